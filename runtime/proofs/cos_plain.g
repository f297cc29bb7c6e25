# The cosine of circular.rs, operation by operation, without fused operations.
# The constants are those of sincos.sollya and of the code; check.sh compares them.
@rnd = float<ieee_64, ne>;

C0 = 0x1.555555555554cp-5;
C1 = -0x1.6c16c16c15221p-10;
C2 = 0x1.a01a019cbfa22p-16;
C3 = -0x1.27e4f812e2833p-22;
C4 = 0x1.1ee9f16b96c82p-29;
C5 = -0x1.8fb13a797c552p-37;
r = rnd(r_in);
rl = rnd(rl_in);
z = rnd(r * r);
u = rnd(z * z);
h = 0.5 * z;
w = rnd(1 - h);
c4 = rnd(rnd(z * C5) + C4);
c3 = rnd(rnd(z * c4) + C3);
c2 = rnd(rnd(z * c3) + C2);
c1 = rnd(rnd(z * c2) + C1);
c0 = rnd(rnd(z * c1) + C0);
# (1 - w) - h is exact, for w is a rounding of 1 - h.
rest = (1 - w) - h;
e = rnd(rest - rnd(r * rl));
d = rnd(rnd(u * c0) + e);

# The same without rounding.
zz = r * r;
m4 = zz * C5 + C4;
m3 = zz * m4 + C3;
m2 = zz * m3 + C2;
m1 = zz * m2 + C1;
m0 = zz * m1 + C0;
ideal = 1 - 0.5 * zz + ((zz * zz) * m0 - r * rl);
sum = w + d;
dd = (zz * zz) * m0 + (rest - r * rl);

# 0.33 * 2^-53 > 3.6e-17
{ r in [0, 0.7855] /\ |rl| <= 5.8e-17 -> |sum - ideal| <= 3.6e-17 }

# w + rest = 1 - h.
sum - ideal -> (d - dd) - 0.5 * (z - zz);
rest -> -(w - (1 - h));

$ r in 256;
