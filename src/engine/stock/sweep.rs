//! The way of a tool through the columns: how low its envelope reaches in each of them.
//!
//! Coordinates are those of the stock: columns are along z, and so does the tool. Everything here is exact for
//! each column: a line sweeps a convex body, so the lowest point over a column is where the slope of the path
//! and the slope of the tool's end balance, or an end of the path. Only a bull nose on a ramp has no closed form; there
//! the balance is found by bisection down to rounding. Arcs are in `arc_sweep`.
use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};

use super::cutter::{Cutter, Tip};

/// What is left to rounding, mm.
pub(super) const HAIR: f64 = 1e-9;

/// Angles, in radians, up to which the chord says well enough where an arc is.
const SHORT: f64 = 0.4;

/// The way over which the series of the arc sine alone gives an angle, radians.
pub(super) const NARROW: f64 = 0.2;

/// No part of a row.
pub(super) const NONE: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

/// A way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Way {
    /// A straight one.
    Line {
        from: DVec3,
        /// Its direction seen from above; any if it is vertical.
        along: DVec2,
        /// Its length seen from above.
        length: f64,
        /// Rise over all.
        rise: f64,
    },
    /// An arc about a line along z.
    Arc {
        centre: DVec2,
        radius: f64,
        /// Where it begins as seen from the centre, a unit vector.
        start: DVec2,
        /// Where it ends.
        end: DVec2,
        /// +1 counter-clockwise, -1 clockwise.
        turn: f64,
        /// Angle in radians, not negative.
        sweep: f64,
        /// Height at the start.
        z: f64,
        /// Rise over all.
        rise: f64,
    },
}

/// A ball on a straight way, from its lowest place on, that holds all that a ball covers on its way: that is the way
/// itself, or of an arc the chord. No point of an arc is farther from the point of its chord at the same share of the
/// way than the radius times the square of the angle over eight (the second derivative bounds what a chord misses), and
/// both are at the same height there; so a ball that is larger by so much holds it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hull {
    /// The centre of the ball at the start.
    pub from: DVec3,
    pub along: DVec2,
    pub length: f64,
    /// Rise in a mm, and the length of the way that rises so in a mm seen from above.
    pub slope: f64,
    pub steep: f64,
    pub radius: f64,
}

impl Hull {
    fn new(from: DVec3, to: DVec3, radius: f64) -> Self {
        let flat = DVec2::new(to.x - from.x, to.y - from.y);
        let length = flat.length_squared().sqrt();
        let along = if length > 0.0 { flat / length } else { DVec2::X };
        // Of a vertical way only the lower end counts.
        let (slope, z) = if length > 0.0 { ((to.z - from.z) / length, from.z) } else { (0.0, from.z.min(to.z)) };
        Self { from: from.with_z(z), along, length, slope, steep: (1.0 + slope * slope).sqrt(), radius }
    }
}

/// A tool on its way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sweep {
    pub way: Way,
    pub cutter: Cutter,
    /// What a ball certainly stays within, unless it goes round far.
    pub hull: Option<Hull>,
    /// Corners of the rectangle that it covers.
    pub min: DVec2,
    pub max: DVec2,
    /// The lowest and the highest place of the tip.
    pub low: f64,
    pub high: f64,
    /// Whether the tool has been at the start before: what it covers there is gone already.
    pub joined: bool,
}

