//! A solid over beams, as one surface: its f is the greatest and the least of its operands' f.

use core::any::Any;

use super::trace::PreparedSolid;
use super::tree::{Node, Side};
use crate::beam::{Bundle, Findings, Hint, Request, Scout, Shift, Slab, Thin, Towards};
use crate::interval::{Flags, Interval, Jet, Kernel, Packet, Routine, Truth, Undecided};
use crate::solve::Enclosed;
use crate::span::Span8;
use crate::surface::{Active, Choice, Terms};
use crate::trace::{OnPicture, Operand};

/// The operands over the beams of a picture, one by one; nothing of those without leaves.
pub(super) type OnPictures = Vec<Option<OnPicture>>;

/// The side of each operand that a list of what is active tells: each is compared with 0.
pub(super) fn side(known: Choice) -> Side {
    match known {
        Choice::Open => Side::Unknown,
        Choice::First => Side::In,
        Choice::Second => Side::Out,
    }
}

/// A solid over eight beams.
///
/// Where operands are known to be on certain sides, they are left out of the tree: what is left has the sign of the
/// solid's f, thus its roots, and is as continuous. Which are left out changes only when leaves are moved, so that all
/// enclosures between are those of one function.
pub(super) struct OverSolid<'a, P: Packet> {
    solid: &'a PreparedSolid<'a>,
    pictures: &'a OnPictures,
    /// Those that were needed so far.
    operands: Vec<Option<Operand<'a, P>>>,
    /// What of the tree is open, or the side of the solid.
    open: Result<Node, Side>,
    parts: u64,
}

impl<'a, P: Packet> OverSolid<'a, P> {
    /// Nothing if the leaves are not this solid's.
    pub fn new(solid: &'a PreparedSolid, leaves: &'a (dyn Any + Send + Sync)) -> Option<Self> {
        let pictures: &OnPictures = leaves.downcast_ref()?;
        Some(OverSolid {
            solid,
            pictures,
            operands: pictures.iter().map(|_| None).collect(),
            open: Err(Side::Unknown),
            parts: 0,
        })
    }

    /// Moves an operand's leaves.
    fn shift_operand(&mut self, p: P, leaf: usize, shift: &Shift<P>) {
        let Some(picture) = &self.pictures[leaf] else {
            return;
        };
        let operand = &mut self.operands[leaf];
        if operand.is_none() {
            *operand = picture.open(p, self.solid.leaves[leaf].prepared());
        }
        if let Some(operand) = operand {
            operand.shift(p, shift, picture.everything());
            self.parts += operand.parts();
        }
    }

    /// What is enclosed by the enclosures that `ask` gives of operands.
    fn enclose<const N: usize>(
        &self,
        p: P,
        node: &Node,
        ask: &dyn Fn(&dyn Bundle<P>) -> Enclosed<P, N>,
    ) -> Enclosed<P, N> {
        match node {
            Node::Leaf(index) => match &self.operands[*index] {
                Some(operand) => p.call(OnASide(ask(&**operand))),
                None => unknown(p),
            },
            Node::Not(inner) => negated(p, self.enclose(p, inner, ask)),
            Node::Both(parts) => {
                let parts = parts.iter().map(|part| self.enclose(p, part, ask));
                let greatest = parts.reduce(|a, b| p.call(Greater(a, b)));
                greatest.unwrap_or_else(|| unknown(p))
            }
            Node::Either(parts) => {
                let parts = parts
                    .iter()
                    .map(|part| negated(p, self.enclose(p, part, ask)));
                let greatest = parts.reduce(|a, b| p.call(Greater(a, b)));
                negated(p, greatest.unwrap_or_else(|| unknown(p)))
            }
        }
    }

    fn asked<const N: usize>(
        &self,
        p: P,
        ask: &dyn Fn(&dyn Bundle<P>) -> Enclosed<P, N>,
    ) -> Enclosed<P, N> {
        match &self.open {
            Ok(node) => self.enclose(p, node, ask),
            Err(Side::Unknown) => unknown(p),
            // A number of the sign.
            Err(side) => {
                let sign = if *side == Side::In { -1.0 } else { 1.0 };
                let mut d = [p.constant(&Interval::ZERO); N];
                d[0] = p.point(p.splat(sign));
                Jet {
                    d,
                    flags: Flags::none(p),
                }
            }
        }
    }
}

