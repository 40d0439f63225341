//! What the rules need to know of a program, read off once.
//!
//! Invariant: nothing is judged here; the order of events is that of the text, and [`Flow`] says
//! whether that can be the order of the run.
use std::borrow::Cow;

use super::fields;
use super::flow::{Run, stops};
use super::labels::fold;
use super::{Against, CycleLabels, values};
use crate::diag::Span;
use crate::fields::key;
use crate::spec::{Cycle, CycleKey, Keyword, Known, Param, Refusal, TakesEffect};
use crate::syntax::{
    Block, BlockKind, CycleForm, CycleView, MFunction, OldCycleLine, Parameter, Program, StatementKind, Value,
    ValueKind,
};

/// A program with its cycle definitions resolved for a control.
pub struct Facts<'a> {
    /// The program.
    pub program: &'a Program,
    /// What it is checked against.
    pub against: Against<'a>,
    /// Its cycle definitions, in order.
    pub definitions: Vec<Definition<'a>>,
    /// What happens, in the order of the text.
    pub events: Vec<Event>,
    /// Whether the text's order can be trusted.
    pub flow: Flow,
    /// Whether lengths are inches.
    pub inch: bool,
    /// What is known of its run.
    pub run: Run,
    /// The language of its labels, if any of them is known.
    pub language: Option<String>,
}

/// A cycle definition.
pub struct Definition<'a> {
    /// As written.
    pub view: CycleView<'a>,
    /// Its key.
    pub key: CycleKey,
    /// What the control knows of it.
    pub known: Known<'a>,
    /// Its parameters or fields as written, those of described cycles with their specification.
    pub items: Vec<Item<'a>>,
    /// What a described cycle needs and the definition lacks.
    pub missing: Vec<&'a Param>,
    /// Whether a line of it cannot be read.
    pub torn: bool,
}

/// A parameter or field as written.
pub struct Item<'a> {
    /// Its specification, if the cycle is described and has it.
    pub param: Option<&'a Param>,
    /// How messages call it: `Q200`, `31.2 HEIGHT:`.
    pub name: Cow<'a, str>,
    /// All of it up to the end of the value.
    pub span: Span,
    /// The value's place.
    pub value_span: Span,
    /// The value in capitals as the specification's examples are written: `+60`, `X+60`, `#5`, `"AB"`.
    pub printed: String,
    /// The value, if it is a single one.
    pub value: Option<Value>,
    /// The number that the parameter written for it certainly has.
    pub number: Option<f64>,
    /// The printed label, or the printed word of an old-style field.
    pub label: Option<Span>,
    /// The place of its specification among the cycle's parameters.
    pub index: Option<usize>,
    /// The label made ready for comparison.
    pub(super) folded: Option<Cow<'a, str>>,
    /// Why its parameter refuses the value.
    pub(super) refusal: Option<Refusal>,
}

/// Something that happens in a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// A cycle definition, by index.
    Define(usize),
    /// A call of the last cycle.
    Call {
        /// Its place.
        span: Span,
        /// Whether it is a block of its own, `CYCL CALL`, that moves nowhere before.
        alone: bool,
    },
    /// The block that follows, which is neither comment nor blank.
    Block,
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
    /// There are blocks that cannot be read.
    pub unread: bool,
    /// There are blocks that may be skipped.
    pub skips: bool,
}

impl<'a> Facts<'a> {
    /// The facts of a program.
    pub fn of(program: &'a Program, against: &Against<'a>) -> Self {
        let definitions = program.cycles().into_iter().map(|view| Definition::of(program, view, against)).collect();
        let mut facts = Self {
            program,
            against: *against,
            definitions,
            events: Vec::new(),
            flow: Flow::default(),
            inch: false,
            run: Run::default(),
            language: None,
        };
        facts.follow();
        facts.run = Run::of(program, &facts.definitions);
        for item in facts.definitions.iter_mut().flat_map(|definition| &mut definition.items) {
            if let Some(ValueKind::Q { negative, .. }) = item.value.map(|value| value.kind)
                && let Some(number) = facts.run.number_at(item.value_span)
            {
                item.number = Some(if negative { -number } else { number });
            }
            item.refusal = values::refused(item, facts.inch);
        }
        facts.language = against.language.map(str::to_owned).or_else(|| super::labels::language_of(&facts));
        facts
    }

