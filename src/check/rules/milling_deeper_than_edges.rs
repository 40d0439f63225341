//! A tool that mills through material higher than its cutting edges are long (LCUTS): its shank rubs.
//!
//! Only where the tool table is named and the height of the material is known: what was cut before counts, arcs and cycles
//! after which it is not known end that. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "milling-deeper-than-edges", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (span, own) in incidents(facts) {
        if let Incident::DeeperThanCuttingEdge(height) = own {
            found.push(rule.at(facts, *span).arg("value", Arg::Number(*height)));
        }
    }
}
