//! Definitions of cycles: values of parameters and old-style fields, guards, and when the cycle acts.
//!
//! Invariant: the values of new-form parameters are the program's Q parameters; fields of the old form belong to
//! the definition.
use std::sync::Arc;

use crate::base::expr::{QKind, QRef};
use crate::engine::flow::definition::Definition;
use crate::engine::flow::definition::FieldCoord;
use crate::engine::flow::definition::FieldValue;
use crate::engine::flow::state::Run;
use crate::engine::geometry::RotaryAxis;
use crate::engine::motion::axis::linear;
use crate::engine::motion::axis::rotary;
use crate::engine::motion::moves::RAPID_FEED;
use crate::engine::params::Content;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::{Class, Fault};
use crate::program::fields::{self, first, stands_on};
use crate::program::syntax::{
    Axis, CycleDef, CycleForm, CycleView, NamedWord, OldCycleLine, Parameter, Value, ValueKind,
};
use crate::spec::{
    self, Combined, Cycle, CycleKey, Group, Keyword, Known, OnControl, Param, ParameterKind, Quantity, Shape,
    TakesEffect, Transformation,
};

/// The values of a definition that are not Q parameters.
struct Values {
    form: Option<usize>,
    fields: Vec<(Arc<str>, FieldValue)>,
}

