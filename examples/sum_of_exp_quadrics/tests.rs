//! The program as a whole: what it refuses, and what it writes.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::run;

mod certificates;

/// Runs the program with these arguments; what it printed, or why it failed.
fn program(arguments: &[&str]) -> Result<String, Failure> {
    let mut out = Vec::new();
    let name = std::iter::once("sum_of_exp_quadrics");
    let arguments = name.chain(arguments.iter().copied()).map(OsString::from);
    run(arguments, &mut out)?;
    Ok(String::from_utf8(out).expect("text"))
}

/// A folder of this test's own in the target folder's place for such things.
fn folder(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("zeroset-example-{}-{name}", std::process::id()));
    // Left over from an earlier process of this number, if at all.
    let _ = std::fs::remove_dir_all(&path);
    path
}

fn assert_picture(path: &Path, size: u32) -> image::RgbImage {
    let picture = image::open(path).expect("a picture that decodes").to_rgb8();
    assert_eq!(picture.dimensions(), (size, size), "{}", path.display());
    picture
}

#[test]
fn bad_arguments_are_refused_in_words() {
    for (arguments, names) in [
        (&["--terms", "0"][..], "1..=4096"),
        (&["--terms", "many"], "many"),
        (&["--size", "0"], "1..=4096"),
        (&["--size", "100000"], "1..=4096"),
        (&["--seed", "-1"], "--seed"),
        (&["--solver", "newtn"], "newton"),
        (&["--sise", "5"], "--size"),
        (&["picture.png"], "picture.png"),
    ] {
        let failure = program(arguments).expect_err("refused");
        assert_eq!(failure.code(), 2, "{arguments:?}");
        let message = failure.to_string();
        assert!(message.contains(names), "{arguments:?}: {message}");
    }
}

#[test]
fn help_is_no_failure() {
    let help = program(&["--help"]).expect_err("help ends the program");
    assert_eq!(help.code(), 0);
    for option in [
        "--terms",
        "--size",
        "--seed",
        "--solver",
        "--out",
        "--figures",
        "--certificate",
    ] {
        assert!(help.to_string().contains(option), "{option}");
    }
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let file = folder("a-file");
    std::fs::write(&file, "in the way").expect("a file");
    let out = file.join("pictures");
    let failure = program(&["--size", "8", "--out", &out.to_string_lossy()]).expect_err("refused");
    assert_eq!(failure.code(), 1);
    assert!(failure.to_string().contains("pictures"), "{failure}");
    std::fs::remove_file(file).expect("removed");
}

#[test]
fn each_solver_writes_the_same_surface() {
    let mut pictures = Vec::new();
    for solver in ["bisection", "newton", "newton2", "halley", "auto"] {
        let out = folder(solver);
        let to = out.to_string_lossy();
        let text = program(&[
            "--size", "40", "--terms", "3", "--solver", solver, "--out", &to,
        ])
        .expect("a picture");
        for needed in ["seed 4", solver, "miss", "curvature", "normals", "wrote"] {
            assert!(text.contains(needed), "{solver}: no `{needed}` in\n{text}");
        }
        assert_picture(&out.join("verdicts.png"), 40);
        pictures.push(assert_picture(&out.join("sum_of_exp_quadrics.png"), 40));
        std::fs::remove_dir_all(out).expect("removed");
    }
    let first = &pictures[0];
    let background = first.get_pixel(0, 0);
    let seen = first.pixels().filter(|p| *p != background).count();
    assert!(seen > 100, "the surface is in the picture: {seen} pixels");
    for other in &pictures[1..] {
        // Roots differ in their last digits, and a tangent pixel may differ; shapes do not.
        let far =
            |(a, b): (&image::Rgb<u8>, &image::Rgb<u8>)| (0..3).any(|k| a[k].abs_diff(b[k]) > 8);
        let different = first
            .pixels()
            .zip(other.pixels())
            .filter(|&p| far(p))
            .count();
        assert!(different <= 4, "{different} pixels differ");
    }
}

#[test]
fn another_seed_is_another_surface() {
    let picture = |seed: &str| {
        let out = folder(&format!("seed-{seed}"));
        program(&[
            "--size",
            "40",
            "--seed",
            seed,
            "--out",
            &out.to_string_lossy(),
        ])
        .expect("a picture");
        let picture = assert_picture(&out.join("sum_of_exp_quadrics.png"), 40);
        std::fs::remove_dir_all(out).expect("removed");
        picture
    };
    assert_eq!(picture("7"), picture("7"));
    assert_ne!(picture("7"), picture("8"));
}
