//! Several open elements that determine each other: their lines, circles and points as the unknowns of one system of
//! equations, solved by numbers.
//!
//! A line has a direction and a distance from the origin, a circle a centre and a signed radius, a point two
//! coordinates; each datum of an element is an equation between them. How many unknowns the equations determine is read
//! off their derivatives. Those that are determined are looked for from many places (Levenberg-Marquardt: Newton's
//! method with a damping that leads it downhill from afar), always the same ones, until no new solution comes any more.
//! Invariant: signs that the data leave open are chosen already, so each equation is smooth.
use std::cmp::Ordering;
use std::f64::consts::TAU;

use glam::DVec2;

use super::curve::{AGREE, Curve};
use super::matrix::{Matrix, determined_columns, least_squares};
use super::state::{Choice, State};
use super::{Datum, Given, Point};
use crate::base::expr::{cosd, sind};
use crate::engine::contour::element::{length, turn_between, turned};
use crate::engine::geometry::left_of;

/// Systems with more unknowns that all depend on each other are not solved.
const MOST_UNKNOWNS: usize = 96;
/// Of more unknowns it is not looked for which of them are determined.
const MOST_OPEN: usize = 512;
/// More solutions than that are none: they belong to a system that is not determined.
const MOST_SOLUTIONS: usize = 32;
/// So many starts at least find nothing new before the search ends.
const QUIET_STARTS: usize = 160;
/// So many where nothing was found at all.
const PATIENT_STARTS: usize = 360;
/// After so many every second start has short arcs.
const SHORT_AFTER: usize = 40;
/// The ends of short arcs are no farther from each other, as a share of the size of the contour.
const SHORT: f64 = 0.1;
/// Never more starts than that.
const MOST_STARTS: usize = 1500;
/// After so many solutions beside which others lie the system counts as open.
const MOST_LOOSE: usize = 6;
/// Steps of one search.
const MOST_STEPS: usize = 80;
/// A step that is shorter, as a share of the size of the contour, is the last one.
const LAST_STEP: f64 = 1e-13;
/// Derivatives are differences over this share of the size of the contour.
const DIFFERENCE: f64 = 1e-5;
/// Points and lengths that differ by less, mm, are the same.
const SAME: f64 = 1e-6;

/// A solution: lines and circles by element, points by their number.
#[derive(Clone, Debug)]
pub(super) struct Solution {
    pub(super) curves: Vec<(usize, Curve)>,
    pub(super) points: Vec<(usize, DVec2)>,
}

/// What is unknown of an element or of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// It is known: in the state.
    Known,
    /// Its first unknown.
    Unknown(usize),
    /// It is unknown, and no part of the system.
    Outside,
}

/// The unknowns of a system and where they are.
#[derive(Clone, Debug)]
struct Layout {
    curves: Vec<Place>,
    points: Vec<Place>,
    count: usize,
}

/// A system: equations in the unknowns of a layout.
struct System<'a> {
    state: &'a State,
    given: &'a [Given],
    layout: Layout,
    /// The middle of what is known, and the size of the contour, mm.
    middle: DVec2,
    size: f64,
    /// Which equations say something of the unknowns.
    says: Vec<bool>,
}

/// A direction as the normal to its left, times a weight.
#[derive(Clone, Copy)]
struct Normal {
    left: DVec2,
    weight: f64,
}

/// Numbers without a pattern, the same ones in each run (SplitMix64).
struct Numbers(u64);

impl Numbers {
    /// The next one, from 0 to 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// From -1 to 1.
    fn signed(&mut self) -> f64 {
        self.next() * 2.0 - 1.0
    }
}

