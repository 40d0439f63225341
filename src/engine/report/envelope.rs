//! What a probing cycle would do in the worst case: heights, ways, what it comes near to.
//!
//! Invariant: nothing here executes anything or knows what a cycle does; all comes from the ways that it is given.
use glam::DVec3;
use serde::Serialize;

use super::event::At;
use super::fault::Fault;
use crate::engine::geometry::{Axis, Frame};
use crate::engine::scene::Scene;
use crate::engine::solid::{Body, Path, Shape, SolidError};
use crate::spec::CycleKey;

/// The name and version of the JSON form.
pub const FORMAT: &str = "ciklo-envelope/1";

/// How exactly the nearest approach is found, mm.
const STEP: f64 = 1e-6;
/// Moves across that are shorter do not count as travelled, mm.
const ACROSS: f64 = 1e-6;

/// What stops the probe.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Touching {
    /// The parts of the scene.
    #[default]
    AsScene,
    /// Everything is touched where the probing begins.
    AtOnce,
    /// Everything is touched where the probing path ends.
    AtEnd,
    /// Everything is touched where the cycle expects it, at its clearance from where the probing begins.
    AsExpected,
}

/// What is in the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", content = "number", rename_all = "kebab-case")]
pub enum Obstacle {
    /// The raw material.
    Stock,
    /// The part of that number, from 1 in the order of the scene: the workpiece, a clamp.
    Part(usize),
}

/// How near the probe comes to something.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Near {
    /// To what.
    pub to: Obstacle,
    /// The least distance of the ball while it does not probe, mm; 0 for a collision. Nothing if the engine cannot
    /// calculate it, or the cycle does not move.
    pub distance: Option<f64>,
    /// Where the tip is then, in the coordinates at the start of the cycle.
    pub tip: Option<[f64; 3]>,
    /// Whether a probing path reaches it.
    pub probed: bool,
}

/// How a run of the cycle ended.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ended {
    /// What stopped the probe.
    pub touching: Touching,
    /// The code of the error that ended it.
    pub error: Option<String>,
    /// The error itself, for those who have words for it.
    #[serde(skip)]
    pub fault: Option<Fault>,
}

/// What one execution of a cycle would do. Heights are those of the tip along the tool axis, in the coordinates at the
/// start of the cycle, mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Envelope {
    /// The physical line of the definition or call.
    pub line: usize,
    /// The printed block number.
    pub block: Option<u32>,
    /// `CYCL DEF` or `TCH PROBE`.
    pub keyword: &'static str,
    /// The number of the cycle.
    pub number: u32,
    /// The tool axis.
    pub axis: char,
    /// The lowest height of the tip, probing paths to their ends included.
    pub lowest: Option<f64>,
    /// The greatest height of the tip.
    pub highest: Option<f64>,
    /// The heights at which the probe travels across, from above.
    pub travelled: Vec<f64>,
    /// How often it probes at most.
    pub probings: usize,
    /// The longest probing path, mm.
    pub longest_probing: Option<f64>,
    /// What it comes near to.
    pub near: Vec<Near>,
    /// How the runs of the cycle ended.
    pub ends: Vec<Ended>,
    /// The key of the cycle.
    #[serde(skip)]
    pub key: Option<CycleKey>,
}

/// A way of the probe.
#[derive(Clone, Debug)]
pub(crate) struct Way {
    /// The tip, in machine coordinates.
    pub(crate) tip: Path,
    /// The ball centre, as the parts see it.
    pub(crate) ball: Path,
    pub(crate) probing: bool,
}

/// The ways of one run of a cycle.
#[derive(Clone, Debug, Default)]
pub(crate) struct Recorder(Vec<Way>);

impl Recorder {
    pub(crate) fn note(&mut self, way: Way) {
        self.0.push(way);
    }

    pub(crate) fn into_ways(self) -> Vec<Way> {
        self.0
    }
}

/// How things are when a cycle begins.
pub(crate) struct Begin<'b> {
    pub(crate) scene: &'b Scene,
    /// The place of the call.
    pub(crate) at: &'b At,
    /// From the machine to program coordinates.
    pub(crate) back: Frame,
    /// The tool axis.
    pub(crate) tool: Axis,
    /// The true radius of the ball.
    pub(crate) ball_radius: f64,
}

