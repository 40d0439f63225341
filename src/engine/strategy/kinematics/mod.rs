//! Strategies that measure the rotary axes on a calibration sphere and correct the kinematics.
//!
//! Invariant: what is moved follows from the kinematics that the control believes in; they change only when a strategy
//! adopts what another one has calculated. Without a retraction height the ball stays over the sphere, as seen along the
//! tool, while an axis turns.
pub mod memory;

use glam::DVec3;

use crate::base::expr::{cosd, sind};
use crate::engine::geometry::{Axis, RotaryAxis};
use crate::engine::machine::{
    Arm, AxisPlan, AxisReport, Carried, Fit, LEAST_CIRCLE, Machine, RotaryMachineAxis, Station, Survey, expected,
    on_grid, sphere,
};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::sphere::fit_sphere;
use crate::engine::strategy::action::{Action, Control, Probing, column};
use crate::engine::strategy::signature::{Mm, results, strategy};
use crate::engine::table::{Cell, TableKind};

strategy! {
    /// Measures the sphere at the positions of each axis, and keeps what it finds.
    MeasureRotaryAxes = "measure-rotary-axes" {
        /// The radius of the sphere, mm.
        radius: Mm<f64> = Length,
        /// How often the sphere is probed around its equator.
        points: f64 = Number,
        /// What the clearance of the probe table is enlarged by, mm.
        clearance: Mm<f64> = Length,
        /// The height to which the probe is retracted before an axis turns; 0: it is not.
        retraction: Mm<f64> = Length,
        /// The feed of positioning, mm/min.
        feed: Mm<f64> = Feed,
        /// The angle of the first probing around the equator, degrees.
        reference: f64 = Angle,
        /// Beyond each position, to measure the backlash, degrees; 0: it is not measured.
        overtravel: f64 = Angle,
        /// Whether a position at 0 is left out; else it is an error.
        skip_zero: bool = Number,
        /// How far from its limits an axis must be measured whose angle the encoder of its motor measures, degrees.
        before_limit: Option<f64> = Angle,
        /// The first angle of A.
        start_a: f64 = Angle,
        /// The last angle.
        end_a: f64 = Angle,
        /// Where it is while other axes are measured.
        incidence_a: f64 = Angle,
        /// How many positions.
        points_a: f64 = Number,
        /// The first angle of B.
        start_b: f64 = Angle,
        /// The last angle.
        end_b: f64 = Angle,
        /// Where it is while other axes are measured.
        incidence_b: f64 = Angle,
        /// How many positions.
        points_b: f64 = Number,
        /// The first angle of C.
        start_c: f64 = Angle,
        /// The last angle.
        end_c: f64 = Angle,
        /// Where it is while other axes are measured.
        incidence_c: f64 = Angle,
        /// How many positions.
        points_c: f64 = Number,
    }
}

strategy! {
    /// Measures the sphere under the probe, and makes its centre the preset in effect.
    PresetIntoSphere = "preset-into-sphere" {
        /// The radius of the sphere, mm.
        radius: Mm<f64> = Length,
        /// How often the sphere is probed around its equator.
        points: f64 = Number,
        /// What the clearance of the probe table is enlarged by, mm.
        clearance: Mm<f64> = Length,
        /// The feed of positioning, mm/min.
        feed: Mm<f64> = Feed,
        /// The angle of the first probing around the equator, degrees.
        reference: f64 = Angle,
    }
}

strategy! {
    /// Calculates what an optimization of the positions could reach; nothing changes.
    RateKinematics = "rate-kinematics" {}
}

strategy! {
    /// Calculates where the axes are so that what was measured is explained best.
    OptimizeAxisPositions = "optimize-axis-positions" {}
}

strategy! {
    /// Calculates the directions of the axes so that what was measured is explained best.
    OptimizeAxisAngles = "optimize-axis-angles" {}
}

strategy! {
    /// Calculates where the axes are, and by how much presets are displaced, so that what was measured is explained best
    /// and the preset in effect is in the sphere.
    OptimizeTransformationChain = "optimize-transformation-chain" {}
}

strategy! {
    /// Puts what was calculated into effect.
    AdoptKinematics = "adopt-kinematics" {}
}

strategy! {
    /// What was measured, for parameters: always mm.
    StoreKinematicsResults = "store-kinematics-results" {}
}

