//! Every interval operation on every back-end beside the crate `inari`, in one run.
//!
//! `cd benches/inari && cargo run --release [operation …]`
//!
//! The quotients are inari's time by ours, and the tax of rounding. The folder's configuration compiles everything for
//! the processor at hand, as inari wants it, so the portable column is faster than it is for a user;
//! `zeroset-bench-kernels` prints the user's.

use inari::Interval;
use zeroset_bench_kernels::data::{Bounds, rows};
use zeroset_bench_kernels::{Contestant, Operation, back_ends, compare};

/// Operands and result as inari has them, in one line of the cache.
#[repr(align(64))]
struct Theirs {
    a: Interval,
    b: Interval,
    c: Interval,
    out: Interval,
}

/// The operands of the others, one by one.
fn theirs() -> Vec<Theirs> {
    let one = |x: &Bounds, i| Interval::try_from((x[0][i], x[1][i])).expect("lo ≤ hi");
    let mut all = Vec::new();
    for row in rows() {
        for i in 0..8 {
            let [a, b, c, out] = [&row.a, &row.b, &row.c, &row.out].map(|x| one(x, i));
            all.push(Theirs { a, b, c, out });
        }
    }
    all
}

/// One loop per operation; `f` is inlined into it.
#[inline(always)]
fn each((all, count): (&mut [Theirs], u32), f: impl Fn(Interval, Interval, Interval) -> Interval) {
    for _ in 0..count {
        for x in std::hint::black_box(&mut *all) {
            x.out = f(x.a, x.b, x.c);
        }
    }
}

/// `count` passes; false where inari has no such operation.
fn passes(operation: Operation, all: &mut [Theirs], count: u32) -> bool {
    let x = (all, count);
    match operation {
        Operation::Copy => each(x, |_, b, _| b),
        Operation::Add => each(x, |a, b, _| a + b),
        Operation::Sub => each(x, |a, b, _| a - b),
        Operation::Mul => each(x, |a, b, _| a * b),
        Operation::MulPos => each(x, |_, b, c| c * b),
        Operation::MulPosPos => each(x, |_, _, c| c * c),
        Operation::Sqr => each(x, |_, b, _| b.sqr()),
        Operation::Powi6 => each(x, |_, b, _| b.powi(6)),
        Operation::Div => each(x, |a, b, _| a / b),
        Operation::Recip => each(x, |_, b, _| b.recip()),
        Operation::Sqrt => each(x, |_, _, c| c.sqrt()),
        Operation::Hypot => each(x, |a, b, _| (a.sqr() + b.sqr()).sqrt()),
        Operation::QuadraticLeaf | Operation::Cbrt => return false,
        Operation::ExpM1 | Operation::Ln1p => return false,
        Operation::Exp => each(x, |_, b, _| b.exp()),
        Operation::Exp2 => each(x, |_, b, _| b.exp2()),
        Operation::Ln => each(x, |_, _, c| c.ln()),
        Operation::Log2 => each(x, |_, _, c| c.log2()),
        Operation::Log10 => each(x, |_, _, c| c.log10()),
        Operation::Sin => each(x, |_, b, _| b.sin()),
        Operation::Cos => each(x, |_, b, _| b.cos()),
        Operation::Tan => each(x, |_, _, c| c.tan()),
        Operation::Asin => each(x, |_, _, c| c.asin()),
        Operation::Acos => each(x, |_, _, c| c.acos()),
        Operation::Atan => each(x, |_, b, _| b.atan()),
        Operation::Atan2 => each(x, |a, b, _| a.atan2(b)),
        Operation::Sinh => each(x, |_, b, _| b.sinh()),
        Operation::Cosh => each(x, |_, b, _| b.cosh()),
        Operation::Tanh => each(x, |_, b, _| b.tanh()),
        Operation::Asinh => each(x, |_, b, _| b.asinh()),
        Operation::Acosh => each(x, |_, _, c| c.recip().acosh()),
        Operation::Atanh => each(x, |_, _, c| c.atanh()),
        Operation::Pow => each(x, |_, b, c| c.pow(b)),
    }
    true
}

fn main() {
    let mut theirs = theirs();
    let mut all = back_ends();
    all.push(Contestant {
        name: "inari",
        passes: Box::new(move |operation, count| passes(operation, &mut theirs, count)),
    });
    compare(
        &mut all,
        &[
            ("inari", "avx512", "inari/avx512"),
            ("inari", "avx2", "inari/avx2"),
            ("avx512", "avx512-unrounded", "tax avx512"),
            ("avx2", "avx2-unrounded", "tax avx2"),
        ],
    );
}
