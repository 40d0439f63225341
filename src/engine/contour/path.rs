//! Contours: radius compensation, roundings and chamfers.
//!
//! What the tool does at the end of an element depends on the next one, so the last element waits until that is known.
//! What happens meanwhile waits after it, so that everything is reported in its order.
//!
//! Invariant: no more than one element waits; the tool is where the element that waits begins.
use std::collections::VecDeque;

use glam::{DVec2, DVec3};

use crate::engine::contour::approach::{Form, Lead, Leg};
use crate::engine::contour::breaks::Break;
use crate::engine::contour::element::{Corner, Element, Manner, Shape, corner, direction};
use crate::engine::motion::drives::Drives;
use crate::engine::motion::functions::ArcFeed;
use crate::engine::motion::moves::{Speed, Turn};
use crate::engine::report::ending::{Done, Leave};
use crate::engine::report::event::{At, Event};
use crate::engine::report::fault::{Class, Fault};
use crate::engine::report::reporter::Reporter;
use crate::engine::world::state::World;
use crate::program::syntax::{Axis, Compensation, Motion};

/// More than that does not wait after an element.
const MOST_WAITING: usize = 10_000;
/// A tool of a smaller radius, mm, runs on the contour.
const NO_RADIUS: f64 = 1e-9;

/// A rounding or chamfer between the element that waits and the next one.
#[derive(Clone, Debug)]
struct Between {
    what: Break,
    speed: Result<Speed, Fault>,
    at: At,
    /// How much waited before it.
    waiting: usize,
}

/// The block that gives an element of a contour.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BlockPlace {
    /// Its program and index.
    pub(crate) block: (usize, usize),
    /// Whether a rounding or chamfer follows directly.
    pub(crate) is_rounded: bool,
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
    /// Where its feed is that of the cutting edge.
    arc_feed: ArcFeed,
    at: At,
    block: (usize, usize),
}

/// What waits after a piece.
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
pub(crate) enum Last {
    Line(DVec2, DVec2),
    Heading(DVec2, DVec2),
}

/// The contour under way.
#[derive(Clone, Debug, Default)]
pub(crate) struct Contour {
    /// + the tool is to the left of the contour, - to the right, 0 on it.
    side: i8,
    /// The programmed position, while the tool is somewhere else.
    nominal: Option<DVec3>,
    /// Where the tool is from the centre of what runs next to the contour: the tip of a turning tool.
    tip: DVec2,
    /// The programmed position and where the tool is after a block with `R+` or `R-`.
    beside: Option<(DVec3, DVec3)>,
    /// + blocks along one axis are longer by the tool radius, - shorter.
    along: i8,
    piece: Option<Box<Piece>>,
    waiting: VecDeque<Waiting>,
    between: Option<Box<Between>>,
    /// Whether what waited is executed just now.
    releasing: bool,
    pub(crate) last: Option<Last>,
    /// Where the feed of an arc is that of the cutting edge.
    pub(crate) arc_feed: ArcFeed,
    /// The block of a contour whose execution failed.
    blamed: Option<(usize, usize)>,
}

impl Contour {
    /// Whether compensation is in effect or something waits.
    pub(crate) const fn is_under_way(&self) -> bool {
        self.side != 0 || self.piece.is_some()
    }

    /// The block that is to blame for a fault, by program and index.
    pub(crate) const fn blamed(&self) -> Option<(usize, usize)> {
        self.blamed
    }

    /// Blames a block for a fault that comes.
    pub(crate) const fn blame(&mut self, block: (usize, usize)) {
        self.blamed = Some(block);
    }

    /// Nothing goes on tangentially from here.
    pub(crate) fn forget(&mut self) {
        self.last = None;
    }

    /// Remembers a straight move, for the direction at its end.
    pub(crate) fn passed(&mut self, from: DVec2, to: DVec2) {
        if from != to {
            self.last = Some(Last::Line(from, to));
        }
    }

    /// Remembers the direction at the end of a move of another kind.
    pub(crate) fn arrived(&mut self, heading: DVec2, at: DVec2) {
        self.last = direction(heading).map(|heading| Last::Heading(heading, at));
    }

