//! Digitizing with a rotary axis of the table in the range: where its places are, and lines along which it turns.
//!
//! The range is that of one linear axis of the working plane and of the rotary axis; the third linear axis stays where
//! it is. Between points of a line along the rotary axis the stylus goes back, the table turns, and the stylus touches
//! the part again in the direction in which it came. Invariant: as for lines; where it touches comes from `scan`.
use glam::{DVec2, DVec3};

use super::range::{Range, RotaryRange, Row, SAME};
use super::scan::{Chart, Ground, Profile, Sample, beyond, lost};
use super::{
    ApproachDigitizingStart, Manner, OFF, Spent, axis_wrong, doubled, in_plane, probe, range_of, stepping, store,
};
use crate::engine::geometry::{Axis, RotaryAxis};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Control, Coordinate};

/// The meanings of the parameters in which a rotary axis may be.
const LEAST: &str = "digitizing-range-min";
const GREATEST: &str = "digitizing-range-max";
const DIRECTION: &str = "line-direction";
const START: &str = "contour-line-start";
const APPROACH: &str = "contour-line-approach";
const BEGINS: &str = "contour-line-direction";

/// A whole turn, degrees.
const TURN: f64 = 360.0;
/// A way back before the table turns is looked for with so many sizes.
const TRIES: usize = 16;

/// The fault of a range, or of a point in it, without an axis.
fn incomplete(letter: char) -> Fault {
    Fault::program("digitizing-range-incomplete").arg("axis", letter.to_string())
}

/// The fault of a way to digitize with a rotary axis that is not known here.
fn unknown(axis: RotaryAxis) -> Fault {
    Fault::unsupported("digitizing-rotary-axis").arg("axis", axis.letter().to_string())
}

/// The fault of a rotary axis that is not in the range.
fn not_in_range(control: &dyn Control, axis: RotaryAxis) -> Fault {
    let tool = control.plane().tool.letter().to_string();
    Fault::program("digitizing-axis-wrong").arg("axis", axis.letter().to_string()).arg("tool", tool)
}

/// The fault of an analog probe that shall do more with a rotary axis than lines along the linear one.
fn not_analog(axis: RotaryAxis) -> Fault {
    Fault::program("digitizing-rotary-analog").arg("axis", axis.letter().to_string())
}

/// The rotary axis that a parameter names, with its value.
fn turning(control: &dyn Control, meaning: &str) -> Option<(RotaryAxis, f64)> {
    let given = control.coordinates(meaning);
    given.into_iter().find(|own| own.rotary).map(|own| (RotaryAxis(own.axis), own.value))
}

/// The rotary axis of the range that is being defined; an error of axes that make no range.
pub(super) fn rotary_range(control: &dyn Control) -> Result<Option<RotaryRange>, Fault> {
    let (least, greatest) = (control.coordinates(LEAST), control.coordinates(GREATEST));
    let has = |point: &[Coordinate], axis: Axis, rotary: bool| {
        point.iter().any(|own| own.axis == axis && own.rotary == rotary)
    };
    let both = |axis: Axis| has(&least, axis, false) && has(&greatest, axis, false);
    let (first, last) = (turning(control, LEAST), turning(control, GREATEST));
    let (Some((axis, from)), Some((other, to))) = (first, last) else {
        if let Some((axis, _)) = first.or(last) {
            return Err(incomplete(axis.letter()));
        }
        return match Axis::ALL.into_iter().find(|axis| !both(*axis)) {
            Some(axis) => Err(incomplete(axis.letter())),
            None => Ok(None),
        };
    };
    if axis != other {
        return Err(incomplete(axis.letter()));
    }
    let plane = control.plane();
    if !both(plane.tool) {
        return Err(incomplete(plane.tool.letter()));
    }
    let lines: Vec<Axis> = [plane.main, plane.secondary].into_iter().filter(|axis| both(*axis)).collect();
    let [line] = lines[..] else {
        return Err(if lines.is_empty() { incomplete(plane.main.letter()) } else { unknown(axis) });
    };
    if least.len() != Axis::ALL.len() || !control.rotary(axis)?.carries_workpiece {
        return Err(unknown(axis));
    }
    Ok(Some(RotaryRange { axis, line, least: from, greatest: to }))
}

