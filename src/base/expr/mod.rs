//! Expressions: the formula language of the controls, one parser and one evaluator for it.
//!
//! Programs write `Q1 = Q2 + SIN +30`; specifications write the same language and may also compare,
//! choose and name values (`IF(Q208 = 0, Q206, Q208)`, `cut.to - dir * Q200`). What exists in
//! specifications only stays an error in programs. Invariant: this module knows no cycle and no
//! block; what a name stands for is decided by the caller's [`Resolve`] and [`Env`].
mod code;
mod func;
mod lexer;
mod parser;
mod value;

pub use code::{Code, Env, EvalError, LONGEST_TEXT, OnlyParameters, Op, Resolve, Type, TypeError, compile};
pub use func::Func;
pub use parser::{Dialect, Expr, ExprError, Node, parse};
pub use value::{Value, atan2d, atand, cosd, sind, tand};

/// Reads a formula as an NC program may contain it (the part after `Q1 =`).
pub fn parse_formula(text: &str) -> Result<Expr, ExprError> {
    parse(text, Dialect::Program)
}

/// The family of a Q parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum QKind {
    /// `Q`: global number.
    Q,
    /// `QL`: local number.
    Ql,
    /// `QR`: remanent number.
    Qr,
    /// `QS`: text.
    Qs,
}

/// A Q parameter: its family and number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct QRef {
    /// The family.
    pub kind: QKind,
    /// The number, 0 to 65535.
    pub number: u16,
}

impl QRef {
    /// The global number parameter of that number.
    pub const fn q(number: u16) -> Self {
        Self { kind: QKind::Q, number }
    }

    /// Reads `Q200`, `QS400`, `QL1`, `QR1`, in any case; nothing else may follow.
    pub fn parse(text: &str) -> Option<Self> {
        let rest = text.strip_prefix(['Q', 'q'])?;
        let (kind, digits) = match rest.as_bytes().first()?.to_ascii_uppercase() {
            b'L' => (QKind::Ql, &rest[1..]),
            b'R' => (QKind::Qr, &rest[1..]),
            b'S' => (QKind::Qs, &rest[1..]),
            _ => (QKind::Q, rest),
        };
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        Some(Self { kind, number: digits.parse().ok()? })
    }
}

impl std::fmt::Display for QRef {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let family = match self.kind {
            QKind::Q => "Q",
            QKind::Ql => "QL",
            QKind::Qr => "QR",
            QKind::Qs => "QS",
        };
        write!(f, "{family}{}", self.number)
    }
}
