//! The round workpiece while it is turned, in slices along the rotary axis, and what one call of a cycle turns of it.
//!
//! Invariant: an outside and an inside radius for each slice; slices that the workpiece may not have any more, or of
//! which something is not known, say nothing.
use glam::DVec3;

use super::body::{Body, SAME, SKIN};
use crate::check::TurnedPart;
use crate::engine::machine::Insert;
use crate::spec::CycleKey;

/// How thick a slice is, and so many there are at most.
const SLICE: f64 = 0.25;
pub(super) const MOST_SLICES: f64 = 8_000.0;
/// A wall that is thinner is none, mm.
pub(super) const WALL: f64 = 0.5;

/// The round workpiece while it is turned.
pub(super) struct Turned {
    pub(super) low: f64,
    pub(super) slice: f64,
    /// The radius of the bore of the blank.
    pub(super) bore: f64,
    /// The outside and inside radius of each slice.
    pub(super) slices: Vec<[f64; 2]>,
    /// Down to where a face was turned: above, a ring may stay that is no wall.
    pub(super) faced: f64,
    /// The bottom of the hole that was drilled in the middle, and its radius where that is known.
    pub(super) drilled: Option<(f64, Option<f64>)>,
    /// Whether the workpiece is clamped otherwise, or something may have been removed that is not known.
    pub(super) open: bool,
    /// What the insert in the spindle is, as the last cycle has it.
    pub(super) insert: Option<Insert>,
    /// Where the tool was when the last movement ended that is none of a cycle.
    pub(super) start: Option<DVec3>,
    /// What the names of tools say of the side for which they are, and how wide bars for inside are.
    pub(super) named: Vec<(f64, TurnedPart)>,
    pub(super) bars: Vec<(f64, f64)>,
    /// The tools that have turned outside, and those that have inside.
    pub(super) sides: [Vec<u64>; 2],
    pub(super) pass: Option<Pass>,
}

/// What one call of a cycle turns.
pub(super) struct Pass {
    pub(super) line: usize,
    pub(super) written: usize,
    pub(super) key: CycleKey,
    pub(super) recess: bool,
    pub(super) inside: bool,
    /// The slices before.
    pub(super) before: Vec<[f64; 2]>,
    /// Whether anything was cut, and where it comes nearest to the part: how far from it, its radius and that of the
    /// part.
    pub(super) cuts: bool,
    pub(super) nearest: Option<[f64; 3]>,
    /// How much of a wall is gone, and the radii of its other side.
    pub(super) through: f64,
    pub(super) other: f64,
    /// How far below the bottom of the hole it goes, if it does.
    pub(super) deepest: Option<f64>,
}

impl Turned {
    /// Of a blank, if it is round about the tool axis.
    pub(super) fn of(body: Option<Body>) -> Self {
        let round = body.filter(Body::is_round);
        let (low, high) = round.map_or((0.0, 0.0), |body| (body.low.z, body.high.z));
        let slice = SLICE.max((high - low) / MOST_SLICES);
        let bore = round.map_or(0.0, |body| body.bore());
        let outside = round.map_or(0.0, |body| (body.high.x - body.low.x) / 2.0);
        let slices = vec![[outside, bore]; ((high - low) / slice).ceil() as usize];
        let middle = round.is_some_and(|body| ((body.low + body.high) / 2.0).truncate().length() <= SAME);
        let sides = [Vec::new(), Vec::new()];
        let (named, bars) = (Vec::new(), Vec::new());
        let (drilled, insert, start, pass) = (None, None, None, None);
        let faced = f64::INFINITY;
        Self { low, slice, bore, slices, faced, drilled, open: !middle, insert, start, named, bars, sides, pass }
    }

    pub(super) fn high(&self) -> f64 {
        self.low + self.slice * self.slices.len() as f64
    }

    /// The slice of a height.
    pub(super) fn at(&self, z: f64) -> Option<usize> {
        let index = ((z - self.low) / self.slice).floor();
        (index >= 0.0 && (index as usize) < self.slices.len()).then_some(index as usize)
    }

    /// A hole that was drilled in the middle.
    pub(super) fn drill(&mut self, bottom: f64, radius: Option<f64>) {
        let (old, wide) = self.drilled.unwrap_or((f64::INFINITY, Some(0.0)));
        let wider = wide.zip(radius).map(|(wide, radius)| wide.max(radius));
        self.drilled = Some((old.min(bottom), wider));
        let from = ((bottom - self.low) / self.slice).ceil().max(0.0) as usize;
        for [_, inside] in self.slices.iter_mut().skip(from) {
            *inside = inside.max(radius.unwrap_or_default());
        }
    }

    /// Takes away what an insert may cut at a place of a pass.
    pub(super) fn cut(&mut self, place: DVec3, inside: bool, face: bool) {
        let (radius, z) = (place.x.abs(), place.z);
        if face && !inside {
            self.faced = self.faced.min(z);
            let from = ((z - self.low) / self.slice).ceil().max(0.0) as usize;
            self.slices.iter_mut().skip(from).for_each(|[outside, _]| *outside = outside.min(radius));
        } else if let Some([outside, bore]) = self.at(z).and_then(|at| self.slices.get_mut(at)) {
            match inside {
                true => *bore = bore.max(radius),
                false => *outside = outside.min(radius),
            }
        }
    }
}

impl Pass {
    /// What a place of a way along the rotary axis does to the wall.
    pub(super) fn see(&mut self, before: [f64; 2], radius: f64, step: f64) {
        let [outside, bore] = before;
        let other = if self.inside { outside } else { bore };
        let gone = if self.inside { radius > outside - SKIN } else { radius < bore + SKIN };
        if bore > 0.0 && outside - bore > WALL && gone {
            self.through += step;
            self.other = if self.inside { other.max(self.other) } else { other };
        }
    }

    /// How far a place is from the part before, at the slices beside it.
    pub(super) fn miss(&mut self, place: DVec3, [from, to]: [usize; 2]) {
        let radius = place.x.abs();
        let near = self.before.iter().take(to.saturating_add(1)).skip(from);
        let surface = match self.inside {
            true => near.map(|[_, bore]| *bore).reduce(f64::min),
            false => near.map(|[outside, _]| *outside).reduce(f64::max),
        };
        let Some(surface) = surface else { return };
        let beside = if self.inside { surface - radius } else { radius - surface };
        self.cuts |= beside < 0.0;
        if self.nearest.is_none_or(|[least, ..]| beside < least) {
            self.nearest = Some([beside, radius, surface]);
        }
    }
}
