//! The nearest point of many boundaries, and what lies in a straight way, by an index of boxes.
//!
//! Invariant: the answers are those that a look at every segment would give; of points that are equally near, but for
//! rounding, the one farthest to the left, then the lowest.
use std::ops::Range;

use cavalier_contours::polyline::{
    PlineSegIntr, PlineSource, PlineVertex, Polyline, pline_seg_intr, seg_closest_point, seg_fast_approx_bounding_box,
};
use cavalier_contours::static_aabb2d_index::{Control, StaticAABB2DIndex, StaticAABB2DIndexBuilder};
use glam::DVec2;

use super::boundary::{EQUAL, earliest, point, vector};
use super::{NEAR, Region};

/// So many segments of a line that follow each other have one box: a line that is passed over is passed over in a few
/// boxes, however short its segments are.
const RUN: usize = 16;

/// An index of closed lines, which are counted from 0.
pub struct Nearest {
    segments: Vec<(PlineVertex, PlineVertex, usize)>,
    /// The number of the line and the segments of each box.
    runs: Vec<(usize, Range<usize>)>,
    /// Nothing where there are no segments.
    index: Option<StaticAABB2DIndex<f64>>,
}

/// A straight way from line to line where nothing is between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bridge {
    /// The numbers of the lines.
    pub(super) lines: [usize; 2],
    /// Where it begins on the one, and ends on the other.
    pub(super) ends: [DVec2; 2],
}

impl Bridge {
    fn length(&self) -> f64 {
        self.ends[0].distance(self.ends[1])
    }

    /// The same from the other end.
    pub(super) fn back(&self) -> Self {
        let ([a, b], [p, q]) = (self.lines, self.ends);
        Self { lines: [b, a], ends: [q, p] }
    }
}

impl Nearest {
    /// Of the boundaries of a region in their order.
    pub fn of(region: &Region) -> Self {
        Self::of_lines(region.parts.iter().flat_map(|part| std::iter::once(&part.outer).chain(&part.holes)))
    }

