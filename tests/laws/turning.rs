//! Laws of turned shoulders: what is left is the contour with its allowance, nothing is cut below it by any part of the
//! insert, all that the insert can reach is reached, no infeed is too deep, and rapid traverse stays in the open.
//!
//! The contour is drawn here as points, from its definition; positions of the insert come from the events of a run.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::fmt::Write as _;

use ciklo::engine::run::{Event, EventKind, MoveKind};
use glam::DVec2;
use proptest::prelude::*;

use crate::turned_body::{self, Left, Ring};

/// How near the contour must be reached, and how far it may be missed, mm.
const EXACT: f64 = 1e-6;
/// What an insert cannot reach is reported from here on, mm; along a slope it may be a little more.
const REPORTED: f64 = 2e-3;
/// The distance of the points of the contour and of the positions that are looked at, mm.
const STEP: f64 = 0.1;
/// What a grid of that step sees as material that is none, mm.
const COARSE: f64 = 0.25;

/// A shoulder and how it is turned, seen by its cuts: `x` along the feed, `y` away from the part.
#[derive(Clone, Debug)]
struct Job {
    face: bool,
    inside: bool,
    /// Whether cuts go (or follow each other) towards greater Z.
    upwards: bool,
    plunges: bool,
    length: f64,
    height: f64,
    first: f64,
    wall: f64,
    corner: f64,
    elements: (u8, u8),
    size: f64,
    radius: f64,
    edges: Option<(f64, f64)>,
    oversizes: (f64, f64),
    depth: f64,
    clearance: f64,
    above: f64,
    smoothing: u8,
    operation: u8,
}

fn mm(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|value| (value * 100.0).round() / 100.0)
}

fn job() -> impl Strategy<Value = Job> {
    let how = (any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>());
    let edges = prop_oneof![Just(None), (mm(45.0..107.0), mm(35.0..70.0)).prop_map(Some)];
    let shape = (mm(15.0..50.0), mm(4.0..15.0), 0.0..1.0_f64, mm(0.0..30.0), prop_oneof![Just(0.0), mm(0.2..1.5)]);
    let ends = (0..3_u8, 0..3_u8, mm(0.2..1.0));
    let cut = (mm(0.2..1.6), edges, (mm(0.0..0.6), mm(0.0..0.3)), mm(0.6..5.0), mm(1.0..3.0), mm(0.0..3.0));
    (how, shape, ends, cut, 0..3_u8, 1..3_u8).prop_map(|(how, shape, ends, cut, smoothing, operation)| {
        let (length, height, first, wall, corner) = shape;
        let room: f64 = (length - 8.0) / height;
        let steepest = if how.3 { room.atan().to_degrees().min(75.0) } else { 10.0 };
        Job {
            face: how.0,
            inside: how.1,
            upwards: how.2,
            plunges: how.3,
            length,
            height,
            first: (first * steepest * 100.0).floor() / 100.0,
            wall,
            corner,
            elements: (ends.0, ends.1),
            size: ends.2,
            radius: cut.0,
            edges: cut.1,
            oversizes: cut.2,
            depth: cut.3,
            clearance: cut.4,
            above: cut.5,
            smoothing,
            operation,
        }
    })
}

impl Job {
    /// The diameter and the coordinate on the axis of a point as cuts see it, which has its origin where the contour
    /// begins.
    fn programmed(&self, at: DVec2) -> (f64, f64) {
        let (ahead, away) = self.signs();
        let start = if self.face {
            // Towards the axis there must be room for the contour.
            DVec2::new(if ahead < 0.0 { 70.0 } else { 15.0 }, -7.0)
        } else {
            DVec2::new(-7.0, if away > 0.0 { 60.0 } else { 20.0 })
        };
        let (x, y) = (start.x + at.x * ahead, start.y + at.y * away);
        if self.face { (2.0 * x, y) } else { (2.0 * y, x) }
    }

    /// The signs of the machine's coordinates along the feed and away from the part.
    fn signs(&self) -> (f64, f64) {
        let (out, along) = (if self.inside { -1.0 } else { 1.0 }, if self.upwards { 1.0 } else { -1.0 });
        if self.face { (-out, -along) } else { (along, out) }
    }

