//! What the rules need to know of a program, read off once.
//!
//! A definition is kept as little more than its place, and read again by those who ask for its values: long programs
//! have many of them. Invariant: nothing is judged here; [`Flow`] says whether the order of the text can be that of the
//! run.
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::OnceLock;

use super::among::{self, Among, Callees, ProgramCall};
use super::definition::{Defined, Definition, Item, with_meaning};
use super::flow::{Run, stops};
use super::guards::SharedData;
use super::labels::{Tongues, told_by};
use super::unread::Unread;
use super::{Against, CycleLabels, values};
use crate::base::diag::Span;
use crate::base::expr::QRef;
use crate::program::fields::key;
use crate::program::syntax::{
    Amount, Block, BlockKind, Compensates, CycleForm, MFunction, Operand, Path, Program, StatementKind, ValueKind,
};
use crate::spec::{Cycle, CycleKey, Known, Param};

/// A program with its cycle definitions resolved for a control.
pub struct Facts<'a> {
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
    /// What is known of its run.
    pub run: Run,
    /// The language of its labels, if any of them is known.
    pub language: Option<String>,
    /// The place of that language in the book of labels.
    tongue: Option<u32>,
    /// The blocks that are more than plain movements, definitions and comments: few in long programs.
    marked: Vec<u32>,
    /// The movements that are more than plain ones for a contour: corners, tangential arcs, approaches, free contours,
    /// surface normals and those that say RL or RR.
    shaped: Vec<u32>,
    begins: bool,
    /// The first END PGM.
    pub(super) end: Option<usize>,
    /// The first block whose number is not greater than the one before, and that number.
    pub(super) falling: Option<(usize, u32)>,
    /// Whether it has arcs that must say which way round they go.
    pub(super) turns: bool,
    /// The programs that it calls.
    pub calls: Vec<ProgramCall>,
    /// Those of them that are known.
    pub(super) callees: Callees,
    /// What it stands among.
    pub(super) among: Option<&'a dyn Among>,
    /// The data that cycles share.
    pub(super) shared: SharedData,
    /// Whether any definition has labels in a language that is not loaded, once that was asked.
    pub(super) foreign: OnceLock<bool>,
    /// The parameters that a GLOBAL DEF gives, with the first block that does.
    pub(super) given: BTreeMap<QRef, usize>,
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
}

impl<'a> Facts<'a> {
    /// The facts of a program.
    pub fn of(program: &'a Program, against: &Against<'a>) -> Self {
        Self::among(program, against, None)
    }

    /// The facts of a program that stands among others.
    pub fn among(program: &'a Program, against: &Against<'a>, among: Option<&'a dyn Among>) -> Self {
        let mut facts = Self::begun(program, against, among);
        facts.run = Run::of(&facts);
        facts.listen();
        facts
    }

    /// The facts of a program whose run does not matter: no parameter has a number, and the language is not known.
    pub fn unrun(program: &'a Program, against: &Against<'a>) -> Self {
        Self::begun(program, against, None)
    }

    /// The same with the language of its labels.
    pub fn spoken(program: &'a Program, against: &Against<'a>) -> Self {
        let mut facts = Self::unrun(program, against);
        facts.listen();
        facts
    }

    /// Finds out the language of its labels, and which definitions have labels letter by letter.
    fn listen(&mut self) {
        let told = told_by(self);
        self.language = self.against.language.map(str::to_owned).or(told.language);
        let mut all = self.against.labels.languages();
        self.tongue = self.language.as_deref().and_then(|own| all.position(|tag| tag == own)?.try_into().ok());
        for (definition, usual) in self.definitions.iter_mut().zip(told.usual) {
            definition.usual = usual;
        }
    }

    /// Whether the name and the labels of a definition are letter by letter those of the program's language, and it has
    /// any: most definitions of long programs are such.
    pub(super) fn has_usual_labels(&self, definition: &Defined<'_>) -> bool {
        self.tongue.is_some_and(|tongue| definition.usual.has(tongue))
    }

