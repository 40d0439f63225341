//! The touch probe in the spindle: what the control knows of it, what it really is, and how the spindle turns it.
//!
//! Invariant: positions of the machine are what the control believes; the true ball follows from them here and
//! nowhere else. Where a scene says no truth, what the tables say at its start is true.
use glam::{DVec2, DVec3};

use crate::base::expr::{atan2d, cosd, sind};
use crate::engine::geometry::RotaryAxis;
use crate::engine::machine::Tool;
use crate::engine::report::fault::Fault;
use crate::engine::scene::{Orientation, PreTravel, Scene, Shaft};
use crate::engine::table::{TableError, TableKind};
use crate::engine::world::state::World;
use crate::spec::OnControl;

/// The word of the probe table for pre-positioning at the machine's rapid rate (TNC 320 manual, line 545).
const MACHINE_RAPID: &str = "FMAX_MACHINE";
/// The word that makes the control turn the probe into the probing direction (TNC 320 manual, lines 546-552).
const TRACKING: &str = "ON";
/// A control measures a point at least once and at most so often.
const MEASUREMENTS: (f64, f64) = (1.0, 3.0);

/// Directions that differ by less are the same: what a coordinate of a rotary axis that is written
/// with three decimals leaves.
const STRAIGHT: f64 = 2e-5;

/// What machine parameters of the scene say of every touch probe, on controls that have it there and not in a table.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct OfMachine {
    set_up: Option<f64>,
    feed: Option<f64>,
    fmax: Option<f64>,
    dist: Option<f64>,
    track: Option<f64>,
    measurements: Option<f64>,
    confidence: Option<f64>,
}

impl OfMachine {
    pub(crate) fn new(on: &OnControl, scene: &Scene) -> Self {
        let value = |neutral: &str, column: &str| {
            let printed = on.datum(neutral).filter(|printed| *printed != column)?;
            scene.machine_number(printed)
        };
        Self {
            set_up: value("set-up", "SET_UP"),
            feed: value("probing-feed", "F"),
            fmax: value("positioning-feed", "FMAX"),
            dist: value("probing-distance", "DIST"),
            track: value("track", "TRACK"),
            measurements: value("multiple-measurement", ""),
            confidence: value("confidence-range", ""),
        }
    }
}

/// The touch probe in use: what the control knows of it and what it really is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ProbeData {
    /// Its row in the probe table.
    pub row: f64,
    /// Distance kept from the touch point, mm.
    pub set_up: f64,
    /// Probing feed, mm/min.
    pub feed: f64,
    /// Feed between touch points, mm/min.
    pub fmax: f64,
    /// The greatest probing path, mm.
    pub dist: f64,
    /// Whether pre-positioning is at the machine's rapid rate.
    pub machine_rapid: bool,
    /// The true radius of the ball, mm.
    pub ball_radius: f64,
    /// The radius that the control reckons with, mm.
    pub effective_radius: f64,
    /// By how much the probe is shorter than the control believes, mm.
    pub shorter: f64,
    /// The calibrated offset of the ball from the spindle axis, main and secondary axis, mm, while the probe is at
    /// its calibration angle.
    pub calibrated: DVec2,
    /// The true offset.
    pub offset: DVec2,
    /// The spindle angle at which it was calibrated, degrees.
    pub angle: f64,
    /// How the spindle can turn it.
    pub orientation: Orientation,
    /// Whether it is turned into every probing direction.
    pub track: bool,
    /// What lies between touching and triggering.
    pub pre_travel: PreTravel,
    /// The shaft that carries the ball, where the scene has one.
    pub shaft: Option<Shaft>,
    /// How often a point is measured.
    pub measurements: u32,
    /// How far these measurements may lie apart, mm.
    pub confidence: Option<f64>,
}

