//! Laws of recessed grooves: nothing is cut below the contour with its allowance by any part of the insert, all that the
//! insert can reach is reached, what roughing leaves is bounded, no cut is too deep, and rapid traverse stays where
//! nothing is left.
//!
//! The groove is drawn here as points, from its definition; the insert is a rectangle with two rounded corners, placed
//! where the events of a run say.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::fmt::Write as _;

use ciklo::engine::region::groove::CuttingEdge;
use ciklo::engine::region::insert_envelope::{Allowance, Envelope};
use ciklo::engine::region::{Edge, Way};
use ciklo::engine::run::{Event, EventKind, MoveKind};
use glam::DVec2;
use proptest::prelude::*;

use crate::turned_body::{self, Left, Ring};

/// How near the contour must be reached, and how far it may be missed, mm.
const EXACT: f64 = 1e-6;
/// The distance of the points of the contour and of the positions that are looked at, mm.
const STEP: f64 = 0.1;
/// How deep rapid traverse may seem to be in material on a grid of that step, mm.
const COARSE: f64 = 0.05;
/// Recesses beside each other are so many cutting widths apart.
const APART: f64 = 0.8;

/// How the groove is described.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    /// From where the tool is.
    Simple,
    /// With flanks and elements.
    Extended,
    /// As a subprogram.
    Contour,
}

/// A groove and how it is recessed, seen by its cuts: `x` across the groove, `y` away from the part.
#[derive(Clone, Debug)]
struct Job {
    form: Form,
    axial: bool,
    /// Whether it is turned lengthwise between recesses.
    turned: bool,
    /// The signs of the machine's coordinates across the groove and away from the part.
    signs: (f64, f64),
    floor: f64,
    height: f64,
    flanks: (f64, f64),
    corner: f64,
    elements: (u8, u8),
    size: f64,
    width: f64,
    radius: f64,
    oversizes: (f64, f64),
    depth: f64,
    one_way: bool,
    shorter: f64,
    compensation: f64,
    clearance: f64,
    above: f64,
    operation: u8,
}

fn mm(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|value| (value * 100.0).round() / 100.0)
}

fn job() -> impl Strategy<Value = Job> {
    let form = prop_oneof![Just(Form::Simple), Just(Form::Extended), Just(Form::Contour)];
    let sign = || prop_oneof![Just(-1.0), Just(1.0)];
    let how = (form, any::<bool>(), any::<bool>(), (sign(), sign()));
    let flank = || prop_oneof![Just(0.0), mm(0.5..30.0)];
    let corner = prop_oneof![Just(0.0), mm(0.2..1.5)];
    let shape = ((0.0..1.0_f64), mm(2.0..12.0), (flank(), flank()), corner, (0..3_u8, 0..3_u8), mm(0.2..1.0));
    let insert = (mm(2.0..6.0), 0.0..1.0_f64, (mm(0.0..0.6), mm(0.0..0.3)));
    let cut = (mm(0.6..5.0), any::<bool>(), 0.0..1.0_f64, mm(0.0..0.05), mm(0.0..3.0), mm(0.0..3.0), 0..4_u8);
    (how, shape, insert, cut).prop_map(|(how, shape, insert, cut)| {
        let (form, axial, turned, signs) = how;
        let (wider, height, flanks, corner, elements, size) = shape;
        let (width, round, oversizes) = insert;
        let (depth, one_way, shorter, compensation, clearance, above, operation) = cut;
        let along = if axial { oversizes.0 / 2.0 } else { oversizes.1 };
        // Some inserts are exactly as wide as the floor.
        let wider = match wider {
            wider if wider < 0.15 => 0.0,
            wider if wider < 0.2 => -4e-7,
            wider => (wider * 2500.0).round() / 100.0,
        };
        let straight = if turned { 0.4 } else { 0.1 };
        let radius = (round * (width - straight) / 2.0 * 100.0).floor() / 100.0;
        let plain = form == Form::Simple;
        // On each wall there is room for what is at its two ends.
        let corner = if elements == (0, 0) { corner } else { corner.min(height - size) };
        let shorter =
            if shorter < 0.3 { 0.0 } else { (shorter * 0.8 * (width - 2.0 * radius) * 100.0).floor() / 100.0 };
        Job {
            form,
            axial,
            turned,
            signs,
            floor: width
                + 2.0 * along
                + wider
                + if plain || corner == 0.0 { 0.0 } else { 2.0 * (corner - radius).max(0.0) },
            height,
            flanks: if plain { (0.0, 0.0) } else { flanks },
            corner: if plain { 0.0 } else { corner },
            elements: if plain { (0, 0) } else { elements },
            size,
            width,
            radius,
            oversizes,
            depth,
            one_way,
            shorter,
            compensation,
            clearance,
            above: if plain { 0.0 } else { above },
            operation,
        }
    })
}

