//! Curves with a direction, as elements of a contour lie on them, and what determines them.
//!
//! A line and a circle have a left side. Two of them touch where they meet with one direction. That a line or circle
//! passes a point, leaves it at a distance, or touches another one are conditions of one kind: linear in the position of
//! a line with a known direction, and for circles quadratic with the same quadratic part, `x² + y² - r²`, so that two
//! of them differ by a linear one (the problem of Apollonius with directed circles).
use glam::DVec2;

use crate::engine::contour::element::{direction, length};
use crate::engine::geometry::left_of;

/// Lengths in mm below this are none.
pub(super) const NOTHING: f64 = 1e-9;
/// A point that misses a curve by no more, mm, lies on it; that much the numbers of a program leave open.
pub(super) const AGREE: f64 = 0.001;
/// A point this close to a curve, mm, is where a line or circle touches it; they do not meet twice.
const TOUCH: f64 = 1e-8;
/// Equations whose coefficients are smaller after elimination say nothing.
const SINGULAR: f64 = 1e-9;

/// A line or a circle with a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Curve {
    /// Through a point, along a unit vector.
    Line { point: DVec2, along: DVec2 },
    /// About a centre; the radius is positive counter-clockwise, negative clockwise.
    Circle { centre: DVec2, radius: f64 },
}

/// A condition on a curve: a line or circle that it touches with the same direction, or a point, a circle without radius.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact(pub(super) Curve);

/// Where a point can lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Locus {
    Point(DVec2),
    /// A line; whether it is that of an element, with its direction.
    Line {
        point: DVec2,
        along: DVec2,
        of_element: bool,
    },
    Circle {
        centre: DVec2,
        radius: f64,
    },
}

impl Contact {
    /// That the curve passes a point.
    pub(super) const fn point(at: DVec2) -> Self {
        Self(Curve::Circle { centre: at, radius: 0.0 })
    }

    /// That a point lies so far to the left of the curve.
    pub(super) const fn aside(at: DVec2, left: f64) -> Self {
        Self(Curve::Circle { centre: at, radius: left })
    }
}

impl Curve {
    /// How far a point lies to the left of it.
    pub(super) fn left(&self, at: DVec2) -> f64 {
        match *self {
            Self::Line { point, along } => along.perp_dot(at - point),
            Self::Circle { centre, radius } => {
                let far = length(at - centre);
                if radius > 0.0 { radius - far } else { far + radius }
            }
        }
    }

    /// The direction at one of its points.
    pub(super) fn heading(&self, at: DVec2) -> Option<DVec2> {
        match *self {
            Self::Line { along, .. } => Some(along),
            Self::Circle { centre, radius } => direction(left_of(at - centre) * radius.signum()),
        }
    }

    /// The point of a circle at which it has that direction.
    pub(super) fn at_heading(&self, heading: DVec2) -> Option<DVec2> {
        match *self {
            Self::Line { .. } => None,
            Self::Circle { centre, radius } => Some(centre - left_of(heading) * radius),
        }
    }

    /// Where another curve touches it; nothing of two that are the same.
    pub(super) fn touches(&self, other: &Self) -> Option<DVec2> {
        match (*self, *other) {
            (Self::Line { .. }, Self::Line { .. }) => None,
            (Self::Line { along, .. }, circle @ Self::Circle { .. })
            | (circle @ Self::Circle { .. }, Self::Line { along, .. }) => circle.at_heading(along),
            (Self::Circle { centre: m, radius: r }, Self::Circle { centre: n, radius: s }) => {
                let left = direction((m - n) * (r - s).signum()).filter(|_| length(m - n) > AGREE)?;
                Some(m - left * r)
            }
        }
    }

    pub(super) const fn locus(&self) -> Locus {
        match *self {
            Self::Line { point, along } => Locus::Line { point, along, of_element: true },
            Self::Circle { centre, radius } => Locus::Circle { centre, radius: radius.abs() },
        }
    }

    /// Whether both are one.
    pub(super) fn is(&self, other: &Self) -> bool {
        self.is_within(other, 1e-7)
    }

