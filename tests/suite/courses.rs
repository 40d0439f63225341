//! Where machines go between two positions of their axes, and the bounds that nothing there exceeds.
use ciklo::engine::geometry::{Axis, RotaryAxis};
use ciklo::engine::machine::{Carried, Course, Machine, MachineAxis, RotaryMachineAxis, Straight};
use glam::DVec3;

fn rotary(letter: char, carries: Carried, about: (Axis, f64), centre: DVec3) -> RotaryMachineAxis {
    let axis = RotaryAxis::from_letter(letter).expect("a letter");
    RotaryMachineAxis {
        axis,
        carries,
        about,
        centre,
        askew: DVec3::ZERO,
        limits: None,
        hirth: None,
        is_measured_at_motor: false,
        rapid: 3600.0,
    }
}

/// Tables of two axes with centres of their own, heads, and one axis of each.
fn machines() -> Vec<Machine> {
    let axes = Axis::ALL.map(|axis| MachineAxis { axis, min: -1e3, max: 1e3, rapid: 1e4, acceleration: 2e3 });
    let made = |rotary: Vec<RotaryMachineAxis>, pivot| Machine {
        name: String::new(),
        spindle: Axis::Z,
        parallel: Vec::new(),
        axes: axes.to_vec(),
        rotary,
        pivot,
        second_datum: None,
        base: DVec3::ZERO,
    };
    let (one, other) = (DVec3::new(10.0, -20.0, -50.0), DVec3::new(-7.0, 3.0, 30.0));
    vec![
        made(
            vec![
                rotary('A', Carried::Workpiece, (Axis::X, -1.0), one),
                rotary('C', Carried::Workpiece, (Axis::Z, -1.0), other),
            ],
            0.0,
        ),
        made(
            vec![
                rotary('C', Carried::Tool, (Axis::Z, 1.0), DVec3::ZERO),
                rotary('B', Carried::Tool, (Axis::Y, 1.0), DVec3::ZERO),
            ],
            120.0,
        ),
        made(
            vec![
                rotary('B', Carried::Tool, (Axis::Y, 1.0), DVec3::ZERO),
                rotary('C', Carried::Workpiece, (Axis::Z, -1.0), one),
            ],
            80.0,
        ),
    ]
}

/// No point and no axis is ever farther from the middle of a stretch than its bound; and the bound is no more than
/// a few times too large, or nothing could be proven with it.
#[test]
fn nothing_goes_farther_than_its_bound() {
    let angles = [DVec3::new(-20.0, 15.0, 40.0), DVec3::new(35.0, -30.0, -100.0)];
    let (from, to) = (DVec3::new(60.0, -10.0, 80.0), DVec3::new(-20.0, 40.0, 10.0));
    let mut looked = 0;
    for machine in machines() {
        for straight in [Straight::Axes(from, to), Straight::Tip(from, to)] {
            let course = Course::new(&machine, angles, straight, DVec3::Z * (machine.pivot + 95.0));
            for arm in [DVec3::ZERO, DVec3::new(0.3, -0.2, 2.0), DVec3::Z * 60.0] {
                for (middle, half) in [(0.5, 0.5), (0.2, 0.1), (0.9, 0.01)] {
                    let way = |point: &dyn Fn(f64) -> DVec3| {
                        let at = |step: i32| point(middle + half * f64::from(step) / 50.0);
                        (-50..=50).map(|step| (at(step) - at(0)).length()).fold(0.0, f64::max)
                    };
                    let (gone, bound) = (way(&|share| course.at(arm, share)), course.reach(arm, middle, half));
                    assert!(gone <= bound && bound < 8.0 * gone, "{gone} {bound} {straight:?}");
                    let (gone, bound) = (way(&|share| course.axes(share)), course.axes_reach(middle, half));
                    assert!(gone <= bound && bound < 8.0 * gone, "{gone} {bound} {straight:?}");
                    looked += 1;
                }
            }
        }
    }
    assert_eq!(looked, 54);
}

/// The tip that is held goes straight where the workpiece is, whatever turns.
#[test]
fn a_tip_that_is_held_goes_straight() {
    let angles = [DVec3::new(-20.0, 15.0, 40.0), DVec3::new(35.0, -30.0, -100.0)];
    let (from, to) = (DVec3::new(60.0, -10.0, 80.0), DVec3::new(-20.0, 40.0, 10.0));
    for machine in machines() {
        let pivot = DVec3::Z * (machine.pivot + 95.0);
        let held = Course::new(&machine, angles, Straight::Tip(from, to), pivot);
        for share in [0.0, 0.25, 1.0] {
            assert_eq!(held.at(DVec3::ZERO, share), from + (to - from) * share);
            // The same seen from the linear axes.
            let axes = held.axes(share);
            let still = Course::new(&machine, [held.angles(share); 2], Straight::Axes(axes, axes), pivot);
            assert!((still.at(DVec3::ZERO, 0.0) - held.at(DVec3::ZERO, share)).length() < 1e-12);
        }
    }
}
