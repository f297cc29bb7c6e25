//! How long formulas take to expand: `cargo run -p zeroset-compiler --example expand -- FILE…` prints milliseconds.
//!
//! The least of many runs, in process: what is above it is the machine's other work. `scripts/build-cost` calls it without optimisation, as Cargo builds macros.

use proc_macro2::TokenStream;
use std::time::Instant;
use zeroset_compiler::expand;

const RUNS: usize = 31;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for file in std::env::args().skip(1) {
        let source = std::fs::read_to_string(&file)?;
        let input: TokenStream = format!("zeroset {source}").parse()?;
        let mut least = f64::INFINITY;
        let mut length = 0;
        for _ in 0..RUNS {
            let copy = input.clone();
            let start = Instant::now();
            let code = expand(copy);
            least = least.min(start.elapsed().as_secs_f64() * 1000.0);
            let code = code.to_string();
            if code.contains("compile_error") {
                return Err(format!("{file}: {code}").into());
            }
            length = code.len();
        }
        println!("{file} {least:.1} {length}");
    }
    Ok(())
}
