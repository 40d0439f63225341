//! Profiles of turned parts, and where the nose of an insert may be above them.
//!
//! A profile is a way over the half plane as a cut sees it: `x` grows in the direction of the feed, `y` away from the
//! part. The [`Envelope`] is the lowest place of the tip of an insert that touches the profile, and no other part of it,
//! at every `x`. Invariant: lines and arcs stay lines and arcs; nothing is approximated by points.
use glam::DVec2;

use super::{Edge, Way};
use crate::base::expr::{atan2d, cosd, sind};

/// Differences below this are none, mm.
const SAME: f64 = 1e-9;
/// The edges of an insert are so long, mm.
const EDGE: f64 = 10_000.0;
/// What is less of an arc, degrees, does not turn it back.
const TURNS_BACK: f64 = 1e-6;
/// What is steeper has no height at a place: it is a wall.
const STEEP: f64 = 1e-7;

/// An insert, as a cut sees it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Insert {
    /// The radius of its nose, mm.
    pub radius: f64,
    /// The directions of its two edges from the nose, counted from the direction of the feed towards the side away from
    /// the part, degrees: the one in front and the one at the back. Without them only the nose is known.
    pub edges: Option<(f64, f64)>,
}

/// A line or an arc over a range of `x`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shape {
    Line { through: DVec2, slope: f64 },
    Arc { centre: DVec2, radius: f64, upper: bool },
}

/// A shape between two places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Piece {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) shape: Shape,
}

/// Places at which two shapes may meet: none, one or two.
pub(super) type Places = std::iter::Take<std::array::IntoIter<f64, 2>>;

fn places(at: [f64; 2], count: usize) -> Places {
    at.into_iter().take(count)
}

impl Shape {
    pub(super) fn height(&self, x: f64) -> f64 {
        match *self {
            Self::Line { through, slope } => through.y + (x - through.x) * slope,
            Self::Arc { centre, radius, upper } => {
                let rise = libm::sqrt((radius * radius - (x - centre.x) * (x - centre.x)).max(0.0));
                centre.y + if upper { rise } else { -rise }
            }
        }
    }

    /// Whether all of it between two places is not higher than a level, or all of it is; nothing if neither is plain.
    fn is_below(&self, level: f64, from: f64, to: f64) -> Option<bool> {
        let (low, high) = match *self {
            Self::Line { through, slope } => {
                let ends = [from, to].map(|x| through.y + (x - through.x) * slope);
                (ends[0].min(ends[1]), ends[0].max(ends[1]))
            }
            Self::Arc { centre, radius, upper: true } => (centre.y, centre.y + radius),
            Self::Arc { centre, radius, upper: false } => (centre.y - radius, centre.y),
        };
        (low > level || high <= level).then_some(high <= level)
    }

    fn moved(self, by: DVec2) -> Self {
        match self {
            Self::Line { through, slope } => Self::Line { through: through + by, slope },
            Self::Arc { centre, radius, upper } => Self::Arc { centre: centre + by, radius, upper },
        }
    }

    /// Where it may have the height of a line.
    fn meets_line(&self, through: DVec2, slope: f64) -> Places {
        match *self {
            Self::Line { through: own, slope: steep } => {
                let apart = steep - slope;
                if apart.abs() < SAME {
                    return places([0.0; 2], 0);
                }
                places([(through.y - own.y + steep * own.x - slope * through.x) / apart; 2], 1)
            }
            Self::Arc { centre, radius, .. } => {
                // The distance of the centre from the line, and half of the chord.
                let length = libm::sqrt(1.0 + slope * slope);
                let off = (through.y + slope * (centre.x - through.x) - centre.y) / length;
                let half = radius * radius - off * off;
                // A line that touches the arc but for rounding meets it there.
                if half < -2.0 * SAME * radius {
                    return places([0.0; 2], 0);
                }
                let (half, foot) = (libm::sqrt(half.max(0.0)), centre.x - off * slope / length);
                places([foot - half / length, foot + half / length], 2)
            }
        }
    }

