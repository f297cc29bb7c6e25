//! A certificate is proved by a program that shares nothing with this one, and refused once anything in it is changed.

use std::fs;
use std::io::{Write, stderr};
use std::path::Path;
use std::process::Command;

use super::{folder, program};

/// The checker's exit code; nothing if it cannot run here.
fn check(certificate: &Path) -> Option<i32> {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("scripts/check-certificate");
    let done = Command::new("python3")
        .arg(script)
        .arg(certificate)
        .output();
    let text = match &done {
        Ok(done) => String::from_utf8_lossy(&done.stdout).into_owned(),
        Err(error) => format!("SKIPPED certificate: python3 does not run: {error}"),
    };
    if text.starts_with("SKIPPED") {
        // Not through the test's captured output: a skip is to be seen.
        let _ = writeln!(stderr(), "{}", text.trim());
        return None;
    }
    done.ok()?.status.code()
}

/// The text with its checksum made right again.
fn signed(lines: &[String]) -> String {
    let body = lines[..lines.len() - 1].join("\n") + "\n";
    let sum = crc32fast::hash(body.as_bytes());
    format!("{body}crc32 {sum:08x}\n")
}

/// A line with one of its numbers changed.
fn changed(line: &str, word: usize, change: impl Fn(f64) -> f64) -> String {
    let mut words: Vec<String> = line.split(' ').map(str::to_owned).collect();
    let bits = u64::from_str_radix(&words[word], 16).expect("a number");
    words[word] = format!("{:016x}", change(f64::from_bits(bits)).to_bits());
    words.join(" ")
}

#[test]
fn others_can_check_a_picture() {
    let out = folder("certificate");
    fs::create_dir_all(&out).expect("a folder");
    let file = out.join("certificate.txt");
    let path = file.to_string_lossy();
    let to = out.to_string_lossy();
    program(&[
        "--size",
        "8",
        "--terms",
        "3",
        "--out",
        &to,
        "--certificate",
        &path,
    ])
    .expect("a picture and its certificate");
    let text = fs::read_to_string(&file).expect("a certificate");
    let verdict = |text: &str| {
        fs::write(&file, text).expect("written");
        check(&file)
    };
    if let Some(code) = verdict(&text) {
        assert_eq!(code, 0, "all claims are proved");
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        assert_eq!(signed(&lines), text);
        let find = |word: &str| {
            let found = lines.iter().position(|l| l.starts_with(word));
            found.unwrap_or_else(|| panic!("no {word}"))
        };
        let root = find("root ");
        let mut lies = Vec::new();
        let mut lie = |change: &dyn Fn(&mut Vec<String>)| {
            let mut lines = lines.clone();
            change(&mut lines);
            lies.push(signed(&lines));
        };
        // The hit becomes a miss; a root beside the true one; one that is not the first; a ray that ends too early.
        lie(&|lines| drop(lines.remove(root)));
        lie(&|lines| {
            let right = changed(&lines[root], 1, |t| t + 1e-9);
            lines[root] = changed(&right, 2, |t| t + 1e-9);
        });
        lie(&|lines| lines[root] = changed(&lines[root], 2, |t| t + 1.0));
        lie(&|lines| lines[find("ray ")] = changed(&lines[find("ray ")], 11, |t| 0.5 * t));
        for lie in lies {
            assert_eq!(verdict(&lie), Some(1));
        }
        for place in (0..text.len()).step_by(text.len() / 12) {
            let mut bytes = text.clone().into_bytes();
            bytes[place] ^= 1;
            assert_eq!(verdict(&String::from_utf8_lossy(&bytes)), Some(2));
        }
    }
    fs::remove_dir_all(out).expect("removed");
}
