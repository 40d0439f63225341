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
