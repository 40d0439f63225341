//! Two programs side by side: whether a control would do the same with both.
//!
//! Each block becomes a [`Statement`]: what the control reads of it, written in one way. Labels, names of
//! cycles, comments, block numbers, white space and the spelling of numbers are left out of it; names of
//! files, texts and whatever no rule reads stay letter by letter. Invariant: two programs with the same
//! statements are the same to a control; where that is not certain, statements differ.
mod canon;
mod diff;

pub use canon::{Statement, statements};

use crate::check::Against;
use crate::syntax::Program;

/// A stretch in which two programs differ: statements of the first, statements of the second; one of the
/// two may be empty.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Difference {
    /// Statements of the first program.
    pub a: Vec<Statement>,
    /// Statements of the second program.
    pub b: Vec<Statement>,
}

/// What is different in two programs, in order; nothing if they are the same.
pub fn compare(a: &Program, b: &Program, against: &Against<'_>) -> Vec<Difference> {
    let (a, b) = (statements(a, against), statements(b, against));
    let texts = |all: &[Statement]| all.iter().map(|own| own.text.clone()).collect::<Vec<_>>();
    let pick = |all: &[Statement], range: std::ops::Range<usize>| all.get(range).unwrap_or_default().to_vec();
    let hunks = diff::hunks(&texts(&a), &texts(&b));
    hunks.into_iter().map(|(left, right)| Difference { a: pick(&a, left), b: pick(&b, right) }).collect()
}
