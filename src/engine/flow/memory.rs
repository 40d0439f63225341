//! What a run keeps only to be faster: everything here could be thrown away at any moment.
//!
//! Invariant: nothing that is taken from here could have come out otherwise.
//! - Cells of slots ([`Spare`]): calls of a cycle have many, and without this each call would ask for memory anew.
//! - Named values of a definition ([`Recall`]): programs call one definition at many places; while no Q parameter is
//!   given a value, the named values and guards need not be evaluated again.
//!
//! Plans that are compiled when their cycle is defined first, and programs that are prepared when they are called first
//! (`flow::code`), are kept by the run itself: they are needed, and only made once.
use super::exec::{Cell, Exec};
use crate::engine::params::Params;
use crate::engine::plan::{Plan, Slot};

/// What a run keeps to be faster.
#[derive(Default)]
pub(crate) struct Memory {
    pub(crate) spare: Spare,
    recall: Option<Recall>,
}

/// Memory of executions that are over, for the next one.
#[derive(Default)]
pub(crate) struct Spare {
    pub(crate) cells: Vec<Cell>,
    pub(crate) sentences: Vec<bool>,
}

/// What the named values of a definition were when it was called last, all of them numbers, of which no guard had
/// anything to say.
struct Recall {
    definition: u64,
    changes: u64,
    values: Vec<(Slot, f64)>,
}

/// Whether the named values and guards of a plan follow from Q parameters alone.
fn of_parameters(plan: &Plan) -> bool {
    plan.builtins.is_empty() && plan.fields.is_empty()
}

impl Memory {
    /// Gives the named values what they were at the last call, if nothing has changed since. Whether that is so.
    pub(crate) fn recall(&self, params: &Params, exec: &mut Exec<'_, '_>) -> bool {
        let Some(recall) = &self.recall else { return false };
        let same = recall.definition == exec.definition.id && recall.changes == params.changes();
        if same {
            recall.values.iter().for_each(|(slot, number)| exec.put_number(*slot, *number));
        }
        same
    }

    /// Keeps the named values for the next call; no guard had anything to say.
    pub(crate) fn remember(&mut self, params: &Params, exec: &Exec<'_, '_>) {
        let plan = exec.plan();
        if of_parameters(plan) {
            let values = plan.lets.iter().map(|named| Some((named.slot, exec.number_in(named.slot)?)));
            let (definition, changes) = (exec.definition.id, params.changes());
            self.recall = values.collect::<Option<_>>().map(|values| Recall { definition, changes, values });
        }
    }

    /// Forgets the named values: they belong to parameters that were never given.
    pub(crate) fn forget_values(&mut self) {
        self.recall = None;
    }
}
