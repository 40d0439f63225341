//! 202, 204 and 241: tools with one edge, bars from below, single-lip drills.
use ciklo::engine::run::{Event, EventKind};
use ciklo::engine::solid::Shape;
use glam::DVec2;
use proptest::prelude::*;

use super::setup::{HEIGHT, Made, Setup, config, definition, heights, places, pre_drilled, setup};

/// The direction in which the program takes the tool off the wall.
fn direction(code: u8) -> DVec2 {
    match code {
        1 => -DVec2::X,
        2 => -DVec2::Y,
        3 => DVec2::X,
        4 => DVec2::Y,
        _ => DVec2::ZERO,
    }
}

/// Where the tip is while the spindle stands, in the coordinates of the plane with the height: ends of moves.
fn while_it_stands(setup: &Setup, made: &Made, cycle: u32) -> Vec<(DVec2, f64)> {
    let (mut stands, mut found) = (false, Vec::new());
    for event in made.of_cycle(cycle) {
        match &event.kind {
            EventKind::Spindle { direction, .. } => stands = *direction == 0,
            EventKind::Move { from, to, .. } if stands => {
                found.extend([*from, *to].map(|point| (setup.plane().flat(point), setup.axis.of(point))));
            }
            _ => {}
        }
    }
    found
}

fn oriented<'a>(events: impl Iterator<Item = &'a Event>) -> Vec<f64> {
    let angle = |event: &Event| match event.kind {
        EventKind::Spindle { orient, .. } => orient,
        _ => None,
    };
    events.filter_map(angle).collect()
}

