//! A touch-probe cycle for workpieces while the spindle certainly turns.
//!
//! Cycles that measure a tool turn it themselves. Silent at cycles that no manual of the control describes, and after
//! a tool call: whether it stops the spindle is the machine builder's affair. Reported once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::spec::{Group, Keyword};

pub(super) const RULE: Rule = Rule { code: "probe-while-turning", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let own = facts.definitions.iter().find(|own| {
        own.key.keyword == Keyword::TchProbe
            && own.related_cycle().is_some_and(|cycle| cycle.file.group != Group::ToolMeasurement)
            && facts.run.before(own.view.first).is_some_and(|modal| modal.is(Aspect::Spindle) == Tri::Yes)
    });
    if let Some(own) = own {
        found.push(rule.at(facts, own.view.head).arg("cycle", own.key.to_string()));
    }
}