impl State {
    /// What open elements determine together, in each of its solutions; nothing where they determine nothing.
    pub(super) fn system(&self, given: &[Given]) -> Option<Vec<Solution>> {
        let whole = System::new(self, given, Layout::of(self, given, None)?);
        let part = System::new(self, given, whole.determined_part()?);
        // One that is too large may fall into several that share nothing but what is known: the first of them.
        let system =
            if part.layout.count <= MOST_UNKNOWNS { part } else { System::new(self, given, part.first_part()?) };
        let mut solutions = system.solutions()?;
        solutions.sort_by(|a, b| self.before(given, a, b));
        Some(solutions)
    }

    /// How many values are missing until the open elements are determined; at least one.
    pub(super) fn missing_values(&self, given: &[Given]) -> usize {
        let Some(layout) = Layout::of(self, given, None) else { return 1 };
        let system = System::new(self, given, layout);
        (system.layout.count - system.rank().min(system.layout.count)).max(1)
    }

    /// With a solution.
    pub(super) fn with_solution(&self, solution: &Solution) -> Self {
        let mut state = self.clone();
        for (i, curve) in &solution.curves {
            state.elements[*i].curve = Some(*curve);
        }
        for (joint, at) in &solution.points {
            state.joints[*joint].at = Some(*at);
        }
        state
    }

    /// The shorter contour comes first, then the one whose first point that differs lies to the left of the way between
    /// the known points around it, or above, where nothing is known after it.
    fn before(&self, given: &[Given], a: &Solution, b: &Solution) -> Ordering {
        let (long, other) = (self.with_solution(a).long(given), self.with_solution(b).long(given));
        if (long - other).abs() > SAME {
            return long.total_cmp(&other);
        }
        let points = a.points.iter().zip(&b.points);
        let Some(((joint, p), (_, q))) = points.into_iter().find(|((_, p), (_, q))| length(p - q) > SAME) else {
            let radius = |solution: &Solution| solution.curves.iter().map(|(_, curve)| curve.size()).sum::<f64>();
            return radius(a).total_cmp(&radius(b));
        };
        let from = (0..*joint).rev().find_map(|joint| self.at(joint));
        let to = (*joint..self.joints.len()).find_map(|joint| self.at(joint));
        let way = from.zip(to).map(|(from, to)| to - from).filter(|way| length(*way) > SAME).unwrap_or(DVec2::X);
        let (left, ahead) = (way.perp_dot(*q - *p), way.dot(*q - *p));
        // Neither to the left is the one that lies farther ahead.
        if left.abs() > SAME * length(way) { left.total_cmp(&0.0) } else { ahead.total_cmp(&0.0) }
    }

    /// How long the elements are that are known with both ends.
    fn long(&self, given: &[Given]) -> f64 {
        let element = |i: usize| {
            let (from, to, curve) = (self.at(i)?, self.at(i + 1)?, self.curve(i)?);
            Some(match curve {
                Curve::Line { .. } => length(to - from),
                Curve::Circle { centre, radius } => {
                    turn_between(from - centre, to - centre, radius.signum()) / 360.0 * TAU * radius.abs()
                }
            })
        };
        (0..given.len().min(self.elements.len())).filter_map(element).sum()
    }
}

impl Layout {
    /// What is unknown in a state, or of it what is asked for; nothing where that is nothing, or too much.
    fn of(state: &State, given: &[Given], only: Option<&dyn Fn(bool, usize) -> bool>) -> Option<Self> {
        let mut count = 0;
        let mut place = |is_known: bool, is_asked: bool, size: usize| {
            if is_known {
                return Place::Known;
            }
            if !is_asked {
                return Place::Outside;
            }
            count += size;
            Place::Unknown(count - size)
        };
        let asked = |is_curve: bool, number: usize| only.is_none_or(|only| only(is_curve, number));
        let size = |i: usize| if is_arc(given, i) { 3 } else { 2 };
        let curves =
            (0..state.elements.len()).map(|i| place(state.curve(i).is_some(), asked(true, i), size(i))).collect();
        let points =
            (0..state.joints.len()).map(|joint| place(state.at(joint).is_some(), asked(false, joint), 2)).collect();
        (count > 0 && count <= MOST_OPEN).then_some(Self { curves, points, count })
    }
}

