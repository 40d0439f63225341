//! Block numbers that do not rise.
//!
//! The control numbers anew what it reads, so this is a note, reported once a program: blocks may have been moved, lost
//! or written twice.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "block-numbers", severity: Severity::Note, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some((index, before)) = facts.falling else { return };
    let Some(block) = facts.program.blocks().get(index) else { return };
    let finding = rule.at(facts, facts.content(block));
    let finding = finding.arg("number", Arg::Number(f64::from(block.number.unwrap_or_default())));
    found.push(finding.arg("before", Arg::Number(f64::from(before))));
}
