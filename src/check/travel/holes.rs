//! What cycles do to the blank where they are called: holes, taps and pockets at places that are known.
use std::collections::HashMap;

use super::{Cut, REACH, SKIN, Walk};
use crate::base::diag::Span;
use crate::check::blank::is_unmoved;
use crate::check::incident::Incident;
use crate::check::program::number;
use crate::check::tools::kind_of_call;
use crate::check::toolwords::ToolKind;
use crate::check::{Aspect, Defined, Definition, Loaded, Modal, Pending, Tri, is_milling};
use crate::program::syntax::{Block, BlockKind, CallForm, Coord};
use crate::spec::{Group, Keyword, Quantity, Reference};

/// How far above the blank holes may begin, which may be drawn too small, in millimetres.
const ALLOWANCE: f64 = 50.0;
/// How far they may go through it: the tip of a drill, in millimetres.
const TIP: f64 = 25.0;
/// Places of holes that are so close are the same, in millimetres.
const SAME: f64 = 0.01;
/// The meanings of the values of holes.
const SURFACE: &str = "surface-coordinate";
const DEPTH: &str = "depth";
const CLEARANCE: &str = "set-up-clearance";
const THREAD_DEPTH: &str = "thread-depth";
const DEEPENED: &str = "deepened-starting-point";
/// What the meanings of lengths have in them that do not say how large a pocket is.
const NO_SIZES: [&str; 5] = ["clearance", "depth", "allowance", "infeed", "coordinate"];

/// The holes that the program has made.
#[derive(Default)]
pub(super) struct Holes {
    /// Where they are, and their bottoms as far as they are known.
    made: Vec<([f64; 2], Option<f64>)>,
    /// Whether there may be others.
    others: bool,
    /// The diameters of round holes and pockets, with their places, and their bottoms as far as they are known.
    wide: Vec<([f64; 2], f64, Option<f64>)>,
    /// What was machined already: the definition, the tool call, the place.
    machined: HashMap<(u32, Loaded, [u64; 2]), Span>,
    /// Whether a tap without a hole, and one that is too deep, were found.
    reported: [bool; 2],
}

impl Holes {
    /// There may be holes elsewhere.
    pub(super) const fn lose(&mut self) {
        self.others = true;
    }

    /// The holes at a place.
    fn at(&self, place: [f64; 2], same: f64) -> impl Iterator<Item = Option<f64>> {
        let here = move |own: &&([f64; 2], Option<f64>)| {
            (own.0[0] - place[0]).abs() <= same && (own.0[1] - place[1]).abs() <= same
        };
        self.made.iter().filter(here).map(|(_, bottom)| *bottom)
    }
}

/// What says how wide a thread is.
const NOMINAL: &str = "nominal-diameter";
/// What says how wide a round pocket is.
const CIRCLE: &str = "circle-diameter";
/// The sides of a rectangular pocket.
const LENGTHS: [&str; 2] = ["first-side-length", "second-side-length"];
/// A pocket may be so far beyond an edge of the blank, in millimetres.
const OVER: f64 = 0.5;
/// A groove that is open at both ends goes no farther beyond them, in millimetres.
const OPEN_END: f64 = 25.0;
/// Around a hole of which nobody says how wide it is, so much is never looked at, in millimetres.
const NARROW: f64 = 20.0;

/// What a cycle makes at a place.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Makes {
    Hole,
    Tap,
    Pocket,
    /// Something of which nobody knows how large it is.
    Anything,
}

fn makes(own: &Defined<'_>) -> Makes {
    let Some(cycle) = own.related_cycle().filter(|_| own.key.keyword == Keyword::CyclDef) else {
        return Makes::Anything;
    };
    match cycle.file.group {
        Group::Drilling => Makes::Hole,
        Group::Threads if !is_milling(cycle) => Makes::Tap,
        Group::Pockets => Makes::Pocket,
        _ => Makes::Anything,
    }
}

impl Walk<'_, '_> {
    /// Where a block calls the cycle; nothing if that is not known.
    pub(super) fn places_of_call(&mut self, block: &Block) -> Option<Vec<[f64; 2]>> {
        if let BlockKind::CyclCall(call) = &block.kind {
            match &call.form {
                CallForm::Plain => {}
                CallForm::Pattern => {
                    let pattern = self.pattern.clone();
                    self.lose();
                    return pattern;
                }
                CallForm::Position(coords) => self.go_to(coords),
            }
        }
        let [Some(x), Some(y), _] = self.at else { return None };
        Some(vec![[x, y]])
    }

