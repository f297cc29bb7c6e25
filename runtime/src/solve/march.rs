//! The march: front to back, without a stack.

use super::crawl::Crawl;
use super::floor::{Outcome, Stuck};
use super::{Brackets, Field, select};
use crate::contract::Contractor;
use crate::interval::{Interval, Packet};
use crate::verdict::{Verdict, Why};

/// What was met before the certain roots: rare, so lane by lane.
#[derive(Debug, Default)]
pub(crate) struct Events {
    /// In ascending order for each ray of the packet.
    pub of: [Vec<Verdict>; 8],
    /// Bit i is set if ray i has any.
    pub touched: u8,
}

impl Events {
    pub fn push(&mut self, lane: usize, verdict: Verdict) {
        verdict.append(&mut self.of[lane]);
        self.touched |= 1 << lane;
    }

    /// Takes out what is known of one ray.
    pub fn take(&mut self, lane: usize) -> Vec<Verdict> {
        self.touched &= !(1 << lane);
        core::mem::take(&mut self.of[lane])
    }

    /// Forgets what is known of these rays.
    pub fn forget(&mut self, lanes: u8) {
        for (lane, list) in self.of.iter_mut().enumerate() {
            if lanes >> lane & 1 != 0 {
                list.clear();
            }
        }
        self.touched &= !lanes;
    }

    /// Forgets all, and keeps the room.
    #[inline(always)]
    pub fn clear(&mut self) {
        if self.touched != 0 {
            for list in &mut self.of {
                list.clear();
            }
            self.touched = 0;
        }
    }
}

/// Where a packet's rays are searched.
#[derive(Clone, Copy)]
pub(super) struct Range<P: Packet> {
    /// The segments; `lo ≥ 0`.
    pub over: Interval<P::F>,
    /// The rays that have one.
    pub live: P::M,
    /// How long the first steps are.
    pub first: P::F,
    /// The number of evaluations at which a ray's search gives up.
    pub limit: P::F,
    /// Is a sign change enough to end a ray's search? It may turn out to be too vague if it is wide: then the search goes on.
    pub first_only: bool,
}

/// State of the march: no root lies in [over.lo, front) that was not reported.
struct Front<P: Packet> {
    front: P::F,
    back: P::F,
    /// The last gap: no root lies strictly inside.
    gap: Interval<P::F>,
}

/// What short steps took so far. Near a root of high order, f is so small that a step which excludes a root is minute, and
/// millions of them would lie before it: after a part of the budget, pieces are left open instead, each as long as what was
/// crawled over before. So there is something left for what lies behind. A crawl over more than the length of a short step is
/// not at one root, and spends the whole budget.
struct Pace<P: Packet> {
    /// What was spent when steps became short.
    since: P::F,
    /// Where the march was then.
    from: P::F,
    /// What may be spent on short steps in a row, before the march leaps.
    patience: P::F,
}

/// The part of the budget that may go into one crawl. The rest is for what lies behind it.
const PATIENCE: f64 = 0.5;

/// Behind what was jumped over, or settled where the march was stuck, a segment is so much longer.
const GROWTH: f64 = 8.0;

/// Splits in a row, more or less: a sign of a crawl long before segments are short.
struct Splits<P: Packet> {
    /// How often segments were split, less how often they were passed.
    count: P::F,
    /// How often they must have been for a jump.
    many: P::F,
}

/// So many splits more than segments that were passed are as good as short segments.
const SPLITS: f64 = 3.0;

/// Behind a short segment without a root the next is so much longer: what made it short lies behind, mostly.
const LEAP: f64 = 16.0;
/// The same for others.
const STRIDE: f64 = 3.0;

/// Segments of this part of the search are too short for a march that gets on; shorter by 64 at each try that fails.
const CRAWL: f64 = 1.0 / (1u64 << 14) as f64;

