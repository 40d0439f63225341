//! A spindle speed that no tool of that diameter and kind turns at: a digit too many or too few.
//!
//! Only where a tool table or a TOOL DEF gives the diameter. The limits are far beyond what is usual: 400 m/min for
//! drills, 80 for taps, 120 for reamers, 2500 for anything else; 2.5 m/min for drills and mills, 0.8 for taps. What a
//! tool is, its name or a comment beside its call says. Silent of tools with which a cycle works that has its own
//! speed. Also a mill that cuts many times as fast as the fastest of the others, and a fast tap that turns faster than
//! the drill of its core hole. Also a reamer that takes so little per revolution that a digit of its speed or of its
//! feed is wrong. Where a comment names steel, no mill cuts with more than 1000 m/min.
use std::collections::BTreeSet;
use std::f64::consts::PI;

use super::spindle_off::turns_spindle;
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::program::{number, remark};
use crate::check::tools::{Tools, kind_of_call};
use crate::check::{Aspect, CycleCall, Facts, Loaded, Pending, Rule, ToolKind, Tri};
use crate::program::syntax::BlockKind;
use crate::spec::MM_PER_INCH;

pub(super) const RULE: Rule = Rule { code: "cutting-speed-unusual", severity: Severity::Warning, run };

/// Of narrower tools the speed says nothing, mm.
const NARROW: f64 = 1.0;
/// A mill that is so many times as fast as all others of the program has a digit too many, m/min, unless it is slow.
const MANY: f64 = 6.0;
const FAST: f64 = 600.0;

/// A tap that is faster, m/min, does not turn faster than the drill of its core hole, which is so wide at least.
const QUICK: f64 = 40.0;
const CORE: f64 = 0.75;
/// So many taps and drills are compared.
const SEVERAL: usize = 64;
/// A reamer takes more than this part of its diameter per revolution.
const REAMED: f64 = 0.004;
/// The meaning of the feed of a reamer.
const FEED: &str = "plunging-feed";

/// No mill cuts steel so fast, m/min.
const IN_STEEL: f64 = 1000.0;
/// What steel is called, by the beginning of the word.
const STEEL: [&str; 8] = ["STEEL", "STAHL", "TERÄS", "TERAS", "JEKL", "ACCIA", "AÇO", "ACIER"];

