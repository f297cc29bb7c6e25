//! One `f64` at a time, with optimal directed rounding: the surface stage and the tests.

use super::enclose::Enclose;
use super::lanes::decompose;
use super::sealed::Sealed;
use super::{Directed, Kernel, Lanes, Portable, Routine};

/// The token for single numbers. It uses [`f64::mul_add`], which is a library call where the processor (or the build)
/// has no FMA: right everywhere, and slow. What runs once per packet belongs to the other back-ends.
///
/// Directed results are the optimal ones, except that a product or quotient below 2⁻⁹⁶⁰ may be one unit further out.
#[derive(Clone, Copy, Debug, Default)]
pub struct Scalar;

/// Below this the error of a product need not be a double.
const TINY: f64 = f64::from_bits((1023 - 960) << 52);
/// Above this the error-free transformations might overflow.
const HUGE: f64 = f64::from_bits((1023 + 1020) << 52);

/// Turns `x`, the nearest double of an exact result, into a lower bound of it. `error` has the sign of exact − x.
fn down(x: f64, error: f64) -> f64 {
    if x == f64::INFINITY {
        f64::MAX // finite operands overflowed
    } else if error < 0.0 || error.is_nan() {
        x.next_down()
    } else {
        x
    }
}

/// As [`down`], above.
fn up(x: f64, error: f64) -> f64 {
    -down(-x, -error)
}

/// The rounding error of `s = a + b`, exactly (Dekker's fast two-sum, operands in order of magnitude; no step of it
/// overflows if `s` did not).
fn sum_error(a: f64, b: f64, s: f64) -> f64 {
    let (big, small) = if a.abs() >= b.abs() { (a, b) } else { (b, a) };
    small - (s - big)
}

/// A number with the sign of the rounding error of `p = a·b`, NaN where that is not known.
fn product_error(a: f64, b: f64, p: f64) -> f64 {
    if a == 0.0 || b == 0.0 {
        0.0
    } else if p.abs() < TINY {
        f64::NAN
    } else {
        a.mul_add(b, -p)
    }
}

/// A number with the sign of a/b − q.
fn quotient_error(a: f64, b: f64, q: f64) -> f64 {
    if a == 0.0 || b.is_infinite() {
        0.0
    } else if a.abs() < TINY || q.abs() < TINY {
        f64::NAN
    } else {
        // The residual of a correctly rounded quotient is a double.
        let residual = (-q).mul_add(b, a);
        if b < 0.0 { -residual } else { residual }
    }
}

/// √a and a number with the sign of its error.
fn root(a: f64) -> (f64, f64) {
    // Scaled by an even power of two, the residual is a double for every a.
    let (scaled, back) = if a < TINY {
        (
            a * f64::from_bits((1023 + 200) << 52),
            f64::from_bits((1023 - 100) << 52),
        )
    } else {
        (a, 1.0)
    };
    let s = scaled.sqrt();
    (
        s * back,
        if s.is_infinite() {
            0.0
        } else {
            (-s).mul_add(s, scaled)
        },
    )
}

/// A number with the sign of a·b + c − s, where `s` is the nearest double of a·b + c; NaN where that is not known.
fn fma_error(a: f64, b: f64, c: f64, s: f64) -> f64 {
    let p = a * b;
    let zero = a == 0.0 || b == 0.0;
    if !(zero || p.abs() >= TINY) || !(p.abs() < HUGE && c.abs() < HUGE) {
        return f64::NAN;
    }
    // a·b + c = p + e + c = t + f + e, all exact. Then the residual t − s is a double or its sum with f + e has the
    // sign of the larger part: compare s with the unevaluated sum, term by term.
    let e = a.mul_add(b, -p);
    let t = p + c;
    let f = sum_error(p, c, t);
    let h = e + f;
    let l = sum_error(e, f, h);
    let r = t + h;
    let w = sum_error(t, h, r);
    // exact = r + w + l. r is s or its neighbour, so r − s is exact.
    let d = r - s;
    let dw = d + w;
    dw + (sum_error(d, w, dw) + l)
}

impl Sealed for Scalar {}

impl Lanes for Scalar {
    type F = f64;
    type M = bool;
    type Rounding = Directed;
    type Eight = Portable;
    const LANES: usize = 1;
    const FUSED: bool = true;
    const NAME: &'static str = "scalar";
    const OPTIMAL: bool = true;

    #[inline(always)]
    fn kernel<K: Kernel>(self, kernel: K) -> K::Output {
        kernel.run(self)
    }
    #[inline(always)]
    fn call<R: Routine<Self>>(self, routine: R) -> R::Output {
        routine.call(self)
    }
    /// The surface stage runs once: what matters is how little there is to compile.
    #[inline(never)]
    fn operation<R: Routine<Self>>(self, routine: R) -> R::Output {
        routine.call(self)
    }

