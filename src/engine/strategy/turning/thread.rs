//! Strategies that turn a thread: its line, its infeeds, and one pass along it.
//!
//! Where the manual leaves something open (how infeeds decrease, what a pitch is with several starts, from where an
//! angle counts), `cycle-specs/errata.yaml` says what was decided. Invariant: all passes are the same line, lowered by
//! their infeeds; the last one begins where the thread is programmed, the ones before it further back, so that infeeds
//! follow the infeed angle. In material the tool moves in step with the spindle only.
use glam::{DVec2, DVec3};

use super::area::{Sight, highest};
use super::insert_report::{Held, hold};
use crate::base::expr::tand;
use crate::engine::region::{Edge, Way};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::contour::{Contours, OverContours};
use crate::engine::strategy::milling::{shape_impossible, too_many};
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::{results, strategy};

/// The feed that means rapid traverse.
const RAPID: f64 = 99_999.999;
/// More infeeds or passes than this are refused.
const MOST_PASSES: f64 = 10_000.0;
/// What calculation may add to a whole number of infeeds.
const SPARE: f64 = 1e-9;
/// What is shorter, mm, is no way.
const NOTHING: f64 = 1e-9;
/// The height of an equilateral triangle in sides, and depths of a metric thread in pitches: 17/24 and 5/8 of it
/// (ISO 68-1, ISO 1502).
const SHARP: f64 = 0.866_025_403_784_438_6;
const OUTSIDE_DEPTH: f64 = SHARP * 17.0 / 24.0;
const INSIDE_DEPTH: f64 = SHARP * 5.0 / 8.0;

strategy! {
    /// A thread on a line: longitudinal, on a face or on a cone.
    ThreadLine = "thread-line" {
        /// Whether the coordinate away from the thread decreases: an inside thread.
        inside: bool = Number,
        /// Whether the pitch is across the rotary axis.
        face: bool = Number,
        /// Where the cycle began, with a diameter as its main coordinate.
        start: DVec3 = Length,
        /// How a cone is given: 0 by both points, 1 and 2 by the end point, an angle, and X or Z of the start, 3 and 4 by
        /// the start point, an angle, and X or Z of the end.
        dimensioning: Option<f64> = Number,
        /// The diameter where the thread begins.
        start_diameter: f64 = Length,
        /// The coordinate on the rotary axis there.
        start_z: f64 = Length,
        /// The diameter where it ends.
        end_diameter: f64 = Length,
        /// The coordinate on the rotary axis there.
        end_z: f64 = Length,
        /// The angle of a cone to the rotary axis, positive where the diameter grows, degrees.
        angle: Option<f64> = Angle,
        /// The way along the pitch before the thread, mm.
        run_in: f64 = Length,
        /// The way after it, mm.
        overrun: Option<f64> = Length,
        /// The way at its end on which the axes are braked, mm.
        braking: Option<f64> = Length,
        /// The way at its end on which the tool is lifted to the surface, mm.
        run_out: f64 = Length,
        /// The distance from the surface between the passes, mm.
        clearance: f64 = Length,
        /// The way in one revolution, mm.
        pitch: f64 = Length,
    }
}

strategy! {
    /// A thread along the contour of a subprogram.
    ThreadOfContour = "thread-of-contour" {
        /// Whether the coordinate away from the thread decreases: an inside thread.
        inside: bool = Number,
        /// Whether the pitch is across the rotary axis.
        face: bool = Number,
        /// Where the cycle began, with a diameter as its main coordinate.
        start: DVec3 = Length,
        /// The way along the pitch before the thread, mm.
        run_in: f64 = Length,
        /// The way after it, mm.
        overrun: f64 = Length,
        /// The way at its end on which the tool is lifted to the surface, mm.
        run_out: f64 = Length,
        /// The distance from the surface between the passes, mm.
        clearance: f64 = Length,
        /// The way in one revolution, mm.
        pitch: f64 = Length,
    }
}

