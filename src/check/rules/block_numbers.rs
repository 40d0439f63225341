//! Block numbers that do not rise.
//!
//! The control numbers anew what it reads, so this is a note, said once a program: blocks may have been moved, lost or
//! written twice.
use crate::check::{Facts, Rule};
use crate::diag::{Arg, Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "block-numbers", severity: Severity::Note, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut last: Option<u32> = None;
    for block in facts.program.blocks() {
        let Some(number) = block.number else { continue };
        if let Some(before) = last.filter(|before| number <= *before) {
            let finding = rule.at(facts, facts.content(block)).arg("number", Arg::Number(f64::from(number)));
            found.push(finding.arg("before", Arg::Number(f64::from(before))));
            return;
        }
        last = Some(number);
    }
}
