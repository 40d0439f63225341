//! The bed of a flat tool that goes down: in each row it covers nearly what it covered before, all at one height.
//!
//! A row remembers that as one number while nothing else touches it, so that a step of such a way costs no more than the few
//! columns that the tool leaves and comes to. Invariant: the tops of the columns of a bed are out of date, and what is said to be highest
//! in the blocks from where the bed was first to where it is may be too high, until it is [spread](Row::spread).
use std::ops::Range;

use super::lane::{BLOCK, Row, SLIVER, Tally, larger};
use super::tops::Sum;

/// Fewer columns are no bed.
const LEAST: usize = 2 * BLOCK;

/// Columns that all end at one height.
#[derive(Clone, Debug)]
pub(super) struct Bed {
    from: usize,
    /// Behind the last one.
    to: usize,
    height: f64,
    /// The blocks that were touched since it was laid.
    blocks: Range<usize>,
}

/// What a flat tool covers in a row: its columns, those of them over which it stands where it is lowest, and the height there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    pub first: usize,
    pub last: usize,
    pub from: usize,
    pub to: usize,
    pub height: f64,
}

/// Runs of columns that lose something, told as they end.
struct Lost<F> {
    run: Option<(usize, usize)>,
    tell: F,
}

impl<F: FnMut(usize, usize)> Lost<F> {
    #[inline(always)]
    fn add(&mut self, first: usize, last: usize) {
        match &mut self.run {
            Some((_, end)) if *end + 1 == first => *end = last,
            _ => {
                if let Some((first, last)) = self.run.replace((first, last)) {
                    (self.tell)(first, last);
                }
            }
        }
    }

    fn end(mut self) {
        if let Some((first, last)) = self.run {
            (self.tell)(first, last);
        }
    }
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
        let start = bed.blocks.start;
        for (n, tops) in self.tops.get_mut(bed.blocks).unwrap_or_default().iter_mut().enumerate() {
            let begin = (start + n) * BLOCK;
            let columns = bed.from.saturating_sub(begin).min(BLOCK)..bed.to.saturating_sub(begin).min(BLOCK);
            if columns.len() == BLOCK {
                (tops.level, tops.highest) = (true, bed.height);
            } else {
                tops.apart().get_mut(columns).unwrap_or_default().fill(bed.height);
                tops.renew();
            }
        }
    }

    /// Remembers the columns over which the tool stands lowest, if all of them end there.
    pub(super) fn lay(&mut self, reach: Reach) {
        let Reach { from, to, height, .. } = reach;
        let at = |column: usize| self.top(column) == height;
        if to < from + LEAST || !at(from) || !at(to) || !at((from + to) / 2) {
            return;
        }
        if (from..=to).all(at) {
            self.bed = Some(Bed { from, to: to + 1, height, blocks: from / BLOCK..to / BLOCK + 1 });
        }
    }

    /// Takes one column that is in no bed down to a height. What it loses, and where it ended.
    #[inline(always)]
    fn lower_one(&mut self, column: usize, height: f64, sum: &mut Sum) -> f64 {
        let Some(tops) = self.tops.get_mut(column / BLOCK) else { return 0.0 };
        let top = if tops.level { tops.highest } else { tops.each[column % BLOCK] };
        let loss = top - height;
        // An empty column gives no number here, which is not greater than zero.
        if loss > 0.0 {
            tops.apart()[column % BLOCK] = height;
            sum.height += loss;
            sum.deepest = larger(sum.deepest, loss);
            sum.highest = larger(sum.highest, top);
            return loss;
        }
        0.0
    }

    /// Takes the bed on to where the tool stands now; `heights` gives what the tool leaves of columns beside that, no more than
    /// of a block. Calls `cut` with the first and the last column of each run that loses something. Whether that was
    /// all: if not, nothing was done.
    #[inline(always)]
    pub(super) fn take_on(
        &mut self,
        reach: Reach,
        heights: impl Fn(usize, usize, &mut [f64; BLOCK]),
        tally: &mut Tally,
        cut: &mut impl FnMut(usize, usize),
    ) -> bool {
        let Reach { first, last, from, to, height } = reach;
        let end = to + 1;
        let Some(bed) = &mut self.bed else { return false };
        // Where most of it is new, or much beside it, the whole is looked at.
        let near = bed.from.max(from) + BLOCK <= bed.to.min(end)
            && bed.from.abs_diff(from) <= BLOCK
            && bed.to.abs_diff(end) <= BLOCK
            && from <= first + BLOCK
            && last < end + BLOCK
            && first <= from
            && end <= last + 1;
        if !near || bed.height <= height {
            return false;
        }
        let (was, kept) = (bed.height, bed.from.max(from)..bed.to.min(end));
        let old = bed.from..bed.to;
        let low = first.min(old.start) / BLOCK;
        let high = last.max(old.end - 1) / BLOCK + 1;
        bed.blocks = bed.blocks.start.min(low)..bed.blocks.end.max(high);
        bed.height = height;
        let mut sum = Sum::NONE;
        let mut lost = Lost { run: None, tell: cut };
        let mut low = [f64::INFINITY; BLOCK];
        // What the tool leaves, first on the side of the lower numbers.
        self.leave(old.start..from, was);
        if first < from {
            heights(first, from - first, &mut low);
            self.beside(first..from, &low, &mut sum, &mut lost);
        }
        // What it comes to: all of it that ends at its height belongs to the bed.
        let mut begin = kept.start;
        if from < old.start {
            begin = from;
            for column in from..old.start {
                if self.lower_one(column, height, &mut sum) > SLIVER {
                    lost.add(column, column);
                }
                if self.top_of(column) < height {
                    begin = column + 1;
                }
            }
        }
        let loss = was - height;
        sum.height += loss * kept.len() as f64;
        sum.deepest = larger(sum.deepest, loss);
        sum.highest = larger(sum.highest, was);
        if loss > SLIVER {
            lost.add(kept.start, kept.end - 1);
        }
        let mut behind = kept.end;
        for column in old.end..end {
            if self.lower_one(column, height, &mut sum) > SLIVER {
                lost.add(column, column);
            }
            if behind == column && self.top_of(column) >= height {
                behind = column + 1;
            }
        }
        self.leave(end..old.end, was);
        if end <= last {
            heights(end, last + 1 - end, &mut low);
            self.beside(end..last + 1, &low, &mut sum, &mut lost);
        }
        if let Some(bed) = &mut self.bed {
            (bed.from, bed.to) = (begin, behind);
        }
        sum.into(tally);
        lost.end();
        true
    }

    /// Writes down where columns end that leave the bed.
    #[inline(always)]
    fn leave(&mut self, columns: Range<usize>, height: f64) {
        for column in columns {
            if let Some(tops) = self.tops.get_mut(column / BLOCK) {
                tops.apart()[column % BLOCK] = height;
            }
        }
    }

    #[inline(always)]
    fn beside(
        &mut self,
        columns: Range<usize>,
        heights: &[f64; BLOCK],
        sum: &mut Sum,
        lost: &mut Lost<impl FnMut(usize, usize)>,
    ) {
        for (column, height) in columns.zip(heights) {
            if self.lower_one(column, *height, sum) > SLIVER {
                lost.add(column, column);
            }
        }
    }

    /// The top of a column that is in no bed.
    #[inline(always)]
    fn top_of(&self, column: usize) -> f64 {
        let Some(tops) = self.tops.get(column / BLOCK) else { return f64::NEG_INFINITY };
        if tops.level { tops.highest } else { tops.each[column % BLOCK] }
    }
}
