//! 262, 263, 264, 265 and 267: the groove in the part, what is cut at most and at least, and the thread that is told.
use ciklo::engine::solid::Shape;
use glam::DVec2;
use proptest::prelude::*;

use super::groove::Groove;
use super::setup::{Change, HEIGHT, Made, Setup, config, definition, pre_drilled, setup};

/// A thread to be milled.
#[derive(Clone, Debug)]
struct Mill {
    place: DVec2,
    diameter: f64,
    pitch: f64,
    left: bool,
    climb: bool,
    depth: f64,
    /// Radius of the tool.
    tool: f64,
    /// Threads per step.
    step: u32,
}

prop_compose! {
    fn mill()(
        place in (-3.0..3.0, -3.0..3.0).prop_map(DVec2::from), diameter in 10.0..24.0_f64, pitch in 0.8..2.5_f64, left in any::<bool>(),
        climb in any::<bool>(), depth in 1.0..20.0_f64, tool in 0.26..0.36_f64, step in 0..5_u32,
    ) -> Mill {
        Mill { place, diameter, pitch, left, climb, depth, tool: diameter * tool, step }
    }
}

impl Mill {
    /// What a circle at front clears: a ring, within which a core stands that is wider than the hole where the circle lies
    /// below the thread; on its way there and back the tool takes some of the core, so that the whole is the most.
    fn countersunk(&self, setup: &Setup, front: (f64, f64), whole: bool) -> Shape {
        let all = setup.hole(self.place, setup.surface - front.0, front.1 + self.tool);
        if whole || front.1 <= self.tool {
            return all;
        }
        let core = setup.hole(self.place, setup.surface - front.0 - 1.0, front.1 - self.tool);
        Shape::Difference(vec![all, core])
    }

    fn signed(&self) -> f64 {
        if self.left { -self.pitch } else { self.pitch }
    }

    fn milling(&self) -> f64 {
        if self.climb { 1.0 } else { -1.0 }
    }

    fn tooth(&self) -> f64 {
        0.2 * self.pitch
    }

    /// Radius of the core that is drilled before, that of a metric thread; the neck of the tool stays within it.
    fn core(&self) -> f64 {
        (self.diameter - 1.082_532 * self.pitch) / 2.0
    }

    /// A tool with one row of teeth, and the drill for the core.
    fn single(&self) -> String {
        format!(
            "{{T: 1, L: 100, R: {}, neck: {{head: {}, radius: {}}}}}, {{T: 2, L: 100, R: {}}}",
            self.tool,
            self.tooth(),
            self.tool - 0.7 * self.pitch,
            self.core()
        )
    }

    /// A tool that cuts along its whole side.
    fn whole(&self) -> String {
        format!("{{T: 1, L: 100, R: {}}}, {{T: 2, L: 100, R: {}}}", self.tool, self.core())
    }

    /// How many helices of how many turns, and their lower ends: one turn, a continuous helix, or helices some pitches apart.
    fn helices(&self, surface: f64, step: u32) -> Vec<(f64, u32)> {
        let floor = surface - self.depth;
        let whole = |way: f64| (self.depth / way - 1e-9).ceil().max(1.0) as u32;
        match step {
            0 => vec![(floor, 1)],
            1 => vec![(floor, whole(self.pitch))],
            _ => (0..whole(self.pitch * f64::from(step)))
                .map(|n| (floor + f64::from(n * step) * self.pitch, 1))
                .collect(),
        }
    }

    fn groove(&self, setup: &Setup, step: u32) -> Groove {
        let reach = self.diameter / 2.0;
        Groove {
            centre: self.place,
            reach,
            way: reach - self.tool,
            tool: self.tool,
            tooth: self.tooth(),
            pitch: self.pitch,
            right: !self.left,
            helices: self.helices(setup.surface, step),
            ring: (self.core() + 0.02, reach - 0.05),
            outside: false,
        }
    }

    fn outside(&self, setup: &Setup, step: u32) -> Groove {
        let reach = self.diameter / 2.0;
        Groove {
            way: reach + self.tool,
            ring: (reach + 0.05, self.stud() - 0.02),
            outside: true,
            ..self.groove(setup, step)
        }
    }

