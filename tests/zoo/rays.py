"""Rays that are random, tangent, or special, from a seed."""

import math
import random
import struct
from fractions import Fraction

from flint import arb, arb_series

from formulas import ZOO
from truth import Line, ball, truth


def bits(x):
    return struct.pack(">d", x).hex()


def number(word):
    return Fraction(struct.unpack(">d", bytes.fromhex(word))[0])


def write(name, count, seed):
    print(f"surface {name}")
    for origin, direction in some(name, count, seed):
        print("ray", *map(bits, origin + direction))


def fixture(name, count, seed):
    """As `write`, with the distinct roots inside the cube behind each ray: three f64s whose sum is within 1e-40 or so of
    the parameter, and the multiplicity."""
    print(f"surface {name}")
    shape = ZOO[name]
    for origin, direction in some(name, count, seed):
        numbers = [Fraction(x) for x in origin + direction]
        line = Line(numbers, shape.half)
        if not line.inside:
            roots, decided = [], True
        else:
            known = truth(shape, line, Fraction(0))
            decided = not known.undecided and not known.identical
            roots = [r for r in known.roots if r.at >= ball(line.near) and r.at <= ball(line.far)]
        if decided:
            print("ray", *map(bits, origin + direction))
            for root in roots:
                print("root", *map(bits, expansion(root.at)), root.multiplicity)


def expansion(at):
    parts = []
    for _ in range(3):
        parts.append(float(at.mid()))
        at = at - arb(parts[-1])
    return parts


def some(name, count, seed):
    source = random.Random(f"{name} {seed}")
    shape = ZOO[name]
    for k in range(count):
        kind = k % 20
        if kind == 1:
            ray = special(shape, source)
        elif kind == 2:
            ray = tangent(shape, source) or across(shape, source)
        else:
            ray = across(shape, source)
        yield ray


def direction(source):
    while True:
        d = [source.gauss(0, 1) for _ in range(3)]
        length = math.hypot(*d)
        if length > 1e-3:
            return [c / length for c in d]


def across(shape, source):
    """From outside of the cube, through a point in it; now and then from far away, or along an axis."""
    target = [source.uniform(-shape.half, shape.half) for _ in range(3)]
    d = direction(source)
    away = source.choice([3.0] * 17 + [1e3, 1e6, 0.0]) * shape.half
    if source.random() < 0.05:
        axis = source.randrange(3)
        d = [math.copysign(1.0, d[k]) if k == axis else source.choice([0.0, -0.0]) for k in range(3)]
    return [t - away * c for t, c in zip(target, d)], [c * source.choice([1.0, 1.0, 0.37]) for c in d]


def special(shape, source):
    """Through singular points, along special lines, through the middle, or along a coordinate plane."""
    if shape.lines and source.random() < 0.4:
        point, along = source.choice(shape.lines)
        back = source.choice([3.0, 2.0, 0.0, 1.5]) * shape.half
        return [float(p) - back * a for p, a in zip(point, along)], [float(a) for a in along]
    point = source.choice(list(shape.points) + [(0, 0, 0)])
    d = direction(source)
    if source.random() < 0.5:
        d[source.randrange(3)] = 0.0
        # Few digits, so that the ray meets the point exactly.
        d = [round(c * 64) / 64 for c in d]
        if not any(d):
            d = [1.0, 0.0, 0.0]
    back = source.choice([2.0, 4.0, 3.0])
    return [float(p) - back * c for p, c in zip(point, d)], d


def tangent(shape, source):
    """A ray in the tangent plane of a point of the surface, as far as f64s can say, or an ulp beside it."""
    for _ in range(8):
        origin, d = across(shape, source)
        line = Line([Fraction(x) for x in origin + d], shape.half)
        if not line.inside:
            continue
        known = truth(shape, line, Fraction(0))
        inside = [r for r in known.roots if r.at > ball(line.near) and r.at < ball(line.far)]
        if not inside:
            continue
        p = line.point(Fraction(float(source.choice(inside).at.mid())))
        g = gradient(shape, p)
        length = math.hypot(*g)
        if not math.isfinite(length) or length < 1e-9:
            continue
        normal = [c / length for c in g]
        e = direction(source)
        along = sum(a * b for a, b in zip(e, normal))
        t = [a - along * b for a, b in zip(e, normal)]
        back = 3.0 * shape.half
        origin = [a - back * b for a, b in zip(p, t)]
        if source.random() < 0.5:
            axis = source.randrange(3)
            origin[axis] = math.nextafter(origin[axis], source.choice([-math.inf, math.inf]))
        return origin, t
    return None


def gradient(shape, p):
    """By one series per axis, in plain numbers."""
    g = []
    for axis in range(3):
        along = [arb_series([arb(p[k]), arb(1 if k == axis else 0)], prec=3) for k in range(3)]
        g.append(float(shape.f(*along)[1].mid()))
    return g