impl Job {
    /// The diameter and the coordinate on the axis of a point as cuts see it, which has its origin where the contour
    /// begins.
    fn programmed(&self, at: DVec2) -> (f64, f64) {
        let (across, away) = self.signs;
        if self.axial {
            let begin = if across < 0.0 { 80.0 } else { 15.0 };
            (2.0 * (begin + at.x * across), -7.0 + at.y * away)
        } else {
            let begin = if away > 0.0 { 60.0 } else { 20.0 };
            (2.0 * (begin + at.y * away), -7.0 + at.x * across)
        }
    }

    fn seen(&self, radius: f64, z: f64) -> DVec2 {
        let (across, away) = self.signs;
        let (diameter, from) = self.programmed(DVec2::ZERO);
        let (dr, dz) = (radius - diameter / 2.0, z - from);
        if self.axial { DVec2::new(dr * across, dz * away) } else { DVec2::new(dz * across, dr * away) }
    }

    /// The corners of the contour with what becomes of them: 0 nothing, 1 a chamfer, 2 a rounding, and how large it is.
    fn corners(&self) -> [(DVec2, u8, f64); 4] {
        let lean = |angle: f64| angle.to_radians().tan() * self.height;
        let foot = DVec2::new(lean(self.flanks.0), -self.height);
        let end = foot + DVec2::new(self.floor, 0.0);
        let round = if self.corner > 0.0 { 2 } else { 0 };
        [
            (DVec2::ZERO, self.elements.0, self.size),
            (foot, round, self.corner),
            (end, round, self.corner),
            (DVec2::new(end.x + lean(self.flanks.1), 0.0), self.elements.1, self.size),
        ]
    }

    /// Points of the contour, and whether the corners of the insert come to them: not to inside corners that are sharper.
    fn contour(&self) -> Vec<(DVec2, bool)> {
        let own = self.corners();
        let far = DVec2::new(50.0, 0.0);
        let corners: Vec<(DVec2, u8, f64)> =
            [(own[0].0 - far, 0, 0.0)].into_iter().chain(own).chain([(own[3].0 + far, 0, 0.0)]).collect();
        let mut way: Vec<DVec2> = Vec::new();
        let mut sharp: Vec<DVec2> = Vec::new();
        for around in corners.windows(3) {
            let &[(before, ..), (at, kind, size), (after, ..)] = around else { continue };
            let (back, on) = ((before - at).normalize(), (after - at).normalize());
            // Half of the angle between the two sides.
            let half = back.dot(on).clamp(-1.0, 1.0).acos() / 2.0;
            match kind {
                1 => way.extend([at + back * size, at + on * size]),
                2 => {
                    let (centre, cut) = (at + (back + on).normalize() * (size / half.sin()), size / half.tan());
                    let (from, to) = (at + back * cut - centre, at + on * cut - centre);
                    let sweep = from.angle_to(to);
                    way.extend((0..=40).map(|n| centre + DVec2::from_angle(sweep * f64::from(n) / 40.0).rotate(from)));
                }
                _ => way.push(at),
            }
            let inner = (at - before).perp_dot(after - at) > 0.0;
            if inner && (kind == 0 || kind == 2 && size < self.radius) {
                sharp.push(at);
            }
        }
        let mut points = Vec::new();
        for pair in way.windows(2) {
            let &[from, to] = pair else { continue };
            // Points between those of an arc would be beside it.
            let count = if from.distance(to) < 2.0 * STEP { 1.0 } else { (from.distance(to) / STEP).ceil() };
            points.extend((0..=count as u32).map(|n| from.lerp(to, f64::from(n) / count)));
        }
        let far = 4.0 * self.radius;
        let whole = |at: &DVec2| sharp.iter().all(|corner| corner.distance(*at) > far);
        points.into_iter().map(|at| (at, whole(&at))).collect()
    }