impl World<'_> {
    /// The touch probe that a probing cycle uses now. Where no tool has a row of the probe table, the tool in
    /// the spindle is taken for the scene's probe.
    pub(crate) fn read_probe(&self) -> Result<ProbeData, Fault> {
        let missing = || Fault::control("probe-missing");
        let tool = self.tool().ok_or_else(missing)?;
        let truth = self.scene.probe.as_ref().ok_or_else(missing)?;
        let row = match tool.probe {
            Some(row) if row == truth.row => row,
            Some(_) => return Err(missing()),
            None if self.tools_name_probes() => return Err(missing()),
            None => truth.row,
        };
        let table = self.table(TableKind::Probe)?;
        let value = |column| table.number(row, column).map(Option::unwrap_or_default);
        let either = |known: Option<f64>, column| known.map_or_else(|| value(column), Ok);
        let machine = self.of_machine;
        let track = match machine.track {
            Some(track) => track != 0.0,
            None => table.text(row, "TRACK")?.eq_ignore_ascii_case(TRACKING),
        };
        let measurements = machine.measurements.map(|count| count.clamp(MEASUREMENTS.0, MEASUREMENTS.1) as u32);
        Ok(ProbeData {
            row,
            set_up: either(machine.set_up, "SET_UP")?,
            feed: either(machine.feed, "F")?,
            fmax: either(machine.fmax, "FMAX")?,
            dist: either(machine.dist, "DIST")?,
            machine_rapid: table.text(row, "F_PREPOS")? == MACHINE_RAPID,
            ball_radius: truth.ball_radius,
            effective_radius: if self.has_radius(&tool)? { tool.radius } else { truth.ball_radius },
            shorter: self.shorter(&tool, truth.length)?,
            calibrated: DVec2::new(value("CAL_OF1")?, value("CAL_OF2")?),
            offset: truth.offset,
            angle: value("CAL_ANG")?,
            orientation: truth.orientation,
            track: track && truth.orientation == Orientation::Any,
            pre_travel: truth.pre_travel,
            shaft: truth.shaft,
            measurements: truth.measurements.or(measurements).unwrap_or(1),
            confidence: truth.confidence.or(machine.confidence),
        })
    }

    /// Whether the tool table knows the radius of the probe.
    fn has_radius(&self, tool: &Tool) -> Result<bool, TableError> {
        if tool.probe.is_none() {
            return Ok(false);
        }
        Ok(self.table(TableKind::Tool)?.number(tool.number, "R")?.is_some_and(|radius| radius > 0.0))
    }

    /// By how much the probe is shorter than the control believes. Without a true length the table at the start of the
    /// scene is right.
    fn shorter(&self, tool: &Tool, length: Option<f64>) -> Result<f64, TableError> {
        let known = &self.scene.tools;
        let truth = match length {
            Some(length) => length,
            None if tool.probe.is_some() && known.has_row(tool.number) => {
                let value = |column| known.number(tool.number, column).map(Option::unwrap_or_default);
                value("L")? + value("DL")?
            }
            None => return Ok(0.0),
        };
        Ok(tool.length - truth)
    }

    fn tools_name_probes(&self) -> bool {
        let Ok(table) = self.table(TableKind::Tool) else { return false };
        table.rows().any(|row| matches!(table.number(row, "TP_NO"), Ok(Some(number)) if number > 0.0))
    }

    /// Whether the tool in the spindle is known to be a touch probe.
    pub(crate) fn holds_probe(&self) -> bool {
        self.tool().is_some_and(|tool| tool.probe.is_some())
    }

    /// An offset of the ball as the spindle has turned it, in the machine.
    fn turned(&self, offset: DVec2) -> DVec3 {
        let plane = self.system.plane;
        if self.spindle_turned == 0.0 {
            return plane.lift(offset, 0.0);
        }
        let (s, c) = (sind(self.spindle_turned), cosd(self.spindle_turned));
        plane.lift(DVec2::new(offset.x * c - offset.y * s, offset.x * s + offset.y * c), 0.0)
    }

    /// Whether the tool is not at right angles to the working plane, in a system that is part of the workpiece.
    pub(crate) fn is_askew(&self) -> bool {
        let wanted = self.system.frame().vector(self.system.plane.tool.unit()).normalize_or_zero();
        self.system.is_on_workpiece() && (wanted - self.tool_axis()).length() > STRAIGHT
    }

    /// The direction from the tool tip along the tool, in the machine.
    fn tool_axis(&self) -> DVec3 {
        let tool = self.system.plane.tool.unit();
        self.head.map_or(tool, |head| head.vector(tool))
    }

    /// The direction from the tool tip to the ball centre as the control believes it, in program coordinates: that of
    /// the tool axis, unless the control reckons with how the tool is.
    pub(crate) fn up(&self) -> DVec3 {
        let system = &self.system;
        if system.knows_tool() { system.back().vector(self.tool_axis()) } else { system.plane.tool.unit() }
    }

    /// The true centre of the ball, in machine coordinates, when the tool tip is believed to be there. A head that is
    /// turned takes the ball with it.
    pub(crate) fn ball_centre(&self, tip: DVec3, probe: &ProbeData) -> DVec3 {
        let arm = self.arm(probe);
        let Some(head) = self.true_head else { return tip + arm };
        let pivot = self.pivot(tip);
        pivot + head.point(tip + arm - pivot)
    }

    /// From the tool tip to the true centre of the ball in the machine, while the head is at 0.
    pub(crate) fn arm(&self, probe: &ProbeData) -> DVec3 {
        self.straight_up() * (probe.ball_radius + probe.shorter) + self.turned(probe.offset)
    }

    /// The direction along the tool in the machine, while the head is at 0.
    fn straight_up(&self) -> DVec3 {
        let tool = self.system.plane.tool.unit();
        let is_tool = self.head.is_some() || self.system.is_on_workpiece();
        if is_tool { tool } else { self.system.frame().vector(tool) }
    }

    /// The axis of the shaft as it is while the head is at 0.
    pub(crate) fn shaft_of_straight_head(&self, shaft: Shaft) -> DVec3 {
        self.straight_up() * (shaft.length - shaft.radius).max(0.0)
    }

    /// Where the control believes the ball centre to be with the tool tip where it is. It adds the calibrated offset to
    /// where the spindle is; of a head that is turned it knows in a tilted plane and while it holds the tip.
    pub(crate) fn believed_centre(&self, tip: DVec3, probe: &ProbeData) -> DVec3 {
        let up = self.system.frame().vector(self.up());
        tip + self.swung() + up * probe.effective_radius + self.calibrated_offset_in_machine(probe)
    }

    /// The calibrated offset as the spindle has turned it, while the head is at 0.
    pub(crate) fn offset_of_straight_head(&self, probe: &ProbeData) -> DVec3 {
        self.turned(probe.calibrated)
    }

    fn calibrated_offset_in_machine(&self, probe: &ProbeData) -> DVec3 {
        let offset = self.turned(probe.calibrated);
        match self.head {
            Some(head) if self.system.is_on_workpiece() => head.vector(offset),
            _ => offset,
        }
    }

    /// The calibrated offset as the spindle has turned it, in program coordinates.
    pub(crate) fn calibrated_offset(&self, probe: &ProbeData) -> DVec3 {
        self.system.back().vector(self.calibrated_offset_in_machine(probe))
    }

    /// The axis of the shaft in the machine, from the centre of the ball to the centre of its
    /// upper end, which is round.
    pub(crate) fn shaft_axis(&self, shaft: Shaft) -> DVec3 {
        let straight = self.shaft_of_straight_head(shaft);
        self.true_head.map_or(straight, |head| head.vector(straight))
    }

    /// A direction of the machine as the spindle sees it: that of the machine while the head is at 0.
    fn in_spindle(&self, direction: DVec3) -> DVec3 {
        self.true_head.map_or(direction, |head| head.inverse().vector(direction))
    }

    /// How far a surface pushes the ball in until the probe triggers; the direction of the machine, of length 1,
    /// leads into the material.
    pub(crate) fn pre_travel(&self, probe: &ProbeData, direction: DVec3) -> f64 {
        let (plane, direction) = (self.system.plane, self.in_spindle(direction));
        let flat = plane.flat(direction);
        probe.pre_travel.towards(atan2d(flat.y, flat.x) - self.spindle_turned, plane.tool.of(direction))
    }

    /// By how much a trigger comes too late, the next time.
    pub(crate) fn scatter(&mut self) -> f64 {
        let Some(probe) = &self.scene.probe else { return 0.0 };
        if probe.scatter.is_empty() {
            return 0.0;
        }
        let late = probe.scatter.get(self.triggered % probe.scatter.len()).copied().unwrap_or_default();
        self.triggered += 1;
        late
    }

    /// The angle by which the spindle must turn the probe from its calibration angle before it probes in a direction
    /// of the machine; nothing where it stays as it is.
    pub(crate) fn tracked(&self, probe: &ProbeData, direction: DVec3) -> Option<f64> {
        let flat = self.system.plane.flat(self.in_spindle(direction));
        (probe.track && flat.length() > f64::EPSILON).then(|| atan2d(flat.y, flat.x))
    }

    /// Rotary axes, in the order of their letters, that the machine has: their program coordinates.
    pub(crate) fn further_axes(&self) -> impl Iterator<Item = f64> + '_ {
        let angles = self.program_angles();
        let has = |axis: &RotaryAxis| self.scene.machine.rotary(*axis).is_some();
        RotaryAxis::ALL.into_iter().filter(has).map(move |axis| axis.of(angles))
    }
}