    /// A corner between the element that waits and the next one can be rounded or broken here.
    pub(crate) fn has_corner(&self) -> Result<(), Fault> {
        let is_element = |piece: &Piece| matches!(piece.kind, Kind::Element(_));
        let waits = self.piece.as_ref().is_some_and(|piece| is_element(piece));
        let plunged = self.waiting.iter().any(|waiting| matches!(waiting, Waiting::Plunge { .. }));
        if !waits || plunged || self.between.is_some() { Err(Fault::program("rounding-misplaced")) } else { Ok(()) }
    }

    /// That corner is rounded or broken.
    pub(crate) fn break_corner(&mut self, drives: &mut Drives<'_, '_>, what: Break, speed: Result<Speed, Fault>) {
        self.gather(drives);
        let (at, waiting) = (drives.report.at().clone(), self.waiting.len());
        self.between = Some(Box::new(Between { what, speed, at, waiting }));
    }

    /// + blocks along one axis are longer by the tool radius, - shorter: as a block says, or as before.
    pub(crate) const fn lengthened(&mut self, compensation: Option<Compensation>) -> i8 {
        match compensation {
            Some(Compensation::Longer) => self.along = 1,
            Some(Compensation::Shorter) => self.along = -1,
            Some(_) => self.along = 0,
            None => {}
        }
        self.along
    }

    /// After a block along one axis: the programmed position, and where the tool is.
    pub(crate) const fn went_along(&mut self, nominal: DVec3, here: DVec3) {
        self.beside = Some((nominal, here));
    }

    /// What the drives have reported since waits in its order.
    fn gather(&mut self, drives: &mut Drives<'_, '_>) {
        self.waiting.extend(drives.report.take_held().map(|event| Waiting::Event(Box::new(event))));
    }

    /// Informs the drives of what may not be executed next to this contour, and whether events wait for it.
    const fn interlock(&self, drives: &mut Drives<'_, '_>) {
        drives.beside_contour = self.is_under_way() && !self.releasing;
        drives.report.hold(self.piece.is_some() && !self.releasing);
    }

    /// The contour ends with the run: what waited to be reported.
    pub(crate) fn abandon(&mut self, drives: &mut Drives<'_, '_>) -> Vec<Event> {
        self.gather(drives);
        self.piece = None;
        self.interlock(drives);
        let waiting = std::mem::take(&mut self.waiting);
        let events = waiting.into_iter().filter_map(|waiting| match waiting {
            Waiting::Event(event) => Some(*event),
            Waiting::Plunge { .. } => None,
        });
        events.collect()
    }

    /// The programmed position: that of the contour while the tool runs next to it.
    pub(crate) fn programmed(&self, world: &World<'_>) -> DVec3 {
        match *self {
            Contour { nominal: Some(nominal), .. } => nominal,
            // Whatever else has moved the tool since counts.
            Contour { beside: Some((nominal, here)), .. } if here == world.here => nominal,
            _ => world.here,
        }
    }

    /// The side in effect: + the tool is to the left of the contour, - to the right, 0 on it.
    pub(crate) const fn side(&self) -> i8 {
        self.side
    }

    /// Whether a block belongs to a contour that waits, or begins one.
    pub(crate) fn takes(&self, motion: &Motion, place: BlockPlace) -> bool {
        self.is_under_way() || side_of(motion).is_some_and(|side| side != 0) || place.is_rounded
    }

    /// The side of a block: that of its word, or as before.
    pub(crate) fn side_of(&self, motion: &Motion) -> i8 {
        side_of(motion).unwrap_or(self.side)
    }

    /// How far the tool runs to the left of the contour, mm of the program.
    pub(crate) fn offset(&self, world: &World<'_>, side: i8) -> Result<f64, Fault> {
        if side == 0 {
            return Ok(0.0);
        }
        if world.insert_runs_beside() {
            return Ok(world.turning_insert()?.radius * f64::from(side));
        }
        let scale = world.system.plane_scale().ok_or_else(|| Fault::program("arc-scaled-unequally"))?;
        let radius = world.tool().map_or(0.0, |tool| tool.radius) / scale;
        Ok(if radius.abs() < NO_RADIUS { 0.0 } else { radius * f64::from(side) })
    }

