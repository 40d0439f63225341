//! What is read off a program by itself: its definitions, what its blocks are, whether the text's order can be that of
//! the run.
//!
//! A definition is kept as little more than its place, and read again by those who ask for its values: long programs
//! have many of them. Invariant: nothing is judged here, and nothing depends on the run or on other files.
use std::borrow::Cow;
use std::collections::BTreeMap;

use super::blocks::{content, each_function, is_silent, stops};
use super::definition::Defined;
use super::unread::{Hides, Unread, hides};
use crate::base::diag::Span;
use crate::base::expr::QRef;
use crate::check::Against;
use crate::check::cycle::{CycleLabels, LabelLanguages};
use crate::program::fields::key;
use crate::program::syntax::{Block, BlockKind, Compensates, CycleForm, MFunction, Path, Program, StatementKind};
use crate::spec::{Cycle, CycleKey, Known, MM_PER_INCH};

/// A program with its cycle definitions resolved for a control.
pub struct Reading<'a> {
    /// The program.
    pub program: &'a Program,
    /// What it is checked against.
    pub against: Against<'a>,
    /// Its cycle definitions, in order.
    pub definitions: Vec<Defined<'a>>,
    /// Whether the text's order can be trusted.
    pub flow: Flow,
    /// Whether lengths are inches.
    pub inch: bool,
    /// The blocks that are more than plain movements, definitions and comments: few in long programs.
    marked: Vec<u32>,
    /// The movements that are more than plain ones for a contour: corners, tangential arcs, approaches, free contours,
    /// surface normals and those with RL or RR.
    shaped: Vec<u32>,
    begins: bool,
    /// The first END PGM.
    pub(in crate::check) end: Option<usize>,
    /// The first block whose number is not greater than the one before, and that number.
    pub(in crate::check) falling: Option<(usize, u32)>,
    /// Whether it has arcs that must say which way round they go.
    pub(in crate::check) turns: bool,
    /// The parameters that a GLOBAL DEF gives, with the first block that does.
    pub(in crate::check) given: BTreeMap<QRef, usize>,
}

/// What is known of the order of the run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Flow {
    /// Blocks are repeated, called or passed over.
    pub jumps: bool,
    /// Other programs are called, or this is a part of one.
    pub programs: bool,
    /// The cycle is called at every position (M89).
    pub modal: bool,
    /// There are blocks that are not analysed, such as a change to turning.
    pub opaque: bool,
    /// What blocks that cannot be read may do.
    pub unread: Unread,
    /// There are blocks that may be skipped.
    pub skips: bool,
    /// Feeds may be those of a revolution (M136).
    pub per_revolution: bool,
}

impl<'a> Reading<'a> {
    /// Reads a program. Of the programs that it calls nothing is known here: `flow.programs` are known only for a
    /// fragment.
    pub(in crate::check) fn of(program: &'a Program, against: &Against<'a>) -> Self {
        let mut reading = Self {
            program,
            against: *against,
            definitions: Vec::new(),
            flow: Flow::default(),
            inch: false,
            marked: Vec::new(),
            shaped: Vec::new(),
            begins: false,
            end: None,
            falling: None,
            turns: false,
            given: BTreeMap::new(),
        };
        let mut known = BTreeMap::new();
        program.each_cycle(|view| {
            let key = key(view.keyword, view.number);
            let (known, kept, elsewhere) = *known.entry(key).or_insert_with(|| {
                let known = against.on.known(key);
                (known, against.labels.kept(key), elsewhere(against, key, known))
            });
            let torn = matches!(view.form, CycleForm::Parameters(written) if !written.errors.is_empty());
            let usual = LabelLanguages::default();
            reading.definitions.push(Defined { view, key, known, elsewhere, torn, kept, usual });
        });
        reading.definitions.shrink_to_fit();
        reading.follow();
        reading
    }

