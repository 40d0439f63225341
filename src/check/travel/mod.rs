//! Where the tool is, block after block, as far as numbers say it, and what happens to the blank on the way: rapid
//! movements into material that nothing has removed, a feed into it with a standing spindle, a tool change or a turn of
//! a rotary axis inside of it, holes next to it.
//!
//! What an execution shows ([`Project::observed`]), which knows the ways through subprograms, patterns and transformations, too,
//! is added where nothing of that kind was found.
//!
//! [`Project::observed`]: super::Project::observed
//!
//! Invariant: only what is certain. Places are known in the order of the text from label to label; a transformation, a
//! rotary axis away from zero, a cycle, a function that moves the machine or a block that may be skipped ends that. What
//! a cycle other than one for holes and pockets removes is not known: nothing is said of material after it.
mod contour;
mod holes;
mod places;

use std::collections::BTreeSet;
use std::f64::consts::TAU;
use std::mem::discriminant;

use self::contour::Course;
use self::holes::Holes;
use super::blank::{AXES, Blank, is_unmoved};
use super::cycle::{probes, removes_material};
use super::incident::Incident;
use super::program::{is_silent, with_meaning};
use super::tools::Tools;
use super::{Aspect, Defined, Facts, Modal, Tri};
use crate::base::diag::Span;
use crate::base::expr::{atan2d, cosd, sind};
use crate::program::syntax::{Axis, Block, BlockKind, Compensates, Coord, Element, Motion, Path, StatementKind};
use crate::spec::{Group, TakesEffect};

/// What a hole or a pocket takes away around its place, in millimetres: so much is never looked at.
const REACH: f64 = 60.0;
/// The radius of a tool that is not known, in millimetres: larger ones are rare.
const RADIUS: f64 = 12.0;
/// What lies so little inside of the blank is at its faces, in millimetres.
const SKIN: f64 = 0.01;
/// So far above the blank a rotary axis does not turn at rapid, in millimetres.
const CLEAR: f64 = 5.0;
/// So far beside the blank a tool below its top has not been retracted, in millimetres.
const BESIDE: f64 = 50.0;
/// The meaning of a value that names a preset.
const PRESET: &str = "preset-number";
/// So many places that are cut are remembered.
const MANY: usize = 1 << 8;

/// A part of the plane that has been cut down to a height.
struct Cut {
    low: [f64; 2],
    high: [f64; 2],
    floor: f64,
}

/// The walk through a program.
struct Walk<'f, 'a> {
    facts: &'f Facts<'a>,
    blank: Blank,
    tools: Option<Tools>,
    /// A millimetre in the unit of the program.
    unit: f64,
    at: [Option<f64>; 3],
    /// The rotary axes that are, or may be, away from zero.
    turned: [bool; 3],
    cuts: Vec<Cut>,
    /// Whether anything may have been cut.
    open: bool,
    /// The definitions of holes that were looked at.
    judged: BTreeSet<Option<u32>>,
    /// The holes that were made.
    holes: Holes,
    /// The places of the last PATTERN DEF.
    pattern: Option<Vec<[f64; 2]>>,
    /// Where the contour goes.
    course: Course,
    /// The corners of the contour that is machined.
    corners: Vec<[f64; 2]>,
    found: Vec<(Span, Incident)>,
}

/// What happens to the blank, with its places: found when a rule first asks for it.
pub(super) fn incidents<'f>(facts: &'f Facts<'_>) -> &'f [(Span, Incident)] {
    facts.incidents.get_or_init(|| {
        let mut all = found(facts);
        all.extend(observed(facts, &all));
        all
    })
}

/// The place of the first incident that a rule wants, and what it takes from it.
pub(super) fn first_incident<T>(facts: &Facts<'_>, wanted: impl Fn(Incident) -> Option<T>) -> Option<(Span, T)> {
    incidents(facts).iter().find_map(|(span, own)| Some((*span, wanted(*own)?)))
}

