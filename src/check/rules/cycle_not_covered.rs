//! A cycle of a kind that the manuals of the control do not treat, such as a drilling cycle on a control of which only
//! the touch-probe manual is known: it may well exist. It is measured by the manual of another control, or by none.
use super::cycle_not_described::other;
use super::unknown_cycle::has_other_keyword;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
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
        let finding = finding.arg("other", other(facts, definition));
        found.push(finding.arg("control", own.title.as_str()));
    }
}
