//! The operands of a solid along the rays of a tile: each is traced only where it can matter.

use std::borrow::Cow;

use super::over::side;
use super::sweep::{Operand, Sweep};
use super::trace::PreparedSolid;
use super::tree::{Node, Side};
use crate::interval::{Interval, Isa};
use crate::render::tile::PacketRays;
use crate::solve::{Evaluations, Settings};
use crate::span::Span8;
use crate::surface::Active;
use crate::trace::{Beam, Trails, eighth};

/// A searched piece is longer by this share of the ray at both ends, so that no root is at the end of a search.
const MARGIN: f64 = 1.0 / 65536.0;

/// Eight rays per packet, and what is known of each operand on them.
pub(super) struct Explored<'a> {
    /// What of the solid's tree may matter.
    node: Cow<'a, Node>,
    pieces: [Interval; 8],
    operands: Vec<Surveyed>,
}

/// What is known of the operands before they are traced.
#[derive(Clone, Copy)]
pub(super) enum Known<'a> {
    /// They are surveyed on each eighth of a beam.
    Around(&'a Beam),
    /// The side of each wherever rays are of interest.
    Sides(&'a Active),
}

/// An operand over a tile.
#[derive(Default)]
struct Surveyed {
    /// On each piece of the rays, as far as that was asked for.
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

/// How rays are looked at.
#[derive(Clone, Copy)]
pub(super) struct Look<'a> {
    pub isa: Isa,
    pub settings: &'a Settings,
    /// Is the first certain face enough?
    pub first_only: bool,
}

/// The work on a tile.
pub(super) struct Explorer<'a, 't> {
    solid: &'a PreparedSolid<'a>,
    look: &'t Look<'t>,
    packets: &'t [PacketRays],
    counts: &'t mut Evaluations,
    /// Pieces of the rays that a survey tells sides of; they cover all that is of interest.
    pieces: [Interval; 8],
    /// How much longer searched pieces are.
    margin: f64,
}

impl<'a, 't> Explorer<'a, 't> {
    pub fn new(
        solid: &'a PreparedSolid<'a>,
        look: &'t Look<'t>,
        packets: &'t [PacketRays],
        counts: &'t mut Evaluations,
    ) -> Self {
        Explorer {
            solid,
            look,
            packets,
            counts,
            pieces: [Span8::EMPTY.of(0); 8],
            margin: 0.0,
        }
    }

    /// Traces the operands over `over`, one segment for each ray; nothing if no ray meets the solid's boundary.
    pub fn explore(mut self, known: Known, over: &[Span8]) -> Option<Explored<'a>> {
        let mut operands = Vec::with_capacity(self.solid.leaves.len());
        operands.resize_with(self.solid.leaves.len(), Surveyed::default);
        let node = match known {
            Known::Around(beam) => self.survey(beam, &mut operands),
            Known::Sides(active) => self.open(active, over, &mut operands),
        };
        if let Some(node) = &node {
            self.visit(node, over, &mut operands);
        }
        self.count(over, &operands);
        Some(Explored {
            node: node?,
            pieces: self.pieces,
            operands,
        })
    }

    /// Surveys the operands over pieces of the rays, and finds out on which of these each may matter; nothing if none does.
    fn survey(&mut self, beam: &Beam, operands: &mut [Surveyed]) -> Option<Cow<'a, Node>> {
        let PreparedSolid { node, leaves } = self.solid;
        node.sides(&mut |leaf| {
            let survey = leaves[leaf].survey(self.look.isa, beam, self.counts);
            operands[leaf].survey = survey;
            survey
        });
        self.pieces = [0, 1, 2, 3, 4, 5, 6, 7].map(|k| eighth(beam.end, k));
        self.margin = MARGIN * beam.end;
        let mut open = None;
        for (k, piece) in self.pieces.into_iter().enumerate() {
            let sides: Vec<Side> = operands.iter().map(|o| o.survey[k]).collect();
            let side = |leaf: usize| sides[leaf];
            if node.side(&side) != Side::Unknown {
                continue;
            }
            open = Some(Cow::Borrowed(node));
            node.relevant(&side, &mut |leaf| {
                let relevant = &mut operands[leaf].relevant;
                if sides[leaf] == Side::Unknown {
                    *relevant = Some(relevant.map_or(piece, |r| r.hull(&piece)));
                }
            });
        }
        open
    }

    /// What of the tree is open where the sides of operands are known; nothing if that of the solid is.
    fn open(
        &mut self,
        active: &Active,
        over: &[Span8],
        operands: &mut [Surveyed],
    ) -> Option<Cow<'a, Node>> {
        let open = self
            .solid
            .node
            .given(&|leaf| side(active.choice(leaf)))
            .ok()?;
        let end = over.iter().flat_map(|span| span.hi).fold(0.0, f64::max);
        let whole = Interval { lo: 0.0, hi: end };
        (self.pieces[0], self.margin) = (whole, MARGIN * end);
        for (leaf, operand) in operands.iter_mut().enumerate() {
            operand.survey = [side(active.choice(leaf)); 8];
        }
        open.leaves(&mut |leaf| operands[leaf].relevant = Some(whole));
        Some(Cow::Owned(open))
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

    /// Traces an operand where it is relevant; elsewhere its side is the surveyed one.
    fn trace(&mut self, index: usize, search: &[Span8], operands: &mut [Surveyed]) -> May {
        let margin = self.margin;
        let operand = &mut operands[index];
        if let Some(relevant) = operand.relevant {
            let near = Span8 {
                lo: [relevant.lo - margin; 8],
                hi: [relevant.hi + margin; 8],
            };
            let limited = search.iter().map(|span| span.meet(&near)).collect();
            let Look { isa, settings, .. } = *self.look;
            let leaf = &self.solid.leaves[index];
            operand.trails = Some(leaf.trails(isa, settings, self.packets, limited, self.counts));
        }
        let mut may = May {
            inside: vec![Span8::EMPTY; search.len()],
            outside: vec![Span8::EMPTY; search.len()],
        };
        for (packet, span) in search.iter().enumerate() {
            for lane in 0..8 {
                let asked = span.of(lane);
                operand.sides(&self.pieces, packet, lane, asked, |side, t| {
                    let piece = Interval {
                        lo: t.lo - margin,
                        hi: t.hi + margin,
                    };
                    let Some(piece) = piece.intersect(&asked) else {
                        return;
                    };
                    if side != Side::Out {
                        may.inside[packet].add(lane, piece);
                    }
                    if side != Side::In {
                        may.outside[packet].add(lane, piece);
                    }
                });
            }
        }
        may
    }
}

