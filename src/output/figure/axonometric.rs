//! The view in three dimensions: the workpiece as far as it is below the working plane, and the axes before and after the
//! plane was tilted.
//!
//! Invariant: parallel lines stay parallel, and all lengths along one direction are shortened alike.
use glam::{DVec2, DVec3};

use super::pen::{ARROW, Pen};
use super::shot::{BOTTOM, CORNERS, Shot, TOP, number, point};
use crate::base::expr::{atan2d, cosd, sind};
use crate::engine::geometry::RotaryAxis;
use crate::spec::Along;

/// How far the reader stands to the left of the secondary axis, and how high above the working plane, degrees.
const ASIDE: f64 = 35.0;
const ABOVE: f64 = 25.0;
/// How long axes are, as a part of the longest edge of the workpiece.
const AXES: f64 = 0.62;
/// Where the arc of an angle crosses them.
const ARC: f64 = 0.75;
/// An arc is drawn by chords over so many degrees.
const CHORD: f64 = 3.0;
/// What is nearer to the plane lies in it, mm.
const NEAR: f64 = 1e-9;

/// The axes of a system in the order of [`Along`].
const UNITS: [DVec3; 3] = [DVec3::X, DVec3::Y, DVec3::Z];

const fn index(axis: Along) -> usize {
    match axis {
        Along::Main => 0,
        Along::Minor => 1,
        Along::Tool => 2,
    }
}

/// To the right, upwards and towards a reader who stands so many degrees to the left of the secondary axis, and so many
/// above the working plane.
pub(super) fn seen_from(aside: f64, above: f64) -> [DVec3; 3] {
    let right = DVec3::new(cosd(aside), sind(aside), 0.0);
    let away = DVec3::new(-sind(aside), cosd(aside), 0.0);
    [right, away * sind(above) + DVec3::Z * cosd(above), DVec3::Z * sind(above) - away * cosd(above)]
}

/// The same for the reader of a figure.
pub(super) fn directions() -> [DVec3; 3] {
    seen_from(ASIDE, ABOVE)
}

/// A place as the reader sees it.
pub(super) fn project(p: DVec3) -> DVec2 {
    let [right, up, _] = directions();
    DVec2::new(p.dot(right), p.dot(up))
}

/// The least and the greatest corner of the workpiece.
fn block(shot: &Shot) -> Option<[DVec3; 2]> {
    let [least, greatest] = CORNERS.map(|place| point(shot, place));
    Some([least?.with_z(number(shot, BOTTOM)?), greatest?.with_z(number(shot, TOP)?)])
}

/// The ends of an axis of a system.
fn end(shot: &Shot, axis: DVec3) -> DVec3 {
    let size = block(shot).map_or(DVec3::ONE, |[least, greatest]| greatest - least);
    axis * (AXES * size.max_element())
}

/// The letter of the rotary axis that turns about an axis.
pub(super) const fn letter(shot: &Shot, axis: Along) -> char {
    RotaryAxis(match axis {
        Along::Main => shot.plane.main,
        Along::Minor => shot.plane.secondary,
        Along::Tool => shot.plane.tool,
    })
    .letter()
}

/// By how much the working plane is turned about an axis, degrees; nothing if it is turned about another one, too.
pub(super) fn tilt(shot: &Shot, about: Along) -> Option<f64> {
    let (unit, from) = (UNITS[index(about)], UNITS[(index(about) + 1) % 3]);
    let to = shot.axes[(index(about) + 1) % 3];
    shot.axes[index(about)].abs_diff_eq(unit, 1e-9).then(|| atan2d(unit.cross(from).dot(to), from.dot(to)))
}

/// Places that the drawing must show.
pub(super) fn bounds(shot: &Shot) -> Vec<DVec3> {
    let mut places: Vec<DVec3> = block(shot).iter().flat_map(sides).flatten().collect();
    let origin = shot.datum.unwrap_or_default();
    places.extend(UNITS.map(|axis| end(shot, axis)));
    places.extend(shot.axes.map(|axis| origin + end(shot, axis)));
    places
}

/// The faces of a block that the reader sees.
fn sides([least, greatest]: &[DVec3; 2]) -> Vec<Vec<DVec3>> {
    let [_, _, towards] = directions();
    let face = |axis: usize| {
        let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
        let corner = |at_a: bool, at_b: bool| {
            let mut p = if towards[axis] > 0.0 { *greatest } else { *least };
            p[a] = if at_a { greatest[a] } else { least[a] };
            p[b] = if at_b { greatest[b] } else { least[b] };
            p
        };
        vec![corner(false, false), corner(true, false), corner(true, true), corner(false, true)]
    };
    (0..3).map(face).collect()
}

/// The part of a convex polygon that is not above a plane.
fn below(polygon: &[DVec3], origin: DVec3, normal: DVec3) -> Vec<DVec3> {
    let height = |p: &DVec3| (*p - origin).dot(normal);
    let mut kept = Vec::new();
    for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (from, to) = (height(a), height(b));
        if from <= NEAR {
            kept.push(*a);
        }
        if (from > NEAR) != (to > NEAR) {
            kept.push(a.lerp(*b, from / (from - to)));
        }
    }
    kept
}

