# avx512/exp.rs, operation by operation.
# The constants are those of exp_table.sollya and of the code; check.sh compares them.
@rnd = float<ieee_64, ne>;

Q0 = 0x1.000000000000ap0;
Q1 = 0x1.0000000000003p-1;
Q2 = 0x1.55555554054eap-3;
Q3 = 0x1.55555554b84c8p-5;
Q4 = 0x1.11126f4707bedp-7;
Q5 = 0x1.6c1805e15a9p-10;

# r1 = x - k L1, exact; r = r1 - k L2, rounded once.
r1 = rnd(r1_in);
r = rnd(r1 - t1);
d = rnd(d_in);
q4 = rnd(r * Q5 + Q4);
q3 = rnd(r * q4 + Q3);
q2 = rnd(r * q3 + Q2);
q1 = rnd(r * q2 + Q1);
q0 = rnd(r * q1 + Q0);
s = rnd(r * q0 + d);

# The same without rounding, from the rounded r on.
m4 = r * Q5 + Q4;
m3 = r * m4 + Q3;
m2 = r * m3 + Q2;
m1 = r * m2 + Q1;
m0 = r * m1 + Q0;
ideal = r * m0 + d;

# T (1 + D) is 2^(j/16). The code adds s to T; d is D less (more) epsilon, rounded. With R the exact reduced argument,
#   T s - T ((1 + D) e^R - 1) = T (rounding + slope + approximation - share) and the epsilon of d, where
#   rounding      = s - ideal: the first goal;
#   slope         = e^r - e^R: |.| <= 1.022 |r - R|, |r - R| <= 2^-59 + 2^-99: the second goal, and k times what ln 2 lacks;
#   approximation = 1 + r m0 - e^r: exp_table.sollya;
#   share         = D (e^R - 1): |.| <= 0.022 |D|.
# exp_table.sollya adds them up.
{ r1 in [-0.02168, 0.02168] /\ |t1| <= 1b-44 /\ |d| <= 1.5e-16 -> |s - ideal| <= 6.8e-18 /\ |r - (r1 - t1)| <= 1b-59 }

$ r1 in 64;
