//! Laws of studs: their blank is the workpiece, of which only the stud and what lies deeper stay.
use ciklo::engine::solid::Shape;
use glam::DVec2;
use proptest::prelude::*;

use super::field::widest;
use super::job::{HEIGHT, Job, MILL, PLUNGE, RESOLUTION, View, config, definition, job, mm};
use super::pockets::corner_of;

/// The workpiece with a stud on it. What stands higher than the blank does not count in a comparison.
fn part(job: &Job, stud: Shape, floor: f64) -> Shape {
    let (k, half) = (job.view.scale, job.half);
    let low = job.surface * k - HEIGHT;
    let base = if job.round {
        Shape::Cylinder { from: job.at(0.0, 0.0, low), to: job.at(0.0, 0.0, floor * k), radius: half.x }
    } else {
        Shape::Box { min: job.at(-half.x, -half.y, low), max: job.at(half.x, half.y, floor * k) }
    };
    Shape::Union(vec![base, stud])
}

/// What steps keep to. The corners of a blank lie farther out than its sides, so laps about them take more.
fn keeps(job: &Job, body: &str, stud: Shape, overlap: f64) -> Result<super::job::Done, TestCaseError> {
    let mut done = job.leaves_part(body, &part(job, stud, job.surface - job.depth), false)?;
    let step = job.step().min(job.depth);
    job.depth_at(&done, PLUNGE, step)?;
    job.depth_at(&done, MILL, step)?;
    job.deepest(&done, step)?;
    let step = overlap * job.tool();
    let k = job.view.scale;
    if !job.round {
        // On the way about a corner of the blank the tool may have some of it on either side.
        done.pieces.iter_mut().filter(|piece| piece.bend.is_finite()).for_each(|piece| piece.left = None);
    }
    let corner = |at: DVec2| !job.round && (job.half - at.abs()).length() < 2.5 * job.radius;
    let wrong = job.climbs_at(&done, MILL, step, &corner)?;
    prop_assert!(wrong <= job.radius, "more the wrong way round: {}{}", wrong, done.both);
    for (index, piece) in done.pieces.iter().enumerate() {
        if piece.feed == MILL && piece.left.is_some() && piece.bend.is_infinite() {
            let most = widest(&done.pieces, index, job.radius, step * k);
            prop_assert!(piece.width() <= most + 0.1, "wider than {}: {:?}{}", most, piece, done.both);
        }
    }
    Ok(done)
}

