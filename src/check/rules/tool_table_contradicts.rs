//! A tool that is used otherwise than the tool table says: faster than its greatest speed (NMAX), although it is locked
//! (TL) and no replacement tool is named (RT), for something that a tool of its type (TYP, of turning tools TYPE) is
//! not there for, without a length among tools that have one, to be measured tooth by tooth without a number of teeth,
//! for centring to a diameter without a point angle (T-ANGLE), or for a left-hand thread although nothing says that the
//! tap is a left-hand one.
//!
//! Only where the table is named (`--table`, `tables` in `ciklo.toml`) and has the columns. Of the types those are
//! judged whose name leaves no doubt; each is reported once for a tool call.
use std::cell::OnceCell;
use std::collections::HashSet;

use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::cycle::{probes, removes_material};
use crate::check::first_way::FirstWay;
use crate::check::incident::Incident;
use crate::check::program::{Work, number, with_meaning};
use crate::check::tools::{kind_of_call, named};
use crate::check::travel::first_incident;
use crate::check::{
    Aspect, Defined, Facts, Loaded, Pending, Project, Rule, ToolKind, ToolName, Tri, diameter_of, is_left, is_milling,
};
use crate::program::syntax::{Amount, BlockKind, Compensates, ToolRef};
use crate::spec::{Cycle, Group, MM_PER_INCH};

pub(super) const RULE: Rule = Rule { code: "tool-table-contradicts", severity: Severity::Warning, run };

/// A touch probe.
const PROBE: &str = "TCHP";
/// A tap.
const TAP: &str = "TAP";
/// Tools that cut at their side.
const MILLS: [&str; 8] = ["MILL", "MILL_R", "MILL_F", "MILL_FACE", "MILL_SIDE", "BALL", "TORUS", "MILL_CHAMFER"];
/// Tools that cut at their tip only.
const DRILLS: [&str; 4] = ["DRILL", "CENT", "REAM", "CSINK"];

/// The meaning of the pitch that only turned threads have.
const THREADED: &str = "turned-thread-pitch";
/// The meaning of the set-up clearance that only recesses have.
const RECESSED: &str = "recess-clearance";

/// The meaning of the choice to measure each tooth.
const TEETH: &str = "tooth-measurement";
/// The meaning of the tool for which a contour cycle only drills.
const PILOT: &str = "rough-out-tool";

/// The meaning of the pitch of a thread, which is negative for the left hand.
const PITCH: &str = "thread-pitch";
/// The word in the column TL of a tool that is locked.
const LOCKED: &str = "L";
/// The meaning of the choice between a depth and a diameter, and its value for the diameter.
const DEPTH_OR_DIAMETER: (&str, f64) = ("depth-or-diameter", 1.0);

/// What a tool is used for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Use {
    Probing,
    Tapping,
    ThreadMilling,
    Drilling,
    Milling,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    by_table(rule, facts, found);
    early(rule, facts, found);
    observed(rule, facts, found);
}

fn by_table(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(project) = facts.project else { return };
    turned(rule, facts, project, found);
    if !project.knows_tools() {
        return;
    }
    for (_, block) in facts.marked() {
        let BlockKind::ToolCall(call) = &block.kind else { continue };
        let Some(tool) = call.tool else { continue };
        if let Some(name) = named(facts, tool)
            && project.tool_word(name, "TL") == Some(LOCKED)
            && project.tool_word(name, "RT").is_none_or(|replacement| replacement == "0")
        {
            let finding = rule.at(facts, facts.content(block)).arg("what", "locked").arg("tool", shown(facts, tool));
            found.push(finding.arg("value", "").arg("other", ""));
        }
        if let Some(radius) = named(facts, tool).and_then(|name| project.tool_value(name, "R")).filter(|own| *own > 0.0)
            && let Some((oversize, span)) = call.dr.and_then(|own| facts.number(&own).map(|value| (value, own.span)))
            && radius * facts.millimetre() + oversize <= 0.0
        {
            let finding = rule.at(facts, span).arg("what", "oversize").arg("tool", shown(facts, tool));
            let radius = radius * facts.millimetre();
            found.push(finding.arg("value", Arg::Number(oversize)).arg("other", Arg::Number(radius)));
        }
        let Some(speed) = call.speed else { continue };
        let most = named(facts, tool).and_then(|name| project.tool_value(name, "NMAX")).filter(|most| *most > 0.0);
        let Some((speed, most, span)) = facts.number(&speed).zip(most).map(|(own, most)| (own, most, speed.span))
        else {
            continue;
        };
        if speed > most {
            let finding = rule.at(facts, span).arg("what", "speed").arg("tool", shown(facts, tool));
            found.push(finding.arg("value", Arg::Number(speed)).arg("other", Arg::Number(most)));
        }
    }
    lengths(rule, facts, project, found);
    teeth(rule, facts, project, found);
    to_diameter(rule, facts, project, found);
    left_hand(rule, facts, project, found);
    let mut uses = uses(facts);
    uses.sort_by_key(|(span, ..)| span.start);
    let mut reported = HashSet::new();
    for (span, loaded, own, word) in uses {
        let Some((tool, kind)) = kind(facts, project, loaded) else { continue };
        if !fits(own, kind) && reported.insert(loaded) {
            let finding = rule.at(facts, span).arg("what", "type").arg("tool", shown(facts, tool));
            found.push(finding.arg("value", word).arg("other", kind));
        }
    }
    sizes(rule, facts, project, found);
}

