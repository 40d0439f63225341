//! Laws of milling paths, each strategy called alone: the whole figure is covered and its wall never crossed, no step is
//! wider than asked for, no plunge steeper, a helix has its pitch.
//!
//! What is covered is calculated here, from the legs as they are.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use ciklo::engine::strategy::shape::pocket_and_slot::{ClearCircleLevel, ClearRectangleLevel, ClearSlotLevel};
use ciklo::engine::strategy::shape::{plunge, stud, thread};
use ciklo::engine::strategy::{Cutter, Leg, Milling};
use glam::{DVec2, DVec3};
use proptest::prelude::*;

const NEAR: f64 = 1e-6;
const FEED: f64 = 500.0;

/// A leg in the working plane with its heights: points a short way apart.
fn points(from: DVec3, leg: &Leg) -> Vec<DVec3> {
    match *leg {
        Leg::Line { to, .. } => {
            let count = ((to - from).length() / 0.05).ceil().max(1.0);
            (1..=count as u32).map(|n| from + (to - from) * (f64::from(n) / count)).collect()
        }
        Leg::Arc { centre, to, direction, sweep, .. } => {
            let (a, b) = ((from - centre).truncate(), (to - centre).truncate());
            let turn = ((b.to_angle() - a.to_angle()) * direction).rem_euclid(std::f64::consts::TAU);
            let whole = turn < 1e-9 || (a - b).length() < 1e-9;
            let swept = sweep.map_or(if whole { std::f64::consts::TAU } else { turn } * direction, f64::to_radians);
            let count = (swept.abs() * a.length() / 0.05).ceil().max(8.0);
            let at = |n: u32| {
                let share = f64::from(n) / count;
                let flat = centre.truncate() + DVec2::from_angle(swept * share).rotate(a);
                flat.extend(from.z + (to.z - from.z) * share)
            };
            (1..=count as u32).map(at).collect()
        }
        Leg::Upright { centre, .. } => {
            let radius = (from - centre).length();
            let at = |n: u32| {
                let angle = f64::from(n) * std::f64::consts::FRAC_PI_2 / 90.0;
                centre + DVec3::new(angle.cos(), 0.0, -angle.sin()) * DVec3::new(-radius, 0.0, radius)
            };
            (1..=90).map(at).collect()
        }
        Leg::InStep { here, .. } => vec![here],
    }
}

/// The points of a path.
fn drawn(from: DVec3, legs: &[Leg]) -> Vec<DVec3> {
    let mut here = from;
    let mut found = vec![from];
    for leg in legs {
        found.extend(points(here, leg));
        here = leg.end();
    }
    found
}

/// Arcs begin and end at the same distance from their centres.
fn is_continuous(from: DVec3, legs: &[Leg]) -> bool {
    let mut here = from;
    legs.iter().all(|leg| {
        let ok = match *leg {
            Leg::Line { .. } => true,
            Leg::Arc { centre, to, .. } => {
                ((here - centre).truncate().length() - (to - centre).truncate().length()).abs() < NEAR
            }
            Leg::Upright { centre, to, .. } => (here.distance(centre) - to.distance(centre)).abs() < NEAR,
            Leg::InStep { .. } => false,
        };
        here = leg.end();
        ok
    })
}

fn rotated(point: DVec2, degrees: f64) -> DVec2 {
    DVec2::from_angle(degrees.to_radians()).rotate(point)
}

/// Inside of a rectangle with round corners about the origin: how far the point lies outside of its wall.
fn outside(point: DVec2, half: DVec2, corner: f64) -> f64 {
    let arm = point.abs() - (half - DVec2::splat(corner));
    if arm.x > 0.0 && arm.y > 0.0 { arm.length() - corner } else { (point.abs() - half).max_element() }
}

/// The points of a grid over a rectangle.
fn grid(half: DVec2) -> impl Iterator<Item = DVec2> {
    let count = |half: f64| (2.0 * half / 1.3).ceil() as i32;
    (0..=count(half.x)).flat_map(move |x| {
        (0..=count(half.y)).map(move |y| {
            let share = |n: i32, half: f64| half * (2.0 * f64::from(n) / f64::from(count(half)) - 1.0);
            DVec2::new(share(x, half.x), share(y, half.y))
        })
    })
}

