# The sine of circular.rs, operation by operation, without fused operations.
# The constants are those of sincos.sollya and of the code; check.sh compares them.
@rnd = float<ieee_64, ne>;

S0 = -0x1.5555555555549p-3;
S1 = 0x1.111111110f8a5p-7;
S2 = -0x1.a01a019c15d7dp-13;
S3 = 0x1.71de357ac844p-19;
S4 = -0x1.ae5e684b6c3b1p-26;
S5 = 0x1.5d93879cc78c5p-33;
r = rnd(r_in);
z = rnd(r * r);
s4 = rnd(rnd(z * S5) + S4);
s3 = rnd(rnd(z * s4) + S3);
s2 = rnd(rnd(z * s3) + S2);
s1 = rnd(rnd(z * s2) + S1);
s0 = rnd(rnd(z * s1) + S0);
t = rnd(z * s0);

# The same without rounding.
zz = r * r;
m4 = zz * S5 + S4;
m3 = zz * m4 + S3;
m2 = zz * m3 + S2;
m1 = zz * m2 + S1;
m0 = zz * m1 + S0;
ideal = zz * m0;

# 0.32 * 2^-53 > 3.5e-17
{ r in [0, 0.7855] -> |t - ideal| <= 3.5e-17 }

$ r in 256;
