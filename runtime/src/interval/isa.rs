//! Which instruction set a render uses.

#[cfg(target_arch = "x86_64")]
use super::{Avx2, Avx512};
use super::{Kernel, Lanes, Portable, Rounding, environment};

/// A back-end that this processor has. It is chosen once per render; [`run`](Self::run) enters it.
#[derive(Clone, Copy, Debug)]
pub struct Isa(Token);

/// Declares the tokens (one that this processor lacks cannot be made) and what is done with each of them.
macro_rules! tokens {
    ($($(#[$condition:meta])* $variant:ident($token:ty) = $detect:expr;)*) => {
        #[derive(Clone, Copy, Debug)]
        enum Token {
            $($(#[$condition])* $variant($token),)*
        }

        impl Isa {
            /// Every back-end of this processor, best first, then those without rounding.
            fn all() -> Vec<Isa> {
                let mut all = Vec::new();
                $($(#[$condition])* {
                    let token: Option<$token> = $detect;
                    all.extend(token.map(|token| Isa(Token::$variant(token))));
                })*
                all
            }

            /// Runs `kernel` with this back-end's token.
            pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
                match self.0 {
                    $($(#[$condition])* Token::$variant(p) => p.kernel(kernel),)*
                }
            }

            /// As [`run`](Self::run), of kernels that are compiled for the back-ends whose bounds do, or do not, hold.
            fn run_where<K: Kernel, const HOLDS: bool>(self, kernel: K) -> K::Output {
                match self.0 {
                    $($(#[$condition])* Token::$variant(p) => {
                        if const { <<$token as Lanes>::Rounding as Rounding>::HOLDS == HOLDS } {
                            p.kernel(kernel)
                        } else {
                            panic!(
                                "{self}: a surface is rendered without rounding by the solver `contract::unsound::Unrounded` alone, \
                                 which does nothing else"
                            )
                        }
                    })*
                }
            }

            /// The name that `ZEROSET_ISA` takes.
            pub fn name(self) -> &'static str {
                match self.0 {
                    $($(#[$condition])* Token::$variant(_) => <$token>::NAME,)*
                }
            }

            /// False for the back-ends whose bounds do not hold.
            fn is_directed(self) -> bool {
                match self.0 {
                    $($(#[$condition])* Token::$variant(_) => <<$token as Lanes>::Rounding as Rounding>::HOLDS,)*
                }
            }
        }
    };
}

tokens! {
    #[cfg(target_arch = "x86_64")]
    Avx512(Avx512) = Avx512::detect();
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2) = Avx2::detect();
    Portable(Portable) = Some(Portable::new());
    #[cfg(all(target_arch = "x86_64", feature = "one-lane"))]
    One(super::One) = super::One::detect();
    #[cfg(all(target_arch = "x86_64", feature = "unrounded"))]
    Avx512Unrounded(Avx512<super::ToNearest>) = Avx512::detect();
    #[cfg(all(target_arch = "x86_64", feature = "unrounded"))]
    Avx2Unrounded(Avx2<super::ToNearest>) = Avx2::detect();
    #[cfg(feature = "unrounded")]
    PortableUnrounded(Portable<super::ToNearest>) = Some(Portable::new());
}

/// Lists an associated constant for every back-end. Generic functions are compiled in the crate that names their types:
/// what is listed is compiled in this one, and found by its type.
macro_rules! back_ends {
    ($list:ident: $of:ident::$constant:ident) => {
        static $list: &[&(dyn core::any::Any + Send + Sync)] = &[
            #[cfg(target_arch = "x86_64")]
            &$of::<$crate::interval::Avx512>::$constant,
            #[cfg(target_arch = "x86_64")]
            &$of::<$crate::interval::Avx2>::$constant,
            &$of::<$crate::interval::Portable>::$constant,
            #[cfg(all(target_arch = "x86_64", feature = "one-lane"))]
            &$of::<$crate::interval::One>::$constant,
            #[cfg(all(target_arch = "x86_64", feature = "unrounded"))]
            &$of::<$crate::interval::Avx512<$crate::interval::ToNearest>>::$constant,
            #[cfg(all(target_arch = "x86_64", feature = "unrounded"))]
            &$of::<$crate::interval::Avx2<$crate::interval::ToNearest>>::$constant,
            #[cfg(feature = "unrounded")]
            &$of::<$crate::interval::Portable<$crate::interval::ToNearest>>::$constant,
        ];
    };
}
pub(crate) use back_ends;

/// Names of the back-ends and the processor features that they need.
const KNOWN: [(&str, &str); 3] = [
    ("avx512", "avx512f, avx512dq"),
    ("avx2", "avx2, fma"),
    ("portable", "none"),
];

/// Why there is no such back-end.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum IsaError {
    /// The name is none of the back-ends.
    #[error("no instruction set is named `{name}`: ZEROSET_ISA is one of avx512, avx2, portable")]
    Unknown {
        /// The name as given.
        name: String,
    },
    /// Someone changed how this thread computes.
    #[error(
        "this thread does not round to nearest, or flushes subnormal numbers to 0: no bound would hold"
    )]
    Environment,
    /// The back-end exists, and this processor cannot run it.
    #[error(
        "this processor has no {name}, which needs {needs}: unset ZEROSET_ISA to use the best that it has"
    )]
    Missing {
        /// The name as given.
        name: &'static str,
        /// The processor features that the back-end needs.
        needs: &'static str,
    },
}

impl Isa {
    /// The best back-end of this processor, or the one that the environment variable `ZEROSET_ISA` names.
    ///
    /// # Errors
    /// If the variable names no back-end, or one that this processor lacks: it is never silently replaced. If this
    /// thread does not compute to nearest, or has no subnormal numbers.
    pub fn detect() -> Result<Isa, IsaError> {
        if !environment::is_ieee() {
            return Err(IsaError::Environment);
        }
        match std::env::var("ZEROSET_ISA") {
            Ok(name) if !name.is_empty() => Self::named(&name),
            Err(std::env::VarError::NotUnicode(name)) => Err(IsaError::Unknown {
                name: name.to_string_lossy().into_owned(),
            }),
            _ => Ok(Self::available()[0]),
        }
    }

    /// The back-end of this name.
    ///
    /// # Errors
    /// If there is none, or this processor lacks it.
    pub fn named(name: &str) -> Result<Isa, IsaError> {
        if let Some(isa) = Self::all().into_iter().find(|isa| isa.name() == name) {
            return Ok(isa);
        }
        match KNOWN.iter().find(|known| known.0 == name) {
            Some(&(name, needs)) => Err(IsaError::Missing { name, needs }),
            None => Err(IsaError::Unknown {
                name: name.to_owned(),
            }),
        }
    }

    /// As [`run`](Self::run), of a surface's kernel: where tests bring the back-ends whose bounds do not hold, no surface is
    /// compiled for them that does not ask for it.
    pub(crate) fn run_surface<K: Kernel>(self, kernel: K) -> K::Output {
        self.run_where::<K, true>(kernel)
    }

    /// As [`run`](Self::run), with the back-ends whose bounds do not hold alone.
    #[cfg(feature = "unrounded")]
    pub(crate) fn run_unrounded<K: Kernel>(self, kernel: K) -> K::Output {
        self.run_where::<K, false>(kernel)
    }

    /// All back-ends of this processor whose bounds hold, best first; the portable one is always among them.
    pub fn available() -> Vec<Isa> {
        let mut all = Self::all();
        all.retain(|isa| isa.is_directed());
        all
    }

    /// The back-ends with rounding switched off, for negative controls and to measure what rounding costs. They render
    /// surfaces that have the solver [`Unrounded`](crate::contract::unsound::Unrounded), and no others.
    #[cfg(feature = "unrounded")]
    #[doc(hidden)]
    pub fn unrounded() -> Vec<Isa> {
        let mut all = Self::all();
        all.retain(|isa| !isa.is_directed());
        all
    }
}

impl PartialEq for Isa {
    fn eq(&self, other: &Isa) -> bool {
        self.name() == other.name()
    }
}

impl Eq for Isa {}

impl std::fmt::Display for Isa {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
