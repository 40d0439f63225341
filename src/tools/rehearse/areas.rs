//! The pockets and slots that a program mills, as the ways of their tools in the plane.
//!
//! Invariant: an area is where the tool was, as far as that is remembered: never more than what was milled.
use glam::DVec2;

use super::body::SAME;
use crate::spec::CycleKey;

/// So many pieces of the way of one pocket are remembered.
pub(super) const MOST_PIECES: usize = 1 << 9;
/// A straight piece of the way of the tool in the plane.
pub(super) type Piece = [DVec2; 2];

/// A pocket or slot that was milled.
pub(super) struct Area {
    /// The tool call that it was made after, and the cycle.
    pub(super) made: (u32, CycleKey),
    pub(super) way: Vec<Piece>,
    /// How long that is, which is the same for all that one definition makes.
    pub(super) long: f64,
    pub(super) low: DVec2,
    pub(super) high: DVec2,
    pub(super) radius: f64,
    pub(super) bottom: f64,
}

impl Area {
    pub(super) fn middle(&self) -> DVec2 {
        (self.low + self.high) / 2.0
    }

    /// How far a place is from the way.
    pub(super) fn distance(&self, place: DVec2) -> f64 {
        self.way.iter().map(|piece| from_place(*piece, place)).fold(f64::INFINITY, f64::min)
    }

    /// How much of the way lies in another area, at least so far inside of it.
    pub(super) fn share_within(&self, other: &Self, skin: f64) -> f64 {
        /// So far apart the places are that are looked at, mm, and so many a piece has at most.
        const STEP: f64 = 1.0;
        const MOST: f64 = 256.0;
        let places: Vec<DVec2> = self
            .way
            .iter()
            .flat_map(|[from, to]| {
                let count = ((*to - *from).length() / STEP).ceil().clamp(1.0, MOST);
                (0..=count as usize).map(move |at| from.lerp(*to, at as f64 / count))
            })
            .collect();
        let inside = places.iter().filter(|place| other.distance(**place) < other.radius - skin).count();
        inside as f64 / places.len().max(1) as f64
    }

    /// Whether the ways of two areas come nearer to each other than so much.
    pub(super) fn comes_within(&self, other: &Self, reach: f64) -> bool {
        let apart = (self.low - other.high).max(other.low - self.high).max_element();
        apart < reach && self.way.iter().any(|one| other.way.iter().any(|own| between(*one, *own) < reach))
    }
}

/// Straight pieces of a movement whose places are known: one if they lie on a line.
pub(super) fn pieces(places: &[DVec2]) -> Vec<Piece> {
    let (Some(first), Some(last)) = (places.first(), places.last()) else { return Vec::new() };
    if places.iter().all(|place| from_place([*first, *last], *place) <= SAME) {
        return vec![[*first, *last]];
    }
    places.windows(2).filter_map(|pair| pair.try_into().ok()).collect()
}

pub(super) fn from_place([one, other]: Piece, place: DVec2) -> f64 {
    let way = other - one;
    let long = way.length_squared();
    let share = if long > 0.0 { ((place - one).dot(way) / long).clamp(0.0, 1.0) } else { 0.0 };
    (place - one - way * share).length()
}

/// How far two pieces are from each other; 0 if they cross.
fn between(one: Piece, other: Piece) -> f64 {
    let turn = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    let ([a, b], [c, d]) = (one, other);
    if turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0 {
        return 0.0;
    }
    let ends = [from_place(one, c), from_place(one, d), from_place(other, a), from_place(other, b)];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}
