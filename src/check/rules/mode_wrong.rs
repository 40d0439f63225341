//! A milling cycle that is called while the control certainly turns, a turning cycle or FUNCTION TURNDATA while it
//! certainly mills.
//!
//! FUNCTION MODE TURN and FUNCTION MODE MILL choose. The control stops at such a call with an error (TNC 640, 001: 7302);
//! FUNCTION TURNDATA has no effect there, which is a warning. Reported once for each way; a machine may have other ways
//! to choose, and what is not certain is passed over.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::removes_material;
use crate::check::{Aspect, Defined, Facts, Pending, Rule, Tri};
use crate::program::syntax::{BlockKind, StatementKind};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "mode-wrong", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let turns = |own: &Defined<'_>| own.related_cycle().is_some_and(|cycle| cycle.file.group == Group::Turning);
    let mills = |own: &Defined<'_>| own.related_cycle().is_some_and(removes_material);
    for (turning, what) in [(Tri::Yes, "milling"), (Tri::No, "turning")] {
        let calls = facts.run.calls.iter().filter(|call| call.modal.is(Aspect::Turning) == turning);
        let mut wrong = calls.filter_map(|call| {
            let Pending::Definition(index) = call.modal.pending else { return None };
            let own = facts.definitions.get(index as usize)?;
            (if turning == Tri::Yes { mills(own) } else { turns(own) }).then_some((call.span, own))
        });
        if let Some((span, own)) = wrong.next() {
            found.push(rule.at(facts, span).arg("what", what).arg("cycle", own.key.to_string()));
        }
    }
    for (index, block) in facts.marked() {
        if let BlockKind::Statement(own) = &block.kind
            && own.kind == StatementKind::Function
            && facts.run.before(index).is_some_and(|modal| modal.is(Aspect::Turning) == Tri::No)
        {
            let text = facts.text(facts.content(block)).to_ascii_uppercase();
            if text.starts_with("FUNCTION TURNDATA") {
                let finding = rule.at(facts, facts.content(block)).arg("what", "data");
                let finding = Diagnostic { severity: Severity::Warning, ..finding };
                found.push(finding.arg("cycle", "FUNCTION TURNDATA"));
                return;
            }
        }
    }
}
