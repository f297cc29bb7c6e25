//! From a bracket with exactly one root to a tiny interval: converge in plain floats, certify once.

use super::{Brackets, Field, WIDE, nonzero, select};
use crate::contract::middle;
use crate::interval::{Interval, Packet, Routine};

/// How wide a root's interval may be: 64 ulp of t, at most 5e-13, and not below what four ulp of t permit.
#[inline(always)]
fn goal<P: Packet>(p: P, t: &Interval<P::F>) -> P::F {
    let ulp = p.mul_rn(t.hi, p.splat(f64::EPSILON));
    let wanted = p.min_f(p.mul_rn(ulp, p.splat(64.0)), p.splat(5e-13));
    p.max_f(
        p.max_f(wanted, p.mul_rn(ulp, p.splat(4.0))),
        p.splat(1e-300),
    )
}

/// [`refine`] as a routine of its own, which all solvers of a surface share.
pub(crate) struct Refine<'b, 'f, P: Packet> {
    pub field: &'b mut Field<'f, P>,
    pub brackets: &'b Brackets<P>,
    pub plain_convergence: bool,
}

impl<P: Packet> Routine<P> for Refine<'_, '_, P> {
    type Output = Interval<P::F>;

    #[inline(always)]
    fn call(self, _p: P) -> Interval<P::F> {
        refine(self.field, self.brackets, self.plain_convergence)
    }
}

/// Encloses the root of each bracket. What comes out is always a part of the bracket that holds the root; how narrow it
/// gets depends on the noise of f alone.
#[inline(always)]
fn refine<P: Packet>(
    field: &mut Field<'_, P>,
    brackets: &Brackets<P>,
    plain_convergence: bool,
) -> Interval<P::F> {
    let p = field.p;
    let mut root = brackets.t;
    let found = brackets.found;
    let goal = goal(p, &root);
    let mut x = brackets.guess;
    let mut slope = p.splat(f64::INFINITY);
    if plain_convergence {
        (x, slope) = converge(field, brackets, x);
    }
    let steep = p.and(found, nonzero(p, &brackets.slope));
    let mut noise = None;
    if p.any(steep) {
        let fx = field.point(x, steep).d[0];
        narrow(p, x, &fx, &brackets.slope, steep, &mut root);
        noise = Some(fx);
    }
    let mut wide = p.and(found, p.lt(goal, width(p, &root)));
    if let (true, Some(fx)) = (p.any(wide), noise) {
        wide = p.and(wide, p.lt(attainable(p, &fx, slope), width(p, &root)));
    }
    if p.any(wide) {
        let job = Narrow {
            field,
            brackets,
            root: &root,
            x,
            goal,
            wide,
        };
        return p.call(job);
    }
    root
}

/// What no sign can better by more than a factor of four: f is certain only where it leaves its noise at the root, which
/// is how wide `fx` is.
#[inline(always)]
fn attainable<P: Packet>(p: P, fx: &Interval<P::F>, slope: P::F) -> P::F {
    let four = p.splat(4.0);
    let noise = p.div_rn(p.mul_rn(four, p.sub_rn(fx.hi, fx.lo)), p.abs_f(slope));
    // Not a number where nothing is known. What is wider gets a second look, which costs more than an image.
    p.select(p.lt(noise, p.splat(WIDE)), noise, p.splat(0.0))
}