    /// Where the two may have the same height.
    pub(super) fn meets(&self, other: &Self) -> Places {
        match (*self, *other) {
            (Self::Line { through, slope }, _) => other.meets_line(through, slope),
            (_, Self::Line { through, slope }) => self.meets_line(through, slope),
            (Self::Arc { centre: a, radius: ra, .. }, Self::Arc { centre: b, radius: rb, .. }) => {
                let (way, apart) = (b - a, a.distance(b));
                if apart < SAME || apart > ra + rb + SAME || apart < (ra - rb).abs() - SAME {
                    return places([0.0; 2], 0);
                }
                let along = (apart * apart + ra * ra - rb * rb) / (2.0 * apart);
                let half = libm::sqrt((ra * ra - along * along).max(0.0));
                let (foot, across) = (a + way * (along / apart), way.perp() * (half / apart));
                places([foot.x + across.x, foot.x - across.x], 2)
            }
        }
    }

    /// The edge from one place to another further in the direction of `x`.
    pub(super) fn edge(&self, from: f64, to: f64) -> Edge {
        let end = DVec2::new(to, self.height(to));
        match *self {
            Self::Line { .. } => Edge::Line(end),
            Self::Arc { centre, .. } => {
                let (a, b) = (DVec2::new(from, self.height(from)) - centre, end - centre);
                Edge::Arc { to: end, centre, sweep: atan2d(a.perp_dot(b), a.dot(b)) }
            }
        }
    }
}

/// What an insert must not go below: the heights of its tip over a profile.
#[derive(Clone, Debug, Default)]
pub struct Envelope {
    pieces: Vec<Piece>,
}

/// A profile that gets an allowance: so much along the feed on either side, and so much away from the part, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Allowance {
    /// Along the feed.
    pub along: f64,
    /// Away from the part.
    pub away: f64,
}

/// A profile cannot be cut in one direction: it goes back where it begins or ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GoesBack;

impl Envelope {
    /// The heights of the tip of an insert over a profile with an allowance. The tip is `tip` nose radii from the
    /// centre of the nose, by axis.
    ///
    /// Where the profile goes back, what lies under it is covered: the tip cannot come there from the side that is away
    /// from the part.
    ///
    /// # Errors
    /// The profile goes back where it begins or ends.
    pub fn over(profile: &Way, allowance: Allowance, insert: Insert, tip: DVec2) -> Result<Self, GoesBack> {
        let mut pieces = Vec::new();
        let along = allowance.along.abs();
        let profile = &monotone(profile);
        let (Some(first), Some(last)) = (profile.edges.first(), profile.edges.last()) else { return Err(GoesBack) };
        let before_last = profile.edges.iter().rev().nth(1).map_or(profile.start, Edge::to);
        if first.to().x < profile.start.x - STEEP || last.to().x < before_last.x - STEEP {
            return Err(GoesBack);
        }
        for side in if along > SAME { &[-1.0, 1.0][..] } else { &[1.0][..] } {
            let by = DVec2::new(along * side, allowance.away);
            above(profile, insert, by, along, &mut pieces);
        }
        let by = tip * insert.radius;
        for piece in &mut pieces {
            *piece = Piece { from: piece.from + by.x, to: piece.to + by.x, shape: piece.shape.moved(by) };
        }
        uncovered(&mut pieces);
        Ok(Self { pieces: highest(&pieces) })
    }

    /// The higher of two at every place.
    pub fn higher(&self, other: &Self) -> Self {
        Self { pieces: highest(&[self.pieces.as_slice(), &other.pieces].concat()) }
    }

    /// Places on each of its pieces: near both ends, and in the middle.
    pub(super) fn places(&self) -> Vec<f64> {
        let places = self.pieces.iter().flat_map(|piece| {
            let near = (piece.to - piece.from).min(1.0) * 1e-3;
            [piece.from + near, piece.from.midpoint(piece.to), piece.to - near]
        });
        places.collect()
    }

    /// The lowest height at a place; nothing where there is no part.
    pub fn height(&self, x: f64) -> Option<f64> {
        // They are in order and do not overlap.
        let first = self.pieces.partition_point(|piece| piece.to + SAME < x);
        let here = self.pieces.iter().skip(first).take_while(|piece| piece.from - SAME <= x);
        here.map(|piece| piece.shape.height(x.clamp(piece.from, piece.to))).reduce(f64::max)
    }

