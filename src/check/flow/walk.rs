//! The walk along every way that the run can take, with what is certain on it.
//!
//! Invariant: what is entered into a run of blocks only ever becomes less certain, so the walk ends.
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet, HashSet, VecDeque};

use super::circles::circles;
use super::graph::{End, Graph, Use, Way};
use super::run::{CycleCall, Outline, Run};
use super::state::{Known, Modal, State, Touched};
use super::step::Steps;
use super::trace;
use crate::base::diag::Span;
use crate::base::expr::QRef;
use crate::check::cycle::{Aspect, Tri};
use crate::check::program::{calls_in, needs_feed, reads, stops};
use crate::program::syntax::{BlockKind, Motion, Path};

/// How often a block may be looked at on average.
const PATIENCE: usize = 48;
/// How many parameters all states together may know: some 100 MB.
const MOST_KNOWN: usize = 2_000_000;

/// Who has called the part that is executed: no one in the main part, someone outside of it where a cycle reads a
/// contour, or the use of that index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Caller {
    Nobody,
    Outside,
    Use(usize),
}

/// A run of blocks with who has called it.
type Node = (usize, Caller);

/// The walk, with what it has found out so far.
pub(super) struct Walk<'w, 'f, 'p> {
    steps: &'w Steps<'f, 'p>,
    graph: Graph,
    entries: BTreeMap<Node, State>,
    /// What each called label may change, and where it returns.
    parts: BTreeMap<usize, Part>,
    /// What is certain where called parts return, by the runs of blocks where they begin.
    exits: BTreeMap<Node, State>,
    /// The parts that return at each LBL 0, where all calls of a part are followed as one.
    ends: BTreeMap<usize, Vec<usize>>,
    /// Who waits for the end of a call.
    callers: BTreeMap<Caller, BTreeSet<Node>>,
    /// Whether all calls of a part are followed as one, because there are too many of them.
    shared: bool,
    /// Whether it took too long already to find out what is called.
    gave_up: bool,
    waiting: VecDeque<Node>,
    queued: BTreeSet<Node>,
    /// How much may still be looked at.
    budget: usize,
    /// How many parameters the states that are kept know.
    known: usize,
}

/// A part that is called, by the run of blocks where it begins.
#[derive(Debug, Default)]
struct Part {
    outline: Outline,
    touched: Touched,
    returns: BTreeSet<usize>,
    /// How many blocks it has.
    blocks: usize,
}

impl<'w, 'f, 'p> Walk<'w, 'f, 'p> {
    pub(super) fn new(steps: &'w Steps<'f, 'p>, graph: Graph) -> Self {
        Self {
            steps,
            graph,
            entries: BTreeMap::new(),
            parts: BTreeMap::new(),
            exits: BTreeMap::new(),
            ends: BTreeMap::new(),
            callers: BTreeMap::new(),
            shared: false,
            gave_up: false,
            waiting: VecDeque::new(),
            queued: BTreeSet::new(),
            budget: 0,
            known: 0,
        }
    }

    pub(super) fn start(&mut self, state: &State) {
        if self.graph.blocks == 0 {
            return;
        }
        self.gave_up = !self.parts();
        if self.gave_up {
            return;
        }
        self.enter((0, Caller::Nobody), state);
        // Contours that cycles read, and labels that a parameter chooses, are come to from anywhere.
        let named = |own: &&Use| own.way == Way::Named;
        let outside: Vec<usize> =
            self.graph.uses.iter().filter(named).filter_map(|own| self.graph.block_of(own.mark.as_ref()?)).collect();
        let chosen = |way: Way| self.graph.uses.iter().any(|own| own.mark.is_none() && own.way == way);
        let (called, jumped) = (chosen(Way::Call), chosen(Way::Jump) || chosen(Way::Repeat));
        let mut nodes: Vec<Node> = outside.iter().map(|block| (*block, Caller::Outside)).collect();
        for block in self.graph.labels.values().flatten() {
            nodes.extend((called || jumped).then_some((*block, Caller::Outside)));
            nodes.extend(jumped.then_some((*block, Caller::Nobody)));
        }
        for (block, caller) in nodes {
            self.enter((self.graph.run_of(block), caller), &State::unknown());
        }
    }

