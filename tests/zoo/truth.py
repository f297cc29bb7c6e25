"""The true roots along a ray: exact for polynomials, by subdivision of balls otherwise."""

from fractions import Fraction

from flint import acb, acb_poly, arb, arb_series, ctx, fmpq, fmpq_poly

# A piece that is still undecided after so many halvings of the segment is left undecided.
DEPTH = 70
# f is nearly constant where |f'|*box is at most this part of its scale.
FLAT = 1e-6


def q(x):
    return fmpq(x.numerator, x.denominator)


def ball(x):
    return arb(q(x))


class Root:
    """A distinct root: where, as a ball; how often; and |f'| there."""

    def __init__(self, at, multiplicity, slope):
        self.at, self.multiplicity, self.slope = at, multiplicity, slope


class Line:
    """The exact line o + s*d, s >= 0, and its part in a cube."""

    def __init__(self, numbers, half):
        self.o, self.d = numbers[:3], numbers[3:6]
        self.near, self.far = Fraction(0), None
        self.inside = self.clip(Fraction(half))

    def clip(self, half):
        near, far = Fraction(0), None
        for o, d in zip(self.o, self.d):
            if d == 0:
                if abs(o) > half:
                    return False
                continue
            a, b = sorted(((-half - o) / d, (half - o) / d))
            near, far = max(near, a), b if far is None else min(far, b)
        self.near, self.far = near, far
        return far is not None and near <= far

    def point(self, s):
        return [float(o + s * d) for o, d in zip(self.o, self.d)]


class Truth:
    """Distinct roots in ascending order; pieces that are undecided; whether f is 0 on the whole line; a scale of f; and
    the least |f| at a critical point off the roots, or where f is nearly constant."""

    def __init__(self, roots, undecided=(), identical=False, scale=1.0, least=float("inf")):
        self.roots, self.undecided, self.identical, self.scale = roots, list(undecided), identical, scale
        self.least = least


def truth(shape, line, base):
    """All roots with s = base + t, by t, in the cube and a little around it."""
    start = [o + base * d for o, d in zip(line.o, line.d)]
    if shape.polynomial:
        return exact(shape, start, line.d)
    return enclosed(shape, start, line.d, line.near - base, line.far - base)


def exact(shape, start, direction):
    x, y, z = (fmpq_poly([q(p), q(d)]) for p, d in zip(start, direction))
    f = shape.f(x, y, z)
    if not isinstance(f, fmpq_poly):
        f = fmpq_poly([f])
    if f == 0:
        return Truth([], identical=True)
    slope = f.derivative()
    found = []
    if f.degree() > 0:
        for at, multiplicity in f.complex_roots():
            if at.imag == 0:
                found.append(Root(at.real, multiplicity, abs(horner(slope, at.real))))
    found.sort(key=lambda r: float(r.at.mid()))
    coefficients = [abs(float(Fraction(int(c.p), int(c.q)))) for c in f.coeffs()]
    least = float("inf")
    if slope.degree() > 0:
        for at in critical(slope):
            # A pair of roots next to the line has its critical point on it, or nearly.
            if abs(at.imag) < abs(at.real) * arb(1e-6) + arb(1e-6):
                height = abs(horner(f, at.real))
                if not any(at.real.overlaps(r.at) for r in found):
                    least = min(least, float(height.mid()))
    return Truth(found, scale=max(coefficients), least=least)


def critical(slope):
    """The zeros of f': for the scale of a ray alone, so that balls of coefficients do, unless zeros coincide."""
    try:
        with ctx.workprec(64):
            return acb_poly([acb(arb(c)) for c in slope.coeffs()]).roots(tol=1e-8, maxprec=400)
    except ValueError:
        return [at for at, _ in slope.complex_roots()]


def horner(polynomial, x):
    value = arb(0)
    for c in reversed(polynomial.coeffs()):
        value = value * x + arb(c)
    return value