    /// Where it is not higher than a level, between two places: pairs of beginning and end in their order.
    pub fn below(&self, level: f64, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
        let first = self.pieces.partition_point(|piece| piece.to < from);
        let mut found: Vec<[f64; 2]> = Vec::new();
        let mut free = |a: f64, b: f64| match found.last_mut() {
            _ if b - a <= SAME => {}
            Some(last) if a - last[1] <= SAME => last[1] = b,
            _ => found.push([a, b]),
        };
        let mut at = from;
        for piece in self.pieces.iter().skip(first).take_while(|piece| piece.from <= to) {
            let (begin, end) = (piece.from.max(from), piece.to.min(to));
            // What is between two pieces by rounding alone is as high as they are.
            if begin - at > SAME && self.height(at.midpoint(begin)).is_none_or(|height| height <= level + SAME) {
                free(at, begin);
            }
            at = begin;
            if let Some(is_free) = piece.shape.is_below(level + SAME, begin, end) {
                if is_free {
                    free(begin, end);
                }
                at = end;
                continue;
            }
            // An arc whose lowest place is just above the level meets it nowhere, and is not free on either side of it.
            let turn = match piece.shape {
                Shape::Arc { centre, upper: false, .. } => Some(centre.x),
                _ => None,
            };
            for x in piece.shape.meets_line(DVec2::new(0.0, level), 0.0).chain(turn).chain([end]) {
                if at <= x && x <= end {
                    if piece.shape.height(at.midpoint(x)) <= level + SAME {
                        free(at, x);
                    }
                    at = x;
                }
            }
        }
        if to - at > SAME && self.height(at.midpoint(to)).is_none_or(|height| height <= level + SAME) {
            free(at, to);
        }
        found
    }

    /// The highest place between two places, the last one of several, with its height.
    pub fn summit(&self, [from, to]: [f64; 2]) -> Option<DVec2> {
        let mut best: Option<DVec2> = None;
        for piece in self.pieces.iter().filter(|piece| piece.to >= from && piece.from < to - SAME) {
            let (a, b) = (piece.from.max(from), piece.to.min(to));
            let top = match piece.shape {
                Shape::Arc { centre, .. } => centre.x.clamp(a, b),
                Shape::Line { .. } => b,
            };
            for x in [a, top, b] {
                let point = DVec2::new(x, piece.shape.height(x));
                if best.is_none_or(|best| point.y >= best.y - SAME) {
                    best = Some(point);
                }
            }
        }
        best
    }

    /// The same, and nowhere lower than a level.
    #[must_use]
    pub fn raised(&self, level: f64) -> Self {
        let (from, to) =
            (self.pieces.first().map_or(0.0, |piece| piece.from), self.pieces.last().map_or(0.0, |piece| piece.to));
        let floor = Piece { from, to, shape: Shape::Line { through: DVec2::new(from, level), slope: 0.0 } };
        let mut pieces = self.pieces.clone();
        pieces.push(floor);
        Self { pieces: highest(&pieces) }
    }

    /// The lowest height between two places.
    pub fn lowest(&self, range: [f64; 2]) -> Option<f64> {
        self.lowest_place(range).map(|place| place.y)
    }

    /// The lowest place between two places, the first one of several, with its height.
    pub fn lowest_place(&self, [from, to]: [f64; 2]) -> Option<DVec2> {
        let mut least: Option<DVec2> = None;
        for piece in self.pieces.iter().filter(|piece| piece.to > from && piece.from < to) {
            let (a, b) = (piece.from.max(from), piece.to.min(to));
            let low = match piece.shape {
                Shape::Arc { centre, upper: false, .. } => centre.x.clamp(a, b),
                _ => a,
            };
            for x in [a, low, b] {
                let here = DVec2::new(x, piece.shape.height(x));
                if least.is_none_or(|least| here.y < least.y) {
                    least = Some(here);
                }
            }
        }
        least
    }