results! {
    /// How the measurements went.
    MeasuredResults {
        /// Whether a backlash is more than half of the way beyond a position, which must be much longer: 1, else 0.
        backlash_in_doubt: f64 = Number,
    }
}

results! {
    /// What an optimization would do.
    ChangeResults {
        /// Whether all of it could be calculated: 1, else 0.
        calculated: f64 = Number,
        /// Whether a coordinate changes by more than the machine parameter allows without a question: 1, else 0.
        exceeds: f64 = Number,
    }
}

results! {
    /// What was measured: -1 where it was not.
    KinematicsResults {
        /// The scatter of A, mm.
        measured_a: f64 = Number,
        /// That of B.
        measured_b: f64 = Number,
        /// That of C.
        measured_c: f64 = Number,
        /// The scatter of A after an optimization, mm.
        optimized_a: f64 = Number,
        /// That of B.
        optimized_b: f64 = Number,
        /// That of C.
        optimized_c: f64 = Number,
        /// The sum of the corrections in X, mm.
        x: f64 = Number,
        /// In Y.
        y: f64 = Number,
        /// In Z.
        z: f64 = Number,
    }
}

/// Nothing can be calculated.
const NOTHING: ChangeResults = ChangeResults { calculated: 0.0, exceeds: 0.0 };
/// Angles that differ by less, degrees, are the same.
const SAME: f64 = 1e-9;
/// A whole turn.
const TURN: f64 = 360.0;
/// An axis turns at most so far at once, degrees, while the ball stays over the sphere.
const MOST_STEP: f64 = 10.0;
/// The greatest share of the way beyond a position that a backlash may be.
const MOST_BACKLASH: f64 = 0.5;
/// The share of the clearance that the straight way of the linear axes may come nearer to the sphere than the ends of it.
const NEARER: f64 = 0.25;

/// The fault of another tool axis than Z (001:14032, 002:50).
///
/// # Errors
/// The tool axis is not Z.
pub(super) fn along_z(control: &dyn Control) -> Result<(), Fault> {
    let tool = control.plane().tool;
    if tool == Axis::Z {
        return Ok(());
    }
    Err(Fault::control("kinematics-tool-axis").arg("axis", tool.letter().to_string()))
}

/// How a sphere is probed.
struct Work<'c> {
    control: &'c mut dyn Control,
    model: Machine,
    arm: Arm,
    probing: Probing,
    radius: f64,
    points: u32,
    clearance: f64,
    feed: f64,
    reference: f64,
}

impl<'c> Work<'c> {
    fn new(
        control: &'c mut dyn Control,
        (radius, points): (Mm<f64>, f64),
        clearance: Mm<f64>,
        feed: Mm<f64>,
        reference: f64,
    ) -> Result<Self, Fault> {
        along_z(control)?;
        if let Some(number) = control.limit("rotary-axis-m-function").filter(|number| *number >= 0.0) {
            return Err(Fault::unsupported("unsupported-m").arg("word", format!("M{number}")));
        }
        let (model, arm, probing) = (control.kinematics(), control.arm()?, control.probing()?);
        let (radius, points, reference) = (radius.0, points.max(1.0) as u32, reference + control.basic_rotation());
        let clearance = probing.set_up + clearance.0;
        Ok(Self { control, model, arm, probing, radius, points, clearance, feed: feed.0, reference })
    }

    /// From the centre of the sphere to that of the ball, before it touches.
    fn away(&self) -> f64 {
        self.radius + self.probing.radius + self.clearance
    }

    /// A direction of the tool, as the head is turned.
    fn of_tool(&self, direction: DVec3) -> DVec3 {
        self.model.head(self.control.angles()).vector(direction)
    }

    fn up(&self) -> DVec3 {
        self.of_tool(self.control.plane().tool.unit())
    }

    /// Where the linear axes are, but for the offset of the ball.
    fn here(&self) -> DVec3 {
        self.control.linear() + self.of_tool(self.arm.offset)
    }

    fn go(&mut self, to: DVec3, feed: f64) -> Done {
        let to = to - self.of_tool(self.arm.offset);
        self.control.go_turning(&[], to, feed)
    }