strategy! {
    /// The infeeds of the thread that was described before.
    ThreadInfeeds = "thread-infeeds" {
        /// The depth of the thread, mm; 0 for that of a metric thread.
        depth: f64 = Length,
        /// The greatest infeed, mm.
        largest: f64 = Length,
        /// Whether all infeeds are the same; otherwise chips have the same section.
        constant: bool = Number,
        /// Between an infeed and a right angle to the pitch, degrees.
        angle: f64 = Angle,
        /// How many starts the thread has.
        starts: f64 = Number,
    }
}

results! {
    /// The infeeds of a thread.
    Infeeds {
        /// How many there are.
        count: f64 = Number,
        /// The depth that they reach, mm.
        depth: f64 = Length,
    }
}

strategy! {
    /// From where the cycle began to before the thread at rapid traverse, and to the first infeed.
    ApproachThread = "approach-thread" {}
}

strategy! {
    /// Along the thread in step with the spindle, at an infeed.
    CutThreadPass = "cut-thread-pass" {
        /// The number of the infeed, from 1.
        cut: f64 = Number,
        /// The angle of the spindle at which the pass begins, degrees.
        spindle_angle: f64 = Angle,
    }
}

strategy! {
    /// Away from the thread at rapid traverse, at a right angle to the pitch.
    LiftOffThread = "lift-off-thread" {}
}

strategy! {
    /// Back to where passes begin at rapid traverse, the clearance above the thread.
    ReturnAlongThread = "return-along-thread" {}
}

strategy! {
    /// To an infeed in front of the thread, at rapid traverse and at the infeed angle.
    InfeedInThread = "infeed-in-thread" {
        /// The number of the infeed, from 1.
        cut: f64 = Number,
    }
}

strategy! {
    /// Passes at the last infeed.
    CutThreadAirPasses = "cut-thread-air-passes" {
        /// How many.
        count: f64 = Number,
        /// The angle of the spindle at which each begins, degrees.
        spindle_angle: f64 = Angle,
    }
}

/// A thread that is turned, as its passes see it: `x` along the pitch, `y` away from it.
#[derive(Clone, Debug)]
pub struct TurnedThread {
    sight: Sight,
    /// The surface from where the thread begins to where it ends.
    surface: Way,
    /// By how much it rises per mm where it begins, and where it ends.
    slopes: [f64; 2],
    run_in: f64,
    overrun: f64,
    run_out: f64,
    clearance: f64,
    pitch: f64,
    /// Where the cycle began.
    start: DVec2,
    is_outside: bool,
    /// The depths of the passes, the last one being that of the thread.
    depths: Vec<f64>,
    /// The way along the pitch that belongs to an infeed of 1 mm.
    sideways: f64,
}

/// What describes a thread besides its surface.
struct Lengths {
    run_in: f64,
    overrun: f64,
    run_out: f64,
    clearance: f64,
    pitch: f64,
}

impl TurnedThread {
    fn new(sight: Sight, surface: Way, start: DVec2, is_outside: bool, by: &Lengths) -> Result<Self, Fault> {
        let (first, last) = (surface.edges.first(), surface.edges.last());
        let before_last = surface.edges.iter().rev().nth(1).map_or(surface.start, Edge::to);
        let (Some(first), Some(last)) = (first, last) else { return Err(shape_impossible(NOTHING, 0.0)) };
        let mut at = surface.start;
        for edge in &surface.edges {
            // In step with the spindle the tool cannot go at a right angle to the pitch, nor back.
            let steps = steepest(at, edge).is_some();
            if edge.to().x - at.x <= NOTHING || !steps {
                return Err(shape_impossible(NOTHING, edge.to().x - at.x));
            }
            at = edge.to();
        }
        let heading = |from, edge: &Edge, end| steepest(from, edge).map_or(0.0, |slopes| slopes[end]);
        let slopes = [heading(surface.start, first, 0), heading(before_last, last, 1)];
        positive(by.pitch)?;
        let (run_in, overrun, run_out) = (by.run_in.abs(), by.overrun.abs(), by.run_out.abs());
        // The tool is lifted on a straight line.
        let straight = if matches!(last, Edge::Line(_)) { last.to().x - before_last.x } else { 0.0 };
        if run_out > straight + SPARE {
            return Err(shape_impossible(run_out, straight));
        }
        let (clearance, pitch) = (by.clearance.abs(), by.pitch);
        let mut thread = Self {
            sight,
            surface,
            slopes,
            run_in,
            overrun,
            run_out,
            clearance,
            pitch,
            start,
            is_outside,
            depths: vec![0.0],
            sideways: 0.0,
        };
        thread.run_out = run_out.min(straight);
        Ok(thread)
    }