    /// Joins a state into what is known at a node.
    fn enter(&mut self, node: Node, state: &State) {
        if node.0 >= self.graph.leaders.len() {
            return;
        }
        if let Some(joined) = joined(self.entries.get(&node), state, &mut self.known) {
            self.entries.insert(node, joined);
            self.queue(node);
        }
    }

    fn queue(&mut self, node: Node) {
        if self.queued.insert(node) {
            self.waiting.push_back(node);
        }
    }

    /// Follows until nothing changes; false if that takes too long.
    pub(super) fn follow(&mut self) -> bool {
        if self.gave_up {
            return false;
        }
        self.budget = self.graph.blocks.saturating_mul(PATIENCE).saturating_add(100_000);
        while let Some(node) = self.waiting.pop_front() {
            self.queued.remove(&node);
            let cost = self.graph.run_end(node.0) - self.graph.leaders.get(node.0).copied().unwrap_or(0);
            self.spend(cost + 1);
            if self.budget == 0 {
                return false;
            }
            self.advance(node);
        }
        true
    }

    /// Looks at so many blocks, ends of parts or calls that wait for them.
    fn spend(&mut self, cost: usize) {
        self.budget = self.budget.saturating_sub(cost);
    }

    fn advance(&mut self, (run, caller): Node) {
        let blocks = self.steps.program.blocks();
        let (first, end) = (self.graph.leaders.get(run).copied().unwrap_or(0), self.graph.run_end(run));
        // What leads nowhere needs no state: only the last block of a run leads out of it.
        let last = end.checked_sub(1).and_then(|last| Some((last, blocks.get(last)?)));
        match last.map(|(last, block)| (self.graph.end(last, block), block.skip)) {
            None | Some((End::Stop, false)) => return,
            Some((End::Next, _)) if end == self.graph.blocks => return,
            _ => {}
        }
        let Some(mut state) = self.entries.get(&(run, caller)).cloned() else { return };
        for index in first..end {
            let Some(block) = blocks.get(index) else { break };
            self.steps.step(index, block, &mut state);
            let last = index + 1 == end;
            match self.graph.end(index, block) {
                End::Stop if !block.skip => return,
                End::Return if caller != Caller::Nobody => {
                    self.come_back(index, caller, &state);
                    if !block.skip {
                        return;
                    }
                }
                End::Use(at) => self.lead_on((run, caller), at, &state, block.skip),
                _ => {}
            }
            if last && !matches!(self.graph.end(index, block), End::Use(_)) {
                self.enter((run + 1, caller), &state);
            }
        }
    }

    /// Comes to the end of a called part: those who wait for it go on if that is news.
    fn come_back(&mut self, block: usize, caller: Caller, state: &State) {
        let parts = match caller {
            Caller::Use(at) => self.target(at).into_iter().collect(),
            Caller::Outside => self.ends.get(&block).cloned().unwrap_or_default(),
            Caller::Nobody => Vec::new(),
        };
        self.spend(parts.len());
        let mut news = false;
        for part in parts {
            if let Some(joined) = joined(self.exits.get(&(part, caller)), state, &mut self.known) {
                self.exits.insert((part, caller), joined);
                news = true;
            }
        }
        if news {
            let callers: Vec<Node> = self.callers.get(&caller).into_iter().flatten().copied().collect();
            self.spend(callers.len());
            callers.into_iter().for_each(|caller| self.queue(caller));
        }
    }

    /// The run of blocks to which a use of a label leads.
    fn target(&self, at: usize) -> Option<usize> {
        let mark = self.graph.uses.get(at)?.mark.as_ref()?;
        Some(self.graph.run_of(self.graph.block_of(mark)?))
    }

