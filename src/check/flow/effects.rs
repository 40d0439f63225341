//! What the definitions of a program do to the state of the control.
use std::collections::HashMap;

use super::state::{Known, Pending, State, Values};
use crate::base::diag::Span;
use crate::base::expr::{QKind, QRef};
use crate::check::cycle::{Aspect, Effect, Then, Tri, removes_material};
use crate::check::program::{Defined, Definition, Reading, Work};
use crate::program::syntax::{CycleForm, CycleKeyword, CycleView, NamedWord, OldCycleLine, Program, ValueKind};
use crate::spec::{CycleKey, Known as Of, ParameterKind};

/// What the definitions of a program do.
pub(super) struct Effects<'f, 'a> {
    program: &'a Program,
    definitions: &'f [Defined<'a>],
    /// The first block of each.
    firsts: Vec<u32>,
    /// What those of cycles do that are not described.
    others: HashMap<CycleKey, Effect>,
    /// The parameters that definitions name as those that they write to.
    named: HashMap<usize, Vec<QRef>>,
}

#[derive(Clone, Copy, Debug)]
enum Written {
    Number(f64),
    Parameter(bool, QRef),
    Something,
}

impl<'f, 'a> Effects<'f, 'a> {
    pub(super) fn of(reading: &'f Reading<'a>) -> Self {
        let definitions = reading.definitions.as_slice();
        // No memory holds so many blocks that this is not enough.
        let firsts = definitions.iter().map(|own| u32::try_from(own.view.first).unwrap_or(u32::MAX)).collect();
        let (mut others, mut named) = (HashMap::new(), HashMap::new());
        for (index, definition) in definitions.iter().enumerate() {
            if definition.kept.is_none() {
                let known = definition.related_cycle().map_or(definition.known, Of::Described);
                others.entry(definition.key).or_insert_with(|| {
                    let works = Work::of(reading.program, definition).is_some();
                    let mut effect = Effect::of(known, definition.key.keyword, is_old(definition) || works);
                    if works {
                        effect.pends = Some(true);
                    }
                    effect
                });
            }
            let names = names(reading, definition);
            if !names.is_empty() {
                named.insert(index, names);
            }
        }
        Self { program: reading.program, definitions, firsts, others, named }
    }

    /// Whether a call of the definition of that index machines the workpiece.
    pub(super) fn cuts(&self, index: u32) -> bool {
        let works = |own: &Defined<'a>| Work::of(self.program, own).is_some();
        let removes = |own: &Defined<'a>| own.related_cycle().is_some_and(removes_material) || works(own);
        self.definitions.get(index as usize).is_some_and(removes)
    }

    /// Whether the definition of that index is one of an early cycle that taps and turns the spindle itself.
    pub(super) fn taps_rigidly(&self, index: u32) -> bool {
        let own = self.definitions.get(index as usize);
        own.and_then(|own| Work::of(self.program, own)) == Some(Work::RigidTapping)
    }

    /// Whether the spindle is stopped after a call of the definition of that index.
    pub(super) fn stops_spindle(&self, index: u32) -> bool {
        self.definitions.get(index as usize).and_then(|own| self.effect(own)).is_some_and(|effect| effect.stops_spindle)
    }

    /// The place of the definition that begins with a block, if its cycle calls the one before it: a pattern.
    pub(super) fn pattern_at(&self, block: usize) -> Option<Span> {
        let at = self.firsts.binary_search(&u32::try_from(block).ok()?).ok()?;
        self.definitions.get(at).filter(|own| own.calls_last()).map(|own| own.view.head)
    }

    /// What the cycle of a definition does.
    fn effect(&self, definition: &Defined<'a>) -> Option<&Effect> {
        match (definition.kept, definition.cycle()) {
            (Some(kept), Some(cycle)) => Some(kept.effect(cycle)),
            _ => self.others.get(&definition.key),
        }
    }

    /// Does what the definition does that begins with a block.
    pub(super) fn apply(&self, block: usize, state: &mut State) {
        let found = u32::try_from(block).ok().and_then(|block| self.firsts.binary_search(&block).ok());
        let Some((index, definition)) = found.and_then(|index| Some((index, self.definitions.get(index)?))) else {
            return;
        };
        let Some(effect) = self.effect(definition) else { return };
        let named = self.named.get(&index).map_or(&[] as &[QRef], Vec::as_slice);
        let writes = !named.is_empty() || !effect.results.is_empty() || writes(&definition.view);
        if effect.anything || (definition.torn && !writes) {
            state.forget();
        }
        write(&definition.view, state);
        for q in named.iter().chain(&effect.results) {
            state.set(*q, Known::Unknown);
        }
        let shift = self.shift(&definition.view, effect, state);
        for (aspect, then) in &effect.aspects {
            // What it names is known better than what its cycle may do.
            if shift.is_some() && *aspect == Aspect::DatumShift {
                continue;
            }
            let value = match then {
                Then::Certain(value) => *value,
                Then::Written => match changed(*aspect, &definition.view) {
                    // What an incremental shift adds to another one may take it back.
                    Tri::Yes
                        if *aspect == Aspect::DatumShift
                            && state.modal.is(*aspect) != Tri::No
                            && is_incremental(self.program, &definition.view) =>
                    {
                        Tri::Unknown
                    }
                    value => value,
                },
            };
            state.modal.set(*aspect, value);
        }
        if let Some(axes) = shift {
            state.modal.shift(axes);
        }
        for rotates in &effect.rotations {
            let before = state.modal.is(Aspect::BasicRotation);
            let after = rotates.then(before, &Values(state, &effect.lacking));
            state.modal.set(Aspect::BasicRotation, after);
        }
        match effect.pends {
            Some(true) => state.pend(index),
            Some(false) => state.modal.pending = Pending::Unknown,
            None => {}
        }
    }

