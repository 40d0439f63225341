//! What a probing cycle would do in the worst case, found out before it moves.
//!
//! A cycle that probes is rehearsed twice: as if everything were touched at once, and as if it were touched at the very
//! end of each probing path. Both leave the machine as it was; then the cycle is executed in the scene as usual.
//! Invariant: nothing here knows what a cycle does; all comes from the paths of the interpreter.
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use glam::DVec3;
use serde::Serialize;

use crate::engine::flow::definition::Definition;
use crate::engine::geometry::{Axis, Frame};
use crate::engine::report::fault::Class;
use crate::engine::run::{At, Done, Leave, Modal, Params, Run};
use crate::engine::scene::Scene;
use crate::engine::solid::{Body, Path, Shape, SolidError};
use crate::engine::world::state::World;
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
}

/// What stands in the scene.
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Ended {
    /// What stopped the probe.
    pub touching: Touching,
    /// The code of the error that ended it.
    pub error: Option<String>,
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
struct Leg {
    /// The tip, in machine coordinates.
    tip: Path,
    /// The ball centre, as the parts see it.
    ball: Path,
    probing: bool,
}

/// The ways of one run of a cycle.
#[derive(Clone, Debug, Default)]
pub(in crate::engine) struct Recorder(Vec<Leg>);

/// The run as it was before a cycle.
struct Before<'e> {
    world: World<'e>,
    params: Params,
    modal: Modal,
    at: At,
    guards: BTreeSet<(CycleKey, Arc<str>)>,
    executed: BTreeMap<CycleKey, Vec<bool>>,
    logs: (usize, usize),
    moves: u64,
    inside: usize,
    probing: bool,
}

impl<'e> Run<'_, 'e> {
    fn kept(&self) -> Before<'e> {
        Before {
            world: self.world.clone(),
            params: self.params.clone(),
            modal: self.modal,
            at: self.event.at.clone(),
            guards: self.guards.clone(),
            executed: self.executed.clone(),
            logs: (self.logs.len(), self.screens.len()),
            moves: self.moves,
            inside: self.inside,
            probing: self.probing,
        }
    }

    fn return_to(&mut self, before: &Before<'e>) {
        self.world = before.world.clone();
        self.params.clone_from(&before.params);
        // What was kept belongs to values that were never given.
        self.recall = None;
        self.modal = before.modal;
        self.event.at.clone_from(&before.at);
        self.guards.clone_from(&before.guards);
        self.executed.clone_from(&before.executed);
        self.logs.truncate(before.logs.0);
        self.screens.truncate(before.logs.1);
        (self.moves, self.inside, self.probing) = (before.moves, before.inside, before.probing);
        self.writing.clear();
    }

    /// Rehearses a cycle that probes, executes it and notes its envelope. Where it fails in the scene and not in both
    /// rehearsals, the program goes on from where a rehearsal ended, as if the cycle had found nothing.
    pub(in crate::engine) fn with_envelope(&mut self, definition: &Definition<'e>) -> Done {
        let before = self.kept();
        let (mut legs, mut ends, mut stood, mut probings) = (Vec::new(), Vec::new(), None, 0);
        for touching in [Touching::AtOnce, Touching::AtEnd, Touching::AsScene] {
            (self.touching, self.recorder) = (touching, Some(Recorder::default()));
            let ended = self.execute_in_scene(definition);
            let own = self.recorder.take().unwrap_or_default().0;
            probings = probings.max(own.iter().filter(|leg| leg.probing).count());
            legs.extend(own);
            let error = match &ended {
                Err(Leave::Fault(fault)) => Some(fault.code.to_string()),
                _ => None,
            };
            ends.push(Ended { touching, error });
            if touching == Touching::AsScene {
                let envelope = self.envelope(definition, &before, &legs, probings, ends);
                self.envelopes.push(envelope);
                return match (ended, stood) {
                    (Err(Leave::Fault(fault)), Some(machine)) if fault.class != Class::Limit => {
                        self.return_to(&before);
                        self.world.machine = machine;
                        self.world.renew();
                        Ok(())
                    }
                    (ended, _) => ended,
                };
            }
            stood = ended.is_ok().then_some(self.world.machine).or(stood);
            self.return_to(&before);
        }
        Ok(())
    }

    /// Notes a way of the tip in machine coordinates, if somebody wants to know.
    pub(in crate::engine) fn note_way(&mut self, tip: &Path, probing: bool) {
        let Some(recorder) = &mut self.recorder else { return };
        let Some(probe) = self.world.probe_if_any() else { return };
        let lift = self.world.ball_centre(DVec3::ZERO, &probe);
        let ball = match *tip {
            Path::Line { from, to } => Path::line(from + lift, to + lift),
            Path::Arc { centre, axis, from, sweep, rise } => {
                Path::Arc { centre: centre + lift, axis, from: from + lift, sweep, rise }
            }
        };
        recorder.0.push(Leg { tip: self.world.path_of_tip(tip), ball: self.world.path_at_parts(&ball), probing });
    }

    fn envelope(
        &self,
        definition: &Definition<'e>,
        before: &Before<'e>,
        legs: &[Leg],
        probings: usize,
        ends: Vec<Ended>,
    ) -> Envelope {
        let system = &before.world.system;
        let (back, tool) = (*system.back(), system.plane.tool);
        let heights = || {
            let ends = legs.iter().flat_map(|leg| [leg.tip.at(0.0), leg.tip.at(1.0)]);
            ends.map(|end| tool.of(back.point(end)))
        };
        let longest = legs.iter().filter(|leg| leg.probing).map(|leg| leg.tip.length()).reduce(f64::max);
        let radius = self.world.probe().map_or(0.0, |probe| probe.ball_radius);
        let key = definition.cycle.key;
        Envelope {
            line: before.at.line,
            block: before.at.block,
            keyword: key.keyword.as_str(),
            number: key.number,
            axis: tool.letter(),
            lowest: heights().reduce(f64::min).map(exact),
            highest: heights().reduce(f64::max).map(exact),
            travelled: travelled(legs, &back, tool),
            probings,
            longest_probing: longest.map(exact),
            near: obstacles(before.world.scene).into_iter().map(|it| near(it, radius, legs, &back)).collect(),
            ends,
            key: Some(key),
        }
    }
}

