//! A repeat of a part whose label comes after it.
//!
//! The part that is repeated lies between the label and the repeat, so the label comes before.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule, Way};

pub(super) const RULE: Rule = Rule { code: "repeat-of-later-label", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let graph = &facts.run.graph;
    for own in graph.uses.iter().filter(|own| own.way == Way::Repeat) {
        let later = own.mark.as_ref().and_then(|mark| graph.block_of(mark)).is_some_and(|block| block > own.block);
        if let (true, Some(mark)) = (later, &own.mark) {
            found.push(rule.at(facts, own.span).arg("label", mark.to_string()));
        }
    }
}
