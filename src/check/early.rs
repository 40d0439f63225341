//! The machining cycles of the first controls, which no manual known here describes: what their definitions say, and
//! the first way through the program, on which they are called: with which tool, which spindle, and from where.
//!
//! On the first way subprograms are passed where they are called, and what is repeated once.
//! Invariant: what may be otherwise on that way is not known.
use std::collections::BTreeMap;

use super::cycle::{removes_material, stops_spindle};
use super::first_way::{Backwards, Early, EarlyCall, FirstWay, Placed, Spindle};
use super::program::{Work, each_function, is_silent, with_meaning};
use super::{Defined, Facts};
use crate::base::diag::Span;
use crate::program::syntax::{
    Amount, Axis, Block, BlockKind, CallForm, Coord, CycleForm, IsoBlock, IsoKind, Motion, OldCycleLine, Path,
    StatementKind, ToolRef, ValueKind,
};
use crate::spec::{Group, TakesEffect};

/// So many blocks are passed.
const MOST: usize = 1 << 14;
/// So many calls are within one another.
const DEEPEST: usize = 8;
/// The meaning of a value that only cycles for milling have.
const MILLED: &str = "milling-type";
/// The meaning of the speed with which a cycle turns the spindle itself.
const OWN_SPEED: &str = "drilling-speed";

/// The cycle that a call means.
#[derive(Clone, Copy, PartialEq)]
enum Waiting {
    Unknown,
    Early(usize),
    Other(usize),
}

impl FirstWay {
    /// The first way through a program that has such cycles, or whose spindle turns counter-clockwise anywhere: followed
    /// when a rule first asks for it.
    pub(super) fn of<'f>(facts: &'f Facts<'_>) -> &'f Self {
        facts.first_way.get_or_init(|| Self::follow(facts))
    }

    fn follow(facts: &Facts<'_>) -> Self {
        let early = definitions(facts);
        let backwards = |(_, block): (usize, &Block)| {
            let mut found = false;
            each_function(block, |number| found |= matches!(number, 4 | 14));
            found
        };
        if early.is_empty() && !facts.marked().any(backwards) {
            return Self::default();
        }
        let passed = vec![false; early.len()];
        let way = Self { early, passed, complete: true, only: true, ..Self::default() };
        let by_block = way.early.iter().enumerate().map(|(at, own)| (own.first, at)).collect();
        let mut walk = Walk {
            facts,
            way,
            by_block,
            tool: None,
            spindle: Spindle::Unknown,
            waiting: Waiting::Unknown,
            place: [None; 3],
            still: true,
            flat: true,
            turning: false,
        };
        walk.follow();
        walk.way
    }
}

/// The definitions of early cycles, in the order of the text.
fn definitions(facts: &Facts<'_>) -> Vec<Early> {
    let of_lines = facts.definitions.iter().filter_map(|own| of_definition(facts, own));
    let blocks = facts.marked().filter_map(|(index, block)| match &block.kind {
        BlockKind::Iso(own) => of_iso(own, index, block),
        _ => None,
    });
    let mut all: Vec<Early> = of_lines.chain(blocks).collect();
    all.sort_by_key(|own| own.first);
    all
}

fn of_definition(facts: &Facts<'_>, own: &Defined<'_>) -> Option<Early> {
    let work = Work::of(facts.program, own)?;
    let mut early = Early::new(work, own.view.first, own.view.head, own.key.to_string());
    if let CycleForm::Lines(lines) = &own.view.form {
        lines.iter().for_each(|line| early.read(facts, line));
    }
    Some(early)
}

