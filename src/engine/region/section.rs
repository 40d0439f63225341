//! The half section of what is turned: an area of the half plane of turning, cut exactly.
//!
//! `x` is the rotary axis and `y` the radius. An area is a list of cells that do not overlap: what lies between two
//! curves, lines or arcs, over a range of `x`. Taking an area away looks at each cell by itself, so surfaces that touch,
//! coincide or end in each other are no special case. Invariant: lines and arcs stay lines and arcs.
use std::f64::consts::PI;

use glam::DVec2;

use super::insert_envelope::{Piece, Shape, highest};
use super::sweep::Swept;
use super::{Edge, Way};
use crate::base::expr::{atan2d, cosd};

/// What is thinner or shorter, mm, is nothing.
pub(super) const THIN: f64 = 1e-9;
/// So far below all of a section its outline goes where it has nothing, mm.
const DEEP: f64 = 20_000.0;
/// Cells are looked through for such that belong together when there are so many, or twice as many as the last time.
const MANY: usize = 64;

/// What lies between two curves over a range of the rotary axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) low: Shape,
    pub(super) high: Shape,
}

/// A side of a cell: a line, or an arc of a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// Its radii at both ends of the range.
    pub ends: [f64; 2],
    /// The centre of its circle, and whether it is the upper half of it; nothing of a line.
    pub circle: Option<(DVec2, bool)>,
}

impl Cell {
    /// The range of the rotary axis.
    pub const fn range(&self) -> [f64; 2] {
        [self.from, self.to]
    }

    /// Its sides: that nearer to the axis, and the outer one.
    pub fn sides(&self) -> [Side; 2] {
        [self.low, self.high].map(|shape| Side {
            ends: [shape.height(self.from), shape.height(self.to)],
            circle: match shape {
                Shape::Line { .. } => None,
                Shape::Arc { centre, upper, .. } => Some((centre, upper)),
            },
        })
    }

    /// Whether a point belongs to it.
    pub fn contains(&self, point: DVec2) -> bool {
        let is_between = || self.low.height(point.x) <= point.y && point.y <= self.high.height(point.x);
        self.from <= point.x && point.x <= self.to && is_between()
    }

    /// How thick it is at a place.
    fn thickness(&self, x: f64) -> f64 {
        self.high.height(x) - self.low.height(x)
    }

    /// The greatest thickness of it, as its ends and its middle have it.
    pub fn greatest(&self) -> f64 {
        [self.from, self.from.midpoint(self.to), self.to].map(|x| self.thickness(x)).into_iter().fold(0.0, f64::max)
    }

    /// The closed way around it.
    fn boundary(&self) -> Way {
        let point = |shape: &Shape, x| DVec2::new(x, shape.height(x));
        let start = point(&self.low, self.from);
        let upper = Way { start: point(&self.high, self.from), edges: vec![self.high.edge(self.from, self.to)] };
        let upper = upper.reversed();
        let mut edges = vec![self.low.edge(self.from, self.to), Edge::Line(upper.start)];
        edges.extend(upper.edges);
        edges.push(Edge::Line(start));
        Way { start, edges }
    }

    /// Its corners, and the middles of its sides.
    pub fn corners(&self) -> impl Iterator<Item = DVec2> + '_ {
        let places = [self.from, self.from.midpoint(self.to), self.to];
        places.into_iter().flat_map(|x| [self.low, self.high].map(|shape| DVec2::new(x, shape.height(x))))
    }

    /// The volume of what it is the half section of, mm³.
    pub fn volume(&self) -> f64 {
        PI * (squares(&self.high, self.from, self.to) - squares(&self.low, self.from, self.to))
    }

    /// The same as another one beside it, which it goes on with.
    fn goes_on(&self, next: &Self) -> bool {
        let (far, middle) = (next.to, next.from.midpoint(next.to));
        let same = |one: &Shape, other: &Shape| {
            one == other
                || [far, middle].into_iter().all(|x| reaches(one, x) && near(one, other, x)) && alike(one, other)
        };
        (next.from - self.to).abs() <= THIN && same(&self.low, &next.low) && same(&self.high, &next.high)
    }
}

/// Whether both are lines or arcs of the same kind.
const fn alike(one: &Shape, other: &Shape) -> bool {
    match (one, other) {
        (Shape::Line { .. }, Shape::Line { .. }) => true,
        (Shape::Arc { upper: a, .. }, Shape::Arc { upper: b, .. }) => *a == *b,
        _ => false,
    }
}

fn reaches(shape: &Shape, x: f64) -> bool {
    match *shape {
        Shape::Line { .. } => true,
        Shape::Arc { centre, radius, .. } => (x - centre.x).abs() <= radius,
    }
}

fn near(one: &Shape, other: &Shape, x: f64) -> bool {
    (one.height(x) - other.height(x)).abs() < THIN / 10.0
}

