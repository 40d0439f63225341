//! What may be left of the blank: a height for each column of cells along the tool axis.
//!
//! Invariant: never more than what is left. Whatever a tool may have removed is gone, so what is found here is
//! material. Beside it the heights above which there is certainly none: only what a tool that is known has removed is
//! gone from them.
use glam::DVec3;

use super::body::{Body, SKIN};

/// So many cells the longer side of the blank has.
const CELLS: f64 = 64.0;
/// So many places may be cut.
const MOST_PLACES: usize = 400_000;
/// A tool that leans more, by the part of its axis that goes upwards, is not followed.
const LEANS: f64 = 0.05;

/// The heights.
pub(super) struct Remains {
    body: Option<Body>,
    /// The height down to which the blank is there, by rows of cells.
    tops: Vec<f64>,
    /// The heights above which certainly nothing is left.
    most: Vec<f64>,
    /// How wide a cell is, mm.
    pub(super) cell: f64,
    columns: usize,
    places: usize,
    /// Whether something may have been removed that is not known.
    pub(super) open: bool,
}

impl Remains {
    /// Of a blank from which nothing has been removed.
    pub(super) fn of(body: Option<Body>) -> Self {
        let size = body.map_or(DVec3::ZERO, |body| body.high - body.low);
        let cell = (size.x.max(size.y) / CELLS).max(0.01);
        let columns = (size.x / cell).ceil().max(1.0) as usize;
        let rows = (size.y / cell).ceil().max(1.0) as usize;
        let tops = vec![body.map_or(0.0, |body| body.high.z); columns * rows];
        let most = tops.clone();
        Self { body, tops, most, cell, columns, places: 0, open: false }
    }

    fn index(&self, body: &Body, x: f64, y: f64) -> Option<usize> {
        let column = ((x - body.low.x) / self.cell).floor();
        let row = ((y - body.low.y) / self.cell).floor();
        let inside = column >= 0.0 && (column as usize) < self.columns && row >= 0.0;
        inside.then(|| row as usize * self.columns + column as usize).filter(|at| *at < self.tops.len())
    }

    /// Whether a place is inside of what is left of the blank.
    pub(super) fn is_solid(&self, place: DVec3) -> bool {
        let Some(body) = self.body.filter(|body| body.holds(place, SKIN)) else { return false };
        self.index(&body, place.x, place.y).and_then(|at| self.tops.get(at)).is_some_and(|top| place.z < top - SKIN)
    }

    /// How much of the blank is above a place in it, mm.
    pub(super) fn above(&self, place: DVec3) -> f64 {
        let top = self.body.and_then(|body| self.tops.get(self.index(&body, place.x, place.y)?).copied());
        top.filter(|_| self.is_solid(place)).map_or(0.0, |top| top - place.z)
    }

    /// Takes away what a tool of a radius may cut at places, and certainly cuts within another one; `up` is the way
    /// along its axis.
    pub(super) fn cut(&mut self, places: &[DVec3], (radius, sure): (f64, f64), up: DVec3) {
        let Some(body) = self.body else { return };
        let flat = up.truncate().length();
        if flat <= 1e-9 && up.z > 0.0 {
            self.clear(&body, places, sure);
            return self.lower(&body, places, radius, 0.0);
        }
        if up.z < LEANS {
            return self.clear_from_side(&body, places, radius, up);
        }
        // The edge of its end is so much lower than its middle, and its shank is over other columns.
        let deeper = radius * flat;
        for place in places {
            let long = ((body.high.z - place.z + deeper) / up.z).max(0.0);
            let count = (long * flat / self.cell).ceil().max(1.0);
            if count > self.tops.len() as f64 {
                self.open = true;
                return;
            }
            let along: Vec<DVec3> = (0..=count as usize).map(|at| *place + up * (long * at as f64 / count)).collect();
            self.lower(&body, &along, radius, deeper);
            if self.open {
                return;
            }
        }
    }

