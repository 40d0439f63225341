//! The guards of the specifications: what the control itself refuses, skips, doubts or asks.
//!
//! Each finding has the code of the guard. Only numbers and texts that the definition writes are
//! known; guards that a machine datum switches off count as active.
use std::collections::{BTreeSet, HashMap, HashSet};

use super::differs_from_other_control::Other;
use super::together;
use crate::base::diag::{Diagnostic, Severity, interned};
use crate::check::cycle::Ready;
use crate::check::guards::{Written, place};
use crate::check::incident::Incident;
use crate::check::tools::{Tool, Tools};
use crate::check::travel::incidents;
use crate::check::{Defined, Definition, Facts, Pending, Rule};
use crate::language::text;
use crate::program::syntax::BlockKind;
use crate::spec::{Cycle, CycleKey, Keyword, Outcome};

pub(super) const RULE: Rule = Rule { code: "guard", severity: Severity::Error, run };

/// The code of a feed that is compared with the spindle speed.
const FEED: &str = "feed-per-revolution-too-great";

/// What guards ask of the tool that a call finds in the spindle: the one that the program defines, or that of the table
/// which was given.
fn run(_: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    with_tools(facts, found);
    executed(facts, found);
}

/// What an execution shows: a message of the control that depends on what parameters, patterns and subprograms do. One that
/// is reported of what is written is not said again.
fn executed(facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (span, own) in incidents(facts) {
        let Incident::Refused(key, code) = own else { continue };
        if found.iter().any(|other| other.code == *code) {
            continue;
        }
        let own = facts.against.on.cycles.get(key).map(|cycle| (facts.against.on, cycle, Severity::Error));
        // What another control says is hardly different on this one.
        let other = || facts.against.catalogue.describing(*key).map(|(on, cycle)| (on, cycle, Severity::Warning));
        let Some((on, cycle, severity)) = own.or_else(other) else { continue };
        let rule = Rule { code, severity, run: together };
        let sentence = text::guard_sentence(on, cycle, code, facts.against.readers);
        found.push(rule.at(facts, *span).arg("message", sentence.unwrap_or_else(|| (*code).to_owned())));
    }
}

fn with_tools(facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(tools) = Tools::of(facts) else { return };
    let mut others: HashMap<CycleKey, Option<Other<'_>>> = HashMap::new();
    let (mut seen, mut reported) = (BTreeSet::new(), HashSet::new());
    // What the definition writes that was called last.
    let mut last: Option<(u32, Written)> = None;
    let calls = facts.run.calls.iter().map(|call| (call.modal.pending, call.modal.loaded));
    // Cycles that act when they are defined find the tool there.
    let at_once = |own: &Defined<'_>| own.key.keyword == Keyword::TchProbe || own.calls_last();
    let defined = facts.definitions.iter().zip(0..).filter(|(own, _)| at_once(own));
    let defined =
        defined.filter_map(|(own, index)| Some((Pending::Definition(index), facts.run.before(own.view.first)?.loaded)));
    // A pattern in a subprogram that several cycles use calls none of them for certain: the tool of the definition counts
    // where the subprogram is called right after it.
    let certain: HashSet<u32> = facts
        .run
        .calls
        .iter()
        .filter_map(|call| match call.modal.pending {
            Pending::Definition(index) => tools.get(call.modal.loaded).map(|_| index),
            _ => None,
        })
        .collect();
    let blocks = facts.program.blocks();
    let handed_on = facts.definitions.iter().zip(0..).filter_map(|(own, index)| {
        let next = blocks.get(own.view.last + 1).is_some_and(|next| matches!(next.kind, BlockKind::CallLbl(_)));
        let loaded = facts.run.before(own.view.first).filter(|_| next && !certain.contains(&index))?.loaded;
        Some((Pending::Definition(index), loaded))
    });
    for (pending, loaded) in calls.chain(defined).chain(handed_on) {
        let (Pending::Definition(index), Some(tool)) = (pending, tools.get(loaded)) else {
            continue;
        };
        // No one here knows what the machine builder has made of a number.
        let own = facts.definitions.get(index as usize).filter(|own| !own.torn && own.related_cycle().is_some());
        let Some(own) = own else { continue };
        let kept = own.cycle().zip(own.kept);
        let (cycle, on, guards) = match kept {
            Some((cycle, kept)) => (cycle, facts.against.on, facts.against.labels.guards_of(cycle, kept)),
            None => match others.entry(own.key).or_insert_with(|| Other::of(facts, own.key)) {
                Some(other) => (other.cycle, other.on, other.guards.as_slice()),
                None => continue,
            },
        };
        if !guards.iter().any(|own| own.asks_tool) {
            continue;
        }
        let related = own.as_related_cycle();
        let known = last.take().filter(|(own, _)| *own == index).map(|(_, written)| written);
        let written = known.unwrap_or_else(|| Written::of(facts, &facts.read(&related), cycle)).with(tool);
        for (at, ready) in guards.iter().enumerate().filter(|(_, own)| own.asks_tool) {
            let (Some(code), Some(true)) = (ready.code.as_deref(), written.holds(ready)) else { continue };
            // A program in inches may have feeds in tenths of them.
            let in_tenths = || {
                let faster = Tool { speed: tool.speed.map(|speed| 10.0 * speed), ..tool };
                Written::of(facts, &facts.read(&related), cycle).with(faster).holds(ready) == Some(true)
            };
            if facts.inch && code == FEED && !in_tenths() {
                continue;
            }
            if !reported.insert((index, at)) {
                continue;
            }
            let place = place(&facts.read(&related), ready, &written).unwrap_or(own.view.head);
            if seen.insert((place.start, interned(code))) {
                let rule = Rule { code: interned(code), severity: severity(ready), run: together };
                let sentence = text::guard_sentence(on, cycle, code, facts.against.readers);
                found.push(rule.at(facts, place).arg("message", sentence.unwrap_or_else(|| code.to_owned())));
            }
        }
        last = Some((index, written));
    }
}

pub(super) fn each(_: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    let Some((cycle, kept)) = definition.cycle().zip(definition.kept) else { return };
    let guards = facts.against.labels.guards_of(cycle, kept);
    if guards.is_empty() {
        return;
    }
    let written = Written::of(facts, definition, cycle);
    for ready in guards {
        if written.holds(ready) == Some(true) {
            found.extend(finding(facts, definition, cycle, ready, &written));
        }
    }
}

fn finding(
    facts: &Facts<'_>,
    definition: &Definition<'_>,
    cycle: &Cycle,
    ready: &Ready,
    written: &Written,
) -> Option<Diagnostic> {
    let code = ready.code.as_deref()?;
    let place = place(definition, ready, written).unwrap_or(definition.view.head);
    let rule = Rule { code: interned(code), severity: severity(ready), run: together };
    let sentence = text::guard_sentence(facts.against.on, cycle, code, facts.against.readers);
    Some(rule.at(facts, place).arg("message", sentence.unwrap_or_else(|| code.to_owned())))
}

/// How bad it is what a guard says.
const fn severity(ready: &Ready) -> Severity {
    match ready.then {
        Some(Outcome::Error) | None => Severity::Error,
        Some(Outcome::Skip | Outcome::Warn | Outcome::Confirm) => Severity::Warning,
    }
}
