//! Rounds of all contestants, interleaved, and a table of medians.

use cpu_time::ProcessTime;

use crate::data::ROWS;
use crate::operation::{self, Operation};

/// Intervals per pass.
const COUNT: usize = 8 * ROWS;
/// Rounds of which the median is taken.
const ROUNDS: usize = 41;
/// Nanoseconds that a measurement should take at least.
const LEAST: f64 = 2e5;

/// Someone who computes operations.
pub struct Contestant<'a> {
    /// The head of its column.
    pub name: &'static str,
    /// So many passes over all operands; false if the operation is missing.
    pub passes: Box<dyn FnMut(Operation, u32) -> bool + 'a>,
}

impl Contestant<'_> {
    /// Nanoseconds of processor time per interval, for so many passes.
    fn measure(&mut self, operation: Operation, passes: u32) -> f64 {
        let start = ProcessTime::now();
        (self.passes)(operation, passes);
        start.elapsed().as_secs_f64() * 1e9 / (f64::from(passes) * COUNT as f64)
    }

    /// How many passes make a measurement; 0 if the operation is missing.
    fn enough(&mut self, operation: Operation) -> u32 {
        if !(self.passes)(operation, 1) {
            return 0;
        }
        let once = self.measure(operation, 8) * COUNT as f64;
        (LEAST / once).clamp(1.0, 1e5) as u32
    }
}

/// The medians of one operation, in the order of the contestants.
fn medians(all: &mut [Contestant], operation: Operation) -> Vec<Option<f64>> {
    let passes: Vec<u32> = all.iter_mut().map(|one| one.enough(operation)).collect();
    let mut times = vec![Vec::new(); all.len()];
    for _ in 0..ROUNDS {
        for (i, one) in all.iter_mut().enumerate() {
            if passes[i] > 0 {
                times[i].push(one.measure(operation, passes[i]));
            }
        }
    }
    times
        .into_iter()
        .map(|mut times| {
            times.sort_by(f64::total_cmp);
            times.get(times.len() / 2).copied()
        })
        .collect()
}

/// Prints nanoseconds per interval for each operation named on the command line, or all; then the quotients of two
/// contestants, given by their names and the head of the column.
pub fn compare(all: &mut [Contestant], quotients: &[(&str, &str, &str)]) {
    let wanted: Vec<String> = std::env::args()
        .skip(1)
        .filter(|a| !a.starts_with('-'))
        .collect();
    println!(
        "ns of processor time per interval, {COUNT} intervals a pass, medians of {ROUNDS} interleaved rounds"
    );
    let rounded = |name: &str| !name.ends_with("-unrounded");
    print!("{:<12}", "");
    for one in all.iter().filter(|one| rounded(one.name)) {
        print!("{:>10}", one.name);
    }
    for (_, _, head) in quotients {
        print!("{head:>16}");
    }
    println!();
    for operation in operation::ALL {
        if !wanted.is_empty() && !wanted.iter().any(|name| name == operation.name()) {
            continue;
        }
        let times = medians(all, operation);
        let of = |name: &str| times[all.iter().position(|one| one.name == name)?];
        print!("{:<12}", operation.name());
        for one in all.iter().filter(|one| rounded(one.name)) {
            print!(
                "{:>10}",
                of(one.name).map_or("-".to_owned(), |t| format!("{t:.2}"))
            );
        }
        for (above, below, _) in quotients {
            let quotient = of(above).zip(of(below)).map(|(a, b)| a / b);
            print!(
                "{:>16}",
                quotient.map_or("-".to_owned(), |q| format!("{q:.2}"))
            );
        }
        println!();
    }
}
