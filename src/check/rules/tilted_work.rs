//! A face that is milled first in a tilted plane: it meets nothing of the blank, or more material stands there than the
//! height at which it begins.
//!
//! Only where PLANE SPATIAL with numbers, after at most a datum shift with numbers, tilts it, in programs with a box as their
//! blank; the text must be carried out from the beginning to there without labels and jumps.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{cosd, sind};
use crate::check::blank::Blank;
use crate::check::cycle::Effect;
use crate::check::program::{Definition, is_silent, number};
use crate::check::{Aspect, Facts, Pending, Rule};
use crate::program::syntax::{Block, BlockKind, StatementKind};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "tilted-work", severity: Severity::Warning, run };

/// The meanings of a face: its corner and its sides, its height before and after.
const CORNER: [&str; 2] = ["starting-point-main", "starting-point-minor"];
const SIDES: [&str; 2] = ["first-side-length", "second-side-length"];
const START: &str = "starting-point-tool";
const END: &str = "end-point-tool";
/// So many places of each side are looked at.
const PLACES: u8 = 16;
/// So much more material than meant is too much, mm.
const MORE: f64 = 2.0;
/// So far up is looked for material, mm, and in such steps.
const UP: f64 = 200.0;
const STEP: f64 = 0.5;

/// Where the coordinates of the program are in those of the blank.
#[derive(Clone, Copy)]
struct Frame {
    origin: [f64; 3],
    /// The angles about X, Y and Z.
    angles: [f64; 3],
}

impl Frame {
    fn place(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.angles;
        let (x, y, z) = (x, y * cosd(a) - z * sind(a), y * sind(a) + z * cosd(a));
        let (x, y, z) = (x * cosd(b) + z * sind(b), y, z * cosd(b) - x * sind(b));
        let (x, y) = (x * cosd(c) - y * sind(c), x * sind(c) + y * cosd(c));
        [self.origin[0] + x, self.origin[1] + y, self.origin[2] + z]
    }

    fn is_tilted(&self) -> bool {
        self.angles != [0.0; 3]
    }
}

/// What a cycle works at: two corners in the plane, and the heights before and after.
struct Work {
    low: [f64; 2],
    high: [f64; 2],
    from: f64,
    to: f64,
    span: Span,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let tilts = |block: &Block| matches!(&block.kind, BlockKind::Statement(own) if own.kind == StatementKind::Plane);
    if !facts.begins() || facts.flow.programs || facts.flow.unread.any() || !facts.marked().any(|(_, own)| tilts(own)) {
        return;
    }
    let Some(blank) = Blank::of(facts.program) else { return };
    let unit = facts.millimetre();
    let mut frame = Some(Frame { origin: [0.0; 3], angles: [0.0; 3] });
    // Whether something was done since the plane was tilted.
    let mut worked = false;
    let mut calls = facts.run.calls.iter().peekable();
    for (index, block) in facts.program.blocks().iter().enumerate().filter(|(_, block)| !is_silent(block)) {
        if block.skip || matches!(block.kind, BlockKind::Lbl(_) | BlockKind::CallLbl(_) | BlockKind::FnJump(_)) {
            return;
        }
        while calls.next_if(|call| call.block < index).is_some() {}
        if let Some(changed) = changed(facts, index, block, frame) {
            (frame, worked) = (changed, false);
        }
        while let Some(call) = calls.next_if(|call| call.block == index) {
            let Some(frame) = frame.filter(Frame::is_tilted) else { continue };
            let first = !std::mem::replace(&mut worked, true);
            let Pending::Definition(at) = call.modal.pending else { continue };
            let Some(own) = facts.definitions.get(at as usize).filter(|_| first) else { continue };
            let related = own.as_related_cycle();
            let read = facts.read(&related);
            let Some(work) = work(&read) else { continue };
            if !meets(&blank, &frame, &work, unit) {
                found.push(rule.at(facts, call.span).arg("what", "beside").arg("value", 0).arg("other", 0));
            } else if let Some(top) = stands(&blank, &frame, &work, unit) {
                found.push(rule.comparison(facts, work.span, "stands", work.from, (top * 10.0).round() / 10.0));
            }
        }
    }
}

