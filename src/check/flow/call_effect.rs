//! What a program does to the state of one that calls it.
use super::state::{State, Touched};

/// What a program does to the state of one that calls it.
#[derive(Debug)]
pub(in crate::check) struct CallEffect {
    pub(super) touched: Touched,
    /// The state at its end, begun with nothing known.
    pub(super) exit: State,
    /// Whether it may call the cycle that the calling program has defined.
    pub(super) calls_cycle: bool,
}

impl CallEffect {
    /// It may do anything.
    pub(super) fn anything() -> Self {
        Self { touched: Touched::everything(), exit: State::unknown(), calls_cycle: true }
    }

    /// Carries a state over the call.
    pub(super) fn apply(&self, state: &mut State) {
        *state = State::after(state, &self.exit, &self.touched);
    }
}
