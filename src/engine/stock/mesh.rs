//! The part as triangles: binary STL.
//!
//! Each cell of the grid is a prism with the exact ends of its stretches, so walls follow the grid. Invariant: the
//! mesh is closed. Two faces meet in whole edges: where the four columns about an upright edge end at different
//! heights, the faces next to it have corners at all of them.
use glam::DVec3;

use super::Stock;

/// Bytes of a triangle.
const TRIANGLE: usize = 50;
/// Bytes before the first triangle.
const HEAD: usize = 84;

/// Heights as the file has them, from low to high.
type Stretches = Vec<[f32; 2]>;

struct Mesh<'s> {
    stock: &'s Stock,
    bytes: Vec<u8>,
    count: u32,
}

impl Stock {
    /// The part in the coordinates of the blank as binary STL. Nothing if it has more triangles than the format
    /// can count.
    pub fn to_stl(&self) -> Option<Vec<u8>> {
        let mut bytes = vec![0; HEAD];
        for (slot, byte) in bytes.iter_mut().zip(b"ciklo part, mm") {
            *slot = *byte;
        }
        let mut mesh = Mesh { stock: self, bytes, count: 0 };
        let columns = self.grid.columns;
        let line = |row: Option<usize>| -> Vec<Stretches> {
            // A frame of empty columns around the part.
            let of = |n: usize| match (n.checked_sub(1), row) {
                (Some(column), Some(row)) if column < columns => snapped(&self.column(column, row)),
                _ => Vec::new(),
            };
            (0..columns + 2).map(of).collect()
        };
        let (mut before, mut here) = (line(None), line(Some(0)));
        for row in 0..=self.grid.rows {
            // `before` is row - 1, `here` is row, `after` is row + 1.
            let next = row + 1;
            let after = line((next < self.grid.rows).then_some(next));
            mesh.row(row, &before, &here, &after)?;
            (before, here) = (here, after);
        }
        let count = mesh.count.to_le_bytes();
        for (slot, byte) in mesh.bytes.iter_mut().skip(HEAD - count.len()).zip(count) {
            *slot = byte;
        }
        Some(mesh.bytes)
    }
}

fn snapped(stretches: &[[f64; 2]]) -> Stretches {
    let mut all: Stretches = Vec::with_capacity(stretches.len());
    for [low, high] in stretches {
        let (low, high) = (*low as f32, *high as f32);
        match all.last_mut() {
            Some(last) if last[1] >= low => last[1] = last[1].max(high),
            _ if high > low => all.push([low, high]),
            _ => {}
        }
    }
    all
}

/// What `a` has and `b` has not.
fn without(a: &Stretches, b: &Stretches) -> Stretches {
    let mut left = Vec::new();
    for [low, high] in a {
        let mut from = *low;
        for [start, end] in b {
            if *start > from && *start < *high {
                left.push([from, *start]);
            }
            if *start < *high {
                from = from.max(*end);
            }
        }
        if from < *high {
            left.push([from, *high]);
        }
    }
    left
}

/// The heights from low to high at which an upright edge has corners.
fn corners(around: [&Stretches; 4], [low, high]: [f32; 2]) -> Vec<f32> {
    let mut all = vec![low, high];
    all.extend(around.into_iter().flatten().flatten().copied().filter(|z| *z > low && *z < high));
    all.sort_by(f32::total_cmp);
    all.dedup();
    all
}

impl Mesh<'_> {
    fn corner(&self, column: usize, row: usize, z: f32) -> [f32; 3] {
        let grid = &self.stock.grid;
        let (x, y) = (grid.min.x + column as f64 * grid.cell.x, grid.min.y + row as f64 * grid.cell.y);
        let p = grid.blank(DVec3::new(x, y, f64::from(z)));
        [p.x as f32, p.y as f32, p.z as f32]
    }

    fn triangle(&mut self, corners: [[f32; 3]; 3]) -> Option<()> {
        let [a, b, c] = corners.map(|p| DVec3::new(f64::from(p[0]), f64::from(p[1]), f64::from(p[2])));
        let normal = (b - a).cross(c - a).normalize_or_zero();
        self.count = self.count.checked_add(1)?;
        self.bytes.reserve(TRIANGLE);
        for value in
            [normal.x as f32, normal.y as f32, normal.z as f32].into_iter().chain(corners.into_iter().flatten())
        {
            self.bytes.extend_from_slice(&value.to_le_bytes());
        }
        self.bytes.extend_from_slice(&[0, 0]);
        Some(())
    }

    /// The faces of the cells of a row, and those between it and the row before. Lists begin with an empty column.
    fn row(&mut self, row: usize, before: &[Stretches], here: &[Stretches], after: &[Stretches]) -> Option<()> {
        let get = |line: &'_ [Stretches], n: usize| -> Stretches { line.get(n).cloned().unwrap_or_default() };
        for n in 1..here.len() {
            let column = n - 1;
            let own = get(here, n);
            for [low, high] in &own {
                for (z, up) in [(*low, false), (*high, true)] {
                    let [a, b, c, d] =
                        [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(i, j)| self.corner(column + i, row + j, z));
                    let (b, d) = if up { (b, d) } else { (d, b) };
                    self.triangle([a, b, c])?;
                    self.triangle([a, c, d])?;
                }
            }
            // Between this cell and the one before it in the row: edges at row and row + 1.
            let left = get(here, n - 1);
            let near = [&get(before, n - 1), &get(before, n), &left, &own];
            let far = [&left, &own, &get(after, n - 1), &get(after, n)];
            for (from, to, own_side) in [(&own, &left, true), (&left, &own, false)] {
                for stretch in without(from, to) {
                    let first = corners(near, stretch).into_iter().map(|z| self.corner(column, row, z)).collect();
                    let second = corners(far, stretch).into_iter().map(|z| self.corner(column, row + 1, z)).collect();
                    self.strip(first, second, own_side)?;
                }
            }
            // Between this cell and that of the row before: edges at column and column + 1.
            let back = get(before, n);
            let near = [&get(before, n - 1), &back, &left, &own];
            let far = [&back, &get(before, n + 1), &own, &get(here, n + 1)];
            for (from, to, own_side) in [(&own, &back, true), (&back, &own, false)] {
                for stretch in without(from, to) {
                    let first = corners(near, stretch).into_iter().map(|z| self.corner(column, row, z)).collect();
                    let second = corners(far, stretch).into_iter().map(|z| self.corner(column + 1, row, z)).collect();
                    self.strip(first, second, !own_side)?;
                }
            }
        }
        Some(())
    }

    /// A face between two upright chains of corners. `turned` gives the side on which the material is.
    fn strip(&mut self, first: Vec<[f32; 3]>, second: Vec<[f32; 3]>, turned: bool) -> Option<()> {
        let (mut i, mut j) = (0, 0);
        let at = |chain: &[[f32; 3]], n: usize| chain.get(n).copied().unwrap_or_default();
        while i + 1 < first.len() || j + 1 < second.len() {
            // The chain with fewer steps done goes on.
            let step_first = j + 1 >= second.len() || (i + 1 < first.len() && i * second.len() <= j * first.len());
            let (a, b) = (at(&first, i), at(&second, j));
            let c = if step_first {
                i += 1;
                at(&first, i)
            } else {
                j += 1;
                at(&second, j)
            };
            self.triangle(if turned { [a, c, b] } else { [a, b, c] })?;
        }
        Some(())
    }
}
