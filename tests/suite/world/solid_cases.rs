//! Contacts whose numbers follow from school geometry; each expectation stands beside its derivation.
use ciklo::engine::geometry::Frame;
use ciklo::engine::solid::{Body, Contact, Path, Shape, SolidError};
use glam::{DVec3, dvec3};

fn body(shape: Shape) -> Body {
    Body::new(&shape).expect("a sound shape")
}

fn block(min: [f64; 3], max: [f64; 3]) -> Shape {
    Shape::Box { min: DVec3::from(min), max: DVec3::from(max) }
}

/// A vertical cylinder between two heights.
fn upright(x: f64, y: f64, radius: f64, from: f64, to: f64) -> Shape {
    Shape::Cylinder { from: dvec3(x, y, from), to: dvec3(x, y, to), radius }
}

/// A block whose top is at z = 0 with a blind hole of radius 10 and depth 20 in its middle.
fn bored() -> Shape {
    Shape::Difference(vec![block([-50.0, -50.0, -40.0], [50.0, 50.0, 0.0]), upright(0.0, 0.0, 10.0, 0.0, -20.0)])
}

fn contact(shape: Shape, radius: f64, from: [f64; 3], to: [f64; 3]) -> Option<Contact> {
    body(shape).first_contact(radius, DVec3::from(from), DVec3::from(to)).expect("a supported question")
}

#[track_caller]
fn assert_centre(found: Option<Contact>, expected: [f64; 3]) {
    let found = found.expect("a contact");
    let gap = (found.ball_centre - DVec3::from(expected)).length();
    assert!(gap < 1e-9, "{found:?} instead of {expected:?}");
    assert!(!found.deflected);
}

#[test]
fn face_of_a_box() {
    let found = contact(block([0.0; 3], [10.0, 20.0, 30.0]), 2.0, [30.0, 5.0, 5.0], [0.0, 5.0, 5.0]);
    assert_centre(found, [12.0, 5.0, 5.0]);
    let found = found.expect("a contact");
    assert_eq!(found.normal, DVec3::X);
    assert!((found.point - dvec3(10.0, 5.0, 5.0)).length() < 1e-12);
    assert!((found.t - 0.6).abs() < 1e-12);
}

#[test]
fn wall_floor_and_mouth_of_a_hole() {
    // Radius 10 less ball radius 1.5.
    assert_centre(contact(bored(), 1.5, [0.0, 0.0, -5.0], [40.0, 0.0, -5.0]), [8.5, 0.0, -5.0]);
    assert_centre(contact(bored(), 1.5, [0.0, 0.0, -5.0], [0.0, -40.0, -5.0]), [0.0, -8.5, -5.0]);
    // The mouth lies in the top face and must not hold the ball; the floor is at -20.
    assert_centre(contact(bored(), 1.5, [3.0, 0.0, 30.0], [3.0, 0.0, -30.0]), [3.0, 0.0, -18.5]);
    // Off the axis by 6: the chord reaches sqrt(8.5² - 6²) = 6.020797289396148.
    assert_centre(contact(bored(), 1.5, [0.0, 6.0, -5.0], [40.0, 6.0, -5.0]), [6.020797289396148, 6.0, -5.0]);
}

#[test]
fn rim_of_a_hole_edge_and_corner_of_a_box() {
    // A ball of radius 15 rests on the rim of radius 10: sqrt(15² - 10²).
    assert_centre(contact(bored(), 15.0, [0.0, 0.0, 50.0], [0.0, 0.0, 0.0]), [0.0, 0.0, 125.0_f64.sqrt()]);
    // Off the axis the near side of the rim is touched first: centre at x = 1, rim at x = 10, sqrt(15² - 9²) = 12.
    assert_centre(contact(bored(), 15.0, [1.0, 0.0, 50.0], [1.0, 0.0, 0.0]), [1.0, 0.0, 12.0]);
    // Edge x = 50, z = 0 at height 3 with radius 5: 50 + sqrt(5² - 3²).
    assert_centre(contact(bored(), 5.0, [90.0, 1.0, 3.0], [0.0, 1.0, 3.0]), [54.0, 1.0, 3.0]);
    // Corner (50, 50, 0) with offsets 2, 2 and radius 3: 2² + 2² + 1² = 3².
    assert_centre(contact(bored(), 3.0, [52.0, 52.0, 20.0], [52.0, 52.0, -20.0]), [52.0, 52.0, 1.0]);
}

