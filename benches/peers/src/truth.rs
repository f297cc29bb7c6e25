//! The truth about a ray, by means that share nothing with the library: a dense march in plain `f64` over the formula as
//! written by hand, with a search wherever f turns back towards 0, and bisection.

/// Steps along a ray.
pub const STEPS: u32 = 2048;

/// z of the first root from z = 1 down to z = −1 of f along the ray at (x, y).
pub fn first(f: &dyn Fn([f64; 3]) -> f64, [x, y]: [f64; 2], steps: u32) -> Option<f64> {
    let f = |z: f64| f([x, y, z]);
    let at = |k: u32| 1.0 - 2.0 * f64::from(k) / f64::from(steps);
    let mut before = [(1.0, f(1.0)); 2];
    for k in 1..=steps {
        let here = (at(k), f(at(k)));
        let [a, b] = before;
        let side = b.1.signum();
        if here.1.signum() != side || here.1 == 0.0 {
            return Some(bisect(&f, b.0, here.0));
        }
        let turns = a.1.signum() == side && b.1.abs() < a.1.abs() && b.1.abs() <= here.1.abs();
        if turns && let Some(beyond) = dip(&|z| side * f(z), here.0, a.0) {
            return Some(bisect(&f, a.0, beyond));
        }
        before = [b, here];
    }
    None
}

/// Where g is not positive in [lo, hi], where it has one minimum; by the golden section.
fn dip(g: &dyn Fn(f64) -> f64, mut lo: f64, mut hi: f64) -> Option<f64> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut c, mut d) = (hi - GOLDEN * (hi - lo), lo + GOLDEN * (hi - lo));
    let (mut gc, mut gd) = (g(c), g(d));
    for _ in 0..50 {
        if gc <= 0.0 {
            return Some(c);
        }
        if gd <= 0.0 {
            return Some(d);
        }
        if gc < gd {
            (hi, d, gd) = (d, c, gc);
            c = hi - GOLDEN * (hi - lo);
            gc = g(c);
        } else {
            (lo, c, gc) = (c, d, gd);
            d = lo + GOLDEN * (hi - lo);
            gd = g(d);
        }
    }
    None
}

/// The sign change between `front` and `back`, until no number lies between.
fn bisect(f: &dyn Fn(f64) -> f64, mut front: f64, mut back: f64) -> f64 {
    let side = f(front).signum();
    loop {
        let middle = 0.5 * (front + back);
        if middle == front || middle == back {
            return middle;
        }
        let value = f(middle);
        if value == 0.0 {
            return middle;
        }
        if value.signum() == side {
            front = middle;
        } else {
            back = middle;
        }
    }
}
