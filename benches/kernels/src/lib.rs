//! What every interval operation costs: the operations, their operands, and the comparison of those who compute them.
//!
//! A library, so that the comparison with another crate (`benches/inari`) is the same code.

pub mod compare;
pub mod data;
pub mod operation;

pub use compare::{Contestant, compare};
pub use operation::Operation;

use data::Row;
use zeroset::interval::{Isa, Kernel, Packet};

/// Passes of one operation over all operands. They are counted inside of the kernel: the choice of a back-end and of the
/// loop takes as long as twenty additions of packets.
struct Passes<'a> {
    operation: Operation,
    count: u32,
    rows: &'a mut [Row],
}

impl Kernel for Passes<'_> {
    type Output = ();

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        operation::for_each(p, self.operation, self.count, self.rows);
    }
}

/// The back-ends that round, then those that do not.
pub fn back_ends() -> Vec<Contestant<'static>> {
    let mut all = Isa::available();
    all.extend(Isa::unrounded());
    let contestant = |isa: Isa| {
        let mut rows = data::rows();
        Contestant {
            name: isa.name(),
            passes: Box::new(move |operation, count| {
                isa.run(Passes {
                    operation,
                    count,
                    rows: &mut rows,
                });
                true
            }),
        }
    };
    all.into_iter().map(contestant).collect()
}
