//! A tool that cuts a thread after it has drilled, mills a pocket and taps, or turns a contour and a thread: the tool call
//! between was forgotten.
//!
//! Cycles that drill and cut the thread with one tool are passed over. Silent where it is not certain which definition or
//! which tool a call means, or where an operator may have changed the tool. Said once for a tool call.
use std::collections::{HashMap, HashSet};

use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::removes_material;
use crate::check::incident::Incident;
use crate::check::program::with_meaning;
use crate::check::travel::first_incident;
use crate::check::{Aspect, Defined, Facts, Loaded, Pending, Rule, Tri};
use crate::spec::{Cycle, Group};

pub(super) const RULE: Rule = Rule { code: "tool-not-changed", severity: Severity::Warning, run };

/// The meanings of values that only cycles for milling, and only cycles for drilling in steps, have.
const MILLED: &str = "milling-type";
const STEPS: &str = "plunging-depth";

/// The meaning of the pitch that only turned threads have.
const THREADED: &str = "turned-thread-pitch";

/// What a tool is there for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Use {
    Drilling,
    Milling,
    Tapping,
    ThreadMilling,
    Turning,
    ThreadTurning,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // What each tool call has done, with the cycle.
    let mut done: HashMap<u32, Vec<(Use, String)>> = HashMap::new();
    let mut reported = HashSet::new();
    let mut calls: Vec<_> = facts.run.calls.iter().collect();
    calls.sort_by_key(|call| call.block);
    for call in calls {
        let (Pending::Definition(index), Loaded::By(tool)) = (call.modal.pending, call.modal.loaded) else { continue };
        let Some(own) = facts.definitions.get(index as usize) else { continue };
        let Some(what) = own.related_cycle().and_then(of_cycle) else { continue };
        // After a program stop another tool may be in the spindle; functions of the machine that turn the workpiece are none.
        let turns = matches!(what, Use::Turning | Use::ThreadTurning);
        if call.modal.is(Aspect::Cut) == Tri::Unknown && !turns {
            done.remove(&tool);
            reported.insert(tool);
        }
        let before = done.entry(tool).or_default();
        let other = before.iter().find(|(other, _)| !go_together(*other, what));
        if let Some((_, cycle)) = other
            && reported.insert(tool)
        {
            let finding = rule.at(facts, call.span).arg("cycle", own.key.to_string());
            found.push(finding.arg("before", cycle.clone()));
        }
        if before.iter().all(|(other, _)| *other != what) {
            before.push((what, key(own)));
        }
    }
    observed(rule, facts, found);
}

/// What an execution shows: the same tool does another job, be it after a second call.
fn observed(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if found.iter().any(|own| own.code == rule.code) {
        return;
    }
    let first = first_incident(facts, |own| match own {
        Incident::ToolHasOtherJob { cycle, before } => Some((cycle, before)),
        _ => None,
    });
    if let Some((span, (cycle, before))) = first {
        found.push(rule.at(facts, span).arg("cycle", cycle.to_string()).arg("before", before.to_string()));
    }
}

fn key(own: &Defined<'_>) -> String {
    own.key.to_string()
}

/// Whether one tool can do both.
const fn go_together(one: Use, other: Use) -> bool {
    match (one, other) {
        (Use::Tapping, other) | (other, Use::Tapping) => matches!(other, Use::Tapping),
        (Use::Turning, Use::ThreadTurning) | (Use::ThreadTurning, Use::Turning) => false,
        (Use::Drilling, Use::ThreadMilling) | (Use::ThreadMilling, Use::Drilling) => false,
        _ => true,
    }
}

fn of_cycle(cycle: &Cycle) -> Option<Use> {
    let has = |meaning: &str| with_meaning(cycle, meaning).is_some();
    match cycle.file.group {
        Group::Turning if has(THREADED) => Some(Use::ThreadTurning),
        Group::Turning => Some(Use::Turning),
        _ if !removes_material(cycle) => None,
        Group::Drilling if has(MILLED) => Some(Use::Milling),
        Group::Drilling => Some(Use::Drilling),
        // Its tool drills before it mills.
        Group::Threads if has(MILLED) && has(STEPS) => None,
        Group::Threads if has(MILLED) => Some(Use::ThreadMilling),
        Group::Threads => Some(Use::Tapping),
        _ => Some(Use::Milling),
    }
}
