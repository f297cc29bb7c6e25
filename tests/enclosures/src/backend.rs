//! Every back-end behind one call.

use zeroset::interval::{Control, Interval, Isa, Kernel, Lanes, Packet, Scalar};

use crate::operation::{Operation, apply};

/// A back-end: an instruction set, or the scalar token.
#[derive(Clone, Copy, Debug)]
pub enum Backend {
    /// Eight lanes.
    Packet(Isa),
    /// One lane.
    Scalar,
    /// Eight lanes whose bounds are wrong in one way.
    Control(Control),
}

/// The operands of one operation; unary operations ignore `b`.
#[derive(Clone, Copy, Debug)]
pub struct Operands {
    /// The first operand.
    pub a: Interval,
    /// The second operand.
    pub b: Interval,
}

/// What one lane returned.
#[derive(Clone, Copy, Debug)]
pub struct Outcome {
    /// The enclosure.
    pub range: Interval,
    /// Its flags.
    pub empty: bool,
    /// Maybe undefined.
    pub undefined: bool,
    /// Maybe discontinuous.
    pub jump: bool,
    /// The derivative is maybe discontinuous.
    pub kink: bool,
}

impl Backend {
    /// Those whose bounds must hold on this processor.
    pub fn rounded() -> Vec<Backend> {
        let mut all: Vec<Backend> = Isa::available().into_iter().map(Backend::Packet).collect();
        all.push(Backend::Scalar);
        all
    }

    /// Those whose bounds must not.
    pub fn unrounded() -> Vec<Backend> {
        Isa::unrounded().into_iter().map(Backend::Packet).collect()
    }

    /// Those whose error bounds are a tenth of the proved ones.
    pub fn too_tight() -> Vec<Backend> {
        Self::controls("-too-tight")
    }

    /// Those that take no care of overflow and underflow.
    pub fn unguarded() -> Vec<Backend> {
        Self::controls("-unguarded")
    }

    fn controls(suffix: &str) -> Vec<Backend> {
        let mut all: Vec<Backend> = Control::all().into_iter().map(Backend::Control).collect();
        all.retain(|backend| backend.name().ends_with(suffix));
        all
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Backend::Packet(isa) => isa.name(),
            Backend::Scalar => Scalar::NAME,
            Backend::Control(control) => control.name(),
        }
    }

    /// Are its directed operations optimal?
    pub fn is_optimal(self) -> bool {
        matches!(self.name(), "avx512" | "scalar")
    }

    /// The operation on each pair of operands.
    pub fn run(self, operation: Operation, operands: &[Operands]) -> Vec<Outcome> {
        let batch = Batch {
            operation,
            operands,
        };
        match self {
            Backend::Packet(isa) => isa.run(batch),
            Backend::Scalar => batch.run(Scalar),
            Backend::Control(control) => control.run(batch),
        }
    }

    /// Newton's division.
    pub fn divide(self, num: Interval, den: Interval) -> Quotient {
        let division = Division { num, den };
        match self {
            Backend::Packet(isa) => isa.run(division),
            Backend::Scalar => division.run(Scalar),
            Backend::Control(control) => control.run(division),
        }
    }

    /// The operation on one pair.
    pub fn one(self, operation: Operation, a: Interval, b: Interval) -> Outcome {
        self.run(operation, &[Operands { a, b }])[0]
    }
}

struct Batch<'a> {
    operation: Operation,
    operands: &'a [Operands],
}

impl Kernel for Batch<'_> {
    type Output = Vec<Outcome>;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Vec<Outcome> {
        let mut out = Vec::with_capacity(self.operands.len());
        for chunk in self.operands.chunks(P::LANES) {
            let (mut a, mut b) = ([Interval::ONE; 8], [Interval::ONE; 8]);
            for (lane, operands) in chunk.iter().enumerate() {
                (a[lane], b[lane]) = (operands.a, operands.b);
            }
            let (range, flags) = apply(p, self.operation, load(p, a), load(p, b));
            let (lo, hi) = (p.to_array(range.lo), p.to_array(range.hi));
            for lane in 0..chunk.len() {
                let bit = |mask| p.bits(mask) >> lane & 1 == 1;
                out.push(Outcome {
                    range: Interval {
                        lo: lo[lane],
                        hi: hi[lane],
                    },
                    empty: bit(flags.empty),
                    undefined: bit(flags.undefined),
                    jump: bit(flags.jump),
                    kink: bit(flags.kink),
                });
            }
        }
        out
    }
}

/// What Newton's division of `num` by `den` returned: the pieces, whether both count, and whether there is none.
#[derive(Clone, Copy, Debug)]
pub struct Quotient {
    /// The only piece, or the lower one.
    pub first: Interval,
    /// The upper piece, if `two`.
    pub second: Interval,
    /// Are there two pieces?
    pub two: bool,
    /// Is there no quotient?
    pub empty: bool,
}

struct Division {
    num: Interval,
    den: Interval,
}

impl Kernel for Division {
    type Output = Quotient;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Quotient {
        let (num, den) = (load(p, [self.num; 8]), load(p, [self.den; 8]));
        let (first, second, two, empty) = p.div_ext(num, den);
        let piece = |a: Interval<P::F>| Interval {
            lo: p.to_array(a.lo)[0],
            hi: p.to_array(a.hi)[0],
        };
        Quotient {
            first: piece(first),
            second: piece(second),
            two: p.any(two),
            empty: p.any(empty),
        }
    }
}

/// Eight intervals as a packet.
#[inline(always)]
pub fn load<P: Packet>(p: P, x: [Interval; 8]) -> Interval<P::F> {
    let (mut lo, mut hi) = ([0.0; 8], [0.0; 8]);
    for lane in 0..8 {
        (lo[lane], hi[lane]) = (x[lane].lo, x[lane].hi);
    }
    Interval {
        lo: p.lanes(lo),
        hi: p.lanes(hi),
    }
}
