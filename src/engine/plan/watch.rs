//! Values of a run that are noted when a step has been executed: what figures are measured by.
//!
//! Invariant: notes are no actions; a run with them moves as one without.
use std::sync::Arc;

use super::Compiler;
use super::act::{Calc, Item};
use super::names::Scope;
use crate::spec::Formula;

/// Expressions whose values are noted each time that a step has been executed, or at the end of the cycle.
#[derive(Clone, Debug)]
pub struct Watch {
    /// The step; the end of the cycle if there is none.
    pub step: Option<Arc<str>>,
    /// The expressions.
    pub values: Vec<Formula>,
}

/// A compiled [`Watch`].
#[derive(Clone, Debug)]
pub struct Watched {
    /// Its place among all.
    pub index: usize,
    /// Its expressions; nothing for one that is wrong.
    pub values: Vec<Option<Calc>>,
}

impl Compiler<'_> {
    /// Adds what is noted after a step, or at the end.
    pub(super) fn watch(&mut self, step: Option<&Arc<str>>, scope: &Scope, items: &mut Vec<Item>) {
        let watches = self.watches;
        for (index, watch) in watches.iter().enumerate().filter(|(_, watch)| watch.step.as_ref() == step) {
            let values = watch.values.iter().map(|formula| self.calc(formula, scope)).collect();
            items.push(Item::Watch(Watched { index, values }));
        }
    }
}
