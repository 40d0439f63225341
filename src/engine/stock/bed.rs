//! The bed of a flat tool that goes down: in each row it covers nearly what it covered before, all at one height.
//!
//! A row remembers that as one number while nothing else touches it, so that a step of such a way costs no more than
//! the few columns that the tool leaves and comes to, which are written down for all rows of a lane (see `rim`).
//! Invariant: the tops of the columns of a bed are out of date, and what is said to be highest in the blocks that were
//! touched since it was laid may be too high, until it is [spread](Row::spread).
use std::ops::Range;

use super::columns::{BLOCK, SLIVER};
use super::dexel_row::Row;
use super::rim::{MOST, Place, Rims};

/// Fewer columns are no bed.
const LEAST: usize = 4;

/// Columns that all end at one height.
#[derive(Clone, Debug)]
pub(super) struct Bed {
    from: u32,
    /// After the last one.
    to: u32,
    height: f64,
    /// The columns of the blocks that were touched since it was laid: none of these is level.
    touched: Range<u32>,
}

/// The columns of all blocks in which some of these lie.
fn whole(columns: &Range<u32>) -> Range<u32> {
    let block = BLOCK as u32;
    columns.start / block * block..columns.end.div_ceil(block) * block
}

/// What a flat tool covers in a row: its columns, and those of them over which it is where it is lowest, from the
/// first to after the last; and the height there.
#[derive(Clone, Debug)]
pub(super) struct Reach {
    pub all: Range<u32>,
    pub footprint: Range<u32>,
    pub height: f64,
}

impl Row {
    /// Brings the tops up to date.
    #[inline(always)]
    pub(super) fn spread(&mut self) {
        if self.bed.is_some() {
            self.spread_bed();
        }
    }

    #[cold]
    #[inline(never)]
    fn spread_bed(&mut self) {
        let Some(bed) = self.bed.take() else { return };
        let (from, to) = (bed.from as usize, bed.to as usize);
        let blocks = bed.touched.start as usize / BLOCK..bed.touched.end as usize / BLOCK;
        let start = blocks.start;
        for (n, tops) in self.tops.get_mut(blocks).unwrap_or_default().iter_mut().enumerate() {
            let begin = (start + n) * BLOCK;
            let columns = from.saturating_sub(begin).min(BLOCK)..to.saturating_sub(begin).min(BLOCK);
            if columns.len() == BLOCK {
                (tops.level, tops.highest) = (true, bed.height);
            } else {
                tops.apart().get_mut(columns).unwrap_or_default().fill(bed.height);
                tops.renew();
            }
        }
    }

    /// Whether there is a bed, or some of these columns may end above a height.
    #[inline(always)]
    pub(super) fn ends_above(&self, columns: Range<usize>, height: f64) -> bool {
        let blocks = columns.start / BLOCK..columns.end.div_ceil(BLOCK);
        self.bed.is_some() || self.tops.get(blocks).unwrap_or_default().iter().any(|tops| tops.highest > height)
    }

    /// Remembers the columns over which the tool is lowest, if all of them end there.
    pub(super) fn lay(&mut self, footprint: Range<u32>, height: f64) {
        let (from, to) = (footprint.start as usize, footprint.end as usize);
        let at = |column: usize| self.top(column) == height;
        if to < from + LEAST || !at(from) || !at(to - 1) || !at((from + to) / 2) || !(from..to).all(at) {
            return;
        }
        let touched = whole(&footprint);
        self.part(touched.clone());
        self.bed = Some(Bed { from: footprint.start, to: footprint.end, height, touched });
    }

    /// Writes the tops of all columns of some blocks down one by one.
    #[cold]
    #[inline(never)]
    fn part(&mut self, columns: Range<u32>) {
        let blocks = columns.start as usize / BLOCK..columns.end as usize / BLOCK;
        for tops in self.tops.get_mut(blocks).unwrap_or_default() {
            tops.apart();
        }
    }

    /// Lays a bed where the tool comes into a row without one, all of whose columns below the tool end higher. Whether
    /// that was all: if not, nothing was done.
    #[inline(never)]
    pub(super) fn begin(
        &mut self,
        Reach { all, footprint, height }: Reach,
        place: Place<'_>,
        left: impl Fn(u32) -> f64,
        rims: &mut Rims,
    ) -> bool {
        let few = footprint.len() <= MOST as usize && all.len() <= 2 * MOST as usize;
        if footprint.len() < LEAST || !few {
            return false;
        }
        let columns = footprint.start as usize..footprint.end as usize;
        if !columns.clone().all(|column| self.top(column) - height > SLIVER) {
            return false;
        }
        let all = all.start.min(footprint.start)..all.end.max(footprint.end);
        let touched = whole(&all);
        self.part(touched.clone());
        rims.begin();
        if self.passes(place.foot, &all, (&(0..0), height), (&footprint, height), left) {
            rims.pass(place.foot);
        }
        rims.leave(self, all.start..footprint.start, place, &(0..0), height);
        rims.leave(self, footprint.end..all.end, place, &(0..0), height);
        rims.come(self, footprint.clone(), place, height);
        self.bed = Some(Bed { from: footprint.start, to: footprint.end, height, touched });
        true
    }

