//! What is left of a workpiece, as a reader sees it: surfaces from the far ones to the near ones, so that what is in front
//! hides what is behind it, and which places of a way it hides.
//!
//! Invariant: the part is a stack of slabs with upright walls; seen from above, a slab never hides one above it.
use std::collections::BTreeSet;

use glam::{DVec2, DVec3};

use crate::base::expr::{cosd, sind};
use crate::engine::stock::{Plateau, Stock};

/// Corners of a circle.
const CORNERS: usize = 48;
/// An outline is a circle if all of it lies so near to one, in cells.
const ROUND: f64 = 1.1;
/// What hides a place is further above it, as a part of the height of the blank.
const SKIN: f64 = 2e-3;

/// A surface to paint, in the coordinates of the grid.
pub(super) struct Surface {
    /// Closed lines; one within another is a hole.
    pub(super) lines: Vec<Vec<DVec3>>,
    /// How light it is, 0 to 255.
    pub(super) light: f64,
    /// Whether its edges are drawn.
    pub(super) edged: bool,
}

/// The surfaces that a reader sees in that direction, in the order in which they are painted.
pub(super) fn surfaces(stock: &Stock, towards: DVec3) -> Vec<Surface> {
    let [min, max] = stock.bounds();
    let extent = (max.z - min.z).max(1e-9);
    let mut all = Vec::new();
    let mut below = min.z;
    for Plateau { height, outlines } in stock.plateaus() {
        let outlines: Vec<Vec<DVec2>> =
            outlines.into_iter().map(|line| rounded(line, stock.cell().max_element())).collect();
        if towards.truncate().length() > 1e-9 && height > below {
            all.extend(walls(&outlines, [below, height], towards));
        }
        all.push(Surface {
            lines: outlines.iter().map(|line| line.iter().map(|p| p.extend(height)).collect()).collect(),
            light: 150.0 + 90.0 * (height - min.z) / extent,
            edged: true,
        });
        below = height;
    }
    all
}

/// A circle in place of an outline that is one within a cell.
fn rounded(line: Vec<DVec2>, cell: f64) -> Vec<DVec2> {
    if line.len() < 5 {
        return line;
    }
    let (low, high) = line.iter().fold((line[0], line[0]), |(low, high), p| (low.min(*p), high.max(*p)));
    let (centre, size) = ((low + high) / 2.0, high - low);
    let radius = line.iter().map(|p| p.distance(centre)).sum::<f64>() / line.len() as f64;
    let off = line.iter().map(|p| (p.distance(centre) - radius).abs()).fold(0.0, f64::max);
    if off > ROUND * cell || (size.x - size.y).abs() > 1.6 * cell || radius < 1.5 * cell {
        return line;
    }
    let area: f64 = line.iter().zip(line.iter().cycle().skip(1)).map(|(a, b)| a.perp_dot(*b)).sum();
    let turn = 360.0 * area.signum() / CORNERS as f64;
    (0..CORNERS).map(|n| centre + DVec2::new(cosd(turn * n as f64), sind(turn * n as f64)) * radius).collect()
}

/// A piece of wall as the reader sees it: its ends in the plane, and how far to the right and how near each of them is.
struct Wall {
    ends: [DVec2; 2],
    right: [f64; 2],
    near: [f64; 2],
}

impl Wall {
    /// How near it is at a place to the right.
    fn near_at(&self, right: f64) -> f64 {
        let share = (right - self.right[0]) / (self.right[1] - self.right[0]);
        self.near[0] + (self.near[1] - self.near[0]) * share
    }
}

