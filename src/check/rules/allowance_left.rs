//! A contour that is machined with two tools and the same oversize DR both times: the allowance of roughing is still there
//! after finishing; so is one that is machined twice with the same tool and the same oversize, but another speed or feed. Also one that a negative DR machines first, and another tool then with a greater one: it finds nothing.
//! So does the same tool with any greater oversize than before. Also a contour train that two tools machine with the same
//! allowance for the side.
use std::collections::{BTreeMap, HashMap};

use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::blank::is_unmoved;
use crate::check::contours::listed;
use crate::check::program::number;
use crate::check::tools::named;
use crate::check::{Defined, Facts, Loaded, Mark, Pending, Rule, ToolName, Way};
use crate::program::syntax::{Amount, Block, BlockKind, Compensates, ToolCall};

pub(super) const RULE: Rule = Rule { code: "allowance-left", severity: Severity::Warning, run };

/// The meaning of the allowance of a contour train, which others have as data of their contours.
const ALLOWANCE: &str = "side-allowance";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    trains(rule, facts, found);
    in_order(rule, facts, found);
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
    for (mark, calls) in calls {
        let (Some((first, left)), Some((last, end))) = (calls.first(), calls.last()) else { continue };
        let same = *left > 0.0 && calls.iter().all(|(_, own)| own == left);
        let milled = facts.run.graph.block_of(mark).is_some_and(|at| facts.shaped().any(|(own, _)| own > at));
        let other = are_others(facts, *first, *last);
        // What a smaller radius has cut away is no longer there for a greater one.
        if *left < 0.0
            && *end > *left
            && other
            && milled
            && let Some(block) = blocks.get(*first as usize)
        {
            let finding = rule.at(facts, facts.content(block)).arg("what", "below");
            let finding = finding.arg("value", Arg::Number(*left));
            found.push(finding.arg("label", mark.to_string()).arg("other", ""));
        }
        if same
            && (other || again(facts, *first, *last) && calls.len() == 2)
            && milled
            && let Some(block) = blocks.get(*last as usize)
        {
            let finding = rule.at(facts, facts.content(block)).arg("what", "left");
            let finding = finding.arg("value", Arg::Number(*end));
            found.push(finding.arg("label", mark.to_string()).arg("other", ""));
        }
    }
}

/// Cycles that machine a list of contours on their own, with an allowance of their own: one that two tools leave.
fn trains(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // The allowance of each definition, with its place.
    let mut known: HashMap<u32, Option<(f64, Span)>> = HashMap::new();
    let allowance = |own: &Defined<'_>| {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        read.item(ALLOWANCE).and_then(|item| Some((number(item)?, item.value_span)))
    };
    for list in listed(facts) {
        let mut passes: Vec<(u32, f64, u32, Span)> = Vec::new();
        for call in &facts.run.calls {
            let (Pending::Definition(index), Loaded::By(tool)) = (call.modal.pending, call.modal.loaded) else {
                continue;
            };
            let reader = list.readers.iter().find(|own| {
                facts.definitions.get(index as usize).is_some_and(|other| other.view.first == own.view.first)
            });
            let Some(reader) = reader else { continue };
            let Some((value, place)) = *known.entry(index).or_insert_with(|| allowance(reader)) else { return };
            passes.push((tool, value, index, place));
        }
        let (Some(first), Some(last)) = (passes.first(), passes.last()) else { continue };
        let same = first.1 > 0.0 && passes.iter().all(|own| own.1 == first.1);
        if same && first.2 != last.2 && are_others(facts, first.0, last.0) {
            let name = facts.definitions.get(last.2 as usize).map_or_else(String::new, |own| own.key.to_string());
            let finding = rule.at(facts, last.3).arg("what", "cycle").arg("label", name);
            found.push(finding.arg("value", Arg::Number(last.1)).arg("other", ""));
        }
    }
}

/// Oversizes that differ by less are the same, mm or inch.
const SAME: f64 = 1e-6;

/// The tool in the spindle with its oversize.
#[derive(Clone, Copy)]
struct Tool<'f> {
    name: ToolName<'f>,
    oversize: f64,
    span: Span,
}