    /// Goes where a call, a repeat or a jump leads.
    fn lead_on(&mut self, (run, caller): Node, at: usize, state: &State, skip: bool) {
        let Some(own) = self.graph.uses.get(at).cloned() else { return };
        let Some(target) = self.target(at) else {
            // It leads to an unknown place, or nowhere.
            self.enter((run + 1, caller), &State::unknown());
            return;
        };
        if own.way != Way::Call {
            // A jump whose condition compares numbers leads one way only.
            match self.steps.decided(own.block) {
                Some(true) => return self.enter((target, caller), state),
                Some(false) => return self.enter((run + 1, caller), state),
                None => {}
            }
            let (taken, passed) = self.steps.branches(own.block, state);
            self.enter((target, caller), taken.as_ref().unwrap_or(state));
            self.enter((run + 1, caller), passed.as_ref().unwrap_or(state));
            return;
        }
        let inside = if self.shared { Caller::Outside } else { Caller::Use(at) };
        self.callers.entry(inside).or_default().insert((run, caller));
        self.enter((target, inside), state);
        let Some(part) = self.parts.get(&target) else { return };
        if let Some(exit) = self.exits.get(&(target, inside)) {
            let left = State::after(state, exit, &part.touched);
            self.enter((run + 1, caller), &left);
        }
        if skip {
            self.enter((run + 1, caller), state);
        }
    }

    /// Finds out what called parts may change and where they return; false if that takes too long.
    fn parts(&mut self) -> bool {
        let called: BTreeSet<usize> = self
            .graph
            .uses
            .iter()
            .filter(|own| own.way == Way::Call)
            .filter_map(|own| self.graph.block_of(own.mark.as_ref()?))
            .map(|block| self.graph.run_of(block))
            .collect();
        let mut calls: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
        let mut patience = self.graph.blocks.saturating_mul(PATIENCE).saturating_add(100_000);
        for start in called {
            let mut part = Part::default();
            let mut inner = BTreeSet::new();
            let (mut seen, mut open) = (BTreeSet::from([start]), vec![start]);
            while let Some(run) = open.pop() {
                part.blocks += self.graph.run_end(run) - self.graph.leaders[run];
                let Some(rest) = patience.checked_sub(self.graph.run_end(run) - self.graph.leaders[run] + 1) else {
                    return false;
                };
                patience = rest;
                let mut follow = |run: usize| {
                    if run < self.graph.leaders.len() && seen.insert(run) {
                        open.push(run);
                    }
                };
                self.within(run, &mut part, &mut inner, &mut follow);
            }
            calls.insert(start, inner);
            self.parts.insert(start, part);
        }
        let calls_of = |own: &&Use| own.way == Way::Call;
        let size = |own: &Use| {
            let run = self.graph.run_of(self.graph.block_of(own.mark.as_ref()?)?);
            self.parts.get(&run).map(|part| part.blocks)
        };
        let all: usize = self.graph.uses.iter().filter(calls_of).filter_map(size).sum();
        self.shared = all > self.graph.blocks.saturating_mul(16).saturating_add(50_000);
        for (start, part) in self.parts.iter_mut().filter(|_| self.shared) {
            for end in std::mem::take(&mut part.returns) {
                self.ends.entry(end).or_default().push(*start);
            }
        }
        self.spread(&calls);
        true
    }

    /// What a part calls changes what it changes.
    fn spread(&mut self, calls: &BTreeMap<usize, BTreeSet<usize>>) {
        let starts: Vec<usize> = calls.keys().copied().collect();
        let place = |run: &usize| starts.binary_search(run).ok();
        let inner: Vec<Vec<usize>> = calls.values().map(|own| own.iter().filter_map(place).collect()).collect();
        let circle = circles(&inner);
        let mut groups: Vec<Vec<usize>> = vec![Vec::new(); circle.len()];
        for (at, circle) in circle.iter().enumerate() {
            groups[*circle].push(at);
        }
        // Circles are numbered from the inside: what is called by others comes before them.
        let mut patience = self.graph.blocks.saturating_mul(PATIENCE).saturating_add(100_000);
        for group in &groups {
            let mut all = Touched::default();
            let members = group.iter().flat_map(|at| std::iter::once(at).chain(&inner[*at]));
            for own in members.filter_map(|at| self.parts.get(starts.get(*at)?)) {
                all.add(&own.touched);
                patience = patience.saturating_sub(own.touched.size());
            }
            if patience == 0 {
                all = Touched::everything();
            }
            for at in group {
                if let Some(part) = starts.get(*at).and_then(|start| self.parts.get_mut(start)) {
                    part.touched = all.clone();
                }
            }
        }
    }

