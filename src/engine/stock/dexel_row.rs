//! Rows of columns: the material along parallel lines, and what is taken away from it.
//!
//! A column has its topmost stretch of material in two arrays, by blocks (see `tops`), and stretches below it, which
//! few columns have, in a map. Invariant: stretches of a column do not overlap and are from low to high; an empty
//! column has the top minus infinity. What a column holds does not grow with the number of cuts: stretches thinner than
//! [`SLIVER`] are dropped, so their number is bounded by the height of the blank.
use std::collections::BTreeMap;
use std::ops::Range;

use super::bed::Bed;
use super::columns::{BLOCK, OFFSETS, PART, SLIVER, Tally, larger};
use super::tops::{Sum, Tops, greatest_of};

/// Nothing, then everything, then nothing.
const WINDOW: [f64; 3 * BLOCK] = {
    let mut window = [f64::INFINITY; 3 * BLOCK];
    let mut n = BLOCK;
    while n < 2 * BLOCK {
        window[n] = f64::NEG_INFINITY;
        n += 1;
    }
    window
};

/// A height for some columns of a block, and infinity for the others.
#[inline(always)]
fn only(columns: &Range<usize>, height: f64) -> [f64; BLOCK] {
    let mut heights = [height; BLOCK];
    let before = WINDOW.get(BLOCK - columns.start..).and_then(|window| window.first_chunk::<BLOCK>());
    let after = WINDOW.get(2 * BLOCK - columns.end..).and_then(|window| window.first_chunk::<BLOCK>());
    if let (Some(before), Some(after)) = (before, after) {
        for n in 0..BLOCK {
            heights[n] = larger(heights[n], larger(before[n], after[n]));
        }
    }
    heights
}

/// A row of columns.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub tops: Vec<Tops>,
    /// What a flat tool has below it on its way down.
    pub bed: Option<Bed>,
    bottom: Vec<f64>,
    /// Stretches below the topmost one, by column.
    below: BTreeMap<usize, Vec<[f64; 2]>>,
    /// No topmost stretch begins above this.
    floor: f64,
}

impl Row {
    /// A row of that many columns with the stretches that `material` gives, from low to high.
    pub(super) fn new(count: usize, mut material: impl FnMut(usize) -> Vec<[f64; 2]>) -> Self {
        let length = count.div_ceil(BLOCK) * BLOCK;
        let empty = Tops { highest: f64::NEG_INFINITY, level: false, each: [f64::NEG_INFINITY; BLOCK] };
        let mut row = Self {
            tops: vec![empty; length / BLOCK],
            bed: None,
            bottom: vec![f64::INFINITY; length],
            below: BTreeMap::new(),
            floor: f64::NEG_INFINITY,
        };
        for column in 0..count {
            row.put(column, material(column));
        }
        for tops in &mut row.tops {
            tops.renew();
            tops.level = tops.reaches(tops.highest);
        }
        row
    }

