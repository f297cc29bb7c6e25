//! What is wrong in a picture.

use crate::shapes::Shape;
use crate::timing::digits;
use crate::truth;
use crate::view::{Shown, View};
use rayon::prelude::*;

/// A picture beside the truth, on the rays that were compared.
#[derive(Clone, Debug, Default)]
pub struct Judgement {
    /// Compared rays.
    pub rays: usize,
    /// Rays that hit and show nothing.
    pub lost: usize,
    /// Rays that hit nothing and show something.
    pub invented: usize,
    /// Rays that show another sheet: the depth is wrong by more than two voxels of a picture of this size.
    pub sheet: usize,
    /// Rays of which the picture says that it does not know.
    pub open: usize,
    /// Errors of depth of the others that hit, in ascending order.
    pub errors: Vec<f64>,
    /// The first pixels that are wrong.
    pub examples: Vec<[u32; 2]>,
}

impl Judgement {
    pub fn wrong(&self) -> usize {
        self.lost + self.invented + self.sheet
    }

    /// Wrong pixels: all, and what they are.
    pub fn wrong_cell(&self) -> String {
        let mut cell = self.wrong().to_string();
        let kinds = [
            (self.lost, "lost"),
            (self.invented, "invented"),
            (self.sheet, "wrong sheet"),
        ];
        let kinds: Vec<String> = kinds
            .iter()
            .filter(|k| k.0 > 0)
            .map(|(n, what)| format!("{n} {what}"))
            .collect();
        if !kinds.is_empty() {
            cell += &format!(" ({})", kinds.join(", "));
        }
        cell
    }

    /// The median and the largest error of depth.
    pub fn error_cell(&self) -> String {
        match self.errors.last() {
            Some(&largest) => {
                format!(
                    "{} / {}",
                    digits(self.errors[self.errors.len() / 2]),
                    digits(largest)
                )
            }
            None => "—".to_owned(),
        }
    }

    fn add(&mut self, pixel: [u32; 2], shown: Shown, truth: Option<f64>, voxel: f64) {
        self.rays += 1;
        let before = self.wrong();
        match (shown, truth) {
            (Shown::Open, _) => self.open += 1,
            (Shown::Miss, None) => {}
            (Shown::Miss, Some(_)) => self.lost += 1,
            (Shown::At(_), None) => self.invented += 1,
            (Shown::At(z), Some(true_z)) if (z - true_z).abs() > 2.0 * voxel => self.sheet += 1,
            (Shown::At(z), Some(true_z)) => self.errors.push((z - true_z).abs()),
        }
        if self.wrong() > before && self.examples.len() < 3 {
            self.examples.push(pixel);
        }
    }
}

/// The truth at sampled pixels.
pub struct Sampled<'a> {
    pub shape: &'a Shape,
    pub view: View,
    pub rays: Vec<([u32; 2], Option<f64>)>,
}

impl<'a> Sampled<'a> {
    /// By a march over each ray.
    pub fn new(shape: &'a Shape, view: View, rays: u32) -> Self {
        let look = |[i, j]: [u32; 2]| {
            (
                [i, j],
                truth::first(&*shape.at, view.ray(i, j), truth::STEPS),
            )
        };
        let rays = view.sample(rays).into_par_iter().map(look).collect();
        Sampled { shape, view, rays }
    }

    /// Looks again, 64 times as closely, at the rays where a picture that claims proofs says otherwise. This may
    /// only bring the truth nearer to f: the march knows nothing of the picture.
    pub fn look_again(&mut self, shown: impl Fn(u32, u32) -> Shown + Sync) {
        let View { size, .. } = self.view;
        let (shape, view) = (self.shape, self.view);
        self.rays.par_iter_mut().for_each(|(pixel, truth)| {
            let mut one = Judgement::default();
            one.add(
                *pixel,
                shown(pixel[0], pixel[1]),
                *truth,
                2.0 / f64::from(size),
            );
            if one.wrong() > 0 {
                *truth = truth::first(&*shape.at, view.ray(pixel[0], pixel[1]), 64 * truth::STEPS);
            }
        });
    }

    /// A picture beside the truth.
    pub fn judge(&self, shown: impl Fn(u32, u32) -> Shown) -> Judgement {
        let mut judgement = Judgement::default();
        let voxel = 2.0 / f64::from(self.view.size);
        for &(pixel, truth) in &self.rays {
            judgement.add(pixel, shown(pixel[0], pixel[1]), truth, voxel);
        }
        judgement.errors.sort_by(f64::total_cmp);
        judgement
    }
}
