//! Which instruction set a render uses.

use super::{Kernel, Portable};

/// A back-end that this processor has. It is chosen once per render; [`run`](Self::run) enters it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Isa(Kind);

/// The back-ends, best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Kind {
    Portable,
    #[cfg(feature = "unrounded")]
    PortableUnrounded,
}

/// Why there is no such back-end.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum IsaError {
    /// The name is none of the back-ends.
    #[error("no instruction set is named `{name}`: ZEROSET_ISA is one of avx512, avx2, portable")]
    Unknown {
        /// The name as given.
        name: String,
    },
    /// The back-end exists, and this processor cannot run it.
    #[error(
        "this processor has no {name}: it lacks one of {needs}; without ZEROSET_ISA the best that it has is used"
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
    /// If the variable names no back-end, or one that this processor lacks. It is never silently replaced.
    pub fn detect() -> Result<Isa, IsaError> {
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
        match name {
            "portable" => Ok(Isa(Kind::Portable)),
            #[cfg(feature = "unrounded")]
            "portable-unrounded" => Ok(Isa(Kind::PortableUnrounded)),
            _ => Err(IsaError::Unknown {
                name: name.to_owned(),
            }),
        }
    }

    /// All back-ends of this processor whose bounds hold, best first. Never empty.
    pub fn available() -> Vec<Isa> {
        vec![Isa(Kind::Portable)]
    }

    /// The same back-ends with rounding switched off, for negative controls.
    #[cfg(feature = "unrounded")]
    #[doc(hidden)]
    pub fn unrounded() -> Vec<Isa> {
        vec![Isa(Kind::PortableUnrounded)]
    }

    /// Runs `kernel` with this back-end's token.
    pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
        use super::Lanes;
        match self.0 {
            Kind::Portable => Portable::<super::Directed>::new().kernel(kernel),
            #[cfg(feature = "unrounded")]
            Kind::PortableUnrounded => Portable::<super::ToNearest>::new().kernel(kernel),
        }
    }

    /// The name that `ZEROSET_ISA` takes.
    pub fn name(self) -> &'static str {
        match self.0 {
            Kind::Portable => "portable",
            #[cfg(feature = "unrounded")]
            Kind::PortableUnrounded => "portable-unrounded",
        }
    }
}

impl std::fmt::Display for Isa {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
