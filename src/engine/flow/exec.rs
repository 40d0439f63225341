//! One execution of a plan: the values in its slots, and what expressions see of them.
//!
//! Invariant: a slot without a value is never read; an error in a named value shows only where it is needed.
use std::sync::Arc;

use glam::DVec3;

use super::definition::{Definition, FieldValue};
use super::memory::Spare;
use crate::base::expr::{Env, EvalError, QRef, Value};
use crate::engine::motion::drives::Switched;
use crate::engine::params::Params;
use crate::engine::plan::{Calc, Plan, Slot};
use crate::engine::report::fault::{Class, Fault};
use crate::engine::world::stylus::ProbeData;

/// What a slot holds.
#[derive(Clone, Debug)]
pub(crate) enum Cell {
    Empty,
    Value(Value),
    /// Its value could not be calculated.
    Failed(Box<Fault>),
}

/// One execution of a plan.
pub(crate) struct Exec<'d, 'e> {
    pub(crate) definition: &'d Definition<'e>,
    pub(crate) cells: Vec<Cell>,
    pub(crate) lists: Vec<Vec<Value>>,
    /// The position when the cycle began: main, minor, tool axis.
    pub(crate) start: DVec3,
    /// Values for parameters that no Q parameter of the program holds.
    shadows: Vec<(QRef, f64)>,
    /// Spindle and coolant as they were when the cycle began.
    pub(crate) switched: Switched,
    /// The probe as it was when the cycle began.
    pub(crate) probe: Option<ProbeData>,
    /// Which sentences of the plan were executed.
    pub(crate) sentences: Vec<bool>,
    /// Whether known names change while the cycle runs.
    pub(crate) changing: bool,
    /// Whether the values of Q parameters are those of the program.
    plain: bool,
}

/// What an expression of a plan sees.
struct View<'v, 'd, 'e> {
    exec: &'v Exec<'d, 'e>,
    params: &'v Params,
}

impl Env for View<'_, '_, '_> {
    fn slot(&self, slot: usize) -> &Value {
        static NOTHING: Value = Value::Bool(false);
        match self.exec.cells.get(slot) {
            Some(Cell::Value(value)) => value,
            _ => &NOTHING,
        }
    }

    fn number(&self, q: QRef) -> Result<f64, EvalError> {
        let (exec, plan) = (self.exec, self.exec.plan());
        if exec.plain {
            return self.params.number(q);
        }
        if let Some((_, value)) = plan.constants.iter().find(|(known, _)| *known == q) {
            return Ok(*value);
        }
        if let Some(stands) = plan.stands_for.iter().find(|stands| stands.q == q) {
            let Value::Number(value) = self.slot(stands.slot) else { return Err(EvalError::Undefined(q)) };
            if !stands.names_it {
                return Ok(*value);
            }
            if let Some((_, value)) = exec.shadows.iter().find(|(known, _)| *known == q) {
                return Ok(*value);
            }
        }
        Ok(exec.definition.read(q, self.params.number(q)?))
    }

    fn text(&self, q: QRef) -> Result<Arc<str>, EvalError> {
        self.params.text(q)
    }
}

impl<'d, 'e> Exec<'d, 'e> {
    pub(crate) fn new(
        definition: &'d Definition<'e>,
        start: DVec3,
        probe: Option<ProbeData>,
        switched: Switched,
        Spare { mut cells, mut sentences }: Spare,
    ) -> Self {
        let plan = &definition.plan;
        // Emptied in place: a call has many cells, and most of them have nothing to give back.
        cells.truncate(plan.slots);
        cells.iter_mut().filter(|cell| !matches!(cell, Cell::Empty)).for_each(|cell| *cell = Cell::Empty);
        cells.resize(plan.slots, Cell::Empty);
        sentences.clear();
        sentences.resize(plan.sentences.len(), false);
        Self {
            definition,
            cells,
            lists: vec![Vec::new(); plan.lists],
            start,
            shadows: Vec::new(),
            switched,
            probe,
            sentences,
            plain: plan.constants.is_empty() && plan.stands_for.is_empty() && definition.unit == 1.0,
            changing: plan.builtins.iter().any(|(_, builtin)| builtin.changes()),
        }
    }

