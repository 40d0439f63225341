//! Laws of turned threads: every pass is in step with the spindle, lies as deep below the surface as its infeed, begins
//! at the angle of its start, and rapid traverse stays out of the part.
//!
//! The surface is calculated here from its definition; positions and feeds come from the events of a run.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::fmt::Write as _;

use ciklo::base::diag::Source;
use ciklo::engine::run::{Engine, Event, EventKind, MoveKind, NoTexts, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use glam::DVec2;
use proptest::prelude::*;

use crate::built::{Built, built};

/// How far the tool may be from where it should be, mm.
const EXACT: f64 = 1e-6;

/// How a thread is described: cycle 831, 832 by points, by an angle, or 830.
#[derive(Clone, Debug)]
enum Form {
    Longitudinal,
    Line(f64),
    /// The dimensioning, from 1, and the angle.
    Cone(u8, f64),
    /// Lengths, slopes, and by how much each element bulges.
    Contour(Vec<(f64, f64, f64)>),
}

/// A thread and how it is turned, seen by its passes: `x` along the pitch, `y` away from it, from where it begins.
#[derive(Clone, Debug)]
struct Job {
    form: Form,
    inside: bool,
    face: bool,
    upwards: bool,
    length: f64,
    pitch: f64,
    depth: f64,
    largest: f64,
    constant: bool,
    angle: f64,
    starts: u8,
    air: u8,
    run_in: f64,
    overrun: f64,
    run_out: f64,
    clearance: f64,
    first_angle: f64,
    per_revolution: bool,
    cutting_speed: bool,
}

fn mm(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|value| (value * 100.0).round() / 100.0)
}

fn form() -> impl Strategy<Value = Form> {
    let elements = proptest::collection::vec((mm(4.0..15.0), mm(-0.4..0.4), mm(-0.5..0.5)), 1..5);
    prop_oneof![
        Just(Form::Longitudinal),
        mm(-0.4..0.4).prop_map(Form::Line),
        (1..5_u8, mm(1.0..20.0)).prop_map(|(how, angle)| Form::Cone(how, angle)),
        elements.prop_map(Form::Contour),
    ]
}

fn job() -> impl Strategy<Value = Job> {
    let how = (any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>());
    let lengths = (mm(8.0..30.0), mm(0.5..4.0), prop_oneof![Just(0.0), mm(0.3..2.5)], mm(0.08..1.0));
    let ways = (mm(0.0..6.0), mm(0.0..5.0), prop_oneof![Just(0.0), mm(0.1..3.0)], mm(0.5..5.0));
    let passes = (mm(0.0..45.0), 1..4_u8, 0..3_u8, mm(0.0..300.0));
    (form(), how, lengths, ways, passes).prop_map(|(form, how, lengths, ways, passes)| Job {
        face: how.1 && !matches!(form, Form::Longitudinal | Form::Cone(..)),
        upwards: how.2 && !matches!(form, Form::Cone(1 | 3, _)),
        run_out: match &form {
            // It is lifted on the last line of a contour.
            Form::Contour(elements) => match elements.last() {
                Some((length, _, 0.0)) => f64::min(ways.2, *length),
                _ => 0.0,
            },
            _ => ways.2,
        },
        overrun: match form {
            Form::Longitudinal => lengths.1,
            Form::Contour(_) => ways.1,
            _ => 0.0,
        },
        run_in: if matches!(form, Form::Longitudinal) { ways.3 } else { ways.0 },
        form,
        inside: how.0,
        length: lengths.0,
        pitch: lengths.1,
        depth: lengths.2,
        largest: lengths.3,
        constant: how.3,
        angle: passes.0,
        starts: passes.1,
        air: passes.2,
        clearance: ways.3,
        first_angle: passes.3,
        per_revolution: how.4,
        cutting_speed: how.5,
    })
}

/// An element of the surface: it ends there, on a circle if it has one.
#[derive(Clone, Copy, Debug)]
struct Element {
    from: DVec2,
    to: DVec2,
    circle: Option<(DVec2, f64)>,
}