    fn seen(&self, radius: f64, z: f64) -> DVec2 {
        let (ahead, away) = self.signs();
        let (diameter, from) = self.programmed(DVec2::ZERO);
        let (dr, dz) = (radius - diameter / 2.0, z - from);
        if self.face { DVec2::new(dr * ahead, dz * away) } else { DVec2::new(dz * ahead, dr * away) }
    }

    /// The corners of the contour with what becomes of them: 0 nothing, 1 a chamfer, 2 a rounding, and how large it is.
    fn corners(&self) -> Vec<(DVec2, u8, f64)> {
        let end = DVec2::new(self.length, -self.height);
        let outer = DVec2::new(end.x + self.wall.to_radians().tan() * self.height, 0.0);
        let (first, tan) = (self.elements.0, self.first.to_radians().tan());
        let round = if self.corner > 0.0 { 2 } else { 0 };
        let mut corners = if self.plunges {
            let foot = DVec2::new(tan * self.height, end.y);
            vec![(DVec2::new(-50.0, 0.0), 0, 0.0), (DVec2::ZERO, first, self.size), (foot, round, self.corner)]
        } else {
            let near = DVec2::new(0.0, end.y - tan * self.length);
            vec![(near - DVec2::new(0.0, 50.0), 0, 0.0), (near, first, self.size)]
        };
        corners.extend([(end, round, self.corner), (outer, self.elements.1, self.size)]);
        corners.push((outer + DVec2::new(50.0, 0.0), 0, 0.0));
        corners
    }

