//! Elements of a contour in the working plane: where they lie next to themselves, where two of them meet, how corners
//! are rounded and broken.
//!
//! Invariant: plain geometry; it knows nothing of heights, feeds, tools or blocks. Offsets are signed, positive to the
//! left of the direction of travel.
use glam::DVec2;

use crate::base::expr::{atan2d, cosd, sind};
use crate::engine::geometry::left_of;

/// Directions that differ by less (radians) go on without a corner: what two square marks of an input step cause.
const STRAIGHT_ON: f64 = 1e-5;
/// Lengths in mm and angles in degrees below this are rounding.
const ROUNDING: f64 = 1e-7;

/// What an element is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shape {
    /// A straight line.
    Line,
    /// An arc: its centre and its angle, counter-clockwise positive.
    Arc { centre: DVec2, sweep: f64 },
}

/// A line or an arc with a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Element {
    pub(crate) from: DVec2,
    pub(crate) to: DVec2,
    pub(crate) shape: Shape,
}

/// Where an element lies, without its ends.
#[derive(Clone, Copy, Debug)]
enum Curve {
    Line { point: DVec2, along: DVec2 },
    Circle { centre: DVec2, radius: f64 },
}

/// Where two elements next to their contour meet, and how much of each is cut off there: mm of a line, degrees of an
/// arc; negative where they go on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Meeting {
    pub(crate) point: DVec2,
    pub(crate) before: f64,
    pub(crate) after: f64,
}

/// How the tool gets round a corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Corner {
    /// Both elements meet.
    Meet(Meeting),
    /// From the end of the one to the beginning of the other on an arc about the corner.
    Around,
    /// From the end of the one to the beginning of the other on a line.
    Across,
}

/// How a corner is to be gone round, next to the usual way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Manner {
    /// Outside on an arc, inside through the intersection.
    #[default]
    Usual,
    /// Outside, too, through the intersection (M97).
    Intersection,
    /// To the end of the element (M98).
    Open,
}

/// The point, turned about a centre.
pub(crate) fn turned(point: DVec2, centre: DVec2, angle: f64) -> DVec2 {
    let (c, s, arm) = (cosd(angle), sind(angle), point - centre);
    centre + DVec2::new(arm.x * c - arm.y * s, arm.x * s + arm.y * c)
}

/// The angle from one arm to another one in a direction of rotation, from 0 to less than 360 degrees.
pub(crate) fn turn_between(from: DVec2, to: DVec2, direction: f64) -> f64 {
    ((atan2d(to.y, to.x) - atan2d(from.y, from.x)) * direction).rem_euclid(360.0)
}

/// The length of a vector.
pub(crate) fn length(v: DVec2) -> f64 {
    libm::hypot(v.x, v.y)
}

/// The unit vector of a direction; nothing if it has none.
pub(crate) fn direction(v: DVec2) -> Option<DVec2> {
    let length = length(v);
    (length > 0.0).then(|| v / length)
}

impl Element {
    pub(crate) const fn line(from: DVec2, to: DVec2) -> Self {
        Self { from, to, shape: Shape::Line }
    }

    pub(crate) const fn arc(from: DVec2, to: DVec2, centre: DVec2, sweep: f64) -> Self {
        Self { from, to, shape: Shape::Arc { centre, sweep } }
    }

    /// The same from its end to its beginning.
    pub(crate) fn reversed(&self) -> Self {
        let shape = match self.shape {
            Shape::Line => Shape::Line,
            Shape::Arc { centre, sweep } => Shape::Arc { centre, sweep: -sweep },
        };
        Self { from: self.to, to: self.from, shape }
    }

    /// The direction of travel at one of its points.
    fn heading(&self, at: DVec2) -> DVec2 {
        let along = match self.shape {
            Shape::Line => self.to - self.from,
            Shape::Arc { centre, sweep } => left_of(at - centre) * sweep.signum(),
        };
        direction(along).unwrap_or(DVec2::X)
    }

