//! Laws of contacts over random solids, against a membership test of its own and samples of the ball.
use ciklo::engine::geometry::{Axis, Frame};
use ciklo::engine::solid::{Body, Path, Shape, SolidError};
use glam::{DVec3, dvec3};
use proptest::prelude::*;

/// Whether a point is in the inside of a shape, deeper than `by` (a rough depth), by the definition alone.
fn inside(shape: &Shape, p: DVec3) -> bool {
    match shape {
        Shape::HalfSpace { point, normal } => (p - *point).dot(*normal) < 0.0,
        Shape::Box { min, max } => p.cmpgt(*min).all() && p.cmplt(*max).all(),
        Shape::Cylinder { from, to, radius } => in_cone(p, *from, *to, *radius, *radius),
        Shape::Cone { from, to, radius_from, radius_to } => in_cone(p, *from, *to, *radius_from, *radius_to),
        Shape::Sphere { centre, radius } => (p - *centre).length() < *radius,
        Shape::Union(shapes) => shapes.iter().any(|shape| inside(shape, p)),
        Shape::Difference(shapes) => shapes
            .split_first()
            .is_some_and(|(first, rest)| inside(first, p) && !rest.iter().any(|shape| inside(shape, p))),
        Shape::Placed { frame, shape } => inside(shape, frame.inverse().point(p)),
        Shape::Mesh(_) => unreachable!("triangulated surfaces have laws of their own"),
    }
}

fn in_cone(p: DVec3, from: DVec3, to: DVec3, start: f64, end: f64) -> bool {
    let axis = to - from;
    let share = (p - from).dot(axis) / axis.length_squared();
    let across = (p - from - axis * share).length();
    share > 0.0 && share < 1.0 && across < start + (end - start) * share
}

/// Directions spread over the sphere.
fn directions() -> Vec<DVec3> {
    let golden = 2.399_963_229_728_653;
    (0..400)
        .map(|k| {
            let z = 1.0 - (2.0 * k as f64 + 1.0) / 400.0;
            let flat = (1.0 - z * z).sqrt();
            dvec3(flat * (golden * k as f64).cos(), flat * (golden * k as f64).sin(), z)
        })
        .collect()
}

fn round_number(low: i32, high: i32) -> impl Strategy<Value = f64> {
    (low * 4..=high * 4).prop_map(|k| f64::from(k) / 4.0)
}

fn point(reach: i32) -> impl Strategy<Value = DVec3> {
    (round_number(-reach, reach), round_number(-reach, reach), round_number(-reach, reach))
        .prop_map(|(x, y, z)| dvec3(x, y, z))
}

/// Boxes, cylinders and cones along the axes, and spheres: their edges are lines and circles, or unsupported.
fn primitive() -> impl Strategy<Value = Shape> {
    let size = || round_number(2, 14);
    prop_oneof![
        (point(8), size(), size(), size()).prop_map(|(min, x, y, z)| Shape::Box { min, max: min + dvec3(x, y, z) }),
        (point(8), 0..3_usize, size(), size()).prop_map(|(from, axis, length, radius)| {
            Shape::Cylinder { from, to: from + Axis::ALL[axis].unit() * length, radius }
        }),
        (point(8), 0..3_usize, size(), size(), round_number(0, 6)).prop_map(|(from, axis, length, start, end)| {
            Shape::Cone { from, to: from + Axis::ALL[axis].unit() * length, radius_from: start, radius_to: end }
        }),
        (point(8), size()).prop_map(|(centre, radius)| Shape::Sphere { centre, radius }),
    ]
}

/// Any primitive turned, and half-spaces at a slant.
fn slanted() -> impl Strategy<Value = Shape> {
    let turned = (primitive(), point(4), point(90)).prop_map(|(shape, shift, rotate)| Shape::Placed {
        frame: Frame::placed(shift, rotate),
        shape: Box::new(shape),
    });
    let half = (point(6), point(5))
        .prop_filter("a direction", |(_, normal)| *normal != DVec3::ZERO)
        .prop_map(|(point, normal)| Shape::HalfSpace { point, normal });
    prop_oneof![turned, half]
}

