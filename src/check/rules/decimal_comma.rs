//! A decimal comma in a program that has decimal points everywhere else: the control reads one of the two only.
//!
//! Only in values of cycle definitions, where at least one other has a point and fewer have a comma. Reported once a program.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::{Facts, Rule};
use crate::program::syntax::{CycleForm, ValueKind};

pub(super) const RULE: Rule = Rule { code: "decimal-comma", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut first, mut commas, mut points): (Option<Span>, usize, usize) = (None, 0, 0);
    for own in &facts.definitions {
        let CycleForm::Parameters(written) = &own.view.form else { continue };
        for value in written.parameters.iter().map(|own| own.value) {
            if !matches!(value.kind, ValueKind::Number(_)) {
                continue;
            }
            let text = facts.text(value.span);
            if text.contains(',') {
                commas += 1;
                first = first.or(Some(value.span));
            }
            points += usize::from(text.contains('.'));
        }
    }
    if let Some(span) = first.filter(|_| commas < points) {
        found.push(rule.at(facts, span));
    }
}