    /// The direction of travel at the beginning.
    pub(crate) fn heading_at_start(&self) -> DVec2 {
        self.heading(self.from)
    }

    /// The direction of travel at the end.
    pub(crate) fn heading_at_end(&self) -> DVec2 {
        self.heading(self.to)
    }

    /// Beside its beginning.
    pub(crate) fn start_beside(&self, offset: f64) -> DVec2 {
        self.from + left_of(self.heading_at_start()) * offset
    }

    /// Beside its end.
    pub(crate) fn end_beside(&self, offset: f64) -> DVec2 {
        self.to + left_of(self.heading_at_end()) * offset
    }

    /// Its extent: mm of a line, degrees of an arc.
    pub(crate) fn extent(&self) -> f64 {
        match self.shape {
            Shape::Line => length(self.to - self.from),
            Shape::Arc { sweep, .. } => sweep.abs(),
        }
    }

    /// The radius of an arc next to it; negative if the arc is too narrow for that. A line has none.
    pub(crate) fn radius_beside(&self, offset: f64, at: DVec2) -> Option<f64> {
        match self.shape {
            Shape::Line => None,
            Shape::Arc { centre, sweep } => Some(length(at - centre) - offset * sweep.signum()),
        }
    }

    /// Whether the arc is too narrow for an offset.
    pub(crate) fn is_too_narrow(&self, offset: f64) -> bool {
        [self.from, self.to].iter().any(|at| self.radius_beside(offset, *at).is_some_and(|radius| radius < -ROUNDING))
    }

    fn curve(&self, offset: f64, at: DVec2) -> Option<Curve> {
        Some(match self.shape {
            Shape::Line => {
                let along = self.heading(at);
                Curve::Line { point: at + left_of(along) * offset, along }
            }
            Shape::Arc { centre, .. } => {
                let radius = self.radius_beside(offset, at).filter(|radius| *radius >= -ROUNDING)?;
                Curve::Circle { centre, radius: radius.max(0.0) }
            }
        })
    }

    /// How much a point next to the element cuts off its end.
    fn cut_before(&self, point: DVec2, offset: f64) -> f64 {
        match self.shape {
            Shape::Line => (self.end_beside(offset) - point).dot(self.heading_at_end()),
            Shape::Arc { centre, sweep } => small_turn(turn_between(point - centre, self.to - centre, sweep.signum())),
        }
    }

    /// How much a point next to the element cuts off its beginning.
    fn cut_after(&self, point: DVec2, offset: f64) -> f64 {
        match self.shape {
            Shape::Line => (point - self.start_beside(offset)).dot(self.heading_at_start()),
            Shape::Arc { centre, sweep } => {
                small_turn(turn_between(self.from - centre, point - centre, sweep.signum()))
            }
        }
    }

    /// mm for a cut.
    fn way(&self, cut: f64, offset: f64) -> f64 {
        let radius = self.radius_beside(offset, self.from).unwrap_or_default();
        match self.shape {
            Shape::Line => cut.abs(),
            Shape::Arc { .. } => (radius * cut).abs().to_radians(),
        }
    }

    /// The point that lies so far before its end.
    fn before_end(&self, cut: f64) -> DVec2 {
        match self.shape {
            Shape::Line => self.to - self.heading_at_end() * cut,
            Shape::Arc { centre, sweep } => turned(self.to, centre, -cut * sweep.signum()),
        }
    }

    /// The point that lies so far after its beginning.
    fn after_start(&self, cut: f64) -> DVec2 {
        match self.shape {
            Shape::Line => self.from + self.heading_at_start() * cut,
            Shape::Arc { centre, sweep } => turned(self.from, centre, cut * sweep.signum()),
        }
    }

    /// The element without that much of its end; it ends exactly there.
    fn without_end(mut self, cut: f64, to: DVec2) -> Self {
        self.to = to;
        if let Shape::Arc { sweep, .. } = &mut self.shape {
            *sweep -= cut * sweep.signum();
        }
        self
    }

