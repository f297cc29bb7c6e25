//! What the suites share: operations by name on every back-end, exact numbers, and operands that are hard.

pub mod backend;
pub mod exact;
pub mod fixture;
pub mod itf;
pub mod operand;
pub mod operation;
pub mod promise;
pub mod survey;
pub mod truth;
