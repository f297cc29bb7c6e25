//! What a render did.

use std::time::Duration;

use crate::solve::Evaluations;

/// Time, summed over threads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Phases {
    /// Finding where an octree's boxes are on the picture.
    pub space: Duration,
    /// Surveying blocks.
    pub beams: Duration,
    /// Making rays and finding roots.
    pub roots: Duration,
    /// Normals.
    pub normals: Duration,
}

impl Phases {
    pub(super) fn add(&mut self, other: &Phases) {
        self.space += other.space;
        self.beams += other.beams;
        self.roots += other.roots;
        self.normals += other.normals;
    }
}

/// What is certain about a picture's area, not only about the rays that sample it; in pixels. Beams through whole pixels
/// prove it, so it takes [`beams`](crate::solve::Settings::beams), and is told cell by cell, of 8×8 pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Area {
    /// Every ray through it hits a surface.
    pub hit: u64,
    /// No ray through it hits one.
    pub miss: u64,
    /// All else: outlines, and what was not surveyed.
    pub undecided: u64,
}

impl Area {
    pub(super) fn add(&mut self, other: &Area) {
        self.hit += other.hit;
        self.miss += other.miss;
        self.undecided += other.undecided;
    }
}

/// Counts and times of a render.
#[derive(Clone, Debug, Default)]
pub struct Statistics {
    /// Rays in all.
    pub rays: u64,
    /// Rays whose first event is this verdict.
    pub miss: u64,
    /// As above.
    pub root: u64,
    /// As above.
    pub tangent: u64,
    /// As above.
    pub crossing: u64,
    /// As above.
    pub unresolved: u64,
    /// Rays on which the nearest roots of two surfaces overlap.
    pub tied: u64,
    /// What is certain for all rays, sampled or not.
    pub area: Area,
    /// Rays that were made one by one; beams showed that the others meet nothing.
    pub made: u64,
    /// Rays among them that do not meet the scene's box: no stage runs for them.
    pub outside: u64,
    /// Evaluations of all surfaces.
    pub evaluations: Evaluations,
    /// Time by phase, summed over threads.
    pub phases: Phases,
    /// Wall-clock time of the whole render.
    pub elapsed: Duration,
    /// The instruction set.
    pub isa: &'static str,
    /// Threads.
    pub threads: usize,
}

impl Statistics {
    pub(super) fn new(isa: &'static str, threads: usize) -> Self {
        Statistics {
            isa,
            threads,
            ..Statistics::default()
        }
    }

    /// Adds the counts of a shard; what is left of its rays are misses.
    pub(super) fn add(&mut self, shard: &Statistics) {
        self.rays += shard.rays;
        self.root += shard.root;
        self.tangent += shard.tangent;
        self.crossing += shard.crossing;
        self.unresolved += shard.unresolved;
        self.miss += shard.rays - shard.root - shard.tangent - shard.crossing - shard.unresolved;
        self.tied += shard.tied;
        self.area.add(&shard.area);
        self.made += shard.made;
        self.outside += shard.outside;
        self.evaluations.add(&shard.evaluations);
        self.phases.add(&shard.phases);
    }
}

impl std::fmt::Display for Statistics {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let per_ray = |n: u64| n as f64 / self.rays.max(1) as f64;
        let share = |n: u64| 100.0 * per_ray(n);
        let nanoseconds = |d: Duration| d.as_nanos() as f64 / self.rays.max(1) as f64;
        let e = &self.evaluations;
        writeln!(
            f,
            "{} rays in {:.1?}, {} threads, {}",
            self.rays, self.elapsed, self.threads, self.isa
        )?;
        writeln!(
            f,
            "verdicts: miss {} ({:.2} %), root {} ({:.2} %), tangent {}, crossing {}, unresolved {}, tied {}",
            self.miss,
            share(self.miss),
            self.root,
            share(self.root),
            self.tangent,
            self.crossing,
            self.unresolved,
            self.tied
        )?;
        let Area {
            hit,
            miss,
            undecided,
        } = self.area;
        writeln!(
            f,
            "certain area: hit {hit} ({:.2} %), miss {miss} ({:.2} %), undecided {undecided} ({:.2} %) pixels",
            share(hit),
            share(miss),
            share(undecided)
        )?;
        writeln!(
            f,
            "evaluations per ray: value {:.2}, slope {:.2}, curvature {:.2}, point {:.2}, float {:.2}, fine {:.4}, gradient {:.2}; \
             per packet {:.2}, over beams {:.3}; skipped: empty beams {:.2}, beams with one root {:.2}, outside the box {:.2}, closed form {:.2}, operands {:.2} (in part {:.2}), \
             surfaces apart {:.2} (in part {:.2}), empty pieces {:.2}",
            per_ray(e.value),
            per_ray(e.slope),
            per_ray(e.curvature),
            per_ray(e.point),
            per_ray(e.float),
            per_ray(e.fine),
            per_ray(e.gradient),
            8.0 * per_ray(e.packets),
            per_ray(e.beams),
            1.0 - per_ray(self.made),
            per_ray(e.single),
            per_ray(self.outside),
            per_ray(e.closed),
            per_ray(e.spared),
            per_ray(e.shortened),
            per_ray(e.apart),
            per_ray(e.trimmed),
            per_ray(e.empty)
        )?;
        write!(
            f,
            "ns per ray and thread: boxes {:.1}, blocks {:.1}, roots {:.1}, normals {:.1}",
            nanoseconds(self.phases.space),
            nanoseconds(self.phases.beams),
            nanoseconds(self.phases.roots),
            nanoseconds(self.phases.normals)
        )
    }
}
