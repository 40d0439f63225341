//! What a program asks of the operator, and the programs that it calls.
use std::sync::Arc;

use super::calls::{Call, program_key};
use super::state::Run;
use crate::engine::report::ending::{Done, Leave};
use crate::engine::report::event::{EventKind, MessageKind};
use crate::engine::report::fault::Fault;

impl Run<'_, '_> {
    pub(crate) fn call_program(&mut self, name: &str) -> Done {
        // A program call ends radius compensation.
        self.end_contour()?;
        let Some(program) = self.calls.called(program_key(name), self.settings) else {
            return Err(Fault::program("program-missing").arg("name", name).into());
        };
        self.calls.call(program, 0, Call::Program, &self.settings.limits)
    }

    /// Executes a program that a cycle calls, to its end.
    pub(crate) fn execute_program(&mut self, name: &str) -> Done {
        let depth = self.calls.depth();
        let (at, inside, probing) = (self.drives.report.at().clone(), self.cycles.inside, self.drives.probing);
        self.call_program(name)?;
        (self.cycles.inside, self.drives.probing) = (0, false);
        // M89 is for the positions of the program that calls.
        let always = std::mem::take(&mut self.modal.call_always);
        let cycle = self.cycles.last.clone();
        (self.blocks)(self, depth + 1)?;
        self.enter_program();
        let same = matches!((&cycle, &self.cycles.last), (Some(before), Some(now)) if Arc::ptr_eq(before, now));
        self.modal.call_always |= always && same;
        (*self.drives.report.at_mut(), self.cycles.inside, self.drives.probing) = (at, inside, probing);
        Ok(())
    }

    /// Lengths and local parameters are those of the program being executed from now on.
    pub(crate) fn enter_program(&mut self) {
        self.drives.unit = self.calls.here().map_or(1.0, |program| program.unit);
        self.params.inside_of(self.calls.of_programs());
    }

    /// The operator's answer to a question; nothing if he does not answer.
    pub(crate) fn ask(&mut self, question: &str) -> Option<bool> {
        let said = self.drives.world.answers.next(question)?;
        Some(!matches!(said.to_ascii_lowercase().as_str(), "no" | "cancel" | "stop" | "false" | "0"))
    }

    /// Stops until the operator continues.
    pub(crate) fn stop(&mut self) -> Done {
        let answer = self.ask("stop");
        let id: Arc<str> = "stop".into();
        self.drives.report.report(EventKind::Message { kind: MessageKind::Stop, id, answer });
        if answer == Some(true) { Ok(()) } else { Err(Leave::Stopped) }
    }
}
