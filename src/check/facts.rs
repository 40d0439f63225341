//! What the rules need to know of a program: what is read off it ([`Reading`]) and what is known of its run, in one.
//!
//! Invariant: nothing is judged here; [`Flow`] says whether the order of the text can be that of the run.
//!
//! [`Flow`]: super::Flow
use std::ops::Deref;
use std::sync::OnceLock;

use super::Against;
use super::cycle::Effect;
use super::first_way::FirstWay;
use super::flow::{Callees, ProgramCall, Project, Run, calls, follow};
use super::incident::Incident;
use super::program::{Defined, Definition, Item, Reading, language_of, number, refused, with_meaning};
use crate::base::diag::Span;
use crate::base::expr::QRef;
use crate::program::syntax::{Amount, Block, CycleForm, Operand, Program, ValueKind};
use crate::spec::{Cycle, Group, Param};

/// Numbers of parameters.
type Numbers = Vec<(QRef, f64)>;

/// A program with its cycle definitions resolved for a control, and what is known of its run.
pub struct Facts<'a> {
    /// What is read off the program.
    reading: Reading<'a>,
    /// What is known of its run.
    pub run: Run,
    /// The language of its labels, if any of them is known.
    pub language: Option<String>,
    /// The place of that language in the book of labels.
    language_place: Option<u32>,
    /// The programs that it calls.
    pub calls: Vec<ProgramCall>,
    /// Those of them that are known.
    callees: Callees,
    /// The files that it refers to.
    pub(super) project: Option<&'a dyn Project>,
    /// The data that cycles share, read when a guard first asks for them: the first block of each definition that keeps
    /// such, and its numbers.
    shared: OnceLock<Vec<(usize, Numbers)>>,
    /// Whether any definition has labels in a language that is not loaded, once that was asked.
    pub(super) foreign: OnceLock<bool>,
    /// What happens to the blank, once that was asked.
    pub(super) incidents: OnceLock<Vec<(Span, Incident)>>,
    /// The first way through the program, once that was asked.
    pub(super) first_way: OnceLock<FirstWay>,
}

impl<'a> Deref for Facts<'a> {
    type Target = Reading<'a>;

    fn deref(&self) -> &Reading<'a> {
        &self.reading
    }
}

impl<'a> Facts<'a> {
    /// The facts of a program.
    pub fn of(program: &'a Program, against: &Against<'a>) -> Self {
        Self::within(program, against, None)
    }

    /// The facts of a program of a project.
    pub fn within(program: &'a Program, against: &Against<'a>, project: Option<&'a dyn Project>) -> Self {
        let mut facts = Self::begun(program, against, project);
        facts.run = follow(&facts.reading, &facts.callees);
        facts.note_language();
        facts
    }

    /// The facts of a program whose run does not matter: no parameter has a number, and the language is not known.
    pub fn unrun(program: &'a Program, against: &Against<'a>) -> Self {
        Self::begun(program, against, None)
    }

    /// The same with the language of its labels.
    pub fn spoken(program: &'a Program, against: &Against<'a>) -> Self {
        let mut facts = Self::unrun(program, against);
        facts.note_language();
        facts
    }

    /// Finds out the language of its labels, and which definitions have labels letter by letter.
    fn note_language(&mut self) {
        let labels = language_of(&self.reading);
        self.language = self.against.language.map(str::to_owned).or(labels.language);
        let mut all = self.against.labels.languages();
        self.language_place = self.language.as_deref().and_then(|own| all.position(|tag| tag == own)?.try_into().ok());
        for (definition, usual) in self.reading.definitions.iter_mut().zip(labels.usual) {
            definition.usual = usual;
        }
    }

    /// Whether the name and the labels of a definition are letter by letter those of the program's language, and it has
    /// any: most definitions of long programs are such.
    pub(super) fn has_usual_labels(&self, definition: &Defined<'_>) -> bool {
        self.language_place.is_some_and(|place| definition.usual.has(place))
    }

    /// The facts of a program without its run.
    fn begun(program: &'a Program, against: &Against<'a>, project: Option<&'a dyn Project>) -> Self {
        let mut reading = Reading::of(program, against);
        let calls = calls(&reading, project);
        let callees = Callees::of(&reading, &calls);
        reading.flow.programs |= callees.leave_open(&reading);
        Self {
            reading,
            run: Run::default(),
            language: None,
            language_place: None,
            calls,
            callees,
            project,
            shared: OnceLock::new(),
            foreign: OnceLock::new(),
            incidents: OnceLock::new(),
            first_way: OnceLock::new(),
        }
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
        of_lines.filter(|own| own.related_cycle().is_some_and(|cycle| with_meaning(cycle, meaning).is_some())).find_map(
            |own| {
                let related = own.as_related_cycle();
                let read = self.read(&related);
                ask(own, &mut read.items.iter().filter(|item| item.param.is_some_and(means)))
            },
        )
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
            item.refusal = refused(item, self.inch);
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

    /// The blocks of the subprogram whose label is set in this block, as far as the first one that ends it; none of long
    /// ones, as each call looks at its own.
    pub(super) fn subprogram(&self, label: usize) -> Option<&[Block]> {
        const LONGEST: usize = 1 << 8;
        let body = self.program.blocks().get(label + 1..)?;
        body.get(..body.iter().take(LONGEST).position(Block::ends_subprogram)?)
    }

    /// The numbers of the data that a cycle works with, from the definition before it that keeps such.
    pub(super) fn shared_before(&self, definition: &Definition<'_>) -> &[(QRef, f64)] {
        let all = self.shared.get_or_init(|| {
            let keeps = |own: &&Defined<'_>| match (own.cycle().zip(own.kept), own.elsewhere) {
                (Some((cycle, kept)), _) => kept.effect(cycle).keeps(),
                (None, Some(cycle)) => cycle.file.group == Group::Contours && Effect::of_cycle(cycle).keeps(),
                (None, None) => false,
            };
            let read = |own: &Defined<'a>| numbers(&self.read(&own.as_related_cycle()));
            self.definitions.iter().filter(keeps).map(|own| (own.view.first, read(own))).collect()
        });
        let after = all.partition_point(|(first, _)| *first < definition.view.first);
        after.checked_sub(1).and_then(|at| all.get(at)).map_or(&[], |(_, numbers)| numbers)
    }
}

/// The first number of each parameter of a definition.
fn numbers(definition: &Definition<'_>) -> Numbers {
    let mut numbers = Numbers::new();
    for (q, number) in definition.items.iter().filter_map(|item| Some((item.param?.q?, number(item)?))) {
        if definition.in_order || !numbers.iter().any(|(own, _)| *own == q) {
            numbers.push((q, number));
        }
    }
    numbers
}