impl<'a> System<'a> {
    fn new(state: &'a State, given: &'a [Given], layout: Layout) -> Self {
        let (low, high, reach) = extent(state, given);
        let size = (high - low).max_element().max(reach).max(1.0);
        let mut system = Self { state, given, layout, middle: (low + high) / 2.0, size, says: Vec::new() };
        // What no unknown changes anywhere is no equation.
        let jacobian = system.jacobian(&system.start(&mut Numbers(1), false));
        system.says = (0..jacobian.rows()).map(|row| jacobian.row(row).iter().any(|own| own.abs() > 1e-12)).collect();
        system
    }

    fn at(&self, joint: usize, x: &[f64]) -> Option<DVec2> {
        match *self.layout.points.get(joint)? {
            Place::Known => self.state.at(joint),
            Place::Unknown(first) => Some(DVec2::new(x[first], x[first + 1])),
            Place::Outside => None,
        }
    }

    fn curve(&self, i: usize, x: &[f64]) -> Option<Curve> {
        match *self.layout.curves.get(i)? {
            Place::Known => self.state.curve(i),
            Place::Unknown(first) if is_arc(self.given, i) => {
                Some(Curve::Circle { centre: DVec2::new(x[first], x[first + 1]), radius: x[first + 2] })
            }
            Place::Unknown(first) => {
                // All unknowns are of the size of the contour; the distance counts from its middle.
                let (s, c) = libm::sincos(x[first] / self.size);
                let along = DVec2::new(c, s);
                Some(Curve::Line { point: self.middle + left_of(along) * x[first + 1], along })
            }
            Place::Outside => None,
        }
    }

    /// The direction of an element at one of its points.
    fn normal(&self, i: usize, joint: usize, x: &[f64]) -> Option<Normal> {
        match self.curve(i, x)? {
            Curve::Line { along, .. } => Some(Normal { left: left_of(along) * self.size, weight: self.size }),
            Curve::Circle { centre, radius } => Some(Normal { left: centre - self.at(joint, x)?, weight: radius }),
        }
    }

    /// The direction in which the contour arrives at a point.
    fn arriving(&self, joint: usize, x: &[f64]) -> Option<Normal> {
        match joint.checked_sub(1) {
            Some(before) => self.normal(before, joint, x),
            None => self.state.arriving(0).map(|heading| self.of_heading(heading)),
        }
    }

    fn of_heading(&self, heading: DVec2) -> Normal {
        Normal { left: left_of(heading) * self.size, weight: self.size }
    }

    /// That a point lies on an element, mm.
    fn on(&self, curve: &Curve, at: DVec2, left: f64) -> f64 {
        match *curve {
            Curve::Line { point, along } => along.perp_dot(at - point) - left,
            Curve::Circle { centre, radius } => {
                let far = radius - left;
                ((at - centre).length_squared() - far * far) / (2.0 * self.size)
            }
        }
    }

    /// That two directions are the same or opposite.
    fn across(&self, a: Normal, b: Normal) -> f64 {
        a.left.perp_dot(b.left) / self.size
    }

    /// The equations: what is left of each, about mm. Those of which a part is outside are left out.
    fn equations(&self, x: &[f64]) -> Vec<f64> {
        let mut found = Vec::with_capacity(8 * self.state.elements.len());
        for (i, own) in self.given.iter().enumerate().take(self.state.elements.len()) {
            self.of_ends(own, i, x, &mut found);
            self.of_directions(own, i, x, &mut found);
            self.of_curve(own, i, x, &mut found);
        }
        found
    }

