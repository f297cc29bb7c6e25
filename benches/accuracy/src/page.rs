//! The page of the docs.

use std::fmt::Write as _;

use zeroset_accuracy::SIZE;

use crate::measure::{CARELESS, RUNS, Row, TIMED};

/// Errors for which there is a table.
const ERRORS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// The rows of one surface.
pub struct Surface<'a> {
    pub name: &'a str,
    pub rows: &'a [Row],
}

impl<'a> Surface<'a> {
    pub fn all(rows: &'a [Row]) -> impl Iterator<Item = Surface<'a>> {
        rows.chunk_by(|a, b| a.surface == b.surface)
            .map(|rows| Surface {
                name: &rows[0].surface,
                rows,
            })
    }

    /// The default solver on the best instruction set.
    fn auto(&self) -> &'a Row {
        &self.rows[0]
    }

    /// The fastest of the others whose largest error is no larger, with or without wrong rays.
    fn fastest(&self, error: f64, wrong: bool) -> Option<&'a Row> {
        self.rows
            .iter()
            .filter(|row| !row.is_ours() && row.found.right > 0)
            .filter(|row| row.found.largest <= error && (row.found.wrong() > 0) == wrong)
            .filter(|row| f64::from(row.found.wrong()) <= CARELESS * f64::from(row.found.rays))
            .min_by(|a, b| a.nanoseconds.total_cmp(&b.nanoseconds))
    }
}

pub fn write(rows: &[Row]) -> String {
    let mut page = head(rows);
    let _ = verdict(&mut page, rows);
    let _ = solvers(&mut page, rows);
    for error in ERRORS {
        let _ = table(&mut page, rows, error);
    }
    page
}

fn head(rows: &[Row]) -> String {
    let isa = rows.first().map_or("", |row| &row.isa);
    format!(
        "# Run time against error

Written by `cargo run --release -p accuracy`, which also writes all rows to `benches/accuracy/accuracy.csv`. Best
instruction set of this run: {isa}.

![Time per ray against the largest error](accuracy.svg)

Each panel is a surface: processor time per ray to the right, the largest error of a root upward, both logarithmic. Green
crosses are this library's solvers; they know no tolerance, so each is one point that holds for all errors above it. (All
five are compiled for six surfaces, one of each kind, and the default one for the others.) Lines
are the usual methods, one point per tolerance from 1e-2 to 1e-15; an open circle has wrong rays.

How it is measured:

- One perspective camera per surface. This library renders {TIMED}² rays, and is charged for making the rays, clipping them, and
  keeping the picture; beams of many rays are part of it. The others get every fifth packet of {SIZE}² rays, ready made.
  Processor time of one thread; all methods in turn in one run, the median of {RUNS} runs. Errors and wrong rays are those of
  {SIZE}² rays for all.
- The truth is known for 256 of the rays, by exact polynomials or 200-bit balls (`tests/accuracy/truth.py`). An error is the
  distance along the ray, as a share of half the width of the cube. A ray is wrong if a root is missed, if one is invented
  (none within ten tolerances and a hundredth), or if it is another one than the first. Rays that this library leaves open, and
  says so, are counted apart; so are changes of sign without a proof that there is one root only, as bisection finds them.
- The others are packets of eight rays in plain `f64`, on the same compiled formula with the same reduction of quadratic
  parts, on the best instruction set. For each tolerance a setting is chosen twice: for the fewest wrong rays, and for the
  fewest evaluations with at most one ray in a hundred wrong. Settings are tried in ascending order, until no ray is wrong or
  three in a row brought nothing. Marching: 8 to 2048 steps and regula falsi. Sphere tracing: the
  least Lipschitz bound of the cube that subdivision by enclosures finds, within 5 %. Segment tracing: bounds of f' on the next
  piece from enclosures, which are rounded outward here. Newton: from the middle of the first step that changes
  the sign. Polynomials up to degree 16: interpolation, then roots by those of the derivatives, and one step by f itself; this
  one goes ray by ray.

"
    )
}

fn ratio(row: &Row, auto: &Row) -> f64 {
    row.nanoseconds / auto.nanoseconds
}

