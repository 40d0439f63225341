//! Faults: why a run ends before its end, in separate classes.
//!
//! Invariant: a fault is data with a stable code; a motion is never approximated, it is a fault instead.
use std::borrow::Cow;

use crate::base::diag::{Arg, Diagnostic, Place};
use crate::base::expr::{EvalError, LONGEST_TEXT};
use crate::engine::report::event::Status;
use crate::engine::solid::SolidError;
use crate::engine::table::TableError;

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

/// Every code of the engine with its class; a mistake of the engine cannot be provoked by a program.
pub const CODES: &[(&str, Class)] = &[
    ("angle-missing", Class::Program),
    ("approach-impossible", Class::Program),
    ("approach-word", Class::Program),
    ("arc-scaled-unequally", Class::Program),
    ("axis-limit", Class::Control),
    ("block-limit", Class::Limit),
    ("block-unreadable", Class::Program),
    ("call-depth-limit", Class::Limit),
    ("character-unknown", Class::Program),
    ("collision", Class::Control),
    ("compensation-at-cycle", Class::Program),
    ("compensation-begin", Class::Program),
    ("compensation-side", Class::Program),
    ("compensation-too-large", Class::Control),
    ("contour-begin-incomplete", Class::Program),
    ("contour-count", Class::Control),
    ("contour-crossing", Class::Program),
    ("contour-data-undefined", Class::Program),
    ("contour-depth", Class::Program),
    ("contour-elements", Class::Control),
    ("contour-empty", Class::Program),
    ("contour-lead", Class::Program),
    ("contour-limit", Class::Limit),
    ("contour-missing", Class::Program),
    ("contour-not-defined", Class::Program),
    ("contour-open", Class::Program),
    ("contour-side-missing", Class::Program),
    ("contour-tool-axis", Class::Program),
    ("contour-undeclared", Class::Program),
    ("coordinate-out-of-place", Class::Program),
    ("cutting-width-missing", Class::Control),
    ("cycle-depth-limit", Class::Internal),
    ("cycle-unknown", Class::Unsupported),
    ("digitizing-axis-wrong", Class::Program),
    ("digitizing-contour-lost", Class::Control),
    ("digitizing-range-incomplete", Class::Program),
    ("digitizing-range-left", Class::Control),
    ("digitizing-range-missing", Class::Program),
    ("digitizing-range-of-points", Class::Program),
    ("digitizing-range-points", Class::Program),
    ("digitizing-range-wrong", Class::Program),
    ("digitizing-rotary-analog", Class::Program),
    ("digitizing-rotary-axis", Class::Unsupported),
    ("digitizing-time-exceeded", Class::Control),
    ("direction-contradicts", Class::Program),
    ("direction-missing", Class::Program),
    ("direction-undefined", Class::Control),
    ("division-by-zero", Class::Program),
    ("elements-overlap", Class::Program),
    ("end-off-circle", Class::Program),
    ("error-of-program", Class::Control),
    ("feed-missing", Class::Program),
    ("field-missing", Class::Program),
    ("field-unknown", Class::Program),
    ("fit-collinear", Class::Control),
    ("fit-failed", Class::Control),
    ("fit-too-few", Class::Internal),
    ("free-contour-contradicts", Class::Program),
    ("free-contour-open", Class::Program),
    ("free-contour-reference", Class::Program),
    ("free-contour-selection", Class::Program),
    ("free-contour-several", Class::Program),
    ("free-contour-word", Class::Program),
    ("hirth-without-retraction", Class::Control),
    ("infeeds-never-reach-depth", Class::Control),
    ("insert-askew", Class::Unsupported),
    ("insert-direction", Class::Control),
    ("jump-limit", Class::Limit),
    ("jump-target-missing", Class::Program),
    ("jump-target-twice", Class::Program),
    ("kinematics-differs", Class::Control),
    ("kinematics-memory-full", Class::Control),
    ("kinematics-not-saved", Class::Control),
    ("kinematics-tool-axis", Class::Control),
    ("kinematics-undetermined", Class::Control),
    ("kinematics-unknown", Class::Unsupported),
    ("lines-parallel", Class::Control),
    ("log-failed", Class::Internal),
    ("log-template", Class::Internal),
    ("log-text", Class::Internal),
    ("m144-together", Class::Program),
    ("machine-parameter-missing", Class::Control),
    ("mask-missing", Class::Program),
    ("mask-unreadable", Class::Program),
    ("measuring-position-at-zero", Class::Control),
    ("measuring-position-near-limit", Class::Control),
    ("milling-mode-missing", Class::Program),
    ("move-limit", Class::Limit),
    ("no-cycle-to-call", Class::Program),
    ("no-such-parameter", Class::Program),
    ("number-too-large", Class::Program),
    ("open-table-missing", Class::Program),
    ("orientation-missing", Class::Control),
    ("output-path", Class::Program),
    ("outside-domain", Class::Program),
    ("parameter-in-addition", Class::Unsupported),
    ("parameter-missing", Class::Program),
    ("parameter-out-of-range", Class::Program),
    ("parameter-undefined", Class::Program),
    ("parameter-unknown", Class::Program),
    ("pattern-combination", Class::Program),
    ("pattern-missing", Class::Program),
    ("pattern-too-long", Class::Program),
    ("pattern-tool-axis", Class::Program),
    ("pattern-unreadable", Class::Program),
    ("plan-mistake", Class::Internal),
    ("plane-through-line", Class::Control),
    ("pole-missing", Class::Program),
    ("position-incomplete", Class::Program),
    ("probe-deflected", Class::Control),
    ("probe-measurements-differ", Class::Control),
    ("probe-missing", Class::Control),
    ("probe-no-contact", Class::Control),
    ("probe-no-direction", Class::Internal),
    ("program-missing", Class::Program),
    ("radius-missing", Class::Program),
    ("radius-too-small", Class::Program),
    ("recess-impossible", Class::Program),
    ("recursive-call", Class::Program),
    ("repeat-count", Class::Program),
    ("rotary-axis-missing", Class::Control),
    ("rotary-axis-unsuitable", Class::Control),
    ("rounding-impossible", Class::Program),
    ("rounding-misplaced", Class::Program),
    ("scaling-factor-zero", Class::Program),
    ("series-count", Class::Internal),
    ("series-limit", Class::Limit),
    ("shaft-collision", Class::Control),
    ("shape-impossible", Class::Control),
    ("solid-cusp", Class::Unsupported),
    ("solid-edge-unsupported", Class::Unsupported),
    ("solid-helix-unsupported", Class::Unsupported),
    ("solid-not-finite", Class::Internal),
    ("sphere-radius-differs", Class::Control),
    ("spline-start", Class::Control),
    ("strategy-argument", Class::Internal),
    ("table-bad-number", Class::Control),
    ("table-key-column", Class::Control),
    ("table-missing", Class::Control),
    ("table-no-column", Class::Control),
    ("table-no-row", Class::Control),
    ("table-too-wide", Class::Control),
    ("tangent-missing", Class::Program),
    ("text-or-number", Class::Program),
    ("text-too-long", Class::Limit),
    ("tilting-unreachable", Class::Control),
    ("tool-direction-unreachable", Class::Control),
    ("tool-locked", Class::Control),
    ("tool-not-in-table", Class::Program),
    ("tool-edges-too-many", Class::Control),
    ("tool-setter-askew", Class::Control),
    ("tool-setter-collision", Class::Control),
    ("tool-setter-missing", Class::Control),
    ("turn-limit", Class::Limit),
    ("undercut-form", Class::Unsupported),
    ("undercut-impossible", Class::Program),
    ("unsupported-axis", Class::Unsupported),
    ("unsupported-block", Class::Unsupported),
    ("unsupported-compensation", Class::Unsupported),
    ("unsupported-cycle", Class::Unsupported),
    ("unsupported-feed", Class::Unsupported),
    ("unsupported-m", Class::Unsupported),
    ("unsupported-path", Class::Unsupported),
    ("unsupported-tcpm", Class::Unsupported),
    ("unsupported-transformation", Class::Unsupported),
    ("value-missing", Class::Program),
    ("value-not-bound", Class::Internal),
    ("value-not-predefined", Class::Program),
    ("word-not-offered", Class::Program),
];

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
    pub(crate) const fn new(class: Class, code: &'static str) -> Self {
        Self { class, code: Cow::Borrowed(code), of_cycle: false, args: Vec::new() }
    }

    pub(crate) const fn program(code: &'static str) -> Self {
        Self::new(Class::Program, code)
    }

    pub(crate) const fn control(code: &'static str) -> Self {
        Self::new(Class::Control, code)
    }

    pub(crate) const fn unsupported(code: &'static str) -> Self {
        Self::new(Class::Unsupported, code)
    }

    /// A fault with a code of a specification.
    pub(crate) fn of_cycle(code: &str) -> Self {
        Self { class: Class::Control, code: Cow::Owned(code.to_owned()), of_cycle: true, args: Vec::new() }
    }

    pub(crate) fn arg(mut self, name: &'static str, value: impl Into<Arg>) -> Self {
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
            EvalError::TextTooLong => Self::new(Class::Limit, "text-too-long").arg("limit", LONGEST_TEXT as f64),
            EvalError::Overflow => Self::program("number-too-large"),
            EvalError::Undefined(q) => Self::program("parameter-undefined").arg("q", q.to_string()),
            EvalError::Kind => Self::program("text-or-number"),
        }
    }
}

impl From<TableError> for Fault {
    fn from(error: TableError) -> Self {
        // Scenes are checked when they are read: only what a program asks for can be missing or unfit.
        let class = match error {
            TableError::TextInNumbers { .. } => Class::Internal,
            _ => Class::Control,
        };
        let diagnostic = error.diagnostic();
        Self { args: diagnostic.args, ..Self::new(class, diagnostic.code) }
    }
}

impl From<SolidError> for Fault {
    fn from(error: SolidError) -> Self {
        let class = if error == SolidError::NotFinite { Class::Internal } else { Class::Unsupported };
        Self::new(class, error.code())
    }
}