/// Where a plane cuts a block: the corners in order around.
fn cut([least, greatest]: [DVec3; 2], origin: DVec3, [x, y, normal]: [DVec3; 3]) -> Vec<DVec3> {
    let mut met: Vec<DVec3> = Vec::new();
    for (axis, unit) in UNITS.into_iter().enumerate() {
        let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
        for (at_a, at_b) in [(false, false), (true, false), (true, true), (false, true)] {
            let mut from = least;
            from[a] = if at_a { greatest[a] } else { least[a] };
            from[b] = if at_b { greatest[b] } else { least[b] };
            let to = from + unit * (greatest - least)[axis];
            let [low, high] = [from, to].map(|p| (p - origin).dot(normal));
            let found = if (low > NEAR) == (high > NEAR) {
                [(low, from), (high, to)]
                    .into_iter()
                    .filter(|(height, _)| height.abs() <= NEAR)
                    .map(|(_, p)| p)
                    .collect()
            } else {
                vec![from.lerp(to, low / (low - high))]
            };
            for p in found {
                if met.iter().all(|other| other.distance(p) > NEAR) {
                    met.push(p);
                }
            }
        }
    }
    let middle = met.iter().copied().sum::<DVec3>() / met.len().max(1) as f64;
    let angle = |p: &DVec3| atan2d((*p - middle).dot(y), (*p - middle).dot(x));
    met.sort_by(|p, q| angle(p).total_cmp(&angle(q)));
    met
}

/// Draws the workpiece below the working plane, the plane, and both systems of axes; `at` puts places on the sheet.
pub(super) fn part(pen: &mut Pen, shot: &Shot, at: &dyn Fn(DVec3) -> DVec2) {
    let origin = shot.datum.unwrap_or_default();
    let normal = shot.axes[2];
    let placed = |polygon: &[DVec3]| polygon.iter().map(|p| at(*p)).collect::<Vec<_>>();
    if let Some(block) = block(shot) {
        let seen = sides(&block);
        for side in &seen {
            pen.area("v", &placed(side));
        }
        for side in &seen {
            pen.area("m o", &placed(&below(side, origin, normal)));
        }
        pen.area("t", &placed(&cut(block, origin, shot.axes)));
    }
    let middle = at(DVec3::ZERO);
    for axis in UNITS {
        pen.line("x", &[middle, at(end(shot, axis))]);
    }
    let place = at(origin);
    for tip in shot.axes.map(|axis| at(origin + end(shot, axis))) {
        pen.line("a", &[place, tip]);
        pen.arrow("aa", tip, tip - place);
    }
    pen.datum(place, 4.0);
}

/// Writes the letters of the axes where they are free: those of the system before, and those of the tilted plane.
pub(super) fn letters(pen: &mut Pen, shot: &Shot, at: &dyn Fn(DVec3) -> DVec2) {
    let origin = shot.datum.unwrap_or_default();
    for (n, along) in [Along::Main, Along::Minor, Along::Tool].into_iter().enumerate() {
        let letter = shot.letter(along);
        let mut ends = vec![(DVec3::ZERO, UNITS[n], letter.to_string())];
        if !shot.axes[n].abs_diff_eq(UNITS[n], 1e-9) {
            ends.push((origin, shot.axes[n], format!("{letter}\u{2032}")));
        }
        for (from, axis, text) in ends {
            let (from, tip) = (at(from), at(from + end(shot, axis)));
            let way = (tip - from).normalize_or(DVec2::X);
            let near = [9.0, 14.0].map(|off| tip + way * off);
            let beside = [10.0, -10.0, 16.0, -16.0].map(|off| tip + way.perp() * off);
            let place = pen.place(&text, &[near, [beside[0], beside[1]], [beside[2], beside[3]]].concat());
            pen.text("l", &text, place);
        }
    }
}

/// Draws the angle by which the plane is turned about an axis, with its label.
pub(super) fn angle(
    pen: &mut Pen,
    shot: &Shot,
    about: Along,
    [from, to]: [f64; 2],
    label: &str,
    at: &dyn Fn(DVec3) -> DVec2,
) {
    let unit = UNITS[index(about)];
    // The tool axis leans; about itself it turns the main axis.
    let arm = end(shot, if about == Along::Tool { DVec3::X } else { DVec3::Z }) * ARC;
    let origin = shot.datum.unwrap_or_default();
    let place = |angle: f64| at(origin + arm * cosd(angle) + unit.cross(arm) * sind(angle));
    let pieces = ((to - from).abs() / CHORD).ceil().max(2.0) as u32;
    let arc: Vec<DVec2> = (0..=pieces).map(|n| place(from + (to - from) * f64::from(n) / f64::from(pieces))).collect();
    pen.line("e", &arc);
    if let [.., before, tip] = arc.as_slice() {
        let long: f64 = arc.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        // The arrowhead leans against the arc.
        let back = place(to - (to - from) * (ARROW / long.max(ARROW)));
        pen.arrow("ea", *tip, if long > ARROW { *tip - back } else { *tip - *before });
    }
    let middle = arc[arc.len() / 2];
    let out = (middle - at(origin)).normalize_or(DVec2::NEG_Y);
    let places: Vec<DVec2> = [12.0, 18.0, -14.0, 26.0].iter().map(|off| middle + out * *off).collect();
    let place = pen.place(label, &places);
    pen.text("l", label, place);
}