    /// A straight block of a contour. Nothing is left of the old contour where it ends.
    pub(crate) fn line(
        &mut self,
        drives: &mut Drives<'_, '_>,
        motion: &Motion,
        place: BlockPlace,
        to: DVec3,
        speed: Result<Speed, Fault>,
    ) -> Done {
        let side = self.side_of(motion);
        let plane = drives.world.system.contour_plane();
        match (self.side, side) {
            (0, 0) => {}
            (0, _) => {
                self.end(drives)?;
                let lead = Lead::straight();
                return self.begin(drives, side, lead, to, motion, place, speed);
            }
            (_, 0) => return self.leave_straight(drives, motion, to, speed),
            (old, new) if old != new => return Err(Fault::program("compensation-side").into()),
            _ => {}
        }
        let from = self.programmed(&drives.world);
        let (start, end) = (plane.flat(from), plane.flat(to));
        if start == end {
            return self.plunge(drives, plane.tool.of(from), to, speed);
        }
        self.element(drives, Element::line(start, end), to, motion, place, speed)
    }

    /// An arc of a contour; `sweep` is its signed angle.
    pub(crate) fn arc(
        &mut self,
        drives: &mut Drives<'_, '_>,
        (centre, sweep): (DVec3, f64),
        to: DVec3,
        motion: &Motion,
        place: BlockPlace,
        speed: Result<Speed, Fault>,
    ) -> Done {
        if self.side_of(motion) != self.side {
            return Err(Fault::program("compensation-begin").into());
        }
        let plane = drives.world.system.contour_plane();
        let from = plane.flat(self.programmed(&drives.world));
        self.element(drives, Element::arc(from, plane.flat(to), plane.flat(centre), sweep), to, motion, place, speed)
    }

    /// A block that moves only along the tool axis, or not at all.
    fn plunge(&mut self, drives: &mut Drives<'_, '_>, from: f64, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let height = drives.world.system.contour_plane().tool.of(to);
        if from == height {
            return Ok(());
        }
        if self.piece.is_none() {
            self.end(drives)?;
            return drives.straight_to(to, None, speed);
        }
        if self.between.is_some() {
            return Err(Fault::program("rounding-misplaced").into());
        }
        self.nominal = Some(to);
        let at = drives.report.at().clone();
        self.gather(drives);
        self.waiting.push_back(Waiting::Plunge { height, speed, at });
        Ok(())
    }

    fn piece_of(&self, report: &Reporter<'_>, kind: Kind, offset: f64, height: f64, place: BlockPlace) -> Piece {
        let (start, cut, manner) = (DVec2::ZERO, 0.0, Manner::Usual);
        let speed = Ok(Speed::Rapid);
        let (arc_feed, at) = (self.arc_feed, report.at().clone());
        Piece { kind, offset, start, cut, height, manner, speed, arc_feed, at, block: place.block }
    }

    /// The way to a contour waits for its first element.
    #[expect(clippy::too_many_arguments, reason = "they are what the block says")]
    pub(crate) fn begin(
        &mut self,
        drives: &mut Drives<'_, '_>,
        side: i8,
        lead: Lead,
        to: DVec3,
        motion: &Motion,
        place: BlockPlace,
        speed: Result<Speed, Fault>,
    ) -> Done {
        let offset = self.offset(&drives.world, side)?;
        self.tip = drives.world.tip_of_nose(offset)?;
        let piece = self.piece_of(
            &drives.report,
            Kind::Lead(lead),
            offset,
            drives.world.system.contour_plane().tool.of(to),
            place,
        );
        self.side = side;
        self.nominal = Some(to);
        self.last = None;
        self.piece = Some(Box::new(Piece { manner: manner(motion), speed, ..piece }));
        self.interlock(drives);
        Ok(())
    }

