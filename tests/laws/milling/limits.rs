//! What a cycle refuses, and cases that were once wrong.
use ciklo::engine::geometry::Axis;
use ciklo::engine::run::{EventKind, MoveKind, Status};
use glam::DVec2;
use proptest::prelude::*;

use super::job::{FINISH, Job, MILL, PLUNGE, View, config, definition, job, mm};
use super::pockets::{Finish, Rectangle, rectangular};

/// The control refuses the call with that code, and the tool has not left rapid traverse.
fn refused(job: &Job, body: &str, code: &str) -> Result<(), TestCaseError> {
    let mut fed = 0;
    let (outcome, both) = job.run(&(body.to_owned() + &job.call(DVec2::ZERO)), &mut |event| {
        if let EventKind::Move { kind, .. } = &event.kind {
            fed += usize::from(!matches!(kind, MoveKind::Rapid));
        }
    });
    let found = outcome.fault.map(|fault| fault.code.into_owned());
    prop_assert_eq!(found.as_deref(), Some(code), "{}", both);
    prop_assert!(outcome.status != Status::Done && fed == 0, "the tool moved{}", both);
    Ok(())
}

/// Values that a figure of that size has; `changes` take the place of some.
fn pocket(job: &Job, cycle: u16, changes: &[(u16, f64)]) -> String {
    let r = job.tool();
    let own: &[(u16, f64)] = match cycle {
        251 => &[(218, 12.0 * r), (219, 9.0 * r), (220, 0.0), (224, 0.0), (367, 0.0), (370, 1.0)],
        252 => &[(223, 9.0 * r), (370, 1.0)],
        253 => &[(218, 12.0 * r), (219, 3.0 * r), (374, 0.0), (367, 0.0)],
        256 => &[
            (218, 9.0 * r),
            (219, 7.0 * r),
            (424, 12.0 * r),
            (425, 11.0 * r),
            (220, r),
            (224, 20.0),
            (367, 0.0),
            (370, 1.0),
            (437, 0.0),
        ],
        257 => &[(223, 9.0 * r), (222, 12.0 * r), (370, 1.0), (376, 30.0)],
        _ => &[
            (219, 3.0 * r),
            (375, 12.0 * r),
            (367, 0.0),
            (216, 0.0),
            (217, 0.0),
            (376, 0.0),
            (248, 60.0),
            (378, 0.0),
            (377, 1.0),
        ],
    };
    let mut values = vec![
        (215, 0.0),
        (368, 0.0),
        (207, MILL),
        (351, job.climb),
        (201, -job.depth),
        (202, job.infeed),
        (369, 0.0),
        (206, PLUNGE),
        (338, 0.0),
        (200, job.clearance),
        (203, job.surface),
        (204, job.second),
        (366, 1.0),
        (385, FINISH),
    ];
    if cycle > 255 {
        let of_pockets = [215, 369, 338, 366, 385];
        values.retain(|(q, _)| !of_pockets.contains(q));
    }
    values.extend(own);
    for (q, value) in changes {
        values.retain(|(number, _)| number != q);
        values.push((*q, *value));
    }
    definition(cycle, &values)
}

laws! {
    #![proptest_config(config())]

    #[test]
    fn what_has_no_room_is_refused(job in job(), less in mm(0.01..3.0), cycle in 251..255_u16, side in mm(0.0..1.0)) {
        let narrow = 2.0 * job.tool() - less.min(1.9 * job.tool());
        let body = match cycle {
            // Roughing leaves the allowance.
            251 => pocket(&job, 251, &[(219, narrow + 2.0 * side), (368, side), (366, 0.0)]),
            252 => pocket(&job, 252, &[(223, narrow + 2.0 * side), (368, side)]),
            _ => pocket(&job, cycle, &[(219, narrow)]),
        };
        let code = if cycle < 253 { "tool-wider-than-pocket" } else { "tool-wider-than-slot" };
        refused(&job, &body, code)?;
    }

    #[test]
    fn what_cannot_be_entered_is_refused(job in job(), cycle in 251..255_u16, less in mm(0.01..2.0)) {
        refused(&Job { angle: 0.0, ..job.clone() }, &pocket(&job, cycle, &[]), "plunging-angle-missing")?;
        refused(&job, &pocket(&job, cycle, &[(202, 0.0)]), "plunging-depth-zero")?;
        refused(&job, &pocket(&job, cycle, &[(201, job.depth)]), "depth-positive")?;
        if cycle < 253 {
            // Less than twice the diameter of the tool is no room for a helix.
            let narrow = 4.0 * job.tool() - less.min(job.tool());
            let (size, other) = if cycle == 251 { (219, 218) } else { (223, 223) };
            let body = pocket(&job, cycle, &[(other, 10.0 * job.tool()), (size, narrow)]);
            refused(&job, &body, "helix-too-small")?;
        }
        if cycle == 251 {
            let body = pocket(&job, 251, &[(220, 4.5 * job.tool() + less), (366, 0.0)]);
            let (outcome, both) = job.run(&(body + &job.call(DVec2::ZERO)), &mut |_| ());
            let found = outcome.fault.map(|fault| fault.code.into_owned());
            prop_assert_eq!(found.as_deref(), Some("shape-impossible"), "{}", both);
        }
    }

    /// A depth of nothing does nothing.
    #[test]
    fn no_depth_is_no_cut(job in job(), cycle in 251..255_u16) {
        let body = pocket(&job, cycle, &[(201, 0.0)]) + &job.call(DVec2::ZERO);
        job.leaves(&body, Vec::new(), false)?;
    }
}

