# The residual of cbrt.rs, operation by operation. Fused or not, only the last product differs: by 2^-53 of itself.
@rnd = float<ieee_64, ne>;

y = rnd(y_in);
m = rnd(m_in);
# 1/(3 y^2) approximately.
w = rnd(w_in);
# The errors of products are exact (two_product).
h = rnd(y * y);
l = y * y - h;
g = rnd(h * y);
i = h * y - g;
rest = rnd(rnd(rnd(m - g) - i) - rnd(l * y));
delta = rnd(rest * w);

cube = (y * y) * y;
ideal = (m - cube) * w;

# 2^-83 is below 2^-82.4 y: w is 1/(3 y^2) to 2^-29, so delta is (m - y^3)/(3 y^2) to 2^-29 2^-31.5 + 2^-82 of y.
{ y in [0.69, 1.39] /\ w in [0.17, 0.71] /\ |m - cube| <= 1b-28 -> |rest - (m - cube)| <= 1b-79 /\ |delta - ideal| <= 1b-79 }

m - g -> (m - cube) + (cube - h * y) + (h * y - g);
rnd(m - g) -> (rnd(m - g) - (m - g)) + (m - g);
rest - (m - cube) -> (rest - ((rnd(rnd(m - g) - i)) - rnd(l * y))) + (rnd(rnd(m - g) - i) - (rnd(m - g) - i)) + (rnd(m - g) - (m - g)) - (rnd(l * y) - l * y);