/// Where a place of the range is in the working plane.
pub(super) fn in_working_plane(control: &mut dyn Control, range: &Range, place: DVec2) -> DVec2 {
    let Some(rotary) = range.rotary else { return place };
    let began = control.digitizing().began;
    control.in_plane(rotary.line.with(began, place.x)).truncate()
}

/// Goes over a place of the range at the clearance height.
pub(super) fn go_over(control: &mut dyn Control, range: &Range, place: DVec2) -> Done {
    let at = in_working_plane(control, range, place);
    let at = control.axes(at.extend(range.height));
    let Some(rotary) = range.rotary else {
        control.digitizing().push(Row::Over(at));
        return control.fly(at, None);
    };
    control.digitizing().angle = place.y;
    control.digitizing().push(Row::Over(at));
    control.fly_turning((rotary.axis, place.y), at, None)
}

/// The direction of lines in the working plane, or in the chart of the range.
pub(super) fn line_direction(
    control: &dyn Control,
    range: &Range,
    with: &ApproachDigitizingStart,
) -> Result<DVec2, Fault> {
    let turns = turning(control, DIRECTION).map(|(axis, _)| axis);
    let Some(rotary) = range.rotary else {
        return match turns {
            Some(axis) => Err(not_in_range(control, axis)),
            None => in_plane(control, with.direction),
        };
    };
    if with.analog && (with.meander || turns.is_some()) {
        return Err(not_analog(rotary.axis));
    }
    if with.angle.is_some_and(|angle| angle != 0.0) {
        return Err(unknown(rotary.axis));
    }
    match turns {
        Some(axis) if axis == rotary.axis => Ok(DVec2::Y),
        Some(axis) => Err(not_in_range(control, axis)),
        None => along_line(control, &rotary, with.direction).map(|()| DVec2::X),
    }
}

/// An error where a direction is not along the linear axis of the range.
fn along_line(control: &dyn Control, rotary: &RotaryRange, direction: DVec3) -> Result<(), Fault> {
    let axes = control.axes(direction);
    if rotary.line.of(axes).abs() == 1.0 { Ok(()) } else { Err(axis_wrong(control, axes)) }
}

/// Where contour lines begin: in the working plane, or in the chart of the range.
pub(super) fn contour_line_start(
    control: &dyn Control,
    range: &Range,
    start: DVec2,
    analog: bool,
) -> Result<DVec2, Fault> {
    let Some(rotary) = range.rotary else {
        let turns = [START, APPROACH, BEGINS].into_iter().find_map(|meaning| turning(control, meaning));
        return match turns {
            Some((axis, _)) => Err(not_in_range(control, axis)),
            None => Ok(start),
        };
    };
    if analog {
        return Err(not_analog(rotary.axis));
    }
    if let Some((axis, _)) = turning(control, APPROACH) {
        return Err(unknown(axis));
    }
    let angle = start_angle(control, &rotary)?;
    Ok(DVec2::new(rotary.line.of(control.axes(start.extend(0.0))), angle))
}

/// The angle at which contour lines begin.
fn start_angle(control: &dyn Control, rotary: &RotaryRange) -> Result<f64, Fault> {
    let angle = turning(control, START).filter(|(axis, _)| *axis == rotary.axis).map(|(_, angle)| angle);
    angle.ok_or_else(|| not_in_range(control, rotary.axis))
}

/// In which sense the rotary axis of the range turns along a contour line; nothing in a range without one.
pub(super) fn turning_sense(control: &dyn Control, range: &Range) -> Result<Option<f64>, Fault> {
    let turns = turning(control, BEGINS);
    match (range.rotary, turns) {
        (None, None) => Ok(None),
        (None, Some((axis, _))) => Err(not_in_range(control, axis)),
        (Some(rotary), Some((axis, sense))) if axis == rotary.axis => Ok(Some(sense)),
        (Some(rotary), _) => Err(not_in_range(control, rotary.axis)),
    }
}

/// The ends of the range in the working plane, as far as the direction may lead to them.
pub(super) fn ends_in_plane(control: &mut dyn Control, range: &Range, direction: DVec2) -> Result<Vec<DVec2>, Fault> {
    let boundary = range.boundary(control.plane());
    if let Some(rotary) = range.rotary {
        along_line(control, &rotary, direction.extend(0.0))?;
    }
    Ok(boundary.into_iter().map(|corner| in_working_plane(control, range, corner)).collect())
}

