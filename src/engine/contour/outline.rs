//! Closed paths of the tool in the working plane: outlines of pockets, slots and studs, and how the tool follows them.
//!
//! Invariant: outlines are counted from a place of the workpiece (a centre and a turn about it); they know nothing of
//! material, levels or cycles.
use glam::{DVec2, DVec3};

use crate::base::expr::{cosd, sind};
use crate::engine::motion::drives::Drives;
use crate::engine::motion::moves::Speed;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;

/// Where a figure lies in the working plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    /// Its centre.
    pub(crate) centre: DVec2,
    /// The direction of its first axis, degrees.
    pub(crate) rotation: f64,
}

impl Place {
    pub(crate) fn new(centre: DVec3, rotation: f64) -> Self {
        Self { centre: centre.truncate(), rotation }
    }

    /// The point of the working plane that the figure has there.
    pub(crate) fn at(&self, point: DVec2) -> DVec2 {
        let (c, s) = (cosd(self.rotation), sind(self.rotation));
        self.centre + DVec2::new(point.x * c - point.y * s, point.x * s + point.y * c)
    }

    /// The point of the figure that lies there in the working plane.
    pub(crate) fn back(&self, point: DVec2) -> DVec2 {
        let (c, s) = (cosd(self.rotation), sind(self.rotation));
        let arm = point - self.centre;
        DVec2::new(arm.x * c + arm.y * s, arm.y * c - arm.x * s)
    }
}

/// A piece of an outline, counter-clockwise about the figure.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Leg {
    Line(DVec2),
    /// Centre, end, direction (+ counter-clockwise).
    Arc(DVec2, DVec2, f64),
}

impl Leg {
    const fn end(&self) -> DVec2 {
        match self {
            Self::Line(end) | Self::Arc(_, end, _) => *end,
        }
    }
}

/// A closed path.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    /// Where it begins and ends.
    pub(crate) start: DVec2,
    /// The direction of travel at its beginning.
    pub(crate) heading: DVec2,
    legs: Vec<Leg>,
}

/// A quarter turn to the left.
pub(crate) fn left_of(direction: DVec2) -> DVec2 {
    DVec2::new(-direction.y, direction.x)
}

/// The unit vector of an angle in degrees.
pub(crate) fn unit(angle: f64) -> DVec2 {
    DVec2::new(cosd(angle), sind(angle))
}

impl Outline {
    /// A rectangle with half its sides and round corners; it begins in the middle of its right side.
    pub(crate) fn rectangle(half: DVec2, corner: f64) -> Self {
        let (a, b, c) = (half.x, half.y, corner);
        let (m, n) = (a - c, b - c);
        let mut legs = vec![Leg::Line(DVec2::new(a, n))];
        let corners = [
            (DVec2::new(m, n), DVec2::new(m, b), DVec2::new(-m, b)),
            (DVec2::new(-m, n), DVec2::new(-a, n), DVec2::new(-a, -n)),
            (DVec2::new(-m, -n), DVec2::new(-m, -b), DVec2::new(m, -b)),
            (DVec2::new(m, -n), DVec2::new(a, -n), DVec2::new(a, 0.0)),
        ];
        for (centre, after, next) in corners {
            if c > 0.0 {
                legs.push(Leg::Arc(centre, after, 1.0));
            }
            legs.push(Leg::Line(next));
        }
        Self { start: DVec2::new(a, 0.0), heading: DVec2::Y, legs }
    }

    /// A circle; it begins on its right.
    pub(crate) fn circle(radius: f64) -> Self {
        let start = DVec2::new(radius, 0.0);
        Self { start, heading: DVec2::Y, legs: vec![Leg::Arc(DVec2::ZERO, start, 1.0)] }
    }

    /// A slot between two half circles; it begins at its left end.
    pub(crate) fn slot(reach: f64, radius: f64) -> Self {
        let (left, right) = (DVec2::new(-reach, 0.0), DVec2::new(reach, 0.0));
        let (up, out) = (DVec2::new(0.0, radius), DVec2::new(radius, 0.0));
        Self {
            start: left - out,
            heading: -DVec2::Y,
            legs: vec![
                Leg::Arc(left, left - up, 1.0),
                Leg::Line(right - up),
                Leg::Arc(right, right + up, 1.0),
                Leg::Line(left + up),
                Leg::Arc(left, left - out, 1.0),
            ],
        }
    }

