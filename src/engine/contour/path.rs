//! Contours: radius compensation, roundings and chamfers.
//!
//! What the tool does at the end of an element depends on the next one, so the last element waits until that is known.
//! What happens meanwhile waits behind it, so that everything is told in its order.
//!
//! Invariant: no more than one element waits; the tool stands where the element that waits begins.
use std::collections::VecDeque;

use glam::{DVec2, DVec3};

use crate::engine::contour::approach::{Lead, Leg};
use crate::engine::contour::element::{Corner, Element, Manner, Shape, broken, corner, direction, rounded};
use crate::engine::motion::axis::linear;
use crate::engine::motion::moves::Speed;
use crate::engine::report::event::{At, Event};
use crate::engine::report::fault::{Class, Fault};
use crate::engine::run::{Done, Run};
use crate::program::syntax::{Axis, Compensation, Motion};

/// More than that does not wait behind an element.
const MOST_WAITING: usize = 10_000;
/// A tool of a smaller radius, mm, runs on the contour.
const NO_RADIUS: f64 = 1e-9;

/// What comes at a corner.
#[derive(Clone, Copy, Debug)]
enum Break {
    Rounding(f64),
    Chamfer(f64),
}

/// A rounding or chamfer between the element that waits and the next one.
#[derive(Clone, Debug)]
struct Between {
    what: Break,
    speed: Result<Speed, Fault>,
    at: At,
    /// How much waited before it.
    waiting: usize,
}

/// What is known of a piece of a contour before its end is.
#[derive(Clone, Debug)]
enum Kind {
    Element(Element),
    /// The way to the contour point at which compensation begins.
    Lead(Lead),
}

/// A piece of a contour.
#[derive(Clone, Debug)]
struct Piece {
    kind: Kind,
    /// How far the tool runs to the left of the contour, mm of the program.
    offset: f64,
    /// Where the tool begins, and how much of the element that leaves out.
    start: DVec2,
    cut: f64,
    /// The coordinate of the tool axis at its end.
    height: f64,
    manner: Manner,
    speed: Result<Speed, Fault>,
    at: At,
    block: (usize, usize),
}

/// What waits behind a piece.
#[derive(Clone, Debug)]
enum Waiting {
    /// A move along the tool axis.
    Plunge {
        height: f64,
        speed: Result<Speed, Fault>,
        at: At,
    },
    Event(Box<Event>),
}

/// The end of the last move in the working plane and the direction there.
#[derive(Clone, Copy, Debug)]
pub(in crate::engine) enum Last {
    Line(DVec2, DVec2),
    Heading(DVec2, DVec2),
}

/// The contour under way.
#[derive(Clone, Debug, Default)]
pub(in crate::engine) struct Contour {
    /// + the tool is to the left of the contour, - to the right, 0 on it.
    side: i8,
    /// The programmed position, while the tool is somewhere else.
    nominal: Option<DVec3>,
    /// The programmed position and where the tool stands after a block with `R+` or `R-`.
    beside: Option<(DVec3, DVec3)>,
    /// + blocks along one axis are longer by the tool radius, - shorter.
    along: i8,
    piece: Option<Box<Piece>>,
    waiting: VecDeque<Waiting>,
    between: Option<Box<Between>>,
    /// Whether what waited is executed just now.
    releasing: bool,
    pub(in crate::engine) last: Option<Last>,
    /// The block of a contour whose execution failed.
    blamed: Option<(usize, usize)>,
}

impl Contour {
    /// + the tool is to the left of the contour, - to the right, 0 on it.
    pub(in crate::engine) const fn side(&self) -> i8 {
        self.side
    }

    /// Whether compensation is in effect or something waits.
    pub(in crate::engine) const fn is_under_way(&self) -> bool {
        self.side != 0 || self.piece.is_some()
    }

    /// Whether a move that the contour does not make itself would come out of turn.
    pub(in crate::engine) const fn is_disturbed(&self) -> bool {
        self.is_under_way() && !self.releasing
    }

