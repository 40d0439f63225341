//! Strategies over the contours of subprograms: where a tool plunges, how it clears a level.
//!
//! The region of the tool centre is what the contours enclose, shrunk by the radius of the tool and the allowance. Its
//! parts are numbered from 1 in the order in which they are cleared. Invariant: the centre never leaves that region,
//! and a level is cleared without lifting (TNC 640 manual, line 4408).
pub mod contour_train;
pub mod cylinder;
pub mod cylinder_wall;
pub mod walls;

use std::cell::RefCell;
use std::cmp::Ordering;
use std::rc::Rc;

use glam::{DVec2, DVec3};

use crate::base::expr::tand;
use crate::engine::geometry::WorkingPlane;
use crate::engine::region::clearing::{self, MOST_RINGS};
use crate::engine::region::contours::{Closed, Contour, enclosed};
use crate::engine::region::relief::Band;
use crate::engine::region::{Boundary, Edge, Region, Way};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::calculation::Calculation;
use crate::engine::strategy::milling::{shape_impossible, too_many};
use crate::engine::strategy::pen::{Cutter, Path, Pen};
use crate::engine::strategy::signature::{Signature, results, strategy};
use crate::engine::strategy::turning::area::Turned;
use crate::engine::strategy::turning::groove::Groove;
use crate::engine::strategy::turning::thread::TurnedThread;
use crate::engine::table::TableKind;

/// A helix is at most so many tool radii wide, so that no core is left.
const WIDEST_HELIX: f64 = 0.9;
/// A helix that would be narrower, in tool radii, is a plunge in strokes.
const NARROWEST_HELIX: f64 = 0.2;
/// More strokes or turns for one level than this are refused.
const MAX_PASSES: f64 = 10_000.0;
/// The feed that means rapid traverse.
const RAPID: f64 = 99_999.999;
/// What a coarser tool has left and is narrower than twice this, mm, is nothing.
const LEFT: f64 = 1e-3;
/// What a tool does not reach and is smaller than this, mm², is nothing.
const LEAST_LEFT: f64 = 1e-3;
/// Places that differ by less, mm, are beside each other.
const BESIDE: f64 = 1e-3;
/// What calculation may add to a whole number of passes, and to a distance.
const SPARE: f64 = 1e-6;

/// The contours that a cycle machines.
#[derive(Clone, Debug, Default)]
pub struct Contours {
    /// As they are programmed, in the order of their labels.
    pub open: Vec<Contour>,
    /// What is machined between the surface and the depth, from above: more than one where contours have depths of
    /// their own. Each lies within the one before it.
    pub bands: Vec<Band>,
    /// Whether there is no pocket: islands in a frame.
    pub only_islands: bool,
    /// Where the tool was when the cycle began, main and minor axis: what is near is cleared first.
    pub from: DVec2,
    /// What is recessed.
    pub groove: Option<Groove>,
    /// What is turned.
    pub turned: Option<Turned>,
    /// The thread that is turned.
    pub thread: Option<TurnedThread>,
    /// Paths and walls that were asked for: each level and each strategy asks for them again.
    pub memory: Memory,
}

/// What was calculated of contours.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    cleared: RefCell<Vec<Cleared>>,
    pub(super) followed: RefCell<Option<Followed>>,
}

/// The walls that a tool of a radius follows, with what stays at them and the least radius in inside corners.
#[derive(Clone, Debug)]
pub(super) struct Followed {
    pub(super) asked: [f64; 3],
    pub(super) walls: Rc<Vec<Wall>>,
}

/// A wall as the centre of a tool follows it, in its band.
#[derive(Clone, Debug)]
pub struct Wall {
    /// The way of the centre.
    pub boundary: Boundary,
    /// Where the centre may be.
    pub(super) centres: Rc<Region>,
    /// How deep below the surface it begins, mm.
    pub from: f64,
    /// How deep it ends, mm.
    pub to: f64,
}

/// A way of clearing with a tool of a radius, and its paths.
#[derive(Clone, Debug)]
struct Cleared {
    way: Clearing,
    tool_radius: f64,
    parts: Rc<Vec<Part>>,
}

/// So many ways of clearing are kept: with and without a coarser tool before.
const KEPT_WAYS: usize = 2;