impl Job {
    fn signs(&self) -> (f64, f64) {
        (if self.upwards { 1.0 } else { -1.0 }, if self.inside { -1.0 } else { 1.0 })
    }

    /// Where the thread begins: radius and coordinate on the axis.
    fn origin(&self) -> (f64, f64) {
        (60.0, -7.0)
    }

    fn programmed(&self, at: DVec2) -> (f64, f64) {
        let ((ahead, away), (radius, z)) = (self.signs(), self.origin());
        let (x, y) = (at.x * ahead, at.y * away);
        if self.face { (2.0 * (radius + x), z + y) } else { (2.0 * (radius + y), z + x) }
    }

    fn seen(&self, radius: f64, z: f64) -> DVec2 {
        let ((ahead, away), (r0, z0)) = (self.signs(), self.origin());
        if self.face {
            DVec2::new((radius - r0) * ahead, (z - z0) * away)
        } else {
            DVec2::new((z - z0) * ahead, (radius - r0) * away)
        }
    }

    /// The slope of a cone: its diameter grows.
    fn rise(&self, angle: f64) -> f64 {
        angle.to_radians().tan() * if self.inside { -1.0 } else { 1.0 }
    }

    fn elements(&self) -> Vec<Element> {
        let line = |to: DVec2| vec![Element { from: DVec2::ZERO, to, circle: None }];
        match &self.form {
            Form::Longitudinal => line(DVec2::new(self.length, 0.0)),
            Form::Line(slope) => line(DVec2::new(self.length, self.length * slope)),
            Form::Cone(_, angle) => line(DVec2::new(self.length, self.length * self.rise(*angle))),
            Form::Contour(elements) => {
                let mut from = DVec2::ZERO;
                let one = |&(length, slope, bulge): &(f64, f64, f64)| {
                    let begin = from;
                    let to = begin + DVec2::new(length, (length * slope * 1000.0).round() / 1000.0);
                    from = to;
                    let circle = (bulge.abs() > 0.05).then(|| {
                        // The arc rises by so much above its chord, or falls.
                        let half = begin.distance(to) / 2.0;
                        let radius = (half * half + bulge * bulge) / (2.0 * bulge.abs());
                        let up = (to - begin).perp().normalize() * bulge.signum();
                        (begin.midpoint(to) - up * (radius - bulge.abs()), radius)
                    });
                    Element { from: begin, to, circle }
                };
                elements.iter().map(one).collect()
            }
        }
    }

    /// The height of the surface, which goes on straight at both ends.
    fn height(&self, x: f64) -> f64 {
        let elements = self.elements();
        let (first, last) = (elements[0], elements[elements.len() - 1]);
        let slope = |element: Element, at: DVec2| match element.circle {
            None => (element.to.y - element.from.y) / (element.to.x - element.from.x),
            Some((centre, _)) => -(at.x - centre.x) / (at.y - centre.y),
        };
        if x < first.from.x {
            return first.from.y + (x - first.from.x) * slope(first, first.from);
        }
        if x > last.to.x {
            return last.to.y + (x - last.to.x) * slope(last, last.to);
        }
        let element = elements.iter().find(|element| x <= element.to.x).unwrap_or(&last);
        match element.circle {
            None => element.from.y + (x - element.from.x) * slope(*element, element.from),
            Some((centre, radius)) => {
                let rise = (radius * radius - (x - centre.x).powi(2)).sqrt();
                centre.y + rise * (element.from.y + element.to.y - 2.0 * centre.y).signum()
            }
        }
    }

    fn end(&self) -> f64 {
        self.elements().last().map_or(0.0, |element| element.to.x)
    }

    fn wanted_depth(&self) -> f64 {
        if self.depth > 0.0 {
            return self.depth;
        }
        // 17/24 and 5/8 of the height of an equilateral triangle on the distance of two turns.
        let sharp = 3.0_f64.sqrt() / 2.0 * self.pitch / f64::from(self.starts);
        sharp * if self.inside { 5.0 / 8.0 } else { 17.0 / 24.0 }
    }