    /// How far a point is from the insert whose tip is at a place; negative within it.
    fn distance(&self, tip: DVec2, point: DVec2) -> f64 {
        let way = point - tip;
        let (near, far) = (DVec2::new(-self.radius, self.radius), DVec2::new(self.radius - self.width, self.radius));
        if way.y < self.radius && way.x > near.x {
            return way.distance(near) - self.radius;
        }
        if way.y < self.radius && way.x < far.x {
            return way.distance(far) - self.radius;
        }
        way.x.max(-self.width - way.x).max(-way.y)
    }

    /// The lowest place of the insert at a coordinate, if it is as wide.
    fn lowest(&self, tip: DVec2, x: f64) -> Option<f64> {
        let behind = (tip.x - x).min(x - tip.x + self.width);
        if behind < 0.0 {
            return None;
        }
        let short = (self.radius - behind).max(0.0);
        Some(tip.y + self.radius - (self.radius * self.radius - short * short).sqrt())
    }

    fn program(&self) -> String {
        let number = match self.form {
            Form::Contour => 0,
            Form::Simple => 1,
            Form::Extended => 2,
        } + if self.turned { 840 } else { 860 }
            + if self.axial { 10 } else { 0 };
        let corners = self.corners();
        let (start, end) = (self.programmed(corners[0].0), self.programmed(corners[2].0));
        let mut values: Vec<(u16, f64)> = vec![(215, f64::from(self.operation)), (460, self.clearance)];
        if self.form == Form::Extended {
            values.extend([
                (491, start.0),
                (492, start.1),
                (495, self.flanks.0),
                (501, f64::from(self.elements.0)),
                (502, self.size),
                (500, self.corner),
                (496, self.flanks.1),
                (503, f64::from(self.elements.1)),
                (504, self.size),
            ]);
        }
        if self.form == Form::Contour {
            values.extend([(479, 0.0), (480, 0.0), (482, 0.0)]);
            if self.turned && !self.axial {
                values.push((488, 0.0));
            }
        } else {
            values.extend([(493, end.0), (494, end.1)]);
        }
        let limit = if self.turned || self.one_way { self.depth } else { 0.0 };
        values.extend([(478, 300.0), (483, self.oversizes.0), (484, self.oversizes.1), (505, 100.0), (463, limit)]);
        if self.turned {
            values.extend([(507, f64::from(u8::from(self.one_way))), (508, self.shorter), (509, self.compensation)]);
        }
        let (x, z) = self.start();
        let mut text = format!(
            "TOOL CALL 1 Z\nFUNCTION MODE TURN\nFUNCTION TURNDATA SPIN VCONST:OFF S500\nL X{x:+} Z{z:+} R0 FMAX M303\n"
        );
        if self.form == Form::Contour {
            text += "CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL 2\n";
        }
        let _ = writeln!(text, "CYCL DEF {number}");
        for (q, value) in values {
            let _ = writeln!(text, "Q{q}={value:+}");
        }
        text += "CYCL CALL\n";
        if self.form == Form::Contour {
            text += "M30\nLBL 2\n";
            let far = DVec2::new(3.0, 0.0);
            let beside = |at: DVec2| (at, 0, 0.0);
            // An element at an edge needs the surface beside it.
            let before = (corners[0].1 > 0).then(|| beside(corners[0].0 - far));
            let after = (corners[3].1 > 0).then(|| beside(corners[3].0 + far));
            for (at, kind, size) in before.into_iter().chain(corners).chain(after) {
                let (x, z) = self.programmed(at);
                let _ = writeln!(text, "L X{x:+.9} Z{z:+.9}");
                let _ = match kind {
                    1 => writeln!(text, "CHF {size}"),
                    2 => writeln!(text, "RND R{size}"),
                    _ => Ok(()),
                };
            }
            text += "LBL 0\n";
        }
        text
    }

