//! Rows of columns: the material along parallel lines, and what is taken away from it.
//!
//! A column has its topmost stretch of material in two arrays and stretches below it, which few columns have, in a
//! map. Invariant: stretches of a column do not overlap and stand from low to high; an empty column has the top
//! minus infinity. What a column holds does not grow with the number of cuts: stretches thinner than [`SLIVER`] are
//! dropped, so their number is bounded by the height of the blank.
use std::collections::BTreeMap;

/// Columns that are cut together; the highest top of each such block is known.
pub(super) const BLOCK: usize = 16;
/// Numbers that are worked on side by side.
const WIDE: usize = 4;
/// Material thinner than this, mm, does not exist.
pub(super) const SLIVER: f64 = 1e-6;

/// What a move does to the columns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tally {
    /// Sum of the heights taken away, mm.
    pub height: f64,
    /// The greatest height taken away from one column.
    pub deepest: f64,
    /// The highest place where something was taken away.
    pub highest: f64,
    /// The columns cut: least and greatest distance to the left of the path.
    pub left: [f64; 2],
}

impl Tally {
    pub(super) const NONE: Self =
        Self { height: 0.0, deepest: 0.0, highest: f64::NEG_INFINITY, left: [f64::INFINITY, f64::NEG_INFINITY] };

    pub(super) fn join(&mut self, other: &Self) {
        self.height += other.height;
        self.deepest = self.deepest.max(other.deepest);
        self.highest = self.highest.max(other.highest);
        self.left = [self.left[0].min(other.left[0]), self.left[1].max(other.left[1])];
    }

    /// Counts a stretch that is gone.
    pub(super) fn count(&mut self, low: f64, high: f64) {
        if high > low {
            self.height += high - low;
            self.deepest = self.deepest.max(high - low);
            self.highest = self.highest.max(high);
        }
    }
}

/// A row of columns.
#[derive(Clone, Debug)]
pub(super) struct Row {
    top: Vec<f64>,
    bottom: Vec<f64>,
    highest: Vec<f64>,
    /// Stretches below the topmost one, by column.
    below: BTreeMap<usize, Vec<[f64; 2]>>,
    /// No topmost stretch begins above this.
    floor: f64,
}

impl Row {
    /// A row of that many columns with the stretches that `material` gives, from low to high.
    pub(super) fn new(count: usize, mut material: impl FnMut(usize) -> Vec<[f64; 2]>) -> Self {
        let length = count.div_ceil(BLOCK) * BLOCK;
        let mut row = Self {
            top: vec![f64::NEG_INFINITY; length],
            bottom: vec![f64::INFINITY; length],
            highest: vec![f64::NEG_INFINITY; length / BLOCK],
            below: BTreeMap::new(),
            floor: f64::NEG_INFINITY,
        };
        for column in 0..count {
            row.put(column, material(column));
        }
        (0..length / BLOCK).for_each(|block| row.renew(block));
        row
    }

    fn put(&mut self, column: usize, mut stretches: Vec<[f64; 2]>) {
        stretches.retain(|[low, high]| high - low > SLIVER);
        let [low, high] = stretches.pop().unwrap_or([f64::INFINITY, f64::NEG_INFINITY]);
        if let (Some(top), Some(bottom)) = (self.top.get_mut(column), self.bottom.get_mut(column)) {
            (*top, *bottom) = (high, low);
        }
        if low < f64::INFINITY {
            self.floor = self.floor.max(low);
        }
        if stretches.is_empty() {
            self.below.remove(&column);
        } else {
            self.below.insert(column, stretches);
        }
    }

    /// The stretches of a column from low to high.
    pub(super) fn column(&self, column: usize) -> Vec<[f64; 2]> {
        let mut stretches = self.below.get(&column).cloned().unwrap_or_default();
        if let (Some(top), Some(bottom)) = (self.top.get(column), self.bottom.get(column))
            && top > bottom
        {
            stretches.push([*bottom, *top]);
        }
        stretches
    }

    /// The top of a column; minus infinity if it is empty.
    pub(super) fn top(&self, column: usize) -> f64 {
        self.top.get(column).copied().unwrap_or(f64::NEG_INFINITY)
    }

    /// The highest top of a block.
    pub(super) fn highest(&self, block: usize) -> f64 {
        self.highest.get(block).copied().unwrap_or(f64::NEG_INFINITY)
    }

    fn renew(&mut self, block: usize) {
        let tops = self.top.get(block * BLOCK..(block + 1) * BLOCK).unwrap_or(&[]);
        let highest = tops.iter().fold(f64::NEG_INFINITY, |a, b| if *b > a { *b } else { a });
        if let Some(slot) = self.highest.get_mut(block) {
            *slot = highest;
        }
    }

