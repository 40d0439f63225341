//! `SPL`: polynomials of the third degree, as CAM systems write them. For each axis `K3 t³ + K2 t² + K1 t + end`, while
//! `t` runs from 1 to 0.
//!
//! Invariant: the tool runs on chords of the curve that nowhere are farther away from it than the input step of the
//! controls, 0.0001 mm or degrees.
use glam::DVec3;

use crate::engine::flow::state::Run;
use crate::engine::motion::axis::{linear, rotary};
use crate::engine::motion::moves::Speed;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::{Class, Fault};
use crate::program::syntax::{Coord, Motion};

/// How far chords may be from the curve, mm or degrees.
const CHORD: f64 = 1e-4;
/// How far a spline may begin from where the tool is, mm: a thousandth, with room for the last digit of its coefficients.
const START: f64 = 1e-3 + 1e-6;
/// A spline with more chords is not machined: it would be longer than any machine.
const MOST_CHORDS: f64 = 1e6;

/// The coefficients of three axes: of the third, second and first power, and the end.
#[derive(Clone, Copy, Debug, Default)]
struct Cubic {
    third: DVec3,
    second: DVec3,
    first: DVec3,
    end: DVec3,
}

impl Cubic {
    fn at(&self, t: f64) -> DVec3 {
        ((self.third * t + self.second) * t + self.first) * t + self.end
    }

    /// Into so many chords of the same share of `t` that each is near enough: the bend is greatest at one of the ends.
    fn chords(&self) -> f64 {
        let bend = (self.third * 6.0 + self.second * 2.0).length().max(self.second.length() * 2.0);
        libm::sqrt(bend / (8.0 * CHORD)).ceil().max(1.0)
    }
}

impl Run<'_, '_> {
    /// `SPL`.
    pub(super) fn spline(&mut self, motion: &Motion, speed: Result<Speed, Fault>) -> Done {
        if self.is_in_contour(motion) {
            return Err(Fault::unsupported("unsupported-compensation").arg("word", "SPL").into());
        }
        let from = self.programmed();
        let (turning, coords): (Vec<Coord>, Vec<Coord>) =
            motion.coords.iter().copied().partition(|coord| rotary(coord.axis).is_some());
        let mut way = Cubic { end: self.target(&coords, from)?, ..Cubic::default() };
        let mut sizes = DVec3::ONE;
        for coord in &coords {
            let axis = linear(coord.axis)?;
            let size = self.drives.unit() / self.drives.world.system.doubled(axis);
            let [third, second, first] = self.coefficients(motion, coord)?.map(|own| own * size);
            way.third = axis.with(way.third, third);
            way.second = axis.with(way.second, second);
            way.first = axis.with(way.first, first);
            sizes = axis.with(sizes, 0.0);
        }
        // What the block does not name stays as it is.
        let off = (way.at(1.0) - from) * (DVec3::ONE - sizes);
        if off.length() > START {
            return Err(Fault::control("spline-start").arg("distance", off.length()).into());
        }
        let ends = self.turn_target(&turning, false)?;
        let mut turns = Vec::with_capacity(ends.len());
        let mut bends = Cubic::default();
        for (coord, (axis, end)) in turning.iter().zip(ends) {
            let sign = axis.of(self.drives.world.system.mirror().1);
            let [third, second, first] = self.coefficients(motion, coord)?.map(|own| own * sign);
            bends.third = axis.with(bends.third, third);
            bends.second = axis.with(bends.second, second);
            bends.first = axis.with(bends.first, first);
            bends.end = axis.with(bends.end, end);
            let off = axis.of(bends.at(1.0) - self.drives.world.angles).abs();
            if off > START {
                return Err(Fault::control("spline-start").arg("distance", off).into());
            }
            turns.push(axis);
        }
        let chords = way.chords().max(bends.chords());
        if chords > MOST_CHORDS {
            return Err(Fault::new(Class::Limit, "move-limit").arg("limit", MOST_CHORDS).into());
        }
        self.contour.forget();
        for chord in 1..=chords as u32 {
            let t = 1.0 - f64::from(chord) / chords;
            let (to, angles) = (way.at(t), bends.at(t));
            let turns: Vec<_> = turns.iter().map(|axis| (*axis, axis.of(angles))).collect();
            let speed = self.plunging_speed(to, speed.clone());
            self.drives.turn_and_go(&turns, to, None, speed, None)?;
        }
        let plane = self.drives.world.system.contour_plane();
        self.contour.arrived(-plane.flat(way.first), plane.flat(way.end));
        Ok(())
    }

    /// The coefficients of a coordinate, of the third power first.
    fn coefficients(&self, motion: &Motion, coord: &Coord) -> Result<[f64; 3], Fault> {
        let of = |power: char| {
            let is_it = |name: &str| {
                let mut letters = name.trim().chars().map(|c| c.to_ascii_uppercase());
                letters.next() == Some('K') && letters.next() == Some(power) && letters.eq(coord.axis.name().chars())
            };
            let word = motion.words.iter().find(|word| is_it(self.slice(word.name)));
            word.map_or_else(|| Err(Fault::program("value-missing")), |word| self.number_of(&word.value))
        };
        Ok([of('3')?, of('2')?, of('1')?])
    }
}
