//! A cycle call (CYCL CALL, M99, M89) with no cycle defined before it, on any way that the run can take.
//!
//! Silent behind calls of other programs, which may define one, and in programs that name neither blank nor tool:
//! others call them and may have defined the cycle.
use crate::check::{Facts, Pending, Rule};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "called-but-not-defined", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // A call of what must not be called is told by itself.
    let told = !facts.flow.jumps && !facts.flow.programs;
    let first = facts.definitions.first().map_or(usize::MAX, |definition| definition.view.first);
    let mut last = None;
    let calls = facts.run.calls.iter().filter(|call| call.modal.pending == Pending::None);
    for call in calls.filter(|call| !(told && first < call.block)) {
        if last.replace(call.span) != Some(call.span) {
            found.push(rule.at(facts, call.span));
        }
    }
}