/// The integral of the square of the radius.
fn squares(shape: &Shape, from: f64, to: f64) -> f64 {
    match *shape {
        Shape::Line { .. } => {
            let (a, b) = (shape.height(from), shape.height(to));
            (to - from) * (a * a + a * b + b * b) / 3.0
        }
        Shape::Arc { centre, radius, upper } => {
            let (a, b) = ((from - centre.x).clamp(-radius, radius), (to - centre.x).clamp(-radius, radius));
            let square = radius * radius;
            let area = |u: f64| {
                (u * libm::sqrt((square - u * u).max(0.0)) + square * libm::asin((u / radius).clamp(-1.0, 1.0))) / 2.0
            };
            let side = if upper { 2.0 } else { -2.0 };
            let own = square * (b - a) - (b * b * b - a * a * a) / 3.0;
            centre.y * centre.y * (to - from) + side * centre.y * (area(b) - area(a)) + own
        }
    }
}

/// A half section.
#[derive(Clone, Debug, Default)]
pub struct Section {
    cells: Vec<Cell>,
    /// How many cells there were when they were last looked through.
    seen: usize,
}

impl Section {
    /// What lies between two radii, and two places of the rotary axis.
    pub fn ring([from, to]: [f64; 2], [inner, outer]: [f64; 2]) -> Self {
        let flat = |radius| Shape::Line { through: DVec2::new(from, radius), slope: 0.0 };
        let cell = Cell { from, to, low: flat(inner), high: flat(outer) };
        Self { cells: if to - from > THIN && outer - inner > THIN { vec![cell] } else { Vec::new() }, seen: 0 }
    }

    /// What a closed way encloses that does not cross itself; the way is closed by a line if it is open.
    pub fn within(way: &Way) -> Self {
        let mut pieces = Vec::new();
        around(way.start, &way.edges, &mut pieces);
        around(way.end(), &[Edge::Line(way.start)], &mut pieces);
        Self { cells: between(&pieces), seen: 0 }
    }

    /// The way along what of it is furthest out, as something sees it, from low to high `x`; where it has nothing, that
    /// is far below. Nothing of a section that is empty.
    pub fn outline(&self, seen: &dyn Fn(&Way) -> Way) -> Option<Way> {
        let mut pieces = Vec::new();
        for cell in self.in_order() {
            let way = seen(&cell.boundary());
            around(way.start, &way.edges, &mut pieces);
        }
        let pieces = highest(&pieces);
        let ends = pieces.iter().flat_map(|piece| [piece.from, piece.to].map(|x| piece.shape.height(x)));
        let floor = ends.reduce(f64::min)? - DEEP;
        let start = DVec2::new(pieces.first()?.from, floor);
        let (mut at, mut edges) = (start, Vec::with_capacity(2 * pieces.len() + 2));
        let mut go = |edges: &mut Vec<Edge>, to: DVec2| {
            if at.distance(to) > THIN {
                edges.push(Edge::Line(to));
            }
            at = to;
        };
        for piece in &pieces {
            let begin = DVec2::new(piece.from, piece.shape.height(piece.from));
            if let Some(last) = edges.last().map(Edge::to)
                && begin.x - last.x > THIN
            {
                go(&mut edges, DVec2::new(last.x, floor));
                go(&mut edges, DVec2::new(begin.x, floor));
            }
            go(&mut edges, begin);
            let edge = piece.shape.edge(piece.from, piece.to);
            edges.push(edge);
            go(&mut edges, edge.to());
        }
        let last = edges.last().map(Edge::to)?;
        edges.push(Edge::Line(DVec2::new(last.x, floor)));
        Some(Way { start, edges })
    }

    /// Its cells.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Its cells in the order of the rotary axis, as few as possible.
    pub fn in_order(&self) -> Vec<Cell> {
        let mut own = self.clone();
        own.join();
        own.cells
    }

    /// Whether nothing belongs to it.
    pub fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// Its least and its greatest coordinates; nothing of one that is empty.
    pub fn bounds(&self) -> Option<[DVec2; 2]> {
        let mut corners = self.cells.iter().flat_map(|cell| {
            let sides = [cell.low, cell.high].into_iter().flat_map(|shape| match shape {
                Shape::Arc { centre, radius, upper } if (cell.from..=cell.to).contains(&centre.x) => {
                    Some(centre + DVec2::new(0.0, if upper { radius } else { -radius }))
                }
                _ => None,
            });
            cell.corners().chain(sides).collect::<Vec<_>>()
        });
        let first = corners.next()?;
        Some(corners.fold([first, first], |[low, high], at| [low.min(at), high.max(at)]))
    }

    /// The volume of what it is the half section of, mm³.
    pub fn volume(&self) -> f64 {
        self.cells.iter().map(Cell::volume).sum()
    }

