//! From a scene to a picture whose pixels are proved.

mod options;
mod record;
mod rendering;
mod settle;
mod shard;
mod statistics;
pub(crate) mod tile;

pub use options::{Options, Progress};
pub use rendering::{Pixel, Rendering};
pub use statistics::{Area, Phases, Statistics};

use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, AtomicUsize, Ordering};
use std::time::Instant;

use rayon::prelude::*;

use crate::beam::{Findings, Frame, Hint, Request, Rows, Space};
use crate::camera::{Camera, Ray};
use crate::interval::{Isa, IsaError};
use crate::scene::{Label, Prepared, Scene, SceneError, Search, TileJob, hull};
use crate::space::{Octree, Outline, Tree};
use crate::span::Span8;
pub use crate::trace::Trail;
use crate::trace::{Leaves, WithBeams};
use crate::verdict::{Answer, Verdict};
use settle::settle;
use shard::{Memory, Shard};
use tile::{BLOCK, GRID_OF_TILES, TILE, TILES_OF_BLOCK, Tile, View, blocks};

/// A picture that cannot be rendered.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// The scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The instruction set.
    #[error(transparent)]
    Isa(#[from] IsaError),
    /// The picture has no pixels, or too many.
    #[error("a picture of {width}×{height} pixels: give a width and a height from 1 to 65536")]
    BadSize {
        /// The width as given.
        width: u32,
        /// The height as given.
        height: u32,
    },
    /// The threads could not be started.
    #[error("the render's threads could not be started: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// A ray's numbers are not finite, or its direction is (nearly) zero.
    #[error(
        "not a ray: give a finite origin within ±1e150, and a direction whose largest component is between 1e-150 and 1e150"
    )]
    BadRay,
}

/// Renders a scene.
///
/// # Errors
/// If a parameter is not finite, a surface has no domain, the size is out of range, or the instruction set that was
/// asked for does not exist here. Each error says what to do.
pub fn render(scene: &Scene, camera: &Camera, options: &Options) -> Result<Rendering, RenderError> {
    on_threads(Job::checked(scene, camera, options)?, Vec::new())
}

/// As [`render`], into the memory of a picture that is not needed any more: for animations. The old picture may be of any
/// size and scene, and nothing of it shows.
///
/// A system may take as long to hand out fresh memory as a simple surface takes to trace.
///
/// # Errors
/// As [`render`]; the old picture is gone then, too.
pub fn render_over(
    old: Rendering,
    scene: &Scene,
    camera: &Camera,
    options: &Options,
) -> Result<Rendering, RenderError> {
    on_threads(Job::checked(scene, camera, options)?, old.into_memory())
}

fn on_threads(job: Job, memory: Vec<Memory>) -> Result<Rendering, RenderError> {
    match job.options.threads {
        None => Ok(job.run(memory)),
        Some(threads) => {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()?;
            Ok(pool.install(|| job.run(memory)))
        }
    }
}

/// All events along one ray against each surface and each solid of a scene, in ascending order.
///
/// Answers count t from their own entry into the surface's box.
///
/// # Errors
/// As [`render`], and if the ray is not one.
pub fn all_roots(
    scene: &Scene,
    ray: &Ray,
    options: &Options,
) -> Result<Vec<(f64, Vec<Verdict>)>, RenderError> {
    let trails = trails(scene, ray, options)?.into_iter();
    Ok(trails.map(|trail| (trail.entry, trail.events)).collect())
}

/// As [`all_roots`], with all that is known of each search.
///
/// # Errors
/// As [`all_roots`].
pub fn trails(scene: &Scene, ray: &Ray, options: &Options) -> Result<Vec<Trail>, RenderError> {
    check_ray(ray)?;
    let boxes = scene.boxes()?;
    let isa = match options.isa {
        Some(isa) => isa,
        None => Isa::detect()?,
    };
    let octree = scene.octree().filter(|_| options.settings.space);
    let surfaces = scene.surfaces.iter().zip(&boxes).enumerate();
    Ok(surfaces
        .map(|(index, (surface, domain))| {
            let search = Search {
                ray,
                domain,
                within: octree.map(|octree| octree.trees()[index].along(isa, ray)),
            };
            surface
                .prepare()
                .along(isa, &options.settings, &search, false)
        })
        .collect())
}