    fn program(&self) -> String {
        let (start_d, start_z) = self.programmed(DVec2::ZERO);
        let end = self.elements().last().map_or(DVec2::ZERO, |element| element.to);
        let (end_d, end_z) = self.programmed(end);
        let (x, z) = self.programmed(DVec2::new(-20.0, 12.0));
        let spin = if self.cutting_speed { "VCONST:ON VC:120 SMAX:1500" } else { "VCONST:OFF S400" };
        let mut text = format!("TOOL CALL 1 Z\nFUNCTION MODE TURN\nFUNCTION TURNDATA SPIN {spin}\n");
        if self.per_revolution {
            text += "M136\n";
        }
        let _ = writeln!(text, "L X{x:+} Z{z:+} R0 FMAX M303");
        let number = match self.form {
            Form::Longitudinal => 831,
            Form::Line(_) | Form::Cone(..) => 832,
            Form::Contour(_) => 830,
        };
        if number == 830 {
            text += "CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL 2\n";
        }
        let _ = writeln!(text, "CYCL DEF {number}");
        let mut q = |number: u16, value: f64| {
            let _ = writeln!(text, "Q{number}={value:+}");
        };
        q(471, f64::from(u8::from(self.inside)));
        q(460, self.clearance);
        q(472, self.pitch);
        q(473, self.depth);
        q(474, self.run_out);
        q(463, self.largest);
        q(467, self.angle);
        q(468, f64::from(u8::from(self.constant)));
        q(470, self.first_angle);
        q(475, f64::from(self.starts));
        q(476, f64::from(self.air));
        if number != 831 {
            q(461, f64::from(u8::from(self.face)));
            q(465, self.run_in);
            q(466, self.overrun);
        }
        if number != 830 {
            q(491, start_d);
            q(492, start_z);
            q(494, end_z);
        }
        if number == 832 {
            let (how, angle) = if let Form::Cone(how, angle) = self.form { (how, angle) } else { (0, 0.0) };
            q(464, f64::from(how));
            q(493, end_d);
            q(469, angle);
            // What the dimensioning does not use is wrong.
            match how {
                1 => q(492, 999.0),
                2 => q(491, 999.0),
                3 => q(494, 999.0),
                4 => q(493, 999.0),
                _ => {}
            }
        }
        text += "CYCL CALL\n";
        if number == 830 {
            let _ = writeln!(text, "M30\nLBL 2\nL X{start_d:+} Z{start_z:+}");
            let (ahead, away) = self.signs();
            let turned = ahead * away * if self.face { -1.0 } else { 1.0 };
            for element in self.elements() {
                let (d, z) = self.programmed(element.to);
                let _ = match element.circle {
                    None => writeln!(text, "L X{d:+} Z{z:+}"),
                    Some((centre, radius)) => {
                        let sense = (element.from - centre).perp_dot(element.to - centre).signum() * turned;
                        writeln!(text, "CR X{d:+} Z{z:+} R{radius:+} DR{}", if sense > 0.0 { '+' } else { '-' })
                    }
                };
            }
            text += "LBL 0\n";
        }
        text
    }

    fn run(&self) -> Result<Vec<Event>, TestCaseError> {
        let Built { files, catalogue, .. } = built();
        let text = "scene: 1\ntools: [{T: 1, L: 80, R: 0}]\nstart: [100, 0, 50]\n";
        let scene = Scene::parse(&Source::new("scene.yaml", text), files);
        let scene = scene.unwrap_or_else(|found| panic!("{found:?}\n{text}"));
        let program = self.program();
        let tree = syntax::parse(&Source::new("LAW.H", program.clone()));
        let mut events = Vec::new();
        let engine = Engine::new(&tree, catalogue.on("tnc640").expect("a control"), &scene, &NoTexts);
        let outcome = engine.with_catalogue(catalogue).run(&mut |event| events.push(event.clone()));
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, program);
        Ok(events)
    }
}

