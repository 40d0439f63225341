//! The part as a picture sees it: plateaus from low to high, each with its outline.
//!
//! Invariant: only tops count, as seen along the columns; outlines run along the rims of columns and are smoothed by
//! less than a cell.
use glam::DVec2;

use super::Stock;

/// Plateaus that a picture can distinguish.
const MOST: usize = 24;

/// Everything that is at least as high as a height.
#[derive(Clone, Debug, PartialEq)]
pub struct Plateau {
    /// The height along the columns.
    pub height: f64,
    /// Closed outlines (main and secondary axis); material is on the left of each.
    pub outlines: Vec<Vec<DVec2>>,
}

impl Stock {
    /// The plateaus of the part from low to high; the lowest is everything that is there at all. A part of many heights
    /// is shown by evenly spaced ones.
    pub fn plateaus(&self) -> Vec<Plateau> {
        let (columns, rows) = self.size();
        let mut tops: Vec<f64> = (0..rows * columns).filter_map(|n| self.top(n % columns, n / columns)).collect();
        if tops.is_empty() {
            return Vec::new();
        }
        tops.sort_by(f64::total_cmp);
        let near = (self.grid.max.z - self.grid.min.z) * 1e-3;
        // A height counts if enough columns end there.
        let least = (tops.len() / 2000).max(4);
        let mut levels: Vec<f64> = Vec::new();
        let mut begin = 0;
        for n in 1..=tops.len() {
            let (first, last) = (tops[begin], tops[n - 1]);
            if tops.get(n).is_none_or(|next| next - first > near) {
                if n - begin >= least {
                    levels.push(last);
                }
                begin = n;
            }
        }
        let (low, high) = (tops[0], tops[tops.len() - 1]);
        if levels.is_empty() || levels.len() > MOST {
            levels = (0..=MOST).map(|n| low + (high - low) * n as f64 / MOST as f64).collect();
        }
        if levels.first().is_some_and(|first| *first > low + near) {
            levels.insert(0, low);
        }
        let outlines = |height: f64| {
            let holds = |column: usize, row: usize| self.top(column, row).is_some_and(|top| top > height - 2.0 * near);
            self.outlines(&holds)
        };
        let lowest = levels.first().copied().unwrap_or(low);
        let all = |height: f64| if height == lowest { f64::NEG_INFINITY } else { height };
        levels.iter().map(|height| Plateau { height: *height, outlines: outlines(all(*height)) }).collect()
    }

    /// The outlines of the columns that belong to a set.
    fn outlines(&self, holds: &dyn Fn(usize, usize) -> bool) -> Vec<Vec<DVec2>> {
        let (columns, rows) = self.size();
        let inside = |column: i64, row: i64| {
            let within = column >= 0 && row >= 0 && (column as usize) < columns && (row as usize) < rows;
            within && holds(column as usize, row as usize)
        };
        // From each corner of the grid the steps that have material on their left: east, north, west, south.
        const STEPS: [(i64, i64); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];
        let wide = columns + 1;
        let mut open = vec![0_u8; wide * (rows + 1)];
        for row in 0..=rows as i64 {
            for column in 0..=columns as i64 {
                let around = [
                    inside(column, row) && !inside(column, row - 1),
                    inside(column - 1, row) && !inside(column, row),
                    inside(column - 1, row - 1) && !inside(column - 1, row),
                    inside(column, row - 1) && !inside(column - 1, row - 1),
                ];
                let bits = around.iter().enumerate().map(|(n, step)| u8::from(*step) << n).sum();
                if let Some(slot) = open.get_mut(row as usize * wide + column as usize) {
                    *slot = bits;
                }
            }
        }
        let mut found = Vec::new();
        for start in 0..open.len() {
            while open.get(start).is_some_and(|bits| *bits != 0) {
                let mut outline = Vec::new();
                let (mut at, mut heading) = (start, None);
                loop {
                    let bits = open.get(at).copied().unwrap_or(0);
                    // Where two outlines touch, the sharper left turn keeps them apart.
                    let order = heading.map_or([0, 1, 2, 3], |h: usize| [(h + 1) % 4, h, (h + 3) % 4, (h + 2) % 4]);
                    let Some(step) = order.into_iter().find(|step| bits & (1 << step) != 0) else { break };
                    if let Some(slot) = open.get_mut(at) {
                        *slot &= !(1 << step);
                    }
                    let (column, row) = ((at % wide) as i64, (at / wide) as i64);
                    outline.push(DVec2::new(column as f64, row as f64));
                    let (x, y) = STEPS[step];
                    at = ((row + y) as usize) * wide + (column + x) as usize;
                    heading = Some(step);
                    if at == start {
                        break;
                    }
                }
                let origin = DVec2::new(self.grid.min.x, self.grid.min.y);
                found.push(smoothed(&outline).into_iter().map(|p| origin + p * self.grid.cell).collect());
            }
        }
        found
    }
}

/// The outline without the steps of the grid: the middles of its edges, thinned where they lie within 0.6 of a cell
/// of a straight line. Corners of long edges stay.
fn smoothed(outline: &[DVec2]) -> Vec<DVec2> {
    let count = outline.len();
    let at = |n: usize| outline[n % count];
    let mut points: Vec<DVec2> = Vec::new();
    for n in 0..count {
        let (before, here, after) = (at(n + count - 1), at(n), at(n + 1));
        let turns = (here - before).perp_dot(after - here) != 0.0;
        // A corner stays if both of its edges go straight on for some cells.
        let straight = |step: usize| {
            let way = |k: usize| at(n + k + 1) - at(n + k);
            let (ahead, back) = (way(0), at(n + count - 1) - at(n));
            (1..=step).all(|k| way(k) == ahead)
                && (1..=step).all(|k| at(n + 2 * count - k - 1) - at(n + 2 * count - k) == back)
        };
        if turns && straight(3.min(count / 4)) {
            points.push(here);
        }
        points.push(0.5 * (here + after));
    }
    let half = points.len() / 2;
    let mut thin = Vec::new();
    thinned(&points[..=half.min(points.len() - 1)], &mut thin);
    thinned(&points[half..], &mut thin);
    thin
}

/// Douglas and Peucker's way to leave points out; the last one is left to the caller.
fn thinned(points: &[DVec2], into: &mut Vec<DVec2>) {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return };
    let way = *last - *first;
    let off = |p: &DVec2| {
        let length = way.length();
        if length == 0.0 { (*p - *first).length() } else { (way.perp_dot(*p - *first) / length).abs() }
    };
    let farthest = (1..points.len().saturating_sub(1)).max_by(|a, b| off(&points[*a]).total_cmp(&off(&points[*b])));
    match farthest.filter(|n| off(&points[*n]) > 0.6) {
        Some(n) => {
            thinned(&points[..=n], into);
            thinned(&points[n..], into);
        }
        None => into.push(*first),
    }
}
