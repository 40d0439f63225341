//! A model of its own of what a flat tool cuts: a field of heights, and for each short piece of the way where beside the
//! path material is taken away.
//!
//! Invariant: nothing of the engine's stock is used; coordinates are those of the working plane (main axis,
//! secondary axis, height).
use ciklo::engine::geometry::WorkingPlane;
use ciklo::engine::solid::Path;
use glam::{DVec2, DVec3};

/// Size of a cell, mm.
const CELL: f64 = 0.6;
/// Longest piece of the way, mm.
const PIECE: f64 = 0.6;
/// Cells that lie by less than this at the rim of the tool do not tell how wide a cut is: arcs are followed on chords.
const RIM: f64 = 0.08;
/// Height, mm, that does not count.
const FLAT: f64 = 1e-3;

/// A move of the tool as the engine told it.
#[derive(Clone, Debug)]
pub(super) struct Move {
    pub(super) path: Path,
    /// mm/min.
    pub(super) feed: f64,
    pub(super) rapid: bool,
}

/// What a short piece of the way cut.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    /// The feed of the move; infinity for rapid traverse.
    pub(super) feed: f64,
    /// The middle of the piece and its direction, as seen along the tool axis.
    pub(super) at: DVec2,
    pub(super) heading: DVec2,
    /// Way over ground.
    pub(super) length: f64,
    /// Radius of the path; infinity on a line.
    pub(super) bend: f64,
    /// The turn from the piece before, radians.
    pub(super) turn: f64,
    /// The greatest height that was cut.
    pub(super) depth: f64,
    /// What was cut: least and greatest distance to the left of the path, if there was anything.
    pub(super) left: Option<[f64; 2]>,
}

impl Piece {
    /// The extent of the cut across the path.
    pub(super) fn width(&self) -> f64 {
        self.left.map_or(0.0, |[low, high]| high - low)
    }

    /// The middle of the cut, to the left of the path.
    pub(super) fn side(&self) -> f64 {
        self.left.map_or(0.0, |[low, high]| (low + high) / 2.0)
    }
}

/// Heights of the material over a square.
struct Field {
    half: DVec2,
    count: [usize; 2],
    tops: Vec<f64>,
}

impl Field {
    fn place(&self, column: usize, row: usize) -> DVec2 {
        // A little beside round numbers, so that no rim runs along a row.
        DVec2::new(column as f64 + 0.4871, row as f64 + 0.5173) * CELL - self.half
    }

    fn range(&self, axis: usize, low: f64, high: f64) -> std::ops::Range<usize> {
        let index = |value: f64| ((value + self.half[axis]) / CELL).max(0.0) as usize;
        index(low).saturating_sub(1)..(index(high) + 2).min(self.count[axis])
    }

    /// A tool of that radius goes straight from one point to another: the greatest height taken, and the places.
    fn cut(&mut self, from: DVec3, to: DVec3, radius: f64) -> (f64, Vec<DVec2>) {
        let (a, b, floor) = (from.truncate(), to.truncate(), from.z.min(to.z));
        let (low, high) = (a.min(b) - DVec2::splat(radius), a.max(b) + DVec2::splat(radius));
        let way = b - a;
        let (mut deepest, mut places) = (0.0_f64, Vec::new());
        for row in self.range(1, low.y, high.y) {
            for column in self.range(0, low.x, high.x) {
                let top = self.tops[row * self.count[0] + column];
                if top <= floor {
                    continue;
                }
                let place = self.place(column, row);
                let share = if way == DVec2::ZERO { 0.0 } else { (place - a).dot(way) / way.length_squared() };
                let far = (place - a - way * share.clamp(0.0, 1.0)).length();
                if far > radius {
                    continue;
                }
                self.tops[row * self.count[0] + column] = floor;
                if far < radius - RIM && top - floor > FLAT {
                    deepest = deepest.max(top - floor);
                    places.push(place);
                }
            }
        }
        (deepest, places)
    }
}

