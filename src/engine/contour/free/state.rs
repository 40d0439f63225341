//! What is known of a free contour: its points, the lines and circles of its elements, directions, radii and angles; and
//! what follows at once from what.
//!
//! Invariant: what has several solutions makes several states, in `determine`; here nothing is chosen.
use glam::DVec2;

use super::curve::{AGREE, Curve};
use super::{Datum, Flaw, Given, Missing, Point};
use crate::base::expr::{atan2d, cosd, sind};
use crate::engine::contour::element::{Element, length, turn_between, turned};
use crate::engine::geometry::left_of;

/// Directions that differ by less (the sine of the angle) agree: data of a drawing are rounded.
const SAME_DIRECTION: f64 = 1e-3;
/// Angles of data and of the contour that differ by less, degrees, agree.
const SAME_ANGLE: f64 = 0.01;
/// An arc is no longer than this, degrees.
const WHOLE: f64 = 360.0;

/// What several signs leave open of an element; a sign is 1 or -1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Choice {
    /// 1: the arc goes round counter-clockwise.
    pub(super) turn: f64,
    /// 1: the point from which a distance is given lies to the left.
    pub(super) side: f64,
    /// 1: a parallel has the direction of the other line.
    pub(super) along: f64,
    /// 1: a parallel lies to the left of the other line.
    pub(super) aside: f64,
}

/// What is known of an element.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    pub(super) choice: Choice,
    pub(super) curve: Option<Curve>,
    /// The direction at its beginning.
    pub(super) leaving: Option<DVec2>,
    /// Signed: positive counter-clockwise.
    pub(super) radius: Option<f64>,
    /// The angle of an arc, degrees.
    pub(super) sweep: Option<f64>,
}

/// The end of an element, or the beginning of the contour.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Joint {
    pub(super) at: Option<DVec2>,
    /// The direction in which the contour arrives there.
    pub(super) arriving: Option<DVec2>,
}

/// What is known of a contour.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub(super) joints: Vec<Joint>,
    pub(super) elements: Vec<Known>,
    /// All elements before this one are determined.
    pub(super) first: usize,
}

fn heading(degrees: f64) -> DVec2 {
    DVec2::new(cosd(degrees), sind(degrees))
}

fn rotated(vector: DVec2, degrees: f64) -> DVec2 {
    turned(vector, DVec2::ZERO, degrees)
}

/// Keeps what is known already.
fn learn<T>(place: &mut Option<T>, value: Option<T>) -> bool {
    let news = place.is_none() && value.is_some();
    if news {
        *place = value;
    }
    news
}

impl State {
    pub(super) fn new(start: DVec2, heading: Option<DVec2>) -> Self {
        Self { joints: vec![Joint { at: Some(start), arriving: heading }], elements: Vec::new(), first: 0 }
    }

    /// Whether another state says the same.
    pub(super) fn is(&self, other: &Self) -> bool {
        let same = |a: Option<DVec2>, b: Option<DVec2>| match (a, b) {
            (Some(a), Some(b)) => length(a - b) < 1e-6,
            (a, b) => a.is_none() && b.is_none(),
        };
        let element = |a: &Known, b: &Known| match (a.curve, b.curve) {
            (Some(a), Some(b)) => a.is(&b),
            // What is open yet may come out in different ways.
            (None, None) => a.choice == b.choice && same(a.leaving, b.leaving),
            _ => false,
        };
        self.joints.iter().zip(&other.joints).all(|(a, b)| same(a.at, b.at))
            && self.elements.iter().zip(&other.elements).all(|(a, b)| element(a, b))
    }

    pub(super) fn at(&self, joint: usize) -> Option<DVec2> {
        self.joints.get(joint).and_then(|joint| joint.at)
    }

    pub(super) fn arriving(&self, joint: usize) -> Option<DVec2> {
        self.joints.get(joint).and_then(|joint| joint.arriving)
    }

    pub(super) fn curve(&self, element: usize) -> Option<Curve> {
        self.elements.get(element).and_then(|known| known.curve)
    }

    /// A coordinate along an axis, as far as it is known.
    pub(super) fn coordinate(&self, datum: Datum, of: impl Fn(DVec2) -> f64) -> Option<f64> {
        match datum.from {
            None => Some(datum.value),
            Some(joint) => Some(of(self.at(joint)?) + datum.value),
        }
    }

