//! AVX-512: each instruction names its own rounding, so bounds are optimal at the price of plain arithmetic.

#[cfg(feature = "one-lane")]
mod one;

use std::arch::x86_64::*;
use std::marker::PhantomData;

use super::enclose::Enclose;
use super::lanes::TWO_THIRDS;
use super::sealed::Sealed;
use super::{Directed, Interval, Kernel, Lanes, Rounding, Routine};

/// The token of the AVX-512 back-end: the processor has AVX-512 F and DQ.
#[derive(Clone, Copy, Debug)]
pub struct Avx512<R = Directed>(PhantomData<R>);

impl<R: Rounding> Avx512<R> {
    /// The token, if this processor has what it stands for.
    pub(super) fn detect() -> Option<Self> {
        let has = is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq");
        has.then_some(Avx512(PhantomData))
    }
}

#[cfg(feature = "one-lane")]
pub use one::One;

/// Towards −∞, +∞, and to nearest; none raises exceptions.
const DOWN: i32 = _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC;
const UP: i32 = _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC;
const NEAREST: i32 = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;

/// Intrinsics, called from methods of the token.
macro_rules! cpu {
    ($call:expr) => {{
        // SAFETY: the token `self` exists only where `detect` found AVX-512 F and DQ, which are all that these
        // intrinsics need; none of them touches memory.
        unsafe { $call }
    }};
}

/// One instruction with the rounding that a name ends in, or to nearest where rounding is off.
macro_rules! rounded {
    ($intrinsic:ident::<$direction:ident>($($operand:expr),*)) => {
        if R::ON { cpu!($intrinsic::<$direction>($($operand),*)) } else { cpu!($intrinsic::<NEAREST>($($operand),*)) }
    };
}

#[inline(never)]
#[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
fn run_kernel<R: Rounding, K: Kernel>(p: Avx512<R>, kernel: K) -> K::Output {
    kernel.run(p)
}

#[inline(never)]
#[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
fn call_routine<R: Rounding, T: Routine<Avx512<R>>>(p: Avx512<R>, routine: T) -> T::Output {
    routine.call(p)
}

#[inline]
#[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
fn call_operation<R: Rounding, T: Routine<Avx512<R>>>(p: Avx512<R>, routine: T) -> T::Output {
    routine.call(p)
}

impl<R: Rounding> Sealed for Avx512<R> {}

