#!/usr/bin/env python3
"""The zoo's oracle: true roots along rays, by exact polynomials or ball arithmetic at 200 bits (python-flint).

    oracle.py rays SURFACE COUNT SEED      writes rays: random ones, and a tenth each tangent and special
    oracle.py judge [--table] < ANSWERS    compares answers with the truth; exits with 1 if one is wrong
    oracle.py fixture SURFACE COUNT SEED   writes rays with their true roots, for a test that runs without this script

It shares nothing with the library: formulas stand here once more (`formulas.py`), and are evaluated by python-flint.
Numbers in files are f64s by their bits. Irrational coefficients are the f64s that both sides use.
"""

import sys

try:
    from flint import ctx
except ImportError:
    print("SKIPPED zoo: python-flint is not installed")
    sys.exit(0)

ctx.prec = 200

import rays  # noqa: E402
import verdicts  # noqa: E402


def main(arguments):
    match arguments:
        case ["rays", name, count, seed]:
            rays.write(name, int(count), int(seed))
            return 0
        case ["fixture", name, count, seed]:
            rays.fixture(name, int(count), int(seed))
            return 0
        case ["judge"]:
            return verdicts.judge(sys.stdin, table=False)
        case ["judge", "--table"]:
            return verdicts.judge(sys.stdin, table=True)
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