    /// An element follows.
    fn element(
        &mut self,
        drives: &mut Drives<'_, '_>,
        element: Element,
        to: DVec3,
        motion: &Motion,
        place: BlockPlace,
        speed: Result<Speed, Fault>,
    ) -> Done {
        let offset = self.offset(&drives.world, self.side)?;
        let plane = drives.world.system.contour_plane();
        self.nominal = Some(to);
        self.last = Some(Last::Heading(element.heading_at_end(), element.to));
        let mut next = self.piece_of(&drives.report, Kind::Element(element), offset, plane.tool.of(to), place);
        (next.manner, next.speed) = (manner(motion), speed);
        if self.piece.is_none() {
            next.start = plane.flat(drives.world.here) - self.tip;
        }
        match self.between.take() {
            Some(between) => self.broken_corner(drives, *between, element, next, place)?,
            None => self.follow(drives, next)?,
        }
        if self.side == 0 && !place.is_rounded {
            self.end(drives)?;
        }
        Ok(())
    }

    /// A rounding or chamfer comes between the element that waits and the next one.
    fn broken_corner(
        &mut self,
        drives: &mut Drives<'_, '_>,
        between: Between,
        element: Element,
        next: Piece,
        place: BlockPlace,
    ) -> Done {
        let Some(mut before) = self.piece.take() else {
            return Err(Fault::program("rounding-misplaced").into());
        };
        let Kind::Element(first) = before.kind else { return Err(Fault::program("rounding-misplaced").into()) };
        let (first, corner, last) = between.what.elements(&first, &element)?;
        before.kind = Kind::Element(first);
        let height = before.height;
        self.piece = Some(before);
        self.gather(drives);
        let later = self.waiting.split_off(between.waiting.min(self.waiting.len()));
        for corner in corner {
            let (at, speed) = (between.at.clone(), between.speed.clone());
            let piece = self.piece_of(&drives.report, Kind::Element(corner), next.offset, height, place);
            self.follow(drives, Piece { at, speed, ..piece })?;
        }
        self.waiting.extend(later);
        self.follow(drives, Piece { kind: Kind::Element(last), ..next })
    }

    /// The next piece follows, so the one that waits can be executed.
    fn follow(&mut self, drives: &mut Drives<'_, '_>, mut next: Piece) -> Done {
        let Kind::Element(element) = next.kind else { return Ok(()) };
        if element.is_too_narrow(next.offset) {
            return Err(self.too_large(next.block, next.offset));
        }
        if let Some(piece) = self.piece.take() {
            let (block, offset) = (piece.block, piece.offset);
            match piece.kind {
                Kind::Lead(_) => {
                    let (start, heading) = (element.start_beside(next.offset), element.heading_at_start());
                    next.start = start;
                    self.execute_piece(drives, *piece, start, 0.0, Some(heading), None)?;
                }
                Kind::Element(before) => {
                    let corner = corner(&before, &element, offset, piece.manner);
                    let (end, cut, link) = match corner.ok_or_else(|| self.too_large(block, offset))? {
                        Corner::Meet(meeting) => {
                            (next.start, next.cut) = (meeting.point, meeting.after);
                            (meeting.point, meeting.before, None)
                        }
                        way => {
                            next.start = element.start_beside(next.offset);
                            let around = (way == Corner::Around).then_some(before.to);
                            (before.end_beside(offset), 0.0, Some((next.start, around)))
                        }
                    };
                    self.execute_piece(drives, *piece, end, cut, None, link)?;
                }
            }
        }
        self.piece = Some(Box::new(next));
        self.interlock(drives);
        Ok(())
    }

