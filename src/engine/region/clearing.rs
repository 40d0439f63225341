//! The path of a cutter that clears a region at one level, from the inside outwards.
//!
//! The centre of the cutter follows the boundaries of the region of centres shrunk by one step after the other: the
//! innermost ones first, the wall last (TNC 640 manual, lines 4690-4693). It never leaves that region and never lifts:
//! between rings it goes straight where nothing is in the way, and else along rings and from one to the next. A step
//! of at most the radius of the cutter leaves nothing; the corners of a greater one may (manual, line 4712).
//! Invariant: every edge lies within the region of centres.
use std::cell::OnceCell;
use std::cmp::Ordering;

use glam::DVec2;

use super::boundary::{Boundary, Edge, nearest_of};
use super::nearest::Bridge;
use super::{NEAR, Nearest, Region};

/// More rings than this one inside the other are refused.
pub const MOST_RINGS: usize = 10_000;

/// Places that differ by less, mm, are beside each other.
const BESIDE: f64 = 1e-3;

/// A path over one connected part of a region.
#[derive(Clone, Debug)]
pub struct Path {
    /// Where the cutter plunges: on the innermost ring.
    pub start: DVec2,
    /// How far the start is from the boundary of the region of centres, in mm: room for a helix about it.
    pub room: f64,
    /// The way from there.
    pub edges: Vec<Edge>,
}

impl Path {
    /// Where it ends.
    pub fn end(&self) -> DVec2 {
        self.edges.last().map_or(self.start, Edge::to)
    }
}

/// More rings are needed than there may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyRings;

/// A connected part of the region of centres, shrunk by a number of steps.
struct Level {
    /// In the direction in which they are milled.
    rings: Vec<Boundary>,
    /// The region that they bound.
    region: Region,
    /// The level around it, one step farther out.
    around: Option<usize>,
    /// The levels inside of it, each the next step of a part of it.
    inside: Vec<usize>,
    /// How far inside it is, mm.
    depth: f64,
    /// Where something of its rings is near, by their numbers.
    near: OnceCell<Nearest>,
    /// The straight ways from ring to ring that join all of them.
    bridges: OnceCell<Vec<Bridge>>,
}

/// The paths that clear a region in which the centre of the cutter may be, one for each of its connected parts.
///
/// `step` is the distance of the rings in mm. `with_region_left` is the direction along the boundaries: with the
/// region on the left of the way is climb milling for a spindle that turns clockwise. `from` is where the cutter comes
/// from: what is near is cleared first.
///
/// # Errors
/// The step is so small that there are more than [`MOST_RINGS`].
pub fn paths(centres: &Region, step: f64, with_region_left: bool, from: DVec2) -> Result<Vec<Path>, TooManyRings> {
    let levels = levels(centres, step, with_region_left)?;
    let mut outermost: Vec<usize> = (0..levels.len()).filter(|n| levels[*n].around.is_none()).collect();
    let (mut here, mut paths) = (from, Vec::with_capacity(outermost.len()));
    while !outermost.is_empty() {
        let next = number_of_nearest(outermost.iter().map(|own| levels[*own].nearest(here)), here);
        let order = from_inside(&levels, outermost.swap_remove(next));
        let Some(first) = order.first().map(|first| &levels[*first]) else { continue };
        let (start, room) = (first.nearest(here), first.depth);
        let mut walk = Walk { levels: &levels, here: start, edges: Vec::new() };
        for number in order {
            walk.mill(number);
        }
        here = walk.here;
        paths.push(Path { start, room, edges: walk.edges });
    }
    Ok(paths)
}

/// Which of some points is nearest to one.
fn number_of_nearest(points: impl Iterator<Item = DVec2> + Clone, here: DVec2) -> usize {
    let nearest = nearest_of(points.clone(), here);
    points.into_iter().position(|point| Some(point) == nearest).unwrap_or(0)
}

/// All levels, those inside first.
fn levels(centres: &Region, step: f64, left: bool) -> Result<Vec<Level>, TooManyRings> {
    let mut shrunk = vec![centres.clone()];
    while let Some(last) = shrunk.last().filter(|last| !last.is_empty()) {
        if shrunk.len() > MOST_RINGS || step.is_nan() || step <= NEAR {
            return Err(TooManyRings);
        }
        let next = last.shrunk(step);
        shrunk.push(next);
    }
    let (mut levels, mut inside): (Vec<Level>, Vec<usize>) = (Vec::new(), Vec::new());
    for (steps, region) in shrunk.iter().enumerate().rev() {
        let first = levels.len();
        levels.extend(region.parts().map(|part| Level::new(part, steps as f64 * step, left)));
        let now = first..levels.len();
        for inner in inside.drain(..) {
            let at = levels[inner].rings.first().map_or(DVec2::ZERO, Boundary::start);
            let Some(around) = now.clone().find(|n| levels[*n].region.contains(at)).or(now.clone().next()) else {
                continue;
            };
            levels[inner].around = Some(around);
            levels[around].inside.push(inner);
        }
        inside.extend(now);
    }
    // From left to right, then from below: how the regions are put together must not decide.
    let middles: Vec<[f64; 2]> = levels.iter().map(Level::rank).collect();
    for level in &mut levels {
        level.inside.sort_by(|a, b| middles[*a].partial_cmp(&middles[*b]).unwrap_or(Ordering::Equal));
    }
    Ok(levels)
}

