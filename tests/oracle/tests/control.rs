//! The negative control: the same pictures with rounding switched off. If the oracle did not catch them, it would prove
//! nothing about the others.

#![forbid(unsafe_code)]

use zeroset::interval::Isa;
use zeroset_oracle::gallery;

#[test]
fn answers_without_rounding_are_refuted() {
    let paths = Isa::unrounded();
    assert!(!paths.is_empty());
    let mut caught = vec![0; paths.len()];
    for picture in gallery::controls() {
        let outcome = picture.check(96, &paths);
        for (count, (path, tally)) in caught.iter_mut().zip(&outcome.paths) {
            println!("{}; {path}: {tally}", outcome.name);
            *count += tally.wrong;
        }
    }
    for (count, isa) in caught.iter().zip(&paths) {
        println!("{isa}: {count} answers refuted");
        assert!(*count > 0, "{isa}: nothing refuted");
    }
}