    /// Points of the contour, and whether the nose comes to them: not to sharp corners inside.
    fn contour(&self) -> Vec<(DVec2, bool)> {
        let corners = self.corners();
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
            let count = (from.distance(to) / STEP).ceil().max(1.0);
            points.extend((0..=count as u32).map(|n| from.lerp(to, f64::from(n) / count)));
        }
        // The nose leaves a fillet as far from a sharp corner as its tangents are long.
        let far = 8.0 * self.radius;
        let whole = |at: &DVec2| sharp.iter().all(|corner| corner.distance(*at) > far);
        points.into_iter().map(|at| (at, whole(&at))).collect()
    }

    /// How far a point is from the insert whose nose has its centre there, less the radius of the nose.
    fn distance(&self, centre: DVec2, point: DVec2) -> f64 {
        let way = point - centre;
        let Some((angle, tip)) = self.edges else { return way.length() - self.radius };
        let (a, b) = (angle.to_radians(), (angle + tip).to_radians());
        // The edges of a tool that cuts towards the chuck outside; across the axis the same tool cuts inwards.
        let seen = |angle: f64| {
            let (z, r) = (-angle.cos(), angle.sin());
            if self.face { DVec2::new(-r, z) } else { DVec2::new(-z, r) }
        };
        let (a, b) = (seen(a), seen(b));
        let (over_a, over_b) = (way.perp_dot(b) / a.perp_dot(b), way.perp_dot(a) / b.perp_dot(a));
        if over_a >= 0.0 && over_b >= 0.0 {
            return -self.radius;
        }
        let to_ray = |ray: DVec2| (way - ray * way.dot(ray).max(0.0)).length();
        to_ray(a).min(to_ray(b)) - self.radius
    }

    fn program(&self) -> String {
        self.program_of(&[self.length], false)
    }

    /// The same for contours of these lengths one after the other; `updated` if the blank is one that turning updates.
    fn program_of(&self, lengths: &[f64], updated: bool) -> String {
        let (x, z) = self.programmed(DVec2::new(-2.0, self.above));
        let mut text = "TOOL CALL 1 Z\nFUNCTION MODE TURN\nFUNCTION TURNDATA SPIN VCONST:OFF S500\n".to_owned();
        let (block, subprogram) = self.ring().updated(updated);
        text += block;
        let _ = writeln!(text, "L X{x:+} Z{z:+} R0 FMAX M303");
        for length in lengths {
            text += &self.call(*length);
        }
        text + "M30\n" + &subprogram
    }

    fn call(&self, length: f64) -> String {
        let number = match (self.face, self.plunges) {
            (false, false) => 812,
            (false, true) => 814,
            (true, false) => 822,
            (true, true) => 824,
        };
        let (start_d, start_z) = self.programmed(DVec2::ZERO);
        let (end_d, end_z) = self.programmed(DVec2::new(length, -self.height));
        let values: [(u16, f64); 19] = [
            (215, f64::from(self.operation)),
            (460, self.clearance),
            (491, start_d),
            (492, start_z),
            (493, end_d),
            (494, end_z),
            (495, self.first),
            (501, f64::from(self.elements.0)),
            (502, self.size),
            (500, self.corner),
            (496, self.wall),
            (503, f64::from(self.elements.1)),
            (504, self.size),
            (463, self.depth),
            (478, 300.0),
            (483, self.oversizes.0),
            (484, self.oversizes.1),
            (505, 100.0),
            (506, f64::from(self.smoothing)),
        ];
        let mut text = format!("CYCL DEF {number}\n");
        for (q, value) in values {
            let _ = writeln!(text, "Q{q}={value:+}");
        }
        text + "CYCL CALL\n"
    }

    fn run(&self) -> Result<(Vec<Event>, Option<Left>), TestCaseError> {
        self.run_program(&self.program())
    }

    /// Across the axis some inserts are beside their nose in what is not turned yet, and one that leans forward comes to the
    /// blank in front of which it is with its edge.
    fn fits(&self) -> bool {
        self.edges.is_none_or(|(angle, tip)| {
            let (front, back) = if self.face { (270.0 - angle - tip, 270.0 - angle) } else { (angle, angle + tip) };
            back <= 180.0 && (front >= 90.0 || self.depth < 2.0 * front.to_radians().tan())
        })
    }

    /// How far the edge in front is behind the nose as high above it as an infeed is deep, mm.
    fn lean(&self) -> f64 {
        let front = self.edges.map_or(90.0, |(angle, tip)| if self.face { 270.0 - angle - tip } else { angle });
        (self.depth + self.radius) * (front - 90.0).max(0.0).to_radians().tan()
    }

    fn run_program(&self, program: &str) -> Result<(Vec<Event>, Option<Left>), TestCaseError> {
        let (angle, tip) = self.edges.unwrap_or_default();
        let (x, z) = self.programmed(DVec2::new(-2.0, self.above));
        let text = format!(
            "scene: 1\ntools: [{{T: 1, L: 80, R: 0, RS: {}, T-ANGLE: {angle}, P-ANGLE: {tip}}}]\nstart: [{}, 0, {z}]\n",
            self.radius,
            x / 2.0,
        );
        turned_body::run(program, &text, Some(self.ring()))
    }

    /// Where the blank begins as cuts see it: in front of the contour only where that goes down into it.
    fn begins(&self) -> f64 {
        if self.plunges { -10.0 } else { 0.0 }
    }

    /// The blank: up to where the contour begins.
    fn ring(&self) -> Ring {
        let ends = [DVec2::new(self.begins(), 0.0), DVec2::new(self.length + 40.0, -self.height - 4.0)];
        let [a, b] = ends.map(|at| {
            let (diameter, z) = self.programmed(at);
            DVec2::new(z, diameter / 2.0)
        });
        let (low, high) = (a.min(b), a.max(b));
        // Towards the axis it goes on to it.
        let outwards = if self.face { self.signs().0 > 0.0 } else { self.inside };
        Ring { z: [low.x, high.x], radii: [if outwards { low.y } else { 0.0 }, high.y] }
    }

    /// A point as cuts see it, as the place on the rotary axis and the radius.
    fn in_half_plane(&self, at: DVec2) -> DVec2 {
        let (diameter, z) = self.programmed(at);
        DVec2::new(z, diameter / 2.0)
    }

    /// What is left is never below the contour with its allowance, and above it there is only what roughing leaves.
    fn leaves(&self, body: &Left, left: bool, contour: &[(DVec2, bool)]) -> Result<(), TestCaseError> {
        body.is_sound(self.operation == 1, &self.program())?;
        let by = if self.operation == 1 { self.allowance() } else { DVec2::ZERO };
        // Points of roundings are up to so much inside of them.
        let chord = 1.5 * (1.0 - (std::f64::consts::FRAC_PI_2 / 80.0).cos());
        for pair in contour.windows(2) {
            let ((from, first), (to, second)) = (pair[0], pair[1]);
            let way = (to - from).normalize_or_zero();
            if from.distance(to) < 1e-3 || from.x < self.begins() + 0.01 {
                continue;
            }
            let (at, out) = (from.midpoint(to), way.perp());
            let side = DVec2::new(if out.x.abs() > 1e-9 { by.x * out.x.signum() } else { 0.0 }, by.y);
            let below = self.in_half_plane(at + side - out * (chord + EXACT));
            if self.ring().has(below, 0.01) && at.x > self.begins() + 0.01 {
                prop_assert!(body.has(below), "nothing is left at {} seen {}\n{}", below, at, self.program());
            }
            if left || !(first && second) {
                continue;
            }
            let most = match self.operation {
                1 if self.smoothing != 1 || by != DVec2::ZERO => {
                    // What a level leaves that ends a little above, with the rounding of the nose; in front of a wall that is
                    // as far as the edge in front leans away from it.
                    let over = contour.iter().filter(|(other, _)| (other.x - at.x).abs() < by.x + STEP + self.lean());
                    let highest = over.map(|(other, _)| other.y).fold(at.y, f64::max);
                    DVec2::new(at.x, highest + by.y + self.depth + self.radius + EXACT)
                }
                _ => at + side + out * (chord + if self.edges.is_some() { REPORTED } else { EXACT }),
            };
            let above = self.in_half_plane(most);
            prop_assert!(!body.has(above), "{} is left over, seen {}\n{}", above, at, self.program());
        }
        Ok(())
    }

    /// Allowances along the feed and away from the part.
    fn allowance(&self) -> DVec2 {
        let (across, along) = (self.oversizes.0 / 2.0, self.oversizes.1);
        if self.face { DVec2::new(across, along) } else { DVec2::new(along, across) }
    }
}