    fn put(&mut self, column: usize, mut stretches: Vec<[f64; 2]>) {
        stretches.retain(|[low, high]| high - low > SLIVER);
        let [low, high] = stretches.pop().unwrap_or([f64::INFINITY, f64::NEG_INFINITY]);
        if let (Some(tops), Some(bottom)) = (self.tops.get_mut(column / BLOCK), self.bottom.get_mut(column)) {
            tops.apart()[column % BLOCK] = high;
            *bottom = low;
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
        let top = self.top(column);
        if let Some(bottom) = self.bottom.get(column)
            && top > *bottom
        {
            stretches.push([*bottom, top]);
        }
        stretches
    }

    /// The top of a column; minus infinity if it is empty.
    pub(super) fn top(&self, column: usize) -> f64 {
        let Some(tops) = self.tops.get(column / BLOCK) else { return f64::NEG_INFINITY };
        if tops.level { tops.highest } else { tops.each[column % BLOCK] }
    }

    /// The highest top of a block.
    pub(super) fn highest(&self, block: usize) -> f64 {
        self.tops.get(block).map_or(f64::NEG_INFINITY, |tops| tops.highest)
    }

    /// Whether some of these columns of a block end above a straight line, given by its height over the first column of
    /// the block and what it rises from one to the next.
    pub(super) fn is_above(&self, block: usize, columns: Range<usize>, height: f64, rise: f64) -> bool {
        let Some(tops) = self.tops.get(block) else { return false };
        if tops.level {
            let (a, b) = (columns.start as f64, columns.end as f64 - 1.0);
            return tops.highest > height + (rise * a).min(rise * b);
        }
        let tops = tops.each.get(columns.clone()).unwrap_or(&[]);
        let mut above = false;
        for (top, n) in tops.iter().zip(OFFSETS.get(columns).unwrap_or(&[])) {
            above |= *top > height + rise * n;
        }
        above
    }

    /// Takes everything above a height away from columns. Calls `cut` with the first and the last
    /// column that lose something.
    pub(super) fn level(
        &mut self,
        (first, last): (usize, usize),
        height: f64,
        tally: &mut Tally,
        mut cut: impl FnMut(usize, usize),
    ) {
        if height <= self.floor {
            return self.level_through((first, last), height, tally, &mut cut);
        }
        let mut ends: Option<(usize, usize)> = None;
        let mut sum = Sum::NONE;
        let mut lost = |from: usize, to: usize| ends = Some((ends.map_or(from, |(first, _)| first), to));
        let start = first / BLOCK;
        let blocks = self.tops.get_mut(start..last / BLOCK + 1).unwrap_or_default();
        for (n, tops) in blocks.iter_mut().enumerate() {
            if tops.highest <= height {
                continue;
            }
            let begin = (start + n) * BLOCK;
            let columns = first.saturating_sub(begin)..(last + 1 - begin).min(BLOCK);
            if columns.len() == BLOCK {
                tops.level_down(begin, height, &mut sum, &mut lost);
            } else if tops.level {
                let loss = tops.highest - height;
                tally.height += loss * columns.len() as f64;
                tally.deepest = larger(tally.deepest, loss);
                tally.highest = larger(tally.highest, tops.highest);
                if loss > SLIVER {
                    lost(begin + columns.start, begin + columns.end - 1);
                }
                tops.apart().get_mut(columns).unwrap_or_default().fill(height);
            } else {
                let (mut low, mut high) = (usize::MAX, 0);
                let (mut sum, mut deepest, mut highest) = (0.0, 0.0, f64::NEG_INFINITY);
                for (n, top) in columns.clone().zip(tops.each.get_mut(columns).unwrap_or_default()) {
                    let loss = *top - height;
                    if loss > 0.0 {
                        sum += loss;
                        deepest = larger(deepest, loss);
                        highest = larger(highest, *top);
                        *top = height;
                        if loss > SLIVER {
                            (low, high) = (low.min(n), n);
                        }
                    }
                }
                if deepest > 0.0 {
                    tally.height += sum;
                    tally.deepest = larger(tally.deepest, deepest);
                    tally.highest = larger(tally.highest, highest);
                    tops.renew();
                }
                if low <= high {
                    lost(begin + low, begin + high);
                }
            }
        }
        sum.into(tally);
        if let Some((first, last)) = ends {
            cut(first, last);
        }
    }

    /// Takes columns down whose topmost stretches begin lower: some of them to a height, the others to heights of their
    /// own that `heights` gives for a block with a given first column, none of which is lower. Calls `cut` with the
    /// first and the last column of each run that loses something.
    #[inline(always)]
    pub(super) fn sink(
        &mut self,
        (first, last): (usize, usize),
        (from, to): (usize, usize),
        height: f64,
        heights: impl Fn(usize, Range<usize>, &mut [f64; BLOCK]),
        tally: &mut Tally,
        cut: &mut impl FnMut(usize, usize),
    ) {
        let mut run: Option<(usize, usize)> = None;
        let mut lost = |first: usize, last: usize| match &mut run {
            Some((_, end)) if *end + 1 == first => *end = last,
            _ => {
                if let Some((first, last)) = run.replace((first, last)) {
                    cut(first, last);
                }
            }
        };
        let mut sum = Sum::NONE;
        let start = first / BLOCK;
        let blocks = self.tops.get_mut(start..last / BLOCK + 1).unwrap_or_default();
        for (n, tops) in blocks.iter_mut().enumerate() {
            if tops.highest <= height {
                continue;
            }
            let begin = (start + n) * BLOCK;
            if from <= begin && begin + BLOCK <= to + 1 {
                tops.level_down(begin, height, &mut sum, &mut lost);
                continue;
            }
            let columns = first.saturating_sub(begin)..(last + 1 - begin).min(BLOCK);
            let mut low = only(&columns, height);
            if !tops.is_above(&low) {
                continue;
            }
            let left = columns.start..from.saturating_sub(begin).min(columns.end);
            let right = (to + 1).saturating_sub(begin).max(columns.start)..columns.end;
            for part in [left, right] {
                if part.start < part.end {
                    heights(begin, part, &mut low);
                }
            }
            tops.bring_down(begin, &low, &mut sum, &mut lost);
        }
        sum.into(tally);
        if let Some((first, last)) = run {
            cut(first, last);
        }
    }

    /// The same where the height may lie below the bottom of a stretch.
    fn level_through(
        &mut self,
        (first, last): (usize, usize),
        height: f64,
        tally: &mut Tally,
        cut: &mut impl FnMut(usize, usize),
    ) {
        for block in first / BLOCK..=last / BLOCK {
            let begin = block * BLOCK;
            if self.highest(block) > height {
                let columns = first.saturating_sub(begin)..(last + 1 - begin).min(BLOCK);
                self.lower_through(block, columns, &[height; BLOCK], tally, cut);
            }
        }
    }

    /// Takes away what lies above the lower sides of balls over columns, and of others next to them: `balls` gives the
    /// square of half the height of the ball over a column, and the height of its middle. Nothing is lower than the
    /// first height
    /// `low`, no middle lower than the second, and between two columns no square greater than `most` says. The first
    /// and the last column that lose something.
    #[inline(always)]
    pub(super) fn balls(
        &mut self,
        (first, last): (usize, usize),
        [low, middle]: [f64; 2],
        balls: impl Fn(f64) -> [f64; 2],
        most: impl Fn(f64, f64) -> f64,
        tally: &mut Tally,
    ) -> Option<(usize, usize)> {
        let mut ends: Option<(usize, usize)> = None;
        let mut latest = [0.0; PART];
        let (mut sum, mut likely) = (Sum::NONE, false);
        let start = first / BLOCK;
        let blocks = self.tops.get_mut(start..last / BLOCK + 1).unwrap_or_default();
        for (n, tops) in blocks.iter_mut().enumerate() {
            let up = larger(middle - tops.highest, 0.0);
            let block = (start + n) * BLOCK;
            let (from, to) = (first.max(block) / PART, last.min(block + BLOCK - 1) / PART);
            let reached = |from: usize, to: usize| up * up <= most((from * PART) as f64, (to * PART + PART - 1) as f64);
            if tops.highest <= low || !reached(from, to) {
                likely = false;
                continue;
            }
            let mut changed = false;
            for part in from..=to {
                if from < to && !reached(part, part) {
                    likely = false;
                    continue;
                }
                let begin = part * PART;
                let at = begin as f64;
                // Where a column has lost something, the next one does as well.
                let lost = tops.under(part % (BLOCK / PART), |n| balls(at + n), likely, &mut sum);
                likely = lost.is_some();
                let Some(lost) = lost else { continue };
                changed = true;
                if let Some((_, last)) = &mut ends {
                    if greatest_of(&lost) > SLIVER {
                        (*last, latest) = (begin, lost);
                    }
                } else if let Some(first) = lost.iter().position(|lost| *lost > SLIVER) {
                    (ends, latest) = (Some((begin + first, begin)), lost);
                }
            }
            if changed {
                tops.renew();
            }
        }
        sum.into(tally);
        let (first, last) = ends?;
        Some((first, last + latest.iter().rposition(|lost| *lost > SLIVER).unwrap_or(0)))
    }

    /// Whether heights from that one on lie within the topmost stretches of all columns.
    pub(super) fn is_above_floor(&self, height: f64) -> bool {
        height > self.floor
    }

    /// Takes everything above the heights away from columns of a block; infinity leaves a column alone. Nothing may be
    /// lower than `least`. Calls `cut` with the first and the last column of the block that lose something.
    pub(super) fn lower(
        &mut self,
        block: usize,
        columns: Range<usize>,
        heights: &[f64; BLOCK],
        least: f64,
        tally: &mut Tally,
        mut cut: impl FnMut(usize, usize),
    ) {
        if least <= self.floor {
            self.lower_through(block, columns, heights, tally, &mut cut);
        } else if let Some(tops) = self.tops.get_mut(block) {
            tops.lower(block * BLOCK, columns, heights, tally, &mut cut);
        }
    }

    /// The same where a height may lie below the bottom of a stretch.
    fn lower_through(
        &mut self,
        block: usize,
        columns: Range<usize>,
        heights: &[f64; BLOCK],
        tally: &mut Tally,
        cut: &mut impl FnMut(usize, usize),
    ) {
        let begin = block * BLOCK;
        let (mut first, mut last) = (usize::MAX, 0);
        for (offset, height) in columns.clone().zip(heights.get(columns).unwrap_or(&[])) {
            let column = begin + offset;
            let (top, bottom) = (self.top(column), self.bottom.get(column).copied().unwrap_or(f64::INFINITY));
            if top <= *height {
                continue;
            }
            if *height > bottom + SLIVER && *height < f64::INFINITY {
                tally.count(*height, top);
                if let Some(tops) = self.tops.get_mut(block) {
                    tops.apart()[offset] = *height;
                }
            } else {
                self.take(column, *height, f64::INFINITY, tally);
            }
            if top - height > SLIVER {
                (first, last) = (first.min(column), last.max(column));
            }
        }
        self.settle(block);
        if first <= last {
            cut(first, last);
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
        if let Some(tops) = self.tops.get_mut(block).filter(|tops| !tops.level) {
            tops.renew();
        }
    }
}
