//! The guards that the definitions of a program provoke: what a program has is given to the guards of each cycle.
//!
//! Invariant: a guard that needs anything else (a parameter that is not certain, the tool, the machine) says nothing;
//! of the state of the control it hears what is certain.
use std::sync::Arc;

use super::Facts;
use super::cycle::{Effect, OFF, Ready, STATES, read_as, replaced, state, tool};
use super::flow::Modal;
use super::program::{Definition, Item, number};
use super::tools::Tool;
use crate::base::diag::Span;
use crate::base::expr::{Env, EvalError, OnlyParameters, QRef, Resolve, Type, Value, compile};
use crate::program::syntax::ValueKind;
use crate::spec::{Cycle, Group, Param};

/// The values that a definition writes as numbers or texts, and the state of the control as far as it is certain.
#[derive(Default)]
pub(super) struct Written {
    pub(super) numbers: Vec<(QRef, f64)>,
    texts: Vec<(QRef, Arc<str>)>,
    /// The state before the definition, of which guards ask what [`STATES`] names.
    modal: Option<Modal>,
    /// What [`TOOL`] names, as far as it is known.
    tool: [Option<Value>; 5],
}

impl Written {
    /// The same with the tool that a call finds.
    pub(super) fn with(mut self, tool: Tool) -> Self {
        let own = [Some(tool.radius), tool.angle, tool.cutting_length, tool.pitch, tool.speed];
        self.tool = own.map(|own| own.map(Value::Number));
        self
    }

    /// The values that are known: those written as numbers or texts, and those that this control lacks.
    pub(super) fn of(facts: &Facts<'_>, definition: &Definition<'_>, cycle: &Cycle) -> Self {
        let modal = facts.run.before(definition.view.first);
        let mut numbers = Vec::with_capacity(cycle.lacking.len() + definition.items.len());
        numbers.extend_from_slice(&cycle.lacking);
        let mut known = Self { numbers, texts: Vec::new(), modal, tool: [const { None }; 5] };
        for item in &definition.items {
            let (Some(q), Some(value)) = (item.param.and_then(read_as), item.value) else { continue };
            // Of what is written several times the first one is read.
            match value.kind {
                ValueKind::Number(_) | ValueKind::Q { .. } if definition.in_order || known.number(q).is_err() => {
                    known.numbers.extend(number(item).map(|number| (q, number)));
                }
                ValueKind::Text(inside) if definition.in_order || known.text(q).is_err() => {
                    known.texts.push((q, facts.text(inside).into()));
                }
                _ => {}
            }
        }
        let recalls = || match definition.kept {
            Some(kept) => kept.effect(cycle).recalls(),
            None => Effect::of_cycle(cycle).recalls(),
        };
        if cycle.file.group == Group::Contours && recalls() {
            known.numbers.extend_from_slice(facts.shared_before(definition));
        }
        known
    }

    /// The number that is written for a parameter.
    pub(super) fn number_of(&self, param: &Param) -> Option<f64> {
        self.number(read_as(param)?).ok()
    }

    /// Whether a parameter acts; nothing if that is not certain.
    pub(super) fn acts(&self, cycle: &Cycle, param: &Param) -> Option<bool> {
        let Some(name) = &param.effective else { return Some(true) };
        let names = |path: &[String]| match path {
            [name] => cycle.file.lets.get(name).map(|formula| formula.expr.clone()),
            _ => None,
        };
        let condition = cycle.file.conditions.get(name.as_str())?;
        compile(&replaced(&condition.expr, &names, 0), &OnlyParameters).ok()?.truth(self).ok()
    }

    /// Whether something of the state is so, by its place in [`STATES`]; nothing if that is not certain.
    fn state(&self, at: usize) -> Option<bool> {
        let (_, aspect) = STATES.get(at)?;
        self.modal?.is(*aspect).known()
    }

    /// What is known of the tool, by the place of its name.
    fn of_tool(&self, at: usize) -> Option<&Value> {
        self.tool.get(at.checked_sub(STATES.len())?)?.as_ref()
    }

    /// Whether a guard's condition holds; nothing if that is not certain.
    pub(super) fn holds(&self, ready: &Ready) -> Option<bool> {
        if let Some(code) = &ready.compiled {
            return code.truth(self).ok();
        }
        if !ready.asks_state && !ready.asks_tool {
            return None;
        }
        compile(&ready.condition, &WithState(self)).ok()?.truth(self).ok()
    }
}

/// The first parameter written that the guard reads, rather one that measures something than one that chooses, and one
/// that its last condition reads; of two with different signs the positive one.
pub(super) fn place(definition: &Definition<'_>, ready: &Ready, written: &Written) -> Option<Span> {
    let way = ready.way(written)?;
    let reads = way.reads(written);
    let rank = |item: &Item<'_>| {
        let param = item.param?;
        let q = read_as(param)?;
        let side = reads.iter().position(|own| own.contains(&q))?;
        let negative = way.is_product(side) && number(item).is_none_or(|number| number <= 0.0);
        Some((!param.choices.is_empty(), side, negative))
    };
    let ranked = definition.items.iter().filter_map(|item| Some((rank(item)?, item)));
    ranked.min_by_key(|(rank, _)| *rank).map(|(_, item)| item.span)
}

/// Names of what is certain about the state.
struct WithState<'w>(&'w Written);

impl Resolve for WithState<'_> {
    fn name(&self, path: &[String]) -> Option<(usize, Type)> {
        // What switches a guard off is off, as machines come.
        if let [first, datum] = path
            && first == "machine"
            && datum.starts_with("suppress_")
        {
            return Some((OFF, Type::Number));
        }
        if let Some(at) = tool(path) {
            return self.0.of_tool(at).map(|_| (at, Type::Number));
        }
        let at = state(path)?;
        self.0.state(at).map(|_| (at, Type::Bool))
    }
}

impl Env for Written {
    fn slot(&self, slot: usize) -> &Value {
        // Only names of what is known have a slot.
        const NONE: &Value = &Value::Number(f64::NAN);
        if slot == OFF {
            return &Value::Number(0.0);
        }
        if let Some(value) = self.of_tool(slot) {
            return value;
        }
        match self.state(slot) {
            Some(true) => &Value::Bool(true),
            Some(false) => &Value::Bool(false),
            None => NONE,
        }
    }

    fn number(&self, q: QRef) -> Result<f64, EvalError> {
        let found = self.numbers.iter().find(|(own, _)| *own == q);
        found.map(|(_, value)| *value).ok_or(EvalError::Undefined(q))
    }

    fn text(&self, q: QRef) -> Result<Arc<str>, EvalError> {
        let found = self.texts.iter().find(|(own, _)| *own == q);
        found.map(|(_, text)| Arc::clone(text)).ok_or(EvalError::Undefined(q))
    }
}