    /// Where the tool is in front of the thread at a depth; negative above the surface.
    fn begin(&self, depth: f64) -> DVec2 {
        let deepest = self.depths.last().copied().unwrap_or_default();
        let last = self.surface.start - DVec2::new(self.run_in, self.run_in * self.slopes[0] + deepest);
        let up = (deepest - depth) / (1.0 + self.slopes[0] * self.sideways);
        last + DVec2::new(-self.sideways, 1.0) * up
    }

    /// The way of a pass at a depth.
    fn pass(&self, depth: f64) -> Way {
        let down = DVec2::new(0.0, -depth);
        let mut edges: Vec<Edge> = Vec::with_capacity(self.surface.edges.len() + 3);
        if !matches!(self.surface.edges.first(), Some(Edge::Line(_))) {
            edges.push(Edge::Line(self.surface.start + down));
        }
        edges.extend(self.surface.edges.iter().map(|edge| moved(edge, down)));
        let after = |from: DVec2| from + DVec2::new(1.0, self.slopes[1]) * self.overrun;
        let end = self.surface.end();
        if self.run_out > NOTHING && depth > 0.0 {
            edges.pop();
            edges.push(Edge::Line(end - DVec2::new(1.0, self.slopes[1]) * self.run_out + down));
            edges.extend([Edge::Line(end), Edge::Line(after(end))]);
        } else {
            if let (Some(Edge::Line(_)), true) = (edges.last(), self.overrun > NOTHING) {
                edges.pop();
            }
            edges.push(Edge::Line(after(end + down)));
        }
        let start = self.begin(depth);
        let mut at = start;
        edges.retain(|edge| std::mem::replace(&mut at, edge.to()).distance(edge.to()) > NOTHING);
        Way { start, edges }
    }

    fn line(&self, pen: &mut Pen, to: DVec2, feed: f64) {
        pen.line(self.sight.point(to, pen.here().y), feed);
    }

    fn draw(&self, pen: &mut Pen, edge: &Edge, feed: f64) {
        match *edge {
            Edge::Line(to) => self.line(pen, to, feed),
            Edge::Arc { to, centre, sweep } => {
                let minor = pen.here().y;
                let (centre, to) = (self.sight.point(centre, minor), self.sight.point(to, minor));
                pen.sideways((centre, to), sweep * self.sight.sense(), feed);
            }
        }
    }

    fn here(&self, pen: &Pen) -> DVec2 {
        self.sight.seen(pen.here().x, pen.here().z)
    }

    fn depth(&self, cut: f64) -> Result<f64, Fault> {
        let found = (cut >= 1.0).then(|| self.depths.get((cut - 1.0) as usize)).flatten();
        found.copied().ok_or_else(|| Fault::program("parameter-out-of-range").arg("q", "").arg("value", cut))
    }

    /// To an infeed, from the clearance above the beginning of passes.
    fn infeed(&self, pen: &mut Pen, depth: f64) {
        self.line(pen, self.begin(depth), RAPID);
    }

    /// Along the thread; the tool is in front of it.
    fn cut(&self, pen: &mut Pen, depth: f64, spindle_angle: f64) {
        let way = self.pass(depth);
        let radius = self.sight.point(self.surface.start, 0.0).x;
        self.line(pen, way.start, RAPID);
        pen.in_step(spindle_angle, 2.0 * radius.abs());
        let mut at = way.start;
        for edge in &way.edges {
            // So many revolutions as there are pitches.
            let to = edge.to();
            self.draw(pen, edge, self.pitch * edge.length(at) / (to.x - at.x));
            at = to;
        }
    }

    fn lift(&self, pen: &mut Pen) {
        let here = self.here(pen);
        let end = self.surface.end() + DVec2::new(1.0, self.slopes[1]) * self.overrun;
        self.line(pen, DVec2::new(here.x, here.y.max(end.y + self.clearance)), RAPID);
    }