class Curve:
    """f along a ray; parameters and the ends of pieces are balls of radius 0, that is, exact dyadic numbers."""

    def __init__(self, shape, start, direction):
        self.f = shape.f
        self.lines = [(ball(p), ball(d)) for p, d in zip(start, direction)]

    def jet(self, t):
        x, y, z = (arb_series([p + d * t, d], prec=3) for p, d in self.lines)
        f = self.f(x, y, z)
        return f[0], f[1], 2 * f[2]

    def over(self, lo, hi):
        f, slope, bend = self.jet(lo.union(hi))
        if sign(f):
            return f, slope, bend
        middle = between(lo, hi, 1 / 2)
        centred = self.jet(middle)[0] + slope * (lo.union(hi) - middle)
        return (f if not centred.is_finite() or not f.overlaps(centred) else f.intersection(centred)), slope, bend


def sign(f):
    return 1 if f > 0 else -1 if f < 0 else 0


def between(lo, hi, share):
    """A number between two exact ones, about this share of the way."""
    return (lo + (hi - lo) * share).mid()


def enclosed(shape, start, direction, lo, hi):
    curve = Curve(shape, start, direction)
    roots, undecided = [], []
    # Beyond the faces by little: the library's box is the cube, rounded outward.
    margin = (hi - lo) / 10**9
    stack = [(ball(lo - margin).mid(), ball(hi + margin).mid(), DEPTH)]
    least = float("inf")
    places = [between(ball(lo), ball(hi), k / 16) for k in range(17)]
    jets = [jet for jet in map(curve.jet, places) if jet[0].is_finite()]
    scale = max(min(float(abs(f).upper()), 1e300) for f, *_ in jets)
    for f, slope, _ in jets:
        # Nearly constant: a near miss need not have a critical point.
        if slope.is_finite() and float(abs(slope).upper()) * float(hi - lo) <= FLAT * scale:
            least = min(least, float(abs(f).lower()))
    steps = 0
    while stack:
        a, b, depth = stack.pop()
        steps += 1
        f, slope, bend = curve.over(a, b)
        if sign(f):
            if not sign(slope):
                least = min(least, float(abs(f).lower()))
            continue
        if sign(slope):
            ends = [sign(curve.jet(e)[0]) for e in (a, b)]
            if ends[0] and ends[1]:
                if ends[0] != ends[1]:
                    roots.append(tighten(curve, a, b, ends[0]))
                continue
        if depth == 0 or steps > 4000:
            undecided.append((fraction(a), fraction(b)))
            continue
        # Not quite the middle, where surfaces like to be.
        middle = between(a, b, 509 / 1024)
        stack += [(middle, b, depth - 1), (a, middle, depth - 1)]
    return Truth(roots, join(undecided), scale=scale or 1.0, least=least)


def tighten(curve, a, b, before):
    """Halves, and images of Newton once the piece is small, until it is 2^-110 wide."""
    while b - a > arb(2) ** -110 * max(1.0, abs(float(a))):
        if b - a < arb(2) ** -10:
            a, b, narrower = newton(curve, a, b)
            if narrower:
                continue
        m = between(a, b, 1 / 2)
        s = sign(curve.jet(m)[0])
        if s == 0:
            break
        a, b = (m, b) if s == before else (a, m)
    return Root(a.union(b), 1, abs(curve.jet(between(a, b, 1 / 2))[1]))


def newton(curve, a, b):
    """One image of Newton; what comes out holds the root. Is it less than half as wide?"""
    m = between(a, b, 1 / 2)
    slope = curve.jet(a.union(b))[1]
    if not sign(slope):
        return a, b, False
    image = m - curve.jet(m)[0] / slope
    lo, hi = max(a, image.lower().mid()), min(b, image.upper().mid())
    return (lo, hi, 2 * (hi - lo) < b - a) if lo <= hi else (a, b, False)


def fraction(x):
    """The exact value of a ball's midpoint."""
    man, exponent = x.mid().man_exp()
    return Fraction(int(man)) * Fraction(2) ** int(exponent)


def join(pieces):
    joined = []
    for a, b in sorted(pieces):
        if joined and a <= joined[-1][1]:
            joined[-1] = (joined[-1][0], max(b, joined[-1][1]))
        else:
            joined.append((a, b))
    return joined