#[test]
fn sphere_cone_and_countersink() {
    let sphere = Shape::Sphere { centre: dvec3(1.0, 2.0, 3.0), radius: 12.5 };
    // Radii add up: 12.5 + 2.
    assert_centre(contact(sphere.clone(), 2.0, [40.0, 2.0, 3.0], [1.0, 2.0, 3.0]), [15.5, 2.0, 3.0]);
    // Side by 8.7: sqrt(14.5² - 8.7²) = 11.6.
    assert_centre(contact(sphere, 2.0, [40.0, 10.7, 3.0], [1.0, 10.7, 3.0]), [12.6, 10.7, 3.0]);
    let cone = Shape::Cone { from: DVec3::ZERO, to: dvec3(0.0, 0.0, 10.0), radius_from: 10.0, radius_to: 0.0 };
    // On the 45 degree side (x + z - 10) / sqrt 2 = 1 at z = 5.
    assert_centre(contact(cone.clone(), 1.0, [30.0, 0.0, 5.0], [0.0, 0.0, 5.0]), [5.0 + 2.0_f64.sqrt(), 0.0, 5.0]);
    // The tip from above.
    assert_centre(contact(cone.clone(), 1.0, [0.0, 0.0, 30.0], [0.0, 0.0, 0.0]), [0.0, 0.0, 11.0]);
    let sunk = Shape::Difference(vec![
        block([-50.0, -50.0, -40.0], [50.0, 50.0, 0.0]),
        Shape::Cone { from: DVec3::ZERO, to: dvec3(0.0, 0.0, -10.0), radius_from: 10.0, radius_to: 0.0 },
    ]);
    // Inside the countersink the ball sinks until the side is 1 away: z = -10 + sqrt 2.
    assert_centre(contact(sunk, 1.0, [0.0, 0.0, 30.0], [0.0, 0.0, -30.0]), [0.0, 0.0, -10.0 + 2.0_f64.sqrt()]);
}

#[test]
fn stud_on_a_block_from_above_and_from_the_side() {
    let stud = Shape::Union(vec![block([-50.0, -50.0, -40.0], [50.0, 50.0, 0.0]), upright(0.0, 0.0, 20.0, -5.0, 15.0)]);
    assert_centre(contact(stud.clone(), 3.0, [40.0, 0.0, 8.0], [0.0, 0.0, 8.0]), [23.0, 0.0, 8.0]);
    // The upper rim at 17 with radius 3 and height 1.8 above it: 20 + sqrt(3² - 1.8²) = 22.4.
    assert_centre(contact(stud.clone(), 3.0, [40.0, 0.0, 16.8], [0.0, 0.0, 16.8]), [22.4, 0.0, 16.8]);
    // In the inner corner the floor is touched while the stud is 1 away.
    assert_centre(contact(stud, 3.0, [24.0, 0.0, 30.0], [24.0, 0.0, -30.0]), [24.0, 0.0, 3.0]);
}

#[test]
fn slot_with_round_ends() {
    let slot = Shape::Union(vec![
        block([-10.0, -5.0, -8.0], [10.0, 5.0, 0.0]),
        upright(-10.0, 0.0, 5.0, 0.0, -8.0),
        upright(10.0, 0.0, 5.0, 0.0, -8.0),
    ]);
    let part = Shape::Difference(vec![block([-50.0, -50.0, -40.0], [50.0, 50.0, 0.0]), slot]);
    assert_centre(contact(part.clone(), 2.0, [0.0, 0.0, -4.0], [30.0, 0.0, -4.0]), [13.0, 0.0, -4.0]);
    // Along the line where the round end begins its tangent surfaces meet.
    assert_centre(contact(part.clone(), 2.0, [10.0, 0.0, -4.0], [10.0, 30.0, -4.0]), [10.0, 3.0, -4.0]);
    assert_centre(contact(part, 2.0, [-3.0, 1.0, -4.0], [-3.0, -30.0, -4.0]), [-3.0, -3.0, -4.0]);
}

