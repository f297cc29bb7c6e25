//! Which of a box's eight parts certainly hold no root: the parts are the lanes of a packet.

use std::sync::Arc;

use super::cells::{Place, Root, eight};
use crate::beam::{Bundle, Direction, Shift, Slab, Thin, Towards};
use crate::interval::{Interval, Packet, Routine, back_ends};
use crate::solve::{differentiable, excluded, nonzero};
use crate::surface::Active;

/// A box to be divided, and the rows of tables that matter in it.
pub(crate) type Cell = (Place, Arc<Active>);

/// Boxes to be divided.
pub(crate) struct Boxes<'a> {
    pub root: &'a Root,
    /// The level of the parts.
    pub level: u32,
    pub cells: &'a [Cell],
    /// Choose the rows that matter in each part?
    pub thin: bool,
}

/// What became of boxes.
#[derive(Default)]
pub(crate) struct Division {
    /// For each box, the parts that may hold roots.
    pub open: Vec<u8>,
    /// These parts, one behind the other.
    pub parts: Vec<Cell>,
    /// Enclosures, each of eight parts.
    pub evaluations: u64,
}

impl Division {
    /// A box whose parts may hold roots where bits are set, with the rows that matter in each.
    pub fn add(&mut self, place: Place, open: u8, mut active: impl FnMut(usize) -> Arc<Active>) {
        self.open.push(open);
        for (k, part) in eight(place).into_iter().enumerate() {
            if open >> k & 1 != 0 {
                self.parts.push((part, active(k)));
            }
        }
    }
}

/// The division, compiled here for each instruction set.
#[derive(Clone, Copy)]
pub(crate) struct Divider<P: Packet>(fn(P, &mut dyn Bundle<P>, &Boxes) -> Division);

back_ends!(DIVIDERS: Divider::READY);

impl<P: Packet> Divider<P> {
    const READY: Self = Divider(|p, surface, boxes| p.call(Divide { surface, boxes }));

    /// Looks at the parts of each box. All back-ends are listed; one that were not would know nothing.
    pub fn divide(p: P, surface: &mut dyn Bundle<P>, boxes: &Boxes) -> Option<Division> {
        let divider = DIVIDERS.iter().find_map(|d| d.downcast_ref::<Self>())?;
        Some(divider.0(p, surface, boxes))
    }
}

struct Divide<'a, 'b, P: Packet> {
    surface: &'a mut dyn Bundle<P>,
    boxes: &'a Boxes<'b>,
}

impl<P: Packet> Routine<P> for Divide<'_, '_, P> {
    type Output = Division;

    #[inline(always)]
    fn call(mut self, p: P) -> Division {
        let (mut division, mut thin) = (Division::default(), Thin::default());
        for (place, active) in self.boxes.cells {
            let slab = self.enter(p, *place, active);
            let open = self.open(p, &slab, &mut division.evaluations);
            if !self.boxes.thin || open == 0 || !active.is_open() {
                division.add(*place, open, |_| active.clone());
                continue;
            }
            self.weigh(p, &slab, active, &mut thin);
            division.add(*place, open, |lane| {
                let mut chosen = Active::default();
                thin.choose(active, lane, &mut chosen);
                Arc::new(chosen)
            });
        }
        division
    }
}

impl<P: Packet> Divide<'_, '_, P> {
    /// Moves the leaves to the middles of a box's parts. In the axes' own frame parts are slabs: x is t.
    #[inline(always)]
    fn enter(&mut self, p: P, place: Place, active: &Active) -> Slab<P::F> {
        let Boxes { root, level, .. } = *self.boxes;
        let [t, x, y] = root.parts(p, place, level);
        let at = [p.mid(x), p.mid(y)];
        let half = |side: Interval<P::F>, middle: P::F| {
            p.max_f(p.sub_ru(side.hi, middle), p.sub_ru(middle, side.lo))
        };
        let turn = [p.splat(0.0); 2];
        self.surface.shift(p, &Shift { p, at, turn }, active);
        Slab {
            t,
            half: [half(x, at[0]), half(y, at[1])],
        }
    }

    /// The parts that may hold roots, by f and by its mean value form.
    #[inline(always)]
    fn open(&self, p: P, slab: &Slab<P::F>, evaluations: &mut u64) -> u8 {
        let f = self.surface.value(p, slab);
        *evaluations += 1;
        let all = p.not(p.none());
        let rest = p.and_not(all, excluded(p, &f.d[0], &f.flags, all));
        if !p.any(rest) {
            return 0;
        }
        let [x, y] = [Direction::Right, Direction::Up]
            .map(|direction| self.surface.slope(p, &towards(p, *slab, direction)));
        let middle = Slab {
            half: [p.splat(0.0); 2],
            ..*slab
        };
        let middle = self.surface.value(p, &middle);
        *evaluations += 3;
        let mean = slab.mean(p, &middle.d[0], &[x.d[1], y.d[1]]);
        let usable = differentiable(p, &y.flags, differentiable(p, &x.flags, rest));
        p.bits(p.and_not(rest, p.and(usable, nonzero(p, &mean))))
    }

    /// Learns how much each row matters in the parts.
    #[inline(always)]
    fn weigh(&self, p: P, slab: &Slab<P::F>, active: &Active, thin: &mut Thin) {
        if !active.rest.is_empty() {
            let middle = p.mid(slab.t);
            let middle = Slab {
                t: p.point(middle),
                half: [p.splat(0.0); 2],
            };
            let over = towards(p, middle, Direction::Any);
            thin.measure(|to| self.surface.terms(p, &over, to));
        }
        let over = towards(p, *slab, Direction::Any);
        thin.weigh(active, self.surface.regions(), |to| {
            self.surface.terms(p, &over, to)
        });
    }
}

/// A direction along an axis of space: nothing turns.
#[inline(always)]
fn towards<P: Packet>(p: P, over: Slab<P::F>, direction: Direction) -> Towards<P::F> {
    let zero = p.splat(0.0);
    Towards {
        over,
        direction,
        tilt: zero,
        turn: [zero; 2],
    }
}
