//! A surface over beams: its leaves for a picture, and what is certain for the tiles of a block. An operand of a solid
//! becomes an object.

use core::any::Any;
use core::marker::PhantomData;

use super::Entries;
use crate::beam::{
    Assemble, Bundle, Findings, Frame, Hint, OverBeams, Request, Scout, Shift, Slab, Space, Thin,
    Towards,
};
use crate::interval::{Kernel, Packet, Routine};
use crate::solve::Enclosed;
use crate::space::{Boxes, Divider, Division};
use crate::surface::{Active, Regions, Surface, Work};

/// The leaves of a whole picture, `S::Bound<OverBeams<P>>` of the render's instruction set.
pub(crate) type Leaves = Box<dyn Any + Send + Sync>;

/// What beams need.
#[derive(Clone, Copy)]
pub(crate) struct WithBeams<'a> {
    pub space: Space<'a>,
    pub leaves: &'a (dyn Any + Send + Sync),
}

/// Computes the leaves of a picture; nothing for a surface without leaves.
pub(crate) struct AssembleLeaves<'a, S: Surface> {
    pub prepared: &'a S::Prepared,
    pub frame: &'a Frame,
}

impl<S: Surface> Kernel for AssembleLeaves<'_, S> {
    type Output = Option<Leaves>;
    const IN_PARTS: bool = true;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Option<Leaves> {
        let eight = p.eight();
        let (lines, active) = (self.frame.lines(eight), S::everything(self.prepared));
        let mut along = S::unbound::<P::Eight>(eight);
        Entries::<S, P::Eight>::bind(eight, self.prepared, &lines, &active, &mut along);
        let mut over = S::unbound::<OverBeams<P>>(p);
        S::rebind(&Assemble(p), &along, &active, &mut over).then(|| Box::new(over) as Leaves)
    }
}

/// A surface bound to eight beams.
pub(super) struct OverGroup<'a, S: Surface, P: Packet> {
    prepared: &'a S::Prepared,
    /// The picture's leaves.
    from: &'a S::Bound<OverBeams<P>>,
    /// These beams' leaves.
    pub(super) bound: Box<S::Bound<OverBeams<P>>>,
}

impl<'a, S: Surface, P: Packet> OverGroup<'a, S, P> {
    /// Nothing if the leaves are not this surface's, on this instruction set.
    pub fn new(
        p: P,
        prepared: &'a S::Prepared,
        leaves: &'a (dyn Any + Send + Sync),
    ) -> Option<Self> {
        Self::within(prepared, leaves, || Box::new(S::unbound::<OverBeams<P>>(p)))
    }

    /// The same in room that may have been used before.
    pub fn within(
        prepared: &'a S::Prepared,
        leaves: &'a (dyn Any + Send + Sync),
        room: impl FnOnce() -> Box<S::Bound<OverBeams<P>>>,
    ) -> Option<Self> {
        Some(OverGroup {
            prepared,
            from: leaves.downcast_ref()?,
            bound: room(),
        })
    }
}

impl<S: Surface, P: Packet> Bundle<P> for OverGroup<'_, S, P> {
    fn shift(&mut self, p: P, shift: &Shift<P>, active: &Active) {
        p.call(Rebound {
            of: self,
            shift,
            active,
        });
    }
    fn value(&self, p: P, over: &Slab<P::F>) -> Enclosed<P, 1> {
        p.call(Value { of: self, over })
    }
    fn slope(&self, p: P, over: &Towards<P::F>) -> Enclosed<P, 2> {
        p.call(Slope { of: self, over })
    }
    fn terms(&self, p: P, over: &Towards<P::F>, to: &mut Thin) {
        p.call(AllTerms { of: self, over, to });
    }
    fn regions(&self) -> &'static Regions {
        &S::REGIONS
    }
    fn work(&self) -> &'static Work {
        &S::WORK
    }
    fn is_closed(&self) -> bool {
        S::quadric(&self.bound).is_some()
    }
}

struct AllTerms<'a, 'b, S: Surface, P: Packet> {
    of: &'a OverGroup<'b, S, P>,
    over: &'a Towards<P::F>,
    to: &'a mut Thin,
}

impl<S: Surface, P: Packet> Routine<P> for AllTerms<'_, '_, S, P> {
    type Output = ();
    #[inline(always)]
    fn call(self, p: P) {
        let OverGroup {
            prepared, bound, ..
        } = self.of;
        S::terms(p, prepared, bound, *self.over, &mut (p, self.to));
    }
}

struct Rebound<'a, 'b, S: Surface, P: Packet> {
    of: &'a mut OverGroup<'b, S, P>,
    shift: &'a Shift<P>,
    active: &'a Active,
}