    /// Over a point, as seen along the tool: back along it if need be, across, and towards it.
    fn go_over(&mut self, to: DVec3) -> Done {
        let up = self.up();
        let above = (self.here() - to).dot(up);
        if above < 0.0 {
            self.go(self.here() - up * above, self.feed)?;
        }
        self.go(to + up * above.max(0.0), self.feed)?;
        self.go(to, self.feed.min(self.probing.feed))
    }

    /// Probes the sphere that is expected there, from over it, and ends over it. Where its centre is.
    fn measure(&mut self, expected: DVec3) -> Done<DVec3> {
        let (away, up) = (self.away(), self.up());
        let plane = self.control.plane();
        let (main, minor) = (self.of_tool(plane.main.unit()), self.of_tool(plane.secondary.unit()));
        let between = self.probing.feed;
        let pole = self.control.touch(-up)?;
        let height = (pole - expected).dot(up) - (self.radius + self.probing.radius);
        let centre = expected + up * height;
        let mut touched = vec![pole];
        for point in 0..self.points {
            let angle = self.reference + TURN / f64::from(self.points) * f64::from(point);
            let out = main * cosd(angle) + minor * sind(angle);
            let beside = centre + out * away;
            self.go(beside + up * away, between)?;
            self.go(beside, self.feed.min(between))?;
            touched.push(self.control.touch(-out)?);
            self.go(beside + up * away, between)?;
        }
        let fitted = fit_sphere(&touched).map_err(|_| Fault::control("fit-failed"))?;
        let radius = fitted.radius - self.probing.radius;
        let limit = self.control.limit("max-ball-deviation");
        if limit.is_some_and(|limit| (radius - self.radius).abs() > limit) {
            let fault = Fault::control("sphere-radius-differs").arg("found", radius).arg("entered", self.radius);
            return Err(fault.into());
        }
        self.go(fitted.centre + up * away, between)?;
        Ok(fitted.centre)
    }

    /// Where a sphere is seen that is there with the table at 0, with the rotary axes at these angles.
    fn expected(&self, sphere: DVec3, angles: DVec3) -> DVec3 {
        expected(&self.model, &self.arm, sphere, angles)
    }

    /// The way back.
    fn sphere(&self, seen: DVec3, angles: DVec3) -> DVec3 {
        sphere(&self.model, &self.arm, seen, angles)
    }

    /// Turns one axis while the ball stays over the sphere.
    fn turn_over(&mut self, axis: RotaryAxis, to: f64, sphere: DVec3) -> Done {
        let before = self.control.angles();
        let way = to - axis.of(before);
        if way.abs() < SAME {
            return Ok(());
        }
        let Some(data) = self.model.rotary(axis).copied() else { return Ok(()) };
        let turning = self.model.turning(&data, before);
        let point = match data.carries {
            Carried::Workpiece => self.model.table(before).point(sphere),
            Carried::Tool => self.model.head(before).point(self.arm.ball - self.arm.pivot),
        };
        let radius = (point - turning.centre).reject_from(turning.direction).length() + self.away();
        // On a chord the ball comes nearer by what the arc rises over it.
        let rise = (self.clearance * NEARER / radius).clamp(1e-6, 1.0);
        let step = (2.0 * libm::acos(1.0 - rise)).to_degrees().min(MOST_STEP);
        let steps = (way.abs() / step).ceil().max(1.0);
        for at in 1..=steps as u32 {
            let angle = if f64::from(at) >= steps { to } else { axis.of(before) + way * f64::from(at) / steps };
            let angles = axis.with(before, angle);
            let head = self.model.head(angles);
            let over = self.expected(sphere, angles) + head.vector(self.control.plane().tool.unit()) * self.away();
            self.control.go_turning(&[(axis, angle)], over - head.vector(self.arm.offset), self.feed)?;
        }
        Ok(())
    }