    /// Where the tool begins.
    fn start(&self) -> (f64, f64) {
        let before = if self.form == Form::Simple { 0.0 } else { -2.0 };
        self.programmed(DVec2::new(before, self.above))
    }

    fn run(&self) -> Result<(Vec<Event>, Option<Left>), TestCaseError> {
        let (x, z) = self.start();
        let text = format!(
            "scene: 1\ntools: [{{T: 1, L: 80, R: 0, RS: {}, CUTWIDTH: {}}}]\nstart: [{}, 0, {z}]\n",
            self.radius,
            self.width,
            x / 2.0,
        );
        turned_body::run(&self.program(), &text, Some(self.ring()))
    }

    /// A point as cuts see it, as the place on the rotary axis and the radius.
    fn in_half_plane(&self, at: DVec2) -> DVec2 {
        let (diameter, z) = self.programmed(at);
        DVec2::new(z, diameter / 2.0)
    }

    /// The blank: the groove is cut into a surface.
    fn ring(&self) -> Ring {
        let ends = [DVec2::new(-10.0, 0.0), DVec2::new(self.corners()[3].0.x + 10.0, -self.height - 4.0)];
        let [a, b] = ends.map(|at| self.in_half_plane(at));
        let (least, most) = (a.min(b), a.max(b));
        let hollow = if self.axial { self.signs.0 > 0.0 } else { self.signs.1 < 0.0 };
        Ring { z: [least.x, most.x], radii: [if hollow { least.y } else { 0.0 }, most.y] }
    }

    /// Nothing of the insert was below the contour with its allowance, and finishing has left nothing where it came.
    fn leaves(&self, body: &Left, contour: &[(DVec2, bool)]) -> Result<(), TestCaseError> {
        body.is_sound(self.operation < 2, &self.program())?;
        let by = if self.operation == 1 || self.operation == 3 { self.allowance() } else { DVec2::ZERO };
        let chord = self.size.max(self.corner) * (1.0 - (std::f64::consts::FRAC_PI_2 / 80.0).cos());
        for pair in contour.windows(2) {
            let ((from, first), (to, second)) = (pair[0], pair[1]);
            if from.distance(to) < 1e-3 || from.y.min(to.y) > -1e-3 {
                continue;
            }
            let (at, out) = (from.midpoint(to), (to - from).normalize().perp());
            let wanted = self.with(at, by);
            let below = self.in_half_plane(wanted - out * (chord + EXACT));
            if self.ring().has(below, 1e-3) {
                prop_assert!(body.has(below), "nothing is left at {} seen {}\n{}", below, at, self.program());
            }
            if first && second && self.operation != 1 && self.stays(at, by) {
                let above = self.in_half_plane(wanted + out * (chord + EXACT));
                prop_assert!(!body.has(above), "{} is left over, seen {}\n{}", above, at, self.program());
            }
        }
        Ok(())
    }

    /// Allowances across the groove and away from the part.
    fn allowance(&self) -> DVec2 {
        let (diameter, z) = (self.oversizes.0 / 2.0, self.oversizes.1);
        if self.axial { DVec2::new(diameter, z) } else { DVec2::new(z, diameter) }
    }

    /// A point of the contour as it is with an allowance, which stays on both walls and on the floor.
    fn with(&self, point: DVec2, allowance: DVec2) -> DVec2 {
        let corners = self.corners();
        let middle = corners[1].0.midpoint(corners[2].0).x;
        point + allowance * DVec2::new((middle - point.x).signum(), 1.0)
    }

    /// Whether a point of the contour is that of the contour with an allowance, too: beyond the middle of the floor, where
    /// the allowances of both walls take all that is flat of it, the other wall is higher.
    fn stays(&self, point: DVec2, allowance: DVec2) -> bool {
        let corners = self.corners();
        let middle = corners[1].0.midpoint(corners[2].0).x;
        let [before, after] = [point, self.with(point, allowance)].map(|at| at.x - middle);
        allowance.x == 0.0 || before.abs() > EXACT && before * after > 0.0
    }
}

/// A move of the tip.
struct Moved {
    rapid: bool,
    finishing: bool,
    step: String,
    arc: Option<DVec2>,
    places: Vec<DVec2>,
}

