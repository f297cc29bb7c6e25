//! AVX2 with FMA: to nearest first, then one fused operation per bound that steps outward.

use std::arch::x86_64::*;
use std::marker::PhantomData;

use super::enclose::Enclose;
use super::sealed::Sealed;
use super::{Directed, Interval, Kernel, Lanes, Rounding, Routine};

/// The token of the AVX2 back-end: the processor has AVX2 and FMA.
#[derive(Clone, Copy, Debug)]
pub struct Avx2<R = Directed>(PhantomData<R>);

impl<R: Rounding> Avx2<R> {
    /// The token, if this processor has what it stands for.
    pub(super) fn detect() -> Option<Self> {
        let has = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
        has.then_some(Avx2(PhantomData))
    }
}

/// Eight doubles, or eight masks of ones or zeros, in two registers.
#[derive(Clone, Copy, Debug)]
pub struct Pair(__m256d, __m256d);

/// Intrinsics, called from methods of the token.
macro_rules! cpu {
    ($call:expr) => {{
        // SAFETY: the token exists only where `detect` found AVX2 and FMA, which are all that these intrinsics need;
        // none of them touches memory.
        unsafe { $call }
    }};
}

/// The same intrinsic on both halves.
macro_rules! both {
    ($intrinsic:ident $(::<$parameter:ident>)? ($a:expr)) => {
        cpu!(Pair($intrinsic$(::<$parameter>)?($a.0), $intrinsic$(::<$parameter>)?($a.1)))
    };
    ($intrinsic:ident $(::<$parameter:ident>)? ($a:expr, $b:expr)) => {
        cpu!(Pair($intrinsic$(::<$parameter>)?($a.0, $b.0), $intrinsic$(::<$parameter>)?($a.1, $b.1)))
    };
    ($intrinsic:ident($a:expr, $b:expr, $c:expr)) => {
        cpu!(Pair($intrinsic($a.0, $b.0, $c.0), $intrinsic($a.1, $b.1, $c.1)))
    };
}

mod widen;

#[inline(never)]
#[target_feature(enable = "avx2,fma")]
fn run_kernel<R: Rounding, K: Kernel>(p: Avx2<R>, kernel: K) -> K::Output {
    kernel.run(p)
}

