//! Claims against the truth.

use crate::truth::Known;

/// What is said about a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Claim {
    /// The first root is here, from the entry.
    Root(f64),
    /// There is none.
    Nothing,
    /// Not decided, and said so.
    Open,
}

/// A claim, and where its t counts from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Claimed {
    /// The ray's entry into the cube, exact by definition.
    pub entry: f64,
    /// What is said.
    pub claim: Claim,
}

/// How a method did on the rays with a known truth.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Score {
    /// Errors of the roots that are right, in ascending order, as shares of half the width of the cube.
    pub errors: Vec<f64>,
    /// Rays with a root for which none was found.
    pub missed: u32,
    /// Roots where there is none near.
    pub invented: u32,
    /// Roots that are not the first.
    pub wrong_sheet: u32,
    /// Rays on which the method says that it does not know.
    pub open: u32,
    /// Rays that were judged.
    pub rays: u32,
}

impl Score {
    /// Wrong answers of all kinds.
    pub fn wrong(&self) -> u32 {
        self.missed + self.invented + self.wrong_sheet
    }

    /// The largest error.
    pub fn largest(&self) -> f64 {
        self.errors.last().copied().unwrap_or(0.0)
    }

    /// The median error.
    pub fn median(&self) -> f64 {
        let middle = self.errors.len() / 2;
        self.errors.get(middle).copied().unwrap_or(0.0)
    }

    /// Judges one ray. `unit` is half the width of the cube in units of t. A root that is nearer to another one than to
    /// the first is on the wrong sheet, unless it is within the tolerance; one far from all roots is invented.
    pub fn add(&mut self, known: &Known, claimed: &Claimed, unit: f64, tolerance: f64) {
        if known.undecided {
            return;
        }
        self.rays += 1;
        let t = match claimed.claim {
            Claim::Open => {
                self.open += 1;
                return;
            }
            Claim::Nothing => {
                self.missed += u32::from(!known.roots.is_empty());
                return;
            }
            Claim::Root(t) => t,
        };
        let distance = |k: usize| known.distance(k, claimed.entry, t) / unit;
        let all = (0..known.roots.len()).map(distance);
        let nearest = all.fold(f64::INFINITY, f64::min);
        let far = (10.0 * tolerance).max(0.01);
        if nearest.is_nan() || nearest > far {
            self.invented += 1;
        } else if distance(0) > nearest.max(tolerance) {
            self.wrong_sheet += 1;
        } else {
            self.errors.push(distance(0));
        }
    }

    /// Sorts the errors.
    #[must_use]
    pub fn finished(mut self) -> Self {
        self.errors.sort_by(f64::total_cmp);
        self
    }
}
