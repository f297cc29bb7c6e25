# A of logarithm.rs, operation by operation, for s >= 0 (only s^2 and s l count).
# The constants are those of logarithm.sollya and of the code; check.sh compares them. Products that are written @(a * b)
# are exact with fused operations and rounded without: check.sh proves both.
@rnd = float<ieee_64, ne>;

C0 = 0x1.5555555555555p-1;
C1 = 0x1.5555555555555p-55;
C2 = 0x1.9999999999968p-2;
C3 = 0x1.2492492498d52p-2;
C4 = 0x1.c71c71bc74e2ep-3;
C5 = 0x1.745d1bc4529aep-3;
C6 = 0x1.3b1298b92491ep-3;
C7 = 0x1.113a108f0f87p-3;
C8 = 0x1.dad1294cd100ep-4;
C9 = 0x1.017bae1e02fd1p-3;

# s + l, of which |l| < 4.5 u |s|. Errors of products are doubles: ze and ue are exact.
s = rnd(s_in);
l = rnd(l_in);
z = rnd(s * s);
ze = s * s - z;
zl = rnd(@((s + s) * l) + ze);
p8 = rnd(@(z * C9) + C8);
p7 = rnd(@(z * p8) + C7);
p6 = rnd(@(z * p7) + C6);
p5 = rnd(@(z * p6) + C5);
p4 = rnd(@(z * p5) + C4);
p3 = rnd(@(z * p4) + C3);
p2 = rnd(@(z * p3) + C2);
w = rnd(z * p2);
uh = rnd(z * C0);
ue = z * C0 - uh;
a = rnd(@(z * C1) + ue);
cc = rnd(w + C0);
c = rnd(w + cc);
b = rnd(@(zl * c) + a);
ul = rnd(@(z * w) + b);

# The same without rounding: A at z, and its slope times what is left of (s + l)^2.
m8 = z * C9 + C8;
m7 = z * m8 + C7;
m6 = z * m7 + C6;
m5 = z * m6 + C5;
m4 = z * m5 + C4;
m3 = z * m4 + C3;
m2 = z * m3 + C2;
delta = ze + 2 * s * l;
ideal = z * (C0 + C1) + z * (z * m2) + delta * (C0 + 2 * z * m2);

# Of A(z + delta + l^2) this leaves out l^2 and delta^2, each below 1b-104, and (C1 + z^2 p') delta, z^2 p' being the part
# of the slope of z^2 p(z) that the code has not: z^2 p' < 0.00161 * 0.31 and |delta| < 4.8e-17, so that is below 2.5e-20.
{ s in [0, 0.2001] /\ |l| <= 1b-53 -> |uh + ul - ideal| <= @BOUND@ /\ |delta| <= 4.8e-17 }

uh + ul - ideal -> (ul - (z * w + b)) + (b - (zl * c + a)) + (a - (z * C1 + ue))
  + z * (w - z * m2) + ((zl - delta) * c + delta * ((c - (2 * w + C0)) + 2 * (w - z * m2)));
zl - delta -> zl - ((s + s) * l + ze);
c - (2 * w + C0) -> (c - (w + cc)) + (cc - (w + C0));
w - z * m2 -> (w - z * p2) + z * (p2 - m2);

$ s in 16;