    /// What a definition that shifts the datum does along the axes that it names.
    fn shift(&self, view: &CycleView<'_>, effect: &Effect, state: &State) -> Option<[Option<Tri>; 3]> {
        let written = |(aspect, then): &(Aspect, Then)| *aspect == Aspect::DatumShift && matches!(then, Then::Written);
        let CycleForm::Lines(lines) = &view.form else { return None };
        let words = lines.iter().filter(|line| line.line > 0).flat_map(|line| &line.words);
        if effect.aspects.iter().any(written) { shifted(self.program, words, state) } else { None }
    }
}

/// Whether a definition writes into parameters of its own.
fn writes(view: &CycleView<'_>) -> bool {
    match &view.form {
        CycleForm::Parameters(cycle) => !cycle.parameters.is_empty(),
        CycleForm::Lines(_) => results_in_lines(view).next().is_some(),
    }
}

/// The parameters that lines name: a result may go there.
fn results_in_lines<'v>(view: &'v CycleView<'_>) -> impl Iterator<Item = QRef> + 'v {
    let lines = match &view.form {
        CycleForm::Lines(lines) if view.keyword == CycleKeyword::TchProbe => lines.as_slice(),
        _ => &[],
    };
    lines.iter().flat_map(|line| &line.words).filter_map(|word| match word.value.kind {
        ValueKind::Q { q, .. } => Some(q),
        _ => None,
    })
}

/// Writes what a definition writes into its parameters.
fn write(view: &CycleView<'_>, state: &mut State) {
    let CycleForm::Parameters(cycle) = &view.form else {
        // Those that follow the parameter take the other coordinates and whether the probe has touched (001: 13702).
        for q in results_in_lines(view) {
            (q.number..q.number.saturating_add(4)).for_each(|number| state.set(QRef { number, ..q }, Known::Unknown));
        }
        return;
    };
    let written = |kind: ValueKind| match kind {
        ValueKind::Number(number) if number.is_finite() => Written::Number(number),
        ValueKind::Q { negative, q } if q.kind != QKind::Qs => Written::Parameter(negative, q),
        _ => Written::Something,
    };
    let read = |written: Written, state: &State| match written {
        Written::Number(number) => Known::Number(number),
        Written::Parameter(negative, q) => match state.get(q) {
            Known::Number(number) => Known::Number(if negative { -number } else { number }),
            _ => Known::Unknown,
        },
        Written::Something => Known::Unknown,
    };
    // All are read before the first one is written: those that read others wait for those before them.
    let (mut waits, mut early) = (Vec::new(), false);
    cycle.parameters.each_value(|_, kind| early |= matches!(kind, ValueKind::Q { .. }));
    cycle.parameters.each_value(|q, kind| match read(written(kind), state) {
        value if early => waits.push((q, value)),
        value => state.set(q, value),
    });
    waits.into_iter().for_each(|(q, value)| state.set(q, value));
}

/// The parameters whose numbers a definition is given.
fn names(reading: &Reading<'_>, definition: &Defined<'_>) -> Vec<QRef> {
    if !definition.has_kind(ParameterKind::QNumber) {
        return Vec::new();
    }
    let related = definition.as_related_cycle();
    let read = Definition::of(reading.program, &related);
    let named = read.items.iter().filter(|item| item.param.is_some_and(|own| own.kind == ParameterKind::QNumber));
    named
        .filter_map(|item| match item.value.map(|value| value.kind) {
            Some(ValueKind::Number(number)) => {
                // The value is the number of a parameter, so it is a small whole number.
                Some(QRef::q(if (0.0..65536.0).contains(&number) { number as u16 } else { 0 }))
            }
            Some(ValueKind::Q { q, .. }) => Some(q),
            _ => None,
        })
        .collect()
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

/// What a shift does along the axes that it names; nothing if it names none or others as well.
pub(super) fn shifted<'w>(
    program: &Program,
    words: impl Iterator<Item = &'w NamedWord>,
    state: &State,
) -> Option<[Option<Tri>; 3]> {
    let mut axes = [None; 3];
    for word in words {
        let name = program.slice(word.name).trim().to_ascii_uppercase();
        let (incremental, name) = match name.strip_prefix('I') {
            Some(axis) => (true, axis),
            None => (false, name.as_str()),
        };
        let place = Aspect::SHIFTS.iter().position(|(_, axis)| *axis == name)?;
        let number = match word.value.kind {
            ValueKind::Number(number) => Some(number),
            ValueKind::Q { q, .. } => match state.get(q) {
                Known::Number(number) => Some(number),
                Known::Unset | Known::Unknown => None,
            },
            _ => return None,
        };
        let zero = number.map(|number| number == 0.0);
        axes[place] = Some(match (incremental, state.modal.is(Aspect::SHIFTS[place].0), zero) {
            // What an incremental shift adds to another one may take it back.
            (true, before, Some(true)) => before,
            (true, Tri::No, Some(false)) | (false, _, Some(false)) => Tri::Yes,
            (false, _, Some(true)) => Tri::No,
            _ => Tri::Unknown,
        });
    }
    axes.iter().any(Option::is_some).then_some(axes)
}

/// Whether a shift says how far it goes on from where the datum is.
fn is_incremental(program: &Program, view: &CycleView<'_>) -> bool {
    let CycleForm::Lines(lines) = &view.form else { return false };
    let words = lines.iter().flat_map(|line| &line.words);
    words.map(|word| program.slice(word.name)).any(|name| name.starts_with(['I', 'i']))
}

/// Whether a definition has numbered lines.
const fn is_old(definition: &Defined<'_>) -> bool {
    matches!(definition.view.form, CycleForm::Lines(_))
}
