//! Pages to read: how to write a formula, how to read what the compiler says about one, how it is differentiated, and what
//! is proved.

#[doc = include_str!("../../docs/writing-formulas.md")]
pub mod writing_formulas {}

#[doc = include_str!("../../docs/reading-the-errors.md")]
pub mod reading_the_errors {}

#[doc = include_str!("../../docs/how-differentiation-works.md")]
pub mod how_differentiation_works {}

#[doc = include_str!("../../docs/what-is-proved.md")]
pub mod what_is_proved {}
