//! What a straight line meets of a solid.
//!
//! Invariant: stretches are reported from low to high and do not touch; skins without thickness do not exist.
use glam::DVec3;

use super::SolidError;
use super::body::Body;
use super::surface::Surface;

/// Stretches that are nearer together than this, mm, are one.
const GAP: f64 = 1e-12;

impl Body {
    /// The stretches `[from, to]` of the line `origin + s direction` that lie in the solid; the direction is a unit
    /// vector, and a stretch without end reaches to infinity.
    ///
    /// # Errors
    /// [`SolidError::NotFinite`] if the line is none.
    pub fn along(&self, origin: DVec3, direction: DVec3) -> Result<Vec<[f64; 2]>, SolidError> {
        if !origin.is_finite() || !direction.is_finite() || direction == DVec3::ZERO {
            return Err(SolidError::NotFinite);
        }
        let mut cuts: Vec<f64> = Vec::new();
        for surface in &self.surfaces {
            cuts.extend(surface.met_by(origin, direction).into_iter().flatten().filter(|s| s.is_finite()));
        }
        self.meshes.iter().for_each(|mesh| mesh.cuts(origin, direction, &mut cuts));
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let mut stretches: Vec<[f64; 2]> = Vec::new();
        let mut from = f64::NEG_INFINITY;
        for to in cuts.iter().copied().chain([f64::INFINITY]) {
            let middle = match (from.is_finite(), to.is_finite()) {
                (true, true) => 0.5 * (from + to),
                (true, false) => from + 1.0,
                (false, true) => to - 1.0,
                (false, false) => 0.0,
            };
            if to - from > GAP && self.contains(origin + direction * middle)? {
                match stretches.last_mut() {
                    Some([_, end]) if from - *end <= GAP => *end = to,
                    _ => stretches.push([from, to]),
                }
            }
            from = to;
        }
        Ok(stretches)
    }
}

impl Surface {
    /// Where a line meets the surface; the other nappe of a cone is no harm.
    fn met_by(&self, origin: DVec3, direction: DVec3) -> [Option<f64>; 2] {
        match *self {
            Self::Plane { normal, offset } => {
                let slope = normal.dot(direction);
                let met = (slope != 0.0).then(|| (offset - normal.dot(origin)) / slope);
                [met, None]
            }
            Self::Sphere { centre, radius } => {
                let way = origin - centre;
                roots(direction.length_squared(), way.dot(direction), way.length_squared() - radius * radius)
            }
            Self::Cylinder { origin: foot, axis, radius } => {
                let across = |v: DVec3| v - axis * v.dot(axis);
                let (way, along) = (across(origin - foot), across(direction));
                roots(along.length_squared(), way.dot(along), way.length_squared() - radius * radius)
            }
            Self::Cone { apex, axis, cos, .. } => {
                let (way, height, climb) = (origin - apex, (origin - apex).dot(axis), direction.dot(axis));
                // |way|² cos² = height² over the whole line.
                let square = direction.length_squared() * cos * cos - climb * climb;
                let linear = way.dot(direction) * cos * cos - height * climb;
                roots(square, linear, way.length_squared() * cos * cos - height * height)
            }
        }
    }
}

/// The roots of `a s² + 2 b s + c`.
fn roots(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    if a.abs() < 1e-14 {
        return [(b.abs() > 1e-14).then(|| -c / (2.0 * b)), None];
    }
    let square = b * b - a * c;
    if square < 0.0 {
        return [None, None];
    }
    // The sum that does not cancel comes first.
    let sum = -(b + b.signum() * square.sqrt());
    if sum == 0.0 { [Some(0.0), None] } else { [Some(sum / a), Some(c / sum)] }
}
