# avx512/wave.rs, operation by operation.
# The constants are those of wave_table.sollya and of the code; check.sh compares them, and fills in the sine @H@ + @L@ and
# the cosine @K@ of one table entry. Entry 16 - j is entry j with the cosine negated, which is entry j at -r.
@rnd = float<ieee_64, ne>;

S0 = -0x1.5555555555555p-3;
S1 = 0x1.111111110f5acp-7;
S2 = -0x1.a01a0109590fp-13;
S3 = 0x1.71cad275bc348p-19;
C0 = -0x1.ffffffffffffdp-2;
C1 = 0x1.555555554f6b6p-5;
C2 = -0x1.6c16c084a5e2cp-10;
C3 = 0x1.9ffe24cb2ad4bp-16;
H = @H@;
L = @L@;
K = @K@;

r = rnd(r_in);
rho = rnd(rho_in);
z = rnd(r * r);
s2 = rnd(z * S3 + S2);
s1 = rnd(z * s2 + S1);
s0 = rnd(z * s1 + S0);
w = rnd(z * s0);
c2 = rnd(z * C3 + C2);
c1 = rnd(z * c2 + C1);
c0 = rnd(z * c1 + C0);
u = rnd(z * c0);
h = rnd(K * r + H);
# Exact by Sterbenz: h is between H/2 and 2H (or H or K is 0).
d = h - H;
e = rnd(K * r - d);
low = rnd(e + L);
q = rnd(r * w + rho);
t1 = rnd(H * u + low);
t = rnd(K * q + t1);

# The same without rounding.
zz = r * r;
m2 = zz * S3 + S2;
m1 = zz * m2 + S1;
m0 = zz * m1 + S0;
W = zz * m0;
n2 = zz * C3 + C2;
n1 = zz * n2 + C1;
n0 = zz * n1 + C0;
U = zz * n0;
ideal = H + L + K * (r + (r * W + rho)) + H * U;
sum = h + t;

{ r in [-0.0983, 0.0983] /\ |rho| <= 1b-56 -> |sum - ideal| <= @BOUND@ /\ |w - W| <= 5e-19 }

K * r - d -> -(h - (K * r + H));
sum - ideal -> (t - (K * q + t1)) + K * ((q - (r * w + rho)) + r * (w - W)) + (t1 - (H * u + low)) + H * (u - U)
    + (low - (e + L)) + (e - (K * r - d));
$ r in 32;
