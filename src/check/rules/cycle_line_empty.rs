//! A line of a definition in the old form that is empty, though the cycle has a field there that must not be
//! left out; of cycles that no manual names also, as a note, a line with a label only.
use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Definition, Facts, Rule};
use crate::program::fields::stands_on;
use crate::program::syntax::{CycleForm, OldCycleLine, SHORTEST_LABEL, ValueKind};
use crate::spec::Known;

pub(super) const RULE: Rule = Rule { code: "cycle-line-empty", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    let CycleForm::Lines(lines) = &definition.view.form else { return };
    let Some(cycle) = definition.cycle() else {
        if facts.against.catalogue.controls.values().all(|on| matches!(on.known(definition.key), Known::Unknown)) {
            unknown(rule, facts, definition, lines, found);
        }
        return;
    };
    for line in lines.iter().filter(|line| line.line > 0 && line.words.is_empty()) {
        let mut fields = cycle.params.iter().filter_map(|param| param.field.as_ref());
        if fields.any(|field| !field.optional && stands_on(field, line)) {
            let name = format!("{}.{}", line.number, line.line);
            found.push(rule.at(facts, line.head).arg("line", name).arg("cycle", definition.key.to_string()));
        }
    }
}

/// The lines of a cycle of which nothing is known: each has a value.
fn unknown(
    rule: &Rule,
    facts: &Facts<'_>,
    definition: &Definition<'_>,
    lines: &[&OldCycleLine],
    found: &mut Vec<Diagnostic>,
) {
    for line in lines.iter().filter(|line| line.line > 0) {
        let is_label = |name: &str| name.chars().filter(|c| c.is_alphabetic()).count() >= SHORTEST_LABEL;
        // Some posts print the label of a dwell that they do not need.
        let severity = match line.words.as_slice() {
            [] => rule.severity,
            [word] if word.value.kind == ValueKind::Missing && is_label(facts.text(word.name)) => Severity::Note,
            _ => continue,
        };
        let name = format!("{}.{}", line.number, line.line);
        let finding = rule.at(facts, line.head).arg("line", name).arg("cycle", definition.key.to_string());
        found.push(Diagnostic { severity, ..finding });
    }
}