/// What an execution of the program shows besides.
fn observed(facts: &Facts<'_>, known: &[(Span, Incident)]) -> Vec<(Span, Incident)> {
    let Some(project) = facts.project.filter(|_| facts.begins() && !facts.flow.unread.any()) else { return Vec::new() };
    let blocks = facts.program.blocks();
    let is_new = |own: &Incident| known.iter().all(|(_, other)| discriminant(own) != discriminant(other));
    let all = project.observed(facts.program).into_iter().filter(|own| is_new(&own.incident));
    all.filter_map(|own| {
        let block = blocks.get(blocks.partition_point(|block| block.line < own.line))?;
        (block.line == own.line).then(|| (facts.content(block), own.incident))
    })
    .collect()
}

/// The first block from which on another preset may be active than the one that the blank refers to: the first one that
/// is activated is that one, unless something was probed or machined before.
fn another_preset(facts: &Facts<'_>) -> usize {
    let presets = |own: &&Defined<'_>| own.related_cycle().is_some_and(|cycle| with_meaning(cycle, PRESET).is_some());
    let worked = |own: &Defined<'_>| own.related_cycle().is_some_and(|cycle| probes(cycle) || removes_material(cycle));
    let first_work = facts.definitions.iter().find(|own| worked(own)).map_or(usize::MAX, |own| own.view.first);
    let mut all = facts.definitions.iter().filter(presets).map(|own| own.view.first);
    match all.next() {
        Some(first) if first > first_work => first,
        Some(_) => all.next().unwrap_or(usize::MAX),
        None => usize::MAX,
    }
}

/// What happens to the blank of a program, with its places in the order of the text.
fn found(facts: &Facts<'_>) -> Vec<(Span, Incident)> {
    let Some(blank) = Blank::of(facts.program).filter(|_| facts.begins() && !facts.flow.unread.any()) else {
        return Vec::new();
    };
    let unit = facts.millimetre();
    let mut walk = Walk {
        facts,
        blank,
        tools: Tools::of(facts),
        unit,
        at: [None; 3],
        turned: [false; 3],
        cuts: Vec::new(),
        open: false,
        judged: BTreeSet::new(),
        holes: Holes::default(),
        pattern: None,
        course: Course::default(),
        corners: Vec::new(),
        found: Vec::new(),
    };
    let until = another_preset(facts);
    let mut calls = facts.run.calls.iter().peekable();
    for (from, to, modal) in facts.run.stretches() {
        let usual = modal.filter(|own| is_unmoved(own) && own.is(Aspect::OtherAxis) != Tri::Yes);
        let usual = usual.filter(|own| own.is(Aspect::Turning) == Tri::No);
        for (index, block) in facts.program.blocks().iter().enumerate().take(to.min(until)).skip(from) {
            while calls.next_if(|call| call.block < index).is_some() {}
            match usual {
                Some(modal) if !block.skip => {
                    walk.block(index, block, &modal);
                    walk.end(block, &modal);
                }
                _ => walk.pass(index, block, modal),
            }
            // Cycles for patterns are carried out as definitions.
            let pattern = matches!(block.kind, BlockKind::CycleDef(_));
            while let Some(call) = calls.next_if(|call| call.block == index) {
                if pattern {
                    continue;
                }
                let places = walk.places_of_call(block);
                walk.machine(&call.modal, call.span, places);
            }
        }
    }
    walk.found
}

impl Walk<'_, '_> {
    /// Forgets where the tool is; what moves unseen may also cut.
    fn lose(&mut self) {
        self.at = [None; 3];
    }

    /// Passes over a block under a transformation: what it moves or calls may cut anywhere.
    ///
    /// The definition of the transformation itself leaves the tool where it is.
    fn pass(&mut self, index: usize, block: &Block, modal: Option<Modal>) {
        if is_silent(block) || !block.skip && self.transforms(index, block) {
            return;
        }
        if let (BlockKind::Statement(own), Some(modal)) = (&block.kind, modal)
            && own.kind == StatementKind::Plane
            && !block.skip
        {
            return self.tilt(block, &modal);
        }
        self.lose();
        match &block.kind {
            BlockKind::Motion(motion) => self.open |= !motion.outline().is_rapid() && motion.outline().has_coords(),
            BlockKind::CallLbl(_) | BlockKind::CallPgm(_) => {
                self.open = true;
                self.holes.lose();
            }
            _ => {}
        }
    }