impl<R: Rounding> Lanes for Avx512<R> {
    type F = __m512d;
    type M = __mmask8;
    type Rounding = R;
    type Eight = Self;
    const LANES: usize = 8;
    const FUSED: bool = true;
    const NAME: &'static str = R::MODE.name([
        "avx512",
        "avx512-unrounded",
        "avx512-too-tight",
        "avx512-unguarded",
    ]);
    const OPTIMAL: bool = true;
    const INLINES_LONG: bool = true;

    #[inline(always)]
    fn kernel<K: Kernel>(self, kernel: K) -> K::Output {
        // SAFETY: the token proves the features; AVX-512 F implies AVX2 and FMA.
        unsafe { run_kernel(self, kernel) }
    }
    #[inline(always)]
    fn call<T: Routine<Self>>(self, routine: T) -> T::Output {
        // SAFETY: as in `kernel`.
        unsafe { call_routine(self, routine) }
    }
    #[inline(always)]
    fn operation<T: Routine<Self>>(self, routine: T) -> T::Output {
        // SAFETY: as in `kernel`.
        unsafe { call_operation(self, routine) }
    }

    #[inline(always)]
    fn eight(self) -> Self {
        self
    }
    #[inline(always)]
    fn splat(self, x: f64) -> __m512d {
        cpu!(_mm512_set1_pd(x))
    }
    #[inline(always)]
    fn lanes(self, x: [f64; 8]) -> __m512d {
        // SAFETY: the token proves AVX-512 F; an unaligned load of eight doubles from an array of eight.
        unsafe { _mm512_loadu_pd(x.as_ptr()) }
    }
    #[inline(always)]
    fn to_array(self, x: __m512d) -> [f64; 8] {
        let mut out = [0.0; 8];
        // SAFETY: the token proves AVX-512 F; an unaligned store of eight doubles to an array of eight.
        unsafe { _mm512_storeu_pd(out.as_mut_ptr(), x) };
        out
    }

    #[inline(always)]
    fn select(self, mask: __mmask8, yes: __m512d, no: __m512d) -> __m512d {
        cpu!(_mm512_mask_blend_pd(mask, no, yes))
    }
    #[inline(always)]
    fn bits(self, mask: __mmask8) -> u8 {
        mask
    }
    #[inline(always)]
    fn mask(self, bits: u8) -> __mmask8 {
        bits
    }
    #[inline(always)]
    fn and(self, a: __mmask8, b: __mmask8) -> __mmask8 {
        a & b
    }
    #[inline(always)]
    fn or(self, a: __mmask8, b: __mmask8) -> __mmask8 {
        a | b
    }
    #[inline(always)]
    fn and_not(self, a: __mmask8, b: __mmask8) -> __mmask8 {
        a & !b
    }

    #[inline(always)]
    fn lt(self, a: __m512d, b: __m512d) -> __mmask8 {
        cpu!(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b))
    }
    #[inline(always)]
    fn le(self, a: __m512d, b: __m512d) -> __mmask8 {
        cpu!(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b))
    }
    #[inline(always)]
    fn eq(self, a: __m512d, b: __m512d) -> __mmask8 {
        cpu!(_mm512_cmp_pd_mask::<_CMP_EQ_OQ>(a, b))
    }

    #[inline(always)]
    fn neg_f(self, a: __m512d) -> __m512d {
        cpu!(_mm512_xor_pd(a, _mm512_set1_pd(-0.0)))
    }
    #[inline(always)]
    fn abs_f(self, a: __m512d) -> __m512d {
        cpu!(_mm512_abs_pd(a))
    }
    #[inline(always)]
    fn min_f(self, a: __m512d, b: __m512d) -> __m512d {
        cpu!(_mm512_min_pd(a, b))
    }
    #[inline(always)]
    fn max_f(self, a: __m512d, b: __m512d) -> __m512d {
        cpu!(_mm512_max_pd(a, b))
    }

    #[inline(always)]
    fn add_rn(self, a: __m512d, b: __m512d) -> __m512d {
        cpu!(_mm512_add_pd(a, b))
    }
    #[inline(always)]
    fn sub_rn(self, a: __m512d, b: __m512d) -> __m512d {
        cpu!(_mm512_sub_pd(a, b))
    }
    #[inline(always)]
    fn mul_rn(self, a: __m512d, b: __m512d) -> __m512d {
        cpu!(_mm512_mul_pd(a, b))
    }
    #[inline(always)]
    fn div_rn(self, a: __m512d, b: __m512d) -> __m512d {
        cpu!(_mm512_div_pd(a, b))
    }
    #[inline(always)]
    fn sqrt_rn(self, a: __m512d) -> __m512d {
        cpu!(_mm512_sqrt_pd(a))
    }
    #[inline(always)]
    fn fma_rn(self, a: __m512d, b: __m512d, c: __m512d) -> __m512d {
        cpu!(_mm512_fmadd_pd(a, b, c))
    }
    #[inline(always)]
    fn fms_rn(self, a: __m512d, b: __m512d, c: __m512d) -> __m512d {
        cpu!(_mm512_fmsub_pd(a, b, c))
    }
    #[inline(always)]
    fn round_f(self, a: __m512d) -> __m512d {
        cpu!(_mm512_roundscale_pd::<NEAREST>(a))
    }
    #[inline(always)]
    fn floor_f(self, a: __m512d) -> __m512d {
        cpu!(_mm512_roundscale_pd::<DOWN>(a))
    }
    #[inline(always)]
    fn bit<const B: u32>(self, shifted: __m512d) -> __mmask8 {
        cpu!(_mm512_test_epi64_mask(
            _mm512_castpd_si512(shifted),
            _mm512_set1_epi64(1 << B)
        ))
    }
    #[inline(always)]
    fn pow2(self, n: __m512d) -> __m512d {
        cpu!(_mm512_scalef_pd(_mm512_set1_pd(1.0), n))
    }
    #[inline(always)]
    fn mend(self, a: __m512d) -> __m512d {
        cpu!(_mm512_fixupimm_pd::<0>(
            a,
            a,
            _mm512_set1_epi64(NAN_TO_ZERO)
        ))
    }

    #[inline(always)]
    fn scale(self, v: __m512d, n: __m512d) -> __m512d {
        cpu!(_mm512_scalef_pd(v, n))
    }
    /// See the function of this name beside the trait.
    #[inline(always)]
    fn decompose(self, x: __m512d) -> (__m512d, __m512d) {
        cpu!({
            let bits = _mm512_castpd_si512(x);
            let one = _mm512_set1_epi64(1023 << 52);
            let offset = _mm512_set1_epi64(TWO_THIRDS as i64 - (1023 << 52));
            let biased = _mm512_srli_epi64::<52>(_mm512_sub_epi64(bits, offset));
            let scale = _mm512_sub_epi64(_mm512_slli_epi64::<52>(biased), one);
            let whole =
                _mm512_castsi512_pd(_mm512_or_si512(biased, _mm512_set1_epi64(0x4330 << 48)));
            let shift = _mm512_set1_pd(4_503_599_627_370_496.0 + 1023.0);
            (
                _mm512_castsi512_pd(_mm512_sub_epi64(bits, scale)),
                _mm512_sub_pd(whole, shift),
            )
        })
    }
    #[inline(always)]
    fn before(self, a: __m512d) -> __m512d {
        let step = R::STEP as i64;
        cpu!(_mm512_castsi512_pd(_mm512_sub_epi64(
            _mm512_castpd_si512(a),
            _mm512_set1_epi64(step)
        )))
    }
    #[inline(always)]
    fn after(self, a: __m512d) -> __m512d {
        let step = R::STEP as i64;
        cpu!(_mm512_castsi512_pd(_mm512_add_epi64(
            _mm512_castpd_si512(a),
            _mm512_set1_epi64(step)
        )))
    }

    #[inline(always)]
    fn add_rd(self, a: __m512d, b: __m512d) -> __m512d {
        rounded!(_mm512_add_round_pd::<DOWN>(a, b))
    }
    #[inline(always)]
    fn add_ru(self, a: __m512d, b: __m512d) -> __m512d {
        rounded!(_mm512_add_round_pd::<UP>(a, b))
    }
    #[inline(always)]
    fn sub_rd(self, a: __m512d, b: __m512d) -> __m512d {
        rounded!(_mm512_sub_round_pd::<DOWN>(a, b))
    }
    #[inline(always)]
    fn sub_ru(self, a: __m512d, b: __m512d) -> __m512d {
        rounded!(_mm512_sub_round_pd::<UP>(a, b))
    }
    #[inline(always)]
    fn mul_rd(self, a: __m512d, b: __m512d) -> __m512d {
        rounded!(_mm512_mul_round_pd::<DOWN>(a, b))
    }
    #[inline(always)]
    fn mul_ru(self, a: __m512d, b: __m512d) -> __m512d {
        rounded!(_mm512_mul_round_pd::<UP>(a, b))
    }
    #[inline(always)]
    fn div_rd(self, a: __m512d, b: __m512d) -> __m512d {
        rounded!(_mm512_div_round_pd::<DOWN>(a, b))
    }
    #[inline(always)]
    fn div_ru(self, a: __m512d, b: __m512d) -> __m512d {
        rounded!(_mm512_div_round_pd::<UP>(a, b))
    }
    #[inline(always)]
    fn sqrt_rd(self, a: __m512d) -> __m512d {
        rounded!(_mm512_sqrt_round_pd::<DOWN>(a))
    }
    #[inline(always)]
    fn sqrt_ru(self, a: __m512d) -> __m512d {
        rounded!(_mm512_sqrt_round_pd::<UP>(a))
    }
    #[inline(always)]
    fn fma_rd(self, a: __m512d, b: __m512d, c: __m512d) -> __m512d {
        rounded!(_mm512_fmadd_round_pd::<DOWN>(a, b, c))
    }
    #[inline(always)]
    fn fma_ru(self, a: __m512d, b: __m512d, c: __m512d) -> __m512d {
        rounded!(_mm512_fmadd_round_pd::<UP>(a, b, c))
    }
}