    /// Leaves the bed, over none of whose columns the tool is where it is lowest. Whether that was all:
    /// if not, nothing was done.
    #[inline(never)]
    pub(super) fn end(
        &mut self,
        all: Range<u32>,
        place: Place<'_>,
        left: impl Fn(u32) -> f64,
        rims: &mut Rims,
    ) -> bool {
        let Some(bed) = &mut self.bed else { return false };
        let (old, height) = (bed.from..bed.to, bed.height);
        let all = all.start.min(old.start)..all.end.max(old.end);
        if all.len() > 2 * MOST as usize || all.start < bed.touched.start || all.end > bed.touched.end {
            return false;
        }
        bed.to = bed.from;
        rims.begin();
        if self.passes(place.foot, &all, (&old, height), (&(0..0), height), left) {
            rims.pass(place.foot);
        }
        rims.leave(self, all, place, &old, height);
        true
    }

    /// Takes the bed on to where the tool is now, and writes down which columns it leaves and comes to. `across`
    /// says where a column lies across the way. Whether that was all: if not, nothing was done.
    #[inline(always)]
    pub(super) fn take_on(
        &mut self,
        Reach { all, footprint, height }: Reach,
        place: Place<'_>,
        across: impl Fn(f64) -> f64,
        left: impl Fn(u32) -> f64,
        rims: &mut Rims,
    ) -> bool {
        let Some(bed) = &mut self.bed else { return false };
        let (top, old) = (bed.height, bed.from..bed.to);
        let (mut from, mut to) = (old.start.max(footprint.start), old.end.min(footprint.end));
        let all = all.start.min(footprint.start).min(old.start)..all.end.max(footprint.end).max(old.end);
        // Where much is new, the whole is examined.
        if to <= from || top - height <= SLIVER || from > all.start + MOST || all.end > to + MOST {
            return false;
        }
        let touched = bed.touched.clone();
        if all.start < touched.start || all.end > touched.end {
            let more = whole(&all);
            bed.touched = more.start.min(touched.start)..more.end.max(touched.end);
            self.part(more.start.min(touched.start)..touched.start);
            self.part(touched.end..more.end.max(touched.end));
        }
        rims.begin();
        let (first, last) = (f64::from(from), f64::from(to - 1));
        rims.count(to - from, [top, height], [first, last].map(&across));
        let foot = place.foot[0];
        let passes = foot >= 0.0
            && (first < foot && foot < last || self.passes(place.foot, &all, (&old, top), (&footprint, height), left));
        if passes {
            rims.pass(place.foot);
        }
        // On the side of the lower numbers; all of what it comes to that ends at its height belongs to the bed.
        if all.start < footprint.start {
            rims.leave(self, all.start..footprint.start, place, &old, top);
        }
        if footprint.start < old.start {
            let lower = rims.come(self, footprint.start..old.start, place, height);
            from = lower.map_or(footprint.start, |(_, last)| last + 1);
        }
        // On the other side.
        if footprint.end < all.end {
            rims.leave(self, footprint.end..all.end, place, &old, top);
        }
        if old.end < footprint.end {
            let lower = rims.come(self, old.end..footprint.end, place, height);
            to = lower.map_or(footprint.end, |(first, _)| first);
        }
        if let Some(bed) = &mut self.bed {
            (bed.from, bed.to, bed.height) = (from, to, height);
        }
        true
    }

    /// Whether the foot of a row lies between two columns that lose something: of all that are examined, those of the
    /// `old` bed end at its height, and those over which the tool is come down to another;
    /// `left` says what is left of the others.
    #[inline(always)]
    fn passes(
        &self,
        [foot, _]: [f64; 2],
        all: &Range<u32>,
        old: (&Range<u32>, f64),
        footprint: (&Range<u32>, f64),
        left: impl Fn(u32) -> f64,
    ) -> bool {
        let is_near = f64::from(all.start) < foot && foot + 1.0 < f64::from(all.end);
        is_near && self.loses(foot as u32, old, footprint, &left) && self.loses(foot as u32 + 1, old, footprint, &left)
    }

    #[cold]
    fn loses(
        &self,
        column: u32,
        old: (&Range<u32>, f64),
        footprint: (&Range<u32>, f64),
        left: &impl Fn(u32) -> f64,
    ) -> bool {
        let top = if old.0.contains(&column) { old.1 } else { self.top(column as usize) };
        let after = if footprint.0.contains(&column) { footprint.1 } else { left(column) };
        top - after > SLIVER
    }
}
