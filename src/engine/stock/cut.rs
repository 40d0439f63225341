//! What the envelope of a tool takes away from one row of columns.
//!
//! Invariant: a block is skipped where nothing of it can be above the envelope; what is asked before the heights are
//! calculated may only say too often that there is something.
use glam::DVec2;

use super::ball_continuation::BallContinuation;
use super::columns::{BLOCK, Tally, WIDE};
use super::cutter::Tip;
use super::dexel_row::Row;
use super::grid::Grid;
use super::ramp::Ramp;
use super::rim::Rims;
use super::sweep::{HAIR, Sweep};

/// The part of a row on which a sweep is carried out.
struct Part<'g> {
    grid: &'g Grid,
    sweep: &'g Sweep,
    y: f64,
}

/// Everything above the envelope goes. `across` collects where something was cut, see [`Sweep::across`].
pub(super) fn above(grid: &Grid, own: &mut Row, row: usize, sweep: &Sweep, tally: &mut Tally, across: &mut [f64; 2]) {
    let y = grid.y(row);
    let Some(span) = sweep.span(y) else { return };
    let columns = |[from, to]: [f64; 2]| Grid::between(from, to, grid.min.x, grid.each.x, grid.columns);
    let part = Part { grid, sweep, y };
    let level = sweep.level();
    let settled = if level.is_none() { sweep.settled(y) } else { None };
    let settled = settled.and_then(|(footprint, height)| Some((columns(footprint)?, height)));
    for (first, last) in sweep.fresh(y, span).into_iter().filter_map(columns) {
        match (level, settled) {
            (Some(level), _) => part.level(own, (first, last), level, tally, across),
            (None, Some(((from, to), height))) if from.max(first) <= to.min(last) => {
                let (from, to) = (from.max(first), to.min(last));
                part.level(own, (from, to), height, tally, across);
                if first < from {
                    part.curved(own, (first, from - 1), tally, across);
                }
                if to < last {
                    part.curved(own, (to + 1, last), tally, across);
                }
            }
            _ => part.curved(own, (first, last), tally, across),
        }
    }
}

/// The same for a ball that goes on from where it has been.
#[inline(always)]
pub(super) fn continue_ball(
    grid: &Grid,
    own: &mut Row,
    row: usize,
    (sweep, ball): (&Sweep, &BallContinuation),
    tally: &mut Tally,
    across: &mut [f64; 2],
) {
    // Columns with a gap in them are examined one by one.
    if !own.is_above_floor(sweep.low) {
        return above(grid, own, row, sweep, tally, across);
    }
    let part = Part { grid, sweep, y: grid.y(row) };
    let (cut, left) = ball.cut(grid, own, part.y, tally);
    if let Some((first, last)) = cut {
        part.note(first, across);
        part.note(last, across);
    }
    if let Some(columns) = left {
        part.curved(own, columns, tally, across);
    }
}