    /// One run of blocks of a part: what it changes, what it calls, and where it goes on.
    fn within(&self, run: usize, part: &mut Part, inner: &mut BTreeSet<usize>, follow: &mut dyn FnMut(usize)) {
        let blocks = self.steps.program.blocks();
        for index in self.graph.leaders[run]..self.graph.run_end(run) {
            let Some(block) = blocks.get(index) else { return };
            let before = Touched::probes();
            let mut after = before.clone();
            after.iter_mut().for_each(|state| self.steps.step(index, block, state));
            part.touched.note(&before, &after);
            match self.graph.end(index, block) {
                End::Stop => {
                    part.outline.stops |= !matches!(block.kind, BlockKind::EndPgm(_));
                    if !block.skip {
                        return;
                    }
                }
                End::Return => {
                    part.outline.returns = true;
                    part.returns.insert(index);
                    if !block.skip {
                        return;
                    }
                }
                End::Use(at) => {
                    let Some(own) = self.graph.uses.get(at) else { continue };
                    match own.mark.as_ref().and_then(|mark| self.graph.block_of(mark)) {
                        None => part.touched = Touched::everything(),
                        Some(target) if own.way == Way::Call => {
                            part.outline.calls.push(at);
                            inner.insert(self.graph.run_of(target));
                        }
                        Some(target) => follow(self.graph.run_of(target)),
                    }
                }
                _ => {}
            }
        }
        follow(run + 1);
    }

    /// The state at END PGM, where a called program returns; nothing if it comes to M2 or M30, which end everything, or
    /// to no end at all.
    pub(super) fn exit(&self) -> Option<State> {
        let blocks = self.steps.program.blocks();
        let mut exit: Option<State> = None;
        for ((run, caller), state) in &self.entries {
            let mut state = state.clone();
            for index in self.graph.leaders.get(*run).copied()?..self.graph.run_end(*run) {
                let block = blocks.get(index)?;
                if stops(block) {
                    if !matches!(block.kind, BlockKind::EndPgm(_)) || *caller != Caller::Nobody {
                        return None;
                    }
                    exit = Some(exit.map_or_else(|| state.clone(), |all| all.join(&state)));
                    break;
                }
                self.steps.step(index, block, &mut state);
            }
        }
        exit
    }