/// A level and all inside of it, each after those inside of it.
fn from_inside(levels: &[Level], outermost: usize) -> Vec<usize> {
    let (mut order, mut stack) = (Vec::new(), vec![outermost]);
    while let Some(number) = stack.pop() {
        order.push(number);
        stack.extend(&levels[number].inside);
    }
    order.reverse();
    order
}

impl Level {
    fn new(region: Region, depth: f64, left: bool) -> Self {
        let rings = region.boundaries().map(|ring| if left { ring } else { ring.reversed() }).collect();
        let (near, bridges) = (OnceCell::new(), OnceCell::new());
        Self { rings, region, around: None, inside: Vec::new(), depth, near, bridges }
    }

    fn near(&self) -> &Nearest {
        self.near.get_or_init(|| Nearest::of(&self.region))
    }

    /// The point of its rings that is nearest to a point.
    fn nearest(&self, near: DVec2) -> DVec2 {
        self.near().nearest(near).map_or(near, |(point, _)| point)
    }

    /// The middle of its region, in steps that rounding does not change.
    fn rank(&self) -> [f64; 2] {
        let middle = self.region.middle().unwrap_or_default();
        [middle.x, middle.y].map(|along| (along / BESIDE).round())
    }

    /// The number of the ring that a point is on.
    fn ring_of(&self, point: DVec2) -> usize {
        self.near().nearest_among(point, f64::INFINITY, &|_| true).map_or(0, |(_, ring)| ring)
    }

    /// Whether a point is inside of it or on its rim.
    fn holds(&self, point: DVec2) -> bool {
        let on_rim = |(_, distance): (DVec2, f64)| distance <= 10.0 * NEAR;
        self.near().nearest(point).is_some_and(on_rim) || self.region.contains(point)
    }
}

/// A walk of the cutter over one part.
struct Walk<'a> {
    levels: &'a [Level],
    here: DVec2,
    edges: Vec<Edge>,
}

impl Walk<'_> {
    /// Mills the rings of a level, the nearest one first.
    fn mill(&mut self, number: usize) {
        let levels = self.levels;
        let level = &levels[number];
        let mut left = vec![true; level.rings.len()];
        while let Some((near, next)) = level.near().nearest_among(self.here, f64::INFINITY, &|ring| left[ring]) {
            left[next] = false;
            self.go_to(near, number);
            self.edges.extend(level.rings[next].from_nearest(self.here).edges());
        }
    }

    /// From where it is to a point of a ring of a level.
    fn go_to(&mut self, goal: DVec2, number: usize) {
        // The level around both, and the region in which the straight way may lie.
        let around = std::iter::successors(Some(number), |number| self.levels[*number].around);
        let Some(common) = around.into_iter().find(|number| self.levels[*number].holds(self.here)) else {
            return self.line(goal);
        };
        let common = &self.levels[common];
        if common.near().is_clear(&common.region, self.here, goal) {
            return self.line(goal);
        }
        // Out to its rings, along them, and in again: nothing is between a point and the nearest one of them.
        let (out, back) = (common.nearest(self.here), common.nearest(goal));
        self.line(out);
        self.along(common, back);
        self.line(goal);
    }

    /// Along the rings of a level to one of its points, straight from ring to ring where they are nearest.
    fn along(&mut self, level: &Level, goal: DVec2) {
        let (own, other) = (level.ring_of(self.here), level.ring_of(goal));
        let mut ring = own;
        for Bridge { lines: [_, next], ends: [from, to] } in level.bridges(own, other) {
            self.along_ring(&level.rings[ring], from);
            self.line(to);
            ring = next;
        }
        self.along_ring(&level.rings[other], goal);
    }

    /// The shorter way along a ring.
    fn along_ring(&mut self, ring: &Boundary, goal: DVec2) {
        let (there, back) = (ring.way(self.here, goal), ring.clone().reversed().way(self.here, goal));
        let length = |edges: &[Edge]| {
            let mut at = self.here;
            edges.iter().fold(0.0, |sum, edge| {
                let from = std::mem::replace(&mut at, edge.to());
                sum + edge.length(from)
            })
        };
        // Rounding does not decide between ways that are equally long.
        let way = if length(&there) <= length(&back) + NEAR { there } else { back };
        if let Some(last) = way.last() {
            self.here = last.to();
        }
        self.edges.extend(way);
    }

    fn line(&mut self, to: DVec2) {
        if self.here.distance(to) > NEAR {
            self.edges.push(Edge::Line(to));
            self.here = to;
        }
    }
}

impl Level {
    /// The straight ways from ring to ring that lead from one to another: where two are nearest to each other nothing
    /// is between them.
    fn bridges(&self, from: usize, to: usize) -> Vec<Bridge> {
        if from == to {
            return Vec::new();
        }
        let all = self.bridges.get_or_init(|| self.near().bridges(self.rings.len()));
        let mut beside: Vec<Vec<Bridge>> = vec![Vec::new(); self.rings.len()];
        for bridge in all.iter().flat_map(|bridge| [*bridge, bridge.back()]) {
            beside[bridge.lines[0]].push(bridge);
        }
        // How each ring that is reached was reached, from the goal.
        let mut reached: Vec<Option<Bridge>> = vec![None; self.rings.len()];
        let mut open = vec![to];
        while let Some(ring) = open.pop() {
            for bridge in &beside[ring] {
                let next = bridge.lines[1];
                if next != to && reached[next].is_none() {
                    reached[next] = Some(bridge.back());
                    open.push(next);
                }
            }
        }
        std::iter::successors(reached[from], |before| reached[before.lines[1]]).collect()
    }
}
