//! The nodes of cycle definitions, in both of their forms, and of their calls.
//!
//! Invariant: a parameter and a field are kept as they are printed; what they mean is not known here.
use super::parameters::Parameters;
use super::terms::{Coord, Feed, MFunction, NamedWord, SyntaxError, Value};
use crate::base::diag::Span;
use crate::base::expr::{QKind, QRef};

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

/// `Q200=2` without its label.
pub(super) struct Assignment {
    pub(super) span: Span,
    pub(super) q: QRef,
    pub(super) q_span: Span,
    pub(super) value: Value,
    /// Whether no blank precedes `=`, as controls print parameters.
    pub(super) tight: bool,
}

/// Numbers of the parameters that only definitions of cycles have.
const OF_CYCLES: std::ops::RangeInclusive<u16> = 200..=499;

impl Assignment {
    /// Whether its parameter is one that only definitions of cycles have.
    pub(super) fn is_of_cycle(&self) -> bool {
        self.q.kind == QKind::Q && OF_CYCLES.contains(&self.q.number)
    }
}