/// Where the goal is met, and where not.
fn verdict(page: &mut String, rows: &[Row]) -> std::fmt::Result {
    let (mut total, mut met, mut wrong) = (0, 0, 0);
    let mut table = String::new();
    for surface in Surface::all(rows) {
        let auto = surface.auto();
        let ours = surface.rows.iter().filter(|row| row.is_ours());
        wrong += ours.map(|row| row.found.wrong()).sum::<u32>();
        write!(table, "| {} ", surface.name)?;
        for error in ERRORS {
            let fastest = |wrong: bool| surface.fastest(error, wrong).map(|row| ratio(row, auto));
            let (right, some) = (fastest(false), fastest(true));
            let late =
                [(right, 1.0), (some, 0.5)].map(|(ratio, goal)| ratio.is_some_and(|r| r < goal));
            let imprecise = auto.found.largest > error;
            total += 1;
            met += u32::from(!imprecise && late == [false; 2]);
            let cell = |ratio: Option<f64>, late: bool| match ratio {
                Some(ratio) if late => format!("**{ratio:.2}**"),
                Some(ratio) => format!("{ratio:.2}"),
                None => "none".to_owned(),
            };
            let note = if imprecise { " **imprecise**" } else { "" };
            write!(
                table,
                "| {}, {}{note} ",
                cell(right, late[0]),
                cell(some, late[1])
            )?;
        }
        writeln!(table, "|")?;
    }
    let columns = ERRORS.map(|error| format!("| up to {error:e} ")).concat();
    writeln!(
        page,
        "## The goal

At each error the automatic choice is to be the fastest of all methods without a wrong ray, and within 2 times of the fastest
with some. It is on {met} of {total} pairs of a surface and an error; this library's solvers have {wrong} wrong rays in all.

The table has the time of the fastest method without a wrong ray, and of the fastest with some (at most one in a hundred), as
a part of the time of the automatic choice. **Bold** is what misses the goal: below 1, and below ½.

| surface {columns}|
|---|---|---|---|---|
{table}
What limits it: the best setting of the others is chosen with hindsight, on the rays that they are then judged by. A march that
happens to need 8 steps does 8 plain evaluations; this library has to exclude every place in front of the root by enclosures,
each of which costs several plain evaluations, and does not know beforehand where roots are. Where many steps are needed
for the last ray to be right, or no number of steps suffices, it is ahead.

The doubled sphere has no change of sign: each of its two sheets is proved by the second derivative and by looks in twice the
precision, in which more than half of the time goes; the others stop where |f| is small, and prove nothing. On the thin shell both
sheets lie in one piece of a beam, so that each ray searches for itself; of Scherk's surface and of the gyroid a march of few steps
happens to see all roots.
"
    )
}

/// This library's solvers beside each other.
fn solvers(page: &mut String, rows: &[Row]) -> std::fmt::Result {
    // The first surface has all of them.
    let first = rows.iter().take_while(|row| row.is_ours());
    let names: Vec<String> = first
        .map(|row| format!("{}, {}", row.method, row.isa))
        .collect();
    writeln!(
        page,
        "## Solvers of this library\n\nNanoseconds per ray, and for the default its largest and median error, evaluations per ray, and open rays of 256.\n"
    )?;
    writeln!(
        page,
        "| surface | {} | largest | median | evaluations | open |",
        names.join(" | ")
    )?;
    writeln!(page, "|{}", "---|".repeat(names.len() + 5))?;
    for surface in Surface::all(rows) {
        let auto = surface.auto();
        let time = |name: &String| {
            let named =
                |row: &&Row| row.is_ours() && format!("{}, {}", row.method, row.isa) == *name;
            let row = surface.rows.iter().find(named);
            row.map(|row| format!("{:.0}", row.nanoseconds))
                .unwrap_or_default()
        };
        let times: Vec<String> = names.iter().map(time).collect();
        writeln!(
            page,
            "| {} | {} | {:.1e} | {:.1e} | {:.1} | {} |",
            surface.name,
            times.join(" | "),
            auto.found.largest,
            auto.found.median,
            auto.evaluations,
            auto.found.open
        )?;
    }
    writeln!(page)
}

fn table(page: &mut String, rows: &[Row], error: f64) -> std::fmt::Result {
    writeln!(page, "## Errors up to {error:e}\n")?;
    writeln!(
        page,
        "Nanoseconds per ray, and how many times as long as the default solver.\n"
    )?;
    writeln!(
        page,
        "| surface | auto | fastest without a wrong ray | | × | fastest with some | | × | wrong |"
    )?;
    writeln!(page, "|{}", "---|".repeat(9))?;
    for surface in Surface::all(rows) {
        let auto = surface.auto();
        let cell = |row: Option<&Row>| match row {
            None => "none | | ".to_owned(),
            Some(row) => {
                let setting = row.setting.unwrap_or(0);
                let (time, ratio) = (row.nanoseconds, ratio(row, auto));
                format!("{} ({setting}) | {time:.0} | {ratio:.1}", row.method)
            }
        };
        let [safe, fast] = [false, true].map(|wrong| surface.fastest(error, wrong));
        let wrong = fast.map(|row| format!("{} of {}", row.found.wrong(), row.found.rays));
        writeln!(
            page,
            "| {} | {:.0} | {} | {} | {} |",
            surface.name,
            auto.nanoseconds,
            cell(safe),
            cell(fast),
            wrong.unwrap_or_default()
        )?;
    }
    writeln!(page)
}