impl Job {
    fn moves(&self, events: &[Event]) -> Vec<Moved> {
        let mut moves = Vec::new();
        for event in events {
            let EventKind::Move { kind, path, feed, .. } = &event.kind else { continue };
            let Some((_, Some(step))) = &event.at.cycle else { continue };
            let place = |share: f64| {
                let at = path.at(share);
                self.seen(at.x, at.z)
            };
            let count = (path.length() / STEP).ceil().max(1.0);
            let places = (0..=count as u32).map(|n| place(f64::from(n) / count)).collect();
            let arc = match kind {
                MoveKind::Arc { centre, .. } => Some(self.seen(centre.x, centre.z)),
                _ => None,
            };
            let rapid = *kind == MoveKind::Rapid;
            let finishing = !rapid && (feed - 100.0).abs() < EXACT;
            moves.push(Moved { rapid, finishing, step: step.to_string(), arc, places });
        }
        moves
    }
}

impl Moved {
    /// The least distance of a point from the way of a point of the insert that far from the tip.
    fn distance(&self, point: DVec2, off: DVec2) -> f64 {
        let point = point - off;
        let (Some(&first), Some(&last)) = (self.places.first(), self.places.last()) else { return f64::INFINITY };
        if let Some(centre) = self.arc {
            let (a, b, way) = (first - centre, last - centre, point - centre);
            let sense = a.perp_dot(b).signum();
            if a.perp_dot(way) * sense >= 0.0 && way.perp_dot(b) * sense >= 0.0 {
                return (way.length() - a.length()).abs();
            }
            return point.distance(first).min(point.distance(last));
        }
        let way = last - first;
        let share = ((point - first).dot(way) / way.length_squared()).clamp(0.0, 1.0);
        point.distance(first.lerp(last, if share.is_nan() { 0.0 } else { share }))
    }
}

impl Job {
    /// How far a point of the contour is from what the insert passes over.
    fn left(&self, moves: &[&Moved], point: DVec2) -> f64 {
        let noses = [DVec2::new(-self.radius, self.radius), DVec2::new(self.radius - self.width, self.radius)];
        let near = |moved: &&Moved| {
            let round = noses.map(|off| moved.distance(point, off) - self.radius);
            let flat = moved.places.iter().filter_map(|tip| {
                let under = tip.x - point.x > self.radius - EXACT && point.x - tip.x + self.width > self.radius - EXACT;
                under.then_some((tip.y - point.y).abs())
            });
            flat.chain(round).fold(f64::INFINITY, f64::min)
        };
        moves.iter().map(near).fold(f64::INFINITY, f64::min)
    }
}

/// What is left over a grid: the blank is as high as the contour begins.
struct Grid {
    heights: Vec<f64>,
    from: f64,
}

impl Grid {
    fn new(job: &Job) -> Self {
        let to = job.corners()[3].0.x + 15.0;
        Self { heights: vec![0.0; ((to + 15.0) / STEP) as usize], from: -15.0 }
    }

    /// By how much an insert is in the material at the most; what it covers is taken away if asked for.
    fn meets(&mut self, job: &Job, tip: DVec2, cuts: bool) -> f64 {
        let first = ((tip.x - job.width - self.from) / STEP).ceil().max(0.0) as usize;
        let last = ((tip.x - self.from) / STEP).floor().max(0.0) as usize;
        let mut deepest: f64 = 0.0;
        for (n, height) in self.heights.iter_mut().enumerate().take(last + 1).skip(first) {
            let x = self.from + n as f64 * STEP;
            let Some(low) = job.lowest(tip, x) else { continue };
            // What is steep at the side says nothing on a grid.
            if (tip.x - x).min(x - tip.x + job.width) > 1.5 * STEP {
                deepest = deepest.max(*height - low);
            }
            if cuts {
                *height = height.min(low);
            }
        }
        deepest
    }

    /// What is left at a place.
    fn height(&self, x: f64) -> f64 {
        let at = ((x - self.from) / STEP).round().max(0.0) as usize;
        self.heights.get(at).copied().unwrap_or(0.0)
    }
}