    /// To the next position of the rotary axes, over the sphere: over the retraction height, or without it, in the order
    /// A, B, C.
    fn go_to(&mut self, angles: DVec3, sphere: DVec3, retraction: f64) -> Done {
        let moves = |control: &dyn Control| -> Vec<(RotaryAxis, f64)> {
            let now = control.angles();
            let turned = RotaryAxis::ALL.into_iter().filter(|axis| (axis.of(angles) - axis.of(now)).abs() > SAME);
            turned.map(|axis| (axis, axis.of(angles))).collect()
        };
        let turns = moves(self.control);
        if turns.is_empty() {
            let over = self.expected(sphere, angles) + self.up() * self.away();
            return if (self.here() - over).length() < SAME { Ok(()) } else { self.go_over(over) };
        }
        if retraction > 0.0 {
            let (frame, tool) = (self.control.frame(), self.control.plane().tool);
            let here = frame.inverse().point(self.control.linear());
            for to in [tool.with(here, retraction), tool.unit() * retraction] {
                self.control.go_turning(&[], frame.point(to), self.feed)?;
            }
            for (axis, angle) in turns {
                let here = self.control.linear();
                self.control.go_turning(&[(axis, angle)], here, self.feed)?;
            }
        } else {
            let now = self.control.angles();
            self.go_over(self.expected(sphere, now) + self.up() * self.away())?;
            for (axis, angle) in turns {
                self.turn_over(axis, angle, sphere)?;
            }
        }
        self.go_over(self.expected(sphere, angles) + self.up() * self.away())
    }
}

impl MeasureRotaryAxes {
    /// What each axis of the machine is measured with; entries for others are ignored (001:14363-14364).
    fn plans(&self, model: &Machine) -> Vec<AxisPlan> {
        let all = [
            (self.start_a, self.end_a, self.incidence_a, self.points_a),
            (self.start_b, self.end_b, self.incidence_b, self.points_b),
            (self.start_c, self.end_c, self.incidence_c, self.points_c),
        ];
        let plan = |(axis, (start, end, incidence, points)): (RotaryAxis, (f64, f64, f64, f64))| AxisPlan {
            axis,
            start,
            end,
            incidence,
            points: points.max(0.0) as u32,
        };
        let of_machine = |plan: &AxisPlan| model.rotary(plan.axis).is_some();
        RotaryAxis::ALL.into_iter().zip(all).map(plan).filter(of_machine).collect()
    }

    /// The positions of an axis without those at 0, where the reference measurement is.
    fn positions(&self, plan: &AxisPlan, of: Option<&RotaryMachineAxis>) -> Result<Vec<f64>, Fault> {
        let hirth = of.and_then(|of| of.hirth);
        let at_zero = |angle: &f64| {
            let rest = angle.rem_euclid(TURN);
            rest.min(TURN - rest) < SAME
        };
        let mut positions = plan.positions(hirth);
        if !self.skip_zero && positions.iter().any(at_zero) {
            let letter = plan.axis.letter().to_string();
            return Err(Fault::control("measuring-position-at-zero").arg("axis", letter));
        }
        positions.retain(|angle| !at_zero(angle));
        // The control needs that way to make up for the backlash (001:14532, 002:1029-1033).
        if let (Some(of), Some(way)) = (of.filter(|of| of.is_measured_at_motor), self.before_limit) {
            let near = positions.iter().find(|angle| of.reaches(**angle) && !of.keeps_from_limits(**angle, way));
            if let Some(angle) = near {
                let fault = Fault::control("measuring-position-near-limit").arg("axis", plan.axis.letter().to_string());
                return Err(fault.arg("angle", *angle).arg("way", way));
            }
        }
        Ok(positions)
    }

    /// Measures the sphere with one axis at an angle; from both sides where the backlash is measured.
    fn station(&self, work: &mut Work<'_>, of: Measured<'_>, sphere: DVec3, overtravel: f64) -> Done<Station> {
        let Measured { axis, angles, is_reference } = of;
        let from = |work: &mut Work<'_>, beyond: f64| -> Done<DVec3> {
            if let Some(axis) = axis.filter(|_| beyond != 0.0) {
                let aside = axis.with(*angles, axis.of(*angles) + beyond);
                work.go_to(aside, sphere, self.retraction.0)?;
            }
            work.go_to(*angles, sphere, self.retraction.0)?;
            let expected = work.expected(sphere, *angles);
            work.measure(expected)
        };
        let seen = from(work, -overtravel)?;
        let again = if overtravel != 0.0 { Some(from(work, overtravel)?) } else { None };
        Ok(Station { axis, is_reference, angles: *angles, seen, again })
    }
}

/// A position of the rotary axes.
struct Measured<'a> {
    axis: Option<RotaryAxis>,
    angles: &'a DVec3,
    is_reference: bool,
}

impl Action for MeasureRotaryAxes {
    type Results = MeasuredResults;
    const PROBES: bool = true;

