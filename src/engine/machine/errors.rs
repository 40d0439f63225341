//! What a machine really is where the control believes something else.
//!
//! Invariant: the control's model is a [`Machine`]; here are only the differences from it, which no control sees.
use glam::DVec3;

use super::Machine;
use crate::engine::geometry::RotaryAxis;

/// A machine as it really is.
#[derive(Clone, Debug, PartialEq)]
pub struct TrueMachine {
    /// Its axes: where and about which lines they really turn.
    pub machine: Machine,
    /// The backlash of A, B and C, degrees: what an axis carries lags behind by half of it in either direction, once the
    /// axis has taken it up.
    pub backlash: DVec3,
    /// By how much the tool really is beside where the linear axes say, mm.
    pub drift: DVec3,
    /// By how much an axis stops beside where it should, degrees: each time it has turned, the next one.
    pub scatter: Vec<(RotaryAxis, Vec<f64>)>,
}

impl TrueMachine {
    /// A machine that is as its model says.
    pub fn as_model(machine: &Machine) -> Self {
        Self { machine: machine.clone(), backlash: DVec3::ZERO, drift: DVec3::ZERO, scatter: Vec::new() }
    }

    /// Displaces the line about which an axis turns, mm, and takes it out of its direction, degrees about X, Y and Z.
    pub fn displace(&mut self, axis: RotaryAxis, centre: DVec3, askew: DVec3) {
        if let Some(found) = self.machine.rotary.iter_mut().find(|known| known.axis == axis) {
            found.centre += centre;
            found.askew += askew;
        }
    }

    /// By how much an axis stops beside where it should, degrees, when it has turned so often.
    pub fn astray(&self, axis: RotaryAxis, turned: usize) -> f64 {
        let known = self.scatter.iter().find(|(known, _)| *known == axis);
        let of = known.and_then(|(_, list)| list.get((turned.max(1) - 1) % list.len().max(1)));
        if turned == 0 { 0.0 } else { of.copied().unwrap_or_default() }
    }

    /// How far what the axes carry is from where they say, degrees, after they have moved: a way shorter than the backlash
    /// does not take all of it up.
    pub fn lag(&self, before: DVec3, way: DVec3) -> DVec3 {
        RotaryAxis::ALL.into_iter().fold(before, |lag, axis| {
            let (way, backlash) = (axis.of(way), axis.of(self.backlash));
            let most = backlash.abs() / 2.0;
            axis.with(lag, (axis.of(lag) - way).clamp(-most, most))
        })
    }
}
