//! Linear and quadratic leaves over segments and at points, recentring, and Newton's division, exactly.

use zeroset::interval::{At, Interval, Isa, Kernel, Linear, Packet, Parameter, Quadratic, Scalar};
use zeroset_enclosures::backend::load;
use zeroset_enclosures::exact::Exact;
use zeroset_enclosures::fixture::steps;
use zeroset_enclosures::operand::Source;

/// One leaf and one segment per lane.
struct Leaf {
    coefficients: [[Interval; 8]; 3],
    segment: [Interval; 8],
}

/// Ranges per lane: quadratic, its slope and curvature, linear; over the segment and at its end.
struct Ranges {
    segment: [[Interval; 8]; 4],
    point: [[Interval; 8]; 4],
}

impl Kernel for &Leaf {
    type Output = Ranges;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Ranges {
        let [c0, c1, c2] = self.coefficients.map(|c| load(p, c));
        let quadratic = Quadratic::new(p, c0, c1, c2);
        let linear = Linear::new(p, c0, c1);
        let segment = load(p, self.segment);
        let point = At(segment.hi);
        Ranges {
            segment: [
                store(p, segment.quadratic(p, &quadratic)),
                store(p, segment.quadratic_slope(p, &quadratic)),
                store(p, segment.quadratic_curvature(p, &quadratic)),
                store(p, segment.linear(p, &linear)),
            ],
            point: [
                store(p, point.quadratic(p, &quadratic)),
                store(p, point.quadratic_slope(p, &quadratic)),
                store(p, point.quadratic_curvature(p, &quadratic)),
                store(p, point.linear(p, &linear)),
            ],
        }
    }
}

fn store<P: Packet>(p: P, a: Interval<P::F>) -> [Interval; 8] {
    let (lo, hi) = (p.to_array(a.lo), p.to_array(a.hi));
    std::array::from_fn(|lane| Interval {
        lo: lo[lane],
        hi: hi[lane],
    })
}

/// A coefficient: a point or a narrow interval, of moderate size; now and then a large, a tiny or an unbounded one.
fn coefficient(source: &mut Source) -> Interval {
    let sign = if source.below(2) == 0 { 1.0 } else { -1.0 };
    match source.below(30) {
        0 => return Interval::point(sign * (source.unit() * 63.0 + 960.0).exp2() * 1.9),
        1 => return Interval::point(sign * (source.unit() * 70.0 - 1074.0).exp2()),
        2 => {
            let x = source.unit() * 8.0 - 4.0;
            return if sign < 0.0 {
                Interval::new(f64::NEG_INFINITY, x)
            } else {
                Interval::new(x, f64::INFINITY)
            };
        }
        _ => {}
    }
    let x = match source.below(6) {
        0 => source.below(9) as f64 - 4.0,
        1 => (source.unit() * 60.0 - 30.0).exp2(),
        2 => 0.0,
        _ => source.unit() * 8.0 - 4.0,
    };
    let w = if source.below(2) == 0 {
        0.0
    } else {
        source.unit() * 0.1
    };
    Interval { lo: x, hi: x + w }
}

fn leaf(source: &mut Source) -> Leaf {
    Leaf {
        coefficients: std::array::from_fn(|_| std::array::from_fn(|_| coefficient(source))),
        segment: std::array::from_fn(|_| {
            // From the entry on, near it, or far away.
            let scale = [1.0, 1.0, 1.0, 1e-300, 1e-9, 1e18][source.below(6) as usize];
            let start = [0.0, source.unit() * 4.0][source.below(4).min(1) as usize];
            let width = [0.0, source.unit() * 4.0][source.below(4).min(1) as usize];
            Interval {
                lo: start * scale,
                hi: (start + width) * scale,
            }
        }),
    }
}

/// Exact values of the four functions at t.
fn values(c: [f64; 3], t: f64) -> [Exact; 4] {
    let [c0, c1, c2] = c.map(Exact::from);
    let (t, two) = (Exact::from(t), Exact::from(2.0));
    let twice = two.mul(&c2);
    [
        c0.add(&t.mul(&c1.add(&t.mul(&c2)))),
        c1.add(&twice.mul(&t)),
        twice,
        c0.add(&c1.mul(&t)),
    ]
}

/// The numerator and the denominator of t are small, so the vertex −c₁/2c₂ is met only to a rounding: near enough to
/// lie outside of a range that leaves the extreme value out.
fn samples(source: &mut Source, c: [f64; 3], segment: Interval) -> Vec<f64> {
    let vertex = -c[1] / (2.0 * c[2]);
    let mut ts = vec![
        segment.lo,
        segment.hi,
        segment.mid(),
        segment.lo + source.unit() * (segment.hi - segment.lo),
    ];
    ts.extend([vertex, vertex.next_up(), vertex.next_down()]);
    ts.retain(|&t| segment.contains(t));
    ts
}

fn violations(isa: Isa, rounds: usize) -> usize {
    let mut source = Source(99);
    let mut count = 0;
    for _ in 0..rounds {
        let leaf = leaf(&mut source);
        let ranges = isa.run(&leaf);
        for lane in 0..8 {
            let choice = source.bits();
            let c = [0, 1, 2].map(|i| {
                let c = leaf.coefficients[i][lane];
                let x = if choice >> i & 1 == 0 { c.lo } else { c.hi };
                x.clamp(f64::MIN, f64::MAX)
            });
            let segment = leaf.segment[lane];
            for t in samples(&mut source, c, segment) {
                for (value, range) in values(c, t).iter().zip(ranges.segment) {
                    count += !value.is_in(range[lane].lo, range[lane].hi) as usize;
                }
            }
            for (value, range) in values(c, segment.hi).iter().zip(ranges.point) {
                count += !value.is_in(range[lane].lo, range[lane].hi) as usize;
            }
        }
    }
    count
}