#[test]
fn rotated_part() {
    let frame = Frame::placed(dvec3(100.0, 0.0, 0.0), dvec3(0.0, 0.0, 45.0));
    let part = Shape::Placed { frame, shape: Box::new(block([-10.0; 3], [10.0; 3])) };
    // The edge points to the ball: 100 - 10 sqrt 2 - 2.
    let expected = 100.0 - 200.0_f64.sqrt() - 2.0;
    assert_centre(contact(part, 2.0, [0.0, 0.0, 0.0], [100.0, 0.0, 0.0]), [expected, 0.0, 0.0]);
}

#[test]
fn arc_meets_a_wall() {
    let wall = Shape::HalfSpace { point: dvec3(0.0, 15.0, 0.0), normal: dvec3(0.0, -3.0, 0.0) };
    let arc = |sweep| Path::Arc { centre: DVec3::ZERO, axis: DVec3::Z, from: dvec3(20.0, 0.0, 1.0), sweep, rise: 0.0 };
    let found = body(wall.clone()).first_contact_on(2.0, &arc(90.0)).expect("supported").expect("a contact");
    // The centre may rise to y = 13, so sin a = 13 / 20.
    let angle = (13.0_f64 / 20.0).asin();
    assert!((found.t - angle.to_degrees() / 90.0).abs() < 1e-12);
    assert!((found.ball_centre - dvec3(20.0 * angle.cos(), 13.0, 1.0)).length() < 1e-9);
    // Clockwise it comes from the other side after 180 degrees more.
    let found = body(wall.clone()).first_contact_on(2.0, &arc(-360.0)).expect("supported").expect("a contact");
    assert!((found.t - (180.0 + angle.to_degrees()) / 360.0).abs() < 1e-12);
    assert_eq!(body(wall).first_contact_on(2.0, &arc(40.0)), Ok(None));
}

#[test]
fn sliding_and_leaving_are_no_contacts() {
    let part = block([-50.0, -50.0, -40.0], [50.0, 50.0, 0.0]);
    assert_eq!(contact(part.clone(), 2.0, [-20.0, 0.0, 2.0], [20.0, 0.0, 2.0]), None);
    assert_eq!(contact(part.clone(), 2.0, [0.0, 0.0, 2.0], [0.0, 0.0, 20.0]), None);
    // Pressing on from the touching position is a contact at once.
    let found = contact(part.clone(), 2.0, [0.0, 0.0, 2.0], [0.0, 0.0, 0.0]).expect("a contact");
    assert_eq!((found.t, found.deflected), (0.0, false));
    let found = contact(part.clone(), 2.0, [0.0, 0.0, 1.5], [0.0, 0.0, 20.0]).expect("a contact");
    assert_eq!((found.t, found.deflected), (0.0, true));
    // An arc that begins along the face and bends into it.
    let arc = Path::Arc {
        centre: dvec3(0.0, 0.0, -28.0),
        axis: DVec3::Y,
        from: dvec3(0.0, 0.0, 2.0),
        sweep: 30.0,
        rise: 0.0,
    };
    let found = body(part.clone()).first_contact_on(2.0, &arc).expect("supported").expect("a contact");
    assert!(found.t < 1e-6, "{found:?}");
    assert_eq!(body(part.clone()).touches(2.0, dvec3(0.0, 0.0, 2.0)), Ok(false));
    assert_eq!(body(part).touches(2.0, dvec3(0.0, 0.0, 1.99)), Ok(true));
}

