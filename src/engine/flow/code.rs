//! Programs prepared for running: labels found, formulas compiled, lines of old-style definitions joined.
//!
//! Invariant: done once for a program; running it looks nothing up by name.
use std::collections::{BTreeMap, HashMap};

use crate::base::expr::{self, Code, QRef};
use crate::engine::geometry::INCH;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Block, BlockKind, CycleView, Formula, Label, Path, Program};

/// What a label is known by.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Key {
    Number(u16),
    Name(String),
}

/// A program ready to run.
pub(crate) struct Prepared<'p> {
    /// The program.
    pub(crate) program: &'p Program,
    /// Its definitions of cycles.
    pub(crate) cycles: Vec<CycleView<'p>>,
    /// By block: the index of the definition that begins there.
    definitions: BTreeMap<usize, usize>,
    /// By block: the compiled formula.
    formulas: BTreeMap<usize, Code>,
    /// By block: whether a rounding, a chamfer, an undercut or a recess follows directly.
    rounded: Vec<bool>,
    /// mm in its unit.
    pub(crate) unit: f64,
    /// The block of each label; nothing if the label is set twice.
    labels: HashMap<Key, Option<usize>>,
    /// Labels whose names are texts of parameters.
    changing_labels: Vec<(usize, QRef)>,
}

impl<'p> Prepared<'p> {
    pub(crate) fn new(program: &'p Program) -> Self {
        let blocks = program.blocks();
        let cycles = program.cycles();
        let definitions = cycles.iter().enumerate().map(|(index, view)| (view.first, index)).collect();
        let formulas = blocks.iter().enumerate().filter_map(|(at, block)| Some((at, formula(&block.kind)?))).collect();
        let rounded = rounded(program);
        let (mut labels, mut changing_labels) = (HashMap::new(), Vec::new());
        for (index, block) in blocks.iter().enumerate() {
            let BlockKind::Lbl(label) = &block.kind else { continue };
            if let Label::Q(q) = label.target {
                changing_labels.push((index, q));
            }
            let Some(key) = key(program, label.target).filter(|key| *key != Key::Number(0)) else { continue };
            labels.entry(key).and_modify(|block| *block = None).or_insert(Some(index));
        }
        let inch = blocks.iter().any(|block| matches!(&block.kind, BlockKind::BeginPgm(frame) if frame.inch));
        let unit = if inch { INCH } else { 1.0 };
        Self { program, cycles, definitions, formulas, rounded, unit, labels, changing_labels }
    }

    /// The block of that index.
    pub(crate) fn block(&self, index: usize) -> Option<&'p Block> {
        self.program.blocks().get(index)
    }

    /// The definition that begins at a block.
    pub(crate) fn definition(&self, block: usize) -> Option<usize> {
        self.definitions.get(&block).copied()
    }

    /// Whether the corner at the end of a block is rounded or broken by the next one.
    pub(crate) fn is_rounded(&self, block: usize) -> bool {
        self.rounded.get(block).copied().unwrap_or(false)
    }

    /// The compiled formula of a block.
    pub(crate) fn formula(&self, block: usize) -> Option<&Code> {
        self.formulas.get(&block)
    }

    /// The block of a label that is written with its number or name.
    pub(crate) fn label(&self, label: Label) -> Result<usize, Fault> {
        self.find(key(self.program, label))
    }

    /// The labels whose names are texts of parameters, in the order of the program.
    pub(crate) fn changing_labels(&self) -> &[(usize, QRef)] {
        &self.changing_labels
    }

    /// The block of a numbered label.
    pub(crate) fn numbered_label(&self, number: u16) -> Result<usize, Fault> {
        self.find(Some(Key::Number(number)))
    }

    /// The block of a named label.
    pub(crate) fn named_label(&self, name: &str) -> Result<usize, Fault> {
        self.find(Some(Key::Name(name.to_owned())))
    }

    fn find(&self, key: Option<Key>) -> Result<usize, Fault> {
        let shown = match &key {
            Some(Key::Number(number)) => number.to_string(),
            Some(Key::Name(name)) => name.clone(),
            None => String::new(),
        };
        match key.and_then(|key| self.labels.get(&key)) {
            Some(Some(block)) => Ok(*block),
            Some(None) => Err(Fault::program("jump-target-twice").arg("label", shown)),
            None => Err(Fault::program("jump-target-missing").arg("label", shown)),
        }
    }
}

fn key(program: &Program, label: Label) -> Option<Key> {
    match label {
        Label::Number(number) => Some(Key::Number(number)),
        Label::Name(span) => Some(Key::Name(program.slice(span).to_owned())),
        Label::Q(_) => None,
    }
}

/// The words with which undercuts and recesses in contours begin.
pub(crate) const FORM_ELEMENTS: [&str; 2] = ["UDC", "GRV"];

/// By block: whether a rounding, a chamfer, an undercut or a recess follows, but for comments and M functions.
fn rounded(program: &Program) -> Vec<bool> {
    let mut follows = false;
    let mut rounded: Vec<bool> = program
        .blocks()
        .iter()
        .rev()
        .map(|block| {
            let here = follows;
            follows = match &block.kind {
                BlockKind::Motion(motion) => matches!(motion.path(), Path::Rnd | Path::Chf),
                BlockKind::Statement(own) => {
                    let head = program.slice(own.head).trim_end();
                    FORM_ELEMENTS.iter().any(|word| head.eq_ignore_ascii_case(word))
                }
                BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) | BlockKind::Functions(_) => follows,
                _ => false,
            };
            here
        })
        .collect();
    rounded.reverse();
    rounded
}

fn formula(kind: &BlockKind) -> Option<Code> {
    let BlockKind::Formula(formula) = kind else { return None };
    let Formula { expr, .. } = &**formula;
    expr::compile(expr, &expr::OnlyParameters).ok()
}