impl Contours {
    /// Contours that are all closed, down to a depth below the surface (mm).
    pub fn new(closed: Vec<Closed>, from: DVec2, depth: f64) -> Self {
        let only_islands = !closed.iter().any(|contour| contour.is_pocket);
        let bands = vec![Band { from: 0.0, to: depth, region: enclosed(&closed) }];
        Self { bands, only_islands, from, ..Self::default() }
    }

    /// The paths that clear the contours, by part: the parts of each band, from above.
    ///
    /// # Errors
    /// The tool is too wide for all of it, or the stepover too small.
    pub fn paths(&self, way: &Clearing, tool_radius: f64) -> Result<Rc<Vec<Part>>, Fault> {
        let mut kept = self.memory.cleared.borrow_mut();
        if let Some(known) = kept.iter().find(|known| known.way == *way && known.tool_radius == tool_radius) {
            return Ok(Rc::clone(&known.parts));
        }
        let parts = Rc::new(self.cleared_by(way, tool_radius)?);
        kept.truncate(KEPT_WAYS - 1);
        kept.insert(0, Cleared { way: *way, tool_radius, parts: Rc::clone(&parts) });
        Ok(parts)
    }

    /// What of the contours a tool does not reach: pieces with the depth of their floor, mm.
    pub fn unreached(&self, tool_radius: f64, allowance: f64, rounding: f64) -> Vec<(Region, f64)> {
        let mut pieces = Vec::new();
        for band in &self.bands {
            let reached = centres(&band.region, tool_radius, allowance, rounding).grown(tool_radius + LEFT);
            let wanted = centres(&band.region, 0.0, allowance, 0.0);
            let left = wanted.difference(&reached);
            pieces.extend(left.parts().filter(|piece| piece.area() > LEAST_LEFT).map(|piece| (piece, band.to)));
        }
        pieces
    }

    fn cleared_by(&self, way: &Clearing, tool_radius: f64) -> Result<Vec<Part>, Fault> {
        let (mut parts, mut from, mut has_room) = (Vec::new(), self.from, false);
        for (number, band) in self.bands.iter().enumerate() {
            let mut centres = centres(&band.region, tool_radius, way.allowance, way.rounding);
            has_room |= !centres.is_empty();
            if let Some(coarse) = way.coarse {
                // Where the tool comes to what the coarser one could not reach.
                let reached = self::centres(&band.region, coarse, way.allowance, way.rounding).grown(coarse);
                let left = centres.grown(tool_radius).difference(&reached).shrunk(LEFT).grown(LEFT);
                centres = centres.intersection(&left.grown(tool_radius));
            }
            if way.floors
                && let Some(below) = self.bands.get(number + 1)
            {
                let floor = band.region.difference(&below.region).shrunk(LEFT).grown(LEFT);
                centres = centres.intersection(&floor.grown(tool_radius));
            }
            if centres.is_empty() {
                continue;
            }
            let paths = clearing::paths(&centres, way.stepover, way.climb >= 0.0, from);
            let paths = paths.map_err(|_| too_many(MOST_RINGS as f64))?;
            from = paths.last().map_or(from, clearing::Path::end);
            parts.extend(paths.into_iter().map(|path| Part { path, from: band.from, to: band.to }));
        }
        if has_room { Ok(parts) } else { Err(shape_impossible(2.0 * tool_radius, 0.0)) }
    }
}

/// A part of contours that is cleared without lifting.
#[derive(Clone, Debug)]
pub struct Part {
    /// The path that clears it at one level.
    pub path: clearing::Path,
    /// How deep below the surface it begins, mm.
    pub from: f64,
    /// How deep its floor is, mm.
    pub to: f64,
}

/// Where the centre of a tool may be that leaves an allowance, with inside corners of at least a radius.
pub(super) fn centres(region: &Region, tool_radius: f64, allowance: f64, rounding: f64) -> Region {
    let by = tool_radius + allowance;
    let region = if by < 0.0 { region.grown(-by) } else { region.shrunk(by) };
    region.rounded(rounding)
}

