//! Laws of slots, straight and along a circle.
use ciklo::engine::solid::Shape;
use glam::DVec2;
use proptest::prelude::*;

use super::job::{FINISH, Job, MILL, PLUNGE, beside, config, definition, job, mm};
use super::pockets::{Finish, finish};

/// What slots have in common: how wide they are beyond the tool, and what that leaves of the allowances.
struct Width {
    whole: f64,
    rough: f64,
}

impl Width {
    /// `share` 0 makes the slot as wide as the tool, which is only roughed; others have room for the allowances.
    fn new(job: &Job, finish: &Finish, share: f64) -> Self {
        let tool = 2.0 * job.tool();
        // As a number of hundredths, unless the tool is to fill the slot.
        let room = tool + 2.0 * finish.side;
        let whole =
            if share == 0.0 { tool } else { ((tool * (1.0 + 1.5 * share)).max(room) * 100.0 + 1.0).ceil() / 100.0 };
        Self { whole, rough: (whole - 2.0 * finish.side).max(tool) }
    }

    /// Width and depth in the end. A slot as wide as the tool is only roughed.
    fn left(&self, job: &Job, finish: &Finish) -> (f64, f64) {
        let only_roughed = finish.mode == 1 || self.whole <= 2.0 * job.tool();
        let floor = if only_roughed { finish.floor.min(job.depth) } else { 0.0 };
        (if only_roughed || finish.side == 0.0 { self.rough } else { self.whole }, job.depth - floor)
    }
}

/// What the steps of the cycle keep to; `core` are the places of the first cut of a level, which fills the slot.
fn keeps(
    job: &Job,
    finish: &Finish,
    body: &str,
    hollow: Vec<Shape>,
    core: &dyn Fn(DVec2) -> bool,
) -> Result<super::job::Done, TestCaseError> {
    let short = job.edges > 0.0 && finish.mode != 1;
    let done = job.leaves(body, hollow, short)?;
    let step = job.step().min(job.depth);
    job.depth_at(&done, PLUNGE, step)?;
    job.depth_at(&done, MILL, step)?;
    job.depth_at(&done, FINISH, finish.deepest(job.depth))?;
    job.deepest(&done, step.max(finish.deepest(job.depth)))?;
    job.width_at(&done, MILL, job.tool(), core)?;
    let wrong = job.climbs_at(&done, MILL, job.tool(), core)?;
    prop_assert!(wrong <= job.radius, "more the wrong way round: {}{}", wrong, done.both);
    if finish.floor == 0.0 {
        job.width_at(&done, FINISH, finish.side, &|_| false)?;
        let wrong = job.climbs_at(&done, FINISH, finish.side, &|_| false)?;
        prop_assert!(wrong <= job.radius, "more the wrong way round: {}{}", wrong, done.both);
    }
    Ok(done)
}

/// Angles from `begin` on about the origin, up to a half turn, as a wedge that is taken away from a shape.
fn outside(job: &Job, centre: DVec2, begin: f64, opening: f64) -> Vec<Shape> {
    let edge = |degrees: f64, sign: f64| {
        let way = DVec2::from_angle((degrees + sign * 90.0).to_radians());
        Shape::HalfSpace { point: job.at(centre.x, centre.y, 0.0), normal: job.at(-way.x, -way.y, 0.0) }
    };
    // Behind the plane at the beginning and before the one at the end.
    vec![edge(begin, -1.0), edge(begin + opening, 1.0)]
}