    /// The stretches of it at a place of the rotary axis, from the axis outwards.
    pub fn at(&self, x: f64) -> Vec<[f64; 2]> {
        let here = self.cells.iter().filter(|cell| cell.from <= x && x <= cell.to);
        joined(here.map(|cell| [cell.low.height(x), cell.high.height(x)]).collect())
    }

    /// The stretches of it along the rotary axis at a radius.
    pub fn along(&self, radius: f64) -> Vec<[f64; 2]> {
        let mut found = Vec::new();
        for cell in &self.cells {
            let mut places = vec![cell.from, cell.to];
            for shape in [cell.low, cell.high] {
                let level = Shape::Line { through: DVec2::new(0.0, radius), slope: 0.0 };
                places.extend(shape.meets(&level).filter(|x| cell.from < *x && *x < cell.to));
            }
            places.sort_by(f64::total_cmp);
            for pair in places.windows(2) {
                let &[a, b] = pair else { continue };
                let middle = a.midpoint(b);
                if b > a && cell.low.height(middle) <= radius && radius <= cell.high.height(middle) {
                    found.push([a, b]);
                }
            }
        }
        joined(found)
    }

    /// Takes away what another one has; `removed` gets each cell that was taken away.
    pub fn take(&mut self, other: &Self, removed: &mut dyn FnMut(&Cell)) {
        for cell in &other.cells {
            self.take_cell(cell, removed);
        }
        self.join_if_many();
    }

    /// Adds what another one has.
    pub fn add(&mut self, other: &Self) {
        let mut rest = other.clone();
        rest.take(self, &mut |_| {});
        self.cells.extend(rest.cells);
        self.join();
    }

    /// Takes away what was swept; `removed` gets each cell that was taken away.
    pub fn cut(&mut self, swept: &Swept, removed: &mut dyn FnMut(&Cell)) {
        for cell in &swept.cells {
            self.take_cell(cell, removed);
        }
        self.join_if_many();
    }

    fn take_cell(&mut self, taken: &Cell, removed: &mut dyn FnMut(&Cell)) {
        let mut at = 0;
        let mut count = self.cells.len();
        while at < count {
            let cell = self.cells[at];
            if taken.to - cell.from <= THIN || cell.to - taken.from <= THIN {
                at += 1;
                continue;
            }
            let mut rest = Rest::default();
            if rest.without(&cell, taken, removed) {
                // The last cell that was not looked at takes its place; what is left need not be looked at.
                count -= 1;
                self.cells.swap(at, count);
                self.cells.swap_remove(count);
                self.cells.extend(rest.cells);
            } else {
                at += 1;
            }
        }
    }

    fn join_if_many(&mut self) {
        if self.cells.len() > MANY.max(2 * self.seen) {
            self.join();
        }
    }

    /// Puts cells in order and joins those that go on with each other.
    fn join(&mut self) {
        let middle = |cell: &Cell| cell.low.height(cell.from.midpoint(cell.to));
        self.cells.sort_by(|a, b| a.from.total_cmp(&b.from).then(middle(a).total_cmp(&middle(b))));
        let mut whole: Vec<Cell> = Vec::with_capacity(self.cells.len());
        for cell in &self.cells {
            // Only cells that end where this one begins can go on with it; they are among the last ones.
            match whole.iter_mut().rev().take(8).find(|last| last.goes_on(cell)) {
                Some(last) => last.to = cell.to,
                None => whole.push(*cell),
            }
        }
        self.cells = whole;
        self.seen = self.cells.len();
    }
}

/// Stretches in their order, those that touch as one.
fn joined(mut stretches: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    stretches.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut whole: Vec<[f64; 2]> = Vec::with_capacity(stretches.len());
    for [from, to] in stretches {
        match whole.last_mut() {
            Some(last) if from - last[1] <= 2.0 * THIN => last[1] = last[1].max(to),
            _ => whole.push([from, to]),
        }
    }
    whole
}

/// What is left of a cell.
#[derive(Default)]
struct Rest {
    cells: Vec<Cell>,
}

