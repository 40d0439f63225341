//! A survey of rotary axes: where a calibration sphere was found while they stood at different angles.
//!
//! Positions of the sphere are those of the linear axes: where the tool tip would be, with the head at 0, when the centre
//! of the probe's ball is in the centre of the sphere (but for the offset of the ball, which the control knows).
//! Invariant: nothing is moved and nothing is changed here; the spatial error of a position is its distance from where
//! the kinematics expect the sphere, seen from the reference position of the same axis (002:886-890).
use glam::DVec3;

use super::fit::Fit;
use super::{Carried, Machine};
use crate::engine::geometry::RotaryAxis;

/// mm in a micrometre.
const MICROMETRE: f64 = 0.001;
/// A measuring circle with a smaller radius, mm, says nothing of angles (001:14311).
pub const LEAST_CIRCLE: f64 = 1.0;

/// How the probe is in the spindle, as the control knows it, while the head is at 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Arm {
    /// From the tool tip to the point about which the head swivels.
    pub pivot: DVec3,
    /// From the tool tip to the centre of the ball, but for its offset from the spindle axis.
    pub ball: DVec3,
    /// That offset.
    pub offset: DVec3,
}

/// How an axis is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisPlan {
    /// The axis.
    pub axis: RotaryAxis,
    /// The first angle, degrees.
    pub start: f64,
    /// The last angle.
    pub end: f64,
    /// Where it is while the other axes are measured.
    pub incidence: f64,
    /// How many positions there are; 0: it is not measured.
    pub points: u32,
}

impl AxisPlan {
    /// Its measuring positions: at equal steps from the first to the last angle, on the grid of Hirth teeth
    /// (001:14184-14240).
    pub fn positions(&self, hirth: Option<f64>) -> Vec<f64> {
        let steps = f64::from(self.points.max(2) - 1);
        let angle = |at: u32| self.start + (self.end - self.start) / steps * f64::from(at);
        (0..self.points).map(|at| on_grid(angle(at), hirth)).collect()
    }
}

/// The nearest angle of the grid of Hirth teeth.
pub fn on_grid(angle: f64, hirth: Option<f64>) -> f64 {
    hirth.map_or(angle, |grid| (angle / grid).round() * grid)
}

/// The sphere at one position of the rotary axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// The axis that is measured; nothing where only the sphere is.
    pub axis: Option<RotaryAxis>,
    /// Whether it is the reference measurement at 0.
    pub is_reference: bool,
    /// The rotary axes.
    pub angles: DVec3,
    /// Where the sphere is.
    pub seen: DVec3,
    /// Where it is when the axis has come to the same angle from the other side.
    pub again: Option<DVec3>,
}

/// What was found of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisReport {
    /// How it was measured.
    pub plan: AxisPlan,
    /// The scatter of the spatial errors that were measured, mm: the root of their mean square.
    pub scatter: f64,
    /// The greatest of these errors, mm.
    pub greatest: f64,
    /// The scatter that is expected after the optimization, mm; nothing where that cannot be calculated.
    pub optimized: Option<f64>,
    /// How far the line about which it turns is out of its direction, degrees; nothing where that cannot be calculated.
    pub askew: Option<f64>,
    /// The mean backlash, degrees, if it was measured.
    pub backlash: Option<f64>,
    /// The mean error of positioning that is left after the optimization, degrees.
    pub positioning: f64,
    /// The radius of the measuring circle, mm.
    pub circle: f64,
    /// By how much the place of the axis is corrected, mm.
    pub correction: DVec3,
    /// How well the positions tell the place of the axis.
    pub rating: f64,
    /// How uncertain angles are, degrees for each micrometre of uncertainty of the system.
    pub uncertainty: f64,
}

/// What was measured, and what follows from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Survey {
    /// The kinematics with which it was measured.
    pub model: Machine,
    /// The probe.
    pub arm: Arm,
    /// The radius of the sphere as entered, mm.
    pub radius: f64,
    /// What each axis was to be measured with.
    pub plans: Vec<AxisPlan>,
    /// The measurements.
    pub stations: Vec<Station>,
    /// The kinematics that fit best, once they were calculated.
    pub fit: Option<Fit>,
    /// What was found of the axes that were measured.
    pub reports: Vec<AxisReport>,
    /// Whether nothing follows from it, as it does not tell directions that were asked for.
    pub is_only_logged: bool,
}

impl Survey {
    /// Where a sphere is seen that is there while the table is at 0.
    pub fn expected(&self, machine: &Machine, sphere: DVec3, angles: DVec3) -> DVec3 {
        expected(machine, &self.arm, sphere, angles)
    }

    /// Where the sphere would be with the table at 0 that was seen in a station.
    pub fn sphere(&self, machine: &Machine, station: &Station) -> DVec3 {
        sphere(machine, &self.arm, station.seen, station.angles)
    }

    /// The axes that were measured.
    pub fn axes(&self) -> impl Iterator<Item = &AxisPlan> {
        self.plans.iter().filter(|plan| plan.points > 0)
    }

    /// The reference measurement of an axis, and its others.
    pub fn of_axis(&self, axis: RotaryAxis) -> (Option<&Station>, Vec<&Station>) {
        let own = || self.stations.iter().filter(move |station| station.axis == Some(axis));
        (own().find(|station| station.is_reference), own().filter(|station| !station.is_reference).collect())
    }

