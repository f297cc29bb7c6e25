//! A log-log line chart as SVG.

use std::fmt::Write;

use super::summary::Summary;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 480.0;
const LEFT: f64 = 82.0;
const RIGHT: f64 = 150.0;
const TOP: f64 = 66.0;
const BOTTOM: f64 = 60.0;
const COLOURS: [&str; 4] = ["#b5541c", "#1f5f9e", "#2d7d46", "#7b3f8c"];

/// A curve with its quartiles.
pub struct Series {
    /// Its name in the legend.
    pub name: &'static str,
    /// One summary per width 2⁰, 2⁻¹, …
    pub values: Vec<Summary>,
}

/// What is drawn.
pub struct Chart {
    /// Above all.
    pub title: &'static str,
    /// Below the title.
    pub note: String,
    /// What the values are.
    pub y_label: &'static str,
    /// The axis ends at this power of ten at the latest; what is above is cut off.
    pub highest: i32,
    /// The curves, at most four.
    pub series: Vec<Series>,
}

/// Where numbers lie on the paper.
struct Frame {
    /// The number of halvings at the left end; the right end is 2⁰.
    halvings: usize,
    /// Powers of ten at the lower and the upper end.
    decades: [i32; 2],
}

impl Frame {
    fn around(series: &[Series], highest: i32) -> Self {
        let all = || series.iter().flat_map(|s| &s.values);
        let least = all()
            .map(|v| v.first.min(v.mean))
            .fold(f64::INFINITY, f64::min);
        let most = all().map(|v| v.third.max(v.mean)).fold(0.0, f64::max);
        let low = least.max(1e-16).log10().floor() as i32;
        let high = (most.max(1e-16).log10().ceil() as i32).min(highest);
        Frame {
            halvings: series.iter().map(|s| s.values.len()).max().unwrap_or(2) - 1,
            decades: [low, high.max(low + 1)],
        }
    }

    /// From left, for the width 2⁻ᵏ.
    fn x(&self, k: usize) -> f64 {
        let along = 1.0 - k as f64 / self.halvings as f64;
        LEFT + along * (WIDTH - LEFT - RIGHT)
    }

    /// From above.
    fn y(&self, value: f64) -> f64 {
        let [low, high] = self.decades.map(f64::from);
        let up = (value.max(1e-300).log10().max(low) - low) / (high - low);
        HEIGHT - BOTTOM - up * (HEIGHT - TOP - BOTTOM)
    }

    fn path(&self, values: impl Iterator<Item = (usize, f64)>) -> String {
        let points = values.map(|(k, v)| format!("{:.1},{:.1}", self.x(k), self.y(v)));
        points.collect::<Vec<_>>().join(" ")
    }
}

impl Chart {
    /// The file's text.
    pub fn svg(&self) -> String {
        let frame = Frame::around(&self.series, self.highest);
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" \
             height=\"{HEIGHT}\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#222\">\n\
             <rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#fff\"/>\n"
        );
        text(&mut out, [LEFT, 26.0], "start", 16, self.title);
        text(&mut out, [LEFT, 46.0], "start", 11, &self.note);
        self.axes(&frame, &mut out);
        let (width, height) = (WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM);
        let _ = writeln!(
            out,
            "<clipPath id=\"inside\"><rect x=\"{LEFT}\" y=\"{TOP}\" width=\"{width}\" height=\"{height}\"/></clipPath>\n\
             <g clip-path=\"url(#inside)\">"
        );
        for (series, colour) in self.series.iter().zip(COLOURS) {
            curve(&frame, series, colour, &mut out);
        }
        out.push_str("</g>\n");
        self.legend(&mut out);
        out.push_str("</svg>\n");
        out
    }

    fn axes(&self, frame: &Frame, out: &mut String) {
        let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
        for k in (0..=frame.halvings).step_by(4) {
            let x = frame.x(k);
            line(out, [x, TOP, x, bottom], "#e4e4e4");
            power(out, [x, bottom + 20.0], "middle", 2, -(k as i32));
        }
        // At most ten lines, however many decades there are.
        let [low, high] = frame.decades;
        let step = (high - low) / 10 + 1;
        for decade in (low..=high).step_by(step as usize) {
            let y = frame.y(10f64.powi(decade));
            line(out, [LEFT, y, right, y], "#e4e4e4");
            power(out, [LEFT - 8.0, y + 4.0], "end", 10, decade);
        }
        line(out, [LEFT, TOP, LEFT, bottom], "#222");
        line(out, [LEFT, bottom, right, bottom], "#222");
        let middle = (LEFT + right) / 2.0;
        text(
            out,
            [middle, HEIGHT - 16.0],
            "middle",
            13,
            "width of T, in ways through the box",
        );
        let y = (TOP + bottom) / 2.0;
        let _ = writeln!(
            out,
            "<text transform=\"translate(24 {y}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            escaped(self.y_label)
        );
    }

    fn legend(&self, out: &mut String) {
        let x = WIDTH - RIGHT + 18.0;
        for (k, (series, colour)) in self.series.iter().zip(COLOURS).enumerate() {
            let y = TOP + 12.0 + 22.0 * k as f64;
            let _ = writeln!(
                out,
                "<path d=\"M{x} {y}h24\" stroke=\"{colour}\" stroke-width=\"2.2\"/>"
            );
            text(out, [x + 30.0, y + 4.0], "start", 13, series.name);
        }
        let below = TOP + 24.0 + 22.0 * self.series.len() as f64;
        for (k, words) in ["line: mean", "dashes: median", "band: quartiles"]
            .iter()
            .enumerate()
        {
            text(out, [x, below + 16.0 * k as f64], "start", 11, words);
        }
    }
}

/// The band between the quartiles, the median dashed, the mean on top.
fn curve(frame: &Frame, series: &Series, colour: &str, out: &mut String) {
    let along = || series.values.iter().enumerate();
    let there = frame.path(along().map(|(k, v)| (k, v.third)));
    let back = frame.path(along().rev().map(|(k, v)| (k, v.first)));
    let median = frame.path(along().map(|(k, v)| (k, v.median)));
    let mean = frame.path(along().map(|(k, v)| (k, v.mean)));
    let _ = writeln!(
        out,
        "<polygon points=\"{there} {back}\" fill=\"{colour}\" fill-opacity=\"0.13\"/>\n\
         <polyline points=\"{median}\" fill=\"none\" stroke=\"{colour}\" stroke-dasharray=\"4 3\"/>\n\
         <polyline points=\"{mean}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2.2\"/>"
    );
}

fn line(out: &mut String, [x0, y0, x1, y1]: [f64; 4], colour: &str) {
    let _ = writeln!(
        out,
        "<path d=\"M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}\" stroke=\"{colour}\"/>"
    );
}

fn text(out: &mut String, [x, y]: [f64; 2], anchor: &str, size: u32, words: &str) {
    let words = escaped(words);
    let _ = writeln!(
        out,
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" font-size=\"{size}\">{words}</text>"
    );
}

/// A power with a raised exponent.
fn power(out: &mut String, [x, y]: [f64; 2], anchor: &str, base: u32, exponent: i32) {
    let exponent = exponent.to_string().replace('-', "−");
    let _ = writeln!(
        out,
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{base}<tspan dy=\"-5\" \
         font-size=\"10\">{exponent}</tspan></text>"
    );
}

fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;")
}