    fn of_ends(&self, own: &Given, i: usize, x: &[f64], found: &mut Vec<f64>) {
        let (from, to) = (self.at(i, x), self.at(i + 1, x));
        if let Some(curve) = self.curve(i, x) {
            found.extend(from.map(|at| self.on(&curve, at, 0.0)));
            found.extend(to.map(|at| self.on(&curve, at, 0.0)));
        }
        if let Some(to) = to {
            self.of_point(&own.end, own.pole, to, x, found);
            if let Some(begin) = own.closes.and_then(|joint| self.at(joint, x)) {
                found.extend([to.x - begin.x, to.y - begin.y]);
            }
            match (from.zip(own.length), own.heading) {
                // Where a line has a direction it goes that far ahead, and not back.
                (Some((from, far)), Some(Datum { value, from: None })) if !own.is_arc => {
                    let left = to - from - DVec2::new(cosd(value), sind(value)) * far;
                    found.extend([left.x, left.y]);
                }
                (Some((from, far)), _) => found.push(((to - from).length_squared() - far * far) / (2.0 * self.size)),
                _ => {}
            }
        }
    }

    fn of_directions(&self, own: &Given, i: usize, x: &[f64], found: &mut Vec<f64>) {
        let leaving = self.normal(i, i, x);
        if own.is_tangential {
            found.extend(self.arriving(i, x).zip(leaving).map(|(a, b)| self.across(a, b)));
        }
        let written = own.heading.and_then(|Datum { value, from }| match from {
            None => Some(self.of_heading(DVec2::new(cosd(value), sind(value)))),
            Some(joint) => {
                let Normal { left, weight } = self.arriving(joint, x)?;
                Some(Normal { left: turned(left, DVec2::ZERO, value), weight })
            }
        });
        found.extend(written.zip(leaving).map(|(a, b)| self.across(a, b)));
    }

    fn of_curve(&self, own: &Given, i: usize, x: &[f64], found: &mut Vec<f64>) {
        let Some(curve) = self.curve(i, x) else { return };
        let Choice { turn, side, aside, .. } = self.state.elements[i].choice;
        found.extend(own.on.iter().map(|at| self.on(&curve, *at, 0.0)));
        found.extend(own.beside.map(|(at, far)| self.on(&curve, at, far.abs() * side)));
        match curve {
            Curve::Circle { centre, radius } => {
                found.extend(own.radius.map(|own| radius - own * turn));
                self.of_point(&own.centre, own.pole, centre, x, found);
                let ends = self.at(i, x).zip(self.at(i + 1, x));
                if let Some(((from, to), sweep)) = ends.zip(own.sweep) {
                    let wanted = turned(from - centre, DVec2::ZERO, sweep * turn);
                    found.push(wanted.perp_dot(to - centre) / self.size);
                }
            }
            Curve::Line { point, along } => {
                let Some((joint, far)) = own.parallel else { return };
                let other = joint.checked_sub(1).and_then(|other| self.curve(other, x));
                let Some(Curve::Line { point: q, along: v }) = other else { return };
                found.push(v.perp_dot(along) * self.size);
                found.extend(far.map(|far| v.perp_dot(point - q) - far * aside));
            }
        }
    }

    /// What is given of a point, the end of an element or its centre.
    fn of_point(&self, point: &Point, pole: Option<DVec2>, at: DVec2, x: &[f64], found: &mut Vec<f64>) {
        let pole = pole.unwrap_or_default();
        let base = |datum: Datum| datum.from.map_or(Some(None), |joint| self.at(joint, x).map(Some));
        for (index, datum) in point.cartesian.iter().enumerate() {
            let known = datum.and_then(|datum| Some((datum.value, base(datum)?)));
            found.extend(known.map(|(value, from)| at[index] - from.map_or(0.0, |from| from[index]) - value));
        }
        let [radius, angle] = point.polar.map(|datum| datum.and_then(|datum| Some((datum.value, base(datum)?))));
        found.extend(radius.map(|(value, from)| match from {
            None => ((at - pole).length_squared() - value * value) / (2.0 * self.size),
            Some(from) => length(at - pole) - length(from - pole) - value,
        }));
        found.extend(angle.map(|(value, from)| match from {
            None => DVec2::new(cosd(value), sind(value)).perp_dot(at - pole),
            Some(from) => turned(from - pole, DVec2::ZERO, value).perp_dot(at - pole) / self.size,
        }));
    }

