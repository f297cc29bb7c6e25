# exp.rs, operation by operation, without fused operations (portable).
# The constants are those of exp.sollya and of the code; check.sh compares them.
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
q8 = rnd(rnd(r * C9) + C8);
q7 = rnd(rnd(r * q8) + C7);
q6 = rnd(rnd(r * q7) + C6);
q5 = rnd(rnd(r * q6) + C5);
q4 = rnd(rnd(r * q5) + C4);
q3 = rnd(rnd(r * q4) + C3);
q2 = rnd(rnd(r * q3) + C2);
q1 = rnd(rnd(r * q2) + C1);
q0 = rnd(rnd(r * q1) + C0);
t = rnd(rnd(rr * q0) - t1);
s = rnd(r1 + t);

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
ideal = r1 + mt;

# The exact reduced argument is R = r1 - T with T = k (ln 2 - L1), and
#   s - (e^R - 1) = (s - ideal) + reduction + slope + approximation, where
#   reduction     = T - t1: |.| <= 2^-80 (half an ulp of t1 < 2^-32, and 1024 * 2^-102 of L2);
#   slope         = g(r) - g(R), g(u) = e^u - 1 - u: |.| <= |R - r| max |e^u - 1|, by the mean value theorem;
#                   |R - r| <= 2^-55 + 2^-80: the second goal and the line above;
#   approximation = r^2 m0 - g(r): |.| <= 2^-57.98 < 3.52e-18 (exp.sollya).
# With the first goal, of which check.sh proves both halves:
#   r1 in [-0.34658, 0]: |s - (e^R - 1)| <= 4.3e-17 + 8.14e-18 + 3.53e-18 < 5.5e-17 < 2^-54 (max |e^u - 1| < 0.2930);
#   r1 in [0, 0.34658]:  |s - (e^R - 1)| <= 8e-17 + 1.16e-17 + 3.53e-18 < 9.6e-17 < 2^-53 (max |e^u - 1| < 0.4143).
{ r1 in @HALF@ /\ |t1| <= 1b-32 -> |s - ideal| <= @BOUND@ /\ |r - (r1 - t1)| <= 1b-55 }

$ r1 in 64;