#[test]
fn a_ball_that_fits_passes_a_through_hole() {
    let part =
        Shape::Difference(vec![block([-50.0, -50.0, -40.0], [50.0, 50.0, 0.0]), upright(0.0, 0.0, 10.0, 0.0, -40.0)]);
    assert_eq!(contact(part.clone(), 9.9, [0.0, 0.0, 30.0], [0.0, 0.0, -90.0]), None);
    assert_centre(
        contact(part, 10.1, [0.0, 0.0, 30.0], [0.0, 0.0, -90.0]),
        [0.0, 0.0, (10.1_f64 * 10.1 - 100.0).sqrt()],
    );
}

#[test]
fn limits_are_errors() {
    // A hole that leans in the block has an ellipse for a rim.
    let leaning = Shape::Difference(vec![
        block([-50.0, -50.0, -40.0], [50.0, 50.0, 0.0]),
        Shape::Cylinder { from: dvec3(0.0, 0.0, 20.0), to: dvec3(20.0, 0.0, -20.0), radius: 8.0 },
    ]);
    let part = body(leaning);
    let down = part.first_contact(3.0, dvec3(2.0, 0.0, 30.0), dvec3(2.0, 0.0, -30.0));
    assert!(matches!(down, Err(SolidError::Edge(_))), "{down:?}");
    // Away from the rim its faces are exact.
    let aside = part.first_contact(3.0, dvec3(-40.0, 0.0, 30.0), dvec3(-40.0, 0.0, -30.0));
    assert!((aside.expect("supported").expect("a contact").ball_centre.z - 3.0).abs() < 1e-9);
    let helix = |z| Path::Arc {
        centre: dvec3(0.0, 0.0, z),
        axis: DVec3::Z,
        from: dvec3(20.0, 0.0, z),
        sweep: 360.0,
        rise: -10.0,
    };
    let solid = body(bored());
    assert_eq!(solid.first_contact_on(2.0, &helix(20.0)), Ok(None));
    assert!(matches!(solid.first_contact_on(2.0, &helix(5.0)), Err(SolidError::Helix(_))));
    assert_eq!(solid.first_contact(f64::NAN, DVec3::ZERO, DVec3::X), Err(SolidError::NotFinite));
    assert_eq!(solid.first_contact(0.0, DVec3::ZERO, DVec3::X), Err(SolidError::NotFinite));
}

#[test]
fn nothing_is_nowhere() {
    let nothing = body(Shape::Union(Vec::new()));
    assert_eq!(nothing.nearest(DVec3::ZERO), Ok(None));
    assert_eq!(nothing.first_contact(1.0, DVec3::ZERO, DVec3::X), Ok(None));
}

#[test]
fn grazing_all_along_is_no_contact() {
    // The arc runs in a plane exactly one radius in front of the face.
    let part = block([1.5, 0.0, 0.0], [3.5, 5.0, 10.0]);
    let arc = Path::Arc {
        centre: dvec3(0.0, -1.5, 8.75),
        axis: DVec3::X,
        from: dvec3(-2.5, 3.25, 0.25),
        sweep: 35.75,
        rise: 0.0,
    };
    assert_eq!(body(part).first_contact_on(4.0, &arc), Ok(None));
}

#[test]
fn a_plate_of_many_holes() {
    let mut shapes = vec![block([-10.0, -10.0, -20.0], [400.0, 400.0, 0.0])];
    for k in 0..60 {
        shapes.push(upright(f64::from(k % 8) * 48.0 + 15.0, f64::from(k / 8) * 48.0 + 15.0, 6.0, 0.0, -20.0));
    }
    let plate = body(Shape::Difference(shapes));
    for k in 0..60 {
        let centre = dvec3(f64::from(k % 8) * 48.0 + 15.0, f64::from(k / 8) * 48.0 + 15.0, -5.0);
        let found = plate.first_contact(2.0, centre, centre + DVec3::X * 30.0).expect("supported");
        assert_centre(found, (centre + DVec3::X * 4.0).to_array());
    }
}
