//! Faults: why a run ends before its end, in separate classes.
//!
//! Invariant: a fault is data with a stable code; a motion is never approximated, it is a fault instead.
use std::borrow::Cow;

use super::event::Status;
use crate::diag::{Arg, Diagnostic, Place};
use crate::engine::solid::SolidError;
use crate::engine::table::TableError;
use crate::expr::EvalError;

/// The classes of faults.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Class {
    /// The program is wrong.
    Program,
    /// The control itself would stop: a guard, a probe that does not touch, a collision.
    Control,
    /// A limit of the engine.
    Limit,
    /// The engine cannot do it.
    Unsupported,
    /// A mistake of the engine or of a specification.
    Internal,
}

impl Class {
    /// How a run ends that has such a fault.
    pub const fn status(self) -> Status {
        match self {
            Self::Program | Self::Control | Self::Internal => Status::Error,
            Self::Limit => Status::Limit,
            Self::Unsupported => Status::Unsupported,
        }
    }
}

/// A fault.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Its class.
    pub class: Class,
    /// Its code: of the engine (text `diag-<code>`) or of a specification (text `guard-<code>`).
    pub code: Cow<'static, str>,
    /// Whether the code is one of a specification.
    pub of_cycle: bool,
    /// What decided.
    pub args: Vec<(&'static str, Arg)>,
}

impl Fault {
    pub(super) const fn new(class: Class, code: &'static str) -> Self {
        Self { class, code: Cow::Borrowed(code), of_cycle: false, args: Vec::new() }
    }

    pub(super) const fn program(code: &'static str) -> Self {
        Self::new(Class::Program, code)
    }

    pub(super) const fn control(code: &'static str) -> Self {
        Self::new(Class::Control, code)
    }

    pub(super) const fn unsupported(code: &'static str) -> Self {
        Self::new(Class::Unsupported, code)
    }

    /// A fault with a code of a specification.
    pub(super) fn of_cycle(code: &str) -> Self {
        Self { class: Class::Control, code: Cow::Owned(code.to_owned()), of_cycle: true, args: Vec::new() }
    }

    pub(super) fn arg(mut self, name: &'static str, value: impl Into<Arg>) -> Self {
        self.args.push((name, value.into()));
        self
    }

    /// The fault as a diagnostic: code of the engine, or `cycle-error` with the code of the specification.
    pub fn diagnostic(&self, place: Option<Place>) -> Diagnostic {
        let code = match &self.code {
            Cow::Borrowed(code) => code,
            Cow::Owned(_) => "cycle-error",
        };
        let mut diagnostic = Diagnostic::global(code);
        diagnostic.place = place;
        diagnostic.args.clone_from(&self.args);
        if self.of_cycle {
            diagnostic.args.push(("code", self.code.as_ref().into()));
        }
        diagnostic
    }
}

impl From<EvalError> for Fault {
    fn from(error: EvalError) -> Self {
        match error {
            EvalError::DivisionByZero => Self::program("division-by-zero"),
            EvalError::Domain(func, value) => {
                Self::program("outside-domain").arg("function", func.name()).arg("value", value)
            }
            EvalError::Overflow => Self::program("number-too-large"),
            EvalError::Undefined(q) => Self::program("parameter-undefined").arg("q", q.to_string()),
            EvalError::Kind => Self::program("text-or-number"),
        }
    }
}

impl From<TableError> for Fault {
    fn from(error: TableError) -> Self {
        let diagnostic = error.diagnostic();
        Self { args: diagnostic.args, ..Self::control(diagnostic.code) }
    }
}

impl From<SolidError> for Fault {
    fn from(error: SolidError) -> Self {
        Self::unsupported(error.code())
    }
}
