//! From a rendering to an image.

use glam::Vec3;
use image::{Rgb, RgbImage};

use crate::render::Rendering;
use crate::verdict::{Verdict, Why};

/// One distant light, light from everywhere, and colours; all colours are linear RGB from 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Shading {
    /// The direction towards the light; any length but 0.
    pub light: Vec3,
    /// The share of light that comes from everywhere, 0 to 1.
    pub ambient: f32,
    /// The strength of the soft highlight, 0 for none.
    pub highlight: f32,
    /// The colour of surface i, unless it has [its own](crate::Operand::coloured); repeated if there are more surfaces.
    pub colours: Vec<Vec3>,
    /// What is seen where nothing is.
    pub background: Vec3,
    /// What is seen where all is open.
    pub unknown: Vec3,
}

impl Default for Shading {
    fn default() -> Self {
        Shading {
            light: Vec3::new(0.4, 0.6, 0.7),
            ambient: 0.25,
            highlight: 0.15,
            colours: vec![
                Vec3::new(0.75, 0.42, 0.14),
                Vec3::new(0.12, 0.38, 0.65),
                Vec3::new(0.18, 0.5, 0.22),
                Vec3::new(0.6, 0.15, 0.3),
            ],
            background: Vec3::new(0.93, 0.94, 0.96),
            unknown: Vec3::new(1.0, 0.0, 0.8),
        }
    }
}

impl Shading {
    /// The linear colour of surface `index`, which may have its own, where its unit normal is `normal`.
    fn colour(&self, index: usize, own: Option<Vec3>, normal: Option<[f32; 3]>) -> Vec3 {
        let base = match (own, self.colours.len()) {
            (Some(colour), _) => colour,
            (None, 0) => Vec3::splat(0.7),
            (None, n) => self.colours[index % n],
        };
        let Some(normal) = normal else {
            return base * self.ambient;
        };
        let cosine = Vec3::from(normal)
            .dot(self.light.normalize_or_zero())
            .max(0.0);
        // The highlight of a rough surface seen from the light's side: cheap, and soft enough not to need the eye.
        let glint = self.highlight * cosine.powi(20);
        base * (self.ambient + (1.0 - self.ambient) * cosine) + Vec3::splat(glint)
    }
}

impl Rendering {
    /// The picture: Lambert's law with one light, sRGB.
    pub fn image(&self, shading: &Shading) -> RgbImage {
        RgbImage::from_fn(self.width(), self.height(), |x, y| {
            let pixel = self.pixel(x, y);
            let colour = match (pixel.surface, pixel.answer.first) {
                (Some(index), _) => shading.colour(index, self.colours[index], pixel.normal),
                (None, Verdict::Miss) => shading.background,
                (None, _) => shading.unknown,
            };
            srgb(colour)
        })
    }

    /// A colour per verdict, each pixel's first: miss white, root green, tangent blue, crossing orange; unresolved red
    /// (floor), brown (order), black (budget), purple (undefined), grey (flat). Where the order of two surfaces is open:
    /// yellow.
    pub fn verdict_image(&self) -> RgbImage {
        RgbImage::from_fn(self.width(), self.height(), |x, y| {
            let pixel = self.pixel(x, y);
            Rgb(match pixel.answer.first {
                _ if pixel.tied => [240, 220, 40],
                Verdict::Miss => [255, 255, 255],
                Verdict::Root { .. } => [60, 160, 80],
                Verdict::Tangent { .. } => [40, 90, 220],
                Verdict::Crossing { .. } => [240, 150, 30],
                Verdict::Unresolved {
                    why: Why::Order, ..
                } => [140, 80, 20],
                Verdict::Unresolved {
                    why: Why::Floor, ..
                } => [220, 30, 30],
                Verdict::Unresolved {
                    why: Why::Budget, ..
                } => [0, 0, 0],
                Verdict::Unresolved {
                    why: Why::Undefined,
                    ..
                } => [150, 40, 180],
                Verdict::Unresolved { why: Why::Flat, .. } => [128, 128, 128],
            })
        })
    }
}

/// From linear light to sRGB's eight bits (IEC 61966-2-1).
fn srgb(linear: Vec3) -> Rgb<u8> {
    let encode = |x: f32| {
        let x = x.clamp(0.0, 1.0);
        let y = if x <= 0.003_130_8 {
            12.92 * x
        } else {
            1.055 * x.powf(1.0 / 2.4) - 0.055
        };
        (y * 255.0 + 0.5) as u8
    };
    Rgb([encode(linear.x), encode(linear.y), encode(linear.z)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_is_the_standard_curve() {
        assert_eq!(srgb(Vec3::new(0.0, 1.0, 0.215_861)).0, [0, 255, 128]);
        assert_eq!(srgb(Vec3::new(0.002, 2.0, -1.0)).0, [7, 255, 0]);
    }
}