impl<'e> Run<'_, 'e> {
    /// The definition that begins at the block being executed.
    pub(super) fn definition_here(&self) -> Option<usize> {
        self.calls.here()?.definition(self.calls.block)
    }

    /// Executes the definition that begins here.
    pub(super) fn define_here(&mut self) -> Done {
        let Some(index) = self.definition_here() else { return Ok(()) };
        let Some(view) = self.calls.here().and_then(|program| program.cycles.get(index).cloned()) else {
            return Ok(());
        };
        self.calls.next = view.last + 1;
        let key = fields::key(view.keyword, view.number);
        self.drives.report.at_mut().cycle = Some((key, None));
        let known = self.known(key);
        if known.is_err() && self.transformation(key).is_some() {
            return self.activate(key, &view);
        }
        let of_lines = matches!(view.form, CycleForm::Lines(_)) && self.settings.only_assumes();
        let machines = key.keyword == Keyword::CyclDef && !key.is_builders() && self.settings.after_faults;
        if (of_lines || machines) && known.as_ref().is_err_and(is_undescribed) {
            // It would machine when it is called: what, no one knows.
            (self.cycles.last, self.cycles.passed_over, self.modal.call_always) = (None, true, false);
            self.pass_over();
            return Ok(());
        }
        let (cycle, on) = known?;
        let plan = self.cycles.plan(cycle, on, &self.settings.watching)?;
        let definition = match view.form {
            CycleForm::Parameters(parameters) => self.parameters(parameters, cycle)?,
            CycleForm::Lines(lines) => self.lines(cycle, &lines)?,
        };
        let Values { form, fields } = definition;
        let unit = self.drives.unit();
        self.cycles.definitions += 1;
        let definition = Definition { id: self.cycles.definitions, cycle, on, plan, unit, form, fields };
        self.at_definition(&definition)?;
        if cycle.file.takes_effect == TakesEffect::OnDefinition {
            self.combination(cycle)?;
            return self.execute(&definition);
        }
        self.modal.call_always = false;
        self.cycles.last = Some(Arc::new(definition));
        Ok(())
    }

    /// A pattern calls only cycles that its manual lists, and not with a value that it excludes.
    fn combination(&self, pattern: &Cycle) -> Done {
        let (combines, Some(last)) = (&pattern.file.combines, &self.cycles.last) else { return Ok(()) };
        if combines.is_empty() {
            return Ok(());
        }
        let refused = Fault::program("pattern-combination")
            .arg("cycle", pattern.key.to_string())
            .arg("called", last.cycle.key.to_string());
        match combines.iter().find(|listed| listed.cycle == last.cycle.key.number) {
            None => Err(refused.arg("what", "cycle").into()),
            Some(Combined { q: Some(q), not: Some(not), .. })
                if self.params.number(*q).is_ok_and(|own| own == *not) =>
            {
                Err(refused.arg("what", "value").arg("value", format!("{q}={not}")).into())
            }
            Some(_) => Ok(()),
        }
    }

    /// The description of a cycle, and the control that it is for. A cycle that this control's manual only names is
    /// taken from another control; so is one that it lacks, in a run that goes on after faults.
    fn known(&self, key: CycleKey) -> Result<(&'e Cycle, &'e OnControl), Fault> {
        let on = self.settings.on;
        let about = |fault: Fault| fault.arg("cycle", key.to_string()).arg("control", on.id());
        match on.known(key) {
            Known::Described(cycle) => Ok((cycle, on)),
            Known::Builders => Err(about(Fault::unsupported("unsupported-cycle"))),
            Known::Unknown if !self.settings.after_faults => Err(about(Fault::unsupported("cycle-unknown"))),
            Known::Named(_) | Known::Unknown => {
                let others = self.settings.others_on.iter();
                let described = |other: &&'e OnControl| other.cycles.get(&key).map(|cycle| (cycle, *other));
                let found = others.clone().find_map(described);
                found.ok_or_else(|| about(Fault::unsupported("unsupported-cycle")))
            }
        }
    }

    /// What the definition of a cycle brings into effect that the engine does not execute, whether a specification
    /// describes it or not, on any control: a manual that does not name a transformation has no other one of that
    /// number.
    fn transformation(&self, key: CycleKey) -> Option<Transformation> {
        let all = std::iter::once(&self.settings.on).chain(&self.settings.others_on);
        all.into_iter().find_map(|on| on.named(key).and_then(|named| named.activates))
    }

    /// A transformation that the engine only knows to be in effect: no values after the first line, or neutral
    /// ones, end it.
    fn activate(&mut self, key: CycleKey, view: &CycleView<'_>) -> Done {
        let Some(transformation) = self.transformation(key) else { return Ok(()) };
        let neutral = match transformation {
            Transformation::Scaling | Transformation::AxisScaling => 1.0,
            Transformation::Mirroring | Transformation::Turning => f64::NAN,
            Transformation::Tilting => 0.0,
        };
        let mut acts = false;
        if let CycleForm::Lines(lines) = &view.form {
            // A feed, a clearance or a centre next to the values of the axes does not make it act.
            let by_axis = transformation != Transformation::Scaling;
            for word in lines.iter().flat_map(|line| &line.words) {
                let name = self.slice(word.name).trim().to_ascii_uppercase();
                if !by_axis || axis_of(&name).is_some() {
                    acts |= match word.value.kind {
                        ValueKind::Number(_) | ValueKind::Q { .. } => self.number_of(&word.value)? != neutral,
                        _ => true,
                    };
                }
            }
        }
        let active = &mut self.drives.world.system.unexecuted;
        if acts {
            active.insert(transformation)
        } else {
            active.remove(&transformation)
        };
        Ok(())
    }

    fn parameters(&mut self, written: &CycleDef, cycle: &Cycle) -> Done<Values> {
        if let Some(error) = written.errors.first() {
            let found = self.slice(error.span).trim().to_owned();
            return Err(Fault::program("block-unreadable").arg("found", found).into());
        }
        if cycle.is_old_style() {
            let fault =
                Fault::program("field-missing").arg("field", cycle.params.first().map_or("", |p| p.is.as_str()));
            return Err(fault.arg("cycle", cycle.key.to_string()).into());
        }
        // A fault that names a parameter, such as one without a value, means that one.
        let of_cycle = |fault: Fault, q: QRef| {
            let named = fault.args.iter().any(|(name, _)| *name == "q");
            let fault = if named { fault } else { fault.arg("q", q.to_string()) };
            fault.arg("cycle", cycle.key.to_string())
        };
        // One in addition to all that the cycle has may be a later version's: the program need not be wrong.
        let has = |q: QRef| written.parameters.iter().any(|own| own.q == q);
        let mut needed = cycle.params.iter().filter_map(|param| Some((param.q?, param.q_of_name())));
        let whole = needed.all(|(q, name)| has(q) || name.is_some_and(has));
        let assumes = self.settings.after_faults;
        for parameter in &written.parameters {
            // In a run that only assumes, what is 0 is taken for switched off.
            let off = whole && self.settings.only_assumes() && parameter.value.kind == ValueKind::Number(0.0);
            if cycle.written(parameter.q).is_none() && !(off || assumes) {
                let fault = match whole {
                    true => Fault::unsupported("parameter-in-addition"),
                    false => Fault::program("parameter-unknown"),
                };
                return Err(of_cycle(fault, parameter.q).into());
            }
        }
        let missing = |q: QRef| of_cycle(Fault::program("parameter-missing"), q);
        let mut copied = Vec::new();
        for param in &cycle.params {
            let Some(q) = param.q else { continue };
            let is_it = |parameter: &Parameter| parameter.q == q || param.q_of_name() == Some(parameter.q);
            let found = written.parameters.iter().rev().find(is_it);
            let content = match found {
                Some(parameter) => self.parameter_value(param, &parameter).map_err(|fault| of_cycle(fault, q))?,
                None => match param.supplied() {
                    Some(value) => match QRef::parse(&value) {
                        // It takes the value of a parameter that is written, which may come later.
                        Some(other) => {
                            copied.push((param, q, other));
                            continue;
                        }
                        None => Content::Number(value.parse().map_err(|_| missing(q))?),
                    },
                    None if assumes && may_be_assumed(param) => Content::Number(0.0),
                    None => return Err(missing(q).into()),
                },
            };
            self.give(param, q, content)?;
        }
        for (param, q, other) in copied {
            let value = self.params.number(other)?;
            self.give(param, q, Content::Number(value))?;
        }
        Ok(Values { form: None, fields: Vec::new() })
    }

    /// Writes a transfer parameter. The name of a tool goes into the text parameter of the same number, and its
    /// number where one belongs.
    fn give(&mut self, param: &Param, q: QRef, content: Content) -> Done {
        if let (Content::Text(name), ParameterKind::NumberOrName) = (&content, param.kind) {
            let number = self.drives.world.tool_named(name)?;
            self.set(QRef { kind: QKind::Qs, number: q.number }, content)?;
            let Some(number) = number else {
                // A number from before would mean another tool.
                self.params.forget(q);
                return Ok(());
            };
            return Ok(self.set(q, Content::Number(number))?);
        }
        if let (Content::Number(_), Some(name)) = (&content, param.q_of_name()) {
            // A name from before would mean something else.
            self.params.forget(name);
        }
        Ok(self.set(q, content)?)
    }

    fn parameter_value(&self, param: &Param, parameter: &Parameter) -> Result<Content, Fault> {
        let value = &parameter.value;
        let textual = parameter.q.kind == QKind::Qs;
        let content = match value.kind {
            ValueKind::Text(span) if textual => Content::Text(self.slice(span).into()),
            ValueKind::Q { q, negative: false } if q.kind == QKind::Qs && textual => {
                Content::Text(self.params.text(q)?)
            }
            ValueKind::Word => Content::Number(self.word_value(param, value)?),
            ValueKind::Missing => return Err(Fault::program("value-missing")),
            _ => Content::Number(self.number_of(value)?),
        };
        match &content {
            Content::Number(_) if textual => Err(Fault::program("text-or-number")),
            Content::Number(number)
                if !matches!(value.kind, ValueKind::Word)
                    && !self.settings.after_faults
                    && spec::number_refusal_in(param, *number, self.drives.unit()).is_some() =>
            {
                Err(Fault::program("parameter-out-of-range").arg("value", *number))
            }
            _ => Ok(content),
        }
    }

    /// The number that a word stands for at the moment of the definition.
    fn word_value(&self, param: &Param, value: &Value) -> Result<f64, Fault> {
        let written = self.slice(value.span).trim().to_ascii_uppercase();
        let letters = written.bytes().take_while(u8::is_ascii_alphabetic).count();
        // The letter of a Q parameter is no part of the word.
        let letters = if written.get(..2).is_some_and(|word| matches!(word, "FU" | "FZ")) { 2 } else { letters };
        let (word, number) = written.split_at(letters);
        // Controls show the word without its letter: `Q207= AUTO`.
        let word = match (word, number.trim()) {
            ("AUTO", _) | ("F", "AUTO") => "FAUTO",
            ("MAX", _) | ("F", "MAX") => "FMAX",
            _ => word,
        };
        // What GLOBAL DEF gives a cycle may take whether or not its list of parameters prints the word.
        let is_given = word == "PREDEF" && param.q.is_some_and(|q| self.cycles.predefined.contains_key(&q.number));
        if !is_given && !param.words.iter().any(|known| known == word) {
            return Err(Fault::program("word-not-offered").arg("word", word));
        }
        let speed = self.drives.switched.spindle.speed;
        match word {
            "FAUTO" => {
                self.modal.tool_feed.map(|feed| feed / self.drives.unit()).ok_or_else(|| Fault::program("feed-missing"))
            }
            "FMAX" => Ok(RAPID_FEED),
            "FU" => Ok(self.written_number(number)? * speed),
            "FZ" => Ok(self.written_number(number)? * speed * self.drives.world.tool().map_or(0.0, |tool| tool.teeth)),
            "PREDEF" => {
                let known = param.q.and_then(|q| self.cycles.predefined.get(&q.number));
                let (value, unit) = known.copied().ok_or_else(|| Fault::program("value-not-predefined"))?;
                // A program called by another one may be in the other unit.
                let value = if unit == self.drives.unit() || !param.is_measured() {
                    value
                } else {
                    value * unit / self.drives.unit()
                };
                match spec::number_refusal_in(param, value, self.drives.unit()) {
                    None => Ok(value),
                    Some(_) => Err(Fault::program("parameter-out-of-range").arg("value", value)),
                }
            }
            _ => Err(Fault::program("word-not-offered").arg("word", word)),
        }
    }

    fn lines(&self, cycle: &Cycle, lines: &[&OldCycleLine]) -> Done<Values> {
        let unreadable = |found: &str| {
            let fault = Fault::program("field-unknown").arg("found", found.trim());
            fault.arg("cycle", cycle.key.to_string())
        };
        if !cycle.is_old_style() {
            return Err(unreadable(lines.first().map_or("", |line| self.slice(line.head))).into());
        }
        let mut first_misfit = None;
        for form in 0..cycle.file.forms.len() {
            match self.fields_of_form(cycle, form, lines)? {
                Ok(fields) => {
                    let known = |id: &str| fields.iter().any(|(field, _)| **field == *id);
                    let missing = cycle.fields(form).find(|(_, field)| !field.optional && !known(field.id.as_str()));
                    if let Some((_, field)) = missing {
                        let fault = Fault::program("field-missing").arg("field", field.id.as_str());
                        return Err(fault.arg("cycle", cycle.key.to_string()).into());
                    }
                    return Ok(Values { form: Some(form), fields });
                }
                Err(misfit) => first_misfit = first_misfit.or(Some(misfit)),
            }
        }
        Err(unreadable(first_misfit.map_or("", |word: NamedWord| self.slice(word.span))).into())
    }

    /// The fields of the lines as that form reads them, or the first word that it cannot.
    #[expect(clippy::type_complexity, reason = "the inner error is the word that does not fit")]
    fn fields_of_form(
        &self,
        cycle: &Cycle,
        form: usize,
        lines: &[&OldCycleLine],
    ) -> Result<Result<Vec<(Arc<str>, FieldValue)>, NamedWord>, Fault> {
        let mut fields: Vec<(Arc<str>, FieldValue)> = Vec::new();
        let Some(prepared) = self.calls.here() else { return Ok(Ok(fields)) };
        for line in lines {
            let mut expected: Vec<(&Param, &spec::Field)> =
                cycle.fields(form).filter(|(_, field)| stands_on(field, line)).collect();
            let mut words = line.words.as_slice();
            while let Some(word) = words.first() {
                let found = first(prepared.program, expected.iter().map(|(_, field)| *field), words);
                let own = found.and_then(|(at, count)| expected.drain(..=at).next_back().zip(Some(count)));
                let Some(((param, field), count)) = own else { return Ok(Err(*word)) };
                let (own, rest) = words.split_at(count.min(words.len()));
                for word in own {
                    if !is_valued(word, self.slice(word.value.span).trim(), param, field) {
                        return Ok(Err(*word));
                    }
                    let value = self.field_value(word, (param, field), cycle.file.group == Group::Digitizing)?;
                    match (fields.iter_mut().find(|(id, _)| *id == field.id.text), value) {
                        (Some((_, FieldValue::Coords(all))), FieldValue::Coords(more)) => all.extend(more),
                        (Some(_), _) => return Ok(Err(*word)),
                        (None, value) => fields.push((Arc::clone(&field.id.text), value)),
                    }
                }
                words = rest;
            }
        }
        Ok(Ok(fields))
    }

    /// The value of a word; `turns` says whether a direction may be that of a rotary axis.
    fn field_value(
        &self,
        word: &NamedWord,
        (param, field): (&Param, &spec::Field),
        turns: bool,
    ) -> Result<FieldValue, Fault> {
        let name = self.slice(word.name).trim().to_ascii_uppercase();
        let out_of_range = || Fault::program("parameter-out-of-range").arg("q", field.id.as_str());
        let in_range = |value: f64| {
            let refusal = spec::number_refusal_in(param, value, self.drives.unit());
            if refusal.is_none() { Ok(value) } else { Err(out_of_range().arg("value", value)) }
        };
        let value = self.slice(word.value.span).trim();
        match (field.shape, word.value.kind) {
            _ if is_direction(param, field) => {
                let printed = if field.shape == Shape::Labelled { value.to_ascii_uppercase() } else { name };
                let axis = axis_of(printed.trim_end_matches(['+', '-']));
                let (axis, _) = axis.ok_or_else(|| Fault::new(Class::Internal, "field-unknown"))?;
                let value = if value.ends_with('-') { -1.0 } else { 1.0 };
                match rotary(axis).filter(|_| turns) {
                    None => Ok(FieldValue::Direction(linear(axis)?.unit() * value)),
                    Some(RotaryAxis(axis)) => {
                        Ok(FieldValue::Coords(vec![FieldCoord { axis, rotary: true, value, incremental: false }]))
                    }
                }
            }
            (Shape::Axes, _) => {
                let (axis, _) = axis_of(&name).ok_or_else(|| Fault::new(Class::Internal, "field-unknown"))?;
                let turns = rotary(axis);
                let axis = turns.map_or_else(|| linear(axis), |rotary| Ok(rotary.0))?;
                Ok(FieldValue::Coords(vec![FieldCoord {
                    axis,
                    rotary: turns.is_some(),
                    value: 0.0,
                    incremental: false,
                }]))
            }
            (Shape::Centre, _) => {
                let letter = name.strip_prefix("CC").unwrap_or(&name);
                let (axis, _) = axis_of(letter).ok_or_else(|| Fault::new(Class::Internal, "field-unknown"))?;
                let value = in_range(self.number_of(&word.value)?)? * self.drives.unit();
                Ok(FieldValue::Coords(vec![FieldCoord {
                    axis: linear(axis)?,
                    rotary: false,
                    value,
                    incremental: false,
                }]))
            }
            (_, ValueKind::Text(inner)) if is_textual(param) => Ok(FieldValue::Text(self.slice(inner).into())),
            _ if is_textual(param) => match spec::refusal(param, value) {
                None => Ok(FieldValue::Text(value.into())),
                Some(_) => Err(Fault::program("word-not-offered").arg("word", value)),
            },
            (Shape::Q, ValueKind::Q { q, .. }) => Ok(FieldValue::Q(q)),
            (Shape::Position | Shape::AxisCoordinate, _) => {
                let (axis, incremental) = axis_of(&name).ok_or_else(|| Fault::new(Class::Internal, "field-unknown"))?;
                let value = in_range(self.number_of(&word.value)?)?;
                let turns = rotary(axis);
                let axis = turns.map_or_else(|| linear(axis), |rotary| Ok(rotary.0))?;
                let length = turns.is_none() && !matches!(param.quantity, Quantity::Factor | Quantity::Angle);
                let value = if length { value * self.drives.unit() } else { value };
                Ok(FieldValue::Coords(vec![FieldCoord { axis, rotary: turns.is_some(), value, incremental }]))
            }
            _ => {
                let incremental = field.word.as_deref().is_some_and(|wanted| name != wanted);
                let length = param.is_measured();
                Ok(FieldValue::Number { value: in_range(self.number_of(&word.value)?)?, incremental, length })
            }
        }
    }
}

