//! Rehearsals of probing cycles: what they would do in the worst case, found out before they move.
//!
//! A cycle that probes is rehearsed twice: as if everything were touched at once, and as if it were touched at the very
//! end of each probing path. Both leave the machine as it was; then the cycle is executed in the scene as usual.
//! Invariant: nothing here knows what a cycle does; all comes from the paths of the drives.
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::engine::flow::definition::Definition;
use crate::engine::flow::state::{Modal, Run};
use crate::engine::motion::drives::Switched;
use crate::engine::params::Params;
use crate::engine::report::ending::{Done, Leave};
use crate::engine::report::envelope::{Begin, Ended, Recorder, Touching, envelope};
use crate::engine::report::event::At;
use crate::engine::report::fault::Class;
use crate::engine::world::state::World;
use crate::spec::CycleKey;

/// The run as it was before a cycle.
pub(super) struct Before<'e> {
    pub(super) world: World<'e>,
    params: Params,
    modal: Modal,
    at: At,
    guards: BTreeSet<(CycleKey, Arc<str>)>,
    executed: BTreeMap<CycleKey, Vec<bool>>,
    logs: (usize, usize),
    switched: Switched,
    moves: u64,
    inside: usize,
    probing: bool,
}

impl<'e> Run<'_, 'e> {
    pub(super) fn kept(&self) -> Before<'e> {
        Before {
            world: self.drives.world.clone(),
            params: self.params.clone(),
            modal: self.modal,
            at: self.drives.report.at().clone(),
            guards: self.records.guards.clone(),
            executed: self.records.executed.clone(),
            logs: (self.records.logs.len(), self.records.screens.len()),
            switched: self.drives.switched,
            moves: self.drives.moves,
            inside: self.cycles.inside,
            probing: self.drives.probing,
        }
    }

    pub(super) fn return_to(&mut self, before: &Before<'e>) {
        self.drives.world = before.world.clone();
        self.params.clone_from(&before.params);
        // What was kept belongs to values that were never given.
        self.memory.forget_values();
        self.modal = before.modal;
        self.drives.switched = before.switched;
        self.drives.report.at_mut().clone_from(&before.at);
        self.records.guards.clone_from(&before.guards);
        self.records.executed.clone_from(&before.executed);
        self.records.logs.truncate(before.logs.0);
        self.records.screens.truncate(before.logs.1);
        (self.drives.moves, self.cycles.inside, self.drives.probing) = (before.moves, before.inside, before.probing);
        self.cycles.writing.clear();
    }

    /// Rehearses a cycle that probes, executes it and notes its envelope. Where it fails in the scene and not in both
    /// rehearsals, the program goes on from where a rehearsal ended, as if the cycle had found nothing.
    pub(crate) fn with_envelope(&mut self, definition: &Definition<'e>) -> Done {
        let before = self.kept();
        let (mut ways, mut ends, mut stood, mut probings) = (Vec::new(), Vec::new(), None, 0);
        for touching in [Touching::AtOnce, Touching::AtEnd, Touching::AsScene] {
            self.drives.touch(touching);
            self.drives.recorder = Some(Recorder::default());
            let ended = self.execute_in_scene(definition);
            let own = self.drives.recorder.take().unwrap_or_default().into_ways();
            probings = probings.max(own.iter().filter(|way| way.probing).count());
            ways.extend(own);
            let fault = match &ended {
                Err(Leave::Fault(fault)) => Some(fault.clone()),
                _ => None,
            };
            ends.push(Ended { touching, error: fault.as_ref().map(|fault| fault.code.to_string()), fault });
            if touching == Touching::AsScene {
                let system = &before.world.system;
                let begin = Begin {
                    scene: before.world.scene,
                    at: &before.at,
                    back: *system.back(),
                    tool: system.plane.tool,
                    ball_radius: self.drives.world.probe().map_or(0.0, |probe| probe.ball_radius),
                };
                let envelope = envelope(&begin, definition.cycle.key, &ways, probings, ends);
                self.records.envelopes.push(envelope);
                return match (ended, stood) {
                    (Err(Leave::Fault(fault)), Some(machine)) if fault.class != Class::Limit => {
                        self.return_to(&before);
                        self.drives.world.machine = machine;
                        self.drives.world.renew();
                        Ok(())
                    }
                    (ended, _) => ended,
                };
            }
            stood = ended.is_ok().then_some(self.drives.world.machine).or(stood);
            self.return_to(&before);
        }
        Ok(())
    }
}
