//! A cycle call (CYCL CALL, M99, M89, a pattern such as CYCL DEF 220) with no cycle defined before it,
//! on any way that the run can take.
//!
//! Silent after calls of other programs, which may define one, and in programs that name neither blank nor tool:
//! others call them and may have defined the cycle.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Pending, Rule};

pub(super) const RULE: Rule = Rule { code: "called-but-not-defined", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // A call of what must not be called is reported by a rule of its own.
    let reported = !facts.flow.jumps && !facts.flow.programs;
    let first = facts.definitions.first().map_or(usize::MAX, |definition| definition.view.first);
    let mut last = None;
    let calls = facts.run.calls.iter().filter(|call| call.modal.pending == Pending::None);
    // A pattern is a definition itself.
    let pattern = |block: usize| facts.definition_at(block).is_some();
    for call in calls.filter(|call| !(reported && first < call.block) || pattern(call.block)) {
        if last.replace(call.span) != Some(call.span) {
            found.push(rule.at(facts, call.span));
        }
    }
}