    fn tell(&mut self, block: &Block, incident: Incident) {
        self.found.push((self.facts.content(block), incident));
    }

    /// The program ends with a block.
    fn end(&mut self, block: &Block, modal: &Modal) {
        if self.facts.ends(block)
            && let Some(height) = self.low().filter(|_| modal.is(Aspect::Tool) == Tri::Yes)
        {
            self.tell(block, Incident::EndsInMaterial(height));
        }
    }

    fn block(&mut self, index: usize, block: &Block, modal: &Modal) {
        match &block.kind {
            _ if is_silent(block) => {}
            BlockKind::Motion(motion) => self.motion(index, block, motion, modal),
            BlockKind::BeginPgm(_) | BlockKind::BlkForm(_) | BlockKind::ToolDef(_) | BlockKind::FnAssign(_) => {}
            BlockKind::Formula(_) | BlockKind::TextFormula(_) | BlockKind::OldCycleLine(_) => {}
            BlockKind::Functions(list) if list.iter().all(|own| is_plain(own.number)) => {}
            BlockKind::ToolCall(call) => {
                if call.tool.is_some() {
                    if let Some(height) = self.inside(0.0).filter(|_| modal.is(Aspect::Tool) == Tri::Yes) {
                        self.tell(block, Incident::ToolChangeInMaterial(height));
                    }
                    self.lose();
                }
            }
            BlockKind::CycleDef(_) => {
                let own = self.facts.definition_at(index);
                if let Some(own) = own.filter(|own| own.calls_last()) {
                    let related = own.as_related_cycle();
                    let places = places::of_cycle(&self.facts.read(&related));
                    self.machine(modal, own.view.head, places);
                    self.lose();
                }
                // What acts when it is defined may move the tool.
                if own.is_none_or(|own| own.takes_effect() != Some(TakesEffect::OnCall)) {
                    self.lose();
                }
            }
            BlockKind::CyclCall(_) => {}
            BlockKind::PatternDef(own) => self.pattern = places::of_pattern(self.facts, own),
            BlockKind::Sel(_) => self.pattern = None,
            BlockKind::Statement(own) if own.kind == StatementKind::Plane => self.tilt(block, modal),
            BlockKind::Statement(_) if self.transforms(index, block) => {}
            _ => {
                self.lose();
                if !matches!(block.kind, BlockKind::Statement(_) | BlockKind::Functions(_)) {
                    self.open = true;
                    self.holes.lose();
                }
            }
        }
    }

    /// Tilts the plane, which may turn the axes while the tool is in the blank.
    fn tilt(&mut self, block: &Block, modal: &Modal) {
        let text = self.facts.text(self.facts.content(block)).to_ascii_uppercase();
        let turns = text.contains(" TURN") && modal.is(Aspect::Tcpm) == Tri::No;
        if let Some(height) = self.inside(CLEAR).filter(|_| turns && !text.contains("RESET")) {
            self.tell(block, Incident::AxisTurnsInMaterial(height));
        }
        let swings = text.contains(" MOVE") && modal.is(Aspect::Tcpm) == Tri::No;
        if let Some(height) = self.inside(0.0).filter(|_| swings && !text.contains("RESET")) {
            self.tell(block, Incident::TiltsInMaterial(height));
        }
        self.lose();
    }

    /// Whether a block only says what coordinates mean from there on: the tool stays where it is.
    fn transforms(&self, index: usize, block: &Block) -> bool {
        match &block.kind {
            BlockKind::Statement(own) => own.kind == StatementKind::Trans,
            BlockKind::OldCycleLine(_) => {
                let cycle = self.facts.definition_at(index).and_then(Defined::related_cycle);
                cycle.is_none_or(|cycle| cycle.file.group == Group::Transforms && with_meaning(cycle, PRESET).is_none())
            }
            _ => false,
        }
    }

    /// The height of a tool that is in the plane of the blank and below its top.
    fn inside(&self, above: f64) -> Option<f64> {
        let [Some(x), Some(y), Some(z)] = self.at else { return None };
        let below = z < self.blank.high[2] + above * self.unit - SKIN * self.unit && self.blank.low[2] <= z;
        (below && self.blank.holds(x, y) && self.turned == [false; 3]).then_some(z)
    }