    /// The spatial errors of an axis with some kinematics, mm.
    fn errors(&self, axis: RotaryAxis, machine: &Machine) -> Vec<DVec3> {
        let (Some(reference), others) = self.of_axis(axis) else { return Vec::new() };
        let sphere = self.sphere(machine, reference);
        others.iter().map(|station| station.seen - self.expected(machine, sphere, station.angles)).collect()
    }

    /// The centre and direction of the line about which an axis turns, in the coordinates of [`Station::seen`], and the
    /// sphere as seen from it.
    fn around(&self, axis: RotaryAxis, station: &Station) -> Option<(DVec3, DVec3)> {
        let data = self.model.rotary(axis)?;
        let turning = self.model.turning(data, station.angles);
        let point = match data.carries {
            Carried::Workpiece => self.model.table(station.angles).point(self.sphere(&self.model, station)),
            Carried::Tool => self.model.head(station.angles).point(self.arm.ball - self.arm.pivot),
        };
        let from_centre = point - turning.centre;
        let arm = from_centre - turning.direction * from_centre.dot(turning.direction);
        // Linear axes follow what a table carries, and make up for what a head does.
        let sense = if data.carries == Carried::Workpiece { 1.0 } else { -1.0 };
        Some((turning.direction * sense, arm))
    }

    /// By which angle a displacement of the sphere turns it about an axis, degrees.
    fn angle_of(&self, axis: RotaryAxis, station: &Station, displaced: DVec3) -> f64 {
        let Some((direction, arm)) = self.around(axis, station) else { return 0.0 };
        let along = direction.cross(arm);
        let square = arm.length_squared();
        if square == 0.0 { 0.0 } else { (displaced.dot(along) / square).to_degrees() }
    }

    /// The mean backlash of an axis, degrees, if it was measured.
    pub fn backlash(&self, axis: RotaryAxis) -> Option<f64> {
        let (reference, others) = self.of_axis(axis);
        let circle = self.around(axis, reference?).map_or(0.0, |(_, arm)| arm.length());
        let turned: Vec<f64> = others
            .iter()
            .filter_map(|station| Some(self.angle_of(axis, station, station.again? - station.seen).abs()))
            .collect();
        (circle >= LEAST_CIRCLE && !turned.is_empty()).then(|| mean(&turned))
    }

    /// The reports stay, and nothing is optimized.
    pub fn only_log(&mut self) {
        (self.is_only_logged, self.fit) = (true, None);
        for report in &mut self.reports {
            (report.optimized, report.correction) = (None, DVec3::ZERO);
        }
    }

    /// Reports on every axis, with the kinematics that fit best and those that also fit directions.
    pub fn report(&mut self, fit: &Fit, with_directions: &Fit) {
        let reports = self.axes().filter_map(|plan| self.report_axis(*plan, fit, with_directions)).collect();
        self.reports = reports;
    }

    fn report_axis(&self, plan: AxisPlan, fit: &Fit, with_directions: &Fit) -> Option<AxisReport> {
        let axis = plan.axis;
        let (reference, others) = self.of_axis(axis);
        let reference = reference?;
        let errors = self.errors(axis, &self.model);
        let left = self.errors(axis, &fit.machine);
        let place = |machine: &Machine| machine.rotary(axis).map_or(DVec3::ZERO, |found| found.centre);
        let circle = self.around(axis, reference).map_or(0.0, |(_, arm)| arm.length());
        let told = circle >= LEAST_CIRCLE;
        let positioning: Vec<f64> =
            others.iter().zip(&left).map(|(station, left)| self.angle_of(axis, station, *left)).collect();
        let askew = |machine: &Machine| machine.rotary(axis).map_or(DVec3::ZERO, |found| found.askew);
        let change = askew(&with_directions.machine) - askew(&self.model);
        Some(AxisReport {
            plan,
            scatter: root_mean_square(&errors),
            greatest: errors.iter().map(|error| error.length()).fold(0.0, f64::max),
            optimized: fit.determines(axis).then(|| root_mean_square(&left)),
            askew: with_directions.determines(axis).then(|| change.length()),
            backlash: self.backlash(axis),
            positioning: if told { mean(&positioning) } else { 0.0 },
            circle,
            correction: place(&fit.machine) - place(&self.model),
            rating: fit.rating(axis),
            uncertainty: if circle > 0.0 { (MICROMETRE / circle).to_degrees() } else { 0.0 },
        })
    }
}

/// Where a sphere is seen that is there while the table is at 0.
pub fn expected(machine: &Machine, arm: &Arm, sphere: DVec3, angles: DVec3) -> DVec3 {
    machine.table(angles).point(sphere) - arm.pivot - machine.head(angles).point(arm.ball - arm.pivot)
}

/// The way back from [`expected`].
pub fn sphere(machine: &Machine, arm: &Arm, seen: DVec3, angles: DVec3) -> DVec3 {
    let ball = seen + arm.pivot + machine.head(angles).point(arm.ball - arm.pivot);
    machine.table(angles).inverse().point(ball)
}

fn mean(values: &[f64]) -> f64 {
    if values.is_empty() { 0.0 } else { values.iter().sum::<f64>() / values.len() as f64 }
}

fn root_mean_square(errors: &[DVec3]) -> f64 {
    let squares: Vec<f64> = errors.iter().map(|error| error.length_squared()).collect();
    libm::sqrt(mean(&squares))
}
