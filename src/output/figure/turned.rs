//! Parts about a rotary axis, on the sheet: half of one that is turned, cut open above the axis, what it will be, and the
//! insert; one on a rotary table, cut across the axis.
//!
//! Invariant: draws what [`half_plane`](super::half_plane) and [`cylinder`](super::cylinder) found.
use glam::DVec2;

use super::frame::Frame;
use super::pen::{Pen, Rect};
use super::subject::{Subject, flat};

/// What is nearer to the rotary axis lies on it, mm.
const ON_AXIS: f64 = 1e-3;

/// What is left of the part, hatched; dashed, what the blank was; and the rotary axis.
pub(super) fn part(pen: &mut Pen, subject: &Subject<'_>, frame: &Frame) {
    let (min, max) = (frame.material.min, frame.material.max);
    let place = |p: DVec2| frame.camera.place(p);
    let left = subject.shot.turned.as_ref().map_or(&[][..], |turned| &turned.left);
    let lines: Vec<Vec<DVec2>> = left.iter().map(|line| line.iter().copied().map(place).collect()).collect();
    let data: String = lines.iter().map(|line| Pen::data(line, true)).collect();
    pen.path("m", &data);
    pen.hatch(&lines);
    for line in subject.shot.turned.iter().flat_map(|turned| &turned.blank) {
        outline(pen, "v", line, &place);
    }
    for line in subject.shot.turned.iter().flat_map(|turned| &turned.finished) {
        outline(pen, "x", line, &place);
    }
    for line in left {
        outline(pen, "o", line, &place);
    }
    let ends = [DVec2::new(min.x, 0.0), DVec2::new(max.x, 0.0)].map(place);
    let more = DVec2::new(8.0, 0.0);
    pen.line("x", &[ends[0] - more, ends[1] + more]);
}

/// The edges of a part, but for its middle on the rotary axis.
fn outline(pen: &mut Pen, class: &str, line: &[DVec2], place: &dyn Fn(DVec2) -> DVec2) {
    let on_axis = |p: &DVec2| p.y.abs() < ON_AXIS;
    let first = (0..line.len()).find(|n| on_axis(&line[*n]) && !on_axis(&line[(n + 1) % line.len()]));
    let Some(first) = first else {
        return pen.area(class, &line.iter().copied().map(place).collect::<Vec<_>>());
    };
    let mut edge = Vec::new();
    for n in 0..=line.len() {
        let p = line[(first + n) % line.len()];
        edge.push(place(p));
        if n > 0 && on_axis(&p) {
            break;
        }
    }
    pen.line(class, &edge);
}

/// The insert where it is at the moment, to scale.
pub(super) fn insert(pen: &mut Pen, subject: &Subject<'_>, frame: &Frame) {
    let (Some(turned), Some((_, tip))) = (&subject.shot.turned, subject.shot.tool) else { return };
    let tip = flat(tip, subject.view);
    if !frame.paper().grown(1.0).holds(frame.camera.place(tip)) {
        return;
    }
    let points: Vec<DVec2> = frame.window.clip(&turned.insert.iter().map(|p| *p + tip).collect::<Vec<_>>());
    let points: Vec<DVec2> = points.into_iter().map(|p| frame.camera.place(p)).collect();
    pen.area("t", &points);
    let (low, high) =
        points.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(*p), high.max(*p)));
    if low.x < high.x {
        pen.blocked.push(Rect { min: low, max: high });
    }
}

/// The part on a rotary table cut open, what it will be, and its axis.
pub(super) fn across(pen: &mut Pen, subject: &Subject<'_>, frame: &Frame) {
    let Some(round) = &subject.shot.round else { return };
    let placed = |line: &Vec<DVec2>| line.iter().map(|p| frame.camera.place(*p)).collect::<Vec<_>>();
    let lines: Vec<Vec<DVec2>> = round.left.iter().map(placed).collect();
    let data: String = lines.iter().map(|line| Pen::data(line, true)).collect();
    pen.path("m", &data);
    pen.hatch(&lines);
    let middle = frame.camera.place(DVec2::ZERO);
    pen.circle("v", middle, round.radius * frame.camera.scale);
    for line in round.finished.iter().map(placed) {
        pen.area("x", &line);
    }
    for line in &lines {
        pen.area("o", line);
    }
    for arm in [DVec2::X, DVec2::Y].map(|axis| axis * 9.0) {
        pen.line("x", &[middle - arm, middle + arm]);
    }
}
