//! The Q parameters of a run: their values, of which each program has local ones of its own.
//!
//! Invariant: a parameter that was never given a value has none; reading it is an error, not 0.
use std::sync::Arc;

use crate::base::expr::{EvalError, QKind, QRef};

/// How many parameters of each family there are.
const COUNT: usize = 2000;

/// The value that a Q parameter or a cell of a table gets.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// A number.
    Number(f64),
    /// A text.
    Text(Arc<str>),
}

/// Values of Q parameters.
#[derive(Clone, Debug)]
pub struct Params {
    numbers: [Vec<Option<f64>>; 3],
    texts: Vec<Option<Arc<str>>>,
    /// The local parameters of the programs that wait for a called one to end, with the call that left each.
    callers: Vec<(u64, Vec<Option<f64>>)>,
    /// How often a value was given or taken.
    changes: u64,
}

const fn family(kind: QKind) -> usize {
    match kind {
        QKind::Q | QKind::Qs => 0,
        QKind::Ql => 1,
        QKind::Qr => 2,
    }
}

impl Params {
    pub(crate) fn new() -> Self {
        let none = || vec![None; COUNT];
        Self { numbers: [none(), none(), none()], texts: vec![None; COUNT], callers: Vec::new(), changes: 0 }
    }

    /// The program that runs was called by these calls, the outermost first: it has local parameters of its own, and those
    /// of its callers are what they were when it returns.
    pub(crate) fn inside_of(&mut self, calls: &[u64]) {
        let same = self.callers.iter().zip(calls).take_while(|((known, _), call)| known == *call).count();
        if same == calls.len() && same == self.callers.len() {
            return;
        }
        self.changes += 1;
        let Self { numbers: [_, locals, _], callers, .. } = self;
        while callers.len() > same {
            *locals = callers.pop().map(|(_, own)| own).unwrap_or_default();
        }
        for call in calls.iter().skip(same) {
            callers.push((*call, std::mem::replace(locals, vec![None; COUNT])));
        }
    }

    /// Takes the local parameters away; nothing where none has a value.
    pub(crate) fn take_locals(&mut self) -> Option<Vec<Option<f64>>> {
        let [_, locals, _] = &mut self.numbers;
        if locals.iter().all(Option::is_none) {
            return None;
        }
        self.changes += 1;
        Some(std::mem::replace(locals, vec![None; COUNT]))
    }

    /// Gives the local parameters back that were taken away.
    pub(crate) fn return_locals(&mut self, own: Option<Vec<Option<f64>>>) {
        let [_, locals, _] = &mut self.numbers;
        match own {
            Some(own) => *locals = own,
            None if locals.iter().all(Option::is_none) => return,
            None => locals.fill(None),
        }
        self.changes += 1;
    }

    /// Hands the value of a local parameter to the program that called this one. Whether there is one, and it had another
    /// value.
    ///
    /// # Errors
    /// The parameter has no value, or there is none of that number.
    pub(crate) fn export(&mut self, q: QRef) -> Result<bool, EvalError> {
        let value = self.number(q)?;
        let own = self.callers.last_mut().and_then(|(_, locals)| locals.get_mut(usize::from(q.number)));
        let Some(cell) = own.filter(|cell| **cell != Some(value)) else { return Ok(false) };
        *cell = Some(value);
        self.changes += 1;
        Ok(true)
    }

    /// The value of a number parameter.
    ///
    /// # Errors
    /// It has no value, or is a text parameter.
    pub fn number(&self, q: QRef) -> Result<f64, EvalError> {
        if q.kind == QKind::Qs {
            return Err(EvalError::Kind);
        }
        let values = self.numbers.get(family(q.kind)).and_then(|values| values.get(usize::from(q.number)));
        values.copied().flatten().ok_or(EvalError::Undefined(q))
    }

    /// The value of a text parameter.
    ///
    /// # Errors
    /// It has no value, or is a number parameter.
    pub fn text(&self, q: QRef) -> Result<Arc<str>, EvalError> {
        if q.kind != QKind::Qs {
            return Err(EvalError::Kind);
        }
        self.texts.get(usize::from(q.number)).cloned().flatten().ok_or(EvalError::Undefined(q))
    }

    /// How often a value was given or taken: while that stays, all values are what they were.
    pub(crate) const fn changes(&self) -> u64 {
        self.changes
    }

    /// The parameter has no value any more.
    pub(crate) fn forget(&mut self, q: QRef) {
        self.changes += 1;
        let number = usize::from(q.number);
        if q.kind == QKind::Qs {
            self.texts.get_mut(number).map(Option::take);
        } else if let Some(values) = self.numbers.get_mut(family(q.kind)) {
            values.get_mut(number).map(Option::take);
        }
    }

    /// The value of a parameter of either kind.
    pub fn get(&self, q: QRef) -> Option<Content> {
        match q.kind {
            QKind::Qs => self.text(q).ok().map(Content::Text),
            _ => self.number(q).ok().map(Content::Number),
        }
    }

    /// Gives a value. Whether it changed anything.
    ///
    /// # Errors
    /// There is no such parameter, or the value is of the other kind.
    pub(crate) fn set(&mut self, q: QRef, value: &Content) -> Result<bool, EvalError> {
        let index = usize::from(q.number);
        self.changes += 1;
        match (q.kind, value) {
            (QKind::Qs, Content::Text(text)) => {
                let cell = self.texts.get_mut(index).ok_or(EvalError::Undefined(q))?;
                let changed = cell.as_ref() != Some(text);
                *cell = Some(Arc::clone(text));
                Ok(changed)
            }
            (QKind::Q | QKind::Ql | QKind::Qr, Content::Number(number)) => {
                let values = self.numbers.get_mut(family(q.kind)).and_then(|values| values.get_mut(index));
                let cell = values.ok_or(EvalError::Undefined(q))?;
                let changed = *cell != Some(*number);
                *cell = Some(*number);
                Ok(changed)
            }
            _ => Err(EvalError::Kind),
        }
    }

    /// All number parameters of the family Q that have a value.
    pub fn numbers(&self) -> impl Iterator<Item = (u16, f64)> + '_ {
        let numbers = self.numbers.first().map_or(&[][..], Vec::as_slice);
        (0..).zip(numbers).filter_map(|(number, value)| value.map(|value| (number, value)))
    }

    /// All text parameters that have a value.
    pub fn texts(&self) -> impl Iterator<Item = (u16, &str)> + '_ {
        (0..).zip(&self.texts).filter_map(|(number, value)| value.as_deref().map(|value| (number, value)))
    }
}