/// A move of the centre of the nose.
struct Moved {
    rapid: bool,
    step: String,
    arc: Option<DVec2>,
    places: Vec<DVec2>,
}

impl Job {
    fn moves(&self, events: &[Event]) -> Vec<Moved> {
        let mut moves = Vec::new();
        for event in events {
            let EventKind::Move { kind, path, .. } = &event.kind else { continue };
            let Some((_, Some(step))) = &event.at.cycle else { continue };
            let tip = DVec2::new(-self.radius, self.radius);
            let centre = |share: f64| {
                let at = path.at(share);
                self.seen(at.x, at.z) + tip
            };
            let count = (path.length() / STEP).ceil().max(1.0);
            let places = (0..=count as u32).map(|n| centre(f64::from(n) / count)).collect();
            let arc = match kind {
                MoveKind::Arc { centre, .. } => Some(self.seen(centre.x, centre.z) + tip),
                _ => None,
            };
            let rapid = *kind == MoveKind::Rapid;
            moves.push(Moved { rapid, step: step.to_string(), arc, places });
        }
        moves
    }
}

impl Moved {
    /// The least distance of a point from the way.
    fn distance(&self, point: DVec2) -> f64 {
        let near = |(a, b): (DVec2, DVec2)| {
            let way = b - a;
            let share = ((point - a).dot(way) / way.length_squared()).clamp(0.0, 1.0);
            point.distance(a.lerp(b, if share.is_nan() { 0.0 } else { share }))
        };
        if let (Some(centre), [first, .., last]) = (self.arc, self.places.as_slice()) {
            let (a, b, way) = (*first - centre, *last - centre, point - centre);
            let sense = a.perp_dot(b).signum();
            if a.perp_dot(way) * sense >= 0.0 && way.perp_dot(b) * sense >= 0.0 {
                return (way.length() - a.length()).abs();
            }
            return point.distance(*first).min(point.distance(*last));
        }
        let pairs = self.places.windows(2).filter_map(|pair| pair.first().copied().zip(pair.get(1).copied()));
        pairs.map(near).fold(f64::INFINITY, f64::min)
    }
}