/// Calls of early cycles, of which only their name or code says what they do, with a tool that is not there for that.
fn early(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut reported = HashSet::new();
    let way = FirstWay::of(facts);
    for (call, own) in way.called() {
        let what = match own.work {
            Work::Drilling => Use::Drilling,
            Work::Tapping | Work::RigidTapping => Use::Tapping,
            Work::Milling => Use::Milling,
        };
        let Some(block) = call.tool else { continue };
        let Some(loaded) = u32::try_from(block).ok().map(Loaded::By) else { continue };
        let Some(tool) = called(facts, loaded) else { continue };
        let listed = named(facts, tool).and_then(|name| facts.project?.tool_word(name, "TYP"));
        let Some(kind) = listed.or_else(|| kind_of_call(facts, block).map(ToolKind::word)) else { continue };
        if !fits(what, kind) && reported.insert(block) {
            let finding = rule.at(facts, call.span).arg("what", "type").arg("tool", shown(facts, tool));
            found.push(finding.arg("value", own.name.clone()).arg("other", kind.to_owned()));
        }
    }
}

/// What an execution shows: a tool that cuts with a cycle for which its name does not fit.
fn observed(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if found.iter().any(|own| own.code == rule.code) {
        return;
    }
    let oversize = first_incident(facts, |own| match own {
        Incident::Oversize { tool, value, radius } => Some((tool, value, radius)),
        _ => None,
    });
    if let Some((span, (tool, value, radius))) = oversize.filter(|(_, (tool, ..))| !in_steps(facts, *tool)) {
        let finding = rule.at(facts, span).arg("what", "large").arg("tool", tool.to_string());
        found.push(finding.arg("value", Arg::Number(value)).arg("other", Arg::Number(radius)));
    }
    let first = first_incident(facts, |own| match own {
        Incident::Misused { tool, kind, cycle } => Some((tool, kind, cycle)),
        _ => None,
    });
    if let Some((span, (tool, kind, cycle))) = first {
        let finding = rule.at(facts, span).arg("what", "type").arg("tool", tool.to_string());
        found.push(finding.arg("value", cycle.to_string()).arg("other", kind.word()));
    }
}

/// Whether a tool is also called with a positive oversize that is no more than an allowance: the larger one then roughs
/// the same contour farther out.
fn in_steps(facts: &Facts<'_>, tool: f64) -> bool {
    const ALLOWANCE: f64 = 2.0;
    facts.marked().any(|(_, block)| match &block.kind {
        BlockKind::ToolCall(call) => {
            let own = matches!(call.tool, Some(ToolRef::Number(own)) if own.amount == Amount::Number(tool));
            let oversize = call.dr.and_then(|own| facts.number(&own)).unwrap_or_default();
            own && oversize > 0.0 && oversize <= ALLOWANCE * facts.millimetre()
        }
        _ => false,
    })
}

