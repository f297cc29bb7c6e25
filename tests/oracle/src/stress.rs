//! Rays that are hard: tangent within an ulp, parallel to axes and faces, from on, inside and far away from a surface.

use zeroset::camera::{Ray, Sampling};
use zeroset::interval::Isa;
use zeroset::verdict::{Answer, Verdict};

use crate::picture::Picture;

/// A generator of its own for the rays: always the same.
struct Random(u64);

impl Random {
    fn number(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        from + (to - from) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn point(&mut self, size: f64) -> [f64; 3] {
        std::array::from_fn(|_| self.number(-size, size))
    }
}

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
    Ray {
        origin: origin.into(),
        direction: direction.into(),
    }
}

/// `steps` floats further up, or down if negative.
fn nudge(x: f64, steps: i32) -> f64 {
    let next = if steps > 0 {
        f64::next_up
    } else {
        f64::next_down
    };
    (0..steps.abs()).fold(x, |x, _| next(x))
}

/// Rays that touch the sphere of this radius about 0, as nearly as floats permit, and some that pass an ulp or a few
/// inside or outside. Some along the axes, most at an angle.
pub fn tangents(radius: f64, count: usize) -> Vec<Ray> {
    let mut random = Random(7);
    let mut all = Vec::new();
    for steps in -3..=3 {
        let r = nudge(radius, steps);
        all.push(ray([r, 0.0, -3.0], [0.0, 0.0, 1.0]));
        all.push(ray([0.0, -r, 2.0], [0.0, 0.0, -1.0]));
        all.push(ray([-5.0, 0.0, r], [0.5, -0.0, 0.0]));
        all.push(ray([r * 0.6, r * 0.8, 4.0], [0.0, 0.0, -0.25]));
    }
    for i in 0..count {
        let n = random.point(1.0);
        let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
        let n = n.map(|x| x / length);
        // Any other vector's part across n is a tangent there.
        let v = random.point(1.0);
        let along: f64 = (0..3).map(|k| v[k] * n[k]).sum();
        let d: [f64; 3] = std::array::from_fn(|k| v[k] - along * n[k]);
        let back = random.number(1.0, 4.0);
        let mut o: [f64; 3] = std::array::from_fn(|k| radius * n[k] - back * d[k]);
        o[i % 3] = nudge(o[i % 3], (i % 7) as i32 - 3);
        all.push(ray(o, d));
    }
    all
}

/// Rays with directions along axes and in coordinate planes (0 and −0), from all around and from faces and corners of
/// the box [−1, 1]³, through its edges and along its faces.
pub fn parallels(count: usize) -> Vec<Ray> {
    let mut random = Random(11);
    let mut all = Vec::new();
    for i in 0..count {
        let mut o = random.point(1.5);
        let mut d = random.point(1.0);
        d[i % 3] = if i % 2 == 0 { 0.0 } else { -0.0 };
        if i % 4 == 0 {
            d[(i + 1) % 3] = 0.0;
        }
        if i % 5 == 0 {
            o[i % 3] = 1.0;
        }
        if i % 10 == 0 {
            o[(i + 2) % 3] = -1.0;
        }
        all.push(ray(o, d));
    }
    for axis in 0..3 {
        let mut d = [0.0; 3];
        d[axis] = 1.0;
        all.push(ray(d.map(|x| -3.0 * x), d));
        all.push(ray([0.0; 3], d));
        all.push(ray(
            [1.0 - 4.0 * d[0], 1.0 - 4.0 * d[1], 1.0 - 4.0 * d[2]],
            d,
        ));
    }
    all
}

/// Rays towards a point near the middle from `distance` away; with 0, from inside the box.
pub fn towards(distance: f64, count: usize) -> Vec<Ray> {
    let mut random = Random(13 + distance as u64);
    let mut all = Vec::new();
    for _ in 0..count {
        let goal = random.point(0.9);
        let way = random.point(1.0);
        let speed = random.number(0.1, 3.0);
        let o = if distance == 0.0 {
            random.point(0.9)
        } else {
            std::array::from_fn(|k| goal[k] - distance * way[k])
        };
        all.push(ray(o, way.map(|x| x * speed)));
    }
    all
}

/// Rays that start on the surface as nearly as floats permit: `points` are on it.
pub fn starting_at(points: &[[f64; 3]], count: usize) -> Vec<Ray> {
    let mut random = Random(17);
    let from = points.iter().cycle().take(count);
    from.map(|&o| ray(o, random.point(1.0))).collect()
}

/// Rays with long, short and lopsided directions: all scaled by powers of two from 2⁻⁴⁰⁰ to 2⁴⁰⁰, or with one component
/// that is all but 0, down to the smallest float.
pub fn lopsided(count: usize) -> Vec<Ray> {
    let mut random = Random(19);
    let mut all = Vec::new();
    for i in 0..count {
        let goal = random.point(0.9);
        let mut d = random.point(1.0);
        let o: [f64; 3] = std::array::from_fn(|k| goal[k] - 3.0 * d[k]);
        let scale = 2f64.powi([-400, -60, -30, 0, 30, 60, 400][i % 7]);
        d = d.map(|x| x * scale);
        if i % 2 == 0 {
            d[i % 3] = [1e-20, -1e-200, 1e-308, -5e-324][i / 2 % 4] * scale.min(1.0);
        }
        all.push(ray(o, d));
    }
    all
}

/// Rays that graze the surface ever closer: between neighbouring pixels of a picture of size × size pixels of which one
/// is a miss and one is not, by bisection until the two rays are the same. At most `count` pairs are taken.
///
/// # Panics
/// If the picture cannot be rendered.
pub fn silhouettes(picture: &Picture, size: u32, count: usize, isa: Isa) -> Vec<Ray> {
    let rendering = picture.render(size, isa);
    let is_miss = |answer: &Answer| answer.first == Verdict::Miss;
    let mut pairs = Vec::new();
    for (x, y) in (0..size).flat_map(|y| (1..size).map(move |x| (x, y))) {
        let pair = [x - 1, x].map(|x| {
            let miss = is_miss(&rendering.answer(x, y));
            (miss, picture.camera.ray(x, y, size, size, Sampling::Centre))
        });
        match pair {
            [(true, miss), (false, hit)] | [(false, hit), (true, miss)] => pairs.push((miss, hit)),
            _ => {}
        }
    }
    let step = pairs.len().div_ceil(count).max(1);
    let mut all = Vec::new();
    for (mut miss, mut hit) in pairs.into_iter().step_by(step) {
        loop {
            let middle = Ray {
                origin: (miss.origin + hit.origin) * 0.5,
                direction: (miss.direction + hit.direction) * 0.5,
            };
            if middle == miss || middle == hit {
                break;
            }
            all.push(middle);
            if is_miss(&picture.first_root(&middle, isa)) {
                miss = middle;
            } else {
                hit = middle;
            }
        }
    }
    all
}
