//! What the definition of a cycle does to the state, read off its specification once for all its definitions.
//!
//! Invariant: a cycle of which nothing is known may do anything.
use std::collections::HashMap;

use super::state::{Aspect, Known, Pending, State, Tri};
use super::step::{Values, pend};
use crate::base::expr::{Code, OnlyParameters, QKind, QRef, compile};
use crate::check::{Defined, Definition, Facts};
use crate::program::syntax::{CycleForm, CycleKeyword, CycleView, OldCycleLine, Program, ValueKind};
use crate::spec::{
    Action, Argument, Body, Cycle, CycleKey, Group, Item, Keyword, Known as Of, ParameterKind, TakesEffect,
    Transformation, Verb,
};

/// What the definitions of a cycle do.
#[derive(Debug, Default)]
pub(in crate::check) struct Deed {
    /// Anything may happen.
    anything: bool,
    /// A call means it from here on.
    pends: Option<bool>,
    aspects: Vec<(Aspect, Then)>,
    /// The parameters that it writes its results into.
    results: Vec<QRef>,
    /// Whether it keeps the data that other cycles share.
    keeps: bool,
    /// Whether it works with them.
    recalls: bool,
    /// Whether it calls the cycle that was defined last.
    calls_last: bool,
    /// Whether the spindle stands behind its call.
    stops_spindle: bool,
    /// Whether it aligns the turning system for the tool.
    aligns: bool,
    /// What it does to the basic rotation, in order.
    rotations: Vec<Rotates>,
    /// The values of parameters that the control lacks.
    lacking: Vec<(QRef, f64)>,
}

/// A change of the basic rotation.
#[derive(Debug)]
struct Rotates {
    /// Only if this holds; always where that needs more than parameters.
    when: Option<Code>,
    /// The row of the preset table that it goes to in the place of taking effect, if it is not 0.
    row: Option<Code>,
    /// The angle, if it is not measured.
    angle: Option<Code>,
    /// Whether it ends.
    ends: bool,
}

impl Rotates {
    fn of(strategy: &str, action: &Action) -> Option<Self> {
        let ends = strategy == "reset-basic-rotation";
        if !ends && !matches!(strategy, "write-basic-rotation" | "turn-basic-rotation") {
            return None;
        }
        let of = |name: &str| {
            let formula = action.with.0.iter().find(|(own, _)| own.as_str() == name);
            formula.and_then(|(_, formula)| compile(&formula.expr, &OnlyParameters).ok())
        };
        let when = action.when.as_ref().and_then(|formula| compile(&formula.expr, &OnlyParameters).ok());
        Some(Self { when, row: of("row"), angle: of("angle"), ends })
    }

    /// Whether a basic rotation is active then, from whether one was.
    fn then(&self, before: Tri, values: &Values<'_>) -> Tri {
        let happens = self.when.as_ref().map_or(Some(true), |code| code.truth(values).ok());
        let stored = self.row.as_ref().map_or(Some(false), |code| code.number(values).ok().map(|row| row != 0.0));
        let turned = match &self.angle {
            _ if self.ends => Tri::No,
            Some(code) => Tri::of(code.number(values).ok().map(|angle| angle != 0.0)),
            None => Tri::Yes,
        };
        match (happens, stored) {
            (Some(false), _) | (_, Some(true)) => before,
            (Some(true), Some(false)) => turned,
            _ => Tri::Unknown,
        }
    }
}

/// What becomes of an aspect.
#[derive(Clone, Copy, Debug)]
enum Then {
    Certain(Tri),
    /// The lines of the definition tell.
    Told,
}

impl From<Tri> for Then {
    fn from(tri: Tri) -> Self {
        Self::Certain(tri)
    }
}

