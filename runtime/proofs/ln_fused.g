# The tail of ln.rs, operation by operation, with fused operations.
# The constants are those of ln.sollya and of the code; check.sh compares them.
@rnd = float<ieee_64, ne>;

L0 = 0x1.555555555554fp-1;
L1 = 0x1.999999999c15bp-2;
L2 = 0x1.24924921e6fe5p-2;
L3 = 0x1.c71c748ce6f3fp-3;
L4 = 0x1.745c4b977115fp-3;
L5 = 0x1.3b35a76777094p-3;
L6 = 0x1.0dcd50a6c0f7cp-3;
L7 = 0x1.1b75928799d54p-3;
f = rnd(f_in);
g = rnd(2 + f);
s = rnd(f / g);
z = rnd(s * s);
l6 = rnd(z * L7 + L6);
l5 = rnd(z * l6 + L5);
l4 = rnd(z * l5 + L4);
l3 = rnd(z * l4 + L3);
l2 = rnd(z * l3 + L2);
l1 = rnd(z * l2 + L1);
l0 = rnd(z * l1 + L0);
q = rnd(f * f);
h = 0.5 * q;
a = rnd(z * l0 + h);
t = rnd(s * a);

# The same without rounding.
ss = f / (2 + f);
zz = ss * ss;
m6 = zz * L7 + L6;
m5 = zz * m6 + L5;
m4 = zz * m5 + L4;
m3 = zz * m4 + L3;
m2 = zz * m3 + L2;
m1 = zz * m2 + L1;
m0 = zz * m1 + L0;
aa = zz * m0 + 0.5 * (f * f);
ideal = ss * aa;

# The bounds: 6.1e-16 < 5.5 * 2^-53, 7.2e-16 < 6.5 * 2^-53, 1e-15 < 9.1 * 2^-53.
{ f in @HALF@ -> |(t - ideal) / ideal| <= @BOUND@ }

# The shares of the two positive terms, for the relative error of their sum.
(zz * m0) / aa -> 1 / (1 + 0.5 * ((2 + f) * (2 + f)) / m0) { f <> 0, m0 <> 0, aa <> 0 };
(0.5 * (f * f)) / aa -> 1 / (1 + m0 / (0.5 * ((2 + f) * (2 + f)))) { f <> 0, m0 <> 0, aa <> 0 };
$ f in 48;