    /// Whether both are one within a length, mm, and a hundredth of that as an angle.
    pub(super) fn is_within(&self, other: &Self, near: f64) -> bool {
        match (*self, *other) {
            (Self::Line { point, along }, Self::Line { point: q, along: v }) => {
                length(along - v) < near / 100.0 && along.perp_dot(q - point).abs() < near
            }
            (Self::Circle { centre, radius }, Self::Circle { centre: n, radius: s }) => {
                length(centre - n) < near && (radius - s).abs() < near
            }
            _ => false,
        }
    }

    /// The radius of a circle, mm; a line has none.
    pub(super) const fn size(&self) -> f64 {
        match *self {
            Self::Line { .. } => 0.0,
            Self::Circle { radius, .. } => radius.abs(),
        }
    }
}

impl Locus {
    pub(super) fn moved(self, by: DVec2) -> Self {
        match self {
            Self::Point(at) => Self::Point(at + by),
            Self::Line { point, along, of_element } => Self::Line { point: point + by, along, of_element },
            Self::Circle { centre, radius } => Self::Circle { centre: centre + by, radius },
        }
    }

    /// How far a point is off.
    pub(super) fn off(&self, at: DVec2) -> f64 {
        match *self {
            Self::Point(own) => length(own - at),
            Self::Line { point, along, .. } => along.perp_dot(at - point).abs(),
            Self::Circle { centre, radius } => (length(at - centre) - radius).abs(),
        }
    }

    /// The points that lie on both. Nothing where both are one, or so nearly parallel that they say the same.
    /// On a line the point that comes later comes first; of two circles the one to the left of the way from the first
    /// centre to the second one.
    pub(super) fn meets(&self, other: &Self) -> Option<Vec<DVec2>> {
        match (*self, *other) {
            (Self::Point(at), on) | (on, Self::Point(at)) => {
                Some(if on.off(at) <= AGREE { vec![at] } else { Vec::new() })
            }
            (Self::Line { point, along, .. }, Self::Line { point: q, along: v, .. }) => {
                let cross = along.perp_dot(v);
                if cross.abs() < 1e-7 {
                    let apart = along.perp_dot(q - point).abs();
                    return if apart <= AGREE { None } else { Some(Vec::new()) };
                }
                Some(vec![point + along * ((q - point).perp_dot(v) / cross)])
            }
            (line @ Self::Line { .. }, circle @ Self::Circle { .. })
            | (circle @ Self::Circle { .. }, line @ Self::Line { .. }) => {
                let (Self::Line { point, along, .. }, Self::Circle { centre, radius }) = (line, circle) else {
                    return None;
                };
                let foot = point + along * (centre - point).dot(along);
                Some(either_side(foot, along, length(centre - foot), radius))
            }
            (Self::Circle { centre: m, radius: r }, Self::Circle { centre: n, radius: s }) => {
                let far = length(n - m);
                if far <= AGREE {
                    return if (r - s).abs() <= AGREE { None } else { Some(Vec::new()) };
                }
                let along = (n - m) / far;
                let foot = (far * far + r * r - s * s) / (2.0 * far);
                // Beyond the circles by rounding alone they touch.
                if foot.abs() > r {
                    let gap = if far > r + s { far - r - s } else { (r - s).abs() - far };
                    let touching = m + along * (r * foot.signum());
                    return Some(if gap <= AGREE { vec![touching] } else { Vec::new() });
                }
                Some(either_side(m + along * foot, left_of(along), foot.abs(), r))
            }
        }
    }
}

/// Two points of a circle on both sides of the middle of their chord, which lies so far from the centre.
fn either_side(middle: DVec2, along: DVec2, far: f64, radius: f64) -> Vec<DVec2> {
    if far > radius + AGREE {
        return Vec::new();
    }
    if far > radius - TOUCH {
        return vec![middle];
    }
    let half = libm::sqrt((radius * radius - far * far).max(0.0));
    vec![middle + along * half, middle - along * half]
}

/// The line in a direction that meets a condition.
pub(super) fn line_along(along: DVec2, contact: &Contact) -> Option<Curve> {
    match contact.0 {
        Curve::Circle { centre, radius } => Some(Curve::Line { point: centre - left_of(along) * radius, along }),
        Curve::Line { .. } => None,
    }
}

