//! The rows of a surface's tables that matter on a beam's rays.

use crate::surface::Active;

/// Near the front few rows matter; on all of the rays more do.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rows {
    /// Up to a parameter, which counts from the camera, …
    pub near: Active,
    /// … namely this, …
    pub reach: f64,
    /// … and everywhere.
    pub all: Active,
    /// How often in a row nothing to speak of could be left out, from wider beams to narrower ones.
    pub vain: u8,
}

/// So often is looked in vain before it is given up for the narrower beams inside, and before it is for packets of rays.
const PATIENCE: [u8; 2] = [2, 1];

impl Rows {
    /// May it be worth a look which of them matter in beams of whole pixels, or in those of packets?
    pub fn worthwhile(&self, whole: bool) -> bool {
        let [beams, packets] = PATIENCE;
        self.vain < if whole { beams } else { packets }
    }

    /// All that there are.
    pub fn everything(active: Active) -> Self {
        Rows {
            near: active.clone(),
            reach: f64::INFINITY,
            all: active,
            vain: 0,
        }
    }

    /// Those that matter up to a parameter, which counts from the camera.
    pub fn at(&self, t: impl FnOnce() -> f64) -> &Active {
        if self.reach == f64::INFINITY || t() <= self.reach {
            &self.near
        } else {
            &self.all
        }
    }

    /// The same, in the room that is there.
    pub fn copy(&mut self, from: &Rows) {
        self.near.clone_from(&from.near);
        self.reach = from.reach;
        self.all.clone_from(&from.all);
        self.vain = from.vain;
    }
}
