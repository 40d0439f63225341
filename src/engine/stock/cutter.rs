//! Tools as bodies of revolution: what their envelope removes.
//!
//! Invariant: lengths are mm; the tip is where the program's position is, the shank goes on without end.
use super::sweep::HAIR;
use crate::base::expr::tand;
use crate::engine::machine::{Neck, Tool};

/// The lower end of a tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tip {
    /// Flat: an end mill, a tap, a thread mill as the cylinder of its teeth, a side cutter.
    Flat,
    /// Rounded between end and side with this radius: a bull nose, or a ball if it is the radius of the tool.
    Round(f64),
    /// A cone: height that a mm of radius takes. A drill or a centre drill.
    Point(f64),
}

/// A tool as a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cutter {
    /// Radius, mm.
    pub radius: f64,
    /// The lower end.
    pub tip: Tip,
    /// The thinner part above the head; a tool without it has its radius over its whole length.
    pub neck: Option<Neck>,
    /// Length of the cutting edges, mm; 0 if it is not known.
    pub edges: f64,
}

impl Cutter {
    /// The body of a tool of the tool table: `R2` makes it round, `T-ANGLE` gives it a point. The oversize of a tool
    /// call moves the tool and does not make it wider. Nothing if the tool has no radius, or is a touch probe.
    pub fn of_tool(tool: &Tool, neck: Option<Neck>) -> Option<Self> {
        let radius = tool.radius - tool.deltas.0;
        if radius <= 0.0 || tool.probe.is_some() || !radius.is_finite() {
            return None;
        }
        let tip = if tool.point > 0.0 && tool.point < 180.0 {
            Tip::Point(1.0 / tand(tool.point / 2.0))
        } else if tool.corner > 0.0 {
            Tip::Round(tool.corner.min(radius))
        } else {
            Tip::Flat
        };
        let neck = neck.filter(|neck| neck.radius < radius);
        Some(Self { radius, tip, neck, edges: tool.lcuts.max(0.0) })
    }

    /// Whether its end is half a ball.
    pub(super) fn is_ball(&self) -> bool {
        matches!(self.tip, Tip::Round(corner) if corner >= self.radius)
    }

    /// Height of the end above the tip at a distance from the axis that is not beyond the radius.
    pub(super) fn rise(&self, distance: f64) -> f64 {
        match self.tip {
            Tip::Flat => 0.0,
            Tip::Round(corner) => {
                let beyond = (distance - (self.radius - corner)).max(0.0);
                corner - (corner * corner - beyond * beyond).max(0.0).sqrt()
            }
            Tip::Point(slope) => slope * distance,
        }
    }

    /// The same tool, to whose rim the columns belong that lie on it but for rounding: else rounding would decide anew
    /// at each level whether a column on a wall goes, and a later level would take what the ones before have left as
    /// well. Ends that are round come up to their rim like a wall; their heights must stay what they are.
    pub(super) fn closed(self) -> Self {
        if let Tip::Round(_) = self.tip {
            return self;
        }
        let neck = self.neck.map(|neck| Neck { radius: neck.radius + HAIR, ..neck });
        Self { radius: self.radius + HAIR, neck, ..self }
    }

    /// The same tool made smaller by a skin: only what is deeper in the material than the skin touches it. Its tip
    /// has to be lifted by the skin as well.
    pub(super) fn shrunk(self, skin: f64) -> Self {
        let radius = (self.radius - skin).max(0.0);
        let tip = match self.tip {
            Tip::Round(corner) => Tip::Round((corner - skin).max(0.0)),
            other => other,
        };
        let neck = self
            .neck
            .map(|neck| Neck { head: (neck.head - 2.0 * skin).max(0.0), radius: (neck.radius - skin).max(0.0) });
        Self { radius, tip, neck, ..self }
    }
}