    /// Radius of the stud around which a thread is milled.
    fn stud(&self) -> f64 {
        self.diameter / 2.0 + 0.6 * self.pitch
    }

    /// The one thread that is told is the one that was asked for; mirrored on one axis it has the other hand.
    fn told(&self, setup: &Setup, made: &Made, outside: bool, step: u32) -> Result<(), TestCaseError> {
        let helices = self.helices(setup.surface, step);
        let threads = made.threads();
        prop_assert_eq!(threads.len(), 1, "{:?}{}", threads, made.text);
        let near = |a: f64, b: f64| (a - b).abs() < 1e-7;
        let top =
            helices.iter().map(|(low, turns)| low + self.pitch * f64::from(*turns)).fold(f64::NEG_INFINITY, f64::max);
        for thread in threads {
            let fits = near(thread.pitch, self.pitch)
                && near(thread.diameter, self.diameter)
                && thread.right == (self.left == setup.mirrors())
                && near(setup.axis.of(thread.bottom), setup.surface - self.depth)
                && near(setup.axis.of(thread.top), top)
                && (setup.plane().flat(thread.bottom) - self.place).length() < 1e-7
                && thread.milled
                && thread.outside == outside
                && thread.passes as usize == helices.len();
            prop_assert!(fits, "{:?} is not {:?}{}", thread, self, made.text);
        }
        Ok(())
    }

    /// Pre-drilled for the core, deep enough for what joins the thread, and then the cycle.
    fn in_core(&self, setup: &Setup, cycle: u32, values: &[(u16, f64)]) -> String {
        pre_drilled(setup, self.place, (self.depth + 1.5 * self.pitch).min(HEIGHT + 1.0))
            + &setup.tool(1, 3000.0, "M3")
            + &definition(cycle, values)
            + &setup.calls(&[self.place])
    }

    fn values_262(&self, setup: &Setup) -> [(u16, f64); 10] {
        let Setup { clearance, surface, second, .. } = *setup;
        [
            (335, self.diameter),
            (239, self.signed()),
            (201, -self.depth),
            (355, f64::from(self.step)),
            (253, 750.0),
            (351, self.milling()),
            (200, clearance),
            (203, surface),
            (204, second),
            (207, 500.0),
        ]
    }

    fn values_263(&self, setup: &Setup, sink: (f64, f64), front: (f64, f64)) -> [(u16, f64); 14] {
        let Setup { clearance, surface, second, .. } = *setup;
        [
            (335, self.diameter),
            (239, self.signed()),
            (201, -self.depth),
            (356, -sink.0),
            (253, 750.0),
            (351, self.milling()),
            (200, clearance),
            (357, sink.1),
            (358, -front.0),
            (359, front.1),
            (203, surface),
            (204, second),
            (254, 150.0),
            (207, 500.0),
        ]
    }

    fn values_264(&self, setup: &Setup, hole: f64, infeed: f64, breaks: f64, front: (f64, f64)) -> [(u16, f64); 17] {
        let Setup { clearance, surface, second, .. } = *setup;
        [
            (335, self.diameter),
            (239, self.signed()),
            (201, -self.depth),
            (356, -hole),
            (253, 750.0),
            (351, self.milling()),
            (202, infeed),
            (258, 0.2),
            (257, breaks),
            (256, 0.2),
            (358, -front.0),
            (359, front.1),
            (200, clearance),
            (203, surface),
            (204, second),
            (206, 150.0),
            (207, 500.0),
        ]
    }

    fn values_265(&self, setup: &Setup, front: (f64, f64), after: bool) -> [(u16, f64); 12] {
        let Setup { clearance, surface, second, .. } = *setup;
        [
            (335, self.diameter),
            (239, self.signed()),
            (201, -self.depth),
            (253, 750.0),
            (358, -front.0),
            (359, front.1),
            (360, f64::from(u8::from(after))),
            (200, clearance),
            (203, surface),
            (204, second),
            (254, 150.0),
            (207, 500.0),
        ]
    }