    /// A slot along a circle between two half circles; it begins at the end of the first half circle. The opening
    /// angle is positive; from 360 degrees on it is a whole ring.
    pub(crate) fn band(radius: f64, begin: f64, opening: f64, half: f64) -> Self {
        let first = unit(begin);
        let last = if opening >= 360.0 { first } else { unit(begin + opening) };
        let start = first * radius - left_of(first) * half;
        let mut legs = vec![Leg::Arc(first * radius, first * (radius + half), 1.0)];
        if opening > 0.0 {
            legs.push(Leg::Arc(DVec2::ZERO, last * (radius + half), 1.0));
        }
        legs.push(Leg::Arc(last * radius, last * (radius - half), 1.0));
        if opening > 0.0 {
            legs.push(Leg::Arc(DVec2::ZERO, first * (radius - half), -1.0));
        }
        legs.push(Leg::Arc(first * radius, start, 1.0));
        // The first half circle is entered in its middle, on the way outwards.
        Self { start, heading: first, legs }
    }

    /// The same path in the other direction if that is clockwise.
    pub(crate) fn towards(self, direction: f64) -> Self {
        if direction > 0.0 {
            return self;
        }
        let mut ends: Vec<DVec2> = std::iter::once(self.start).chain(self.legs.iter().map(Leg::end)).collect();
        ends.pop();
        let legs = self.legs.iter().rev().zip(ends.into_iter().rev());
        let legs = legs
            .map(|(leg, end)| match leg {
                Leg::Line(_) => Leg::Line(end),
                Leg::Arc(centre, _, direction) => Leg::Arc(*centre, end, -direction),
            })
            .collect();
        Self { start: self.start, heading: -self.heading, legs }
    }
}

/// A quarter circle by which the tool joins an outline or leaves it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tangent {
    /// Its centre.
    centre: DVec2,
    /// Where the tool begins to join.
    pub(crate) before: DVec2,
    /// Where it has left.
    pub(crate) after: DVec2,
    /// Counter-clockwise if positive.
    direction: f64,
}

impl Tangent {
    /// On the left of the direction of travel if `left` is positive.
    pub(crate) fn at(outline: &Outline, radius: f64, left: f64) -> Self {
        let centre = outline.start + left_of(outline.heading) * (radius * left);
        let arm = outline.heading * radius;
        Self { centre, before: centre - arm, after: centre + arm, direction: left }
    }
}

impl Drives<'_, '_> {
    /// Straight to a point of the figure at the present height.
    pub(crate) fn mill_to(&mut self, place: &Place, to: DVec2, feed: f64) -> Done {
        let height = self.in_plane(self.world.here).z;
        self.mill_to_height(place, to, height, feed)
    }

    /// Straight to a point of the figure at a height.
    pub(crate) fn mill_to_height(&mut self, place: &Place, to: DVec2, height: f64, feed: f64) -> Done {
        let to = self.world.system.axes(place.at(to).extend(height));
        self.straight_to(to, None, Speed::of_feed(feed))
    }

    /// Straight along the tool axis.
    pub(crate) fn mill_down(&mut self, height: f64, feed: f64) -> Done {
        let to = self.in_plane(self.world.here).truncate().extend(height);
        self.straight_to(self.world.system.axes(to), None, Speed::of_feed(feed))
    }

    /// On an arc to a point of the figure at a height.
    pub(crate) fn mill_around(
        &mut self,
        place: &Place,
        (centre, to): (DVec2, DVec2),
        height: f64,
        direction: f64,
        feed: f64,
    ) -> Done {
        let system = &self.world.system;
        let centre = system.axes(place.at(centre).extend(height));
        let to = system.axes(place.at(to).extend(height));
        self.arc_to(centre, to, direction, None, Speed::of_feed(feed))
    }

    /// Once around; the tool is at the beginning of the outline.
    pub(crate) fn mill_outline(&mut self, place: &Place, outline: &Outline, feed: f64) -> Done {
        let height = self.in_plane(self.world.here).z;
        for leg in &outline.legs {
            match leg {
                Leg::Line(to) => self.mill_to(place, *to, feed)?,
                Leg::Arc(centre, to, direction) => {
                    self.mill_around(place, (*centre, *to), height, *direction, feed)?;
                }
            }
        }
        Ok(())
    }

    /// Joins an outline on a quarter circle.
    pub(crate) fn mill_join(&mut self, place: &Place, tangent: &Tangent, outline: &Outline, feed: f64) -> Done {
        let height = self.in_plane(self.world.here).z;
        self.mill_to(place, tangent.before, feed)?;
        self.mill_around(place, (tangent.centre, outline.start), height, tangent.direction, feed)
    }

    /// Leaves an outline on a quarter circle.
    pub(crate) fn mill_leave(&mut self, place: &Place, tangent: &Tangent, feed: f64) -> Done {
        let height = self.in_plane(self.world.here).z;
        self.mill_around(place, (tangent.centre, tangent.after), height, tangent.direction, feed)
    }

    /// The fault of a figure that no path of this tool makes.
    pub(crate) fn shape_impossible(&self, least: f64, found: f64) -> Fault {
        Fault::control("shape-impossible").arg("least", least).arg("found", found)
    }
}
