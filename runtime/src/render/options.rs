//! What can be asked of a render.

use crate::camera::Sampling;
use crate::interval::Isa;
use crate::solve::Settings;

/// How far a render is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Blocks of 64×64 pixels that are finished.
    pub done: usize,
    /// Blocks in all.
    pub of: usize,
}

/// What can be asked of a render. `Options::new(512, 512)` is a good start; change fields as needed.
#[derive(Clone, Copy)]
pub struct Options<'a> {
    /// Columns of pixels, 1 to 65536.
    pub width: u32,
    /// Rows of pixels, 1 to 65536.
    pub height: u32,
    /// Where in a pixel its ray is.
    pub sampling: Sampling,
    /// How to search.
    pub settings: Settings,
    /// Compute normals? Without them [`Rendering::image`](super::Rendering::image) has no shading.
    pub normals: bool,
    /// Threads; nothing means rayon's global pool.
    pub threads: Option<usize>,
    /// The instruction set; nothing means the best one, or what the environment variable `ZEROSET_ISA` names.
    pub isa: Option<Isa>,
    /// Called after each block, from any thread: for a progress bar.
    pub progress: Option<&'a (dyn Fn(Progress) + Sync)>,
}

impl Options<'_> {
    /// A picture of this size, all else as usual.
    pub fn new(width: u32, height: u32) -> Self {
        Options {
            width,
            height,
            sampling: Sampling::default(),
            settings: Settings::default(),
            normals: true,
            threads: None,
            isa: None,
            progress: None,
        }
    }
}
