//! Rays and answers as text.

use std::fmt;

use zeroset::camera::Ray;
use zeroset::glam::DVec3;
use zeroset::interval::Interval;
use zeroset::verdict::Verdict;

/// A ray and what the library says about it.
#[derive(Clone, Debug)]
pub struct Answered {
    /// The ray.
    pub ray: Ray,
    /// The parameter from which the events count.
    pub entry: f64,
    /// In ascending order.
    pub events: Vec<Verdict>,
}

/// Numbers by their bits.
fn write_bits(f: &mut fmt::Formatter<'_>, numbers: &[f64]) -> fmt::Result {
    numbers
        .iter()
        .try_for_each(|x| write!(f, " {:016x}", x.to_bits()))
}

impl fmt::Display for Answered {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "ray")?;
        write_bits(f, &self.ray.origin.to_array())?;
        write_bits(f, &self.ray.direction.to_array())?;
        write_bits(f, &[self.entry])?;
        for event in &self.events {
            let (word, t, more) = match *event {
                Verdict::Miss => continue,
                Verdict::Root { t } => ("root", t, None),
                Verdict::Tangent { t, residual } => ("tangent", t, Some(residual)),
                Verdict::Crossing { t } => ("crossing", t, None),
                Verdict::Unresolved { t, .. } => ("open", t, None),
            };
            let Interval { lo, hi } = t;
            write!(f, "\n{word}")?;
            write_bits(f, &[lo, hi])?;
            write_bits(f, more.as_slice())?;
        }
        Ok(())
    }
}

/// The numbers of a line, each the bits of an `f64`.
///
/// # Errors
/// If a word is not 16 hexadecimal digits.
pub fn numbers<'a>(words: impl Iterator<Item = &'a str>) -> Result<Vec<f64>, String> {
    words
        .map(|word| {
            let bits = u64::from_str_radix(word, 16)
                .ok()
                .filter(|_| word.len() == 16);
            bits.map(f64::from_bits)
                .ok_or_else(|| format!("`{word}` is not the bits of a number"))
        })
        .collect()
}

/// A ray from the words behind `ray`.
///
/// # Errors
/// If these are not six numbers.
pub fn ray<'a>(words: impl Iterator<Item = &'a str>) -> Result<Ray, String> {
    let numbers = numbers(words)?;
    let [ox, oy, oz, dx, dy, dz] = numbers[..] else {
        return Err(format!("a ray of {} numbers", numbers.len()));
    };
    Ok(Ray {
        origin: DVec3::new(ox, oy, oz),
        direction: DVec3::new(dx, dy, dz),
    })
}
