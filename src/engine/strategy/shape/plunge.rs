//! Strategies that bring a milling tool to the next level: on a helix and in strokes to and fro.
//!
//! Invariant: one level at a time, from one height to another; which cycle plunges is not known here.
use glam::DVec3;

use crate::base::expr::{cosd, sind, tand};
use crate::engine::report::fault::Fault;
use crate::engine::strategy::milling::{Milling, too_many};
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::strategy;

/// More turns or strokes for one level than this are refused.
const MAX_PASSES: f64 = 10_000.0;
/// What calculation may add to a whole number of turns or strokes.
const SPARE: f64 = 1e-9;

/// Declares a strategy of plunging: what all of them are given, and what it is given besides.
macro_rules! plunge {
    ($(#[$doc:meta])* $name:ident = $text:literal { $($more:tt)* }) => {
        strategy! {
            $(#[$doc])*
            $name = $text {
                /// The middle of the plunge: its tool coordinate is not used.
                centre: DVec3 = Length,
                /// The height where material begins, mm.
                from: f64 = Length,
                /// The height of the level, mm.
                to: f64 = Length,
                /// The greatest plunging angle, degrees.
                angle: f64 = Angle,
                /// The feed, mm/min.
                feed: f64 = Feed,
                $($more)*
            }
        }

        impl $name {
            const fn descent(&self) -> Descent {
                Descent { centre: self.centre, from: self.from, to: self.to, angle: self.angle, feed: self.feed }
            }
        }
    };
}

plunge! {
    /// Down on a helix, then once around to level the bottom, then to the centre.
    PlungeOnHelix = "plunge-on-helix" {
        /// The radius of the path of the tool centre, mm.
        radius: f64 = Length,
        /// Clockwise if negative, otherwise counter-clockwise.
        direction: f64 = Number,
    }
}

plunge! {
    /// Down in strokes about the centre, then once along the bottom to level it, then to the centre. A stroke is as
    /// long as the plunging angle asks for, at least `least` and at most `room`.
    PlungeInStrokes = "plunge-in-strokes" {
        /// The direction of the strokes, degrees.
        rotation: f64 = Angle,
        /// The least length of a stroke, mm.
        least: f64 = Length,
        /// Its greatest length, mm.
        room: f64 = Length,
    }
}

plunge! {
    /// Down in strokes from one end of a slot to the other, beginning at the left one.
    PlungeAlongSlot = "plunge-along-slot" {
        /// The direction of the slot, degrees.
        rotation: f64 = Angle,
        /// The length of the way, mm.
        length: f64 = Length,
    }
}

plunge! {
    /// Down in strokes from one end of a circular slot to the other, beginning at its starting angle.
    PlungeAlongCircularSlot = "plunge-along-circular-slot" {
        /// The diameter of the circle along which the slot lies, mm.
        diameter: f64 = Length,
        /// Where it begins, degrees.
        begin: f64 = Angle,
        /// How far it goes from there, degrees.
        opening: f64 = Angle,
    }
}

impl Milling for PlungeOnHelix {
    fn mill(&self, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let (descent, radius) = (self.descent(), self.radius);
        let direction = if self.direction < 0.0 { -1.0 } else { 1.0 };
        let turns = descent.passes(2.0 * std::f64::consts::PI * radius)?;
        pen.line(descent.beside(radius, 0.0, pen.here().z), descent.feed);
        pen.line(descent.beside(radius, 0.0, descent.from), descent.feed);
        for half in 1..=2 * turns {
            let side = if half % 2 == 0 { 0.0 } else { 180.0 };
            descent.around(descent.beside(radius, side, descent.height(half, 2 * turns)), direction, pen);
        }
        descent.around(descent.beside(radius, 0.0, descent.to), direction, pen);
        pen.line(descent.beside(0.0, 0.0, descent.to), descent.feed);
        Ok(())
    }
}

impl Milling for PlungeInStrokes {
    fn mill(&self, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let (descent, rotation) = (self.descent(), self.rotation);
        let length = (descent.depth() / tand(descent.angle)).max(self.least).min(self.room);
        let strokes = descent.passes(length)?;
        let end = |number: u32| if number.is_multiple_of(2) { -length / 2.0 } else { length / 2.0 };
        pen.line(descent.beside(0.0, rotation, descent.from), descent.feed);
        pen.line(descent.beside(end(0), rotation, descent.from), descent.feed);
        for stroke in 1..=strokes {
            let height = descent.height(stroke, strokes);
            pen.line(descent.beside(end(stroke), rotation, height), descent.feed);
        }
        pen.line(descent.beside(end(strokes + 1), rotation, descent.to), descent.feed);
        pen.line(descent.beside(0.0, rotation, descent.to), descent.feed);
        Ok(())
    }
}

impl Milling for PlungeAlongSlot {
    fn mill(&self, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let (descent, length) = (self.descent(), self.length);
        let strokes = descent.passes(length)?;
        let end = |number: u32| if number.is_multiple_of(2) { -length / 2.0 } else { length / 2.0 };
        for stroke in 0..=strokes {
            let height = descent.height(stroke, strokes);
            pen.line(descent.beside(end(stroke), self.rotation, height), descent.feed);
        }
        Ok(())
    }
}

impl Milling for PlungeAlongCircularSlot {
    fn mill(&self, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let (descent, begin, opening) = (self.descent(), self.begin, self.opening);
        let radius = self.diameter / 2.0;
        let strokes = descent.passes(radius * opening.abs().to_radians())?;
        let angle = |number: u32| if number.is_multiple_of(2) { begin } else { begin + opening };
        pen.line(descent.beside(radius, begin, descent.from), descent.feed);
        for stroke in 1..=strokes {
            let to = descent.beside(radius, angle(stroke), descent.height(stroke, strokes));
            let forward = if stroke % 2 == 1 { opening } else { -opening };
            descent.around(to, forward.signum(), pen);
        }
        Ok(())
    }
}

/// What all ways of plunging need.
struct Descent {
    centre: DVec3,
    from: f64,
    to: f64,
    angle: f64,
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
            let fault = Fault::control("infeeds-never-reach-depth").arg("reached", 0.0).arg("depth", self.depth());
            return Err(fault.arg("first", 0.0).arg("less", 0.0).arg("least", 0.0));
        }
        let passes = libm::ceil(self.depth() / drop - SPARE).max(1.0);
        if passes > MAX_PASSES {
            return Err(too_many(MAX_PASSES));
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

    /// On an arc about the centre to a point.
    fn around(&self, to: DVec3, direction: f64, pen: &mut Pen) {
        let centre = DVec3::new(self.centre.x, self.centre.y, to.z);
        pen.arc((centre, to), direction, None, self.feed);
    }
}