    /// The text at a place.
    pub fn text(&self, span: Span) -> &'a str {
        self.program.slice(span)
    }

    /// Whether the program begins with BEGIN PGM: it is a whole one.
    pub fn begins(&self) -> bool {
        self.program.blocks().iter().any(|block| matches!(block.kind, BlockKind::BeginPgm(_)))
    }

    /// Whether a block that cannot be read begins with the word.
    pub fn unread(&self, word: &str) -> bool {
        let unread = |block: &&Block| matches!(block.kind, BlockKind::Unknown(_));
        let mut unread = self.program.blocks().iter().filter(unread);
        unread.any(|block| {
            let text = self.text(self.content(block));
            text.get(..word.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(word))
        })
    }

    /// The blocks that are more than comments.
    pub fn acting(&self) -> impl Iterator<Item = &'a Block> {
        let silent =
            |block: &&Block| matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_));
        self.program.blocks().iter().filter(move |block| !silent(block))
    }

    /// The M functions of a block.
    pub fn functions(&self, block: &'a Block) -> &'a [MFunction] {
        match &block.kind {
            BlockKind::Motion(motion) if motion.has_functions() => &motion.functions,
            BlockKind::Functions(list) | BlockKind::Stop(list) => list,
            BlockKind::CyclCall(call) => &call.functions,
            _ => &[],
        }
    }

    /// Whether the program ends with the block.
    pub fn ends(&self, block: &Block) -> bool {
        stops(block)
    }

    /// What the first line of a block says, without its number and the blanks around it.
    pub fn content(&self, block: &Block) -> Span {
        let text = self.text(block.span);
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

    /// The labels of a definition's cycle.
    pub fn labels(&self, definition: &Definition<'_>) -> Option<&'a CycleLabels> {
        self.against.labels.cycle(definition.key)
    }

    /// The definitions of described cycles with their specifications.
    pub fn described(&self) -> impl Iterator<Item = (&Definition<'a>, &'a Cycle)> {
        self.definitions.iter().filter_map(|definition| match definition.known {
            Known::Described(cycle) => Some((definition, cycle)),
            _ => None,
        })
    }

    /// Walks through the blocks and notes what happens.
    fn follow(&mut self) {
        let mut next = 0;
        // A fragment is called from a program or copied into one: what comes before and behind it is not known.
        self.events.reserve(self.program.blocks().len() + self.definitions.len());
        let begins = |block: &Block| matches!(block.kind, BlockKind::BeginPgm(_));
        self.flow.programs |= !self.program.blocks().iter().any(begins);
        for (index, block) in self.program.blocks().iter().enumerate() {
            if !matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_)) {
                self.events.push(Event::Block);
            }
            // A block that may be skipped may not happen.
            self.flow.jumps |= block.skip;
            self.flow.skips |= block.skip;
            while self.definitions.get(next).is_some_and(|definition| definition.view.first == index) {
                self.events.push(Event::Define(next));
                next += 1;
            }
            match &block.kind {
                BlockKind::BeginPgm(frame) => self.inch = frame.inch,
                BlockKind::CallLbl(_) | BlockKind::FnJump(_) => self.flow.jumps = true,
                BlockKind::CallPgm(_) => self.flow.programs = true,
                BlockKind::Statement(statement) => match statement.kind {
                    StatementKind::CallSelected => self.flow.programs = true,
                    StatementKind::Function => self.flow.opaque = true,
                    _ => {}
                },
                BlockKind::Unknown(_) | BlockKind::Iso(_) => (self.flow.opaque, self.flow.unread) = (true, true),
                BlockKind::Motion(motion) if motion.has_functions() => self.note(&motion.functions, None),
                BlockKind::Functions(list) | BlockKind::Stop(list) => self.note(list, None),
                BlockKind::CyclCall(call) => {
                    self.note(&call.functions, Some(call.head));
                }
                _ => {}
            }
        }
    }

    /// The calls that a block makes.
    fn note(&mut self, list: &[MFunction], call: Option<Span>) {
        let mut calls: Vec<Span> = call.into_iter().collect();
        for function in list {
            self.flow.modal |= function.number == 89;
            if matches!(function.number, 89 | 99) {
                calls.push(function.span);
            }
        }
        let alone = call.is_some();
        self.events.extend(calls.into_iter().map(|span| Event::Call { span, alone }));
    }
}

