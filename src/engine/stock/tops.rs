//! The tops of the columns of one block, and what is taken away from them.
//!
//! The columns of a block that all end at the same height, as on a plane face, are one number: cutting them again is
//! one subtraction. Loops run over all columns of a block, several side by side.
use std::ops::Range;

use super::columns::{BLOCK, OFFSETS, PART, SLIVER, Tally, WIDE, larger};
use super::sweep::HAIR;

/// The greatest of numbers that were found side by side.
#[inline(always)]
fn greatest([a, b, c, d]: [f64; WIDE]) -> f64 {
    larger(larger(a, b), larger(c, d))
}

/// The greatest of the numbers of a part of a block.
#[inline(always)]
pub(super) fn greatest_of(numbers: &[f64; PART]) -> f64 {
    greatest(*numbers)
}

/// What columns of a row lose, without where.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sum {
    pub height: f64,
    pub deepest: f64,
    pub highest: f64,
}

impl Sum {
    pub(super) const NONE: Self = Self { height: 0.0, deepest: 0.0, highest: f64::NEG_INFINITY };

    #[inline(always)]
    pub(super) fn into(self, tally: &mut Tally) {
        tally.height += self.height;
        tally.deepest = larger(tally.deepest, self.deepest);
        tally.highest = larger(tally.highest, self.highest);
    }
}

/// The tops of one block.
#[derive(Clone, Debug)]
pub(super) struct Tops {
    /// What is highest.
    pub highest: f64,
    /// Whether all columns end there; `each` is out of date then.
    pub level: bool,
    pub each: [f64; BLOCK],
}

impl Tops {
    /// The tops one by one.
    pub(super) fn apart(&mut self) -> &mut [f64; BLOCK] {
        if self.level {
            self.level = false;
            self.each = [self.highest; BLOCK];
        }
        &mut self.each
    }

    /// Takes everything above the heights away; `begin` is the number of the first column.
    pub(super) fn lower(
        &mut self,
        begin: usize,
        columns: Range<usize>,
        heights: &[f64; BLOCK],
        tally: &mut Tally,
        cut: &mut impl FnMut(usize, usize),
    ) {
        let chunks = columns.start / WIDE..columns.end.div_ceil(WIDE);
        let highest = self.highest;
        let tops = self.apart().as_chunks_mut::<WIDE>().0;
        // Four sums side by side, so that nothing waits for the one before it.
        let (mut deepest, mut sum) = ([0.0_f64; WIDE], [0.0_f64; WIDE]);
        let mut gone = [0.0_f64; BLOCK];
        let lost = gone.as_chunks_mut::<WIDE>().0.get_mut(chunks.clone());
        let (Some(tops), Some(heights), Some(lost)) =
            (tops.get_mut(chunks.clone()), heights.as_chunks::<WIDE>().0.get(chunks), lost)
        else {
            return;
        };
        for ((tops, heights), lost) in tops.iter_mut().zip(heights).zip(lost) {
            for n in 0..WIDE {
                let (top, height) = (tops[n], heights[n]);
                let after = if height < top { height } else { top };
                // An empty column and a place without a tool give no number here, which is not greater than zero.
                let loss = top - after;
                let loss = if loss > 0.0 { loss } else { 0.0 };
                lost[n] = loss;
                sum[n] += loss;
                deepest[n] = if loss > deepest[n] { loss } else { deepest[n] };
                tops[n] = after;
            }
        }
        let deepest = greatest(deepest);
        if deepest <= 0.0 {
            return;
        }
        tally.height += sum.iter().sum::<f64>();
        tally.deepest = tally.deepest.max(deepest);
        if tally.highest < highest {
            tally.highest = larger(tally.highest, self.were(&gone));
        }
        self.renew();
        if deepest > SLIVER {
            let first = gone.iter().position(|gone| *gone > SLIVER).unwrap_or(0);
            let last = gone.iter().rposition(|gone| *gone > SLIVER).unwrap_or(0);
            cut(begin + first, begin + last);
        }
    }

