//! A touch-probe cycle for workpieces while the spindle certainly turns.
//!
//! Cycles that measure a tool turn it themselves. Silent behind a tool call: whether it stops the spindle is the machine
//! builder's affair. Said once a program.
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::diag::{Diagnostic, Severity};
use crate::spec::Keyword;

pub(super) const RULE: Rule = Rule { code: "probe-while-turning", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let tools = |number: u32| matches!(number, 30..=33 | 480..=499);
    let own = facts.definitions.iter().find(|own| {
        own.key.keyword == Keyword::TchProbe
            && !tools(own.key.number)
            && facts.run.before(own.view.first).is_some_and(|modal| modal.is(Aspect::Spindle) == Tri::Yes)
    });
    if let Some(own) = own {
        found.push(rule.at(facts, own.view.head).arg("cycle", own.key.to_string()));
    }
}
