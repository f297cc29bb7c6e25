//! A second opinion by a script, where Python runs.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// Gives `text` to a script's standard input. Does the script agree, and what does it say? Nothing if it cannot run, or
/// lacks what it needs: then a line says that `test` was skipped.
pub fn agrees(test: &str, script: impl AsRef<Path>, text: &str) -> Option<(bool, String)> {
    let mut python = Command::new("python3");
    let python = python.arg(script.as_ref());
    let started = python.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
    let mut child = match started {
        Ok(child) => child,
        Err(error) => {
            say(&format!("SKIPPED {test}: python3 does not run: {error}"));
            return None;
        }
    };
    let mut input = child.stdin.take().expect("a pipe");
    let done = std::thread::scope(|scope| {
        // Beside reading, lest both sides wait for each other. A script that skips does not read.
        scope.spawn(move || drop(input.write_all(text.as_bytes())));
        child.wait_with_output().expect("an end")
    });
    let said = String::from_utf8_lossy(&done.stdout).trim_end().to_string();
    if said.starts_with("SKIPPED") {
        say(&said);
        return None;
    }
    Some((done.status.success(), said))
}

/// Past the test harness, which keeps what `println!` says to itself.
fn say(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}
