//! A call of a cycle that acts when it is defined and must not be called.
//!
//! Certain in two cases: only such cycles are defined before the call; or the call comes directly
//! after the definition of a pattern, which has called the cycle before it by itself already.
//! Otherwise the call means the last cycle that is called, whatever was defined since. Silent where
//! blocks are repeated, called or skipped, and after cycles of which nothing is known.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::is_silent;
use crate::check::{Defined, Facts, Rule};
use crate::program::syntax::BlockKind;
use crate::spec::TakesEffect;

pub(super) const RULE: Rule = Rule { code: "call-of-def-active-cycle", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.flow.jumps || facts.flow.programs {
        return;
    }
    let active = |own: &Defined<'_>| own.takes_effect() == Some(TakesEffect::OnDefinition);
    if !facts.definitions.iter().any(active) {
        return;
    }
    let mut coming = facts.definitions.iter().peekable();
    let (mut last, mut callable): (Option<&Defined<'_>>, bool) = (None, false);
    for (index, block) in facts.marked() {
        while let Some(next) = coming.next_if(|next| next.view.first < index) {
            callable |= !active(next);
            last = Some(next);
        }
        let Some(last) = last.filter(|last| active(last)) else { continue };
        let own = match &block.kind {
            BlockKind::CyclCall(call) => Some(call.head),
            _ => None,
        };
        let pattern = || last.calls_last();
        if callable && !(own.is_some() && directly_after(facts, last.view.first, index) && pattern()) {
            continue;
        }
        let functions = facts.functions(block);
        let called = functions.iter().filter(|own| matches!(own.number, 89 | 99)).map(|own| own.span);
        for span in own.into_iter().chain(called) {
            found.push(rule.at(facts, span).arg("cycle", last.key.to_string()));
        }
    }
}

/// Whether only comments are between two blocks.
fn directly_after(facts: &Facts<'_>, before: usize, at: usize) -> bool {
    let blocks = facts.program.blocks().get(..at).unwrap_or_default();
    blocks.iter().rposition(|block| !is_silent(block)) == Some(before)
}