    /// Walks once more through everything that was reached and notes what the rules ask for.
    pub(super) fn result(mut self, finished: bool) -> Run {
        let mut run = Run::default();
        if !finished {
            run.changes.push((0, Some(Modal::UNKNOWN)));
            run.graph = self.graph;
            return run;
        }
        for (start, part) in std::mem::take(&mut self.parts) {
            if let Some(block) = self.graph.leaders.get(start) {
                run.parts.insert(*block, part.outline);
            }
        }
        let blocks = self.steps.program.blocks();
        let mut words = Motion::new(Path::L);
        let (mut read, mut calls, mut seen) = (Vec::new(), Vec::new(), HashSet::<Modal>::new());
        (run.unset, run.unfed) = self.first_pass();
        for (at, first) in self.graph.leaders.iter().enumerate() {
            let nodes = (at, Caller::Nobody)..=(at, Caller::Use(usize::MAX));
            let mut states: Vec<State> = self.entries.range(nodes).map(|(_, state)| state.clone()).collect();
            if self.entries.contains_key(&(at, Caller::Nobody)) {
                run.main.insert(*first);
            }
            let mut stopped = false;
            for index in *first..self.graph.run_end(at) {
                let Some(block) = blocks.get(index) else { break };
                if stopped {
                    states.clear();
                }
                let modal = states.iter().map(|state| state.modal).reduce(|one, other| one.join(&other));
                if run.changes.last().is_none_or(|(_, last)| *last != modal) {
                    run.changes.push((index, modal));
                }
                if states.is_empty() {
                    continue;
                }
                read.clear();
                reads(block, &mut read);
                for (q, span) in &read {
                    let known = states
                        .iter()
                        .map(|state| state.get(*q))
                        .reduce(|one, other| if one == other { one } else { Known::Unknown });
                    match known {
                        Some(Known::Unset) => run.unset.push((*q, *span)),
                        Some(Known::Number(number)) => {
                            run.numbers.insert(span.start, number);
                            let written = matches!(block.kind, BlockKind::Motion(_) | BlockKind::ToolCall(_));
                            if written && (number <= 0.0 || self.steps.program.slice(*span).starts_with('-')) {
                                run.odd.push(*span);
                            }
                        }
                        _ => {}
                    }
                }
                run.failing.extend(Steps::failing(block, &states));
                calls.clear();
                calls_in(block, &mut words, &mut calls);
                calls.extend(self.steps.pattern_at(index, block));
                for span in calls.iter().copied() {
                    // Each way of coming here by itself: the same block may be right for one and wrong for another.
                    seen.clear();
                    for modal in states.iter().map(|state| self.steps.at_call(block, state)) {
                        if states.len() == 1 || seen.insert(modal) {
                            run.calls.push(CycleCall { span, block: index, modal });
                        }
                    }
                }
                states.iter_mut().for_each(|state| self.steps.step(index, block, state));
                let ends = stops(block);
                stopped = ends && !block.skip;
                if ends
                    && let Some(modal) = states.iter().map(|state| state.modal).reduce(|one, other| one.join(&other))
                {
                    run.ends.push((index, modal));
                }
            }
        }
        if let Some(state) = self.entries.get(&(0, Caller::Nobody)) {
            for (place, passes) in trace::numbers(self.steps, &self.graph, state.clone()) {
                if let Entry::Vacant(entry) = run.numbers.entry(place) {
                    match passes.only() {
                        Some(number) => drop(entry.insert(number)),
                        None => run.passes.extend(passes.several().map(|several| (place, several))),
                    }
                }
            }
        }
        run.unset.sort_by_key(|(_, span)| span.start);
        run.graph = self.graph;
        run
    }

    /// The parameters that have no value when the run comes to them first, as far as it can only go one way, and the
    /// first movement at feed on it that comes before any feed.
    fn first_pass(&self) -> (Vec<(QRef, Span)>, Option<usize>) {
        let blocks = self.steps.program.blocks();
        let Some(mut state) = self.entries.get(&(0, Caller::Nobody)).cloned() else { return Default::default() };
        if !state.may_be_unset() {
            return Default::default();
        }
        let mut unfed = None;
        let (mut found, mut read, mut back) = (Vec::new(), Vec::new(), Vec::new());
        let mut index = 0;
        let mut patience = blocks.len().saturating_mul(4).saturating_add(10_000);
        while let Some(block) = blocks.get(index) {
            patience -= 1;
            if block.skip || patience == 0 {
                break;
            }
            read.clear();
            reads(block, &mut read);
            found.extend(read.iter().filter(|(q, _)| state.get(*q) == Known::Unset).copied());
            if state.modal.is(Aspect::Feed) == Tri::No && needs_feed(block) {
                unfed = unfed.or(Some(index));
            }
            self.steps.step(index, block, &mut state);
            index += 1;
            match self.graph.end(index - 1, block) {
                End::Next => {}
                End::Stop => break,
                End::Return => index = back.pop().unwrap_or(index),
                End::Use(at) => {
                    let own = self.graph.uses.get(at).filter(|own| own.way == Way::Call);
                    let Some(target) = own.and_then(|own| self.graph.block_of(own.mark.as_ref()?)) else { break };
                    back.push(index);
                    index = target;
                }
            }
        }
        (found, unfed)
    }
}

/// What is known where a state comes to one that is known already, if that is news. Where all of them know too much, it
/// knows no parameters.
fn joined(known: Option<&State>, state: &State, all: &mut usize) -> Option<State> {
    let mut joined = known.map_or_else(|| state.clone(), |known| known.join(state));
    let before = known.map_or(0, State::size);
    if *all - before + joined.size() > MOST_KNOWN {
        joined.forget_parameters();
    }
    if known == Some(&joined) {
        return None;
    }
    *all = *all - before + joined.size();
    Some(joined)
}
