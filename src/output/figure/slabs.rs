//! What is left of a rectangle when convex polygons are taken away.
//!
//! The plane is cut into upright slabs in which no two edges cross; in each of them what is left are trapezoids, whose
//! free sides are linked to outlines. Invariant: edges that lie on one another do no harm, and lines stay where they are.
use std::collections::BTreeMap;

use glam::DVec2;

/// Slabs that are narrower have nothing in them, mm.
const NARROW: f64 = 1e-7;
/// Places that are nearer to each other are one, mm.
const SAME: f64 = 1e-5;
/// The grid on which ends of sides are looked for, mm.
const GRID: f64 = 1e-3;

/// An edge that is not upright, from its left to its right end.
#[derive(Clone, Copy, Debug)]
struct Edge {
    from: DVec2,
    to: DVec2,
}

impl Edge {
    fn at(&self, x: f64) -> f64 {
        self.from.y + (self.to.y - self.from.y) * ((x - self.from.x) / (self.to.x - self.from.x))
    }

    fn crossing(&self, other: &Self) -> Option<f64> {
        let (way, over) = (self.to - self.from, other.to - other.from);
        let turn = way.perp_dot(over);
        if turn.abs() <= 1e-9 * way.length() * over.length() {
            return None;
        }
        let x = self.from.x + way.x * ((other.from - self.from).perp_dot(over) / turn);
        (x > self.from.x.max(other.from.x) && x < self.to.x.min(other.to.x)).then_some(x)
    }
}

/// The edges of a convex polygon, but for upright ones.
fn edges(polygon: &[DVec2]) -> Vec<Edge> {
    let sides = polygon.iter().zip(polygon.iter().cycle().skip(1));
    let along = sides.filter(|(a, b)| (a.x - b.x).abs() > NARROW);
    along.map(|(a, b)| if a.x < b.x { Edge { from: *a, to: *b } } else { Edge { from: *b, to: *a } }).collect()
}

/// The outlines of what is left, material on their left.
pub(super) fn left([min, max]: [DVec2; 2], polygons: &[Vec<DVec2>]) -> Vec<Vec<DVec2>> {
    let all: Vec<Vec<Edge>> = polygons.iter().map(|polygon| edges(polygon)).collect();
    let places = places([min.x, max.x], &all);
    let mut near = Near::new(&all);
    let mut sides: Vec<[DVec2; 2]> = Vec::new();
    let mut before: Vec<[f64; 2]> = Vec::new();
    for pair in places.windows(2) {
        let &[a, b] = pair else { continue };
        let here = trapezoids((a, b), [min.y, max.y], near.over(a.midpoint(b)));
        let begin: Vec<[f64; 2]> = here.iter().map(|[low, high]| [low.x, high.x]).collect();
        upright(a, &before, &begin, &mut sides);
        for [low, high] in &here {
            sides.push([DVec2::new(a, low.x), DVec2::new(b, low.y)]);
            sides.push([DVec2::new(b, high.y), DVec2::new(a, high.x)]);
        }
        before = here.iter().map(|[low, high]| [low.y, high.y]).collect();
    }
    upright(max.x, &before, &[], &mut sides);
    linked(&sides)
}

/// The polygons that are over a place, which only ever moves to the right.
struct Near<'p> {
    /// Left and right end of each polygon, those that begin further to the right first.
    ahead: Vec<(f64, f64, usize)>,
    /// Right end and number of those that have begun, in their order.
    begun: Vec<(f64, usize)>,
    all: &'p [Vec<Edge>],
}

impl<'p> Near<'p> {
    fn new(all: &'p [Vec<Edge>]) -> Self {
        let ends = |edges: &[Edge]| {
            edges.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(left, right), edge| {
                (left.min(edge.from.x), right.max(edge.to.x))
            })
        };
        let mut ahead: Vec<(f64, f64, usize)> =
            all.iter().map(|edges| ends(edges)).enumerate().map(|(n, (left, right))| (left, right, n)).collect();
        ahead.sort_by(|a, b| b.0.total_cmp(&a.0));
        Self { ahead, begun: Vec::new(), all }
    }

    fn over(&mut self, x: f64) -> impl Iterator<Item = &'p [Edge]> {
        self.begun.retain(|(right, _)| *right > x);
        let before = self.begun.len();
        while let Some((_, right, n)) = self.ahead.pop_if(|(left, ..)| *left < x) {
            if right > x {
                self.begun.push((right, n));
            }
        }
        if self.begun.len() > before {
            self.begun.sort_by_key(|(_, n)| *n);
        }
        self.begun.iter().map(|(_, n)| self.all[*n].as_slice())
    }
}