    /// Executes a piece, what waits after it, and the way round the corner: to a point, on an arc about another one.
    fn execute_piece(
        &mut self,
        drives: &mut Drives<'_, '_>,
        piece: Piece,
        end: DVec2,
        cut: f64,
        heading: Option<DVec2>,
        link: Option<(DVec2, Option<DVec2>)>,
    ) -> Done {
        let at = std::mem::replace(drives.report.at_mut(), piece.at.clone());
        self.releasing = true;
        self.gather(drives);
        self.interlock(drives);
        let plane = drives.world.system.contour_plane();
        let done = match &piece.kind {
            Kind::Element(element) => self.run_element(drives, element, &piece, end, cut),
            Kind::Lead(lead) => self.run_lead(drives, lead, &piece, end, heading),
        };
        if let Err(fault) = done {
            self.blamed = Some(piece.block);
            return Err(fault);
        }
        for waiting in std::mem::take(&mut self.waiting) {
            match waiting {
                Waiting::Event(event) => drives.report.report_waiting(*event),
                Waiting::Plunge { height, speed, at } => {
                    *drives.report.at_mut() = at;
                    drives.straight_to(plane.tool.with(drives.world.here, height), None, speed)?;
                }
            }
        }
        if let Some((to, around)) = link {
            *drives.report.at_mut() = piece.at;
            let height = plane.tool.of(drives.world.here);
            let to = plane.lift(to + self.tip, height);
            match around {
                Some(centre) => {
                    let centre = plane.lift(centre + self.tip, height);
                    let turn = Turn { plane, centre, direction: -piece.offset.signum(), sweep: None };
                    drives.arc_by(turn, to, piece.speed)?;
                }
                None => drives.straight_to(to, None, piece.speed)?,
            }
        }
        *drives.report.at_mut() = at;
        self.releasing = false;
        self.interlock(drives);
        Ok(())
    }

    fn run_element(
        &mut self,
        drives: &mut Drives<'_, '_>,
        element: &Element,
        piece: &Piece,
        end: DVec2,
        cut: f64,
    ) -> Done {
        let plane = drives.world.system.contour_plane();
        let path = element.path(piece.start, end, piece.cut + cut);
        let Some(path) = path else { return Err(self.too_large(piece.block, piece.offset)) };
        let speed = piece.speed.clone().map(|speed| speed_on(piece.arc_feed, element, &path, speed));
        leg(drives, &Leg::of(&path).moved(self.tip), plane.tool.of(drives.world.here), piece.height, speed)
    }

    fn run_lead(
        &mut self,
        drives: &mut Drives<'_, '_>,
        lead: &Lead,
        piece: &Piece,
        end: DVec2,
        heading: Option<DVec2>,
    ) -> Done {
        let plane = drives.world.system.contour_plane();
        let from = drives.world.here;
        let (aside, legs) = lead.legs(plane.flat(from) - self.tip, end, heading, self.side)?;
        if let (Some(to), Some(before)) = (aside, lead.speed_before()) {
            drives.straight_to(plane.lift(to + self.tip, plane.tool.of(from)), None, before)?;
            drives.straight_to(plane.tool.with(drives.world.here, piece.height), None, piece.speed.clone())?;
        }
        for piece_of_way in legs {
            leg(
                drives,
                &piece_of_way.moved(self.tip),
                plane.tool.of(drives.world.here),
                piece.height,
                piece.speed.clone(),
            )?;
        }
        Ok(())
    }

    fn too_large(&mut self, block: (usize, usize), offset: f64) -> Leave {
        self.blamed = Some(block);
        Fault::control("compensation-too-large").arg("radius", offset.abs()).into()
    }

    /// Executes what waits: the tool ends next to the end of the contour. Compensation ends.
    pub(crate) fn end(&mut self, drives: &mut Drives<'_, '_>) -> Done {
        if let Some(piece) = self.piece.take() {
            if self.between.is_some() {
                return Err(Fault::program("rounding-misplaced").into());
            }
            let end = match &piece.kind {
                Kind::Element(element) => element.end_beside(piece.offset),
                Kind::Lead(_) => {
                    self.blamed = Some(piece.block);
                    return Err(Fault::program("contour-missing").into());
                }
            };
            self.execute_piece(drives, *piece, end, 0.0, None, None)?;
        }
        self.side = 0;
        self.nominal = None;
        self.tip = DVec2::ZERO;
        self.interlock(drives);
        Ok(())
    }

