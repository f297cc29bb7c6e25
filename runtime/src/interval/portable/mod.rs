//! Eight doubles in an array, without any instruction set: plain operations that a compiler vectorises as it can.

mod error_free;

use std::marker::PhantomData;

use super::lanes::{RADIUS, RADIUS_STEP, decompose};
use super::sealed::Sealed;
use super::{Directed, Kernel, Lanes, Rounding, Routine};

/// The token of the portable back-end.
///
/// Results to nearest are widened after Rump, Zimmermann, Boldo and Melquiond, *Computing predecessor and successor in
/// rounding to nearest* (BIT 49, 2009): with e = |x|·φ + η, φ = 2⁻⁵³(1 + 2⁻⁵²), η = 2⁻¹⁰⁷⁴, all to nearest,
/// x − e ≤ pred(x) and x + e ≥ succ(x) for every finite x. An operation's exact result lies between the two.
#[derive(Clone, Copy, Debug)]
pub struct Portable<R = Directed>(PhantomData<R>);

impl<R: Rounding> Portable<R> {
    /// The token; every processor has this back-end.
    pub fn new() -> Self {
        Portable(PhantomData)
    }
}

impl<R: Rounding> Default for Portable<R> {
    fn default() -> Self {
        Self::new()
    }
}

/// φ = 2⁻⁵³(1 + 2⁻⁵²)
const PHI: f64 = f64::from_bits(((1023 - 53) << 52) | 1);
/// η, the smallest positive double
const ETA: f64 = f64::from_bits(1);

type F = [f64; 8];
type M = [u64; 8];

/// x or a number below it, such that the exact result that rounded to x is not below. Where x is 0 and `exact`, it stays.
#[inline(always)]
fn down_one<R: Rounding>(x: f64, exact: bool) -> f64 {
    if !R::ON {
        return x;
    }
    // An overflow of finite operands rounds to +∞, and ∞ − ∞ would be NaN. A NaN stays one.
    let x = if R::GUARDED && x > f64::MAX {
        f64::MAX
    } else {
        x
    };
    x - error::<R>(x, exact)
}

/// As [`down_one`], above.
#[inline(always)]
fn up_one<R: Rounding>(x: f64, exact: bool) -> f64 {
    if !R::ON {
        return x;
    }
    let x = if R::GUARDED && x < f64::MIN {
        f64::MIN
    } else {
        x
    };
    x + error::<R>(x, exact)
}

/// As [`down_one`], of a sum or a root: neither rounds to 0 but where it is 0.
#[inline(always)]
fn down_sum<R: Rounding>(x: f64) -> f64 {
    down_one::<R>(x, x == 0.0)
}

/// As [`down_sum`], above.
#[inline(always)]
fn up_sum<R: Rounding>(x: f64) -> f64 {
    up_one::<R>(x, x == 0.0)
}

/// Is a·b exact because a factor is 0?
#[inline(always)]
fn zeros(a: f64, b: f64) -> bool {
    (a == 0.0) | (b == 0.0)
}

/// An upper bound of what a product and a sum rounded to x: see [`RADIUS`].
#[inline(always)]
fn up_radius<R: Rounding>(x: f64) -> f64 {
    if !R::ON {
        return x;
    }
    x + x.max(RADIUS) * (RADIUS_STEP * R::SCALE)
}

/// |x|·φ + η, less η where x is `exact`. Directions and constants make many products 0, and η takes some processors a
/// hundred cycles for each operation on it.
#[inline(always)]
fn error<R: Rounding>(x: f64, exact: bool) -> f64 {
    let least = if R::GUARDED && !exact { ETA } else { 0.0 };
    x.abs() * (PHI * R::SCALE) + least
}

/// 2⁻⁵³(1 + 2⁻⁵⁰): φ with room for the roundings of a sum of three.
const PHI_3: f64 = f64::from_bits(((1023 - 53) << 52) | 4);

/// A lower bound of a·b + c from p = a·b and s = p + c, both to nearest: they err by u|p| (or η/2) and u|s|, u = 2⁻⁵³, and
/// the last difference by another u|s|.
#[inline(always)]
fn product_sum_down<R: Rounding>(a: f64, b: f64, c: f64) -> f64 {
    let p = a * b;
    let s = p + c;
    if !R::ON {
        return s;
    }
    let s = if R::GUARDED && s > f64::MAX {
        f64::MAX
    } else {
        s
    };
    let least = if R::GUARDED && !zeros(a, b) {
        2.0 * ETA
    } else {
        0.0
    };
    s - ((p.abs() + s.abs() + s.abs()) * (PHI_3 * R::SCALE) + least)
}

/// Lane by lane: `map!(i => expression of i)`.
macro_rules! map {
    ($i:ident => $lane:expr) => {{
        let mut out = [0.0; 8];
        let mut $i = 0;
        while $i < 8 {
            out[$i] = $lane;
            $i += 1;
        }
        out
    }};
}

