//! The finished picture: an answer per pixel.

use super::shard::{Memory, Place, Shard};
use super::statistics::Statistics;
use super::tile::{BLOCK, TILE, TILES_OF_BLOCK, Tile, blocks};
use crate::interval::Interval;
use crate::scene::Label;
use crate::verdict::{Answer, Verdict};

/// What is known about one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// The verdicts along its ray.
    pub answer: Answer,
    /// The index of the surface that it shows; of a solid, the operand.
    pub surface: Option<usize>,
    /// The unit normal there, towards the viewer (thus out of a solid, unless the ray comes from inside), in plain floats;
    /// nothing where the gradient is 0 or was not asked for.
    pub normal: Option<[f32; 3]>,
    /// The root shown overlaps what is or may be one of another surface or operand: which comes first is open.
    pub tied: bool,
}

/// A finished picture.
pub struct Rendering {
    size: [u32; 2],
    shards: Vec<Shard>,
    /// Where each tile's packets are.
    tiles: Vec<Place>,
    names: Vec<&'static str>,
    /// The surfaces' own colours, by index.
    pub(crate) colours: Vec<Option<glam::Vec3>>,
    statistics: Statistics,
}

impl Rendering {
    pub(super) fn new(
        size: [u32; 2],
        shards: Vec<Shard>,
        labels: Vec<Label>,
        mut statistics: Statistics,
    ) -> Self {
        let mut tiles = vec![Place::default(); blocks(size) as usize * TILES_OF_BLOCK];
        for (index, shard) in shards.iter().enumerate() {
            statistics.add(&shard.statistics);
            for &(number, place) in &shard.tiles {
                tiles[number as usize] = Place {
                    shard: index as u32,
                    ..place
                };
            }
        }
        Rendering {
            size,
            shards,
            tiles,
            names: labels.iter().map(|label| label.name).collect(),
            colours: labels.iter().map(|label| label.colour).collect(),
            statistics,
        }
    }

    /// What another picture may use, the most last.
    pub(super) fn into_memory(self) -> Vec<Memory> {
        let mut shards = self.shards;
        shards.sort_by_key(|shard| shard.records.capacity());
        shards.into_iter().map(Shard::into_memory).collect()
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

    /// The names of the surfaces, by index; each operand of a solid is one.
    pub fn surfaces(&self) -> &[&'static str] {
        &self.names
    }

    /// What is known about the pixel in column `x` and row `y`, counted from the upper left.
    ///
    /// # Panics
    /// If there is no such pixel.
    pub fn pixel(&self, x: u32, y: u32) -> Pixel {
        let Some((shard, index, lane)) = self.place(x, y) else {
            return Pixel {
                answer: Answer::miss(0.0),
                surface: None,
                normal: None,
                tied: false,
            };
        };
        let record = &shard.records[index];
        let has = |bits: u8| bits >> lane & 1 != 0;
        let answer = if has(record.special) {
            shard.special(index, lane)
        } else {
            Answer {
                entry: record.entry[lane],
                first: if has(record.shown) {
                    Verdict::Root {
                        t: Interval {
                            lo: record.lo[lane],
                            hi: record.hi[lane],
                        },
                    }
                } else {
                    Verdict::Miss
                },
                behind: None,
            }
        };
        let normal = record.normal.map(|n| n[lane]);
        // Lanes that show nothing hold leftovers.
        let turned = has(record.shown) && normal != [0.0; 3];
        Pixel {
            answer,
            surface: has(record.shown).then_some(usize::from(record.surface[lane])),
            normal: turned.then_some(normal),
            tied: has(record.tied),
        }
    }

    /// The answer at a pixel.
    ///
    /// # Panics
    /// If there is no such pixel.
    pub fn answer(&self, x: u32, y: u32) -> Answer {
        self.pixel(x, y).answer
    }

    /// Shard, record and lane of a pixel; nothing if its whole packet misses.
    fn place(&self, x: u32, y: u32) -> Option<(&Shard, usize, usize)> {
        let [width, height] = self.size;
        assert!(
            x < width && y < height,
            "pixel ({x}, {y}) of a picture of {width}×{height}"
        );
        let (block, inside) = (
            y / BLOCK[1] * width.div_ceil(BLOCK[0]) + x / BLOCK[0],
            y % BLOCK[1] / TILE[1] * (BLOCK[0] / TILE[0]) + x % BLOCK[0] / TILE[0],
        );
        let number = block as usize * TILES_OF_BLOCK + inside as usize;
        let place = self.tiles.get(number)?;
        let (packet, lane) = Tile::place(x % TILE[0], y % TILE[1]);
        let record = place.of(packet)?;
        Some((&self.shards[place.shard as usize], record, lane))
    }
}
