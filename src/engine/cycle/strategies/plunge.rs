//! Strategies that bring a milling tool to the next level: on a helix and in strokes to and fro.
//!
//! Invariant: one level at a time, from one height to another; which cycle plunges is not known here.
use glam::DVec3;

use crate::base::expr::{cosd, sind, tand};
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::motion::moves::Speed;
use crate::engine::plan::StrategyCall;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::{Class, Fault};

/// More turns or strokes for one level than this are refused.
const MAX_PASSES: f64 = 10_000.0;
/// What calculation may add to a whole number of turns or strokes.
const SPARE: f64 = 1e-9;

/// What both ways of plunging need.
struct Descent {
    /// The middle of the plunge, main and secondary axis; the third component is not used.
    centre: DVec3,
    /// The height where material begins.
    from: f64,
    /// The height of the level.
    to: f64,
    /// The greatest plunging angle, degrees.
    angle: f64,
    /// mm/min.
    feed: f64,
}

impl Descent {
    fn depth(&self) -> f64 {
        (self.to - self.from).abs()
    }

    /// How many passes of a length go down at no more than the plunging angle.
    fn passes(&self, length: f64) -> Result<u32, Fault> {
        let drop = length * tand(self.angle);
        if drop.is_nan() || drop <= 0.0 {
            let fault = Fault::control("infeeds-never-arrive").arg("reached", 0.0).arg("depth", self.depth());
            return Err(fault.arg("first", 0.0).arg("less", 0.0).arg("least", 0.0));
        }
        let passes = libm::ceil(self.depth() / drop - SPARE).max(1.0);
        if passes > MAX_PASSES {
            return Err(Fault::new(Class::Limit, "series-limit").arg("limit", MAX_PASSES));
        }
        Ok(passes as u32)
    }

    /// The height after so many of so many equal parts of the way.
    fn height(&self, part: u32, parts: u32) -> f64 {
        let share = f64::from(part) / f64::from(parts);
        if part < parts { self.from + (self.to - self.from) * share } else { self.to }
    }

    /// The point next to the centre at a distance in a direction of the working plane.
    fn beside(&self, distance: f64, direction: f64, height: f64) -> DVec3 {
        let (main, minor) = (distance * cosd(direction), distance * sind(direction));
        DVec3::new(self.centre.x + main, self.centre.y + minor, height)
    }
}

impl<'e> Run<'_, 'e> {
    /// Down on a helix whose path has the given radius, then once around to level the bottom, then to the centre.
    pub(super) fn plunge_on_helix(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let descent = self.descent(call, exec)?;
        let (radius, direction) = (self.given(call, 5, exec)?, self.given(call, 6, exec)?);
        let direction = if direction < 0.0 { -1.0 } else { 1.0 };
        let turns = descent.passes(2.0 * std::f64::consts::PI * radius)?;
        let here = self.drives.in_plane(self.drives.world.here).z;
        self.plunge_to(descent.beside(radius, 0.0, here), descent.feed)?;
        self.plunge_to(descent.beside(radius, 0.0, descent.from), descent.feed)?;
        for half in 1..=2 * turns {
            let side = if half % 2 == 0 { 0.0 } else { 180.0 };
            let to = descent.beside(radius, side, descent.height(half, 2 * turns));
            self.plunge_around(&descent, to, direction)?;
        }
        self.plunge_around(&descent, descent.beside(radius, 0.0, descent.to), direction)?;
        self.plunge_to(descent.beside(0.0, 0.0, descent.to), descent.feed)
    }

    /// Down in strokes about the centre, then once along the bottom to level it, then to the centre. A stroke is as
    /// long as the plunging angle asks for, at least `least` and at most `room`.
    pub(super) fn plunge_in_strokes(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let descent = self.descent(call, exec)?;
        let (rotation, least, room) =
            (self.given(call, 5, exec)?, self.given(call, 6, exec)?, self.given(call, 7, exec)?);
        let length = (descent.depth() / tand(descent.angle)).max(least).min(room);
        let strokes = descent.passes(length)?;
        let end = |number: u32| if number.is_multiple_of(2) { -length / 2.0 } else { length / 2.0 };
        self.plunge_to(descent.beside(0.0, rotation, descent.from), descent.feed)?;
        self.plunge_to(descent.beside(end(0), rotation, descent.from), descent.feed)?;
        for stroke in 1..=strokes {
            let height = descent.height(stroke, strokes);
            self.plunge_to(descent.beside(end(stroke), rotation, height), descent.feed)?;
        }
        self.plunge_to(descent.beside(end(strokes + 1), rotation, descent.to), descent.feed)?;
        self.plunge_to(descent.beside(0.0, rotation, descent.to), descent.feed)
    }

    /// Down in strokes from one end of a slot to the other, beginning at the left one.
    pub(super) fn plunge_along_slot(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let descent = self.descent(call, exec)?;
        let [rotation, length] = self.all_given(call, 5, exec)?;
        let strokes = descent.passes(length)?;
        let end = |number: u32| if number.is_multiple_of(2) { -length / 2.0 } else { length / 2.0 };
        for stroke in 0..=strokes {
            let height = descent.height(stroke, strokes);
            self.plunge_to(descent.beside(end(stroke), rotation, height), descent.feed)?;
        }
        Ok(())
    }

    /// Down in strokes from one end of a circular slot to the other, beginning at its starting angle.
    pub(super) fn plunge_along_circular_slot(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let descent = self.descent(call, exec)?;
        let [diameter, begin, opening] = self.all_given(call, 5, exec)?;
        let radius = diameter / 2.0;
        let strokes = descent.passes(radius * opening.abs().to_radians())?;
        let angle = |number: u32| if number.is_multiple_of(2) { begin } else { begin + opening };
        self.plunge_to(descent.beside(radius, begin, descent.from), descent.feed)?;
        for stroke in 1..=strokes {
            let to = descent.beside(radius, angle(stroke), descent.height(stroke, strokes));
            let forward = if stroke % 2 == 1 { opening } else { -opening };
            self.plunge_around(&descent, to, forward.signum())?;
        }
        Ok(())
    }

    fn descent(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<Descent, Fault> {
        let centre = self.point(Self::argument(call, 0)?, exec)?;
        let [from, to, angle, feed] = self.all_given(call, 1, exec)?;
        Ok(Descent { centre, from, to, angle, feed })
    }

    fn plunge_to(&mut self, to: DVec3, feed: f64) -> Done {
        let to = self.drives.world.system.axes(to);
        self.drives.straight_to(to, None, Speed::of_feed(feed))
    }

    fn plunge_around(&mut self, descent: &Descent, to: DVec3, direction: f64) -> Done {
        let centre = DVec3::new(descent.centre.x, descent.centre.y, to.z);
        let (centre, to) = (self.drives.world.system.axes(centre), self.drives.world.system.axes(to));
        self.drives.arc_to(centre, to, direction, None, Speed::of_feed(descent.feed))
    }
}
