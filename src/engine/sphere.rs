//! The sphere through points.
//!
//! Invariant: the sum of squared distances from the sphere is least (geometric fit); found by damped steps of Gauss and
//! Newton from the algebraic fit, and finished by Newton's method.
use glam::{DMat4, DVec3, DVec4};

use super::geometry::{FitError, MAX_STEPS, NEAR_MINIMUM, NEWTON_STEPS};

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Centre in mm.
    pub centre: DVec3,
    /// Radius in mm.
    pub radius: f64,
}

/// Points count as lying in one plane when the determinant of their spread is below this share of its greatest value.
const FLAT: f64 = 1e-14;

/// The sphere with the least sum of squared distances from the points.
///
/// # Errors
/// Fewer than four points, points in one plane, or no minimum.
pub fn fit_sphere(points: &[DVec3]) -> Result<Sphere, FitError> {
    if points.len() < 4 {
        return Err(FitError::TooFew);
    }
    if !points.iter().all(|p| p.is_finite()) {
        return Err(FitError::NotFinite);
    }
    let mean = points.iter().sum::<DVec3>() / points.len() as f64;
    let scale = points.iter().map(|p| (p - mean).length()).fold(0.0, f64::max);
    if scale == 0.0 {
        return Err(FitError::Collinear);
    }
    let local: Vec<DVec3> = points.iter().map(|p| (p - mean) / scale).collect();
    let unit = refine(algebraic(&local)?, &local)?;
    Ok(Sphere { centre: mean + unit.truncate() * scale, radius: unit.w * scale })
}

fn outer(a: DVec4, b: DVec4) -> DMat4 {
    DMat4::from_cols(a * b.x, a * b.y, a * b.z, a * b.w)
}

/// The fit that is linear in the centre and the power of the origin: centre and radius.
fn algebraic(points: &[DVec3]) -> Result<DVec4, FitError> {
    let (mut normal, mut right) = (DMat4::ZERO, DVec4::ZERO);
    for p in points {
        let row = p.extend(1.0);
        normal += outer(row, row);
        right += row * p.length_squared();
    }
    if normal.determinant().abs() <= FLAT * points.len() as f64 {
        return Err(FitError::Collinear);
    }
    let found = normal.inverse() * right;
    let centre = found.truncate() / 2.0;
    Ok(centre.extend(libm::sqrt((found.w + centre.length_squared()).max(0.0))))
}

/// The distances of the points from the sphere and the derivatives of each by centre and radius.
fn gaps(sphere: DVec4, points: &[DVec3]) -> impl Iterator<Item = (f64, DVec4, f64)> + '_ {
    points.iter().map(move |p| {
        let away = p - sphere.truncate();
        let distance = away.length();
        (distance - sphere.w, (-away / distance).extend(-1.0), distance)
    })
}

fn cost(sphere: DVec4, points: &[DVec3]) -> f64 {
    gaps(sphere, points).map(|(gap, ..)| gap * gap).sum()
}

/// Damped Gauss-Newton until the minimum is near, then Newton.
fn refine(start: DVec4, points: &[DVec3]) -> Result<DVec4, FitError> {
    let (mut best, mut best_cost, mut damping) = (start, cost(start, points), 0.0);
    for _ in 0..MAX_STEPS {
        let (mut normal, mut right) = (DMat4::ZERO, DVec4::ZERO);
        for (gap, row, _) in gaps(best, points) {
            normal += outer(row, row);
            right += row * gap;
        }
        let damped = normal + DMat4::from_diagonal(DVec4::splat(damping * points.len() as f64));
        let step = damped.inverse() * right;
        if !step.is_finite() {
            return Err(FitError::NoConvergence);
        }
        if step.length() <= NEAR_MINIMUM * (1.0 + best.w) {
            return newton(best, points).ok_or(FitError::NoConvergence);
        }
        let next = best - step;
        let next_cost = cost(next, points);
        if next_cost <= best_cost {
            (best, best_cost) = (next, next_cost);
            damping = if damping < 1e-8 { 0.0 } else { damping / 10.0 };
        } else {
            damping = if damping == 0.0 { 1e-4 } else { damping * 10.0 };
        }
    }
    Err(FitError::NoConvergence)
}

/// Newton's method on the gradient; nothing where the sum of squares does not curve upwards.
fn newton(start: DVec4, points: &[DVec3]) -> Option<DVec4> {
    let mut sphere = start;
    for _ in 0..NEWTON_STEPS {
        let (mut hessian, mut gradient) = (DMat4::ZERO, DVec4::ZERO);
        for (gap, row, distance) in gaps(sphere, points) {
            let normal = row.truncate().extend(0.0);
            // The distance itself curves across the normal, by one over the distance.
            let across = DMat4::from_diagonal(DVec4::new(1.0, 1.0, 1.0, 0.0)) - outer(normal, normal);
            hessian += outer(row, row) + across * (gap / distance);
            gradient += row * gap;
        }
        let step = hessian.inverse() * gradient;
        let minimum = hessian.determinant() > 0.0 && step.is_finite() && step.dot(hessian * step) >= 0.0;
        if !minimum {
            return None;
        }
        sphere -= step;
    }
    Some(sphere)
}
