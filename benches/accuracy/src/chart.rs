//! A panel for each surface.

use std::error::Error;

use plotters::prelude::*;

use crate::measure::{Row, Tuning};
use crate::page::Surface;

const COLUMNS: usize = 5;
const PANEL: [u32; 2] = [300, 230];
/// Errors below are drawn here.
const FLOOR: f64 = 1e-17;

const METHODS: [(&str, RGBColor); 5] = [
    ("marching and secant", RGBColor(214, 96, 20)),
    ("sphere tracing", RGBColor(50, 90, 200)),
    ("segment tracing", RGBColor(140, 60, 170)),
    ("marching and Newton", RGBColor(200, 40, 60)),
    ("polynomial solver", RGBColor(120, 120, 120)),
];
const OURS: RGBColor = RGBColor(20, 130, 60);

pub fn draw(rows: &[Row]) -> Result<String, Box<dyn Error>> {
    let surfaces: Vec<Surface> = Surface::all(rows).collect();
    // One panel for the legend.
    let lines = (surfaces.len() + 1).div_ceil(COLUMNS);
    let size = (PANEL[0] * COLUMNS as u32, PANEL[1] * lines as u32);
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
        area.fill(&WHITE)?;
        let panels = area.split_evenly((lines, COLUMNS));
        for (surface, panel) in surfaces.iter().zip(&panels) {
            draw_panel(surface, panel)?;
        }
        if let Some(panel) = panels.get(surfaces.len()) {
            draw_legend(panel)?;
        }
        area.present()?;
    }
    Ok(text)
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

fn draw_panel(surface: &Surface, panel: &Area) -> Result<(), Box<dyn Error>> {
    let mut chart = ChartBuilder::on(panel)
        .caption(surface.name, ("sans-serif", 14))
        .margin(6)
        .x_label_area_size(22)
        .y_label_area_size(42)
        .build_cartesian_2d((10.0..1e5f64).log_scale(), (FLOOR..1.0f64).log_scale())?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_labels(5)
        .y_labels(6)
        .x_label_formatter(&|ns| format!("{ns:.0} ns"))
        .y_label_formatter(&|error| format!("{error:.0e}"))
        .label_style(("sans-serif", 9))
        .draw()?;
    let place = |row: &Row| {
        let ns = row.nanoseconds.clamp(10.0, 1e5);
        (ns, row.found.largest.clamp(FLOOR, 1.0))
    };
    for (name, colour) in METHODS {
        let rows: Vec<&Row> = surface
            .rows
            .iter()
            .filter(|row| row.method == name && row.tuning == Tuning::Careful)
            .filter(|row| row.found.right > 0)
            .collect();
        chart.draw_series(LineSeries::new(rows.iter().map(|row| place(row)), colour))?;
        chart.draw_series(rows.iter().map(|row| {
            let style = match row.found.wrong() {
                0 => colour.filled(),
                _ => colour.stroke_width(1),
            };
            Circle::new(place(row), 3, style)
        }))?;
    }
    let best = &surface.rows[0].isa;
    let ours = surface
        .rows
        .iter()
        .filter(|row| row.is_ours() && row.isa == *best);
    chart.draw_series(ours.enumerate().map(|(k, row)| {
        let width = if k == 0 { 3 } else { 1 };
        Cross::new(place(row), 4, OURS.stroke_width(width))
    }))?;
    Ok(())
}

fn draw_legend(panel: &Area) -> Result<(), Box<dyn Error>> {
    let font = ("sans-serif", 13);
    let ours = [
        ("this library: auto", OURS),
        ("its other solvers (thin crosses)", OURS),
    ];
    for (k, (name, colour)) in (1..).zip(ours.into_iter().chain(METHODS)) {
        let y = 24 * k;
        if k <= 2 {
            panel.draw(&Cross::new(
                (30, y),
                4,
                colour.stroke_width(if k == 1 { 3 } else { 1 }),
            ))?;
        } else {
            panel.draw(&Circle::new((30, y), 3, colour.filled()))?;
        }
        panel.draw(&Text::new(name, (45, y - 6), font))?;
    }
    panel.draw(&Circle::new((30, 192), 3, BLACK.stroke_width(1)))?;
    panel.draw(&Text::new("has wrong rays", (45, 186), font))?;
    Ok(())
}