/// A length without what calculating left behind its last digits.
fn exact(length: f64) -> f64 {
    libm::round(length * 1e9) / 1e9 + 0.0
}

/// The heights of moves across, from above, each once.
fn travelled(legs: &[Leg], back: &Frame, tool: Axis) -> Vec<f64> {
    let mut heights: Vec<f64> = Vec::new();
    for leg in legs.iter().filter(|leg| !leg.probing) {
        let (from, to) = (back.point(leg.tip.at(0.0)), back.point(leg.tip.at(1.0)));
        let across = tool.with(to - from, 0.0).length();
        if across > ACROSS || leg.tip.length() > (to - from).length() + ACROSS {
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

fn near((to, body): (Obstacle, Result<Body, SolidError>), radius: f64, legs: &[Leg], back: &Frame) -> Near {
    let found = body.as_ref().ok().and_then(|body| nearest(body, radius, legs).ok().flatten());
    let reaches = |leg: &Leg| {
        body.as_ref().is_ok_and(|body| matches!(body.first_contact_on(radius, &leg.ball), Ok(Some(_)) | Err(_)))
    };
    Near {
        to,
        distance: found.map(|(distance, _)| libm::round(distance / STEP) * STEP).map(exact),
        tip: found.map(|(_, tip)| back.point(tip).to_array().map(exact)),
        probed: legs.iter().filter(|leg| leg.probing).any(reaches),
    }
}

/// The least distance of the ball on its ways without probing, and where the tip is then in machine coordinates.
fn nearest(body: &Body, radius: f64, legs: &[Leg]) -> Result<Option<(f64, DVec3)>, SolidError> {
    let mut best: Option<(f64, DVec3)> = None;
    for leg in legs.iter().filter(|leg| !leg.probing) {
        for t in [0.0, 1.0] {
            let Some(end) = body.nearest(leg.ball.at(t))? else { return Ok(None) };
            if best.is_none_or(|(distance, _)| end.distance < distance) {
                best = Some((end.distance, leg.tip.at(t)));
            }
        }
        if let Some((distance, _)) = best.filter(|(distance, _)| *distance > radius)
            && let Some(found) = nearer(body, radius, distance - STEP, leg)?
        {
            best = Some(found);
        }
    }
    Ok(best.map(|(distance, tip)| ((distance - radius).max(0.0), tip)))
}

/// The least distance of the ball centre on a way if it is below `high`, not below the radius of the ball. A ball of
/// any greater radius than that distance would touch.
fn nearer(body: &Body, radius: f64, high: f64, leg: &Leg) -> Result<Option<(f64, DVec3)>, SolidError> {
    let touches = |radius: f64| -> Result<Option<DVec3>, SolidError> {
        Ok(body.first_contact_on(radius, &leg.ball)?.map(|contact| leg.tip.at(contact.t)))
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
