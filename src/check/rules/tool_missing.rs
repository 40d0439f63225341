//! A cycle that moves before any tool call has named the tool axis, on any way that the run can take.
//!
//! Reported once a program. Silent after calls of other programs and blocks that are not analysed (turning has no tool
//! axis), and in programs that name neither blank nor tool: others call them.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Defined, Facts, Rule, Tri};
use crate::spec::Keyword;

pub(super) const RULE: Rule = Rule { code: "tool-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let missing = |modal: crate::check::Modal| modal.is(Aspect::Tool) == Tri::No;
    let calls = facts.run.calls.iter().filter(|call| missing(call.modal) && !facts.definitions.is_empty());
    // What a cycle of the machine builder needs, no one knows.
    let probe = |own: &&Defined<'_>| own.key.keyword == Keyword::TchProbe && own.related_cycle().is_some();
    let probes = facts.definitions.iter().filter(probe);
    let probes = probes.filter(|own| facts.run.before(own.view.first).is_some_and(missing)).map(|own| own.view.head);
    let first = calls.map(|call| call.span).chain(probes).min_by_key(|span| span.start);
    if let Some(span) = first {
        found.push(rule.at(facts, span));
    }
}
