//! The singular points of a surface in a cube, by subdivision on f and its gradient.

use zeroset::Surface;
use zeroset::interval::{Arithmetic, Interval, Scalar};

type Cell = [Interval; 3];

/// What is found in a cube.
#[derive(Clone, Debug, Default)]
pub struct Found {
    /// A box around each critical point of f at which f may be 0. All singular points of the surface are in these.
    pub nodes: Vec<Cell>,
    /// The greatest |f| that these boxes leave possible.
    pub doubt: f64,
    /// Cells that were looked at.
    pub cells: u64,
    /// Cells in which nothing was decided: singular points that are not isolated, or degenerate.
    pub open: u64,
}

/// Cells this small are not divided further.
const SMALLEST: f64 = 1e-6;
/// More than rounding leaves of a critical point's place.
const CLOSE: f64 = 1e-11;

/// Divides the cube of this half width until each cell is excluded (f or a component of its gradient has no zero there)
/// or holds exactly one critical point; this is then enclosed as narrowly as `f64` can, and kept if f may be 0 there.
pub fn nodes<S: Surface>(surface: &S, half: f64) -> Found {
    let prepared = surface.prepare();
    let mut found = Found::default();
    // Not quite symmetric: nodes like to be on planes of symmetry, which should be no cells' faces.
    let side = Interval {
        lo: -half * 1.001,
        hi: half * 1.002,
    };
    let mut stack = vec![[side; 3]];
    while let Some(cell) = stack.pop() {
        found.cells += 1;
        match look::<S>(&prepared, cell) {
            Look::Free => {}
            Look::One(point) => keep::<S>(&prepared, point, &mut found),
            Look::Less(rest) => {
                let ((_, before), (axis, widest)) = (widest(&cell), widest(&rest));
                if widest < 0.5 * before {
                    stack.push(rest);
                    continue;
                }
                if before < SMALLEST {
                    found.open += 1;
                    continue;
                }
                let cut = rest[axis].lo + widest * (509.0 / 1024.0);
                let (mut left, mut right) = (rest, rest);
                left[axis].hi = cut;
                right[axis].lo = cut;
                stack.extend([right, left]);
            }
        }
    }
    found
}

enum Look {
    /// No singular point.
    Free,
    /// One critical point near the cell, in this box.
    One(Cell),
    /// All singular points of the cell are in this part of it.
    Less(Cell),
}

fn look<S: Surface>(prepared: &S::Prepared, cell: Cell) -> Look {
    let a = Scalar;
    let [f, slope @ ..] = S::gradient(a, prepared, cell).d;
    let has_zero = |x: &Interval| x.contains(0.0);
    if !has_zero(&f) || !slope.iter().all(has_zero) {
        return Look::Free;
    }
    let centre = cell.map(|x| point(x.mid()));
    let away = [0, 1, 2].map(|k| a.sub(cell[k], centre[k]));
    let at_centre = S::gradient(a, prepared, centre).d[0];
    if !has_zero(&a.add(at_centre, dot(&slope, &away))) {
        return Look::Free;
    }
    let at = S::hessian(a, prepared, centre).d;
    // Over a little more than the cell: a zero on a face lies inside then.
    let around = cell.map(|x| {
        let more = 0.05 * x.width() + CLOSE;
        Interval {
            lo: x.lo - more,
            hi: x.hi + more,
        }
    });
    let over = S::hessian(a, prepared, around).d;
    let away = [0, 1, 2].map(|k| a.sub(around[k], centre[k]));
    // The mean value form of the gradient.
    let h = square(&over);
    let gradient = [at[1], at[2], at[3]];
    let slopes = [0, 1, 2].map(|k| a.add(gradient[k], dot(&h[k], &away)));
    if !slopes.iter().all(has_zero) {
        return Look::Free;
    }
    let Some(y) = inverse(&square(&at).map(|row| row.map(|x| x.mid()))) else {
        return Look::Less(cell);
    };
    let image = krawczyk(&centre, &gradient, &h, &y, &away);
    if (0..3).all(|k| around[k].lo < image[k].lo && image[k].hi < around[k].hi) {
        return Look::One(image);
    }
    let mut rest = cell;
    for k in 0..3 {
        match cell[k].intersect(&image[k]) {
            Some(part) => rest[k] = part,
            None => return Look::Free,
        }
    }
    Look::Less(rest)
}