    /// The height of a tool that is in the blank or so close beside it that the workpiece cannot be taken out.
    fn low(&self) -> Option<f64> {
        let [Some(x), Some(y), Some(z)] = self.at else { return None };
        let below = z < self.blank.high[2] - SKIN * self.unit && self.blank.low[2] <= z;
        let near = self.blank.distance([x, y]) <= BESIDE * self.unit;
        (below && near && self.turned == [false; 3]).then_some(z)
    }

    fn motion(&mut self, index: usize, block: &Block, motion: &Element, modal: &Modal) {
        let outline = motion.outline();
        match motion.path() {
            Path::Rnd | Path::Chf => return,
            Path::Cc => {
                let words = motion.words();
                self.course.centre = self.place(&words);
                return;
            }
            Path::Appr(form) => return self.approach(index, block, form, &motion.words(), modal),
            Path::Dep(form) => return self.depart(block, form, &motion.words(), modal),
            Path::L | Path::Lp | Path::C | Path::Cr | Path::Ct if outline.has_coords() => {}
            Path::L if !outline.has_functions() => return,
            // Where a free contour goes is not known, but it stays at its height.
            Path::Fl | Path::Flt | Path::Fc | Path::Fct if !outline.has_functions() => {
                let height = motion.words().coord(Axis::Z).map_or(self.at[2], |coord| self.target(coord, self.at[2]));
                self.at = [None, None, height];
                self.open = true;
                return;
            }
            _ => {
                self.open |= !outline.is_rapid();
                return self.lose();
            }
        }
        let words = motion.words();
        if words.functions.iter().any(|own| !is_plain(own.number)) {
            self.open |= !outline.is_rapid();
            return self.lose();
        }
        self.turn(block, &words, outline.is_rapid(), modal);
        let from = self.at;
        for (place, axis) in AXES.into_iter().enumerate() {
            if let Some(coord) = words.coord(axis) {
                self.at[place] = self.target(coord, from[place]);
            }
        }
        if motion.path() == Path::Lp {
            let place = self.polar(&words);
            (self.at[0], self.at[1]) = (place.map(|own| own[0]), place.map(|own| own[1]));
        }
        let free = outline.compensates() == Compensates::Off
            || (outline.compensates() == Compensates::Unsaid && modal.is(Aspect::Compensation) == Tri::No);
        if self.turned != [false; 3] || modal.is(Aspect::Tool) != Tri::Yes {
            self.open |= !outline.is_rapid();
        } else if outline.is_rapid() {
            if let Some(height) = self.strikes(from, &words).filter(|_| free) {
                self.tell(block, Incident::RapidInMaterial(height));
            }
        } else {
            let spindle = match (modal.is(Aspect::Spindle), modal.is(Aspect::Unstarted)) {
                (Tri::No, _) => Some(Incident::FeedWithoutSpindle),
                (_, Tri::Yes) => Some(Incident::FeedBeforeSpindleStart),
                _ => None,
            };
            if let Some(incident) = spindle.filter(|_| !outline.has_functions() && self.goes_through(from)) {
                self.tell(block, incident);
            }
            self.look_at_corner(from, block, outline.compensates(), modal);
            self.look_at_contour(from, block, &words, modal);
            self.cut(from, &words, modal);
        }
    }

    /// The corner of a contour where a movement ends.
    fn look_at_corner(&mut self, from: [Option<f64>; 3], block: &Block, side: Compensates, modal: &Modal) {
        let on = modal.is(Aspect::Compensation) == Tri::Yes;
        let beside = side == Compensates::Beside || (side == Compensates::Unsaid && on);
        let ([Some(x), Some(y), height], true) = (self.at, beside && is_unmoved(modal)) else {
            return self.corners.clear();
        };
        if height != from[2] || self.corners.len() >= MANY {
            self.corners.clear();
        }
        let same = |own: &[f64; 2]| libm::hypot(own[0] - x, own[1] - y) <= SKIN * self.unit;
        match self.corners.iter().position(same) {
            Some(0) => self.corners.truncate(1),
            // Where it is already it need not go.
            Some(at) if at + 1 == self.corners.len() => {}
            Some(_) => {
                self.tell(block, Incident::CornerPassedTwice([x, y]));
                self.corners.clear();
            }
            None => self.corners.push([x, y]),
        }
    }