#[test]
fn leaves_are_enclosed() {
    for isa in Isa::available() {
        assert_eq!(
            violations(isa, if cfg!(miri) { 10 } else { 1500 }),
            0,
            "{isa}"
        );
    }
}

#[test]
fn negative_control_leaves_without_rounding_are_missed() {
    for isa in Isa::unrounded() {
        let count = violations(isa, 1500);
        println!("{isa}: {count} violations");
        assert!(count > 0, "{isa}");
    }
}

/// (t − 1)(t − 2) over [0, 4]: the vertex at 3/2 counts; over [2, 4] it does not.
#[test]
fn vertices_count_only_inside() {
    for isa in Isa::available() {
        let leaf = Leaf {
            coefficients: [
                [Interval::point(2.0); 8],
                [Interval::point(-3.0); 8],
                [Interval::ONE; 8],
            ],
            segment: std::array::from_fn(|lane| {
                Interval::new(
                    [0.0, 2.0, 0.0, 1.5][lane % 4],
                    [4.0, 4.0, 1.0, 1.5][lane % 4],
                )
            }),
        };
        let expected = [(-0.25, 6.0), (0.0, 6.0), (0.0, 2.0), (-0.25, -0.25)];
        let [ranges, ..] = isa.run(&leaf).segment;
        for (range, (lo, hi)) in ranges.iter().zip(expected) {
            assert!(
                (lo - range.lo).abs() < 1e-14 && (range.hi - hi).abs() < 1e-14,
                "{isa}: {range:?} for [{lo}, {hi}]"
            );
            assert!(range.lo <= lo && hi <= range.hi, "{isa}");
        }
    }
}

/// entry·d + o, one per lane.
struct Recentre([[f64; 8]; 3]);

impl Kernel for &Recentre {
    type Output = [Interval; 8];
    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> [Interval; 8] {
        let [entry, d, o] = self.0.map(|x| p.lanes(x));
        store(p, p.recentre(entry, d, o))
    }
}

#[test]
fn recentring_far_origins_is_tight() {
    let mut source = Source(3);
    for isa in Isa::available() {
        let mut worst = 0;
        for _ in 0..2000 {
            // An origin far away whose ray comes near 0: the sum cancels down to what the product rounded off.
            let mut operands = [[0.0; 8]; 3];
            #[allow(clippy::needless_range_loop)]
            for lane in 0..8 {
                let (entry, d) = ((source.unit() * 60.0).exp2(), source.unit() * 2.0 - 1.0);
                let offset = source.unit() * (source.unit() * 60.0 - 40.0).exp2();
                operands[0][lane] = entry;
                operands[1][lane] = d;
                operands[2][lane] = if source.below(8) == 0 {
                    -entry * d
                } else {
                    offset - entry * d
                };
            }
            let found = isa.run(&Recentre(operands));
            for lane in 0..8 {
                let [entry, d, o] = [0, 1, 2].map(|i| Exact::from(operands[i][lane]));
                let value = entry.mul(&d).add(&o);
                assert!(value.is_in(found[lane].lo, found[lane].hi), "{isa}");
                if found[lane].lo > 1e-290 {
                    worst = worst.max(steps(found[lane]));
                }
            }
        }
        println!("{isa}: at most {worst} units wide");
        assert!(worst <= 3, "{isa}: {worst}");
    }
}

#[test]
fn newton_division_keeps_every_quotient() {
    let p = Scalar;
    let mut source = Source(11);
    for _ in 0..20_000 {
        let (num, den) = (source.interval(), source.interval());
        let (first, second, two, empty) = p.div_ext(num, den);
        let (x, d) = (source.member(num), source.member(den));
        if empty {
            assert!(den.lo == 0.0 && den.hi == 0.0 && !num.contains(0.0));
            continue;
        }
        if d == 0.0 {
            continue;
        }
        let holds = |piece: Interval| {
            // lo ≤ x/d ≤ hi
            let (x, d) = (Exact::from(x), Exact::from(d));
            let above = !piece.lo.is_finite()
                || x.add(&Exact::from(piece.lo).mul(&d).neg()).sign() * d.sign() >= 0;
            let below = !piece.hi.is_finite()
                || Exact::from(piece.hi).mul(&d).add(&x.neg()).sign() * d.sign() >= 0;
            above && below
        };
        assert!(
            holds(first) || (two && holds(second)),
            "{x:e} ∈ {num:?} by {d:e} ∈ {den:?}: {first:?} {second:?} {two}"
        );
    }
    let (first, second, two, _) = p.div_ext(Interval::new(1.0, 2.0), Interval::new(-1.0, 4.0));
    assert!(two && first.hi == -1.0 && second.lo == 0.25);
    let (first, second, two, _) = p.div_ext(Interval::new(-2.0, -1.0), Interval::new(-1.0, 4.0));
    assert!(two && first.hi == -0.25 && second.lo == 1.0);
}