/// Searches for the first root of each ray. Roots that are proved come back as brackets; what is open before them goes
/// to `events`, and where the first ray's search went on to `cuts`. Each step asks the contractor for what is left of
/// [front, back]: nothing, and the segment moves on and doubles; a bracket, and the ray is done; or a first piece, which
/// is searched next, while the gap behind it is remembered. A segment too short to be split, or one whose front cannot be told from a root, is settled by
/// [`Stuck`]; short ones before that, and what follows where it is stuck again and again, may be jumped over by [`Crawl`].
#[inline(always)]
pub(super) fn march<C: Contractor, P: Packet>(
    field: &mut Field<'_, P>,
    range: &Range<P>,
    events: &mut Events,
    mut cuts: Option<&mut Vec<f64>>,
) -> Brackets<P> {
    let p = field.p;
    let zero = p.splat(0.0);
    let mut over = range.over;
    let end = over.hi;
    let shortest = p.mul_rn(end, p.splat(1.0 / (1u64 << 48) as f64));
    let short = p.mul_rn(end, p.splat(CRAWL));
    let mut crawling = short;
    let mut pace = Pace::<P> {
        since: *field.spent,
        from: over.lo,
        patience: p.mul_rn(range.limit, p.splat(PATIENCE)),
    };
    // How often the march was stuck since it got on, and how often it must have been for a jump.
    let mut idle = zero;
    let mut enough = p.splat(2.0);
    let mut splits = Splits::new(p);
    let mut live = range.live;
    let mut found = Brackets::none(p);
    let mut memory = C::memory(p);
    let mut at = Front::<P> {
        front: range.over.lo,
        back: p.min_f(p.add_rn(range.over.lo, range.first), end),
        gap: Interval {
            lo: p.splat(-1.0),
            hi: p.splat(-1.0),
        },
    };
    while p.any(live) {
        let t = Interval {
            lo: at.front,
            hi: at.back,
        };
        let pieces = C::contract(field, &t, live, &mut memory);
        let none = p.and(pieces.none, live);
        let one = p.and(p.and_not(pieces.one, none), live);
        if p.any(one) {
            found.put(
                p,
                one,
                &pieces.first,
                &pieces.slope,
                p.lt(zero, pieces.slope.lo),
                t.hi,
            );
            live = p.and_not(live, one);
        }
        let split = p.and_not(live, none);
        let stuck = p.and(
            split,
            p.or(
                pieces.stuck,
                p.le(p.sub_rn(pieces.first.hi, pieces.first.lo), shortest),
            ),
        );
        at.advance(p, (end, short), none, &pieces.first, pieces.next);
        live = p.and_not(live, p.and(none, p.le(end, at.front)));
        if p.any(stuck) {
            // At a front that cannot be told from a root only its neighbourhood is in question.
            let near = p.select(pieces.stuck, at.front, at.back);
            let t = Interval {
                lo: at.front,
                hi: near,
            };
            let job = Stuck::<C, P>::new(field, over, t, stuck, shortest, events);
            let outcome = p.call(job);
            live = at.settle(p, end, live, stuck, &outcome, &mut found);
            // What is found later lies behind the event: no neighbourhood reaches back to it.
            over.lo = p.select(p.and(stuck, outcome.met), outcome.behind, over.lo);
            if range.first_only {
                live = p.and_not(live, outcome.hit);
            }
        }
        idle = p.select(stuck, p.add_rn(idle, p.splat(1.0)), idle);
        let again = p.and(p.and(stuck, live), p.le(enough, idle));
        let length = p.sub_rn(at.back, at.front);
        let long = p.lt(short, length);
        idle = p.select(long, zero, idle);
        let tired = pace.tired(p, short, length, at.front, *field.spent);
        let mut tired = p.and(tired, p.and(live, split));
        let crawls = p.and_not(p.and(live, split), stuck);
        let split_often = splits.often(p, split, crawls, live);
        let sure = p.or(p.and(crawls, p.le(length, crawling)), again);
        let slow = p.or(split_often, sure);
        if C::ORDER >= 2 && p.any(slow) {
            let jump = p.call(Crawl {
                field,
                front: at.front,
                end,
                lanes: slow,
                early: p.and_not(split_often, sure),
                stuck: again,
                events,
            });
            live = at.settle(p, end, live, jump.jumped, &jump.outcome, &mut found);
            over.lo = p.select(jump.outcome.met, jump.outcome.behind, over.lo);
            tired = p.and_not(tired, jump.jumped);
            let shorter = p.mul_rn(length, p.splat(1.0 / 64.0));
            crawling = p.select(slow, p.select(jump.jumped, short, shorter), crawling);
            splits.tried(p, slow, jump.jumped);
            idle = p.select(jump.jumped, zero, idle);
            let rarer = p.select(jump.jumped, p.splat(2.0), p.add_rn(enough, enough));
            enough = p.select(again, rarer, enough);
        }
        if p.any(tired) {
            let piece = at.leap(p, end, shortest, tired, pace.from);
            let flags = field.value(&piece, tired).flags;
            let broken = p.bits(p.or(flags.undefined, flags.jump));
            leave(
                p,
                tired,
                &piece,
                [Why::Floor, Why::Undefined],
                broken,
                events,
            );
            over.lo = p.select(tired, piece.hi, over.lo);
            live = p.and_not(live, p.and(tired, p.le(end, piece.hi)));
        }
        if let Some(cuts) = &mut cuts {
            cuts.push(p.to_array(at.front)[0]);
        }
        let spent = p.and(live, p.lt(range.limit, *field.spent));
        if p.any(spent) {
            leave_rest(p, spent, at.front, end, events);
            live = p.and_not(live, spent);
        }
    }
    found
}

impl<P: Packet> Splits<P> {
    #[inline(always)]
    fn new(p: P) -> Self {
        Splits {
            count: p.splat(0.0),
            many: p.splat(SPLITS),
        }
    }

