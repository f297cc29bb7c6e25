//! What this library finds.

use zeroset::interval::Isa;
use zeroset::verdict::Verdict;
use zeroset::{Camera, Options, Rendering, Scene, render};

use crate::judge::{Claim, Claimed};

/// Which contractor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solver {
    /// The default.
    Auto,
    /// Halving.
    Bisection,
    /// Interval Newton.
    Newton,
    /// The same with a tightened derivative.
    Tightened,
    /// The second derivative too.
    Halley,
}

impl Solver {
    /// All of them.
    pub const ALL: [Solver; 5] = [
        Solver::Auto,
        Solver::Bisection,
        Solver::Newton,
        Solver::Tightened,
        Solver::Halley,
    ];

    /// As in tables.
    pub fn name(self) -> &'static str {
        match self {
            Solver::Auto => "auto",
            Solver::Bisection => "bisection",
            Solver::Newton => "Newton",
            Solver::Tightened => "tightened Newton",
            Solver::Halley => "Halley",
        }
    }
}

/// A picture of so many columns and rows, without normals.
pub fn picture(scene: &Scene, camera: &Camera, isa: Isa, size: u32) -> Rendering {
    let mut options = Options::new(size, size);
    options.isa = Some(isa);
    options.normals = false;
    render(scene, camera, &options).expect("a valid scene")
}

/// A pixel's claim: the middle of the root's interval; what is no plain root is open.
pub fn claim(picture: &Rendering, x: u32, y: u32) -> Claimed {
    let answer = picture.pixel(x, y).answer;
    let claim = match answer.first {
        Verdict::Miss => Claim::Nothing,
        Verdict::Root { t } => Claim::Root(t.mid()),
        _ => Claim::Open,
    };
    Claimed {
        entry: answer.entry,
        claim,
    }
}
