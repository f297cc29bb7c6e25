//! The operands of a solid along the rays of a tile: each is traced only where it can matter.

use super::leaf::PreparedLeaf;
use super::span::Span8;
use super::sweep::{Operand, Sweep};
use super::tree::{Node, Side};
use crate::interval::{Interval, Isa};
use crate::render::tile::PacketRays;
use crate::solve::{Evaluations, Settings};
use crate::trace::{Beam, Trails, eighth};

/// A searched piece is longer by this share of the ray at both ends, so that no root is at the end of a search.
const MARGIN: f64 = 1.0 / 65536.0;

/// Eight rays per packet, and what is known of each operand on them.
pub(super) struct Explored<'a> {
    node: &'a Node,
    beam: &'a Beam,
    operands: Vec<Surveyed>,
}

/// An operand over a tile.
#[derive(Default)]
struct Surveyed {
    /// On each eighth of the beam, as far as that was asked for.
    survey: [Side; 8],
    /// Where it can matter.
    relevant: Option<Interval>,
    trails: Option<Trails>,
}

/// What a node may be on each ray: the hull of where it is not certainly outside, and of where not certainly inside.
struct May {
    inside: Vec<Span8>,
    outside: Vec<Span8>,
}

/// The work on a tile.
pub(super) struct Explorer<'a, 't> {
    pub node: &'a Node,
    pub leaves: &'t [Box<dyn PreparedLeaf + 't>],
    pub isa: Isa,
    pub settings: &'t Settings,
    pub packets: &'t [PacketRays],
    pub beam: &'a Beam,
    pub counts: &'t mut Evaluations,
}

