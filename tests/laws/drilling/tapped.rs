//! 206, 207 and 209: the thread that the way of the tap and the turning of the spindle make.
use ciklo::engine::run::{Event, EventKind, MoveKind};
use glam::DVec2;
use proptest::prelude::*;

use super::setup::{Made, Setup, config, definition, places, setup};

/// What is tapped.
#[derive(Clone, Debug)]
struct Tap {
    radius: f64,
    pitch: f64,
    left: bool,
    depth: f64,
    speed: f64,
}

prop_compose! {
    fn tap()(radius in 1.0..6.0_f64, pitch in 0.2..3.0_f64, left in any::<bool>(), depth in 0.5..29.0_f64, speed in 50..900) -> Tap {
        Tap { radius, pitch, left, depth, speed: f64::from(speed) }
    }
}

impl Tap {
    fn scene(&self, setup: &Setup) -> String {
        setup.scene(&format!("{{T: 1, L: 100, R: {}}}", self.radius))
    }

    fn signed(&self) -> f64 {
        if self.left { -self.pitch } else { self.pitch }
    }

    /// The hole of the tap in the blank, and a thread at each place as asked for.
    fn proved(&self, setup: &Setup, made: &Made, places: &[DVec2], passes: u32) -> Result<(), TestCaseError> {
        let floor = setup.surface - self.depth;
        let holes = places.iter().map(|place| setup.hole(*place, floor, self.radius)).collect();
        made.is(&setup.part(holes), self.depth)?;
        let threads = made.threads();
        prop_assert_eq!(threads.len(), places.len(), "{:?}{}", threads, made.text);
        for (thread, place) in threads.iter().zip(places) {
            let near = |a: f64, b: f64| (a - b).abs() < 1e-7;
            let (top, bottom) = (setup.axis.of(thread.top), setup.axis.of(thread.bottom));
            let fits = near(thread.pitch, self.pitch)
                && thread.right != self.left
                && near(thread.diameter, 2.0 * self.radius)
                && near(bottom, floor)
                && near(top, setup.surface + setup.clearance)
                && (setup.plane().flat(thread.top) - *place).length() < 1e-7
                && !thread.milled
                && !thread.outside
                && thread.passes == passes;
            prop_assert!(fits, "{:?} is not {:?}{}", thread, self, made.text);
        }
        Ok(())
    }
}

/// End, feed, turning and speed of each move at feed of the cycle.
fn in_step(setup: &Setup, events: &[Event], cycle: u32) -> Vec<(f64, f64, i8, f64)> {
    let (mut turning, mut speed, mut found) = (0, 0.0, Vec::new());
    for event in events {
        match &event.kind {
            EventKind::Spindle { direction, speed: rate, .. } => (turning, speed) = (*direction, *rate),
            EventKind::Move { kind: MoveKind::Feed, to, feed, .. } if super::setup::of_cycle(event, cycle) => {
                found.push((setup.axis.of(*to), *feed, turning, speed));
            }
            _ => {}
        }
    }
    found
}

/// How the spindle turns in which direction: away from itself with the hand of the thread.
fn wanted_turning(left: bool, down: bool) -> i8 {
    if left == down { -1 } else { 1 }
}

