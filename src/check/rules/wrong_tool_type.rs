//! A workpiece that is probed with the tool that has just machined it,
//! or machined with the tool that has just probed it; a probe that is measured as a tool; a tool that cuts with which the
//! touch probe for tools is calibrated.
//!
//! A contour with RL or RR at feed is machining, too. A tool call must come between them. Silent after STOP, M0, M6 and M functions of the machine builder, where
//! another tool may be put in by hand. Each is reported once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::{probes, removes_material};
use crate::check::program::with_meaning;
use crate::check::program::words::has_function;
use crate::check::tools::{kind_of_call, named};
use crate::check::{Aspect, Defined, Facts, Loaded, Pending, Rule, ToolKind, ToolName, Tri};
use crate::program::syntax::{Block, BlockKind, Compensates};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "wrong-tool-type", severity: Severity::Warning, run };

/// The meaning of what only the measurement of a tool that cuts has.
const MEASURED: &str = "tooth-measurement";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let milled = Milled::of(facts);
    let probe = facts.definitions.iter().find(|own| {
        own.related_cycle().is_some_and(probes)
            && facts
                .run
                .before(own.view.first)
                .is_some_and(|modal| modal.is(Aspect::Cut) == Tri::Yes || milled.with(modal.loaded, own.view.first))
    });
    if let Some(own) = probe {
        let finding = rule.at(facts, own.view.head).arg("what", "probe");
        found.push(finding.arg("cycle", own.key.to_string()));
    }
    let measured = facts.definitions.iter().find(|own| {
        measures(own) && facts.run.before(own.view.first).is_some_and(|modal| modal.is(Aspect::Probed) == Tri::Yes)
    });
    if let Some(own) = measured {
        let finding = rule.at(facts, own.view.head).arg("what", "measured");
        found.push(finding.arg("cycle", own.key.to_string()));
    }
    if measured.is_none()
        && let Some(own) = facts.definitions.iter().find(|own| measures_probe(facts, own))
    {
        let finding = rule.at(facts, own.view.head).arg("what", "named");
        found.push(finding.arg("cycle", own.key.to_string()));
    }
    if let Some(own) = facts.definitions.iter().find(|own| calibrates(own) && cuts(facts, own)) {
        let finding = rule.at(facts, own.view.head).arg("what", "calibrates");
        found.push(finding.arg("cycle", own.key.to_string()));
    }
    let mut calls = facts.run.calls.iter().filter(|call| call.modal.is(Aspect::Probed) == Tri::Yes);
    let call = calls.find_map(|call| {
        let Pending::Definition(index) = call.modal.pending else { return None };
        let own = facts.definitions.get(index as usize)?;
        own.related_cycle().is_some_and(removes_material).then_some((call.span, own))
    });
    if let Some((span, own)) = call {
        found.push(rule.at(facts, span).arg("what", "mill").arg("cycle", own.key.to_string()));
        return;
    }
    let probed = |index: usize| facts.run.before(index).is_some_and(|modal| modal.is(Aspect::Probed) == Tri::Yes);
    if let Some((_, block)) = facts.shaped().find(|(index, block)| along(block) && probed(*index)) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "contour"));
    }
}

/// Whether a block moves along a contour.
fn along(block: &Block) -> bool {
    match &block.kind {
        BlockKind::Motion(motion) => {
            motion.outline().compensates() == Compensates::Beside && !motion.outline().is_rapid()
        }
        _ => false,
    }
}

/// The blocks of contours, and those at which a tool may be put in by hand, in programs that probe.
#[derive(Default)]
struct Milled {
    contours: Vec<usize>,
    by_hand: Vec<usize>,
}

impl Milled {
    fn of(facts: &Facts<'_>) -> Self {
        if !facts.definitions.iter().any(|own| own.related_cycle().is_some_and(probes)) {
            return Self::default();
        }
        let contours = facts.shaped().filter(|(_, block)| along(block)).map(|(index, _)| index).collect();
        let stops = |block: &Block| matches!(block.kind, BlockKind::Stop(_)) || has_function(block, &[0, 1, 6]);
        let by_hand = facts.marked().filter(|(_, block)| stops(block)).map(|(index, _)| index).collect();
        Self { contours, by_hand }
    }

    /// Whether a tool has moved along a contour between its call and a block.
    fn with(&self, loaded: Loaded, until: usize) -> bool {
        let Loaded::By(call) = loaded else { return false };
        let within =
            |all: &[usize]| all.get(all.partition_point(|own| *own < call as usize)).is_some_and(|own| *own < until);
        within(&self.contours) && !within(&self.by_hand)
    }
}

/// Whether a definition measures a tool that cuts.
fn measures(own: &Defined<'_>) -> bool {
    own.related_cycle()
        .is_some_and(|cycle| cycle.file.group == Group::ToolMeasurement && with_meaning(cycle, MEASURED).is_some())
}

/// Whether it measures a tool that is called a touch probe.
fn measures_probe(facts: &Facts<'_>, own: &Defined<'_>) -> bool {
    let Some(Loaded::By(call)) = facts.run.before(own.view.first).map(|modal| modal.loaded) else { return false };
    measures(own) && kind_of_call(facts, call as usize) == Some(ToolKind::Probe)
}

/// The words in the name of a cycle that calibrates, and those for the tool that it needs.
const CALIBRATE: &str = "calibrate";
const PIN: [&str; 8] = ["CALIB", "KALIB", "KAL", "PIN", "DORN", "MASTER", "GAUGE", "REF"];
/// The words of the column TYP for tools that cut.
const MILLS: &str = "FRAES";

/// Whether a definition calibrates the touch probe for tools.
fn calibrates(own: &Defined<'_>) -> bool {
    own.related_cycle().is_some_and(|cycle| {
        cycle.file.group == Group::ToolMeasurement && cycle.file.name.as_str().starts_with(CALIBRATE)
    })
}

/// Whether the tool at a definition is one that cuts: by its name, or by its type in the table.
fn cuts(facts: &Facts<'_>, own: &Defined<'_>) -> bool {
    let Some(Loaded::By(call)) = facts.run.before(own.view.first).map(|modal| modal.loaded) else { return false };
    let Some(block) = facts.program.blocks().get(call as usize) else { return false };
    let BlockKind::ToolCall(tool) = &block.kind else { return false };
    let Some(name) = tool.tool.and_then(|tool| named(facts, tool)) else { return false };
    let word = |column: &str| facts.project.and_then(|project| project.tool_word(name, column)).unwrap_or_default();
    let own = match name {
        ToolName::Name(name) => name,
        ToolName::Number(_) => "",
    };
    let comment = block.comment().map(|own| facts.text(own)).unwrap_or_default();
    let words = format!("{} {} {own} {comment}", word("NAME"), word("DOC")).to_ascii_uppercase();
    if words.split(|sign: char| !sign.is_alphabetic()).any(|part| PIN.iter().any(|own| part.starts_with(own))) {
        return false;
    }
    let typed = word("TYP").to_ascii_uppercase();
    let kind = kind_of_call(facts, call as usize).or_else(|| ToolKind::of_type(&typed));
    kind.is_some_and(|kind| kind != ToolKind::Probe) || typed == MILLS
}
