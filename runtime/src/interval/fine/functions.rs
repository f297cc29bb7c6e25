//! Functions of balls.

use super::ball::{Ball, TINY};
use crate::interval::{Arithmetic, Lanes, Scalar};

impl Ball {
    /// e^x = 2^k · (e^(r/512))^512 with r = x − k·ln 2, |r| ≤ 0.36. Taylor's polynomial of degree 9 at |s| ≤ 0.36/512
    /// has a remainder below |s|¹⁰/10! · e^|s| < 10⁻³⁸.
    #[inline(never)]
    pub fn exp(self) -> Ball {
        /// ln 2 = 0.6931471805599453 + 2.3190468138462996·10⁻¹⁷ + less than 6·10⁻³⁴.
        const LN_2: Ball = Ball {
            hi: f64::from_bits(0x3fe62e42fefa39ef),
            lo: f64::from_bits(0x3c7abc9e3b39803f),
            radius: 6e-34,
        };
        let whole = (self.hi / std::f64::consts::LN_2).round();
        let near = self.radius < 1e-3 && whole.abs() < 900.0;
        if !near {
            return Ball::from_interval(&Scalar.exp(self.interval()));
        }
        let r = self.subtract(LN_2.multiply(Ball::exact(whole)));
        let s = Ball {
            hi: r.hi / 512.0,
            lo: r.lo / 512.0,
            radius: r.radius / 512.0,
        };
        // 9! times the polynomial has whole coefficients: 9!/n!
        let (mut sum, mut coefficient) = (Ball::exact(1.0), 1.0);
        for n in (1..=9).rev() {
            coefficient *= f64::from(n);
            sum = Ball::exact(coefficient).add(s.multiply(sum));
        }
        let mut sum = sum.over(coefficient);
        sum.radius += 1e-38;
        for _ in 0..9 {
            sum = sum.multiply(sum);
        }
        // The library's powi promises no exact result.
        let scale = Scalar.pow2(whole);
        Ball::new(sum.hi * scale, sum.lo * scale, sum.radius * scale + TINY)
    }

    /// sin a and cos a at r = a − k·π/2, |r| ≤ 0.8, by Taylor's polynomials of degree 31 and 30: their remainders are
    /// below 0.8³³/33! and 0.8³²/32!, both less than 10⁻³⁸. Nothing for large or wide arguments.
    #[inline(never)]
    fn reduced_sin_cos(self) -> Option<[Ball; 2]> {
        /// π/2 = 1.5707963267948966 + 6.123233995736766·10⁻¹⁷ − 1.4973849048591833·10⁻³³ + …
        const HALF_PI: Ball = Ball {
            hi: f64::from_bits(0x3ff921fb54442d18),
            lo: f64::from_bits(0x3c91a62633145c07),
            radius: 1.5e-33,
        };
        let whole = (self.hi / std::f64::consts::FRAC_PI_2).round();
        let r = self.subtract(HALF_PI.multiply(Ball::exact(whole)));
        if whole.abs() > 1e6 || self.radius > 1e-3 || r.most() > 0.8 {
            return None;
        }
        let square = r.multiply(r);
        let series = |last: i32| {
            let mut sum = Ball::exact(1.0);
            for n in (1..=last).rev().step_by(2) {
                // 1 − r²/(n(n − 1)) · (1 − …), from n = last down to 3 or 2.
                if n < 2 {
                    break;
                }
                let step = square.over(f64::from(n * (n - 1)));
                sum = Ball::exact(1.0).subtract(step.multiply(sum));
            }
            sum
        };
        let (mut sin, mut cos) = (r.multiply(series(31)), series(30));
        sin.radius += 1e-38;
        cos.radius += 1e-38;
        Some(match whole.rem_euclid(4.0) as u8 {
            0 => [sin, cos],
            1 => [cos, sin.negate()],
            2 => [sin.negate(), cos.negate()],
            _ => [cos.negate(), sin],
        })
    }

    /// sin a and cos a
    pub fn sin_cos(self) -> [Ball; 2] {
        let coarse = || {
            Scalar
                .sin_cos(self.interval())
                .map(|a| Ball::from_interval(&a))
        };
        self.reduced_sin_cos().unwrap_or_else(coarse)
    }
}
