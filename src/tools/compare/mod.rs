//! Two programs side by side: whether a control would do the same with both.
//!
//! Each block becomes a [`Statement`]: what the control reads of it, written in one way. Labels, names of
//! cycles, comments, block numbers, white space and the spelling of numbers are left out of it; names of
//! files, texts and whatever no rule reads stay letter by letter. Invariant: two programs with the same
//! statements are the same to a control; where that is not certain, statements differ.
mod canon;
mod diff;

pub use canon::{Statement, statements};

use std::hash::{DefaultHasher, Hasher as _};

use sha2::{Digest as _, Sha256};

use crate::check::Against;
use crate::program::syntax::Program;

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
    let (left, right) = (marks(a, against), marks(b, against));
    let (left, right): (Vec<_>, Vec<_>) = diff::hunks(&left, &right).into_iter().unzip();
    let (left, right) = (canon::those(a, against, &left), canon::those(b, against, &right));
    left.into_iter().zip(right).map(|(a, b)| Difference { a, b }).collect()
}

/// A mark of each statement: long programs have millions of them, and texts take more room than the programs. Two marks
/// that are equal by chance are as likely as 128 coins that all fall alike.
fn marks(program: &Program, against: &Against<'_>) -> Vec<u128> {
    let mut marks = Vec::new();
    canon::each(program, against, |_, text| {
        let half = |salt: u8| {
            let mut hasher = DefaultHasher::new();
            hasher.write_u8(salt);
            hasher.write(text.as_bytes());
            u128::from(hasher.finish())
        };
        marks.push(half(0) << 64 | half(1));
    });
    marks
}

/// What all statements of a program come to: two programs with the same are the same to a control. With it one of them
/// can be forgotten before the other is read.
pub fn fingerprint(program: &Program, against: &Against<'_>) -> [u8; 32] {
    let mut digest = Sha256::new();
    canon::each(program, against, |_, text| {
        digest.update((text.len() as u64).to_le_bytes());
        digest.update(text.as_bytes());
    });
    digest.finalize().into()
}