/// How a region is cleared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearing {
    /// The distance of the rings, mm.
    pub stepover: f64,
    /// What stays at the walls, mm.
    pub allowance: f64,
    /// The least radius of the path in inside corners, mm.
    pub rounding: f64,
    /// Climb milling if not negative, for a spindle that turns clockwise.
    pub climb: f64,
    /// The radius of a coarser tool that has cleared the region before, mm.
    pub coarse: Option<f64>,
    /// Only the floor of each band, without what is machined deeper.
    pub floors: bool,
}

strategy! {
    /// The data that a definition has kept for the cycles on contours; reads the contours, too.
    RecallContourData = "recall-contour-data" {}
}

results! {
    /// The data of contours.
    ContourData {
        /// From the surface to the floor, with sign.
        depth: f64 = Length,
        /// The stepover in tool radii.
        overlap: f64 = Number,
        /// The allowance at the walls.
        side_allowance: f64 = Length,
        /// The allowance on the floor.
        floor_allowance: f64 = Length,
        /// The height of the surface.
        surface: f64 = Length,
        /// The set-up clearance.
        clearance: f64 = Length,
        /// The height at which nothing is in the way.
        height: f64 = Length,
        /// The least radius of the path in inside corners.
        rounding: f64 = Length,
        /// Climb milling if not negative.
        direction: f64 = Number,
    }
}

impl Action for RecallContourData {
    type Results = ContourData;

    fn act(&self, control: &mut dyn Control) -> Done<ContourData> {
        let kept = |name| control.kept(name).ok_or_else(|| Fault::program("contour-data-undefined"));
        let data = ContourData {
            depth: kept("depth")?,
            overlap: kept("overlap")?,
            side_allowance: kept("side_allowance")?,
            floor_allowance: kept("floor_allowance")?,
            surface: kept("surface")?,
            clearance: kept("clearance")?,
            height: kept("height")?,
            rounding: kept("rounding")?,
            direction: kept("direction")?,
        };
        control.read_contours(data.depth.abs())?;
        Ok(data)
    }
}

strategy! {
    /// How many parts the region has that a tool clears, each with a point where it is entered.
    FindInfeedPoints = "find-infeed-points" {
        /// The stepover in radii of the tool that clears.
        overlap: f64 = Number,
        /// What stays at the walls, mm.
        allowance: f64 = Length,
        /// The least radius of the path in inside corners, mm.
        rounding: f64 = Length,
        /// The number of the tool that clears; without it the tool in the spindle.
        tool: Option<f64> = Number,
        /// The number of a coarser tool that has cleared the region before; 0 if none has.
        coarse: Option<f64> = Number,
        /// Whether the floors are finished, and not what is above them cleared.
        floors: Option<f64> = Number,
    }
}

results! {
    /// The parts of a region, and the tools that clear them.
    InfeedPoints {
        /// How many parts there are.
        count: f64 = Number,
        /// The radius of the tool that clears, without the oversizes of a tool call.
        radius: f64 = Length,
        /// The radius of the coarser tool; 0 if there is none.
        coarse: f64 = Length,
        /// The distance of the rings.
        stepover: f64 = Length,
    }
}

/// The radius of a tool of the tool table, mm: with its wear, without oversizes of a tool call.
fn radius_in_table(control: &dyn Control, tool: f64) -> Result<f64, Fault> {
    if !control.has_row(TableKind::Tool, tool)? {
        return Err(Fault::program("tool-not-in-table").arg("tool", tool));
    }
    let number = |column| Ok::<_, Fault>(control.number(TableKind::Tool, tool, column)?.unwrap_or_default());
    Ok(number("R")? + number("DR")?)
}

impl Action for FindInfeedPoints {
    type Results = InfeedPoints;

    fn act(&self, control: &mut dyn Control) -> Done<InfeedPoints> {
        let radius = match self.tool {
            Some(tool) => radius_in_table(control, tool)?,
            None => control.tool_radius(),
        };
        let coarse = self.coarse.filter(|tool| *tool != 0.0);
        let coarse = coarse.map(|tool| radius_in_table(control, tool)).transpose()?;
        let Self { allowance, rounding, .. } = *self;
        let (stepover, floors) = (self.overlap * radius, self.floors.is_some_and(|only| only != 0.0));
        let way = Clearing { stepover, allowance, rounding, climb: 1.0, coarse, floors };
        let paths = control.contours().paths(&way, radius)?;
        Ok(InfeedPoints { count: paths.len() as f64, radius, coarse: coarse.unwrap_or(0.0), stepover })
    }
}