    /// The way along it between two of its points, which may be on walls.
    pub fn way(&self, from: DVec2, to: DVec2) -> Way {
        if from.x > to.x + SAME {
            return self.way(to, from).reversed();
        }
        let (mut at, mut edges) = (from, Vec::new());
        for piece in &self.pieces {
            let (a, b) = (piece.from.max(from.x), piece.to.min(to.x));
            if b - a <= SAME {
                continue;
            }
            let start = DVec2::new(a, piece.shape.height(a));
            if start.distance(at) > SAME {
                edges.push(Edge::Line(start));
            }
            let edge = piece.shape.edge(a, b);
            at = edge.to();
            edges.push(edge);
        }
        if at.distance(to) > SAME {
            edges.push(Edge::Line(to));
        }
        Way { start: from, edges: straightened(from, edges) }
    }

    /// Where it is higher than another one and than a level, by more than a margin, between two places: pairs of beginning
    /// and end in their order.
    pub fn higher_than(&self, other: &Self, level: f64, margin: f64, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
        let mut places = vec![from, to];
        let first = other.pieces.partition_point(|piece| piece.to < from);
        let others = || other.pieces.iter().skip(first).take_while(|piece| piece.from <= to);
        places.extend(others().flat_map(|piece| [piece.from, piece.to]));
        let first = self.pieces.partition_point(|piece| piece.to < from);
        for piece in self.pieces.iter().skip(first).take_while(|piece| piece.from <= to) {
            places.extend([piece.from, piece.to]);
            places.extend(piece.shape.meets_line(DVec2::new(0.0, level + margin), 0.0));
            let under = others().filter(|own| own.from <= piece.to && own.to >= piece.from);
            places.extend(under.flat_map(|own| own.shape.moved(DVec2::Y * margin).meets(&piece.shape)));
        }
        places.retain(|x| (from..=to).contains(x));
        places.sort_by(f64::total_cmp);
        let mut found: Vec<[f64; 2]> = Vec::new();
        let mut begin = from;
        for b in places {
            if b - begin <= SAME {
                continue;
            }
            let a = std::mem::replace(&mut begin, b);
            let middle = a.midpoint(b);
            let least = other.height(middle).map_or(level, |height| height.max(level));
            if self.height(middle).is_none_or(|height| height <= least + margin) {
                continue;
            }
            match found.last_mut() {
                Some(last) if a - last[1] <= SAME => last[1] = b,
                _ => found.push([a, b]),
            }
        }
        found
    }

    /// By how much it is higher than another one between two places, at the most.
    pub fn above(&self, other: &Self, [from, to]: [f64; 2]) -> f64 {
        let places = self.pieces.iter().chain(&other.pieces).flat_map(|piece| {
            let near = (piece.to - piece.from).min(1.0) * 1e-3;
            [piece.from + near, piece.from.midpoint(piece.to), piece.to - near]
        });
        let places = places.filter(|x| (from..=to).contains(x));
        let more = |x: f64| Some(self.height(x)? - other.height(x)?);
        places.filter_map(more).fold(0.0, f64::max)
    }
}

/// The same edges, with lines that go on straight as one.
fn straightened(from: DVec2, edges: Vec<Edge>) -> Vec<Edge> {
    let mut whole: Vec<Edge> = Vec::with_capacity(edges.len());
    // Where the last line begins, and where the last edge ends.
    let (mut begin, mut at) = (from, from);
    for edge in edges {
        let (before, after) = (at - begin, edge.to() - at);
        match (whole.last_mut(), edge) {
            (Some(Edge::Line(last)), Edge::Line(to))
                if before.perp_dot(after).abs() <= SAME * before.length() && before.dot(after) > 0.0 =>
            {
                *last = to;
            }
            _ => {
                begin = at;
                whole.push(edge);
            }
        }
        at = edge.to();
    }
    whole
}

/// The pieces that the centre of the nose must stay above, of a profile moved by so much.
fn above(profile: &Way, insert: Insert, by: DVec2, along: f64, pieces: &mut Vec<Piece>) {
    let radius = insert.radius;
    let mut at = profile.start + by;
    let ends = profile.edges.iter().map(|edge| edge.to().x);
    let ends = ends.fold([profile.start.x; 2], |[least, most], x| [least.min(x), most.max(x)]);
    let ends = [ends[0] - along - radius, ends[1] + along + radius];
    corner(at, insert, (along, by.x), ends, pieces);
    for edge in &profile.edges {
        let end = edge.to() + by;
        match *edge {
            Edge::Line(_) => {
                let way = end - at;
                if way.x > STEEP {
                    let shift = DVec2::new(-way.y, way.x) * (radius / way.length());
                    let through = at + shift;
                    let shape = Shape::Line { through, slope: way.y / way.x };
                    pieces.push(Piece { from: through.x, to: end.x + shift.x, shape });
                }
            }
            Edge::Arc { centre, sweep, .. } => {
                let centre = centre + by;
                // What goes back is covered by what comes forward above it.
                if end.x >= at.x {
                    arc((at, end), (centre, sweep), insert, ends, pieces);
                }
            }
        }
        corner(end, insert, (along, by.x), ends, pieces);
        at = end;
    }
}

