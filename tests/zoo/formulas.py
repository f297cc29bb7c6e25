"""The surfaces, once more: each by its own formula in plain Python, over any ring that x, y and z come from."""

import functools
import math
from fractions import Fraction

from flint import arb, arb_series, fmpq


@functools.cache
def rational(x):
    """The exact value of a float, in a ring where both fit."""
    n, d = float(x).as_integer_ratio()
    return fmpq(n, d)


@functools.cache
def decimal(text):
    """The number that is spelt."""
    x = Fraction(text)
    return fmpq(x.numerator, x.denominator)


def power(x, n):
    result = x
    for _ in range(n - 1):
        result = result * x
    return result


def exp(x):
    return x.exp()


def sin(x):
    return x.sin()


def cos(x):
    return x.cos()


def choose(x, yes, no):
    """The branch of a sign: both, by their hull, where it is not certain."""
    if x[0] >= 0:
        return yes
    if x[0] <= 0:
        return no
    return arb_series([yes[k].union(no[k]) for k in range(3)], prec=3)


def magnitude(x):
    return choose(x, x, -x)


def greater(a, b):
    return choose(a - b, a, b)


def root(x):
    """A square root whose derivatives may be anything where x may be 0."""
    if x[0] > 0:
        return x.sqrt()
    wide = arb(0, math.inf)
    top = abs(x[0]).sqrt()
    return arb_series([arb(0).union(top), wide, wide], prec=3)


# The irrational coefficients, as the f64s that both sides use.
PHI = rational((1 + math.sqrt(5)) / 2)
SQRT2 = rational(math.sqrt(2))
MU2 = decimal("1.69")
Q = fmpq


def square(x, y, z):
    return x * x + y * y + z * z


def torus(x, y, z):
    r2, a2 = decimal("0.36"), decimal("0.0625")
    return power(square(x, y, z) + (r2 - a2), 2) - (x * x + y * y) * (4 * r2)


def torus_root(x, y, z):
    return power(root(x * x + y * y) - arb(decimal("0.6")), 2) + z * z - arb(decimal("0.0625"))


def clebsch(x, y, z):
    cubes = power(x, 3) + power(y, 3) + power(z, 3)
    mixed = x * x * (y + z) + y * y * (x + z) + z * z * (x + y)
    return 81 * cubes - 189 * mixed + 54 * x * y * z + 126 * (x * y + x * z + y * z) - 9 * square(x, y, z) - 9 * (x + y + z) + 1


def kummer(x, y, z):
    factor = (3 * MU2 - 1) / (3 - MU2)
    pqst = (1 - z - SQRT2 * x) * (1 - z + SQRT2 * x) * (1 + z + SQRT2 * y) * (1 + z - SQRT2 * y)
    return power(square(x, y, z) - MU2, 2) - factor * pqst


def tangle(x, y, z):
    return sum((power(c, 4) - 5 * c * c for c in (x, y, z)), 0 * x) + decimal("11.8")


def mitchell(x, y, z):
    q = y * y + z * z
    return 4 * (power(x, 4) + q * q + 17 * x * x * q) - 20 * (x * x + q) + 17


def klein(x, y, z):
    r2 = square(x, y, z)
    inner = r2 - 2 * y - 1
    return (r2 + 2 * y - 1) * (inner * inner - 8 * z * z) + 16 * x * z * inner


def heart(x, y, z):
    body = power(x * x + y * y * Q(9, 4) + z * z - 1, 3)
    return body - x * x * power(z, 3) - y * y * power(z, 3) * Q(9, 80)


def barth_sextic(x, y, z):
    p2 = PHI * PHI
    product = (p2 * x * x - y * y) * (p2 * y * y - z * z) * (p2 * z * z - x * x)
    return 4 * product - (1 + 2 * PHI) * power(square(x, y, z) - 1, 2)


def barth_decic(x, y, z):
    p4 = PHI * PHI * PHI * PHI
    xx, yy, zz = x * x, y * y, z * z
    product = (xx - p4 * yy) * (yy - p4 * zz) * (zz - p4 * xx)
    fourth = xx * xx + yy * yy + zz * zz - 2 * (xx * yy + yy * zz + zz * xx)
    r2 = xx + yy + zz
    return 8 * product * fourth + (3 + 5 * PHI) * power(r2 - 1, 2) * power(r2 - (2 - PHI), 2)


