//! Nanoseconds per interval of every operation, on every back-end, with and without rounding.
//!
//! `cargo run --release -p zeroset-bench-kernels [operation …]`
//!
//! Operands are 512 packets in the first-level cache; an operation runs over all of them, so what is measured is
//! throughput with loads and stores. Rounds of all back-ends are interleaved and the median of each is taken, so that a
//! change of the clock meets all alike.

mod operation;

use std::hint::black_box;
use std::time::Instant;

use operation::Operation;
use zeroset::interval::{Interval, Isa, Kernel, Packet};

/// Intervals per pass.
const COUNT: usize = 512;
/// Rounds of which the median is taken.
const ROUNDS: usize = 31;

/// Operands and room for results: lower and upper bounds.
struct Data {
    a: [Vec<f64>; 2],
    b: [Vec<f64>; 2],
    out: [Vec<f64>; 2],
}

/// One pass of one operation.
struct Pass<'a> {
    operation: Operation,
    data: &'a mut Data,
}

/// The packet of intervals from `i` on.
#[inline(always)]
fn load<P: Packet>(p: P, x: &[Vec<f64>; 2], i: usize) -> Interval<P::F> {
    let at = |x: &[f64]| p.lanes(x[i..i + 8].try_into().expect("eight numbers"));
    Interval {
        lo: at(&x[0]),
        hi: at(&x[1]),
    }
}

impl Kernel for Pass<'_> {
    type Output = ();

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        let data = self.data;
        operation::for_each(p, self.operation, COUNT / 8, data);
    }
}

/// Numbers that all domains share and that no branch predictor learns.
fn data() -> Data {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let mut next = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut bounds = |least: f64, greatest: f64| {
        let (mut lo, mut hi) = (Vec::new(), Vec::new());
        for _ in 0..COUNT {
            let start = least + (greatest - least) * next();
            lo.push(start);
            hi.push(start + 0.05 * next());
        }
        [lo, hi]
    };
    Data {
        a: bounds(0.05, 0.9),
        b: bounds(-2.0, 2.0),
        out: [vec![0.0; COUNT], vec![0.0; COUNT]],
    }
}

/// Nanoseconds per interval of one pass, repeated until it lasts.
fn measure(isa: Isa, operation: Operation, data: &mut Data, passes: u32) -> f64 {
    let start = Instant::now();
    for _ in 0..passes {
        isa.run(Pass {
            operation,
            data: black_box(&mut *data),
        });
    }
    start.elapsed().as_secs_f64() * 1e9 / (f64::from(passes) * COUNT as f64)
}

fn main() {
    let wanted: Vec<String> = std::env::args()
        .skip(1)
        .filter(|argument| !argument.starts_with('-'))
        .collect();
    let mut all = Isa::available();
    all.extend(Isa::unrounded());
    print!("{:<14}", "ns/interval");
    for isa in &all {
        print!("{:>20}", isa.name());
    }
    println!();
    let mut data = data();
    for operation in operation::ALL {
        if !wanted.is_empty() && !wanted.iter().any(|name| name == operation.name()) {
            continue;
        }
        // Slow operations make fewer passes: a tenth of a millisecond each.
        let passes: Vec<u32> = all
            .iter()
            .map(|&isa| {
                measure(isa, operation, &mut data, 2);
                let once = measure(isa, operation, &mut data, 2) * COUNT as f64;
                (1e5 / once).clamp(1.0, 1e4) as u32
            })
            .collect();
        let mut times = vec![Vec::new(); all.len()];
        for _ in 0..ROUNDS {
            for (i, &isa) in all.iter().enumerate() {
                times[i].push(measure(isa, operation, &mut data, passes[i]));
            }
        }
        print!("{:<14}", operation.name());
        for mut times in times {
            times.sort_by(f64::total_cmp);
            print!("{:>20.2}", times[ROUNDS / 2]);
        }
        println!();
    }
}