/// Whether a tool machines a contour with an oversize, and afterwards with a greater one: only where nothing between the two
/// calls could make something else of the contour, no parameters, transformations, jumps or cycles.
fn in_order(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    let mut tool: Option<Tool<'_>> = None;
    // The contours that were machined, by the blocks of their labels.
    let mut machined: Vec<(usize, Tool<'_>)> = Vec::new();
    for (index, block) in blocks.iter().enumerate() {
        if facts.ends(block) || block.skip {
            return;
        }
        match &block.kind {
            BlockKind::ToolCall(call) if call.tool.is_some() => tool = called(facts, block, call),
            BlockKind::CallLbl(call) if call.repeat.is_none() => {
                let (Some(label), Some(tool)) = (facts.run.graph.called_from(index), tool) else {
                    machined.clear();
                    continue;
                };
                if !compensates(facts, label) {
                    continue;
                }
                let before = machined.iter().find(|(own, before)| {
                    *own == label && before.oversize < tool.oversize - SAME && before.name == tool.name
                });
                if let Some((_, before)) = before {
                    let finding = rule.comparison(facts, before.span, "order", before.oversize, tool.oversize);
                    found.push(finding.arg("label", ""));
                    return;
                }
                machined.push((label, tool));
            }
            BlockKind::Motion(_) | BlockKind::Functions(_) | BlockKind::Stop(_) => {}
            BlockKind::Comment | BlockKind::Empty | BlockKind::Structure(_) => {}
            _ => machined.clear(),
        }
    }
}

/// The tool that a block calls; nothing if it or its oversize is not known.
fn called<'f>(facts: &Facts<'f>, block: &Block, call: &ToolCall) -> Option<Tool<'f>> {
    let (oversize, span) = match &call.dr {
        Some(own) => (facts.number(own)?, own.span),
        None => (0.0, facts.content(block)),
    };
    Some(Tool { name: named(facts, call.tool?)?, oversize, span })
}

/// The tool that a block calls, unless a parameter chooses it.
fn tool_at<'f>(facts: &Facts<'f>, block: u32) -> Option<ToolName<'f>> {
    match facts.program.blocks().get(block as usize).map(|block| &block.kind) {
        Some(BlockKind::ToolCall(call)) => named(facts, call.tool?),
        _ => None,
    }
}

/// Whether two blocks call the same tool with another speed or feed, without a transformation at the second one.
fn again(facts: &Facts<'_>, one: u32, other: u32) -> bool {
    let same = tool_at(facts, one).zip(tool_at(facts, other)).is_some_and(|(one, other)| one == other);
    let call = |block: u32| match facts.program.blocks().get(block as usize).map(|block| &block.kind) {
        Some(BlockKind::ToolCall(call)) => {
            Some((call.speed.and_then(|own| facts.number(&own)), call.feed.as_ref().map(|own| facts.text(own.span))))
        }
        _ => None,
    };
    let unmoved = facts.run.before(other as usize).is_some_and(|modal| is_unmoved(&modal));
    one != other && same && unmoved && call(one) != call(other)
}

/// Whether two blocks certainly call different tools.
fn are_others(facts: &Facts<'_>, one: u32, other: u32) -> bool {
    tool_at(facts, one).zip(tool_at(facts, other)).is_some_and(|(one, other)| one != other)
}

/// Whether a subprogram has a contour with compensation, and nothing in it that depends on when it is called.
fn compensates(facts: &Facts<'_>, label: usize) -> bool {
    let Some(body) = facts.subprogram(label) else { return false };
    let plain = |block: &Block| match &block.kind {
        BlockKind::Motion(motion) => !motion.outline().has_parameters(),
        BlockKind::CallLbl(call) => call.repeat.is_some_and(|times| matches!(times.amount, Amount::Number(_))),
        BlockKind::Lbl(_) | BlockKind::Functions(_) => true,
        BlockKind::Comment | BlockKind::Empty | BlockKind::Structure(_) => true,
        _ => block.is_blend(),
    };
    let beside = |block: &Block| match &block.kind {
        BlockKind::Motion(motion) => motion.outline().compensates() == Compensates::Beside,
        _ => false,
    };
    body.iter().all(plain) && body.iter().any(beside)
}