/// What a cycle did: where each move ends in the plane and along the tool axis, its feed, and whether it is rapid.
fn moves(job: &Job, body: &str) -> Result<Vec<(DVec2, f64, f64, bool)>, TestCaseError> {
    let plane = job.plane();
    let mut found = Vec::new();
    let (outcome, both) = job.run_with("machine_parameters: {displayDepthErr: 0}\n", body, &mut |event| {
        if let (EventKind::Move { kind, to, feed, .. }, Some(_)) = (&event.kind, &event.at.cycle) {
            found.push((plane.flat(*to), plane.tool.of(*to), *feed, matches!(kind, MoveKind::Rapid)));
        }
    });
    prop_assert_eq!(outcome.status, Status::Done, "{:?}{}", outcome.fault, both);
    Ok(found)
}

laws! {
    #![proptest_config(config())]

    /// The sign of the depth is the working direction: where the machine allows a positive one, the same moves are made
    /// upwards, as the mirror image about the surface.
    #[test]
    fn upwards_is_the_mirror_image_of_downwards(
        job in job(), cycle in prop::sample::select(vec![251_u16, 252, 253, 254, 256, 257]), finish in any::<bool>(), strategy in 0..3_u8,
    ) {
        let strategy = if cycle == 252 { strategy.min(1) } else { strategy };
        let angle = if cycle == 252 && strategy == 0 { 0.0 } else { job.angle };
        let job = Job { angle, surface: job.surface.abs(), ..job };
        let allowances = if finish && cycle < 256 { [(368, 0.1 * job.tool()), (369, 0.3)] } else { [(368, 0.0), (369, 0.0)] };
        let of = |sign: f64| {
            let mut changes = vec![(201, sign * job.depth), (366, f64::from(strategy))];
            changes.extend(allowances);
            if cycle > 255 {
                // Studs have no floor to finish and no way to plunge.
                changes.retain(|(q, _)| *q != 366 && *q != 369);
            }
            moves(&job, &(pocket(&job, cycle, &changes) + &job.call(DVec2::ZERO)))
        };
        let (down, up) = (of(-1.0)?, of(1.0)?);
        prop_assert_eq!(down.len(), up.len(), "{} {:?}", cycle, job);
        for (n, (a, b)) in down.iter().zip(&up).enumerate() {
            let heights = (a.1 - job.surface) + (b.1 - job.surface);
            let same = a.0.distance(b.0) < 1e-9 && heights.abs() < 1e-9 && a.2 == b.2 && a.3 == b.3;
            prop_assert!(same, "{}, move {}: {:?} {:?} {:?}", cycle, n, a, b, job);
        }
    }
}

/// A job from which cases of their own differ.
const PLAIN: Job = Job {
    axis: Axis::Z,
    view: View { mirror: [false; 2], turn: 0.0, scale: 1.0 },
    radius: 3.0,
    corner: 0.0,
    angle: 4.0,
    edges: 0.0,
    surface: 0.0,
    clearance: 2.0,
    second: 20.0,
    depth: 6.0,
    infeed: 2.0,
    climb: 1.0,
    half: DVec2::splat(55.0),
    round: false,
};

const POCKET: Rectangle = Rectangle {
    size: DVec2::new(20.0, 10.0),
    corner: 0.5,
    rotation: 30.0,
    position: 1,
    overlap: 1.2,
    plunge: 0,
    centre: DVec2::ZERO,
};

fn holds(job: &Job, finish: &Finish) {
    if let Err(error) = rectangular(job, finish, &POCKET) {
        panic!("{error}");
    }
}

/// Finishing alone went at rapid traverse to the first plunging depth, even where the roughed floor lay above it.
#[test]
fn finishing_alone_stays_above_the_roughed_floor() {
    holds(&Job { infeed: 9.0, ..PLAIN }, &Finish { side: 0.5, floor: 1.0, infeed: 0.0, mode: 2 });
    holds(&Job { infeed: 9.0, ..PLAIN }, &Finish { side: 0.0, floor: 0.0, infeed: 0.0, mode: 2 });
}

/// The way from the middle to the wall went through the allowance at the depth at which roughing had ended, deeper
/// than the first infeed of finishing.
#[test]
fn the_first_finishing_infeed_is_not_passed() {
    for mode in [0, 2] {
        holds(&Job { infeed: 5.0, ..PLAIN }, &Finish { side: 1.4, floor: 0.0, infeed: 0.5, mode });
    }
}

/// The length of the edges was taken for one of the scaled program.
#[test]
fn edges_are_not_scaled() {
    let view = View { scale: 1.42, ..PLAIN.view };
    holds(&Job { view, edges: 1.5, depth: 4.0, ..PLAIN }, &Finish { side: 0.0, floor: 0.0, infeed: 0.0, mode: 1 });
}
