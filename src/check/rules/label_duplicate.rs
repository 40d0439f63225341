//! A label that a block before has set already.
use crate::base::diag::{Diagnostic, Place, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "label-duplicate", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let place = |block: usize| match facts.program.blocks().get(block).map(|block| &block.kind) {
        Some(BlockKind::Lbl(label)) => Some(label.span),
        _ => None,
    };
    for (mark, blocks) in &facts.run.graph.labels {
        let Some((first, others)) = blocks.split_first() else { continue };
        let Some(first) = place(*first) else { continue };
        for span in others.iter().filter_map(|block| place(*block)) {
            let first = Place::new(facts.program.source(), first);
            found.push(rule.at(facts, span).arg("label", mark.to_string()).related("first-place", first));
        }
    }
}
