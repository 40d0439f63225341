//! What a definition's named values were when it was called last: programs call one definition at many places.
//!
//! Invariant: only what follows from Q parameters alone is kept, and only while no Q parameter is given a value; so
//! nothing that is taken from here could have come out otherwise.
use crate::engine::cycle::execute::Exec;
use crate::engine::plan::{Plan, Slot};
use crate::engine::run::Run;

/// The named values of a definition, all of them numbers, of which no guard had anything to say.
pub(in crate::engine) struct Recall {
    definition: u64,
    changes: u64,
    values: Vec<(Slot, f64)>,
}

/// Whether the named values and guards of a plan follow from Q parameters alone.
fn of_parameters(plan: &Plan) -> bool {
    plan.builtins.is_empty() && plan.fields.is_empty()
}

impl<'e> Run<'_, 'e> {
    /// Gives the named values what they were at the last call, if nothing has changed since. Whether that is so.
    pub(in crate::engine) fn recall(&self, exec: &mut Exec<'_, 'e>) -> bool {
        let Some(recall) = &self.recall else { return false };
        let same = recall.definition == exec.definition.id && recall.changes == self.params.changes();
        if same {
            recall.values.iter().for_each(|(slot, number)| exec.put_number(*slot, *number));
        }
        same
    }

    /// Keeps the named values for the next call; no guard had anything to say.
    pub(in crate::engine) fn remember(&mut self, exec: &Exec<'_, 'e>) {
        let plan = exec.plan();
        if of_parameters(plan) {
            let values = plan.lets.iter().map(|named| Some((named.slot, exec.number_in(named.slot)?)));
            let (definition, changes) = (exec.definition.id, self.params.changes());
            self.recall = values.collect::<Option<_>>().map(|values| Recall { definition, changes, values });
        }
    }
}