    fn go_to(&mut self, coords: &[Coord]) {
        for (place, axis) in super::AXES.into_iter().enumerate() {
            if let Some(coord) = coords.iter().find(|own| own.axis == axis) {
                self.at[place] = self.target(coord, self.at[place]);
            }
        }
    }

    /// The cycle that was defined last is called.
    pub(super) fn machine(&mut self, modal: &Modal, span: Span, places: Option<Vec<[f64; 2]>>) {
        let facts = self.facts;
        let index = match modal.pending {
            Pending::Definition(index) => Some(index),
            Pending::None | Pending::Unknown => None,
        };
        let definition = index.and_then(|index| facts.definitions.get(index as usize));
        let what = definition.map_or(Makes::Anything, makes);
        let (Some(definition), Some(places)) = (definition, places) else {
            (self.open, self.at) = (true, [None; 3]);
            return self.holes.lose();
        };
        self.widths(definition, what, modal, span, &places);
        if what == Makes::Anything {
            (self.open, self.at) = (true, [None; 3]);
            return self.holes.lose();
        }
        let usual = is_unmoved(modal) && modal.is(Aspect::OtherAxis) != Tri::Yes && self.turned == [false; 3];
        let related = definition.as_related_cycle();
        let read = facts.read(&related);
        if !usual {
            self.holes.lose();
        }
        let size = if what == Makes::Pocket { size(&read) } else { Some(0.0) };
        for place in &places {
            match what {
                _ if !usual => {}
                Makes::Pocket => {
                    self.holes.lose();
                    if size.is_some_and(|size| self.blank.distance(*place) > size) {
                        self.found.push((span, Incident::OutsideBlank(*place)));
                    } else if self.goes_over(&read, *place) {
                        self.found.push((span, Incident::CoversBlank(*place)));
                    }
                }
                Makes::Tap => self.tap(&read, span, *place),
                _ => self.hole(&read, span, *place),
            }
            if usual && what != Makes::Pocket {
                self.judge(&read, index, span, *place);
            }
            if usual {
                self.come_down(&read, *place);
                self.note_place(index, modal, span, *place);
            }
            let narrow = what != Makes::Pocket && read.item(NOMINAL).is_none();
            let reach = if narrow { NARROW } else { REACH } * self.unit + size.unwrap_or(0.0);
            let [x, y] = *place;
            self.remember(Cut { low: [x - reach, y - reach], high: [x + reach, y + reach], floor: f64::NEG_INFINITY });
        }
        self.open |= size.is_none();
        self.at[2] = None;
    }

    /// Notes that a definition machines at a place, and whether it has done so before, from another block.
    fn note_place(&mut self, index: Option<u32>, modal: &Modal, span: Span, place: [f64; 2]) {
        let Some(index) = index.filter(|_| matches!(modal.loaded, Loaded::By(_))) else { return };
        // Zero has two signs.
        let key = (index, modal.loaded, place.map(|own| (own + 0.0).to_bits()));
        if self.holes.machined.len() >= super::MANY {
            return;
        }
        let first = *self.holes.machined.entry(key).or_insert(span);
        if first != span {
            self.found.push((span, Incident::MachinedAgain(place)));
        }
    }

    /// Notes how wide holes are, and compares a thread with the one that it is cut in.
    fn widths(&mut self, own: &Defined<'_>, what: Makes, modal: &Modal, span: Span, places: &[[f64; 2]]) {
        let threads = own.related_cycle().is_some_and(|cycle| cycle.file.group == Group::Threads);
        let usual = is_unmoved(modal) && modal.is(Aspect::OtherAxis) != Tri::Yes && self.turned == [false; 3];
        if !usual || (what == Makes::Anything && !threads) {
            return;
        }
        let related = own.as_related_cycle();
        let read = self.facts.read(&related);
        let tool = self.tools.as_ref().and_then(|tools| tools.get(modal.loaded)).map(|tool| 2.0 * tool.radius);
        let width = match what {
            Makes::Pocket => read.item(CIRCLE).and_then(number),
            _ if read.item(NOMINAL).is_some() => read.item(NOMINAL).and_then(number),
            // What only centres is not as wide as its tool.
            Makes::Hole if !is_whole(&read) || self.only_centres(&read, modal, tool) => None,
            _ => tool,
        };
        let Some(width) = width.filter(|width| *width > 0.0) else { return };
        let same = SAME * self.unit;
        let value = |meaning: &str| read.item(meaning).and_then(number);
        let bottom = value(SURFACE).zip(value(THREAD_DEPTH).or_else(|| value(DEPTH)));
        let bottom = bottom.map(|(surface, depth)| surface + depth);
        for place in places {
            if !threads {
                if self.holes.wide.len() < super::MANY {
                    self.holes.wide.push((*place, width, bottom));
                }
                continue;
            }
            let near = |other: [f64; 2]| (0..2).all(|axis| (other[axis] - place[axis]).abs() <= same);
            // What is shallower than the thread only centres it, or is a counterbore.
            let whole = |own: Option<f64>| own.zip(bottom).is_none_or(|(own, thread)| own <= thread + same);
            let here = self.holes.wide.iter().filter(|(other, _, own)| near(*other) && whole(*own));
            let here = here.map(|(_, width, _)| *width);
            let hole = here.fold(0.0, f64::max);
            // The external thread of a hollow stud is wider than its hole, too.
            if hole >= width - same {
                self.found.push((span, Incident::WideCore { thread: width, hole }));
                return;
            }
        }
    }

