//! Polynomials over segments, exactly: every value and derivative at points of the segment is enclosed.

use zeroset::interval::{Interval, Isa, Kernel, Packet, Polynomial};
use zeroset_enclosures::backend::load;
use zeroset_enclosures::exact::Exact;
use zeroset_enclosures::operand::Source;

/// One polynomial of N coefficients and one segment per lane.
struct Given<const N: usize> {
    middle: [f64; 8],
    coefficients: [[Interval; 8]; N],
    segment: [Interval; 8],
}

impl<const N: usize> Kernel for &Given<N> {
    type Output = [[Interval; 8]; 3];

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> [[Interval; 8]; 3] {
        let c = self.coefficients.map(|c| load(p, c));
        let of = Polynomial::new(p, p.lanes(self.middle), &c);
        let all = of.hulls::<3>(p, &load(p, self.segment));
        // The shorter answers are the same.
        let some = of.hulls::<2>(p, &load(p, self.segment));
        // What overflowed is no bound.
        let line = Interval {
            lo: p.splat(f64::NEG_INFINITY),
            hi: p.splat(f64::INFINITY),
        };
        let [f, d, dd, g, e] = [all[0], all[1], all[2], some[0], some[1]].map(|hull| Interval {
            lo: p.select(hull.finite, hull.range.lo, line.lo),
            hi: p.select(hull.finite, hull.range.hi, line.hi),
        });
        let both = [p.intersect(f, g).0, p.intersect(d, e).0, dd];
        both.map(|a| {
            let (lo, hi) = (p.to_array(a.lo), p.to_array(a.hi));
            std::array::from_fn(|lane| Interval {
                lo: lo[lane],
                hi: hi[lane],
            })
        })
    }
}

/// A coefficient: small whole numbers let terms cancel; some are huge or tiny, and some are wide.
fn coefficient(source: &mut Source) -> Interval {
    let x = match source.below(8) {
        0..=2 => source.below(17) as f64 - 8.0,
        3 => (source.unit() * 60.0 - 30.0).exp2(),
        4 => (source.unit() * 1800.0 - 1000.0).exp2(),
        5 => 0.0,
        _ => source.unit() * 8.0 - 4.0,
    };
    let w = match source.below(4) {
        0 => source.unit() * 0.1,
        1 => x.abs() * f64::EPSILON,
        _ => 0.0,
    };
    Interval { lo: x, hi: x + w }
}

fn given<const N: usize>(source: &mut Source) -> Given<N> {
    Given {
        middle: std::array::from_fn(|_| source.unit() * 2.0),
        coefficients: std::array::from_fn(|_| std::array::from_fn(|_| coefficient(source))),
        segment: std::array::from_fn(|_| {
            let lo = match source.below(3) {
                0 => source.below(8) as f64 / 2.0,
                _ => source.unit() * 4.0,
            };
            let width = match source.below(4) {
                0 => 0.0,
                1 => (-40.0 * source.unit()).exp2(),
                _ => source.unit(),
            };
            Interval { lo, hi: lo + width }
        }),
    }
}

/// f, f' and f'' at t.
fn values<const N: usize>(c: &[f64; N], middle: f64, t: f64) -> [Exact; 3] {
    let s = Exact::from(t).add(&Exact::from(middle).neg());
    [0usize, 1, 2].map(|order| {
        let mut sum = Exact::from(0.0);
        for k in (order..N).rev() {
            let factor: usize = (k + 1 - order..=k).product();
            let term = Exact::from(c[k]).mul(&Exact::from(factor as f64));
            sum = sum.mul(&s).add(&term);
        }
        sum
    })
}

/// Values outside of their enclosure.
fn violations<const N: usize>(isa: Isa, rounds: usize) -> usize {
    let mut source = Source(7 + N as u64);
    let mut count = 0;
    for _ in 0..rounds {
        let given = given::<N>(&mut source);
        let ranges = isa.run(&given);
        for lane in 0..8 {
            let segment = given.segment[lane];
            for t in [
                segment.lo,
                segment.hi,
                segment.mid(),
                segment.lo + source.unit() * (segment.hi - segment.lo),
            ] {
                let bits = source.bits();
                let c = std::array::from_fn::<f64, N, _>(|i| {
                    let c = given.coefficients[i][lane];
                    if bits >> i & 1 == 0 { c.lo } else { c.hi }
                });
                if !segment.contains(t) {
                    continue;
                }
                let all = values(&c, given.middle[lane], t);
                for (value, range) in all.iter().zip(ranges) {
                    count += usize::from(!value.is_in(range[lane].lo, range[lane].hi));
                }
            }
        }
    }
    count
}

fn all_degrees(isa: Isa, rounds: usize) -> usize {
    violations::<1>(isa, rounds)
        + violations::<2>(isa, rounds)
        + violations::<4>(isa, rounds)
        + violations::<5>(isa, rounds)
        + violations::<7>(isa, rounds)
        + violations::<10>(isa, rounds)
        + violations::<13>(isa, rounds)
}

#[test]
fn polynomials_are_enclosed() {
    for isa in Isa::available() {
        let rounds = if cfg!(miri) { 2 } else { 400 };
        assert_eq!(all_degrees(isa, rounds), 0, "{isa}");
    }
}

#[test]
fn negative_control_polynomials_without_rounding_are_missed() {
    for isa in Isa::unrounded() {
        let count = all_degrees(isa, 100);
        println!("{isa}: {count} violations");
        assert!(count > 100, "{isa}");
    }
}

/// (t − 1)³ − t over [0, 2]: the Bernstein coefficients are −1, 1/3, −7/3 and −1, and those of f' 2, −4 and 2.
#[test]
fn the_hull_is_that_of_the_bernstein_coefficients() {
    let expected = [(-7.0 / 3.0, 1.0 / 3.0), (-4.0, 2.0), (-6.0, 6.0)];
    for isa in Isa::available() {
        let c = [-1.0, -1.0, 0.0, 1.0];
        let given = Given {
            middle: [1.0; 8],
            coefficients: c.map(|c| [Interval::point(c); 8]),
            segment: [Interval::new(0.0, 2.0); 8],
        };
        for (range, (lo, hi)) in isa.run(&given).into_iter().zip(expected) {
            assert!(
                range[0].lo <= lo && range[0].lo > lo - 3e-13,
                "{isa}: {range:?}"
            );
            assert!(
                range[0].hi >= hi && range[0].hi < hi + 3e-13,
                "{isa}: {range:?}"
            );
        }
    }
}

/// What overflows is the line, not a number and not nothing.
#[test]
fn what_overflows_is_the_line() {
    for isa in Isa::available() {
        let mut given = Given {
            middle: [0.0; 8],
            coefficients: [[Interval::point(f64::MAX); 8]; 5],
            segment: [Interval::new(3.0, 4.0); 8],
        };
        given.coefficients[2] = [Interval {
            lo: f64::NEG_INFINITY,
            hi: 1.0,
        }; 8];
        for range in isa.run(&given) {
            assert_eq!(
                (range[0].lo, range[0].hi),
                (f64::NEG_INFINITY, f64::INFINITY),
                "{isa}"
            );
        }
    }
}