    /// The facts of a program without its run.
    pub(super) fn begun(program: &'a Program, against: &Against<'a>, among: Option<&'a dyn Among>) -> Self {
        let mut facts = Self {
            program,
            against: *against,
            definitions: Vec::new(),
            flow: Flow::default(),
            inch: false,
            run: Run::default(),
            language: None,
            tongue: None,
            marked: Vec::new(),
            shaped: Vec::new(),
            begins: false,
            end: None,
            falling: None,
            turns: false,
            calls: Vec::new(),
            callees: Callees::default(),
            among,
            shared: SharedData::default(),
            foreign: OnceLock::new(),
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
            facts.definitions.push(Defined { view, key, known, elsewhere, torn, kept, usual: Tongues::default() });
        });
        facts.definitions.shrink_to_fit();
        facts.calls = among::calls(&facts);
        facts.callees = Callees::of(&facts);
        facts.follow();
        facts
    }

    /// The text at a place.
    pub fn text(&self, span: Span) -> &'a str {
        self.program.slice(span)
    }

    /// Whether the program begins with BEGIN PGM: it is a whole one.
    pub const fn begins(&self) -> bool {
        self.begins
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
    pub(super) fn definition_at(&self, block: usize) -> Option<&Defined<'a>> {
        let at = self.definitions.partition_point(|own| own.view.first < block);
        self.definitions.get(at).filter(|own| own.view.first == block)
    }

    /// The last definition that begins before a block.
    pub(super) fn definition_before(&self, block: usize) -> Option<&Defined<'a>> {
        let at = self.definitions.partition_point(|own| own.view.first < block);
        self.definitions.get(at.checked_sub(1)?)
    }

    /// Asks the definitions in lines whose cycle, or the one that it is like, has a parameter with a meaning, with the
    /// items that write it, until one has an answer.
    pub(super) fn find_meaning<T>(
        &self,
        meaning: &str,
        mut ask: impl FnMut(&Defined<'a>, &mut dyn Iterator<Item = &Item<'_>>) -> Option<T>,
    ) -> Option<T> {
        let of_lines = self.definitions.iter().filter(|own| matches!(own.view.form, CycleForm::Lines(_)));
        let means = |param: &Param| param.is.as_str() == meaning;
        of_lines.filter(|own| own.kin().is_some_and(|cycle| with_meaning(cycle, meaning).is_some())).find_map(|own| {
            let kin = own.as_kin();
            let read = self.read(&kin);
            ask(own, &mut read.items.iter().filter(|item| item.param.is_some_and(means)))
        })
    }

    /// The definitions with their values.
    pub fn readings(&self) -> impl Iterator<Item = Definition<'_>> {
        self.definitions.iter().map(|definition| self.read(definition))
    }

    /// The definitions of described cycles with their values and specifications. Each is read anew: a rule that needs
    /// no others is one of those that are carried out together.
    pub fn described(&self) -> impl Iterator<Item = (Definition<'_>, &'a Cycle)> {
        self.definitions.iter().filter_map(|definition| definition.cycle().map(|cycle| (self.read(definition), cycle)))
    }

    /// A definition with its values.
    pub fn read<'d>(&'d self, definition: &'d Defined<'a>) -> Definition<'d> {
        self.read_into(Vec::new(), definition)
    }

    /// The same with room that was used before; what it holds is let go.
    pub(super) fn read_into<'d>(&'d self, room: Vec<Item<'d>>, definition: &'d Defined<'a>) -> Definition<'d> {
        let mut read = Definition::begun(room, self.program, definition);
        self.fill(&mut read, None);
        read
    }

    /// Gives a definition its values on one of the passes of a loop.
    pub(super) fn read_pass(&self, definition: &mut Definition<'_>, pass: usize) {
        self.fill(definition, Some(pass));
    }

    fn fill(&self, read: &mut Definition<'_>, pass: Option<usize>) {
        for item in &mut read.items {
            if let Some(ValueKind::Q { negative, .. }) = item.value.map(|value| value.kind) {
                let passed = || pass.and_then(|pass| self.run.numbers_at(item.value_span).get(pass).copied());
                let signed = |number: f64| if negative { -number } else { number };
                item.number = self.known_at(item.value_span, negative).or_else(|| passed().map(signed));
            }
            item.refusal = values::refused(item, self.inch);
        }
    }

    /// How often a definition is read with other values.
    pub(super) fn passes(&self, definition: &Definition<'_>) -> usize {
        if !self.run.changes_numbers() {
            return 0;
        }
        definition.items.iter().map(|item| self.run.numbers_at(item.value_span).len()).max().unwrap_or_default()
    }

    /// The number that a parameter certainly has at its place, with the sign before it.
    pub(super) fn known_at(&self, place: Span, negative: bool) -> Option<f64> {
        self.run.number_at(place).map(|number| if negative { -number } else { number })
    }

    /// The number of an operand that is a parameter, if it is certain.
    pub(super) fn known(&self, operand: &Operand) -> Option<f64> {
        match operand.amount {
            Amount::Q { negative, .. } => self.known_at(operand.span, negative),
            Amount::Number(_) | Amount::Text(_) => None,
        }
    }

    /// The number of an operand, written or certain.
    pub(super) fn number(&self, operand: &Operand) -> Option<f64> {
        match operand.amount {
            Amount::Number(number) => Some(number),
            Amount::Q { .. } | Amount::Text(_) => self.known(operand),
        }
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
                    self.turns |= matches!(motion.path(), Path::C | Path::Cr | Path::Cp);
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
                BlockKind::CallPgm(_) => self.flow.programs |= self.calls_unknown(index),
                BlockKind::Statement(statement) => match statement.kind {
                    StatementKind::CallSelected => self.flow.programs |= self.calls_unknown(index),
                    StatementKind::Function => self.flow.opaque = true,
                    StatementKind::Indirect | StatementKind::Refused => self.flow.hide(self.program, block),
                    _ => {}
                },
                BlockKind::Iso(_) if block.is_blend() => {}
                BlockKind::Unknown(_) | BlockKind::Iso(_) => self.flow.hide(self.program, block),
                _ => {}
            }
            each_function(block, |number| self.flow.modal |= number == 89);
            // No memory holds so many blocks that this is not enough.
            self.marked.extend(u32::try_from(index).ok());
        }
        self.marked.shrink_to_fit();
        self.shaped.shrink_to_fit();
        self.flow.jumps |= self.flow.skips;
        // A fragment is called from a program or copied into one: what comes before and behind it is not known.
        self.flow.programs |= !self.begins;
    }

    /// Whether a block calls a program that may define or call cycles.
    fn calls_unknown(&self, block: usize) -> bool {
        self.callees.blocks.get(&block).is_none_or(|callee| callee.through.calls_cycle)
    }
}

