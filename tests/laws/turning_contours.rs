//! Laws of turned contours (810, 820, 815): random contours of lines, chamfers and roundings, with flanks down and up,
//! grooves and overhangs, limits, and cuts along the axes or parallel to the contour. No part of the insert goes below
//! what is wanted, all that can be reached is reached, cuts are not too deep, and rapid traverse stays in the open.
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
/// The distance of the points of the contour and of the positions that are looked at, mm.
const STEP: f64 = 0.1;
/// What a grid of that step sees as material that is none, mm.
const COARSE: f64 = 0.25;

/// What becomes of a corner: nothing, a chamfer or a rounding of a size.
type Corner = (u8, f64);

/// A contour and how it is turned, seen by its cuts: `x` along the feed, `y` away from the part.
#[derive(Clone, Debug)]
struct Job {
    face: bool,
    inside: bool,
    parallel: bool,
    upwards: bool,
    reversed: bool,
    /// Steps from corner to corner with what becomes of the corner at their end.
    steps: Vec<(DVec2, Corner)>,
    radius: f64,
    edges: Option<(f64, f64)>,
    oversizes: (f64, f64),
    depth: f64,
    clearance: f64,
    above: f64,
    smoothing: u8,
    operation: u8,
    undercuts: bool,
    /// A limit: by so much before the end, above the lowest place.
    limit: Option<(f64, f64)>,
    equidistant: bool,
}

fn mm(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|value| (value * 100.0).round() / 100.0)
}

fn job() -> impl Strategy<Value = Job> {
    let how = (any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>());
    // Along; up, level, or down; a wall straight up or down in between.
    let step = prop_oneof![
        4 => (mm(4.0..14.0), mm(-4.0..5.0)).prop_map(|(x, y)| DVec2::new(x, y)),
        3 => mm(4.0..14.0).prop_map(|x| DVec2::new(x, 0.0)),
        1 => mm(2.5..5.0).prop_map(|y| DVec2::new(0.0, y)),
        1 => mm(2.5..5.0).prop_map(|y| DVec2::new(0.0, -y)),
        1 => (mm(0.2..1.5), mm(3.0..6.0)).prop_map(|(x, y)| DVec2::new(-x, y)),
    ];
    let corner = (0..3_u8, mm(0.2..1.0));
    let steps = proptest::collection::vec((step, corner), 2..7);
    let edges = prop_oneof![Just(None), (mm(45.0..107.0), mm(35.0..70.0)).prop_map(Some)];
    let cut = (mm(0.2..1.6), edges, (mm(0.0..0.6), mm(0.0..0.3)), mm(0.6..5.0), mm(1.0..3.0), mm(0.0..3.0));
    let limit = proptest::option::weighted(0.25, (mm(2.0..8.0), mm(0.5..3.0)));
    (how, steps, cut, 0..3_u8, 1..3_u8, limit).prop_map(|(how, mut steps, cut, smoothing, operation, limit)| {
        // It goes on where it begins and where it ends, and ends higher than it begins: the tool is in front of a wall.
        for (step, _) in steps.iter_mut().take(1) {
            *step = DVec2::new(step.x.max(4.0), step.y.max(0.0));
        }
        // Walls one on the other are no contour.
        for at in 1..steps.len() {
            if steps[at].0.x <= 0.0 && steps[at - 1].0.x <= 0.0 {
                steps[at].0 = DVec2::new(6.0, 0.0);
            }
        }
        let last = steps.last().map_or(DVec2::X, |(step, _)| *step);
        if last.x <= 0.0 {
            steps.push((DVec2::new(6.0, 0.0), (0, 0.0)));
        }
        let end: DVec2 = steps.iter().map(|(step, _)| *step).sum();
        steps.push((DVec2::new(0.0, (14.0 - end.y).max(4.0)), (0, 0.0)));
        // A rounding in a sharp corner takes more of its sides than its radius: no more than there is room for.
        for at in 1..steps.len() {
            let (into, (kind, size), out) = (steps[at - 1].0, steps[at - 1].1, steps[at].0);
            let turned = into.angle_to(out).abs();
            let most = 0.45 * into.length().min(out.length()) / (turned / 2.0).tan();
            if kind == 2 && size > most {
                steps[at - 1].1 = if most < 0.1 { (0, 0.0) } else { (2, (most * 100.0).floor() / 100.0) };
            }
        }
        Job {
            face: how.0,
            inside: how.1 && !how.0,
            upwards: how.2,
            parallel: how.3 && !how.0,
            reversed: how.4,
            equidistant: how.5,
            undercuts: how.6 || how.3 && !how.0,
            steps,
            radius: cut.0,
            edges: cut.1,
            oversizes: cut.2,
            depth: cut.3,
            clearance: cut.4,
            // From where the tool is follows whether it works inside.
            above: cut.5.max(0.05),
            smoothing,
            operation,
            limit: if how.3 && !how.0 { None } else { limit },
        }
    })
}