    fn back(&self, pen: &mut Pen) {
        for edge in self.pass(-self.clearance).reversed().edges {
            self.draw(pen, &edge, RAPID);
        }
    }
}

/// The slopes of an edge at its ends, if it goes in the direction of `x` all the way.
fn steepest(from: DVec2, edge: &Edge) -> Option<[f64; 2]> {
    let slope = |way: DVec2| (way.x > NOTHING * way.length()).then(|| way.y / way.x);
    match *edge {
        Edge::Line(to) => slope(to - from).map(|slope| [slope; 2]),
        Edge::Arc { to, centre, sweep } => {
            let along = |at: DVec2| slope((at - centre).perp() * sweep.signum());
            (sweep.abs() < 180.0).then_some(())?;
            Some([along(from)?, along(to)?])
        }
    }
}

fn moved(edge: &Edge, by: DVec2) -> Edge {
    match *edge {
        Edge::Line(to) => Edge::Line(to + by),
        Edge::Arc { to, centre, sweep } => Edge::Arc { to: to + by, centre: centre + by, sweep },
    }
}

fn positive(value: f64) -> Result<(), Fault> {
    let wrong = || Fault::program("parameter-out-of-range").arg("q", "").arg("value", value);
    if value > 0.0 && value.is_finite() { Ok(()) } else { Err(wrong()) }
}

fn thread(contours: &Contours) -> Result<&TurnedThread, Fault> {
    contours.thread.as_ref().ok_or_else(|| Fault::program("contour-not-defined"))
}

/// How passes see a thread: the way along the pitch, and the sign of the coordinate away from it. Where the tool is
/// below the axis (X negative) an outside thread is one whose coordinate X decreases (TNC 640 manual, line 10061).
fn sight(face: bool, inside: bool, along: f64) -> Sight {
    Sight { face, ahead: if along < 0.0 { -1.0 } else { 1.0 }, away: if inside { -1.0 } else { 1.0 } }
}

impl ThreadLine {
    /// Radius and coordinate on the rotary axis of both ends.
    fn ends(&self) -> Result<[(f64, f64); 2], Fault> {
        // The tool stays on the side of the axis where it is.
        let side = |diameter: f64| if self.start.x < 0.0 { -diameter.abs() } else { diameter } / 2.0;
        let (start, end) = ((side(self.start_diameter), self.start_z), (side(self.end_diameter), self.end_z));
        let slope = tand(self.angle.unwrap_or_default()) * if self.start.x < 0.0 { -1.0 } else { 1.0 };
        let along = |by: f64| {
            let length = by / slope.abs();
            if length > NOTHING && length.is_finite() { Ok(length) } else { Err(shape_impossible(NOTHING, 0.0)) }
        };
        // Without an end of its own a cone goes towards the chuck, where the coordinate decreases.
        Ok(match self.dimensioning.unwrap_or_default() {
            0.0 => [start, end],
            1.0 => [(start.0, end.1 + along((end.0 - start.0).abs())?), end],
            2.0 => [(end.0 - (end.1 - start.1).abs() * slope, start.1), end],
            3.0 => [start, (end.0, start.1 - along((end.0 - start.0).abs())?)],
            4.0 => [start, (start.0 + (end.1 - start.1).abs() * slope, end.1)],
            other => return Err(Fault::program("parameter-out-of-range").arg("q", "").arg("value", other)),
        })
    }
}

impl Action for ThreadLine {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let [from, to] = self.ends()?;
        let along = if self.face { to.0 - from.0 } else { to.1 - from.1 };
        let sight = sight(self.face, self.inside, along);
        let (start, end) = (sight.seen(from.0, from.1), sight.seen(to.0, to.1));
        let surface = Way { start, edges: vec![Edge::Line(end)] };
        let Self { run_in, run_out, clearance, pitch, .. } = *self;
        let braking = self.braking.unwrap_or_default().abs();
        if braking > end.x - start.x + SPARE {
            return Err(shape_impossible(braking, end.x - start.x).into());
        }
        let by = Lengths { run_in, overrun: self.overrun.unwrap_or_default(), run_out, clearance, pitch };
        let is_outside = self.inside == (from.0 < 0.0);
        let began = sight.seen(self.start.x / 2.0, self.start.z);
        control.keep_thread(TurnedThread::new(sight, surface, began, is_outside, &by)?);
        hold(control, sight, Held::Thread)
    }
}