/// The cycle as the control with the highest id describes it, if this one does not.
fn elsewhere<'a>(against: &Against<'a>, key: CycleKey, known: Known<'_>) -> Option<&'a Cycle> {
    if matches!(known, Known::Described(_) | Known::Builders) {
        return None;
    }
    against.catalogue.describing(key).map(|(_, cycle)| cycle)
}

/// What the first line of a block says, without its number and the blanks around it.
pub(super) fn content(program: &Program, block: &Block) -> Span {
    let text = program.slice(block.span);
    let line = text.split(['\n', '\r']).next().unwrap_or_default();
    let mut from = line.len() - line.trim_start_matches(['/', ' ', '\t']).len();
    if block.number.is_some() {
        let rest = line.get(from..).unwrap_or_default();
        let rest = rest.trim_start_matches(['N', 'n']).trim_start_matches(|c: char| c.is_ascii_digit());
        from = line.len() - rest.trim_start_matches(['/', ' ', '\t']).len();
    }
    let end = line.trim_end().len().max(from);
    Span::new(block.span.start + from, block.span.start + end)
}

/// Whether a block is a comment or blank.
pub(super) fn is_silent(block: &Block) -> bool {
    matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_))
}

/// The numbers of a block's M functions, in the order written.
pub(super) fn each_function(block: &Block, mut each: impl FnMut(u16)) {
    match &block.kind {
        BlockKind::Motion(motion) => motion.each_function(each),
        BlockKind::Functions(list) | BlockKind::Stop(list) => list.iter().for_each(|own| each(own.number)),
        BlockKind::CyclCall(call) => call.functions.iter().for_each(|own| each(own.number)),
        _ => {}
    }
}