/// The lines that meet two conditions, the one that goes from the first one to the second one first; nothing where the
/// conditions are one.
pub(super) fn lines(a: &Contact, b: &Contact) -> Option<Vec<Curve>> {
    let (Curve::Circle { centre: m, radius: r }, Curve::Circle { centre: n, radius: s }) = (a.0, b.0) else {
        return None;
    };
    let far = length(n - m);
    if far <= AGREE {
        return None;
    }
    let (way, share) = ((n - m) / far, (s - r) / far);
    if share.abs() > 1.0 {
        return Some(Vec::new());
    }
    // The left normal of the line: its share along the way between the centres is given.
    let across = libm::sqrt(1.0 - share * share);
    let of = |across: f64| {
        let normal = way * share + left_of(way) * across;
        Curve::Line { point: m - normal * r, along: DVec2::new(normal.y, -normal.x) }
    };
    Some(vec![of(across), of(-across)])
}

/// Conditions on a circle: `x`, `y` of its centre and its signed radius.
#[derive(Clone, Debug, Default)]
pub(super) struct Circles {
    /// Linear ones: coefficients and value.
    rows: Vec<([f64; 3], f64)>,
    /// What it touches.
    contacts: Vec<(DVec2, f64)>,
    /// Circles on which its centre lies.
    centres: Vec<(DVec2, f64)>,
}

impl Circles {
    pub(super) fn row(&mut self, coefficients: [f64; 3], value: f64) {
        self.rows.push((coefficients, value));
    }

    /// The same with its centre known.
    pub(super) fn about(&self, centre: DVec2) -> Self {
        let mut own = self.clone();
        own.centres.clear();
        own.rows.insert(0, ([1.0, 0.0, 0.0], centre.x));
        own.rows.insert(1, ([0.0, 1.0, 0.0], centre.y));
        own
    }

    pub(super) fn radius(&mut self, radius: f64) {
        self.row([0.0, 0.0, 1.0], radius);
    }

    pub(super) fn centre_on(&mut self, centre: DVec2, radius: f64) {
        self.centres.push((centre, radius));
    }

    /// It passes a point in a direction.
    pub(super) fn passes(&mut self, at: DVec2, heading: DVec2) {
        let left = left_of(heading);
        self.row([1.0, 0.0, -left.x], at.x);
        self.row([0.0, 1.0, -left.y], at.y);
    }

    pub(super) fn contact(&mut self, contact: &Contact) {
        match contact.0 {
            Curve::Line { point, along } => {
                let left = left_of(along);
                self.row([left.x, left.y, -1.0], left.dot(point));
            }
            Curve::Circle { centre, radius } => self.contacts.push((centre, radius)),
        }
    }

    /// The circles that meet the conditions; nothing where they are too few.
    pub(super) fn solve(&self) -> Option<Vec<Curve>> {
        let mut rows = self.rows.clone();
        let known = rows.iter().find(|(row, _)| row[0] == 0.0 && row[1] == 0.0).map(|(_, value)| *value);
        // (x - a)² + (y - b)² - (r - s)² = 0, and (x - a)² + (y - b)² = ρ²: what is linear in them, and what is left.
        let touching = |&(at, s): &(DVec2, f64)| ([-2.0 * at.x, -2.0 * at.y, 2.0 * s], s * s - at.dot(at));
        let about = |&(at, rho): &(DVec2, f64)| ([-2.0 * at.x, -2.0 * at.y, 0.0], rho * rho - at.dot(at));
        let mut quadratic: Vec<(bool, [f64; 3], f64)> = Vec::new();
        for contact in &self.contacts {
            let (row, value) = touching(contact);
            match known {
                // With a radius that is known they are circles about a point, too.
                Some(r) => quadratic.push((true, [row[0], row[1], 0.0], value + r * r - row[2] * r)),
                None => quadratic.push((false, row, value)),
            }
        }
        for centre in &self.centres {
            let (row, value) = about(centre);
            quadratic.push((true, row, value));
        }
        // Two of one kind differ by a linear condition.
        for kind in [false, true] {
            let mut own = quadratic.iter().filter(|(about, ..)| *about == kind);
            let Some((_, first, constant)) = own.next() else { continue };
            for (_, row, value) in own {
                rows.push(([row[0] - first[0], row[1] - first[1], row[2] - first[2]], value - constant));
            }
        }
        let (rank, space) = eliminated(rows);
        match rank {
            3 => Some(circle(space.point).into_iter().collect()),
            2 => {
                let (about, row, value) = quadratic.first()?;
                Some(roots(&space, *about, row, *value).into_iter().filter_map(circle).collect())
            }
            _ => None,
        }
    }
}

