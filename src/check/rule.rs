//! A rule of the checker.
use super::Facts;
use super::incident::Incident;
use super::travel::first_incident;
use crate::base::diag::{Arg, Diagnostic, Place, Severity, Span};

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
    /// A finding of this rule that says what it is, a number and the one with which that is compared.
    pub(super) fn comparison(&self, facts: &Facts<'_>, span: Span, what: &str, value: f64, other: f64) -> Diagnostic {
        let finding = self.at(facts, span).arg("what", what).arg("value", Arg::Number(value));
        finding.arg("other", Arg::Number(other))
    }
    /// Reports the first incident that is wanted: what it is, and two numbers of it.
    pub(super) fn report_first(
        &self,
        facts: &Facts<'_>,
        found: &mut Vec<Diagnostic>,
        what: &'static str,
        wanted: impl Fn(Incident) -> Option<(f64, f64)>,
    ) {
        if let Some((span, (value, other))) = first_incident(facts, wanted) {
            found.push(self.comparison(facts, span, what, value, other));
        }
    }
}