    /// What a movement says of rotary axes.
    fn turn(&mut self, block: &Block, words: &Motion, rapid: bool, modal: &Modal) {
        let rotary = [Axis::A, Axis::B, Axis::C];
        let mut turns = false;
        for (axis, turned) in rotary.into_iter().zip(&mut self.turned) {
            let Some(coord) = words.coord(axis) else { continue };
            let angle = self.facts.number(&coord.value).filter(|_| !coord.incremental);
            turns |= angle != Some(0.0);
            *turned = angle != Some(0.0);
        }
        let known = |axis: &Axis| matches!(axis, Axis::Pr | Axis::Pa) || AXES.contains(axis) || rotary.contains(axis);
        let others = words.coords.iter().any(|own| !known(&own.axis));
        if others {
            self.turned = [true; 3];
        }
        let [Some(x), Some(y), Some(z)] = self.at else { return };
        let near = z < self.blank.high[2] + CLEAR * self.unit && self.blank.holds(x, y);
        if turns && rapid && near && modal.is(Aspect::Tcpm) == Tri::No && words.coord(Axis::Z).is_none() {
            self.tell(block, Incident::AxisTurnsInMaterial(z));
        }
    }

    /// The place of the plane that words name, from where the tool is.
    fn place(&self, words: &Motion) -> Option<[f64; 2]> {
        let axis = |place: usize| match words.coord(AXES[place]) {
            Some(coord) => self.target(coord, self.at[place]),
            None => self.at[place],
        };
        Some([axis(0)?, axis(1)?])
    }

    fn target(&self, coord: &Coord, from: Option<f64>) -> Option<f64> {
        let value = self.facts.number(&coord.value)?;
        if coord.incremental { Some(from? + value) } else { Some(value) }
    }

    /// The place of the plane that a polar radius and a polar angle name; what is not written stays.
    fn polar(&self, words: &Motion) -> Option<[f64; 2]> {
        let pole = self.course.centre?;
        let (x, y) = (self.at[0].map(|x| x - pole[0]), self.at[1].map(|y| y - pole[1]));
        let before = |value: &dyn Fn(f64, f64) -> f64| Some(value(x?, y?));
        let part = |axis: Axis, before: Option<f64>| match words.coord(axis) {
            Some(coord) => self.target(coord, before),
            None => before,
        };
        let radius = part(Axis::Pr, before(&|x, y| libm::hypot(x, y)))?;
        let angle = part(Axis::Pa, before(&|x, y| atan2d(y, x)))?;
        Some([pole[0] + radius * cosd(angle), pole[1] + radius * sind(angle)])
    }

    /// How deep a movement from a place to the one where the tool is goes into material that nothing has removed.
    fn strikes(&self, from: [Option<f64>; 3], words: &Motion) -> Option<f64> {
        let [Some(x), Some(y), Some(z)] = self.at else { return None };
        let to = [x, y, z];
        // Of a movement from nowhere the end is known.
        let begin = match from {
            [Some(x), Some(y), Some(z)] => [x, y, z],
            _ => to,
        };
        let lifts = begin[0] == to[0] && begin[1] == to[1] && begin[2] <= to[2] && begin != to;
        if lifts || self.open {
            return None;
        }
        const SAMPLES: i32 = 16;
        let parts = (0..=SAMPLES).map(|step| f64::from(step) / f64::from(SAMPLES));
        let mut places: Vec<[f64; 3]> = match words.path {
            Path::L | Path::Lp => {
                let (first, last) = self.clipped(begin, to, SKIN)?;
                let place = |part: f64| [0, 1, 2].map(|axis| begin[axis] + (to[axis] - begin[axis]) * part);
                parts.map(|part| place(first + (last - first) * part)).collect()
            }
            Path::C => parts.map(|part| self.on_arc(begin, to, words, part)).collect::<Option<_>>()?,
            _ => return None,
        };
        places.retain(|place| self.clipped(*place, *place, SKIN).is_some());
        let own = |cut: &Cut, place: [f64; 3]| {
            cut.floor <= place[2] + SKIN
                && (0..2).all(|axis| cut.low[axis] <= place[axis] && place[axis] <= cut.high[axis])
        };
        let strikes = places.iter().any(|place| !self.cuts.iter().any(|cut| own(cut, *place)));
        strikes.then(|| begin[2].min(to[2]))
    }

