//! What generated code names. Nothing here is for users.

pub use crate::interval::{
    Arithmetic, Ball, Fine, Interval, Jet, Leaves, Linear, Number, Packet, Parameter, Polynomial,
    Quadratic, Rebind, Undecided, series,
};
pub use crate::language;
pub use crate::ray::Rays;
pub use crate::solid::{Operand, Solid};
pub use crate::surface::Row as ActiveRow;
pub use crate::surface::{
    Active, Continuity, Operations, ParameterError, Place, Regions, Report, Surface, Terms, Work,
};
pub use std::default::Default;
pub use std::ops::{BitAnd, BitOr, Not, Sub};
pub use std::option::Option;
pub use std::result::Result::{self, Err, Ok};
pub use std::vec;
pub use std::vec::Vec;
pub use zeroset_macros::implicit;

use crate::interval::{Flags, Lanes, Scalar};

/// A reference that the optimiser takes for another one.
#[inline(always)]
#[must_use]
pub fn apart<T>(place: &T) -> &T {
    std::hint::black_box(place)
}

/// Primitive types by paths that nobody can shadow.
pub mod primitive {
    pub use std::f64::consts;
    pub use std::primitive::{bool, f64, i64, u32, usize};
}

/// π.
pub const PI: Number = Number {
    enclosure: Interval {
        lo: std::f64::consts::PI,
        hi: std::f64::consts::PI.next_up(),
    },
    leading: [std::f64::consts::PI, 1.224_646_799_147_353_2e-16],
};

/// The number system of the surface stage.
#[must_use]
pub fn scalar() -> Scalar {
    Scalar
}

/// An exact number. Finite, by [`Surface::check`].
#[must_use]
pub fn point(x: f64) -> Interval {
    Interval { lo: x, hi: x }
}

/// May a value of the surface stage be undefined?
#[must_use]
pub fn may_be_undefined(flags: &Flags<Scalar>) -> bool {
    let p = scalar();
    p.any(p.or(flags.undefined, flags.empty))
}

/// Refuses NaN and infinities.
pub fn finite(
    surface: &'static str,
    field: &'static str,
    value: f64,
) -> Result<(), ParameterError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(ParameterError::NotFinite {
            surface,
            field,
            value,
        })
    }
}

/// Refuses tables that are shorter than the formula's indices.
pub fn enough_rows(
    surface: &'static str,
    field: &'static str,
    rows: usize,
    needed: usize,
) -> Result<(), ParameterError> {
    if rows >= needed {
        Ok(())
    } else {
        Err(ParameterError::TooFewRows {
            surface,
            field,
            rows,
            needed,
        })
    }
}

/// Leaves of degree 1.
pub type Linears<L, const M: usize> = [<L as Leaves>::Linear; M];

/// Leaves of degree 2.
pub type Quadratics<L, const N: usize> = [<L as Leaves>::Quadratic; N];

/// Maps the leaves of one scope.
#[inline(always)]
pub fn rebind_leaves<R: Rebind, const M: usize, const N: usize>(
    map: &R,
    (linear, quadratic): (&Linears<R::From, M>, &Quadratics<R::From, N>),
    to: (&mut Linears<R::To, M>, &mut Quadratics<R::To, N>),
) {
    for (to, leaf) in to.0.iter_mut().zip(linear) {
        *to = map.linear(leaf);
    }
    for (to, leaf) in to.1.iter_mut().zip(quadratic) {
        *to = map.quadratic(leaf);
    }
}

/// The leaves of a row.
pub type Row<L, const M: usize, const N: usize> = (Linears<L, M>, Quadratics<L, N>);

/// Maps the leaves of one row.
#[inline(always)]
pub fn rebind_row<R: Rebind, const M: usize, const N: usize>(
    map: &R,
    from: &Row<R::From, M, N>,
) -> Row<R::To, M, N> {
    let p = map.lanes();
    let mut to = (
        [<R::To as Leaves>::linear(p); M],
        [<R::To as Leaves>::quadratic(p); N],
    );
    rebind_leaves(map, (&from.0, &from.1), (&mut to.0, &mut to.1));
    to
}
