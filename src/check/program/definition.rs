//! A cycle definition: what the control knows of its cycle, and its parameters or fields as they are written.
//!
//! Invariant: nothing here depends on the run; the numbers that parameters certainly have are filled in by [`Facts`].
//!
//! [`Facts`]: super::Facts
use std::borrow::Cow;
use std::ops::Deref;

use super::fields;
use super::item::{Item, Place, capitals};
use crate::check::cycle::{Effect, Kept, LabelLanguages};
use crate::program::syntax::{CycleDef, CycleForm, CycleView, Parameter, Program};
use crate::spec::{Cycle, CycleKey, Group, Keyword, Known, Param, ParameterKind, TakesEffect};

/// A cycle definition and what the control knows of its cycle.
#[derive(Clone)]
pub struct Defined<'a> {
    /// As written.
    pub view: CycleView<'a>,
    /// Its key.
    pub key: CycleKey,
    /// What the control knows of it.
    pub known: Known<'a>,
    /// The cycle as another control describes it, if this one does not.
    pub(in crate::check) elsewhere: Option<&'a Cycle>,
    /// Whether a line of it cannot be read.
    pub torn: bool,
    /// What is kept of a described cycle.
    pub(in crate::check) kept: Option<&'a Kept>,
    /// The languages whose name and labels it has letter by letter.
    pub(in crate::check) usual: LabelLanguages,
}

/// A cycle definition with its values.
pub struct Definition<'a> {
    own: &'a Defined<'a>,
    /// Its parameters or fields as written, those of described cycles with their specification.
    pub items: Vec<Item<'a>>,
    /// What a described cycle needs and the definition lacks.
    pub missing: Vec<&'a Param>,
    /// Whether every item is a parameter of the cycle and comes after those that the cycle names before it.
    pub(in crate::check) in_order: bool,
}

impl<'a> Deref for Definition<'a> {
    type Target = Defined<'a>;

    fn deref(&self) -> &Defined<'a> {
        self.own
    }
}

impl<'a> Defined<'a> {
    /// The cycle, if the control describes it.
    pub const fn cycle(&self) -> Option<&'a Cycle> {
        match self.known {
            Known::Described(cycle) => Some(cycle),
            _ => None,
        }
    }

    /// The cycle, or what another control describes under its number: enough to say what it is for.
    pub fn related_cycle(&self) -> Option<&'a Cycle> {
        self.cycle().or(self.elsewhere)
    }

    /// When the cycle acts, if that is known. All touch-probe cycles act when they are defined.
    pub fn takes_effect(&self) -> Option<TakesEffect> {
        match (self.related_cycle(), self.key.keyword) {
            (Some(cycle), _) => Some(cycle.file.takes_effect),
            (None, Keyword::TchProbe) => Some(TakesEffect::OnDefinition),
            _ => None,
        }
    }

    /// Whether its cycle calls the one that was defined last.
    pub(in crate::check) fn calls_last(&self) -> bool {
        match (self.cycle().zip(self.kept), self.elsewhere) {
            (Some((cycle, kept)), _) => kept.effect(cycle).calls_last(),
            (None, Some(cycle)) => cycle.file.group == Group::Patterns && Effect::of_cycle(cycle).calls_last(),
            (None, None) => false,
        }
    }

    /// The same definition, read as that of a cycle of another control.
    pub(in crate::check) fn read_as(&self, cycle: &'a Cycle) -> Self {
        Self {
            view: self.view.clone(),
            key: self.key,
            known: Known::Described(cycle),
            elsewhere: None,
            torn: self.torn,
            kept: None,
            usual: LabelLanguages::default(),
        }
    }

    /// The same definition, read as that of the cycle of another control that it is like, if this one does not have the
    /// cycle.
    pub(in crate::check) fn as_related_cycle(&self) -> Cow<'_, Self> {
        match self.elsewhere {
            Some(cycle) => Cow::Owned(self.read_as(cycle)),
            None => Cow::Borrowed(self),
        }
    }

    /// Whether its cycle has a parameter of that kind.
    pub(in crate::check) fn has_kind(&self, kind: ParameterKind) -> bool {
        match (self.cycle(), self.elsewhere) {
            (Some(_), _) => self.kept.is_some_and(|kept| kept.has_kind(kind)),
            (None, Some(cycle)) => cycle.params.iter().any(|param| param.kind == kind),
            (None, None) => false,
        }
    }
}