impl Job {
    /// The diameter and the coordinate on the axis of a point as cuts see it.
    fn programmed(&self, at: DVec2) -> (f64, f64) {
        let (ahead, away) = self.signs();
        let start = if self.face { DVec2::new(150.0, -7.0) } else { DVec2::new(-7.0, 150.0) };
        let (x, y) = (start.x + at.x * ahead, start.y + at.y * away);
        if self.face { (2.0 * x, y) } else { (2.0 * y, x) }
    }

    /// The signs of the machine's coordinates along the feed and away from the part.
    fn signs(&self) -> (f64, f64) {
        let along = if self.upwards { 1.0 } else { -1.0 };
        (along, if self.inside { -1.0 } else { 1.0 })
    }

    fn seen(&self, radius: f64, z: f64) -> DVec2 {
        let (ahead, away) = self.signs();
        let (diameter, from) = self.programmed(DVec2::ZERO);
        let (dr, dz) = (radius - diameter / 2.0, z - from);
        if self.face { DVec2::new(dr * ahead, dz * away) } else { DVec2::new(dz * ahead, dr * away) }
    }

    fn corners(&self) -> Vec<(DVec2, Corner)> {
        let mut at = DVec2::ZERO;
        let mut corners = vec![(at, (0, 0.0))];
        for (step, corner) in &self.steps {
            at += *step;
            corners.push((at, *corner));
        }
        corners
    }

    /// The highest corner, and where the tool begins.
    fn top(&self) -> f64 {
        self.corners().iter().map(|(at, _)| at.y).fold(0.0, f64::max)
    }

    fn start(&self) -> DVec2 {
        DVec2::new(-6.0 - self.blank(), self.top() + self.blank() + self.above)
    }

    /// The blank beside the contour, where it is cut parallel.
    fn blank(&self) -> f64 {
        if self.parallel { 4.0 } else { 0.0 }
    }

    /// The limit as cuts see it; the tool is in front of it and above it.
    fn limit(&self) -> Option<DVec2> {
        let corners = self.corners();
        let (end, low) = (corners.last()?.0, corners.iter().map(|(at, _)| at.y).fold(f64::INFINITY, f64::min));
        self.limit.map(|(before, above)| DVec2::new(end.x - before.min(end.x - 3.0), low + above))
    }

    /// The way as points, and its sharp inside corners.
    fn way(&self) -> (Vec<DVec2>, Vec<DVec2>) {
        let corners = self.corners();
        let (mut way, mut sharp) = (vec![DVec2::ZERO], Vec::new());
        for around in corners.windows(3) {
            let &[(before, _), (at, (kind, size)), (after, _)] = around else { continue };
            let (back, on) = ((before - at).normalize(), (after - at).normalize());
            let straight = back.perp_dot(on).abs() < 1e-9;
            let half = back.dot(on).clamp(-1.0, 1.0).acos() / 2.0;
            match kind {
                1 if !straight => way.extend([at + back * size, at + on * size]),
                2 if !straight => {
                    let (centre, cut) = (at + (back + on).normalize() * (size / half.sin()), size / half.tan());
                    let (from, to) = (at + back * cut - centre, at + on * cut - centre);
                    let sweep = from.angle_to(to);
                    way.extend((0..=40).map(|n| centre + DVec2::from_angle(sweep * f64::from(n) / 40.0).rotate(from)));
                }
                _ => way.push(at),
            }
            if (at - before).perp_dot(after - at) > 0.0 && (kind == 0 || kind == 1 || size < self.radius) {
                sharp.push(at);
            }
        }
        way.push(corners.last().expect("corners").0);
        (way, sharp)
    }

