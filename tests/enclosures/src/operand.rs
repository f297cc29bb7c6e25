//! Random operands that are hard: subnormal, near overflow, signed zeros, infinite bounds, powers of two.

use zeroset::interval::Interval;

/// A generator with a seed, so that failures repeat (splitmix64).
#[derive(Clone, Debug)]
pub struct Source(pub u64);

impl Source {
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in [0, n).
    pub fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * f64::EPSILON / 2.0
    }

    /// A finite double: half of them ordinary, half of them hard.
    pub fn number(&mut self) -> f64 {
        let sign = if self.bits() & 1 == 0 { 1.0 } else { -1.0 };
        let size = match self.below(12) {
            0..=3 => self.unit() * 10.0,
            4 | 5 => (self.unit() * 40.0 - 20.0).exp2(),
            6 => self.below(20) as f64,
            7 => f64::from_bits(self.below(1 << 52)),
            8 => f64::MAX * (1.0 - self.unit() * self.unit()),
            9 => {
                let power = f64::from_bits((1 + self.below(2045)) << 52);
                [power, power.next_up(), power.next_down()][self.below(3) as usize]
            }
            10 => {
                [0.0, f64::MIN_POSITIVE, f64::from_bits(1), f64::MAX, 1.0][self.below(5) as usize]
            }
            _ => f64::from_bits(self.below(0x7ff << 52)),
        };
        sign * size
    }

    /// An interval: half of them points, some with an infinite bound.
    pub fn interval(&mut self) -> Interval {
        let (x, y) = (self.number(), self.number());
        match self.below(10) {
            0..=4 => Interval { lo: x, hi: x },
            5 => Interval {
                lo: x,
                hi: f64::INFINITY,
            },
            6 => Interval {
                lo: f64::NEG_INFINITY,
                hi: x,
            },
            _ => Interval {
                lo: x.min(y),
                hi: x.max(y),
            },
        }
    }

    /// A finite member of an interval, a bound as often as not.
    pub fn member(&mut self, a: Interval) -> f64 {
        let candidate = match self.below(4) {
            0 => a.lo,
            1 => a.hi,
            2 => a.mid(),
            _ => self.number(),
        };
        if candidate.is_finite() && a.contains(candidate) {
            candidate
        } else {
            a.mid()
        }
    }
}