    fn values_267(&self, setup: &Setup, front: (f64, f64)) -> [(u16, f64); 13] {
        let Setup { clearance, surface, second, .. } = *setup;
        [
            (335, self.diameter),
            (239, self.signed()),
            (201, -self.depth),
            (355, f64::from(self.step)),
            (253, 750.0),
            (351, self.milling()),
            (200, clearance),
            (358, -front.0),
            (359, front.1),
            (203, surface),
            (204, second),
            (254, 150.0),
            (207, 500.0),
        ]
    }

    /// The scene of a stud that stands by itself.
    fn stud_scene(&self, setup: &Setup, tools: &str) -> String {
        let centre = setup.seen(self.place);
        format!(
            "{}stock: {{cylinder: {{axis: {}, centre: [{}, {}], from: {}, to: {}, radius: {}}}}}\n",
            setup.scene(tools),
            setup.axis.letter(),
            centre.x,
            centre.y,
            setup.surface - HEIGHT,
            setup.surface,
            self.stud()
        )
    }

    fn around(&self, setup: &Setup, front: (f64, f64)) -> String {
        setup.tool(1, 3000.0, "M3") + &definition(267, &self.values_267(setup, front)) + &setup.calls(&[self.place])
    }

    /// The blank, without a hole of that radius from that height up, and without others.
    fn without(&self, setup: &Setup, holes: &[(f64, f64)]) -> Shape {
        let core = (setup.surface - self.depth - 1.5 * self.pitch, self.core());
        let all = [core].iter().chain(holes).map(|(floor, radius)| setup.hole(self.place, *floor, *radius)).collect();
        setup.part(all)
    }

    /// The thread cut by a whole side: nothing more than the diameter from where it is joined on, nothing less from where
    /// its lowest turn ends.
    fn envelope(&self, setup: &Setup, made: &Made, front: Option<(f64, f64)>) -> Result<(), TestCaseError> {
        let (floor, reach) = (setup.surface - self.depth, self.diameter / 2.0);
        let front = front.map(|(depth, offset)| (setup.surface - depth, offset + self.tool));
        let with = |hole: (f64, f64)| {
            let holes: Vec<_> = [Some(hole), front].into_iter().flatten().collect();
            self.without(setup, &holes)
        };
        made.is_between(&with((floor + self.pitch, reach - 0.01)), &with((floor - self.pitch / 2.0, reach + 1e-3)))
    }
}

/// Depth and offset at the front.
fn front() -> impl Strategy<Value = (f64, f64)> {
    (0.1..3.0_f64, 0.5..7.0_f64)
}

