//! The nodes of blocks that are a name and words after it.
//!
//! Invariant: every word is kept with the place of its name and of its value; what it does is not known here.
use super::terms::{NamedWord, Parameter, SyntaxError};
use crate::base::diag::Span;
use crate::base::expr::QRef;

/// What a statement is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StatementKind {
    /// `BLK FORM CYLINDER`, `ROTATION`, `FILE`.
    BlkForm,
    /// `CALL SELECTED PGM`, `CALL SELECTED CYCLE`, `CALL SELECTED CONTOUR`.
    CallSelected,
    /// `CONTOUR DEF`.
    ContourDef,
    /// `DECLARE CONTOUR`.
    DeclareContour,
    /// `FN 14` to `FN 38`, with its number.
    Fn(u32),
    /// `FSELECT`.
    Fselect,
    /// `FUNCTION`, and the like that only some controls know.
    Function,
    /// A block in which a parameter is named by the value of another one, as in `Q[Q5] = 3`.
    Indirect,
    /// `PLANE`.
    Plane,
    /// `ERROR = …`: what a control makes of a block that it could not read.
    Refused,
    /// `Q1 SET UNDEFINED`.
    SetUndefined,
    /// `SQL`.
    Sql,
    /// `TRANS`.
    Trans,
}

impl StatementKind {
    /// The name of the kind in machine-readable output.
    pub const fn name(self) -> &'static str {
        match self {
            Self::BlkForm => "blk-form",
            Self::CallSelected => "call-selected",
            Self::ContourDef => "contour-def",
            Self::DeclareContour => "declare-contour",
            Self::Fn(18) => "sysread",
            Self::Fn(_) => "fn",
            Self::Fselect => "fselect",
            Self::Function => "function",
            Self::Indirect => "indirect",
            Self::Plane => "plane",
            Self::Refused => "refused",
            Self::SetUndefined => "set-undefined",
            Self::Sql => "sql",
            Self::Trans => "trans",
        }
    }
}

/// A block of words after its name.
#[derive(Clone, Debug)]
pub struct Statement {
    /// What it is.
    pub kind: StatementKind,
    /// The words that name it: `PLANE SPATIAL`, `FN 14: ERROR`.
    pub head: Span,
    /// The words after it, in the order written.
    pub words: Vec<NamedWord>,
}

/// `PATTERN DEF`.
#[derive(Clone, Debug)]
pub struct PatternDef {
    /// `PATTERN DEF`.
    pub head: Span,
    /// `POS1( … )`, `ROW1( … )` and so on.
    pub items: Vec<PatternItem>,
}

/// One position, row, frame or circle of a pattern.
#[derive(Clone, Debug)]
pub struct PatternItem {
    /// `POS1`.
    pub name: Span,
    /// What is between the brackets.
    pub words: Vec<NamedWord>,
}

/// `GLOBAL DEF`, of as many lines as it takes.
#[derive(Clone, Debug)]
pub struct GlobalDef {
    /// Its number.
    pub number: u32,
    /// `GLOBAL DEF` and the number.
    pub head: Span,
    /// The printed name.
    pub name: Option<Span>,
    /// The parameters in the order written.
    pub parameters: Vec<Parameter>,
    /// What cannot be read inside, at most one for a line.
    pub errors: Vec<SyntaxError>,
}

/// `QC10 = ( QC1 | QC2 ) \\ QC3`.
#[derive(Clone, Debug)]
pub struct ContourFormula {
    /// The number of the contour that is made.
    pub target: u32,
    /// Its place.
    pub target_span: Span,
    /// The formula's place.
    pub text: Span,
    /// The contours that it reads, with their places.
    pub reads: Vec<(u32, Span)>,
}

/// `QS1 = SUBSTR( SRC_QS2 BEG0 LEN4 ) || "mm"`.
#[derive(Clone, Debug)]
pub struct TextFormula {
    /// The parameter that is set.
    pub target: QRef,
    /// Its place.
    pub target_span: Span,
    /// The formula's place.
    pub text: Span,
    /// The functions on texts in it.
    pub calls: Vec<TextCall>,
}

/// A function on texts with what it is given.
#[derive(Clone, Debug)]
pub struct TextCall {
    /// Its name.
    pub name: Span,
    /// What is between the brackets.
    pub words: Vec<NamedWord>,
}

/// `SEL TABLE` and its like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Selection {
    /// `TABLE`, `PATTERN` …
    pub what: Span,
    /// The name, without quotation marks.
    pub name: Span,
}