impl<'a> Definition<'a> {
    /// Reads a definition, without what depends on the run.
    pub(in crate::check) fn of(program: &'a Program, own: &'a Defined<'a>) -> Self {
        Self::begun(Vec::new(), program, own)
    }

    /// What is written for the parameter that has a meaning.
    pub(in crate::check) fn item(&self, meaning: &str) -> Option<&Item<'a>> {
        self.items.iter().find(|item| item.param.is_some_and(|param| param.is.as_str() == meaning))
    }

    /// The same with room for its items.
    pub(in crate::check) fn begun(mut room: Vec<Item<'a>>, program: &'a Program, own: &'a Defined<'a>) -> Self {
        room.clear();
        let mut definition = Self { own, items: room, missing: Vec::new(), in_order: false };
        match (&own.view.form, own.cycle()) {
            (CycleForm::Parameters(written), cycle) => definition.parameters(program, written, cycle),
            (CycleForm::Lines(lines), Some(cycle)) => {
                definition.missing = fields::matching(program, cycle, lines, &mut definition.items);
            }
            (CycleForm::Lines(_), None) => {}
        }
        definition
    }

    fn parameters(&mut self, program: &'a Program, written: &'a CycleDef, cycle: Option<&'a Cycle>) {
        self.items.reserve(written.parameters.len());
        let (mut place, mut last) = (Place::default(), None);
        self.in_order = cycle.is_some();
        for parameter in &written.parameters {
            let printed = program.slice(parameter.value.span);
            let index = cycle.and_then(|cycle| place.of(cycle, parameter.q));
            let param = cycle.zip(index).and_then(|(cycle, index)| cycle.params.get(index));
            self.in_order &= index.is_some() && last < index;
            last = index;
            self.items.push(Item {
                index,
                param,
                name: name_of(program, &parameter),
                span: parameter.span,
                value_span: parameter.value.span,
                printed: if printed.starts_with('"') { Cow::Borrowed(printed) } else { capitals(printed) },
                value: Some(parameter.value),
                number: None,
                label: parameter.label,
                refusal: None,
            });
        }
        let Some(cycle) = cycle else { return };
        if self.in_order && self.items.len() == cycle.params.len() {
            return;
        }
        let mut there = vec![false; cycle.params.len()];
        for index in self.items.iter().filter_map(|item| item.index) {
            there[index] = true;
        }
        let needed = |param: &Param| param.field.as_ref().is_none_or(|field| field.form == 0 && !field.optional);
        let missing = cycle.params.iter().zip(there).filter(|(param, there)| !there && needed(param));
        self.missing = missing.map(|(param, _)| param).collect();
    }
}

/// The parameter of a cycle that has a meaning.
pub(in crate::check) fn with_meaning<'c>(cycle: &'c Cycle, meaning: &str) -> Option<&'c Param> {
    cycle.params.iter().find(|param| param.is.as_str() == meaning)
}

/// The parameter as messages call it: as it is written, if that is how controls write it.
fn name_of<'a>(program: &'a Program, parameter: &Parameter) -> Cow<'a, str> {
    let written = program.slice(parameter.q_span);
    let usual = matches!(written.as_bytes(), [b'Q', b'1'..=b'9', ..] | [b'Q', b'L' | b'R' | b'S', b'1'..=b'9', ..]);
    if usual { Cow::Borrowed(written) } else { Cow::Owned(parameter.q.to_string()) }
}
