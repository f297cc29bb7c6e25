//! Beside POV-Ray's isosurface of accuracy 1e-4: its own processor time for tracing, without light or shadow.
//!
//! Its picture shows depth as a colour of 16 bits.

use crate::Arguments;
use crate::judge::Sampled;
use crate::shapes::{Isosurface, Shape};
use crate::timing::{Spread, digits, pool, timed};
use crate::view::{Place, Shown, View};
use std::path::Path;
use std::process::Command;
use std::time::Duration;

/// The side of the picture.
const SIZE: u32 = 512;
const PLACE: Place = Place::Centre;

/// A finished picture of POV-Ray.
struct Picture {
    trace: Duration,
    /// Its complaints about the bound of the gradient.
    complaint: Option<String>,
    /// Pixels, three big-endian numbers of 16 bits each.
    pixels: Vec<u8>,
}

/// All shapes that it is told about.
pub fn run(shapes: &[Shape], arguments: &Arguments) {
    if Command::new("povray").arg("--version").output().is_err() {
        println!("\nSKIPPED povray: not installed");
        return;
    }
    println!("\n### Beside POV-Ray, {SIZE}², one thread\n");
    println!(
        "| shape | POV-Ray, ms | zeroset, ms | ratio | POV-Ray wrong | POV-Ray error | zeroset wrong | zeroset error |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let folder = std::env::temp_dir().join(format!("zeroset-bench-peers-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let mut complaints = Vec::new();
    for shape in shapes {
        if let Some(isosurface) = &shape.isosurface {
            match measure(shape, isosurface, &folder, arguments) {
                Ok(complaint) => {
                    complaints.extend(complaint.map(|c| format!("{}: {c}", shape.name)))
                }
                Err(error) => println!("\nSKIPPED povray, {}: {error}\n", shape.name),
            }
        }
    }
    // What it leaves behind is its own; a folder that cannot be removed is no reason to stop.
    let _ = std::fs::remove_dir_all(&folder);
    for complaint in complaints {
        println!("\nPOV-Ray on {complaint}");
    }
}

fn measure(
    shape: &Shape,
    isosurface: &Isosurface,
    folder: &Path,
    arguments: &Arguments,
) -> Result<Option<String>, String> {
    let view = View {
        size: SIZE,
        place: PLACE,
    };
    let (mut theirs, mut ours) = (Vec::new(), Vec::new());
    let pool = pool(1);
    let mut last = trace(isosurface, folder)?;
    pool.install(|| view.render(&shape.scene));
    for _ in 0..arguments.runs.max(1) {
        last = trace(isosurface, folder)?;
        theirs.push(last.trace.as_secs_f64());
        ours.push(timed(1, || pool.install(|| view.render(&shape.scene))).as_secs_f64());
    }
    let (theirs, ours) = (Spread::of(theirs), Spread::of(ours));
    let picture = view.render(&shape.scene);
    let mut sampled = Sampled::new(shape, view, arguments.rays);
    sampled.look_again(|i, j| View::shown(&picture, i, j));
    let povray = sampled.judge(|i, j| shown(&last.pixels, i, j));
    let zeroset = sampled.judge(|i, j| View::shown(&picture, i, j));
    println!(
        "| {} | {} | {} | {} | {} of {} | {} | {} | {} |",
        shape.name,
        theirs.cell(),
        ours.cell(),
        digits(theirs.median / ours.median),
        povray.wrong_cell(),
        povray.rays,
        povray.error_cell(),
        zeroset.wrong_cell(),
        zeroset.error_cell(),
    );
    Ok(last.complaint)
}

/// Its coordinates are left-handed: it looks along +z from z = −3, and z is turned round.
fn scene(
    Isosurface {
        formula,
        gradient,
        ball,
    }: &Isosurface,
) -> String {
    let container = match ball {
        Some(radius) => format!("sphere {{ 0, {radius} }}"),
        None => "box { -1, 1 }".to_owned(),
    };
    format!(
        "#version 3.7;
global_settings {{ assumed_gamma 1 }}
background {{ rgb 0 }}
camera {{ orthographic location <0,0,-3> direction <0,0,1> right <2,0,0> up <0,2,0> }}
#declare F = function(x, y, z) {{ {formula} }}
isosurface {{
  function {{ F(x, y, -z) }} threshold 0 accuracy 1e-4 max_gradient {gradient} contained_by {{ {container} }}
  pigment {{ function {{ (2 - z)/4 }} color_map {{ [0 rgb <0,1,1>] [1 rgb <1,1,1>] }} }}
  finish {{ ambient 1 diffuse 0 }}
}}
"
    )
}

fn trace(isosurface: &Isosurface, folder: &Path) -> Result<Picture, String> {
    let (input, output) = (folder.join("scene.pov"), folder.join("picture.ppm"));
    std::fs::write(&input, scene(isosurface)).map_err(|e| e.to_string())?;
    let done = Command::new("povray")
        .arg(format!("+I{}", input.display()))
        .arg(format!("+O{}", output.display()))
        .args(["+FP16", "-D", "-A", "-V", "+WT1", "File_Gamma=1.0"])
        .args([format!("+W{SIZE}"), format!("+H{SIZE}")])
        .output()
        .map_err(|e| e.to_string())?;
    let report = String::from_utf8_lossy(&done.stderr).replace('\r', "\n");
    if !done.status.success() {
        let lines: Vec<&str> = report.lines().filter(|l| l.contains("rror")).collect();
        return Err(lines.join("; "));
    }
    let bytes = std::fs::read(&output).map_err(|e| e.to_string())?;
    let length = 6 * (SIZE * SIZE) as usize;
    if !bytes.starts_with(b"P6") || bytes.len() < length {
        return Err("its picture has another format".to_owned());
    }
    Ok(Picture {
        trace: processor_time(&report).ok_or("its report names no time")?,
        complaint: complaint(&report),
        pixels: bytes[bytes.len() - length..].to_vec(),
    })
}

/// The processor time behind `Trace Time`.
fn processor_time(report: &str) -> Option<Duration> {
    let behind = &report[report.find("Trace Time:")?..];
    let words: Vec<&str> = behind.split_whitespace().collect();
    let number = words
        .iter()
        .position(|w| *w == "CPU-seconds")?
        .checked_sub(1)?;
    Some(Duration::from_secs_f64(words[number].parse().ok()?))
}

fn complaint(report: &str) -> Option<String> {
    let start = report.find("The maximum gradient found was")?;
    let sentence: String = report[start..]
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    Some(sentence.split(". ").next()?.to_owned())
}

/// Green and blue are full where there is a surface; red is (z + 2)/4.
fn shown(pixels: &[u8], i: u32, j: u32) -> Shown {
    let at = 6 * (j * SIZE + i) as usize;
    let channel = |k: usize| u16::from_be_bytes([pixels[at + 2 * k], pixels[at + 2 * k + 1]]);
    if channel(1) == 0 {
        Shown::Miss
    } else {
        Shown::At(4.0 * f64::from(channel(0)) / 65535.0 - 2.0)
    }
}
