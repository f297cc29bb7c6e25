//! `cargo run --release -p zeroset-bench-graphs [surface …]` prints what sharing and stages are worth.

#![forbid(unsafe_code)]

use zeroset_bench_graphs::{polynomials, surfaces, table};

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let mut all = surfaces::all();
    all.retain(|s| wanted.is_empty() || wanted.iter().any(|name| name == s.name));
    table::print(&all);
    polynomials::print(&all);
}