pub(crate) fn check_ray(ray: &Ray) -> Result<(), RenderError> {
    let speed = ray.direction.abs().max_element();
    let fine = ray.origin.is_finite()
        && ray.origin.abs().max_element() <= 1e150
        && ray.direction.is_finite()
        && (1e-150..=1e150).contains(&speed);
    if fine {
        Ok(())
    } else {
        Err(RenderError::BadRay)
    }
}

/// One render.
pub(crate) struct Job<'a> {
    camera: &'a Camera,
    options: &'a Options<'a>,
    isa: Isa,
    names: Vec<&'static str>,
    labels: Vec<Label>,
    /// The index of each one's first label.
    first: Vec<u16>,
    prepared: Vec<Box<dyn Prepared + 'a>>,
    boxes: Vec<[[f64; 3]; 2]>,
    octree: Option<&'a Octree>,
    /// The box around all boxes; nothing without surfaces.
    domain: Option<[[f64; 3]; 2]>,
}

impl<'a> Job<'a> {
    /// Refuses what cannot be rendered.
    pub(crate) fn checked(
        scene: &'a Scene,
        camera: &'a Camera,
        options: &'a Options<'a>,
    ) -> Result<Self, RenderError> {
        let Options { width, height, .. } = *options;
        let fits = |n: u32| (1..=65536).contains(&n);
        if !fits(width) || !fits(height) {
            return Err(RenderError::BadSize { width, height });
        }
        let isa = match options.isa {
            Some(isa) => isa,
            None => Isa::detect()?,
        };
        let boxes = scene.boxes()?;
        let domain = hull(&boxes);
        check_ray(&camera.ray(0, 0, width, height, options.sampling))?;
        Ok(Job {
            camera,
            options,
            isa,
            names: scene.surfaces.iter().map(|s| s.name()).collect(),
            labels: scene.labels().collect(),
            first: scene.first_labels(),
            prepared: scene.surfaces.iter().map(|s| s.prepare()).collect(),
            boxes,
            octree: scene.octree().filter(|_| options.settings.space),
            domain,
        })
    }

    /// Names and boxes.
    pub(crate) fn surfaces(&self) -> impl Iterator<Item = (&'static str, &[[f64; 3]; 2])> {
        self.names.iter().copied().zip(&self.boxes)
    }

    /// A pixel's ray.
    pub(crate) fn ray(&self, x: u32, y: u32) -> Ray {
        let Options { width, height, .. } = *self.options;
        self.camera.ray(x, y, width, height, self.options.sampling)
    }

    /// What each surface does to a ray, up to its first certain root.
    pub(crate) fn first_roots(&self, ray: &Ray) -> impl Iterator<Item = Trail> {
        let surfaces = self.prepared.iter().zip(&self.boxes);
        surfaces.map(move |(surface, domain)| {
            // A certificate is to stand on its own.
            let search = Search {
                ray,
                domain,
                within: None,
            };
            surface.along(self.isa, &self.options.settings, &search, true)
        })
    }