/// From `x` in plain floats, kept inside the bracket by the signs that it sees; the result is a place and the derivative
/// there. Nothing that it does can be wrong: it is only where to look. The first step is Newton's; later ones go to the zero
/// of the cubic in f through the last two places with their derivatives, where it is inside.
#[inline(always)]
fn converge<P: Packet>(field: &mut Field<'_, P>, brackets: &Brackets<P>, x: P::F) -> (P::F, P::F) {
    let p = field.p;
    let zero = p.splat(0.0);
    let Interval { mut lo, mut hi } = brackets.t;
    // What is left behind a step is in proportion to its square, or to its square and that of the step before: a few ulp.
    let close = p.mul_rn(hi, p.splat(1.0 / (1u64 << 26) as f64));
    let closer = p.mul_rn(hi, close);
    let mut before = Seen::nowhere(p);
    let mut reach = hi;
    let mut x = x;
    let mut slope = zero;
    let mut open = brackets.found;
    let mut round = 0;
    while round < 60 {
        let [f, d] = field.float(x, open);
        slope = p.select(open, d, slope);
        let f = p.select(brackets.rising, f, p.neg_f(f));
        let d = p.select(brackets.rising, d, p.neg_f(d));
        lo = p.select(p.lt(f, zero), p.max_f(x, lo), lo);
        hi = p.select(p.lt(zero, f), p.min_f(x, hi), hi);
        let here = Seen {
            x,
            f,
            by: p.div_rn(p.splat(1.0), d),
        };
        let newton = p.sub_rn(x, p.mul_rn(f, here.by));
        let (mut next, mut usable) = (newton, p.none());
        if round > 0 {
            let cubic = here.zero_with(p, &before);
            usable = p.and(p.lt(lo, cubic), p.lt(cubic, hi));
            next = p.select(usable, cubic, newton);
        }
        let inside = p.and(p.le(lo, next), p.le(next, hi));
        // The end of a bracket is often next to the root.
        let instead = if round % 2 == 0 {
            p.max_f(p.min_f(newton, hi), lo)
        } else {
            middle(p, &Interval { lo, hi })
        };
        let next = p.select(inside, next, instead);
        let step = p.abs_f(p.sub_rn(next, x));
        x = p.select(open, next, x);
        let by_two = p.and(usable, p.le(p.mul_rn(step, reach), closer));
        let by_one = p.and_not(p.le(step, close), usable);
        open = p.and_not(open, p.or(by_two, by_one));
        if !p.any(open) {
            break;
        }
        (before, reach) = (here, step);
        round += 1;
    }
    (x, slope)
}

/// A place, f there and 1/f'.
struct Seen<P: Packet> {
    x: P::F,
    f: P::F,
    by: P::F,
}

impl<P: Packet> Seen<P> {
    fn nowhere(p: P) -> Self {
        let zero = p.splat(0.0);
        Seen {
            x: zero,
            f: zero,
            by: zero,
        }
    }

    /// Where the cubic polynomial x(f) through both places, with its derivatives there, has f = 0: Hermite's interpolation.
    #[inline(always)]
    fn zero_with(&self, p: P, before: &Self) -> P::F {
        let by = p.div_rn(p.splat(1.0), p.sub_rn(self.f, before.f));
        let chord = p.mul_rn(p.sub_rn(self.x, before.x), by);
        let here = p.mul_rn(p.sub_rn(self.by, chord), by);
        let there = p.mul_rn(p.sub_rn(chord, before.by), by);
        let third = p.mul_rn(p.sub_rn(here, there), by);
        let second = p.sub_rn(here, p.mul_rn(before.f, third));
        let first = p.sub_rn(self.by, p.mul_rn(self.f, second));
        p.sub_rn(self.x, p.mul_rn(self.f, first))
    }
}

/// The Newton image of the bracket: root ← root ∩ (x − f(x)/f'). It cannot be empty; an end that is not a number is not
/// taken.
#[inline(always)]
fn narrow<P: Packet>(
    p: P,
    x: P::F,
    fx: &Interval<P::F>,
    slope: &Interval<P::F>,
    lanes: P::M,
    root: &mut Interval<P::F>,
) {
    let (step, _) = p.div(*fx, *slope);
    let lo = p.max_f(p.sub_rd(x, step.hi), root.lo);
    let hi = p.min_f(p.sub_ru(x, step.lo), root.hi);
    let good = p.and(lanes, p.le(lo, hi));
    *root = select(p, good, &Interval { lo, hi }, root);
}

#[inline(always)]
fn width<P: Packet>(p: P, t: &Interval<P::F>) -> P::F {
    p.sub_ru(t.hi, t.lo)
}

/// The lanes for which one image was not enough: a routine of its own because it is rare.
struct Narrow<'b, 'f, 's, P: Packet> {
    field: &'b mut Field<'f, P>,
    brackets: &'s Brackets<P>,
    root: &'s Interval<P::F>,
    x: P::F,
    goal: P::F,
    wide: P::M,
}