laws! {
    #![proptest_config(config())]

    #[test]
    fn straight_slots(
        job in job(), finish in finish(), share in prop_oneof![Just(0.0), 0.02..1.0_f64], more in mm(0.0..50.0), position in 0..5_u8,
        rotation in prop_oneof![Just(0.0), mm(-360.0..360.0)], plunge in 0..3_u8, at in (mm(-10.0..10.0), mm(-10.0..10.0)),
    ) {
        let finish = finish.in_depth(job.depth);
        let width = Width::new(&job, &finish, share);
        // Strokes need some length.
        let length = width.whole + if plunge > 0 { more.max(2.0) } else { more };
        let reach = (length - width.whole) / 2.0;
        let define = |mode: f64| definition(253, &[
            (215, mode), (218, length), (219, width.whole), (368, finish.side), (374, rotation), (367, f64::from(position)),
            (207, MILL), (351, job.climb), (201, -job.depth), (202, job.infeed), (369, finish.floor), (206, PLUNGE),
            (338, finish.infeed), (200, job.clearance), (203, job.surface), (204, job.second), (366, f64::from(plunge)), (385, FINISH),
        ]);
        let way = DVec2::from_angle(rotation.to_radians());
        let centre = DVec2::from(at);
        let along = match position {
            1 => -length / 2.0,
            2 => -reach,
            3 => reach,
            4 => length / 2.0,
            _ => 0.0,
        };
        let start = centre + way * along;
        let (wide, depth) = width.left(&job, &finish);
        let half = DVec2::new(reach + wide / 2.0, wide / 2.0);
        let hollow = job.rectangle(centre, half, wide / 2.0, rotation, job.surface - depth);
        let hollow = if depth > 0.0 { vec![hollow] } else { Vec::new() };
        let ends = [centre - way * reach, centre + way * reach].map(|p| job.view.point(p));
        let core = |p: DVec2| beside(p, ends[0], ends[1]) < 0.5 * job.radius;
        let done = keeps(&job, &finish, &finish.body(&define, &job.call(start)), hollow, &core)?;
        if position == 0 {
            job.ends(&done, centre, job.safe())?;
        }
        prop_assert!((done.end.z - job.safe() * job.view.scale).abs() < 1e-9, "ends at {}{}", done.end, done.both);
    }

    #[test]
    fn circular_slots(
        job in job(), finish in finish(), share in prop_oneof![Just(0.0), 0.02..1.0_f64], more in mm(0.5..20.0), position in 0..4_u8,
        begin in mm(-360.0..360.0), opening in prop_oneof![5 => mm(10.0..200.0), 1 => mm(200.0..360.0), 1 => Just(360.0)], count in 1..4_u8, plunge in 0..3_u8,
        at in (mm(-10.0..10.0), mm(-10.0..10.0)),
    ) {
        let finish = finish.in_depth(job.depth);
        let width = Width::new(&job, &finish, share);
        let diameter = width.whole + 2.0 * more;
        // Slots side by side; they may touch and overlap.
        let step = 360.0 / f64::from(count);
        let define = |mode: f64| {
            let centre = DVec2::from(at);
            definition(254, &[
                (215, mode), (219, width.whole), (368, finish.side), (375, diameter), (367, f64::from(position)), (216, centre.x),
                (217, centre.y), (376, begin), (248, opening), (378, step), (377, f64::from(count)), (207, MILL), (351, job.climb),
                (201, -job.depth), (202, job.infeed), (369, finish.floor), (206, PLUNGE), (338, finish.infeed), (200, job.clearance),
                (203, job.surface), (204, job.second), (366, f64::from(plunge)), (385, FINISH),
            ])
        };
        let on_circle = |degrees: f64| DVec2::from_angle(degrees.to_radians()) * (diameter / 2.0);
        let centre = DVec2::from(at);
        // The tool stands somewhere, at the beginning of the slot, at its middle, or at its end.
        let start = match position {
            1 => centre + on_circle(begin),
            2 => centre + on_circle(begin + opening / 2.0),
            3 => centre + on_circle(begin + opening),
            _ => DVec2::new(3.0, -4.0),
        };
        // Where slots run into each other, a later one finds material gone.
        prop_assume!(count == 1 || step > opening + 2.0 * (width.whole / diameter).min(1.0).asin().to_degrees() + 1.0);
        let (wide, depth) = width.left(&job, &finish);
        let floor = job.surface - depth;
        let (k, middle) = (job.view.scale, job.view.point(centre));
        let mut hollow = Vec::new();
        for slot in 0..count {
            let first = begin + step * f64::from(slot);
            let ends = [first, first + opening];
            hollow.extend(ends.map(|degrees| job.round(centre + on_circle(degrees), wide / 2.0, floor)));
            // In two halves, each less than half a turn; mirroring changes the ends over.
            for half in 0..2 {
                let from = first + opening / 2.0 * f64::from(half);
                let from = if job.view.flips() { from + opening / 2.0 } else { from };
                let mut shapes = vec![job.round(centre, (diameter + wide) / 2.0, floor)];
                shapes.push(Shape::Cylinder {
                    from: job.at(middle.x, middle.y, 200.0),
                    to: job.at(middle.x, middle.y, -200.0),
                    radius: (diameter - wide) / 2.0 * k,
                });
                shapes.extend(outside(&job, middle, job.view.angle(from), opening / 2.0));
                hollow.push(Shape::Difference(shapes));
            }
        }
        let hollow = if depth > 0.0 { hollow } else { Vec::new() };
        let core = |p: DVec2| ((p - middle).length() - diameter / 2.0 * k).abs() < 0.5 * job.radius;
        let done = keeps(&job, &finish, &finish.body(&define, &job.call(start)), hollow, &core)?;
        if position == 0 {
            job.ends(&done, centre, job.safe())?;
        }
        prop_assert!((done.end.z - job.safe() * k).abs() < 1e-9, "ends at {}{}", done.end, done.both);
    }
}