laws! {
    #![proptest_config(config())]

    #[test]
    fn rectangular_studs(
        job in job(), size in (mm(4.0..40.0), mm(4.0..40.0)), more in (mm(0.0..15.0), mm(0.0..15.0)), corner in 0.0..1.0_f64,
        side in prop_oneof![Just(0.0), mm(0.05..1.5)], position in 0..5_u8, overlap in mm(0.1..1.41), approach in 0..5_u8,
        quarter in prop_oneof![Just(0.0), Just(90.0), Just(-90.0), Just(180.0)],
    ) {
        let (size, more) = (DVec2::from(size), DVec2::from(more));
        // A blank is greater than the stud with its allowance.
        let blank = size + more + DVec2::splat(2.0 * side + 0.02);
        // Its sides lie along the axes.
        let view = View { turn: (job.view.turn / 90.0).round() * 90.0, ..job.view };
        let lies = (view.turn / 90.0 + quarter / 90.0).rem_euclid(2.0) == 1.0;
        let half = blank * view.scale / 2.0;
        let job = Job { view, half: if lies { DVec2::new(half.y, half.x) } else { half }, ..job };
        let corner = (corner * size.min_element() / 2.0 * 100.0).floor() / 100.0;
        let start = corner_of(position, size, quarter);
        let body = definition(256, &[
            (218, size.x), (424, blank.x), (219, size.y), (425, blank.y), (220, corner), (368, side), (224, quarter),
            (367, f64::from(position)), (207, MILL), (351, job.climb), (201, -job.depth), (202, job.infeed), (206, PLUNGE),
            (200, job.clearance), (203, job.surface), (204, job.second), (370, overlap), (437, f64::from(approach)),
        ]);
        let half = size / 2.0 + DVec2::splat(side);
        let stud = job.rectangle(DVec2::ZERO, half, corner + side, quarter, job.surface - job.depth);
        let done = keeps(&job, &(body + &job.call(start)), stud, overlap)?;
        prop_assert!((done.end.z - job.safe() * job.view.scale).abs() < 1e-9, "ends at {}{}", done.end, done.both);
        // The tool has left the stud.
        let stud = half * job.view.scale;
        let beside = (done.end.truncate().abs() - if lies { DVec2::new(stud.y, stud.x) } else { stud }).max_element();
        prop_assert!(beside > job.radius + 0.5, "ends at {}{}", done.end, done.both);
    }

    #[test]
    fn circular_studs(
        job in job(), diameter in mm(2.0..50.0), more in mm(0.02..20.0), side in prop_oneof![Just(0.0), mm(0.05..1.5)],
        overlap in mm(0.1..1.41), begin in mm(0.0..359.0),
    ) {
        let blank = diameter + more + 2.0 * side;
        let job = Job { half: DVec2::splat(blank * job.view.scale / 2.0), round: true, ..job };
        let body = definition(257, &[
            (223, diameter), (222, blank), (368, side), (207, MILL), (351, job.climb), (201, -job.depth), (202, job.infeed),
            (206, PLUNGE), (200, job.clearance), (203, job.surface), (204, job.second), (370, overlap), (376, begin),
        ]);
        let stud = job.round(DVec2::ZERO, diameter / 2.0 + side, job.surface - job.depth);
        let done = keeps(&job, &(body + &job.call(DVec2::ZERO)), stud, overlap)?;
        job.ends(&done, DVec2::ZERO, job.safe())?;
    }
}

/// Twelve columns of this stock lie on the wall of the stud: 45 of them side by side are 49.08 / 45 wide, and the wall, 15.1
/// of the stud and 1.26 of its allowance, is 15 of these widths away from the middle column: at (15, 0), (9, 12) and
/// what lies as they do. Where rounding alone decided whether the rim of the tool reaches them, one was left
/// by the first level and went with the second, 1.6 deep at an infeed of 0.8.
#[test]
fn columns_on_the_wall_of_a_stud() {
    let view = View { turn: -15.67, ..View::PLAIN };
    let blank = 49.080_000_000_000_005;
    let (axis, half) = (ciklo::engine::geometry::Axis::X, DVec2::splat(blank / 2.0));
    let job = Job {
        axis,
        view,
        radius: 1.5,
        corner: 0.0,
        angle: 2.0,
        edges: 0.0,
        surface: 0.0,
        clearance: 1.0,
        second: 0.0,
        depth: 14.84,
        infeed: 0.8,
        climb: -1.0,
        half,
        round: true,
    };
    let wide = blank / (blank / RESOLUTION).ceil();
    let on = |x: f64, y: f64| (x.hypot(y) * wide - 16.36).abs() < 1e-9;
    assert!(on(15.0, 0.0) && on(9.0, 12.0), "columns are {wide} wide");
    let body = definition(
        257,
        &[
            (223, 30.2),
            (222, blank),
            (368, 1.26),
            (207, MILL),
            (351, -1.0),
            (201, -14.84),
            (202, 0.8),
            (206, PLUNGE),
            (200, 1.0),
            (203, 0.0),
            (204, 0.0),
            (370, 0.1),
            (376, 0.0),
        ],
    );
    let (done, _) = job.machined(&(body + &job.call(DVec2::ZERO)), false).expect("a stud");
    job.deepest(&done, 0.8).expect("no cut deeper than the infeed");
}
