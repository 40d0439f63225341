//! Blocks of the language that are no cycles: the words that they need and take.
//!
//! Invariant: the same for every control that has the block; which one has it is not known here.
use super::decode::{record, words};
use crate::expr::QRef;

words! {
    /// What a function gives.
    pub enum Gives {
        /// A number.
        Number = "number",
        /// A text.
        Text = "text",
    }
}

record! {
    /// What a word of a block takes.
    pub struct WordLimit {
        /// The word.
        word: String,
        /// The least number.
        min: Option<f64>,
        /// The greatest number.
        max: Option<f64>,
        /// Only whole numbers.
        whole: bool,
        /// The words that may stand behind it, or with which they begin.
        offers: Vec<String>,
    }
}

record! {
    /// The words of a block.
    pub struct BlockWords {
        /// The words that it begins with, such as `PLANE SPATIAL`; for an M function its name, for one on texts, too.
        block: String,
        /// What may follow; others are told if they look like one of them.
        follows: Vec<String>,
        /// Words of which none can be left out.
        needs: Vec<String>,
        /// Lists of words of which exactly one stands there.
        one_of: Vec<String>,
        /// Lists of words of which at least one stands there.
        any_of: Vec<String>,
        /// Pairs of words that exclude each other.
        excludes: Vec<String>,
        /// Pairs of words: where the first one stands, the second one is needed.
        asks: Vec<String>,
        /// The extension of the file that it names.
        file: Option<String>,
        /// Lists of words whose numbers are not all 0.
        nonzero: Vec<String>,
        /// Pairs of words: the number of the first one is less than that of the second one.
        below: Vec<String>,
        /// What its words take.
        limits: Vec<WordLimit>,
        /// What the function gives.
        gives: Option<Gives>,
    }
}

record! {
    /// A GLOBAL DEF.
    pub struct Global {
        /// Its number.
        number: u32,
        /// The parameters that it gives, in its order.
        parameters: Vec<QRef>,
        /// The values of a parameter that no cycle has.
        values: Vec<f64>,
    }
}

record! {
    /// The file of the language.
    pub struct Tongue {
        /// Its blocks.
        blocks: Option<Vec<BlockWords>>,
        /// What GLOBAL DEF gives.
        globals: Option<Vec<Global>>,
    }
}
