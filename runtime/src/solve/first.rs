//! The first root of each ray: the march, and what makes its brackets narrow.

use core::marker::PhantomData;

use super::march::{Range, leave_rest, march};
use super::sharpen::{Second, sharpen};
use super::{Brackets, Events, Field, Refine, Settings, select};
use crate::contract::{Auto, Contractor};
use crate::interval::{Interval, Packet, Routine, back_ends};

/// Where to search a packet's rays.
pub(crate) struct Job<'b, P: Packet> {
    pub field: Field<'b, P>,
    pub settings: &'b Settings,
    /// The segments; `lo ≥ 0`.
    pub over: &'b Interval<P::F>,
    /// The rays that have one.
    pub live: P::M,
    /// How long the first steps are.
    pub first: P::F,
    /// What is known already: rays that are not searched, whose brackets are made narrow.
    pub known: Option<&'b Brackets<P>>,
    /// Is a sign change enough to end a ray's search?
    pub first_only: bool,
    /// What is met before the roots.
    pub events: &'b mut Events,
    /// Where the first ray's search goes on, for those who keep account.
    pub cuts: Option<&'b mut Vec<f64>>,
}

/// The first certain roots of a packet.
pub(crate) struct Roots<P: Packet> {
    pub hit: P::M,
    pub t: Interval<P::F>,
    /// A search for the next goes on here.
    pub resume: P::F,
    /// Those that are wide and might be narrower.
    pub vague: P::M,
}

/// A contractor's search on one instruction set.
#[derive(Clone, Copy)]
pub struct Solver<P: Packet> {
    search: fn(Job<'_, P>) -> Roots<P>,
    settle: fn(Job<'_, P>) -> Roots<P>,
    sharpen: fn(Second<'_, P>, &mut Interval<P::F>),
    /// Does it use second derivatives?
    pub(crate) bends: bool,
}

impl<P: Packet> Solver<P> {
    const BY_DEFAULT: Self = Self::of::<Auto>();

    /// With the contractor `C`, compiled in the crate that asks for it.
    pub(crate) const fn of<C: Contractor>() -> Self {
        Solver {
            search: search::<C, P>,
            settle,
            sharpen,
            bends: C::ORDER >= 2,
        }
    }

    /// With [`Auto`], compiled here: a surface's crate compiles nothing of it.
    pub(crate) fn default() -> Self {
        let ready = DEFAULT.iter().find_map(|solver| solver.downcast_ref());
        // All back-ends are listed; one that were not would find nothing, and claim nothing.
        ready.copied().unwrap_or(Solver {
            search: unsearched,
            settle: unsearched,
            sharpen: |_, _| {},
            bends: false,
        })
    }

    /// The first root of each ray.
    #[inline(always)]
    pub(crate) fn search(self, job: Job<'_, P>) -> Roots<P> {
        if job.field.p.any(job.live) {
            (self.search)(job)
        } else {
            (self.settle)(job)
        }
    }

    /// Looks again in twice the precision, at roots and at events.
    #[inline(always)]
    pub(crate) fn sharpen(self, second: Second<'_, P>, t: &mut Interval<P::F>) {
        (self.sharpen)(second, t);
    }
}

back_ends!(DEFAULT: Solver::BY_DEFAULT);

fn search<C: Contractor, P: Packet>(job: Job<'_, P>) -> Roots<P> {
    job.field.p.call(Search::<C, P> {
        job,
        solver: PhantomData,
    })
}

/// Without a search: what is known already is made narrow.
fn settle<P: Packet>(job: Job<'_, P>) -> Roots<P> {
    job.field.p.call(Settle { job })
}

/// [`settle`] inside the instruction set.
struct Settle<'b, P: Packet> {
    job: Job<'b, P>,
}

impl<P: Packet> Routine<P> for Settle<'_, P> {
    type Output = Roots<P>;

    #[inline(always)]
    fn call(self, p: P) -> Roots<P> {
        let mut job = self.job;
        match job.known {
            Some(known) => roots_of(p, &mut job, known),
            None => roots_of(p, &mut job, &Brackets::none(p)),
        }
    }
}

/// The narrow intervals of brackets.
#[inline(always)]
fn roots_of<P: Packet>(p: P, job: &mut Job<'_, P>, found: &Brackets<P>) -> Roots<P> {
    let mut roots = Roots {
        hit: found.found,
        t: *job.over,
        resume: job.over.hi,
        vague: p.none(),
    };
    if p.any(found.found) {
        let t = p.call(Refine {
            field: &mut job.field,
            brackets: found,
            plain_convergence: job.settings.plain_convergence,
        });
        roots.t = select(p, found.found, &t, &roots.t);
        roots.resume = p.select(found.found, found.resume, roots.resume);
    }
    roots
}

/// Leaves everything open.
fn unsearched<P: Packet>(job: Job<'_, P>) -> Roots<P> {
    let p = job.field.p;
    leave_rest(p, job.live, job.over.lo, job.over.hi, job.events);
    Roots {
        hit: p.none(),
        t: *job.over,
        resume: job.over.hi,
        vague: p.none(),
    }
}

/// [`search`] inside the instruction set.
struct Search<'b, C, P: Packet> {
    job: Job<'b, P>,
    solver: PhantomData<C>,
}

impl<C: Contractor, P: Packet> Routine<P> for Search<'_, C, P> {
    type Output = Roots<P>;

    #[inline(always)]
    fn call(self, p: P) -> Roots<P> {
        let mut job = self.job;
        let range = Range {
            over: *job.over,
            live: job.live,
            first: job.first,
            limit: p.splat(job.settings.limit()),
            first_only: job.first_only,
        };
        let mut found = march::<C, P>(&mut job.field, &range, job.events, job.cuts.take());
        if let Some(known) = job.known {
            found.join(p, known.found, known);
        }
        roots_of(p, &mut job, &found)
    }
}

#[cfg(test)]
mod tests {
    use super::{DEFAULT, Solver};
    use crate::interval::{Isa, Kernel, Packet};

    struct Listed;

    impl Kernel for Listed {
        type Output = bool;
        fn run<P: Packet>(self, _: P) -> bool {
            DEFAULT.iter().any(|solver| solver.is::<Solver<P>>())
        }
    }

    #[test]
    fn every_back_end_has_its_default_solver_compiled() {
        for isa in Isa::available() {
            assert!(isa.run(Listed), "{isa}");
        }
        assert!(!Listed.run(crate::interval::Scalar));
    }
}