/// The blank over a grid: up to where the cycle began, in front of the contour only where that goes down into it.
struct Blank {
    heights: Vec<f64>,
    from: f64,
}

impl Blank {
    fn new(job: &Job) -> Self {
        let (from, count) = (-20.0, 1200);
        let begins = if job.plunges { -10.0 } else { 0.0 };
        let solid = |n: u32| if from + f64::from(n) * STEP < begins { f64::NEG_INFINITY } else { 0.0 };
        Self { heights: (0..count).map(solid).collect(), from }
    }

    /// By how much a nose at a place is in the material at the most; what it covers is taken away if asked for.
    fn meets(&mut self, centre: DVec2, radius: f64, cuts: bool) -> f64 {
        let first = ((centre.x - radius - self.from) / STEP).ceil().max(0.0) as usize;
        let last = ((centre.x + radius - self.from) / STEP).floor().max(0.0) as usize;
        let mut deepest: f64 = 0.0;
        for (n, height) in self.heights.iter_mut().enumerate().take(last + 1).skip(first) {
            let off = self.from + n as f64 * STEP - centre.x;
            let low = centre.y - (radius * radius - off * off).max(0.0).sqrt();
            // What is steep at the side of the nose says nothing on a grid.
            if off.abs() < radius - STEP {
                deepest = deepest.max(*height - low);
            }
            if cuts {
                *height = height.min(low);
            }
        }
        deepest
    }
}

laws! {
    #![proptest_config(crate::cases::config(50))]

    #[test]
    fn shoulders_keep_their_profile(job in job()) {
        let (events, body) = job.run()?;
        let (moves, contour) = (job.moves(&events), job.contour());
        let by = if job.operation == 1 { job.allowance() } else { DVec2::ZERO };
        // Nothing of the insert is below the contour with its allowance.
        for moved in &moves {
            for centre in moved.places.iter().step_by(if moved.rapid { 4 } else { 2 }) {
                for (point, _) in &contour {
                    for side in [-1.0, 1.0] {
                        let wanted = *point + by * DVec2::new(side, 1.0);
                        let apart = job.distance(*centre, wanted);
                        prop_assert!(
                            apart > -EXACT, "{} in the part at {} in {}\n{}", -apart, wanted, moved.step, job.program()
                        );
                    }
                }
            }
        }
        // Where the insert can come it comes, whatever is said not to be reached.
        let left = events.iter().any(|event| matches!(&event.kind, EventKind::Message { .. }));
        if let (Some(body), true) = (&body, job.fits()) {
            job.leaves(body, left, &contour)?;
        }
        let along = |moved: &&Moved| moved.step.contains("finish") || moved.step.contains("smooth");
        let whole: Vec<&Moved> = moves.iter().filter(|moved| !moved.rapid).filter(along).collect();
        if !left && (job.operation == 2 || job.smoothing == 1 && by == DVec2::ZERO) {
            for (point, _) in contour.iter().filter(|(_, whole)| *whole) {
                let apart = whole.iter().map(|moved| moved.distance(*point)).fold(f64::INFINITY, f64::min) - job.radius;
                let most = if job.edges.is_some() { REPORTED } else { EXACT };
                prop_assert!(apart < most, "{} left at {}\n{}", apart, point, job.program());
            }
        }
        // No infeed is deeper than wanted.
        let cuts = moves.iter().filter(|moved| moved.step.starts_with("cut-") && !moved.rapid);
        let mut level = job.above.max(0.0) + job.radius;
        for height in cuts.filter_map(|moved| Some((moved.places.first()?.y, moved.places.last()?.y))) {
            if (height.0 - height.1).abs() < EXACT && height.0 < level {
                prop_assert!(level - height.0 < job.depth + EXACT, "{} after {}\n{}", height.0, level, job.program());
                level = height.0;
            }
        }
        // Rapid traverse stays in the open.
        if job.operation == 1 {
            let mut blank = Blank::new(&job);
            for moved in &moves {
                for centre in &moved.places {
                    let deep = blank.meets(*centre, job.radius, !moved.rapid);
                    prop_assert!(
                        !moved.rapid || deep < COARSE, "rapid {} deep at {} in {}\n{}", deep, centre, moved.step, job.program()
                    );
                }
            }
        }
    }
}

