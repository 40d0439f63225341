//! Laws of contour pockets (cycles 14, 20 to 24, and CONTOUR DEF): what a run leaves is asked point by point.
//!
//! Contours are stars and circles whose distance functions are exact here. A point belongs to what must be cut where a
//! disc of the tool, and of the rounding radius around it, fits into the contours beside it; it must stay where the
//! contours do not reach it, or, with one pocket, within the allowance of a wall. Nothing of the engine's regions or of
//! its stock is used.
use std::fmt::Write as _;

use ciklo::engine::geometry::Axis;
use ciklo::engine::run::{Event, EventKind, MoveKind, Status};
use ciklo::engine::solid::Path;
use glam::{DVec2, DVec3};
use proptest::prelude::*;

use super::job::{FINISH, Job, MILL, PLUNGE, View, beside, definition, job, mm};

/// What a path along offsets of lines and arcs, and chords of arcs, may miss, mm.
const SLACK: f64 = 0.02;
/// Heights that differ by less, mm, are one.
const LEVEL: f64 = 1e-5;
/// The feed of the floor.
const FLOOR: f64 = 650.0;

/// Corners about a centre, one at each angle; a circle, where there is one radius.
#[derive(Clone, Debug)]
struct Star {
    centre: DVec2,
    radii: Vec<f64>,
}

impl Star {
    fn corners(&self) -> Vec<DVec2> {
        let count = self.radii.len() as f64;
        let corner = |(n, radius): (usize, &f64)| {
            let (sine, cosine) = (std::f64::consts::TAU * n as f64 / count).sin_cos();
            // As it is written in the program.
            ((self.centre + DVec2::new(cosine, sine) * *radius) * 1e3).round() / 1e3
        };
        self.radii.iter().enumerate().map(corner).collect()
    }

    /// How far inside a point lies, negative outside.
    fn inside(&self, corners: &[DVec2], at: DVec2) -> f64 {
        if let [radius] = self.radii.as_slice() {
            return radius - at.distance(self.centre);
        }
        let (mut is_inside, mut distance) = (false, f64::INFINITY);
        for (n, a) in corners.iter().enumerate() {
            let b = corners[(n + 1) % corners.len()];
            if (a.y > at.y) != (b.y > at.y) && at.x < (b.x - a.x) * (at.y - a.y) / (b.y - a.y) + a.x {
                is_inside = !is_inside;
            }
            distance = distance.min(beside(at, *a, b));
        }
        if is_inside { distance } else { -distance }
    }

    fn subprogram(&self, job: &Job, label: usize, side: &str) -> String {
        let mut text = format!("LBL {label}\n");
        if let [radius] = self.radii.as_slice() {
            let start = self.centre + DVec2::X * *radius;
            let _ = writeln!(text, "CC {}\nL {} {side}", job.words(self.centre), job.words(start));
            let _ = writeln!(text, "C {} DR+", job.words(start));
        } else {
            let corners = self.corners();
            let _ = writeln!(text, "L {} {side}", job.words(corners[0]));
            for corner in corners[1..].iter().chain(&corners[..1]) {
                let _ = writeln!(text, "L {}", job.words(*corner));
            }
        }
        text + "LBL 0\n"
    }
}

fn star(far: f64, least: f64, most: f64) -> impl Strategy<Value = Star> {
    let centre = (mm(-far..far + 0.01), mm(-far..far + 0.01)).prop_map(DVec2::from);
    let radii = prop_oneof![
        2 => prop::collection::vec(mm(least..most), 1),
        5 => prop::collection::vec(mm(least..most), 3..13),
        1 => prop::collection::vec(mm(least..most), 40..200),
    ];
    (centre, radii).prop_map(|(centre, radii)| Star { centre, radii })
}

/// A contour after the first one.
#[derive(Clone, Debug)]
struct More {
    star: Star,
    is_pocket: bool,
    /// A share of the milling depth, in formulas.
    depth: Option<f64>,
}

#[derive(Clone, Debug)]
struct Case {
    first: Star,
    more: Vec<More>,
    /// Whether `CONTOUR DEF` lists them, and not cycle 14.
    listed: bool,
    overlap: f64,
    side: f64,
    floor: f64,
    rounding: f64,
    strokes: bool,
    finishes: bool,
}

prop_compose! {
    fn case()(
        first in star(6.0, 12.0, 26.0),
        more in prop::collection::vec(
            (star(18.0, 3.0, 12.0), prop::bool::weighted(0.3), prop::option::of(0.1..0.9_f64))
                .prop_map(|(star, is_pocket, depth)| More { star, is_pocket, depth }),
            0..5,
        ),
        listed in any::<bool>(), overlap in mm(0.3..1.9), side in prop_oneof![Just(0.0), mm(0.1..1.0)],
        floor in prop_oneof![Just(0.0), mm(0.05..0.4)], rounding in prop_oneof![2 => Just(0.0), 1 => mm(0.1..2.0)],
        strokes in any::<bool>(), finishes in any::<bool>(),
    ) -> Case {
        // Two pockets of cycle 14 may also be what is common to both; that is another law.
        let more = more.into_iter().map(|more| More { is_pocket: more.is_pocket && listed, ..more }).collect();
        Case { first, more, listed, overlap, side, floor, rounding, strokes, finishes }
    }
}

