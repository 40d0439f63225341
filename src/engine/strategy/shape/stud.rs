//! Strategies that mill around a stud at one level, from the blank to the stud.
//!
//! Invariant: the stud with its allowance is never crossed; the laps have equal distances, none greater than asked for.
use glam::{DVec2, DVec3};

use crate::base::expr::atan2d;
use crate::engine::geometry::left_of;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::milling::{MAX_OUTLINES, Milling, shape_impossible, too_many};
use crate::engine::strategy::outline::{Outline, Place, Tangent};
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::strategy;

/// What calculation may add to a whole number of laps.
const SPARE: f64 = 1e-9;
/// How far next to the blank the tool begins, mm.
const BESIDE: f64 = 2.0;

strategy! {
    /// Mills around a rectangular stud at one level, from the blank to the stud.
    MillRectangularStudLevel = "mill-rectangular-stud-level" {
        /// The middle of the stud.
        centre: DVec3 = Length,
        /// Climb milling if positive, for a spindle that turns clockwise.
        climb: f64 = Number,
        /// Its side along its first axis, mm.
        length: f64 = Length,
        /// Its other side, mm.
        width: f64 = Length,
        /// The radius of its corners, mm.
        corner: f64 = Length,
        /// The direction of its first axis, degrees.
        rotation: f64 = Angle,
        /// The greatest distance of the laps, mm.
        stepover: f64 = Length,
        /// What stays on the stud, mm.
        allowance: f64 = Length,
        /// The side of the blank along the first axis, mm.
        blank_length: f64 = Length,
        /// Its other side, mm.
        blank_width: f64 = Length,
        /// 0: from the right of the blank; 1 to 4: from a corner, counter-clockwise from the lower left one.
        approach: f64 = Number,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// Mills around a circular stud at one level: from where the tool is on a spiral of half circles, and once around.
    MillCircularStudLevel = "mill-circular-stud-level" {
        /// The centre of the stud.
        centre: DVec3 = Length,
        /// Climb milling if positive, for a spindle that turns clockwise.
        climb: f64 = Number,
        /// Its diameter, mm.
        diameter: f64 = Length,
        /// The greatest distance of the turns, mm.
        stepover: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// Half a turn to the other side of a centre, to a point at another distance from it.
    HalfTurn = "half-turn" {
        /// The centre.
        centre: DVec3 = Length,
        /// Clockwise if negative, otherwise counter-clockwise.
        direction: f64 = Number,
        /// The distance of its end from the centre, mm.
        radius: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

impl Milling for MillRectangularStudLevel {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let stud = self.stud(tool)?;
        match self.approach {
            1.0 => stud.begin_at_corner(DVec2::new(-1.0, -1.0), pen),
            2.0 => stud.begin_at_corner(DVec2::new(1.0, -1.0), pen),
            3.0 => stud.begin_at_corner(DVec2::new(1.0, 1.0), pen),
            4.0 => stud.begin_at_corner(DVec2::new(-1.0, 1.0), pen),
            _ => stud.begin_at_right(pen),
        }
        Ok(())
    }
}

impl MillRectangularStudLevel {
    fn stud(&self, tool: Cutter) -> Result<Stud, Fault> {
        let Self { length, width, stepover, allowance, .. } = *self;
        if 2.0 * self.corner > length.min(width) + SPARE {
            return Err(shape_impossible(2.0 * self.corner, length.min(width)));
        }
        let (size, blank) = (DVec2::new(length, width) / 2.0, DVec2::new(self.blank_length, self.blank_width) / 2.0);
        let corner = self.corner + allowance;
        let over = (blank - size - DVec2::splat(allowance)).max(DVec2::ZERO);
        let room = over.max_element();
        let least = libm::ceil(room / stepover - SPARE).max(1.0);
        let step = room / least;
        // The corners of the blank lie farther out than its sides: laps outside of them reach these.
        let arm = over + DVec2::splat(corner);
        let beyond = libm::hypot(arm.x, arm.y) - corner - 2.0 * tool.radius;
        let more = if step > 0.0 { libm::ceil(beyond / step - SPARE) } else { 0.0 };
        let laps = least.max(more + 1.0);
        if laps.is_nan() || laps > MAX_OUTLINES {
            return Err(too_many(MAX_OUTLINES));
        }
        Ok(Stud {
            place: Place::new(self.centre, self.rotation),
            half: size + DVec2::splat(allowance + tool.radius),
            corner: corner + tool.radius,
            blank,
            tool_radius: tool.radius,
            step,
            laps: laps as u32,
            direction: if self.climb < 0.0 { 1.0 } else { -1.0 },
            feed: self.at,
        })
    }
}

impl Milling for MillCircularStudLevel {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let (place, from) = polar_place(self.centre, tool, pen)?;
        let to = self.diameter / 2.0 + tool.radius;
        let direction = if self.climb < 0.0 { 1.0 } else { -1.0 };
        let halves = libm::ceil(2.0 * (from - to).abs() / self.stepover - SPARE).max(1.0);
        if halves.is_nan() || halves > 2.0 * MAX_OUTLINES {
            return Err(too_many(MAX_OUTLINES));
        }
        let halves = halves as u32;
        let at = |half: u32| {
            let share = f64::from(half) / f64::from(halves);
            let distance = if half == halves { to } else { from + (to - from) * share };
            DVec2::new(if half.is_multiple_of(2) { distance } else { -distance }, 0.0)
        };
        let height = pen.here().z;
        for half in 1..=halves {
            let (now, next) = (at(half - 1), at(half));
            pen.around(&place, ((now + next) / 2.0, next), height, direction, self.at);
        }
        pen.around(&place, (DVec2::ZERO, at(halves)), height, direction, self.at);
        Ok(())
    }
}

impl Milling for HalfTurn {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let (place, from) = polar_place(self.centre, tool, pen)?;
        let (now, next) = (DVec2::new(from, 0.0), DVec2::new(-self.radius, 0.0));
        let direction = if self.direction < 0.0 { -1.0 } else { 1.0 };
        pen.around(&place, ((now + next) / 2.0, next), pen.here().z, direction, self.at);
        Ok(())
    }
}

/// A place at the centre, with its first axis towards the tool, and how far the tool is from it.
fn polar_place(centre: DVec3, tool: Cutter, pen: &Pen) -> Result<(Place, f64), Fault> {
    let arm = (pen.here() - centre).truncate();
    let distance = libm::hypot(arm.x, arm.y);
    if distance == 0.0 {
        return Err(shape_impossible(tool.radius, distance));
    }
    Ok((Place::new(centre, atan2d(arm.y, arm.x)), distance))
}

/// A rectangular stud with its blank.
struct Stud {
    place: Place,
    /// Half the sides of the path along the stud.
    half: DVec2,
    /// The radius of the path about the corners.
    corner: f64,
    /// Half the sides of the blank.
    blank: DVec2,
    tool_radius: f64,
    /// The distance of the laps, and how many there are.
    step: f64,
    laps: u32,
    direction: f64,
    feed: f64,
}

impl Stud {
    /// How far a lap lies outside of the last one.
    fn outside(&self, lap: u32) -> f64 {
        f64::from(self.laps - lap) * self.step
    }

    fn outline(&self, lap: u32) -> Outline {
        let outside = self.outside(lap);
        Outline::rectangle(self.half + DVec2::splat(outside), self.corner + outside).towards(self.direction)
    }

    /// From the right of the blank on a quarter circle to the first lap, lap by lap, and away on a quarter circle.
    fn begin_at_right(&self, pen: &mut Pen) {
        let Self { place, feed, .. } = self;
        let beside = self.blank.x + BESIDE + self.tool_radius;
        let tangent = |outline: &Outline| {
            let room = beside - outline.start.x;
            Tangent::at(outline, if room > SPARE { room } else { BESIDE }, -self.direction)
        };
        for lap in 1..=self.laps {
            let outline = self.outline(lap);
            if lap == 1 {
                pen.join(place, &tangent(&outline), &outline, *feed);
            } else {
                pen.to(place, outline.start, *feed);
            }
            pen.outline(place, &outline, *feed);
            if lap == self.laps {
                pen.leave(place, &tangent(&outline), *feed);
            }
        }
    }

    /// From a corner along the first side of the first lap, lap by lap inwards, and away on a quarter circle.
    fn begin_at_corner(&self, corner: DVec2, pen: &mut Pen) {
        let Self { place, feed, direction, .. } = self;
        // Along the first side, and from it towards the stud.
        let first =
            if corner.x * corner.y * direction < 0.0 { DVec2::new(0.0, -corner.y) } else { DVec2::new(-corner.x, 0.0) };
        let inwards = left_of(first) * *direction;
        let point = |x: f64, y: f64| first * x + inwards * y;
        let along = |half: DVec2| DVec2::new((half * first).abs().element_sum(), (half * inwards).abs().element_sum());
        let height = pen.here().z;
        let begin = along(self.blank).x + BESIDE + self.tool_radius;
        for lap in 1..=self.laps {
            let outside = self.outside(lap);
            let (half, c) = (along(self.half) + DVec2::splat(outside), self.corner + outside);
            let (a, b) = (half.x, half.y);
            if lap == 1 {
                pen.to(place, point(-begin, -b), *feed);
            }
            let around = |pen: &mut Pen, x: f64, y: f64, to: DVec2| {
                pen.around(place, (point(x, y), to), height, *direction, *feed);
            };
            pen.to(place, point(a - c, -b), *feed);
            around(pen, a - c, c - b, point(a, c - b));
            pen.to(place, point(a, b - c), *feed);
            around(pen, a - c, b - c, point(a - c, b));
            pen.to(place, point(c - a, b), *feed);
            around(pen, c - a, b - c, point(-a, b - c));
            pen.to(place, point(-a, c - b), *feed);
            around(pen, c - a, c - b, point(c - a, -b));
            if lap < self.laps {
                pen.to(place, point(c - a, self.step - b), *feed);
            } else {
                let (centre, to) = (point(c - a, -b - BESIDE), point(c - a + BESIDE, -b - BESIDE));
                pen.around(place, (centre, to), height, -direction, *feed);
            }
        }
    }
}