    /// A place on the arc about the centre from one place to another.
    fn on_arc(&self, begin: [f64; 3], to: [f64; 3], words: &Motion, part: f64) -> Option<[f64; 3]> {
        let centre = self.course.centre?;
        let angle = |place: [f64; 3]| libm::atan2(place[1] - centre[1], place[0] - centre[0]);
        let radius = libm::hypot(begin[0] - centre[0], begin[1] - centre[1]);
        let (first, last) = (angle(begin), angle(to));
        let sweep = if words.counter_clockwise? { last - first } else { first - last };
        let sweep = if sweep > 0.0 { sweep } else { sweep + TAU };
        let angle = if words.counter_clockwise? { first + sweep * part } else { first - sweep * part };
        let height = begin[2] + (to[2] - begin[2]) * part;
        Some([centre[0] + radius * libm::cos(angle), centre[1] + radius * libm::sin(angle), height])
    }

    /// Whether a movement from a place to the one where the tool is goes through the blank.
    fn goes_through(&self, from: [Option<f64>; 3]) -> bool {
        let ([Some(a), Some(b), Some(c)], [Some(x), Some(y), Some(z)]) = (from, self.at) else { return false };
        from != self.at && self.clipped([a, b, c], [x, y, z], SKIN).is_some()
    }

    /// The part of a movement that is inside of the blank by so many millimetres.
    fn clipped(&self, begin: [f64; 3], to: [f64; 3], skin: f64) -> Option<(f64, f64)> {
        let skin = skin * self.unit;
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        for axis in 0..3 {
            let (low, high) = (self.blank.low[axis] + skin, self.blank.high[axis] - skin);
            let way = to[axis] - begin[axis];
            if way == 0.0 {
                if begin[axis] < low || high < begin[axis] {
                    return None;
                }
                continue;
            }
            let (one, other) = ((low - begin[axis]) / way, (high - begin[axis]) / way);
            first = first.max(one.min(other));
            last = last.min(one.max(other));
        }
        (first <= last).then_some((first, last))
    }

    /// How far the tool reaches next to its centre.
    fn reach(&self, modal: &Modal) -> f64 {
        let tool = self.tools.as_ref().and_then(|tools| tools.get(modal.loaded));
        tool.map_or(RADIUS * self.unit, |tool| tool.radius)
    }

    /// Notes what a movement at feed removes: of an arc the square around it.
    fn cut(&mut self, from: [Option<f64>; 3], words: &Motion, modal: &Modal) {
        let [Some(x), Some(y), Some(z)] = self.at else {
            self.open = true;
            return;
        };
        let beyond = match words.path {
            Path::L | Path::Lp => Some(0.0),
            Path::C => self.course.centre.map(|centre| 2.0 * libm::hypot(x - centre[0], y - centre[1])),
            Path::Cr => words.radius.and_then(|own| self.facts.number(&own)).map(|radius| 2.0 * radius.abs()),
            _ => None,
        };
        let Some(beyond) = beyond else {
            self.open = true;
            return;
        };
        let begin = [from[0].unwrap_or(x), from[1].unwrap_or(y), from[2].unwrap_or(z)];
        self.open |= from.contains(&None) && begin != [x, y, z];
        let reach = self.reach(modal) + beyond;
        self.remember(Cut {
            low: [begin[0].min(x) - reach, begin[1].min(y) - reach],
            high: [begin[0].max(x) + reach, begin[1].max(y) + reach],
            floor: begin[2].min(z),
        });
    }

    fn remember(&mut self, cut: Cut) {
        if self.cuts.len() < MANY {
            self.cuts.push(cut);
        } else {
            self.open = true;
        }
    }
}

/// Whether an M function neither moves the tool nor changes what coordinates mean.
const fn is_plain(number: u16) -> bool {
    matches!(number, 0..=9 | 13 | 14 | 30 | 99)
}
