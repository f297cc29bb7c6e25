# The tail of e^r - 1, and so of eˣ - 1, sinh, tanh (hyperbolic.rs) and powers (real_power.rs), operation by operation.
# The constants are those of exp.sollya and of the code; check.sh compares them. Products that are written @(a * b) are
# exact with fused operations and rounded without: check.sh proves both.
@rnd = float<ieee_64, ne>;

C0 = 0x1.000000000000bp-1;
C1 = 0x1.5555555555561p-3;
C2 = 0x1.555555555022dp-5;
C3 = 0x1.111111110d645p-7;
C4 = 0x1.6c16c1854e9fcp-10;
C5 = 0x1.a01a01baddbb3p-13;
C6 = 0x1.a019975e50177p-16;
C7 = 0x1.71dddfd6f9507p-19;
C8 = 0x1.28afa5e33078fp-22;
C9 = 0x1.af8575077d162p-26;

# r1 = x - k L1, exact; t1 = k L2, rounded.
r1 = rnd(r1_in);
t1 = rnd(t1_in);
r = rnd(r1 - t1);
rr = rnd(r * r);
q8 = rnd(@(r * C9) + C8);
q7 = rnd(@(r * q8) + C7);
q6 = rnd(@(r * q7) + C6);
q5 = rnd(@(r * q6) + C5);
q4 = rnd(@(r * q5) + C4);
q3 = rnd(@(r * q4) + C3);
q2 = rnd(@(r * q3) + C2);
q1 = rnd(@(r * q2) + C1);
q0 = rnd(@(r * q1) + C0);
t = rnd(@(rr * q0) - t1);

# The same without rounding, from the rounded r on.
m8 = r * C9 + C8;
m7 = r * m8 + C7;
m6 = r * m7 + C6;
m5 = r * m6 + C5;
m4 = r * m5 + C4;
m3 = r * m4 + C3;
m2 = r * m3 + C2;
m1 = r * m2 + C1;
m0 = r * m1 + C0;
mt = (r * r) * m0 - t1;

# exp_m1.sollya takes it from here; what else there is to the error is in exp_fused.g.
{ r1 in @HALF@ /\ |t1| <= 1b-32 -> |t - mt| <= @BOUND@ }

$ r1 in 64;
