//! Surfaces written by hand, without the compiler, and an exact oracle for them.

pub mod dual;
pub mod exact;
pub mod formulas;
pub mod oracle;
pub mod staged;
