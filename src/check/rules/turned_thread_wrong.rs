//! A turned thread that does not fit what was turned before: its pitch is far too large for its diameter, its diameter
//! is another one than that of the cylinder on which it lies, it goes on beyond the end of that cylinder or past the
//! only groove in it, in which it is to run out, or it is an inside thread on a cylinder that was turned outside; or its pitch
//! is not that of the insert, where the tool table or the name of the tool has one. Also
//! one that is cut with a constant cutting speed: the spindle speed changes with the depth of each pass, and the flanks
//! with it.
//!
//! Cylinders are those of the simple cycles for shoulders, where their end is written as a number. Of contours that cycles
//! read from subprograms it is only said that a thread goes on into a wider part of them.
use super::cutting_speed_unlimited::switches;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::contours::{listed, moved};
use crate::check::program::{number, with_meaning};
use crate::check::tools::pitch_of_loaded;
use crate::check::{Defined, Facts, Pending, Rule};
use crate::program::syntax::{Axis, BlockKind};
use crate::spec::{Cycle, Group, MM_PER_INCH};

pub(super) const RULE: Rule = Rule { code: "turned-thread-wrong", severity: Severity::Warning, run };

/// The meanings of values of threads.
const PITCH: &str = "turned-thread-pitch";
const DIAMETER: [&str; 2] = ["turned-thread-diameter", "contour-start-diameter"];
const STARTS: &str = "number-of-thread-starts";
const POSITION: &str = "thread-position";
/// That value of the position is an inside thread.
const INSIDE: f64 = 1.0;
/// The meanings of the ends of contours, and of their beginning in Z.
const END: [&str; 2] = ["contour-end-diameter", "contour-end-z"];
const START: [&str; 2] = ["contour-start-diameter", "contour-start-z"];
const BEGIN: &str = "contour-start-z";
/// The greatest part of the diameter that a pitch has: that of the coarsest trapezoidal threads.
const COARSEST: f64 = 0.35;
/// A pitch that differs by such a part is another one than that of the insert.
const SAME: f64 = 0.02;
/// So much the cylinder of an outside thread may differ from its diameter: part of the diameter, and mm.
const NEAR: (f64, f64) = (0.04, 0.5);
/// So far beyond the end of the cylinder a thread may go, mm: its runout.
const RUNOUT: f64 = 0.5;

/// A cylinder that was turned: its diameter and its end in Z, mm.
struct Cylinder {
    diameter: f64,
    end: f64,
}

/// A groove: the diameter in which it was cut, and its far side and near side in Z, mm.
struct Groove {
    diameter: f64,
    far: f64,
    near: f64,
}

/// What was turned: cylinders, grooves in them, whether there may be more, and whether something was machined inside.
type Turned<'t> = (&'t [Cylinder], &'t [Groove], bool, bool);

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let unit = if facts.inch { MM_PER_INCH } else { 1.0 };
    let mut cylinders: Vec<Cylinder> = Vec::new();
    let mut grooves: Vec<Groove> = Vec::new();
    // Whether something turns what is not known, or inside.
    let (mut open, mut inside) = (false, false);
    let profiles = profiles(facts, unit);
    let mut seen = std::collections::HashSet::new();
    let switches = switches(facts);
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else {
            open = true;
            continue;
        };
        let Some(own) = facts.definitions.get(index as usize).filter(|_| seen.insert(index)) else { continue };
        let Some(cycle) = own.related_cycle() else {
            open = true;
            continue;
        };
        inside |= cycle.file.group == Group::Drilling;
        if cycle.file.group != Group::Turning {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let value = |meaning: &str| read.item(meaning).and_then(number).map(|own| own * unit);
        if with_meaning(cycle, PITCH).is_some() {
            let before = switches.partition_point(|(index, _)| *index < own.view.first);
            if before.checked_sub(1).is_some_and(|last| switches[last].1) {
                let finding = rule.at(facts, own.view.head).arg("what", "speed").arg("value", "");
                found.push(finding.arg("other", ""));
            }
            let item = read.item(PITCH).and_then(|item| Some((item, number(item)?)));
            if let (Some((item, pitch)), Some(tool)) = (item, pitch_of_loaded(facts, call.modal.loaded))
                && (pitch.abs() - tool).abs() > SAME * tool
            {
                found.push(rule.comparison(facts, item.value_span, "tool", pitch, tool));
                continue;
            }
            if !shoulder(rule, facts, own, (&profiles, inside), unit, found) {
                thread(rule, facts, own, (&cylinders, &grooves, open, inside), unit, found);
            }
        } else if is_shoulder(cycle) {
            match END.map(value) {
                [Some(diameter), Some(end)] => cylinders.push(Cylinder { diameter, end }),
                _ => open = true,
            }
        } else if with_meaning(cycle, "recess-clearance").is_some() {
            let (start, end) = (START.map(value), END.map(value));
            if let ([Some(diameter), Some(from)], [Some(bottom), Some(to)]) = (start, end)
                && bottom < diameter
            {
                grooves.push(Groove { diameter, far: from.min(to), near: from.max(to) });
            }
        } else if !is_face(cycle) {
            open = true;
        }
    }
}

/// Whether a cycle turns a cylinder from the face on.
fn is_shoulder(cycle: &Cycle) -> bool {
    let name = cycle.file.name.as_str();
    name.contains("shoulder") && name.contains("longitudinal")
}