fn circle([x, y, radius]: [f64; 3]) -> Option<Curve> {
    (radius.abs() > AGREE).then_some(Curve::Circle { centre: DVec2::new(x, y), radius })
}

/// What linear conditions leave: a point, and a direction in which it can go.
struct Space {
    point: [f64; 3],
    along: [f64; 3],
}

/// The rank of linear conditions, and what they leave of space.
fn eliminated(mut rows: Vec<([f64; 3], f64)>) -> (usize, Space) {
    let mut pivots: Vec<usize> = Vec::with_capacity(3);
    let mut rank = 0;
    while rank < rows.len().min(3) {
        // The greatest coefficient of all that are left.
        let mut best = (rank, 0, 0.0_f64);
        for (at, (row, _)) in rows.iter().enumerate().skip(rank) {
            let size = row.iter().fold(0.0_f64, |size, own| size.max(own.abs())).max(1.0);
            for (column, own) in row.iter().enumerate().filter(|(column, _)| !pivots.contains(column)) {
                if own.abs() / size > best.2 {
                    best = (at, column, own.abs() / size);
                }
            }
        }
        let (at, column, size) = best;
        if size < SINGULAR {
            break;
        }
        rows.swap(rank, at);
        let (row, value) = rows[rank];
        let pivot = row[column];
        let (row, value) = (row.map(|own| own / pivot), value / pivot);
        rows[rank] = (row, value);
        for (other, (own, own_value)) in rows.iter_mut().enumerate() {
            let factor = own[column];
            if other != rank && factor != 0.0 {
                for (own, by) in own.iter_mut().zip(row) {
                    *own -= factor * by;
                }
                own[column] = 0.0;
                *own_value -= factor * value;
            }
        }
        pivots.push(column);
        rank += 1;
    }
    let (mut point, mut along) = ([0.0; 3], [0.0; 3]);
    let free = (0..3).find(|column| !pivots.contains(column));
    for (column, (row, value)) in pivots.iter().zip(&rows) {
        point[*column] = *value;
        if let Some(free) = free {
            along[*column] = -row[free];
        }
    }
    if let Some(free) = free {
        along[free] = 1.0;
    }
    (rank, Space { point, along })
}

/// The points of a line in space that meet a quadratic condition: `x² + y² (- r²) + row · (x, y, r) = value`.
fn roots(space: &Space, about: bool, row: &[f64; 3], value: f64) -> Vec<[f64; 3]> {
    let sign = [1.0, 1.0, if about { 0.0 } else { -1.0 }];
    let Space { point: p, along: q } = space;
    let sum = |of: &dyn Fn(usize) -> f64| (0..3).map(of).sum::<f64>();
    let a = sum(&|i| sign[i] * q[i] * q[i]);
    let b = sum(&|i| sign[i] * p[i] * q[i] + row[i] * q[i] / 2.0);
    let c = sum(&|i| sign[i] * p[i] * p[i] + row[i] * p[i]) - value;
    let at = |t: f64| [p[0] + t * q[0], p[1] + t * q[1], p[2] + t * q[2]];
    let size = sum(&|i| q[i] * q[i]);
    if a.abs() < 1e-9 * size {
        return if b.abs() < NOTHING { Vec::new() } else { vec![at(-c / (2.0 * b))] };
    }
    let (middle, square) = (-b / a, (b * b - a * c) / (a * a));
    // Half the distance of both, mm: where they miss each other by rounding, they are one.
    let half = square * size;
    if half < -AGREE {
        return Vec::new();
    }
    if half < 1e-10 {
        return vec![at(middle)];
    }
    let half = libm::sqrt(square);
    vec![at(middle + half), at(middle - half)]
}
