//! Two pages to read: how to write a formula, and how to read what the compiler says about one.

#[doc = include_str!("../../docs/writing-formulas.md")]
pub mod writing_formulas {}

#[doc = include_str!("../../docs/reading-the-errors.md")]
pub mod reading_the_errors {}
