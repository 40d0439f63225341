//! What can be known of a program's run without running it: an abstract interpretation over its labels, calls,
//! repeats and jumps.
//!
//! Every way that the run can take is followed with what is certain on it; where ways meet, what differs is
//! unknown. Invariant: certain means certain on every way. A program that takes too long to follow is one of
//! which nothing is known.
mod circles;
mod effect;
mod graph;
mod state;
mod step;
mod trace;
mod walk;

use std::collections::{BTreeMap, BTreeSet};

pub use circles::circles;
pub(super) use graph::stops;
pub use graph::{Graph, Mark, Use, Way};
pub use state::{Aspect, Loaded, Modal, Pending, Tri};

use super::Facts;
use super::facts::each_function;
use crate::base::diag::Span;
use crate::base::expr::QRef;
use crate::program::syntax::{Block, BlockKind, MFunction, Motion};
pub(super) use effect::{Deed, probes, removes_material, stops_spindle};
pub(super) use graph::reads;
use state::{State, Touched};
use step::Steps;
use walk::Walk;

/// A call of a cycle.
#[derive(Clone, Copy, Debug)]
pub struct CycleCall {
    /// Its place.
    pub span: Span,
    /// The block.
    pub block: usize,
    /// The state in which it happens.
    pub modal: Modal,
}

/// What is known of the run.
#[derive(Debug, Default)]
pub struct Run {
    /// Labels and what leads to them.
    pub graph: Graph,
    /// The blocks from which on another state holds before each block; nothing where the run never comes.
    changes: Vec<(usize, Option<Modal>)>,
    /// The calls of cycles that the run can come to.
    pub calls: Vec<CycleCall>,
    /// Parameters that are read and have no value on any way, with their places.
    pub unset: Vec<(QRef, Span)>,
    /// Formulas that have no result on any way, with their places and why.
    pub failing: Vec<(Span, &'static str)>,
    /// The places of parameters that are certainly zero or negative, or are read negated.
    pub(super) odd: Vec<Span>,
    /// Numbers of the parameters that definitions read, by the place of the value.
    numbers: BTreeMap<usize, f64>,
    /// Those that a parameter has one after the other where a block is passed several times, by the place of the value.
    passes: BTreeMap<usize, Vec<f64>>,
    /// Where the program ends, with the state there.
    pub ends: Vec<(usize, Modal)>,
    /// The blocks behind a label, a call or a jump that the main part comes to, without being called.
    pub main: BTreeSet<usize>,
    /// What is called: the block of its label, where it returns, and the calls in it.
    parts: BTreeMap<usize, Outline>,
}

/// A part that is called.
#[derive(Debug, Default)]
struct Outline {
    returns: bool,
    /// Whether it comes to M2 or M30.
    stops: bool,
    /// The uses of labels in it that are calls.
    calls: Vec<usize>,
}

impl Run {
    /// Follows a program.
    pub(super) fn of(facts: &Facts<'_>) -> Self {
        let steps = Steps::new(facts);
        let graph = Graph::of(facts);
        let mut walk = Walk::new(&steps, graph);
        let (main, blank) = kind(facts);
        walk.start(&State::begin(main, blank));
        let finished = walk.follow();
        walk.result(finished)
    }

    /// The state before a block; nothing if the run never comes there.
    pub fn before(&self, block: usize) -> Option<Modal> {
        let at = self.changes.partition_point(|(from, _)| *from <= block);
        self.changes.get(at.checked_sub(1)?)?.1
    }

    /// Stretches of blocks with the same state before each: first block, the block behind the last one, state.
    pub fn stretches(&self) -> impl Iterator<Item = (usize, usize, Option<Modal>)> {
        let ends = self.changes.iter().skip(1).map(|(from, _)| *from).chain([self.graph.blocks]);
        self.changes.iter().zip(ends).map(|((from, modal), end)| (*from, end, *modal))
    }

    /// The calls, by index of use, by which a subprogram calls itself, be it through others.
    pub fn recursive_calls(&self) -> impl Iterator<Item = usize> {
        let target = |call: usize| self.graph.block_of(self.graph.uses.get(call)?.mark.as_ref()?);
        let blocks: Vec<usize> = self.parts.keys().copied().collect();
        let place = |block: usize| blocks.binary_search(&block).ok();
        let callees = |own: &Outline| own.calls.iter().filter_map(|call| place(target(*call)?)).collect();
        let inner: Vec<Vec<usize>> = self.parts.values().map(callees).collect();
        // Parts that come back to themselves are those that reach each other.
        let circle = circles(&inner);
        let mut found = BTreeSet::new();
        for (at, own) in self.parts.values().enumerate() {
            let back = |call: &&usize| target(**call).and_then(place).is_some_and(|to| circle[to] == circle[at]);
            found.extend(own.calls.iter().filter(back));
        }
        found.into_iter()
    }

