#!/usr/bin/env python3
"""Enclosures of derivatives against differences with 800 bits: `arb.py < ENCLOSURES`.

Each line has a surface's name, and f64s by their bits. After `space`: a box, and the enclosures of f, its gradient and its
Hessian (xx, xy, xz, yy, yz, zz) over it. After `ray`: an origin, a direction, a segment, and the enclosures of f, f', f''
over it. An enclosure is its lower and its upper end. Exits with 1 if a derivative is outside of its enclosure.
"""

import random
import struct
import sys
from fractions import Fraction
from itertools import combinations_with_replacement as pairs

try:
    from flint import arb, ctx, fmpq
except ImportError:
    print("SKIPPED derivatives against arb: python-flint is not installed")
    sys.exit(0)

ctx.prec = 800
# Differences with this step are off by its square times a higher derivative. The ball has room for far more.
STEP = Fraction(1, 2**130)
ROOM = arb(0, arb(2) ** -160)


def ball(x):
    x = Fraction(x)
    return arb(fmpq(x.numerator, x.denominator))


def power(a, b):
    b = ball(b) if isinstance(b, str) else b
    return (b * a.log()).exp()


def cbrt(a):
    return a.root(3) if a > 0 else -((-a).root(3))


def log(a, base):
    return a.log() / arb(base).log()


def hypot(a, b):
    return (a * a + b * b).sqrt()


def product(factors):
    result = arb(1)
    for factor in factors:
        result *= factor
    return result


def least(first, *rest):
    for a in rest:
        first = arb.min(first, a)
    return first


def most(first, *rest):
    return -least(-first, *(-a for a in rest))


def branches(x, y, z):
    if x + 5 < y - 5 or (x > 8 and z > 0):
        return x * y
    return y * z**2 if z < 10 else arb(1)


def shared(x, y, z):
    s = x * y + z
    q = s**2 - s.sin()
    return q * s + q**3


FORMULAS = {
    "Polynomial": lambda x, y, z: x**3 * y - 2 * x * y * z + z**4 - (x - y) ** 2 * (y + 3) ** 3 + x**2 - 1,
    "Quotient": lambda x, y, z: (x * y + 1) / (z**2 + 2) - x / (3 + y**2) + 1 / (x**2 + y**2 + 4),
    "NegativePowers": lambda x, y, z: (
        1 / (x + 5) ** 2
        + z / (y + 6) ** 3
        + power(x**2 + 1, "1.5")
        + power(y**2 + 2, "-0.5")
        + power(z**2 + 3, "0.3")
    ),
    "RealPower": lambda x, y, z: power(x**2 + 1, y / 4) + power(arb(2), x) - z,
    "Roots": lambda x, y, z: (x**2 + y**2 + 1).sqrt() * z + cbrt(x + 9) - cbrt(z * y),
    "Exponentials": lambda x, y, z: (x * y).exp() + power(arb(2), z - x) - (y / 2).expm1() * z,
    "Logarithms": lambda x, y, z: (x**2 + 2).log() + (1 + y**2).log() * z - log(z**2 + 3, 2) + log(x + 7, 10),
    "Circular": lambda x, y, z: (x * y).sin() + (y + z).cos() * x - (z / 4).tan(),
    "Arcs": lambda x, y, z: (x / 5).asin() * y + (y / 5).acos() - (z * x).atan() + arb.atan2(x + 6, y * z + 1),
    "Hyperbolic": lambda x, y, z: x.sinh() - (y * z).cosh() + (x + z).tanh() * y,
    "Areas": lambda x, y, z: (x * z).asinh() + (y**2 + 2).acosh() - (z / 6).atanh() * x,
    "Distances": lambda x, y, z: hypot(x - 3, y + 4) + abs(z - 4) * x + 1 / (y + 7),
    "Extremes": lambda x, y, z: most(x - 5, y * z) + least(x * x, z + 9) + most(least(x * y, arb(20)), arb(-20)),
    "Branches": branches,
    "Sums": lambda x, y, z: (
        sum((i * x + y).sin() * (z - i) ** 2 for i in range(4)) + product(x + i * y * z for i in range(1, 4))
    ),
    "Nested": lambda x, y, z: sum(product(x + i * y - j * z for j in range(3)) * (i * x).cos() for i in range(3)),
    "FoldedExtremes": lambda x, y, z: (
        least(*((x - 7 * i) ** 2 + y * z for i in range(3))) + most(*(y - 9 * i + x * z for i in range(3)))
    ),
    "Shared": shared,
}


class Line:
    """Values on a lattice of steps around a point, each computed once."""

    def __init__(self, f, point, directions):
        self.f, self.point, self.directions, self.known = f, point, directions, {}

    def at(self, *steps):
        if steps not in self.known:
            moves = [(STEP * n, d) for n, d in zip(steps, self.directions) if n]
            moved = [c + sum(h * d[k] for h, d in moves) for k, c in enumerate(self.point)]
            self.known[steps] = self.f(*map(ball, moved))
        return self.known[steps]

    def difference(self, *axes):
        """The derivative along up to two of the directions."""

        def off(*signs):
            steps = [0] * len(self.directions)
            for axis, sign in zip(axes, signs):
                steps[axis] += sign
            return self.at(*steps)

        if not axes:
            return off()
        if len(axes) == 1:
            return (off(1) - off(-1)) / ball(2 * STEP) + ROOM
        return (off(1, 1) - off(1, -1) - off(-1, 1) + off(-1, -1)) / ball(4 * STEP**2) + ROOM


def truths(name, point, directions):
    line = Line(FORMULAS[name], point, directions)
    axes = range(len(directions))
    orders = [()] + [(i,) for i in axes] + list(pairs(axes, 2))
    return [line.difference(*order) for order in orders]


def number(word):
    return struct.unpack(">d", bytes.fromhex(word))[0]


def intervals(numbers):
    return list(zip(numbers[::2], numbers[1::2]))


def places(lo, hi, source):
    lo, hi = Fraction(lo), Fraction(hi)
    return [lo] if lo == hi else [lo + (hi - lo) * Fraction(source.randrange(1, 64), 64) for _ in range(2)]


def samples(kind, numbers, source):
    """Points, directions of derivatives, and enclosures."""
    if kind == "space":
        axes = [[int(i == k) for k in range(3)] for i in range(3)]
        points = zip(*(places(lo, hi, source) for lo, hi in intervals(numbers[:6])))
        return list(points), axes, intervals(numbers[6:])
    origin, direction = ([Fraction(x) for x in numbers[k : k + 3]] for k in (0, 3))
    points = [[o + t * d for o, d in zip(origin, direction)] for t in places(*numbers[6:8], source)]
    return points, [direction], intervals(numbers[8:])


def main():
    source = random.Random(1)
    right = wrong = undecided = 0
    for line in sys.stdin:
        name, kind, *words = line.split()
        points, directions, enclosures = samples(kind, list(map(number, words)), source)
        for point in points:
            for k, (truth, (lo, hi)) in enumerate(zip(truths(name, point, directions), enclosures, strict=True)):
                if not truth.is_finite() or truth.rad() > 1e-30:
                    undecided += 1
                elif truth < arb(lo) or truth > arb(hi):
                    wrong += 1
                    if wrong < 6:
                        print("wrong:", name, kind, k, [float(c) for c in point], truth.str(20), lo, hi)
                else:
                    right += 1
    print(f"derivatives against arb: {right} inside, {wrong} outside, {undecided} undecided")
    return 1 if wrong or 1000 * undecided > right or not right else 0


if __name__ == "__main__":
    sys.exit(main())
