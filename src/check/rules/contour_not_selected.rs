//! A cycle that machines a contour, in milling or turning, and is called before anything has named a contour.
//!
//! CYCL DEF 14, SEL CONTOUR and CONTOUR DEF name one. Reported once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::contours::wanted;
use crate::check::{Aspect, Facts, Pending, Rule, Tri};

pub(super) const RULE: Rule = Rule { code: "contour-not-selected", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for call in facts.run.calls.iter().filter(|call| call.modal.is(Aspect::Contour) == Tri::No) {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(definition) = facts.definitions.get(index as usize) else { continue };
        if wanted(definition).is_some() {
            found.push(rule.at(facts, call.span).arg("cycle", definition.key.to_string()));
            return;
        }
    }
}
