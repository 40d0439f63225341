//! A line of a definition in the old form on which nothing stands, though the cycle has a field there that must not be
//! left out.
use super::together;
use crate::check::{Definition, Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::fields::stands_on;
use crate::syntax::CycleForm;

pub(super) const RULE: Rule = Rule { code: "cycle-line-empty", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    let (CycleForm::Lines(lines), Some(cycle)) = (&definition.view.form, definition.cycle()) else { return };
    for line in lines.iter().filter(|line| line.line > 0 && line.words.is_empty()) {
        let mut fields = cycle.params.iter().filter_map(|param| param.field.as_ref());
        if fields.any(|field| !field.optional && stands_on(field, line)) {
            let name = format!("{}.{}", line.number, line.line);
            found.push(rule.at(facts, line.head).arg("line", name).arg("cycle", definition.key.to_string()));
        }
    }
}
