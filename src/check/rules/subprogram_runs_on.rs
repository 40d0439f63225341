//! A subprogram that runs into the next one, because no LBL 0 is between them.
//!
//! Only reported where both are called, or read as contours, neither is jumped to or repeated, and nothing but blocks
//! that always follow each other is between the labels.
use std::collections::BTreeMap;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Mark, Rule, Way};
use crate::program::syntax::{BlockKind, Label};

pub(super) const RULE: Rule = Rule { code: "subprogram-runs-on", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let only_called = only_called(facts);
    let mut before: Option<(String, crate::base::diag::Span)> = None;
    for (_, block) in facts.marked() {
        match &block.kind {
            BlockKind::Lbl(label) => {
                let mark = match label.target {
                    Label::Number(number) => Mark::Number(number),
                    Label::Name(name) => Mark::Name(facts.text(name).to_owned()),
                    Label::Q(_) => continue,
                };
                if mark == Mark::Number(0) {
                    before = None;
                    continue;
                }
                let called = only_called.get(&mark).is_some_and(|own| *own);
                if let (true, Some((name, span))) = (called, &before) {
                    let finding = rule.at(facts, *span).arg("label", name.as_str()).arg("next", mark.to_string());
                    found.push(finding);
                }
                before = called.then(|| (mark.to_string(), label.span));
            }
            BlockKind::FnJump(_) => before = None,
            _ if facts.ends(block) => before = None,
            _ => {}
        }
    }
}

/// The labels that something leads to, and whether that are calls only.
fn only_called<'f>(facts: &'f Facts<'_>) -> BTreeMap<&'f Mark, bool> {
    let mut called = BTreeMap::new();
    for own in &facts.run.graph.uses {
        if let Some(mark) = &own.mark {
            *called.entry(mark).or_insert(true) &= matches!(own.way, Way::Call | Way::Named);
        }
    }
    called
}
