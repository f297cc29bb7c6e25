//! The tables: operations and times of each entry point.

use crate::entry::{Entry, Evaluate, PACKETS, isa};
use crate::surfaces::Forms;

/// Rounds of which the median is taken.
const ROUNDS: usize = 101;
/// Seconds that a measurement should take at least.
const LEAST: f64 = 1e-4;

/// Entry points along a ray.
const ALONG: [Entry; 3] = [Entry::Value, Entry::Slope, Entry::Curvature];
/// Entry points in space.
const SPACE: [Entry; 3] = [Entry::SpaceValue, Entry::Gradient, Entry::Hessian];

/// One thing to time.
pub(crate) struct Timed<'a> {
    surface: &'a dyn Evaluate,
    half: f64,
    entry: Entry,
    passes: u32,
    times: Vec<f64>,
}

impl<'a> Timed<'a> {
    pub(crate) fn new(surface: &'a dyn Evaluate, half: f64, entry: Entry) -> Self {
        let mut timed = Timed {
            surface,
            half,
            entry,
            passes: 1,
            times: Vec::new(),
        };
        timed.measure();
        let once = timed.measure();
        timed.passes = (LEAST / once).clamp(1.0, 1e4) as u32;
        timed
    }

    /// Seconds of one run.
    fn measure(&self) -> f64 {
        let time = self.surface.time(self.entry, self.half, self.passes);
        time.as_secs_f64()
    }

    fn round(&mut self) {
        let packets = f64::from(self.passes) * PACKETS as f64;
        self.times.push(self.measure() * 1e9 / packets);
    }

    /// Nanoseconds per packet.
    fn median(&mut self) -> f64 {
        self.times.sort_by(f64::total_cmp);
        self.times[self.times.len() / 2]
    }
}

/// Medians of interleaved rounds.
pub(crate) fn medians(mut all: Vec<Timed>) -> Vec<f64> {
    for _ in 0..ROUNDS {
        all.iter_mut().for_each(Timed::round);
    }
    all.iter_mut().map(Timed::median).collect()
}

/// Prints both tables.
pub fn print(surfaces: &[Forms]) {
    println!(
        "Operations, and ns per packet of eight segments on {} (medians of {ROUNDS} interleaved rounds): naive, shared, staged.\n",
        isa().name()
    );
    println!(
        "| surface | value | slope | curvature | value, ns | slope, ns | curvature, ns | naive / staged | shared / staged |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let mut lost = Vec::new();
    for s in surfaces {
        let report = s.forms[3].report();
        let counts = report
            .segment
            .map(|o| format!("{} {} {}", o.naive, o.shared, o.staged));
        let timed = |entry| [0, 1, 3].map(|form| Timed::new(s.forms[form].as_ref(), s.half, entry));
        let times = medians(ALONG.into_iter().flat_map(timed).collect());
        let cells: Vec<String> = times
            .chunks(3)
            .map(|t| format!("{:.1} {:.1} {:.1}", t[0], t[1], t[2]))
            .collect();
        let quotient = |form: usize| {
            let all: Vec<String> = times
                .chunks(3)
                .map(|t| format!("{:.2}", t[form] / t[2]))
                .collect();
            all.join(" ")
        };
        let least = times
            .chunks(3)
            .map(|t| t[1].min(t[0]) / t[2])
            .fold(f64::INFINITY, f64::min);
        if least < 0.95 {
            lost.push(format!("{} ({least:.2})", s.name));
        }
        println!(
            "| {} | {} | {} | {} | {} |",
            s.name,
            counts.join(" | "),
            cells.join(" | "),
            quotient(0),
            quotient(1)
        );
    }
    println!("\nSlower staged than in another form: {}.\n", list(&lost));
    print_space(surfaces);
}

fn print_space(surfaces: &[Forms]) {
    println!(
        "In space, staged: operations, ns per packet, and the quotients by the value alone (goals: 4 and 12).\n"
    );
    println!(
        "| surface | value | gradient | Hessian | value, ns | gradient, ns | Hessian, ns | gradient | Hessian |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let mut missed = Vec::new();
    for s in surfaces {
        let staged = s.forms[3].as_ref();
        let counts = staged.report().space.map(|o| o.staged.to_string());
        let t = medians(
            SPACE
                .into_iter()
                .map(|e| Timed::new(staged, s.half, e))
                .collect(),
        );
        let (gradient, hessian) = (t[1] / t[0], t[2] / t[0]);
        if gradient > 4.0 || hessian > 12.0 {
            missed.push(format!("{} ({gradient:.2}, {hessian:.2})", s.name));
        }
        println!(
            "| {} | {} | {:.1} | {:.1} | {:.1} | {gradient:.2} | {hessian:.2} |",
            s.name,
            counts.join(" | "),
            t[0],
            t[1],
            t[2]
        );
    }
    println!("\nBeyond the goals: {}.", list(&missed));
}

pub(crate) fn list(names: &[String]) -> String {
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}