    /// Whether events wait until the element before them is executed.
    pub(in crate::engine) const fn holds_events(&self) -> bool {
        self.piece.is_some() && !self.releasing
    }

    /// An event waits.
    pub(in crate::engine) fn hold(&mut self, event: Event) {
        self.waiting.push_back(Waiting::Event(Box::new(event)));
    }

    /// The block that is to blame for a fault, by program and index.
    pub(in crate::engine) const fn blamed(&self) -> Option<(usize, usize)> {
        self.blamed
    }

    /// The contour ends with the run: what waited to be told.
    pub(in crate::engine) fn abandon(&mut self) -> Vec<Event> {
        self.piece = None;
        let waiting = std::mem::take(&mut self.waiting);
        let events = waiting.into_iter().filter_map(|waiting| match waiting {
            Waiting::Event(event) => Some(*event),
            Waiting::Plunge { .. } => None,
        });
        events.collect()
    }

    /// Nothing goes on tangentially from here.
    pub(in crate::engine) fn forget(&mut self) {
        self.last = None;
    }

    /// Remembers a straight move, for the direction at its end.
    pub(in crate::engine) fn passed(&mut self, from: DVec2, to: DVec2) {
        if from != to {
            self.last = Some(Last::Line(from, to));
        }
    }
}

impl Run<'_, '_> {
    /// The programmed position: that of the contour while the tool runs beside it.
    pub(in crate::engine) fn programmed(&self) -> DVec3 {
        match self.contour {
            Contour { nominal: Some(nominal), .. } => nominal,
            // Whatever else has moved the tool since counts.
            Contour { beside: Some((nominal, here)), .. } if here == self.world.here => nominal,
            _ => self.world.here,
        }
    }

    /// Whether a block belongs to a contour that waits, or begins one.
    pub(in crate::engine) fn is_in_contour(&self, motion: &Motion) -> bool {
        self.contour.is_under_way() || side_of(motion).is_some_and(|side| side != 0) || self.is_rounded_next()
    }

    fn is_rounded_next(&self) -> bool {
        self.programs.get(self.flow.program).is_some_and(|prepared| prepared.is_rounded(self.flow.block))
    }

    /// A fault if something that cannot be executed beside a contour comes while compensation is in effect.
    pub(in crate::engine) fn not_beside_contour(&self, word: impl Into<String>) -> Done {
        if !self.contour.is_disturbed() {
            return Ok(());
        }
        Err(Fault::unsupported("unsupported-compensation").arg("word", word.into()).into())
    }

    /// The side of a block: that of its word, or as before.
    pub(in crate::engine) fn side(&self, motion: &Motion) -> i8 {
        side_of(motion).unwrap_or(self.contour.side)
    }

    /// How far the tool runs to the left of the contour, mm of the program.
    pub(in crate::engine) fn offset(&self, side: i8) -> Result<f64, Fault> {
        if side == 0 {
            return Ok(0.0);
        }
        let scale = self.world.system.plane_scale().ok_or_else(|| Fault::program("arc-scaled-unequally"))?;
        let radius = self.world.tool().map_or(0.0, |tool| tool.radius) / scale;
        Ok(if radius.abs() < NO_RADIUS { 0.0 } else { radius * f64::from(side) })
    }

