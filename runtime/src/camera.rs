//! Cameras: from a pixel to a ray.

use glam::DVec3;

use crate::beam::{Frame, View};
use crate::interval::Packet;
use crate::ray::Lines;

/// A half line: the points `origin + t·direction`, t ≥ 0.
///
/// These `f64` numbers *are* the exact ray, whatever rounding made them: every verdict speaks of this line. The
/// direction is not normalised.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes; t counts in units of it.
    pub direction: DVec3,
}

impl Ray {
    /// The point at `t`, rounded to nearest.
    #[inline]
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

/// Where in a pixel its ray is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Sampling {
    /// In the middle of the pixel.
    #[default]
    Centre,
    /// At its upper left corner.
    Corner,
}

/// What turns a place on the picture into a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    from: DVec3,
    forward: DVec3,
    /// One half of the picture's height to the right, on the picture plane.
    right: DVec3,
    /// One half of the picture's height up.
    up: DVec3,
    lens: Lens,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Lens {
    Perspective,
    Orthographic,
}

/// A camera that cannot take a picture.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CameraError {
    /// A coordinate is NaN or infinite.
    #[error("the camera's {0} has a coordinate that is not finite: give three finite numbers")]
    NotFinite(&'static str),
    /// The camera looks from a point at the same point.
    #[error("the camera looks from a point at that same point: move `from` or `at`")]
    NoDirection,
    /// The view direction and `up` are parallel.
    #[error(
        "`up` is zero or points along the view: choose another `up`, for example the z axis when you look along y"
    )]
    BadUp,
    /// The angle of view is not between 0° and 180°.
    #[error(
        "the vertical field of view is {0}°: give an angle above 0° and below 180°, for example 40°"
    )]
    BadAngle(f64),
    /// The height of an orthographic picture is not positive.
    #[error(
        "the height of the orthographic view is {0}: give a positive length in the scene's units"
    )]
    BadHeight(f64),
}

impl Camera {
    /// A perspective camera at `from` that looks at `at`. `degrees` is the vertical field of view.
    pub fn perspective(
        from: DVec3,
        at: DVec3,
        up: DVec3,
        degrees: f64,
    ) -> Result<Self, CameraError> {
        if !(degrees > 0.0 && degrees < 180.0) {
            return Err(CameraError::BadAngle(degrees));
        }
        let half = (degrees.to_radians() / 2.0).tan();
        Self::looking(from, at, up, half, Lens::Perspective)
    }

    /// An orthographic camera: all rays are parallel to `at − from` and start on the plane through `from`. `height` is
    /// the picture's height in the scene's units.
    pub fn orthographic(
        from: DVec3,
        at: DVec3,
        up: DVec3,
        height: f64,
    ) -> Result<Self, CameraError> {
        if !(height > 0.0 && height.is_finite()) {
            return Err(CameraError::BadHeight(height));
        }
        Self::looking(from, at, up, height / 2.0, Lens::Orthographic)
    }

    fn looking(
        from: DVec3,
        at: DVec3,
        up: DVec3,
        half: f64,
        lens: Lens,
    ) -> Result<Self, CameraError> {
        for (name, v) in [("`from`", from), ("`at`", at), ("`up`", up)] {
            if !v.is_finite() {
                return Err(CameraError::NotFinite(name));
            }
        }
        let forward = (at - from)
            .try_normalize()
            .ok_or(CameraError::NoDirection)?;
        // Parallel up to rounding counts as parallel: the picture would spin with the last bit.
        let side = forward.cross(up.normalize_or_zero());
        if side.length() < 1e-9 {
            return Err(CameraError::BadUp);
        }
        let right = side.normalize();
        let up = right.cross(forward);
        Ok(Camera {
            from,
            forward,
            right: right * half,
            up: up * half,
            lens,
        })
    }

    /// The ray through the pixel in column `x` and row `y`, counted from the upper left, of a picture of
    /// `width`×`height` pixels.
    #[inline(always)]
    pub fn ray(&self, x: u32, y: u32, width: u32, height: u32, sampling: Sampling) -> Ray {
        let [u, v, scale] = plane([x, y], [width, height], sampling);
        let shift = self.right * (u * scale) + self.up * (v * scale);
        match self.lens {
            Lens::Perspective => Ray {
                origin: self.from,
                direction: self.forward + shift,
            },
            Lens::Orthographic => Ray {
                origin: self.from + shift,
                direction: self.forward,
            },
        }
    }

    /// The camera's frame over a box; see [`Frame::new`] for where there is none.
    pub(crate) fn frame(&self, picture: [u32; 2], domain: &[[f64; 3]; 2]) -> Option<Frame> {
        let pixel = 2.0 / f64::from(picture[1]);
        Frame::new(
            &View {
                from: self.from.to_array(),
                axes: [self.forward, self.right, self.up].map(|v| v.to_array()),
                perspective: self.lens == Lens::Perspective,
                pixel,
                // Beams reach less than a block beyond the picture.
                reach: picture.map(|n| (0.5 * f64::from(n) + 70.0) * pixel),
            },
            domain,
        )
    }