/// The same for a flat tool on a ramp, in some bands: their first rows and the places of these among the rows.
pub(super) fn ramp(
    grid: &Grid,
    rows: &mut [Row],
    bands: impl Iterator<Item = (usize, usize)>,
    (sweep, ramp, rims): (&Sweep, &Ramp<'_>, &mut Rims),
    tally: &mut Tally,
    across: &mut [f64; 2],
) {
    ramp.cut_bands(grid, rows, bands, rims, (tally, across), |own, row, tally, across| {
        ramp_whole(grid, own, row, (sweep, ramp), tally, across);
    });
}

/// The same in a row all of which has to be examined.
#[inline(never)]
fn ramp_whole(
    grid: &Grid,
    own: &mut Row,
    row: usize,
    (sweep, ramp): (&Sweep, &Ramp<'_>),
    tally: &mut Tally,
    across: &mut [f64; 2],
) {
    // Columns with a gap in them are examined one by one.
    if !own.is_above_floor(sweep.low) {
        own.spread();
        return above(grid, own, row, sweep, tally, across);
    }
    let part = Part { grid, sweep, y: grid.y(row) };
    ramp.cut(grid, own, part.y, tally, |first, last| part.note_all((first, last), across));
}

impl Part<'_> {
    #[inline(always)]
    fn note(&self, column: usize, across: &mut [f64; 2]) {
        let at = self.sweep.across(DVec2::new(self.grid.x(column), self.y));
        *across = [across[0].min(at), across[1].max(at)];
    }

    /// What lies between two columns.
    #[inline(always)]
    fn note_all(&self, (first, last): (usize, usize), across: &mut [f64; 2]) {
        self.note(first, across);
        self.note(last, across);
        // Between them the row may come nearer to the centre of an arc.
        if let Some(middle) = self.sweep.centre()
            && self.grid.x(first) < middle.x
            && middle.x < self.grid.x(last)
        {
            across[0] = across[0].min((self.y - middle.y) * (self.y - middle.y));
        }
    }

    /// The envelope is level between these columns.
    fn level(&self, own: &mut Row, columns: (usize, usize), level: f64, tally: &mut Tally, across: &mut [f64; 2]) {
        own.level(columns, level, tally, |first, last| self.note_all((first, last), across));
    }

    /// The envelope has a height of its own in each column.
    fn curved(&self, own: &mut Row, (first, last): (usize, usize), tally: &mut Tally, across: &mut [f64; 2]) {
        let Self { grid, sweep, y } = *self;
        let mut heights = [f64::INFINITY; BLOCK];
        let flat = sweep.cutter.tip == Tip::Flat;
        let mut next = first / BLOCK;
        while next <= last / BLOCK {
            let block = next;
            next += 1;
            let highest = own.highest(block);
            if highest <= sweep.low {
                continue;
            }
            let begin = block * BLOCK;
            let columns = first.saturating_sub(begin)..(last + 1 - begin).min(BLOCK);
            let half = 0.5 * (columns.len() - 1) as f64 * grid.cell.x;
            let middle = DVec2::new(grid.x(begin + columns.start) + half, y);
            let reached = match sweep.tangent(middle) {
                _ if flat => own.is_above(block, columns.clone(), sweep.low, 0.0),
                Some([height, rise]) => {
                    let start = height - rise * (middle.x - grid.x(begin)) - HAIR;
                    own.is_above(block, columns.clone(), start, rise * grid.cell.x)
                }
                None => highest > sweep.least_near(middle, half),
            };
            if !reached {
                continue;
            }
            let chunks = columns.start / WIDE * WIDE..columns.end.div_ceil(WIDE) * WIDE;
            sweep.heights([grid.x(begin), grid.cell.x, y], chunks.clone(), &mut heights);
            for n in (chunks.start..columns.start).chain(columns.end..chunks.end) {
                heights[n] = f64::INFINITY;
            }
            own.lower(block, chunks, &heights, sweep.low, tally, |first, last| {
                self.note(first, across);
                self.note(last, across);
            });
        }
    }
}

/// Everything between the lower and the upper envelope of a head goes.
pub(super) fn between(
    grid: &Grid,
    own: &mut Row,
    row: usize,
    sweep: &Sweep,
    head: f64,
    tally: &mut Tally,
    across: &mut [f64; 2],
) {
    let y = grid.y(row);
    let Some([from, to]) = sweep.span(y) else { return };
    let Some((first, last)) = Grid::between(from, to, grid.min.x, grid.each.x, grid.columns) else { return };
    let over = sweep.mirrored();
    let part = Part { grid, sweep, y };
    let (mut low, mut high) = ([f64::INFINITY; BLOCK], [f64::INFINITY; BLOCK]);
    for block in first / BLOCK..=last / BLOCK {
        if own.highest(block) <= sweep.low {
            continue;
        }
        let begin = block * BLOCK;
        let at = [grid.x(begin), grid.cell.x, y];
        sweep.heights(at, 0..BLOCK, &mut low);
        over.heights(at, 0..BLOCK, &mut high);
        for (offset, (low, high)) in low.iter().zip(&high).enumerate() {
            let column = begin + offset;
            if column < first || column > last || *low == f64::INFINITY {
                continue;
            }
            if own.take(column, *low, head - *high, tally) {
                part.note(column, across);
            }
        }
        own.settle(block);
    }
}