/// c − Y·g(c) + (I − Y·H)·(X − c): it holds all zeros of g in X, and exactly one if it lies inside X.
fn krawczyk(
    c: &Cell,
    g: &[Interval; 3],
    h: &[[Interval; 3]; 3],
    y: &[[f64; 3]; 3],
    away: &[Interval; 3],
) -> Cell {
    let a = Scalar;
    [0, 1, 2].map(|i| {
        let row = y[i].map(point);
        let rest = [0, 1, 2].map(|j| {
            let yh = dot(&row, &[h[0][j], h[1][j], h[2][j]]);
            a.sub(point(f64::from(u8::from(i == j))), yh)
        });
        a.add(a.sub(c[i], dot(&row, g)), dot(&rest, away))
    })
}

/// Narrows the box of a critical point, and keeps it if f may be 0 there and it is a new one.
fn keep<S: Surface>(prepared: &S::Prepared, mut cell: Cell, found: &mut Found) {
    let a = Scalar;
    for _ in 0..6 {
        let centre = cell.map(|x| point(x.mid()));
        let at = S::hessian(a, prepared, centre).d;
        let away = [0, 1, 2].map(|k| a.sub(cell[k], centre[k]));
        let h = square(&S::hessian(a, prepared, cell).d);
        if let Some(y) = inverse(&square(&at).map(|row| row.map(|x| x.mid()))) {
            let image = krawczyk(&centre, &[at[1], at[2], at[3]], &h, &y, &away);
            for k in 0..3 {
                cell[k] = cell[k].intersect(&image[k]).unwrap_or(cell[k]);
            }
        }
    }
    let centre = cell.map(|x| point(x.mid()));
    let away = [0, 1, 2].map(|k| a.sub(cell[k], centre[k]));
    let at = S::gradient(a, prepared, centre).d[0];
    let [_, slope @ ..] = S::gradient(a, prepared, cell).d;
    let f = a.add(at, dot(&slope, &away));
    let known = |other: &Cell| (0..3).all(|k| other[k].intersect(&cell[k]).is_some());
    if f.contains(0.0) && !found.nodes.iter().any(known) {
        found.doubt = found.doubt.max(f.hi).max(-f.lo);
        found.nodes.push(cell);
    }
}

fn point(x: f64) -> Interval {
    Interval { lo: x, hi: x }
}

fn dot(u: &[Interval; 3], v: &[Interval; 3]) -> Interval {
    let a = Scalar;
    let [x, y, z] = [0, 1, 2].map(|k| a.mul(u[k], v[k]));
    a.add(a.add(x, y), z)
}

/// The Hessian of `[f, f_x, f_y, f_z, f_xx, f_xy, f_xz, f_yy, f_yz, f_zz]`.
fn square(d: &[Interval; 10]) -> [[Interval; 3]; 3] {
    [[d[4], d[5], d[6]], [d[5], d[7], d[8]], [d[6], d[8], d[9]]]
}

/// The inverse of a matrix in plain floats.
fn inverse(m: &[[f64; 3]; 3]) -> Option<[[f64; 3]; 3]> {
    let minor = |i: usize, j: usize| {
        let [r, s] = [(i + 1) % 3, (i + 2) % 3];
        let [u, v] = [(j + 1) % 3, (j + 2) % 3];
        m[r][u] * m[s][v] - m[r][v] * m[s][u]
    };
    let determinant: f64 = (0..3).map(|j| m[0][j] * minor(0, j)).sum();
    let inverse = [0, 1, 2].map(|i| [0, 1, 2].map(|j| minor(j, i) / determinant));
    let finite = inverse.iter().flatten().all(|x| x.is_finite());
    finite.then_some(inverse)
}

fn widest(cell: &Cell) -> (usize, f64) {
    let widths = cell.map(|x| x.width());
    let axis = (1..3).fold(0, |best, k| if widths[k] > widths[best] { k } else { best });
    (axis, widths[axis])
}
