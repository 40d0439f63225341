//! A feed that fits the other unit: millimetres for a revolution while M136 is not active, or for a minute while it is.
//!
//! With M136 before the cycle the control reads its feeds in mm for a revolution, without it in mm/min (TNC 640, 001:
//! 7308, 7321, 7524). Only reported where M136 is known, of values that no one means in the unit that acts, and of
//! programs in mm: in cycles where they are called, of movements at the first one.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Definition, Facts, Modal, Pending, Rule, Tri};
use crate::program::syntax::{Amount, Block, BlockKind, FeedKind, ValueKind};
use crate::spec::{Group, Quantity};

pub(super) const RULE: Rule = Rule { code: "feed-unit", severity: Severity::Warning, run };

/// The meanings of the feeds of turning.
const TURNING: [&str; 2] = ["turning-roughing-feed", "turning-finishing-feed"];
/// Less than this is no feed of a minute, mm.
const LEAST: f64 = 1.0;
/// More than this turns nothing in a revolution, mm.
const LARGE: f64 = 1.5;
/// More than this is no feed of a revolution, mm.
const GREATEST: f64 = 20.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.inch {
        return;
    }
    in_cycles(rule, facts, found);
    in_movements(rule, facts, found);
}

/// The feeds of cycles that are called.
fn in_cycles(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut seen, mut reported) = (BTreeSet::new(), BTreeSet::new());
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(revolution) = call.modal.is(Aspect::PerRevolution).known() else { continue };
        let Some(definition) = facts.definitions.get(index as usize) else { continue };
        let Some(cycle) = definition.related_cycle() else { continue };
        if !seen.insert((index, revolution)) {
            continue;
        }
        let turning = cycle.file.group == Group::Turning;
        // Those of a minute are small in milling, too, where nothing but the least is meant.
        if turning || revolution {
            let related = definition.as_related_cycle();
            of_cycle(rule, facts, &facts.read(&related), (turning, revolution), &mut reported, found);
        }
    }
}

fn of_cycle(
    rule: &Rule,
    facts: &Facts<'_>,
    read: &Definition<'_>,
    (turning, revolution): (bool, bool),
    reported: &mut BTreeSet<usize>,
    found: &mut Vec<Diagnostic>,
) {
    let first = found.len();
    for item in &read.items {
        let feed = item.param.is_some_and(|param| match turning {
            true => TURNING.contains(&param.is.as_str()),
            false => param.quantity == Quantity::Feed,
        });
        let number = match item.value.map(|value| value.kind) {
            _ if !feed => None,
            Some(ValueKind::Number(number)) => Some(number),
            _ => item.number,
        };
        // No insert turns with so much for a revolution.
        let large = turning && revolution && number.is_some_and(|number| (LARGE..=GREATEST).contains(&number));
        if number.is_some_and(|number| is_wrong(number, revolution) || large)
            // The feeds of a milling cycle are one finding.
            && (turning || found.len() == first)
            && reported.insert(item.value_span.start)
        {
            let finding = rule.at(facts, item.value_span).arg("parameter", item.name.as_ref());
            let finding = finding.arg("value", item.printed.as_ref());
            let what = if large { "large" } else { "minute" };
            found.push(finding.arg("what", if revolution && !large { "revolution" } else { what }));
        }
    }
}

/// The first movement with a feed of the other unit, of each unit.
fn in_movements(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut reported = [false; 2];
    for (from, to, modal) in facts.run.stretches() {
        let Some(revolution) = modal.and_then(|modal| unit(&modal)).filter(|own| !reported[usize::from(*own)]) else {
            continue;
        };
        for block in facts.program.blocks().get(from..to).unwrap_or_default() {
            let Some((number, finding)) = feed(rule, facts, block) else { continue };
            if is_wrong(number, revolution) {
                reported[usize::from(revolution)] = true;
                found.push(finding.arg("what", if revolution { "revolving" } else { "moving" }));
                break;
            }
        }
    }
}

/// Whether feeds are those of a revolution, where movements are looked at: everywhere in that unit, in the other one
/// while turning.
fn unit(modal: &Modal) -> Option<bool> {
    match modal.is(Aspect::PerRevolution) {
        Tri::Yes => Some(true),
        Tri::No => (modal.is(Aspect::Turning) == Tri::Yes).then_some(false),
        Tri::Unknown => None,
    }
}

/// The feed of a movement, with a finding at its place.
fn feed(rule: &Rule, facts: &Facts<'_>, block: &Block) -> Option<(f64, Diagnostic)> {
    let BlockKind::Motion(motion) = &block.kind else { return None };
    if !motion.outline().has_feed() {
        return None;
    }
    let feed = motion.words().feed?;
    let FeedKind::Value(own) = feed.kind else { return None };
    let Amount::Number(number) = own.amount else { return None };
    let switches = motion.functions().iter().any(|own| matches!(own.number, 136 | 137));
    let finding = rule.at(facts, feed.span).arg("parameter", "F").arg("value", facts.text(own.span).to_owned());
    (!switches).then_some((number, finding))
}

fn is_wrong(number: f64, revolution: bool) -> bool {
    if revolution { number > GREATEST } else { 0.0 < number && number < LEAST }
}