/// A contour with its corners, depth and kind.
struct Known<'c> {
    star: &'c Star,
    corners: Vec<DVec2>,
    is_pocket: bool,
    /// Of a pocket its depth, of an island how far it lies below the surface.
    depth: f64,
}

impl Case {
    fn depth_of(more: &More, job: &Job) -> Option<f64> {
        more.depth.map(|share| ((job.depth * share * 100.0).round() / 100.0).max(0.01))
    }

    fn program(&self, job: &Job) -> String {
        let mut text = String::new();
        let kind = |more: &More| if more.is_pocket { 'P' } else { 'I' };
        if self.listed {
            text += "CONTOUR DEF P1 = LBL 1";
            for (n, more) in self.more.iter().enumerate() {
                let _ = write!(text, " {}{} = LBL {}", kind(more), n + 2, n + 2);
                if let Some(depth) = Self::depth_of(more, job) {
                    let _ = write!(text, " DEPTH{depth}");
                }
            }
            text += "\n";
        } else {
            let labels: Vec<String> = (1..=self.more.len() + 1).map(|n| n.to_string()).collect();
            let _ = writeln!(text, "CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL {}", labels.join(" /"));
        }
        text += &definition(
            20,
            &[
                (1, -job.depth),
                (2, self.overlap),
                (3, self.side),
                (4, self.floor),
                (5, job.surface),
                (6, job.clearance),
                (7, job.surface + 30.0),
                (8, self.rounding),
                (9, job.climb),
            ],
        );
        let strokes = if self.strokes { PLUNGE } else { 0.0 };
        let rough = [(10, job.infeed), (11, PLUNGE), (12, MILL), (18, 0.0), (19, strokes), (208, 0.0)];
        text += &(definition(22, &rough) + "CYCL CALL\n");
        if self.finishes {
            text += &(definition(23, &[(11, PLUNGE), (12, FLOOR), (208, 0.0)]) + "CYCL CALL\n");
            let sides = [(9, job.climb), (10, job.infeed), (11, PLUNGE), (12, FINISH), (14, 0.0)];
            text += &(definition(24, &sides) + "CYCL CALL\n");
        }
        let letter = job.axis.letter();
        let _ = writeln!(text, "L {letter}+90 R0 FMAX M30");
        // Counter-clockwise all of them: with the tool on the left inside.
        let sides = std::iter::once(true).chain(self.more.iter().map(|more| more.is_pocket));
        for (n, (star, is_pocket)) in self.stars().zip(sides).enumerate() {
            let side = match (self.listed, is_pocket) {
                (true, _) => "R0",
                (false, true) => "RL",
                (false, false) => "RR",
            };
            text += &star.subprogram(job, n + 1, side);
        }
        text
    }

    fn stars(&self) -> impl Iterator<Item = &Star> {
        std::iter::once(&self.first).chain(self.more.iter().map(|more| &more.star))
    }

    fn known(&self, job: &Job) -> Vec<Known<'_>> {
        let first = Known { star: &self.first, corners: self.first.corners(), is_pocket: true, depth: job.depth };
        let more = self.more.iter().map(|more| {
            let own = Self::depth_of(more, job).filter(|_| self.listed);
            let depth = own.unwrap_or(if more.is_pocket { job.depth } else { 0.0 });
            Known { star: &more.star, corners: more.star.corners(), is_pocket: more.is_pocket, depth }
        });
        std::iter::once(first).chain(more).collect()
    }

    /// How far inside of what is machined at a depth a point lies, or less where pockets meet.
    fn inside(known: &[Known<'_>], depth: f64, at: DVec2) -> f64 {
        known.iter().fold(f64::NEG_INFINITY, |inside, own| {
            let mine = own.star.inside(&own.corners, at);
            match own.is_pocket {
                true if own.depth >= depth => inside.max(mine),
                false if own.depth < depth => inside.min(-mine),
                _ => inside,
            }
        })
    }
}

/// A run of the tool over points: how far down each was cut, on the workpiece.
struct Ground {
    places: Vec<DVec2>,
    bottoms: Vec<f64>,
}

