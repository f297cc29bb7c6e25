#!/usr/bin/env python3
"""Formulas in prefix form, boxes, and two enclosures each, against arb at 200 bits.

Lines on standard input: ten f64s by their bits (x, y, z, and two enclosures, each its lower and upper end), a bar, and the
formula. Each is evaluated at points of its box; exits with 1 if a value is outside of an enclosure, or if all are skipped.
"""

import random
import struct
import sys
from fractions import Fraction

try:
    from flint import arb, ctx, fmpq
except ImportError:
    print("SKIPPED rewriting against arb: python-flint is not installed")
    sys.exit(0)

ctx.prec = 200


class Undefined(Exception):
    """The formula has no value here, or 200 bits cannot tell."""


def ball(x):
    return arb(fmpq(x.numerator, x.denominator))


def need(condition):
    if not condition:
        raise Undefined


def divide(a, b):
    need(b != 0)
    return a / b


def power(a, b):
    if a == 0:
        need(b > 0)
        return arb(0)
    need(a > 0)
    return (b * a.log()).exp()


def halves(a, n):
    if n % 2:
        need(a >= 0)
        a = a.sqrt()
    else:
        n //= 2
    need(n >= 0 or a != 0)
    return a**n if n >= 0 else 1 / a**-n


def domain(test, f):
    def checked(a):
        need(test(a))
        return f(a)

    return checked


def cbrt(a):
    if a == 0:
        return arb(0)
    need(a > 0 or a < 0)
    return a.root(3) if a > 0 else -((-a).root(3))


def atan2(a, b):
    need(not (a == 0 and b == 0))
    # The cut needs certain signs.
    need(a > 0 or a < 0 or b > 0 or (a == 0 and b < 0))
    return arb.atan2(a, b)


def least(a, b):
    need(a <= b or b <= a)
    return a if a <= b else b


def most(a, b):
    need(a <= b or b <= a)
    return b if a <= b else a


UNARY = {
    "neg": lambda a: -a,
    "abs": lambda a: abs(a),
    "sqrt": domain(lambda a: a >= 0, lambda a: a.sqrt()),
    "exp": lambda a: a.exp(),
    "exp2": lambda a: arb(2) ** a,
    "exp_m1": lambda a: a.expm1(),
    "ln": domain(lambda a: a > 0, lambda a: a.log()),
    "ln_1p": domain(lambda a: a > -1, lambda a: a.log1p()),
    "log2": domain(lambda a: a > 0, lambda a: a.log() / arb(2).log()),
    "log10": domain(lambda a: a > 0, lambda a: a.log() / arb(10).log()),
    "sin": lambda a: a.sin(),
    "cos": lambda a: a.cos(),
    "tan": lambda a: a.tan(),
    "asin": domain(lambda a: abs(a) <= 1, lambda a: a.asin()),
    "acos": domain(lambda a: abs(a) <= 1, lambda a: a.acos()),
    "atan": lambda a: a.atan(),
    "sinh": lambda a: a.sinh(),
    "cosh": lambda a: a.cosh(),
    "tanh": lambda a: a.tanh(),
    "asinh": lambda a: a.asinh(),
    "acosh": domain(lambda a: a >= 1, lambda a: a.acosh()),
    "atanh": domain(lambda a: abs(a) < 1, lambda a: a.atanh()),
    "cbrt": cbrt,
    "recip": lambda a: divide(arb(1), a),
}
BINARY = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": divide,
    "min": least,
    "max": most,
    "hypot": lambda a, b: (a * a + b * b).sqrt(),
    "atan2": atan2,
    "pow": power,
}


def value(words, point):
    """Reads one formula off the front of the words."""
    word = next(words)
    if word in point:
        return point[word]
    if word == "pi":
        return arb.pi()
    if word in UNARY:
        return UNARY[word](value(words, point))
    if word in BINARY:
        a = value(words, point)
        return BINARY[word](a, value(words, point))
    if word == "halves":
        n = int(next(words))
        return halves(value(words, point), n)
    if word == "clamp":
        v, low, high = (value(words, point) for _ in range(3))
        return most(least(v, high), low)
    if word == "if":
        parts = [skipping(words, point) for _ in range(4)]
        a, b = (now(p) for p in parts[:2])
        need(a < b or a >= b)
        return now(parts[2] if a < b else parts[3])
    numerator, denominator = word.split("/")
    return ball(Fraction(int(numerator), int(denominator)))


def skipping(words, point):
    """A part of an `if`: its value, or that it has none, which matters only if it is taken."""
    taken = []

    def record():
        for word in words:
            taken.append(word)
            yield word

    try:
        return value(record(), point)
    except Undefined as error:
        rest(taken, words)
        return error


ARITY = {"halves": 2, "clamp": 3, "if": 4}


def rest(taken, words):
    """Reads the words of a formula that was left in the middle."""
    open_parts = 1
    for k, word in enumerate(taken):
        open_parts += parts(word, taken, k) - 1
    while open_parts > 0:
        word = next(words)
        taken.append(word)
        open_parts += parts(word, taken, len(taken) - 1) - 1


def parts(word, taken, k):
    if k and taken[k - 1] == "halves":
        return 0
    return 1 if word in UNARY else 2 if word in BINARY else ARITY.get(word, 0)


def now(part):
    if isinstance(part, Undefined):
        raise part
    return part


def number(word):
    return struct.unpack(">d", bytes.fromhex(word))[0]


def inside(lo, hi, truth):
    """Not certainly outside."""
    return not (truth < arb(lo)) and not (truth > arb(hi))


def main():
    source = random.Random(1)
    formulas = points = wrong = 0
    for line in sys.stdin:
        head, formula = line.split("|")
        numbers = [number(w) for w in head.split()]
        sides = [(Fraction(numbers[2 * k]), Fraction(numbers[2 * k + 1])) for k in range(3)]
        formulas += 1
        for _ in range(6):
            at = [lo + (hi - lo) * Fraction(source.randrange(65), 64) for lo, hi in sides]
            try:
                truth = value(iter(formula.split()), dict(zip("xyz", map(ball, at))))
                need(truth.is_finite())
            except (Undefined, ValueError, ZeroDivisionError):
                continue
            points += 1
            for k in (6, 8):
                if not inside(numbers[k], numbers[k + 1], truth):
                    wrong += 1
                    if wrong < 6:
                        print("wrong:", formula.strip(), [float(c) for c in at], truth, numbers[k], numbers[k + 1])
    print(f"{formulas} formulas, {points} values, {wrong} outside")
    return 1 if wrong or points < formulas else 0


if __name__ == "__main__":
    sys.exit(main())