    fn eight(self) -> Portable {
        Portable::new()
    }
    fn splat(self, x: f64) -> f64 {
        x
    }
    fn lanes(self, x: [f64; 8]) -> f64 {
        x[0]
    }
    fn to_array(self, x: f64) -> [f64; 8] {
        [x; 8]
    }

    fn select(self, mask: bool, yes: f64, no: f64) -> f64 {
        if mask { yes } else { no }
    }
    fn bits(self, mask: bool) -> u8 {
        mask as u8
    }
    fn mask(self, bits: u8) -> bool {
        bits & 1 != 0
    }
    fn and(self, a: bool, b: bool) -> bool {
        a & b
    }
    fn or(self, a: bool, b: bool) -> bool {
        a | b
    }
    fn and_not(self, a: bool, b: bool) -> bool {
        a & !b
    }

    fn lt(self, a: f64, b: f64) -> bool {
        a < b
    }
    fn le(self, a: f64, b: f64) -> bool {
        a <= b
    }
    fn eq(self, a: f64, b: f64) -> bool {
        a == b
    }

    fn neg_f(self, a: f64) -> f64 {
        -a
    }
    fn abs_f(self, a: f64) -> f64 {
        a.abs()
    }
    fn min_f(self, a: f64, b: f64) -> f64 {
        if a < b { a } else { b }
    }
    fn max_f(self, a: f64, b: f64) -> f64 {
        if a > b { a } else { b }
    }

    fn add_rn(self, a: f64, b: f64) -> f64 {
        a + b
    }
    fn sub_rn(self, a: f64, b: f64) -> f64 {
        a - b
    }
    fn mul_rn(self, a: f64, b: f64) -> f64 {
        a * b
    }
    fn div_rn(self, a: f64, b: f64) -> f64 {
        a / b
    }
    fn sqrt_rn(self, a: f64) -> f64 {
        a.sqrt()
    }
    fn fma_rn(self, a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
    fn fms_rn(self, a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, -c)
    }
    fn round_f(self, a: f64) -> f64 {
        a.round_ties_even()
    }
    fn floor_f(self, a: f64) -> f64 {
        a.floor()
    }
    fn bit<const B: u32>(self, shifted: f64) -> bool {
        (shifted.to_bits() >> B) & 1 == 1
    }
    fn pow2(self, n: f64) -> f64 {
        f64::from_bits(((n as i64 + 1023) as u64) << 52)
    }

    fn decompose(self, x: f64) -> (f64, f64) {
        decompose(x)
    }
    fn before(self, a: f64) -> f64 {
        a.next_down()
    }
    fn after(self, a: f64) -> f64 {
        a.next_up()
    }

    fn add_rd(self, a: f64, b: f64) -> f64 {
        if a.is_infinite() || b.is_infinite() {
            return a + b;
        }
        let s = a + b;
        down(s, sum_error(a, b, s))
    }
    fn add_ru(self, a: f64, b: f64) -> f64 {
        -self.add_rd(-a, -b)
    }
    fn mul_rd(self, a: f64, b: f64) -> f64 {
        if a.is_infinite() || b.is_infinite() {
            return a * b;
        }
        let p = a * b;
        let bound = down(p, product_error(a, b, p));
        // Without this the bound of a positive product that underflows would be negative.
        if bound < 0.0 && (a < 0.0) == (b < 0.0) {
            0.0
        } else {
            bound
        }
    }
    fn mul_ru(self, a: f64, b: f64) -> f64 {
        -self.mul_rd(-a, b)
    }
    fn div_rd(self, a: f64, b: f64) -> f64 {
        if a.is_infinite() || b == 0.0 {
            return a / b;
        }
        let q = a / b;
        let bound = down(q, quotient_error(a, b, q));
        if bound < 0.0 && (a < 0.0) == (b < 0.0) {
            0.0
        } else {
            bound
        }
    }
    fn div_ru(self, a: f64, b: f64) -> f64 {
        -self.div_rd(-a, b)
    }
    fn sqrt_rd(self, a: f64) -> f64 {
        if a == f64::INFINITY {
            return a;
        }
        let (s, error) = root(a);
        down(s, error)
    }
    fn sqrt_ru(self, a: f64) -> f64 {
        let (s, error) = root(a);
        up(s, error)
    }
    fn fma_rd(self, a: f64, b: f64, c: f64) -> f64 {
        if a.is_infinite() || b.is_infinite() || c.is_infinite() {
            return a.mul_add(b, c);
        }
        let s = a.mul_add(b, c);
        down(s, fma_error(a, b, c, s))
    }
    fn fma_ru(self, a: f64, b: f64, c: f64) -> f64 {
        -self.fma_rd(-a, b, -c)
    }
}

impl Enclose for Scalar {}
