//! A cycle of a kind that the manuals of the control do not treat, such as a drilling cycle on a control of which only
//! the touch-probe manual is known: nothing can be said of it, and it may well exist.
use super::unknown_cycle::has_other_keyword;
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::Known;

pub(super) const RULE: Rule = Rule { code: "cycle-not-covered", severity: Severity::Note, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let own = &facts.against.on.control;
    for definition in &facts.definitions {
        let judged = facts.against.on.covers(definition.key) || has_other_keyword(facts, definition);
        if !matches!(definition.known, Known::Unknown) || judged {
            continue;
        }
        let finding = rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string());
        found.push(finding.arg("control", own.title.as_str()));
    }
}