/// Tools whose name gives another diameter than their radius does.
fn sizes(rule: &Rule, facts: &Facts<'_>, project: &dyn Project, found: &mut Vec<Diagnostic>) {
    /// So much of the diameter, and so many millimetres, a tool may differ from its name: it is worn, or ground anew.
    const WORN: (f64, f64) = (0.05, 0.1);
    let mut reported = HashSet::new();
    for (_, block) in facts.marked() {
        let BlockKind::ToolCall(call) = &block.kind else { continue };
        let Some((tool, name)) = call.tool.and_then(|tool| Some((tool, named(facts, tool)?))) else { continue };
        let said = project.tool_word(name, "NAME").and_then(diameter_of);
        let radius = project.tool_value(name, "R").filter(|radius| *radius > 0.0);
        let Some((said, own)) = said.zip(radius.map(|radius| 2.0 * radius)) else { continue };
        let near = |said: f64| (said - own).abs() <= WORN.0 * said + WORN.1;
        // A name may give it in inches.
        if !near(said) && !near(said * MM_PER_INCH) && reported.insert(shown(facts, tool)) {
            let finding = rule.at(facts, facts.content(block)).arg("what", "size").arg("tool", shown(facts, tool));
            found.push(finding.arg("value", Arg::Number(said)).arg("other", Arg::Number(own)));
        }
    }
}

/// Tools without a length among others that have one: the control moves the spindle nose to where the tip is to go.
fn lengths(rule: &Rule, facts: &Facts<'_>, project: &dyn Project, found: &mut Vec<Diagnostic>) {
    let (mut with, mut without) = (0, Vec::new());
    let mut seen = HashSet::new();
    for (_, block) in facts.marked() {
        let BlockKind::ToolCall(call) = &block.kind else { continue };
        let Some((tool, name)) = call.tool.and_then(|tool| Some((tool, named(facts, tool)?))) else { continue };
        // Tool 0 is no tool, and turning tools have their lengths elsewhere.
        if name == ToolName::Number(0.0) || project.turning_type(name).is_some() || !seen.insert(shown(facts, tool)) {
            continue;
        }
        let turns = project.tool_word(name, "TYP") == Some("TURN");
        match project.tool_value(name, "L") {
            _ if project.has_tool(name) != Some(true) || turns => {}
            Some(length) if length > 0.0 => with += 1,
            Some(length) if length < 0.0 => return,
            _ => without.push((facts.content(block), tool)),
        }
    }
    if let ([(span, tool)], true) = (without.as_slice(), with > 0) {
        let finding = rule.at(facts, *span).arg("what", "length").arg("tool", shown(facts, *tool));
        found.push(finding.arg("value", "").arg("other", ""));
    }
}

/// Teeth that are to be measured one by one of a tool without a number of teeth.
fn teeth(rule: &Rule, facts: &Facts<'_>, project: &dyn Project, found: &mut Vec<Diagnostic>) {
    for own in &facts.definitions {
        if own.related_cycle().is_none_or(|cycle| with_meaning(cycle, TEETH).is_none()) {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some(item) = read.item(TEETH).filter(|item| number(item) == Some(1.0)) else { continue };
        let loaded = facts.run.before(own.view.first).map(|modal| modal.loaded);
        let Some(tool) = loaded.and_then(|loaded| called(facts, loaded)) else { continue };
        let Some(name) = named(facts, tool) else { continue };
        let known = project.has_tool(name) == Some(true);
        if known && project.tool_value(name, "CUT").is_none_or(|teeth| teeth <= 0.0) {
            let finding = rule.at(facts, item.span).arg("what", "teeth").arg("tool", shown(facts, tool));
            found.push(finding.arg("value", own.key.to_string()).arg("other", ""));
        }
    }
}

/// Turning cycles that are called with a turning tool of another type: threads are turned with one for threads only,
/// and nothing else is; recesses with one for recesses or recess turning. Reported once for a tool call.
fn turned(rule: &Rule, facts: &Facts<'_>, project: &dyn Project, found: &mut Vec<Diagnostic>) {
    let mut reported = HashSet::new();
    for call in &facts.run.calls {
        let (Pending::Definition(index), Loaded::By(block)) = (call.modal.pending, call.modal.loaded) else { continue };
        let Some(own) = facts.definitions.get(index as usize) else { continue };
        let Some(cycle) = own.related_cycle().filter(|cycle| cycle.file.group == Group::Turning) else { continue };
        let Some(tool) = called(facts, call.modal.loaded) else { continue };
        let Some(name) = named(facts, tool) else { continue };
        let called = match name {
            ToolName::Name(own) => Some(own),
            ToolName::Number(_) => project.tool_word(name, "NAME"),
        };
        let listed = project.turning_type(name);
        let Some(kind) = listed.or_else(|| called.and_then(turning_type_of)) else { continue };
        let threads = with_meaning(cycle, THREADED).is_some();
        let recesses = with_meaning(cycle, RECESSED).is_some();
        let fits = match kind {
            "THREAD" => threads,
            // A name does not say whether it also turns along.
            "RECESS" | "RECTURN" => recesses || listed.is_none() && !threads,
            "ROUGH" | "FINISH" | "BUTTON" => !threads && !recesses,
            _ => true,
        };
        if !fits && reported.insert(block) {
            let (what, other) = if listed.is_some() { ("turning", kind) } else { ("called", called.unwrap_or(kind)) };
            let finding = rule.at(facts, call.span).arg("what", what).arg("tool", shown(facts, tool));
            found.push(finding.arg("value", own.key.to_string()).arg("other", other.to_owned()));
        }
    }
}

/// The type of a tool for threads or recesses that is called so, if its name leaves no doubt.
fn turning_type_of(name: &str) -> Option<&'static str> {
    const THREADS: [&str; 7] = ["THREAD", "THRD", "GEWINDE", "FILETT", "ROSCA", "KIERRE", "NAVOJ"];
    const RECESSES: [&str; 9] =
        ["GROOV", "RECESS", "PARTING", "STECH", "EINSTICH", "ABSTICH", "GOLA", "RANHURA", "URITUS"];
    let name = name.to_uppercase();
    let is = |stems: &[&str]| {
        name.split(|sign: char| !sign.is_alphabetic()).any(|part| stems.iter().any(|stem| part.starts_with(stem)))
    };
    match (is(&THREADS), is(&RECESSES)) {
        (true, false) => Some("THREAD"),
        (false, true) => Some("RECESS"),
        _ => None,
    }
}

