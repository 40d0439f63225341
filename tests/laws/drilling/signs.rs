//! The sign of a depth is the working direction: a positive one works upwards, where the machine allows it.
use ciklo::engine::run::{EventKind, FindingKind, Status};
use proptest::prelude::*;

use super::setup::{Change, HALF, Setup, config, definition, heights, machine, of_cycle, run, setup, threads};

/// Cycles, and their parameters beside clearances, surface and depth.
const DRILLING: [(u32, &[(u16, f64)]); 11] = [
    (200, &[(206, 250.0), (202, 4.0), (210, 0.1), (211, 0.2)]),
    (201, &[(206, 250.0), (208, 500.0), (211, 0.2)]),
    (202, &[(206, 250.0), (208, 500.0), (211, 0.2), (214, 2.0), (336, 30.0)]),
    (
        203,
        &[
            (206, 250.0),
            (202, 4.0),
            (210, 0.1),
            (211, 0.2),
            (212, 0.5),
            (213, 2.0),
            (205, 1.0),
            (208, 500.0),
            (256, 0.2),
        ],
    ),
    (
        205,
        &[
            (206, 250.0),
            (202, 6.0),
            (211, 0.2),
            (212, 0.5),
            (205, 1.0),
            (256, 0.2),
            (257, 2.0),
            (258, 0.5),
            (259, 1.0),
            (379, 0.0),
            (253, 750.0),
        ],
    ),
    (206, &[(206, 250.0), (211, 0.2)]),
    (240, &[(343, 0.0), (344, -9.0), (206, 250.0), (211, 0.2)]),
    (207, &[(239, 1.5)]),
    (208, &[(206, 250.0), (334, 1.5), (335, 12.0), (342, 0.0), (351, 1.0)]),
    (209, &[(239, -1.25), (257, 3.0), (256, 0.5), (336, 20.0), (403, 1.5)]),
    (
        241,
        &[
            (206, 250.0),
            (211, 0.2),
            (379, 0.0),
            (253, 750.0),
            (208, 500.0),
            (426, 3.0),
            (427, 25.0),
            (428, 500.0),
            (429, 8.0),
            (430, 9.0),
        ],
    ),
];