/// What holds of every groove.
fn keeps_its_profile(job: &Job) -> Result<(), TestCaseError> {
    let (events, body) = job.run()?;
    let (moves, contour) = (job.moves(&events), job.contour());
    let reported = events.iter().any(|event| matches!(&event.kind, EventKind::Message { .. }));
    prop_assert!(!reported, "it fits\n{}", job.program());
    if let Some(body) = &body {
        job.leaves(body, &contour)?;
    }
    // Nothing of the insert is below the contour with its allowance.
    for moved in &moves {
        let by = if moved.finishing && job.operation < 3 || job.operation == 2 { DVec2::ZERO } else { job.allowance() };
        let by = if moved.rapid && job.operation == 0 { DVec2::ZERO } else { by };
        for tip in moved.places.iter().step_by(if moved.rapid { 4 } else { 2 }) {
            for (point, _) in contour.iter().filter(|(point, _)| point.y > tip.y - 1.0) {
                // An allowance on the surface beside the groove is no matter of the groove.
                let wanted = job.with(*point, by);
                let wanted = if wanted.y > EXACT { *point } else { wanted };
                let apart = job.distance(*tip, wanted);
                prop_assert!(
                    apart > -EXACT,
                    "{} in the part at {} in {}\n{}",
                    -apart,
                    wanted,
                    moved.step,
                    job.program()
                );
            }
        }
    }
    let (rough, finish): (Vec<&Moved>, Vec<&Moved>) =
        moves.iter().filter(|moved| !moved.rapid).partition(|moved| !moved.finishing);
    // The whole contour is finished, and recess turning leaves its allowance everywhere.
    let mut wanted = Vec::new();
    if job.operation != 1 {
        wanted.push((&finish, if job.operation == 3 { job.allowance() } else { DVec2::ZERO }, EXACT));
    }
    if job.operation < 2 && job.turned {
        wanted.push((&rough, job.allowance(), EXACT + job.compensation));
    }
    for (moves, by, most) in wanted {
        for (point, _) in contour.iter().filter(|(point, whole)| *whole && job.stays(*point, by)) {
            let point = job.with(*point, by);
            if point.y > EXACT {
                continue;
            }
            let apart = job.left(moves, point);
            prop_assert!(apart < most, "{} left at {}\n{}", apart, point, job.program());
        }
    }
    // Rapid traverse goes where nothing is left, and no cut is deeper than wanted.
    let mut left = Grid::new(job);
    for moved in moves.iter().filter(|_| job.operation < 2) {
        for tip in &moved.places {
            let deep = left.meets(job, *tip, !moved.rapid);
            prop_assert!(
                !moved.rapid || deep < COARSE,
                "rapid {} deep at {} in {}\n{}",
                deep,
                tip,
                moved.step,
                job.program()
            );
        }
        if job.operation == 1 && moved.step.starts_with("rough-groove") {
            let (Some(first), Some(last)) = (moved.places.first(), moved.places.last()) else { continue };
            let across = (first.y - last.y).abs() < EXACT;
            prop_assert!(across || last.y > first.y, "down in {}\n{}", moved.step, job.program());
        }
    }
    if job.operation < 2 && job.turned {
        let levels = moves.iter().filter(|moved| !moved.rapid && moved.step.starts_with("recess-"));
        let levels = levels.filter(|moved| moved.step.ends_with("depth"));
        let mut level = job.above;
        for low in levels.filter_map(|moved| moved.places.last()).map(|tip| tip.y) {
            prop_assert!(level - low < job.depth + EXACT, "{} after {}\n{}", low, level, job.program());
            level = low.min(level);
        }
    }
    // Between recesses stay the cusps of the rounded corners; a leaning flank is a flight of steps.
    if job.operation == 1 && !job.turned {
        let gap = (APART * job.width - job.width + 2.0 * job.radius).max(0.0) / 2.0;
        let cusp = job.radius - (job.radius * job.radius - gap * gap).max(0.0).sqrt();
        let (corners, by) = (job.corners(), job.allowance());
        let leans = job.flanks != (0.0, 0.0) || job.elements != (0, 0);
        let beside = by.x + job.radius.max(job.corner) + 2.0 * STEP + if leans { APART * job.width } else { 0.0 };
        let mut x = corners[1].0.x + beside;
        while x < corners[2].0.x - beside {
            let high = left.height(x) + job.height - by.y;
            prop_assert!(high < cusp + 0.01 + gap * STEP, "{} over the floor at {}\n{}", high, x, job.program());
            x += STEP;
        }
        for (point, _) in contour.iter().filter(|(point, _)| point.y < -EXACT) {
            let point = job.with(*point, by);
            if point.y < by.y - job.height + job.radius.max(job.corner) + EXACT || point.y > -EXACT {
                continue;
            }
            let deep = rough.iter().flat_map(|moved| &moved.places).filter(|tip| tip.y + job.radius <= point.y + EXACT);
            let gap = deep.map(|tip| (point.x - tip.x).max(tip.x - job.width - point.x)).fold(f64::INFINITY, f64::min);
            let most = APART * job.width + job.radius + job.size + EXACT;
            prop_assert!(gap < most, "{} left beside {}\n{}", gap, point, job.program());
        }
    }
    Ok(())
}

