//! A tool call, a rotary axis that turns at rapid, a plane that is tilted with MOVE or the end of the program while the
//! tool is inside of the blank, or just above it, or at the end of the program close beside it: it was not retracted.
//! A PLANE with TURN directly after a cycle that leaves the tool just above its surface, or the only turn of the axes
//! after a retraction that is far less than before all others.
//!
//! Also the only line of a surface after which the tool goes on at rapid without the retraction that all other lines
//! have.
//!
//! Places are followed from label to label in programs with a box as their blank. Silent while the control holds the
//! tool tip in its place (M128, FUNCTION TCPM). Each is said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::blank;
use crate::check::incident::Incident;
use crate::check::program::{is_silent, number};
use crate::check::travel::incidents;
use crate::check::{Aspect, Facts, Pending, Rule, Tri, Way};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, StatementKind};
use crate::spec::{Keyword, MM_PER_INCH};

pub(super) const RULE: Rule = Rule { code: "retract-missing", severity: Severity::Warning, run };

/// The meanings of the values that say at which height a cycle leaves the tool.
const SURFACE: &str = "surface-coordinate";
const RADIUS: &str = "cylinder-radius";
const CLEARANCES: [&str; 2] = ["set-up-clearance", "second-set-up-clearance"];
/// Longer programs are written by posts.
const MOST: usize = 3_000;
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
        turn = true;
    }
    if let Some((block, height)) = unlifted(facts) {
        let finding = rule.at(facts, facts.content(block)).arg("what", "rapid");
        found.push(finding.arg("value", Arg::Number(height)));
    }
    if let Some((block, height)) = unlike_others(facts).filter(|_| !turn) {
        let what = if height.is_some() { "others" } else { "unretracted" };
        let finding = rule.at(facts, facts.content(block)).arg("what", what);
        found.push(finding.arg("value", Arg::Number(height.unwrap_or_default())));
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

/// The only line of a surface from which the tool goes on at rapid in the plane, with its height; it is lifted after at
/// least three others.
fn unlifted<'a>(facts: &Facts<'a>) -> Option<(&'a Block, f64)> {
    const OTHERS: usize = 3;
    /// So many points have a line of a surface.
    const POINTS: usize = 3;
    let top = blank::top(facts.program)?;
    let blocks = facts.program.blocks();
    let (mut lifted, mut found) = (0, Vec::new());
    // The points of the line, and its last height.
    let (mut points, mut last) = (0, None);
    for block in blocks.iter().take(MOST).filter(|block| !is_silent(block)) {
        let BlockKind::Motion(motion) = &block.kind else {
            points = 0;
            continue;
        };
        let words = motion.words();
        let height = words.coord(Axis::Z);
        let across = words.coords.iter().any(|own| matches!(own.axis, Axis::X | Axis::Y));
        if !motion.outline().is_rapid() {
            let number = height.filter(|own| !own.incremental).and_then(|own| facts.number(&own.value));
            last = if height.is_some() { number } else { last };
            points = if across && height.is_some() { points + 1 } else { 0 };
            continue;
        }
        let low = last.filter(|height| std::mem::take(&mut points) >= POINTS && *height < top);
        match low {
            Some(low) if height.is_none() && across && !motion.has_functions() && !block.skip => {
                found.push((block, low));
            }
            Some(low) if height.and_then(|own| facts.number(&own.value)).is_some_and(|to| to > low) => lifted += 1,
            _ => {}
        }
    }
    match found.as_slice() {
        [only] if lifted >= OTHERS => Some(*only),
        _ => None,
    }
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

/// Whether a height is above the blank.
fn is_above(facts: &Facts<'_>, height: f64) -> bool {
    let top = blank::top(facts.program);
    top.is_some_and(|top| top < height)
}

/// Whether a block turns nothing but the axis about the tool axis.
fn turns_flat(block: &Block) -> bool {
    let BlockKind::Motion(motion) = &block.kind else { return false };
    !motion.words().coords.iter().any(|own| matches!(own.axis, Axis::A | Axis::B))
}

/// Whether a block is in a part that is repeated.
fn is_repeated(facts: &Facts<'_>, block: &Block) -> bool {
    let graph = &facts.run.graph;
    let at = facts.program.blocks().partition_point(|own| own.line < block.line);
    graph.uses.iter().filter(|own| matches!(own.way, Way::Jump | Way::Repeat) && own.block > at).any(|own| {
        let to = own.mark.as_ref().and_then(|mark| graph.block_of(mark));
        to.is_some_and(|to| to < at)
    })
}

/// How far the tool was retracted before the axes turn.
#[derive(Clone, Copy, PartialEq)]
enum Height {
    /// It was not since it has cut.
    Not,
    /// To a position of the machine.
    Machine,
    /// To a coordinate.
    Over(f64),
}

/// The only block that turns the axes of a tilted plane, or back, after a retraction that is far less than that before
/// all the others.
fn unlike_others<'a>(facts: &Facts<'a>) -> Option<(&'a Block, Option<f64>)> {
    /// So many others make a rule.
    const OTHERS: usize = 2;
    let blocks = facts.program.blocks();
    if blocks.len() > MOST || !facts.begins() {
        return None;
    }
    // How far the tool was retracted last, and whether anything but definitions of planes came after it.
    let (mut height, mut turns): (Option<Height>, Vec<(&Block, Height)>) = (None, Vec::new());
    // Where the cycle that was defined last leaves the tool.
    let mut left = Height::Not;
    for (index, block) in blocks.iter().enumerate().filter(|(_, block)| !is_silent(block) && !block.skip) {
        match &block.kind {
            BlockKind::Motion(motion) => {
                let words = motion.words();
                let rotary = words.coords.iter().any(|own| matches!(own.axis, Axis::A | Axis::B | Axis::C));
                let machine = words.functions.iter().any(|own| matches!(own.number, 91 | 140));
                if rotary && motion.outline().is_rapid() {
                    // The next turn without a movement between is from the same height.
                    turns.extend(height.take().map(|height| (block, height)));
                } else if machine {
                    height = Some(Height::Machine);
                } else if let Some(own) = words.coord(Axis::Z) {
                    let alone = words.coords.len() == 1 && motion.outline().is_rapid() && !own.incremental;
                    height = match own.value.amount {
                        _ if !motion.outline().is_rapid() => Some(Height::Not),
                        Amount::Number(value) if alone => Some(Height::Over(value)),
                        _ => None,
                    };
                } else if !motion.outline().is_rapid() {
                    height = Some(Height::Not);
                }
                if words.functions.iter().any(|own| own.number == 99) {
                    height = Some(left);
                }
            }
            BlockKind::Functions(list) if list.iter().any(|own| own.number == 140) => height = Some(Height::Machine),
            BlockKind::Statement(own) if own.kind == StatementKind::Plane => {
                let words = facts.text(facts.content(block)).to_ascii_uppercase();
                if [" TURN", " MOVE"].iter().any(|word| words.contains(word)) {
                    turns.extend(height.take().map(|height| (block, height)));
                }
            }
            BlockKind::OldCycleLine(_) | BlockKind::Functions(_) => {}
            BlockKind::CyclCall(_) => height = Some(left),
            BlockKind::CycleDef(_) => {
                if let Some(own) = facts.definition_at(index) {
                    let related = own.as_related_cycle();
                    let read = facts.read(&related);
                    let value = |meaning: &str| read.item(meaning).and_then(number);
                    let second = value(CLEARANCES[1]).filter(|second| *second > 0.0);
                    left = value(SURFACE)
                        .zip(second)
                        .map_or(Height::Not, |(surface, second)| Height::Over(surface + second));
                }
            }
            // After a tool change, in a subprogram or after one the tool may be anywhere.
            _ => height = None,
        }
    }
    let low = |own: Height, usual: Height| match (own, usual) {
        (Height::Over(own), Height::Over(usual)) => own < usual / 2.0,
        (Height::Over(_), Height::Machine) => true,
        (Height::Machine, _) | (_, Height::Not) => false,
        (Height::Not, _) => true,
    };
    let usual = turns.first().map(|own| own.1)?;
    let usual = if turns.iter().filter(|own| own.1 == usual).count() > 1 { usual } else { turns.get(1)?.1 };
    let mut others = turns.iter().filter(|own| own.1 != usual);
    let (block, own) = others.next().copied()?;
    let value = match own {
        Height::Over(value) => Some(value),
        Height::Not | Height::Machine => None,
    };
    // What is repeated is not the only one, and a turn about the tool axis keeps the part below the tool.
    let plain = matches!(own, Height::Over(height) if is_above(facts, height) && (turns_flat(block) || is_repeated(facts, block)));
    (others.next().is_none() && turns.len() > OTHERS && low(own, usual) && !plain).then_some((block, value))
}