    /// Points of the contour, and whether the nose comes to them: not to inside corners, nor under an overhang.
    fn contour(&self) -> Vec<(DVec2, bool)> {
        let (way, sharp) = self.way();
        let goes_back = way.windows(2).any(|pair| pair[1].x < pair[0].x - 1e-9);
        let mut points = Vec::new();
        for pair in way.windows(2) {
            let &[from, to] = pair else { continue };
            let count = (from.distance(to) / STEP).ceil().max(1.0);
            points.extend((0..=count as u32).map(|n| from.lerp(to, f64::from(n) / count)));
        }
        let far = 8.0 * self.radius;
        let whole = |at: &DVec2| !goes_back && sharp.iter().all(|corner| corner.distance(*at) > far);
        points.into_iter().map(|at| (at, whole(&at))).collect()
    }

    /// How far a point is from the insert whose nose has its centre there, less the radius of the nose.
    fn distance(&self, centre: DVec2, point: DVec2) -> f64 {
        let way = point - centre;
        let Some((angle, tip)) = self.edges else { return way.length() - self.radius };
        let (a, b) = (angle.to_radians(), (angle + tip).to_radians());
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
        let number = if self.parallel {
            815
        } else if self.face {
            820
        } else {
            810
        };
        let (x, z) = self.programmed(self.start());
        let mut text = format!(
            "TOOL CALL 1 Z\nFUNCTION MODE TURN\nFUNCTION TURNDATA SPIN VCONST:OFF S500\nL X{x:+} Z{z:+} R0 FMAX M303\n\
             CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL 2\nCYCL DEF {number}\n"
        );
        let mut q = |number: u16, value: f64| {
            let _ = writeln!(text, "Q{number}={value:+}");
        };
        q(215, f64::from(self.operation));
        q(460, self.clearance);
        q(499, f64::from(u8::from(self.reversed)));
        q(463, self.depth);
        q(478, 300.0);
        q(483, self.oversizes.0);
        q(484, self.oversizes.1);
        q(505, 100.0);
        if self.parallel {
            q(485, self.blank());
            q(486, f64::from(u8::from(self.equidistant)));
        } else {
            let limit = self.limit().map(|limit| self.programmed(limit));
            q(487, f64::from(u8::from(self.undercuts)));
            q(488, 50.0);
            q(479, f64::from(u8::from(limit.is_some())));
            q(480, limit.map_or(0.0, |limit| limit.0));
            q(482, limit.map_or(0.0, |limit| limit.1));
            q(506, f64::from(self.smoothing));
        }
        text += "CYCL CALL\nM30\nLBL 2\n";
        let mut corners = self.corners();
        if self.reversed {
            corners.reverse();
        }
        for (number, (at, (kind, size))) in corners.iter().enumerate() {
            let (x, z) = self.programmed(*at);
            let _ = writeln!(text, "L X{x:+} Z{z:+}");
            let between = number > 0 && number + 1 < corners.len();
            let straight = between && {
                let (back, on) = (corners[number - 1].0 - *at, corners[number + 1].0 - *at);
                back.normalize().perp_dot(on.normalize()).abs() < 1e-9
            };
            match kind {
                1 if between && !straight => {
                    // A chamfer has its length on either side.
                    let _ = writeln!(text, "CHF {size}");
                }
                2 if between && !straight => {
                    let _ = writeln!(text, "RND R{size}");
                }
                _ => {}
            }
        }
        text + "LBL 0\n"
    }

    fn run(&self) -> Result<(Vec<Event>, Option<Left>), TestCaseError> {
        let (angle, tip) = self.edges.unwrap_or_default();
        let (x, z) = self.programmed(self.start());
        let text = format!(
            "scene: 1\ntools: [{{T: 1, L: 80, R: 0, RS: {}, T-ANGLE: {angle}, P-ANGLE: {tip}}}]\nstart: [{}, 0, {z}]\n",
            self.radius,
            x / 2.0,
        );
        turned_body::run(&self.program(), &text, Some(self.ring()))
    }

    /// A point as cuts see it, as the place on the rotary axis and the radius.
    fn in_half_plane(&self, at: DVec2) -> DVec2 {
        let (diameter, z) = self.programmed(at);
        DVec2::new(z, diameter / 2.0)
    }

