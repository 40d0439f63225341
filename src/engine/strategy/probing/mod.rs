//! Strategies of the touch probe: probing on a way of its own, going back, what a calibration found.
//!
//! Invariant: one movement at a time; which cycle asks is not known here.
pub mod measure;
pub mod tool_setter;

use glam::DVec3;

use crate::engine::report::ending::{Done, Leave};
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control, Probe, Stopped};
use crate::engine::strategy::signature::{Mm, results, strategy};
use crate::engine::table::{Cell, TableKind};

strategy! {
    /// Probes from where the probe is, on a path and at a feed of its own, and stays where it stops.
    ProbeWithOwnPath = "probe-with-own-path" {
        /// The direction, a vector of length 1.
        direction: DVec3 = Number,
        /// How far it goes at most, mm.
        path: Mm<f64> = Length,
        /// The feed, mm/min.
        feed: Mm<f64> = Feed,
        /// Whether direction and results are in machine coordinates.
        in_machine: Option<bool> = Number,
        /// Whether no touch point is no error.
        tolerant: Option<bool> = Number,
        /// Whether a stylus that is deflected at the start is no error.
        silent: Option<bool> = Number,
    }
}

results! {
    /// Where the probe stopped.
    ProbeWithOwnPathResults {
        /// The main coordinate of the ball centre.
        main: Mm<f64> = Length,
        /// Its minor coordinate.
        minor: Mm<f64> = Length,
        /// Its tool coordinate.
        tool: Mm<f64> = Length,
        /// 0: it touched something; 1: nothing was there; 2: it was deflected at the start.
        status: f64 = Number,
    }
}

strategy! {
    /// Back against the direction in which the probe touched, not beyond where that movement began.
    RetractFromTouchPoint = "retract-from-touch-point" {
        /// How far at most, mm.
        path: Mm<f64> = Length,
    }
}

strategy! {
    /// Writes what a calibration found: effective radius and length into the tool table, the offset of the ball from
    /// the spindle axis into the probe table. All of it acts at once.
    StoreProbeCalibration = "store-probe-calibration" {
        /// The effective radius of the ball, mm.
        radius: Option<Mm<f64>> = Length,
        /// The length of the probe, mm.
        length: Option<Mm<f64>> = Length,
        /// By how much the offset differs from the one in effect, in program coordinates.
        offset: Option<Mm<DVec3>> = Length,
    }
}

impl Action for ProbeWithOwnPath {
    type Results = ProbeWithOwnPathResults;
    const PROBES: bool = true;

    fn act(&self, control: &mut dyn Control) -> Done<ProbeWithOwnPathResults> {
        let given = |flag: Option<bool>| flag.unwrap_or(false);
        let here = control.ball()?;
        let frame = control.frame();
        let way = control.axes(self.direction) * self.path.0;
        let way = if given(self.in_machine) { frame.inverse().vector(way) } else { way };
        let (centre, status) = stroke(way, self.feed.0, given(self.silent), here, control)?;
        if status == NOTHING_THERE && !given(self.tolerant) {
            return Err(Fault::control("probe-no-contact").arg("distance", way.length()).into());
        }
        let centre = control.in_plane(if given(self.in_machine) { frame.point(centre) } else { centre });
        Ok(ProbeWithOwnPathResults { main: Mm(centre.x), minor: Mm(centre.y), tool: Mm(centre.z), status })
    }
}

const TOUCHED: f64 = 0.0;
const NOTHING_THERE: f64 = 1.0;
const DEFLECTED: f64 = 2.0;

/// Where the ball is after a way, and the status; a way of nothing touches nothing.
fn stroke(way: DVec3, feed: f64, silent: bool, here: DVec3, probe: &mut dyn Probe) -> Done<(DVec3, f64)> {
    if way.length() <= 0.0 || way.is_nan() {
        return Ok((here, NOTHING_THERE));
    }
    match probe.stroke(way, feed) {
        Ok(Stopped { centre, touched }) => Ok((centre, if touched { TOUCHED } else { NOTHING_THERE })),
        Err(Leave::Fault(fault)) if silent && fault.code == "probe-deflected" => Ok((here, DEFLECTED)),
        Err(leave) => Err(leave),
    }
}

impl Action for RetractFromTouchPoint {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        control.retract(self.path.0)
    }
}

impl Action for StoreProbeCalibration {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let probe = control.calibration()?;
        for (value, column, called) in [(self.radius, "R", probe.oversizes.0), (self.length, "L", probe.oversizes.1)] {
            if let Some(value) = value {
                // The oversizes of the table and of the tool call stay.
                let delta = control.number(TableKind::Tool, probe.tool, &format!("D{column}"))?;
                let cell = Cell::Number(value.0 - delta.unwrap_or_default() - called);
                control.write(TableKind::Tool, probe.tool, column, &cell)?;
            }
        }
        if let Some(change) = self.offset {
            let change = control.plane().flat(control.frame().vector(control.axes(change.0)));
            let offset = probe.offset + change;
            for (column, value) in [("CAL_OF1", offset.x), ("CAL_OF2", offset.y)] {
                control.write(TableKind::Probe, probe.row, column, &Cell::Number(value))?;
            }
        }
        control.renew()?;
        Ok(())
    }
}
