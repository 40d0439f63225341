//! A definition of the old form in which a line is left out: after line 3 comes line 5, or nothing comes after line 0.
//!
//! Of cycles that are described the parameter that is missing is reported instead.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::CycleForm;

pub(super) const RULE: Rule = Rule { code: "cycle-line-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.unread("CYCL") || facts.unread("TCH") {
        return;
    }
    for definition in facts.definitions.iter().filter(|own| own.cycle().is_none()) {
        let CycleForm::Lines(lines) = &definition.view.form else { continue };
        if let [only] = lines.as_slice()
            && only.line == 0
            && !definition.torn
        {
            let name = |line: u32| format!("{}.{line}", only.number);
            found.push(rule.at(facts, only.head).arg("line", "none").arg("missing", name(1)));
        }
        for pair in lines.windows(2) {
            let [before, own] = pair else { continue };
            if own.line > before.line + 1 {
                let name = |line: u32| format!("{}.{line}", own.number);
                found.push(rule.at(facts, own.head).arg("line", name(own.line)).arg("missing", name(before.line + 1)));
            }
        }
    }
}
