//! A cycle that works with the data of another one, called before that one is defined.
//!
//! Roughing, pilot drilling and finishing of contours take depth, allowances and heights from the cycle that keeps them.
//! Said once a program, and only where no way of the run has defined it.
use crate::check::{Aspect, Facts, Pending, Rule, Tri};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "contour-data-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for call in facts.run.calls.iter().filter(|call| call.modal.is(Aspect::ContourData) == Tri::No) {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(definition) = facts.definitions.get(index as usize) else { continue };
        let Some((cycle, kept)) = definition.cycle().zip(definition.kept) else { continue };
        if !kept.deed(cycle).recalls() {
            continue;
        }
        let keeper = facts.against.on.cycles.values().find(|own| {
            let kept = facts.against.labels.kept(own.key);
            kept.is_some_and(|kept| kept.deed(own).keeps())
        });
        let Some(keeper) = keeper else { continue };
        let finding = rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string());
        found.push(finding.arg("data", keeper.key.to_string()));
        return;
    }
}
