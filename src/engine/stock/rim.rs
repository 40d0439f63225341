//! The columns that a flat tool leaves and comes to next to its beds.
//!
//! Those of all rows of a lane are written down one after the other first, and then worked on without a branch, so
//! that it does not matter how many there are in a row. Invariant: what is written down is carried out before anything
//! else is done to the rows.
use std::ops::Range;

use super::columns::{BLOCK, SLIVER, Tally, WIDE, larger, smaller};
use super::cutter_rim::{Seen, Trail};
use super::dexel_row::Row;
use super::grid::BAND;

/// Columns that are written down at most before they are carried out, and of one row on one side.
const ROOM: usize = 512;
pub(super) const MOST: u32 = 32;

/// Columns of several rows, one after the other.
#[derive(Debug)]
struct Columns {
    count: usize,
    /// Where they lie as seen from the way; then where they end, and what distinguishes places across the way.
    x: [f64; ROOM],
    y: [f64; ROOM],
    /// Where they ended.
    top: [f64; ROOM],
    loss: [f64; ROOM],
    /// The numbers of the row in the lane and of the column.
    place: [[u32; 2]; ROOM],
}

impl Columns {
    const NONE: Self =
        Self { count: 0, x: [0.0; ROOM], y: [0.0; ROOM], top: [0.0; ROOM], loss: [0.0; ROOM], place: [[0; 2]; ROOM] };

    /// Writes columns down; `end` says where each of them ended.
    #[inline(always)]
    fn add(&mut self, columns: Range<u32>, place: Place<'_>, mut end: impl FnMut(u32) -> f64) {
        let mut at = self.count;
        let ([mut x, mut y], [dx, dy]) = (place.seen.column(place.at, f64::from(columns.start)), place.seen.step);
        for column in columns {
            // What does not fit has been refused before.
            let n = at % ROOM;
            (self.x[n], self.y[n], self.top[n]) = (x, y, end(column));
            self.place[n] = [place.row, column];
            (x, y, at) = (x + dx, y + dy, at + 1);
        }
        self.count = at;
    }

    /// Calculates where columns end by what is left at a place, and what they lose. Where that is nothing, there is no
    /// number across the way.
    #[inline(always)]
    fn calculate(&mut self, left: impl Fn([f64; 2]) -> f64, across: impl Fn([f64; 2]) -> f64, losses: &mut Losses) {
        // The list is filled up to columns that are worked on side by side with empty ones.
        let all = self.count.next_multiple_of(WIDE).min(ROOM);
        for at in self.count..all {
            self.top[at % ROOM] = f64::NEG_INFINITY;
        }
        let Self { x, y, top, loss, .. } = self;
        for ((x, y), (top, loss)) in x.iter_mut().zip(&mut *y).zip(top.iter_mut().zip(&mut *loss)).take(all) {
            let p = [*x, *y];
            let (low, place, before) = (left(p), across(p), *top);
            let after = smaller(before, low);
            // An empty column gives no number here, which is not greater than zero.
            let lost = larger(0.0, before - after);
            *x = after;
            *loss = lost;
            *y = if lost > SLIVER { place } else { f64::NAN };
            *top = if lost > 0.0 { before } else { f64::NEG_INFINITY };
        }
        let list = y.as_chunks().0.iter().zip(top.as_chunks().0.iter().zip(loss.as_chunks().0));
        for (across, (top, loss)) in list.take(all / WIDE) {
            losses.add(top, loss, across);
        }
    }
}

/// What columns lose, side by side.
#[derive(Clone, Copy, Debug)]
struct Losses {
    height: [f64; WIDE],
    deepest: [f64; WIDE],
    highest: [f64; WIDE],
    /// The least and the greatest that says where across the way something was lost.
    near: [f64; WIDE],
    far: [f64; WIDE],
}

impl Losses {
    const NONE: Self = Self {
        height: [0.0; WIDE],
        deepest: [0.0; WIDE],
        highest: [f64::NEG_INFINITY; WIDE],
        near: [f64::INFINITY; WIDE],
        far: [f64::NEG_INFINITY; WIDE],
    };

    /// What is no number is in no order, and does not count.
    #[inline(always)]
    fn add(&mut self, top: &[f64; WIDE], loss: &[f64; WIDE], across: &[f64; WIDE]) {
        for n in 0..WIDE {
            self.height[n] += loss[n];
            self.deepest[n] = larger(self.deepest[n], loss[n]);
            self.highest[n] = larger(self.highest[n], top[n]);
            self.near[n] = smaller(self.near[n], across[n]);
            self.far[n] = larger(self.far[n], across[n]);
        }
    }
}

