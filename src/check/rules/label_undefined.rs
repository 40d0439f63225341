//! A call, a repeat, a jump or a list of contours that names a label which no block sets.
//!
//! Silent in pieces of programs, and where a block that cannot be read may be the label.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule, Way};
use crate::program::syntax::{Block, BlockKind, Label};

pub(super) const RULE: Rule = Rule { code: "label-undefined", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.begins() || facts.unread("LBL") {
        return;
    }
    // Of a list that names several, the first one is reported.
    let (mut list, mut own_found) = (None, Vec::new());
    for own in &facts.run.graph.uses {
        let Some(mark) = &own.mark else { continue };
        if facts.run.graph.labels.contains_key(mark) {
            continue;
        }
        let finding = rule.at(facts, own.span).arg("label", mark.to_string());
        // What names a label in another way may mean one of another program, but for a list of contours in a cycle.
        let cycle = matches!(
            facts.program.blocks().get(own.block).map(|block| &block.kind),
            Some(BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_))
        );
        let severity = if own.way == Way::Named && !cycle { Severity::Warning } else { finding.severity };
        if own.way == Way::Named && list.replace(own.block) == Some(own.block) {
            continue;
        }
        own_found.push(Diagnostic { severity, ..finding });
    }
    // A label that a text parameter names may be any.
    let of_parameter =
        |block: &Block| matches!(&block.kind, BlockKind::Lbl(label) if matches!(label.target, Label::Q(_)));
    if !own_found.is_empty() && !facts.program.blocks().iter().any(of_parameter) {
        found.append(&mut own_found);
    }
}