impl Ground {
    /// A straight move of a flat tool; the places that it cuts.
    fn cut(&mut self, from: DVec3, to: DVec3, radius: f64, rapid: bool) -> Option<DVec2> {
        let (a, b, bottom) = (from.truncate(), to.truncate(), from.z.min(to.z));
        let (low, high) = (a.min(b) - DVec2::splat(radius), a.max(b) + DVec2::splat(radius));
        let mut wrong = None;
        for (place, own) in self.places.iter().zip(&mut self.bottoms) {
            if place.x < low.x || place.y < low.y || place.x > high.x || place.y > high.y || *own <= bottom + LEVEL {
                continue;
            }
            let far = beside(*place, a, b);
            if far < radius {
                if rapid && far < radius - SLACK {
                    wrong = Some(*place);
                }
                *own = bottom;
            }
        }
        wrong
    }
}

fn straight(path: &Path, see: &dyn Fn(DVec3) -> DVec3) -> Vec<DVec3> {
    let count = match path {
        Path::Line { from, to } => {
            let (from, to) = (see(*from), see(*to));
            let level = (from.z - to.z).abs() < LEVEL || from.truncate().distance(to.truncate()) < LEVEL;
            if level { 1.0 } else { (from.distance(to) / 0.5).ceil() }
        }
        // Chords within 0.002 mm of arcs of this size.
        Path::Arc { .. } => (path.length() / 0.2).ceil(),
    };
    let count = count.max(1.0) as usize;
    (0..=count).map(|n| see(path.at(n as f64 / count as f64))).collect()
}

/// Looks at what a program leaves.
fn leaves(job: &Job, case: &Case) -> Result<(), TestCaseError> {
    let (known, scale) = (case.known(job), job.view.scale);
    let places: Vec<DVec2> = (0..44)
        .flat_map(|x| (0..44).map(move |y| DVec2::new(-43.3 + 1.97 * f64::from(x), -43.7 + 2.01 * f64::from(y))))
        .collect();
    let top = job.surface * scale;
    let mut ground =
        Ground { places: places.iter().map(|at| job.view.point(*at)).collect(), bottoms: vec![top; places.len()] };
    let plane = job.plane();
    let see = |at: DVec3| plane.flat(at).extend(plane.tool.of(at));
    let (mut wrong, mut walls) = (None, Vec::new());
    let mut look = |event: &Event| {
        if let EventKind::Move { kind, feed, path, .. } = &event.kind {
            let rapid = matches!(kind, MoveKind::Rapid | MoveKind::Arc { rapid: true, .. });
            for pair in straight(path, &see).windows(2) {
                wrong = wrong.or(ground.cut(pair[0], pair[1], job.radius, rapid));
            }
            if *feed == FINISH && matches!(path, Path::Line { .. }) {
                walls.push((see(path.at(0.0)), see(path.at(1.0))));
            }
        }
    };
    let (outcome, both) = job.run(&case.program(job), &mut look);
    let tool = job.tool();
    // Whether a disc fits that covers a point, with the allowance around it.
    let side = if case.finishes { 0.0 } else { case.side };
    let fits = |at: DVec2, depth: f64, side: f64| {
        let disc = tool + case.rounding;
        let centres = (0..16).flat_map(|n| {
            let (sine, cosine) = (std::f64::consts::TAU * f64::from(n) / 16.0).sin_cos();
            [0.5, 1.0].map(|share| DVec2::new(cosine, sine) * share * (disc - SLACK))
        });
        let mut centres = std::iter::once(DVec2::ZERO).chain(centres);
        centres.any(|arm| Case::inside(&known, depth, at + arm) >= disc + side + SLACK)
    };
    if let Some(fault) = &outcome.fault {
        // Nothing has room.
        prop_assert_eq!(&*fault.code, "shape-impossible", "{}", both);
        let mut left = places.iter().filter(|at| fits(**at, 0.001, case.side));
        prop_assert!(left.next().is_none(), "there is room{}", both);
        return Ok(());
    }
    prop_assert_eq!(outcome.status, Status::Done, "{}", both);
    prop_assert!(wrong.is_none(), "rapid traverse cuts at {:?}{}", wrong, both);
    // The depths of floors, from below.
    let mut depths: Vec<f64> = known.iter().map(|own| own.depth).filter(|depth| *depth > 0.0).collect();
    depths.sort_by(|a, b| b.total_cmp(a));
    depths.dedup();
    let one_pocket = known.iter().filter(|own| own.is_pocket).count() == 1;
    for (at, bottom) in places.iter().zip(&ground.bottoms) {
        let cut = job.surface - bottom / scale;
        // Never below the floor, never into a wall or an island.
        let within = depths.iter().copied().find(|depth| Case::inside(&known, *depth, *at) > -SLACK).unwrap_or(0.0);
        prop_assert!(cut <= within + LEVEL, "{} is cut {} and not {}{}", at, cut, within, both);
        if !case.finishes {
            let left = (within - case.floor).max(0.0);
            prop_assert!(cut <= left + LEVEL, "{} is cut {} and not {}{}", at, cut, left, both);
        }
        if one_pocket && side > 0.0 {
            let near = depths.iter().copied().find(|depth| Case::inside(&known, *depth, *at) > side - SLACK);
            prop_assert!(cut <= near.unwrap_or(0.0) + LEVEL, "{} is nearer to a wall{}", at, both);
        }
        // What the tool reaches is cut; steps wider than the tool leave cusps.
        if case.overlap <= 1.0 {
            let reached = depths.iter().copied().find(|depth| fits(*at, *depth, side)).unwrap_or(0.0);
            let floor = if case.finishes { reached } else { reached - case.floor };
            prop_assert!(cut >= floor - LEVEL, "{} is cut {} and not {}{}", at, cut, floor, both);
        }
    }
    // In climb the wall is on the right, of a tool that turns clockwise.
    let right = if job.climb < 0.0 { -1.0 } else { 1.0 };
    for (from, to) in walls.iter().filter(|(from, to)| from.truncate().distance(to.truncate()) > 0.5) {
        let way = (to - from).truncate().normalize();
        let depth = job.surface - from.z / scale;
        // On the wall, and behind it; where an island runs out into a point it is thinner than that.
        let behind = |more: f64| {
            let wall = (from + (to - from) / 2.0).truncate() - way.perp() * right * (job.radius + more);
            // Back to the program.
            Case::inside(&known, depth - LEVEL, places_of(job, wall))
        };
        let inside = behind(0.0).min(behind(2.0 * SLACK));
        prop_assert!(inside < SLACK, "the wall beside {} to {} is on the other side: {}{}", from, to, inside, both);
    }
    Ok(())
}