/// What a job does to the beds of a lane.
#[derive(Debug)]
pub(super) struct Rims {
    left: Columns,
    fresh: Columns,
    losses: Losses,
    /// Whether anything is written down or counted.
    any: bool,
}

/// A row of a lane: its number there, where its first column lies as seen from the way, the number of the column that
/// is nearest to the centre of the way, and what says this across it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<'s> {
    pub row: u32,
    pub at: [f64; 2],
    pub seen: &'s Seen,
    pub foot: [f64; 2],
}

impl Rims {
    pub(super) fn new() -> Self {
        Self { left: Columns::NONE, fresh: Columns::NONE, losses: Losses::NONE, any: false }
    }

    /// Something is going to be written down.
    #[inline(always)]
    pub(super) fn begin(&mut self) {
        self.any = true;
    }

    /// Counts what all columns of a bed lose, the first and the last of which lie so across the way.
    #[inline(always)]
    pub(super) fn count(&mut self, columns: u32, [top, height]: [f64; 2], [first, last]: [f64; 2]) {
        let Losses { height: sum, deepest, highest, near, far } = &mut self.losses;
        sum[0] += (top - height) * f64::from(columns);
        deepest[0] = larger(deepest[0], top - height);
        highest[0] = larger(highest[0], top);
        (near[0], near[1]) = (smaller(near[0], first), smaller(near[1], last));
        (far[0], far[1]) = (larger(far[0], first), larger(far[1], last));
    }

    /// Counts the place where a row comes nearest to the centre of the way, as something is lost on both sides of it.
    #[inline(always)]
    pub(super) fn pass(&mut self, [_, across]: [f64; 2]) {
        self.losses.near[0] = smaller(self.losses.near[0], across);
    }

    /// Whether there is no room for what a row may need.
    #[inline(always)]
    pub(super) fn is_full(&self) -> bool {
        self.left.count.max(self.fresh.count) + 2 * BAND * MOST as usize > ROOM
    }

    /// Writes columns down that the tool leaves; those of the bed ended at a height.
    #[inline(always)]
    pub(super) fn leave(&mut self, row: &Row, columns: Range<u32>, place: Place<'_>, bed: &Range<u32>, height: f64) {
        if columns.start < bed.start {
            let end = |column: u32| row.top(column as usize);
            self.left.add(columns.start..columns.end.min(bed.start), place, end);
        }
        self.left.add(columns.start.max(bed.start)..columns.end.min(bed.end), place, |_| height);
        if bed.end < columns.end {
            let end = |column: u32| row.top(column as usize);
            self.left.add(columns.start.max(bed.end)..columns.end, place, end);
        }
    }

    /// Takes columns down that the tool comes to. The first and the last that ended lower.
    #[inline(always)]
    pub(super) fn come(
        &mut self,
        row: &mut Row,
        columns: Range<u32>,
        place: Place<'_>,
        height: f64,
    ) -> Option<(u32, u32)> {
        let (mut first, mut last) = (u32::MAX, 0);
        self.fresh.add(columns, place, |column| {
            let Some(tops) = row.tops.get_mut(column as usize / BLOCK) else { return f64::NEG_INFINITY };
            let own = &mut tops.each[column as usize % BLOCK];
            let top = *own;
            if top < height {
                (first, last) = (first.min(column), column);
            } else {
                *own = height;
            }
            top
        });
        (first <= last).then_some((first, last))
    }

    /// Takes from the columns what the tool leaves or takes, and says what all lose.
    pub(super) fn carry_out(
        &mut self,
        rows: &mut [Row],
        trail: &impl Trail,
        height: f64,
        tally: &mut Tally,
        across: &mut [f64; 2],
    ) {
        if !std::mem::take(&mut self.any) {
            return;
        }
        let mut losses = std::mem::replace(&mut self.losses, Losses::NONE);
        self.left.calculate(|p| trail.height(p), |p| trail.across(p), &mut losses);
        let Columns { count, x, place, .. } = &self.left;
        let list = place.get(..*count).unwrap_or_default().iter().zip(x.get(..*count).unwrap_or_default());
        for ([row, column], after) in list {
            let tops = rows.get_mut(*row as usize).and_then(|row| row.tops.get_mut(*column as usize / BLOCK));
            if let Some(tops) = tops {
                tops.each[*column as usize % BLOCK] = *after;
            }
        }
        self.fresh.calculate(|_| height, |p| trail.across(p), &mut losses);
        (self.left.count, self.fresh.count) = (0, 0);
        tally.height += losses.height.iter().sum::<f64>();
        for n in 0..WIDE {
            tally.deepest = larger(tally.deepest, losses.deepest[n]);
            tally.highest = larger(tally.highest, losses.highest[n]);
            *across = [smaller(across[0], losses.near[n]), larger(across[1], losses.far[n])];
        }
    }
}