    /// A block that positions one axis: with `R+` the way is longer by the tool radius, with `R-` shorter.
    pub(in crate::engine) fn along_axis(
        &mut self,
        motion: &Motion,
        in_machine: bool,
        speed: Result<Speed, Fault>,
    ) -> Done {
        match motion.compensation {
            Some(Compensation::Longer) => self.contour.along = 1,
            Some(Compensation::Shorter) => self.contour.along = -1,
            Some(_) => self.contour.along = 0,
            None => {}
        }
        let axis = motion.coords.first().and_then(|coord| linear(coord.axis).ok());
        let Some(axis) = axis.filter(|_| !in_machine) else { return self.line(motion, in_machine, speed) };
        if self.contour.along != 0 {
            self.not_beside_contour("R+, R-")?;
        }
        if self.is_in_contour(motion) {
            return self.line(motion, in_machine, speed);
        }
        let from = self.programmed();
        let nominal = self.target(&motion.coords, from)?;
        let way = axis.of(nominal - from);
        let radius = self.offset(1)? * f64::from(self.contour.along);
        let tool = self.world.system.plane.tool;
        // Along its own axis the tool has no radius, and no way has no end.
        let longer = if axis == tool || way == 0.0 { 0.0 } else { radius * way.signum() };
        let to = axis.with(self.world.here, axis.of(nominal) + longer);
        self.contour.forget();
        self.straight_to(to, None, speed)?;
        self.contour.beside = Some((nominal, self.world.here));
        Ok(())
    }

    /// A straight block of a contour. Nothing is left of the old contour where it ends.
    pub(in crate::engine) fn contour_line(&mut self, motion: &Motion, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let side = self.side(motion);
        let plane = self.world.system.plane;
        match (self.contour.side, side) {
            (0, 0) => {}
            (0, _) => {
                self.end_contour()?;
                let lead = Lead::straight();
                return self.begin_contour(side, lead, to, motion, speed);
            }
            (_, 0) => return self.leave_contour(motion, to, speed),
            (old, new) if old != new => return Err(Fault::program("compensation-side").into()),
            _ => {}
        }
        let from = self.programmed();
        let (start, end) = (plane.flat(from), plane.flat(to));
        if start == end {
            return self.contour_plunge(plane.tool.of(from), to, speed);
        }
        self.contour_element(Element::line(start, end), to, motion, speed)
    }

    /// An arc of a contour; `sweep` is its signed angle.
    pub(in crate::engine) fn contour_arc(
        &mut self,
        centre: DVec3,
        to: DVec3,
        sweep: f64,
        motion: &Motion,
        speed: Result<Speed, Fault>,
    ) -> Done {
        if self.side(motion) != self.contour.side {
            return Err(Fault::program("compensation-begin").into());
        }
        let plane = self.world.system.plane;
        let from = plane.flat(self.programmed());
        self.contour_element(Element::arc(from, plane.flat(to), plane.flat(centre), sweep), to, motion, speed)
    }

    /// A block that moves only along the tool axis, or not at all.
    fn contour_plunge(&mut self, from: f64, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let height = self.world.system.plane.tool.of(to);
        if from == height {
            return Ok(());
        }
        if self.contour.piece.is_none() {
            self.end_contour()?;
            return self.straight_to(to, None, speed);
        }
        if self.contour.between.is_some() {
            return Err(Fault::program("rounding-misplaced").into());
        }
        self.contour.nominal = Some(to);
        let at = self.event.at.clone();
        self.contour.waiting.push_back(Waiting::Plunge { height, speed, at });
        Ok(())
    }

    fn piece(&self, kind: Kind, offset: f64, height: f64, speed: Result<Speed, Fault>) -> Piece {
        let block = (self.flow.program, self.flow.block);
        let (start, cut, manner) = (DVec2::ZERO, 0.0, Manner::Usual);
        Piece { kind, offset, start, cut, height, manner, speed, at: self.event.at.clone(), block }
    }

    /// The way to a contour waits for its first element.
    pub(in crate::engine) fn begin_contour(
        &mut self,
        side: i8,
        lead: Lead,
        to: DVec3,
        motion: &Motion,
        speed: Result<Speed, Fault>,
    ) -> Done {
        let offset = self.offset(side)?;
        let piece = self.piece(Kind::Lead(lead), offset, self.world.system.plane.tool.of(to), speed);
        self.contour.side = side;
        self.contour.nominal = Some(to);
        self.contour.last = None;
        self.contour.piece = Some(Box::new(Piece { manner: manner(motion), ..piece }));
        Ok(())
    }

