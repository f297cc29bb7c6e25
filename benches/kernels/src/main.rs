//! Nanoseconds per interval of every operation on every back-end, and what rounding costs.
//!
//! `cargo run --release -p zeroset-bench-kernels [operation …]`
//!
//! The tax is the time beside that of the same code with rounding switched off. All operands are in the first-level
//! cache and an operation runs over all of them, so what is measured is throughput with loads and stores. Rounds are
//! interleaved, so that a change of the clock meets all alike. `benches/inari` prints the same beside the crate `inari`.

use zeroset_bench_kernels::{back_ends, compare};

fn main() {
    compare(
        &mut back_ends(),
        &[
            ("avx512", "avx512-unrounded", "tax avx512"),
            ("avx2", "avx2-unrounded", "tax avx2"),
            ("portable", "portable-unrounded", "tax portable"),
        ],
    );
}
