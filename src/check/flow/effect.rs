//! What the definition of a cycle does to the state, read off its specification once.
//!
//! Invariant: a cycle of which nothing is known may do anything.
use super::state::{Aspect, Known, State, Tri};
use super::step::pend;
use crate::check::Definition;
use crate::expr::{QKind, QRef};
use crate::spec::{
    Action, Argument, Body, Cycle, Item, Keyword, Known as Of, ParameterKind, TakesEffect, Transformation, Verb,
};
use crate::syntax::{CycleForm, CycleView, OldCycleLine, ValueKind};

/// What a definition does.
#[derive(Debug, Default)]
pub(super) struct Effect {
    /// Anything may happen.
    anything: bool,
    /// A call means it from here on.
    pends: Option<bool>,
    aspects: Vec<(Aspect, Tri)>,
    /// The parameters that it writes: those of the definition, with what is written for them.
    written: Vec<(QRef, Written)>,
}

#[derive(Clone, Copy, Debug)]
enum Written {
    Number(f64),
    Parameter(bool, QRef),
    Something,
}

impl Effect {
    pub(super) fn of(definition: &Definition<'_>) -> Self {
        let mut effect = Self { written: written(definition), ..Self::default() };
        match definition.known {
            Of::Described(cycle) => effect.described(definition, cycle),
            Of::Named(named) => {
                // Touch probe cycles act at once; of others nobody knows when.
                effect.pends = (definition.key.keyword != Keyword::TchProbe).then_some(false);
                effect.aspects.push((Aspect::Feed, Tri::Unknown));
                effect.aspects.push((Aspect::Contour, Tri::Unknown));
                effect.aspects.push((Aspect::Pattern, Tri::Unknown));
                effect.aspects.push((Aspect::Compensation, Tri::Unknown));
                match named.activates {
                    Some(transformation) => {
                        let aspect = aspect(transformation);
                        effect.aspects.push((aspect, changed(aspect, &definition.view)));
                    }
                    None => {
                        effect.aspects.extend([(Aspect::DatumShift, Tri::Unknown), (Aspect::Rotation, Tri::Unknown)])
                    }
                }
            }
            Of::Builders | Of::Unknown => effect.anything = true,
        }
        effect.anything |= definition.torn && effect.written.is_empty();
        effect
    }

    fn described(&mut self, definition: &Definition<'_>, cycle: &Cycle) {
        match cycle.file.takes_effect {
            TakesEffect::OnCall => self.pends = Some(true),
            TakesEffect::OnDefinition => self.aspects.push((Aspect::Feed, Tri::Unknown)),
        }
        for results in &cycle.file.results {
            if let Some(q) = results.q {
                self.written.push((q, Written::Something));
            }
        }
        let mut verbs = Vec::new();
        cycle.file.run.iter().for_each(|item| actions(item, &mut verbs));
        for action in verbs {
            match (action.verb, &action.argument) {
                (Verb::Transform, Argument::Many(entries)) => {
                    for (name, argument) in &entries.0 {
                        self.transforms(name.as_str(), argument, definition);
                    }
                }
                (Verb::Remember, Argument::Many(entries)) => {
                    if entries.0.iter().any(|(name, _)| name.as_str() == "contour") {
                        self.aspects.push((Aspect::Contour, Tri::Yes));
                    }
                }
                (Verb::Strategy, Argument::One(name)) if name.as_str() == "call-program" => self.anything = true,
                (Verb::Spindle | Verb::Orient, _) if cycle.file.takes_effect == TakesEffect::OnDefinition => {
                    self.aspects.push((Aspect::Spindle, Tri::Unknown));
                }
                _ => {}
            }
        }
    }

    fn transforms(&mut self, what: &str, argument: &Argument, definition: &Definition<'_>) {
        let aspect = match what {
            "datum-shift" => Aspect::DatumShift,
            "datum-row" => {
                self.aspects.push((Aspect::DatumShift, Tri::Unknown));
                return;
            }
            "mirroring" => Aspect::Mirroring,
            "rotation" => Aspect::Rotation,
            "scaling" => Aspect::Scaling,
            "axis-scaling" => Aspect::AxisScaling,
            "tilting" => Aspect::Tilting,
            "cancel" => {
                let cancels =
                    |word: &Argument| matches!(word, Argument::One(name) if name.as_str() == "radius-compensation");
                if matches!(argument, Argument::List(words) if words.iter().any(cancels)) {
                    self.aspects.push((Aspect::Compensation, Tri::No));
                }
                return;
            }
            _ => {
                for aspect in [Aspect::DatumShift, Aspect::Rotation] {
                    self.aspects.push((aspect, Tri::Unknown));
                }
                return;
            }
        };
        self.aspects.push((aspect, changed(aspect, &definition.view)));
    }

