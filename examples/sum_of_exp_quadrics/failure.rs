//! What can go wrong, in words for the terminal.

use std::path::{Path, PathBuf};

use zeroset::camera::CameraError;
use zeroset::render::RenderError;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The command line is wrong; or it asks for help, which is no failure.
    #[error(transparent)]
    Arguments(#[from] clap::Error),
    /// The camera is wrong.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// The render is refused.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The certificate cannot be written.
    #[error(transparent)]
    Certificate(#[from] zeroset::certificate::CertificateError),
    /// The instruction set that was asked for does not exist here.
    #[error(transparent)]
    Isa(#[from] zeroset::interval::IsaError),
    /// A file or folder cannot be written.
    #[error("cannot write `{}`: {source}", path.display())]
    Write {
        /// Which one.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A picture cannot be written.
    #[error("cannot write `{}`: {source}", path.display())]
    Picture {
        /// Which one.
        path: PathBuf,
        /// Why.
        source: image::ImageError,
    },
    /// The terminal or pipe is closed.
    #[error("cannot print: {0}")]
    Print(#[from] std::io::Error),
}

impl Failure {
    /// Names the file that could not be written.
    pub fn write(path: &Path) -> impl FnOnce(std::io::Error) -> Failure {
        move |source| Failure::Write {
            path: path.to_owned(),
            source,
        }
    }

    /// The exit code: 2 for a wrong command line, as is usual, 1 for all else, 0 where help was asked for.
    pub fn code(&self) -> u8 {
        match self {
            Failure::Arguments(error) => u8::from(error.use_stderr()) * 2,
            _ => 1,
        }
    }
}
