//! Holes in scaled systems, and drilling on in a pilot hole.
use ciklo::engine::run::{EventKind, MoveKind};
use glam::DVec2;
use proptest::prelude::*;

use super::setup::{Change, Setup, config, definition, places, pre_drilled, setup};

laws! {
    #![proptest_config(config())]

    /// Places, surfaces and depths are scaled, whatever else changes the system; the drill is what it is.
    #[test]
    fn scaled_holes_keep_the_drill(
        setup in setup(), places in places(), depth in 0.5..18.0_f64, infeed in 0.5..20.0, radius in 1.0..6.0_f64, factor in 0.4..1.5_f64,
        first in any::<bool>(),
    ) {
        // The blank stays where it is: its surface, seen in the scaled system.
        let Setup { clearance, surface, second, .. } = setup;
        let values = [
            (200, clearance), (201, -depth), (206, 250.0), (202, infeed), (210, 0.0), (203, surface / factor), (204, second), (211, 0.1),
        ];
        let scale = format!("CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL{factor}\n");
        let letter = setup.axis.letter();
        let drilled = format!("TOOL CALL 1 {letter} S2000 F300\nL {letter}+100 R0 FMAX M3\n")
            + &definition(200, &values)
            + &setup.calls(&places)
            + &format!("L {letter}+100 R0 FMAX\nCYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL1\n");
        // What is defined first acts last.
        let plain = Setup { change: Change::None, ..setup.clone() };
        let body = if first { setup.changed() + &scale } else { scale + &setup.changed() } + &drilled;
        let made = plain.machined(&body, &plain.scene(&format!("{{T: 1, L: 100, R: {radius}}}")), 0.9)?;
        let at = |place: DVec2| if first { setup.seen(place * factor) } else { setup.seen(place) * factor };
        let holes = places.iter().map(|place| plain.hole(at(*place), surface - factor * depth, radius)).collect();
        made.is(&plain.part(holes), factor * infeed.min(depth))?;
    }

    /// A deepened starting point lies in a hole that is there: the drill goes there at its own feed, and cuts from there on.
    #[test]
    fn drilling_goes_on_in_a_pilot_hole(
        setup in setup(), place in (-15.0..15.0, -15.0..15.0).prop_map(DVec2::from), depth in 2.0..29.0_f64, share in 0.1..0.9, radius in 1.0..6.0_f64,
        infeed in 1.0..12.0, less in 0.0..1.0, stops in (0.2..1.0, 0.2..1.0), breaks in prop_oneof![Just(0.0), 0.5..6.0],
    ) {
        let Setup { clearance, surface, second, .. } = setup;
        let begin = depth * share;
        let values = [
            (200, clearance), (201, -depth), (206, 150.0), (202, infeed), (203, surface), (204, second), (212, less),
            (205, infeed * 0.3), (258, stops.0), (259, stops.1), (257, breaks), (256, 0.2), (211, 0.25), (379, begin), (253, 777.0),
        ];
        let tools = format!("{{T: 1, L: 100, R: {radius}}}, {{T: 2, L: 100, R: {radius}}}");
        let body = pre_drilled(&setup, place, begin) + &setup.tool(1, 1200.0, "M3") + &definition(205, &values) + &setup.calls(&[place]);
        let made = setup.machined(&body, &setup.scene(&tools), 0.9)?;
        let deepest = if breaks > 0.0 { f64::min(infeed, breaks) } else { infeed };
        made.is(&setup.part(vec![setup.hole(place, surface - depth, radius)]), deepest.min(depth - begin).max(begin))?;
        let first = made.of_cycle(205).filter_map(|event| match &event.kind {
            EventKind::Move { kind: MoveKind::Feed, to, feed, .. } => Some((setup.axis.of(*to), *feed)),
            _ => None,
        }).take(2).collect::<Vec<_>>();
        let first_cut = surface - begin - deepest.min(depth - begin);
        let fits = first.len() == 2 && (first[0].0 - (surface - begin + clearance)).abs() < 1e-9 && (first[0].1 - 777.0).abs() < 1e-9
            && (first[1].0 - first_cut).abs() < 1e-9 && (first[1].1 - 150.0).abs() < 1e-9;
        prop_assert!(fits, "{:?} {}{}", first, first_cut, made.text);
    }
}