    /// An element follows.
    fn contour_element(&mut self, element: Element, to: DVec3, motion: &Motion, speed: Result<Speed, Fault>) -> Done {
        let offset = self.offset(self.contour.side)?;
        let plane = self.world.system.plane;
        self.contour.nominal = Some(to);
        self.contour.last = Some(Last::Heading(element.heading_at_end(), element.to));
        let mut next = self.piece(Kind::Element(element), offset, plane.tool.of(to), speed);
        next.manner = manner(motion);
        if self.contour.piece.is_none() {
            next.start = plane.flat(self.world.here);
        }
        match self.contour.between.take() {
            Some(between) => self.broken_corner(*between, element, next)?,
            None => self.follow(next)?,
        }
        if self.contour.side == 0 && !self.is_rounded_next() {
            self.end_contour()?;
        }
        Ok(())
    }

    /// A rounding or chamfer comes between the element that waits and the next one.
    fn broken_corner(&mut self, between: Between, element: Element, next: Piece) -> Done {
        let Some(mut before) = self.contour.piece.take() else {
            return Err(Fault::program("rounding-misplaced").into());
        };
        let Kind::Element(first) = before.kind else { return Err(Fault::program("rounding-misplaced").into()) };
        let (found, size) = match between.what {
            Break::Rounding(radius) => (rounded(&first, &element, radius), radius),
            Break::Chamfer(leg) => (broken(&first, &element, leg), leg),
        };
        let Some((first, corner, last)) = found else {
            return Err(Fault::program("rounding-impossible").arg("size", size).into());
        };
        before.kind = Kind::Element(first);
        let height = before.height;
        self.contour.piece = Some(before);
        let later = self.contour.waiting.split_off(between.waiting.min(self.contour.waiting.len()));
        if let Some(corner) = corner {
            let at = between.at;
            let piece = self.piece(Kind::Element(corner), next.offset, height, between.speed);
            self.follow(Piece { at, ..piece })?;
        }
        self.contour.waiting.extend(later);
        self.follow(Piece { kind: Kind::Element(last), ..next })
    }

    /// The next piece follows, so the one that waits can be executed.
    fn follow(&mut self, mut next: Piece) -> Done {
        let Kind::Element(element) = next.kind else { return Ok(()) };
        if element.is_too_narrow(next.offset) {
            return Err(self.too_large(next.block, next.offset));
        }
        if let Some(piece) = self.contour.piece.take() {
            let (block, offset) = (piece.block, piece.offset);
            match piece.kind {
                Kind::Lead(_) => {
                    let (start, heading) = (element.start_beside(next.offset), element.heading_at_start());
                    next.start = start;
                    self.execute_piece(*piece, start, 0.0, Some(heading), None)?;
                }
                Kind::Element(before) => {
                    let corner = corner(&before, &element, offset, piece.manner);
                    let (end, cut, link) = match corner.ok_or_else(|| self.too_large(block, offset))? {
                        Corner::Meet(meeting) => {
                            (next.start, next.cut) = (meeting.point, meeting.behind);
                            (meeting.point, meeting.before, None)
                        }
                        way => {
                            next.start = element.start_beside(next.offset);
                            let around = (way == Corner::Around).then_some(before.to);
                            (before.end_beside(offset), 0.0, Some((next.start, around)))
                        }
                    };
                    self.execute_piece(*piece, end, cut, None, link)?;
                }
            }
        }
        self.contour.piece = Some(Box::new(next));
        Ok(())
    }

