//! A cycle that works with the data of another one, called before that one is defined.
//!
//! Roughing, pilot drilling and finishing of contours take depth, allowances and heights from the cycle that keeps
//! them. Reported once a program, and only where no way of the run has defined it.
use crate::base::diag::{Diagnostic, Place, Severity};
use crate::check::cycle::Effect;
use crate::check::{Aspect, Facts, Pending, Rule, Tri};

pub(super) const RULE: Rule = Rule { code: "contour-data-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for call in facts.run.calls.iter().filter(|call| call.modal.is(Aspect::ContourData) == Tri::No) {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(definition) = facts.definitions.get(index as usize) else { continue };
        if !definition
            .related_cycle()
            .is_some_and(|cycle| cycle.file.contour.is_some() && Effect::of_cycle(cycle).recalls())
        {
            continue;
        }
        let keepers = facts.against.catalogue.controls.values().flat_map(|on| on.cycles.values());
        let Some(keeper) = keepers.into_iter().find(|own| Effect::of_cycle(own).keeps()) else { continue };
        let finding = rule.at(facts, call.span).arg("cycle", definition.key.to_string());
        let finding = finding.arg("data", keeper.key.to_string());
        found.push(finding.related("defined-here", Place::new(facts.program.source(), definition.view.head)));
        return;
    }
}