impl Rest {
    /// Leaves what of a cell does not belong to another one. Whether anything belongs to both.
    fn without(&mut self, cell: &Cell, taken: &Cell, removed: &mut dyn FnMut(&Cell)) -> bool {
        let from = if taken.from - cell.from > THIN { taken.from } else { cell.from };
        let to = if cell.to - taken.to > THIN { taken.to } else { cell.to };
        let mut places = [from; 12];
        let mut count = 1;
        for own in [&cell.low, &cell.high] {
            for other in [&taken.low, &taken.high] {
                for x in own.meets(other) {
                    if x - from > THIN && to - x > THIN && count < places.len() - 1 {
                        places[count] = x;
                        count += 1;
                    }
                }
            }
        }
        places[count] = to;
        let places = &mut places[..=count];
        places[1..count].sort_by(f64::total_cmp);
        let mut any = false;
        for pair in places.windows(2) {
            let &[a, b] = pair else { continue };
            if b <= a {
                continue;
            }
            let middle = a.midpoint(b);
            let [low, high] = [cell.low.height(middle), cell.high.height(middle)];
            let [from, to] = [taken.low.height(middle), taken.high.height(middle)];
            let (least, most) = (low.max(from), high.min(to));
            let within = |low, high| Cell { from: a, to: b, low, high };
            if most - least <= THIN {
                self.keep(within(cell.low, cell.high));
                continue;
            }
            any = true;
            let (under, over) = (from - low > THIN, high - to > THIN);
            if under {
                self.keep(within(cell.low, taken.low));
            }
            if over {
                self.keep(within(taken.high, cell.high));
            }
            removed(&within(
                if from > low { taken.low } else { cell.low },
                if to < high { taken.high } else { cell.high },
            ));
        }
        if any {
            if from > cell.from {
                self.keep(Cell { to: from, ..*cell });
            }
            if to < cell.to {
                self.keep(Cell { from: to, ..*cell });
            }
        }
        any
    }

    fn keep(&mut self, cell: Cell) {
        let before = |last: &&mut Cell| last.to == cell.from && last.low == cell.low && last.high == cell.high;
        match self.cells.iter_mut().rev().take(2).find(before) {
            Some(last) => last.to = cell.to,
            None => self.cells.push(cell),
        }
    }
}

/// What lies between closed lines, given as pieces in any order.
pub(super) fn between(pieces: &[Piece]) -> Vec<Cell> {
    let mut places: Vec<f64> = pieces.iter().flat_map(|piece| [piece.from, piece.to]).collect();
    places.sort_by(f64::total_cmp);
    // Of places that are nearly the same the first one counts.
    places.dedup_by(|next, kept| *next - *kept <= THIN);
    let mut cells: Vec<Cell> = Vec::with_capacity(places.len());
    let mut here: Vec<(f64, &Piece)> = Vec::with_capacity(4);
    for pair in places.windows(2) {
        let &[from, to] = pair else { continue };
        let middle = from.midpoint(to);
        here.clear();
        let spanning = pieces.iter().filter(|piece| piece.from <= middle && middle <= piece.to);
        here.extend(spanning.map(|piece| (piece.shape.height(middle), piece)));
        here.sort_by(|a, b| a.0.total_cmp(&b.0));
        for sides in here.chunks_exact(2) {
            let (low, high) = (sides[0].1.shape, sides[1].1.shape);
            if sides[1].0 - sides[0].0 <= THIN {
                continue;
            }
            match cells.iter_mut().rev().take(2).find(|last| last.to == from && last.low == low && last.high == high) {
                Some(last) => last.to = to,
                None => cells.push(Cell { from, to, low, high }),
            }
        }
    }
    cells
}

/// Adds edges one after another.
fn around(start: DVec2, edges: &[Edge], pieces: &mut Vec<Piece>) {
    let mut at = start;
    for edge in edges {
        match *edge {
            Edge::Line(to) => line(at, to, pieces),
            Edge::Arc { centre, sweep, .. } => {
                let arm = at - centre;
                arc(centre, arm.length(), [atan2d(arm.y, arm.x), sweep], pieces);
            }
        }
        at = edge.to();
    }
}

/// Adds a line; what goes straight up or down bounds cells by its place.
pub(super) fn line(from: DVec2, to: DVec2, pieces: &mut Vec<Piece>) {
    let way = to - from;
    if way.x.abs() <= THIN {
        return;
    }
    // The end that is known more exactly.
    let through = if from.abs().max_element() <= to.abs().max_element() { from } else { to };
    let shape = Shape::Line { through, slope: way.y / way.x };
    pieces.push(Piece { from: from.x.min(to.x), to: from.x.max(to.x), shape });
}

/// Adds an arc from an angle over a sweep, degrees, in pieces of the upper and the lower half of its circle.
pub(super) fn arc(centre: DVec2, radius: f64, [begin, sweep]: [f64; 2], pieces: &mut Vec<Piece>) {
    if radius <= THIN {
        return;
    }
    let (low, high) = (begin.min(begin + sweep), begin.max(begin + sweep));
    let mut at = low;
    while high - at > THIN {
        let half = libm::floor(at / 180.0 + 1e-12);
        let end = ((half + 1.0) * 180.0).min(high);
        let (a, b) = (centre.x + radius * cosd(at), centre.x + radius * cosd(end));
        let upper = half.rem_euclid(2.0) == 0.0;
        if (b - a).abs() > THIN {
            pieces.push(Piece { from: a.min(b), to: a.max(b), shape: Shape::Arc { centre, radius, upper } });
        }
        at = end;
    }
}