laws! {
    #![proptest_config(crate::cases::config(50))]

    #[test]
    fn grooves_keep_their_profile(job in job()) {
        keeps_its_profile(&job)?;
    }
}

/// The insert is as wide as the floor, or differs by less than a program shows, and there are chamfers or flanks above.
#[test]
fn an_insert_as_wide_as_the_floor_comes_down_to_it() {
    for form in [Form::Simple, Form::Extended, Form::Contour] {
        for (axial, turned, operation) in [(false, false, 0), (true, false, 1), (false, true, 0), (true, true, 1)] {
            for (elements, flanks, wider) in
                [(1, 0.0, 0.0), (0, 0.0, 4e-7), (2, 0.0, -4e-7), (1, 12.5, -4e-7), (0, 3.0, 0.0)]
            {
                let plain = form == Form::Simple;
                let (elements, flanks) = if plain { (0, 0.0) } else { (elements, flanks) };
                let job = Job {
                    form,
                    axial,
                    turned,
                    signs: (-1.0, 1.0),
                    floor: 2.0 + wider,
                    height: 3.0,
                    flanks: (flanks, flanks),
                    corner: 0.0,
                    elements: (elements, elements),
                    size: 0.2,
                    width: 2.0,
                    radius: 0.0,
                    oversizes: (0.0, 0.0),
                    depth: 0.6,
                    one_way: false,
                    shorter: 0.0,
                    compensation: 0.0,
                    clearance: 1.0,
                    above: if plain { 0.0 } else { 1.0 },
                    operation,
                };
                let (events, _) = job.run().expect("it runs");
                let lowest = job
                    .moves(&events)
                    .iter()
                    .filter(|moved| !moved.rapid && !moved.finishing)
                    .flat_map(|moved| moved.places.iter().map(|tip| tip.y).collect::<Vec<_>>())
                    .fold(f64::INFINITY, f64::min);
                assert!((lowest + job.height).abs() < EXACT, "roughs to {lowest}\n{}", job.program());
                keeps_its_profile(&job).unwrap_or_else(|wrong| panic!("{wrong}"));
            }
        }
    }
}

/// Where the tip of an insert may be over a profile without an allowance.
fn over(edge: CuttingEdge, profile: &Way) -> Envelope {
    let none = Allowance { along: 0.0, away: 0.0 };
    edge.over(profile, none, 20.0).expect("its arcs are circles")
}

#[test]
fn an_insert_stays_between_walls() {
    // A rectangular groove 10 wide and 5 deep, an insert of 4 with corners of 0.5.
    let edges = [(0.0, -5.0), (10.0, -5.0), (10.0, 0.0)].map(|(x, y)| Edge::Line(DVec2::new(x, y)));
    let profile = Way { start: DVec2::ZERO, edges: edges.to_vec() };
    let edge = CuttingEdge { width: 4.0, radius: 0.5 };
    let own = over(edge, &profile);
    assert_eq!(own.below(-5.0, [-10.0, 20.0]), vec![[4.0, 10.0]]);
    assert_eq!(own.height(2.0), Some(0.0));
    let none = Allowance { along: 0.0, away: 0.0 };
    let left = edge.leaves((&profile, none, 20.0), &own, [4.0, 10.0]).expect("lines only");
    assert!(left < 1e-9, "{left}");
}