    /// Does it; `index` is that of the definition.
    pub(super) fn apply(&self, index: usize, state: &mut State) {
        if self.anything {
            state.forget();
        }
        let read = |written: Written| match written {
            Written::Number(number) => Known::Number(number),
            Written::Parameter(negative, q) => match state.get(q) {
                Known::Number(number) => Known::Number(if negative { -number } else { number }),
                _ => Known::Unknown,
            },
            Written::Something => Known::Unknown,
        };
        // All are read before the first one is written.
        let values: Vec<(QRef, Known)> = self.written.iter().map(|(q, written)| (*q, read(*written))).collect();
        for (q, value) in values {
            state.set(q, value);
        }
        for (aspect, value) in &self.aspects {
            state.modal.set(*aspect, *value);
        }
        match self.pends {
            Some(true) => pend(index, state),
            Some(false) => state.modal.pending = super::state::Pending::Unknown,
            None => {}
        }
    }
}

/// What a definition writes into parameters: its own, and those whose numbers it is given.
fn written(definition: &Definition<'_>) -> Vec<(QRef, Written)> {
    let mut all = Vec::new();
    match &definition.view.form {
        CycleForm::Parameters(cycle) => {
            for parameter in &cycle.parameters {
                let value = match parameter.value.kind {
                    ValueKind::Number(number) if number.is_finite() => Written::Number(number),
                    ValueKind::Q { negative, q } if q.kind != QKind::Qs => Written::Parameter(negative, q),
                    _ => Written::Something,
                };
                all.push((parameter.q, value));
            }
        }
        CycleForm::Lines(lines) => {
            for word in lines.iter().flat_map(|line| &line.words) {
                // A result may go there.
                if let (Keyword::TchProbe, ValueKind::Q { q, .. }) = (definition.key.keyword, word.value.kind) {
                    all.push((q, Written::Something));
                }
            }
        }
    }
    for item in &definition.items {
        let names = item.param.is_some_and(|param| param.kind == ParameterKind::QNumber);
        match item.value.map(|value| value.kind) {
            Some(ValueKind::Number(number)) if names => {
                // The value is the number of a parameter, so it is a small whole number.
                let number = if (0.0..65536.0).contains(&number) { number as u16 } else { 0 };
                all.push((QRef::q(number), Written::Something));
            }
            Some(ValueKind::Q { q, .. }) if names => all.push((q, Written::Something)),
            _ => {}
        }
    }
    all
}

fn aspect(transformation: Transformation) -> Aspect {
    match transformation {
        Transformation::Mirroring => Aspect::Mirroring,
        Transformation::Scaling => Aspect::Scaling,
        Transformation::AxisScaling => Aspect::AxisScaling,
        Transformation::Tilting => Aspect::Tilting,
        Transformation::Turning => Aspect::Turning,
    }
}

/// Whether the lines of a transformation switch it on: with values that are not neutral, or axes for a mirror image.
fn changed(aspect: Aspect, view: &CycleView<'_>) -> Tri {
    let CycleForm::Lines(lines) = &view.form else { return Tri::Unknown };
    let neutral = match aspect {
        Aspect::Scaling | Aspect::AxisScaling => 1.0,
        _ => 0.0,
    };
    let words = |line: &&&OldCycleLine| line.line > 0;
    let mut values = lines.iter().filter(words).flat_map(|line| &line.words).map(|word| word.value.kind);
    if aspect == Aspect::Mirroring {
        return Tri::of(Some(values.next().is_some()));
    }
    let (mut found, mut neutral_seen) = (Tri::No, false);
    for value in values {
        match value {
            // Among the factors of axes there may be a centre.
            ValueKind::Number(number) if number == neutral => neutral_seen = true,
            ValueKind::Number(_) if aspect != Aspect::AxisScaling => return Tri::Yes,
            ValueKind::Number(_) => found = if neutral_seen { Tri::Unknown } else { Tri::Yes },
            _ => found = Tri::Unknown,
        }
    }
    found
}

/// All actions of a step.
fn actions<'c>(item: &'c Item, found: &mut Vec<&'c Action>) {
    let body: &Body = &item.body;
    let cases = item.choose.iter().flat_map(|case| &case.actions);
    found.extend(body.actions.iter().chain(&item.then).chain(cases));
    body.items.iter().chain(&item.items).chain(&item.between).for_each(|inner| actions(inner, found));
}
