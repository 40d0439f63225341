//! A flat tool on a ramp or on a short piece of a helix: nearly all that it covers lies under it where it stands lowest,
//! and its floor is level there.
//!
//! Of the rest, a rim of few columns, each has a height of its own. Invariant: what is taken from the ends of the way alone
//! is all that is covered in a row, but for rows near the rims beside the way, which are looked at as a whole.
use std::ops::Range;

use glam::DVec2;

use super::Grid;
use super::bed::Reach;
use super::bend::Turned;
use super::cutter::Tip;
use super::lane::{BLOCK, Row, Tally, larger, smaller};
use super::sweep::{HAIR, NARROW, NONE, Sweep, Way};

/// The first and the last of some columns.
type Columns = (usize, usize);

/// A flat tool on its way up or down.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ramp<'s> {
    sweep: &'s Sweep,
    /// Where it stands lowest, and the other end.
    low: DVec2,
    high: DVec2,
    square: f64,
    height: f64,
    /// Rows that may cross a rim beside the way.
    rims: [[f64; 2]; 2],
    /// Whether all under the lower end is gone.
    gone: bool,
    arc: Option<Turned>,
}

impl<'s> Ramp<'s> {
    /// Of a way; nothing if more has to be looked at.
    pub(super) fn new(sweep: &'s Sweep) -> Option<Self> {
        if sweep.cutter.tip != Tip::Flat {
            return None;
        }
        let radius = sweep.cutter.radius;
        let rim = |from: f64, to: f64, bulge: f64| [smaller(from, to) - bulge, larger(from, to) + bulge];
        let (start, end, rise, rims) = match sweep.way {
            Way::Line { from, along, length, rise } if rise != 0.0 && length > 0.0 => {
                let start = DVec2::new(from.x, from.y);
                let end = start + along * length;
                let side = along.x * radius;
                (start, end, rise, [side, -side].map(|side| rim(start.y + side, end.y + side, HAIR)))
            }
            Way::Arc { centre, radius: wide, start, end, sweep: angle, rise, .. } if rise != 0.0 && angle < NARROW => {
                // A rim is no farther from its chord than its radius times the square of the angle over eight.
                let rims = [wide + radius, (wide - radius).max(0.0)].map(|reach| {
                    let bulge = reach * (angle * angle * 0.125) + HAIR;
                    rim(centre.y + start.y * reach, centre.y + end.y * reach, bulge)
                });
                (centre + start * wide, centre + end * wide, rise, rims)
            }
            _ => return None,
        };
        let (low, high) = if rise < 0.0 { (end, start) } else { (start, end) };
        let gone = sweep.joined && rise > 0.0;
        Some(Self { sweep, low, high, square: radius * radius, height: sweep.low, rims, gone, arc: Turned::new(sweep) })
    }

    /// Takes away what it covers in a row, whose columns must all have material down to its lowest place. Calls
    /// `cut` with the first and the last column of each run that loses something.
    #[inline(always)]
    pub(super) fn cut(&self, grid: &Grid, own: &mut Row, y: f64, tally: &mut Tally, mut cut: impl FnMut(usize, usize)) {
        let [mut from, mut to] = NONE;
        let (low, high) = (y - self.low.y, y - self.high.y);
        let (stands, other) = (self.square - low * low, self.square - high * high);
        let half = if stands > 0.0 { stands } else { 0.0 }.sqrt();
        if stands >= 0.0 {
            (from, to) = (self.low.x - half, self.low.x + half);
        }
        if other >= 0.0 {
            let half = other.sqrt();
            (from, to) = (smaller(from, self.high.x - half), larger(to, self.high.x + half));
        }
        let [[a, b], [c, d]] = self.rims;
        if (a <= y && y <= b) || (c <= y && y <= d) {
            let Some(span) = self.sweep.span(y) else { return };
            [from, to] = span;
        }
        let columns = |from: f64, to: f64| Grid::between(from, to, grid.min.x, grid.each.x, grid.columns);
        let Some((first, last)) = columns(from, to) else { return };
        // Under the lower end; where there is no such column, an empty stretch.
        let settled = if half > HAIR { columns(self.low.x - half + HAIR, self.low.x + half - HAIR) } else { None };
        let (from, to) = settled.unwrap_or((usize::MAX, 0));
        let down = !self.gone && from <= to;
        if down {
            let reach = Reach { first, last, from, to, height: self.height };
            let heights =
                |begin: usize, count: usize, out: &mut _| self.beside([grid.x(begin), grid.cell.x, y], count, out);
            if own.take_on(reach, heights, tally, &mut cut) {
                return;
            }
        }
        own.spread();
        let before = tally.height;
        let mut sink = |columns: Columns| {
            let at = |begin: usize| [grid.x(begin), grid.cell.x, y];
            let heights = |begin: usize, part: Range<usize>, out: &mut _| self.sweep.heights(at(begin), part, out);
            own.sink(columns, (from, to), self.height, heights, tally, &mut cut);
        };
        if down {
            sink((first, last));
            if tally.height > before {
                own.lay(Reach { first, last, from, to, height: self.height });
            }
            return;
        }
        if !self.gone || from > to {
            return sink((first, last));
        }
        if first < from {
            sink((first, from - 1));
        }
        if to < last {
            sink((to + 1, last));
        }
    }

    /// The heights that it leaves in so many columns at the points `(x + n step, y)`.
    #[inline(always)]
    fn beside(&self, at: [f64; 3], count: usize, out: &mut [f64; BLOCK]) {
        match &self.arc {
            Some(arc) => self.sweep.leave_helix(arc, at, 0..count, out),
            None => self.sweep.heights(at, 0..count, out),
        }
    }
}