#[inline(never)]
#[target_feature(enable = "avx2,fma")]
fn call_routine<R: Rounding, T: Routine<Avx2<R>>>(p: Avx2<R>, routine: T) -> T::Output {
    routine.call(p)
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn call_operation<R: Rounding, T: Routine<Avx2<R>>>(p: Avx2<R>, routine: T) -> T::Output {
    routine.call(p)
}

impl<R: Rounding> Sealed for Avx2<R> {}

impl<R: Rounding> Lanes for Avx2<R> {
    type F = Pair;
    type M = Pair;
    type Rounding = R;
    type Eight = Self;
    const LANES: usize = 8;
    const FUSED: bool = true;
    const NAME: &'static str =
        R::MODE.name(["avx2", "avx2-unrounded", "avx2-too-tight", "avx2-unguarded"]);
    const OPTIMAL: bool = false;

    #[inline(always)]
    fn kernel<K: Kernel>(self, kernel: K) -> K::Output {
        // SAFETY: the token proves the features.
        unsafe { run_kernel(self, kernel) }
    }
    #[inline(always)]
    fn call<T: Routine<Self>>(self, routine: T) -> T::Output {
        // SAFETY: the token proves the features.
        unsafe { call_routine(self, routine) }
    }
    #[inline(always)]
    fn operation<T: Routine<Self>>(self, routine: T) -> T::Output {
        // SAFETY: the token proves the features.
        unsafe { call_operation(self, routine) }
    }

    #[inline(always)]
    fn eight(self) -> Self {
        self
    }
    #[inline(always)]
    fn splat(self, x: f64) -> Pair {
        cpu!(Pair(_mm256_set1_pd(x), _mm256_set1_pd(x)))
    }
    #[inline(always)]
    fn lanes(self, x: [f64; 8]) -> Pair {
        // SAFETY: the token proves AVX; unaligned loads of four doubles each, inside an array of eight.
        unsafe {
            Pair(
                _mm256_loadu_pd(x.as_ptr()),
                _mm256_loadu_pd(x.as_ptr().add(4)),
            )
        }
    }
    #[inline(always)]
    fn to_array(self, x: Pair) -> [f64; 8] {
        let mut out = [0.0; 8];
        // SAFETY: the token proves AVX; unaligned stores of four doubles each, inside an array of eight.
        unsafe {
            _mm256_storeu_pd(out.as_mut_ptr(), x.0);
            _mm256_storeu_pd(out.as_mut_ptr().add(4), x.1);
        }
        out
    }

    #[inline(always)]
    fn select(self, mask: Pair, yes: Pair, no: Pair) -> Pair {
        both!(_mm256_blendv_pd(no, yes, mask))
    }
    #[inline(always)]
    fn bits(self, mask: Pair) -> u8 {
        cpu!((_mm256_movemask_pd(mask.0) | (_mm256_movemask_pd(mask.1) << 4)) as u8)
    }
    #[inline(always)]
    fn mask(self, bits: u8) -> Pair {
        let bits = bits as i64;
        cpu!({
            let word = _mm256_set1_epi64x(bits);
            let (low, high) = (
                _mm256_setr_epi64x(1, 2, 4, 8),
                _mm256_setr_epi64x(16, 32, 64, 128),
            );
            Pair(
                _mm256_castsi256_pd(_mm256_cmpeq_epi64(_mm256_and_si256(word, low), low)),
                _mm256_castsi256_pd(_mm256_cmpeq_epi64(_mm256_and_si256(word, high), high)),
            )
        })
    }
    #[inline(always)]
    fn and(self, a: Pair, b: Pair) -> Pair {
        both!(_mm256_and_pd(a, b))
    }
    #[inline(always)]
    fn or(self, a: Pair, b: Pair) -> Pair {
        both!(_mm256_or_pd(a, b))
    }
    #[inline(always)]
    fn and_not(self, a: Pair, b: Pair) -> Pair {
        // The intrinsic complements its first operand.
        both!(_mm256_andnot_pd(b, a))
    }

    #[inline(always)]
    fn lt(self, a: Pair, b: Pair) -> Pair {
        both!(_mm256_cmp_pd::<_CMP_LT_OQ>(a, b))
    }
    #[inline(always)]
    fn le(self, a: Pair, b: Pair) -> Pair {
        both!(_mm256_cmp_pd::<_CMP_LE_OQ>(a, b))
    }
    #[inline(always)]
    fn eq(self, a: Pair, b: Pair) -> Pair {
        both!(_mm256_cmp_pd::<_CMP_EQ_OQ>(a, b))
    }

    #[inline(always)]
    fn neg_f(self, a: Pair) -> Pair {
        both!(_mm256_xor_pd(a, self.splat(-0.0)))
    }
    #[inline(always)]
    fn abs_f(self, a: Pair) -> Pair {
        both!(_mm256_andnot_pd(self.splat(-0.0), a))
    }
    #[inline(always)]
    fn min_f(self, a: Pair, b: Pair) -> Pair {
        both!(_mm256_min_pd(a, b))
    }
    #[inline(always)]
    fn max_f(self, a: Pair, b: Pair) -> Pair {
        both!(_mm256_max_pd(a, b))
    }

    #[inline(always)]
    fn add_rn(self, a: Pair, b: Pair) -> Pair {
        both!(_mm256_add_pd(a, b))
    }
    #[inline(always)]
    fn sub_rn(self, a: Pair, b: Pair) -> Pair {
        both!(_mm256_sub_pd(a, b))
    }
    #[inline(always)]
    fn mul_rn(self, a: Pair, b: Pair) -> Pair {
        both!(_mm256_mul_pd(a, b))
    }
    #[inline(always)]
    fn div_rn(self, a: Pair, b: Pair) -> Pair {
        both!(_mm256_div_pd(a, b))
    }
    #[inline(always)]
    fn sqrt_rn(self, a: Pair) -> Pair {
        both!(_mm256_sqrt_pd(a))
    }
    #[inline(always)]
    fn fma_rn(self, a: Pair, b: Pair, c: Pair) -> Pair {
        both!(_mm256_fmadd_pd(a, b, c))
    }
    #[inline(always)]
    fn fms_rn(self, a: Pair, b: Pair, c: Pair) -> Pair {
        both!(_mm256_fmsub_pd(a, b, c))
    }
    #[inline(always)]
    fn round_f(self, a: Pair) -> Pair {
        const NEAREST: i32 = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;
        both!(_mm256_round_pd::<NEAREST>(a))
    }
    #[inline(always)]
    fn floor_f(self, a: Pair) -> Pair {
        both!(_mm256_floor_pd(a))
    }
    #[inline(always)]
    fn bit<const B: u32>(self, shifted: Pair) -> Pair {
        cpu!({
            let bit = _mm256_set1_epi64x(1 << B);
            let (low, high) = (
                _mm256_and_si256(_mm256_castpd_si256(shifted.0), bit),
                _mm256_and_si256(_mm256_castpd_si256(shifted.1), bit),
            );
            Pair(
                _mm256_castsi256_pd(_mm256_cmpeq_epi64(low, bit)),
                _mm256_castsi256_pd(_mm256_cmpeq_epi64(high, bit)),
            )
        })
    }
    #[inline(always)]
    fn pow2(self, n: Pair) -> Pair {
        // n + 1023 + 1.5·2⁵² holds the biased exponent in its low bits; shifted into place, the rest falls off.
        let biased = self.add_rn(n, self.splat(6_755_399_441_055_744.0 + 1023.0));
        cpu!(Pair(
            _mm256_castsi256_pd(_mm256_slli_epi64::<52>(_mm256_castpd_si256(biased.0))),
            _mm256_castsi256_pd(_mm256_slli_epi64::<52>(_mm256_castpd_si256(biased.1))),
        ))
    }
    #[inline(always)]
    fn mend(self, a: Pair) -> Pair {
        self.and(both!(_mm256_cmp_pd::<_CMP_ORD_Q>(a, a)), a)
    }

    /// See the function of this name beside the trait.
    #[inline(always)]
    fn decompose(self, x: Pair) -> (Pair, Pair) {
        let (a, b) = (self.decompose_half(x.0), self.decompose_half(x.1));
        (Pair(a.0, b.0), Pair(a.1, b.1))
    }
    #[inline(always)]
    fn before(self, a: Pair) -> Pair {
        self.moved(a, -(R::STEP as i64))
    }
    #[inline(always)]
    fn after(self, a: Pair) -> Pair {
        self.moved(a, R::STEP as i64)
    }

    #[inline(always)]
    fn add_rd(self, a: Pair, b: Pair) -> Pair {
        self.down(self.add_rn(a, b))
    }
    #[inline(always)]
    fn add_ru(self, a: Pair, b: Pair) -> Pair {
        self.up(self.add_rn(a, b))
    }
    #[inline(always)]
    fn sub_rd(self, a: Pair, b: Pair) -> Pair {
        self.down(self.sub_rn(a, b))
    }
    #[inline(always)]
    fn sub_ru(self, a: Pair, b: Pair) -> Pair {
        self.up(self.sub_rn(a, b))
    }
    #[inline(always)]
    fn mul_rd(self, a: Pair, b: Pair) -> Pair {
        self.down_guarded(self.mul_rn(a, b), self.zeros(a, b))
    }
    #[inline(always)]
    fn mul_ru(self, a: Pair, b: Pair) -> Pair {
        self.up_guarded(self.mul_rn(a, b), self.zeros(a, b))
    }
    #[inline(always)]
    fn mul_nonneg_rd(self, a: Pair, b: Pair) -> Pair {
        self.max_f(self.down_nonneg(self.mul_rn(a, b)), self.splat(0.0))
    }
    #[inline(always)]
    fn mul_nonneg_ru(self, a: Pair, b: Pair) -> Pair {
        self.max_f(
            self.up_nonneg(self.mul_rn(a, b), self.zeros(a, b)),
            self.splat(0.0),
        )
    }
    #[inline(always)]
    fn radius(self, a: Pair, b: Pair, c: Pair) -> Pair {
        let product = self.max_f(self.mul_rn(a, b), self.splat(0.0));
        self.up_radius(self.add_rn(product, c))
    }
    #[inline(always)]
    fn div_rd(self, a: Pair, b: Pair) -> Pair {
        self.down_guarded(self.div_rn(a, b), self.zero(a))
    }
    #[inline(always)]
    fn div_ru(self, a: Pair, b: Pair) -> Pair {
        self.up_guarded(self.div_rn(a, b), self.zero(a))
    }
    #[inline(always)]
    fn sqrt_rd(self, a: Pair) -> Pair {
        self.down(self.sqrt_rn(a))
    }
    #[inline(always)]
    fn sqrt_ru(self, a: Pair) -> Pair {
        self.up(self.sqrt_rn(a))
    }
    #[inline(always)]
    fn fma_rd(self, a: Pair, b: Pair, c: Pair) -> Pair {
        self.down_guarded(self.fma_rn(a, b, c), self.zeros(a, b))
    }
    #[inline(always)]
    fn fma_ru(self, a: Pair, b: Pair, c: Pair) -> Pair {
        self.up_guarded(self.fma_rn(a, b, c), self.zeros(a, b))
    }
}

/// Overrides that widen once per bound, after the minimum and the maximum: widening keeps the order.
impl<R: Rounding> Enclose for Avx2<R> {
    #[inline(always)]
    fn i_mul(self, a: Interval<Pair>, b: Interval<Pair>) -> Interval<Pair> {
        let p = self;
        let last = p.mend(p.mul_rn(a.hi, b.hi));
        let (x, y, z) = (
            p.mul_rn(a.hi, b.lo),
            p.mul_rn(a.lo, b.hi),
            p.mul_rn(a.lo, b.lo),
        );
        let lo = p.min_f(z, p.min_f(y, p.min_f(x, last)));
        let hi = p.max_f(z, p.max_f(y, p.max_f(x, last)));
        p.outward(lo, hi, a, b)
    }

    #[inline(always)]
    fn i_mul_pos(self, a: Interval<Pair>, b: Interval<Pair>) -> Interval<Pair> {
        let p = self;
        let lo = p.min_f(p.mul_rn(a.lo, b.lo), p.mend(p.mul_rn(a.hi, b.lo)));
        let hi = p.max_f(p.mul_rn(a.lo, b.hi), p.mend(p.mul_rn(a.hi, b.hi)));
        p.outward(lo, hi, a, b)
    }
}
