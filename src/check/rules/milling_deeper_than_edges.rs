//! A tool that mills through material higher than its cutting edges are long (LCUTS): its shank rubs.
//!
//! Only where the tool table is named and the height of the material is known: what was cut before counts, arcs and
//! cycles after which it is not known end that. Also a cycle that infeeds so far at once, or cuts a thread of such a
//! depth in a single turn. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::incident::Incident;
use crate::check::program::{number, with_meaning};
use crate::check::tools::Tools;
use crate::check::travel::incidents;
use crate::check::{Defined, Facts, Pending, Rule};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "milling-deeper-than-edges", severity: Severity::Warning, run };

/// The meanings of the depths of pockets, contours and threads, and of what a cycle infeeds at once.
const DEPTHS: [&str; 2] = ["depth", "milling-depth"];
const INFEEDS: [&str; 2] = ["plunging-depth", "contour-plunging-depth"];
const THREAD_DEPTH: &str = "thread-depth";
const PITCH: &str = "thread-pitch";
/// The meanings of the value that says in how many turns a thread is milled, and that it is milled at all.
const TURNS: &str = "threads-per-step";
const MILLED: &str = "milling-type";
/// So much longer edges would have to be before anybody speaks of it, in millimetres.
const SLACK: f64 = 0.5;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let before = found.len();
    for (span, own) in incidents(facts) {
        if let Incident::DeeperThanCuttingEdge(height) = own {
            found.push(rule.at(facts, *span).arg("value", Arg::Number(*height)));
        }
    }
    if found.len() == before
        && let Some((span, height)) = by_cycle(facts)
    {
        found.push(rule.at(facts, span).arg("value", Arg::Number(height)));
    }
}

/// The first cycle that cuts higher at once than the edges of its tool are long, with the value that says so.
fn by_cycle(facts: &Facts<'_>) -> Option<(Span, f64)> {
    let tools = Tools::of(facts)?;
    facts.run.calls.iter().find_map(|call| {
        let Pending::Definition(index) = call.modal.pending else { return None };
        let own = facts.definitions.get(index as usize)?;
        let edges = tools.get(call.modal.loaded)?.cutting_length.filter(|edges| *edges > 0.0)?;
        let (span, height, gained) = at_once(facts, own, call.block)?;
        (height > edges + gained + SLACK * facts.millimetre()).then_some((span, height))
    })
}

/// How high a cycle cuts at once, the value that says so, and how far the tool moves along its axis while it does.
fn at_once(facts: &Facts<'_>, own: &Defined<'_>, call: usize) -> Option<(Span, f64, f64)> {
    let cycle = own.related_cycle()?;
    let related = own.as_related_cycle();
    let read = facts.read(&related);
    let value = |meaning: &str| read.item(meaning).and_then(number);
    match cycle.file.group {
        Group::Threads if with_meaning(cycle, MILLED).is_some() => {
            let turns = if with_meaning(cycle, TURNS).is_some() { value(TURNS)? } else { 0.0 };
            let item = read.item(THREAD_DEPTH)?;
            (turns == 0.0).then_some(())?;
            Some((item.value_span, number(item)?.abs(), value(PITCH)?.abs()))
        }
        Group::Pockets | Group::Contours => {
            let item = INFEEDS.iter().find_map(|own| read.item(own))?;
            let depth = DEPTHS.iter().find_map(|own| value(own)).or_else(|| shared_depth(facts, call))?;
            Some((item.value_span, number(item)?.abs().min(depth.abs()), 0.0))
        }
        _ => None,
    }
}

/// The depth that the last definition before a block keeps for the cycles after it.
fn shared_depth(facts: &Facts<'_>, block: usize) -> Option<f64> {
    let before = facts.definitions.iter().rev().filter(|own| own.view.first < block);
    let mut keeps = before.filter(|own| own.related_cycle().is_some_and(|own| with_meaning(own, DEPTHS[1]).is_some()));
    let related = keeps.next()?.as_related_cycle();
    facts.read(&related).item(DEPTHS[1]).and_then(number)
}
