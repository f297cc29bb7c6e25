//! Leaves over beams: polynomials of degree ≤ 2 in t, x and y.

use core::marker::PhantomData;

use crate::interval::{Interval, Leaves, Linear, Packet, Quadratic};

/// Leaves over the beams of one packet.
#[derive(Clone, Copy)]
pub struct OverBeams<P>(PhantomData<P>);

/// c + c_t t + c_x x + c_y y.
#[derive(Clone, Copy)]
pub struct LinearOver<P: Packet> {
    /// Along the middle ray, where x = y = 0.
    pub middle: Linear<P>,
    /// The derivatives by x and y.
    pub side: [Interval<P::F>; 2],
}

/// A quadratic polynomial in t, x and y.
#[derive(Clone, Copy)]
pub struct QuadraticOver<P: Packet> {
    /// Along the middle ray, where x = y = 0.
    pub middle: Quadratic<P>,
    /// The derivatives by x and y on the middle ray: they are linear in t.
    pub side: [Linear<P>; 2],
    /// The coefficients of x² and y².
    pub square: [Interval<P::F>; 2],
    /// The coefficient of xy.
    pub mixed: Interval<P::F>,
}

impl<P: Packet> Leaves for OverBeams<P> {
    type Packet = P;
    type Linear = LinearOver<P>;
    type Quadratic = QuadraticOver<P>;
    // Beams evaluate formulas as they are written.
    type Polynomial<const N: usize> = ();
    #[inline(always)]
    fn linear(p: P) -> LinearOver<P> {
        let middle = Linear::zero(p);
        LinearOver {
            middle,
            side: [middle.c0; 2],
        }
    }
    #[inline(always)]
    fn polynomial<const N: usize>(_p: P) {}
    #[inline(always)]
    fn quadratic(p: P) -> QuadraticOver<P> {
        let side = Linear::zero(p);
        QuadraticOver {
            middle: Quadratic::zero(p),
            side: [side; 2],
            square: [side.c0; 2],
            mixed: side.c0,
        }
    }
}
