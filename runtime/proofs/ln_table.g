# The tail of avx512/ln.rs, operation by operation.
# The constants are those of ln_table.sollya and of the code; check.sh compares them.
@rnd = float<ieee_64, ne>;

L0 = -0x1.fffffffffffbep-2;
L1 = 0x1.5555555554745p-2;
L2 = -0x1.00000000dd2a8p-2;
L3 = 0x1.999999c7a60acp-3;
L4 = -0x1.55553d74d406fp-3;
L5 = 0x1.2490f14b943cap-3;
L6 = -0x1.007923198a4d6p-3;
L7 = 0x1.cd6a2ca1653a2p-4;

# r is exact.
r = rnd(r_in);
f = rnd(f_in);
rr = rnd(r * r);
l6 = rnd(r * L7 + L6);
l5 = rnd(r * l6 + L5);
l4 = rnd(r * l5 + L4);
l3 = rnd(r * l4 + L3);
l2 = rnd(r * l3 + L2);
l1 = rnd(r * l2 + L1);
l0 = rnd(r * l1 + L0);
t = rnd(rr * l0 + f);

# The same without rounding.
m6 = r * L7 + L6;
m5 = r * m6 + L5;
m4 = r * m5 + L4;
m3 = r * m4 + L3;
m2 = r * m3 + L2;
m1 = r * m2 + L1;
m0 = r * m1 + L0;
ideal = r * r * m0;

# f is what the sum k L1 + H + r lacks, with k L2 and the lower part of the table; it errs by less than 2^-80. The rounding
# of t is proved absolutely: f may cancel r^2 p.
{ r in @HALF@ /\ |f| <= 1b-30 -> |(rr * l0 - ideal) / r| <= @BOUND@ /\ |t - (rr * l0 + f)| <= 1b-64 }

(rr * l0 - ideal) / r -> r * ((rr * l0 - ideal) / (r * r)) { r <> 0 };
(rr * l0 - ideal) / (r * r) -> (1 + (rr - r * r) / (r * r)) * (l0 - m0) + (rr - r * r) / (r * r) * m0 { r <> 0 };
$ r in 32;
