//! NC labels and NC blocks: what a control prints after `;`, and whole cycle definitions.
//!
//! Invariant: a label is printed whole or refused, never cut; what a block looks like follows from
//! the profile of the control and the form of the cycle.
mod block;
mod lint;
mod table;

pub use block::{Request, as_printed, block, block_of, continuation, example, example_of};
pub use lint::{SIGNS, check};
pub use table::{LabelRow, csv, table};
