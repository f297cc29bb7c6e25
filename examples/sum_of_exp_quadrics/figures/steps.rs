//! The second figure: what one step of a contractor leaves of T.

use zeroset::contract::{Around, halley_step, newton_step, tightened_slope};
use zeroset::interval::{Interval, Scalar};

use super::function::RayFunction;

/// The names of the steps, in the order of [`remainders`].
pub const NAMES: [&str; 3] = ["newton", "newton2", "halley"];

/// What one step from the middle of T leaves.
pub struct Remainder {
    /// The widths of all pieces together, over the width of T.
    pub share: f64,
    /// Pieces: 0, 1 or 2.
    pub pieces: usize,
}

/// One step each, by the tracer's own code, from the middle of T and on staged enclosures: Newton with f'(T), Newton
/// with f'(T) ∩ (f'(m) + f''(T)(T − m)), and Halley with f''(T). No range of f excludes before, nothing is halved after.
pub fn remainders(f: &RayFunction, t: Interval) -> [Remainder; 3] {
    let m = t.mid();
    let at_m = f.slope_at(m);
    let jet = f.curvature(t);
    let tight = tightened_slope(Scalar, &t, m, &jet, &at_m[1], true);
    let newton = newton_step(Scalar, &t, m, &at_m[0], &jet.d[1], true);
    let newton2 = newton_step(Scalar, &t, m, &at_m[0], &tight, true);
    let mut halley = Around::all(Scalar, &t, m);
    halley_step(Scalar, &t, m, &at_m, &jet.d[2], true, &mut halley);
    [newton, newton2, halley].map(|step| remainder(&step, t))
}

fn remainder(step: &Around<Scalar>, t: Interval) -> Remainder {
    // Without a gap in the middle the two sides are one piece.
    let sides = if step.right <= step.left {
        vec![step.hi - step.lo]
    } else {
        vec![step.left - step.lo, step.hi - step.right]
    };
    let widths: Vec<f64> = sides.into_iter().filter(|w| *w >= 0.0).collect();
    Remainder {
        share: widths.iter().sum::<f64>() / t.width(),
        pieces: widths.len(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::function::functions;
    use super::*;

    #[test]
    fn no_step_loses_the_root_and_none_leaves_more_than_all() {
        for f in functions().iter().step_by(8) {
            for &t in &f.segments {
                for r in remainders(f, t) {
                    assert!(r.pieces > 0 && r.share <= 1.0 + 1e-9);
                }
            }
        }
    }

    /// On narrow segments the remainders of Newton shrink with the width, those of Halley with its square.
    #[test]
    fn orders_of_convergence_are_newtons_and_halleys() {
        let f = &functions()[3];
        let [wide, narrow] = [8, 12].map(|k| remainders(f, f.segments[k]));
        assert!(narrow[0].share < wide[0].share);
        assert!(narrow[2].share < narrow[0].share);
    }
}