strategy! {
    /// Reports what of the contours the tool in the spindle does not reach: corners and narrow places.
    FindMaterialLeft = "find-material-left" {
        /// What stays at the walls, mm.
        allowance: f64 = Length,
        /// The least radius of the path in inside corners, mm.
        rounding: f64 = Length,
        /// The height of the surface, mm.
        surface: f64 = Length,
        /// From there to the floor of the deepest contour, with sign, mm.
        depth: f64 = Length,
    }
}

results! {
    /// What is not reached.
    MaterialLeft {
        /// In how many places.
        places: f64 = Number,
    }
}

impl Action for FindMaterialLeft {
    type Results = MaterialLeft;

    fn act(&self, control: &mut dyn Control) -> Done<MaterialLeft> {
        let left = control.contours().unreached(control.tool_radius(), self.allowance, self.rounding);
        let down = if self.depth < 0.0 { -1.0 } else { 1.0 };
        let place = |(piece, depth): &(Region, f64)| Some((piece.area(), piece.middle()?.extend(*depth)));
        let mut places: Vec<(f64, DVec3)> = left.iter().filter_map(place).collect();
        // Level by level from left to right; rounding does not decide between places above each other.
        let rank = |at: DVec3| [at.z, at.x, at.y].map(|along| (along / BESIDE).round());
        places.sort_by(|(_, a), (_, b)| rank(*a).partial_cmp(&rank(*b)).unwrap_or(Ordering::Equal));
        for (area, at) in places {
            control.note_left(area, DVec3 { z: self.surface + down * at.z, ..at });
        }
        Ok(MaterialLeft { places: left.len() as f64 })
    }
}

strategy! {
    /// How far before the last infeed a drill stops when it returns at rapid traverse (TNC 640 manual, lines 4645-4648).
    StopDistance = "stop-distance" {
        /// The drilling depth, mm.
        depth: f64 = Length,
    }
}

results! {
    /// The stop distance.
    StopDistanceResults {
        /// mm.
        distance: f64 = Length,
    }
}

/// Up to this depth, mm, the distance is the least one; then it is a part of the depth, and at most the greatest one.
const SHALLOW: f64 = 30.0;
const LEAST_STOP: f64 = 0.6;
const STOPS_IN_DEPTH: f64 = 50.0;
const GREATEST_STOP: f64 = 7.0;

impl Calculation for StopDistance {
    type Results = StopDistanceResults;

    fn calculate(&self, _: WorkingPlane) -> Result<StopDistanceResults, Fault> {
        let depth = self.depth.abs();
        let deep = (depth / STOPS_IN_DEPTH).min(GREATEST_STOP);
        Ok(StopDistanceResults { distance: if depth > SHALLOW { deep } else { LEAST_STOP } })
    }
}

/// A strategy that moves a milling tool over contours.
pub trait OverContours: Signature {
    /// Draws the path from where the pen is.
    ///
    /// # Errors
    /// No path of this tool makes it, or it has too many legs.
    fn mill(&self, contours: &Contours, tool: Cutter, pen: &mut Pen) -> Result<(), Fault>;

    /// The path from a point: main, minor and tool coordinate.
    fn path(&self, contours: &Contours, tool: Cutter, from: DVec3) -> Path {
        let mut pen = Pen::new(from);
        let ended = self.mill(contours, tool, &mut pen);
        pen.path(ended)
    }
}