/// Whether the comments name steel and no other material that is cut faster.
fn is_steel(facts: &Facts<'_>) -> bool {
    const FASTER: [&str; 4] = ["AL", "ALU", "BRASS", "GRAPHIT"];
    let mut steel = false;
    for text in facts.program.blocks().iter().filter_map(remark).map(|span| facts.text(span)) {
        let text = text.to_uppercase();
        for word in text.split(|sign: char| !sign.is_alphanumeric()) {
            steel |= STEEL.iter().any(|own| word.starts_with(own));
            if FASTER.iter().any(|own| word.starts_with(own)) {
                return false;
            }
        }
    }
    steel
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(tools) = Tools::of(facts) else { return };
    // The mills: their speeds, and what a finding says.
    let mut speeds: Vec<(f64, f64, Span)> = Vec::new();
    // The taps also with their turns, and the drills by diameter.
    let mut taps: Vec<(f64, f64, f64, Span)> = Vec::new();
    let mut drills: Vec<(f64, f64)> = Vec::new();
    let own_speeds = own_speeds(facts);
    let steel = is_steel(facts);
    for (index, block) in facts.marked() {
        let BlockKind::ToolCall(call) = &block.kind else { continue };
        if own_speeds.contains(&index) {
            continue;
        }
        let (Some(_), Some(speed), None) = (call.tool, call.speed, call.cutting_speed) else { continue };
        let turning = facts.run.before(index).is_none_or(|modal| modal.is(Aspect::Turning) != Tri::No);
        let Some(tool) = u32::try_from(index).ok().and_then(|own| tools.get(Loaded::By(own))) else { continue };
        let Some(turns) = facts.number(&speed).filter(|own| *own > 0.0 && !turning) else { continue };
        let diameter = 2.0 * tool.radius * if facts.inch { MM_PER_INCH } else { 1.0 };
        if diameter < NARROW {
            continue;
        }
        let metres = PI * diameter * turns / 1000.0;
        let (least, most): (f64, f64) = match kind_of_call(facts, index) {
            Some(ToolKind::Tap) => (0.8, 80.0),
            Some(ToolKind::Reamer) => (0.8, 120.0),
            Some(ToolKind::Drill | ToolKind::Spot) => (2.5, 400.0),
            Some(ToolKind::EndMill | ToolKind::FaceMill | ToolKind::Ball) => (2.5, 2500.0),
            Some(ToolKind::Probe | ToolKind::Boring | ToolKind::BackBoring) => continue,
            _ => (0.3, 2500.0),
        };
        let mills = matches!(kind_of_call(facts, index), Some(ToolKind::EndMill | ToolKind::FaceMill | ToolKind::Ball));
        let most = if mills && steel { most.min(IN_STEEL) } else { most };
        let mills_kind = matches!(kind_of_call(facts, index), Some(ToolKind::EndMill | ToolKind::FaceMill));
        if mills_kind && metres >= least && metres <= most {
            speeds.push((metres, diameter, speed.span));
        }
        match kind_of_call(facts, index) {
            Some(ToolKind::Tap) if metres <= most && taps.len() < SEVERAL => {
                taps.push((metres, diameter, turns, speed.span))
            }
            Some(ToolKind::Drill) if drills.len() < SEVERAL => drills.push((diameter, turns)),
            _ => {}
        }
        if metres < least || metres > most {
            let side = if metres < least { "below" } else { "above" };
            let finding = rule.at(facts, speed.span).arg("side", side);
            let finding = finding.arg("value", Arg::Number((metres * 10.0).round() / 10.0));
            found.push(finding.arg("other", Arg::Number(diameter)));
        }
    }
    for (metres, diameter, turns, span) in taps {
        let core = |own: &&(f64, f64)| (CORE * diameter..diameter).contains(&own.0);
        if metres > QUICK && drills.iter().filter(core).any(|(_, own)| turns > *own) {
            let finding = rule.at(facts, span).arg("side", "above");
            let finding = finding.arg("value", Arg::Number((metres * 10.0).round() / 10.0));
            found.push(finding.arg("other", Arg::Number(diameter)));
        }
    }
    if let Some((span, turn, diameter)) = reamed(facts, &tools) {
        let finding = rule.at(facts, span).arg("side", "reamed").arg("value", Arg::Number(turn));
        found.push(finding.arg("other", Arg::Number(diameter)));
    }
    speeds.sort_by(|one, other| other.0.total_cmp(&one.0));
    if let [(fastest, diameter, span), (second, ..), ..] = speeds.as_slice()
        && *fastest > FAST
        && *fastest > MANY * second
    {
        let finding = rule.at(facts, *span).arg("side", "above");
        let finding = finding.arg("value", Arg::Number((fastest * 10.0).round() / 10.0));
        found.push(finding.arg("other", Arg::Number(*diameter)));
    }
}

/// The first call of a cycle with a reamer that takes far too little per revolution, with that and the diameter; feeds
/// of programs in inches may be in tenths of them.
fn reamed(facts: &Facts<'_>, tools: &Tools) -> Option<(Span, f64, f64)> {
    facts.run.calls.iter().filter(|_| !facts.inch).find_map(|call| {
        let (Pending::Definition(index), Loaded::By(block)) = (call.modal.pending, call.modal.loaded) else {
            return None;
        };
        (kind_of_call(facts, usize::try_from(block).ok()?) == Some(ToolKind::Reamer)).then_some(())?;
        let tool = tools.get(call.modal.loaded)?;
        let speed = tool.speed.filter(|speed| *speed > 0.0)?;
        let related = facts.definitions.get(index as usize)?.as_related_cycle();
        let read = facts.read(&related);
        let item = read.item(FEED)?;
        let turn = number(item).filter(|feed| *feed > 0.0)? / speed;
        let diameter = 2.0 * tool.radius;
        let few = diameter > 3.0 && turn < REAMED * diameter;
        few.then_some((item.value_span, (turn * 1e4).round() / 1e4, diameter))
    })
}

/// The calls of the tools with which a cycle turns the spindle at its own speed.
fn own_speeds(facts: &Facts<'_>) -> BTreeSet<usize> {
    let own = |call: &CycleCall| {
        let (Pending::Definition(index), Loaded::By(block)) = (call.modal.pending, call.modal.loaded) else {
            return None;
        };
        let cycle = facts.definitions.get(index as usize)?.related_cycle()?;
        turns_spindle(cycle).then_some(block as usize)
    };
    facts.run.calls.iter().filter_map(own).collect()
}
