//! `cargo run --release -p zeroset-bench-graphs [surface …]` prints what sharing and stages are worth: operations and
//! times, the cost of derivatives in space, polynomials from coefficients, and widths on the paper's family.

#![forbid(unsafe_code)]

use zeroset_bench_graphs::{polynomials, surfaces, table, width};

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let mut all = surfaces::all();
    all.retain(|s| wanted.is_empty() || wanted.iter().any(|name| name == s.name));
    table::print(&all);
    polynomials::print(&all);
    width::print(&all);
}