    fn act(&self, control: &mut dyn Control) -> Done<MeasuredResults> {
        control.release_tip()?;
        let plans = self.plans(&control.kinematics());
        let (start, datum) = (control.angles(), control.angle_datum());
        let preset = control.preset_in_effect().1;
        let feed = self.feed;
        let mut work = Work::new(control, (self.radius, self.points), self.clearance, feed, self.reference)?;
        let model = work.model.clone();
        let mut stations: Vec<Station> = Vec::new();
        // The sphere is in the preset, which was set with the rotary axes at their datum.
        let mut sphere = model.table(datum).inverse().point(preset);
        let grid = |axis: RotaryAxis| model.rotary(axis).and_then(|data| data.hirth);
        for plan in plans.iter().filter(|plan| plan.points > 0) {
            if grid(plan.axis).is_some() && self.retraction.0 == 0.0 {
                let letter = plan.axis.letter().to_string();
                return Err(Fault::control("hirth-without-retraction").arg("axis", letter).into());
            }
        }
        let incident = plans
            .iter()
            .fold(DVec3::ZERO, |angles, plan| plan.axis.with(angles, on_grid(plan.incidence, grid(plan.axis))));
        for plan in plans.iter().filter(|plan| plan.points > 0) {
            let (axis, hirth) = (plan.axis, grid(plan.axis));
            let positions = self.positions(plan, model.rotary(axis))?;
            let at_zero = axis.with(incident, 0.0);
            let circle = work.circle(axis, at_zero, sphere);
            let measured = self.overtravel != 0.0 && hirth.is_none() && circle >= LEAST_CIRCLE;
            let sense = if plan.end < plan.start { -1.0 } else { 1.0 };
            let overtravel = if measured { self.overtravel.abs() * sense } else { 0.0 };
            let of = Measured { axis: Some(axis), angles: &at_zero, is_reference: true };
            let reference = self.station(&mut work, of, sphere, overtravel)?;
            sphere = work.sphere(reference.seen, at_zero);
            stations.push(reference);
            for angle in positions {
                let angles = axis.with(incident, angle);
                let of = Measured { axis: Some(axis), angles: &angles, is_reference: false };
                stations.push(self.station(&mut work, of, sphere, overtravel)?);
            }
        }
        if stations.is_empty() {
            let of = Measured { axis: None, angles: &start, is_reference: true };
            let reference = self.station(&mut work, of, sphere, 0.0)?;
            sphere = work.sphere(reference.seen, start);
            stations.push(reference);
        }
        work.go_to(start, sphere, self.retraction.0)?;
        let arm = work.arm;
        let survey = Survey {
            model,
            arm,
            radius: self.radius.0,
            plans,
            stations,
            fit: None,
            reports: Vec::new(),
            is_only_logged: false,
        };
        let most = self.overtravel.abs() * MOST_BACKLASH;
        let in_doubt = survey.axes().any(|plan| survey.backlash(plan.axis).is_some_and(|backlash| backlash > most));
        control.keep_survey(survey);
        Ok(MeasuredResults { backlash_in_doubt: f64::from(u8::from(in_doubt)) })
    }
}

impl Work<'_> {
    /// The radius of the circle on which an axis takes the sphere, or the ball, round.
    fn circle(&self, axis: RotaryAxis, angles: DVec3, sphere: DVec3) -> f64 {
        let Some(data) = self.model.rotary(axis) else { return 0.0 };
        let turning = self.model.turning(data, angles);
        let point = match data.carries {
            Carried::Workpiece => self.model.table(angles).point(sphere),
            Carried::Tool => self.model.head(angles).point(self.arm.ball - self.arm.pivot),
        };
        (point - turning.centre).reject_from(turning.direction).length()
    }
}

impl Action for PresetIntoSphere {
    type Results = ();
    const PROBES: bool = true;

    fn act(&self, control: &mut dyn Control) -> Done {
        control.release_tip()?;
        let angles = control.angles();
        let mut work = Work::new(control, (self.radius, self.points), self.clearance, self.feed, self.reference)?;
        // The probe is over the sphere.
        let under = work.here() - work.up() * work.away();
        let seen = work.measure(under)?;
        let found = work.sphere(seen, angles);
        let centre = work.model.table(control.angle_datum()).point(found);
        let (row, origin) = control.preset_in_effect();
        for axis in Axis::ALL {
            control.write(TableKind::Preset, row, &column(axis), &Cell::Number(axis.of(centre)))?;
        }
        control.move_preset(centre - origin);
        Ok(())
    }
}