impl<P: Packet> Routine<P> for Narrow<'_, '_, '_, P> {
    type Output = Interval<P::F>;

    #[inline(always)]
    fn call(self, _p: P) -> Interval<P::F> {
        let Narrow {
            field,
            brackets,
            goal,
            wide,
            ..
        } = self;
        let mut root = *self.root;
        let wide = by_images(field, &mut root, self.x, goal, wide);
        let wide = by_signs(field, brackets, &mut root, self.x, goal, wide);
        bisect(field, brackets, &mut root, goal, wide);
        root
    }
}

/// Newton images with f' over what is left, while each at least halves it.
#[inline(always)]
fn by_images<P: Packet>(
    field: &mut Field<'_, P>,
    root: &mut Interval<P::F>,
    x: P::F,
    goal: P::F,
    wide: P::M,
) -> P::M {
    let p = field.p;
    let mut wide = wide;
    let mut moving = wide;
    let mut round = 0;
    while p.any(moving) && round < 50 {
        let before = width(p, root);
        let inside = p.and(p.lt(root.lo, x), p.lt(x, root.hi));
        let x = p.select(inside, x, middle(p, root));
        let f = field.slope(root, moving);
        let steep = p.and(moving, nonzero(p, &f.d[1]));
        let fx = field.point(x, steep);
        narrow(p, x, &fx.d[0], &f.d[1], steep, root);
        let after = width(p, root);
        let slope = p.min_f(p.abs_f(f.d[1].lo), p.abs_f(f.d[1].hi));
        let enough = p.max_f(goal, attainable(p, &fx.d[0], slope));
        wide = p.and_not(wide, p.le(after, p.select(steep, enough, goal)));
        let halved = p.le(after, p.mul_rn(before, p.splat(0.5)));
        moving = p.and(p.and(moving, wide), halved);
        round += 1;
    }
    wide
}

/// Where f has a certain sign at `x`, one end of the bracket moves there.
#[inline(always)]
fn cut<P: Packet>(
    field: &mut Field<'_, P>,
    rising: P::M,
    root: &mut Interval<P::F>,
    x: P::F,
    lanes: P::M,
) -> P::M {
    let p = field.p;
    let zero = p.splat(0.0);
    let f = field.point(x, lanes).d[0];
    let positive = p.and(lanes, p.lt(zero, f.lo));
    let negative = p.and(lanes, p.lt(f.hi, zero));
    let before = p.or(p.and(rising, negative), p.and_not(positive, rising));
    let behind = p.or(p.and(rising, positive), p.and_not(negative, rising));
    root.lo = p.select(before, p.max_f(root.lo, x), root.lo);
    root.hi = p.select(behind, p.min_f(root.hi, x), root.hi);
    p.or(before, behind)
}

/// Signs on both sides of `x`, at growing distances.
#[inline(always)]
fn by_signs<P: Packet>(
    field: &mut Field<'_, P>,
    brackets: &Brackets<P>,
    root: &mut Interval<P::F>,
    x: P::F,
    goal: P::F,
    wide: P::M,
) -> P::M {
    let p = field.p;
    let mut wide = wide;
    let mut radius = p.mul_rn(goal, p.splat(0.25));
    let mut round = 0;
    while p.any(wide) && round < 12 {
        let lo = p.max_f(p.sub_rn(x, radius), root.lo);
        let hi = p.min_f(p.add_rn(x, radius), root.hi);
        cut(field, brackets.rising, root, p.min_f(lo, root.hi), wide);
        cut(field, brackets.rising, root, p.max_f(hi, root.lo), wide);
        // Both certain: what is left is as narrow as the noise permits.
        wide = p.and_not(
            wide,
            p.le(
                width(p, root),
                p.max_f(goal, p.mul_rn(radius, p.splat(2.5))),
            ),
        );
        radius = p.mul_rn(radius, p.splat(4.0));
        round += 1;
    }
    wide
}

/// Bisection by certain signs, until f's noise hides the sign in the middle.
#[inline(always)]
fn bisect<P: Packet>(
    field: &mut Field<'_, P>,
    brackets: &Brackets<P>,
    root: &mut Interval<P::F>,
    goal: P::F,
    wide: P::M,
) {
    let p = field.p;
    let mut wide = wide;
    let mut round = 0;
    while p.any(wide) && round < 100 {
        let x = middle(p, root);
        let moved = cut(field, brackets.rising, root, x, wide);
        wide = p.and(p.and_not(wide, p.le(width(p, root), goal)), moved);
        round += 1;
    }
}