/// The envelope of a cycle with those ways, which probes so often at most.
pub(crate) fn envelope(begin: &Begin<'_>, key: CycleKey, ways: &[Way], probings: usize, ends: Vec<Ended>) -> Envelope {
    let (back, tool) = (begin.back, begin.tool);
    let heights = || {
        let ends = ways.iter().flat_map(|way| [way.tip.at(0.0), way.tip.at(1.0)]);
        ends.map(|end| tool.of(back.point(end)))
    };
    let longest = ways.iter().filter(|way| way.probing).map(|way| way.tip.length()).reduce(f64::max);
    let near_to = |it| near(it, begin.ball_radius, ways, &back);
    Envelope {
        line: begin.at.line,
        block: begin.at.block,
        keyword: key.keyword.as_str(),
        number: key.number,
        axis: tool.letter(),
        lowest: heights().reduce(f64::min).map(exact),
        highest: heights().reduce(f64::max).map(exact),
        travelled: travelled(ways, &back, tool),
        probings,
        longest_probing: longest.map(exact),
        near: obstacles(begin.scene).into_iter().map(near_to).collect(),
        ends,
        key: Some(key),
    }
}

/// A length without the rounding error in its last digits.
fn exact(length: f64) -> f64 {
    libm::round(length * 1e9) / 1e9 + 0.0
}

/// The heights of moves across, from above, each once.
fn travelled(ways: &[Way], back: &Frame, tool: Axis) -> Vec<f64> {
    let mut heights: Vec<f64> = Vec::new();
    for way in ways.iter().filter(|way| !way.probing) {
        let (from, to) = (back.point(way.tip.at(0.0)), back.point(way.tip.at(1.0)));
        let across = tool.with(to - from, 0.0).length();
        if across > ACROSS || way.tip.length() > (to - from).length() + ACROSS {
            heights.extend([tool.of(from), tool.of(to)].map(exact));
        }
    }
    heights.sort_by(|one, other| other.total_cmp(one));
    heights.dedup_by(|one, other| (*one - *other).abs() <= ACROSS);
    heights
}

/// The raw material and the parts, each by itself.
fn obstacles(scene: &Scene) -> Vec<(Obstacle, Result<Body, SolidError>)> {
    let mut all: Vec<(Obstacle, Result<Body, SolidError>)> =
        scene.stock.iter().map(|stock| (Obstacle::Stock, Body::new(stock))).collect();
    if let Shape::Placed { frame, shape } = &scene.parts
        && let Shape::Union(parts) = &**shape
    {
        for (number, part) in (1..).zip(parts) {
            let placed = Shape::Placed { frame: *frame, shape: Box::new(part.clone()) };
            all.push((Obstacle::Part(number), Body::new(&placed)));
        }
    }
    all
}

fn near((to, body): (Obstacle, Result<Body, SolidError>), radius: f64, ways: &[Way], back: &Frame) -> Near {
    let found = body.as_ref().ok().and_then(|body| nearest(body, radius, ways).ok().flatten());
    let reaches = |way: &Way| {
        body.as_ref().is_ok_and(|body| matches!(body.first_contact_on(radius, &way.ball), Ok(Some(_)) | Err(_)))
    };
    Near {
        to,
        distance: found.map(|(distance, _)| libm::round(distance / STEP) * STEP).map(exact),
        tip: found.map(|(_, tip)| back.point(tip).to_array().map(exact)),
        probed: ways.iter().filter(|way| way.probing).any(reaches),
    }
}

/// The least distance of the ball on its ways without probing, and where the tip is then in machine coordinates.
fn nearest(body: &Body, radius: f64, ways: &[Way]) -> Result<Option<(f64, DVec3)>, SolidError> {
    let mut best: Option<(f64, DVec3)> = None;
    for way in ways.iter().filter(|way| !way.probing) {
        for t in [0.0, 1.0] {
            let Some(end) = body.nearest(way.ball.at(t))? else { return Ok(None) };
            if best.is_none_or(|(distance, _)| end.distance < distance) {
                best = Some((end.distance, way.tip.at(t)));
            }
        }
        if let Some((distance, _)) = best.filter(|(distance, _)| *distance > radius)
            && let Some(found) = nearer(body, radius, distance - STEP, way)?
        {
            best = Some(found);
        }
    }
    Ok(best.map(|(distance, tip)| ((distance - radius).max(0.0), tip)))
}

/// The least distance of the ball centre on a way if it is below `high`, not below the radius of the ball. A ball of
/// any greater radius than that distance would touch.
fn nearer(body: &Body, radius: f64, high: f64, way: &Way) -> Result<Option<(f64, DVec3)>, SolidError> {
    let touches = |radius: f64| -> Result<Option<DVec3>, SolidError> {
        Ok(body.first_contact_on(radius, &way.ball)?.map(|contact| way.tip.at(contact.t)))
    };
    let (mut low, mut high) = (radius, high.max(radius));
    let Some(mut tip) = touches(high)? else { return Ok(None) };
    if let Some(tip) = touches(low)? {
        return Ok(Some((radius, tip)));
    }
    while high - low > STEP / 2.0 {
        let middle = f64::midpoint(low, high);
        match touches(middle)? {
            Some(nearer) => (high, tip) = (middle, nearer),
            None => low = middle,
        }
    }
    Ok(Some((high, tip)))
}