    /// X, Y, and radius and angle about the pole, of a point of which that much is given.
    pub(super) fn given(&self, point: &Point, pole: Option<DVec2>) -> [Option<f64>; 4] {
        let pole = pole.unwrap_or_default();
        let [x, y] = point.cartesian;
        let [radius, angle] = point.polar;
        [
            x.and_then(|datum| self.coordinate(datum, |at| at.x)),
            y.and_then(|datum| self.coordinate(datum, |at| at.y)),
            radius.and_then(|datum| self.coordinate(datum, |at| length(at - pole))),
            angle.and_then(|datum| self.coordinate(datum, |at| atan2d(at.y - pole.y, at.x - pole.x))),
        ]
    }

    /// Whether a point is where an element must end.
    pub(super) fn may_end(&self, given: &Given, element: usize, at: DVec2) -> bool {
        let closes = given.closes.and_then(|joint| self.at(joint)).is_none_or(|begin| length(begin - at) <= AGREE);
        let far = given.length.zip(self.at(element)).is_none_or(|(far, from)| (length(at - from) - far).abs() <= AGREE);
        closes && far && self.agrees(&given.end, given.pole, at)
    }

    /// Whether a point is the one of which that much is given.
    pub(super) fn agrees(&self, point: &Point, pole: Option<DVec2>, at: DVec2) -> bool {
        let arm = at - pole.unwrap_or_default();
        let [x, y, radius, angle] = self.given(point, pole);
        let is = |value: Option<f64>, own: f64| value.is_none_or(|value| (value - own).abs() <= AGREE);
        // The sine alone is 0 on the other side, too.
        let points = angle.is_none_or(|angle| {
            let way = heading(angle);
            length(arm) <= AGREE || (way.perp_dot(arm).abs() <= AGREE && way.dot(arm) > 0.0)
        });
        is(x, at.x) && is(y, at.y) && is(radius, length(arm)) && points
    }

    /// What follows at once. Whether anything did.
    pub(super) fn learn(&mut self, given: &[Given]) -> bool {
        let mut news = false;
        for (i, own) in given.iter().enumerate().take(self.elements.len()).skip(self.first) {
            news |= self.learn_directions(own, i);
            if i + 1 < self.elements.len() && given.get(i + 1).is_some_and(|next| next.is_tangential) {
                let leaving = self.elements[i + 1].leaving;
                news |= learn(&mut self.joints[i + 1].arriving, leaving);
            }
            if own.is_arc {
                news |= self.learn_arc(own, i);
            }
            news |= self.learn_ends(own, i);
        }
        while self.is_determined(self.first) {
            self.first += 1;
        }
        news
    }

    fn learn_directions(&mut self, own: &Given, i: usize) -> bool {
        let Known { choice, curve, leaving, sweep, .. } = self.elements[i];
        let (start, end, arriving) = (self.at(i), self.at(i + 1), self.arriving(i + 1));
        let at_start = curve.zip(start).and_then(|(curve, at)| curve.heading(at));
        let at_end = curve.zip(end).and_then(|(curve, at)| curve.heading(at));
        let of_line = curve.and_then(|curve| match curve {
            Curve::Line { along, .. } => Some(along),
            Curve::Circle { .. } => None,
        });
        let written = own.heading.and_then(|datum| match datum.from {
            None => Some(heading(datum.value)),
            Some(joint) => Some(rotated(self.arriving(joint)?, datum.value)),
        });
        let parallel = own.parallel.and_then(|(joint, _)| match self.curve(joint.checked_sub(1)?)? {
            Curve::Line { along, .. } => Some(along * choice.along),
            Curve::Circle { .. } => None,
        });
        let tangential = if own.is_tangential { self.arriving(i) } else { None };
        let back = if own.is_arc {
            arriving.zip(sweep).map(|(arriving, sweep)| rotated(arriving, -sweep * choice.turn))
        } else {
            arriving
        };
        let found = written.or(parallel).or(tangential).or(at_start).or(of_line).or(back);
        let mut news = learn(&mut self.elements[i].leaving, found);
        let leaving = leaving.or(found);
        let ahead = if own.is_arc {
            leaving.zip(sweep).map(|(leaving, sweep)| rotated(leaving, sweep * choice.turn))
        } else {
            leaving
        };
        news |= learn(&mut self.joints[i + 1].arriving, at_end.or(of_line).or(ahead));
        if own.is_tangential {
            news |= learn(&mut self.joints[i].arriving, leaving);
        }
        if let (Some(Datum { value, from: Some(joint) }), Some(leaving)) = (own.heading, leaving) {
            news |= learn(&mut self.joints[joint].arriving, Some(rotated(leaving, -value)));
        }
        news
    }

