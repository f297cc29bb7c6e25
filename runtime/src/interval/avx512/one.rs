//! AVX-512 one lane at a time: the same algorithms without vectors, to know what vectors are worth.
//!
//! A packet of eight is served by eight tokens, each of which reads and writes its own place of the packet's arrays.

use std::arch::x86_64::*;
use std::ops::Range;

use super::super::enclose::Enclose;
use super::super::lanes::decompose;
use super::super::sealed::Sealed;
use super::{Avx512, DOWN, UP, four_products, two_squares};
use crate::interval::{Directed, Interval, Kernel, Lanes, Routine};

/// The token of one lane: the processor has AVX-512 F and DQ.
#[derive(Clone, Copy, Debug)]
pub struct One {
    eight: Avx512,
    /// Its place, below 8.
    place: u8,
}

impl One {
    /// The token of the first lane, if this processor has what it stands for.
    pub(in crate::interval) fn detect() -> Option<Self> {
        let eight = Avx512::detect()?;
        Some(One { eight, place: 0 })
    }
}

/// One scalar instruction with its rounding.
macro_rules! rounded {
    ($intrinsic:ident::<$direction:ident>($($operand:expr),*)) => {{
        // SAFETY: the token `self` holds one of AVX-512 F and DQ, which are all that these intrinsics need; none of them
        // touches memory.
        unsafe { _mm_cvtsd_f64($intrinsic::<$direction>($(_mm_set_sd($operand)),*)) }
    }};
}

#[inline(never)]
#[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
fn run_kernel<K: Kernel>(p: One, kernel: K) -> K::Output {
    kernel.run(p)
}

#[inline(never)]
#[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
fn call_routine<T: Routine<One>>(p: One, routine: T) -> T::Output {
    routine.call(p)
}

#[inline]
#[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
fn call_operation<T: Routine<One>>(p: One, routine: T) -> T::Output {
    routine.call(p)
}

impl Sealed for One {}

impl Lanes for One {
    type F = f64;
    type M = bool;
    type Rounding = Directed;
    type Eight = Avx512;
    const LANES: usize = 1;
    const PARTS: usize = 8;
    const FUSED: bool = true;
    const NAME: &'static str = "avx512-one";
    const OPTIMAL: bool = true;
    const INLINES_LONG: bool = true;