    /// Takes everything above the heights away, of which those of columns that stay are infinite;
    /// `begin` is the number of the first column.
    #[inline(always)]
    pub(super) fn bring_down(
        &mut self,
        begin: usize,
        heights: &[f64; BLOCK],
        sum: &mut Sum,
        cut: &mut impl FnMut(usize, usize),
    ) {
        let highest = self.highest;
        let tops = self.apart();
        let mut lost = [0.0; BLOCK];
        let (mut all, mut deepest) = ([0.0; WIDE], [0.0; WIDE]);
        {
            let ((tops, _), (heights, _), (lost, _)) =
                (tops.as_chunks_mut(), heights.as_chunks(), lost.as_chunks_mut());
            for ((tops, heights), lost) in tops.iter_mut().zip(heights).zip(lost) {
                let (tops, heights, lost): (&mut [f64; WIDE], &[f64; WIDE], &mut [f64; WIDE]) = (tops, heights, lost);
                for n in 0..WIDE {
                    let (top, height) = (tops[n], heights[n]);
                    let after = if height < top { height } else { top };
                    // An empty column gives no number here, which is not greater than zero.
                    let loss = top - after;
                    let loss = if loss > 0.0 { loss } else { 0.0 };
                    tops[n] = after;
                    lost[n] = loss;
                    all[n] += loss;
                    deepest[n] = if loss > deepest[n] { loss } else { deepest[n] };
                }
            }
        }
        sum.height += all.iter().sum::<f64>();
        sum.deepest = larger(sum.deepest, greatest(deepest));
        if sum.highest < highest {
            sum.highest = larger(sum.highest, self.were(&lost));
        }
        self.renew();
        if let Some(first) = lost.iter().position(|lost| *lost > SLIVER) {
            let last = lost.iter().rposition(|lost| *lost > SLIVER).unwrap_or(first);
            cut(begin + first, begin + last);
        }
    }

    /// Takes a block down to a height that is lower than the highest of its tops;
    /// `begin` is the number of the first column.
    #[inline(always)]
    pub(super) fn level_down(&mut self, begin: usize, height: f64, sum: &mut Sum, cut: &mut impl FnMut(usize, usize)) {
        if !self.level {
            let whole = self.reaches(height);
            self.bring_down(begin, &[height; BLOCK], sum, cut);
            self.level = whole;
            return;
        }
        let loss = self.highest - height;
        sum.height += loss * BLOCK as f64;
        sum.deepest = larger(sum.deepest, loss);
        sum.highest = larger(sum.highest, self.highest);
        self.highest = height;
        if loss > SLIVER {
            cut(begin, begin + BLOCK - 1);
        }
    }

    /// Whether one of the columns ends above its height.
    #[inline(always)]
    pub(super) fn is_above(&self, heights: &[f64; BLOCK]) -> bool {
        let mut above = [false; WIDE];
        for (tops, heights) in self.each.as_chunks::<WIDE>().0.iter().zip(heights.as_chunks::<WIDE>().0) {
            for n in 0..WIDE {
                above[n] |= tops[n] > heights[n];
            }
        }
        self.level || above.contains(&true)
    }