def chebyshev(n):
    def t(x):
        before, now = 0 * x + 1, x
        for _ in range(n - 1):
            before, now = now, 2 * x * now - before
        return now

    return lambda x, y, z: t(x) + t(y) + t(z) + 1


def bretzel(x, y, z):
    inner = x * x * power(1 - x * x, 2) * power(4 - x * x, 3) - 20 * y * y
    return inner * inner + 80 * z * z - 22


def decocube(x, y, z):
    def part(a, b, c):
        return power(a * a + b * b - decimal("0.64"), 2) + power(c * c - 1, 2)

    return part(x, y, z) * part(y, z, x) * part(z, x, y) - decimal("0.02")


def icosahedral(x, y, z):
    phi = arb(PHI)
    terms = [cos(a + b * phi) + cos(a - b * phi) for a, b in ((x, y), (y, z), (z, x))]
    return 2 - (terms[0] + terms[1] + terms[2])


def superquadric(x, y, z):
    def high(v, n):
        result, square = None, magnitude(v)
        while n:
            if n & 1:
                result = square if result is None else result * square
            square, n = square * square, n >> 1
        return result

    return high(x, 500) + high(y, 35) / 2 + high(z, 4) / 2 - 1


def gyroid(x, y, z):
    return sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x)


def schwarz_d(x, y, z):
    sx, sy, sz, cx, cy, cz = sin(x), sin(y), sin(z), cos(x), cos(y), cos(z)
    return sx * sy * sz + sx * cy * cz + cx * sy * cz + cx * cy * sz


def exponentials(x, y, z):
    level = arb(decimal("0.5"))
    for a, b, c, s in BLOBS:
        dx, dy, dz = x - a, y - b, z - c
        level = level - exp((dx * dx + dy * dy + dz * dz) * -s)
    return level


# Centres and sharpness; the library's side has the same rows.
BLOBS = [
    (0.25, 0.125, -0.375, 6.0),
    (-0.5, 0.25, 0.125, 9.0),
    (0.125, -0.5, 0.25, 7.5),
    (-0.125, 0.375, 0.5, 11.0),
    (0.5, -0.25, -0.125, 8.0),
    (-0.375, -0.375, -0.25, 12.5),
]
BLOBS = [[arb(rational(x)) for x in row] for row in BLOBS]


def shell(thickness):
    def f(x, y, z):
        r2 = square(x, y, z)
        return greater(r2 - arb(decimal("0.64")), arb(power(decimal("0.8") - thickness, 2)) - r2)

    return f


class Shape:
    """f, the half width of its cube, whether f is a polynomial, and points that are hard."""

    def __init__(self, f, half, polynomial=True, points=(), lines=()):
        self.f, self.half, self.polynomial, self.points, self.lines = f, half, polynomial, points, lines


def corners(*scale):
    return [(a, b, c) for a in scale for b in scale for c in scale]