/// The frame after a block that changes it, which may not be certain; nothing if it does not.
fn changed(facts: &Facts<'_>, index: usize, block: &Block, frame: Option<Frame>) -> Option<Option<Frame>> {
    match &block.kind {
        BlockKind::Statement(own) if own.kind == StatementKind::Plane => {
            let text = facts.text(facts.content(block)).to_ascii_uppercase();
            let Some(mut new) = frame else { return Some(None) };
            if text.contains("RESET") {
                new.angles = [0.0; 3];
                return Some(Some(new));
            }
            let word = |name: &str| {
                // SPATIAL begins like SPA.
                text.split_whitespace().find_map(|word| word.strip_prefix(name)?.parse::<f64>().ok())
            };
            let angles = [word("SPA"), word("SPB"), word("SPC")];
            let ([Some(a), Some(b), Some(c)], true, false) = (angles, text.contains("SPATIAL"), new.is_tilted()) else {
                return Some(None);
            };
            new.angles = [a, b, c];
            Some(Some(new))
        }
        BlockKind::Statement(own) if own.kind == StatementKind::Trans => Some(None),
        BlockKind::OldCycleLine(_) | BlockKind::CycleDef(_) => {
            let own = facts.definition_at(index)?;
            let cycle = own.related_cycle()?;
            if cycle.file.group != Group::Transforms {
                return None;
            }
            // A preset that is activated before all is that of the blank.
            let preset = cycle.params.iter().any(|param| param.is.as_str() == "preset-number");
            let moved = |own: &Frame| own.is_tilted() || own.origin != [0.0; 3];
            if preset && !frame.as_ref().is_none_or(moved) {
                return None;
            }
            let effect = Effect::of_cycle(cycle);
            let shifts = !effect.aspects.is_empty() && effect.aspects.iter().all(|(own, _)| *own == Aspect::DatumShift);
            Some(shifted(facts, shifts, own.view.first..=own.view.last, frame))
        }
        _ => None,
    }
}

/// The frame after the lines of a definition, if they are those of a datum shift with numbers in a plane that is not tilted,
/// or of one that ends it.
fn shifted(
    facts: &Facts<'_>,
    shifts: bool,
    lines: std::ops::RangeInclusive<usize>,
    frame: Option<Frame>,
) -> Option<Frame> {
    let mut new = frame.filter(|own| shifts && !own.is_tilted())?;
    for block in facts.program.blocks().get(lines)? {
        let text = facts.text(facts.content(block)).split(';').next()?.to_ascii_uppercase();
        for word in text.split_whitespace().skip(3) {
            let axis = ["X", "Y", "Z"].iter().position(|axis| word.starts_with(axis));
            match axis {
                Some(axis) => new.origin[axis] = word.get(1..)?.parse().ok()?,
                None if word.starts_with(['I', '#', 'A', 'B', 'C']) && word.bytes().any(|own| own.is_ascii_digit()) => {
                    return None;
                }
                None => {}
            }
        }
    }
    Some(new)
}

/// The face that a cycle mills, if that is certain.
fn work(read: &Definition<'_>) -> Option<Work> {
    let value = |meaning: &str| read.item(meaning).and_then(number);
    let (item, end) = (read.item(START)?, value(END)?);
    let (from, [x, y]) = (number(item)?, [value(CORNER[0])?, value(CORNER[1])?]);
    let [long, wide] = [value(SIDES[0])?, value(SIDES[1])?];
    let low = [x.min(x + long), y.min(y + wide)];
    let high = [x.max(x + long), y.max(y + wide)];
    Some(Work { low, high, from: from.max(end), to: end, span: item.value_span })
}

/// The places of the plane that work is looked at, none of them at its edge.
fn places(work: &Work) -> impl Iterator<Item = [f64; 2]> {
    let part = |at: u8| (f64::from(at) + 0.5) / f64::from(PLACES);
    let place = move |axis: usize, at: u8| work.low[axis] + (work.high[axis] - work.low[axis]) * part(at);
    (0..PLACES).flat_map(move |x| (0..PLACES).map(move |y| [place(0, x), place(1, y)]))
}

/// Whether a place is inside of the blank.
fn holds(blank: &Blank, place: [f64; 3], unit: f64) -> bool {
    let skin = 0.05 * unit;
    (0..3).all(|axis| blank.low[axis] + skin < place[axis] && place[axis] < blank.high[axis] - skin)
}

/// Whether work meets the blank anywhere.
fn meets(blank: &Blank, frame: &Frame, work: &Work, unit: f64) -> bool {
    let heights: Vec<f64> =
        (0..=PLACES).map(|at| work.to + (work.from - work.to) * f64::from(at) / f64::from(PLACES)).collect();
    places(work).any(|[x, y]| heights.iter().any(|z| holds(blank, frame.place([x, y, *z]), unit)))
}

/// The height up to which material stands over work, if it is more than meant.
fn stands(blank: &Blank, frame: &Frame, work: &Work, unit: f64) -> Option<f64> {
    let steps = (UP / STEP) as u16;
    let height = |step: u16| work.from + f64::from(step) * STEP * unit;
    let top = (0..steps)
        .rev()
        .find(|step| places(work).any(|[x, y]| holds(blank, frame.place([x, y, height(*step)]), unit)))?;
    Some(height(top)).filter(|top| *top > work.from + MORE * unit)
}
