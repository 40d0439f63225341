//! A working plane that is certainly still tilted where the program ends.
//!
//! It stays tilted for whatever is run next.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};

pub(super) const RULE: Rule = Rule { code: "plane-not-reset", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let tilted = facts.run.ends.iter().find(|(_, modal)| modal.is(Aspect::Tilting) == Tri::Yes);
    if let Some(block) = tilted.and_then(|(block, _)| facts.program.blocks().get(*block)) {
        found.push(rule.at(facts, facts.content(block)));
    }
}
