//! Certificates: what a picture claims, written down so that a program that shares nothing with this one can check it.
//!
//! A certificate is text. Numbers are `f64`s by their bits, as 16 hexadecimal digits, so nothing is lost. Lines:
//!
//! ```text
//! zeroset certificate 1
//! …                                       the caller's own lines: the formula's parameters
//! surface S NAME LO LO LO HI HI HI        surface number S, and the box in which it is searched
//! outside S X Y  O O O  D D D             pixel (X, Y): the ray O + s·D, s ≥ 0, misses the box
//! ray S X Y  O O O  D D D  ENTRY END      this one meets it for s in ENTRY + [0, END] at most
//! cut T T …                               where the search split the ray: of help, no claim
//! root LO HI                              exactly one root with s in ENTRY + [LO, HI]
//! tangent LO HI RESIDUAL                  none, one or two roots there, and |f| comes down to RESIDUAL or less
//! crossing LO HI                          f changes its sign there
//! open LO HI                              nothing is claimed there
//! crc32 C                                 of all bytes before this line
//! ```
//!
//! The lines after a `ray` are its events in ascending order, up to the first root or crossing. The claim is that f has
//! no root outside of them: before the first root or crossing if there is one, else on all of [0, END].
//!
//! [`scripts/check-certificate`](https://github.com/zeroset/zeroset/blob/main/scripts/check-certificate) proves or
//! refutes such a file with arb's ball arithmetic, for a formula that *its* user gives.

use std::fmt::Write as _;
use std::io::{self, Write};

use rayon::prelude::*;

use crate::camera::{Camera, Ray};
use crate::interval::Interval;
use crate::render::{Job, Options, RenderError};
use crate::scene::Scene;
use crate::trace::Trail;
use crate::verdict::Verdict;

/// No certificate.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CertificateError {
    /// The scene or the options.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// A line of the caller's is not one, or reads like one of the certificate's own.
    #[error(
        "`{0}` cannot stand in a certificate's head: give one line that begins with a word of its own, not with one of the format's"
    )]
    Head(String),
    /// The file.
    #[error("the certificate cannot be written: {0}")]
    Write(#[from] io::Error),
}

/// The words that begin the format's own lines.
const WORDS: [&str; 9] = [
    "surface", "outside", "ray", "cut", "root", "tangent", "crossing", "open", "crc32",
];

/// Traces a picture's rays once more, one by one, and writes what each surface's verdicts claim. `head` goes in front:
/// lines with all that a checker needs to know of the formulas, such as the values of their fields.
///
/// # Errors
/// As [`render`](fn@crate::render), if a line of `head` would be read as one of the certificate's, or if `out` fails.
pub fn write(
    scene: &Scene,
    camera: &Camera,
    options: &Options,
    head: &[String],
    out: &mut impl Write,
) -> Result<(), CertificateError> {
    let mut out = Summed {
        out,
        sum: crc32fast::Hasher::new(),
    };
    let job = Job::checked(scene, camera, options)?;
    writeln!(out, "zeroset certificate 1")?;
    for line in head {
        let word = line.split_whitespace().next().unwrap_or_default();
        if line.contains(['\n', '\r']) || word.is_empty() || WORDS.contains(&word) {
            return Err(CertificateError::Head(line.clone()));
        }
        writeln!(out, "{line}")?;
    }
    for (index, (name, domain)) in job.surfaces().enumerate() {
        let corners = bits(domain.as_flattened());
        writeln!(out, "surface {index} {name}{corners}")?;
    }
    for y in 0..options.height {
        let row: Vec<String> = (0..options.width)
            .into_par_iter()
            .map(|x| pixel(&job, [x, y]))
            .collect();
        for lines in row {
            out.write_all(lines.as_bytes())?;
        }
    }
    let sum = out.sum.clone().finalize();
    writeln!(out, "crc32 {sum:08x}")?;
    out.flush()?;
    Ok(())
}

/// A pixel's lines, for each surface.
fn pixel(job: &Job, [x, y]: [u32; 2]) -> String {
    let mut lines = String::new();
    let ray = job.ray(x, y);
    for (index, trail) in job.first_roots(&ray).enumerate() {
        let place = format!("{index} {x} {y}{}", direction(&ray));
        // Writing to a string does not fail.
        let _ = describe(&mut lines, &place, &trail);
    }
    lines
}

fn describe(lines: &mut String, place: &str, trail: &Trail) -> std::fmt::Result {
    let Some(end) = trail.end else {
        return writeln!(lines, "outside {place}");
    };
    writeln!(lines, "ray {place}{}", bits(&[trail.entry, end]))?;
    if !trail.cuts.is_empty() {
        writeln!(lines, "cut{}", bits(&trail.cuts))?;
    }
    for event in &trail.events {
        let ends = |t: &Interval| bits(&[t.lo, t.hi]);
        match event {
            Verdict::Miss => {}
            Verdict::Root { t } => writeln!(lines, "root{}", ends(t))?,
            Verdict::Tangent { t, residual } => {
                writeln!(lines, "tangent{}{}", ends(t), bits(&[*residual]))?;
            }
            Verdict::Crossing { t } => writeln!(lines, "crossing{}", ends(t))?,
            Verdict::Unresolved { t, .. } => writeln!(lines, "open{}", ends(t))?,
        }
    }
    Ok(())
}

fn direction(ray: &Ray) -> String {
    bits(&ray.origin.to_array()) + &bits(&ray.direction.to_array())
}

/// Each number's bits, with a space before it.
fn bits(numbers: &[f64]) -> String {
    numbers.iter().fold(String::new(), |mut text, x| {
        let _ = write!(text, " {:016x}", x.to_bits());
        text
    })
}

/// A writer that keeps the sum of what went through.
struct Summed<'a, W> {
    out: &'a mut W,
    sum: crc32fast::Hasher,
}

impl<W: Write> Write for Summed<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.out.write(bytes)?;
        self.sum.update(&bytes[..written]);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn a_head_cannot_pass_for_claims() {
        let camera = Camera::perspective(DVec3::Z, DVec3::ZERO, DVec3::Y, 40.0).expect("a camera");
        let with = |line: &str| {
            let mut out = Vec::new();
            let head = [line.to_owned()];
            write(&Scene::new(), &camera, &Options::new(1, 1), &head, &mut out).map(|()| out)
        };
        for line in ["", " ", "root 0 1", "ray\t0", "a 1\nroot 0 1"] {
            assert!(
                matches!(with(line), Err(CertificateError::Head(_))),
                "{line:?}"
            );
        }
        let text = with("level 1").expect("a head of its own");
        assert!(text.starts_with(b"zeroset certificate 1\nlevel 1\ncrc32 "));
    }
}