    fn learn_arc(&mut self, own: &Given, i: usize) -> bool {
        let Known { choice, curve, leaving, radius, sweep } = self.elements[i];
        let of_curve = curve.and_then(|curve| match curve {
            Curve::Circle { radius, .. } => Some(radius),
            Curve::Line { .. } => None,
        });
        let sine = sweep.map(|sweep| sind(sweep / 2.0)).filter(|sine| *sine > SAME_DIRECTION);
        let chord = own.length.or_else(|| Some(length(self.at(i + 1)? - self.at(i)?)));
        let of_chord = chord.zip(sine).map(|(chord, sine)| chord / (2.0 * sine) * choice.turn);
        let written = own.radius.map(|radius| radius * choice.turn);
        let mut news = learn(&mut self.elements[i].radius, written.or(of_curve).or(radius).or(of_chord));
        let swept = match curve {
            Some(Curve::Circle { centre, .. }) => self.swept(i, centre),
            _ => leaving.zip(self.arriving(i + 1)).map(|(from, to)| turn_between(from, to, choice.turn)),
        };
        // Without a corner nothing tells no turn from a whole one.
        let swept = swept.filter(|swept| *swept > SAME_ANGLE && *swept < WHOLE - SAME_ANGLE);
        news |= learn(&mut self.elements[i].sweep, own.sweep.or(swept));
        news
    }

    /// The angle of an arc whose ends are known.
    fn swept(&self, i: usize, centre: DVec2) -> Option<f64> {
        Some(turn_between(self.at(i)? - centre, self.at(i + 1)? - centre, self.elements[i].choice.turn))
    }

    fn learn_ends(&mut self, own: &Given, i: usize) -> bool {
        let mut news = false;
        let [x, y, ..] = self.given(&own.end, own.pole);
        news |= learn(&mut self.joints[i + 1].at, x.zip(y).map(|(x, y)| DVec2::new(x, y)));
        let begin = own.closes.and_then(|joint| self.at(joint));
        news |= learn(&mut self.joints[i + 1].at, begin);
        if let Some(curve) = self.elements[i].curve {
            // On a circle a direction is at one point only.
            let start = self.elements[i].leaving.and_then(|heading| curve.at_heading(heading));
            news |= learn(&mut self.joints[i].at, start);
            let end = self.arriving(i + 1).and_then(|heading| curve.at_heading(heading));
            news |= learn(&mut self.joints[i + 1].at, end);
            if own.is_tangential && i > 0 {
                let touching = self.curve(i - 1).and_then(|before| before.touches(&curve));
                news |= learn(&mut self.joints[i].at, touching);
            }
        }
        if let Some(way) = self.displacement(own, i) {
            let (start, end) = (self.at(i), self.at(i + 1));
            news |= learn(&mut self.joints[i + 1].at, start.map(|start| start + way));
            news |= learn(&mut self.joints[i].at, end.map(|end| end - way));
        }
        news
    }

    /// The way from the beginning of an element to its end.
    pub(super) fn displacement(&self, own: &Given, i: usize) -> Option<DVec2> {
        if let [Some(Datum { value: x, from: Some(a) }), Some(Datum { value: y, from: Some(b) })] = own.end.cartesian
            && a == i
            && b == i
        {
            return Some(DVec2::new(x, y));
        }
        let Known { choice, leaving, radius, sweep, .. } = self.elements.get(i).copied()?;
        let leaving = leaving?;
        if !own.is_arc {
            return own.length.map(|length| leaving * length);
        }
        let centre = left_of(leaving) * radius?;
        Some(turned(DVec2::ZERO, centre, sweep? * choice.turn))
    }