/// Declares a strategy on one part of a region: how that is cleared, and what it is given besides.
macro_rules! on_part {
    ($(#[$doc:meta])* $name:ident = $text:literal { $($more:tt)* }) => {
        strategy! {
            $(#[$doc])*
            $name = $text {
                /// The number of the part, from 1.
                part: f64 = Number,
                /// The distance of the rings, mm.
                stepover: f64 = Length,
                /// What stays at the walls, mm.
                allowance: f64 = Length,
                /// The least radius of the path in inside corners, mm.
                rounding: f64 = Length,
                /// Climb milling if not negative.
                climb: f64 = Number,
                /// The radius of the tool that clears, where that is another one than the tool in the spindle, mm.
                radius: Option<f64> = Length,
                /// The radius of a coarser tool that has cleared the region before, mm.
                coarse: Option<f64> = Length,
                /// Whether the floors are finished, and not what is above them cleared.
                floors: Option<f64> = Number,
                $($more)*
            }
        }

        impl $name {
            /// The part, with the path that clears it.
            fn part(&self, contours: &Contours, tool: Cutter) -> Result<Part, Fault> {
                let Self { stepover, allowance, rounding, climb, radius, .. } = *self;
                let coarse = self.coarse.filter(|radius| *radius > 0.0);
                let floors = self.floors.is_some_and(|only| only != 0.0);
                let way = Clearing { stepover, allowance, rounding, climb, coarse, floors };
                let parts = contours.paths(&way, radius.unwrap_or(tool.radius))?;
                let number = (self.part.max(1.0) - 1.0) as usize;
                parts.get(number).cloned().ok_or_else(|| shape_impossible(2.0 * tool.radius, 0.0))
            }
        }
    };
}

on_part! {
    /// Between which heights a part is cleared: that of the contours, or less where they have depths of their own.
    FindDepthsOfPart = "find-depths-of-part" {
        /// The height of the surface, mm.
        surface: f64 = Length,
        /// From there to the floor of the deepest contour, with sign, mm.
        depth: f64 = Length,
        /// What stays on each floor, mm.
        floor_allowance: f64 = Length,
    }
}

results! {
    /// The heights between which something is machined.
    Depths {
        /// Where it begins.
        from: f64 = Length,
        /// Where it ends.
        to: f64 = Length,
    }
}

/// The heights of depths below a surface, in the direction of a depth with sign, with an allowance on the floor.
pub(super) fn heights((from, to): (f64, f64), surface: f64, depth: f64, allowance: f64) -> Depths {
    let down = if depth < 0.0 { -1.0 } else { 1.0 };
    // What lies on the floor above is taken away, too.
    let from = if from > 0.0 { (from - allowance).max(0.0) } else { 0.0 };
    Depths { from: surface + down * from, to: surface + down * (to - allowance).max(from) }
}

impl Action for FindDepthsOfPart {
    type Results = Depths;

    fn act(&self, control: &mut dyn Control) -> Done<Depths> {
        let tool = Cutter { radius: control.tool_radius() };
        let part = self.part(control.contours(), tool)?;
        Ok(heights((part.from, part.to), self.surface, self.depth, self.floor_allowance))
    }
}

on_part! {
    /// Over the point where the part is entered, at rapid traverse: up to where nothing is in the way, across, and down.
    MoveOverInfeedPoint = "move-over-infeed-point" {
        /// The height at which nothing is in the way, mm.
        above: f64 = Length,
        /// The height to which it goes down, mm.
        height: f64 = Length,
    }
}

on_part! {
    /// Down to a level on a helix about the point where the part is entered, or, where there is no room for one, in
    /// strokes along the path that clears it.
    PlungeIntoRegion = "plunge-into-region" {
        /// The height where material begins, mm.
        from: f64 = Length,
        /// The height of the level, mm.
        to: f64 = Length,
        /// The greatest plunging angle, degrees.
        angle: f64 = Angle,
        /// The greatest length of a stroke, mm.
        stroke: f64 = Length,
        /// The feed, mm/min.
        feed: f64 = Feed,
    }
}

on_part! {
    /// Clears the part at one level from the inside outwards.
    ClearRegionAtLevel = "clear-region-at-level" {
        /// The height of the level, mm.
        level: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

impl OverContours for MoveOverInfeedPoint {
    fn mill(&self, contours: &Contours, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let path = self.part(contours, tool)?.path;
        if pen.here().z < self.above {
            pen.down(self.above, RAPID);
        }
        pen.line(path.start.extend(pen.here().z), RAPID);
        pen.line(path.start.extend(self.height), RAPID);
        Ok(())
    }
}

impl OverContours for PlungeIntoRegion {
    fn mill(&self, contours: &Contours, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let path = self.part(contours, tool)?.path;
        let radius = path.room.min(WIDEST_HELIX * tool.radius);
        pen.line(path.start.extend(self.from), self.feed);
        if radius >= NARROWEST_HELIX * tool.radius {
            self.on_helix(&path, radius, pen)
        } else {
            self.in_strokes(&path, pen)
        }
    }
}

impl PlungeIntoRegion {
    /// How many passes of a length go down at no more than the plunging angle.
    fn passes(&self, length: f64) -> Result<u32, Fault> {
        let passes = libm::ceil((self.to - self.from).abs() / (length * tand(self.angle)) - SPARE).max(1.0);
        if passes.is_nan() || passes > MAX_PASSES { Err(too_many(MAX_PASSES)) } else { Ok(passes as u32) }
    }

    fn height(&self, part: u32, parts: u32) -> f64 {
        if part < parts { self.from + (self.to - self.from) * f64::from(part) / f64::from(parts) } else { self.to }
    }

    /// Half turns, then once around to level the bottom, then to the middle.
    fn on_helix(&self, path: &clearing::Path, radius: f64, pen: &mut Pen) -> Result<(), Fault> {
        let turns = self.passes(std::f64::consts::TAU * radius)?;
        let beside = |side: f64, height: f64| (path.start + DVec2::new(side * radius, 0.0)).extend(height);
        pen.line(beside(1.0, self.from), self.feed);
        for half in 1..=2 * turns + 2 {
            let (height, side) = (self.height(half, 2 * turns), if half % 2 == 0 { 1.0 } else { -1.0 });
            pen.arc((path.start.extend(height), beside(side, height)), 1.0, None, self.feed);
        }
        pen.line(path.start.extend(self.to), self.feed);
        Ok(())
    }

    /// To and fro along the path that clears the part, and once more at the bottom.
    fn in_strokes(&self, path: &clearing::Path, pen: &mut Pen) -> Result<(), Fault> {
        let there = Way { start: path.start, edges: path.edges.clone() }.shortened(self.stroke);
        let back = there.reversed();
        let strokes = self.passes(there.length())?;
        // An even number ends where it begins; the last two level the bottom.
        let strokes = strokes + strokes % 2;
        for stroke in 1..=strokes + 2 {
            let way = if stroke % 2 == 1 { &there } else { &back };
            descend(way, self.height(stroke - 1, strokes), self.height(stroke, strokes), self.feed, pen);
        }
        Ok(())
    }
}

/// Evenly along a way from one height to another.
fn descend(way: &Way, from: f64, to: f64, feed: f64, pen: &mut Pen) {
    let (mut at, mut gone, length) = (way.start, 0.0, way.length());
    for edge in &way.edges {
        gone += edge.length(at);
        let share = if length > 0.0 { (gone / length).min(1.0) } else { 1.0 };
        draw(edge, from + (to - from) * share, feed, pen);
        at = edge.to();
    }
}

/// Draws an edge that ends at a height.
pub(super) fn draw(edge: &Edge, height: f64, feed: f64, pen: &mut Pen) {
    match *edge {
        Edge::Line(to) => pen.line(to.extend(height), feed),
        Edge::Arc { to, centre, sweep } => {
            pen.arc((centre.extend(height), to.extend(height)), sweep.signum(), Some(sweep), feed);
        }
    }
}

impl OverContours for ClearRegionAtLevel {
    fn mill(&self, contours: &Contours, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let path = self.part(contours, tool)?.path;
        pen.line(path.start.extend(pen.here().z), self.at);
        pen.line(path.start.extend(self.level), self.at);
        for edge in &path.edges {
            draw(edge, self.level, self.at, pen);
        }
        Ok(())
    }
}

on_part! {
    /// Onto the floor on an arc upright to it, or straight down where there is no room.
    ApproachRegionFloor = "approach-region-floor" {
        /// The height of the floor, mm.
        level: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

impl OverContours for ApproachRegionFloor {
    fn mill(&self, contours: &Contours, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let path = self.part(contours, tool)?.path;
        let radius = path.room.min(tool.radius) / 2.0;
        if radius >= NARROWEST_HELIX * tool.radius && pen.here().z >= self.level + radius {
            let beside = path.start - DVec2::new(radius, 0.0);
            pen.line(beside.extend(pen.here().z), self.at);
            pen.line(beside.extend(self.level + radius), self.at);
            pen.upright(path.start.extend(self.level + radius), path.start.extend(self.level), self.at);
        }
        pen.line(path.start.extend(self.level), self.at);
        Ok(())
    }
}
