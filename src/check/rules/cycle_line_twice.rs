//! A definition of the old form in which a line has the number of the line before it, or a smaller one.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::CycleForm;

pub(super) const RULE: Rule = Rule { code: "cycle-line-twice", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        let CycleForm::Lines(lines) = &definition.view.form else { continue };
        for pair in lines.windows(2) {
            let [before, own] = pair else { continue };
            if own.line == before.line && own.line > 0 {
                let line = format!("{}.{}", own.number, own.line);
                found.push(rule.at(facts, own.head).arg("line", line));
            }
        }
    }
}