    /// Each thread takes the next block until none is left, and keeps what it finished in one piece of memory, old or new.
    fn run(self, memory: Vec<Memory>) -> Rendering {
        let start = Instant::now();
        let picture = [self.options.width, self.options.height];
        let view = View {
            camera: self.camera,
            picture,
            sampling: self.options.sampling,
        };
        let beams = self.beams();
        let outlines = self.outlines();
        let projected = start.elapsed();
        let surfaces = self.tile_jobs(&view, &beams, &outlines);
        let blocks = blocks(picture);
        let threads = rayon::current_num_threads();
        let next = AtomicU32::new(0);
        let done = AtomicUsize::new(0);
        let memory = Mutex::new(memory);
        let shards: Vec<Shard> = (0..threads)
            .into_par_iter()
            .with_max_len(1)
            .map(|_| {
                let (mut tile, mut surveyed) = (Tile::default(), Vec::new());
                surveyed.resize_with(surfaces.len(), Findings::default);
                let old = memory.lock().ok().and_then(|mut memory| memory.pop());
                let mut shard = Shard::within(old, blocks as usize / threads + 1);
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= blocks {
                        break shard;
                    }
                    let room = (&mut surveyed[..], &mut tile);
                    self.block(&view, &surfaces, number, room, &mut shard);
                    if let Some(progress) = self.options.progress {
                        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
                        progress(Progress {
                            done,
                            of: blocks as usize,
                        });
                    }
                }
            })
            .collect();
        let mut statistics = Statistics::new(self.isa.name(), threads);
        statistics.phases.space = projected;
        statistics.elapsed = start.elapsed();
        Rendering::new(picture, shards, self.labels, statistics)
    }

    /// Each surface's frame and leaves, where it can be traced in beams.
    fn beams(&self) -> Vec<Option<(Frame, Leaves)>> {
        let picture = [self.options.width, self.options.height];
        let surfaces = self.prepared.iter().zip(&self.boxes);
        surfaces
            .map(|(surface, domain)| {
                let wanted = self.options.settings.beams;
                let frame = wanted.then(|| self.camera.frame(picture, domain))??;
                Some((frame, surface.leaves(self.isa, &frame)?))
            })
            .collect()
    }

    /// Where the boxes of each surface's octree are on the picture. A camera without a frame sees them anywhere.
    fn outlines(&self) -> Vec<Option<Outline>> {
        let picture = [self.options.width, self.options.height];
        let Some(octree) = self.octree else {
            return self.boxes.iter().map(|_| None).collect();
        };
        let outline = |tree: &Tree| {
            let frame = self.camera.frame(picture, &tree.root.bounds())?;
            Some(Outline::new(self.isa, tree, &frame, picture))
        };
        octree.trees().par_iter().map(outline).collect()
    }

    fn tile_jobs<'b>(
        &'b self,
        view: &'b View<'b>,
        beams: &'b [Option<(Frame, Leaves)>],
        outlines: &'b [Option<Outline>],
    ) -> Vec<TileJob<'b>> {
        let surfaces = self.boxes.iter().zip(beams).zip(&self.prepared);
        surfaces
            .zip(&self.first)
            .zip(outlines)
            .map(|((((domain, beams), surface), &index), outline)| TileJob {
                isa: self.isa,
                settings: &self.options.settings,
                view,
                domain,
                index,
                beams: beams.as_ref().map(|(frame, leaves)| WithBeams {
                    space: Space { frame, domain },
                    leaves: &**leaves,
                }),
                outline: outline.as_ref(),
                everything: Rows::everything(surface.everything()),
            })
            .collect()
    }

    /// Surveys a block, and traces the tiles that may show something.
    fn block(
        &self,
        view: &View,
        surfaces: &[TileJob],
        number: u32,
        (surveyed, tile): (&mut [Findings], &mut Tile),
        shard: &mut Shard,
    ) {
        let clock = Instant::now();
        let columns = view.picture[0].div_ceil(BLOCK[0]);
        let corner = [number % columns * BLOCK[0], number / columns * BLOCK[1]];
        let place = |k: usize| tile_of(corner, k);
        let mut live = 0u8;
        for k in 0..TILES_OF_BLOCK {
            let [x, y] = place(k);
            live |= u8::from(x < view.picture[0] && y < view.picture[1]) << k;
        }
        for ((job, surface), findings) in surfaces.iter().zip(&self.prepared).zip(&mut *surveyed) {
            self.survey(job, &**surface, (corner, live), findings);
            let evaluations = &mut shard.statistics.evaluations;
            evaluations.beams += findings.count;
            let apart = (0..TILES_OF_BLOCK).filter(|k| findings.apart >> k & 1 != 0);
            let pixels = apart.map(|k| within(view.picture, place(k), TILE));
            evaluations.apart += pixels.sum::<u64>();
        }
        shard.statistics.phases.beams += clock.elapsed();
        shard.statistics.rays += within(view.picture, corner, BLOCK);
        for k in (0..TILES_OF_BLOCK).filter(|k| live >> k & 1 != 0) {
            tile.begin(view, place(k), self.domain.unwrap_or_default());
            if surveyed.iter().any(|found| found.hints[k].open) {
                self.tile(surfaces, surveyed, k, tile, number, shard);
            } else {
                shard.statistics.area.add(&tile.area());
            }
        }
    }

    /// What is known of a surface in a block's tiles.
    fn survey(
        &self,
        job: &TileJob,
        surface: &dyn Prepared,
        (corner, live): ([u32; 2], u8),
        findings: &mut Findings,
    ) {
        (findings.count, findings.apart) = (0, 0);
        let spans = job
            .outline
            .map_or(Span8::ALL, |outline| outline.spans(corner, &GRID_OF_TILES));
        let open = live & spans.live();
        match job.beams {
            _ if open == 0 => findings.close(),
            Some(beams) => {
                let request = Request {
                    space: beams.space,
                    corner: job.view.begin(corner, &GRID_OF_TILES),
                    grid: &GRID_OF_TILES,
                    live: open,
                    within: spans,
                    known: &Hint::OPEN,
                    rows: &job.everything,
                    settings: &self.options.settings,
                };
                surface.survey(self.isa, beams, &request, findings);
            }
            None => {
                findings.know(&Hint::OPEN, &job.everything);
                findings.keep(open);
            }
        }
        findings.apart |= live & !open;
    }

    /// Traces one tile.
    fn tile(
        &self,
        surfaces: &[TileJob],
        surveyed: &[Findings],
        k: usize,
        tile: &mut Tile,
        block: u32,
        shard: &mut Shard,
    ) {
        let mut phases = Phases::default();
        let clock = Instant::now();
        for ((job, surface), found) in surfaces.iter().zip(&self.prepared).zip(surveyed) {
            if found.hints[k].open {
                surface.trace(job, (&found.hints[k], &found.rows[k]), tile);
            }
        }
        let specials = settle(tile);
        phases.roots = clock.elapsed();
        if self.options.normals {
            for (surface, &index) in self.prepared.iter().zip(&self.first) {
                surface.normals(self.isa, index, tile);
            }
        }
        phases.normals = clock.elapsed() - phases.roots;
        let number = block * TILES_OF_BLOCK as u32 + k as u32;
        shard.keep(number, tile, specials, &phases);
    }
}

/// The corner of a tile of the block with this corner.
fn tile_of(corner: [u32; 2], k: usize) -> [u32; 2] {
    let (x, y) = (
        k as u32 % GRID_OF_TILES.columns,
        k as u32 / GRID_OF_TILES.columns,
    );
    [corner[0] + x * TILE[0], corner[1] + y * TILE[1]]
}

/// The pixels of a rectangle that are in the picture, where its corner is.
fn within(picture: [u32; 2], corner: [u32; 2], size: [u32; 2]) -> u64 {
    let [width, height] = [0, 1].map(|k| size[k].min(picture[k] - corner[k]));
    u64::from(width) * u64::from(height)
}

/// The answer for one ray against a whole scene: of all surfaces the first event, and the first certain root behind it.
///
/// # Errors
/// As [`all_roots`].
pub fn first_roots(
    scene: &Scene,
    ray: &Ray,
    options: &Options,
) -> Result<Vec<Answer>, RenderError> {
    let lists = all_roots(scene, ray, options)?;
    Ok(lists
        .into_iter()
        .map(|(entry, events)| Answer::from_events(entry, &events))
        .collect())
}
