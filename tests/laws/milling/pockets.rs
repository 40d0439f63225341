//! Laws of pockets.
use glam::DVec2;
use proptest::prelude::*;

use super::job::{FINISH, Job, MILL, PLUNGE, beside, config, definition, job, mm};

/// What is finished how.
#[derive(Clone, Debug)]
pub(super) struct Finish {
    /// Side and floor allowance.
    pub(super) side: f64,
    pub(super) floor: f64,
    /// Q338.
    pub(super) infeed: f64,
    /// 0: roughing and finishing, 1: roughing, 2: roughing, and finishing by a second call.
    pub(super) mode: u8,
}

prop_compose! {
    pub(super) fn finish()(
        side in prop_oneof![Just(0.0), mm(0.05..1.5)], floor in prop_oneof![Just(0.0), mm(0.05..2.0)],
        infeed in prop_oneof![Just(0.0), mm(0.5..8.0)], mode in 0..3_u8,
    ) -> Finish {
        Finish { side, floor, infeed, mode }
    }
}

impl Finish {
    /// The same with a floor allowance that leaves something to be roughed.
    pub(super) fn in_depth(&self, depth: f64) -> Self {
        let floor = if self.floor < depth { self.floor } else { (depth * 50.0).floor() / 100.0 };
        Self { floor, ..self.clone() }
    }

    /// The allowances that are left in the end.
    pub(super) fn left(&self, depth: f64) -> (f64, f64) {
        if self.mode == 1 { (self.side, self.floor.min(depth)) } else { (0.0, 0.0) }
    }

    /// The deepest step of finishing.
    pub(super) fn deepest(&self, depth: f64) -> f64 {
        let side = if self.side == 0.0 {
            0.0
        } else if self.infeed > 0.0 {
            self.infeed
        } else {
            depth
        };
        side.max(self.floor).min(depth)
    }

    /// Definitions and calls; `call` is the text of one.
    pub(super) fn body(&self, define: &dyn Fn(f64) -> String, call: &str) -> String {
        match self.mode {
            2 => define(1.0) + call + &define(2.0) + call,
            mode => define(f64::from(mode)) + call,
        }
    }
}

#[derive(Clone, Debug)]
pub(super) struct Rectangle {
    pub(super) size: DVec2,
    pub(super) corner: f64,
    pub(super) rotation: f64,
    pub(super) position: u8,
    pub(super) overlap: f64,
    pub(super) plunge: u8,
    pub(super) centre: DVec2,
}

prop_compose! {
    fn rectangle()(
        size in (mm(0.0..40.0), mm(0.0..30.0)), corner in 0.0..1.0_f64, any_corner in any::<bool>(), rotation in prop_oneof![Just(0.0), mm(-360.0..360.0)],
        position in 0..5_u8, overlap in mm(0.1..1.99), plunge in 0..3_u8, centre in (mm(-15.0..15.0), mm(-15.0..15.0)),
    ) -> Rectangle {
        let corner = if any_corner { corner } else { 0.0 };
        Rectangle { size: size.into(), corner, rotation, position, overlap, plunge, centre: centre.into() }
    }
}

/// From the centre to the tool at the call.
pub(super) fn corner_of(position: u8, size: DVec2, rotation: f64) -> DVec2 {
    let (x, y) = match position {
        1 => (-0.5, -0.5),
        2 => (0.5, -0.5),
        3 => (0.5, 0.5),
        4 => (-0.5, 0.5),
        _ => (0.0, 0.0),
    };
    DVec2::from_angle(rotation.to_radians()).rotate(size * DVec2::new(x, y))
}