    fn residuals(&self, x: &[f64]) -> Vec<f64> {
        let mut found = self.equations(x);
        let mut says = self.says.iter();
        found.retain(|_| says.next().copied().unwrap_or(true));
        found
    }

    fn jacobian(&self, x: &[f64]) -> Matrix {
        let step = self.size * DIFFERENCE;
        let mut at = x.to_vec();
        let columns: Vec<Vec<f64>> = (0..x.len())
            .map(|column| {
                at[column] = x[column] + step;
                let mut after = self.residuals(&at);
                at[column] = x[column] - step;
                for (after, before) in after.iter_mut().zip(self.residuals(&at)) {
                    *after = (*after - before) / (2.0 * step);
                }
                at[column] = x[column];
                after
            })
            .collect();
        Matrix::of_columns(&columns)
    }

    /// How many unknowns the equations determine where nothing is special.
    fn rank(&self) -> usize {
        let at = self.start(&mut Numbers(2), false);
        determined_columns(self.jacobian(&at)).0
    }

    /// The layout of what is determined.
    fn determined_part(&self) -> Option<Layout> {
        let at = self.start(&mut Numbers(2), false);
        let (_, determined) = determined_columns(self.jacobian(&at));
        let whole = |place: &Place, size: usize| match *place {
            Place::Unknown(first) => determined[first..first + size].iter().all(|own| *own),
            _ => false,
        };
        Layout::of(
            self.state,
            self.given,
            Some(&|is_curve, number| {
                if is_curve {
                    whole(&self.layout.curves[number], if is_arc(self.given, number) { 3 } else { 2 })
                } else {
                    whole(&self.layout.points[number], 2)
                }
            }),
        )
    }

    /// The layout of the first unknowns that depend on each other, and on no others, and are not too many.
    fn first_part(&self) -> Option<Layout> {
        let jacobian = self.jacobian(&self.start(&mut Numbers(2), false));
        // Of each unknown the first one on which it depends so far.
        let mut firsts: Vec<usize> = (0..self.layout.count).collect();
        let mut join = |a: usize, b: usize| {
            let (a, b) = (firsts[a], firsts[b]);
            let (low, high) = (a.min(b), a.max(b));
            firsts.iter_mut().filter(|first| **first == high).for_each(|first| *first = low);
        };
        for row in 0..jacobian.rows() {
            let mut columns = jacobian.row(row).iter().enumerate().filter(|(_, own)| own.abs() > 1e-12);
            if let Some((first, _)) = columns.next() {
                columns.for_each(|(column, _)| join(first, column));
            }
        }
        let curves =
            self.layout.curves.iter().enumerate().map(|(i, place)| (place, if is_arc(self.given, i) { 3 } else { 2 }));
        let points = self.layout.points.iter().map(|place| (place, 2));
        for (place, size) in curves.chain(points) {
            if let Place::Unknown(first) = *place {
                (first + 1..first + size).for_each(|own| join(first, own));
            }
        }
        let size = |own: usize| firsts.iter().filter(|first| **first == own).count();
        let chosen = firsts.iter().copied().find(|first| size(*first) <= MOST_UNKNOWNS)?;
        let is_in = |place: &Place| matches!(*place, Place::Unknown(first) if firsts[first] == chosen);
        Layout::of(
            self.state,
            self.given,
            Some(&|is_curve, number| {
                is_in(if is_curve { &self.layout.curves[number] } else { &self.layout.points[number] })
            }),
        )
    }