/// Whether a cycle turns a face.
fn is_face(cycle: &Cycle) -> bool {
    cycle.file.name.as_str().contains("face") || with_meaning(cycle, "turning-clearance").is_none()
}

/// The corners of the contours that turning cycles read from subprograms, by the cycle that reads them: diameter and Z, mm.
fn profiles(facts: &Facts<'_>, unit: f64) -> Vec<(usize, Vec<[f64; 2]>)> {
    let mut all = Vec::new();
    for list in listed(facts) {
        let turns = |own: &&&Defined<'_>| own.related_cycle().is_some_and(|cycle| cycle.file.group == Group::Turning);
        let Some(reader) = list.readers.iter().filter(turns).map(|own| own.view.first).min() else { continue };
        for contour in &list.contours {
            let (mut at, mut corners) = ([None; 2], Vec::new());
            for block in contour.iter() {
                let BlockKind::Motion(motion) = &block.kind else { continue };
                at = moved(&motion.words(), [Axis::X, Axis::Z], at).unwrap_or_default();
                if let [Some(x), Some(z)] = at {
                    corners.push([x * unit, z * unit]);
                }
            }
            all.push((reader, corners));
        }
    }
    all
}

/// An outside thread on a contour that has a wider part before its end, or an inside thread on one.
fn shoulder(
    rule: &Rule,
    facts: &Facts<'_>,
    own: &Defined<'_>,
    (profiles, drilled): (&[(usize, Vec<[f64; 2]>)], bool),
    unit: f64,
    found: &mut Vec<Diagnostic>,
) -> bool {
    let related = own.as_related_cycle();
    let read = facts.read(&related);
    let item = |meaning: &str| read.item(meaning).and_then(|item| Some((number(item)?, item.value_span)));
    let Some((position, place)) = item(POSITION) else { return false };
    let (Some((diameter, _)), Some((end, span))) = (DIAMETER.into_iter().find_map(item), item(END[1])) else {
        return false;
    };
    let begin = item(BEGIN).map_or(0.0, |(own, _)| own * unit);
    let before = || profiles.iter().filter(|(reader, _)| *reader < own.view.first).flat_map(|(_, corners)| corners);
    if position == INSIDE {
        let near = |[x, _]: &[f64; 2]| (x - diameter * unit).abs() <= NEAR.0 * diameter * unit + NEAR.1;
        let outside = !drilled && before().any(near);
        if outside {
            found.push(rule.comparison(facts, place, "inside", diameter, diameter));
        }
        return outside;
    }
    let wider = |[x, z]: &&[f64; 2]| {
        *x > diameter * unit * (1.0 + NEAR.0) + NEAR.1 && *z < begin - RUNOUT && *z > end * unit + RUNOUT
    };
    let first = before().filter(wider).max_by(|a, b| a[1].total_cmp(&b[1]));
    if let Some([_, z]) = first {
        found.push(rule.comparison(facts, span, "end", end, z / unit));
    }
    first.is_some()
}

fn thread(
    rule: &Rule,
    facts: &Facts<'_>,
    own: &Defined<'_>,
    (cylinders, grooves, open, inside): Turned<'_>,
    unit: f64,
    found: &mut Vec<Diagnostic>,
) {
    let related = own.as_related_cycle();
    let read = facts.read(&related);
    let item = |meaning: &str| read.item(meaning).and_then(|item| Some((number(item)?, item.value_span)));
    let diameter = DIAMETER.into_iter().find_map(item);
    let Some((written, place)) = diameter.filter(|(own, _)| *own > 0.0) else { return };
    let diameter = written * unit;
    let finding_of = |span, what, value, other| rule.comparison(facts, span, what, value, other);
    let starts = item(STARTS).map_or(1.0, |(starts, _)| starts.max(1.0));
    if let Some((pitch, span)) = item(PITCH)
        && pitch * unit / starts > COARSEST * diameter
    {
        found.push(finding_of(span, "pitch", pitch, written));
    }
    let near = |own: &&Cylinder| (own.diameter - diameter).abs() <= NEAR.0 * diameter + NEAR.1;
    let (Some((end, last)), begin) = (item(END[1]), item(BEGIN).map_or(0.0, |(own, _)| own * unit)) else { return };
    if let Some((position, span)) = item(POSITION)
        && position == INSIDE
    {
        if !inside && !open && cylinders.iter().any(|own| near(&own)) {
            found.push(finding_of(span, "inside", written, written));
        }
        return;
    }
    // What is turned where the thread begins.
    let here = cylinders.iter().filter(|own| own.end < begin - RUNOUT).min_by(|a, b| a.diameter.total_cmp(&b.diameter));
    let Some(here) = here.filter(|_| !open) else { return };
    if !near(&here) {
        found.push(finding_of(place, "diameter", written, here.diameter / unit));
    } else if end * unit < here.end - RUNOUT {
        found.push(finding_of(last, "end", end, here.end / unit));
    } else {
        let own = |groove: &&Groove| {
            (groove.diameter - here.diameter).abs() <= RUNOUT && groove.near < begin && groove.far > here.end
        };
        let mut all = grooves.iter().filter(own);
        if let (Some(groove), None) = (all.next(), all.next())
            && end * unit < groove.far - RUNOUT
        {
            found.push(finding_of(last, "groove", end, groove.far / unit));
        }
    }
}
