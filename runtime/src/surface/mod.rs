//! The trait that `implicit!` implements.

mod active;
mod regions;
mod work;

pub use active::{Active, Choice, Rest, Row};
pub use regions::{Place, Regions};
pub use work::Work;

use crate::interval::{Arithmetic, Flags, Jet, Leaves, Packet, Parameter, Rebind, Truth};
use crate::ray::Rays;

/// An implicit surface f = 0, compiled from a formula by [`implicit!`](crate::implicit).
///
/// Four binding times: what is literal was folded by the compiler; [`prepare`](Self::prepare) computes what depends on
/// the fields only, once per render; [`bind`](Self::bind) what depends on the ray, once per packet; the rest is
/// [`value`](Self::value), [`slope`](Self::slope) and [`curvature`](Self::curvature) over a segment.
pub trait Surface: Send + Sync {
    /// What the compiler knows about the formula.
    const REPORT: Report;

    /// Values of the surface stage.
    type Prepared: Send + Sync;
    /// Values of the ray stage: leaves along rays, or over beams.
    type Bound<L: Leaves>: Send + Sync + 'static;

    /// Refuses parameters that are NaN or infinite, by the field's name.
    fn check(&self) -> Result<(), ParameterError>;
    /// The box of `#[domain]`, lower and upper corner, rounded outward.
    fn domain(&self) -> Option<[[f64; 3]; 2]>;
    /// f at a point, in plain `f64` without any guarantee.
    fn at(&self, point: [f64; 3]) -> f64;

    /// The surface stage.
    fn prepare(&self) -> Self::Prepared;
    /// All rows and both sides of all choices.
    fn everything(prepared: &Self::Prepared) -> Active;
    /// Room for the ray stage, to be used again for packet after packet.
    fn unbound<L: Leaves>(p: L::Packet) -> Self::Bound<L>;
    /// The ray stage, for the active rows.
    #[inline(always)]
    fn bind<P: Packet>(
        p: P,
        prepared: &Self::Prepared,
        rays: &Rays<P>,
        active: &Active,
        bound: &mut Self::Bound<P>,
    ) {
        Self::bind_leaves(p, prepared, rays, active, bound);
        Self::bind_series(p, prepared, rays, bound);
    }
    /// What points of rays need of it.
    fn bind_leaves<P: Packet>(
        p: P,
        prepared: &Self::Prepared,
        rays: &Rays<P>,
        active: &Active,
        bound: &mut Self::Bound<P>,
    );
    /// What segments need of it, besides: polynomials of higher degree.
    #[inline(always)]
    fn bind_series<P: Packet>(
        _p: P,
        _prepared: &Self::Prepared,
        _rays: &Rays<P>,
        _bound: &mut Self::Bound<P>,
    ) {
    }
    /// Makes other leaves of the leaves `from`, which has all rows, for the rows of `active`. False, without
    /// any work, from a surface that has no leaves: it cannot be traced in beams.
    fn rebind<R: Rebind>(
        _map: &R,
        _from: &Self::Bound<R::From>,
        _active: &Active,
        _to: &mut Self::Bound<R::To>,
    ) -> bool {
        false
    }

    /// The terms of the active rows over a segment, for the folds whose rows may be left out.
    fn terms<A: Arithmetic, T: Parameter<A>>(
        _a: A,
        _prepared: &Self::Prepared,
        _bound: &Self::Bound<T::Leaves>,
        _t: T,
        _to: &mut impl Terms<A>,
    ) {
    }

    /// f over a segment.
    fn value<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &Self::Prepared,
        bound: &Self::Bound<T::Leaves>,
        t: T,
    ) -> Jet<A::Value, A::Packet, 1>;
    /// f and df/dt over a segment.
    fn slope<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &Self::Prepared,
        bound: &Self::Bound<T::Leaves>,
        t: T,
    ) -> Jet<A::Value, A::Packet, 2>;
    /// f, df/dt and d²f/dt² over a segment.
    fn curvature<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &Self::Prepared,
        bound: &Self::Bound<T::Leaves>,
        t: T,
    ) -> Jet<A::Value, A::Packet, 3>;

    /// f and its gradient at the points of a box: `[f, f_x, f_y, f_z]`.
    fn gradient<A: Arithmetic>(
        a: A,
        prepared: &Self::Prepared,
        point: [A::Value; 3],
    ) -> Jet<A::Value, A::Packet, 4>;
    /// As [`gradient`](Self::gradient), from the active rows. f holds what the others add; its gradient does not, and is no
    /// enclosure where any are left out.
    #[inline(always)]
    fn seen<A: Arithmetic>(
        a: A,
        prepared: &Self::Prepared,
        _active: &Active,
        point: [A::Value; 3],
    ) -> Jet<A::Value, A::Packet, 4> {
        Self::gradient(a, prepared, point)
    }
    /// f, its gradient and its Hessian: `[f, f_x, f_y, f_z, f_xx, f_xy, f_xz, f_yy, f_yz, f_zz]`.
    fn hessian<A: Arithmetic>(
        a: A,
        prepared: &Self::Prepared,
        point: [A::Value; 3],
    ) -> Jet<A::Value, A::Packet, 10>;
    /// The regions of its code along rays.
    const REGIONS: Regions = Regions::NONE;
    /// What evaluations cost.
    const WORK: Work = Work::UNKNOWN;
    /// Does [`seen`](Self::seen) leave out just what segments do, also where it is left out by its sign?
    const SIGNS_IN_SPACE: bool = false;
    /// The leaf that is all of the formula with the active rows, if it is of degree ≤ 2: its roots are then found in closed form.
    fn quadric<L: Leaves>(_bound: &Self::Bound<L>) -> Option<&L::Quadratic> {
        None
    }
}