/// Whether 0 stands for a value that a definition lacks where a run goes on after faults: places and depths say where
/// the tool goes.
fn may_be_assumed(param: &Param) -> bool {
    param.quantity != Quantity::Length && spec::number_refusal_in(param, 0.0, 1.0).is_none()
}

/// Whether the value of a word, printed like that, is one that the field can hold.
fn is_valued(word: &NamedWord, printed: &str, param: &Param, field: &spec::Field) -> bool {
    match field.shape {
        Shape::Labelled if is_direction(param, field) || is_textual(param) => {
            let printed = if is_textual(param) { printed.to_owned() } else { printed.to_ascii_uppercase() };
            spec::refusal(param, &printed) != Some(spec::Refusal::Kind)
        }
        Shape::Labelled | Shape::Word | Shape::Row => {
            matches!(word.value.kind, ValueKind::Number(_) | ValueKind::Q { .. })
        }
        Shape::Q | Shape::AxisDirection | Shape::Position | Shape::AxisCoordinate | Shape::Axes | Shape::Centre => true,
    }
}

/// Whether a field is an axis, with a sign or without.
fn is_direction(param: &Param, field: &spec::Field) -> bool {
    field.shape == Shape::AxisDirection || matches!(param.kind, ParameterKind::Axis | ParameterKind::AxisDirection)
}

/// Whether a field keeps what is printed.
fn is_textual(param: &Param) -> bool {
    matches!(param.kind, ParameterKind::Text | ParameterKind::LabelList)
}

/// The axis of a word such as `X` or `IX`, and whether it is incremental.
fn axis_of(name: &str) -> Option<(Axis, bool)> {
    let (letters, incremental) = match name.strip_prefix('I') {
        Some(rest) => (rest, true),
        None => (name, false),
    };
    let axis = Axis::by_name(letters.as_bytes()).filter(|axis| !matches!(axis, Axis::Pr | Axis::Pa))?;
    Some((axis, incremental))
}

/// Whether a fault is that of a cycle that no description says how to execute.
fn is_undescribed(fault: &Fault) -> bool {
    matches!(&*fault.code, "cycle-unknown" | "unsupported-cycle")
}