    /// Counts a step. Which of the lanes that crawl may jump? Neighbours do together, and take along who is nearly as far.
    #[inline(always)]
    fn often(&mut self, p: P, split: P::M, crawls: P::M, live: P::M) -> P::M {
        let one = p.splat(1.0);
        let step = p.select(split, one, p.neg_f(one));
        self.count = p.max_f(p.add_rn(self.count, step), p.splat(0.0));
        let enough = p.and(crawls, p.le(self.many, self.count));
        if 2 * p.bits(enough).count_ones() < p.bits(live).count_ones() {
            return p.none();
        }
        p.and(crawls, p.le(p.sub_rn(self.many, one), self.count))
    }

    /// Those that tried begin again; it takes twice as many where they did not jump.
    #[inline(always)]
    fn tried(&mut self, p: P, tried: P::M, jumped: P::M) {
        self.count = p.select(tried, p.splat(0.0), self.count);
        let twice = p.add_rn(self.many, self.many);
        self.many = p.select(p.and_not(tried, jumped), twice, self.many);
    }
}

impl<P: Packet> Pace<P> {
    /// Takes a step of this length into account. Where was enough spent on short ones?
    #[inline(always)]
    fn tired(&mut self, p: P, short: P::F, length: P::F, front: P::F, spent: P::F) -> P::M {
        let long = p.lt(short, length);
        self.since = p.select(long, spent, self.since);
        self.from = p.select(long, front, self.from);
        let enough = p.lt(self.patience, p.sub_rn(spent, self.since));
        let near = p.le(p.sub_rn(front, self.from), short);
        p.and_not(p.and(enough, near), long)
    }
}

impl<P: Packet> Front<P> {
    /// Moves on: behind T where it holds no root, else to the first piece.
    #[inline(always)]
    fn advance(
        &mut self,
        p: P,
        (end, short): (P::F, P::F),
        none: P::M,
        first: &Interval<P::F>,
        next: P::F,
    ) {
        let length = p.sub_rn(self.back, self.front);
        let split = p.and_not(p.lt(first.hi, next), none);
        let in_gap = p.and(p.le(self.gap.lo, self.back), p.lt(self.back, self.gap.hi));
        let behind = p.select(in_gap, self.gap.hi, self.back);
        self.gap = select(
            p,
            split,
            &Interval {
                lo: first.hi,
                hi: next,
            },
            &self.gap,
        );
        self.front = p.select(none, behind, first.lo);
        let growth = p.select(p.lt(length, short), p.splat(LEAP), p.splat(STRIDE));
        let longer = p.min_f(p.add_rn(behind, p.mul_rn(length, growth)), end);
        self.back = p.select(none, p.max_f(longer, behind), first.hi);
    }

    /// A piece that is as long as what was crawled over since `from`. The march goes on behind it.
    #[inline(always)]
    fn leap(&mut self, p: P, end: P::F, shortest: P::F, lanes: P::M, from: P::F) -> Interval<P::F> {
        let length = p.max_f(p.sub_rn(self.front, from), shortest);
        let piece = Interval {
            lo: self.front,
            hi: p.min_f(p.add_rn(self.front, length), end),
        };
        self.front = p.select(lanes, piece.hi, self.front);
        let back = p.min_f(p.add_rn(piece.hi, length), end);
        self.back = p.select(lanes, back, self.back);
        piece
    }

    /// Takes over what was found out about the stuck lanes; returns the lanes that go on.
    #[inline(always)]
    fn settle(
        &mut self,
        p: P,
        end: P::F,
        live: P::M,
        stuck: P::M,
        outcome: &Outcome<P>,
        found: &mut Brackets<P>,
    ) -> P::M {
        let one = p.and(outcome.brackets.found, stuck);
        found.join(p, one, &outcome.brackets);
        let length = p.sub_rn(outcome.behind, self.front);
        self.front = p.select(stuck, outcome.behind, self.front);
        let longer = p.mul_rn(length, p.splat(GROWTH));
        let longer = p.min_f(p.add_rn(outcome.behind, longer), end);
        self.back = p.select(stuck, p.max_f(longer, outcome.behind), self.back);
        let done = p.or(one, p.and(stuck, p.le(end, outcome.behind)));
        p.and_not(live, done)
    }
}

/// The budget is spent: all from `front` to `end` is open.
#[cold]
pub(super) fn leave_rest<P: Packet>(
    p: P,
    lanes: P::M,
    front: P::F,
    end: P::F,
    events: &mut Events,
) {
    let t = Interval { lo: front, hi: end };
    leave(p, lanes, &t, [Why::Budget; 2], 0, events);
}

/// Leaves a piece open, for the second reason where bits are set, else for the first.
#[cold]
#[inline(never)]
fn leave<P: Packet>(
    p: P,
    lanes: P::M,
    t: &Interval<P::F>,
    why: [Why; 2],
    second: u8,
    events: &mut Events,
) {
    let (lo, hi) = (p.to_array(t.lo), p.to_array(t.hi));
    let lanes = p.bits(lanes);
    for lane in (0..8).filter(|lane| lanes >> lane & 1 != 0) {
        let t = Interval {
            lo: lo[lane],
            hi: hi[lane],
        };
        let why = why[usize::from(second >> lane & 1)];
        events.push(lane, Verdict::Unresolved { t, why });
    }
}