    /// A place from which solutions are looked for: points somewhere about the contour, lines and arcs between them; the
    /// arcs may be short, as roundings are.
    fn start(&self, numbers: &mut Numbers, short: bool) -> Vec<f64> {
        let mut x = vec![0.0; self.layout.count];
        let mut points = Vec::with_capacity(self.layout.points.len());
        for (joint, place) in self.layout.points.iter().enumerate() {
            let wide = DVec2::new(numbers.signed(), numbers.signed()) * self.size;
            let before = joint.checked_sub(1).filter(|before| short && is_arc(self.given, *before));
            let near = before.and_then(|before| points.get(before)).map(|before: &DVec2| *before + wide * SHORT);
            let at = self.state.at(joint).or(near).unwrap_or(self.middle + wide);
            if let Place::Unknown(first) = *place {
                x[first] = at.x;
                x[first + 1] = at.y;
            }
            points.push(at);
        }
        for (i, place) in self.layout.curves.iter().enumerate() {
            let (from, to) = (points[i], points[i + 1]);
            let (angle, sweep) = (numbers.next(), numbers.next());
            let Place::Unknown(first) = *place else { continue };
            let way = if length(to - from) > AGREE { to - from } else { DVec2::X };
            if is_arc(self.given, i) {
                // Of an angle from 20 to 340 degrees.
                let half = sweep * 160.0 + 10.0;
                let turn = self.state.elements[i].choice.turn;
                let radius = self.given[i].radius.unwrap_or(length(way) / (2.0 * sind(half)));
                let high = left_of(way / length(way)) * (radius * cosd(half) * turn);
                let centre = (from + to) / 2.0 + high;
                x[first..first + 3].copy_from_slice(&[centre.x, centre.y, radius * turn]);
            } else {
                let turned = libm::atan2(way.y, way.x) + (angle - 0.5);
                let (s, c) = libm::sincos(turned);
                x[first] = turned * self.size;
                x[first + 1] = DVec2::new(c, s).perp_dot((from + to) / 2.0 - self.middle);
            }
        }
        x
    }

    /// The nearest place downhill at which all equations hold as well as they can.
    fn search(&self, mut x: Vec<f64>) -> Option<Vec<f64>> {
        let square = |all: &[f64]| all.iter().map(|own| own * own).sum::<f64>();
        let (mut left, mut damping) = (self.residuals(&x), 1e-2);
        let mut cost = square(&left);
        for _ in 0..MOST_STEPS {
            let jacobian = self.jacobian(&x);
            let mut moved = None;
            for _ in 0..12 {
                let step = least_squares(&jacobian, &left, damping)?;
                let next: Vec<f64> = x.iter().zip(&step).map(|(x, step)| x - step).collect();
                let (after, far) = (self.residuals(&next), libm::sqrt(square(&step)));
                let own = square(&after);
                if own < cost || far < LAST_STEP * self.size {
                    moved = Some((next, after, own, far));
                    break;
                }
                damping = (damping * 8.0).max(1e-12);
            }
            // Where nothing is downhill any more it is as near as numbers come.
            let Some((next, after, own, far)) = moved else { break };
            (x, left, cost) = (next, after, own);
            damping *= 0.05;
            if far < LAST_STEP * self.size || cost == 0.0 {
                break;
            }
        }
        (cost < AGREE * AGREE * left.len() as f64).then_some(x)
    }

    fn solution(&self, x: &[f64]) -> Solution {
        let unknown = |place: &Place| matches!(place, Place::Unknown(_));
        let curves = (0..self.layout.curves.len()).filter(|i| unknown(&self.layout.curves[*i]));
        let points = (0..self.layout.points.len()).filter(|joint| unknown(&self.layout.points[*joint]));
        Solution {
            curves: curves.filter_map(|i| Some((i, self.curve(i, x)?))).collect(),
            points: points.filter_map(|joint| Some((joint, self.at(joint, x)?))).collect(),
        }
    }

