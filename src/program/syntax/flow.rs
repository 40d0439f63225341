//! The nodes of labels, calls, conditional jumps and calculations with Q parameters.
//!
//! Invariant: a node says what is written; where a jump leads and what a parameter holds is not known here.
use super::terms::{Amount, Operand};
use crate::base::diag::Span;
use crate::base::expr::{Expr, QRef};

/// A label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LabelRef {
    /// The number or the name, quotation marks included.
    pub span: Span,
    /// Which one.
    pub target: Label,
}

/// The label meant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Label {
    /// A number; 0 ends a subprogram.
    Number(u16),
    /// A name: its place, without quotation marks.
    Name(Span),
    /// The content of a parameter (only where labels are called).
    Q(QRef),
}

impl Label {
    /// `LBL 0`: the end of a subprogram.
    pub const END: Self = Self::Number(0);
}

/// `CALL LBL`.
#[derive(Clone, Debug)]
pub struct CallLbl {
    /// Where to.
    pub label: LabelRef,
    /// `REP`: how often the part is repeated.
    pub repeat: Option<Operand>,
}

/// What `FN 0` to `FN 8` and `FN 13` calculate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FnOp {
    /// FN 0: `a`.
    Set,
    /// FN 1: `a + b`.
    Add,
    /// FN 2: `a - b`.
    Sub,
    /// FN 3: `a * b`.
    Mul,
    /// FN 4: `a DIV b`.
    Div,
    /// FN 5: square root of `a`.
    Sqrt,
    /// FN 6: sine of `a` degrees.
    Sin,
    /// FN 7: cosine of `a` degrees.
    Cos,
    /// FN 8: `a LEN b`, the root of the sum of squares.
    Len,
    /// FN 13: `a ANG b`, the angle whose opposite side is `a` and whose adjacent side is `b`.
    Ang,
}

/// `FN 0: Q1 = +5` and its like.
#[derive(Clone, Debug)]
pub struct FnAssign {
    /// The parameter that is set.
    pub target: QRef,
    /// Its place.
    pub target_span: Span,
    /// The operation.
    pub op: FnOp,
    /// The first operand.
    pub a: Operand,
    /// The second one, where the operation has two.
    pub b: Option<Operand>,
}

/// A comparison of a jump.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// FN 9, `EQU`.
    Equal,
    /// FN 10, `NE`.
    NotEqual,
    /// FN 11, `GT`.
    Greater,
    /// FN 12, `LT`.
    Less,
    /// FN 9, `IS UNDEFINED`; no operand follows.
    Undefined,
    /// FN 9, `IS DEFINED`; no operand follows.
    Defined,
}

impl Relation {
    /// Whether it holds between two numbers; nothing of those that ask whether there is a value.
    pub fn holds(self, a: f64, b: f64) -> Option<bool> {
        match self {
            Self::Equal => Some(a == b),
            Self::NotEqual => Some(a != b),
            Self::Greater => Some(a > b),
            Self::Less => Some(a < b),
            Self::Undefined | Self::Defined => None,
        }
    }
}

/// A conditional jump.
#[derive(Clone, Debug)]
pub struct FnJump {
    /// The comparison.
    pub relation: Relation,
    /// Left of it.
    pub a: Operand,
    /// Right of it.
    pub b: Operand,
    /// Where to.
    pub label: LabelRef,
}

impl FnJump {
    /// Whether it always or never jumps, because it compares two written numbers; nothing if that depends on the run.
    pub fn decided(&self) -> Option<bool> {
        match (self.a.amount, self.b.amount) {
            (Amount::Number(a), Amount::Number(b)) => self.relation.holds(a, b),
            _ => None,
        }
    }
}

/// An assignment by formula.
#[derive(Clone, Debug)]
pub struct Formula {
    /// The parameter that is set.
    pub target: QRef,
    /// Its place.
    pub target_span: Span,
    /// The formula; its spans count from the start of `text`.
    pub expr: Expr,
    /// The formula's place in the program.
    pub text: Span,
}