/// The words of the first controls stand in a fixed order.
fn of_iso(own: &IsoBlock, index: usize, block: &Block) -> Option<Early> {
    let (work, IsoKind::Cycle(code)) = (Work::of_iso(own)?, own.kind) else { return None };
    let span = block.comment().unwrap_or(block.span);
    let mut early = Early::new(work, index, span, format!("G{code}"));
    let is_code = |kind: ValueKind| kind == ValueKind::Number(f64::from(code));
    let after = own.words.iter().map(|word| word.value.kind).skip_while(|kind| !is_code(*kind)).skip(1);
    let written = after.filter(|kind| *kind != ValueKind::Missing).map(|kind| match kind {
        ValueKind::Number(number) => Some((number, span)),
        _ => None,
    });
    let words: Vec<Option<Placed>> = written.collect();
    let at = |place: usize| words.get(place - 1).copied().flatten();
    (early.clearance, early.depth) = (at(1), at(2));
    match work {
        Work::Drilling => (early.infeed, early.feeds) = (at(3), at(5).into_iter().collect()),
        Work::Tapping => early.feeds = at(4).into_iter().collect(),
        Work::RigidTapping => early.pitch = at(3),
        Work::Milling => {
            early.infeed = at(3);
            let round = words.len() == ROUND;
            let (sides, last) = if round { (vec![at(5).map(doubled)], 6) } else { (vec![at(5), at(6)], 7) };
            early.sides = sides.into_iter().flatten().collect();
            early.corner = if round { None } else { at(8) };
            early.feeds = [at(4), at(last)].into_iter().flatten().collect();
        }
    }
    Some(early)
}

/// So many words a round pocket has; others have a side more.
const ROUND: usize = 6;

const fn doubled((radius, span): Placed) -> Placed {
    (2.0 * radius, span)
}

impl Early {
    const fn new(work: Work, first: usize, head: Span, name: String) -> Self {
        Self {
            work,
            first,
            head,
            name,
            clearance: None,
            depth: None,
            infeed: None,
            pitch: None,
            feeds: Vec::new(),
            sides: Vec::new(),
            corner: None,
        }
    }

    /// Reads a line: which one it is says what its first word means.
    fn read(&mut self, facts: &Facts<'_>, line: &OldCycleLine) {
        let number = |kind: ValueKind| match kind {
            ValueKind::Number(number) => Some(number),
            _ => None,
        };
        let name = |span: Span| facts.text(span).trim().to_ascii_uppercase();
        for (at, word) in line.words.iter().enumerate().filter(|_| line.line > 0) {
            let Some(placed) = number(word.value.kind).map(|number| (number, word.value.span)) else { continue };
            let name = name(word.name);
            match (line.line, at, self.work) {
                (1, 0, _) => self.clearance = Some(placed),
                (2, 0, _) => self.depth = Some(placed),
                (3, 0, Work::Drilling | Work::Milling) => self.infeed = Some(placed),
                (3, 0, Work::RigidTapping) => self.pitch = Some(placed),
                (3.., _, _) if name == "F" => self.feeds.push(placed),
                (6, 1.., Work::Milling) if name != "DR" => self.corner = Some(placed),
                (4 | 5, 0, Work::Milling) if matches!(name.as_str(), "X" | "Y" | "Z") => self.sides.push(placed),
                (4, 0, Work::Milling) => self.sides.push(doubled(placed)),
                _ => {}
            }
        }
    }
}

/// The walk.
struct Walk<'f, 'a> {
    facts: &'f Facts<'a>,
    way: FirstWay,
    /// The definitions of early cycles by their first blocks.
    by_block: BTreeMap<usize, usize>,
    tool: Option<usize>,
    spindle: Spindle,
    waiting: Waiting,
    place: [Option<f64>; 3],
    /// Whether heights are certainly those of the blank.
    still: bool,
    /// The same of those in the plane alone.
    flat: bool,
    turning: bool,
}

impl Walk<'_, '_> {
    fn follow(&mut self) {
        let facts = self.facts;
        let blocks = facts.program.blocks();
        let (mut at, mut back, mut steps) = (0, Vec::new(), 0);
        while let Some(block) = blocks.get(at) {
            steps += 1;
            if steps > MOST {
                self.way.complete = false;
                return;
            }
            if facts.ends(block) {
                return;
            }
            let mut next = at + 1;
            match &block.kind {
                _ if is_silent(block) => {}
                _ if block.skip => self.forget(),
                BlockKind::CallLbl(call) if call.repeat.is_none() => match facts.run.graph.called_from(at) {
                    Some(label) if back.len() < DEEPEST => {
                        back.push(next);
                        next = label + 1;
                    }
                    _ => self.forget(),
                },
                BlockKind::CallLbl(_) => self.way.only = false,
                BlockKind::FnJump(jump) => {
                    self.way.only = false;
                    if jump.decided() == Some(true) {
                        self.way.complete = false;
                        return;
                    }
                }
                _ if block.ends_subprogram() => next = back.pop().unwrap_or(next),
                _ => self.step(at, block),
            }
            at = next;
        }
        self.way.complete = false;
    }

