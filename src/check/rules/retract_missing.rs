//! A tool call, a rotary axis that turns at rapid, a plane that is tilted with MOVE or the end of the program while the
//! tool is inside of the blank, or just above it, or at the end of the program close beside it: it was not retracted.
//! A PLANE with TURN directly after a cycle that leaves the tool just above its surface.
//!
//! Places are followed from label to label in programs with a box as their blank. Silent while the control holds the tool
//! tip in its place (M128, FUNCTION TCPM). Each is said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::incident::Incident;
use crate::check::program::{is_silent, number};
use crate::check::travel::incidents;
use crate::check::{Aspect, Facts, Pending, Rule, Tri};
use crate::program::syntax::{Axis, Block, BlockKind, StatementKind};
use crate::spec::{Keyword, MM_PER_INCH};

pub(super) const RULE: Rule = Rule { code: "retract-missing", severity: Severity::Warning, run };

/// The meanings of the values that say at which height a cycle leaves the tool.
const SURFACE: &str = "surface-coordinate";
const RADIUS: &str = "cylinder-radius";
const CLEARANCES: [&str; 2] = ["set-up-clearance", "second-set-up-clearance"];
/// So far above the surface no rotary axis turns, in millimetres.
const CLEAR: f64 = 10.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut change, mut turn, mut tilt, mut end) = (false, false, false, false);
    for (span, own) in incidents(facts) {
        let (what, height, said) = match own {
            Incident::ToolChangeInMaterial(height) => ("change", *height, &mut change),
            Incident::AxisTurnsInMaterial(height) => ("turn", *height, &mut turn),
            Incident::TiltsInMaterial(height) => ("tilt", *height, &mut tilt),
            Incident::EndsInMaterial(height) => ("end", *height, &mut end),
            _ => continue,
        };
        if !std::mem::replace(said, true) {
            found.push(rule.at(facts, *span).arg("what", what).arg("value", Arg::Number(height)));
        }
    }
    if let Some((span, height)) = turned_after_cycle(facts).filter(|_| !turn) {
        found.push(rule.at(facts, span).arg("what", "turn").arg("value", Arg::Number(height)));
    }
}

/// The first PLANE that turns the axes where a cycle has left the tool just above its surface, with that height.
fn turned_after_cycle(facts: &Facts<'_>) -> Option<(Span, f64)> {
    facts.marked().find_map(|(index, block)| {
        let BlockKind::Statement(own) = &block.kind else { return None };
        let span = facts.content(block);
        let turns = facts.text(span).split_ascii_whitespace().any(|word| word.eq_ignore_ascii_case("TURN"));
        let free = facts.run.before(index).is_some_and(|modal| modal.is(Aspect::Tcpm) == Tri::No);
        (own.kind == StatementKind::Plane && turns && free).then_some(())?;
        Some((span, left_at(facts, index)?))
    })
}

/// The height at which the last cycle has left the tool, if that is just above its surface and nothing has moved the
/// tool along its axis since.
fn left_at(facts: &Facts<'_>, index: usize) -> Option<f64> {
    let blocks = facts.program.blocks();
    for (at, block) in blocks.iter().enumerate().take(index).rev() {
        if let Some(call) = facts.run.calls.iter().find(|call| call.block == at) {
            let Pending::Definition(pending) = call.modal.pending else { return None };
            let own = facts.definitions.get(pending as usize)?;
            let related = own.as_related_cycle();
            let read = facts.read(&related);
            let value = |meaning: &str| read.item(meaning).and_then(number);
            let second = if read.item(CLEARANCES[1]).is_some() { value(CLEARANCES[1])? } else { 0.0 };
            let above = value(CLEARANCES[0])?.max(second);
            let least = if facts.inch { CLEAR / MM_PER_INCH } else { CLEAR };
            return (above < least).then_some(value(SURFACE).or_else(|| value(RADIUS))? + above);
        }
        if !stays(facts, at, block) {
            return None;
        }
    }
    None
}

/// Whether a block certainly leaves the tool at its height.
fn stays(facts: &Facts<'_>, at: usize, block: &Block) -> bool {
    match &block.kind {
        BlockKind::Motion(motion) => {
            let flat = |axis: Axis| matches!(axis, Axis::X | Axis::Y);
            let words = motion.words();
            !motion.has_functions() && words.coords.iter().all(|coord| flat(coord.axis))
        }
        BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) => {
            facts.definition_at(at).is_none_or(|own| own.key.keyword == Keyword::CyclDef && own.cycle().is_some())
        }
        BlockKind::FnAssign(_) | BlockKind::Formula(_) => true,
        _ => is_silent(block),
    }
}