/// A cycle, whether its thread lies around a stud, and the parameters that it takes.
type Threading = (u32, bool, &'static [(u16, f64)]);

/// The cycles that mill threads.
const MILLING: [Threading; 5] = [
    (262, false, &[(355, 1.0), (351, 1.0), (253, 750.0), (207, 500.0)]),
    (
        263,
        false,
        &[(356, 0.0), (351, 1.0), (253, 750.0), (357, 0.2), (358, 0.0), (359, 0.0), (254, 150.0), (207, 500.0)],
    ),
    (
        264,
        false,
        &[
            (356, 0.0),
            (351, -1.0),
            (253, 750.0),
            (202, 5.0),
            (258, 0.2),
            (257, 5.0),
            (256, 0.2),
            (358, 0.0),
            (359, 0.0),
            (206, 150.0),
            (207, 500.0),
        ],
    ),
    (265, false, &[(253, 750.0), (358, 0.0), (359, 0.0), (360, 0.0), (254, 150.0), (207, 500.0)]),
    (267, true, &[(355, 1.0), (351, -1.0), (253, 750.0), (358, 0.0), (359, 0.0), (254, 150.0), (207, 500.0)]),
];

fn common(setup: &Setup, depth: f64, own: &[(u16, f64)]) -> Vec<(u16, f64)> {
    let frame = [(200, setup.clearance), (201, depth), (203, setup.surface), (204, setup.second)];
    frame.into_iter().chain(own.iter().copied()).collect()
}

fn scene(setup: &Setup) -> String {
    setup.scene("{T: 1, L: 100, R: 4}") + "machine_parameters: {displayDepthErr: 0}\n"
}

laws! {
    #![proptest_config(config())]

    /// What works downwards and what works upwards are mirror images about the surface, feeds and dwells included.
    #[test]
    fn upwards_is_the_mirror_image_of_downwards(setup in setup(), which in 0..DRILLING.len(), depth in 0.5..20.0_f64) {
        let (cycle, own) = DRILLING[which];
        let setup = Setup { surface: setup.surface.abs(), ..setup };
        let made = |depth: f64| {
            let body = setup.tool(1, 1000.0, "M3") + &definition(cycle, &common(&setup, depth, own)) + "CYCL CALL\n";
            run(&setup.program(&body), &scene(&setup))
        };
        let ((down, events_down), (up, events_up)) = (made(-depth), made(depth));
        prop_assert!(down.status == Status::Done && up.status == Status::Done, "{} {:?} {:?}", cycle, down.fault, up.fault);
        let of = |events: &[ciklo::engine::run::Event]| heights(&setup, events.iter().filter(|event| of_cycle(event, cycle)));
        let (down, up) = (of(&events_down), of(&events_up));
        prop_assert_eq!(down.len(), up.len(), "{}", cycle);
        for (n, ((a, feed_a, rapid_a), (b, feed_b, rapid_b))) in down.iter().zip(&up).enumerate() {
            let (a, b) = (a - setup.surface, b - setup.surface);
            prop_assert!((a + b).abs() < 1e-9, "{cycle}, move {n}: {a} {b}");
            prop_assert!(feed_a == feed_b && rapid_a == rapid_b, "{cycle}, move {n}: {feed_a} {feed_b}");
        }
        let dwells = |events: &[ciklo::engine::run::Event]| events.iter().filter_map(|event| match event.kind {
            EventKind::Dwell(seconds) => Some(seconds),
            _ => None,
        }).collect::<Vec<_>>();
        prop_assert_eq!(dwells(&events_down), dwells(&events_up));
        // A thread that is tapped keeps its hand, whichever way the tap goes.
        let tapped = |events| threads(events).iter().map(|thread| (thread.right, thread.pitch)).collect::<Vec<_>>();
        let (down, up) = (tapped(&events_down), tapped(&events_up));
        if cycle == 206 {
            // With a floating holder the program turns the spindle, so upwards the other hand comes out.
            prop_assert!(down.iter().zip(&up).all(|(a, b)| a.0 != b.0), "{:?} {:?}", down, up);
        } else {
            prop_assert!(down.iter().zip(&up).all(|(a, b)| a.0 == b.0 && (a.1 - b.1).abs() < 1e-9), "{:?} {:?}", down, up);
        }
        prop_assert_eq!(down.len(), up.len());
    }

    /// A milled thread keeps hand, diameter and pitch and lies on the other side of the surface.
    #[test]
    fn milled_threads_lie_on_the_other_side(
        setup in setup(), which in 0..MILLING.len(), depth in 2.0..20.0_f64, pitch in 0.8..2.0_f64, left in any::<bool>(), diameter in 12.0..20.0_f64,
    ) {
        let (cycle, outside, own) = MILLING[which];
        let signed = if left { -pitch } else { pitch };
        let mut found = Vec::new();
        for sign in [-1.0, 1.0] {
            let mut values = common(&setup, sign * depth, own);
            values.extend([(335, diameter), (239, signed)]);
            let body = setup.tool(1, 1000.0, "M3") + &definition(cycle, &values) + "CYCL CALL\n";
            let (outcome, events) = run(&setup.program(&body), &scene(&setup));
            prop_assert_eq!(outcome.status, Status::Done, "{} {:?}", cycle, outcome.fault);
            let threads = threads(&events);
            prop_assert_eq!(threads.len(), 1, "{}", cycle);
            found.extend(threads);
        }
        let floors = [setup.axis.of(found[0].bottom), setup.axis.of(found[1].top)];
        prop_assert!((floors[0] - (setup.surface - depth)).abs() < 1e-7 && (floors[1] - (setup.surface + depth)).abs() < 1e-7, "{cycle} {:?}", found);
        for thread in &found {
            let fits = thread.right != (left != setup.mirrors()) && (thread.pitch - pitch).abs() < 1e-7
                && (thread.diameter - diameter).abs() < 1e-7 && thread.outside == outside;
            prop_assert!(fits, "{cycle} {:?}", thread);
        }
    }

    /// The manuals warn of it: with a positive depth the tool goes at rapid traverse below the surface. It is told.
    #[test]
    fn a_positive_depth_over_material_is_told(setup in setup(), which in 0..DRILLING.len(), depth in 0.5..20.0_f64) {
        let (cycle, own) = DRILLING[which];
        let setup = Setup { surface: setup.surface.abs(), change: Change::None, ..setup };
        let body = setup.tool(1, 1000.0, "M3") + &definition(cycle, &common(&setup, depth, own)) + "CYCL CALL\n";
        let (outcome, events, _, report) = machine(&setup.program(&body), &scene(&setup), HALF / 20.0);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let first = events.iter().position(|event| of_cycle(event, cycle) && matches!(event.kind, EventKind::Move { .. })).expect("a move");
        match events[first + 1].kind {
            EventKind::Finding { kind: FindingKind::Rapid, amount } => {
                prop_assert!((amount - setup.clearance).abs() < 1e-6, "{} {}", amount, setup.clearance);
            }
            ref other => prop_assert!(false, "{cycle}: {other:?}"),
        }
        prop_assert_eq!(report.findings.first().map(|finding| finding.kind), Some(FindingKind::Rapid));
    }
}

/// Without that machine parameter nothing moves.
#[test]
fn a_positive_depth_is_an_error_by_default() {
    let setup = Setup {
        axis: ciklo::engine::geometry::Axis::Z,
        surface: 0.0,
        clearance: 2.0,
        second: 10.0,
        change: Change::None,
    };
    let milling = MILLING.iter().map(|(cycle, _, own)| (*cycle, *own, &[(335, 16.0), (239, 1.0)][..]));
    for (cycle, own, more) in DRILLING.iter().map(|(cycle, own)| (*cycle, *own, &[][..])).chain(milling) {
        let mut values = common(&setup, 5.0, own);
        values.extend(more);
        let body = setup.tool(1, 1000.0, "M3") + &definition(cycle, &values) + "CYCL CALL\n";
        let (outcome, events) = run(&setup.program(&body), &setup.scene("{T: 1, L: 100, R: 4}"));
        assert_eq!(outcome.fault.as_ref().map(|fault| &*fault.code), Some("depth-positive"), "{cycle}");
        assert!(
            !events.iter().any(|event| of_cycle(event, cycle) && matches!(event.kind, EventKind::Move { .. })),
            "{cycle}"
        );
    }
}