impl Surveyed {
    /// Tells its side on pieces that cover `asked`.
    fn sides(
        &self,
        pieces: &[Interval; 8],
        packet: usize,
        lane: usize,
        asked: Interval,
        mut tell: impl FnMut(Side, Interval),
    ) {
        if asked.lo > asked.hi {
            return;
        }
        let trails = self.trails.as_ref();
        let searched = trails.map(|trails| trails.searched[packet].of(lane));
        let searched = searched.filter(|t| t.lo <= t.hi);
        let (before, behind) = searched.map_or((asked.hi, asked.hi), |t| (t.lo, t.hi));
        for (piece, side) in pieces.iter().zip(self.survey) {
            for (lo, hi) in [(asked.lo, before), (behind, asked.hi)] {
                let (lo, hi) = (lo.max(piece.lo), hi.min(piece.hi));
                if lo <= hi {
                    tell(side, Interval { lo, hi });
                }
            }
        }
        if let (Some(trails), Some(searched)) = (trails, searched) {
            let (marks, start) = trails.of(packet, lane);
            let (mut lo, mut side) = (searched.lo, start);
            for mark in marks {
                tell(
                    side,
                    Interval {
                        lo,
                        hi: mark.reach.lo,
                    },
                );
                tell(Side::Unknown, mark.reach);
                (lo, side) = (mark.reach.hi, mark.after);
            }
            let hi = searched.hi;
            tell(side, Interval { lo, hi });
        }
    }
}

impl Explored<'_> {
    /// A sweep over its rays.
    pub fn sweep(&self, first_only: bool) -> Sweep<'_> {
        Sweep {
            node: &self.node,
            pieces: self.pieces,
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