laws! {
    #![proptest_config(config())]

    /// The hole has the radius of the edge; off the wall, neither the bar nor its one edge touches it on the way out.
    #[test]
    fn boring_leaves_holes_without_a_scratch(
        setup in setup(), places in places(), depth in 0.5..29.0_f64, radius in 3.0..7.0_f64, bar in 0.4..0.9, code in 0..5_u8,
        angle in -360.0..360.0_f64, back in prop_oneof![Just(0.0), 100.0..900.0],
    ) {
        let Setup { clearance, surface, second, .. } = setup;
        let tools = format!("{{T: 1, L: 100, R: {radius}, neck: {{head: 2, radius: {}}}}}", radius * bar);
        let values = [
            (200, clearance), (201, -depth), (206, 100.0), (211, 0.5), (208, back), (203, surface), (204, second),
            (214, f64::from(code)), (336, angle),
        ];
        let body = setup.tool(1, 1200.0, "M3") + &definition(202, &values) + &setup.calls(&places);
        let made = setup.machined(&body, &setup.scene(&tools), 0.9)?;
        let holes = places.iter().map(|place| setup.hole(*place, surface - depth, radius)).collect();
        made.is(&setup.part(holes), depth)?;
        prop_assert_eq!(oriented(made.of_cycle(202)), vec![angle; places.len()], "{}", made.text);
        // The edge was turned against the direction in which the tool leaves the wall.
        for (tip, height) in while_it_stands(&setup, &made, 202) {
            // Of its own hole, though another one may be as near to it as the edge is taken off the wall.
            let aside = direction(code) * 0.2;
            let from_hole = |off: &DVec2| off.length().min((*off - aside).length());
            let place = places.iter().map(|place| tip - *place);
            let off = place.min_by(|a, b| from_hole(a).total_cmp(&from_hole(b))).expect("a place");
            let edge = off - direction(code) * radius;
            let moved = off.length() > 1e-9;
            prop_assert!((off - aside).length() < 1e-9 || !moved, "{:?}{}", off, made.text);
            prop_assert!(edge.length() <= radius + 1e-9, "{:?} at {}{}", edge, height, made.text);
            // Upwards only beside the wall.
            prop_assert!(code == 0 || moved || (height - (surface - depth)).abs() < 1e-9, "{}{}", height, made.text);
        }
        let out = heights(&setup, made.of_cycle(202)).iter().filter(|(height, _, _)| *height > surface).map(|m| m.1).collect::<Vec<_>>();
        let wanted = if back == 0.0 { 100.0 } else { back };
        prop_assert!(out.iter().any(|feed| (feed - wanted).abs() < 1e-9), "{:?}{}", out, made.text);
    }

    /// The bar goes through the bore beside its centre, counterbores from below to the depth, and comes out again.
    #[test]
    fn back_boring_leaves_counterbores(
        setup in setup(), place in (-12.0..12.0, -12.0..12.0).prop_map(DVec2::from), bar in 2.0..4.0_f64, off in 0.6..3.0_f64,
        gap in 0.01..0.3_f64, play in 0.01..0.3_f64, depth in 0.3..20.0_f64, height in 2.0..20.0, code in 1..5_u8, angle in -360.0..360.0_f64,
        wait in prop_oneof![Just(0.0), 0.1..1.0],
    ) {
        let Setup { clearance, surface, second, .. } = setup;
        let hole = bar + off + gap;
        let radius = hole + off - play;
        let tools = format!(
            "{{T: 1, L: 100, R: {radius}, neck: {{head: {height}, radius: {bar}}}}}, {{T: 2, L: 100, R: {hole}}}",
        );
        let values = [
            (200, clearance), (249, depth), (250, HEIGHT), (251, off), (252, height), (253, 700.0), (254, 150.0), (255, wait),
            (203, surface), (204, second), (214, f64::from(code)), (336, angle),
        ];
        let body = pre_drilled(&setup, place, HEIGHT + 1.0) + &setup.tool(1, 1200.0, "M3") + &definition(204, &values)
            + &setup.calls(&[place]);
        let made = setup.machined(&body, &setup.scene(&tools), 0.7)?;
        let under = surface - HEIGHT;
        let bores = vec![setup.hole(place, under - 60.0, hole), setup.cylinder(place, under - 1.0, under + depth, radius)];
        made.is(&setup.part(bores), HEIGHT.max(depth))?;
        prop_assert_eq!(oriented(made.of_cycle(204)), vec![angle; 2], "{}", made.text);
        for (tip, low) in while_it_stands(&setup, &made, 204) {
            // The edge, on the side from which the tool moved away, and the bar are within the bore.
            let (edge, inside) = (tip - place - direction(code) * radius, low + height < surface && low + height > under);
            prop_assert!(!inside || edge.length() <= hole + 1e-9, "{:?} at {}{}", edge, low, made.text);
            prop_assert!(low > surface || (tip - place).length() + bar <= hole + 1e-9 || low + height < under, "{}", made.text);
        }
        let waits: Vec<f64> = made.of_cycle(204).filter_map(|event| match event.kind {
            EventKind::Dwell(seconds) => Some(seconds),
            _ => None,
        }).collect();
        prop_assert_eq!(waits, if wait > 0.0 { vec![wait] } else { Vec::new() }, "{}", made.text);
    }

    /// With a negative depth the bar works downwards: from above a ledge within the workpiece into it, with its edge at the tip.
    #[test]
    fn a_negative_depth_counterbores_a_ledge_from_above(
        setup in setup(), place in (-8.0..8.0, -8.0..8.0).prop_map(DVec2::from), bar in 2.0..4.0_f64, off in 0.6..3.0_f64, gap in 0.01..0.3_f64,
        cut in 0.2..3.0_f64, play in 0.05..0.5_f64, ledge in 6.0..20.0_f64, depth in 0.3..8.0_f64, code in 1..5_u8, angle in -360.0..360.0_f64,
    ) {
        let Setup { clearance, surface, second, .. } = setup;
        let hole = bar + off + gap;
        let radius = hole + cut;
        // The offset bar with its edge fits into the wide bore.
        let wide = radius + off + play;
        // The least height of the edge over the tip that the cycle takes.
        let lip = 0.0001;
        let tools = format!(
            "{{T: 1, L: 100, R: {radius}, neck: {{head: 2, radius: {bar}}}}}, {{T: 2, L: 100, R: {hole}}}, {{T: 3, L: 100, R: {wide}}}",
        );
        let widening = [
            (200, clearance), (201, -ledge), (206, 250.0), (202, ledge), (210, 0.0), (203, surface), (204, 40.0), (211, 0.0),
        ];
        let values = [
            (200, clearance), (249, -depth), (250, ledge), (251, off), (252, lip), (253, 700.0), (254, 150.0), (255, 0.0),
            (203, surface), (204, second), (214, f64::from(code)), (336, angle),
        ];
        let body = pre_drilled(&setup, place, HEIGHT + 1.0) + &setup.tool(3, 1000.0, "M3") + &definition(200, &widening)
            + &setup.calls(&[place]) + &setup.tool(1, 1200.0, "M3") + &definition(204, &values) + &setup.calls(&[place]);
        let made = setup.machined(&body, &setup.scene(&tools), 0.7)?;
        let ledge = surface - ledge;
        let bores = vec![
            setup.hole(place, surface - HEIGHT - 60.0, hole), setup.hole(place, ledge, wide), setup.hole(place, ledge - depth - lip, radius),
        ];
        made.is(&setup.part(bores), HEIGHT)?;
        prop_assert_eq!(oriented(made.of_cycle(204)), vec![angle; 2], "{}", made.text);
        let lowest = heights(&setup, made.of_cycle(204)).iter().map(|(height, _, _)| *height).fold(f64::INFINITY, f64::min);
        prop_assert!((lowest - (ledge - depth - lip)).abs() < 1e-9, "{}{}", lowest, made.text);
        // Offset only above the ledge, by the set-up clearance.
        for (tip, low) in while_it_stands(&setup, &made, 204) {
            prop_assert!(low >= ledge + clearance - lip - 1e-9 || (tip - place).length() < 1e-9, "{} at {}{}", tip, low, made.text);
        }
    }

    /// Speeds and coolant belong to the place of the drill, and the hole to the whole.
    #[test]
    fn single_lip_drilling_leaves_holes(
        setup in setup(), place in (-15.0..15.0, -15.0..15.0).prop_map(DVec2::from), radius in 1.0..6.0_f64, depth in 1.0..29.0_f64,
        start in prop_oneof![Just(0.0), 0.1..0.9], turning in 3..6_u8, slow in 20.0..60.0_f64, fast in 400.0..900.0_f64, wait in 0.0..1.0,
        back in prop_oneof![Just(0.0), 100.0..900.0],
    ) {
        let Setup { clearance, surface, second, .. } = setup;
        let begin = depth * start;
        let (slow, fast) = (slow.round(), fast.round());
        let tools = format!("{{T: 1, L: 100, R: {radius}}}, {{T: 2, L: 100, R: {radius}}}");
        let values = [
            (200, clearance), (201, -depth), (206, 90.0), (211, wait), (203, surface), (204, second), (379, begin), (253, 600.0),
            (208, back), (426, f64::from(turning)), (427, slow), (428, fast), (429, 8.0), (430, 9.0),
        ];
        let before = if begin > 0.0 { pre_drilled(&setup, place, begin) } else { String::new() };
        let body = before + &setup.tool(1, 1200.0, "M3") + &definition(241, &values) + &setup.calls(&[place]);
        let made = setup.machined(&body, &setup.scene(&tools), 0.7)?;
        made.is(&setup.part(vec![setup.hole(place, surface - depth, radius)]), depth)?;
        let wanted_turning = match turning { 3 => 1, 4 => -1, _ => 0 };
        let (mut speed, mut direction, mut coolant, mut seen) = (1200.0, 1, false, 0);
        for event in made.of_cycle(241) {
            match &event.kind {
                EventKind::Spindle { direction: now, speed: rate, .. } => (direction, speed) = (*now, *rate),
                EventKind::Coolant(on) => coolant = *on,
                EventKind::Move { from, to, feed, .. } => {
                    let (from, to) = (setup.axis.of(*from), setup.axis.of(*to));
                    let slowly = if wanted_turning == 0 { 0.0 } else { slow };
                    if (feed - 90.0).abs() < 1e-9 && to < from {
                        seen += 1;
                        prop_assert_eq!((direction, speed, coolant), (1, fast, true), "{}", made.text);
                        prop_assert!((to - (surface - depth)).abs() < 1e-9, "{}{}", to, made.text);
                        // Only the advanced stop lies between what was pre-drilled and the drill.
                        let stop = if begin > 0.0 { surface - begin } else { surface } + clearance;
                        prop_assert!((from - stop).abs() < 1e-9, "{} is not {}{}", from, stop, made.text);
                    } else if to > from && from < surface {
                        prop_assert_eq!((direction, speed, coolant), (wanted_turning, slowly, false), "{}", made.text);
                        let wanted = if back == 0.0 { 90.0 } else { back };
                        prop_assert!((feed - wanted).abs() < 1e-9, "{}{}", feed, made.text);
                    } else if to < from && begin > 0.0 && (feed - 600.0).abs() < 1e-9 {
                        prop_assert_eq!((direction, speed), (wanted_turning, slowly), "{}", made.text);
                    }
                }
                _ => {}
            }
        }
        prop_assert_eq!(seen, 1, "{}", made.text);
    }
}

/// The walls of shapes lie where a shape of its own would have them: the comparison is none that always agrees.
#[test]
fn another_part_is_told_apart() {
    let setup = Setup {
        axis: ciklo::engine::geometry::Axis::Z,
        surface: 0.0,
        clearance: 2.0,
        second: 0.0,
        change: super::setup::Change::Mirror(true),
    };
    let place = DVec2::new(5.0, 3.0);
    let body = pre_drilled(&setup, place, 10.0);
    let made = setup.machined(&body, &setup.scene("{T: 2, L: 100, R: 4}"), 0.7).expect("a run");
    let hole = |place: DVec2, depth: f64, radius: f64| -> Shape { setup.part(vec![setup.hole(place, -depth, radius)]) };
    assert!(made.is(&hole(place, 10.0, 4.0), 10.0).is_ok());
    assert!(made.is(&hole(-place, 10.0, 4.0), 10.0).is_err());
    assert!(made.is(&hole(place, 10.1, 4.0), 10.0).is_err());
    assert!(made.is(&hole(place, 10.0, 4.4), 10.0).is_err());
    assert!(made.is(&hole(place, 10.0, 4.0), 9.0).is_err());
}