/// Cycles that centre to a diameter with a tool that has no point angle.
fn to_diameter(rule: &Rule, facts: &Facts<'_>, project: &dyn Project, found: &mut Vec<Diagnostic>) {
    let (meaning, diameter) = DEPTH_OR_DIAMETER;
    let mut reported = HashSet::new();
    for call in &facts.run.calls {
        let (Pending::Definition(index), Loaded::By(block)) = (call.modal.pending, call.modal.loaded) else { continue };
        let Some(own) = facts.definitions.get(index as usize) else { continue };
        if own.related_cycle().is_none_or(|cycle| with_meaning(cycle, meaning).is_none()) {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some(item) = read.item(meaning).filter(|item| number(item) == Some(diameter)) else { continue };
        let Some(tool) = called(facts, call.modal.loaded) else { continue };
        let angle = named(facts, tool).and_then(|name| project.tool_value(name, "T-ANGLE"));
        if angle.is_some_and(|angle| angle <= 0.0) && reported.insert((index, block)) {
            let finding = rule.at(facts, item.span).arg("what", "point").arg("tool", shown(facts, tool));
            found.push(finding.arg("value", own.key.to_string()).arg("other", ""));
        }
    }
}

/// A left-hand thread with a tap whose name does not say that it is one, in a program that does not say so either.
fn left_hand(rule: &Rule, facts: &Facts<'_>, project: &dyn Project, found: &mut Vec<Diagnostic>) {
    let (mut seen, mut reported) = (HashSet::new(), HashSet::new());
    let said = OnceCell::new();
    let is_said = || {
        let mut comments = facts.program.blocks().iter().filter_map(|block| block.comment());
        *said.get_or_init(|| comments.any(|comment| is_left(facts.text(comment))))
    };
    for call in &facts.run.calls {
        let (Pending::Definition(index), Loaded::By(block)) = (call.modal.pending, call.modal.loaded) else { continue };
        if call.modal.is(Aspect::Counterclockwise) == Tri::Yes || !seen.insert((index, block)) {
            continue;
        }
        let Some(own) = facts.definitions.get(index as usize) else { continue };
        let taps = |cycle: &Cycle| cycle.file.group == Group::Threads && !is_milling(cycle);
        if !own.related_cycle().is_some_and(taps) {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some((item, pitch)) = read.item(PITCH).and_then(|item| Some((item, number(item)?))) else { continue };
        let Some(tool) = called(facts, call.modal.loaded) else { continue };
        let Some(name) = named(facts, tool) else { continue };
        let own_name = match name {
            ToolName::Name(own) => Some(own),
            ToolName::Number(_) => None,
        };
        let listed = ["NAME", "DOC"].iter().filter_map(|column| project.tool_word(name, column));
        let words: Vec<&str> = listed.chain(own_name).collect();
        let taps = words.iter().any(|words| ToolKind::named(words) == Some(ToolKind::Tap));
        if pitch >= 0.0 || !taps || words.iter().any(|words| is_left(words)) {
            continue;
        }
        if !is_said() && reported.insert(index) {
            let finding = rule.at(facts, item.value_span).arg("what", "left").arg("tool", shown(facts, tool));
            found.push(finding.arg("value", Arg::Number(pitch)).arg("other", ""));
        }
    }
}

/// Whether a tool of a type can be used so; types that leave a doubt can.
fn fits(own: Use, kind: &str) -> bool {
    let (mill, drill) = (MILLS.contains(&kind), DRILLS.contains(&kind));
    match own {
        Use::Probing => !(mill || drill || kind == TAP),
        Use::Tapping => !(mill || drill || kind == PROBE),
        Use::Drilling => !matches!(kind, TAP | PROBE),
        Use::ThreadMilling | Use::Milling => !(drill || matches!(kind, TAP | PROBE)),
    }
}

/// The tool in the spindle, as its call has it.
fn called(facts: &Facts<'_>, loaded: Loaded) -> Option<ToolRef> {
    let Loaded::By(block) = loaded else { return None };
    let BlockKind::ToolCall(call) = &facts.program.blocks().get(block as usize)?.kind else { return None };
    call.tool
}

/// The tool in the spindle and its type.
fn kind<'p>(facts: &Facts<'_>, project: &'p dyn Project, loaded: Loaded) -> Option<(ToolRef, &'p str)> {
    let tool = called(facts, loaded)?;
    let name = named(facts, tool)?;
    let kind = project.tool_word(name, "TYP").or_else(|| project.tool_word(name, "NAME").and_then(kind_of_name));
    Some((tool, kind?))
}

/// What the first word of a name says that a tool is, where its table has no types. A drill may also serve a contour
/// cycle that drills before it mills, so it is not judged by its name.
fn kind_of_name(name: &str) -> Option<&'static str> {
    let first = name.split(|sign: char| !sign.is_ascii_alphabetic()).next()?.to_ascii_uppercase();
    Some(match first.as_str() {
        "TAP" | "MASCHIO" | "MACHO" => TAP,
        "REAMER" | "REAM" => "REAM",
        "ENDMILL" | "EM" => "MILL",
        _ => return None,
    })
}