    /// Takes away whole columns where a tool comes from the side or from below: those that it, or its shank, may touch.
    fn clear_from_side(&mut self, body: &Body, places: &[DVec3], radius: f64, up: DVec3) {
        let long = (body.high - body.low).length();
        let count = (long / self.cell).ceil();
        let deeper = 2.0 * long;
        for place in places {
            if self.open || count > self.tops.len() as f64 {
                self.open = true;
                return;
            }
            let along: Vec<DVec3> = (0..=count as usize).map(|at| *place + up * (long * at as f64 / count)).collect();
            let touched: Vec<DVec3> =
                along.into_iter().filter(|own| body.distance(*own) <= radius + self.cell).collect();
            self.lower(body, &touched, radius, deeper);
        }
    }

    /// Whether a tool of a radius may meet material at places.
    pub(super) fn may_meet(&self, places: &[DVec3], radius: f64) -> bool {
        let Some(body) = self.body else { return true };
        let reach = radius + self.cell;
        places.iter().any(|place| self.around(&body, *place, reach).any(|at| self.is_higher(at, place.z)))
    }

    /// Whether a tool of a radius meets material at places with more than its rim.
    pub(super) fn may_cut(&self, places: &[DVec3], radius: f64) -> bool {
        let Some(body) = self.body else { return true };
        let reach = radius - self.cell;
        let higher = |place: &DVec3| self.around(&body, *place, reach).any(|at| self.is_higher(at, place.z));
        self.open || reach <= 0.0 || places.iter().any(higher)
    }

    fn is_higher(&self, at: usize, height: f64) -> bool {
        self.most.get(at).is_some_and(|most| *most > height + SKIN)
    }

    /// Notes what a tool certainly removes: the columns that lie wholly under it.
    fn clear(&mut self, body: &Body, places: &[DVec3], radius: f64) {
        // The middle of a column is so far from its corners.
        let radius = radius - self.cell / std::f64::consts::SQRT_2;
        if radius <= 0.0 || self.places + places.len() > MOST_PLACES {
            return;
        }
        for place in places {
            let under: Vec<usize> = self.around(body, *place, radius).collect();
            for at in under {
                if let Some(most) = self.most.get_mut(at) {
                    *most = most.min(place.z);
                }
            }
        }
    }

    /// The columns whose middle is so near to a place.
    fn around(&self, body: &Body, place: DVec3, reach: f64) -> impl Iterator<Item = usize> {
        let (cell, columns) = (self.cell, self.columns);
        let rows = self.tops.len() / columns;
        let from = (place - body.low).truncate();
        let span = |value: f64, count: usize| {
            let first = ((value - reach) / cell).floor().max(0.0) as usize;
            first..(((value + reach) / cell).floor() + 1.0).clamp(0.0, count as f64) as usize
        };
        let across = span(from.x, columns);
        span(from.y, rows).flat_map(move |row| across.clone().map(move |column| (row, column))).filter_map(
            move |(row, column)| {
                let middle = [column as f64 + 0.5, row as f64 + 0.5].map(|own| own * cell);
                let near = libm::hypot(middle[0] - from.x, middle[1] - from.y) <= reach;
                near.then_some(row * columns + column)
            },
        )
    }

    /// Lowers the columns about places to them, and by so much more.
    fn lower(&mut self, body: &Body, places: &[DVec3], radius: f64, deeper: f64) {
        if self.places + places.len() > MOST_PLACES {
            self.open = true;
            return;
        }
        self.places += places.len();
        let radius = radius + self.cell;
        for place in places {
            let reach = DVec3::new(radius, radius, 0.0);
            let (from, to) = (*place - reach, *place + reach);
            let first = |value: f64, low: f64| ((value - low) / self.cell).floor().max(0.0) as usize;
            let rows = self.tops.len() / self.columns;
            let (left, right) = (first(from.x, body.low.x), first(to.x, body.low.x).min(self.columns - 1));
            let (lower, upper) = (first(from.y, body.low.y), first(to.y, body.low.y).min(rows - 1));
            if to.x < body.low.x || to.y < body.low.y {
                continue;
            }
            for row in lower..=upper {
                for top in self.tops.iter_mut().skip(row * self.columns).take(right + 1).skip(left) {
                    *top = top.min(place.z - deeper);
                }
            }
        }
    }
}
