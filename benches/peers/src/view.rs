//! The view of all pictures: orthographic along −z over the cube [−1, 1]³.

use glam::DVec3;
use zeroset::Camera;
use zeroset::camera::Sampling;
use zeroset::render::{Options, Rendering, render, render_over};
use zeroset::{Scene, verdict::Verdict};

/// Where in a pixel its ray runs.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// At the corner that is fidget's: x = (i − N/2)·2/N, y = (N/2 − 1 − j)·2/N.
    Corner,
    /// In the middle.
    Centre,
}

/// A picture of N × N pixels. N is a power of two: all coordinates are exact.
#[derive(Clone, Copy)]
pub struct View {
    pub size: u32,
    pub place: Place,
}

/// What a picture shows at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shown {
    Miss,
    /// A surface, at this z.
    At(f64),
    /// It says itself that it does not know.
    Open,
}

impl View {
    /// x and y of a pixel's ray.
    pub fn ray(&self, i: u32, j: u32) -> [f64; 2] {
        let (n, i, j) = (f64::from(self.size), f64::from(i), f64::from(j));
        match self.place {
            Place::Corner => [(i - n / 2.0) * 2.0 / n, (n / 2.0 - 1.0 - j) * 2.0 / n],
            Place::Centre => [(i + 0.5 - n / 2.0) * 2.0 / n, (n / 2.0 - 0.5 - j) * 2.0 / n],
        }
    }

    pub fn camera(&self) -> Camera {
        // zeroset's corner is the upper one.
        let shift = match self.place {
            Place::Corner => -2.0 / f64::from(self.size),
            Place::Centre => 0.0,
        };
        let at = DVec3::new(0.0, shift, 0.0);
        Camera::orthographic(at + 3.0 * DVec3::Z, at, DVec3::Y, 2.0)
            .expect("a camera along the z axis")
    }

    pub fn options(&self) -> Options<'static> {
        let mut options = Options::new(self.size, self.size);
        options.sampling = match self.place {
            Place::Corner => Sampling::Corner,
            Place::Centre => Sampling::Centre,
        };
        options
    }

    /// zeroset's picture, on the threads of the pool from which this is called.
    pub fn render(&self, scene: &Scene) -> Rendering {
        render(scene, &self.camera(), &self.options()).expect("a valid scene")
    }

    /// The same into the memory of another picture.
    pub fn render_over(&self, old: Option<Rendering>, scene: &Scene) -> Rendering {
        let Some(old) = old else {
            return self.render(scene);
        };
        render_over(old, scene, &self.camera(), &self.options()).expect("a valid scene")
    }

    /// What zeroset shows at a pixel. The camera is at z = 3 and looks along −z.
    pub fn shown(picture: &Rendering, i: u32, j: u32) -> Shown {
        let answer = picture.answer(i, j);
        match answer.first {
            Verdict::Miss => Shown::Miss,
            Verdict::Root { t } | Verdict::Crossing { t } => {
                Shown::At(3.0 - answer.entry - 0.5 * (t.lo + t.hi))
            }
            Verdict::Tangent { .. } | Verdict::Unresolved { .. } => Shown::Open,
        }
    }

    /// Pixels spread over the picture, about so many, in all phases of tiles and packets.
    pub fn sample(&self, rays: u32) -> Vec<[u32; 2]> {
        let step = (f64::from(self.size) / f64::from(rays.max(1)).sqrt()) as u32;
        let step = step.max(1) | 1;
        let steps = move || (0..self.size).step_by(step as usize);
        steps().flat_map(|j| steps().map(move |i| [i, j])).collect()
    }
}
