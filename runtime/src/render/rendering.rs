//! The finished picture: an answer per pixel.

use super::statistics::{Phases, Statistics};
use super::tile::{NOTHING, TILE};
use crate::interval::Interval;
use crate::solve::Evaluations;
use crate::verdict::{Answer, Verdict};

/// The kind of a pixel's first verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Miss,
    Root,
    Tangent,
    Crossing,
    Unresolved,
}

/// What is kept per pixel. Answers that are neither a miss nor a plain root are in the piece's list.
#[derive(Clone, Copy)]
pub(crate) struct Record {
    pub entry: f64,
    pub lo: f64,
    pub hi: f64,
    pub normal: [f32; 3],
    pub surface: u16,
    pub kind: Kind,
    pub tied: bool,
}

/// A finished tile: rows of pixels from its upper left corner.
#[derive(Default)]
pub(crate) struct Piece {
    /// Nothing at all if every pixel is a miss.
    pub records: Vec<Record>,
    /// Width and height.
    pub size: [u32; 2],
    /// In ascending order of the pixel's index.
    pub specials: Vec<(u32, Answer)>,
    pub counts: Evaluations,
    pub phases: Phases,
}

/// What is known about one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// The verdicts along its ray.
    pub answer: Answer,
    /// The index of the surface that it shows.
    pub surface: Option<usize>,
    /// The unit normal there, towards the viewer, in plain floats; nothing where the gradient is 0 or was not asked for.
    pub normal: Option<[f32; 3]>,
    /// The root shown overlaps one of another surface: which comes first is open.
    pub tied: bool,
}

/// A finished picture.
pub struct Rendering {
    size: [u32; 2],
    pieces: Vec<Piece>,
    names: Vec<&'static str>,
    statistics: Statistics,
}

impl Rendering {
    pub(super) fn new(
        size: [u32; 2],
        pieces: Vec<Piece>,
        names: Vec<&'static str>,
        statistics: Statistics,
    ) -> Self {
        Rendering {
            size,
            pieces,
            names,
            statistics,
        }
    }

    /// Columns of pixels.
    pub fn width(&self) -> u32 {
        self.size[0]
    }

    /// Rows of pixels.
    pub fn height(&self) -> u32 {
        self.size[1]
    }

    /// Counts and times.
    pub fn statistics(&self) -> &Statistics {
        &self.statistics
    }

    /// The names of the surfaces, by index.
    pub fn surfaces(&self) -> &[&'static str] {
        &self.names
    }

    /// What is known about the pixel in column `x` and row `y`, counted from the upper left.
    ///
    /// # Panics
    /// If there is no such pixel.
    pub fn pixel(&self, x: u32, y: u32) -> Pixel {
        let (piece, index) = self.place(x, y);
        let Some(record) = piece.records.get(index) else {
            return Pixel {
                answer: Answer::miss(0.0),
                surface: None,
                normal: None,
                tied: false,
            };
        };
        let t = Interval {
            lo: record.lo,
            hi: record.hi,
        };
        let plain = |first| Answer {
            entry: record.entry,
            first,
            behind: None,
        };
        let answer = match record.kind {
            Kind::Miss => plain(Verdict::Miss),
            Kind::Root => plain(Verdict::Root { t }),
            _ => {
                let found = piece
                    .specials
                    .binary_search_by_key(&(index as u32), |(i, _)| *i);
                piece.specials
                    [found.expect("each pixel that is neither a miss nor a root is listed")]
                .1
            }
        };
        Pixel {
            answer,
            surface: (record.surface != NOTHING).then_some(usize::from(record.surface)),
            normal: (record.normal != [0.0; 3]).then_some(record.normal),
            tied: record.tied,
        }
    }

    /// The answer at a pixel.
    ///
    /// # Panics
    /// If there is no such pixel.
    pub fn answer(&self, x: u32, y: u32) -> Answer {
        self.pixel(x, y).answer
    }

    fn place(&self, x: u32, y: u32) -> (&Piece, usize) {
        let [width, height] = self.size;
        assert!(
            x < width && y < height,
            "pixel ({x}, {y}) of a picture of {width}×{height}"
        );
        let columns = width.div_ceil(TILE);
        let piece = &self.pieces[(y / TILE * columns + x / TILE) as usize];
        (piece, (y % TILE * piece.size[0] + x % TILE) as usize)
    }
}
