//! A line of a definition in the old form that does not follow line 0 of the same cycle.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::CycleForm;

pub(super) const RULE: Rule = Rule { code: "cycle-line-zero-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.unread("CYCL") || facts.unread("TCH") || !facts.begins() {
        return;
    }
    for definition in &facts.definitions {
        let CycleForm::Lines(lines) = &definition.view.form else { continue };
        if let Some(first) = lines.first().filter(|_| lines.iter().all(|line| line.line != 0)) {
            let line = format!("{}.{}", first.number, first.line);
            let finding = rule.at(facts, first.head).arg("line", line);
            found.push(finding.arg("head", format!("{}.0", first.number)));
        }
    }
}