/// What the definitions of a program do.
pub(super) struct Effects<'f, 'a> {
    program: &'a Program,
    definitions: &'f [Defined<'a>],
    /// The first block of each.
    firsts: Vec<u32>,
    /// What those of cycles do that are not described.
    others: HashMap<CycleKey, Deed>,
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
    pub(super) fn of(facts: &'f Facts<'a>) -> Self {
        let definitions = facts.definitions.as_slice();
        // No memory holds so many blocks that this is not enough.
        let firsts = definitions.iter().map(|own| u32::try_from(own.view.first).unwrap_or(u32::MAX)).collect();
        let (mut others, mut named) = (HashMap::new(), HashMap::new());
        for (index, definition) in definitions.iter().enumerate() {
            if definition.kept.is_none() {
                let known = definition.kin().map_or(definition.known, Of::Described);
                others.entry(definition.key).or_insert_with(|| Deed::of(known, definition.key.keyword));
            }
            let names = names(facts, definition);
            if !names.is_empty() {
                named.insert(index, names);
            }
        }
        Self { program: facts.program, definitions, firsts, others, named }
    }

    /// Whether a call of the definition of that index machines the workpiece.
    pub(super) fn cuts(&self, index: u32) -> bool {
        self.definitions.get(index as usize).is_some_and(|own| own.kin().is_some_and(removes_material))
    }

    /// Whether the spindle stands behind a call of the definition of that index.
    pub(super) fn stops_spindle(&self, index: u32) -> bool {
        self.definitions.get(index as usize).and_then(|own| self.deed(own)).is_some_and(|deed| deed.stops_spindle)
    }

    /// What the cycle of a definition does.
    fn deed(&self, definition: &Defined<'a>) -> Option<&Deed> {
        match (definition.kept, definition.cycle()) {
            (Some(kept), Some(cycle)) => Some(kept.deed(cycle)),
            _ => self.others.get(&definition.key),
        }
    }

    /// Does what the definition does that begins with a block.
    pub(super) fn apply(&self, block: usize, state: &mut State) {
        let found = u32::try_from(block).ok().and_then(|block| self.firsts.binary_search(&block).ok());
        let Some((index, definition)) = found.and_then(|index| Some((index, self.definitions.get(index)?))) else {
            return;
        };
        let Some(deed) = self.deed(definition) else { return };
        let named = self.named.get(&index).map_or(&[] as &[QRef], Vec::as_slice);
        let writes = !named.is_empty() || !deed.results.is_empty() || writes(&definition.view);
        if deed.anything || (definition.torn && !writes) {
            state.forget();
        }
        write(&definition.view, state);
        for q in named.iter().chain(&deed.results) {
            state.set(*q, Known::Unknown);
        }
        for (aspect, then) in &deed.aspects {
            let value = match then {
                Then::Certain(value) => *value,
                Then::Told => match changed(*aspect, &definition.view) {
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
        for rotates in &deed.rotations {
            let before = state.modal.is(Aspect::BasicRotation);
            let after = rotates.then(before, &Values(state, &deed.lacking));
            state.modal.set(Aspect::BasicRotation, after);
        }
        match deed.pends {
            Some(true) => pend(index, state),
            Some(false) => state.modal.pending = Pending::Unknown,
            None => {}
        }
    }
}

/// The strategy that reads what another cycle keeps.
const RECALL: &str = "recall-contour-data";

/// The name of the cycle that was defined last.
const LAST_CYCLE: &str = "last-cycle";

impl Deed {
    /// Whether the cycle keeps data that others share.
    pub(in crate::check) const fn keeps(&self) -> bool {
        self.keeps
    }

    /// Whether the cycle works with such data.
    pub(in crate::check) const fn recalls(&self) -> bool {
        self.recalls
    }

    /// Whether the cycle aligns the turning system for the tool.
    pub(in crate::check) const fn aligns(&self) -> bool {
        self.aligns
    }

    /// Whether the cycle calls the one that was defined last.
    pub(in crate::check) const fn calls_last(&self) -> bool {
        self.calls_last
    }

    /// What definitions of a described cycle do.
    pub(in crate::check) fn of_cycle(cycle: &Cycle) -> Self {
        Self::of(Of::Described(cycle), cycle.key.keyword)
    }

    /// What definitions of a cycle do.
    pub(in crate::check) fn of(known: Of<'_>, keyword: Keyword) -> Self {
        let mut deed = Self::default();
        match known {
            Of::Described(cycle) => deed.described(cycle),
            Of::Named(named) => {
                // Touch probe cycles act at once; of others nobody knows when.
                deed.pends = (keyword != Keyword::TchProbe).then_some(false);
                for aspect in
                    [Aspect::Feed, Aspect::Contour, Aspect::ContourData, Aspect::Pattern, Aspect::Compensation]
                {
                    deed.aspects.push((aspect, Tri::Unknown.into()));
                }
                match named.activates {
                    Some(transformation) => deed.aspects.push((aspect(transformation), Then::Told)),
                    None => {
                        for aspect in [Aspect::DatumShift, Aspect::Rotation] {
                            deed.aspects.push((aspect, Tri::Unknown.into()));
                        }
                    }
                }
            }
            Of::Builders | Of::Unknown => deed.anything = true,
        }
        deed
    }

    fn described(&mut self, cycle: &Cycle) {
        if probes(cycle) {
            self.aspects.push((Aspect::Probed, Tri::Yes.into()));
        }
        match cycle.file.takes_effect {
            TakesEffect::OnCall => self.pends = Some(true),
            TakesEffect::OnDefinition => self.aspects.push((Aspect::Feed, Tri::Unknown.into())),
        }
        self.results.extend(cycle.file.results.iter().filter_map(|results| results.q));
        self.lacking.clone_from(&cycle.lacking);
        let mut verbs = Vec::new();
        cycle.file.run.iter().for_each(|item| actions(item, &mut verbs));
        for action in verbs {
            match (action.verb, &action.argument) {
                (Verb::Transform, Argument::Many(entries)) => {
                    for (name, argument) in &entries.0 {
                        self.transforms(name.as_str(), argument);
                    }
                }
                (Verb::Remember, Argument::Many(entries)) => {
                    if entries.0.iter().any(|(name, _)| name.as_str() == "contour") {
                        self.aspects.push((Aspect::Contour, Tri::Yes.into()));
                    } else {
                        self.keeps = true;
                        self.aspects.push((Aspect::ContourData, Tri::Yes.into()));
                    }
                }
                (Verb::Call, Argument::One(name)) => self.calls_last |= name.as_str() == LAST_CYCLE,
                (Verb::Strategy, Argument::One(name)) => {
                    self.recalls |= name.as_str() == RECALL;
                    if let "align-turning-system" | "reset-turning-system" = name.as_str() {
                        let aligns = name.as_str().starts_with("align");
                        self.aligns |= aligns;
                        self.aspects.push((Aspect::Aligned, if aligns { Tri::Yes } else { Tri::Unknown }.into()));
                    }
                    self.rotations.extend(Rotates::of(name.as_str(), action));
                }
                (Verb::Spindle, Argument::One(name)) if cycle.file.takes_effect == TakesEffect::OnCall => {
                    self.stops_spindle |= name.as_str() == "stop";
                }
                (Verb::Spindle | Verb::Orient, _) if cycle.file.takes_effect == TakesEffect::OnDefinition => {
                    self.aspects.push((Aspect::Spindle, Tri::Unknown.into()));
                }
                _ => {}
            }
        }
    }

    fn transforms(&mut self, what: &str, argument: &Argument) {
        let aspect = match what {
            "datum-shift" => Aspect::DatumShift,
            "datum-row" => {
                self.aspects.push((Aspect::DatumShift, Tri::Unknown.into()));
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
                    self.aspects.push((Aspect::Compensation, Tri::No.into()));
                }
                return;
            }
            _ => {
                // A preset has a basic rotation of its own.
                for aspect in [Aspect::DatumShift, Aspect::Rotation, Aspect::BasicRotation] {
                    self.aspects.push((aspect, Tri::Unknown.into()));
                }
                return;
            }
        };
        self.aspects.push((aspect, Then::Told));
    }
}

/// Whether the spindle stands behind a call of a cycle.
pub(in crate::check) fn stops_spindle(cycle: &Cycle) -> bool {
    Deed::of_cycle(cycle).stops_spindle
}

/// Whether a cycle mills, drills or cuts threads.
pub(in crate::check) fn removes_material(cycle: &Cycle) -> bool {
    matches!(cycle.file.group, Group::Drilling | Group::Threads | Group::Pockets | Group::Contours | Group::Surfaces)
        && cycle.file.takes_effect == TakesEffect::OnCall
}

/// Whether a cycle touches the workpiece with a probe in the spindle.
pub(in crate::check) fn probes(cycle: &Cycle) -> bool {
    matches!(cycle.file.group, Group::Rotation | Group::Datum | Group::Measuring)
        && cycle.file.keyword == Keyword::TchProbe
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
fn names(facts: &Facts<'_>, definition: &Defined<'_>) -> Vec<QRef> {
    if !definition.has_kind(ParameterKind::QNumber) {
        return Vec::new();
    }
    let kin = definition.as_kin();
    let read = Definition::of(facts.program, &kin);
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

/// Whether a shift says how far it goes on from where the datum is.
fn is_incremental(program: &Program, view: &CycleView<'_>) -> bool {
    let CycleForm::Lines(lines) = &view.form else { return false };
    let words = lines.iter().flat_map(|line| &line.words);
    words.map(|word| program.slice(word.name)).any(|name| name.starts_with(['I', 'i']))
}

/// All actions of a step.
fn actions<'c>(item: &'c Item, found: &mut Vec<&'c Action>) {
    let body: &Body = &item.body;
    let cases = item.choose.iter().flat_map(|case| &case.actions);
    found.extend(body.actions.iter().chain(&item.then).chain(cases));
    body.items.iter().chain(&item.items).chain(&item.between).for_each(|inner| actions(inner, found));
}
