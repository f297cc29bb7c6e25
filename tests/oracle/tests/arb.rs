//! A second opinion on the sums of exponentials: arb, through python-flint, where it is installed.

#![forbid(unsafe_code)]

use std::path::Path;
use std::process::Command;

use zeroset::interval::Isa;
use zeroset_oracle::picture::say;
use zeroset_oracle::sample::sample;

/// Runs `arb.py` over a sample; nothing if there is no python.
fn second_opinion(name: &str, text: &str) -> Option<(bool, String)> {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&file, text).expect("the target folder can be written");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("arb.py");
    match Command::new("python3").arg(script).arg(file).output() {
        Ok(output) => {
            let text = String::from_utf8_lossy(&output.stdout).into_owned();
            Some((output.status.success(), text))
        }
        Err(error) => {
            say(&format!("SKIPPED arb: python3 does not run: {error}"));
            None
        }
    }
}

#[test]
fn arb_agrees() {
    let all = sample(1..=2, 10, Isa::available()[0]);
    let Some((fine, text)) = second_opinion("sums.txt", &all) else {
        return;
    };
    say(text.trim_end());
    assert!(fine, "{text}");
    if text.starts_with("SKIPPED") {
        return;
    }
    // The control: a miss in place of each root.
    let lie: Vec<String> = all
        .lines()
        .map(|line| match line.strip_prefix("root") {
            Some(rest) => {
                let ray: Vec<&str> = rest.split_whitespace().take(6).collect();
                format!("miss {}", ray.join(" "))
            }
            None => line.into(),
        })
        .collect();
    let (fine, text) = second_opinion("lies.txt", &lie.join("\n")).expect("it ran before");
    assert!(!fine && text.contains("wrong"), "{text}");
}