    /// Called labels from which the run comes to the end of the program and never to LBL 0, with their blocks.
    pub fn endless_parts(&self) -> Vec<(Mark, usize)> {
        let endless = |block: &usize| self.parts.get(block).is_some_and(|own| !own.returns && !own.stops);
        let marks = self.graph.labels.iter().filter_map(|(mark, blocks)| match blocks.as_slice() {
            [only] => Some((mark.clone(), *only)),
            _ => None,
        });
        marks.filter(|(_, block)| endless(block)).collect()
    }

    /// The number of a parameter that a definition reads there.
    pub fn number_at(&self, place: Span) -> Option<f64> {
        self.numbers.get(&place.start).copied()
    }

    /// The numbers of a parameter that a definition reads there with another one each time, pass by pass.
    pub fn numbers_at(&self, place: Span) -> &[f64] {
        self.passes.get(&place.start).map(Vec::as_slice).unwrap_or_default()
    }

    /// Whether anything is read with different numbers.
    pub fn changes_numbers(&self) -> bool {
        !self.passes.is_empty()
    }
}

/// What a program does to the state of one that calls it.
#[derive(Debug)]
pub(super) struct Through {
    touched: Touched,
    /// The state at its end, begun with nothing known.
    exit: State,
    /// Whether it may call the cycle that the calling program has defined.
    pub(super) calls_cycle: bool,
}

impl Through {
    /// It may do anything.
    pub(super) fn anything() -> Self {
        Self { touched: Touched::everything(), exit: State::unknown(), calls_cycle: true }
    }

    fn apply(&self, state: &mut State) {
        *state = State::behind(state, &self.exit, &self.touched);
    }
}

/// What a program does when another one calls it.
pub(super) fn through(facts: &Facts<'_>) -> Through {
    let steps = Steps::new(facts);
    let mut walk = Walk::new(&steps, Graph::of(facts));
    walk.start(&State::unknown());
    if !walk.follow() {
        return Through::anything();
    }
    let Some(mut exit) = walk.exit() else { return Through::anything() };
    let mut touched = Touched::default();
    for (index, block) in facts.program.blocks().iter().enumerate() {
        let before = Touched::probes();
        let mut after = before.clone();
        after.iter_mut().for_each(|state| steps.step(index, block, state));
        touched.note(&before, &after);
    }
    // Definitions count for their own program only; local parameters, too.
    touched.only_global();
    exit.modal.pending = Pending::Unknown;
    if exit.modal.loaded != Loaded::None {
        exit.modal.loaded = Loaded::Unknown;
    }
    let run = walk.result(true);
    let calls_cycle = run.calls.iter().any(|call| !matches!(call.modal.pending, Pending::Definition(_)));
    Through { touched, exit, calls_cycle }
}

/// The places where a block calls a cycle.
fn calls_in(block: &Block, words: &mut Motion, found: &mut Vec<Span>) {
    let calls = |own: &MFunction| matches!(own.number, 89 | 99);
    let mut any = false;
    each_function(block, |number| any |= matches!(number, 89 | 99));
    if let BlockKind::CyclCall(call) = &block.kind {
        found.push(call.head);
    }
    match &block.kind {
        _ if !any => {}
        BlockKind::Motion(motion) => {
            if let Some((_, span)) = motion.last_function() {
                found.push(span);
                return;
            }
            motion.read_into(words);
            found.extend(words.functions.iter().filter(|own| calls(own)).map(|own| own.span));
        }
        BlockKind::Functions(list) | BlockKind::Stop(list) => {
            found.extend(list.iter().filter(|own| calls(own)).map(|own| own.span));
        }
        BlockKind::CyclCall(call) => {
            found.extend(call.functions.iter().filter(|own| calls(own)).map(|own| own.span));
        }
        _ => {}
    }
}

/// Whether a program is one that is started, not one that others call: it names its blank or its tools or ends with
/// M2 or M30; and whether that is certain: it names its blank, or its tools and such an end.
fn kind(facts: &Facts<'_>) -> (bool, bool) {
    let (mut tool, mut end, mut blank) = (false, false, false);
    for (_, block) in facts.marked() {
        match &block.kind {
            BlockKind::BlkForm(_) => blank = true,
            BlockKind::Statement(statement) => {
                blank |= statement.kind == crate::program::syntax::StatementKind::BlkForm
            }
            BlockKind::ToolCall(_) => tool = true,
            BlockKind::BeginPgm(_) | BlockKind::EndPgm(_) => {}
            _ => end |= stops(block),
        }
    }
    (facts.begins() && (tool || end || blank), facts.begins() && (blank || (tool && end)))
}