    /// The blank: from where the contour begins, as high as the tool begins. For cuts parallel to a contour that is more
    /// than they reckon with.
    fn ring(&self) -> Ring {
        let corners = self.corners();
        let low = corners.iter().map(|(at, _)| at.y).fold(0.0, f64::min);
        let end = corners.iter().map(|(at, _)| at.x).fold(0.0, f64::max);
        let ends = [DVec2::new(0.0, self.start().y), DVec2::new(end + 20.0, low - 4.0)];
        let [a, b] = ends.map(|at| self.in_half_plane(at));
        let (least, most) = (a.min(b), a.max(b));
        let hollow = self.inside || self.face && self.signs().0 > 0.0;
        Ring { z: [least.x, most.x], radii: [if hollow { least.y } else { 0.0 }, most.y] }
    }

    /// Nothing of the insert was below the contour with its allowance, and finishing has left nothing where it came.
    fn leaves(&self, body: &Left, left: bool, contour: &[(DVec2, bool)]) -> Result<(), TestCaseError> {
        body.is_sound(self.operation == 1 && !self.parallel, &self.program())?;
        let ring = self.ring();
        let by = if self.operation == 1 { self.allowance() } else { DVec2::ZERO };
        let chord = self.chord();
        for pair in contour.windows(2) {
            let ((from, first), (to, second)) = (pair[0], pair[1]);
            if from.distance(to) < 1e-3 {
                continue;
            }
            let (at, out) = (from.midpoint(to), (to - from).normalize().perp());
            let side = DVec2::new(if out.x.abs() > 1e-9 { by.x * out.x.signum() } else { 0.0 }, by.y);
            let below = self.in_half_plane(at + side - out * (chord + EXACT));
            if ring.has(below, 0.01) {
                prop_assert!(body.has(below), "nothing is left at {} seen {}\n{}", below, at, self.program());
            }
            let all = first && second && !left && self.undercuts && self.limit().is_none();
            if all && (self.operation == 2 || by == DVec2::ZERO && self.smoothing == 1) {
                let most = chord + if self.edges.is_some() { 2e-3 } else { EXACT };
                let above = self.in_half_plane(at + side + out * most);
                prop_assert!(!body.has(above), "{} is left over, seen {}\n{}", above, at, self.program());
            }
        }
        Ok(())
    }

    /// How far the points of the contour lie beside its roundings at the most, which have 40 chords each.
    fn chord(&self) -> f64 {
        let corners = self.steps.windows(2).map(|pair| {
            let ((into, (kind, size)), (out, _)) = (pair[0], pair[1]);
            if kind == 2 { size * (1.0 - (into.angle_to(out) / 80.0).cos()) } else { 0.0 }
        });
        corners.fold(0.0, f64::max)
    }

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
            moves.push(Moved { rapid: *kind == MoveKind::Rapid, step: step.to_string(), arc, places });
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

/// The blank over a grid: up to where the cycle began, or beside the contour; nothing in front of it.
struct Blank {
    heights: Vec<f64>,
}

/// Where the grid begins.
const FROM: f64 = -12.0;

impl Blank {
    fn new(job: &Job) -> Self {
        let (way, _) = job.way();
        let (count, blank) = (((way[way.len() - 1].x + 30.0 - FROM) / STEP) as u32, job.blank());
        let solid = |n: u32| {
            let x = FROM + f64::from(n) * STEP;
            if x < 0.0 {
                return f64::NEG_INFINITY;
            }
            if !job.parallel {
                return job.start().y;
            }
            // The highest place of circles about the contour.
            let over = |at: &DVec2| {
                let off = (x - at.x).abs();
                if off <= blank { at.y + (blank * blank - off * off).sqrt() } else { f64::NEG_INFINITY }
            };
            job.contour().iter().map(|(at, _)| over(at)).fold(f64::NEG_INFINITY, f64::max)
        };
        Self { heights: (0..count).map(solid).collect() }
    }