/// Follows the moves through a block whose extent is `half` to all sides, or a cylinder, whose top is at `surface`.
pub(super) fn follow(
    moves: &[Move],
    plane: WorkingPlane,
    radius: f64,
    (half, round): (DVec2, bool),
    surface: f64,
) -> Vec<Piece> {
    let count = [0, 1].map(|axis| (2.0 * half[axis] / CELL).ceil() as usize);
    let mut field = Field { half, count, tops: vec![surface; count[0] * count[1]] };
    for row in 0..count[1] {
        for column in 0..count[0] {
            let place = field.place(column, row);
            if if round { place.length() > half.x } else { (place.abs() - half).max_element() > 0.0 } {
                field.tops[row * count[0] + column] = f64::NEG_INFINITY;
            }
        }
    }
    let seen = |p: DVec3| plane.flat(p).extend(plane.tool.of(p));
    let mut pieces: Vec<Piece> = Vec::new();
    for Move { path, feed, rapid, .. } in moves {
        let bend = match path {
            Path::Line { .. } => f64::INFINITY,
            Path::Arc { centre, from, .. } => (seen(*from) - seen(*centre)).truncate().length(),
        };
        let whole = path.length();
        // Chords of small arcs turn by at most a twentieth of a turn.
        let count = (whole / PIECE.min(bend * 0.3)).ceil().max(1.0) as usize;
        for n in 0..count {
            let at = |n: usize| seen(path.at(n as f64 / count as f64));
            let (from, to) = (at(n), at(n + 1));
            let way = (to - from).truncate();
            let (depth, places) = field.cut(from, to, radius);
            let heading = way.normalize_or_zero();
            let before = pieces.iter().rev().find(|piece| piece.length > 0.0).map_or(heading, |piece| piece.heading);
            let turn = if heading == DVec2::ZERO { 0.0 } else { before.angle_to(heading).abs() };
            let middle = (from + to) / 2.0;
            let left = places.iter().map(|place| heading.perp_dot(*place - middle.truncate()));
            let left = left.fold(None, |sides: Option<[f64; 2]>, v| {
                Some(sides.map_or([v, v], |[low, high]| [low.min(v), high.max(v)]))
            });
            pieces.push(Piece {
                feed: if *rapid { f64::INFINITY } else { *feed },
                at: middle.truncate(),
                heading,
                length: if way.length() < 1e-9 { 0.0 } else { way.length() },
                bend,
                turn,
                depth,
                left: left.filter(|_| way.length() > 1e-9),
            });
        }
    }
    pieces
}

/// How wide a cut may be at a piece of the way, if laps lie `step` beside each other: wider where the path is bent or
/// has a corner within reach of the tool, as the material beyond is met from the front, and widest where laps are short.
pub(super) fn widest(pieces: &[Piece], index: usize, radius: f64, step: f64) -> f64 {
    // A corner of a right angle meets the strip beyond it with its front, and the strip beside it as before.
    let corner = if step < radius { radius + (2.0 * radius * step - step * step).sqrt() } else { 2.0 * radius };
    // On a bend that is concave the strip reaches from the outermost place of the tool to where its rim crosses what the
    // lap before has left.
    let bent = |bend: f64| {
        let left = bend - step + radius;
        let cos = (left * left - bend * bend - radius * radius) / (2.0 * bend * radius);
        if left <= 0.0 { 2.0 * radius } else { radius - radius * cos.clamp(-1.0, 1.0) }
    };
    // Whichever way the tool goes within such a bend, what it meets lies outside the circle that the lap before has left, at
    // `left` from the centre of the bend. That part of the tool is widest where the tool is farthest out, on the bend:
    // between the two points in which both circles cross or, if these lie behind its middle, as wide as the tool.
    let front = |bend: f64| {
        let left = bend - step + radius;
        let along = (bend * bend + left * left - radius * radius) / (2.0 * bend);
        if left <= 0.0 || along <= bend { 2.0 * radius } else { 2.0 * (left * left - along * along).max(0.0).sqrt() }
    };
    let mut allowed = step;
    let (mut sharp, mut narrowest) = (false, f64::INFINITY);
    let mut look = |indices: &mut dyn Iterator<Item = usize>| {
        let mut way = 0.0;
        for n in indices {
            let piece = &pieces[n];
            if piece.length == 0.0 || piece.turn.to_degrees() > 25.0 {
                allowed = allowed.max(corner);
                sharp = true;
            }
            if piece.bend.is_finite() {
                narrowest = narrowest.min(piece.bend);
                allowed = allowed.max(bent(piece.bend).min(corner));
            }
            way += piece.length;
            if way > 2.0 * radius + step {
                break;
            }
        }
    };
    look(&mut (0..=index).rev());
    look(&mut (index + 1..pieces.len()));
    // Where the tool turns sharply, it goes straight towards a wall that is bent.
    let allowed = if sharp && narrowest.is_finite() { allowed.max(front(narrowest)) } else { allowed };
    match short_lap(pieces, index, step) {
        // The lap before ends in the circle around its start before it has left a straight edge: the step sideways cuts from
        // its front to where that circle and the tool, `lap` and `step` away from it, cross.
        Some(lap) if step < radius && lap < (2.0 * radius * step - step * step).sqrt() => {
            let apart = lap.hypot(step);
            let half = (radius * radius - apart * apart / 4.0).max(0.0).sqrt();
            allowed.max(radius + (lap / 2.0 + half * step / apart).min(radius))
        }
        _ => allowed,
    }
}

/// The length of the lap before the step sideways on which a piece lies, if the step before that lap has been made too: both
/// between corners.
fn short_lap(pieces: &[Piece], index: usize, step: f64) -> Option<f64> {
    let mut legs = [0.0; 2];
    let mut corners = 0;
    for piece in pieces[..=index].iter().rev() {
        if (1..=2).contains(&corners) {
            legs[corners - 1] += piece.length;
        }
        if piece.length == 0.0 || piece.bend.is_finite() {
            return None;
        }
        if piece.turn.to_degrees() > 25.0 {
            corners += 1;
        }
        if corners == 3 {
            return (legs[1] < step + 1e-6).then_some(legs[0]);
        }
    }
    None
}