    /// Nothing is known any more.
    fn forget(&mut self) {
        (self.tool, self.spindle, self.waiting) = (None, Spindle::Unknown, Waiting::Unknown);
        (self.place, self.still, self.way.complete) = ([None; 3], false, false);
    }

    fn step(&mut self, at: usize, block: &Block) {
        match &block.kind {
            BlockKind::ToolCall(call) if call.tool.is_some() => {
                let same = self.tool.is_some_and(|before| self.tool_of(before) == self.tool_of(at));
                (self.tool, self.place) = (Some(at), [None; 3]);
                self.spindle = if same { Spindle::Unknown } else { Spindle::Unstarted };
                self.still &= call.axis.is_none_or(|axis| axis == Axis::Z);
            }
            BlockKind::Motion(motion) => {
                self.turn(block);
                self.go(&motion.words(), block);
            }
            BlockKind::Functions(_) | BlockKind::Stop(_) => {
                self.turn(block);
                self.call_by_function(block, self.place);
            }
            BlockKind::CyclCall(call) => {
                self.turn(block);
                let here = matches!(call.form, CallForm::Plain);
                self.call(call.head, if here { self.place } else { [None; 3] });
                self.place = if here { self.place } else { [None; 3] };
            }
            BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) => self.define(at),
            BlockKind::Iso(own) => match self.by_block.get(&at) {
                Some(early) => self.wait(*early),
                None if block.is_blend() || own.kind == IsoKind::Modal => {}
                None => self.forget(),
            },
            BlockKind::Statement(own) => match own.kind {
                StatementKind::Plane | StatementKind::Trans => self.still = false,
                StatementKind::Function => {
                    let words = self.facts.text(self.facts.content(block)).to_ascii_uppercase();
                    self.turning |= words.contains("TURN") || words.contains("GRIND");
                    self.still = false;
                }
                StatementKind::CallSelected | StatementKind::Indirect | StatementKind::Refused => self.forget(),
                _ => {}
            },
            BlockKind::CallPgm(_) | BlockKind::Unknown(_) => self.forget(),
            _ => {}
        }
    }

    fn wait(&mut self, early: usize) {
        self.waiting = Waiting::Early(early);
        if let Some(passed) = self.way.passed.get_mut(early) {
            *passed = true;
        }
    }

    /// A definition begins.
    fn define(&mut self, at: usize) {
        if let Some(early) = self.by_block.get(&at) {
            return self.wait(*early);
        }
        let facts = self.facts;
        let index = facts.definitions.partition_point(|own| own.view.first < at);
        let Some(own) = facts.definitions.get(index).filter(|own| own.view.first == at) else { return };
        if own.calls_last() {
            return self.call(own.view.head, [None; 3]);
        }
        let group = own.related_cycle().map(|cycle| cycle.file.group);
        match own.takes_effect() {
            Some(TakesEffect::OnDefinition) if group == Some(Group::Transforms) => self.transform(own),
            Some(TakesEffect::OnDefinition) if group == Some(Group::Contours) => {}
            Some(TakesEffect::OnDefinition) => self.place = [None; 3],
            Some(TakesEffect::OnCall) => self.waiting = Waiting::Other(index),
            None => self.waiting = Waiting::Unknown,
        }
    }

    /// A transformation: what names no more than axes of the plane and an angle leaves heights as they are.
    fn transform(&mut self, own: &Defined<'_>) {
        self.flat = false;
        // A preset is where the coordinates of the blank are.
        let CycleForm::Lines(lines) = &own.view.form else { return };
        for word in lines.iter().flat_map(|line| &line.words) {
            let name = self.facts.text(word.name).trim().to_ascii_uppercase();
            let none = word.value.kind == ValueKind::Number(0.0);
            let plane = matches!(name.as_str(), "X" | "Y" | "IX" | "IY" | "ROT" | "IROT");
            self.still &= plane || none;
        }
    }

    fn tool_of(&self, block: usize) -> Option<String> {
        let block = self.facts.program.blocks().get(block)?;
        let BlockKind::ToolCall(call) = &block.kind else { return None };
        match call.tool? {
            ToolRef::Number(own) => Some(self.facts.text(own.span).trim().to_owned()),
            ToolRef::Name(own) => Some(self.facts.text(own).trim().to_owned()),
        }
    }

    /// What the M functions of a block do to the spindle.
    fn turn(&mut self, block: &Block) {
        each_function(block, |number| match number {
            3 | 13 => (self.spindle, self.way.clockwise) = (Spindle::Started, true),
            4 | 14 => self.spindle = Spindle::Backwards,
            0 | 5 | 6 => self.spindle = Spindle::Stopped,
            1 | 7..=9 | 89..=199 => {}
            // What it does is the machine builder's affair.
            _ => self.spindle = Spindle::Unknown,
        });
    }

    /// A movement, and the call that may follow it.
    fn go(&mut self, words: &Motion, block: &Block) {
        if words.functions.iter().any(|own| matches!(own.number, 91 | 92 | 140)) {
            self.place = [None; 3];
        } else {
            for (axis, place) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(&mut self.place) {
                let Some(coord) = words.coord(axis).filter(|_| words.path != Path::Cc) else { continue };
                *place = match coord.value.amount {
                    Amount::Number(number) if coord.incremental => place.map(|from| from + number),
                    Amount::Number(number) => Some(number),
                    Amount::Q { .. } | Amount::Text(_) => None,
                };
            }
            let odd = words.coords.iter().any(|own| !matches!(own.axis, Axis::X | Axis::Y | Axis::Z));
            if odd
                || !matches!(words.path, Path::L | Path::Axis | Path::C | Path::Cr | Path::Cc | Path::Rnd | Path::Chf)
            {
                (self.place[0], self.place[1]) = (None, None);
            }
            let turned = |own: &Coord| matches!(own.axis, Axis::A | Axis::B | Axis::C);
            let none = |own: &Coord| own.value.amount == Amount::Number(0.0) && !own.incremental;
            self.still &= words.coords.iter().all(|own| !turned(own) || none(own));
        }
        let moves = !words.coords.is_empty() && words.path != Path::Cc;
        let rapid = matches!(&block.kind, BlockKind::Motion(own) if own.outline().is_rapid());
        if moves && !rapid {
            self.machines(self.facts.content(block), false);
        }
        self.call_by_function(block, self.place);
    }

    /// Calls the cycle if M89 or M99 is in a block.
    fn call_by_function(&mut self, block: &Block, place: [Option<f64>; 3]) {
        let mut calls = false;
        each_function(block, |number| match number {
            99 => calls = true,
            89 => self.way.complete = false,
            _ => {}
        });
        if calls {
            self.call(self.facts.content(block), place);
        }
    }

    /// The cycle that was defined last is called.
    fn call(&mut self, span: Span, place: [Option<f64>; 3]) {
        match self.waiting {
            Waiting::Early(early) => {
                let Some(work) = self.way.early.get(early).map(|own| own.work) else { return };
                let known = [self.still && self.flat, self.still && self.flat, self.still];
                let place = [0, 1, 2].map(|axis| place[axis].filter(|_| known[axis]));
                self.way.calls.push(EarlyCall { span, early, tool: self.tool, spindle: self.spindle, place });
                match work {
                    Work::RigidTapping => self.spindle = Spindle::Unknown,
                    own => self.machines(span, own == Work::Tapping),
                }
            }
            Waiting::Other(index) => {
                let cycle = self.facts.definitions.get(index).and_then(Defined::related_cycle);
                let Some(cycle) = cycle.filter(|cycle| removes_material(cycle)) else { return };
                self.way.others = true;
                let threads = cycle.file.group == Group::Threads;
                let taps = threads && with_meaning(cycle, MILLED).is_none();
                let own = with_meaning(cycle, OWN_SPEED).is_some() || stops_spindle(cycle) || cycle.file.clockwise_only;
                if !own && (taps || !threads) {
                    self.machines(span, taps);
                }
                self.place = [None; 3];
            }
            Waiting::Unknown => (self.way.others, self.place) = (true, [None; 3]),
        }
    }

    /// The tool machines.
    fn machines(&mut self, span: Span, taps: bool) {
        let Some(tool) = self.tool.filter(|_| self.spindle == Spindle::Backwards && !self.turning) else { return };
        if !self.way.backwards.iter().any(|own| own.tool == tool && own.taps == taps) {
            self.way.backwards.push(Backwards { tool, span, taps });
        }
    }
}
