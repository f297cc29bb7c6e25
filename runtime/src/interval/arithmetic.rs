//! What generated code is written in: one body serves intervals, plain floats, packets and scalars.

use super::{Ball, Flags, Interval, Number, Packet, Truth};

/// A number system. Generated code is generic over it, so the same straight-line body encloses a surface over a
/// packet of segments (every [`Packet`] is an `Arithmetic` on intervals) and approximates it in plain floats
/// ([`Nearest`](super::Nearest)).
///
/// For intervals each operation is an *inclusion*: its result contains the value of the real operation for all points
/// of the operands where it is defined. Partial operations return [`Flags`] beside it. `Nearest` returns no flags; its
/// results may be NaN.
pub trait Arithmetic: Copy {
    /// The packet that the coefficients of the ray stage are stored for.
    type Packet: Packet;
    /// A number of this system: an interval packet, or a vector of floats.
    type Value: Copy;

    /// A value of the surface stage, the same in each lane.
    fn constant(self, c: &Interval) -> Self::Value;

    /// An exact number of the formula.
    #[inline(always)]
    fn literal(self, n: &Number) -> Self::Value {
        self.constant(&n.enclosure)
    }

    /// A value of the surface stage that is known in twice the precision, too.
    #[inline(always)]
    fn stored(self, c: &Interval, _fine: &Ball) -> Self::Value {
        self.constant(c)
    }

    /// No flags set.
    fn clear(self) -> Flags<Self::Packet>;
    /// The flags of an operation's operands, together.
    fn join(self, a: Flags<Self::Packet>, b: Flags<Self::Packet>) -> Flags<Self::Packet>;

    /// The flags of a function and those of one of its derivatives: where the derivative is empty, the function need not be.
    fn join_derivative(self, a: Flags<Self::Packet>, d: Flags<Self::Packet>)
    -> Flags<Self::Packet>;
    /// *Undefined* in all lanes if a value of the surface stage may be.
    fn undefined_if(self, undefined: bool) -> Flags<Self::Packet>;

    /// −a
    fn neg(self, a: Self::Value) -> Self::Value;
    /// a + b
    fn add(self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a − b
    fn sub(self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a·b
    fn mul(self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a·b, where the compiler proved `a ≥ 0` (an interval's lower bound may still be a rounding below 0 only if
    /// [`nonneg`](Self::nonneg) was not applied; operands here have `lo ≥ 0`).
    fn mul_pos(self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a·b, where both are ≥ 0.
    fn mul_pos_pos(self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a²
    fn sqr(self, a: Self::Value) -> Self::Value;
    /// aⁿ for n ≥ 0; even powers are the inclusion of the power, never a product of dependent factors.
    fn powi(self, a: Self::Value, n: u32) -> Self::Value;
    /// Intersects with [0, ∞): for values that the compiler proved to be ≥ 0.
    fn nonneg(self, a: Self::Value) -> Self::Value;
    /// |a|
    fn abs(self, a: Self::Value) -> Self::Value;
    /// The derivative of |a|: the sign, [−1, 1] across 0 (a kink).
    fn abs_slope(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// min(a, b)
    fn min(self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// max(a, b)
    fn max(self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a < b, as far as it is decided; for intervals also `≤`, because a certain `<` is certain `≤` and an undecided one
    /// is undecided either way.
    fn less(self, a: Self::Value, b: Self::Value) -> Truth<Self::Packet>;
    /// a ≤ b, as far as it is decided.
    fn less_or_equal(self, a: Self::Value, b: Self::Value) -> Truth<Self::Packet>;
    /// Both conditions.
    fn both(self, a: Truth<Self::Packet>, b: Truth<Self::Packet>) -> Truth<Self::Packet>;
    /// Either condition.
    fn either(self, a: Truth<Self::Packet>, b: Truth<Self::Packet>) -> Truth<Self::Packet>;
    /// `yes` where the condition is certain, `no` where its negation is, else their hull. Flags set nothing by
    /// themselves: [`branch`](Self::branch) is for `if`, where an undecided condition is a possible jump.
    fn choose(self, c: Truth<Self::Packet>, yes: Self::Value, no: Self::Value) -> Self::Value;
    /// The flags of `choose`: those of the taken branch; of both where undecided (empty only if both are). Undecided
    /// lanes add `undecided` (a jump for an `if` of unknown continuity, a kink for min and max of derivatives).
    fn branch(
        self,
        c: Truth<Self::Packet>,
        yes: Flags<Self::Packet>,
        no: Flags<Self::Packet>,
        undecided: super::Undecided,
    ) -> Flags<Self::Packet>;

    /// a/b on b ≠ 0; *undefined* where 0 ∈ b, *empty* where b = [0, 0].
    fn div(self, a: Self::Value, b: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// 1/a on a ≠ 0.
    fn recip(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// √a on a ≥ 0.
    fn sqrt(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// ∛a everywhere.
    fn cbrt(self, a: Self::Value) -> Self::Value;
    /// aᵇ = exp(b·ln a) on a > 0, and 0ᵇ = 0 for b > 0.
    fn pow(self, a: Self::Value, b: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// eᵃ
    fn exp(self, a: Self::Value) -> Self::Value;
    /// 2ᵃ
    fn exp2(self, a: Self::Value) -> Self::Value;
    /// eᵃ − 1
    fn exp_m1(self, a: Self::Value) -> Self::Value;
    /// ln a on a > 0.
    fn ln(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// ln(1 + a) on a > −1.
    fn ln_1p(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// log₂ a on a > 0.
    fn log2(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// log₁₀ a on a > 0.
    fn log10(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// sin a
    fn sin(self, a: Self::Value) -> Self::Value;
    /// cos a
    fn cos(self, a: Self::Value) -> Self::Value;
    /// sin a and cos a: what both need is computed once.
    fn sin_cos(self, a: Self::Value) -> [Self::Value; 2];
    /// tan a, off its poles.
    fn tan(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// arcsin a on [−1, 1].
    fn asin(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// arccos a on [−1, 1].
    fn acos(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// arctan a
    fn atan(self, a: Self::Value) -> Self::Value;
    /// The angle of (x = b, y = a) in (−π, π]; undefined at the origin, a jump across the negative x axis.
    fn atan2(self, a: Self::Value, b: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// sinh a
    fn sinh(self, a: Self::Value) -> Self::Value;
    /// cosh a
    fn cosh(self, a: Self::Value) -> Self::Value;
    /// tanh a
    fn tanh(self, a: Self::Value) -> Self::Value;
    /// arsinh a
    fn asinh(self, a: Self::Value) -> Self::Value;
    /// arcosh a on a ≥ 1.
    fn acosh(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// artanh a on (−1, 1).
    fn atanh(self, a: Self::Value) -> (Self::Value, Flags<Self::Packet>);
    /// √(a² + b²)
    fn hypot(self, a: Self::Value, b: Self::Value) -> Self::Value;
}