    /// Takes everything above the heights away from a block; infinity leaves a column alone. Nothing may be lower
    /// than `least`. Calls `cut` with the first and the last column of the block that lose something.
    pub(super) fn lower(
        &mut self,
        block: usize,
        heights: &[f64; BLOCK],
        least: f64,
        tally: &mut Tally,
        mut cut: impl FnMut(usize, usize, &mut Tally),
    ) {
        let begin = block * BLOCK;
        if least <= self.floor {
            self.lower_through(block, heights, tally, cut);
            return;
        }
        let Some(tops) = self.top.get_mut(begin..begin + BLOCK) else { return };
        let Some(tops) = tops.as_chunks_mut::<BLOCK>().0.first_mut() else { return };
        // Four sums side by side, so that nothing waits for the one before it.
        let mut deepest = [0.0_f64; WIDE];
        let mut left = [f64::NEG_INFINITY; WIDE];
        let mut gone = [0.0_f64; BLOCK];
        let parts = tops.as_chunks_mut::<WIDE>().0.iter_mut().zip(heights.as_chunks::<WIDE>().0);
        for ((tops, heights), gone) in parts.zip(gone.as_chunks_mut::<WIDE>().0) {
            for n in 0..WIDE {
                let (top, height) = (tops[n], heights[n]);
                let after = if height < top { height } else { top };
                // An empty column and a place without a tool give no number here, which is not greater than zero.
                let loss = top - after;
                let loss = if loss > 0.0 { loss } else { 0.0 };
                gone[n] = loss;
                deepest[n] = if loss > deepest[n] { loss } else { deepest[n] };
                left[n] = if after > left[n] { after } else { left[n] };
                tops[n] = after;
            }
        }
        let greatest = |values: [f64; WIDE]| values.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let (deepest, left) = (greatest(deepest), greatest(left));
        if let Some(slot) = self.highest.get_mut(block) {
            *slot = left;
        }
        if deepest > 0.0 {
            tally.height += gone.iter().sum::<f64>();
            tally.deepest = tally.deepest.max(deepest);
            for (top, gone) in tops.iter().zip(&gone) {
                if *gone > 0.0 {
                    tally.highest = tally.highest.max(top + gone);
                }
            }
            if deepest > SLIVER {
                let first = gone.iter().position(|gone| *gone > SLIVER).unwrap_or(0);
                let last = gone.iter().rposition(|gone| *gone > SLIVER).unwrap_or(0);
                cut(begin + first, begin + last, tally);
            }
        }
    }

    /// The same where a height may lie below the bottom of a stretch.
    fn lower_through(
        &mut self,
        block: usize,
        heights: &[f64; BLOCK],
        tally: &mut Tally,
        mut cut: impl FnMut(usize, usize, &mut Tally),
    ) {
        let begin = block * BLOCK;
        let (mut first, mut last) = (usize::MAX, 0);
        for (offset, height) in heights.iter().enumerate() {
            let column = begin + offset;
            let (top, bottom) = (self.top(column), self.bottom.get(column).copied().unwrap_or(f64::INFINITY));
            if top <= *height {
                continue;
            }
            if *height > bottom + SLIVER && *height < f64::INFINITY {
                tally.count(*height, top);
                if let Some(slot) = self.top.get_mut(column) {
                    *slot = *height;
                }
            } else {
                self.take(column, *height, f64::INFINITY, tally);
            }
            if top - height > SLIVER {
                (first, last) = (first.min(column), last.max(column));
            }
        }
        self.renew(block);
        if first <= last {
            cut(first, last, tally);
        }
    }

    /// Takes a stretch away from a column. Whether anything was there.
    pub(super) fn take(&mut self, column: usize, low: f64, high: f64, tally: &mut Tally) -> bool {
        if low >= self.top(column) || low >= high {
            return false;
        }
        let before = self.column(column);
        let mut after = Vec::with_capacity(before.len() + 1);
        let (mut gone, mut top) = (0.0, f64::NEG_INFINITY);
        for [from, to] in before {
            let (a, b) = (from.max(low), to.min(high));
            if b <= a {
                after.push([from, to]);
                continue;
            }
            gone += b - a;
            top = b;
            after.extend([[from, a], [b, to]].into_iter().filter(|[from, to]| to - from > SLIVER));
        }
        if gone == 0.0 {
            return false;
        }
        tally.height += gone;
        tally.deepest = tally.deepest.max(gone);
        tally.highest = tally.highest.max(top);
        self.put(column, after);
        gone > SLIVER
    }

    /// After columns of a block were changed one by one.
    pub(super) fn settle(&mut self, block: usize) {
        self.renew(block);
    }
}