fn shape() -> impl Strategy<Value = Shape> {
    prop_oneof![
        prop::collection::vec(prop_oneof![primitive(), slanted()], 1..4).prop_map(Shape::Union),
        prop::collection::vec(prop_oneof![primitive(), slanted()], 2..4).prop_map(Shape::Difference),
        primitive(),
        prop::collection::vec(primitive(), 1..4).prop_map(Shape::Union),
        prop::collection::vec(primitive(), 2..4).prop_map(Shape::Difference),
        (primitive(), prop::collection::vec(primitive(), 1..3))
            .prop_map(|(first, rest)| Shape::Difference(vec![first, Shape::Union(rest)])),
    ]
}

fn path() -> impl Strategy<Value = Path> {
    prop_oneof![
        (point(30), point(12)).prop_map(|(from, to)| Path::line(from, to)),
        (point(12), 0..3_usize, point(30), round_number(-400, 400)).prop_map(|(centre, axis, from, sweep)| Path::Arc {
            centre,
            axis: Axis::ALL[axis].unit(),
            from,
            sweep,
            rise: 0.0
        }),
    ]
}

fn frame() -> impl Strategy<Value = Frame> {
    (point(100), (round_number(-180, 180), round_number(-180, 180), round_number(-180, 180)))
        .prop_map(|(shift, (a, b, c))| Frame::placed(shift, dvec3(a, b, c)))
}

fn moved(path: &Path, frame: &Frame) -> Path {
    match *path {
        Path::Line { from, to } => Path::line(frame.point(from), frame.point(to)),
        Path::Arc { centre, axis, from, sweep, rise } => {
            Path::Arc { centre: frame.point(centre), axis: frame.vector(axis), from: frame.point(from), sweep, rise }
        }
    }
}

/// A ball a little smaller than the real one must be free of material.
fn assert_free(shape: &Shape, centre: DVec3, radius: f64) -> Result<(), TestCaseError> {
    for share in [0.3, 0.7, 0.95, 1.0] {
        for direction in directions() {
            let p = centre + direction * (radius * share - 1e-7);
            prop_assert!(!inside(shape, p), "{p} is inside, ball at {centre}");
        }
    }
    prop_assert!(!inside(shape, centre));
    Ok(())
}

