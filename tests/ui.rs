//! What rustc prints for mistakes in a formula: texts, underlines, and nothing about their consequences.
//!
//! rustc words its own part of these messages, so they are compared on one version only.
//! `TRYBUILD=overwrite cargo test --test ui` writes the expectations anew.

use std::io::Write;
use std::process::Command;

/// The version on which the expectations were written.
const RUSTC: &str = "rustc 1.95.";

#[test]
fn ui() {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version = Command::new(rustc)
        .arg("--version")
        .output()
        .unwrap()
        .stdout;
    let version = String::from_utf8_lossy(&version).into_owned();
    if !version.starts_with(RUSTC) {
        // Straight to the stream: what tests print is hidden when they pass.
        let skipped = format!("SKIPPED ui: expectations are those of {RUSTC}x, this is {version}");
        let _ = std::io::stderr().write_all(skipped.as_bytes());
        return;
    }
    let cases = trybuild::TestCases::new();
    cases.compile_fail("tests/ui/*.rs");
    cases.pass("tests/ui/pass/*.rs");
}
