#!/usr/bin/env python3
"""The zoo's oracle: true roots along rays, by exact polynomials or ball arithmetic at 200 bits (python-flint).

    oracle.py all COUNT SEED [SURFACE ...] all of it, for each surface or those named: a table; builds the tracer with
                                           Cargo; interrupted, it judges what it has
    oracle.py rays SURFACE COUNT SEED      writes rays: random ones, a twentieth each tangent and special
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

import contextlib  # noqa: E402
import io  # noqa: E402
import multiprocessing  # noqa: E402
import pathlib  # noqa: E402
import signal  # noqa: E402
import subprocess  # noqa: E402

import rays  # noqa: E402
import verdicts  # noqa: E402
from formulas import ZOO  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
TRACE = ["cargo", "run", "--quiet", "--release", "-p", "zeroset-zoo"]


# Rays that are traced and judged at a time.
SHARE = 1000


def one(job):
    """Rays, answers and judgement for a share of one surface's rays."""
    name, count, seed = job
    text = io.StringIO()
    with contextlib.redirect_stdout(text):
        rays.write(name, count, seed)
    answers = subprocess.run(TRACE, cwd=ROOT, input=text.getvalue(), capture_output=True, text=True, check=True)
    return verdicts.tallies(answers.stdout.splitlines())


def everything(count, seed, names):
    subprocess.run([*TRACE, "--", "names"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    shares = [(start, min(SHARE, count - start)) for start in range(0, count, SHARE)]
    jobs = [(name, size, f"{seed} {start}") for start, size in shares for name in names]
    found = {name: verdicts.Tally(name) for name in names}
    with multiprocessing.Pool(initializer=signal.signal, initargs=(signal.SIGINT, signal.SIG_IGN)) as pool:
        with contextlib.suppress(KeyboardInterrupt):
            for tallies in pool.imap_unordered(one, jobs):
                for tally in tallies:
                    found[tally.name].join(tally)
    return verdicts.report([tally for tally in found.values() if tally.rays], table=True)


def main(arguments):
    match arguments:
        case ["all", count, seed, *names] if set(names) <= set(ZOO):
            return everything(int(count), seed, names or list(ZOO))
        case ["rays", name, count, seed]:
            rays.write(name, int(count), seed)
            return 0
        case ["fixture", name, count, seed]:
            rays.fixture(name, int(count), seed)
            return 0
        case ["judge"]:
            return verdicts.report(verdicts.tallies(sys.stdin), table=False)
        case ["judge", "--table"]:
            return verdicts.report(verdicts.tallies(sys.stdin), table=True)
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