/// For `fixupimm`: quiet and signalling NaN, the two kinds of operands that come first, become +0, others stay.
const NAN_TO_ZERO: i64 = 0x88;

impl<R: Rounding> Enclose for Avx512<R> {
    #[inline(always)]
    fn i_mul(self, a: Interval<__m512d>, b: Interval<__m512d>) -> Interval<__m512d> {
        four_products(self, a, b)
    }
    #[inline(always)]
    fn i_sqr(self, a: Interval<__m512d>) -> Interval<__m512d> {
        two_squares(self, a)
    }
}

/// a·b by four products. For one number y, the least x·y over x ∈ a is that of a.lo where y ≥ 0, else that of a.hi; it is
/// concave in y, so the least of all is at a bound of b. The greatest alike.
///
/// NaN is 0·∞ and means 0. `min_f` and `max_f` drop it in their first operand, and are right to: with y = b.lo it
/// comes of y = −∞ and a zero bound of a, or of y = 0 and an infinite one, and either way the product of the other
/// bound of b (mended) is 0, or on the far side of it. −0 ≥ 0, as it must be: by its sign bit it would take the other
/// bound of a.
#[inline(always)]
fn four_products<P: Enclose>(p: P, a: Interval<P::F>, b: Interval<P::F>) -> Interval<P::F> {
    let zero = p.splat(0.0);
    let (low, high) = (p.le(zero, b.lo), p.le(zero, b.hi));
    let least = p.mend(p.mul_rd(p.select(high, a.lo, a.hi), b.hi));
    let most = p.mend(p.mul_ru(p.select(high, a.hi, a.lo), b.hi));
    Interval {
        lo: p.min_f(p.mul_rd(p.select(low, a.lo, a.hi), b.lo), least),
        hi: p.max_f(p.mul_ru(p.select(low, a.hi, a.lo), b.lo), most),
    }
}

/// The squares of the bounds of |a|; they cannot be 0·∞, and a square rounded down is not negative.
#[inline(always)]
fn two_squares<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let m = p.i_abs(a);
    Interval {
        lo: p.mul_rd(m.lo, m.lo),
        hi: p.mul_ru(m.hi, m.hi),
    }
}
