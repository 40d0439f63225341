//! What programs are checked against.
use super::cycle::LabelBook;
use crate::language::locale::Language;
use crate::spec::{Catalogue, OnControl};

/// What programs are checked against.
#[derive(Clone, Copy)]
pub struct Against<'a> {
    /// All controls, to say on which of them a cycle exists.
    pub catalogue: &'a Catalogue,
    /// The control that the program is for.
    pub on: &'a OnControl,
    /// Its labels in all languages.
    pub labels: &'a LabelBook<'a>,
    /// The language of the program's labels; found out from them if not given.
    pub language: Option<&'a str>,
    /// The software version of the control, if it is known.
    pub software: Option<&'a str>,
    /// Languages for the sentences of guards, the first that has a sentence wins.
    pub readers: &'a [&'a Language],
}