    /// The rays of a packet of pixels from `corner` on: by the same operations as [`ray`](Camera::ray), so they are the
    /// same rays.
    #[inline(always)]
    pub(crate) fn rays<P: Packet>(
        &self,
        p: P,
        corner: [u32; 2],
        picture: [u32; 2],
        sampling: Sampling,
        lines: &mut Lines,
    ) {
        let [u, v, scale] = plane(corner, picture, sampling);
        let scale = p.splat(scale);
        let u = p.mul_rn(p.add_rn(p.splat(u), p.lanes(COLUMNS)), scale);
        let v = p.mul_rn(p.sub_rn(p.splat(v), p.lanes(ROWS)), scale);
        let (right, up) = (self.right.to_array(), self.up.to_array());
        let (from, forward) = (self.from.to_array(), self.forward.to_array());
        for k in 0..3 {
            let shift = p.add_rn(p.mul_rn(p.splat(right[k]), u), p.mul_rn(p.splat(up[k]), v));
            match self.lens {
                Lens::Perspective => {
                    p.store(p.splat(from[k]), &mut lines.origin[k]);
                    let direction = p.add_rn(p.splat(forward[k]), shift);
                    p.store(direction, &mut lines.direction[k]);
                }
                Lens::Orthographic => {
                    let origin = p.add_rn(p.splat(from[k]), shift);
                    p.store(origin, &mut lines.origin[k]);
                    p.store(p.splat(forward[k]), &mut lines.direction[k]);
                }
            }
        }
    }
}

/// Where the pixels of a packet of 4×2 lie from its first.
pub(crate) const COLUMNS: [f64; 8] = [0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0];
pub(crate) const ROWS: [f64; 8] = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];

/// A pixel on the picture plane, in pixels to the right and up from the middle (half of them, exact), and the size of
/// a pixel in halves of the picture's height.
#[inline(always)]
pub(crate) fn plane(pixel: [u32; 2], picture: [u32; 2], sampling: Sampling) -> [f64; 3] {
    let offset = match sampling {
        Sampling::Centre => 0.5,
        Sampling::Corner => 0.0,
    };
    let [width, height] = picture.map(f64::from);
    [
        f64::from(pixel[0]) + offset - 0.5 * width,
        0.5 * height - f64::from(pixel[1]) - offset,
        2.0 / height,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interval::{Isa, Kernel};

    #[test]
    fn the_middle_ray_looks_forward() {
        let camera =
            Camera::perspective(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y, 40.0).unwrap();
        let ray = camera.ray(2, 1, 5, 3, Sampling::Centre);
        assert_eq!(ray.direction, DVec3::new(0.0, 0.0, -1.0));
        let right = camera.ray(4, 1, 5, 3, Sampling::Centre);
        let top = camera.ray(2, 0, 5, 3, Sampling::Centre);
        assert!(right.direction.x > 0.0 && top.direction.y > 0.0);
    }

    #[test]
    fn orthographic_rays_are_parallel_and_span_the_height() {
        let camera =
            Camera::orthographic(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y, 4.0).unwrap();
        let top = camera.ray(0, 0, 8, 8, Sampling::Corner);
        let next = camera.ray(0, 8, 8, 8, Sampling::Corner);
        assert_eq!(top.direction, next.direction);
        assert_eq!(top.origin.y - next.origin.y, 4.0);
    }

    #[test]
    fn packets_hold_the_same_rays() {
        struct Same(Camera);
        impl Kernel for Same {
            type Output = ();
            fn run<P: Packet>(self, p: P) {
                for sampling in [Sampling::Centre, Sampling::Corner] {
                    let mut lines = Lines::default();
                    self.0.rays(p, [8, 6], [31, 17], sampling, &mut lines);
                    for lane in 0..8 {
                        let (x, y) = (8 + lane as u32 % 4, 6 + lane as u32 / 4);
                        let ray = self.0.ray(x, y, 31, 17, sampling);
                        let origin = lines.origin.map(|o| o[lane]);
                        let direction = lines.direction.map(|d| d[lane]);
                        assert_eq!(
                            (origin, direction),
                            (ray.origin.into(), ray.direction.into())
                        );
                    }
                }
            }
        }
        let (from, at) = (DVec3::new(1.1, -2.3, 5.7), DVec3::new(0.1, 0.3, -0.7));
        for isa in Isa::available() {
            isa.run(Same(Camera::perspective(from, at, DVec3::Y, 37.0).unwrap()));
            isa.run(Same(Camera::orthographic(from, at, DVec3::Y, 1.3).unwrap()));
        }
    }

    #[test]
    fn bad_cameras_say_what_to_do() {
        let o = DVec3::ZERO;
        assert_eq!(
            Camera::perspective(o, o, DVec3::Y, 40.0),
            Err(CameraError::NoDirection)
        );
        assert_eq!(
            Camera::perspective(o, DVec3::X, DVec3::X, 40.0),
            Err(CameraError::BadUp)
        );
        assert_eq!(
            Camera::perspective(o, DVec3::X, DVec3::Y, 0.0),
            Err(CameraError::BadAngle(0.0))
        );
        assert_eq!(
            Camera::orthographic(o, DVec3::X, DVec3::Y, -1.0),
            Err(CameraError::BadHeight(-1.0))
        );
        assert!(matches!(
            Camera::orthographic(o, DVec3::NAN, DVec3::Y, 1.0),
            Err(CameraError::NotFinite(_))
        ));
    }
}