    /// The element without that much of its beginning; it begins exactly there.
    fn without_start(mut self, cut: f64, from: DVec2) -> Self {
        self.from = from;
        if let Shape::Arc { sweep, .. } = &mut self.shape {
            *sweep -= cut * sweep.signum();
        }
        self
    }

    /// The path next to it from one point to another one, with what they cut off it; nothing where nothing is left and
    /// the tool would have to go back.
    pub(crate) fn path(&self, start: DVec2, end: DVec2, cut: f64) -> Option<Self> {
        let left = self.extent() - cut;
        if left < -ROUNDING {
            return None;
        }
        let shape = match self.shape {
            Shape::Line => Shape::Line,
            Shape::Arc { centre, sweep } => Shape::Arc { centre, sweep: left.max(0.0) * sweep.signum() },
        };
        Some(Self { from: start, to: end, shape })
    }
}

/// An angle that is nearly a whole turn is a small one the other way.
fn small_turn(angle: f64) -> f64 {
    if angle > 360.0 - ROUNDING { angle - 360.0 } else { angle }
}

fn crossings(a: Curve, b: Curve) -> Vec<DVec2> {
    match (a, b) {
        (Curve::Line { point: p, along: u }, Curve::Line { point: q, along: v }) => {
            let cross = u.perp_dot(v);
            if cross == 0.0 { Vec::new() } else { vec![p + u * ((q - p).perp_dot(v) / cross)] }
        }
        (Curve::Line { point, along }, Curve::Circle { centre, radius })
        | (Curve::Circle { centre, radius }, Curve::Line { point, along }) => {
            let foot = point + along * (centre - point).dot(along);
            let distance = length(centre - foot);
            if distance > radius + ROUNDING {
                return Vec::new();
            }
            let half = libm::sqrt((radius * radius - distance * distance).max(0.0));
            vec![foot + along * half, foot - along * half]
        }
        (Curve::Circle { centre: m, radius: r }, Curve::Circle { centre: n, radius: s }) => {
            let distance = length(n - m);
            if distance == 0.0 || distance > r + s + ROUNDING || distance < (r - s).abs() - ROUNDING {
                return Vec::new();
            }
            let along = (n - m) / distance;
            let foot = (distance * distance + r * r - s * s) / (2.0 * distance);
            let half = libm::sqrt((r * r - foot * foot).max(0.0));
            let middle = m + along * foot;
            vec![middle + left_of(along) * half, middle - left_of(along) * half]
        }
    }
}

/// The sine of the angle by which the direction changes at a joint, and whether it goes on without a corner.
fn bend(before: &Element, after: &Element) -> (f64, bool) {
    let (u, v) = (before.heading_at_end(), after.heading_at_start());
    let bend = u.perp_dot(v);
    (bend, bend.abs() < STRAIGHT_ON && u.dot(v) > 0.0)
}

/// Where two elements meet next to an inside corner: the meeting that cuts off least.
fn inside(before: &Element, after: &Element, offset: f64) -> Option<Meeting> {
    let (a, b) = (before.curve(offset, before.to)?, after.curve(offset, after.from)?);
    let meeting = |point: DVec2| {
        let (cut, other) = (before.cut_before(point, offset), after.cut_after(point, offset));
        // A line may be left with less than nothing here: its other end decides, for M97 goes on beyond it.
        let over = |cut: f64, element: &Element| cut > element.extent() + ROUNDING;
        let fits =
            |cut: f64, element: &Element| cut >= -ROUNDING && (element.shape == Shape::Line || !over(cut, element));
        let way = before.way(cut, offset) + after.way(other, offset);
        let meeting = Meeting { point, before: cut.max(0.0), after: other.max(0.0) };
        let is_over = over(cut, before) || over(other, after);
        (fits(cut, before) && fits(other, after)).then_some((is_over, way, meeting))
    };
    let found = crossings(a, b).into_iter().filter_map(meeting);
    found.min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))).map(|(_, _, meeting)| meeting)
}