/// The same way with arcs divided where they turn back.
pub fn monotone(way: &Way) -> Way {
    let (mut at, mut edges) = (way.start, Vec::with_capacity(way.edges.len()));
    for edge in &way.edges {
        if let Edge::Arc { to, centre, sweep } = *edge {
            let arm = at - centre;
            let (from, radius) = (atan2d(arm.y, arm.x), arm.length());
            // The angles from the beginning to the sides of the circle.
            let mut turns: Vec<(f64, f64)> = [0.0, 180.0, 360.0, 540.0]
                .map(|side| ((side - from) * sweep.signum()).rem_euclid(360.0))
                .into_iter()
                .zip([1.0, -1.0, 1.0, -1.0])
                .flat_map(|(angle, side)| [(angle, side), (angle + 360.0, side)])
                .filter(|(angle, _)| *angle > TURNS_BACK && *angle < sweep.abs() - TURNS_BACK)
                .collect();
            turns.sort_by(|a, b| a.0.total_cmp(&b.0));
            turns.dedup_by(|a, b| a.0 - b.0 < TURNS_BACK);
            let mut gone = 0.0;
            for (angle, side) in turns {
                let to = centre + DVec2::new(side * radius, 0.0);
                edges.push(Edge::Arc { to, centre, sweep: (angle - gone) * sweep.signum() });
                gone = angle;
            }
            edges.push(Edge::Arc { to, centre, sweep: (sweep.abs() - gone) * sweep.signum() });
        } else {
            edges.push(*edge);
        }
        at = edge.to();
    }
    Way { start: way.start, edges }
}

/// An arc: beside it is another one, unless the nose does not find room in it.
fn arc(
    (from, to): (DVec2, DVec2),
    (centre, sweep): (DVec2, f64),
    insert: Insert,
    ends: [f64; 2],
    pieces: &mut Vec<Piece>,
) {
    let (own, upper) = (from.distance(centre), sweep < 0.0);
    let side = if upper { 1.0 } else { -1.0 };
    let radius = own + insert.radius * side;
    if radius > SAME {
        let place = |point: DVec2| centre.x + (point.x - centre.x) * (radius / own);
        pieces.push(Piece { from: place(from), to: place(to), shape: Shape::Arc { centre, radius, upper } });
    }
    if upper {
        for (normal, direction) in leaning(insert) {
            let touched = centre.x + own * normal.x;
            if (from.x..=to.x).contains(&touched) {
                pieces.push(ray(centre + normal * radius, direction, ends));
            }
        }
    }
}

/// A corner of the profile: the nose goes round it, and the edges of the insert lean against it.
fn corner(at: DVec2, insert: Insert, (along, moved): (f64, f64), ends: [f64; 2], pieces: &mut Vec<Piece>) {
    let radius = insert.radius;
    if radius > SAME {
        let shape = Shape::Arc { centre: at, radius, upper: true };
        pieces.push(Piece { from: at.x - radius, to: at.x + radius, shape });
    }
    // Between the two places of a corner with an allowance along the feed.
    if along > SAME && moved < 0.0 {
        let through = at + DVec2::new(0.0, radius);
        pieces.push(Piece { from: at.x, to: at.x + 2.0 * along, shape: Shape::Line { through, slope: 0.0 } });
    }
    for (normal, direction) in leaning(insert) {
        pieces.push(ray(at + normal * radius, direction, ends));
    }
}

