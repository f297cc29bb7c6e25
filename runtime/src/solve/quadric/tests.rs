//! Every claim against whole numbers: t is a multiple of 2⁻⁵² below 4, so f is one of 2⁻¹⁰⁴, exactly.

use super::closed_form;
use crate::interval::{Interval, Isa, Kernel, Packet, Quadratic};

const UNIT: f64 = 1.0 / (1u64 << 52) as f64;

/// c₀ + c₁t + c₂t² with whole coefficients below 2⁹.
#[derive(Clone, Copy, Debug)]
struct Form([i128; 3]);

impl Form {
    fn sign(&self, t: f64) -> i128 {
        let Form([c0, c1, c2]) = *self;
        let k = (t / UNIT) as i128;
        ((c0 << 104) + ((c1 * k) << 52) + c2 * k * k).signum()
    }

    /// How many roots lie in [a, b], neither of which is one.
    fn roots(&self, a: f64, b: f64) -> usize {
        let Form([c0, c1, c2]) = *self;
        if self.sign(a) != self.sign(b) {
            return 1;
        }
        // The vertex is at −c₁/2c₂.
        let beyond = |t: f64| -(c1 << 52) - 2 * c2 * (t / UNIT) as i128;
        let inside = beyond(a).signum() * beyond(b).signum() < 0;
        let turns = inside && self.sign(a) == c2.signum();
        match (c1 * c1 - 4 * c0 * c2).signum() {
            1 if turns => 2,
            0 if turns => 1,
            _ => 0,
        }
    }
}

/// Numbers that look random.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
    fn below(&mut self, n: u64) -> u64 {
        (self.next() >> 11) % n
    }
    fn form(&mut self) -> Form {
        let mut any = || self.below(1023) as i128 - 511;
        let [c0, c1, c2] = [any(), any(), any()];
        // Every other one touches 0 between 1 and 4, or nearly.
        match self.below(2) {
            0 => Form([c0, c1, c2]),
            _ => {
                let (m, n) = (2 + self.below(6) as i128, 1 + self.below(7) as i128);
                let sign = 1 - 2 * self.below(2) as i128;
                let near = self.below(5) as i128 - 2;
                // n(2t − m)² + near
                Form([sign * (n * m * m + near), -4 * sign * n * m, 4 * sign * n])
            }
        }
    }
    /// In [1, 4), not a multiple of ½ as roots are.
    fn t(&mut self) -> f64 {
        1.0 + (self.below(3 << 40) | 1) as f64 / (1u64 << 40) as f64
    }
}

#[derive(Default, Debug)]
struct Seen {
    first: usize,
    second: usize,
    none: usize,
    open: usize,
    wrong: usize,
}

/// Judges some packets; the control moves what is claimed by 2⁻⁴⁰ of itself.
struct Judge {
    moved: bool,
}

impl Kernel for Judge {
    type Output = Seen;
    const IN_PARTS: bool = true;

    fn run<P: Packet>(self, p: P) -> Seen {
        let mut numbers = Numbers(88172645463325252);
        let mut seen = Seen::default();
        for _ in 0..4000 {
            let forms: [Form; 8] = core::array::from_fn(|_| numbers.form());
            let ends: [[f64; 2]; 8] = core::array::from_fn(|_| {
                let (a, b) = (numbers.t(), numbers.t());
                [a.min(b), a.max(b)]
            });
            for part in 0..P::PARTS {
                self.judge(p.part(part), &forms, &ends, &mut seen);
            }
        }
        seen
    }
}

impl Judge {
    fn judge<P: Packet>(&self, p: P, forms: &[Form; 8], ends: &[[f64; 2]; 8], seen: &mut Seen) {
        let c = |k: usize| p.point(p.lanes(forms.map(|form| form.0[k] as f64)));
        let leaf = Quadratic::new(p, c(0), c(1), c(2));
        let over = Interval {
            lo: p.lanes(ends.map(|e| e[0])),
            hi: p.lanes(ends.map(|e| e[1])),
        };
        let closed = closed_form(p, &leaf, &over, p.not(p.none()));
        let (decided, hit) = (p.bits(closed.decided), p.bits(closed.hit));
        let [lo, hi] = [closed.root.lo, closed.root.hi].map(|x| p.to_array(x));
        let resume = p.to_array(closed.resume);
        for lane in p.own() {
            let (form, [a, b]) = (&forms[lane], ends[lane]);
            let scale = if self.moved { 1.0 + 1e-12 } else { 1.0 };
            let (lo, hi) = (lo[lane] * scale, hi[lane] * scale);
            // Without a root before it, the first root is in the interval, and none behind it up to the end of the claim.
            let right = if decided >> lane & 1 == 0 {
                seen.open += 1;
                true
            } else if hit >> lane & 1 == 0 {
                seen.none += 1;
                form.roots(a, b) == 0
            } else {
                let second = form.roots(a, b) == 1 && form.roots(1e-9, a) == 1;
                *(if second {
                    &mut seen.second
                } else {
                    &mut seen.first
                }) += 1;
                let within = a <= lo && hi <= b && resume[lane] >= hi;
                // Exact roots may be its ends.
                let before = lo == a || form.sign(lo) == 0 || form.roots(a, lo) == 0;
                let behind = form.sign(hi) == 0 || form.roots(hi, resume[lane]) == 0;
                let there = form.sign(lo) * form.sign(hi) <= 0;
                within && before && behind && there && hi - lo < 1e-12
            };
            seen.wrong += usize::from(!right);
        }
    }
}

#[test]
fn closed_forms_claim_what_whole_numbers_confirm() {
    for isa in Isa::available() {
        let seen = isa.run(Judge { moved: false });
        assert_eq!(seen.wrong, 0, "{isa}: {seen:?}");
        assert!(
            seen.first > 2000 && seen.second > 1000 && seen.none > 10_000,
            "{seen:?}"
        );
        assert!(seen.open < 1200, "{isa}: {seen:?}");
        let control = isa.run(Judge { moved: true });
        assert!(control.wrong > 3000, "{isa}: {control:?}");
    }
}
