#!/usr/bin/env python3
"""A second opinion on sums of exponentials, by arb's ball arithmetic at 200 bits: `arb.py < SAMPLE`.

The sample is written by the test program; floats are hexadecimal, and the surface is level = sum of exp(-q_k):

    sum LEVEL N      N rows follow: centre, then the coefficients of dx^2, dy^2, dz^2, dx*dy, dx*dz, dy*dz
    root O O O D D D ENTRY LO HI      the first root in the box [-1, 1]^3 lies in ENTRY + [LO, HI]
    miss O O O D D D                  there is none

Prints one line; exits with 1 if an answer is wrong, and for a file without answers.
"""

import sys
from fractions import Fraction

try:
    from flint import arb, ctx, fmpq
except ImportError:
    print("SKIPPED answers against arb: python-flint is not installed")
    sys.exit(0)

ctx.prec = 200


def exact(x):
    """A rational number as a ball."""
    return arb(fmpq(x.numerator, x.denominator))


class Ray:
    """f along a ray: -q_k = peak + bend*(t - middle)^2, bend < 0, which needs no t twice."""

    def __init__(self, level, rows, o, d):
        self.level = exact(level)
        self.terms = []
        for u, v, w, a, b, c, e, f, g in rows:
            p = [o[0] - u, o[1] - v, o[2] - w]

            def form(p, q):
                return -(
                    a * p[0] * q[0] + b * p[1] * q[1] + c * p[2] * q[2]
                    + e * p[0] * q[1] + f * p[0] * q[2] + g * p[1] * q[2]
                )

            c0, c1, c2 = form(p, p), form(p, d) + form(d, p), form(d, d)
            middle = -c1 / (2 * c2)
            self.terms.append((exact(c0 + c1 * middle / 2), exact(c2), exact(middle)))

    def value(self, t):
        return self.level - sum((peak + bend * (t - middle) ** 2).exp() for peak, bend, middle in self.terms)

    def slope(self, t):
        return -sum(
            (peak + bend * (t - middle) ** 2).exp() * 2 * bend * (t - middle) for peak, bend, middle in self.terms
        )

    def sign(self, t):
        f = self.value(exact(t))
        return 1 if f > 0 else -1 if f < 0 else 0

    def roots(self, a, b, depth=0):
        """How many roots [a, b] holds; None if that is not decided."""
        t = exact(a).union(exact(b))
        f = self.value(t)
        if f > 0 or f < 0:
            return 0
        d = self.slope(t)
        if d > 0 or d < 0:
            signs = self.sign(a) * self.sign(b)
            return None if signs == 0 else int(signs < 0)
        if depth == 60:
            return None
        m = (a + b) / 2
        left = self.roots(a, m, depth + 1)
        if left is None:
            return None
        right = self.roots(m, b, depth + 1)
        return None if right is None else left + right


def inside(o, d):
    """The part of a ray in the box, t >= 0; None if there is none."""
    near, far = Fraction(0), None
    for start, speed in zip(o, d):
        if speed == 0:
            if abs(start) > 1:
                return None
            continue
        ends = sorted([(-1 - start) / speed, (1 - start) / speed])
        near = max(near, ends[0])
        far = ends[1] if far is None else min(far, ends[1])
    return (near, far) if far is not None and near <= far else None


def judge(kind, numbers, level, rows):
    """True, False, or None if it is not decided."""
    o, d = numbers[:3], numbers[3:6]
    part = inside(o, d)
    if kind == "miss":
        if part is None:
            return True
        count = Ray(level, rows, o, d).roots(*part)
        return None if count is None else count == 0
    if part is None:
        return None
    entry, lo, hi = numbers[6:]
    ray = Ray(level, rows, o, d)
    lo, hi = entry + lo, entry + hi
    before = ray.roots(part[0], lo) if part[0] < lo else 0
    within = ray.roots(lo, hi)
    return None if before is None or within is None else before == 0 and within == 1


def main():
    level, rows, missing = None, [], 0
    counts = {True: 0, False: 0, None: 0}
    for number, line in enumerate(sys.stdin, 1):
        word, *rest = line.split()
        if word == "sum":
            level, missing, rows = Fraction(float.fromhex(rest[0])), int(rest[1]), []
            continue
        if missing:
            rows.append([Fraction(float.fromhex(x)) for x in [word, *rest]])
            missing -= 1
            continue
        verdict = judge(word, [Fraction(float.fromhex(x)) for x in rest], level, rows)
        counts[verdict] += 1
        if verdict is not True:
            print(f"line {number}: {'wrong' if verdict is False else 'undecided'}: {line.strip()}")
    print(f"arb: right {counts[True]}, wrong {counts[False]}, undecided {counts[None]}")
    return 0 if counts[False] == 0 and counts[True] > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