/// A place of the workpiece in the program.
fn places_of(job: &Job, at: DVec2) -> DVec2 {
    let (x, y) = (job.view.point(DVec2::X), job.view.point(DVec2::Y));
    DVec2::new(at.dot(x), at.dot(y)) / (job.view.scale * job.view.scale)
}

laws! {
    #![proptest_config(crate::cases::config(50))]

    #[test]
    fn contour_pockets(job in job(), case in case()) {
        let job = Job { edges: 60.0, ..job };
        leaves(&job, &case)?;
    }
}

/// The centre of the tool had room for a tenth of a millimetre, and the arc onto the wall in cycle 24 more, through the
/// wall.
#[test]
fn the_way_onto_a_wall_stays_in_a_nook() {
    let job = Job {
        axis: Axis::X,
        view: View::PLAIN,
        radius: 5.19,
        corner: 0.0,
        angle: 2.0,
        edges: 60.0,
        surface: 0.0,
        clearance: 1.0,
        second: 0.0,
        depth: 0.5,
        infeed: 0.8,
        climb: -1.0,
        half: DVec2::splat(55.0),
        round: false,
    };
    let radii = vec![12.0, 12.0, 19.13, 24.45, 24.74, 12.0, 12.0, 12.0, 12.0, 12.0, 12.0];
    let island = Star { centre: DVec2::new(0.0, 1.95), radii: vec![5.27] };
    let case = Case {
        first: Star { centre: DVec2::new(2.62, -5.97), radii },
        more: vec![More { star: island, is_pocket: false, depth: None }],
        listed: false,
        overlap: 0.3,
        side: 0.0,
        floor: 0.0,
        rounding: 0.0,
        strokes: false,
        finishes: true,
    };
    if let Err(error) = leaves(&job, &case) {
        panic!("{error}");
    }
}

/// The point of an island at (11.235, 0.744) is 0.020 wide where the tool begins along its upper side, at x = 10.82: from
/// 0.744 · (10.82 - 3) / 8.235 = 0.706 to 0.396 + 0.348 · (10.82 - 2.974) / 8.261 = 0.727.
#[test]
fn the_wall_of_an_island_may_be_its_point() {
    let job = Job {
        axis: Axis::X,
        view: View::PLAIN,
        radius: 1.6,
        corner: 0.0,
        angle: 2.0,
        edges: 60.0,
        surface: 0.0,
        clearance: 1.0,
        second: 0.0,
        depth: 0.5,
        infeed: 0.8,
        climb: -1.0,
        half: DVec2::splat(55.0),
        round: false,
    };
    let mut radii = vec![3.0; 95];
    (radii[1], radii[5]) = (11.26, 9.62);
    let case = Case {
        first: Star { centre: DVec2::ZERO, radii: vec![19.33] },
        more: vec![More { star: Star { centre: DVec2::ZERO, radii }, is_pocket: false, depth: None }],
        listed: false,
        overlap: 0.3,
        side: 0.0,
        floor: 0.0,
        rounding: 0.0,
        strokes: false,
        finishes: true,
    };
    if let Err(error) = leaves(&job, &case) {
        panic!("{error}");
    }
}
