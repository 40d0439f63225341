//! Frames, angles and circles; circle fits against references of 50 digits (`tests/references/circle_fits.py`).
use ciklo::base::expr::{atan2d, cosd, sind};
use ciklo::engine::geometry::{Axis, Circle, FitError, Frame, WorkingPlane, fit_circle};
use glam::{DVec2, DVec3, dvec2, dvec3};
use proptest::prelude::*;

fn near(a: Circle, b: Circle) -> f64 {
    (a.centre - b.centre).length().max((a.radius - b.radius).abs())
}

#[test]
fn fits_equal_the_references() {
    for line in include_str!("../../references/circle_fits.txt").lines() {
        let numbers =
            |text: &str| text.split_whitespace().map(|n| n.parse::<f64>().expect("a number")).collect::<Vec<_>>();
        let (points, expected) = line.split_once('|').expect("a bar");
        let points: Vec<DVec2> = numbers(points).chunks(2).map(|p| dvec2(p[0], p[1])).collect();
        let expected = numbers(expected);
        let expected = Circle { centre: dvec2(expected[0], expected[1]), radius: expected[2] };
        let found = fit_circle(&points).expect("a circle");
        assert!(near(found, expected) < 1e-9, "{found:?} instead of {expected:?}");
    }
}

#[test]
fn bad_points_have_names() {
    let line = [dvec2(0.0, 0.0), dvec2(1.0, 1.0), dvec2(3.0, 3.0)];
    assert_eq!(fit_circle(&line), Err(FitError::Collinear));
    assert_eq!(fit_circle(&[DVec2::ONE; 4]), Err(FitError::Collinear));
    assert_eq!(fit_circle(&line[..2]), Err(FitError::TooFew));
    assert_eq!(fit_circle(&[DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::INFINITY]), Err(FitError::NotFinite));
}

#[test]
fn right_angles_are_whole() {
    for (degrees, sine, cosine) in
        [(0.0, 0.0, 1.0), (90.0, 1.0, 0.0), (180.0, 0.0, -1.0), (-90.0, -1.0, 0.0), (450.0, 1.0, 0.0)]
    {
        assert_eq!((sind(degrees), cosd(degrees)), (sine, cosine), "{degrees}");
    }
    assert!((sind(30.0) - 0.5).abs() < 1e-15);
    assert_eq!(atan2d(1.0, 0.0), 90.0);
}

#[test]
fn working_planes_turn_right_handed() {
    for (tool, main, secondary) in
        [(Axis::Z, Axis::X, Axis::Y), (Axis::Y, Axis::Z, Axis::X), (Axis::X, Axis::Y, Axis::Z)]
    {
        let plane = WorkingPlane::of_tool_axis(tool);
        assert_eq!((plane.main, plane.secondary, plane.tool), (main, secondary, tool));
        assert_eq!(main.unit().cross(secondary.unit()), tool.unit());
        let turned = Frame::rotate(tool, 90.0).point(main.unit());
        assert_eq!(turned, secondary.unit());
        assert_eq!(plane.flat(plane.lift(dvec2(3.0, 4.0), 5.0)), dvec2(3.0, 4.0));
        assert_eq!(tool.of(plane.lift(dvec2(3.0, 4.0), 5.0)), 5.0);
        assert_eq!(Axis::from_letter(tool.letter()), Some(tool));
        assert_eq!(tool.of(tool.with(DVec3::ZERO, 7.0)), 7.0);
    }
}

laws! {
    #![proptest_config(crate::cases::config(256))]

    #[test]
    fn frames_are_rigid_and_have_a_way_back(
        shift in prop::array::uniform3(-500.0..500.0_f64), rotate in prop::array::uniform3(-400.0..400.0_f64),
        a in prop::array::uniform3(-500.0..500.0_f64), b in prop::array::uniform3(-500.0..500.0_f64),
    ) {
        let (a, b) = (DVec3::from(a), DVec3::from(b));
        let frame = Frame::placed(DVec3::from(shift), DVec3::from(rotate));
        let length = (frame.point(a) - frame.point(b)).length();
        prop_assert!((length - (a - b).length()).abs() < 1e-10);
        prop_assert!((frame.inverse().point(frame.point(a)) - a).length() < 1e-10);
        prop_assert!((frame.vector(a) - (frame.point(a) - frame.point(DVec3::ZERO))).length() < 1e-10);
        prop_assert!((frame.of(frame.inverse()).point(a) - a).length() < 1e-10);
        prop_assert!(frame.vector(DVec3::X).cross(frame.vector(DVec3::Y)).dot(frame.vector(DVec3::Z)) > 0.999_999);
    }

    #[test]
    fn points_of_a_circle_give_it_back(
        x in -500.0..500.0_f64, y in -500.0..500.0_f64, radius in 1.0..200.0_f64, start in 0.0..360.0_f64,
        steps in prop::collection::vec(25.0..60.0_f64, 3..6),
    ) {
        let circle = Circle { centre: dvec2(x, y), radius };
        let mut angle = start;
        let points: Vec<DVec2> = steps.iter().map(|step| {
            angle += step;
            circle.centre + dvec2(cosd(angle), sind(angle)) * radius
        }).collect();
        prop_assert!(near(fit_circle(&points).expect("a circle"), circle) < 1e-9);
    }

    #[test]
    fn a_fit_is_a_minimum_and_moves_with_its_points(
        noise in prop::collection::vec(-0.3..0.3_f64, 5..12), shift in prop::array::uniform2(-300.0..300.0_f64), turn in 0.0..360.0_f64,
    ) {
        let count = noise.len() as f64;
        let points: Vec<DVec2> = noise.iter().enumerate().map(|(k, noise)| {
            let angle = 300.0 * k as f64 / count;
            dvec2(cosd(angle), sind(angle)) * (20.0 + noise)
        }).collect();
        let cost = |circle: Circle| -> f64 { points.iter().map(|p| ((p - circle.centre).length() - circle.radius).powi(2)).sum() };
        let found = fit_circle(&points).expect("a circle");
        for (dx, dy, dr) in [(1e-4, 0.0, 0.0), (-1e-4, 0.0, 0.0), (0.0, 1e-4, 0.0), (0.0, -1e-4, 0.0), (0.0, 0.0, 1e-4), (0.0, 0.0, -1e-4)] {
            let other = Circle { centre: found.centre + dvec2(dx, dy), radius: found.radius + dr };
            prop_assert!(cost(other) > cost(found));
        }
        let frame = Frame::placed(dvec3(shift[0], shift[1], 0.0), dvec3(0.0, 0.0, turn));
        let flat = WorkingPlane::of_tool_axis(Axis::Z);
        let move_it = |p: DVec2| flat.flat(frame.point(flat.lift(p, 0.0)));
        let moved: Vec<DVec2> = points.iter().map(|p| move_it(*p)).collect();
        let expected = Circle { centre: move_it(found.centre), radius: found.radius };
        prop_assert!(near(fit_circle(&moved).expect("a circle"), expected) < 1e-9);
    }
}
