//! A parameter that stands before one which it follows on the control.
//!
//! Controls know parameters by their numbers, so this is a warning; it is said once a definition.
//! Lines of the old form are counted by their numbers; within a line their fields may stand in any order, as may lines
//! that are repeated, such as those of a datum shift.
use super::together;
use crate::check::{Definition, Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::Cycle;
use crate::syntax::{CycleForm, OldCycleLine};

pub(super) const RULE: Rule = Rule { code: "misordered-parameter", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if let CycleForm::Lines(lines) = &definition.view.form {
        let repeats =
            |cycle: &Cycle| cycle.params.iter().any(|own| own.field.as_ref().is_some_and(|field| field.repeat));
        if definition.cycle().is_some_and(repeats) {
            return;
        }
        let swapped = lines.windows(2).find(|pair| pair[1].line > 0 && pair[1].line < pair[0].line);
        if let Some([before, line]) = swapped {
            let name = |line: &OldCycleLine| format!("{}.{}", line.number, line.line);
            let finding = rule.at(facts, line.head).arg("parameter", name(line)).arg("before", name(before));
            found.push(finding.arg("cycle", definition.key.to_string()));
        }
        return;
    }
    if definition.in_order || definition.cycle().is_none_or(Cycle::is_old_style) {
        return;
    }
    let mut last: Option<(usize, &str)> = None;
    for item in &definition.items {
        let Some(own) = item.index else { continue };
        match last {
            Some((before, name)) if own < before => {
                let finding = rule.at(facts, item.span).arg("parameter", item.name.as_ref());
                found.push(finding.arg("before", name).arg("cycle", definition.key.to_string()));
                break;
            }
            _ => last = Some((own, item.name.as_ref())),
        }
    }
}