/// Calculates what fits, keeps it with the report, and says what it would change.
fn optimize(control: &mut dyn Control, directions: bool) -> Done<(Survey, Fit)> {
    let mut survey = control.survey()?;
    let (places, both) = (Fit::of(&survey, false), Fit::of(&survey, true));
    let fit = if directions { both.clone() } else { places };
    survey.report(&fit, &both);
    Ok((survey, fit))
}

fn keep(control: &mut dyn Control, mut survey: Survey, fit: Fit) -> ChangeResults {
    let limit = control.limit("max-modification");
    let exceeds = limit.is_some_and(|limit| fit.greatest_change(&survey.model) > limit);
    let calculated = fit.undetermined.is_empty();
    survey.fit = Some(fit);
    control.keep_survey(survey);
    ChangeResults { calculated: f64::from(u8::from(calculated)), exceeds: f64::from(u8::from(exceeds)) }
}

/// The fault of positions that do not tell where an axis is.
fn all_told(fit: &Fit) -> Result<(), Fault> {
    let Some(axis) = fit.undetermined.first() else { return Ok(()) };
    Err(Fault::control("kinematics-undetermined").arg("axis", axis.letter().to_string()))
}

impl Action for RateKinematics {
    type Results = ChangeResults;

    fn act(&self, control: &mut dyn Control) -> Done<ChangeResults> {
        let (survey, fit) = optimize(control, false)?;
        Ok(keep(control, survey, fit))
    }
}

impl Action for OptimizeAxisPositions {
    type Results = ChangeResults;

    fn act(&self, control: &mut dyn Control) -> Done<ChangeResults> {
        if control.survey()?.is_only_logged {
            return Ok(NOTHING);
        }
        let (survey, fit) = optimize(control, false)?;
        all_told(&fit)?;
        Ok(keep(control, survey, fit))
    }
}

impl Action for OptimizeAxisAngles {
    type Results = ChangeResults;

    fn act(&self, control: &mut dyn Control) -> Done<ChangeResults> {
        let (mut survey, mut fit) = optimize(control, true)?;
        if !fit.undetermined.is_empty() {
            // What was measured is logged all the same (002:880-882); nothing is optimized.
            survey.only_log();
            control.keep_survey(survey);
            return Ok(NOTHING);
        }
        // Places follow in another series of measurements.
        for axis in &mut fit.machine.rotary {
            if let Some(known) = survey.model.rotary(axis.axis) {
                axis.centre = known.centre;
            }
        }
        Ok(keep(control, survey, fit))
    }
}

impl Action for OptimizeTransformationChain {
    type Results = ChangeResults;

    fn act(&self, control: &mut dyn Control) -> Done<ChangeResults> {
        let (survey, mut fit) = optimize(control, false)?;
        all_told(&fit)?;
        let (datum, origin) = (control.angle_datum(), control.preset_in_effect().1);
        fit.machine.base += fit.machine.table(datum).point(fit.sphere) - origin;
        Ok(keep(control, survey, fit))
    }
}

impl Action for AdoptKinematics {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        if let Some(fit) = control.survey()?.fit {
            control.set_kinematics(fit.machine);
        }
        Ok(())
    }
}

impl Action for StoreKinematicsResults {
    type Results = KinematicsResults;

    fn act(&self, control: &mut dyn Control) -> Done<KinematicsResults> {
        let survey = control.survey()?;
        let [a, b, c] = RotaryAxis::ALL.map(|axis| survey.reports.iter().find(|report| report.plan.axis == axis));
        let measured = |report: Option<&AxisReport>| report.map_or(-1.0, |report| report.scatter);
        let optimized = |report: Option<&AxisReport>| report.and_then(|report| report.optimized).unwrap_or(-1.0);
        let offset = survey.reports.iter().map(|report| report.correction).sum::<DVec3>();
        Ok(KinematicsResults {
            measured_a: measured(a),
            measured_b: measured(b),
            measured_c: measured(c),
            optimized_a: optimized(a),
            optimized_b: optimized(b),
            optimized_c: optimized(c),
            x: offset.x,
            y: offset.y,
            z: offset.z,
        })
    }
}