impl<S: Surface, P: Packet> Routine<P> for Rebound<'_, '_, S, P> {
    type Output = ();
    #[inline(always)]
    fn call(self, _p: P) {
        let OverGroup { from, bound, .. } = self.of;
        S::rebind(self.shift, from, self.active, bound);
    }
}

struct Value<'a, 'b, S: Surface, P: Packet> {
    of: &'a OverGroup<'b, S, P>,
    over: &'a Slab<P::F>,
}

impl<S: Surface, P: Packet> Routine<P> for Value<'_, '_, S, P> {
    type Output = Enclosed<P, 1>;
    #[inline(always)]
    fn call(self, p: P) -> Enclosed<P, 1> {
        S::value(p, self.of.prepared, &self.of.bound, *self.over)
    }
}

struct Slope<'a, 'b, S: Surface, P: Packet> {
    of: &'a OverGroup<'b, S, P>,
    over: &'a Towards<P::F>,
}

impl<S: Surface, P: Packet> Routine<P> for Slope<'_, '_, S, P> {
    type Output = Enclosed<P, 2>;
    #[inline(always)]
    fn call(self, p: P) -> Enclosed<P, 2> {
        S::slope(p, self.of.prepared, &self.of.bound, *self.over)
    }
}

/// What is known about the beams of a grid.
pub(crate) struct SurveyGrid<'a, S: Surface> {
    pub prepared: &'a S::Prepared,
    pub beams: WithBeams<'a>,
    pub request: &'a Request<'a>,
    pub findings: &'a mut Findings,
    pub surface: PhantomData<S>,
}

impl<S: Surface> Kernel for SurveyGrid<'_, S> {
    type Output = ();
    const IN_PARTS: bool = true;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        match OverGroup::<S, P>::new(p, self.prepared, self.beams.leaves) {
            Some(mut over) => Scout::survey(p, &mut over, self.request, self.findings),
            None => self.findings.know(&Hint::OPEN, self.request.rows),
        }
    }
}

/// An operand of a solid over the beams of a picture.
pub(crate) struct OnPicture {
    leaves: Leaves,
    everything: Active,
    /// An [`Opener`] for the render's instruction set.
    opener: Box<dyn Any + Send + Sync>,
}

/// From a surface after its surface stage, and its leaves, to an object over eight beams. A solid does not know its
/// operands' types, and they do not know the instruction set: a pointer to a function has no lifetime, so it can be found
/// by its type.
struct Opener<P: Packet>(for<'a> fn(P, Erased<'a>, Erased<'a>) -> Option<Operand<'a, P>>);

type Erased<'a> = &'a (dyn Any + Send + Sync);
/// An operand over eight beams.
pub(crate) type Operand<'a, P> = Box<dyn Bundle<P> + 'a>;

impl OnPicture {
    /// All rows of the operand's tables.
    pub fn everything(&self) -> &Active {
        &self.everything
    }

    /// Ready for beams; nothing if this was made for another surface or another instruction set.
    pub fn open<'a, P: Packet>(&'a self, p: P, prepared: Erased<'a>) -> Option<Operand<'a, P>> {
        let opener: &Opener<P> = self.opener.downcast_ref()?;
        (opener.0)(p, prepared, &*self.leaves)
    }
}

/// Computes the leaves of an operand; nothing for one without leaves.
pub(crate) struct AssembleOperand<'a, S: Surface> {
    pub prepared: &'a S::Prepared,
    pub frame: &'a Frame,
}

impl<S: Surface + 'static> Kernel for AssembleOperand<'_, S> {
    type Output = Option<OnPicture>;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Option<OnPicture> {
        let AssembleOperand { prepared, frame } = self;
        Some(OnPicture {
            leaves: AssembleLeaves::<S> { prepared, frame }.run(p)?,
            everything: S::everything(prepared),
            opener: Box::new(Opener::<P>(open::<S, P>)),
        })
    }
}

fn open<'a, S: Surface + 'static, P: Packet>(
    p: P,
    prepared: Erased<'a>,
    leaves: Erased<'a>,
) -> Option<Operand<'a, P>> {
    let over = OverGroup::<S, P>::new(p, prepared.downcast_ref()?, leaves)?;
    Some(Box::new(over))
}

/// Which parts of boxes may hold roots; the leaves are those of [`Frame::axes_from`] the lower corner.
pub(crate) struct DivideBoxes<'a, S: Surface> {
    pub prepared: &'a S::Prepared,
    pub leaves: &'a (dyn Any + Send + Sync),
    pub boxes: &'a Boxes<'a>,
    pub surface: PhantomData<S>,
}

impl<S: Surface> Kernel for DivideBoxes<'_, S> {
    type Output = Option<Division>;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Option<Division> {
        let mut over = OverGroup::<S, P>::new(p, self.prepared, self.leaves)?;
        Divider::divide(p, &mut over, self.boxes)
    }
}