    fn is_determined(&self, i: usize) -> bool {
        self.curve(i).is_some() && self.at(i).is_some() && self.at(i + 1).is_some()
    }

    /// Whether an element whose ends are known is what its data say.
    pub(super) fn holds(&self, given: &[Given], i: usize) -> bool {
        let Some(own) = given.get(i) else { return true };
        let end = self.at(i + 1);
        if end.is_some_and(|end| !self.may_end(own, i, end)) {
            return false;
        }
        let Some(curve) = self.curve(i) else { return true };
        if own.on.iter().any(|at| curve.left(*at).abs() > AGREE)
            || own.beside.is_some_and(|(at, far)| (curve.left(at).abs() - far.abs()).abs() > AGREE)
            || !self.is_as_given(own, i, &curve)
        {
            return false;
        }
        let (Some(start), Some(end)) = (self.at(i), end) else { return true };
        if curve.left(start).abs() > AGREE || curve.left(end).abs() > AGREE {
            return false;
        }
        let same = |a: Option<DVec2>, b: Option<DVec2>| {
            a.zip(b).is_none_or(|(a, b)| a.perp_dot(b).abs() <= SAME_DIRECTION && a.dot(b) > 0.0)
        };
        let written = own.heading.and_then(|datum| match datum.from {
            None => Some(heading(datum.value)),
            Some(joint) => Some(rotated(self.arriving(joint)?, datum.value)),
        });
        let own_heading = curve.heading(start);
        let before = if own.is_tangential { self.arriving(i) } else { None };
        if !same(own_heading, before) || !same(own_heading, written) {
            return false;
        }
        // What goes on tangentially does not turn back at once.
        let opposite = curve.heading(end).zip(self.arriving(i + 1)).is_some_and(|(own, next)| own.dot(next) < 0.0);
        if opposite {
            return false;
        }
        match curve {
            Curve::Line { along, .. } => (end - start).dot(along) > AGREE,
            Curve::Circle { centre, .. } => {
                let swept = turn_between(start - centre, end - centre, self.elements[i].choice.turn);
                let whole = length(end - start) <= AGREE;
                let is_whole = own.sweep.is_none_or(|sweep| (sweep - WHOLE).abs() <= SAME_ANGLE);
                let wanted = own.sweep.is_none_or(|sweep| (sweep - swept).abs() <= SAME_ANGLE);
                if whole { is_whole } else { wanted }
            }
        }
    }

    /// Whether the line or circle is the one that is given.
    fn is_as_given(&self, own: &Given, i: usize, curve: &Curve) -> bool {
        match *curve {
            Curve::Circle { centre, radius } => {
                radius * self.elements[i].choice.turn > 0.0
                    && own.radius.is_none_or(|own| (own - radius.abs()).abs() <= AGREE)
                    && self.agrees(&own.centre, own.pole, centre)
            }
            Curve::Line { point, .. } => {
                let other = own.parallel.and_then(|(joint, far)| Some((self.curve(joint.checked_sub(1)?)?, far?)));
                other.is_none_or(|(other, far)| (other.left(point).abs() - far).abs() <= AGREE)
            }
        }
    }

    /// The contour, if all of it is known.
    pub(super) fn elements(&self, given: &[Given]) -> Result<Vec<Element>, Flaw> {
        let mut elements = Vec::with_capacity(given.len());
        for (element, own) in given.iter().enumerate() {
            let missing = if own.is_arc { Missing::Arc } else { Missing::Line };
            let open = |element: usize, missing: Missing| {
                let values = self.missing_values(given);
                Flaw::Open { element, missing, values }
            };
            let curve = self.curve(element).ok_or_else(|| open(element, missing))?;
            let from = self.at(element).ok_or_else(|| open(element.saturating_sub(1), Missing::End))?;
            let to = self.at(element + 1).ok_or_else(|| open(element, Missing::End))?;
            elements.push(match curve {
                Curve::Line { .. } => Element::line(from, to),
                Curve::Circle { centre, .. } => {
                    let turn = self.elements[element].choice.turn;
                    let swept = turn_between(from - centre, to - centre, turn);
                    let swept = if length(to - from) <= AGREE { WHOLE } else { swept };
                    Element::arc(from, to, centre, swept * turn)
                }
            });
        }
        Ok(elements)
    }
}
