//! Vectors of `f64` with directed rounding: the primitives that a back-end provides.

use core::ops::Range;

use super::Rounding;
use super::sealed::Sealed;

/// 2⁻⁹⁰⁰: steps in proportion to it are normal numbers, and so are their products with what is not tiny.
///
/// An upper bound of a·b + c for a, b, c ≥ 0 from x, what a product and a sum rounded to nearest give, is
/// x + 4u·max(x, 2⁻⁹⁰⁰), u = 2⁻⁵³. For the product lost at most u of itself, or 2⁻¹⁰⁷⁵, and the sum u, so that
/// a·b + c ≤ x(1 + 2u + 4u²) + 2⁻¹⁰⁷⁴; and what is added is more than that, rounded again or not.
pub(super) const RADIUS: f64 = f64::from_bits((1023 - 900) << 52);
/// 4u
pub(super) const RADIUS_STEP: f64 = 2.0 * f64::EPSILON;

/// A token for one instruction set. Holding one proves that the processor has it, so every method is safe.
///
/// Only [`Isa`](super::Isa) creates tokens, after detection. A back-end is this trait and nothing else:
/// interval operations ([`Packet`](super::Packet)) are written once, on top of it, and a back-end overrides
/// those that it can do better.
///
/// Suffixes are the IEEE 754 rounding attributes: `rn` to nearest, `rd` towards −∞, `ru` towards +∞.
/// A back-end need not be exact in `rd` and `ru`, but it must bound: `x_rd ≤ exact ≤ x_ru`, for all finite and
/// infinite operands, at overflow and in subnormals. NaN (0·∞, ∞ − ∞) may come out of the primitives; the interval
/// operations mend it.
pub trait Lanes: Copy + Send + Sync + Sealed + 'static {
    /// A vector of [`Self::LANES`] doubles.
    type F: Copy + Send + Sync + 'static;
    /// One bit per lane, in whatever form the processor likes.
    type M: Copy + Send + Sync + 'static;
    /// Do bounds hold, or what is wrong with them? Wrong ones are negative controls.
    type Rounding: Rounding;

    /// The back-end of eight lanes for what a packet is set up with: itself, if it has them.
    type Eight: super::Packet;

    /// How many lanes a vector has: 8 in packets, 1 in scalars.
    const LANES: usize;
    /// How many tokens serve a packet of eight: one, if it has all lanes, and else one for each part of them.
    const PARTS: usize = 1;
    /// Is `fma_rn` fused, that is, rounded once?
    const FUSED: bool;
    /// The name that `ZEROSET_ISA` and reports use.
    const NAME: &'static str;
    /// Are directed results the optimal ones, so that they have the sign of the exact result (or are 0)? Where they are
    /// not, an exact 0 may be widened to the smallest subnormal.
    const OPTIMAL: bool;
    /// Are sine and cosine inlined into formulas? Calls cost a gyroid a tenth of its time, and inlining costs seconds of
    /// compilation, on AVX2 twice as many.
    const INLINES_LONG: bool = false;

    /// Runs `kernel` as one function of its own, compiled for this instruction set, into which everything that
    /// it calls is inlined. This is where inlining stops.
    fn kernel<K: Kernel>(self, kernel: K) -> K::Output;
    /// The same for work on values of this instruction set, which [`Kernel`] cannot name: one function of its own per
    /// routine and instruction set (`#[inline(never)]`, with the target features).
    fn call<R: Routine<Self>>(self, routine: R) -> R::Output;
    /// The same for one operation of a formula. A formula has hundreds of them; inlined as they are written they give a
    /// function that takes minutes to compile, most of it for taking apart what every one of them passes in memory. As a
    /// function of its own an operation is simplified once, and then inlined where it is short.
    fn operation<R: Routine<Self>>(self, routine: R) -> R::Output;

    /// The token of eight lanes.
    fn eight(self) -> Self::Eight;
    /// The token of a part.
    #[inline(always)]
    fn part(self, _number: usize) -> Self {
        self
    }
    /// The places in arrays of eight that the lanes of this token stand for.
    #[inline(always)]
    fn own(self) -> Range<usize> {
        0..8
    }

    /// The same number in every lane.
    fn splat(self, x: f64) -> Self::F;
    /// Lane `i` is `f(i)`; for set-up code, not for inner loops.
    fn lanes(self, x: [f64; 8]) -> Self::F;
    /// The lanes, padded with the last one.
    fn to_array(self, x: Self::F) -> [f64; 8];
    /// Writes the lanes to the places that are this token's own.
    #[inline(always)]
    fn store(self, x: Self::F, to: &mut [f64; 8]) {
        *to = self.to_array(x);
    }

    /// Lane-wise `mask ? yes : no`.
    fn select(self, mask: Self::M, yes: Self::F, no: Self::F) -> Self::F;
    /// The mask with bit `i` for place `i`; those of other places are 0.
    fn bits(self, mask: Self::M) -> u8;
    /// The mask from bits; those of other places are ignored.
    fn mask(self, bits: u8) -> Self::M;
    /// Both.
    fn and(self, a: Self::M, b: Self::M) -> Self::M;
    /// Either.
    fn or(self, a: Self::M, b: Self::M) -> Self::M;
    /// `a` and not `b`.
    fn and_not(self, a: Self::M, b: Self::M) -> Self::M;
    /// Is any lane set?
    #[inline(always)]
    fn any(self, mask: Self::M) -> bool {
        self.bits(mask) != 0
    }

    /// `a < b`, false on NaN.
    fn lt(self, a: Self::F, b: Self::F) -> Self::M;
    /// `a ≤ b`, false on NaN.
    fn le(self, a: Self::F, b: Self::F) -> Self::M;
    /// `a = b`, false on NaN; −0 = +0.
    fn eq(self, a: Self::F, b: Self::F) -> Self::M;

    /// −a.
    fn neg_f(self, a: Self::F) -> Self::F;
    /// |a|.
    fn abs_f(self, a: Self::F) -> Self::F;
    /// The smaller; **`b` if either is NaN**.
    fn min_f(self, a: Self::F, b: Self::F) -> Self::F;
    /// The larger; **`b` if either is NaN**.
    fn max_f(self, a: Self::F, b: Self::F) -> Self::F;

    /// a + b to nearest.
    fn add_rn(self, a: Self::F, b: Self::F) -> Self::F;
    /// a − b to nearest.
    fn sub_rn(self, a: Self::F, b: Self::F) -> Self::F;
    /// a·b to nearest.
    fn mul_rn(self, a: Self::F, b: Self::F) -> Self::F;
    /// a/b to nearest.
    fn div_rn(self, a: Self::F, b: Self::F) -> Self::F;
    /// √a to nearest.
    fn sqrt_rn(self, a: Self::F) -> Self::F;
    /// a·b + c; one rounding where the processor has FMA, else two. For approximations only.
    fn fma_rn(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F;
    /// a·b − c, as [`fma_rn`](Self::fma_rn).
    fn fms_rn(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F;
    /// The nearest whole number, ties to even.
    fn round_f(self, a: Self::F) -> Self::F;
    /// The largest whole number ≤ a.
    fn floor_f(self, a: Self::F) -> Self::F;

    /// Is bit `B` (0 or 1) of the whole number n set, in two's complement, where `shifted` is n + 1.5·2⁵²?
    fn bit<const B: u32>(self, shifted: Self::F) -> Self::M;
    /// 2ⁿ for a whole number n in [−1022, 1023]; anything else gives garbage.
    fn pow2(self, n: Self::F) -> Self::F;
    /// v·2ⁿ for ½ ≤ v ≤ 2 and a whole number n in [−1022, 1024], exact if the result is a normal number.
    #[inline(always)]
    fn scale(self, v: Self::F, n: Self::F) -> Self::F {
        // 2¹⁰²⁴ is no double: half of it, and v doubled.
        let half = self.pow2(self.sub_rn(n, self.splat(1.0)));
        self.mul_rn(self.add_rn(v, v), half)
    }
    /// (m, e) with x = m·2ᵉ exactly, e a whole number and m ∈ [⅔, 4⁄3) to a unit in the last place, for a positive normal
    /// x; anything else gives garbage.
    fn decompose(self, x: Self::F) -> (Self::F, Self::F);
    /// The number before a positive normal one; the same number where rounding is off. In packets, also the one nearer to 0
    /// than a negative one, and a NaN of 0.
    fn before(self, a: Self::F) -> Self::F;
    /// The number after a positive normal one, +∞ after MAX; the same number where rounding is off. In packets, also the one
    /// farther from 0 than a negative one.
    fn after(self, a: Self::F) -> Self::F;
    /// `a`, and 0 where it is NaN: 0·∞ stands for the product of 0 and numbers without bound, which is 0.
    #[inline(always)]
    fn mend(self, a: Self::F) -> Self::F {
        self.select(self.eq(a, a), a, self.splat(0.0))
    }
    /// Every lane.
    #[inline(always)]
    fn all(self) -> Self::M {
        self.mask(0xff)
    }
    /// No lane.
    #[inline(always)]
    fn none(self) -> Self::M {
        self.mask(0)
    }
    /// Not.
    #[inline(always)]
    fn not(self, a: Self::M) -> Self::M {
        self.and_not(self.all(), a)
    }

    /// A lower bound of a + b.
    fn add_rd(self, a: Self::F, b: Self::F) -> Self::F;
    /// An upper bound of a + b.
    fn add_ru(self, a: Self::F, b: Self::F) -> Self::F;
    /// A lower bound of a − b.
    #[inline(always)]
    fn sub_rd(self, a: Self::F, b: Self::F) -> Self::F {
        self.add_rd(a, self.neg_f(b))
    }
    /// An upper bound of a − b.
    #[inline(always)]
    fn sub_ru(self, a: Self::F, b: Self::F) -> Self::F {
        self.add_ru(a, self.neg_f(b))
    }
    /// A lower bound of a·b.
    fn mul_rd(self, a: Self::F, b: Self::F) -> Self::F;
    /// An upper bound of a·b.
    fn mul_ru(self, a: Self::F, b: Self::F) -> Self::F;
    /// A lower bound of a·b for a, b ≥ 0 that is itself ≥ 0; 0·∞ = 0.
    #[inline(always)]
    fn mul_nonneg_rd(self, a: Self::F, b: Self::F) -> Self::F {
        self.max_f(self.mul_rd(a, b), self.splat(0.0))
    }
    /// An upper bound of a·b for a, b ≥ 0; 0·∞ = 0.
    #[inline(always)]
    fn mul_nonneg_ru(self, a: Self::F, b: Self::F) -> Self::F {
        self.max_f(self.mul_ru(a, b), self.splat(0.0))
    }
    /// An upper bound of a·b + c for radii a, b, c ≥ 0; 0·∞ = 0. It need not be tight below 10⁻²⁷⁰: where a factor is 0, as
    /// it often is, a back-end that widens gives a small normal number. The smallest subnormal would make many
    /// processors take a hundred cycles for each operation on it.
    #[inline(always)]
    fn radius(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F {
        self.add_ru(self.mul_nonneg_ru(a, b), c)
    }
    /// A lower bound of a/b.
    fn div_rd(self, a: Self::F, b: Self::F) -> Self::F;
    /// An upper bound of a/b.
    fn div_ru(self, a: Self::F, b: Self::F) -> Self::F;
    /// A lower bound of √a.
    fn sqrt_rd(self, a: Self::F) -> Self::F;
    /// An upper bound of √a.
    fn sqrt_ru(self, a: Self::F) -> Self::F;
    /// A lower bound of a·b + c. Every back-end is within 2 ulp of the *result*, whatever cancels: recentring a ray
    /// at a far origin depends on it.
    fn fma_rd(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F;
    /// An upper bound of a·b + c, as tight as [`fma_rd`](Self::fma_rd).
    fn fma_ru(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F;
    /// A lower bound of a·b + c that may be as wide as roundings of the product and the sum: for leaves, whose inner
    /// roundings are as large as what a tighter bound would save.
    #[inline(always)]
    fn mul_add_rd(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F {
        self.fma_rd(a, b, c)
    }
    /// An upper bound of a·b + c, as wide as [`mul_add_rd`](Self::mul_add_rd).
    #[inline(always)]
    fn mul_add_ru(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F {
        self.fma_ru(a, b, c)
    }
}

/// 1.5·2⁵²: added to a number below 2⁵¹, it leaves the nearest whole number, in the low bits of the sum.
pub const WHOLE: f64 = 6_755_399_441_055_744.0;

/// [`Lanes::decompose`] of one number. The bits of x less those of ⅔ hold, above the lowest 52, the exponent that brings
/// x to [⅔, 4⁄3): every such interval starts at ⅔·2ᵉ, whose bits differ from those of ⅔ in the exponent alone.
#[inline(always)]
pub(super) fn decompose(x: f64) -> (f64, f64) {
    let shifted = x
        .to_bits()
        .wrapping_sub(TWO_THIRDS)
        .wrapping_add(1023 << 52);
    let biased = shifted >> 52;
    let m = f64::from_bits(
        x.to_bits()
            .wrapping_sub((biased << 52).wrapping_sub(1023 << 52)),
    );
    // A whole number below 2⁵² in the low bits of 2⁵².
    let e = f64::from_bits(biased | 0x4330_0000_0000_0000) - (4_503_599_627_370_496.0 + 1023.0);
    (m, e)
}

/// A piece of code as an operation: `$body` becomes a [`Routine`], which [`Lanes::operation`] runs with the token
/// `$lanes`. Operands are passed by reference.
macro_rules! operation {
    (
        <$P:ident: $bound:ident> $lanes:expr, ($($operand:ident: $kind:ty = $value:expr),*) -> $out:ty
        = $p:ident => $body:expr
    ) => {{
        struct Operation<'a, $P: $bound> {
            $($operand: &'a $kind),*
        }
        impl<$P: $bound> $crate::interval::Routine<$P> for Operation<'_, $P> {
            type Output = $out;
            #[inline(always)]
            fn call(self, $p: $P) -> $out {
                $(let $operand = *self.$operand;)*
                $body
            }
        }
        $lanes.operation(Operation::<$P> { $($operand: $value),* })
    }};
}
pub(crate) use operation;

/// Methods that are one operation each.
macro_rules! operations {
    (
        <$P:ident: $bound:ident> $this:ident => $lanes:expr;
        $($name:ident($($operand:ident: $kind:ty),*) -> $out:ty = $p:ident => $body:expr;)*
    ) => {
        $(#[inline(always)]
        fn $name($this, $($operand: $kind),*) -> $out {
            $crate::interval::lanes::operation!(
                <$P: $bound> $lanes, ($($operand: $kind = &$operand),*) -> $out = $p => $body
            )
        })*
    };
}
pub(super) use operations;

/// The bits of ⅔.
pub(super) const TWO_THIRDS: u64 = 0x3fe5_5555_5555_5555;

/// A piece of work that is written once and compiled for each instruction set.
pub trait Kernel {
    /// What it returns.
    type Output;
    /// Does it ask each part of a packet for its lanes? Only then it meets tokens that have less than eight.
    const IN_PARTS: bool = false;
    /// The work. Mark implementations `#[inline(always)]`, and use neither closures nor iterator adaptors on the hot
    /// path: they do not inherit the instruction set.
    fn run<P: super::Packet>(self, p: P) -> Self::Output;
}

/// A piece of work on values of one instruction set, such as one entry point of a surface. Arguments are held by
/// reference.
pub trait Routine<L: Lanes> {
    /// What it returns.
    type Output;
    /// The work; the rules are those of [`Kernel::run`].
    fn call(self, lanes: L) -> Self::Output;
}