/// The edges that can lean against something: the direction from the part to the edge, and that in which it goes down.
fn leaning(insert: Insert) -> impl Iterator<Item = (DVec2, DVec2)> {
    let (front, back) = insert.edges.unwrap_or((90.0, 90.0));
    // The part is below: an edge leans where it goes up in front of the nose, or behind it.
    let front = (front < 90.0 - STEEP).then(|| {
        let along = DVec2::new(cosd(front), sind(front));
        (along.perp(), -along)
    });
    let back = (back > 90.0 + STEEP).then(|| {
        let along = DVec2::new(cosd(back), sind(back));
        (-along.perp(), -along)
    });
    front.into_iter().chain(back)
}

/// The line down from where an edge touches, beyond the ends of the profile.
fn ray(through: DVec2, down: DVec2, ends: [f64; 2]) -> Piece {
    let shape = Shape::Line { through, slope: down.y / down.x };
    // Parallel ones end at the same place, so that those that are lower are under the others altogether.
    let far = ends[usize::from(down.x > 0.0)] + EDGE * down.x;
    Piece { from: through.x.min(far), to: through.x.max(far), shape }
}

/// The same without lines that are lower all along than a parallel one.
fn uncovered(pieces: &mut Vec<Piece>) {
    let line = |piece: &Piece| match piece.shape {
        Shape::Line { through, slope } => Some((*piece, through, slope)),
        Shape::Arc { .. } => None,
    };
    let lines: Vec<(Piece, DVec2, f64)> = pieces.iter().filter_map(line).collect();
    pieces.retain(|piece| {
        let Some((_, through, slope)) = line(piece) else { return true };
        // A steep line is as far under another one as it is beside it.
        let margin = SAME * (1.0 + slope.abs());
        !lines.iter().any(|(other, _, steep)| {
            let is_wider = other.from <= piece.from && piece.to <= other.to;
            *steep == slope && is_wider && other.shape.height(through.x) > through.y + margin
        })
    });
}

/// The highest of the pieces at every place.
pub(super) fn highest(pieces: &[Piece]) -> Vec<Piece> {
    let mut places: Vec<f64> = pieces.iter().flat_map(|piece| [piece.from, piece.to]).collect();
    for (index, one) in pieces.iter().enumerate() {
        for other in pieces.iter().skip(index + 1) {
            let (from, to) = (one.from.max(other.from), one.to.min(other.to));
            if from < to {
                let found = one.shape.meets(&other.shape);
                places.extend(found.filter(|x| (from..=to).contains(x)));
            }
        }
    }
    places.sort_unstable_by(f64::total_cmp);
    let mut found: Vec<Piece> = Vec::new();
    // Those that reach the place, in their order; the next ones by where they begin.
    let mut waiting: Vec<usize> = (0..pieces.len()).collect();
    waiting.sort_by(|a, b| pieces[*b].from.total_cmp(&pieces[*a].from));
    let mut here: Vec<usize> = Vec::with_capacity(pieces.len());
    let mut begin = places.first().copied().unwrap_or_default();
    for to in places {
        // Several places that are nearly the same are one: what is between them stays no gap.
        if to - begin <= SAME {
            continue;
        }
        let from = std::mem::replace(&mut begin, to);
        let middle = from.midpoint(to);
        here.retain(|piece| middle <= pieces[*piece].to);
        while let Some(next) = waiting.pop_if(|next| pieces[*next].from <= middle) {
            if middle <= pieces[next].to {
                here.insert(here.partition_point(|piece| *piece < next), next);
            }
        }
        // What touches the piece before only goes on with it, as far as that goes.
        let before = found.last().filter(|last| from - last.to <= SAME).map(|last| last.shape);
        let (mut top, mut goes_far): (Option<(f64, Shape)>, bool) = (None, false);
        for piece in here.iter().map(|piece| &pieces[*piece]) {
            let height = piece.shape.height(middle);
            if top.is_none_or(|(best, _)| height >= best) {
                top = Some((height, piece.shape));
            }
            goes_far |= before == Some(piece.shape);
        }
        let Some((height, shape)) = top else { continue };
        let goes_on = goes_far && before.is_some_and(|before| height - before.height(middle) <= SAME);
        match found.last_mut() {
            Some(last) if goes_on => last.to = to,
            _ => found.push(Piece { from, to, shape }),
        }
    }
    found
}