    /// What knows nothing of parts runs in eight lanes.
    #[inline(always)]
    fn kernel<K: Kernel>(self, kernel: K) -> K::Output {
        if const { K::IN_PARTS } {
            // SAFETY: the token proves the features; AVX-512 F implies AVX2 and FMA.
            unsafe { run_kernel(self, kernel) }
        } else {
            self.eight.kernel(kernel)
        }
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
    fn eight(self) -> Avx512 {
        self.eight
    }
    #[inline(always)]
    fn part(self, number: usize) -> Self {
        One {
            place: number as u8 & 7,
            ..self
        }
    }
    #[inline(always)]
    fn own(self) -> Range<usize> {
        let place = usize::from(self.place);
        place..place + 1
    }

    #[inline(always)]
    fn splat(self, x: f64) -> f64 {
        x
    }
    #[inline(always)]
    fn lanes(self, x: [f64; 8]) -> f64 {
        x[usize::from(self.place & 7)]
    }
    #[inline(always)]
    fn to_array(self, x: f64) -> [f64; 8] {
        [x; 8]
    }
    #[inline(always)]
    fn store(self, x: f64, to: &mut [f64; 8]) {
        to[usize::from(self.place & 7)] = x;
    }

    #[inline(always)]
    fn select(self, mask: bool, yes: f64, no: f64) -> f64 {
        if mask { yes } else { no }
    }
    #[inline(always)]
    fn bits(self, mask: bool) -> u8 {
        u8::from(mask) << (self.place & 7)
    }
    #[inline(always)]
    fn mask(self, bits: u8) -> bool {
        bits >> (self.place & 7) & 1 != 0
    }
    #[inline(always)]
    fn and(self, a: bool, b: bool) -> bool {
        a & b
    }
    #[inline(always)]
    fn or(self, a: bool, b: bool) -> bool {
        a | b
    }
    #[inline(always)]
    fn and_not(self, a: bool, b: bool) -> bool {
        a & !b
    }
    #[inline(always)]
    fn any(self, mask: bool) -> bool {
        mask
    }
    #[inline(always)]
    fn all(self) -> bool {
        true
    }
    #[inline(always)]
    fn none(self) -> bool {
        false
    }

    #[inline(always)]
    fn lt(self, a: f64, b: f64) -> bool {
        a < b
    }
    #[inline(always)]
    fn le(self, a: f64, b: f64) -> bool {
        a <= b
    }
    #[inline(always)]
    fn eq(self, a: f64, b: f64) -> bool {
        a == b
    }

    #[inline(always)]
    fn neg_f(self, a: f64) -> f64 {
        -a
    }
    #[inline(always)]
    fn abs_f(self, a: f64) -> f64 {
        a.abs()
    }
    #[inline(always)]
    fn min_f(self, a: f64, b: f64) -> f64 {
        if a < b { a } else { b }
    }
    #[inline(always)]
    fn max_f(self, a: f64, b: f64) -> f64 {
        if a > b { a } else { b }
    }

    #[inline(always)]
    fn add_rn(self, a: f64, b: f64) -> f64 {
        a + b
    }
    #[inline(always)]
    fn sub_rn(self, a: f64, b: f64) -> f64 {
        a - b
    }
    #[inline(always)]
    fn mul_rn(self, a: f64, b: f64) -> f64 {
        a * b
    }
    #[inline(always)]
    fn div_rn(self, a: f64, b: f64) -> f64 {
        a / b
    }
    #[inline(always)]
    fn sqrt_rn(self, a: f64) -> f64 {
        a.sqrt()
    }
    #[inline(always)]
    fn fma_rn(self, a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
    #[inline(always)]
    fn fms_rn(self, a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, -c)
    }
    #[inline(always)]
    fn round_f(self, a: f64) -> f64 {
        a.round_ties_even()
    }
    #[inline(always)]
    fn floor_f(self, a: f64) -> f64 {
        a.floor()
    }
    #[inline(always)]
    fn bit<const B: u32>(self, shifted: f64) -> bool {
        (shifted.to_bits() >> B) & 1 == 1
    }
    #[inline(always)]
    fn pow2(self, n: f64) -> f64 {
        self.scale(1.0, n)
    }
    #[inline(always)]
    fn scale(self, v: f64, n: f64) -> f64 {
        // SAFETY: as in `rounded!`.
        unsafe { _mm_cvtsd_f64(_mm_scalef_sd(_mm_set_sd(v), _mm_set_sd(n))) }
    }
    #[inline(always)]
    fn decompose(self, x: f64) -> (f64, f64) {
        decompose(x)
    }
    #[inline(always)]
    fn before(self, a: f64) -> f64 {
        f64::from_bits(a.to_bits().wrapping_sub(1))
    }
    #[inline(always)]
    fn after(self, a: f64) -> f64 {
        f64::from_bits(a.to_bits().wrapping_add(1))
    }

    #[inline(always)]
    fn add_rd(self, a: f64, b: f64) -> f64 {
        rounded!(_mm_add_round_sd::<DOWN>(a, b))
    }
    #[inline(always)]
    fn add_ru(self, a: f64, b: f64) -> f64 {
        rounded!(_mm_add_round_sd::<UP>(a, b))
    }
    #[inline(always)]
    fn sub_rd(self, a: f64, b: f64) -> f64 {
        rounded!(_mm_sub_round_sd::<DOWN>(a, b))
    }
    #[inline(always)]
    fn sub_ru(self, a: f64, b: f64) -> f64 {
        rounded!(_mm_sub_round_sd::<UP>(a, b))
    }
    #[inline(always)]
    fn mul_rd(self, a: f64, b: f64) -> f64 {
        rounded!(_mm_mul_round_sd::<DOWN>(a, b))
    }
    #[inline(always)]
    fn mul_ru(self, a: f64, b: f64) -> f64 {
        rounded!(_mm_mul_round_sd::<UP>(a, b))
    }
    #[inline(always)]
    fn div_rd(self, a: f64, b: f64) -> f64 {
        rounded!(_mm_div_round_sd::<DOWN>(a, b))
    }
    #[inline(always)]
    fn div_ru(self, a: f64, b: f64) -> f64 {
        rounded!(_mm_div_round_sd::<UP>(a, b))
    }
    #[inline(always)]
    fn sqrt_rd(self, a: f64) -> f64 {
        rounded!(_mm_sqrt_round_sd::<DOWN>(a, a))
    }
    #[inline(always)]
    fn sqrt_ru(self, a: f64) -> f64 {
        rounded!(_mm_sqrt_round_sd::<UP>(a, a))
    }
    #[inline(always)]
    fn fma_rd(self, a: f64, b: f64, c: f64) -> f64 {
        rounded!(_mm_fmadd_round_sd::<DOWN>(a, b, c))
    }
    #[inline(always)]
    fn fma_ru(self, a: f64, b: f64, c: f64) -> f64 {
        rounded!(_mm_fmadd_round_sd::<UP>(a, b, c))
    }
}

impl Enclose for One {
    #[inline(always)]
    fn i_mul(self, a: Interval, b: Interval) -> Interval {
        four_products(self, a, b)
    }
    #[inline(always)]
    fn i_sqr(self, a: Interval) -> Interval {
        two_squares(self, a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of all kinds.
    const NUMBERS: [f64; 8] = [
        1.1,
        -3.7,
        0.0,
        1e308,
        -2.5e-308,
        f64::INFINITY,
        0.7,
        -6.02e23,
    ];

    /// Each token's result at its place, as bits; NaN is NaN.
    fn by_parts(one: One, work: impl Fn(One, [f64; 3]) -> f64, x: [[f64; 8]; 3]) -> [u64; 8] {
        let mut all = [0.0; 8];
        for part in 0..One::PARTS {
            let p = one.part(part);
            let y = work(p, x.map(|x| p.lanes(x)));
            p.store(y, &mut all);
        }
        all.map(same)
    }

    fn same(x: f64) -> u64 {
        if x.is_nan() {
            0x7ff8 << 48
        } else {
            x.to_bits()
        }
    }

    macro_rules! compare {
        ($one:ident $x:ident: $($name:ident($($k:literal),*);)*) => {$(
            let eight = $one.eight();
            let v = $x.map(|x| eight.lanes(x));
            let expected = eight.to_array(eight.$name($(v[$k]),*)).map(same);
            let got = by_parts($one, |p, x| p.$name($(x[$k]),*), $x);
            assert_eq!(got, expected, stringify!($name));
        )*};
    }

    #[test]
    fn a_lane_is_what_it_is_among_eight() {
        let Some(one) = One::detect() else {
            return;
        };
        for (i, j) in (0..8).flat_map(|i| (0..8).map(move |j| (i, j))) {
            let turned = |by: usize| core::array::from_fn(|k| NUMBERS[(k + by) % 8]);
            let x = [NUMBERS, turned(i), turned(j)];
            compare! {
                one x:
                min_f(0, 1); max_f(0, 1); neg_f(0); abs_f(0); mend(0); before(0); after(0);
                add_rn(0, 1); sub_rn(0, 1); mul_rn(0, 1); div_rn(0, 1); sqrt_rn(0);
                fma_rn(0, 1, 2); fms_rn(0, 1, 2); round_f(0); floor_f(0);
                add_rd(0, 1); add_ru(0, 1); sub_rd(0, 1); sub_ru(0, 1); mul_rd(0, 1); mul_ru(0, 1);
                div_rd(0, 1); div_ru(0, 1); sqrt_rd(0); sqrt_ru(0); fma_rd(0, 1, 2); fma_ru(0, 1, 2);
                radius(0, 1, 2);
            }
        }
    }

    #[test]
    fn masks_and_arrays_have_one_place() {
        let Some(one) = One::detect() else {
            return;
        };
        let p = one.part(5);
        assert_eq!((p.bits(true), p.bits(false), p.own()), (1 << 5, 0, 5..6));
        assert!(p.mask(1 << 5) && !p.mask(!(1 << 5)));
        let mut array = [0.0; 8];
        p.store(1.0, &mut array);
        assert_eq!(array, [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    }
}