    /// Whether a hole is only centred: by a tool for that, or not as deep as a tip of 90 degrees is long.
    fn only_centres(&self, read: &Definition<'_>, modal: &Modal, width: Option<f64>) -> bool {
        let kind = match modal.loaded {
            Loaded::By(block) => kind_of_call(self.facts, block as usize),
            Loaded::None | Loaded::Unknown => None,
        };
        let depth = read.item(DEPTH).and_then(number);
        matches!(kind, Some(ToolKind::Spot | ToolKind::Chamfer))
            || depth.zip(width).is_some_and(|(depth, width)| depth.abs() < width / 2.0)
    }

    /// Whether a round pocket is cut by the edge of the blank, or a rectangular one covers all of it, or goes far beyond
    /// it at both ends.
    fn goes_over(&self, read: &Definition<'_>, place: [f64; 2]) -> bool {
        let value = |meaning: &str| read.item(meaning).and_then(number);
        let room = OVER * self.unit;
        if let Some(diameter) = value(CIRCLE) {
            let beyond = |axis: usize| {
                place[axis] - diameter / 2.0 < self.blank.low[axis] - room
                    || place[axis] + diameter / 2.0 > self.blank.high[axis] + room
            };
            return (0..2).any(beyond);
        }
        let sides = LENGTHS.map(value);
        let centred = ["angle-of-rotation", "pocket-position"].iter().all(|meaning| value(meaning) == Some(0.0));
        let ([Some(length), Some(width)], true) = (sides, centred) else { return false };
        let beyond = |axis: usize, side: f64, room: f64| {
            place[axis] - side / 2.0 < self.blank.low[axis] - room
                && place[axis] + side / 2.0 > self.blank.high[axis] + room
        };
        // A groove through the blank needs little more than the radius of its tool at both ends.
        let end = OPEN_END * self.unit;
        let sides = [(0, length), (1, width)];
        sides.iter().all(|(axis, side)| beyond(*axis, *side, room))
            || sides.iter().any(|(axis, side)| beyond(*axis, *side, end))
    }

    /// A cycle comes down at rapid to the set-up clearance above its surface, which must not be inside of the blank where
    /// nothing has been cut.
    fn come_down(&mut self, read: &Definition<'_>, place: [f64; 2]) {
        let value = |meaning: &str| read.item(meaning).and_then(number);
        let (Some(item), Some(surface), Some(clearance)) = (read.item(SURFACE), value(SURFACE), value(CLEARANCE))
        else {
            return;
        };
        let height = surface + clearance;
        let covers = |cut: &Cut| (0..2).all(|axis| cut.low[axis] <= place[axis] && place[axis] <= cut.high[axis]);
        let inside = self.blank.holds(place[0], place[1]) && height < self.blank.high[2] - SKIN * self.unit;
        if inside && surface >= self.blank.low[2] && !self.open && !self.cuts.iter().any(covers) {
            self.found.push((item.span, Incident::RapidInMaterial(height)));
        }
    }

    /// Notes a hole that is drilled.
    fn hole(&mut self, read: &Definition<'_>, span: Span, place: [f64; 2]) {
        let value = |meaning: &str| read.item(meaning).and_then(number);
        self.pilot(read, span, place);
        // Where a value decides that the depth acts, it is not looked at.
        let acts = is_whole(read);
        let bottom = match value(SURFACE).zip(value(DEPTH)) {
            Some((surface, depth)) if acts => Some(surface + depth),
            // What only centres makes no hole for a tap.
            _ if !acts && read.item(DEPTH).is_some() => Some(f64::INFINITY),
            _ => None,
        };
        if self.holes.made.len() < super::MANY {
            self.holes.made.push((place, bottom));
        } else {
            self.holes.lose();
        }
    }

