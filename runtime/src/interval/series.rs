//! Coefficients of polynomials in t, as the ray stage computes them: arrays of intervals, from the constant upwards.
//!
//! Products are functions of their own: once per packet a call costs little, and generated code stays short.

use super::{Arithmetic, Interval, Lanes, Packet, Routine};

/// The coefficients of a polynomial of degree N − 1.
pub type Series<P, const N: usize> = [Interval<<P as Lanes>::F>; N];

/// 0
#[inline(always)]
pub fn zero<P: Packet, const N: usize>(p: P) -> Series<P, N> {
    [p.point(p.splat(0.0)); N]
}

/// −a
#[inline(always)]
pub fn negative<P: Packet, const N: usize>(p: P, a: &Series<P, N>) -> Series<P, N> {
    let mut all = *a;
    let mut k = 0;
    while k < N {
        all[k] = Arithmetic::neg(p, a[k]);
        k += 1;
    }
    all
}

/// a + b
#[inline(always)]
pub fn sum<P: Packet, const A: usize, const B: usize, const N: usize>(
    p: P,
    a: &Series<P, A>,
    b: &Series<P, B>,
) -> Series<P, N> {
    let mut all = zero(p);
    let mut k = 0;
    while k < N {
        all[k] = match (k < A, k < B) {
            (true, true) => Arithmetic::add(p, a[k], b[k]),
            (true, false) => a[k],
            (false, _) => b[k],
        };
        k += 1;
    }
    all
}

/// a − b
#[inline(always)]
pub fn difference<P: Packet, const A: usize, const B: usize, const N: usize>(
    p: P,
    a: &Series<P, A>,
    b: &Series<P, B>,
) -> Series<P, N> {
    sum(p, a, &negative(p, b))
}

/// a·b
#[inline(always)]
pub fn product<P: Packet, const A: usize, const B: usize, const N: usize>(
    p: P,
    a: &Series<P, A>,
    b: &Series<P, B>,
) -> Series<P, N> {
    p.call(Product::<P, A, B, N> { a, b })
}

/// a²
#[inline(always)]
pub fn square<P: Packet, const A: usize, const N: usize>(p: P, a: &Series<P, A>) -> Series<P, N> {
    p.call(Square::<P, A, N> { a })
}

struct Product<'a, P: Packet, const A: usize, const B: usize, const N: usize> {
    a: &'a Series<P, A>,
    b: &'a Series<P, B>,
}

impl<P: Packet, const A: usize, const B: usize, const N: usize> Routine<P>
    for Product<'_, P, A, B, N>
{
    type Output = Series<P, N>;

    #[inline(always)]
    fn call(self, p: P) -> Series<P, N> {
        let mut all = zero::<P, N>(p);
        let mut i = 0;
        while i < A {
            let mut j = 0;
            while j < B {
                let term = Arithmetic::mul(p, self.a[i], self.b[j]);
                // The first of its terms is the sum so far: 0 + term would be rounded.
                let first = i == 0 || j + 1 == B;
                all[i + j] = if first {
                    term
                } else {
                    Arithmetic::add(p, all[i + j], term)
                };
                j += 1;
            }
            i += 1;
        }
        all
    }
}

struct Square<'a, P: Packet, const A: usize, const N: usize> {
    a: &'a Series<P, A>,
}

impl<P: Packet, const A: usize, const N: usize> Routine<P> for Square<'_, P, A, N> {
    type Output = Series<P, N>;

    #[inline(always)]
    fn call(self, p: P) -> Series<P, N> {
        let a = self.a;
        let mut all = zero::<P, N>(p);
        let mut k = 0;
        while k < N {
            // Twice the products of different coefficients, and a square.
            let mut i = (k + 1).saturating_sub(A);
            let first = i;
            while 2 * i < k {
                let term = Arithmetic::mul(p, a[i], a[k - i]);
                all[k] = if i == first {
                    term
                } else {
                    Arithmetic::add(p, all[k], term)
                };
                i += 1;
            }
            let twice = Arithmetic::add(p, all[k], all[k]);
            if 2 * i == k {
                let term = Arithmetic::sqr(p, a[i]);
                all[k] = if i == first {
                    term
                } else {
                    Arithmetic::add(p, twice, term)
                };
            } else {
                all[k] = twice;
            }
            k += 1;
        }
        all
    }
}
