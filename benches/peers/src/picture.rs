//! A shell thinner than a voxel, side by side: as fidget renders it, and as zeroset does. Both are shaded here, in the same
//! way, from depth and normals.

use crate::shapes;
use crate::versus_fidget;
use crate::view::{Place, Shown, View};
use fidget::jit::JitFunction;
use image::{Rgb, RgbImage};
use std::path::Path;

/// The side of either picture, and what is between them, in pixels.
const SIZE: u32 = 360;
const GAP: u32 = 12;
const PAPER: Rgb<u8> = Rgb([255; 3]);

/// Writes the two pictures into one file.
pub fn write(path: &Path) -> image::ImageResult<()> {
    let shape = shapes::shell(1e-3);
    let view = View {
        size: SIZE,
        place: Place::Corner,
    };
    let jit = fidget::shape::Shape::<JitFunction>::from(shape.tree.clone());
    let theirs = versus_fidget::picture(&jit, SIZE, None);
    let ours = view.render(&shape.scene);
    let mut both = RgbImage::from_pixel(2 * SIZE + GAP, SIZE, PAPER);
    for (i, j) in (0..SIZE).flat_map(|j| (0..SIZE).map(move |i| (i, j))) {
        // fidget's gradients are by rows, which count downward.
        let [x, y, z] = theirs[(j as usize, i as usize)].normal;
        let shown = versus_fidget::shown(&theirs, i, j);
        both.put_pixel(i, j, shaded(shown, [x, -y, z]));
        let normal = ours.pixel(i, j).normal.unwrap_or_default();
        both.put_pixel(SIZE + GAP + i, j, shaded(View::shown(&ours, i, j), normal));
    }
    both.save(path)
}

/// Lit from the upper left; what is far is darker. The normal is of any length, on either side.
fn shaded(shown: Shown, normal: [f32; 3]) -> Rgb<u8> {
    let Shown::At(z) = shown else {
        return PAPER;
    };
    let length = normal.iter().map(|x| x * x).sum::<f32>().sqrt();
    let side = if normal[2] < 0.0 { -1.0 } else { 1.0 };
    const LIGHT: [f32; 3] = [-0.45, 0.55, 0.7];
    let towards: f32 = normal.iter().zip(LIGHT).map(|(n, l)| n * l).sum();
    let light = 0.35 + 0.65 * (side * towards / length).max(0.0);
    let near = 0.75 + 0.3 * z as f32;
    let light = light * near.clamp(0.2, 1.0);
    Rgb([120.0, 170.0, 230.0].map(|c: f32| (c * light).min(255.0) as u8))
}
