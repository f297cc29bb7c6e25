//! A second opinion on the sums of exponentials: arb, through python-flint, where it is installed.

#![forbid(unsafe_code)]

#[path = "../../support/python.rs"]
mod python;

use zeroset::interval::Isa;
use zeroset_oracle::sample::sample;

#[test]
fn arb_agrees() {
    let test = "answers against arb";
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/arb.py");
    let all = sample(1..=2, 10, Isa::available()[0]);
    let Some((fine, said)) = python::agrees(test, script, &all) else {
        return;
    };
    println!("{said}");
    assert!(fine, "{said}");
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
    let (fine, said) = python::agrees(test, script, &lie.join("\n")).expect("it ran before");
    assert!(!fine && said.contains("wrong"), "{said}");
}