    /// Compensation ends, and the tool goes straight to a point. Of a block that moves only along the tool axis, the
    /// tool stays next to the contour.
    fn leave_straight(
        &mut self,
        drives: &mut Drives<'_, '_>,
        motion: &Motion,
        to: DVec3,
        speed: Result<Speed, Fault>,
    ) -> Done {
        self.end(drives)?;
        let plane = drives.world.system.contour_plane();
        let tool = match plane.tool.letter() {
            'X' => Axis::X,
            'Y' => Axis::Y,
            _ => Axis::Z,
        };
        let in_plane = motion.coords.iter().any(|coord| coord.axis != tool);
        let to = if in_plane { to } else { plane.tool.with(drives.world.here, plane.tool.of(to)) };
        let from = plane.flat(drives.world.here);
        self.passed(from, plane.flat(to));
        drives.straight_to(to, None, speed)
    }

    /// The contour ends, and the tool leaves it in a form of `DEP`; `along` is the direction at its end.
    pub(crate) fn leave_by(
        &mut self,
        drives: &mut Drives<'_, '_>,
        form: Form,
        along: DVec2,
        to: DVec3,
        speed: Result<Speed, Fault>,
    ) -> Done {
        let (side, tip) = (self.side, self.tip);
        self.end(drives)?;
        let plane = drives.world.system.contour_plane();
        let (from, height) = (plane.flat(drives.world.here), plane.tool.of(drives.world.here));
        let legs = form.legs_away(from - tip, plane.flat(to) - tip, along, side)?;
        for piece_of_way in &legs {
            leg(drives, &piece_of_way.moved(tip), height, height, speed.clone())?;
        }
        self.forget();
        // A height that is programmed, too, is reached last.
        drives.straight_to(plane.tool.with(drives.world.here, plane.tool.of(to)), None, speed)
    }

    /// The direction at the end of the contour so far.
    pub(crate) fn heading(&self, world: &World<'_>) -> Result<DVec2, Fault> {
        let here = world.system.contour_plane().flat(self.programmed(world));
        let heading = match self.last {
            Some(Last::Line(from, to)) if to == here => direction(to - from),
            Some(Last::Heading(heading, to)) if to == here => Some(heading),
            _ => None,
        };
        heading.ok_or_else(|| Fault::program("tangent-missing"))
    }

    /// Remembers an arc that is executed at once, for the direction at its end.
    pub(crate) fn passed_arc(&mut self, from: DVec2, to: DVec2, centre: DVec2, sweep: f64) {
        self.last = Some(Last::Heading(Element::arc(from, to, centre, sweep).heading_at_end(), to));
    }

    /// A fault if more waits after an element than may.
    pub(crate) fn no_more_waits(&self, report: &Reporter<'_>) -> Done {
        if self.waiting.len() + report.held() <= MOST_WAITING {
            return Ok(());
        }
        Err(Fault::new(Class::Limit, "contour-limit").arg("limit", MOST_WAITING as f64).into())
    }
}

/// Runs a line or arc, and to a height at the same time.
pub(crate) fn leg(drives: &mut Drives<'_, '_>, leg: &Leg, from: f64, height: f64, speed: Result<Speed, Fault>) -> Done {
    let plane = drives.world.system.contour_plane();
    match *leg {
        Leg::Line(to) => drives.straight_to(plane.lift(to, height), None, speed),
        Leg::Arc { centre, to, sweep } if sweep == 0.0 || to == centre => {
            drives.straight_to(plane.lift(to, height), None, speed)
        }
        Leg::Arc { centre, to, sweep } => {
            let (centre, to) = (plane.lift(centre, from), plane.lift(to, height));
            drives.arc_by(Turn { plane, centre, direction: sweep.signum(), sweep: Some(sweep) }, to, speed)
        }
    }
}

/// The speed of the tool centre on an arc whose cutting edge keeps the feed.
fn speed_on(arc_feed: ArcFeed, element: &Element, path: &Element, speed: Speed) -> Speed {
    let (Shape::Arc { centre, .. }, Speed::Feed(feed)) = (&element.shape, speed) else { return speed };
    let share = path.from.distance(*centre) / element.from.distance(*centre);
    match arc_feed {
        ArcFeed::Edge => Speed::Feed(feed * share),
        ArcFeed::EdgeInside if share < 1.0 => Speed::Feed(feed * share),
        ArcFeed::EdgeInside | ArcFeed::Centre => speed,
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
