//! What a called program does, found out by following it with nothing known before it.
use super::call_effect::CallEffect;
use super::graph::Graph;
use super::project::{Callee, Callees, Project, calls};
use super::state::{Loaded, Pending, State, Touched};
use super::step::Steps;
use super::walk::Walk;
use crate::check::Against;
use crate::check::program::Reading;
use crate::program::syntax::Program;

impl Callee {
    /// Reads off what a program does when it is called.
    pub fn of(program: &Program, against: &Against<'_>, project: Option<&dyn Project>) -> Self {
        let reading = Reading::of(program, against);
        let callees = Callees::of(&reading, &calls(&reading, project));
        Self::new(program, call_effect(&reading, &callees))
    }
}

/// What a program does when another one calls it.
fn call_effect(reading: &Reading<'_>, callees: &Callees) -> CallEffect {
    let steps = Steps::new(reading, callees);
    let mut walk = Walk::new(&steps, Graph::of(reading));
    walk.start(&State::unknown());
    if !walk.follow() {
        return CallEffect::anything();
    }
    let Some(mut exit) = walk.exit() else { return CallEffect::anything() };
    let mut touched = Touched::default();
    for (index, block) in reading.program.blocks().iter().enumerate() {
        let before = Touched::probes();
        let mut after = before.clone();
        after.iter_mut().for_each(|state| steps.step(index, block, state));
        touched.note(&before, &after);
    }
    // Definitions count for their own program only; local parameters, too.
    touched.only_global();
    exit.modal.pending = Pending::Unknown;
    if exit.modal.loaded != Loaded::None {
        exit.modal.loaded = Loaded::Unknown;
    }
    let run = walk.result(true);
    let calls_cycle = run.calls.iter().any(|call| !matches!(call.modal.pending, Pending::Definition(_)));
    CallEffect { touched, exit, calls_cycle }
}