/// Where two elements meet next to an outside corner if they go on.
fn outside(before: &Element, after: &Element, offset: f64) -> Option<Meeting> {
    let (a, b) = (before.curve(offset, before.to)?, after.curve(offset, after.from)?);
    let far = |point: &DVec2| length(*point - before.to);
    let point = crossings(a, b).into_iter().min_by(|a, b| far(a).total_cmp(&far(b)))?;
    let back = |cut: f64, element: &Element| match element.shape {
        Shape::Arc { .. } if cut > 180.0 => cut - 360.0,
        _ => cut,
    };
    let (cut, other) = (before.cut_before(point, offset), after.cut_after(point, offset));
    Some(Meeting { point, before: back(cut, before), after: back(other, after) })
}

/// How a tool that runs next to both elements gets from one to the other; nothing where it is too large for the corner.
pub(crate) fn corner(before: &Element, after: &Element, offset: f64, manner: Manner) -> Option<Corner> {
    let at = |point: DVec2| Corner::Meet(Meeting { point, before: 0.0, after: 0.0 });
    if offset == 0.0 {
        return Some(at(before.to));
    }
    let (bend, straight_on) = bend(before, after);
    if straight_on {
        let middle = direction(before.heading_at_end() + after.heading_at_start())?;
        return Some(at(before.to + left_of(middle) * offset));
    }
    if manner == Manner::Open {
        return Some(Corner::Across);
    }
    let is_inside = bend * offset > 0.0 && bend.abs() >= STRAIGHT_ON;
    match (is_inside, manner) {
        (true, _) => inside(before, after, offset).map(Corner::Meet),
        (false, Manner::Intersection) => outside(before, after, offset).map(Corner::Meet),
        (false, _) => Some(Corner::Around),
    }
}

/// A corner rounded with a radius: the two elements and the arc between them, if there is a corner.
/// Nothing where the arc finds no place.
pub(crate) fn rounded(before: &Element, after: &Element, radius: f64) -> Option<(Element, Option<Element>, Element)> {
    let (bend, straight_on) = bend(before, after);
    if straight_on || radius == 0.0 {
        return Some((*before, None, *after));
    }
    let direction = bend.signum();
    let Meeting { point: centre, before: cut, after: other } = inside(before, after, radius * direction)?;
    if cut > before.extent() + ROUNDING || other > after.extent() + ROUNDING {
        return None;
    }
    let (from, to) = (before.before_end(cut), after.after_start(other));
    let sweep = turn_between(from - centre, to - centre, direction) * direction;
    let arc = Element::arc(from, to, centre, sweep);
    Some((before.without_end(cut, from), Some(arc), after.without_start(other, to)))
}

/// A corner of two lines broken by a chamfer that takes so much off each. Nothing where it finds no place.
pub(crate) fn broken(before: &Element, after: &Element, leg: f64) -> Option<(Element, Option<Element>, Element)> {
    let lines = before.shape == Shape::Line && after.shape == Shape::Line;
    if !lines || leg > before.extent() + ROUNDING || leg > after.extent() + ROUNDING {
        return None;
    }
    let (_, straight_on) = bend(before, after);
    if straight_on || leg == 0.0 {
        return Some((*before, None, *after));
    }
    let (from, to) = (before.before_end(leg), after.after_start(leg));
    Some((before.without_end(leg, from), Some(Element::line(from, to)), after.without_start(leg, to)))
}

/// The arc that goes on from a direction and ends at a point: its centre and angle. Nothing if that point lies straight
/// ahead or straight after.
pub(crate) fn tangential(from: DVec2, heading: DVec2, to: DVec2) -> Option<(DVec2, f64)> {
    let chord = to - from;
    let (aside, ahead) = (heading.perp_dot(chord), heading.dot(chord));
    if aside.abs() <= STRAIGHT_ON * length(chord) {
        return None;
    }
    let radius = chord.length_squared() / (2.0 * aside);
    Some((from + left_of(heading) * radius, 2.0 * atan2d(aside, ahead)))
}
