//! A rule of the checker.
use super::Facts;
use crate::base::diag::{Diagnostic, Place, Severity, Span};

/// A rule of the checker.
#[derive(Debug)]
pub struct Rule {
    /// The stable code of its findings.
    pub code: &'static str,
    /// How bad they are; guards of specifications have a severity each.
    pub severity: Severity,
    /// Looks for them.
    pub(super) run: fn(&Rule, &Facts<'_>, &mut Vec<Diagnostic>),
}

impl Rule {
    /// A finding of this rule.
    pub(super) fn at(&self, facts: &Facts<'_>, span: Span) -> Diagnostic {
        let place = Place::new(facts.program.source(), span);
        Diagnostic { severity: self.severity, ..Diagnostic::error(self.code, place) }
    }
}
