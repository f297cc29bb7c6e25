#!/usr/bin/env python3
"""Writes models.rs: constructive models of balls, boxes, cylinders and tori, joined one by one: by a union, a difference, or
a smooth union (the quadratic one: min(a, b) - h^2/4k with h = max(k - |a - b|, 0)); and a temple, whose parts touch."""

import pathlib
import random

BLEND = 0.08


def minus(name, number):
    return f"{name} + {number[1:]}" if number.startswith("-") else f"{name} - {number}"


class Model:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.statements = []
        self.operations = 0

    def number(self, low, high):
        return str(round(self.random.uniform(low, high), 3))

    def let(self, name, expression, operations):
        self.statements.append(f"let {name} = {expression};")
        self.operations += operations
        return name

    def part(self, i, size):
        """A primitive at a random place: the name of its distance."""
        centre = [self.number(-0.6, 0.6) for _ in range(3)]
        x, y, z = (self.let(f"{axis}{i}", minus(axis, c), 1) for axis, c in zip("xyz", centre))
        kind = self.random.randrange(4)
        a, b, c = (self.number(0.4 * size, size) for _ in range(3))
        if kind == 0:
            return self.let(f"p{i}", f"sqrt({x}*{x} + {y}*{y} + {z}*{z}) - {a}", 7)
        if kind == 1:
            return self.let(f"p{i}", f"max(abs({x}) - {a}, max(abs({y}) - {b}, abs({z}) - {c}))", 8)
        if kind == 2:
            return self.let(f"p{i}", f"max(sqrt({x}*{x} + {y}*{y}) - {a}, abs({z}) - {b})", 8)
        ring = self.let(f"q{i}", f"sqrt({x}*{x} + {z}*{z}) - {a}", 5)
        return self.let(f"p{i}", f"sqrt({ring}*{ring} + {y}*{y}) - {round(0.4 * float(a), 3)}", 5)

    def join(self, i, whole, part, blended):
        how = self.random.random()
        if how < blended:
            h = self.let(f"h{i}", f"max({BLEND} - abs({whole} - {part}), 0.0)", 4)
            return self.let(f"a{i}", f"min({whole}, {part}) - {h}*{h}*{round(1 / (4 * BLEND), 4)}", 4)
        if how < blended + 0.2 * (1 - blended):
            return self.let(f"a{i}", f"max({whole}, -{part})", 2)
        return self.let(f"a{i}", f"min({whole}, {part})", 1)


def model(name, parts, seed, blended, attribute=""):
    m = Model(seed)
    names = [m.part(i, 0.5 / parts ** (1 / 3)) for i in range(parts)]
    whole = names[0]
    for i, part in enumerate(names[1:]):
        whole = m.join(i, whole, part, blended)
    # A primitive takes a line or two: its place, and its distance.
    body = "\n    ".join([*m.statements, whole]).replace(";\n    let y", "; let y").replace(";\n    let z", "; let z")
    return f"// {m.operations} operations\n{attribute}model! {{ {name}(x, y, z)\n    {body}\n}}\n"


def temple(name, columns):
    """Columns between steps and a roof, before a wall with windows: faces lie in one plane, and a sign has no thickness."""
    m = Model(0)

    def box(i, low, high):
        sides = [f"max({axis} - {b}, {a} - {axis})".replace("- -", "+ ") for axis, a, b in zip("xyz", low, high)]
        return m.let(f"b{i}", f"max({sides[0]}, max({sides[1]}, {sides[2]}))", 11)

    parts = [box(f"s{k}", (-1 + k / 16, -0.75 + k / 16, -0.5), (1 - k / 16, -0.6875 + k / 16, 0.75 - k / 16)) for k in range(4)]
    parts.append(box("r", (-0.875, 0.25, -0.5), (0.875, 0.375, 0.5)))
    parts.append(box("n", (-0.25, 0.375, 0.5), (0.25, 0.5, 0.5)))
    for i in range(columns):
        x = (2 * i + 1 - columns) * 0.75 / columns
        m.let(f"x{i}", minus("x", str(x)), 1)
        shaft = m.let(f"p{i}", f"max(sqrt(x{i}*x{i} + (z - 0.25)*(z - 0.25)) - 0.05, max(y - 0.1875, -0.4375 - y))", 12)
        foot = box(f"f{i}", (x - 0.0625, -0.5, 0.1875), (x + 0.0625, -0.4375, 0.3125))
        head = box(f"h{i}", (x - 0.0625, 0.1875, 0.1875), (x + 0.0625, 0.25, 0.3125))
        parts += [shaft, foot, head]
    whole = parts[0]
    for i, part in enumerate(parts[1:]):
        whole = m.let(f"u{i}", f"min({whole}, {part})", 1)
    wall = box("w", (-0.75, -0.5, -0.5), (0.75, 0.25, -0.25))
    for i in range(columns - 1):
        x = (2 * i + 2 - columns) * 0.75 / columns
        hole = box(f"o{i}", (x - 0.03125, -0.25, -0.5), (x + 0.03125, 0.125, -0.25))
        wall = m.let(f"v{i}", f"max({wall}, -{hole})", 2)
    body = "\n    ".join([*m.statements, f"min({whole}, {wall})"])
    return f"// {m.operations + 1} operations\nmodel! {{ {name}(x, y, z)\n    {body}\n}}\n"


models = [
    model("Model1", 8, 1, 0.5),
    model("Model2", 30, 2, 0.5),
    temple("Temple", 8),
    model("Model3", 55, 13, 0.5, '#[cfg(feature = "large")]\n'),
]
pathlib.Path(__file__).with_name("models.rs").write_text("// Written by models.py.\n\n" + "\n".join(models))
