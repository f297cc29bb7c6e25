//! Back-ends whose bounds are wrong in one way each, for tests that must notice.
//!
//! They are not among those of [`Isa`](super::Isa), for which every surface is compiled.

use super::rounding::{TooTight, Unguarded};
#[cfg(target_arch = "x86_64")]
use super::{Avx2, Avx512};
use super::{Kernel, Lanes, Portable};

/// A back-end with one thing missing.
#[derive(Clone, Copy, Debug)]
pub enum Control {
    /// AVX-512 with elementary functions that step a tenth of what was proved.
    #[cfg(target_arch = "x86_64")]
    Avx512TooTight(Avx512<TooTight>),
    /// AVX2 with a tenth of the widening.
    #[cfg(target_arch = "x86_64")]
    Avx2TooTight(Avx2<TooTight>),
    /// Portable with a tenth of the widening.
    PortableTooTight(Portable<TooTight>),
    /// AVX2 without guards.
    #[cfg(target_arch = "x86_64")]
    Avx2Unguarded(Avx2<Unguarded>),
    /// Portable without guards.
    PortableUnguarded(Portable<Unguarded>),
}

impl Control {
    /// Those that this processor can run.
    pub fn all() -> Vec<Control> {
        let mut all = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            all.extend(Avx512::detect().map(Control::Avx512TooTight));
            all.extend(Avx2::detect().map(Control::Avx2TooTight));
            all.extend(Avx2::detect().map(Control::Avx2Unguarded));
        }
        all.push(Control::PortableTooTight(Portable::new()));
        all.push(Control::PortableUnguarded(Portable::new()));
        all
    }

    /// Runs `kernel` with this back-end's token.
    pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self {
            #[cfg(target_arch = "x86_64")]
            Control::Avx512TooTight(p) => p.kernel(kernel),
            #[cfg(target_arch = "x86_64")]
            Control::Avx2TooTight(p) => p.kernel(kernel),
            Control::PortableTooTight(p) => p.kernel(kernel),
            #[cfg(target_arch = "x86_64")]
            Control::Avx2Unguarded(p) => p.kernel(kernel),
            Control::PortableUnguarded(p) => p.kernel(kernel),
        }
    }

    /// The name, which says what is wrong.
    pub fn name(self) -> &'static str {
        fn of<L: Lanes>(_: L) -> &'static str {
            L::NAME
        }
        match self {
            #[cfg(target_arch = "x86_64")]
            Control::Avx512TooTight(p) => of(p),
            #[cfg(target_arch = "x86_64")]
            Control::Avx2TooTight(p) => of(p),
            Control::PortableTooTight(p) => of(p),
            #[cfg(target_arch = "x86_64")]
            Control::Avx2Unguarded(p) => of(p),
            Control::PortableUnguarded(p) => of(p),
        }
    }
}
