#!/usr/bin/env python3
"""The true roots of the rays on standard input, by exact polynomials or by ball arithmetic at 200 bits (python-flint).

    cargo run --release -p accuracy -- rays | tests/accuracy/truth.py > tests/accuracy/truth.txt

For each surface a line, then one for each ray: the roots in the cube, each as two f64s whose sum it is, by their bits;
`-` if there are none, and `?` if 200 bits do not tell. Formulas and methods are those of the zoo's oracle (../zoo), which
shares nothing with the library.
"""

import multiprocessing
import pathlib
import sys
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "zoo"))

try:
    from flint import ctx
except ImportError:
    print("SKIPPED truth: python-flint is not installed", file=sys.stderr)
    sys.exit(1)

ctx.prec = 200

from formulas import ZOO  # noqa: E402
from rays import bits, expansion, number  # noqa: E402
from truth import Line, ball, truth  # noqa: E402


def roots(job):
    name, words = job
    shape = ZOO[name]
    line = Line([number(word) for word in words], shape.half)
    if not line.inside:
        return "-"
    known = truth(shape, line, Fraction(0))
    if known.undecided or known.identical:
        return "?"
    inside = [r for r in known.roots if r.at >= ball(line.near) and r.at <= ball(line.far)]
    return " ".join(bits(part) for r in inside for part in expansion(r.at)[:2]) or "-"


def main():
    jobs, name = [], None
    for line in sys.stdin:
        kind, *words = line.split()
        if kind == "surface":
            name = words[0]
        else:
            jobs.append((name, words))
    with multiprocessing.Pool() as pool:
        answers = pool.map(roots, jobs, chunksize=16)
    name = None
    for (surface, _), answer in zip(jobs, answers):
        if surface != name:
            name = surface
            print("surface", name)
        print(answer)


main()
