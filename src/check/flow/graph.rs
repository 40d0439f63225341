//! The ways that a run can take: where blocks begin that something leads to, and where it leads.
//!
//! Invariant: nothing is executed here; labels that parameters choose may be any label.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::Span;
use crate::check::program::{Definition, Reading, names_end, stops};
use crate::program::syntax::{Block, BlockKind, Label, LabelRef, Program, ValueKind};
use crate::spec::ParameterKind;

/// Which label: a number or a name.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Mark {
    /// Its number.
    Number(u16),
    /// Its name.
    Name(String),
}

impl std::fmt::Display for Mark {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Name(name) => write!(f, "\"{name}\""),
        }
    }
}

/// How something leads to a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// A subprogram is called.
    Call,
    /// A part is repeated.
    Repeat,
    /// A jump.
    Jump,
    /// A cycle reads the contour there, or something else names the label.
    Named,
}

/// Something that leads to a label.
#[derive(Clone, Debug)]
pub struct Use {
    /// The block.
    pub block: usize,
    /// Where the label is named.
    pub span: Span,
    /// The label; nothing if a parameter chooses it.
    pub mark: Option<Mark>,
    /// How.
    pub way: Way,
}

/// What a block does to the way of the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// The next block follows.
    Next,
    /// LBL 0.
    Return,
    /// M2, M30, END PGM.
    Stop,
    /// The use of that index.
    Use(usize),
}

/// Labels of a program and what leads to them.
#[derive(Debug, Default)]
pub struct Graph {
    /// The blocks that set a label, label 0 left out, in the order of the text.
    pub labels: BTreeMap<Mark, Vec<usize>>,
    /// What leads to labels, in the order of the text.
    pub uses: Vec<Use>,
    /// The first block of each run of blocks that nothing leads out of or into.
    pub(super) leaders: Vec<usize>,
    /// The blocks that cannot be read and name M2 or M30.
    halts: BTreeSet<usize>,
    /// How many blocks there are.
    pub(super) blocks: usize,
}

impl Graph {
    pub(super) fn of(reading: &Reading<'_>) -> Self {
        let program = reading.program;
        let mut graph = Self { leaders: vec![0], blocks: program.blocks().len(), ..Self::default() };
        graph.contour_labels(reading);
        for (index, block) in reading.marked() {
            match &block.kind {
                BlockKind::Lbl(label) => match mark_of(program, label) {
                    Some(Mark::Number(0)) => graph.lead(index + 1),
                    Some(mark) => {
                        graph.labels.entry(mark).or_default().push(index);
                        graph.lead(index);
                    }
                    None => {}
                },
                BlockKind::CallLbl(call) => {
                    // A part that is repeated no times is none that is called.
                    let way = if call.repeat.is_some() { Way::Repeat } else { Way::Call };
                    graph.leads(program, index, &call.label, way);
                }
                BlockKind::FnJump(jump) => graph.leads(program, index, &jump.label, Way::Jump),
                BlockKind::Statement(statement) => {
                    for word in &statement.words {
                        if program.slice(word.name).eq_ignore_ascii_case("LBL") {
                            let mark = match word.value.kind {
                                ValueKind::Number(number) if (0.0..65536.0).contains(&number) => {
                                    Some(Mark::Number(number as u16))
                                }
                                ValueKind::Text(name) => Some(Mark::Name(program.slice(name).to_owned())),
                                _ => None,
                            };
                            graph.uses.push(Use { block: index, span: word.span, mark, way: Way::Named });
                        }
                    }
                }
                BlockKind::Unknown(_) if names_end(program, block) => {
                    graph.halts.insert(index);
                    graph.lead(index + 1);
                }
                _ if stops(block) => graph.lead(index + 1),
                _ => {}
            }
        }
        graph.uses.sort_by_key(|own| own.block);
        graph
    }

    /// The labels that definitions list, by the last block of each definition.
    fn contour_labels(&mut self, reading: &Reading<'_>) {
        for definition in reading.definitions.iter().filter(|own| own.has_kind(ParameterKind::LabelList)) {
            for item in &Definition::of(reading.program, &definition.as_related_cycle()).items {
                if item.param.is_none_or(|param| param.kind != ParameterKind::LabelList) {
                    continue;
                }
                let mut at = item.value_span.start;
                for part in reading.text(item.value_span).split('/') {
                    // The joint of two lines is no part of a label.
                    let blank = |c: char| c.is_whitespace() || c == '~';
                    let name = part.trim_matches(blank);
                    let from = at + (part.len() - part.trim_start_matches(blank).len());
                    at += part.len() + 1;
                    if let Ok(number) = name.parse() {
                        let span = Span::new(from, from + name.len());
                        let (block, mark) = (definition.view.last, Some(Mark::Number(number)));
                        self.uses.push(Use { block, span, mark, way: Way::Named });
                    }
                }
            }
        }
    }

    fn lead(&mut self, index: usize) {
        if self.leaders.last() != Some(&index) && index < self.blocks {
            self.leaders.push(index);
        }
    }

    fn leads(&mut self, program: &Program, index: usize, label: &LabelRef, way: Way) {
        self.uses.push(Use { block: index, span: label.span, mark: mark_of(program, label), way });
        self.lead(index + 1);
    }

    /// What the block does to the way.
    pub(super) fn end(&self, index: usize, block: &Block) -> End {
        match &block.kind {
            BlockKind::Lbl(label) if label.target == Label::END => End::Return,
            BlockKind::CallLbl(_) | BlockKind::FnJump(_) => {
                let at = self.uses.partition_point(|own| own.block < index);
                match self.uses.get(at) {
                    Some(own) if own.block == index => End::Use(at),
                    _ => End::Next,
                }
            }
            _ if stops(block) || self.halts.contains(&index) => End::Stop,
            _ => End::Next,
        }
    }

    /// What leads from a block to labels, or names them there.
    pub(in crate::check) fn uses_in(&self, block: usize) -> &[Use] {
        let from = self.uses.partition_point(|own| own.block < block);
        let after = self.uses.get(from..).unwrap_or_default();
        after.get(..after.partition_point(|own| own.block == block)).unwrap_or_default()
    }

    /// The block of the label that a block calls, if it is set once.
    pub(in crate::check) fn called_from(&self, block: usize) -> Option<usize> {
        self.block_of(self.uses_in(block).first()?.mark.as_ref()?)
    }

    /// The block after the last one of the run of blocks that begins there.
    pub(super) fn run_end(&self, run: usize) -> usize {
        self.leaders.get(run + 1).copied().unwrap_or(self.blocks)
    }

    /// The run of blocks that holds a block.
    pub(super) fn run_of(&self, block: usize) -> usize {
        self.leaders.partition_point(|leader| *leader <= block).saturating_sub(1)
    }

    /// The block of a label, if it is set once.
    pub fn block_of(&self, mark: &Mark) -> Option<usize> {
        match self.labels.get(mark)?.as_slice() {
            [only] => Some(*only),
            _ => None,
        }
    }
}

/// Which label is named; nothing if a parameter chooses it.
pub(super) fn mark_of(program: &Program, label: &LabelRef) -> Option<Mark> {
    match label.target {
        Label::Number(number) => Some(Mark::Number(number)),
        Label::Name(name) => Some(Mark::Name(program.slice(name).to_owned())),
        Label::Q(_) => None,
    }
}