laws! {
    #![proptest_config(crate::cases::config(400))]

    #[test]
    fn contact_is_on_the_surface_and_the_first(shape in shape(), path in path(), radius in round_number(1, 6)) {
        let body = Body::new(&shape).expect("a sound shape");
        let found = match body.first_contact_on(radius, &path) {
            Ok(found) => found,
            Err(SolidError::Edge(_) | SolidError::Cusp(_)) => return Ok(()),
            Err(other) => return Err(TestCaseError::fail(format!("{other:?}"))),
        };
        let end = found.map_or(1.0, |contact| contact.t);
        if let Some(contact) = found.filter(|contact| !contact.deflected) {
            let away = contact.ball_centre - contact.point;
            prop_assert!((away.length() - radius).abs() < 1e-9);
            prop_assert!((path.at(contact.t) - contact.ball_centre).length() < 1e-9);
            prop_assert!((away / radius - contact.normal).length() < 1e-9);
            // Material next to the point: some point within 1e-6 is inside, and the ball itself is free of it.
            let near = |reach: f64| directions().into_iter().any(|d| inside(&shape, contact.point + d * reach));
            prop_assert!(near(1e-6) || near(1e-5) || near(1e-4), "no material at {}", contact.point);
            // A little later the ball is in it.
            let later = path.at((contact.t + 1e-7).min(1.0));
            prop_assert!(contact.t > 1.0 - 1e-6 || (later - contact.point).length() < radius);
        }
        if found.is_none_or(|contact| !contact.deflected) {
            for k in 0..=24 {
                assert_free(&shape, path.at(end * f64::from(k) / 24.0), radius)?;
            }
        } else {
            // Deflected means overlap: some point of the ball is inside.
            let centre = path.at(0.0);
            prop_assert!(body.touches(radius, centre) == Ok(true) || inside(&shape, centre));
        }
    }

    #[test]
    fn a_moved_world_moves_the_contact(shape in shape(), path in path(), radius in round_number(1, 6), frame in frame()) {
        let here = Body::new(&shape).expect("a sound shape").first_contact_on(radius, &path);
        let placed = Shape::Placed { frame, shape: Box::new(shape) };
        let there = Body::new(&placed).expect("a sound shape").first_contact_on(radius, &moved(&path, &frame));
        match (here, there) {
            (Ok(Some(a)), Ok(Some(b))) => {
                let slow = (a.ball_centre - b.ball_centre).length();
                // A grazing approach leaves the moment open, never the distance.
                let expected = frame.point(a.ball_centre);
                let way = path.length().max(1.0);
                prop_assert!((expected - b.ball_centre).length() < 1e-9 || grazing(&a.normal, &path, a.t), "{a:?} {b:?} {slow} {way}");
            }
            (Ok(None), Ok(None)) | (Err(_), Err(_)) => {}
            (Ok(Some(a)), Ok(None)) => prop_assert!(grazing(&a.normal, &path, a.t), "{a:?} was lost"),
            (Ok(None), Ok(Some(b))) => prop_assert!(grazing(&frame.inverse().vector(b.normal), &path, b.t), "{b:?} came"),
            // Limits are found by tolerances, so a limit in one world may just be avoided in the other.
            (Err(SolidError::Edge(_) | SolidError::Cusp(_)), _) | (_, Err(SolidError::Edge(_) | SolidError::Cusp(_))) => {}
            (a, b) => prop_assert!(false, "{a:?} {b:?}"),
        }
    }

    /// A shaft is all balls along its axis: it touches where one of them does, and is free where none comes near.
    #[test]
    fn a_shaft_touches_where_a_ball_of_it_does(
        shape in shape(), path in path(), radius in round_number(1, 3), axis in point(20), turned in any::<bool>(),
    ) {
        prop_assume!(axis.length() > 1.0);
        let body = Body::new(&shape).expect("a sound shape");
        let way = |share: f64| match path {
            // All points of the shaft turn about the same axis, or all move alike.
            Path::Arc { centre, axis: about, from, sweep, rise } if turned => {
                let from = from + axis * share;
                Path::Arc { centre: centre + about * (from - centre).dot(about), axis: about, from, sweep, rise }
            }
            _ => path.moved(axis * share),
        };
        let Ok(found) = body.shaft_contact(radius, axis.length(), &way) else { return Ok(()) };
        if let Some(contact) = found {
            // The point belongs to the solid and lies on the shaft at some moment of the movement.
            let gap = (contact.ball_centre - contact.point).length() - radius;
            prop_assert!(contact.deflected || gap.abs() < 1e-5, "{gap}");
            prop_assert!(body.contains(contact.point).unwrap_or(true));
        } else {
            for k in 0..=60 {
                let one = body.first_contact_on(radius, &way(f64::from(k) / 60.0));
                prop_assert!(matches!(one, Ok(None)), "at {k}: {one:?}");
            }
        }
    }

    #[test]
    fn distance_changes_no_faster_than_the_point(shape in shape(), a in point(25), b in point(25)) {
        let body = Body::new(&shape).expect("a sound shape");
        if let (Ok(Some(near)), Ok(Some(far))) = (body.nearest(a), body.nearest(b)) {
            prop_assert!((near.distance - far.distance).abs() <= (a - b).length() + 1e-9);
            prop_assert!(((near.point - a).length() - near.distance).abs() < 1e-9);
        }
    }
}

fn grazing(normal: &DVec3, path: &Path, t: f64) -> bool {
    let way = path.at(t + 1e-6) - path.at(t - 1e-6);
    way.normalize_or_zero().dot(*normal).abs() < 1e-3
}