    /// By how much a nose at a place is in the material at the most; what it covers is taken away if asked for.
    fn meets(&mut self, centre: DVec2, radius: f64, cuts: bool) -> f64 {
        let first = ((centre.x - radius - FROM) / STEP).ceil().max(0.0) as usize;
        let last = ((centre.x + radius - FROM) / STEP).floor().max(0.0) as usize;
        let mut deepest: f64 = 0.0;
        for (n, height) in self.heights.iter_mut().enumerate().take(last + 1).skip(first) {
            let off = FROM + n as f64 * STEP - centre.x;
            let low = centre.y - (radius * radius - off * off).max(0.0).sqrt();
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
    fn contours_keep_their_profile(job in job()) {
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
            // At a feed not beyond the limit.
            if let (Some(limit), false) = (job.limit(), moved.rapid || moved.step.starts_with("retract")) {
                for centre in &moved.places {
                    prop_assert!(centre.x + job.radius < limit.x + EXACT, "{centre} in {}\n{}", moved.step, job.program());
                    prop_assert!(centre.y - job.radius > limit.y - EXACT, "{centre} in {}\n{}", moved.step, job.program());
                }
            }
        }
        // Where the insert can come it comes, whatever is said not to be reached.
        let left = events.iter().any(|event| matches!(&event.kind, EventKind::Message { .. }));
        // Across the axis such an insert is beside its nose in what is not turned yet.
        let fits = job.edges.is_none_or(|(angle, _)| !job.face || angle >= 90.0);
        if let (Some(body), true) = (&body, fits) {
            job.leaves(body, left, &contour)?;
        }
        let along = |moved: &&Moved| match job.parallel && job.operation == 1 {
            true => moved.step == "cut-parallel-to-contour" && by == DVec2::ZERO,
            false => moved.step.contains("finish") || moved.step.contains("smooth"),
        };
        let whole: Vec<&Moved> = moves.iter().filter(|moved| !moved.rapid).filter(along).collect();
        let all = job.undercuts && job.limit().is_none() && !left;
        if all && (job.operation == 2 || by == DVec2::ZERO && (job.parallel || job.smoothing == 1)) {
            for (point, _) in contour.iter().filter(|(_, whole)| *whole) {
                let apart = whole.iter().map(|moved| moved.distance(*point)).fold(f64::INFINITY, f64::min) - job.radius;
                let most = if job.edges.is_some() { 2e-3 } else { EXACT };
                prop_assert!(apart < most, "{} left at {}\n{}", apart, point, job.program());
            }
        }
        if job.operation != 1 {
            return Ok(());
        }
        // No infeed is deeper than wanted, and rapid traverse stays in the open.
        let cuts = moves.iter().filter(|moved| moved.step.starts_with("cut-contour") && !moved.rapid);
        let mut level = job.start().y + job.radius;
        for height in cuts.filter_map(|moved| Some((moved.places.first()?.y, moved.places.last()?.y))) {
            if (height.0 - height.1).abs() < EXACT && height.0 < level {
                prop_assert!(level - height.0 < job.depth + EXACT, "{} after {}\n{}", height.0, level, job.program());
                level = height.0;
            }
        }
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

/// Behind a hill the contour ends in a valley, and above its end an insert whose edge leans back leaves a wedge: the tool goes
/// out along that edge, neither through the wedge nor through the hill.
#[test]
fn an_insert_that_leans_back_leaves_a_valley_along_its_edge() {
    for (front, clearance) in [(100.0, 0.5), (107.0, 1.0), (95.0, 0.1)] {
        let program = format!(
            "TOOL CALL 1 Z\nFUNCTION MODE TURN\nFUNCTION TURNDATA SPIN VCONST:OFF S500\nL X+70 Z+2 R0 FMAX M303\n\
             CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL 2\n\
             CYCL DEF 810 Q215=2 Q460={clearance} Q478=300 Q483=0 Q484=0 Q505=100 Q463=2 Q506=0 Q499=0 Q479=0 Q480=0 Q482=0 Q487=1 Q488=0\n\
             CYCL CALL\nM30\nLBL 2\nL X+50 Z+0\nL Z-5\nL X+60 Z-15\nL X+50 Z-25\nL Z-32\nLBL 0\n"
        );
        let scene = format!(
            "scene: 1\ntools: [{{T: 1, L: 80, R: 0, RS: 0.4, T-ANGLE: {front}, P-ANGLE: 45}}]\nstart: [35, 0, 2]\n"
        );
        let ring = Ring { z: [-50.0, 0.0], radii: [0.0, 35.0] };
        let (_, body) = turned_body::run(&program, &scene, Some(ring)).expect("it runs");
        body.expect("a stock").is_sound(true, &program).unwrap_or_else(|wrong| panic!("{wrong}"));
    }
}
