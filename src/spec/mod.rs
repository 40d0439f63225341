//! The specifications of the cycles: reading, checking, resolving for a control.
//!
//! Invariant: knows no language; every text that a person reads is an id here.
mod catalogue;
mod decode;
mod figure_form;
mod figures;
mod filter;
mod form;
mod index;
mod language;
mod lint;
mod load;
mod pages;
mod prepared;
mod profile;
mod run_form;
mod schema;
mod texts;
mod tree;
mod value;
mod vocabulary;
mod worked;
mod yaml;

pub use catalogue::{Catalogue, Cycle, CycleKey, Field, Known, OnControl, Outline, Param, PrintedRange};
pub use decode::{Context, Decode, Definitions, Entries, Formula, Name};
pub use figure_form::*;
pub use figures::{dimensions, measurable, not_in_figures};
pub use form::*;
pub use language::{BlockWords, Gives, Global, LanguageFile, OldCycle, WordLimit};
pub use lint::{equals, lint};
pub use pages::{NoteSection, NotesOfSection, Pages, Theme};
pub use profile::{
    Control, Errata, Erratum, LabelRules, Named, NamedIn, OptionName, Since, Topic, TopicOn, Topics, Transformation,
    software,
};
pub use run_form::*;
pub use schema::schema;
pub use texts::{Text, texts};
pub use value::{MM_PER_INCH, Refusal, number_refusal_in, refusal};
pub use vocabulary::*;
pub use worked::{Worked, WorkedFile, WorkedOn};
pub use yaml::{Key, Kind, Node, read as read_yaml};