/// How far tools go at a feed in cuts along a level, mm, and how many such cuts there are, in each call of a cycle.
fn cuts_in(events: &[Event]) -> Vec<(f64, usize)> {
    let mut found = vec![(0.0, 0)];
    for event in events {
        match &event.kind {
            EventKind::Move { kind: MoveKind::Feed, path, .. } => {
                let step = event.at.cycle.as_ref().and_then(|(_, step)| step.as_deref());
                if let (Some(last), true) = (found.last_mut(), step.is_some_and(|step| step.starts_with("cut-"))) {
                    *last = (last.0 + path.length(), last.1 + 1);
                }
            }
            EventKind::Move { .. } if event.at.cycle.is_none() => found.push((0.0, 0)),
            _ => {}
        }
    }
    found
}

laws! {
    #![proptest_config(crate::cases::config(20))]

    /// A blank that turning updates: the part is the same as without it, with fewer cuts in air; what was roughed already is
    /// not cut again.
    #[test]
    fn updated_blanks_leave_the_same_part(job in job(), half in 0.4..0.7_f64) {
        let mut job = Job { operation: 1, above: 0.0, ..job };
        if !job.fits() {
            job.edges = None;
        }
        // Steps stay at the levels, of which the lowest must not be in front of the blank: that of an element at the
        // beginning, or of a surface that goes down there.
        if job.smoothing == 2 {
            job.elements.0 = 0;
            job.first = if job.plunges { job.first } else { 0.0 };
        }
        // A flank needs its length; steps that a first call leaves on it are cut at other levels by a second one.
        let first = if job.plunges { job.length } else { (job.length * half * 100.0).round() / 100.0 };
        let lengths = if job.plunges && job.smoothing == 2 { vec![job.length] } else { vec![first, job.length] };
        let programs = [false, true].map(|updated| job.program_of(&lengths, updated));
        let (plain, whole) = job.run_program(&programs[0])?;
        let (sparing, left) = job.run_program(&programs[1])?;
        let (Some(whole), Some(left)) = (whole, left) else { return Err(TestCaseError::fail("no stock")) };
        left.is_sound(true, &programs[1])?;
        let apart = (whole.volume() - left.volume()).abs();
        prop_assert!(apart < 1e-2, "{} mm³ apart of {}\n{}", apart, whole.volume(), programs[1]);
        let sum = |events: &[Event]| cuts_in(events).iter().fold((0.0, 0), |all, own| (all.0 + own.0, all.1 + own.1));
        let (before, after) = (sum(&plain), sum(&sparing));
        prop_assert!(after.0 < before.0 + EXACT, "{:?} instead of {:?}\n{}", after, before, programs[1]);
        // What is left is that of the shorter contour: the second call does not cut it again.
        if job.plunges && job.smoothing < 2 && job.oversizes == (0.0, 0.0) {
            prop_assert!(after.1 * 2 <= before.1, "{:?} instead of {:?}\n{}", after, before, programs[1]);
        }
    }
}

laws! {
    #![proptest_config(crate::cases::config(40))]

    /// With a constant cutting speed the speed of the workpiece follows the diameter up to its limit, and feeds per
    /// revolution take as long as the sum over short pieces of the way says.
    #[test]
    fn feeds_per_revolution_follow_the_diameter(
        cutting in mm(40.0..300.0), limit in mm(300.0..4000.0), feed in mm(0.05..0.5),
        from in mm(2.0..200.0), to in mm(2.0..200.0), along in mm(0.0..60.0),
    ) {
        const PIECES: u32 = 20_000;
        let program = format!(
            "TOOL CALL 1 Z\nFUNCTION MODE TURN\nFUNCTION TURNDATA SPIN VCONST:ON VC:{cutting} SMAX:{limit}\nM136\n\
             L X{from:+} Z+0 R0 FMAX M303\nL X{to:+} Z{:+} F{feed}\n", -along
        );
        let (events, _) = turned_body::run(&program, "scene: 1\ntools: [{T: 1, L: 80, R: 0, RS: 0.4}]\n", None)?;
        let last = events.iter().rev().find_map(|event| match &event.kind {
            EventKind::Move { kind: MoveKind::Feed, feed, turned: Some(turned), .. } => Some((*feed, *turned)),
            _ => None,
        });
        let Some((mean, turned)) = last else { return Ok(()) };
        let speed = |diameter: f64| (1000.0 * cutting / (std::f64::consts::PI * diameter)).min(limit);
        prop_assert!((turned.diameter - to).abs() < EXACT && (turned.speed - speed(to)).abs() < EXACT * limit, "{:?}", turned);
        let length = ((to - from) / 2.0).hypot(along);
        let at = |piece: u32| from + (to - from) * (f64::from(piece) + 0.5) / f64::from(PIECES);
        let time: f64 = (0..PIECES).map(|piece| length / f64::from(PIECES) / (feed * speed(at(piece)))).sum();
        prop_assert!((length / mean / time - 1.0).abs() < EXACT, "{} instead of {}\n{}", mean, length / time, program);
    }
}