    /// Takes away what lies above the lower sides of balls over a part of the block: `balls` gives the square of half
    /// the height of the ball over a column, and the height of its middle. What the columns lose, if any of them does;
    /// that is examined first unless it is `likely`. The block has to be [renewed](Self::renew) then.
    #[inline(always)]
    pub(super) fn under(
        &mut self,
        part: usize,
        balls: impl Fn(f64) -> [f64; 2],
        likely: bool,
        sum: &mut Sum,
    ) -> Option<[f64; PART]> {
        if !likely {
            let level = [self.highest; PART];
            let tops = if self.level { &level } else { self.each.as_chunks::<PART>().0.get(part)? };
            // Whether a column ends above the lower side of its ball is known from squares, without a root.
            let mut over = [f64::NEG_INFINITY; WIDE];
            for (tops, offsets) in tops.as_chunks::<WIDE>().0.iter().zip(OFFSETS.as_chunks::<WIDE>().0) {
                for n in 0..WIDE {
                    let [rest, middle] = balls(offsets[n]);
                    let up = middle - tops[n];
                    let up = if up > 0.0 { up } else { 0.0 };
                    let more = rest - up * up;
                    over[n] = if more > over[n] { more } else { over[n] };
                }
            }
            if greatest(over) < 0.0 {
                return None;
            }
        }
        let highest = self.highest;
        let tops = self.apart().as_chunks_mut::<PART>().0.get_mut(part)?;
        let (mut lost, mut deepest, mut all) = ([0.0; PART], [0.0; WIDE], [0.0; WIDE]);
        {
            let ((tops, _), (lost, _), (offsets, _)) =
                (tops.as_chunks_mut(), lost.as_chunks_mut(), OFFSETS.as_chunks());
            for ((tops, lost), offsets) in tops.iter_mut().zip(lost).zip(offsets) {
                let (tops, lost, offsets): (&mut [f64; WIDE], &mut [f64; WIDE], &[f64; WIDE]) = (tops, lost, offsets);
                for n in 0..WIDE {
                    let [rest, middle] = balls(offsets[n]);
                    // Where there is no ball, and in an empty column, there is no number, which is in no order.
                    let low = middle - rest.sqrt();
                    let after = if low < tops[n] { low } else { tops[n] };
                    let loss = tops[n] - after;
                    let loss = if loss > 0.0 { loss } else { 0.0 };
                    tops[n] = after;
                    lost[n] = loss;
                    all[n] += loss;
                    deepest[n] = if loss > deepest[n] { loss } else { deepest[n] };
                }
            }
        }
        let deepest = greatest(deepest);
        if deepest <= 0.0 {
            return None;
        }
        sum.height += all.iter().sum::<f64>();
        sum.deepest = larger(sum.deepest, deepest);
        if sum.highest < highest {
            // What rounding takes has not been there.
            let mut high = [f64::NEG_INFINITY; WIDE];
            for (tops, lost) in tops.as_chunks::<WIDE>().0.iter().zip(lost.as_chunks::<WIDE>().0) {
                for n in 0..WIDE {
                    let was = if lost[n] > HAIR { tops[n] + lost[n] } else { f64::NEG_INFINITY };
                    high[n] = if was > high[n] { was } else { high[n] };
                }
            }
            sum.highest = larger(sum.highest, greatest(high));
        }
        Some(lost)
    }

    /// Where the highest of the columns that have lost something ended before.
    #[inline(always)]
    fn were(&self, lost: &[f64; BLOCK]) -> f64 {
        let mut high = [f64::NEG_INFINITY; WIDE];
        for (tops, lost) in self.each.as_chunks::<WIDE>().0.iter().zip(lost.as_chunks::<WIDE>().0) {
            for n in 0..WIDE {
                let was = if lost[n] > 0.0 { tops[n] + lost[n] } else { f64::NEG_INFINITY };
                high[n] = if was > high[n] { was } else { high[n] };
            }
        }
        greatest(high)
    }

    /// After tops were changed.
    pub(super) fn renew(&mut self) {
        let mut high = [f64::NEG_INFINITY; WIDE];
        for tops in self.each.as_chunks::<WIDE>().0 {
            for (high, top) in high.iter_mut().zip(tops) {
                *high = if *top > *high { *top } else { *high };
            }
        }
        self.highest = greatest(high);
    }

    /// Whether nothing is lower than a height.
    pub(super) fn reaches(&self, height: f64) -> bool {
        let mut reaches = true;
        for top in &self.each {
            reaches &= *top >= height;
        }
        reaches
    }
}
