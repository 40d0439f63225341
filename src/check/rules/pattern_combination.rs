//! A pattern that would call a cycle which its manual does not let it call, or calls with a value that it excludes.
//!
//! Only reported where it is certain which cycle was defined last.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Pending, Rule};
use crate::program::syntax::{CycleForm, ValueKind};
use crate::spec::Combined;

pub(super) const RULE: Rule = Rule { code: "pattern-combination", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for pattern in &facts.definitions {
        let Some(combines) = pattern.related_cycle().map(|cycle| &cycle.file.combines).filter(|own| !own.is_empty())
        else {
            continue;
        };
        let pending = facts.run.before(pattern.view.first).map(|modal| modal.pending);
        let Some(Pending::Definition(index)) = pending else { continue };
        let Some(called) = facts.definitions.get(index as usize).filter(|own| own.related_cycle().is_some()) else {
            continue;
        };
        let listed = combines.iter().find(|own| own.cycle == called.key.number);
        if listed.is_none_or(|own| excluded(&called.view.form, own)) {
            let finding = rule.at(facts, pattern.view.head).arg("cycle", pattern.key.to_string());
            let value = listed.and_then(|own| own.q.zip(own.not));
            let what = if value.is_some() { "value" } else { "cycle" };
            let finding = finding.arg("what", what).arg("called", called.key.to_string());
            found.push(finding.arg("value", value.map_or_else(String::new, |(q, not)| format!("{q}={not}"))));
        }
    }
}

/// Whether the definition has the value that is excluded.
fn excluded(form: &CycleForm<'_>, combined: &Combined) -> bool {
    let (CycleForm::Parameters(written), Some((q, not))) = (form, combined.q.zip(combined.not)) else { return false };
    let mut found = false;
    written.parameters.each_value(|own, kind| {
        found |= own == q && matches!(kind, ValueKind::Number(number) if number == not);
    });
    found
}