/// What tools are used for, with the place, the tool and the word that says it.
fn uses(facts: &Facts<'_>) -> Vec<(Span, Loaded, Use, String)> {
    let mut uses = Vec::new();
    for own in facts.definitions.iter().filter(|own| own.related_cycle().is_some_and(probes)) {
        let loaded = facts.run.before(own.view.first).map(|modal| modal.loaded);
        uses.extend(loaded.map(|loaded| (own.view.head, loaded, Use::Probing, own.key.to_string())));
    }
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let own = facts.definitions.get(index as usize);
        let what = own.and_then(Defined::related_cycle).and_then(of_cycle);
        if let Some((own, what)) = own.zip(what) {
            uses.push((call.span, call.modal.loaded, what, own.key.to_string()));
        }
    }
    for (index, block) in facts.shaped() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        let modal = facts.run.before(index).filter(|modal| modal.is(Aspect::Turning) == Tri::No);
        let modal = modal.filter(|_| motion.outline().compensates() == Compensates::Beside);
        uses.extend(modal.map(|modal| (facts.content(block), modal.loaded, Use::Milling, "RL, RR".to_owned())));
    }
    uses
}

/// What a cycle uses a tool for.
fn of_cycle(cycle: &Cycle) -> Option<Use> {
    let mills = is_milling(cycle);
    match cycle.file.group {
        _ if !removes_material(cycle) => None,
        Group::Drilling if mills => Some(Use::Milling),
        Group::Drilling => Some(Use::Drilling),
        // Its tool drills before it mills: tables call it one or the other.
        Group::Threads if mills && with_meaning(cycle, "plunging-depth").is_some() => Some(Use::Drilling),
        Group::Threads if mills => Some(Use::ThreadMilling),
        Group::Threads => Some(Use::Tapping),
        // It drills for another tool that roughs out.
        Group::Contours if with_meaning(cycle, PILOT).is_some() => Some(Use::Drilling),
        _ => Some(Use::Milling),
    }
}

fn shown(facts: &Facts<'_>, tool: ToolRef) -> String {
    match named(facts, tool) {
        Some(ToolName::Number(number)) => number.to_string(),
        Some(ToolName::Name(name)) => format!("\"{name}\""),
        None => String::new(),
    }
}