    fn of_lines<'a>(lines: impl Iterator<Item = &'a Polyline>) -> Self {
        let mut segments = Vec::new();
        let mut runs = Vec::new();
        for (number, line) in lines.enumerate() {
            let begin = segments.len();
            segments.extend(line.iter_segments().map(|(from, to)| (from, to, number)));
            let end = segments.len();
            runs.extend((begin..end).step_by(RUN).map(|from| (number, from..(from + RUN).min(end))));
        }
        let mut boxes = StaticAABB2DIndexBuilder::new(runs.len());
        for (_, run) in &runs {
            let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            for (from, to, _) in &segments[run.clone()] {
                let own = seg_fast_approx_bounding_box(*from, *to);
                low = low.min(DVec2::new(own.min_x, own.min_y));
                high = high.max(DVec2::new(own.max_x, own.max_y));
            }
            boxes.add(low.x, low.y, high.x, high.y);
        }
        let index = boxes.build().ok().filter(|_| !runs.is_empty());
        Self { segments, runs, index }
    }

    /// The segments of a box.
    fn run(&self, number: usize) -> impl Iterator<Item = &(PlineVertex, PlineVertex, usize)> {
        let run = self.runs.get(number).map_or(0..0, |(_, run)| run.clone());
        self.segments.get(run).into_iter().flatten()
    }

    /// The point that is nearest to a point, with its distance.
    pub fn nearest(&self, to: DVec2) -> Option<(DVec2, f64)> {
        let (near, _) = self.nearest_among(to, f64::INFINITY, &|_| true)?;
        Some((near, near.distance(to)))
    }

    /// The same on some of the lines and no farther than a limit in mm, with the number of the line.
    pub(super) fn nearest_among(
        &self,
        to: DVec2,
        limit: f64,
        wanted: &dyn Fn(usize) -> bool,
    ) -> Option<(DVec2, usize)> {
        let index = self.index.as_ref()?;
        let (mut least, mut found) = (limit, Vec::<(DVec2, usize)>::new());
        let mut visit = |number: usize, square: f64| {
            if libm::sqrt(square) > least + 2.0 * EQUAL {
                return Control::Break(());
            }
            if !self.runs.get(number).is_some_and(|(line, _)| wanted(*line)) {
                return Control::Continue;
            }
            for (from, end, line) in self.run(number) {
                let near = point(seg_closest_point(*from, *end, vector(to), NEAR));
                if near.distance(to) <= least + EQUAL {
                    least = least.min(near.distance(to));
                    found.push((near, *line));
                }
            }
            Control::Continue
        };
        let _: Control<()> = index.visit_neighbors(to.x, to.y, &mut visit);
        let near = found.into_iter().filter(|(near, _)| near.distance(to) <= least + EQUAL);
        near.reduce(|one, other| if earliest(one.0, other.0) == one.0 { one } else { other })
    }

    /// The bridges that join all lines: the shortest ones that do.
    pub(super) fn bridges(&self, lines: usize) -> Vec<Bridge> {
        let mut group: Vec<usize> = (0..lines).collect();
        let mut bridges = Vec::with_capacity(lines);
        loop {
            // The shortest way out of each group of lines that are joined already, but for the largest one: the others come
            // to it, and from its many segments all of its own that are near would be passed over.
            let mut best: Vec<Option<Bridge>> = vec![None; lines];
            let mut sizes = vec![0; lines];
            for (line, run) in &self.runs {
                sizes[group[*line]] += run.len();
            }
            let largest = (0..lines).max_by_key(|own| sizes[*own]);
            for (line, run) in &self.runs {
                let own = group[*line];
                if Some(own) == largest {
                    continue;
                }
                let limit = |best: &[Option<Bridge>]| best[own].map_or(f64::INFINITY, |best| best.length() - EQUAL);
                let others = |line: usize| group[line] != own;
                if self.is_far(run, limit(&best), &others) {
                    continue;
                }
                for (from, _, line) in self.segments.get(run.clone()).into_iter().flatten() {
                    let (limit, at) = (limit(&best), point(from.pos()));
                    let Some((near, other)) = self.nearest_among(at, limit, &others) else { continue };
                    let bridge = self.shortest(Bridge { lines: [*line, other], ends: [at, near] }, &group);
                    if bridge.length() < limit {
                        best[own] = Some(bridge);
                    }
                }
            }
            let before = bridges.len();
            for bridge in best.into_iter().flatten() {
                let [a, b] = bridge.lines.map(|line| group[line]);
                if a != b {
                    group.iter_mut().filter(|own| **own == b).for_each(|own| *own = a);
                    bridges.push(bridge);
                }
            }
            if bridges.len() == before {
                return bridges;
            }
        }
    }

    /// Whether none of some lines comes as near to the beginnings of these segments as the limit says.
    fn is_far(&self, run: &Range<usize>, limit: f64, wanted: &dyn Fn(usize) -> bool) -> bool {
        if limit.is_infinite() {
            return false;
        }
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for (from, _, _) in self.segments.get(run.clone()).into_iter().flatten() {
            (low, high) = (low.min(point(from.pos())), high.max(point(from.pos())));
        }
        // What is farther from the middle of their box than its corners and the limit is too far from all of them.
        let reach = low.distance(high) / 2.0;
        self.nearest_among(low.midpoint(high), limit + reach + EQUAL, wanted).is_none()
    }

    /// Step by step from one end to the other a bridge becomes one whose ends see each other.
    fn shortest(&self, mut bridge: Bridge, group: &[usize]) -> Bridge {
        let own = group[bridge.lines[0]];
        for _ in 0..8 {
            let before = bridge.length();
            let [_, to] = bridge.ends;
            let from = self.nearest_among(to, before + EQUAL, &|line| group[line] == own);
            let Some((from, line)) = from else { break };
            let to = self.nearest_among(from, before + EQUAL, &|line| group[line] != own);
            let Some((to, other)) = to else { break };
            bridge = Bridge { lines: [line, other], ends: [from, to] };
            if bridge.length() > before - NEAR {
                break;
            }
        }
        bridge
    }

    /// Whether the straight way between two points of a region of which these are the lines stays within it; it may
    /// touch them.
    pub(super) fn is_clear(&self, region: &Region, from: DVec2, to: DVec2) -> bool {
        let length = from.distance(to);
        if length <= NEAR {
            return true;
        }
        // The way is cut where it meets a boundary; each piece is inside or outside as a whole.
        let mut cuts = vec![0.0, 1.0];
        let (low, high) = (from.min(to) - NEAR, from.max(to) + NEAR);
        let way = (PlineVertex::new(from.x, from.y, 0.0), PlineVertex::new(to.x, to.y, 0.0));
        let mut visit = |number: usize| {
            let mut cut = |at| cuts.push(point(at).distance(from) / length);
            for (a, b, _) in self.run(number) {
                match pline_seg_intr(*a, *b, way.0, way.1, NEAR) {
                    PlineSegIntr::NoIntersect => {}
                    PlineSegIntr::TangentIntersect { point } | PlineSegIntr::OneIntersect { point } => cut(point),
                    PlineSegIntr::TwoIntersects { point1, point2 }
                    | PlineSegIntr::OverlappingLines { point1, point2 }
                    | PlineSegIntr::OverlappingArcs { point1, point2 } => {
                        cut(point1);
                        cut(point2);
                    }
                }
            }
        };
        if let Some(index) = &self.index {
            let () = index.visit_query(low.x, low.y, high.x, high.y, &mut visit);
        }
        cuts.sort_by(f64::total_cmp);
        cuts.windows(2).filter(|pair| (pair[1] - pair[0]) * length > 4.0 * NEAR).all(|pair| {
            let middle = from.lerp(to, (pair[0] + pair[1]) / 2.0);
            region.contains(middle) || self.nearest(middle).is_some_and(|(_, distance)| distance <= 10.0 * NEAR)
        })
    }
}
