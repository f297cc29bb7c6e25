//! What a render did.

use std::time::Duration;

use super::rendering::{Kind, Piece};
use crate::solve::Evaluations;

/// Time, summed over threads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Phases {
    /// Making rays, and their entries into the scene's box.
    pub rays: Duration,
    /// Finding roots.
    pub roots: Duration,
    /// Normals.
    pub normals: Duration,
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

    pub(super) fn add(&mut self, piece: &Piece) {
        let rays = u64::from(piece.size[0] * piece.size[1]);
        self.rays += rays;
        self.miss += rays - piece.records.len() as u64;
        for record in &piece.records {
            let count = match record.kind {
                Kind::Miss => &mut self.miss,
                Kind::Root => &mut self.root,
                Kind::Tangent => &mut self.tangent,
                Kind::Crossing => &mut self.crossing,
                Kind::Unresolved => &mut self.unresolved,
            };
            *count += 1;
            self.tied += u64::from(record.tied);
        }
        self.evaluations.add(&piece.counts);
        self.phases.rays += piece.phases.rays;
        self.phases.roots += piece.phases.roots;
        self.phases.normals += piece.phases.normals;
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
        writeln!(
            f,
            "evaluations per ray: value {:.2}, slope {:.2}, curvature {:.2}, point {:.2}, float {:.2}, fine {:.4}, gradient {:.2}; \
             per packet {:.2}",
            per_ray(e.value),
            per_ray(e.slope),
            per_ray(e.curvature),
            per_ray(e.point),
            per_ray(e.float),
            per_ray(e.fine),
            per_ray(e.gradient),
            8.0 * per_ray(e.packets)
        )?;
        write!(
            f,
            "ns per ray and thread: rays {:.1}, roots {:.1}, normals {:.1}",
            nanoseconds(self.phases.rays),
            nanoseconds(self.phases.roots),
            nanoseconds(self.phases.normals)
        )
    }
}