fn unit(angle: f64) -> DVec2 {
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

impl Sweep {
    /// A straight way.
    pub(super) fn line(from: DVec3, to: DVec3, cutter: Cutter) -> Self {
        let flat = DVec2::new(to.x - from.x, to.y - from.y);
        let length = libm::hypot(flat.x, flat.y);
        let along = if length > 0.0 { flat / length } else { DVec2::X };
        let (a, b) = (DVec2::new(from.x, from.y), DVec2::new(to.x, to.y));
        let way = Way::Line { from, along, length, rise: to.z - from.z };
        let mut line = Self::bounded(way, cutter, a.min(b), a.max(b), from.z, to.z);
        if cutter.is_ball() {
            let up = DVec3::Z * cutter.radius;
            line.hull = Some(Hull::new(from + up, to + up, cutter.radius));
        }
        line
    }

    /// An arc from an angle (radians) on; `sweep` is signed.
    pub(super) fn arc(centre: DVec2, radius: f64, angle: f64, sweep: f64, z: f64, rise: f64, cutter: Cutter) -> Self {
        let (start, end) = (unit(angle), unit(angle + sweep));
        let way = Way::Arc { centre, radius, start, end, turn: sweep.signum(), sweep: sweep.abs(), z, rise };
        let (mut min, mut max) = (start.min(end), start.max(end));
        let passes = |way: DVec2| {
            let (after, before) = (start.perp_dot(way) * sweep >= 0.0, way.perp_dot(end) * sweep >= 0.0);
            sweep.abs() >= TAU || if sweep.abs() <= PI { after && before } else { after || before }
        };
        for way in [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y] {
            if passes(way) {
                (min, max) = (min.min(way), max.max(way));
            }
        }
        let mut arc = Self::bounded(way, cutter, centre + min * radius, centre + max * radius, z, z + rise);
        if cutter.is_ball() && sweep.abs() < SHORT {
            let up = z + cutter.radius;
            let (from, to) = ((centre + start * radius).extend(up), (centre + end * radius).extend(up + rise));
            arc.hull = Some(Hull::new(from, to, cutter.radius + radius * sweep * sweep / 8.0));
        }
        arc
    }

    fn bounded(way: Way, cutter: Cutter, min: DVec2, max: DVec2, from: f64, to: f64) -> Self {
        let reach = DVec2::splat(cutter.radius);
        Self {
            way,
            cutter,
            min: min - reach,
            max: max + reach,
            low: from.min(to),
            high: from.max(to),
            joined: false,
            hull: None,
        }
    }

    /// The same upside down: its heights are the negative upper ends of what a flat tool covers.
    pub(super) fn mirrored(&self) -> Self {
        let mut other = *self;
        match &mut other.way {
            Way::Line { from, rise, .. } => (from.z, *rise) = (-from.z, -*rise),
            Way::Arc { z, rise, .. } => (*z, *rise) = (-*z, -*rise),
        }
        (other.low, other.high) = (-self.high, -self.low);
        other.cutter.tip = Tip::Flat;
        other.hull = None;
        other
    }

    /// The same with another tool whose tip is higher by `lift`.
    pub(super) fn with(&self, cutter: Cutter, lift: f64) -> Self {
        let mut other = *self;
        match &mut other.way {
            Way::Line { from, .. } => from.z += lift,
            Way::Arc { z, .. } => *z += lift,
        }
        let grow = DVec2::splat(cutter.radius - self.cutter.radius);
        Self {
            cutter,
            min: self.min - grow,
            max: self.max + grow,
            low: self.low + lift,
            high: self.high + lift,
            hull: None,
            ..other
        }
    }

    /// Says places across the path apart: how far a point lies to the left of a line, or the square of its distance
    /// from the centre of an arc.
    pub(super) fn across(&self, p: DVec2) -> f64 {
        match self.way {
            Way::Line { from, along, .. } => along.perp_dot(p - DVec2::new(from.x, from.y)),
            Way::Arc { centre, .. } => (p - centre).length_squared(),
        }
    }

    /// The centre of an arc.
    pub(super) const fn centre(&self) -> Option<DVec2> {
        match self.way {
            Way::Line { .. } => None,
            Way::Arc { centre, .. } => Some(centre),
        }
    }

    /// How far points lie to the left of the path, least and most, from the least and the greatest of these numbers.
    pub(super) fn left(&self, [least, most]: [f64; 2]) -> [f64; 2] {
        match self.way {
            Way::Line { .. } => [least, most],
            Way::Arc { radius, turn, .. } => {
                let [inner, outer] = [turn * (radius - least.sqrt()), turn * (radius - most.sqrt())];
                [inner.min(outer), inner.max(outer)]
            }
        }
    }

    /// The part of a row of that y that it covers; what lies within the rectangle and the outer rim for arcs.
    pub(super) fn span(&self, y: f64) -> Option<[f64; 2]> {
        let Way::Line { from, along, length, .. } = self.way else { return self.arc_span(y) };
        let radius = self.cutter.radius;
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut disc = |centre: DVec2| {
            let square = radius * radius - (y - centre.y) * (y - centre.y);
            if square >= 0.0 {
                let half = square.sqrt();
                low = low.min(centre.x - half);
                high = high.max(centre.x + half);
            }
        };
        let start = DVec2::new(from.x, from.y);
        let end = start + along * length;
        disc(start);
        disc(end);
        if along.y != 0.0 && length > 0.0 {
            let far = along.y.abs() * length;
            for side in [radius, -radius] {
                let edge = start + along.perp() * side;
                let way = (y - edge.y) * along.y.signum();
                if (0.0..=far).contains(&way) {
                    let x = edge.x + along.x * (way / along.y.abs());
                    low = low.min(x);
                    high = high.max(x);
                }
            }
        }
        (low <= high).then_some([low, high])
    }

    /// The parts of a row within its span in which it can cut something; the second may be empty. Where the tool has
    /// was at the start, that is what the path leads it to: beyond the first place for a flat tool that does not go
    /// down, and before the tool otherwise.
    pub(super) fn fresh(&self, y: f64, [low, high]: [f64; 2]) -> [[f64; 2]; 2] {
        let Way::Line { from, along, length, rise } = self.way else { return self.arc_fresh(y, [low, high]) };
        if !self.joined || length == 0.0 {
            return [[low, high], NONE];
        }
        let radius = self.cutter.radius;
        let slope = rise / length;
        let after = match self.cutter.tip {
            Tip::Flat if rise >= 0.0 => {
                let square = radius * radius - (y - from.y) * (y - from.y);
                if square <= 0.0 {
                    return [[low, high], NONE];
                }
                // A hair is left to rounding.
                let half = square.sqrt() - HAIR;
                return [[low, high.min(from.x - half)], [low.max(from.x + half), high]];
            }
            Tip::Flat => return [[low, high], NONE],
            Tip::Point(steep) if slope.abs() >= steep => return [[low, high], NONE],
            Tip::Point(steep) => radius * slope.abs() / (steep * steep - slope * slope).sqrt(),
            Tip::Round(corner) if corner >= radius => radius * slope.abs() / (1.0 + slope * slope).sqrt(),
            Tip::Round(_) if rise == 0.0 => 0.0,
            Tip::Round(_) => return [[low, high], NONE],
        };
        // What lies farther back than this along the path is lowest where the tool was.
        let after = if slope > 0.0 { 0.0 } else { after }.min(radius) + HAIR;
        let start = (y - from.y) * along.y + after;
        if along.x > 1e-9 {
            [[low.max(from.x - start / along.x), high], NONE]
        } else if along.x < -1e-9 {
            [[low, high.min(from.x - start / along.x)], NONE]
        } else {
            [[low, high], NONE]
        }
    }

    /// No height of the envelope is lower within half a length about a point.
    pub(super) fn least_near(&self, p: DVec2, half: f64) -> f64 {
        match self.way {
            Way::Line { from, along, length, .. } if self.cutter.tip != Tip::Flat => {
                let way = p - DVec2::new(from.x, from.y);
                let (u, v) = (way.dot(along), along.perp_dot(way));
                let beyond = u - u.max(0.0).min(length);
                let far = (beyond * beyond + v * v).sqrt() - half;
                if far > self.cutter.radius { f64::INFINITY } else { self.low + self.cutter.rise(far.max(0.0)) }
            }
            Way::Arc { centre, radius, .. } if self.cutter.tip != Tip::Flat => {
                let far = ((p - centre).length() - radius).abs() - half;
                if far > self.cutter.radius { f64::INFINITY } else { self.low + self.cutter.rise(far.max(0.0)) }
            }
            _ => self.low,
        }
    }

    /// The height above which everything is flat, if that is so within the span of each row: a flat tool that
    /// stays at its height.
    pub(super) fn level(&self) -> Option<f64> {
        match self.way {
            Way::Line { from, rise, length, .. } if self.cutter.tip == Tip::Flat && (rise == 0.0 || length == 0.0) => {
                Some(from.z + rise.min(0.0))
            }
            _ => None,
        }
    }

    /// The part of a row over which a flat tool is at the lower end of its ramp, and that height.
    pub(super) fn settled(&self, y: f64) -> Option<([f64; 2], f64)> {
        if self.cutter.tip != Tip::Flat {
            return None;
        }
        let (at, height) = match self.way {
            Way::Line { from, along, length, rise } if rise != 0.0 => {
                let start = DVec2::new(from.x, from.y);
                (if rise < 0.0 { start + along * length } else { start }, from.z + rise.min(0.0))
            }
            Way::Arc { centre, radius, start, end, z, rise, .. } if rise != 0.0 => {
                (centre + if rise < 0.0 { end } else { start } * radius, z + rise.min(0.0))
            }
            _ => return None,
        };
        let square = self.cutter.radius * self.cutter.radius - (y - at.y) * (y - at.y);
        if square <= 0.0 {
            return None;
        }
        let half = square.sqrt() - HAIR;
        (half > 0.0).then_some(([at.x - half, at.x + half], height))
    }
}
