//! Columns in blocks: how many are cut together, and what a move does to them.
/// Columns that are cut together; the highest top of each such block is known.
pub(super) const BLOCK: usize = 16;
/// Numbers that are worked on side by side.
pub(super) const WIDE: usize = 4;
/// Columns of a block over which a standing ball is examined at once.
pub(super) const PART: usize = BLOCK / 4;
/// Material thinner than this, mm, does not exist.
pub(super) const SLIVER: f64 = 1e-6;

/// The numbers of the columns of a block.
pub(super) const OFFSETS: [f64; BLOCK] =
    [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0];

/// The larger of two numbers, without a case for what is none.
#[inline(always)]
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// The smaller of two numbers, without a case for what is none.
#[inline(always)]
pub(super) fn smaller(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

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