    /// Executes a piece, what waits behind it, and the way round the corner: to a point, on an arc about another one.
    fn execute_piece(
        &mut self,
        piece: Piece,
        end: DVec2,
        cut: f64,
        heading: Option<DVec2>,
        link: Option<(DVec2, Option<DVec2>)>,
    ) -> Done {
        let at = std::mem::replace(&mut self.event.at, piece.at.clone());
        self.contour.releasing = true;
        let plane = self.world.system.plane;
        let done = match &piece.kind {
            Kind::Element(element) => self.run_element(element, &piece, end, cut),
            Kind::Lead(lead) => self.run_lead(lead, &piece, end, heading),
        };
        if let Err(fault) = done {
            self.contour.blamed = Some(piece.block);
            return Err(fault);
        }
        for waiting in std::mem::take(&mut self.contour.waiting) {
            match waiting {
                Waiting::Event(event) => self.tell_later(*event),
                Waiting::Plunge { height, speed, at } => {
                    self.event.at = at;
                    self.straight_to(plane.tool.with(self.world.here, height), None, speed)?;
                }
            }
        }
        if let Some((to, around)) = link {
            self.event.at = piece.at;
            let height = plane.tool.of(self.world.here);
            let to = plane.lift(to, height);
            match around {
                Some(centre) => {
                    self.arc_to(plane.lift(centre, height), to, -piece.offset.signum(), None, piece.speed)?;
                }
                None => self.straight_to(to, None, piece.speed)?,
            }
        }
        self.event.at = at;
        self.contour.releasing = false;
        Ok(())
    }

    fn run_element(&mut self, element: &Element, piece: &Piece, end: DVec2, cut: f64) -> Done {
        let plane = self.world.system.plane;
        let path = element.path(piece.start, end, piece.cut + cut);
        let Some(path) = path else { return Err(self.too_large(piece.block, piece.offset)) };
        self.leg(&Leg::of(&path), plane.tool.of(self.world.here), piece.height, piece.speed.clone())
    }

    fn run_lead(&mut self, lead: &Lead, piece: &Piece, end: DVec2, heading: Option<DVec2>) -> Done {
        let plane = self.world.system.plane;
        let from = self.world.here;
        let (aside, legs) = lead.legs(plane.flat(from), end, heading, self.contour.side)?;
        if let (Some(to), Some(before)) = (aside, lead.speed_before()) {
            self.straight_to(plane.lift(to, plane.tool.of(from)), None, before)?;
            self.straight_to(plane.tool.with(self.world.here, piece.height), None, piece.speed.clone())?;
        }
        for leg in legs {
            self.leg(&leg, plane.tool.of(self.world.here), piece.height, piece.speed.clone())?;
        }
        Ok(())
    }

    /// Runs a line or arc, and to a height at the same time.
    pub(in crate::engine) fn leg(&mut self, leg: &Leg, from: f64, height: f64, speed: Result<Speed, Fault>) -> Done {
        let plane = self.world.system.plane;
        match *leg {
            Leg::Line(to) => self.straight_to(plane.lift(to, height), None, speed),
            Leg::Arc { centre, to, sweep } if sweep == 0.0 || to == centre => {
                self.straight_to(plane.lift(to, height), None, speed)
            }
            Leg::Arc { centre, to, sweep } => {
                let (centre, to) = (plane.lift(centre, from), plane.lift(to, height));
                self.arc_to(centre, to, sweep.signum(), Some(sweep), speed)
            }
        }
    }

    fn too_large(&mut self, block: (usize, usize), offset: f64) -> crate::engine::run::Leave {
        self.contour.blamed = Some(block);
        Fault::control("compensation-too-large").arg("radius", offset.abs()).into()
    }

    /// Executes what waits: the tool ends beside the end of the contour. Compensation ends.
    pub(in crate::engine) fn end_contour(&mut self) -> Done {
        if let Some(piece) = self.contour.piece.take() {
            if self.contour.between.is_some() {
                return Err(Fault::program("rounding-misplaced").into());
            }
            let end = match &piece.kind {
                Kind::Element(element) => element.end_beside(piece.offset),
                Kind::Lead(_) => {
                    self.contour.blamed = Some(piece.block);
                    return Err(Fault::program("contour-missing").into());
                }
            };
            self.execute_piece(*piece, end, 0.0, None, None)?;
        }
        self.contour.side = 0;
        self.contour.nominal = None;
        Ok(())
    }