/// Masks are words of ones or zeros, which selects turn into bit operations.
macro_rules! test {
    ($i:ident => $lane:expr) => {{
        let mut out = [0u64; 8];
        let mut $i = 0;
        while $i < 8 {
            out[$i] = if $lane { u64::MAX } else { 0 };
            $i += 1;
        }
        out
    }};
}

mod enclose;

impl<R: Rounding> Sealed for Portable<R> {}

impl<R: Rounding> Lanes for Portable<R> {
    type F = F;
    type M = M;
    type Rounding = R;
    type Eight = Self;
    const LANES: usize = 8;
    const FUSED: bool = false;
    const NAME: &'static str = R::MODE.name([
        "portable",
        "portable-unrounded",
        "portable-too-tight",
        "portable-unguarded",
    ]);
    const OPTIMAL: bool = false;

    #[inline(always)]
    fn kernel<K: Kernel>(self, kernel: K) -> K::Output {
        run_kernel(self, kernel)
    }
    #[inline(always)]
    fn call<T: Routine<Self>>(self, routine: T) -> T::Output {
        call_routine(self, routine)
    }
    /// Never inlined: eight-lane loops inlined hundreds of times take minutes to compile and run no faster.
    #[inline(always)]
    fn operation<T: Routine<Self>>(self, routine: T) -> T::Output {
        call_routine(self, routine)
    }

    #[inline(always)]
    fn eight(self) -> Self {
        self
    }
    #[inline(always)]
    fn splat(self, x: f64) -> F {
        [x; 8]
    }
    #[inline(always)]
    fn lanes(self, x: [f64; 8]) -> F {
        x
    }
    #[inline(always)]
    fn to_array(self, x: F) -> [f64; 8] {
        x
    }

    #[inline(always)]
    fn select(self, mask: M, yes: F, no: F) -> F {
        map!(i => f64::from_bits((mask[i] & yes[i].to_bits()) | (!mask[i] & no[i].to_bits())))
    }
    #[inline(always)]
    fn bits(self, mask: M) -> u8 {
        let mut bits = 0;
        let mut i = 0;
        while i < 8 {
            bits |= ((mask[i] & 1) as u8) << i;
            i += 1;
        }
        bits
    }
    #[inline(always)]
    fn mask(self, bits: u8) -> M {
        test!(i => (bits >> i) & 1 == 1)
    }
    #[inline(always)]
    fn and(self, a: M, b: M) -> M {
        let mut out = a;
        let mut i = 0;
        while i < 8 {
            out[i] &= b[i];
            i += 1;
        }
        out
    }
    #[inline(always)]
    fn or(self, a: M, b: M) -> M {
        let mut out = a;
        let mut i = 0;
        while i < 8 {
            out[i] |= b[i];
            i += 1;
        }
        out
    }
    #[inline(always)]
    fn and_not(self, a: M, b: M) -> M {
        let mut out = a;
        let mut i = 0;
        while i < 8 {
            out[i] &= !b[i];
            i += 1;
        }
        out
    }

    #[inline(always)]
    fn lt(self, a: F, b: F) -> M {
        test!(i => a[i] < b[i])
    }
    #[inline(always)]
    fn le(self, a: F, b: F) -> M {
        test!(i => a[i] <= b[i])
    }
    #[inline(always)]
    fn eq(self, a: F, b: F) -> M {
        test!(i => a[i] == b[i])
    }

    #[inline(always)]
    fn neg_f(self, a: F) -> F {
        map!(i => -a[i])
    }
    #[inline(always)]
    fn abs_f(self, a: F) -> F {
        map!(i => a[i].abs())
    }
    #[inline(always)]
    fn min_f(self, a: F, b: F) -> F {
        map!(i => if a[i] < b[i] { a[i] } else { b[i] })
    }
    #[inline(always)]
    fn max_f(self, a: F, b: F) -> F {
        map!(i => if a[i] > b[i] { a[i] } else { b[i] })
    }

    #[inline(always)]
    fn add_rn(self, a: F, b: F) -> F {
        map!(i => a[i] + b[i])
    }
    #[inline(always)]
    fn sub_rn(self, a: F, b: F) -> F {
        map!(i => a[i] - b[i])
    }
    #[inline(always)]
    fn mul_rn(self, a: F, b: F) -> F {
        map!(i => a[i] * b[i])
    }
    #[inline(always)]
    fn div_rn(self, a: F, b: F) -> F {
        map!(i => a[i] / b[i])
    }
    #[inline(always)]
    fn sqrt_rn(self, a: F) -> F {
        map!(i => a[i].sqrt())
    }
    #[inline(always)]
    fn fma_rn(self, a: F, b: F, c: F) -> F {
        map!(i => a[i] * b[i] + c[i])
    }
    #[inline(always)]
    fn fms_rn(self, a: F, b: F, c: F) -> F {
        map!(i => a[i] * b[i] - c[i])
    }
    #[inline(always)]
    fn round_f(self, a: F) -> F {
        // Adding 1.5·2⁵² leaves no bits below 1; larger numbers are whole already.
        const SHIFT: f64 = 6_755_399_441_055_744.0;
        map!(i => if a[i].abs() < 4_503_599_627_370_496.0 / 2.0 { (a[i] + SHIFT) - SHIFT } else { a[i].round_ties_even() })
    }
    #[inline(always)]
    fn floor_f(self, a: F) -> F {
        let r = self.round_f(a);
        map!(i => if r[i] > a[i] { r[i] - 1.0 } else { r[i] })
    }
    #[inline(always)]
    fn bit<const B: u32>(self, shifted: F) -> M {
        test!(i => (shifted[i].to_bits() >> B) & 1 == 1)
    }
    #[inline(always)]
    fn pow2(self, n: F) -> F {
        // n + 1.5·2⁵² holds n in its low bits; shifted to the exponent, the rest falls off.
        map!(i => f64::from_bits((n[i] + (6_755_399_441_055_744.0 + 1023.0)).to_bits() << 52))
    }

    #[inline(always)]
    fn decompose(self, x: F) -> (F, F) {
        let (mut m, mut e) = ([0.0; 8], [0.0; 8]);
        let mut i = 0;
        while i < 8 {
            (m[i], e[i]) = decompose(x[i]);
            i += 1;
        }
        (m, e)
    }
    #[inline(always)]
    fn before(self, a: F) -> F {
        map!(i => f64::from_bits(a[i].to_bits().wrapping_sub(R::STEP)))
    }
    #[inline(always)]
    fn after(self, a: F) -> F {
        map!(i => f64::from_bits(a[i].to_bits().wrapping_add(R::STEP)))
    }

    #[inline(always)]
    fn add_rd(self, a: F, b: F) -> F {
        map!(i => down_sum::<R>(a[i] + b[i]))
    }
    #[inline(always)]
    fn add_ru(self, a: F, b: F) -> F {
        map!(i => up_sum::<R>(a[i] + b[i]))
    }
    #[inline(always)]
    fn mul_rd(self, a: F, b: F) -> F {
        map!(i => down_one::<R>(a[i] * b[i], zeros(a[i], b[i])))
    }
    #[inline(always)]
    fn mul_ru(self, a: F, b: F) -> F {
        map!(i => up_one::<R>(a[i] * b[i], zeros(a[i], b[i])))
    }
    #[inline(always)]
    fn div_rd(self, a: F, b: F) -> F {
        map!(i => down_one::<R>(a[i] / b[i], a[i] == 0.0))
    }
    #[inline(always)]
    fn div_ru(self, a: F, b: F) -> F {
        map!(i => up_one::<R>(a[i] / b[i], a[i] == 0.0))
    }
    #[inline(always)]
    fn sqrt_rd(self, a: F) -> F {
        map!(i => down_sum::<R>(a[i].sqrt()))
    }
    #[inline(always)]
    fn sqrt_ru(self, a: F) -> F {
        map!(i => up_sum::<R>(a[i].sqrt()))
    }
    #[inline(always)]
    fn fma_rd(self, a: F, b: F, c: F) -> F {
        fma_down::<R>(&a, &b, &c)
    }
    #[inline(always)]
    fn fma_ru(self, a: F, b: F, c: F) -> F {
        // The least upper bound of x is the negated greatest lower bound of −x.
        self.neg_f(fma_down::<R>(&self.neg_f(a), &b, &self.neg_f(c)))
    }
    #[inline(always)]
    fn radius(self, a: F, b: F, c: F) -> F {
        map!(i => up_radius::<R>((a[i] * b[i]).max(0.0) + c[i]))
    }
    #[inline(always)]
    fn mul_add_rd(self, a: F, b: F, c: F) -> F {
        map!(i => product_sum_down::<R>(a[i], b[i], c[i]))
    }
    #[inline(always)]
    fn mul_add_ru(self, a: F, b: F, c: F) -> F {
        map!(i => -product_sum_down::<R>(-a[i], b[i], -c[i]))
    }
}

#[inline(never)]
fn run_kernel<R: Rounding, K: Kernel>(p: Portable<R>, kernel: K) -> K::Output {
    kernel.run(p)
}

#[inline(never)]
fn call_routine<R: Rounding, T: Routine<Portable<R>>>(p: Portable<R>, routine: T) -> T::Output {
    routine.call(p)
}

/// Lower bounds of a·b + c: out of line, for it is long. The lanes where the error-free transformations do not hold are
/// rare, and mended one by one.
#[inline(never)]
fn fma_down<R: Rounding>(a: &F, b: &F, c: &F) -> F {
    let mut out = map!(i => error_free::tight::<R>(a[i], b[i], c[i]));
    let held = test!(i => error_free::holds(a[i], b[i], c[i]));
    let mut all = u64::MAX;
    let mut i = 0;
    while i < 8 {
        all &= held[i];
        i += 1;
    }
    if R::ON && R::GUARDED && all == 0 {
        let mut i = 0;
        while i < 8 {
            if held[i] == 0 {
                out[i] = error_free::guarded::<R>(a[i], b[i], c[i]);
            }
            i += 1;
        }
    }
    out
}