ZOO = {
    "sphere": Shape(lambda x, y, z: square(x, y, z) - decimal("0.64"), 1.0),
    "ellipsoid": Shape(lambda x, y, z: x * x + 2 * y * y + 3 * z * z + x * y - 1, 1.5),
    "cylinder": Shape(lambda x, y, z: x * x + y * y - decimal("0.25"), 1.0),
    "cone": Shape(lambda x, y, z: x * x + y * y - z * z, 1.0, points=[(0, 0, 0)], lines=[((0, 0, 0), (1, 0, 1)), ((0, 0, 0), (3, 4, 5))]),
    "hyperboloid": Shape(lambda x, y, z: x * x + y * y - z * z - decimal("0.25"), 1.5, lines=[((0.5, 0, 0), (0, 1, 1))]),
    "torus": Shape(torus, 0.9),
    "torus_root": Shape(torus_root, 0.9, polynomial=False),
    "cayley": Shape(lambda x, y, z: 4 * square(x, y, z) + 16 * x * y * z - 1, 1.5, points=[(0.5, 0.5, -0.5), (-0.5, -0.5, -0.5), (0.5, -0.5, 0.5), (-0.5, 0.5, 0.5)]),
    "clebsch": Shape(clebsch, 3.0),
    "kummer": Shape(kummer, 2.5),
    "tangle": Shape(tangle, 3.2),
    "mitchell": Shape(mitchell, 2.1),
    "steiner": Shape(lambda x, y, z: x * x * y * y + y * y * z * z + z * z * x * x + x * y * z, 0.6, points=[(0, 0, 0)], lines=[((0, 0, 0), (1, 0, 0)), ((0, 0, 0), (0, 1, 0)), ((0, 0, 0), (0, 0, 1))]),
    "klein": Shape(klein, 4.2),
    "heart": Shape(heart, 1.5, points=[(0, 0, 1), (0, 0, -1), (1, 0, 0)]),
    "teardrop": Shape(lambda x, y, z: power(x, 5) / 2 + power(x, 4) / 2 - y * y - z * z, 1.2, points=[(0, 0, 0), (-1, 0, 0)]),
    "barth_sextic": Shape(barth_sextic, 2.0, points=[(1, 0, 0), (0, 1, 0), (0, 0, 1)]),
    "barth_decic": Shape(barth_decic, 2.2, points=[(1, 0, 0), (0, 0, 1)]),
    "chmutov_6": Shape(chebyshev(6), 1.35, points=corners(-0.5, 0.5, 1)),
    "chmutov_8": Shape(chebyshev(8), 1.5),
    "bretzel": Shape(bretzel, 2.4),
    "decocube": Shape(decocube, 1.3),
    "icosahedral": Shape(icosahedral, 4.77, polynomial=False),
    "superquadric": Shape(superquadric, 1.3, polynomial=False, points=[(1, 0, 0), (0, 0, 1)]),
    "gyroid": Shape(gyroid, 6.283185307179586, polynomial=False, points=[(0, 0, 0)]),
    "schwarz_p": Shape(lambda x, y, z: cos(x) + cos(y) + cos(z), 6.283185307179586, polynomial=False),
    "schwarz_d": Shape(schwarz_d, 6.283185307179586, polynomial=False, points=[(0, 0, 0)]),
    "blobby": Shape(lambda x, y, z: square(x, y, z) + sin(4 * x) - cos(4 * y) + sin(4 * z) - 1, 2.5, polynomial=False),
    "scherk": Shape(lambda x, y, z: exp(z) * cos(y) - cos(x), 10.0, polynomial=False, points=[(0, 0, 0)]),
    "exponentials": Shape(exponentials, 1.0, polynomial=False),
    "zitrus": Shape(lambda x, y, z: x * x + z * z - power(y, 3) * power(1 - y, 3), 1.2, points=[(0, 0, 0), (0, 1, 0)]),
    "ding_dong": Shape(lambda x, y, z: x * x + y * y + power(z, 3) - z * z, 1.5, points=[(0, 0, 0), (0, 0, 1)]),
    "calypso": Shape(lambda x, y, z: x * x + y * y * z - z * z, 1.5, points=[(0, 0, 0)], lines=[((0, 0, 0), (0, 1, 0))]),
    "whitney": Shape(lambda x, y, z: x * x - y * y * z, 1.5, points=[(0, 0, 0)], lines=[((0, 0, 0), (0, 0, 1)), ((0, 0, 0), (0, 1, 0))]),
    "himmel": Shape(lambda x, y, z: x * x - y * y * z * z, 1.5, points=[(0, 0, 0)], lines=[((0, 0, 0), (0, 1, 0)), ((0, 0, 0), (0, 0, 1)), ((0, 1, 0), (1, 0, 1))]),
    "limao": Shape(lambda x, y, z: x * x - power(y, 3) * power(z, 3), 1.5, points=[(0, 0, 0)], lines=[((0, 0, 0), (0, 1, 0)), ((0, 0, 0), (0, 0, 1))]),
    "doubled_sphere": Shape(lambda x, y, z: power(square(x, y, z) - decimal("0.64"), 2), 1.0),
    "isolated_point": Shape(square, 1.0, points=[(0, 0, 0)]),
    "thin_shell": Shape(shell(rational(2.0**-40)), 1.0, polynomial=False),
}
