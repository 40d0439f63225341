//! The turning spindle: how fast it turns the workpiece, and what a feed per revolution is in mm/min.
//!
//! Invariant: with a constant cutting speed the time of a move is exact; its feed is the mean one.
use std::f64::consts::PI;

use glam::DVec3;

use crate::engine::motion::drives::{Drives, TurningSpindle};
use crate::engine::report::ending::Done;
use crate::engine::report::event::{EventKind, OnDiameter};
use crate::engine::report::fault::Fault;
use crate::engine::solid::Path;

/// The greatest speed that a control takes, 1/min: that of a constant cutting speed near the axis where none is given.
const MOST_SPEED: f64 = 99_999.999;
/// mm in the unit of cutting speeds.
const METRE: f64 = 1000.0;
/// Pieces of an arc for which the mean feed is reckoned.
const PIECES: u32 = 128;

impl TurningSpindle {
    /// Its speed on a diameter, 1/min; 0 while it is stationary.
    pub(crate) fn speed_on(&self, diameter: f64) -> f64 {
        let limit = self.limit.unwrap_or(MOST_SPEED);
        match (self.direction, self.cutting_speed) {
            (0, _) => 0.0,
            (_, None) => self.speed.min(limit),
            (_, Some(cutting)) => (METRE * cutting / (PI * diameter.abs())).min(limit),
        }
    }

    /// Minutes for one revolution, on the mean between two diameters that a move goes through evenly.
    fn mean_period(&self, from: f64, to: f64) -> f64 {
        let Some(cutting) = self.cutting_speed else { return 1.0 / self.speed_on(to) };
        let limit = self.limit.unwrap_or(MOST_SPEED);
        // Below this diameter the limit holds: the period is constant there and grows with the diameter above.
        let (per_mm, limited) = (PI / (METRE * cutting), METRE * cutting / (PI * limit));
        // The integral of the period over diameters, from 0.
        let sum = |diameter: f64| {
            let above = (diameter.abs() - limited).max(0.0);
            let least = diameter.abs().min(limited) / limit;
            (least + per_mm * above * (limited + above / 2.0)) * diameter.signum()
        };
        if (from - to).abs() <= f64::EPSILON * from.abs().max(1.0) {
            return 1.0 / self.speed_on(to);
        }
        (sum(to) - sum(from)) / (to - from)
    }
}

impl Drives<'_, '_> {
    /// Turns the workpiece in a direction, or no longer.
    pub(crate) fn turn_workpiece(&mut self, direction: i8) -> Done {
        if direction != 0 && !self.world.system.turning {
            return Err(Fault::unsupported("unsupported-m").arg("word", "M303, M304").into());
        }
        self.switched.turned.direction = direction;
        let speed = self.switched.turned.speed_on(self.diameter(self.world.here));
        self.report.report(EventKind::Spindle { tool: None, direction, speed, orient: None });
        Ok(())
    }

    /// From now on feeds are per revolution, in step with the workpiece from an angle on: it keeps the speed that it has
    /// on a diameter.
    pub(crate) fn keep_step(&mut self, angle: f64, diameter: f64) {
        let turned = &mut self.switched.turned;
        turned.speed = turned.speed_on(diameter);
        (turned.cutting_speed, turned.limit, self.switched.per_revolution) = (None, None, true);
        let (direction, speed) = (turned.direction, turned.speed);
        let orient = Some(angle.rem_euclid(360.0));
        self.report.report(EventKind::Spindle { tool: None, direction, speed, orient });
    }

    /// The diameter at a point of the program.
    fn diameter(&self, point: DVec3) -> f64 {
        2.0 * point.x
    }

    /// What a move to a point of the program ends on, in turning.
    pub(crate) fn on_diameter(&self, to: DVec3) -> Option<OnDiameter> {
        let diameter = self.diameter(to);
        let speed = || self.switched.turned.speed_on(diameter);
        self.world.system.turning.then(|| OnDiameter { diameter, speed: speed() })
    }

    /// A feed in mm/min along a path in machine coordinates: while feeds are per revolution, the mean one.
    pub(crate) fn per_minute(&self, feed: f64, path: &Path) -> Result<f64, Fault> {
        if !self.switched.per_revolution {
            return Ok(feed);
        }
        let per_minute = match self.world.system.turning {
            false => feed * f64::from(self.switched.spindle.direction.abs()) * self.switched.spindle.speed,
            true => feed / self.mean_period(path),
        };
        let known = (per_minute > 0.0).then_some(per_minute);
        known.ok_or_else(|| Fault::program("feed-missing").arg("feed", per_minute))
    }

    fn mean_period(&self, path: &Path) -> f64 {
        let turned = self.switched.turned;
        let at = |share: f64| self.diameter(self.world.to_program(path.at(share)));
        if let Path::Line { .. } = path {
            return turned.mean_period(at(0.0), at(1.0));
        }
        let share = |piece: u32| f64::from(piece) / f64::from(PIECES);
        (0..PIECES).map(|piece| turned.mean_period(at(share(piece)), at(share(piece + 1)))).sum::<f64>()
            / f64::from(PIECES)
    }
}
