//! A subprogram that calls itself, be it through others.
//!
//! Where the program has conditional jumps or blocks that may be skipped, it may end all the same, and this is a
//! warning. A call of a label that is set twice is looked at by itself: it stands between that label and its LBL 0.
use std::collections::BTreeSet;

use crate::check::{Facts, Rule, Use, Way};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::{BlockKind, Label};

pub(super) const RULE: Rule = Rule { code: "subprogram-recursive", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let run = &facts.run;
    let conditional = facts.flow.skips || run.graph.uses.iter().any(|own| own.way == Way::Jump);
    let doubled = run.graph.uses.iter().zip(0..).filter(|(own, _)| is_inside_own(facts, own)).map(|(_, at)| at);
    let calls: BTreeSet<usize> = run.recursive_calls().chain(doubled).collect();
    for at in calls {
        let Some(own) = run.graph.uses.get(at) else { continue };
        let finding =
            rule.at(facts, own.span).arg("label", own.mark.as_ref().map(ToString::to_string).unwrap_or_default());
        found.push(Diagnostic { severity: if conditional { Severity::Warning } else { finding.severity }, ..finding });
    }
}

/// Whether a label that is set more than once is called between one of its places and the LBL 0 behind it.
fn is_inside_own(facts: &Facts<'_>, own: &Use) -> bool {
    let places = own.mark.as_ref().and_then(|mark| facts.run.graph.labels.get(mark));
    let Some(places) = places.filter(|places| own.way == Way::Call && places.len() > 1) else { return false };
    let before = facts.marked().rev().skip_while(|(index, _)| *index >= own.block);
    let mut labels = before.filter_map(|(index, block)| match &block.kind {
        BlockKind::Lbl(label) => Some((index, label.target)),
        _ => None,
    });
    labels
        .find(|(index, label)| *label == Label::END || places.contains(index))
        .is_some_and(|(_, label)| label != Label::END)
}
