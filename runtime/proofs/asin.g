# The arcsine of arcsine.rs, operation by operation, with and without fused operations (see check.sh on @).
# The constants are those of asin.sollya and of the code; check.sh compares them.
@rnd = float<ieee_64, ne>;

B0 = 0x1.5555555555578p-3;
B1 = 0x1.333333332df3bp-4;
B2 = 0x1.6db6db72289dap-5;
B3 = 0x1.f1c71a8cef866p-6;
B4 = 0x1.6e8bdfbb0af7fp-6;
B5 = 0x1.1c49e16d4636ep-6;
B6 = 0x1.ca20eab934aa8p-7;
B7 = 0x1.757aa0d824c1fp-7;
B8 = 0x1.6178650f68978p-7;
B9 = 0x1.e27f6641a7e2ep-9;
B10 = 0x1.64a4dd069bcd3p-6;
B11 = -0x1.596cfbf2af867p-6;
B12 = 0x1.0bb7b2f0e78f4p-5;
# zz = q^2 for |x| < 1/2; zz = (1 - |x|)/2 and q near 2 sqrt(zz) beyond.
z = rnd(zz);
p11 = rnd(@(z * B12) + B11);
p10 = rnd(@(z * p11) + B10);
p9 = rnd(@(z * p10) + B9);
p8 = rnd(@(z * p9) + B8);
p7 = rnd(@(z * p8) + B7);
p6 = rnd(@(z * p7) + B6);
p5 = rnd(@(z * p6) + B5);
p4 = rnd(@(z * p5) + B4);
p3 = rnd(@(z * p4) + B3);
p2 = rnd(@(z * p3) + B2);
p1 = rnd(@(z * p2) + B1);
p0 = rnd(@(z * p1) + B0);
t = rnd(z * p0);
q = rnd(q_in);
rho = rnd(rho_in);
tail = rnd(@(q * t) + rho);
# The sum of turned, for c > 0: c * high is exact, and so is the error of the first sum (Dekker).
high = 0x1.921fb54442d18p-1;
low = 0x1.1a62633145c07p-55;
base = c * high;
sum = rnd(base + q);
error = q - (sum - base);
rest = rnd(@(c * low) + tail);
before = sum + rnd(error + rest);

# The same without rounding.
m11 = zz * B12 + B11;
m10 = zz * m11 + B10;
m9 = zz * m10 + B9;
m8 = zz * m9 + B8;
m7 = zz * m8 + B7;
m6 = zz * m7 + B6;
m5 = zz * m6 + B5;
m4 = zz * m5 + B4;
m3 = zz * m4 + B3;
m2 = zz * m3 + B2;
m1 = zz * m2 + B1;
m0 = zz * m1 + B0;
ideal = zz * m0;
whole = (base + c * low) + (q + (q * ideal + rho));

# 0.11 * 2^-53 > 1.2e-17, 0.24 * 2^-53 > 2.6e-17
{ zz in [0, 0.25] /\ |q| <= 1 /\ |rho| <= 1b-53 /\ c in [1, 4] ->
  |t - ideal| <= 1.2e-17 /\ |before - whole| <= 2.6e-17 }

error -> -(sum - (base + q));
before - whole ->
  (rnd(error + rest) - (error + rest)) + (rest - (c * low + tail)) + (tail - (q * ideal + rho));

$ zz in 16;