impl<P: Packet> Bundle<P> for OverSolid<'_, P> {
    fn parts(&self) -> u64 {
        self.parts
    }

    fn is_dear(&self) -> bool {
        true
    }

    fn shift(&mut self, p: P, shift: &Shift<P>, active: &Active) {
        self.parts = 0;
        let node = &self.solid.node;
        let open = node.given(&|leaf| side(active.choice(leaf)));
        if let Ok(open) = &open {
            open.leaves(&mut |leaf| self.shift_operand(p, leaf, shift));
        }
        self.open = open;
    }

    fn value(&self, p: P, over: &Slab<P::F>) -> Enclosed<P, 1> {
        self.asked(p, &|operand| operand.value(p, over))
    }

    fn slope(&self, p: P, over: &Towards<P::F>) -> Enclosed<P, 2> {
        self.asked(p, &|operand| operand.slope(p, over))
    }

    /// The operands that are on one certain side.
    fn terms(&self, p: P, over: &Towards<P::F>, to: &mut Thin) {
        let Ok(open) = &self.open else { return };
        open.leaves(&mut |leaf| {
            if let Some(operand) = &self.operands[leaf] {
                let f = operand.value(p, &over.over);
                let zero = p.splat(0.0);
                let (inside, outside) = (p.lt(f.d[0].hi, zero), p.lt(zero, f.d[0].lo));
                let truth = |yes: P::M, no: P::M| Truth { yes, no };
                let less = [truth(inside, outside), truth(outside, inside)];
                (p, &mut *to).choice(leaf, less, f.flags);
            }
        });
    }
}

/// Nothing is known.
fn unknown<P: Packet, const N: usize>(p: P) -> Enclosed<P, N> {
    let mut flags = Flags::none(p);
    flags.undefined = p.not(p.none());
    Jet {
        d: [p.entire(); N],
        flags,
    }
}

fn negated<P: Packet, const N: usize>(p: P, a: Enclosed<P, N>) -> Enclosed<P, N> {
    Jet {
        d: a.d.map(|a| Interval {
            lo: p.neg_f(a.hi),
            hi: p.neg_f(a.lo),
        }),
        flags: a.flags,
    }
}

/// An operand that may not be defined is on no certain side.
struct OnASide<P: Packet, const N: usize>(Enclosed<P, N>);

impl<P: Packet, const N: usize> Routine<P> for OnASide<P, N> {
    type Output = Enclosed<P, N>;
    #[inline(always)]
    fn call(self, p: P) -> Enclosed<P, N> {
        let OnASide(mut f) = self;
        f.flags.undefined = p.or(f.flags.undefined, f.flags.empty);
        f.flags.empty = p.none();
        f.d[0] = p.select_interval(f.flags.undefined, p.entire(), f.d[0]);
        f
    }
}

/// The greater of two numbers, with derivatives: those of the greater one where it is certain which that is, else the
/// hull of both.
struct Greater<P: Packet, const N: usize>(Enclosed<P, N>, Enclosed<P, N>);

impl<P: Packet, const N: usize> Routine<P> for Greater<P, N> {
    type Output = Enclosed<P, N>;
    #[inline(always)]
    fn call(self, p: P) -> Enclosed<P, N> {
        let Greater(a, b) = self;
        let first = Truth {
            yes: p.lt(b.d[0].hi, a.d[0].lo),
            no: p.lt(a.d[0].hi, b.d[0].lo),
        };
        let mut d = a.d;
        let mut k = 1;
        while k < N {
            let both = p.hull(a.d[k], b.d[k]);
            let one = p.select_interval(first.no, b.d[k], both);
            d[k] = p.select_interval(first.yes, a.d[k], one);
            k += 1;
        }
        d[0] = Interval {
            lo: p.max_f(a.d[0].lo, b.d[0].lo),
            hi: p.max_f(a.d[0].hi, b.d[0].hi),
        };
        Jet {
            d,
            flags: first.branch(p, a.flags, b.flags, Undecided::Kink),
        }
    }
}

/// What is known about the beams of a grid.
pub(super) struct SurveySolid<'a> {
    pub solid: &'a PreparedSolid<'a>,
    pub leaves: &'a (dyn Any + Send + Sync),
    pub request: &'a Request<'a>,
    pub findings: &'a mut Findings,
}

impl Kernel for SurveySolid<'_> {
    type Output = ();

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        match OverSolid::<P>::new(self.solid, self.leaves) {
            Some(mut over) => {
                // Sides of operands are to hold along all of the rays: an octree's boxes end beams, and shorten none.
                let request = Request {
                    within: Span8::ALL,
                    ..*self.request
                };
                Scout::survey(p, &mut over, &request, self.findings);
            }
            None => self.findings.know(&Hint::OPEN, self.request.rows),
        }
    }
}