impl<'a> Explorer<'a, '_> {
    /// Traces the operands over `over`, one segment for each ray; nothing if no ray meets the solid's boundary.
    pub fn explore(mut self, over: &[Span8]) -> Option<Explored<'a>> {
        let (isa, beam, node) = (self.isa, self.beam, self.node);
        let mut operands = Vec::with_capacity(self.leaves.len());
        operands.resize_with(self.leaves.len(), Surveyed::default);
        let whole = node.sides(&mut |leaf| {
            let survey = self.leaves[leaf].survey(isa, beam, self.counts);
            operands[leaf].survey = survey;
            survey
        });
        let mut anything = false;
        for k in (0..8).filter(|k| whole[*k] == Side::Unknown) {
            let sides: Vec<Side> = operands.iter().map(|o| o.survey[k]).collect();
            let side = |leaf: usize| sides[leaf];
            anything = true;
            let piece = eighth(beam.end, k);
            node.relevant(&side, &mut |leaf| {
                let relevant = &mut operands[leaf].relevant;
                *relevant = Some(relevant.map_or(piece, |r| r.hull(&piece)));
            });
        }
        if anything {
            self.visit(node, over, &mut operands);
        }
        self.count(over, &operands);
        anything.then_some(Explored {
            node,
            beam,
            operands,
        })
    }

    /// Counts what was not searched.
    fn count(&mut self, over: &[Span8], operands: &[Surveyed]) {
        for (packet, span) in over.iter().enumerate() {
            for lane in 0..8 {
                let ray = span.of(lane);
                if ray.lo > ray.hi {
                    continue;
                }
                for operand in operands {
                    let searched = operand.trails.as_ref().map(|t| t.searched[packet].of(lane));
                    match searched.filter(|t| t.lo <= t.hi) {
                        None => self.counts.spared += 1,
                        Some(t) => self.counts.shortened += u64::from(t != ray),
                    }
                }
            }
        }
    }

    /// Traces what is below a node over `search`. The operands of an intersection are of interest only where none of those
    /// before is certainly outside, and those of a union where none is certainly inside.
    fn visit(&mut self, node: &Node, search: &[Span8], operands: &mut [Surveyed]) -> May {
        match node {
            Node::Leaf(index) => self.trace(*index, search, operands),
            Node::Not(inner) => {
                let May { inside, outside } = self.visit(inner, search, operands);
                May {
                    inside: outside,
                    outside: inside,
                }
            }
            Node::Both(parts) => {
                let (inside, outside) =
                    self.among(parts, search, operands, |may| (may.inside, may.outside));
                May { inside, outside }
            }
            Node::Either(parts) => {
                let (outside, inside) =
                    self.among(parts, search, operands, |may| (may.outside, may.inside));
                May { inside, outside }
            }
        }
    }

    /// Where no part is certainly on the side that decides, and the hull of where some part may be.
    fn among(
        &mut self,
        parts: &[Node],
        search: &[Span8],
        operands: &mut [Surveyed],
        of: fn(May) -> (Vec<Span8>, Vec<Span8>),
    ) -> (Vec<Span8>, Vec<Span8>) {
        let mut open = search.to_vec();
        let mut decided = vec![Span8::EMPTY; search.len()];
        for part in parts {
            if open.iter().all(Span8::is_empty) {
                break;
            }
            let (still, done) = of(self.visit(part, &open, operands));
            for k in 0..search.len() {
                open[k] = open[k].meet(&still[k]);
                decided[k] = decided[k].hull(&done[k]);
            }
        }
        (open, decided)
    }

    fn trace(&mut self, index: usize, search: &[Span8], operands: &mut [Surveyed]) -> May {
        let whole = || May {
            inside: search.to_vec(),
            outside: search.to_vec(),
        };
        let operand = &mut operands[index];
        let Some(relevant) = operand.relevant else {
            return whole();
        };
        let margin = MARGIN * self.beam.end;
        let near = Span8 {
            lo: [relevant.lo - margin; 8],
            hi: [relevant.hi + margin; 8],
        };
        let limited: Vec<Span8> = search.iter().map(|span| span.meet(&near)).collect();
        let trails =
            self.leaves[index].trails(self.isa, self.settings, self.packets, limited, self.counts);
        let mut may = May {
            inside: vec![Span8::EMPTY; search.len()],
            outside: vec![Span8::EMPTY; search.len()],
        };
        for (packet, span) in search.iter().enumerate() {
            for lane in 0..8 {
                let (asked, searched) = (span.of(lane), trails.searched[packet].of(lane));
                let [inside, outside] = [&mut may.inside[packet], &mut may.outside[packet]];
                if asked != searched {
                    inside.add(lane, asked);
                    outside.add(lane, asked);
                    continue;
                }
                let mut add = |side: Side, lo: f64, hi: f64| {
                    let piece = Interval {
                        lo: lo - margin,
                        hi: hi + margin,
                    };
                    let Some(piece) = piece.intersect(&asked) else {
                        return;
                    };
                    if side != Side::Out {
                        inside.add(lane, piece);
                    }
                    if side != Side::In {
                        outside.add(lane, piece);
                    }
                };
                let (marks, start) = trails.of(packet, lane);
                let (mut from, mut side) = (asked.lo, start);
                for mark in marks {
                    add(side, from, mark.reach.lo);
                    add(Side::Unknown, mark.reach.lo, mark.reach.hi);
                    (from, side) = (mark.reach.hi, mark.after);
                }
                if asked.lo <= asked.hi {
                    add(side, from, asked.hi);
                }
            }
        }
        operand.trails = Some(trails);
        may
    }
}

impl Explored<'_> {
    /// A sweep over its rays.
    pub fn sweep(&self, first_only: bool) -> Sweep<'_> {
        Sweep {
            node: self.node,
            pieces: [0, 1, 2, 3, 4, 5, 6, 7].map(|k| eighth(self.beam.end, k)),
            operands: Vec::with_capacity(self.operands.len()),
            first_only,
            faces: Vec::new(),
        }
    }

    /// Finds the faces of the solid along one ray.
    pub fn faces<'s>(&'s self, sweep: &mut Sweep<'s>, packet: usize, lane: usize, over: Interval) {
        sweep.operands.clear();
        for Surveyed { survey, trails, .. } in &self.operands {
            let (mut searched, mut marks, mut side) = (Span8::EMPTY.of(0), &[][..], Side::Unknown);
            if let Some(trails) = trails {
                searched = trails.searched[packet].of(lane);
                (marks, side) = trails.of(packet, lane);
            }
            sweep.operands.push(Operand {
                trails: trails.as_ref(),
                searched,
                marks,
                side,
                survey,
            });
        }
        sweep.run(over);
    }
}