/// Makes the pocket wide enough for the tool and the plunge, and looks at what is left.
pub(super) fn rectangular(job: &Job, finish: &Finish, pocket: &Rectangle) -> Result<(), TestCaseError> {
    let r = job.tool();
    // A helix needs twice the diameter; otherwise the tool just fits.
    let least = 2.0 * finish.side + if pocket.plunge == 1 { 4.0 * r } else { 2.0 * r };
    let size = pocket.size + DVec2::splat((least * 100.0 + 1.0).ceil() / 100.0);
    let corner = (pocket.corner * size.min_element() / 2.0 * 100.0).floor() / 100.0;
    let Rectangle { rotation, position, overlap, plunge, centre, .. } = *pocket;
    let define = |mode: f64| {
        definition(
            251,
            &[
                (215, mode),
                (218, size.x),
                (219, size.y),
                (220, corner),
                (368, finish.side),
                (224, rotation),
                (367, f64::from(position)),
                (207, MILL),
                (351, job.climb),
                (201, -job.depth),
                (202, job.infeed),
                (369, finish.floor),
                (206, PLUNGE),
                (338, finish.infeed),
                (200, job.clearance),
                (203, job.surface),
                (204, job.second),
                (370, overlap),
                (366, f64::from(plunge)),
                (385, FINISH),
            ],
        )
    };
    let start = centre + corner_of(position, size, rotation);
    let (side, floor) = finish.left(job.depth);
    let depth = job.depth - floor;
    // What is round about a corner cannot be less than the tool.
    let full = if corner == 0.0 { r } else { corner.max(r) };
    let half = size / 2.0 - DVec2::splat(side);
    let hollow =
        job.rectangle(centre, half, (full - side).max(r).min(half.min_element()), rotation, job.surface - depth);
    let hollow = if depth > 0.0 { vec![hollow] } else { Vec::new() };
    let short = job.edges > 0.0 && finish.mode != 1;
    let done = job.leaves(&finish.body(&define, &job.call(start)), hollow, short)?;
    job.ends(&done, start, job.safe())?;
    let step = job.step().min(job.depth);
    job.depth_at(&done, PLUNGE, step)?;
    job.depth_at(&done, MILL, step)?;
    job.depth_at(&done, FINISH, finish.deepest(job.depth))?;
    job.deepest(&done, step.max(finish.deepest(job.depth)))?;
    // The first cut of a level runs along the middle and is as wide as the tool.
    let half = size / 2.0 - DVec2::splat(finish.side + r);
    let core = half - DVec2::splat(half.min_element());
    let turned = |p: DVec2| job.view.point(centre + DVec2::from_angle(rotation.to_radians()).rotate(p));
    let core = |at: DVec2| beside(at, turned(-core), turned(core)) < 0.5 * job.radius;
    let step = overlap * r;
    job.width_at(&done, MILL, step, &core)?;
    // The floor is finished from the middle to the wall, which is finished before.
    let side = if finish.floor > 0.0 { step.max(finish.side) } else { finish.side };
    let entered =
        |at: DVec2| core(at) || (finish.floor > 0.0 && (at - turned(DVec2::ZERO)).length() < 1.6 * job.radius);
    if finish.floor == 0.0 {
        job.width_at(&done, FINISH, side, &entered)?;
    }
    let wrong = job.climbs_at(&done, MILL, step, &core)?;
    // A helix has cleared a ring about the middle.
    prop_assert!(plunge == 1 || wrong <= job.radius, "more the wrong way round: {}{}", wrong, done.both);
    if finish.floor == 0.0 {
        job.climbs_at(&done, FINISH, side, &entered)?;
    }
    Ok(())
}

laws! {
    #![proptest_config(config())]

    #[test]
    fn rectangular_pockets(job in job(), finish in finish(), pocket in rectangle()) {
        rectangular(&job, &finish.in_depth(job.depth), &pocket)?;
    }

    #[test]
    fn circular_pockets(
        job in job(), finish in finish(), more in mm(0.0..40.0), overlap in mm(0.1..1.99), helix in any::<bool>(),
        centre in (mm(-15.0..15.0), mm(-15.0..15.0)),
    ) {
        // Plunging vertically asks for an angle of 0 or 90 in the tool table.
        let job = if helix { job } else { Job { angle: 0.0, ..job } };
        let finish = finish.in_depth(job.depth);
        let (r, centre) = (job.tool(), DVec2::from(centre));
        let least = 2.0 * finish.side + if helix { 4.0 * r } else { 2.0 * r };
        let diameter = more + (least * 100.0 + 1.0).ceil() / 100.0;
        let define = |mode: f64| definition(252, &[
            (215, mode), (223, diameter), (368, finish.side), (207, MILL), (351, job.climb), (201, -job.depth), (202, job.infeed),
            (369, finish.floor), (206, PLUNGE), (338, finish.infeed), (200, job.clearance), (203, job.surface), (204, job.second),
            (370, overlap), (366, f64::from(u8::from(helix))), (385, FINISH),
        ]);
        let (side, floor) = finish.left(job.depth);
        let depth = job.depth - floor;
        let hollow = job.round(centre, diameter / 2.0 - side, job.surface - depth);
        let hollow = if depth > 0.0 { vec![hollow] } else { Vec::new() };
        let short = job.edges > 0.0 && finish.mode != 1;
        let done = job.leaves(&finish.body(&define, &job.call(centre)), hollow, short)?;
        job.ends(&done, centre, job.safe())?;
        let step = job.step().min(job.depth);
        job.depth_at(&done, PLUNGE, step)?;
        job.depth_at(&done, MILL, step)?;
        job.depth_at(&done, FINISH, finish.deepest(job.depth))?;
        job.deepest(&done, step.max(finish.deepest(job.depth)))?;
        let middle = job.view.point(centre);
        let core = |at: DVec2| (at - middle).length() < job.radius * overlap;
        job.width_at(&done, MILL, overlap * r, &core)?;
        if finish.floor == 0.0 {
            job.width_at(&done, FINISH, finish.side, &core)?;
            job.climbs_at(&done, FINISH, finish.side, &core)?;
        }
        let wrong = job.climbs_at(&done, MILL, overlap * r, &core)?;
        prop_assert!(helix || wrong <= job.radius, "more the wrong way round: {}{}", wrong, done.both);
    }
}
