//! Strategies that calculate from measured points and texts: directions, intersections, planes, tolerances.
//!
//! Invariant: a direction is never guessed: points that determine none are a fault.
use std::sync::Arc;

use glam::{DMat3, DVec2, DVec3};

use crate::base::expr::atan2d;
use crate::engine::geometry::{Axis, WorkingPlane};
use crate::engine::report::fault::Fault;
use crate::engine::strategy::calculation::{Calculation, directed};
use crate::engine::strategy::signature::{results, strategy};

/// Lines are parallel if the sine of the angle between them is smaller.
const PARALLEL: f64 = 1e-9;
/// Three points lie on a line if the triangle that they span is flatter than this, as a sine.
const ON_LINE: f64 = 1e-9;

strategy! {
    /// The direction from one point to another in the working plane.
    Direction = "direction" {
        /// Where it begins.
        from: DVec3 = Length,
        /// Where it points.
        to: DVec3 = Length,
    }
}

results! {
    /// A direction.
    DirectionResults {
        /// Against the main axis, degrees.
        angle: f64 = Angle,
    }
}

impl Calculation for Direction {
    type Results = DirectionResults;

    fn calculate(&self, _: WorkingPlane) -> Result<DirectionResults, Fault> {
        let way = vector(self.from, self.to)?;
        Ok(DirectionResults { angle: atan2d(way.y, way.x) })
    }
}

strategy! {
    /// The point where two lines of the working plane meet.
    IntersectLines = "intersect-lines" {
        /// A point of the first line.
        first: DVec3 = Length,
        /// Another one.
        second: DVec3 = Length,
        /// A point of the second line.
        third: DVec3 = Length,
        /// Another one.
        fourth: DVec3 = Length,
    }
}

results! {
    /// A point of the working plane.
    IntersectLinesResults {
        /// Its main coordinate.
        main: f64 = Length,
        /// Its minor coordinate.
        minor: f64 = Length,
    }
}

impl Calculation for IntersectLines {
    type Results = IntersectLinesResults;

    fn calculate(&self, _: WorkingPlane) -> Result<IntersectLinesResults, Fault> {
        let first = vector(self.first, self.second)?.normalize();
        let second = vector(self.third, self.fourth)?.normalize();
        let across = first.perp_dot(second);
        if across.abs() < PARALLEL {
            return Err(Fault::control("lines-parallel"));
        }
        let (a, b) = (self.first.truncate(), self.third.truncate());
        let met = a + first * ((b - a).perp_dot(second) / across);
        Ok(IntersectLinesResults { main: met.x, minor: met.y })
    }
}

/// The vector from one point to another in the working plane.
fn vector(from: DVec3, to: DVec3) -> Result<DVec2, Fault> {
    directed((to - from).truncate())
}

strategy! {
    /// The angles of the plane through three points: those of its sections along the axes, those of rotary axes A and B
    /// that tilt a plane parallel to it, and the spatial angles of a system in it, whose main axis runs from the first
    /// point to the second and whose secondary axis points to the side of the third.
    PlaneAngles = "plane-angles" {
        /// The first point.
        first: DVec3 = Length,
        /// The second point.
        second: DVec3 = Length,
        /// The third point.
        third: DVec3 = Length,
    }
}

results! {
    /// The angles of a plane, degrees.
    PlaneAnglesResults {
        /// That of its section along the minor axis.
        section_a: f64 = Angle,
        /// That of its section along the main axis.
        section_b: f64 = Angle,
        /// Where A must be.
        rotary_a: f64 = Angle,
        /// Where B must be.
        rotary_b: f64 = Angle,
        /// The spatial angle about X.
        a: f64 = Angle,
        /// That about Y.
        b: f64 = Angle,
        /// That about Z.
        c: f64 = Angle,
    }
}

impl Calculation for PlaneAngles {
    type Results = PlaneAnglesResults;

    fn calculate(&self, plane: WorkingPlane) -> Result<PlaneAnglesResults, Fault> {
        let (along, aside) = (self.second - self.first, self.third - self.first);
        let normal = along.cross(aside);
        if normal.length() <= ON_LINE * along.length() * aside.length() {
            return Err(Fault::control("plane-through-line"));
        }
        let normal = normal.normalize();
        // Out of the material, where the probe came from.
        let up = if normal.z < 0.0 { -normal } else { normal };
        let [a, b, c] = spatial_angles(along.normalize(), normal, plane);
        Ok(PlaneAnglesResults {
            section_a: atan2d(-up.y, up.z),
            section_b: atan2d(up.x, up.z),
            rotary_a: -atan2d(up.y, libm::hypot(up.x, up.z)),
            rotary_b: atan2d(up.x, up.z),
            a,
            b,
            c,
        })
    }
}

/// The angles about X, then the fixed Y, then the fixed Z that turn the working plane to a
/// main axis and a tool axis.
fn spatial_angles(main: DVec3, tool: DVec3, plane: WorkingPlane) -> [f64; 3] {
    let turned = [main, tool.cross(main), tool].map(|axis| plane.lift(axis.truncate(), axis.z));
    let axes = [plane.main, plane.secondary, plane.tool];
    let column = |wanted: Axis| {
        axes.iter().zip(turned).find(|(axis, _)| **axis == wanted).map_or(DVec3::ZERO, |(_, column)| column)
    };
    let matrix = DMat3::from_cols(column(Axis::X), column(Axis::Y), column(Axis::Z));
    let (x, y, z) = (matrix.x_axis, matrix.y_axis, matrix.z_axis);
    let level = libm::hypot(x.x, x.y);
    let b = atan2d(-x.z, level);
    if level <= ON_LINE {
        // Only the sum or the difference of A and C matters: C stays 0.
        return [atan2d(-z.y, y.y), b, 0.0];
    }
    [atan2d(y.z, z.z), b, atan2d(x.y, x.x)]
}

strategy! {
    /// Reads a tolerance band that is written as a text (TNC 640 manual 004, lines 151-162).
    ToleranceBand = "tolerance-band" {
        /// Such as `0.4-0.1`.
        text: Arc<str> = Text,
    }
}

results! {
    /// A tolerance band.
    ToleranceBandResults {
        /// The upper limit.
        upper: f64 = Length,
        /// The lower limit, signed.
        lower: f64 = Length,
        /// 1 if it is monitored, 0 if the text says nothing.
        monitored: f64 = Number,
    }
}

impl Calculation for ToleranceBand {
    type Results = ToleranceBandResults;

    fn calculate(&self, _: WorkingPlane) -> Result<ToleranceBandResults, Fault> {
        let band = tolerance_band(&self.text);
        let monitored = f64::from(u8::from(band.is_some()));
        let (upper, lower) = band.unwrap_or_default();
        Ok(ToleranceBandResults { upper, lower, monitored })
    }
}

/// Upper and lower limit of a tolerance text: an unsigned upper value, a minus with a lower value, or both.
/// Anything else monitors nothing.
fn tolerance_band(text: &str) -> Option<(f64, f64)> {
    let text = text.trim().replace(',', ".");
    let (upper, lower) = match text.split_once('-') {
        Some((upper, lower)) => (upper, Some(lower)),
        None => (text.as_str(), None),
    };
    let number = |part: &str| {
        let plain = !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit() || b == b'.');
        part.parse::<f64>().ok().filter(|_| plain)
    };
    let upper = if upper.is_empty() && lower.is_some() { Some(0.0) } else { number(upper) }?;
    let lower = lower.map_or(Some(0.0), number)?;
    (upper > 0.0 || lower > 0.0).then_some((upper, -lower))
}