laws! {
    #![proptest_config(config())]

    #[test]
    fn tapping_with_a_floating_holder(setup in setup(), places in places(), tap in tap(), wait in prop_oneof![Just(0.0), 0.1..1.0]) {
        let Setup { clearance, surface, second, .. } = setup;
        let feed = tap.speed * tap.pitch;
        let values = [(200, clearance), (201, -tap.depth), (206, feed), (211, wait), (203, surface), (204, second)];
        let body = setup.tool(1, tap.speed, if tap.left { "M4" } else { "M3" }) + &definition(206, &values) + &setup.calls(&places);
        let made = setup.machined(&body, &tap.scene(&setup), 0.9)?;
        tap.proved(&setup, &made, &places, 1)?;
        let moves = in_step(&setup, &made.events, 206);
        let each = [(surface - tap.depth, true), (surface + clearance, false)];
        prop_assert_eq!(moves.len(), 2 * places.len());
        for ((to, at, turning, speed), (height, down)) in moves.iter().zip(each.iter().cycle()) {
            let fits = (to - height).abs() < 1e-9 && (at - feed).abs() < 1e-9 && (speed - tap.speed).abs() < 1e-9;
            prop_assert!(fits && *turning == wanted_turning(tap.left, *down), "{:?}{}", moves, made.text);
        }
    }

    #[test]
    fn rigid_tapping(setup in setup(), places in places(), tap in tap(), turning in prop::sample::select(vec!["M3", "M4", "M5"])) {
        let Setup { clearance, surface, second, .. } = setup;
        let values = [(200, clearance), (201, -tap.depth), (239, tap.signed()), (203, surface), (204, second)];
        let body = setup.tool(1, tap.speed, turning) + &definition(207, &values) + &setup.calls(&places);
        let made = setup.machined(&body, &tap.scene(&setup), 0.9)?;
        tap.proved(&setup, &made, &places, 1)?;
        let moves = in_step(&setup, &made.events, 207);
        for ((_, feed, turning, speed), down) in moves.iter().zip([true, false].iter().cycle()) {
            prop_assert!((feed - speed * tap.pitch).abs() < 1e-6 && *turning == wanted_turning(tap.left, *down), "{:?}{}", moves, made.text);
        }
        // The spindle stands at the end of the cycle.
        let last = made.of_cycle(207).filter_map(|event| match &event.kind {
            EventKind::Spindle { direction, .. } => Some(*direction),
            _ => None,
        }).last();
        prop_assert_eq!(last, Some(0), "{}", made.text);
    }

    /// In by the depth for chip breaking, back by some turns or out, and out by the factor faster.
    #[test]
    fn tapping_with_chip_breaking(
        setup in setup(), places in places(), tap in tap(), bite in 0.6..12.0_f64, turns in prop_oneof![Just(0.0), 0.1..0.4],
        angle in -360.0..360.0_f64, factor in 1.0..4.0_f64,
    ) {
        let Setup { clearance, surface, second, .. } = setup;
        let values = [
            (200, clearance), (201, -tap.depth), (239, tap.signed()), (203, surface), (204, second), (257, bite), (256, turns),
            (336, angle), (403, factor),
        ];
        let body = setup.tool(1, tap.speed, "M3") + &definition(209, &values) + &setup.calls(&places);
        let made = setup.machined(&body, &tap.scene(&setup), 0.9)?;
        // Calculated here: where each way ends, and whether it goes down.
        let count = (tap.depth / bite - 1e-9).ceil().max(1.0) as u32;
        let mut wanted = Vec::new();
        for n in 1..=count {
            let floor = surface - (f64::from(n) * bite).min(tap.depth);
            wanted.push((floor, true));
            let back = if turns == 0.0 || n == count { surface + clearance } else { floor + turns * tap.pitch };
            wanted.push((back, false));
        }
        tap.proved(&setup, &made, &places, count)?;
        let moves = in_step(&setup, &made.events, 209);
        prop_assert_eq!(moves.len(), wanted.len() * places.len(), "{:?}{}", moves, made.text);
        for ((to, feed, turning, speed), (height, down)) in moves.iter().zip(wanted.iter().cycle()) {
            let rate = if *down { tap.speed } else { tap.speed * factor };
            let fits = (to - height).abs() < 1e-7 && (speed - rate).abs() < 1e-7 && (feed - rate * tap.pitch).abs() < 1e-6;
            prop_assert!(fits && *turning == wanted_turning(tap.left, *down), "{:?}{}", (to, feed, turning, speed), made.text);
        }
        let angles: Vec<f64> = made.of_cycle(209).filter_map(|event| match event.kind {
            EventKind::Spindle { orient, .. } => orient,
            _ => None,
        }).collect();
        prop_assert_eq!(angles, vec![angle; places.len()], "{}", made.text);
    }
}