#[test]
fn an_insert_lies_on_summits() {
    // Half of a circle of 5: an insert of 3 lies on its summit for as long as any of its edge is above that.
    let arc = Edge::Arc { to: DVec2::new(5.0, 0.0), centre: DVec2::ZERO, sweep: -180.0 };
    let profile = Way { start: DVec2::new(-5.0, 0.0), edges: vec![arc] };
    let own = over(CuttingEdge { width: 3.0, radius: 0.0 }, &profile);
    for (x, height) in [(0.0, 5.0), (1.0, 5.0), (3.0, 5.0), (6.0, 4.0)] {
        assert!(own.height(x).is_some_and(|own| (own - height).abs() < 1e-9), "{x}");
    }
}

/// An insert as wide as the groove, whose corners are rounder than the rounding of the edge beside it: the two arcs on which
/// it goes round that edge are one way, without a notch where the second one begins.
#[test]
fn a_rounded_edge_beside_an_insert_as_wide_as_the_groove_has_no_notch() {
    let job = Job {
        form: Form::Extended,
        axial: false,
        turned: true,
        signs: (-1.0, -1.0),
        floor: 3.43,
        height: 2.0,
        flanks: (0.0, 0.0),
        corner: 0.0,
        elements: (0, 2),
        size: 0.89,
        width: 3.43,
        radius: 0.91,
        oversizes: (0.0, 0.0),
        depth: 0.6,
        one_way: false,
        shorter: 0.0,
        compensation: 0.0,
        clearance: 0.0,
        above: 0.0,
        operation: 0,
    };
    keeps_its_profile(&job).unwrap_or_else(|wrong| panic!("{wrong}"));
    let (events, _) = job.run().expect("it runs");
    // Round the edge on one arc.
    let arcs = job.moves(&events).iter().filter(|moved| moved.finishing && moved.arc.is_some()).count();
    assert_eq!(arcs, 1);
}

/// A groove as wide as the insert is cut by recesses alone: neither wall is cut again.
#[test]
fn recess_turning_cuts_no_wall_of_a_groove_as_wide_as_the_insert() {
    for (axial, form) in [(false, Form::Simple), (true, Form::Simple), (false, Form::Contour), (true, Form::Extended)] {
        let job = Job {
            form,
            axial,
            turned: true,
            signs: (-1.0, 1.0),
            floor: 3.0,
            height: 5.0,
            flanks: (0.0, 0.0),
            corner: 0.0,
            elements: (0, 0),
            size: 0.2,
            width: 3.0,
            radius: 0.2,
            oversizes: (0.0, 0.0),
            depth: 2.0,
            one_way: false,
            shorter: 0.0,
            compensation: 0.0,
            clearance: 1.0,
            above: 0.0,
            operation: 1,
        };
        keeps_its_profile(&job).unwrap_or_else(|wrong| panic!("{wrong}"));
        let (events, _) = job.run().expect("it runs");
        // 5 deep in infeeds of 1.67, and nothing else at a feed.
        let cut: f64 = job
            .moves(&events)
            .iter()
            .filter(|moved| !moved.rapid)
            .map(|moved| moved.places[0].distance(moved.places[moved.places.len() - 1]))
            .sum();
        assert!((cut - job.height).abs() < EXACT, "{cut} mm at a feed\n{}", job.program());
    }
}

/// The allowances of both walls leave less of a flat floor than they take: what was flat in one half of it lies in the
/// corner of the other.
#[test]
fn allowances_of_both_walls_take_what_is_flat_of_the_floor() {
    let job = Job {
        form: Form::Extended,
        axial: false,
        turned: false,
        signs: (-1.0, -1.0),
        floor: 2.86,
        height: 2.0,
        flanks: (0.0, 0.0),
        corner: 1.14,
        elements: (0, 0),
        size: 0.2,
        width: 2.0,
        radius: 0.94,
        oversizes: (0.0, 0.23),
        depth: 0.6,
        one_way: false,
        shorter: 0.0,
        compensation: 0.0,
        clearance: 0.0,
        above: 0.0,
        operation: 3,
    };
    keeps_its_profile(&job).unwrap_or_else(|wrong| panic!("{wrong}"));
}
