//! What the render did, for the terminal.

use std::io::{Result, Write};
use std::time::Duration;

use zeroset::render::Statistics;
use zeroset::surface::Surface;

use crate::arguments::Arguments;
use crate::family::SumOfExpQuadrics;

/// Prints what is rendered.
pub fn heading(out: &mut impl Write, arguments: &Arguments) -> Result<()> {
    let Arguments {
        terms,
        size,
        seed,
        solver,
        ..
    } = arguments;
    writeln!(
        out,
        "sum of {terms} exponentials, seed {seed}, {size}×{size} pixels, solver {solver}"
    )?;
    functions(out)
}

/// Which functions of the formula have proved enclosures.
fn functions(out: &mut impl Write) -> Result<()> {
    let report = SumOfExpQuadrics::REPORT;
    for &function in report.functions {
        let tested = report.unproved().any(|f| f == function);
        let word = if tested {
            "tested, not proved"
        } else {
            "proved"
        };
        writeln!(out, "  enclosure of {function}: {word}")?;
    }
    Ok(())
}

/// Prints counts and times.
pub fn statistics(out: &mut impl Write, s: &Statistics) -> Result<()> {
    let per_ray = |n: u64| n as f64 / s.rays.max(1) as f64;
    writeln!(out, "\n{:<12}{:>12}{:>10}", "verdict", "rays", "share")?;
    for (name, count) in [
        ("miss", s.miss),
        ("root", s.root),
        ("tangent", s.tangent),
        ("crossing", s.crossing),
        ("unresolved", s.unresolved),
    ] {
        let share = 100.0 * per_ray(count);
        writeln!(out, "{name:<12}{count:>12}{share:>8.2} %")?;
    }
    let area = s.area;
    writeln!(out, "\n{:<12}{:>12}{:>10}", "all rays", "pixels", "share")?;
    for (name, count) in [
        ("hit", area.hit),
        ("miss", area.miss),
        ("undecided", area.undecided),
    ] {
        let share = 100.0 * per_ray(count);
        writeln!(out, "{name:<12}{count:>12}{share:>8.2} %")?;
    }
    let e = &s.evaluations;
    writeln!(out, "\n{:<12}{:>12}{:>10}", "evaluations", "all", "per ray")?;
    for (name, count) in [
        ("value", e.value),
        ("slope", e.slope),
        ("curvature", e.curvature),
        ("point", e.point),
        ("float", e.float),
        ("gradient", e.gradient),
    ] {
        let each = per_ray(count);
        writeln!(out, "{name:<12}{count:>12}{each:>10.3}")?;
    }
    for (name, count) in [("in packets", e.packets), ("over beams", e.beams)] {
        let each = per_ray(count);
        writeln!(out, "{name:<12}{count:>12}{each:>10.3}")?;
    }
    writeln!(out, "\n{:<12}{:>12}{:>10}", "skipped", "all", "per ray")?;
    for (name, count) in [
        ("empty beams", s.rays - s.made),
        ("single root", e.single),
        ("outside", s.outside),
        ("closed form", e.closed),
        ("normals", s.rays - e.gradient),
    ] {
        let each = per_ray(count);
        writeln!(out, "{name:<12}{count:>12}{each:>10.3}")?;
    }
    phases(out, s)
}

/// Time by phase: of all threads together, and per ray.
fn phases(out: &mut impl Write, s: &Statistics) -> Result<()> {
    writeln!(out, "\n{:<12}{:>12}{:>10}", "phase", "time", "per ray")?;
    for (name, time) in [
        ("beams", s.phases.beams),
        ("roots", s.phases.roots),
        ("normals", s.phases.normals),
    ] {
        writeln!(
            out,
            "{name:<12}{:>9.2} ms{:>7.0} ns",
            milliseconds(time),
            time.as_nanos() as f64 / s.rays.max(1) as f64
        )?;
    }
    writeln!(
        out,
        "{:<12}{:>9.2} ms   from start to end, {} threads, {}",
        "render",
        milliseconds(s.elapsed),
        s.threads,
        s.isa
    )
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