    /// Compensation ends, and the tool goes straight to a point. Of a block that moves only along the tool axis, the
    /// tool stays beside the contour.
    fn leave_contour(&mut self, motion: &Motion, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        self.end_contour()?;
        let plane = self.world.system.plane;
        let tool = match plane.tool.letter() {
            'X' => Axis::X,
            'Y' => Axis::Y,
            _ => Axis::Z,
        };
        let in_plane = motion.coords.iter().any(|coord| coord.axis != tool);
        let to = if in_plane { to } else { plane.tool.with(self.world.here, plane.tool.of(to)) };
        let from = plane.flat(self.world.here);
        self.contour.passed(from, plane.flat(to));
        self.straight_to(to, None, speed)
    }

    /// The direction at the end of the contour so far.
    pub(in crate::engine) fn heading(&self) -> Result<DVec2, Fault> {
        let here = self.world.system.plane.flat(self.programmed());
        let heading = match self.contour.last {
            Some(Last::Line(from, to)) if to == here => direction(to - from),
            Some(Last::Heading(heading, to)) if to == here => Some(heading),
            _ => None,
        };
        heading.ok_or_else(|| Fault::program("tangent-missing"))
    }

    /// Remembers an arc that is executed at once, for the direction at its end.
    pub(in crate::engine) fn passed_arc(&mut self, from: DVec2, to: DVec2, centre: DVec2, sweep: f64) {
        self.contour.last = Some(Last::Heading(Element::arc(from, to, centre, sweep).heading_at_end(), to));
    }

    /// `RND` and `CHF`: they change the corner between the element that waits and the next one.
    pub(in crate::engine) fn rounding(&mut self, motion: &Motion, chamfer: bool) -> Done {
        let is_element = |piece: &Piece| matches!(piece.kind, Kind::Element(_));
        let waits = self.contour.piece.as_ref().is_some_and(|piece| is_element(piece));
        let plunged = self.contour.waiting.iter().any(|waiting| matches!(waiting, Waiting::Plunge { .. }));
        if !waits || plunged || self.contour.between.is_some() {
            return Err(Fault::program("rounding-misplaced").into());
        }
        let Some(size) = &motion.radius else { return Err(Fault::program("radius-missing").into()) };
        let size = self.operand(size)? * self.unit();
        if size < 0.0 {
            return Err(Fault::program("rounding-impossible").arg("size", size).into());
        }
        // Its feed holds for the corner only.
        let feed = self.modal.feed;
        let speed = self.speed(motion.feed.as_ref());
        self.modal.feed = feed;
        let what = if chamfer { Break::Chamfer(size) } else { Break::Rounding(size) };
        self.contour.between =
            Some(Box::new(Between { what, speed, at: self.event.at.clone(), waiting: self.contour.waiting.len() }));
        Ok(())
    }

    /// A fault if more waits behind an element than may.
    pub(in crate::engine) fn no_more_waits(&self) -> Done {
        if self.contour.waiting.len() <= MOST_WAITING {
            return Ok(());
        }
        Err(Fault::new(Class::Limit, "contour-limit").arg("limit", MOST_WAITING as f64).into())
    }
}

/// The side that a block names.
fn side_of(motion: &Motion) -> Option<i8> {
    motion.compensation.and_then(|compensation| match compensation {
        Compensation::R0 => Some(0),
        Compensation::Rl => Some(1),
        Compensation::Rr => Some(-1),
        Compensation::Longer | Compensation::Shorter => None,
    })
}

/// How the corner at the end of a block is to be gone round.
fn manner(motion: &Motion) -> Manner {
    match motion.functions.iter().map(|function| function.number).find(|number| matches!(number, 97 | 98)) {
        Some(97) => Manner::Intersection,
        Some(_) => Manner::Open,
        None => Manner::Usual,
    }
}

impl Leg {
    fn of(path: &Element) -> Self {
        match path.shape {
            Shape::Line => Self::Line(path.to),
            Shape::Arc { centre, sweep } => Self::Arc { centre, to: path.to, sweep },
        }
    }
}
