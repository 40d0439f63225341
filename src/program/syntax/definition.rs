//! The nodes of cycle definitions, in both of their forms, and of their calls.
//!
//! Invariant: a parameter and a field are kept as they are printed; what they mean is not known here.
use super::parameters::Parameters;
use super::statement::NamedWord;
use super::tree::{Coord, Feed, MFunction, SyntaxError};
use crate::base::diag::Span;
use crate::base::expr::QRef;

/// The two families of cycles; the same number means different cycles in each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CycleKeyword {
    /// `CYCL DEF`.
    CyclDef,
    /// `TCH PROBE`.
    TchProbe,
}

impl CycleKeyword {
    /// As programs print it.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::CyclDef => "CYCL DEF",
            Self::TchProbe => "TCH PROBE",
        }
    }

    pub(super) const fn kind_name(self) -> &'static str {
        match self {
            Self::CyclDef => "cycl-def",
            Self::TchProbe => "tch-probe",
        }
    }
}

/// A cycle definition with Q parameters, of as many lines as it takes.
#[derive(Clone, Debug)]
pub struct CycleDef {
    /// The family.
    pub keyword: CycleKeyword,
    /// The number in the family.
    pub number: u32,
    /// Keyword and number.
    pub head: Span,
    /// The printed name.
    pub name: Option<Span>,
    /// The parameters in the order written.
    pub parameters: Parameters,
    /// What cannot be read inside, at most one for a line.
    pub errors: Vec<SyntaxError>,
}

/// A parameter of a cycle definition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// From `Q` to the end of the value.
    pub span: Span,
    /// The parameter.
    pub q: QRef,
    /// Its place.
    pub q_span: Span,
    /// The value.
    pub value: Value,
    /// The label after `;`, trimmed; absent if there is no `;` or nothing after it.
    pub label: Option<Span>,
}

/// A value as printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// Its place; empty if it is missing.
    pub span: Span,
    /// What it is.
    pub kind: ValueKind,
}

/// What a value is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ValueKind {
    /// A number.
    Number(f64),
    /// A parameter.
    Q {
        /// Whether a minus precedes it.
        negative: bool,
        /// The parameter.
        q: QRef,
    },
    /// A word such as `FAUTO` or `PREDEF`.
    Word,
    /// A text: its place without the quotation marks.
    Text(Span),
    /// A sign alone, the direction of `X-`: true for minus.
    Sign(bool),
    /// Nothing.
    Missing,
}

/// One line `n.k` of a cycle definition of the old form.
#[derive(Clone, Debug)]
pub struct OldCycleLine {
    /// The family.
    pub keyword: CycleKeyword,
    /// The number in the family: n.
    pub number: u32,
    /// The line: k.
    pub line: u32,
    /// Keyword, number and line.
    pub head: Span,
    /// The printed name, on line 0.
    pub name: Option<Span>,
    /// The fields in the order written.
    pub words: Vec<NamedWord>,
}

/// `CYCL CALL`.
#[derive(Clone, Debug)]
pub struct CyclCall {
    /// `CYCL CALL`.
    pub head: Span,
    /// Where the cycle is called.
    pub form: CallForm,
    /// Feed between the points.
    pub feed: Option<Feed>,
    /// M functions.
    pub functions: Vec<MFunction>,
}

/// Where a cycle is called.
#[derive(Clone, Debug)]
pub enum CallForm {
    /// Here.
    Plain,
    /// `PAT`: on every point of the pattern.
    Pattern,
    /// `POS`: at a position.
    Position(Vec<Coord>),
}