/// The walls under outlines that face the reader, far ones first. Material is on the left of an outline.
fn walls(outlines: &[Vec<DVec2>], [low, high]: [f64; 2], towards: DVec3) -> Vec<Surface> {
    let front = towards.truncate().normalize_or(DVec2::NEG_Y);
    let side = front.perp();
    let mut all: Vec<Wall> = Vec::new();
    for (a, b) in outlines.iter().flat_map(|line| line.iter().zip(line.iter().cycle().skip(1))) {
        let outward = -(*b - *a).perp();
        if outward.dot(front) <= 1e-9 {
            continue;
        }
        let mut ends = [*a, *b];
        if a.dot(side) > b.dot(side) {
            ends.reverse();
        }
        all.push(Wall { ends, right: ends.map(|p| p.dot(side)), near: ends.map(|p| p.dot(front)) });
    }
    all.sort_by(|a, b| a.right[0].total_cmp(&b.right[0]).then(a.near[0].total_cmp(&b.near[0])));
    let paint = |n: &usize| {
        let wall = &all[*n];
        let [a, b] = wall.ends;
        let outward = (b - a).perp().normalize_or_zero();
        let outward = if outward.dot(front) < 0.0 { -outward } else { outward };
        Surface {
            lines: vec![vec![a.extend(low), b.extend(low), b.extend(high), a.extend(high)]],
            // What looks along the secondary axis is lighter than what looks along the main one.
            light: 110.0 + 40.0 * outward.y.abs(),
            edged: false,
        }
    };
    far_first(&all).iter().map(paint).collect()
}

/// An order in which no wall is painted over one that is nearer where both are seen.
fn far_first(walls: &[Wall]) -> Vec<usize> {
    let mut before: Vec<usize> = vec![0; walls.len()];
    let mut nearer: Vec<Vec<usize>> = vec![Vec::new(); walls.len()];
    let mut open: Vec<usize> = Vec::new();
    for (n, wall) in walls.iter().enumerate() {
        open.retain(|other| walls[*other].right[1] > wall.right[0] + 1e-9);
        for other in &open {
            let end = walls[*other].right[1].min(wall.right[1]);
            let middle = (wall.right[0] + end) / 2.0;
            let (far, near) =
                if walls[*other].near_at(middle) < wall.near_at(middle) { (*other, n) } else { (n, *other) };
            nearer[far].push(near);
            before[near] += 1;
        }
        open.push(n);
    }
    let mut free: BTreeSet<usize> = (0..walls.len()).filter(|n| before[*n] == 0).collect();
    let mut order = Vec::new();
    while let Some(next) = free.pop_first() {
        order.push(next);
        for other in &nearer[next] {
            before[*other] -= 1;
            if before[*other] == 0 {
                free.insert(*other);
            }
        }
    }
    // Walls that touch may seem to be before each other; none of them is left out.
    let known: BTreeSet<usize> = order.iter().copied().collect();
    order.extend((0..walls.len()).filter(|n| !known.contains(n)));
    order
}

/// Whether material lies between a place and a reader in that direction.
pub(super) fn hides(stock: &Stock, place: DVec3, towards: DVec3) -> bool {
    let [min, max] = stock.bounds();
    let (cell, (columns, rows)) = (stock.cell(), stock.size());
    let skin = SKIN * (max.z - min.z);
    let step = towards * (0.5 * cell.min_element() / towards.truncate().length().max(0.5));
    // A place on a wall is not behind it.
    let mut p = place + step * 2.0;
    let mut left = 4 * (columns + rows) + 8;
    while left > 0 && p.z < max.z + skin {
        let at = (p.truncate() - min.truncate()) / cell;
        if at.cmpge(DVec2::ZERO).all() && at.x < columns as f64 && at.y < rows as f64 {
            let stretches = stock.column(at.x as usize, at.y as usize);
            if stretches.iter().any(|[from, to]| p.z > from + skin && p.z < to - skin) {
                return true;
            }
        } else if leaves(at, [columns as f64, rows as f64], towards) {
            return false;
        }
        p += step;
        left -= 1;
    }
    false
}

/// Whether a ray outside the grid goes further away from it.
fn leaves(at: DVec2, size: [f64; 2], towards: DVec3) -> bool {
    (0..2).any(|axis| (at[axis] < 0.0 && towards[axis] <= 0.0) || (at[axis] > size[axis] && towards[axis] >= 0.0))
}
