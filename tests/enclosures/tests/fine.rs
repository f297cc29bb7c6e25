//! Twice the precision: balls against exact rationals, and a control that shows that the test can fail.

#![forbid(unsafe_code)]

use num_bigint::BigInt;
use num_rational::BigRational;
use zeroset::interval::{Arithmetic, Ball, Fine};

struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        self.0 >> 11
    }
    /// A number of either sign with an exponent between −30 and 30.
    fn number(&mut self) -> f64 {
        let size = 1.0 + self.bits() as f64 / (1u64 << 53) as f64;
        let sign = if self.bits().is_multiple_of(2) {
            1.0
        } else {
            -1.0
        };
        sign * size * 2f64.powi((self.bits() % 61) as i32 - 30)
    }
    /// A sum of two doubles, exactly.
    fn pair(&mut self) -> (Ball, BigRational) {
        let (a, b) = (self.number(), self.number() * 1e-17);
        (Ball::sum(a, b), rational(a) + rational(b))
    }
}

fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).expect("finite")
}

/// Does the ball, shrunk by `scale`, hold the number?
fn holds(ball: Ball, exact: &BigRational, scale: f64) -> bool {
    let [hi, lo, radius] = ball.parts();
    if radius.is_infinite() {
        return true;
    }
    let distance = rational(hi) + rational(lo) - exact;
    let distance = if distance < rational(0.0) {
        -distance
    } else {
        distance
    };
    distance <= rational(radius * scale)
}

/// Balls that do not hold the exact result, for + − × ÷ and √.
fn violations(scale: f64) -> [usize; 5] {
    let mut random = Random(3);
    let mut wrong = [0; 5];
    for _ in 0..3000 {
        let ((a, x), (b, y)) = (random.pair(), random.pair());
        let results = [
            (Fine.add(a, b), &x + &y),
            (Fine.sub(a, b), &x - &y),
            (Fine.mul(a, b), &x * &y),
            (Fine.div(a, b).0, &x / &y),
        ];
        for (k, (ball, exact)) in results.iter().enumerate() {
            wrong[k] += usize::from(!holds(*ball, exact, scale));
        }
        // √ of a square.
        let (square, flags) = Fine.sqrt(Fine.sqr(a));
        assert!(!flags.undefined);
        let size = if x < rational(0.0) { -x } else { x };
        wrong[4] += usize::from(!holds(square, &size, scale));
    }
    wrong
}

#[test]
fn arithmetic_holds_the_exact_result() {
    assert_eq!(violations(1.0), [0; 5]);
}

#[test]
fn radii_ten_times_too_small_for_each_operation_would_be_noticed() {
    // The bounds are generous: it takes a factor to find them wrong.
    let wrong = violations(1.0 / 64.0);
    assert!(wrong.iter().all(|n| *n > 0), "{wrong:?}");
}

#[test]
fn exp_holds_its_series() {
    let mut random = Random(5);
    for _ in 0..60 {
        let x = random.number() % 3.0;
        let exact = rational(x);
        let (mut term, mut sum) = (rational(1.0), rational(1.0));
        for n in 1..60 {
            term = term * &exact / BigRational::from_integer(BigInt::from(n));
            sum += &term;
        }
        // What is left of the series is below 3⁶⁰/60! · e³ < 1e-50.
        let ball = Fine.exp(Ball::sum(x, 0.0));
        let [hi, _, radius] = ball.parts();
        assert!(holds(ball, &sum, 1.0), "{x}");
        assert!(radius < hi * 1e-25, "{x}: {radius}");
    }
}

#[test]
fn sin_and_cos_hold_their_series() {
    let mut random = Random(9);
    for _ in 0..12 {
        let x = random.number() % 9.0;
        let exact = rational(x);
        let mut term = rational(1.0);
        let mut sums = [rational(0.0), rational(1.0)];
        for n in 1..90 {
            term = term * &exact / BigRational::from_integer(BigInt::from(n));
            // sin takes the odd powers, cos the even ones; signs change every second power.
            let sum = &mut sums[usize::from(n % 2 == 0)];
            if n / 2 % 2 == 0 {
                *sum += &term;
            } else {
                *sum -= &term;
            }
        }
        // What is left of the series is below 9⁹⁰/90! < 1e-52.
        let x = Ball::sum(x, 0.0);
        for (ball, sum) in [Fine.sin(x), Fine.cos(x)].into_iter().zip(&sums) {
            let [_, _, radius] = ball.parts();
            assert!(holds(ball, sum, 1.0), "{x:?}");
            assert!(radius < 1e-28, "{x:?}: {radius}");
        }
    }
    // Far away the enclosures of f64 take over.
    let far = Fine.sin(Ball::sum(1e15, 0.0)).interval();
    assert!(far.contains(0.858_272_793_170_235_9) && far.width() < 1e-14);
}

#[test]
fn extremes_are_enclosed_by_anything() {
    for (a, b) in [(1e308, 1e308), (-1e308, 1e-320), (5e-324, 5e-324)] {
        let product = Fine.mul(Ball::sum(a, 0.0), Ball::sum(b, 0.0));
        assert!(holds(product, &(rational(a) * rational(b)), 1.0));
    }
    assert!(
        Fine.div(Ball::sum(1.0, 0.0), Ball::sum(0.0, 0.0))
            .1
            .undefined
    );
    assert!(Fine.sqrt(Ball::sum(-1.0, 0.0)).1.undefined);
    assert!(Fine.exp(Ball::sum(1e5, 0.0)).interval().hi == f64::INFINITY);
    assert!(Fine.exp(Ball::sum(-1e5, 0.0)).interval().lo >= -1e-290);
}