    /// A deepened starting point is in the hole that is there.
    fn pilot(&mut self, read: &Definition<'_>, span: Span, place: [f64; 2]) {
        let value = |meaning: &str| read.item(meaning).and_then(number);
        let (Some(deepened), Some(surface)) = (value(DEEPENED).filter(|own| *own > 0.0), value(SURFACE)) else {
            return;
        };
        if self.holes.others || self.holes.made.is_empty() {
            return;
        }
        let start = surface - deepened;
        let here: Option<Vec<f64>> = self.holes.at(place, SAME * self.unit).collect();
        let Some(bottom) = here.and_then(|here| here.into_iter().reduce(f64::min)) else { return };
        if start < bottom - SAME * self.unit {
            let place = read.item(DEEPENED).map_or(span, |item| item.span);
            self.found.push((place, Incident::StartBelowPilotHole { start, bottom }));
        }
    }

    /// A tap goes into a hole that must be there, and deeper than it goes.
    fn tap(&mut self, read: &Definition<'_>, span: Span, place: [f64; 2]) {
        if self.holes.others || self.holes.made.is_empty() || self.blank.lacks(place[0], place[1]) {
            return;
        }
        let value = |meaning: &str| read.item(meaning).and_then(number);
        let here: Option<Vec<f64>> = self.holes.at(place, SAME * self.unit).collect();
        let bottom = here.map(|here| here.into_iter().fold(f64::INFINITY, f64::min));
        if bottom == Some(f64::INFINITY) {
            if !std::mem::replace(&mut self.holes.reported[0], true) {
                self.found.push((span, Incident::NoHole(place)));
            }
            return;
        }
        let (Some(bottom), Some(surface), Some(depth)) = (bottom, value(SURFACE), value(THREAD_DEPTH)) else { return };
        let through = bottom <= self.blank.low[2];
        if !through
            && surface + depth < bottom - SAME * self.unit
            && !std::mem::replace(&mut self.holes.reported[1], true)
        {
            let place = read.item(THREAD_DEPTH).map_or(span, |item| item.span);
            self.found.push((place, Incident::HoleTooShallow { tap: surface + depth, hole: bottom }));
        }
    }

    /// A hole at a place: what is wrong with its definition is said at its first call.
    fn judge(&mut self, read: &Definition<'_>, index: Option<u32>, span: Span, at: [f64; 2]) {
        if self.blank.lacks(at[0], at[1]) {
            return self.found.push((span, Incident::HoleBesideBlank(at)));
        }
        if !self.judged.insert(index) {
            return;
        }
        let value = |meaning: &str| read.item(meaning).and_then(number);
        let Some(surface) = value(SURFACE) else { return };
        let place = read.item(SURFACE).map_or(read.view.head, |item| item.span);
        let allowance = ALLOWANCE * self.unit;
        if surface > self.blank.high[2] + allowance || surface < self.blank.low[2] {
            return self.found.push((place, Incident::HoleOffSurface(surface)));
        }
        let depth = [DEPTH, THREAD_DEPTH].iter().find_map(|meaning| Some((value(meaning)?, read.item(meaning)?.span)));
        if let Some((depth, place)) = depth.filter(|(depth, _)| surface + depth < self.blank.low[2] - TIP * self.unit) {
            self.found.push((place, Incident::HoleThroughBlank(surface + depth)));
        }
    }
}

/// Whether the depth of a hole acts whatever else its definition says: nothing only centres it.
fn is_whole(read: &Definition<'_>) -> bool {
    read.item(DEPTH).is_some_and(|item| item.param.is_some_and(|param| param.effective.is_none()))
}

/// More than a pocket, stud or slot measures from its place; nothing if that is not certain.
fn size(read: &Definition<'_>) -> Option<f64> {
    let sizes = read.items.iter().filter(|item| {
        item.param.is_some_and(|param| {
            let name = param.is.as_str();
            param.quantity == Quantity::Length
                && param.reference != Some(Reference::Absolute)
                && !NO_SIZES.iter().any(|part| name.contains(part))
        })
    });
    let all: Option<Vec<f64>> = sizes.map(number).collect();
    all.filter(|all| !all.is_empty()).map(|all| all.iter().map(|size| size.abs()).sum())
}