impl Action for ThreadOfContour {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let way = control.read_turned_contour()?;
        let (from, to) = (way.start, way.end());
        let along = if self.face { to.y - from.y } else { to.x - from.x };
        let sight = sight(self.face, self.inside, along);
        let Self { run_in, overrun, run_out, clearance, pitch, .. } = *self;
        let by = Lengths { run_in, overrun, run_out, clearance, pitch };
        let is_outside = self.inside == (from.y < 0.0);
        let began = sight.seen(self.start.x / 2.0, self.start.z);
        control.keep_thread(TurnedThread::new(sight, sight.seen_way(&way), began, is_outside, &by)?);
        hold(control, sight, Held::Thread)
    }
}

impl Action for ThreadInfeeds {
    type Results = Infeeds;

    fn act(&self, control: &mut dyn Control) -> Done<Infeeds> {
        let mut thread = thread(control.contours())?.clone();
        // Neighbouring turns of several starts are so far apart.
        let apart = thread.pitch / self.starts.max(1.0);
        let standard = if thread.is_outside { OUTSIDE_DEPTH } else { INSIDE_DEPTH } * apart;
        let depth = if self.depth == 0.0 { standard } else { self.depth.abs() };
        positive(self.largest)?;
        let share = depth / self.largest;
        let count = libm::ceil(if self.constant { share } else { share * share } - SPARE).max(1.0);
        if !(count <= MOST_PASSES) {
            return Err(too_many(MOST_PASSES).into());
        }
        let sideways = tand(self.angle);
        let leans = 1.0 + thread.slopes[0] * sideways;
        if !(self.angle.abs() < 90.0) || leans <= NOTHING {
            return Err(Fault::program("parameter-out-of-range").arg("q", "").arg("value", self.angle).into());
        }
        let reached = |cut: u32| {
            let share = f64::from(cut) / count;
            // The section of a triangle grows with the square of its depth.
            depth * if self.constant { share } else { libm::sqrt(share) }
        };
        thread.depths = (1..=count as u32).map(reached).collect();
        thread.sideways = sideways;
        control.keep_thread(thread);
        Ok(Infeeds { count, depth })
    }
}

impl OverContours for ApproachThread {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let thread = thread(contours)?;
        let (here, to) = (thread.here(pen), thread.begin(-thread.clearance));
        let over = highest(&thread.pass(-thread.clearance));
        // In front of the thread nothing is in the way.
        let in_front = here.x <= to.x && thread.start.x <= to.x;
        let over = if in_front { here.y } else { over.max(here.y) };
        thread.line(pen, DVec2::new(here.x, over), RAPID);
        thread.line(pen, DVec2::new(to.x, over), RAPID);
        thread.line(pen, to, RAPID);
        thread.infeed(pen, thread.depth(1.0)?);
        Ok(())
    }
}

impl OverContours for CutThreadPass {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let thread = thread(contours)?;
        thread.cut(pen, thread.depth(self.cut)?, self.spindle_angle);
        Ok(())
    }
}

impl OverContours for LiftOffThread {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        thread(contours)?.lift(pen);
        Ok(())
    }
}

impl OverContours for ReturnAlongThread {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        thread(contours)?.back(pen);
        Ok(())
    }
}

impl OverContours for InfeedInThread {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let thread = thread(contours)?;
        thread.infeed(pen, thread.depth(self.cut)?);
        Ok(())
    }
}

impl OverContours for CutThreadAirPasses {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let thread = thread(contours)?;
        if self.count > MOST_PASSES {
            return Err(too_many(MOST_PASSES));
        }
        let deepest = thread.depths.last().copied().unwrap_or_default();
        for _ in 0..self.count.max(0.0) as u32 {
            thread.infeed(pen, deepest);
            thread.cut(pen, deepest, self.spindle_angle);
            thread.lift(pen);
            thread.back(pen);
        }
        Ok(())
    }
}
