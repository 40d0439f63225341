//! The part left next to the part that was wanted.
//!
//! Columns are exact, so both are compared column by column to rounding; the tolerance says how far a surface may
//! lie from where it should be, in any direction.
use glam::DVec3;

use super::columns::SLIVER;
use super::{Stock, StockTrouble};
use crate::engine::solid::{Body, Shape, SolidError};

/// How a part differs from the wanted one, beyond the tolerance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviation {
    /// Columns that hold too much, and the greatest height of it with its place (machine coordinates).
    pub left_over: Option<(usize, f64, DVec3)>,
    /// Columns that lack something, and the greatest height of it with its place.
    pub gouged: Option<(usize, f64, DVec3)>,
}

impl Deviation {
    /// Whether there is none.
    pub const fn is_none(&self) -> bool {
        self.left_over.is_none() && self.gouged.is_none()
    }
}

/// What `a` has and `b` has not; both from low to high.
fn without(a: &[[f64; 2]], b: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut left = Vec::new();
    for [low, high] in a {
        let mut from = *low;
        for [start, end] in b {
            if *start > from && *start < *high {
                left.push([from, *start]);
            }
            from = from.max(if *start < *high { *end } else { from });
        }
        if from < *high {
            left.push([from, *high]);
        }
    }
    left.retain(|[low, high]| high - low > SLIVER);
    left
}

impl Stock {
    /// Compares what is left with a solid (machine coordinates) of which only the part in the blank counts. A surface
    /// may lie up to `tolerance` (mm) next to its place.
    ///
    /// # Errors
    /// The solid cannot be decided somewhere.
    pub fn compare(&self, wanted: &Shape, tolerance: f64) -> Result<Deviation, StockTrouble> {
        let placed = Shape::Placed { frame: self.grid.back, shape: Box::new(wanted.clone()) };
        let body = Body::new(&placed)?;
        let grid = &self.grid;
        let up = grid.blank(DVec3::Z);
        let mut found = Deviation::default();
        for row in 0..grid.rows {
            for column in 0..grid.columns {
                let origin = grid.blank(DVec3::new(grid.x(column), grid.y(row), 0.0));
                let mut nominal = body.along(origin, up)?;
                nominal.iter_mut().for_each(|[low, high]| {
                    (*low, *high) = (low.max(grid.min.z), high.min(grid.max.z));
                });
                nominal.retain(|[low, high]| high > low);
                let real = self.column(column, row);
                let note = |stretches: Vec<[f64; 2]>, wanted: bool, into: &mut Option<(usize, f64, DVec3)>| {
                    let mut worst: Option<(f64, f64)> = None;
                    for [low, high] in stretches {
                        if let Some(at) = unexplained(&body, origin, up, [low, high], tolerance, wanted)?
                            && worst.is_none_or(|(height, _)| high - low > height)
                        {
                            worst = Some((high - low, at));
                        }
                    }
                    if let Some((height, at)) = worst {
                        let place = grid.frame.point(origin + up * at);
                        let (count, old, _) = into.unwrap_or((0, 0.0, place));
                        *into = match *into {
                            Some((_, _, there)) if old >= height => Some((count + 1, old, there)),
                            _ => Some((count + 1, height, place)),
                        };
                    }
                    Ok::<(), SolidError>(())
                };
                note(without(&real, &nominal), false, &mut found.left_over)?;
                note(without(&nominal, &real), true, &mut found.gouged)?;
            }
        }
        Ok(found)
    }
}

/// A height of the stretch that no surface within the tolerance explains. `inside` says on which side the stretch is.
fn unexplained(
    body: &Body,
    origin: DVec3,
    up: DVec3,
    [low, high]: [f64; 2],
    tolerance: f64,
    inside: bool,
) -> Result<Option<f64>, SolidError> {
    let side = up.any_orthonormal_vector();
    let other = up.cross(side);
    let slant = std::f64::consts::FRAC_1_SQRT_2;
    let around = [
        side,
        -side,
        other,
        -other,
        (side + other) * slant,
        (side - other) * slant,
        (other - side) * slant,
        (side + other) * -slant,
        up,
        -up,
    ];
    let samples = (((high - low) / tolerance).ceil() as usize).clamp(1, 64);
    for sample in 0..samples {
        let at = low + (high - low) * (sample as f64 + 0.5) / samples as f64;
        let point = origin + up * at;
        let mut explained = false;
        for way in around {
            explained = explained || body.contains(point + way * tolerance)? != inside;
        }
        if !explained {
            return Ok(Some(at));
        }
    }
    Ok(None)
}