/// Where slabs begin and end.
fn places([from, to]: [f64; 2], all: &[Vec<Edge>]) -> Vec<f64> {
    let mut places = vec![from, to];
    let mut edges: Vec<Edge> = all.iter().flatten().copied().collect();
    places.extend(edges.iter().flat_map(|edge| [edge.from.x, edge.to.x]));
    edges.sort_by(|a, b| a.from.x.total_cmp(&b.from.x));
    for (n, edge) in edges.iter().enumerate() {
        let (low, high) = (edge.from.y.min(edge.to.y), edge.from.y.max(edge.to.y));
        for other in edges.iter().skip(n + 1).take_while(|other| other.from.x < edge.to.x) {
            if other.from.y.min(other.to.y) <= high && other.from.y.max(other.to.y) >= low {
                places.extend(edge.crossing(other));
            }
        }
    }
    places.retain(|x| (from..=to).contains(x));
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| *a - *b < NARROW);
    places
}

/// What is left in a slab: lower and upper side, each by its heights at both ends.
fn trapezoids<'p>(
    (a, b): (f64, f64),
    [bottom, top]: [f64; 2],
    near: impl Iterator<Item = &'p [Edge]>,
) -> Vec<[DVec2; 2]> {
    let middle = a.midpoint(b);
    let mut taken: Vec<[(f64, DVec2); 2]> = Vec::new();
    for edges in near {
        let mut here = edges.iter().filter(|edge| edge.from.x < middle && middle < edge.to.x);
        if let (Some(one), Some(other)) = (here.next(), here.next()) {
            let side = |edge: &Edge| (edge.at(middle), DVec2::new(edge.at(a), edge.at(b)));
            let (one, other) = (side(one), side(other));
            taken.push(if one.0 < other.0 { [one, other] } else { [other, one] });
        }
    }
    taken.sort_by(|a, b| a[0].0.total_cmp(&b[0].0));
    let mut free = Vec::new();
    let mut floor = (bottom, DVec2::splat(bottom));
    for [low, high] in taken {
        if low.0.min(top) > floor.0 + SAME {
            let ceiling = if low.0 < top { low.1 } else { DVec2::splat(top) };
            free.push([floor.1, ceiling.min(DVec2::splat(top))]);
        }
        if high.0 > floor.0 {
            floor = (high.0, high.1.max(DVec2::splat(bottom)));
        }
    }
    if floor.0 < top - SAME {
        free.push([floor.1.min(DVec2::splat(top)), DVec2::splat(top)]);
    }
    free
}

/// Upright sides between what is left before a place and after it.
fn upright(x: f64, before: &[[f64; 2]], after: &[[f64; 2]], sides: &mut Vec<[DVec2; 2]>) {
    let mut heights: Vec<f64> = before.iter().chain(after).flatten().copied().collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup_by(|a, b| *a - *b < SAME);
    let within = |list: &[[f64; 2]], y: f64| list.iter().any(|[low, high]| *low < y && y < *high);
    for pair in heights.windows(2) {
        let &[low, high] = pair else { continue };
        let middle = low.midpoint(high);
        let (low, high) = (DVec2::new(x, low), DVec2::new(x, high));
        match (within(before, middle), within(after, middle)) {
            (true, false) => sides.push([low, high]),
            (false, true) => sides.push([high, low]),
            _ => {}
        }
    }
}

/// Sides that end where others begin, as closed lines.
fn linked(sides: &[[DVec2; 2]]) -> Vec<Vec<DVec2>> {
    let cell = |p: DVec2| ((p.x / GRID).round() as i64, (p.y / GRID).round() as i64);
    let mut begins: BTreeMap<(i64, i64), Vec<usize>> = BTreeMap::new();
    for (n, [from, _]) in sides.iter().enumerate() {
        begins.entry(cell(*from)).or_default().push(n);
    }
    let mut used = vec![false; sides.len()];
    let mut lines = Vec::new();
    for first in 0..sides.len() {
        let mut line = Vec::new();
        let mut next = (!used[first]).then_some(first);
        while let Some(n) = next {
            used[n] = true;
            line.push(sides[n][0]);
            let end = sides[n][1];
            let (x, y) = cell(end);
            let near = (-1..=1).flat_map(|i| (-1..=1).map(move |k| (x + i, y + k)));
            let open = near.filter_map(|cell| begins.get(&cell)).flatten().filter(|n| !used[**n]);
            next = open
                .map(|n| (sides[*n][0].distance(end), *n))
                .filter(|(away, _)| *away < GRID)
                .min_by(|a, b| a.0.total_cmp(&b.0))
                .map(|(_, n)| n);
        }
        if line.len() > 2 {
            lines.push(line);
        }
    }
    lines
}