    /// The plan that is executed.
    pub(crate) fn plan(&self) -> &'d Plan {
        &self.definition.plan
    }

    pub(crate) fn show(&mut self, sentence: usize) {
        if let Some(shown) = self.sentences.get_mut(sentence) {
            *shown = true;
        }
    }

    /// The same as [`Self::put`] of a number; most slots keep numbers for ever.
    #[inline]
    pub(crate) fn put_number(&mut self, slot: Slot, number: f64) {
        match self.cells.get_mut(slot) {
            Some(Cell::Value(Value::Number(kept))) => *kept = number,
            _ => self.put(slot, Value::Number(number)),
        }
    }

    pub(crate) fn put(&mut self, slot: Slot, value: Value) {
        if let Some(cell) = self.cells.get_mut(slot) {
            *cell = Cell::Value(value);
        }
    }

    /// The number in a slot, if it is one.
    pub(crate) fn number_in(&self, slot: Slot) -> Option<f64> {
        match self.cells.get(slot) {
            Some(Cell::Value(Value::Number(number))) => Some(*number),
            _ => None,
        }
    }

    pub(crate) fn fail(&mut self, slot: Slot, fault: Fault) {
        if let Some(cell) = self.cells.get_mut(slot) {
            *cell = Cell::Failed(Box::new(fault));
        }
    }

    pub(crate) fn copy(&mut self, from: Slot, to: Slot) {
        if let Some(Cell::Value(value)) = self.cells.get(from) {
            let value = value.clone();
            self.put(to, value);
        }
    }

    /// A parameter that an old-style field names, written: the Q parameter of the program, if there is one.
    pub(crate) fn redirected(&mut self, q: QRef, value: f64) -> Option<QRef> {
        let plan = self.plan();
        let stands = plan.stands_for.iter().find(|stands| stands.q == q && stands.names_it)?;
        let (_, id) = plan.fields.iter().find(|(slot, _)| *slot == stands.slot)?;
        self.shadows.retain(|(known, _)| *known != q);
        self.shadows.push((q, value));
        match self.definition.field(id) {
            Some(FieldValue::Q(target)) => Some(*target),
            _ => None,
        }
    }

    /// Whether a parameter is written to where a field says.
    pub(crate) fn is_redirected(&self, q: QRef) -> bool {
        self.plan().stands_for.iter().any(|stands| stands.q == q && stands.names_it)
    }

    fn needed(&self, calc: &Calc) -> Result<(), Fault> {
        for slot in &calc.needs {
            match self.cells.get(*slot) {
                Some(Cell::Value(_)) => {}
                Some(Cell::Failed(fault)) => return Err(Fault::clone(fault)),
                _ => {
                    let start = calc.place.start();
                    let place = format!("{}:{}", calc.place.source.name(), start.line);
                    return Err(Fault::new(Class::Internal, "value-not-bound").arg("place", place));
                }
            }
        }
        Ok(())
    }

    pub(crate) fn value(&self, calc: &Calc, params: &Params) -> Result<Value, Fault> {
        if let Some(number) = calc.code.slot().and_then(|slot| self.number_in(slot)) {
            return Ok(Value::Number(number));
        }
        self.needed(calc)?;
        Ok(calc.code.eval(&View { exec: self, params })?)
    }

    pub(crate) fn number(&self, calc: &Calc, params: &Params) -> Result<f64, Fault> {
        // What most actions are given is a name that has its value.
        if let Some(number) = calc.code.slot().and_then(|slot| self.number_in(slot)) {
            return Ok(number);
        }
        self.needed(calc)?;
        Ok(calc.code.number(&View { exec: self, params })?)
    }

    pub(crate) fn truth(&self, calc: &Calc, params: &Params) -> Result<bool, Fault> {
        self.needed(calc)?;
        Ok(calc.code.truth(&View { exec: self, params })?)
    }

    /// A point: main, minor, tool axis.
    pub(crate) fn point(&self, calc: &Calc, params: &Params) -> Result<DVec3, Fault> {
        self.needed(calc)?;
        Ok(calc.code.point(&View { exec: self, params })?)
    }

    pub(crate) fn holds(&self, when: Option<&Calc>, params: &Params) -> Result<bool, Fault> {
        when.map_or(Ok(true), |when| self.truth(when, params))
    }
}
