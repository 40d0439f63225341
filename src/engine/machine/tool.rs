//! The tool in the spindle, as the tables and the tool call describe it.

/// The tool in the spindle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tool {
    /// Its number.
    pub number: f64,
    /// Radius with all oversizes, mm.
    pub radius: f64,
    /// Length with all oversizes, mm.
    pub length: f64,
    /// Radius of the corner between end and side with all oversizes, mm: 0 of a flat end, the radius of a ball.
    pub corner: f64,
    /// Angle of the point, degrees; 0 of tools that have none.
    pub point: f64,
    /// Greatest plunging angle, degrees; 0 if none is known.
    pub angle: f64,
    /// Length of the cutting edges, mm; 0 if none is known.
    pub lcuts: f64,
    /// Radius of the edge at the bottom (R2), mm.
    pub corner_radius: f64,
    /// Number of teeth; 0 if none is known.
    pub teeth: f64,
    /// The row of the probe table that belongs to it, if it is a touch probe.
    pub probe: Option<f64>,
    /// The oversizes of the tool call: radius and length, mm.
    pub deltas: (f64, f64),
}

/// The part above the head of a side cutter or back countersink.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neck {
    /// Height of the head, mm.
    pub head: f64,
    /// Radius of the neck, mm.
    pub radius: f64,
}

/// What an insert is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InsertForm {
    /// It turns with the nose between two edges.
    Pointed,
    /// It recesses with a straight edge between two noses.
    Recessing,
    /// It turns threads.
    Thread,
}

impl InsertForm {
    /// The word for it in JSON.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Pointed => "pointed",
            Self::Recessing => "recessing",
            Self::Thread => "thread",
        }
    }
}

/// An insert as a cycle has it meet the workpiece, in the plane of the main axis and the rotary axis. Directions are
/// degrees, counted from the rotary axis towards the main axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Insert {
    /// What it is for.
    pub form: InsertForm,
    /// The radius of its nose, mm.
    pub radius: f64,
    /// From the centre of the nose to the tip of which positions are those, in nose radii: along the main axis and
    /// along the rotary axis.
    pub tip: [f64; 2],
    /// The directions of its edges from the nose: that in front and that behind. Where the tool table does not give
    /// them, both are away from the part.
    pub edges: [f64; 2],
    /// Its width, mm, and the direction from the nose at the tip to the other one; 0 of one that has one nose.
    pub width: (f64, f64),
    /// The length of its edges, mm; 0 if none is known.
    pub length: f64,
}
