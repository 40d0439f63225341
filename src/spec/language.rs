//! Blocks of the language that are no cycles: the words that they need and take.
//!
//! Invariant: the same for every control that has the block; which one has it is not known here.
use super::decode::{record, words};
use crate::base::expr::QRef;

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
        /// The words that may follow it, or with which they begin.
        offers: Vec<String>,
    }
}

record! {
    /// The words of a block.
    pub struct BlockWords {
        /// The words that it begins with, such as `PLANE SPATIAL`; for an M function its name, for one on texts, too.
        block: String,
        /// What may follow; others are reported if they look like one of them.
        follows: Vec<String>,
        /// Words of which none can be left out.
        needs: Vec<String>,
        /// Lists of words of which exactly one must be given.
        one_of: Vec<String>,
        /// Lists of words of which at least one must be given.
        any_of: Vec<String>,
        /// Pairs of words that exclude each other.
        excludes: Vec<String>,
        /// Pairs of words: with the first one, the second one is needed.
        asks: Vec<String>,
        /// The extension of the file that it names, or several, separated by blanks.
        file: Option<String>,
        /// Lists of words whose numbers are not all 0.
        nonzero: Vec<String>,
        /// Pairs of words: the number of the first one is less than that of the second one.
        below: Vec<String>,
        /// Words that are followed by a number, a parameter or a text.
        valued: Vec<String>,
        /// Words that are not the last ones.
        goes_on: Vec<String>,
        /// What its text contains, or one of several, separated by blanks.
        contains: Vec<String>,
        /// Words that mean nothing in it.
        never: Vec<String>,
        /// The words that may follow an M function, and no others.
        none_but: Vec<String>,
        /// Words one of which begins what the function does; without any of them it ends that.
        begun_by: Vec<String>,
        /// Six words, the components of two vectors that are not parallel.
        askew: Option<String>,
        /// Nine words, the coordinates of three points that do not lie on one line.
        spread: Option<String>,
        /// Extensions of files, separated by blanks, of which it names none.
        no_file: Option<String>,
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
    /// A cycle of the first controls, which the ones after them still carry out though their manuals no longer describe it.
    pub struct OldCycle {
        /// Its number.
        number: u32,
        /// Its English name.
        name: String,
    }
}

record! {
    /// The file of the language.
    pub struct LanguageFile {
        /// Its blocks.
        blocks: Option<Vec<BlockWords>>,
        /// What GLOBAL DEF gives.
        globals: Option<Vec<Global>>,
        /// Cycles of the first controls.
        old_cycles: Option<Vec<OldCycle>>,
    }
}