/// What the compiler knows about a formula.
#[derive(Clone, Copy, Debug)]
pub struct Report {
    /// The surface's name.
    pub name: &'static str,
    /// The degree in x, y, z, if f is a polynomial.
    pub degree: Option<u32>,
    /// How smooth f is, wherever it is defined.
    pub continuity: Continuity,
    /// Is f defined everywhere, for all values of the fields?
    pub total: bool,
    /// Names of the functions that f and its derivatives call, in alphabetic order.
    pub functions: &'static [&'static str],
    /// Operations of the surface stage, done once per render.
    pub surface_operations: u32,
    /// Linear and quadratic leaves of the ray stage, in loops counted once.
    pub leaves: u32,
    /// Polynomials of higher degree in t whose coefficients the ray stage computes.
    pub polynomials: u32,
    /// Operations on polynomials in t that make these leaves, done once per ray.
    pub ray_operations: u32,
    /// Interval operations over a segment of a ray: value, slope, curvature.
    pub segment: [Operations; 3],
    /// Interval operations in space: the value alone, with its gradient, and with gradient and Hessian.
    pub space: [Operations; 3],
}

/// How many interval operations an entry point does, bodies of loops counted once.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Operations {
    /// If each use of a subexpression computed it again. Stops at [`u32::MAX`].
    pub naive: u32,
    /// If what is equal is computed once.
    pub shared: u32,
    /// As compiled: without what the surface stage and the ray stage have done before. The leaves count.
    pub staged: u32,
}

impl Operations {
    /// Nothing is done, or nothing is known about it.
    pub const NONE: Operations = Operations {
        naive: 0,
        shared: 0,
        staged: 0,
    };
}

/// How smooth a function is, wherever it is defined.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Continuity {
    /// It may jump.
    Jumps,
    /// Continuous, with kinks.
    Continuous,
    /// All derivatives exist.
    Smooth,
}

/// Receives the terms of sums, and what minima and maxima choose from, row by row; and what choices compare.
pub trait Terms<A: Arithmetic> {
    /// A term of the sum with this index in [`Active::rest`].
    fn term(&mut self, row: Row, sum: usize, term: A::Value, flags: Flags<A::Packet>);
    /// A number of a row, where the least of all rows' is taken: which of such minima, the number, and whether the sign of
    /// the least is all that matters.
    fn candidate(
        &mut self,
        row: Row,
        minimum: usize,
        number: A::Value,
        flags: Flags<A::Packet>,
        by_sign: bool,
    );
    /// Whether the first number of a choice is less than the second, and the second less than the first.
    fn choice(&mut self, choice: usize, less: [Truth<A::Packet>; 2], flags: Flags<A::Packet>);
    /// Where the sign is all that matters: whether the first number has that of the choice, and whether the second has.
    fn by_sign(&mut self, choice: usize, alone: [Truth<A::Packet>; 2], flags: Flags<A::Packet>);
}

impl Report {
    /// The functions that f calls whose enclosures are tested, not proved.
    pub fn unproved(&self) -> impl Iterator<Item = &'static str> {
        let known = |f: &&'static str| crate::interval::UNPROVED.contains(f);
        self.functions.iter().copied().filter(known)
    }
}

/// A parameter that no surface can have.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ParameterError {
    /// A number is NaN or infinite.
    #[error("field `{field}` of `{surface}` is {value}: parameters must be finite numbers")]
    NotFinite {
        /// The surface's name.
        surface: &'static str,
        /// The field's name.
        field: &'static str,
        /// The offending value.
        value: f64,
    },
    /// An operand of a solid is placed by a map that is none: it has no inverse, as far as can be told.
    #[error(
        "the placement of `{surface}` is not finite or flattens it: give an affine map with finite entries and a determinant that is not 0"
    )]
    Placement {
        /// The surface's name.
        surface: &'static str,
    },
    /// A table of run-time length is too short: an index of the formula is outside, or a minimum has no row to take.
    #[error(
        "table `{field}` of `{surface}` has {rows} rows, and the formula needs at least {needed}"
    )]
    TooFewRows {
        /// The surface's name.
        surface: &'static str,
        /// The table's name.
        field: &'static str,
        /// How many rows there are.
        rows: usize,
        /// How many the formula needs.
        needed: usize,
    },
}
