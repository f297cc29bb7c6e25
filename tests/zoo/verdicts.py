"""Answers against the truth."""

import math
import statistics
from fractions import Fraction

from flint import arb

from formulas import ZOO
from rays import number
from truth import Line, ball, fraction, truth

# A root is easy if |f'|*box > 1e-6*scale there, and no other is nearer than 1e-9*box.
STEEP, APART = 1e-6, 1e-9
KINDS = ("root", "tangent", "crossing", "open")


class Tally:
    def __init__(self, name):
        self.name = name
        self.rays = self.undecided = self.easy = self.easy_open = 0
        self.true_roots = 0
        self.counts = dict.fromkeys(KINDS, 0)
        self.wrong, self.widths, self.conditions, self.examples = {}, [], [], []

    def error(self, what, words):
        self.wrong[what] = self.wrong.get(what, 0) + 1
        self.note(f"wrong, {what}", words)

    def note(self, what, words):
        if len(self.examples) < 5:
            self.examples.append(f"{what}: {' '.join(words)}")

    def join(self, other):
        for count in ("rays", "undecided", "easy", "easy_open", "true_roots"):
            setattr(self, count, getattr(self, count) + getattr(other, count))
        for one, more in ((self.counts, other.counts), (self.wrong, other.wrong)):
            for key, count in more.items():
                one[key] = one.get(key, 0) + count
        self.widths += other.widths
        self.conditions += other.conditions
        self.examples = (self.examples + other.examples)[:5]

    def row(self):
        errors = sum(self.wrong.values())
        c = self.counts
        return [self.name, self.rays, self.true_roots, c["root"], c["tangent"], c["crossing"], c["open"], self.undecided,
                self.easy, self.easy_open, middle(self.widths), middle(self.conditions), errors]


def middle(numbers):
    return f"{statistics.median(numbers):.3g}" if numbers else ""


HEAD = ["surface", "rays", "true roots", "root", "tangent", "crossing", "open", "oracle undecided", "easy rays",
        "open among easy", "median ulps", "median conditioning", "wrong"]


def tallies(lines):
    """Judges answers, surface by surface."""
    found, ray, events, tally = [], None, [], None

    def finish():
        if ray:
            try:
                check(tally, ray, events)
            except ZeroDivisionError:
                tally.undecided += 1

    for line in lines:
        word, *rest = line.split()
        if word == "surface":
            finish()
            ray, events = None, []
            tally = Tally(rest[0])
            found.append(tally)
        elif word == "ray":
            finish()
            ray, events = rest, []
        elif word in KINDS:
            events.append((word, *[number(w) for w in rest[:2]]))
    finish()
    return found


def report(tallies, table):
    """Prints a line or a row for each; the exit code: 1 if something is wrong, or if nothing was judged."""
    rows = [t.row() for t in tallies]
    widths = [w for t in tallies for w in t.widths]
    conditions = [c for t in tallies for c in t.conditions]
    sums = [sum(r[k] for r in rows) for k in range(1, 10)]
    rows.append(["all", *sums, middle(widths), middle(conditions), sum(r[12] for r in rows)])
    if table:
        print("| " + " | ".join(HEAD) + " |\n|" + "---|" * len(HEAD))
    for row in rows:
        words = [str(c) for c in row]
        print("| " + " | ".join(words) + " |" if table else ", ".join(f"{h} {w}" for h, w in zip(HEAD, words)))
    for tally in tallies:
        for example in tally.examples:
            print(f"{tally.name}: {example}")
    return 1 if not tallies or any(t.wrong for t in tallies) else 0


def holds(lo, hi, at):
    """Certainly, or as far as 200 bits can tell."""
    return not (at < ball(lo)) and not (at > ball(hi))


def check(tally, words, events):
    shape = ZOO[tally.name]
    tally.rays += 1
    line = Line([number(w) for w in words[:6]], shape.half)
    if not line.inside:
        if any(kind != "open" for kind, *_ in events):
            tally.error("a root outside the box", words)
        return
    entry = number(words[6])
    known = truth(shape, line, entry)
    near, far = ball(line.near - entry), ball(line.far - entry)
    inside = [r for r in known.roots if not r.at < near and not r.at > far]
    tally.true_roots += len(inside)
    for kind, *_ in events:
        tally.counts[kind] += 1
    box = line.far - line.near
    cover(tally, words, events, known, inside, line.near - entry, line.far - entry)
    for event in events:
        claim(tally, words, event, known, box)
    if known.undecided:
        tally.undecided += 1
    elif not known.identical:
        ease(tally, words, events, known, inside, box)


def cover(tally, words, events, known, inside, near, far):
    """Is each true root in an event? And where f is 0 throughout, is nothing claimed?"""
    if known.identical:
        lo = min((e[1] for e in events), default=None)
        if lo is None or any(k in ("root", "tangent") for k, *_ in events) or lo > near:
            tally.error("f is 0 along the ray", words)
        return
    for root in inside:
        if not any(holds(lo, hi, root.at) for _, lo, hi in events):
            tally.error("a root is missed", words)


def claim(tally, words, event, known, box):
    kind, lo, hi = event
    if any(a <= hi and lo <= b for a, b in known.undecided) or known.identical or kind == "open":
        return
    held = [r for r in known.roots if holds(lo, hi, r.at)]
    if kind == "root":
        if len(held) != 1:
            tally.error(f"a root that is {len(held)} roots", words)
        else:
            tally.widths.append(ulps(lo, hi))
            tally.conditions.append(conditioning(held[0], hi, known.scale))
    if kind == "crossing":
        if sum(r.multiplicity for r in held) % 2 == 0:
            tally.error("a crossing without a change of sign", words)
        if hi - lo > Fraction(1e-12) * max(box, abs(hi)):
            tally.error("a wide crossing", words)
    if kind == "tangent":
        if sum(r.multiplicity for r in held) > 2:
            tally.error("a tangency with more than two roots", words)
        if hi - lo > Fraction(1e-6) * max(box, abs(hi)):
            tally.error("a wide tangency", words)
        if len(held) == 2 and held[1].at - held[0].at > ball(Fraction(APART) * box) and min(
                float(r.slope.mid()) for r in held) * float(box) > STEEP * known.scale:
            tally.error("a tangency around roots that are well apart", words)


def ulps(lo, hi):
    scale = float(max(abs(lo), abs(hi))) or 1.0
    return float(hi - lo) / math.ulp(scale)


def conditioning(root, t, scale):
    """How many ulps of t the root moves if f is off by half an ulp of its scale: what f64 can tell at best."""
    slope = float(root.slope.mid())
    return scale * 2.0**-53 / (slope * math.ulp(float(t) or 1.0)) if slope else math.inf


def ease(tally, words, events, known, inside, box):
    """An easy ray has only simple roots, steep and apart; and nowhere comes f so near to 0 without a root as it would
    between two roots that are not steep."""
    width = float(box)
    if known.least <= STEEP**2 * known.scale:
        return
    for before, after in zip(inside, inside[1:]):
        if not after.at - before.at > arb(APART * width):
            return
    for root in inside:
        if root.multiplicity != 1 or not float(root.slope.mid()) * width > STEEP * known.scale:
            return
    tally.easy += 1
    if any(kind in ("open", "tangent") for kind, *_ in events):
        tally.easy_open += 1
        tally.note("open, and easy", words)
