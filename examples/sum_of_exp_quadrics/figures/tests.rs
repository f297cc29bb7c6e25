//! The files as a whole.

use super::*;

#[test]
fn tables_have_a_row_per_width_and_curve_and_the_drawing_its_curves() {
    let few: Vec<Measured> = functions().iter().step_by(64).map(measure).collect();
    let table = enclosures_table(&few);
    let rows = table.lines().filter(|l| !l.starts_with('#')).count();
    assert_eq!(rows, 1 + 3 * (NARROWEST + 1) * forms::NAMES.len());
    let columns = |l: &str| l.split(',').count();
    assert!(table.lines().skip(2).all(|l| columns(l) == 7));
    let table = contractions_table(&few);
    assert!(table.lines().skip(2).all(|l| columns(l) == 9));
    assert!(!table.contains("NaN") && !table.contains("inf"));

    let svg = contractions_chart(&few).svg();
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    assert_eq!(svg.matches("<polygon").count(), steps::NAMES.len());
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
}
