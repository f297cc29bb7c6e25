//! Rays with known roots, as `truth.py` writes them.

use std::collections::HashMap;

/// The first root of a ray, counted from the ray's origin.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Known {
    /// The distinct roots inside the cube, in ascending order, each as a sum of two `f64`s.
    pub roots: Vec<[f64; 2]>,
    /// Nothing is known of this ray.
    pub undecided: bool,
}

impl Known {
    /// How far `base + t` is from root number `k`.
    pub fn distance(&self, k: usize, base: f64, t: f64) -> f64 {
        let [hi, lo] = self.roots[k];
        // The leading parts cancel exactly, or nearly: the base is of the root's size.
        (((base - hi) + t) - lo).abs()
    }
}

/// The rays of each surface, row after row.
pub fn read(text: &str) -> HashMap<String, Vec<Known>> {
    let mut surfaces: HashMap<String, Vec<Known>> = HashMap::new();
    let mut rays = &mut Vec::new();
    for line in text.lines() {
        let mut words = line.split(' ');
        match words.next() {
            Some("surface") => {
                let name = words.next().unwrap_or_default();
                rays = surfaces.entry(name.to_owned()).or_default();
            }
            Some("?") => rays.push(Known {
                undecided: true,
                ..Known::default()
            }),
            _ => {
                let numbers: Vec<f64> = line
                    .split(' ')
                    .filter(|word| word.len() == 16)
                    .map(|word| f64::from_bits(u64::from_str_radix(word, 16).expect("bits")))
                    .collect();
                rays.push(Known {
                    roots: numbers.chunks(2).map(|pair| [pair[0], pair[1]]).collect(),
                    undecided: false,
                });
            }
        }
    }
    surfaces
}
