//! The choice of a back-end.

use std::io::Write;
use zeroset::interval::{Isa, IsaError};

#[test]
fn back_ends_have_names() {
    let names: Vec<_> = Isa::available().iter().map(|isa| isa.name()).collect();
    println!("this processor has {}", names.join(", "));
    assert_eq!(names.last(), Some(&"portable"));
    for isa in Isa::available() {
        assert_eq!(Isa::named(isa.name()), Ok(isa));
    }
    for name in ["avx512", "avx2"] {
        match Isa::named(name) {
            Ok(isa) => assert_eq!(isa.to_string(), name),
            Err(error) => {
                let _ = writeln!(std::io::stderr(), "SKIPPED {name}: {error}");
                assert!(
                    matches!(error, IsaError::Missing { .. }) && error.to_string().contains(name)
                );
            }
        }
    }
}

#[test]
fn unknown_names_are_refused_with_the_known_ones() {
    let error = Isa::named("neon").unwrap_err().to_string();
    assert!(
        error.contains("`neon`") && error.contains("avx512, avx2, portable"),
        "{error}"
    );
}

#[test]
fn back_ends_without_rounding_are_not_offered() {
    assert!(
        Isa::available()
            .iter()
            .all(|isa| !isa.name().contains("unrounded"))
    );
    assert!(
        Isa::unrounded()
            .iter()
            .all(|isa| isa.name().contains("unrounded"))
    );
}
