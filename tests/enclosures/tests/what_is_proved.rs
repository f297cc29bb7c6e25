//! The table of `docs/what-is-proved.md` has every function of the language, the widths that the tests enforce, and
//! proofs that exist.

use std::collections::BTreeSet;
use std::path::Path;

use zeroset_enclosures::promise::width;

const PAGE: &str = include_str!("../../../docs/what-is-proved.md");
/// The compiler's one table of functions.
const CATALOGUE: &str = include_str!("../../../macros/compiler/src/functions.rs");

/// What stands between backquotes.
fn quoted(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

/// The rows of the table: the functions' names, and all cells.
fn rows(page: &str) -> Vec<(Vec<&str>, Vec<&str>)> {
    page.lines()
        .skip_while(|line| !line.starts_with("| function |"))
        .skip(2)
        .take_while(|line| line.starts_with('|'))
        .map(|line| {
            let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
            (quoted(cells[0]), cells)
        })
        .collect()
}

/// The names in rows `entry(Function::Sqrt, "sqrt", …)`.
fn catalogue() -> BTreeSet<&'static str> {
    CATALOGUE
        .lines()
        .filter_map(|line| line.trim().strip_prefix("entry(Function::"))
        .filter_map(|rest| rest.split('"').nth(1))
        .collect()
}

#[test]
fn every_function_of_the_language_has_a_row() {
    let rows = rows(PAGE);
    let named: Vec<&str> = rows.iter().flat_map(|row| row.0.clone()).collect();
    let set: BTreeSet<&str> = named.iter().copied().collect();
    assert_eq!(set.len(), named.len(), "twice: {named:?}");
    let functions = catalogue();
    assert!(functions.len() > 25, "{functions:?}");
    for name in &functions {
        assert!(set.contains(name), "`{name}` has no row");
    }
    // Operators, which have no name in the language.
    let operators = ["add", "sub", "mul", "div", "sqr", "pow"];
    for name in set {
        assert!(
            functions.contains(name) || operators.contains(&name),
            "`{name}` is no function"
        );
    }
}

#[test]
fn widths_are_those_that_the_tests_enforce() {
    for (names, cells) in rows(PAGE) {
        assert_eq!(cells.len(), 8, "{names:?}");
        for (backend, cell) in ["avx512", "avx2", "portable"].into_iter().zip(&cells[4..]) {
            for name in &names {
                // What does not round is compared with exact results elsewhere.
                if *cell != "0" {
                    assert_eq!(
                        *cell,
                        width(name, backend).to_string(),
                        "{name} on {backend}"
                    );
                }
            }
        }
    }
}

#[test]
fn proofs_exist() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../runtime");
    let mut count = 0;
    for (names, cells) in rows(PAGE) {
        for file in quoted(cells[7])
            .into_iter()
            .filter(|file| file.contains('.'))
        {
            let code = root.join("src/interval/functions").join(file);
            let proof = root.join("proofs").join(file);
            assert!(
                code.exists() || proof.exists(),
                "{names:?}: there is no {file}"
            );
            count += 1;
        }
    }
    assert!(count > 40, "{count}");
}

#[test]
fn negative_control_a_row_less_is_noticed() {
    let less: String = PAGE
        .lines()
        .filter(|line| !line.starts_with("| `tanh`"))
        .map(|line| format!("{line}\n"))
        .collect();
    assert!(
        !rows(&less).iter().any(|row| row.0.contains(&"tanh"))
            && rows(PAGE).len() == rows(&less).len() + 1
    );
}