    /// Whether the data of all elements agree, those of directions that are opposite in the equations, too.
    fn holds(&self, solution: &Solution) -> bool {
        let mut state = self.state.with_solution(solution);
        while state.learn(self.given) {}
        (0..state.elements.len()).all(|i| {
            let parallel = self.given.get(i).filter(|own| own.heading.is_none()).and_then(|own| own.parallel);
            let other = parallel.and_then(|(joint, _)| state.curve(joint.checked_sub(1)?));
            let directions = match (state.curve(i), other) {
                (Some(Curve::Line { along, .. }), Some(Curve::Line { along: v, .. })) => {
                    along.dot(v) * state.elements[i].choice.along > 0.0
                }
                _ => true,
            };
            directions && state.holds(self.given, i)
        })
    }

    /// All solutions; nothing where others lie beside them.
    fn solutions(&self) -> Option<Vec<Solution>> {
        let mut numbers = Numbers(3);
        let mut found: Vec<Solution> = Vec::new();
        let (mut last, mut loose) = (0, 0);
        for start in 0..MOST_STARTS {
            let quiet = if found.is_empty() { PATIENT_STARTS } else { QUIET_STARTS.max(2 * last) };
            if start - last > quiet {
                break;
            }
            let short = start > SHORT_AFTER && start % 2 == 1;
            let Some(x) = self.search(self.start(&mut numbers, short)) else { continue };
            let solution = self.solution(&x);
            if found.iter().any(|known| known.is(&solution)) || !self.holds(&solution) {
                continue;
            }
            if determined_columns(self.jacobian(&x)).0 < self.layout.count {
                loose += 1;
                if loose > MOST_LOOSE && found.is_empty() {
                    return None;
                }
                continue;
            }
            found.push(solution);
            last = start;
            if found.len() > MOST_SOLUTIONS {
                return None;
            }
        }
        // Where nothing was found more data may say why.
        (!found.is_empty()).then_some(found)
    }
}

impl Solution {
    fn is(&self, other: &Self) -> bool {
        let points = self.points.iter().zip(&other.points);
        let curves = self.curves.iter().zip(&other.curves);
        points.into_iter().all(|((_, a), (_, b))| length(a - b) < SAME)
            && curves.into_iter().all(|((_, a), (_, b))| a.is_within(b, SAME))
    }
}

fn is_arc(given: &[Given], i: usize) -> bool {
    given.get(i).is_some_and(|own| own.is_arc)
}

/// The least box around the points that the data name, and the greatest length among them.
fn extent(state: &State, given: &[Given]) -> (DVec2, DVec2, f64) {
    let mut points: Vec<DVec2> = (0..state.joints.len()).filter_map(|joint| state.at(joint)).collect();
    let mut reach: f64 = 0.0;
    let start = points.first().copied().unwrap_or_default();
    for own in given.iter().take(state.elements.len()) {
        points.extend(&own.on);
        points.extend(own.beside.map(|(at, _)| at));
        let pole = own.pole.unwrap_or_default();
        for point in [&own.end, &own.centre] {
            for (index, datum) in point.cartesian.iter().enumerate() {
                match datum {
                    Some(Datum { value, from: None }) => {
                        let mut at = start;
                        at[index] = *value;
                        points.push(at);
                    }
                    Some(Datum { value, .. }) => reach = reach.max(value.abs()),
                    None => {}
                }
            }
            if let Some(Datum { value, .. }) = point.polar[0] {
                points.push(pole);
                reach = reach.max(value.abs());
            }
        }
        let lengths = [own.radius, own.length, own.beside.map(|(_, far)| far), own.parallel.and_then(|(_, far)| far)];
        reach = lengths.into_iter().flatten().fold(reach, |reach, own| reach.max(own.abs()));
    }
    for curve in state.elements.iter().filter_map(|known| known.curve) {
        if let Curve::Circle { centre, radius } = curve {
            points.push(centre);
            reach = reach.max(radius.abs());
        }
    }
    let low = points.iter().copied().fold(start, DVec2::min);
    let high = points.iter().copied().fold(start, DVec2::max);
    (low, high, reach)
}