/// A pass: the angle at which it begins, its points, and how far its revolutions are from those that it should make.
struct Pass {
    angle: f64,
    speed: f64,
    points: Vec<DVec2>,
}

laws! {
    #![proptest_config(crate::cases::config(50))]

    #[test]
    fn threads_are_in_step_and_exact(job in job()) {
        let (events, program) = (job.run()?, job.program());
        let (end, depth) = (job.end(), job.wanted_depth());
        let mut passes: Vec<Pass> = Vec::new();
        for event in &events {
            if event.at.cycle.as_ref().is_none_or(|(_, step)| step.is_none()) {
                continue;
            }
            match &event.kind {
                EventKind::Spindle { direction, speed, orient: Some(angle), .. } => {
                    prop_assert!(*direction == 1 && *speed > 0.0);
                    passes.push(Pass { angle: *angle, speed: *speed, points: Vec::new() });
                }
                EventKind::Move { kind, path, feed, turned, .. } => {
                    let at = |share: f64| {
                        let at = path.at(share);
                        job.seen(at.x, at.z)
                    };
                    let places = (0..=40).map(|n| at(f64::from(n) / 40.0));
                    if matches!(kind, MoveKind::Rapid | MoveKind::Arc { rapid: true, .. }) {
                        for place in places {
                            let above = place.y - job.height(place.x);
                            let inside = place.x > EXACT && place.x < end - EXACT;
                            prop_assert!(!inside || above > job.clearance - EXACT, "rapid at {place}\n{program}");
                        }
                        continue;
                    }
                    let pass = passes.last_mut().expect("a pass begins with the spindle");
                    prop_assert_eq!(turned.map(|turned| turned.speed), Some(pass.speed));
                    let revolutions = path.length() / feed * pass.speed;
                    let wanted = (at(1.0).x - at(0.0).x) / job.pitch;
                    prop_assert!((revolutions - wanted).abs() < 1e-9 * wanted.max(1.0), "{revolutions} {wanted}\n{program}");
                    pass.points.extend(places);
                }
                _ => {}
            }
        }
        // The fewest infeeds that are not too deep.
        let infeeds = |count: u32| {
            let share = move |cut: u32| f64::from(cut) / f64::from(count);
            let constant = job.constant;
            (1..=count).map(move |cut| depth * if constant { share(cut) } else { share(cut).sqrt() })
        };
        let count = (1..).find(|count| infeeds(*count).next().is_some_and(|first| first <= job.largest + 1e-9));
        let depths: Vec<f64> = infeeds(count.expect("a number")).collect();
        let each = depths.len() + usize::from(job.air);
        prop_assert_eq!(passes.len(), each * usize::from(job.starts), "{}", program);
        let tangent = job.angle.to_radians().tan();
        for (number, pass) in passes.iter().enumerate() {
            let (start, cut) = (number / each, number % each);
            let lower = depths[cut.min(depths.len() - 1)];
            let angle = job.first_angle + 360.0 * start as f64 / f64::from(job.starts);
            let apart = (pass.angle - angle).rem_euclid(360.0);
            prop_assert!(apart.min(360.0 - apart) < 1e-9, "{} {angle}\n{program}", pass.angle);
            for point in &pass.points {
                let surface = job.height(point.x);
                let wanted = if job.run_out == 0.0 || point.x <= end - job.run_out {
                    surface - lower
                } else {
                    surface - lower * ((end - point.x) / job.run_out).max(0.0)
                };
                prop_assert!((point.y - wanted).abs() < EXACT, "{point} is not {wanted} high\n{program}");
            }
            // The last infeed is where the thread is programmed, the others lie on a line through it.
            let (first, last) = (pass.points[0], pass.points[pass.points.len() - 1]);
            let begin = DVec2::new(-job.run_in, job.height(-job.run_in) - depth);
            prop_assert!((first.x - begin.x + (first.y - begin.y) * tangent).abs() < EXACT, "{first} {begin}\n{program}");
            prop_assert!((last.x - end - job.overrun).abs() < EXACT, "{last}\n{program}");
        }
    }
}
