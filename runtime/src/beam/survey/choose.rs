//! The rows that matter in beams that are open.

use super::march::Surveyor;
use super::{Found, Stretch};
use crate::beam::{Direction, Frame, Rows, Thin};
use crate::interval::Packet;
use crate::surface::Active;

/// How many widths of a beam are near its front.
const REACH: f64 = 6.0;

impl<P: Packet> Surveyor<'_, P> {
    /// Chooses the rows that matter in the open beams among those of `active`, which hold to the end of the stretch or of
    /// all: up to a few widths from the front or behind the only root, and on all of the rest.
    #[inline(always)]
    pub(super) fn choose(
        &self,
        found: &Found<P>,
        frame: &Frame,
        thin: &mut Thin,
        (given, active, to_the_end): (&Rows, &Active, bool),
        rows: &mut [Rows; 8],
    ) {
        let p = self.p;
        // The root of these was separated for f with the rows that are given: with fewer it must be the same.
        thin.look_at(p.own(), p.bits(found.one));
        let open = p.bits(found.open);
        let lanes = move || (0..8).filter(move |lane| open >> lane & 1 != 0);
        let Stretch { end, last, .. } = *self.stretch;
        let width = self.group.width(p, found.front);
        let ahead = p.add_rn(found.front, p.mul_rn(width, p.splat(REACH)));
        let reach = p.min_f(p.select(found.one, found.back, ahead), end);
        let (work, regions) = (self.surface.work(), self.surface.regions());
        if !active.rest.is_empty() {
            let front = self.middle(found.front, Direction::Any);
            thin.measure(|to| self.surface.terms(p, &front, to));
        }
        thin.weigh(active, regions, |to| {
            self.surface.terms(p, &self.around(found.front, reach), to)
        });
        let all = p.or(found.inside, p.le(last, reach));
        let reach = p.select(
            all,
            p.splat(f64::INFINITY),
            p.add_rd(reach, p.splat(frame.near)),
        );
        let reach = p.to_array(reach);
        let mut all = p.bits(all);
        let before = active.rows.is_empty().then(|| work.of(active));
        for lane in lanes() {
            thin.choose(active, lane, &mut rows[lane].near);
            rows[lane].all.clone_from(&given.all);
            rows[lane].reach = reach[lane];
            rows[lane].vain = 0;
            // Nothing is left out, or no side of a choice that is worth it: it holds as far as before.
            let near = &rows[lane].near;
            let few = before.is_some_and(|before| !work.pays(near, before));
            if few || !near.is_less_than(active) {
                rows[lane].near.clone_from(active);
                rows[lane].vain = given.vain + 1;
                rows[lane].reach = if to_the_end {
                    f64::INFINITY
                } else {
                    given.reach
                };
                all |= 1 << lane;
            }
        }
        if to_the_end && open & !all != 0 && (self.stretch.keenly || !active.rest.is_empty()) {
            thin.weigh(active, regions, |to| {
                self.surface.terms(p, &self.around(found.front, last), to)
            });
            for lane in lanes().filter(|lane| all >> lane & 1 == 0) {
                thin.choose(active, lane, &mut rows[lane].all);
            }
        }
    }
}
