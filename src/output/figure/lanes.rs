//! Dimension lines beside a drawing: each gets a lane, the short ones next to the drawing.
//!
//! Invariant: in a lane nothing overlaps, labels included.

/// A dimension line beside the drawing: where it begins and ends along its lane, and how much room it takes there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bar {
    /// The two ends, in pixels along the lane, lesser first.
    pub(super) ends: [f64; 2],
    /// The length that its label takes along the lane.
    pub(super) label: f64,
    /// The side that is nearer: 0 before the drawing (left, above), 1 after it.
    pub(super) near: usize,
    /// How far the sheet reaches along the lane.
    pub(super) edges: [f64; 2],
}

/// The lane of a bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Lane {
    /// 0 before the drawing, 1 after it.
    pub(super) side: usize,
    /// Its place from the drawing outwards.
    pub(super) index: usize,
}

/// The room between the label and the arrowheads on its line.
const GAP: f64 = 18.0;

impl Bar {
    /// Whether the label fits between the ends.
    pub(super) fn fits(&self) -> bool {
        self.ends[1] - self.ends[0] >= self.label + GAP
    }

    /// Whether the label of a short bar is beyond the greater end: the sheet ends before the lesser one.
    fn is_beyond(&self) -> bool {
        self.ends[0] - GAP / 2.0 - 3.0 - self.label < self.edges[0]
    }

    /// Where its label has its middle: on the line or, if the line is short, beyond an end.
    pub(super) fn middle(&self) -> f64 {
        let off = GAP / 2.0 + 2.0 + self.label / 2.0;
        match (self.fits(), self.is_beyond()) {
            (true, _) => (self.ends[0] + self.ends[1]) / 2.0,
            (false, false) => self.ends[0] - off,
            (false, true) => self.ends[1] + off,
        }
    }

    /// What it takes of its lane.
    pub(super) fn room(&self) -> [f64; 2] {
        let (near, far) = (GAP / 2.0 + 2.0, GAP / 2.0 + 3.0 + self.label);
        match (self.fits(), self.is_beyond()) {
            (true, _) => [self.ends[0] - 1.0, self.ends[1] + 1.0],
            (false, false) => [self.ends[0] - far, self.ends[1] + near],
            (false, true) => [self.ends[0] - near, self.ends[1] + far],
        }
    }
}

/// Gives every bar a lane; also how many lanes there are on each side.
pub(super) fn lanes(bars: &[Bar]) -> (Vec<Lane>, [usize; 2]) {
    let mut order: Vec<usize> = (0..bars.len()).collect();
    let length = |n: &usize| bars.get(*n).map_or(0.0, |bar| bar.ends[1] - bar.ends[0]);
    order.sort_by(|a, b| length(a).total_cmp(&length(b)).then(a.cmp(b)));
    let mut taken: Vec<(Lane, [f64; 2])> = Vec::new();
    let mut found: Vec<Lane> = bars.iter().map(|bar| Lane { side: bar.near, index: 0 }).collect();
    let mut counts = [0, 0];
    for n in order {
        let Some(bar) = bars.get(n) else { continue };
        let room = bar.room();
        let is_free =
            |lane: Lane| taken.iter().all(|(other, own)| *other != lane || own[1] <= room[0] || room[1] <= own[0]);
        let mut all = (0..bars.len()).flat_map(|index| [bar.near, 1 - bar.near].map(|side| Lane { side, index }));
        let Some(lane) = all.find(|lane| is_free(*lane)) else { continue };
        counts[lane.side] = counts[lane.side].max(lane.index + 1);
        taken.push((lane, room));
        found[n] = lane;
    }
    (found, counts)
}