laws! {
    #![proptest_config(config())]

    #[test]
    fn thread_milling_leaves_a_groove(setup in setup(), mill in mill()) {
        let body = mill.in_core(&setup, 262, &mill.values_262(&setup));
        let made = setup.machined(&body, &setup.scene(&mill.single()), 0.7)?;
        let (_, ridges) = mill.groove(&setup, mill.step).measured(&setup, &made)?;
        prop_assert!(ridges > 0 || mill.step != 1 || mill.depth < 4.0 * mill.pitch, "no ridge was seen{}", made.text);
        mill.told(&setup, &made, false, mill.step)?;
    }

    #[test]
    fn thread_milling_leaves_its_envelope(setup in setup(), mill in mill()) {
        let body = mill.in_core(&setup, 262, &mill.values_262(&setup));
        let made = setup.machined(&body, &setup.scene(&mill.whole()), 0.7)?;
        mill.envelope(&setup, &made, None)?;
    }

    #[test]
    fn threads_of_countersinking_cycles_leave_a_groove(setup in setup(), mill in mill(), drilling in any::<bool>()) {
        let body = if drilling {
            mill.in_core(&setup, 264, &mill.values_264(&setup, 0.0, 5.0, 0.0, (0.0, 0.0)))
        } else {
            mill.in_core(&setup, 263, &mill.values_263(&setup, (0.0, 0.0), (0.0, 0.0)))
        };
        let made = setup.machined(&body, &setup.scene(&mill.single()), 0.7)?;
        mill.groove(&setup, 0).measured(&setup, &made)?;
        mill.told(&setup, &made, false, 0)?;
    }

    /// Countersinking at the side stays within the core, at the front it makes room as far as offset and radius reach.
    #[test]
    fn countersinking_leaves_its_envelope(
        setup in setup(), mill in mill(), deeper in 0.4..1.0_f64, aside in prop_oneof![Just(0.0), 0.05..0.3], front in front(),
        side in any::<bool>(), at_front in any::<bool>(),
    ) {
        let sink = if side { mill.depth + deeper * mill.pitch } else { 0.0 };
        let at = if at_front { front } else { (0.0, 0.0) };
        let body = mill.in_core(&setup, 263, &mill.values_263(&setup, (sink, aside), at));
        let made = setup.machined(&body, &setup.scene(&mill.whole()), 0.7)?;
        mill.envelope(&setup, &made, at_front.then_some(front))?;
        mill.told(&setup, &made, false, 0)?;
    }

    /// The tool drills the hole by itself, in infeeds and with chips broken.
    #[test]
    fn drilling_and_milling_leaves_hole_and_thread(
        setup in setup(), mill in mill(), deeper in 0.6..3.0_f64, infeed in 1.0..9.0, breaks in prop_oneof![Just(0.0), 0.5..6.0], front in front(),
        at_front in any::<bool>(),
    ) {
        let hole = mill.depth + deeper * mill.pitch;
        let at = if at_front { front } else { (0.0, 0.0) };
        let body = setup.tool(1, 3000.0, "M3") + &definition(264, &mill.values_264(&setup, hole, infeed, breaks, at))
            + &setup.calls(&[mill.place]);
        let made = setup.machined(&body, &setup.scene(&mill.whole()), 0.7)?;
        let (floor, reach) = (setup.surface - mill.depth, mill.diameter / 2.0);
        let with = |thread: (f64, f64), whole: bool| {
            let mut holes = vec![setup.hole(mill.place, setup.surface - hole, mill.tool), setup.hole(mill.place, thread.0, thread.1)];
            if at_front {
                holes.push(mill.countersunk(&setup, front, whole));
            }
            setup.part(holes)
        };
        made.is_between(&with((floor + mill.pitch, reach - 0.01), false), &with((floor - mill.pitch / 2.0, reach + 1e-3), true))?;
        mill.told(&setup, &made, false, 0)?;
    }

    /// A single row of teeth needs a core to come back through.
    #[test]
    fn helical_drilling_leaves_a_groove(setup in setup(), mill in mill()) {
        let body = mill.in_core(&setup, 265, &mill.values_265(&setup, (0.0, 0.0), false));
        let made = setup.machined(&body, &setup.scene(&mill.single()), 0.7)?;
        mill.groove(&setup, 1).measured(&setup, &made)?;
        mill.told(&setup, &made, false, 1)?;
    }

    /// Nothing is drilled before: the helix goes from the surface into the solid.
    #[test]
    fn helical_drilling_leaves_its_envelope(setup in setup(), mill in mill(), front in front(), at_front in any::<bool>(), after in any::<bool>()) {
        let at = if at_front { front } else { (0.0, 0.0) };
        let body = setup.tool(1, 3000.0, "M3") + &definition(265, &mill.values_265(&setup, at, after)) + &setup.calls(&[mill.place]);
        let made = setup.machined(&body, &setup.scene(&mill.whole()), 0.7)?;
        let (floor, reach) = (setup.surface - mill.depth, mill.diameter / 2.0);
        let with = |thread: (f64, f64), whole: bool| {
            let mut holes = vec![setup.hole(mill.place, thread.0, thread.1)];
            if at_front {
                holes.push(mill.countersunk(&setup, front, whole));
            }
            setup.part(holes)
        };
        made.is_between(&with((floor + mill.pitch, reach - 0.01), false), &with((floor - mill.pitch / 2.0, reach + 1e-3), true))?;
        mill.told(&setup, &made, false, 1)?;
    }

    #[test]
    fn outside_thread_milling_leaves_a_groove(setup in setup(), mill in mill()) {
        let scene = mill.stud_scene(&setup, &mill.single());
        let made = setup.machined(&mill.around(&setup, (0.0, 0.0)), &scene, 0.5)?;
        mill.outside(&setup, mill.step).measured(&setup, &made)?;
        mill.told(&setup, &made, true, mill.step)?;
    }

    /// A whole side around the stud, and a countersink at its front.
    #[test]
    fn outside_thread_milling_leaves_its_envelope(setup in setup(), mill in mill(), depth in 0.1..0.9_f64, share in 0.5..1.1_f64, at_front in any::<bool>()) {
        // The edge at the front reaches to this radius of the stud.
        let kept = mill.diameter / 2.0 * share;
        let front = (depth, kept + mill.tool);
        let scene = mill.stud_scene(&setup, &mill.whole());
        let made = setup.machined(&mill.around(&setup, if at_front { front } else { (0.0, 0.0) }), &scene, 0.5)?;
        let (floor, reach) = (setup.surface - mill.depth, mill.diameter / 2.0);
        let bottom = setup.surface - HEIGHT;
        let part = |from: f64, radius: f64, kept: f64| {
            let lower = setup.cylinder(mill.place, bottom, from, mill.stud());
            let (chamfer, top) = if at_front { (setup.surface - front.0, setup.surface) } else { (setup.surface, setup.surface) };
            let mut parts = vec![lower, setup.cylinder(mill.place, bottom, chamfer.max(from), radius)];
            if at_front {
                parts.push(setup.cylinder(mill.place, bottom, top, kept.min(radius)));
            }
            Shape::Union(parts)
        };
        if !at_front || mill.depth > front.0 + mill.pitch {
            made.is_between(&part(floor + mill.pitch, reach + 0.01, kept + 0.01), &part((floor - mill.pitch / 2.0).max(bottom), reach - 1e-3, kept - 1e-3))?;
        }
        mill.told(&setup, &made, true, mill.step)?;
    }

    /// Scaled threads: the tool is not scaled, so its path takes that into account.
    #[test]
    fn scaled_threads_are_told_as_they_are(setup in setup(), mill in mill(), factor in 0.8..1.5_f64) {
        let setup = Setup { change: Change::None, surface: 0.0, ..setup };
        let body = format!("CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL{factor}\n") + &setup.tool(1, 3000.0, "M3")
            + &definition(262, &mill.values_262(&setup)) + &setup.calls(&[mill.place]);
        let (outcome, events) = super::setup::run(&setup.program(&body), &setup.scene(&mill.whole()));
        prop_assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
        let threads = super::setup::threads(&events);
        let wanted = factor * mill.diameter;
        prop_assert_eq!(threads.len(), 1);
        prop_assert!(threads.iter().all(|thread| (thread.diameter - wanted).abs() < 1e-7 && (thread.pitch - factor * mill.pitch).abs() < 1e-7
            && thread.right != mill.left), "{:?} {}", threads, wanted);
    }
}

