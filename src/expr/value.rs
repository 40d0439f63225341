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

/// Reduces an angle in degrees to -180..180 without loss.
fn reduce(degrees: f64) -> f64 {
    libm::remainder(degrees, 360.0)
}

/// The sine of an angle in degrees; exact at multiples of 90°.
pub fn sind(degrees: f64) -> f64 {
    let angle = reduce(degrees);
    match angle {
        0.0 | 180.0 | -180.0 => 0.0,
        90.0 => 1.0,
        -90.0 => -1.0,
        _ => libm::sin(angle.to_radians()),
    }
}

/// The cosine of an angle in degrees; exact at multiples of 90°.
pub fn cosd(degrees: f64) -> f64 {
    let angle = reduce(degrees);
    match angle {
        0.0 => 1.0,
        180.0 | -180.0 => -1.0,
        90.0 | -90.0 => 0.0,
        _ => libm::cos(angle.to_radians()),
    }
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
