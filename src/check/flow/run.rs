//! What is known of a program's run.
use std::collections::{BTreeMap, BTreeSet};

use super::circles::circles;
use super::graph::{Graph, Mark};
use super::state::Modal;
use crate::base::diag::Span;
use crate::base::expr::QRef;

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
    pub(super) changes: Vec<(usize, Option<Modal>)>,
    /// The calls of cycles that the run can come to.
    pub calls: Vec<CycleCall>,
    /// Parameters that are read and have no value on any way, with their places.
    pub unset: Vec<(QRef, Span)>,
    /// The first movement at feed before any feed, as far as the run can only go one way.
    pub unfed: Option<usize>,
    /// Formulas that have no result on any way, with their places and why.
    pub failing: Vec<(Span, &'static str)>,
    /// The places of parameters that are certainly zero or negative, or are read negated.
    pub(in crate::check) odd: Vec<Span>,
    /// Numbers of the parameters that definitions read, by the place of the value.
    pub(super) numbers: BTreeMap<usize, f64>,
    /// Those that a parameter has one after the other where a block is passed several times, by the place of the value.
    pub(super) passes: BTreeMap<usize, Vec<f64>>,
    /// Where the program ends, with the state there.
    pub ends: Vec<(usize, Modal)>,
    /// The blocks after a label, a call or a jump that the main part comes to, without being called.
    pub main: BTreeSet<usize>,
    /// What is called: the block of its label, where it returns, and the calls in it.
    pub(super) parts: BTreeMap<usize, Outline>,
}

/// A part that is called.
#[derive(Debug, Default)]
pub(super) struct Outline {
    pub(super) returns: bool,
    /// Whether it comes to M2 or M30.
    pub(super) stops: bool,
    /// The uses of labels in it that are calls.
    pub(super) calls: Vec<usize>,
}

impl Run {
    /// The state before a block; nothing if the run never comes there.
    pub fn before(&self, block: usize) -> Option<Modal> {
        let at = self.changes.partition_point(|(from, _)| *from <= block);
        self.changes.get(at.checked_sub(1)?)?.1
    }

    /// Stretches of blocks with the same state before each: first block, the block after the last one, state.
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