/// The tool begins as high as the surface, on which an allowance stays: it goes back over that, and not through it.
#[test]
fn the_way_back_goes_over_the_allowance_of_the_surface() {
    let program = "TOOL CALL 1 Z\nFUNCTION MODE TURN\nFUNCTION TURNDATA SPIN VCONST:OFF S500\nL X+120 Z-5 R0 FMAX M303\n\
        CYCL DEF 814 Q215=+1 Q460=+1 Q491=+120 Q492=-7 Q493=+112 Q494=-22 Q495=+0 Q501=+0 Q502=+0.2 Q500=+0 Q496=+0 Q503=+0 \
        Q504=+0.2 Q463=+0.6 Q478=+300 Q483=+0.55 Q484=+0 Q505=+100 Q506=+1\nCYCL CALL\nM30\n";
    let scene = "scene: 1\ntools: [{T: 1, L: 80, R: 0, RS: 1.33}]\nstart: [60, 0, -5]\n";
    // The blank is as high as the allowance in front of the contour.
    let ring = Ring { z: [-40.0, -6.0], radii: [0.0, 60.275] };
    let (events, body) = turned_body::run(program, scene, Some(ring)).expect("it runs");
    let rapid_back = events.iter().any(|event| {
        matches!(&event.at.cycle, Some((_, Some(step))) if step.starts_with("rapid-to-starting-point"))
            && matches!(&event.kind, EventKind::Move { path, .. } if (path.at(1.0).x - 61.0).abs() < EXACT)
    });
    assert!(rapid_back, "over the surface with the clearance of 1");
    let body = body.expect("a stock");
    assert!(body.has(DVec2::new(-6.9, 60.27)), "the allowance on the surface is whole");
}

/// The floor is narrower than the insert leans: cuts end at the wall in front of what the edge leaves above, and the tool
/// comes out along that edge. What a first call has left a second one does not cut again.
#[test]
fn an_insert_that_leans_back_comes_out_of_a_narrow_valley() {
    for depth in [0.6, 4.4] {
        let job = Job {
            face: true,
            inside: false,
            upwards: false,
            plunges: true,
            length: 34.77,
            height: 8.76,
            first: 0.0,
            wall: 0.0,
            corner: 0.0,
            elements: (0, 0),
            size: 0.2,
            radius: 1.13,
            edges: Some((104.86, 35.0)),
            oversizes: (0.0, 0.0),
            depth,
            clearance: 1.0,
            above: 0.0,
            smoothing: 1,
            operation: 1,
        };
        for updated in [false, true] {
            let program = job.program_of(&[job.length, job.length], updated);
            let (events, body) = job.run_program(&program).expect("it runs");
            body.expect("a stock").is_sound(true, &program).unwrap_or_else(|wrong| panic!("{wrong}"));
            if updated {
                // Of the second call only the way along the contour is left: down, along the slope and the floor, up the
                // wall, and away from it.
                let second = events.iter().filter(|event| event.at.cycle.is_some() && event.at.line > 40);
                let cuts = second.filter(|event| matches!(event.kind, EventKind::Move { kind: MoveKind::Feed, .. }));
                assert_eq!(cuts.count(), 5);
            }
        }
    }
}