impl<'a> Definition<'a> {
    fn of(program: &'a Program, view: CycleView<'a>, against: &Against<'a>) -> Self {
        let key = key(view.keyword, view.number);
        let known = against.on.known(key);
        let cycle = match known {
            Known::Described(cycle) => Some(cycle),
            _ => None,
        };
        let mut definition = Self { view, key, known, items: Vec::new(), missing: Vec::new(), torn: false };
        match definition.view.form.clone() {
            CycleForm::Parameters(written) => {
                definition.torn = !written.errors.is_empty();
                definition.parameters(program, written, cycle);
            }
            CycleForm::Lines(lines) => definition.lines(program, &lines, cycle),
        }
        definition
    }

    fn parameters(&mut self, program: &'a Program, written: &'a crate::syntax::CycleDef, cycle: Option<&'a Cycle>) {
        self.items.reserve_exact(written.parameters.len());
        for parameter in &written.parameters {
            let printed = program.slice(parameter.value.span);
            let quoted = printed.starts_with('"');
            let param = cycle.and_then(|cycle| cycle.written(parameter.q));
            self.items.push(Item {
                index: index_of(cycle, param),
                folded: parameter.label.map(|label| fold(program.slice(label))),
                param,
                name: name_of(program, parameter),
                span: parameter.span,
                value_span: parameter.value.span,
                printed: if quoted { printed.to_owned() } else { printed.to_uppercase() },
                value: Some(parameter.value),
                number: None,
                label: parameter.label,
                refusal: None,
            });
        }
        let Some(cycle) = cycle else { return };
        let written =
            |param: &Param| self.items.iter().any(|item| item.param.is_some_and(|own| std::ptr::eq(own, param)));
        let needed = |param: &&Param| param.field.as_ref().is_none_or(|field| field.form == 0 && !field.optional);
        self.missing = cycle.params.iter().filter(|param| needed(param) && !written(param)).collect();
    }

    fn lines(&mut self, program: &'a Program, lines: &[&'a OldCycleLine], cycle: Option<&'a Cycle>) {
        let Some(cycle) = cycle else { return };
        let matched = fields::matching(program, cycle, lines);
        self.items = matched.items;
        self.missing = matched.missing;
    }

    /// When the cycle acts, if that is known. All touch-probe cycles act when they are defined.
    pub fn takes_effect(&self) -> Option<TakesEffect> {
        match (self.known, self.key.keyword) {
            (Known::Described(cycle), _) => Some(cycle.file.takes_effect),
            (_, Keyword::TchProbe) => Some(TakesEffect::OnDefinition),
            _ => None,
        }
    }
}

/// The parameter as messages call it: as it is written, if that is how controls write it.
fn name_of<'a>(program: &'a Program, parameter: &Parameter) -> Cow<'a, str> {
    let written = program.slice(parameter.q_span);
    let usual = match written.as_bytes() {
        [b'Q', b'1'..=b'9', ..] => true,
        [b'Q', b'L' | b'R' | b'S', b'1'..=b'9', ..] => true,
        _ => false,
    };
    if usual { Cow::Borrowed(written) } else { Cow::Owned(parameter.q.to_string()) }
}

/// The place of a parameter in its cycle.
pub(super) fn index_of(cycle: Option<&Cycle>, param: Option<&Param>) -> Option<usize> {
    cycle?
        .params
        .iter()
        .zip(0..)
        .find(|(own, _)| param.is_some_and(|param| std::ptr::eq(*own, param)))
        .map(|(_, at)| at)
}