/// Turns the table to where contour lines begin, beside the part.
pub(super) fn turn_back(control: &mut dyn Control, at: DVec3) -> Done {
    let Some(rotary) = range_of(control)?.rotary else { return Ok(()) };
    let angle = start_angle(control, &rotary)?;
    control.digitizing().angle = angle;
    control.digitizing().push(Row::Back(at));
    control.fly_turning((rotary.axis, angle), at, None)
}

/// Goes once around the part while the rotary axis turns; the stylus is before the first point.
pub(super) fn once_around(
    control: &mut dyn Control,
    range: &Range,
    (sense, approach): (f64, DVec2),
    manner: &Manner,
    spent: &mut Spent,
) -> Done {
    let Some(rotary) = range.rotary else { return Ok(()) };
    let (here, _) = control.stylus()?;
    let here = control.in_plane(here);
    if rotary.greatest - rotary.least < TURN - SAME {
        return Err(beyond(control, here).into());
    }
    let up = -approach.extend(0.0);
    let chart = Chart { axis: rotary.axis, base: here - up * here.dot(up), up, around: true };
    let top = control.digitizing().first.dot(up);
    let ends = ends_in_plane(control, range, approach)?;
    let floor = ends.into_iter().map(|end| end.extend(0.0).dot(up)).fold(f64::INFINITY, f64::min);
    let angle = control.digitizing().angle;
    let (from, to) = (DVec2::new(angle, 0.0), DVec2::new(angle + sense * TURN, 0.0));
    let turned = Some(chart);
    let profile = Profile { control: &*control, from, to, top, floor, ceiling: f64::INFINITY, turned };
    let samples = profile.trace(stepping(manner))?;
    take_turned(control, &chart, &samples, manner, [floor, top], spent)
}

/// Takes the points of a line along the rotary axis: the stylus is before the first of them. Where it only grazes what it
/// was to touch, it goes on to what is below, down to the end of the range.
pub(super) fn take_turned(
    control: &mut dyn Control,
    chart: &Chart,
    samples: &[Sample],
    manner: &Manner,
    [floor, top]: [f64; 2],
    spent: &mut Spent,
) -> Done {
    let travel = manner.travel.unwrap_or(OFF).max(OFF);
    for sample in samples.iter().skip(1) {
        let (angle, height) = (sample.at.x, sample.at.z);
        let touches = sample.on == Ground::Part;
        let (here, feed) = control.stylus()?;
        let now = (control.in_plane(here) - chart.base).dot(chart.up);
        let before = if touches { height + travel } else { height };
        let least = before.max(now);
        let larger = doubled(travel).take(TRIES).map(|more| least + more);
        let mut clear = None;
        for way in [least].into_iter().chain(larger).take_while(|way| *way < top).chain([top]) {
            if !control.touches_while_turning((chart.axis, angle), control.axes(chart.place(way)))? {
                clear = Some(way);
                break;
            }
        }
        let Some(clear) = clear else { return Err(lost(control, chart.place(height)).into()) };
        if clear > now + SAME {
            control.fly(control.axes(chart.place(clear)), Some(feed))?;
        }
        control.digitizing().angle = angle;
        let at = control.axes(chart.place(clear.max(now)));
        control.fly_turning((chart.axis, angle), at, Some(feed))?;
        if clear.max(now) > before + SAME {
            control.fly(control.axes(chart.place(before)), Some(feed))?;
        }
        spent.add((clear - now).abs() + (clear - before).abs(), feed)?;
        if !touches {
            store(control, chart.place(height));
            continue;
        }
        let touched = probe(control, -chart.up * (before - floor), manner.feed)?;
        let (stopped, _) = control.stylus()?;
        let reached = (control.in_plane(stopped) - chart.base).dot(chart.up);
        spent.add(before - reached, manner.feed)?;
        if touched {
            control.retract(travel)?;
        } else if chart.around {
            return Err(lost(control, chart.place(floor)).into());
        } else {
            store(control, chart.place(floor));
        }
    }
    Ok(())
}
