//! A cycle that is called, or a touch-probe cycle, while radius compensation is certainly active.
//!
//! Cycles compensate for the tool themselves and want R0 where they begin. Said once a program.
use crate::check::{Aspect, Facts, Pending, Rule, Tri};
use crate::diag::{Diagnostic, Severity};
use crate::spec::Keyword;

pub(super) const RULE: Rule = Rule { code: "compensation-at-cycle", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let calls =
        facts.run.calls.iter().filter(|call| call.modal.is(Aspect::Compensation) == Tri::Yes).filter_map(|call| {
            let Pending::Definition(index) = call.modal.pending else { return None };
            Some((call.span, facts.definitions.get(index as usize)?))
        });
    let probes = facts.definitions.iter().filter(|own| own.key.keyword == Keyword::TchProbe).filter_map(|own| {
        let active = facts.run.before(own.view.first)?.is(Aspect::Compensation) == Tri::Yes;
        active.then_some((own.view.head, own))
    });
    if let Some((span, definition)) = calls.chain(probes).min_by_key(|(span, _)| span.start) {
        found.push(rule.at(facts, span).arg("cycle", definition.key.to_string()));
    }
}