    /// The text at a place.
    pub fn text(&self, span: Span) -> &'a str {
        self.program.slice(span)
    }

    /// Whether the program begins with BEGIN PGM: it is a whole one.
    pub const fn begins(&self) -> bool {
        self.begins
    }

    /// A millimetre in the unit of the program.
    pub const fn millimetre(&self) -> f64 {
        if self.inch { 1.0 / MM_PER_INCH } else { 1.0 }
    }

    /// Whether a block that cannot be read begins with the word.
    pub fn unread(&self, word: &str) -> bool {
        let mut unread = self.marked().filter(|(_, block)| block.is_unread());
        unread.any(|(_, block)| {
            let text = self.text(self.content(block));
            text.get(..word.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(word))
        })
    }

    /// The blocks that are more than comments.
    pub fn acting(&self) -> impl DoubleEndedIterator<Item = &'a Block> {
        self.program.blocks().iter().filter(|block| !is_silent(block))
    }

    /// The blocks, with their places among all, that are neither comments nor of definitions, movements without M
    /// functions left out.
    pub fn marked(&self) -> impl DoubleEndedIterator<Item = (usize, &'a Block)> {
        let blocks = self.program.blocks();
        self.marked.iter().filter_map(|index| Some((*index as usize, blocks.get(*index as usize)?)))
    }

    /// Corners, tangential arcs, approaches, departures, elements of free contours, surface normals and movements with
    /// RL or RR, with their places among all blocks.
    pub fn shaped(&self) -> impl Iterator<Item = (usize, &'a Block)> {
        let blocks = self.program.blocks();
        self.shaped.iter().filter_map(|index| Some((*index as usize, blocks.get(*index as usize)?)))
    }

    /// The M functions of a block.
    pub fn functions(&self, block: &'a Block) -> Cow<'a, [MFunction]> {
        match &block.kind {
            BlockKind::Motion(motion) => Cow::Owned(motion.functions()),
            BlockKind::Functions(list) | BlockKind::Stop(list) => Cow::Borrowed(list),
            BlockKind::CyclCall(call) => Cow::Borrowed(&call.functions),
            _ => Cow::Borrowed(&[]),
        }
    }

    /// Whether the program ends with the block.
    pub fn ends(&self, block: &Block) -> bool {
        stops(block)
    }

    /// What the first line of a block says, without its number and the blanks around it.
    pub fn content(&self, block: &Block) -> Span {
        content(self.program, block)
    }

    /// The labels of a definition's cycle.
    pub fn labels(&self, definition: &Defined<'a>) -> Option<&'a CycleLabels> {
        let (cycle, kept) = definition.cycle().zip(definition.kept)?;
        Some(self.against.labels.labels_of(cycle, kept))
    }

    /// The definition that begins with a block.
    pub(in crate::check) fn definition_at(&self, block: usize) -> Option<&Defined<'a>> {
        let at = self.definitions.partition_point(|own| own.view.first < block);
        self.definitions.get(at).filter(|own| own.view.first == block)
    }

    /// The last definition that begins before a block.
    pub(in crate::check) fn definition_before(&self, block: usize) -> Option<&Defined<'a>> {
        let at = self.definitions.partition_point(|own| own.view.first < block);
        self.definitions.get(at.checked_sub(1)?)
    }

    /// Walks through the blocks and notes what they are.
    fn follow(&mut self) {
        let mut last = None;
        for (index, block) in self.program.blocks().iter().enumerate() {
            // A block that may be skipped may not happen.
            self.flow.skips |= block.skip;
            if let Some(number) = block.number {
                let before = last.replace(number).filter(|before| number <= *before && self.falling.is_none());
                self.falling = self.falling.or(before.map(|before| (index, before)));
            }
            match &block.kind {
                BlockKind::Empty
                | BlockKind::Comment
                | BlockKind::Structure(_)
                | BlockKind::CycleDef(_)
                | BlockKind::OldCycleLine(_) => continue,
                BlockKind::Motion(motion) => {
                    self.turns |= matches!(motion.path(), Path::C | Path::Cr | Path::Cp | Path::Fc | Path::Fct);
                    let outline = motion.outline();
                    let formed = matches!(
                        motion.path(),
                        Path::Rnd
                            | Path::Chf
                            | Path::Appr(_)
                            | Path::Dep(_)
                            | Path::Ct
                            | Path::Ctp
                            | Path::Fl
                            | Path::Flt
                            | Path::Fc
                            | Path::Fct
                            | Path::Fpol
                            | Path::Ln
                    );
                    if formed || outline.compensates() == Compensates::Beside {
                        self.shaped.extend(u32::try_from(index).ok());
                    }
                    if !outline.has_functions() && !outline.has_odd_coords() && !motion.ends_with_letter() {
                        continue;
                    }
                }
                BlockKind::GlobalDef(own) => {
                    for parameter in &own.parameters {
                        self.given.entry(parameter.q).or_insert(index);
                    }
                }
                BlockKind::BeginPgm(frame) => (self.inch, self.begins) = (frame.inch, true),
                BlockKind::EndPgm(_) => self.end = self.end.or(Some(index)),
                BlockKind::CallLbl(_) | BlockKind::FnJump(_) => self.flow.jumps = true,
                BlockKind::Statement(statement) => match statement.kind {
                    StatementKind::Function => self.flow.opaque = true,
                    StatementKind::Indirect | StatementKind::Refused => self.hide(block),
                    _ => {}
                },
                BlockKind::Iso(_) if block.is_blend() => {}
                BlockKind::Unknown(_) | BlockKind::Iso(_) => self.hide(block),
                _ => {}
            }
            each_function(block, |number| {
                self.flow.modal |= number == 89;
                self.flow.per_revolution |= number == 136;
            });
            // No memory holds so many blocks that this is not enough.
            self.marked.extend(u32::try_from(index).ok());
        }
        self.marked.shrink_to_fit();
        self.shaped.shrink_to_fit();
        self.flow.jumps |= self.flow.skips;
        // A fragment is called from a program or copied into one: what comes before and after it is not known.
        self.flow.programs |= !self.begins;
    }

    /// Takes in what a block that cannot be read may do.
    fn hide(&mut self, block: &Block) {
        self.flow.opaque = true;
        match hides(self.program, block) {
            Hides::Movement => self.flow.unread.movements = true,
            Hides::Tool => self.flow.unread.tools = true,
            Hides::Assignment(_) => self.flow.unread.assignments = true,
            Hides::Machining => {}
            Hides::Anything => self.flow.unread.anything = true,
        }
    }
}

/// The cycle as the control with the highest id describes it, if this one does not.
fn elsewhere<'a>(against: &Against<'a>, key: CycleKey, known: Known<'_>) -> Option<&'a Cycle> {
    if matches!(known, Known::Described(_) | Known::Builders) {
        return None;
    }
    against.catalogue.describing(key).map(|(_, cycle)| cycle)
}
