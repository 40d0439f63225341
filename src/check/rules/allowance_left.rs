//! A contour that is machined with two tools and the same oversize DR both times: the allowance of roughing is still there
//! after finishing. Also one that a negative DR machines first, and another tool then with a greater one: it finds nothing.
use std::collections::BTreeMap;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Loaded, Mark, Rule, Way};
use crate::program::syntax::{Amount, BlockKind, ToolRef};

pub(super) const RULE: Rule = Rule { code: "allowance-left", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    // The calls of each subprogram: the block of the tool and its oversize.
    let mut calls: BTreeMap<&Mark, Vec<(u32, f64)>> = BTreeMap::new();
    for own in facts.run.graph.uses.iter().filter(|own| own.way == Way::Call) {
        let (Some(mark), Some(modal)) = (&own.mark, facts.run.before(own.block)) else { return };
        let Loaded::By(tool) = modal.loaded else { continue };
        let Some(BlockKind::ToolCall(call)) = blocks.get(tool as usize).map(|block| &block.kind) else { continue };
        let oversize = match call.dr.map(|own| own.amount) {
            None => 0.0,
            Some(Amount::Number(number)) => number,
            Some(_) => return,
        };
        calls.entry(mark).or_default().push((tool, oversize));
    }
    let number = |tool: u32| match blocks.get(tool as usize).map(|block| &block.kind) {
        Some(BlockKind::ToolCall(call)) => match call.tool {
            Some(ToolRef::Number(own)) => Some(facts.text(own.span)),
            Some(ToolRef::Name(name)) => Some(facts.text(name)),
            None => None,
        },
        _ => None,
    };
    for (mark, calls) in calls {
        let (Some((first, left)), Some((last, end))) = (calls.first(), calls.last()) else { continue };
        let same = *left > 0.0 && calls.iter().all(|(_, own)| own == left);
        let milled = facts.run.graph.block_of(mark).is_some_and(|at| facts.shaped().any(|(own, _)| own > at));
        let other = number(*first) != number(*last);
        // What a smaller radius has cut away is no longer there for a greater one.
        if *left < 0.0
            && *end > *left
            && other
            && milled
            && let Some(block) = blocks.get(*first as usize)
        {
            let finding = rule.at(facts, facts.content(block)).arg("what", "below");
            let finding = finding.arg("value", crate::base::diag::Arg::Number(*left));
            found.push(finding.arg("label", mark.to_string()));
        }
        if same
            && other
            && milled
            && let Some(block) = blocks.get(*last as usize)
        {
            let finding = rule.at(facts, facts.content(block)).arg("what", "left");
            let finding = finding.arg("value", crate::base::diag::Arg::Number(*end));
            found.push(finding.arg("label", mark.to_string()));
        }
    }
}
