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
    /// Could nothing be left out? Then narrower beams inside are not asked.
    pub vain: bool,
}

impl Rows {
    /// All that there are.
    pub fn everything(active: Active) -> Self {
        Rows {
            near: active.clone(),
            reach: f64::INFINITY,
            all: active,
            vain: false,
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
