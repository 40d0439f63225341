//! A cycle that finishes contours and is called before the one that roughs them out, and a pilot hole that is drilled for
//! the tool that drills it where another one roughs out afterwards.
//!
//! The order is that of the text, of calls for the same list of contours, in programs without jumps.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::contours::listed;
use crate::check::program::{number, with_meaning};
use crate::check::{Defined, Facts, Loaded, Pending, Rule};
use crate::program::syntax::{Amount, BlockKind, ToolRef};

pub(super) const RULE: Rule = Rule { code: "finishing-before-roughing", severity: Severity::Warning, run };

/// The meaning of the parameter that only cycles for roughing out have.
const ROUGHING: &str = "coarse-roughing-tool";
/// The meaning of the one that names the tool which comes after the pilot hole.
const PILOT: &str = "rough-out-tool";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    pilots(rule, facts, found);
    if facts.flow.jumps {
        return;
    }
    let has = |own: &Defined<'_>, meaning: &str| {
        own.related_cycle().is_some_and(|cycle| with_meaning(cycle, meaning).is_some())
    };
    // Whether a list of contours belongs to it: the cycles that only finish read the data of all of them, too.
    let reads = |own: &Defined<'_>| {
        own.related_cycle().and_then(|cycle| cycle.file.contour.as_ref()).is_some_and(|own| own.closed && own.displaces)
    };
    let lists: Vec<usize> = listed(facts).iter().map(|own| own.list.view.first).collect();
    let list_of = |block: usize| lists.partition_point(|own| *own < block);
    let called: Vec<(&Defined<'_>, usize)> = facts
        .run
        .calls
        .iter()
        .filter_map(|call| match call.modal.pending {
            Pending::Definition(index) => Some((facts.definitions.get(index as usize)?, call.block)),
            _ => None,
        })
        .filter(|(own, _)| reads(own))
        .collect();
    for (at, (own, block)) in called.iter().enumerate() {
        if has(own, ROUGHING) {
            continue;
        }
        let same = |other: &&(&Defined<'_>, usize)| has(other.0, ROUGHING) && list_of(other.1) == list_of(*block);
        let before = called.iter().take(at).any(|other| same(&other));
        let after = called.iter().skip(at + 1).find(same);
        if let (false, Some((roughing, _))) = (before, after) {
            let place = facts.program.blocks().get(*block).map(|block| facts.content(block));
            let Some(place) = place else { continue };
            let finding = rule.at(facts, place).arg("what", "order").arg("cycle", own.key.to_string());
            return found.push(finding.arg("other", roughing.key.to_string()));
        }
    }
}

/// The pilot holes for the tool that drills them, where another one roughs out afterwards.
fn pilots(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (at, call) in facts.run.calls.iter().enumerate() {
        let (Pending::Definition(index), Some(tool)) = (call.modal.pending, loaded_tool(facts, call.modal.loaded))
        else {
            continue;
        };
        let Some(own) = facts.definitions.get(index as usize) else { continue };
        if own.related_cycle().is_none_or(|cycle| with_meaning(cycle, PILOT).is_none()) {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some(item) = read.item(PILOT).filter(|item| number(item) == Some(tool)) else { continue };
        let roughs = |index: u32| {
            let cycle = facts.definitions.get(index as usize).and_then(Defined::related_cycle);
            cycle.is_some_and(|cycle| with_meaning(cycle, ROUGHING).is_some())
        };
        let mut after = facts.run.calls.iter().skip(at + 1);
        let roughing = after.find(|call| matches!(call.modal.pending, Pending::Definition(index) if roughs(index)));
        if roughing.and_then(|call| loaded_tool(facts, call.modal.loaded)).is_some_and(|other| other != tool) {
            let finding = rule.at(facts, item.value_span).arg("what", "pilot").arg("cycle", own.key.to_string());
            found.push(finding.arg("other", item.name.as_ref()));
        }
    }
}

/// The number of the tool in the spindle.
fn loaded_tool(facts: &Facts<'_>, loaded: Loaded) -> Option<f64> {
    let Loaded::By(block) = loaded else { return None };
    let BlockKind::ToolCall(call) = &facts.program.blocks().get(block as usize)?.kind else { return None };
    match call.tool? {
        ToolRef::Number(operand) => match operand.amount {
            Amount::Number(number) => Some(number).filter(|number| *number > 0.0),
            _ => None,
        },
        ToolRef::Name(_) => None,
    }
}
