//! Tools that are not along the columns, and ways about axes that do not: followed in steps.
//!
//! Invariant: steps are not longer than a quarter of a cell, so the error of a surface is below that; at each step
//! the stretch of a column that the tool covers is exact (round and pointed ends: to rounding).
use glam::{DVec2, DVec3};

use super::columns::{BLOCK, Tally};
use super::cutter::{Cutter, Tip};
use super::dexel_row::Row;
use super::grid::Grid;
use crate::engine::solid::Path;

/// Steps that are carried out together.
const TOGETHER: usize = 32;
/// Share of a cell that a step is long.
const STEP: f64 = 0.25;
/// Steps of a search for the greatest or the zero of a concave function.
const SEARCH: usize = 48;

/// A tool on a part of such a way, in coordinates of the grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct Oblique {
    path: Path,
    cutter: Cutter,
    /// Unit vector from the tip to the spindle.
    tool: DVec3,
    /// First step, steps in this part, steps of the whole way.
    first: usize,
    count: usize,
    steps: usize,
    min: DVec2,
    max: DVec2,
    /// The heights between which there can be material.
    low: f64,
    high: f64,
    /// A length that leads out of the blank.
    far: f64,
}

impl Oblique {
    /// The whole way; the tip is lifted along the tool.
    pub(super) fn new(path: &Path, grid: &Grid, cutter: Cutter, tool: DVec3, lift: f64, low: f64) -> Self {
        let up = tool * lift;
        let path = match *path {
            Path::Line { from, to } => Path::line(grid.point(from) + up, grid.point(to) + up),
            Path::Arc { centre, axis, from, sweep, rise } => {
                let (centre, from) = (grid.point(centre) + up, grid.point(from) + up);
                Path::Arc { centre, axis: grid.vector(axis), from, sweep, rise }
            }
        };
        let step = STEP * grid.cell.min_element();
        let steps = ((path.length() / step).ceil().max(1.0)) as usize;
        let middle = 0.5 * (grid.min + grid.max);
        let far = (grid.max - grid.min).length() + (path.at(0.0) - middle).length() + path.length() + cutter.radius;
        let mut whole = Self {
            path,
            cutter,
            tool,
            first: 0,
            count: steps + 1,
            steps,
            min: DVec2::ZERO,
            max: DVec2::ZERO,
            low,
            high: grid.max.z,
            far,
        };
        whole.bound();
        whole
    }

    /// The way in parts, each with its own rectangle.
    pub(super) fn parts(&self) -> impl Iterator<Item = Self> + use<> {
        let whole = *self;
        (0..=whole.steps).step_by(TOGETHER).map(move |first| {
            let mut part = Self { first, count: TOGETHER.min(whole.steps + 1 - first), ..whole };
            part.bound();
            part
        })
    }

    fn tip(&self, step: usize) -> DVec3 {
        self.path.at((self.first + step) as f64 / self.steps as f64)
    }

    fn bound(&mut self) {
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let away = self.tool * self.far;
        let ends = if self.count > TOGETHER { 0 } else { self.count };
        for step in 0..ends {
            let tip = self.tip(step);
            (min, max) = (min.min(tip).min(tip + away), max.max(tip).max(tip + away));
        }
        let reach = DVec2::splat(self.cutter.radius);
        (self.min, self.max) = (DVec2::new(min.x, min.y) - reach, DVec2::new(max.x, max.y) + reach);
    }

    pub(super) const fn bounds(&self) -> (DVec2, DVec2) {
        (self.min, self.max)
    }

    /// Takes what the tool covers away from a row.
    pub(super) fn cut(&self, grid: &Grid, own: &mut Row, row: usize, tally: &mut Tally) {
        let y = grid.y(row);
        let before = tally.height;
        let mut touched: Option<(usize, usize)> = None;
        for step in 0..self.count {
            let tip = self.tip(step);
            let end = tip + self.tool * self.far;
            let radius = self.cutter.radius;
            if y < tip.y.min(end.y) - radius || y > tip.y.max(end.y) + radius {
                continue;
            }
            let (from, to) = (tip.x.min(end.x) - radius, tip.x.max(end.x) + radius);
            let Some((first, last)) = Grid::between(from, to, grid.min.x, grid.each.x, grid.columns) else { continue };
            touched = touched.map_or(Some((first, last)), |(a, b)| Some((a.min(first), b.max(last))));
            for column in first..=last {
                let way = DVec3::new(grid.x(column), y, 0.0) - tip;
                for [low, high] in self.stretches(way).into_iter().flatten() {
                    own.take(column, low, high, tally);
                }
            }
        }
        if let Some((first, last)) = touched.filter(|_| tally.height > before) {
            (first / BLOCK..=last / BLOCK).for_each(|block| own.settle(block));
        }
    }

    /// What the tool covers of the column that is at `way` from its tip (at height 0).
    fn stretches(&self, way: DVec3) -> [Option<[f64; 2]>; 2] {
        let Cutter { radius, neck, .. } = self.cutter;
        match neck {
            None => [self.stretch(way, radius, true, [0.0, f64::INFINITY]), None],
            Some(neck) => [
                self.stretch(way, radius, true, [0.0, neck.head]),
                self.stretch(way, neck.radius, false, [neck.head, f64::INFINITY]),
            ],
        }
    }

    /// The same for the part of the tool between two heights; its lower end has the form of the tip or is flat.
    fn stretch(&self, way: DVec3, radius: f64, tipped: bool, [from, to]: [f64; 2]) -> Option<[f64; 2]> {
        let lean = self.tool.z;
        let height = way.dot(self.tool);
        // The square of the distance from the axis is a s² + 2 b s + c.
        let (a, b) = (1.0 - lean * lean, way.z - height * lean);
        let c = way.length_squared() - height * height;
        // The way's height counts from 0, the column's from the grid's zero.
        let (mut low, mut high) = (self.low, self.high);
        if a > 1e-14 {
            let square = b * b - a * (c - radius * radius);
            if square < 0.0 {
                return None;
            }
            let half = square.sqrt() / a;
            (low, high) = (low.max(-b / a - half), high.min(-b / a + half));
        } else if c > radius * radius {
            return None;
        }
        // Between the two heights along the tool.
        if lean.abs() > 1e-14 {
            let ends = [(from - height) / lean, (to - height) / lean];
            (low, high) = (low.max(ends[0].min(ends[1])), high.min(ends[0].max(ends[1])));
        } else if height < from || height > to {
            return None;
        }
        if low >= high {
            return None;
        }
        if !tipped || self.cutter.tip == Tip::Flat {
            return Some([low, high]);
        }
        // What is above the end is where this is not negative; it is concave along the column.
        let above = |s: f64| {
            let far = (a * s * s + 2.0 * b * s + c).max(0.0).sqrt();
            height + lean * s - self.cutter.rise(far.min(radius))
        };
        let (mut near, mut beyond) = (low, high);
        for _ in 0..SEARCH {
            let (x, y) = (near + (beyond - near) * 0.382, near + (beyond - near) * 0.618);
            if above(x) < above(y) { near = x } else { beyond = y }
        }
        let peak = 0.5 * (near + beyond);
        if above(peak) < 0.0 {
            return None;
        }
        let edge = |outside: f64| {
            let (mut inside, mut outside) = (peak, outside);
            if above(outside) >= 0.0 {
                return outside;
            }
            for _ in 0..SEARCH {
                let middle = 0.5 * (inside + outside);
                if above(middle) >= 0.0 { inside = middle } else { outside = middle }
            }
            inside
        };
        Some([edge(low), edge(high)])
    }
}
