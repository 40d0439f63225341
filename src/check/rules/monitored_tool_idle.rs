//! A measurement that corrects or monitors a tool which has not machined before, or has machined only elsewhere: the number
//! belongs to another tool.
//!
//! In the order of the text: no call of that tool comes before the measurement, but calls of others do. Silent where a
//! parameter or a name calls a tool, where subprograms call tools or other programs are called, and in what comes after the
//! end of the main part.
use std::collections::BTreeSet;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::blank::is_unmoved;
use crate::check::contours::place_of_call;
use crate::check::cycle::probes_around;
use crate::check::milled::Milled;
use crate::check::program::{number, with_meaning};
use crate::check::{Facts, Loaded, Rule};
use crate::program::syntax::{BlockKind, ToolRef};

pub(super) const RULE: Rule = Rule { code: "monitored-tool-idle", severity: Severity::Warning, run };

/// The meaning of the tool that a measurement corrects.
const MONITORED: &str = "monitored-tool";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let measures = |own: &&crate::check::Defined<'_>| {
        own.related_cycle().is_some_and(|cycle| with_meaning(cycle, MONITORED).is_some())
    };
    let mut measurements = facts.definitions.iter().filter(measures).peekable();
    if measurements.peek().is_none() || facts.flow.programs || facts.flow.unread.any() || !facts.begins() {
        return;
    }
    let mut called: BTreeSet<u64> = BTreeSet::new();
    // Tools that were called with a speed.
    let mut machining = false;
    let mut ended = false;
    let mut open = Vec::new();
    for (index, block) in facts.marked() {
        while let Some(own) = measurements.next_if(|own| own.view.first < index) {
            let related = own.as_related_cycle();
            let read = facts.read(&related);
            let Some(item) = read.item(MONITORED) else { continue };
            let Some(tool) = number(item).filter(|tool| *tool > 0.0) else { continue };
            if machining && !ended && !called.contains(&tool.to_bits()) {
                open.push((item.value_span, tool, own.key));
            }
        }
        if let BlockKind::ToolCall(call) = &block.kind
            && let Some(tool) = call.tool
        {
            let ToolRef::Number(operand) = tool else { return };
            let Some(tool) = facts.number(&operand) else { return };
            if ended {
                return;
            }
            called.insert(tool.to_bits());
            machining |= call.speed.is_some() && tool > 0.0;
        }
        ended |= facts.ends(block);
    }
    for (span, tool, key) in open {
        let finding = rule.at(facts, span).arg("what", "idle").arg("tool", Arg::Number(tool));
        found.push(finding.arg("cycle", key.to_string()).arg("other", ""));
    }
    elsewhere(rule, facts, &called, found);
}

/// The meanings of the centre that is measured.
const CENTRE: [&str; 2] = ["probing-centre-main", "probing-centre-minor"];
/// So far around a centre a tool that machines elsewhere does not come, mm.
const AWAY: f64 = 1.0;

/// Measurements of what one tool has milled that correct another one, which has machined elsewhere only.
fn elsewhere(rule: &Rule, facts: &Facts<'_>, called: &BTreeSet<u64>, found: &mut Vec<Diagnostic>) {
    let milled = Milled::all(facts);
    if milled.is_empty() {
        return;
    }
    for own in &facts.definitions {
        let Some(cycle) = own.related_cycle().filter(|cycle| with_meaning(cycle, MONITORED).is_some()) else {
            continue;
        };
        let inside = !probes_around(cycle);
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let value = |meaning: &str| read.item(meaning).and_then(number);
        let (Some(item), [Some(x), Some(y)]) = (read.item(MONITORED), CENTRE.map(value)) else { continue };
        let Some(tool) = number(item).filter(|tool| called.contains(&tool.to_bits())) else { continue };
        if !facts.run.before(own.view.first).is_some_and(|modal| is_unmoved(&modal)) {
            continue;
        }
        let here = |own: &&Milled| {
            let [x, y] = own.from([x, y]);
            libm::hypot(x, y) < AWAY && own.blank.is_none() == inside
        };
        let Some(last) = milled.iter().rfind(|other| other.block < own.view.first && here(other)) else { continue };
        let Some(other) = number_of(facts, last.loaded).filter(|other| *other != tool) else { continue };
        let mills = milled.iter().filter(here).any(|own| number_of(facts, own.loaded).is_none_or(|own| own == tool));
        if !mills && is_elsewhere(facts, tool, last) {
            let finding = rule.at(facts, item.value_span).arg("what", "elsewhere").arg("tool", Arg::Number(tool));
            found.push(finding.arg("cycle", own.key.to_string()).arg("other", Arg::Number(other)));
        }
    }
}

/// The number of the tool in the spindle.
fn number_of(facts: &Facts<'_>, loaded: Loaded) -> Option<f64> {
    let Loaded::By(block) = loaded else { return None };
    match &facts.program.blocks().get(block as usize)?.kind {
        BlockKind::ToolCall(call) => match call.tool? {
            ToolRef::Number(operand) => facts.number(&operand),
            ToolRef::Name(_) => None,
        },
        _ => None,
    }
}

/// Whether all that a tool does is to call cycles at places which are known and away from what another one has milled, or
/// before that, as a drill does.
fn is_elsewhere(facts: &Facts<'_>, tool: f64, last: &Milled) -> bool {
    let its = |loaded: Loaded| match loaded {
        Loaded::None => false,
        Loaded::By(_) => number_of(facts, loaded).is_none_or(|own| own == tool),
        Loaded::Unknown => true,
    };
    let mut any = false;
    for call in facts.run.calls.iter().filter(|call| its(call.modal.loaded)) {
        let place = place_of_call(facts, call.block).filter(|_| is_unmoved(&call.modal));
        let Some([x, y]) = place else { return false };
        let [x, y] = last.from([x, y]);
        if call.block > last.block && libm::hypot(x, y) <= last.shape.outer() {
            return false;
        }
        any = true;
    }
    let feeds = facts.run.stretches().any(|(from, to, modal)| {
        modal.is_none_or(|modal| its(modal.loaded))
            && facts.program.blocks().get(from..to).unwrap_or_default().iter().any(|block| match &block.kind {
                BlockKind::Motion(motion) => !motion.outline().is_rapid() && motion.outline().has_coords(),
                _ => false,
            })
    });
    any && !feeds
}
