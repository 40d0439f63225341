//! A cycle that acts when it is called, and is not called on any way that the run can take.
//!
//! A pattern after it calls it. Silent in programs that call others, which may call it, and with M89, and where a
//! block after it cannot be read.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::first_way::FirstWay;
use crate::check::program::Work;
use crate::check::{Facts, Modal, Pending, Rule};
use crate::program::syntax::BlockKind;
use crate::spec::TakesEffect;

pub(super) const RULE: Rule = Rule { code: "defined-but-never-called", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.flow.programs || facts.flow.modal {
        return;
    }
    // Those of DIN/ISO, which have no definition that could be read.
    let way = FirstWay::of(facts);
    for own in way.uncalled().filter(|own| way.complete && facts.definition_at(own.first).is_none()) {
        found.push(rule.at(facts, own.head).arg("cycle", own.name.clone()));
    }
    // The states in which something calls the last cycle.
    let calls: Vec<Modal> = facts.run.calls.iter().map(|call| call.modal).collect();
    if calls.iter().any(|modal| modal.pending == Pending::Unknown) {
        return;
    }
    let mut called = vec![false; facts.definitions.len()];
    for modal in &calls {
        if let Pending::Definition(index) = modal.pending
            && let Some(called) = called.get_mut(index as usize)
        {
            *called = true;
        }
    }
    let mut unread = facts.marked().filter(|(_, block)| matches!(block.kind, BlockKind::Unknown(_)));
    let last_unread = unread.next_back().map(|(index, _)| index);
    for (definition, called) in facts.definitions.iter().zip(called) {
        let works = Work::of(facts.program, definition).is_some();
        let waits = definition.takes_effect() == Some(TakesEffect::OnCall) || works;
        let reached = facts.run.before(definition.view.first).is_some();
        // What cannot be read may be the call.
        let unread = last_unread.is_some_and(|unread| unread > definition.view.last);
        if waits && reached && !called && !unread {
            found.push(rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string()));
        }
    }
}
