//! A subprogram that calls itself, be it through others.
//!
//! Where the program has conditional jumps or blocks that may be skipped, it may end all the same, and this is a
//! warning. A call of a label that is set twice is looked at by itself: it is between that label and its LBL 0.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Mark, Rule, Way};

pub(super) const RULE: Rule = Rule { code: "subprogram-recursive", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let run = &facts.run;
    let conditional = facts.flow.skips || run.graph.uses.iter().any(|own| own.way == Way::Jump);
    let calls: BTreeSet<usize> = run.recursive_calls().chain(inside_doubled(facts)).collect();
    for at in calls {
        let Some(own) = run.graph.uses.get(at) else { continue };
        let finding =
            rule.at(facts, own.span).arg("label", own.mark.as_ref().map(ToString::to_string).unwrap_or_default());
        found.push(Diagnostic { severity: if conditional { Severity::Warning } else { finding.severity }, ..finding });
    }
}

/// The calls, by index of use, of labels that are set more than once, between one of their places and the LBL 0 after
/// it.
fn inside_doubled(facts: &Facts<'_>) -> Vec<usize> {
    let graph = &facts.run.graph;
    let doubled: BTreeSet<&Mark> =
        graph.labels.iter().filter(|(_, places)| places.len() > 1).map(|(mark, _)| mark).collect();
    if doubled.is_empty() {
        return Vec::new();
    }
    let places: BTreeMap<usize, &Mark> = doubled
        .iter()
        .filter_map(|mark| Some((graph.labels.get(*mark)?, *mark)))
        .flat_map(|(places, mark)| places.iter().map(move |place| (*place, mark)))
        .collect();
    let calls: BTreeMap<usize, (usize, &Mark)> = graph
        .uses
        .iter()
        .enumerate()
        .filter(|(_, own)| own.way == Way::Call)
        .filter_map(|(at, own)| Some((own.block, (at, own.mark.as_ref()?))))
        .collect();
    let (mut found, mut begun) = (Vec::new(), BTreeSet::new());
    for (index, block) in facts.marked() {
        if block.ends_subprogram() {
            begun.clear();
        } else if let Some(mark) = places.get(&index) {
            begun.insert(*mark);
        } else if let Some((at, mark)) = calls.get(&index)
            && begun.contains(mark)
        {
            found.push(*at);
        }
    }
    found
}