laws! {
    #![proptest_config(crate::cases::config(24))]

    /// The whole rectangle is cleared at one height, and the edge of the tool reaches its wall and goes no further.
    #[test]
    fn a_rectangle_is_cleared_to_its_wall(
        (length, width) in (12.0..60.0_f64, 12.0..60.0_f64), radius in 2.0..5.0_f64, rounder in 0.0..1.0_f64,
        share in 0.2..1.4_f64, rotation in -180.0..180.0_f64, climb in prop::bool::ANY,
    ) {
        let corner = radius + rounder * (length.min(width) / 2.0 - radius);
        let centre = DVec3::new(30.0, -20.0, 0.0);
        let pocket = ClearRectangleLevel {
            centre, climb: if climb { 1.0 } else { -1.0 }, length, width, corner, rotation, stepover: share * radius, at: FEED,
        };
        let from = centre.truncate().extend(-4.0);
        let path = pocket.path(Cutter { radius }, from);
        prop_assert!(path.fault.is_none(), "{:?}", path.fault);
        prop_assert!(is_continuous(from, &path.legs));
        let middle: Vec<DVec2> =
            drawn(from, &path.legs).iter().map(|p| rotated(p.truncate() - centre.truncate(), -rotation)).collect();
        prop_assert!(path.legs.iter().all(|leg| leg.end().z == -4.0));
        let half = DVec2::new(length, width) / 2.0;
        let widest = middle.iter().map(|p| outside(*p, half, corner)).fold(f64::NEG_INFINITY, f64::max);
        prop_assert!((widest + radius).abs() < 1e-3, "the edge is {} beside the wall", widest + radius);
        for point in grid(half).filter(|point| outside(*point, half, corner) <= 0.0) {
            let nearest = middle.iter().map(|p| (*p - point).length()).fold(f64::INFINITY, f64::min);
            prop_assert!(nearest <= radius + 0.03, "{point} is {nearest} from the path of a tool of {radius}");
        }
    }

    /// A circle is cleared on a spiral that goes out by no more than the stepover in a turn.
    #[test]
    fn a_circle_is_cleared_on_a_spiral(
        diameter in 12.0..80.0_f64, radius in 2.0..5.0_f64, share in 0.1..1.9_f64, climb in prop::bool::ANY,
    ) {
        let stepover = share * radius;
        let pocket = ClearCircleLevel {
            centre: DVec3::ZERO, climb: if climb { 1.0 } else { -1.0 }, diameter, stepover, at: FEED,
        };
        let path = pocket.path(Cutter { radius }, DVec3::new(0.0, 0.0, -2.0));
        prop_assert!(path.fault.is_none() && is_continuous(DVec3::new(0.0, 0.0, -2.0), &path.legs));
        let ends: Vec<f64> = path.legs.iter().map(|leg| leg.end().truncate().length()).collect();
        let wall = diameter / 2.0 - radius;
        prop_assert!(ends.iter().all(|distance| *distance <= wall + NEAR));
        // Half a turn later it is out by no more than half the stepover, until it leaves the wall.
        let spiral = ends.iter().take_while(|distance| **distance < wall - NEAR).chain([&wall]);
        let spiral: Vec<f64> = std::iter::once(0.0).chain(spiral.copied()).collect();
        prop_assert!(spiral.windows(2).all(|pair| pair[1] - pair[0] <= stepover / 2.0 + NEAR), "{spiral:?}");
        let turns = if climb { 1.0 } else { -1.0 };
        let along = |leg: &Leg| matches!(leg, Leg::Arc { direction, .. } if *direction == turns);
        prop_assert!(path.legs.iter().all(along), "climb milling turns one way");
    }

    /// The allowance of a slot stays on its wall, and nothing in the middle.
    #[test]
    fn a_slot_keeps_its_allowance(
        width in 10.0..20.0_f64, more in 0.0..40.0_f64, radius in 2.0..4.5_f64, allowance in 0.0..0.5_f64,
    ) {
        let slot = ClearSlotLevel {
            centre: DVec3::ZERO, climb: 1.0, length: width + more, width, rotation: 0.0, allowance, at: FEED,
        };
        let path = slot.path(Cutter { radius }, DVec3::ZERO);
        let middle = drawn(DVec3::ZERO, &path.legs);
        let from_core = |p: &DVec3| {
            (p.truncate() - DVec2::new(p.x.clamp(-more / 2.0, more / 2.0), 0.0)).length()
        };
        let widest = middle.iter().map(from_core).fold(0.0, f64::max);
        prop_assert!((widest - (width / 2.0 - radius - allowance).max(0.0)).abs() < NEAR, "{widest}");
    }

    /// No leg goes down more steeply than asked for, and the way ends at the level.
    #[test]
    fn no_plunge_is_steeper_than_its_angle(
        depth in 0.5..12.0_f64, angle in 1.0..30.0_f64, radius in 1.0..8.0_f64, room in 2.0..30.0_f64,
    ) {
        let (centre, from, to, feed) = (DVec3::ZERO, 1.0, 1.0 - depth, 150.0);
        let start = DVec3::new(0.0, 0.0, from);
        let helix = plunge::PlungeOnHelix { centre, from, to, angle, feed, radius, direction: 1.0 };
        let strokes = plunge::PlungeInStrokes { centre, from, to, angle, feed, rotation: 20.0, least: 1.0, room };
        for path in [helix.path(Cutter { radius }, start), strokes.path(Cutter { radius }, start)] {
            prop_assert!(path.fault.is_none());
            let mut here = start;
            for leg in &path.legs {
                let (way, drop): (f64, f64) = match leg {
                    Leg::Line { to, .. } => ((*to - here).truncate().length(), here.z - to.z),
                    // Half a turn each, the last one a whole turn.
                    Leg::Arc { to, .. } => (std::f64::consts::PI * radius, here.z - to.z),
                    Leg::Upright { .. } | Leg::InStep { .. } => panic!("{leg:?} is no leg of a plunge"),
                };
                prop_assert!(drop <= way * angle.to_radians().tan() + NEAR, "{leg:?} from {here}");
                here = leg.end();
            }
            prop_assert!((here - centre.truncate().extend(to)).length() < NEAR, "it ends at {here}");
        }
    }

    /// Laps around a stud never come nearer than the tool radius, and the last one touches it.
    #[test]
    fn a_stud_is_never_cut(
        (length, width) in (10.0..50.0_f64, 10.0..50.0_f64), more in 0.5..15.0_f64, radius in 2.0..8.0_f64,
        corner in 0.0..4.0_f64, share in 0.2..1.5_f64, approach in 0_u8..5,
    ) {
        let strategy = stud::MillRectangularStudLevel {
            centre: DVec3::ZERO, climb: 1.0, length, width, corner, rotation: 0.0, stepover: share * radius, allowance: 0.0,
            blank_length: length + 2.0 * more, blank_width: width + 2.0 * more, approach: f64::from(approach), at: FEED,
        };
        let from = DVec3::new(200.0, 200.0, -3.0);
        let path = strategy.path(Cutter { radius }, from);
        prop_assert!(path.fault.is_none());
        // The way to the first leg comes from wherever the tool was.
        let begin = path.legs.first().map_or(from, Leg::end);
        let middle = drawn(begin, path.legs.get(1..).unwrap_or_default());
        let half = DVec2::new(length, width) / 2.0;
        let nearest = middle.iter().map(|p| distance(p.truncate(), half, corner)).fold(f64::INFINITY, f64::min);
        prop_assert!((nearest - radius).abs() < 1e-6, "the centre comes to {nearest} with a tool of {radius}");
    }

    /// A thread is a helix about its axis: so far from it as the tool asks for, with the rise of the pitch.
    #[test]
    fn a_thread_rises_by_its_pitch(
        diameter in 10.0..40.0_f64, share in 0.2..0.9_f64, pitch in 0.5..4.0_f64, left in prop::bool::ANY,
        depth in 2.0..20.0_f64, climb in prop::bool::ANY,
    ) {
        let radius = share * diameter / 2.0;
        let pitch = if left { -pitch } else { pitch };
        let strategy = thread::MillThreadHelix {
            centre: DVec3::ZERO, surface: 0.0, depth: -depth, diameter, pitch, outside: 0.0,
            climb: if climb { 1.0 } else { -1.0 }, threads: 1.0, at: FEED, between: FEED,
        };
        let from = DVec3::new(diameter / 2.0 - radius, 0.0, -depth);
        let path = strategy.path(Cutter { radius }, from);
        let [Leg::Arc { to, sweep: Some(sweep), feed, .. }] = path.legs.as_slice() else { panic!("{path:?}") };
        let rise = to.z - from.z;
        prop_assert!((rise / (sweep / 360.0) - pitch).abs() < NEAR, "a right-hand thread rises counter-clockwise");
        prop_assert!(rise.abs() >= depth - NEAR && rise.abs() < depth + pitch.abs() + NEAR);
        prop_assert!((feed / FEED - (1.0 - share)).abs() < NEAR, "the edge has the feed");
    }
}

/// How far a point lies from a rectangle with round corners about the origin.
fn distance(point: DVec2, half: DVec2, corner: f64) -> f64 {
    let arm = (point.abs() - (half - DVec2::splat(corner))).max(DVec2::ZERO);
    arm.length() - corner
}
