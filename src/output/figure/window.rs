//! The rectangle of the world that a figure shows.
use glam::DVec2;

/// A rectangle of the world, to the right and upwards.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    pub(super) min: DVec2,
    pub(super) max: DVec2,
}

impl Window {
    /// Nothing yet.
    pub(super) const EMPTY: Self = Self { min: DVec2::INFINITY, max: DVec2::NEG_INFINITY };

    /// Makes it so large that a place is in it.
    pub(super) fn take(&mut self, p: DVec2) {
        (self.min, self.max) = (self.min.min(p), self.max.max(p));
    }

    /// Its width and height.
    pub(super) fn size(&self) -> DVec2 {
        (self.max - self.min).max(DVec2::splat(1e-6))
    }

    /// The part of a convex polygon inside.
    pub(super) fn clip(&self, polygon: &[DVec2]) -> Vec<DVec2> {
        let mut points = polygon.to_vec();
        for (axis, limit, sign) in
            [(0, self.min.x, 1.0), (0, self.max.x, -1.0), (1, self.min.y, 1.0), (1, self.max.y, -1.0)]
        {
            let inside = |p: &DVec2| (p[axis] - limit) * sign;
            let mut kept = Vec::new();
            for (n, a) in points.iter().enumerate() {
                let b = points.get((n + 1) % points.len()).copied().unwrap_or(*a);
                let (from, to) = (inside(a), inside(&b));
                if from >= 0.0 {
                    kept.push(*a);
                }
                if (from < 0.0) != (to < 0.0) {
                    kept.push(a.lerp(b, from / (from - to)));
                }
            }
            points = kept;
        }
        points
    }
}
