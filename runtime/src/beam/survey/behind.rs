//! What lies behind what is near: eight pieces of one beam in one look.
//!
//! Where few rows and sides matter is near a beam's front. Rays that pass there run through much of the scene, most of it empty.
//! Of each piece the beam tells whether it is, and if not, what matters in it.

use super::{Bundle, Scout, Space};
use crate::beam::{Group, Thin};
use crate::interval::{Packet, Routine};
use crate::solve::excluded;
use crate::surface::Active;

/// A beam from a parameter on.
pub(crate) struct Behind<'a> {
    pub space: Space<'a>,
    /// The rectangle of pixels: see [`Group::new`].
    pub corner: [f64; 2],
    pub size: [u32; 2],
    /// Where it begins and ends; parameters count from the camera.
    pub within: [f64; 2],
    /// What of the surface matters there.
    pub active: &'a Active,
}

/// What is found out about the pieces, one behind the other.
#[derive(Default)]
pub(crate) struct Pieces {
    /// Where each ends, and the next begins.
    pub end: [f64; 8],
    /// Those that may hold roots.
    pub open: u8,
    /// What matters in each of these.
    pub active: [Active; 8],
    thin: Thin,
}

/// Each piece is so much longer than the one before.
const GROWTH: f64 = 1.25;

impl<P: Packet> Scout<P> {
    /// Looks at the pieces: with how many evaluations. Nothing on a back-end that is not listed.
    pub fn look_behind(
        p: P,
        surface: &mut dyn Bundle<P>,
        beam: &Behind,
        pieces: &mut Pieces,
    ) -> Option<u64> {
        let scout = Self::found()?;
        Some((scout.behind)(p, surface, beam, pieces))
    }
}

/// A look at the pieces.
pub(super) struct LookBehind<'a, 'b, P: Packet> {
    pub surface: &'a mut dyn Bundle<P>,
    pub beam: &'a Behind<'b>,
    pub pieces: &'a mut Pieces,
}

impl<P: Packet> Routine<P> for LookBehind<'_, '_, P> {
    type Output = u64;

    #[inline(always)]
    fn call(mut self, p: P) -> u64 {
        self.pieces.open = 0;
        for part in 0..P::PARTS {
            self.part(p.part(part));
        }
        P::PARTS as u64 * self.surface.parts()
    }
}

impl<P: Packet> LookBehind<'_, '_, P> {
    /// Looks at the pieces that are the token's own.
    #[inline(always)]
    fn part(&mut self, p: P) {
        let Behind {
            space: Space { frame, domain },
            corner,
            size,
            within: [from, to],
            active,
        } = *self.beam;
        let group = Group::alone(p, frame, corner, size);
        let near = p.splat(frame.near);
        let first = p.sub_rd(p.splat(from), near);
        let last = p.min_f(group.span(p, domain).hi, p.sub_ru(p.splat(to), near));
        let length = p.max_f(p.sub_rn(last, first), p.splat(0.0));
        let [lo, hi] = [0, 1].map(|side| {
            let part = core::array::from_fn(|piece| before(piece + side) / before(8));
            p.add_rn(first, p.mul_rn(length, p.lanes(part)))
        });
        let over = group.around(p, lo, hi);
        self.surface.shift(p, &group.shift(p), active);
        let f = self.surface.value(p, &over.over);
        let all = p.not(p.none());
        let open = p.bits(p.and_not(all, excluded(p, &f.d[0], &f.flags, all)));
        let ends = p.to_array(p.add_rd(hi, near));
        let Pieces {
            end,
            open: found,
            active: own,
            thin,
        } = &mut *self.pieces;
        for piece in p.own() {
            end[piece] = if piece == 7 {
                f64::INFINITY
            } else {
                ends[piece]
            };
            *found |= open & 1 << piece;
        }
        if open != 0 {
            thin.look_at(p.own(), 0);
            thin.weigh(active, self.surface.regions(), |to| {
                self.surface.terms(p, &over, to);
            });
            // The next part of the packet learns anew.
            for piece in p.own().filter(|piece| open >> piece & 1 != 0) {
                thin.choose(active, piece, &mut own[piece]);
            }
        }
    }
}

/// How long the pieces before this one are together, in lengths of the first.
#[inline(always)]
fn before(piece: usize) -> f64 {
    const BEFORE: [f64; 9] = {
        let (mut before, mut length) = ([0.0; 9], 1.0);
        let mut piece = 0;
        while piece < 8 {
            before[piece + 1] = before[piece] + length;
            length *= GROWTH;
            piece += 1;
        }
        before
    };
    BEFORE[piece]
}