/// A groove of the other hand, of another pitch, deeper or wider is told apart: the measurement is none that always agrees.
#[test]
fn another_groove_is_told_apart() {
    let mill = Mill {
        place: DVec2::new(1.0, -2.0),
        diameter: 20.0,
        pitch: 2.0,
        left: false,
        climb: true,
        depth: 14.0,
        tool: 6.0,
        step: 1,
    };
    let axis = ciklo::engine::geometry::Axis::Z;
    let setup = Setup { axis, surface: 0.0, clearance: 2.0, second: 0.0, change: Change::Rotate(30.0) };
    let body = mill.in_core(&setup, 262, &mill.values_262(&setup));
    let made = setup.machined(&body, &setup.scene(&mill.single()), 0.7).expect("a run");
    let groove = mill.groove(&setup, 1);
    let measured = |groove: &Groove| groove.measured(&setup, &made);
    let (columns, ridges) = measured(&groove).expect("the groove");
    assert!(columns > 50 && ridges > 100, "{columns} {ridges}");
    assert!(measured(&Groove { right: false, ..groove.clone() }).is_err());
    assert!(measured(&Groove { pitch: 2.1, ..groove.clone() }).is_err());
    assert!(measured(&Groove { reach: 9.9, ..groove.clone() }).is_err());
    assert!(measured(&Groove { helices: vec![(-15.0, 7)], ..groove.clone() }).is_err());
    assert!(measured(&Groove { helices: vec![(-14.0, 8)], ..groove }).is_ok(), "above the surface nothing is seen");
}
