//! The values of expressions, and trigonometry in degrees.
use std::sync::Arc;

use glam::DVec3;

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number: mm, degrees, seconds, mm/min or none.
    Number(f64),
    /// True or false.
    Bool(bool),
    /// A point or vector: main, minor and tool axis of the working plane.
    Point(DVec3),
    /// A text.
    Text(Arc<str>),
}

impl Default for Value {
    fn default() -> Self {
        Self::Number(0.0)
    }
}

/// Sine and cosine, reduced to the first eighth of a turn so that right angles come out as whole numbers.
fn sincos(degrees: f64) -> (f64, f64) {
    let turns = libm::round(degrees / 90.0);
    let rest = (degrees - turns * 90.0).to_radians();
    let (s, c) = (libm::sin(rest), libm::cos(rest));
    let (sine, cosine) = match turns.rem_euclid(4.0) as u8 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    };
    // No negative zeros.
    (sine + 0.0, cosine + 0.0)
}

/// The sine of an angle in degrees; exact at multiples of 90°.
pub fn sind(degrees: f64) -> f64 {
    sincos(degrees).0
}

/// The cosine of an angle in degrees; exact at multiples of 90°.
pub fn cosd(degrees: f64) -> f64 {
    sincos(degrees).1
}

/// The tangent of an angle in degrees; not finite at odd multiples of 90°.
pub fn tand(degrees: f64) -> f64 {
    sind(degrees) / cosd(degrees)
}

/// The angle in degrees whose tangent is `x`.
pub fn atand(x: f64) -> f64 {
    libm::atan(x).to_degrees()
}

/// The angle in degrees of the direction (`x`, `y`).
pub fn atan2d(y: f64, x: f64) -> f64 {
    libm::atan2(y, x).to_degrees()
}
