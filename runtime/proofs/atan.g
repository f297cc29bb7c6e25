# The arctangent of arctangent.rs, operation by operation, with and without fused operations (see check.sh on @).
# The constants are those of atan.sollya and of the code; check.sh compares them.
@rnd = float<ieee_64, ne>;

A0 = -0x1.555555555553dp-2;
A1 = 0x1.99999999958a3p-3;
A2 = -0x1.24924922af5fp-3;
A3 = 0x1.c71c70e6f262p-4;
A4 = -0x1.745cf8f73170cp-4;
A5 = 0x1.3b111afe94eedp-4;
A6 = -0x1.10ebcd8827dbap-4;
A7 = 0x1.df107a698961bp-5;
A8 = -0x1.9cd7eccbda9a1p-5;
A9 = 0x1.37e25fc43b8bcp-5;
A10 = -0x1.258529a96db99p-6;
# zz = q^2.
z = rnd(zz);
p9 = rnd(@(z * A10) + A9);
p8 = rnd(@(z * p9) + A8);
p7 = rnd(@(z * p8) + A7);
p6 = rnd(@(z * p7) + A6);
p5 = rnd(@(z * p6) + A5);
p4 = rnd(@(z * p5) + A4);
p3 = rnd(@(z * p4) + A3);
p2 = rnd(@(z * p3) + A2);
p1 = rnd(@(z * p2) + A1);
p0 = rnd(@(z * p1) + A0);
t = rnd(z * p0);
q = rnd(q_in);
rho = rnd(rho_in);
tail = rnd(@(q * t) + rnd(rho - rnd(rho * z)));
# The sum of turned, for c > 0: c * high is exact, and so is the error of the first sum (Dekker).
high = 0x1.921fb54442d18p-1;
low = 0x1.1a62633145c07p-55;
base = c * high;
sum = rnd(base + q);
error = q - (sum - base);
rest = rnd(@(c * low) + tail);
before = sum + rnd(error + rest);

# The same without rounding.
m9 = zz * A10 + A9;
m8 = zz * m9 + A8;
m7 = zz * m8 + A7;
m6 = zz * m7 + A6;
m5 = zz * m6 + A5;
m4 = zz * m5 + A4;
m3 = zz * m4 + A3;
m2 = zz * m3 + A2;
m1 = zz * m2 + A1;
m0 = zz * m1 + A0;
ideal = zz * m0;
whole = (base + c * low) + (q + (q * ideal + (rho - rho * zz)));

# 0.13 * 2^-53 > 1.4e-17, 0.12 * 2^-53 > 1.3e-17
{ zz in [0, 0.17165] /\ |q| <= 0.4143 /\ |rho| <= 1b-51 /\ c in [1, 4] ->
  |t - ideal| <= 1.4e-17 /\ |before - whole| <= 1.3e-17 }

error -> -(sum - (base + q));
before - whole ->
  (rnd(error + rest) - (error + rest)) + (rest - (c * low + tail)) + (tail - (q * ideal + (rho - rho * zz)));

$ zz in 16;
