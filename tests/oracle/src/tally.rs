//! Counts per picture and path.

use zeroset::camera::Ray;
use zeroset::verdict::{Answer, Verdict};

use crate::judge::Finding;

/// How wide a root's interval may be.
pub const WIDEST: f64 = 1e-12;

/// How many answers are kept with their rays.
const KEPT: usize = 20;

/// What became of the rays of a picture on one path.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Rays in all.
    pub rays: u64,
    /// Rays whose first event is this verdict.
    pub roots: u64,
    /// As above.
    pub misses: u64,
    /// As above.
    pub tangents: u64,
    /// As above.
    pub crossings: u64,
    /// As above.
    pub unresolved: u64,
    /// Answers that the oracle refutes.
    pub wrong: u64,
    /// Answers that the oracle cannot judge.
    pub undecided: u64,
    /// Roots whose interval is wider than [`WIDEST`].
    pub wide: u64,
    /// The widest interval of a root.
    pub widest: f64,
    /// The first few that are wrong, undecided, open or wide.
    pub examples: Vec<String>,
}

impl Tally {
    /// Counts an answer and what the oracle says of it.
    pub fn add(&mut self, ray: &Ray, answer: &Answer, finding: &Finding) {
        self.rays += 1;
        let count = match answer.first {
            Verdict::Miss => &mut self.misses,
            Verdict::Root { t } => {
                let width = t.hi - t.lo;
                self.widest = self.widest.max(width);
                self.wide += u64::from(width > WIDEST);
                &mut self.roots
            }
            Verdict::Tangent { .. } => &mut self.tangents,
            Verdict::Crossing { .. } => &mut self.crossings,
            Verdict::Unresolved { .. } => &mut self.unresolved,
        };
        *count += 1;
        let (count, why) = match finding {
            Finding::Right => return,
            Finding::Wrong(why) => (&mut self.wrong, why),
            Finding::Undecided(why) => (&mut self.undecided, why),
        };
        *count += 1;
        if self.examples.len() < KEPT {
            self.examples
                .push(format!("{why}: {}", describe(ray, answer)));
        }
    }

    /// Both together.
    pub fn join(mut self, other: Tally) -> Tally {
        self.rays += other.rays;
        self.roots += other.roots;
        self.misses += other.misses;
        self.tangents += other.tangents;
        self.crossings += other.crossings;
        self.unresolved += other.unresolved;
        self.wrong += other.wrong;
        self.undecided += other.undecided;
        self.wide += other.wide;
        self.widest = self.widest.max(other.widest);
        let room = KEPT - self.examples.len();
        self.examples.extend(other.examples.into_iter().take(room));
        self
    }
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "rays {}, roots {}, misses {}, tangents {}, crossings {}, unresolved {}, wrong {}, undecided by the oracle \
             {}, wider than {WIDEST:e}: {}, widest {:.1e}",
            self.rays,
            self.roots,
            self.misses,
            self.tangents,
            self.crossings,
            self.unresolved,
            self.wrong,
            self.undecided,
            self.wide,
            self.widest
        )
    }
}

/// A float by its exact value: sign, hexadecimal digits and a power of two, as C and Python read it.
pub fn hex(x: f64) -> String {
    let bits = x.to_bits();
    let sign = if bits >> 63 == 1 { "-" } else { "" };
    let (field, fraction) = (bits >> 52 & 0x7ff, bits & ((1 << 52) - 1));
    match field {
        0x7ff => format!("{x}"),
        0 => format!("{sign}0x0.{fraction:013x}p-1022"),
        _ => format!("{sign}0x1.{fraction:013x}p{}", field as i64 - 1023),
    }
}

/// A ray and an answer, to the last bit.
pub fn describe(ray: &Ray, answer: &Answer) -> String {
    let point = |v: [f64; 3]| v.map(hex).join(" ");
    let mut text = format!(
        "origin {} direction {} entry {}: {}",
        point(ray.origin.to_array()),
        point(ray.direction.to_array()),
        hex(answer.entry),
        event(&answer.first)
    );
    if let Some(behind) = &answer.behind {
        text += &format!(", behind it {}", event(behind));
    }
    text
}

fn event(verdict: &Verdict) -> String {
    let name = kind(verdict);
    match verdict.t() {
        None => name.into(),
        Some(t) => format!("{name} [{}, {}] ≈ {:.6}", hex(t.lo), hex(t.hi), t.lo),
    }
}

/// A verdict's name, with the reason of an unresolved one.
pub fn kind(verdict: &Verdict) -> &'static str {
    use zeroset::verdict::Why;
    match verdict {
        Verdict::Miss => "miss",
        Verdict::Root { .. } => "root",
        Verdict::Tangent { .. } => "tangent",
        Verdict::Crossing { .. } => "crossing",
        Verdict::Unresolved { why, .. } => match why {
            Why::Order => "unresolved (order)",
            Why::Floor => "unresolved (floor)",
            Why::Budget => "unresolved (budget)",
            Why::Undefined => "unresolved (undefined)",
            Why::Flat => "unresolved (flat)",
        },
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn hexadecimal_floats() {
        assert_eq!(super::hex(-0.75), "-0x1.8000000000000p-1");
        assert_eq!(super::hex(5e-324), "0x0.0000000000001p-1022");
    }
}
