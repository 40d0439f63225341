//! A tapped thread whose pitch is none of the standard ones for its diameter: the pitch itself, or what the feed rate and
//! the speed make of it with a floating tap holder.
//!
//! Only where a tool table or a TOOL DEF gives a diameter of the metric series (ISO 261) and says nothing of the pitch. A
//! feed a little below that of the coarse pitch is left to the tap holder.
use std::collections::HashSet;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::program::{number, with_meaning};
use crate::check::tools::{COARSE, Tools};
use crate::check::{Facts, Pending, Rule};
use crate::spec::{Group, MM_PER_INCH};

pub(super) const RULE: Rule = Rule { code: "thread-pitch-unusual", severity: Severity::Warning, run };

/// Fine pitches, mm.
const FINE: [f64; 9] = [0.35, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 3.0, 4.0];
/// So much of the pitch a feed may differ from it, and so much a floating holder makes up for.
const SAME: f64 = 0.02;
const FLOATING: f64 = 0.08;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(tools) = Tools::of(facts) else { return };
    let mut seen = HashSet::new();
    for call in &facts.run.calls {
        let (Pending::Definition(index), Some(tool)) = (call.modal.pending, tools.get(call.modal.loaded)) else {
            continue;
        };
        let own = facts.definitions.get(index as usize);
        let Some(own) = own.filter(|own| own.related_cycle().is_some_and(|cycle| cycle.file.group == Group::Threads))
        else {
            continue;
        };
        if own.related_cycle().is_none_or(|cycle| with_meaning(cycle, "milling-type").is_some()) || tool.pitch.is_some()
        {
            continue;
        }
        let unit = if facts.inch { MM_PER_INCH } else { 1.0 };
        let diameter = 2.0 * tool.radius * unit;
        let Some((_, coarse)) = COARSE.iter().find(|(own, _)| (own - diameter).abs() <= 0.02) else { continue };
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let item = read.item("thread-pitch").or_else(|| read.item("plunging-feed"));
        let Some((item, value)) = item.and_then(|item| Some((item, number(item)?.abs() * unit))) else { continue };
        let by_feed = read.item("thread-pitch").is_none();
        let Some(pitch) = (if by_feed { tool.speed.map(|speed| value / speed) } else { Some(value) }) else { continue };
        let near = |own: f64| (pitch - own).abs() <= SAME * own;
        // Fine pitches are no greater than two thirds of the coarse one, give or take.
        let fine = FINE.iter().any(|own| *own < *coarse && *own > coarse / 4.0 && near(*own));
        let floats = by_feed && pitch <= *coarse && pitch >= coarse * (1.0 - FLOATING);
        if !(near(*coarse) || fine || floats) && pitch.is_finite() && seen.insert(index) {
            let finding = rule.at(facts, item.value_span).arg("value", Arg::Number((pitch * 1000.0).round() / 1000.0));
            found.push(finding.arg("other", Arg::Number(diameter)));
        }
    }
}
