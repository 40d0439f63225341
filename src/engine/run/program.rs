//! The loop over blocks, and control flow: labels, calls, repeats, jumps, programs.
//!
//! Invariant: every block is either executed, without effect by its nature, or a fault.
use std::sync::Arc;

use super::{Done, Run};
use crate::base::expr::QKind;
use crate::engine::flow::calls::{Call, program_key};
use crate::engine::flow::code::Prepared;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Amount, Block, CallLbl, FnJump, Label, LabelRef, Operand};

/// How it goes on after a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::engine) enum After {
    /// With the next block.
    GoOn,
    /// The program ends here.
    End,
}

impl<'e> Run<'_, 'e> {
    /// Executes the program to its end.
    pub(in crate::engine) fn program(&mut self) -> Done {
        self.blocks(0)?;
        self.end_contour()
    }

    /// Executes a program that a cycle calls, to its end.
    pub(in crate::engine) fn execute_program(&mut self, name: &str) -> Done {
        let depth = self.flow.depth();
        let (at, inside, probing) = (self.event.at.clone(), self.inside, self.probing);
        self.call_program(name)?;
        (self.inside, self.probing) = (0, false);
        // M89 is for the positions of the program that calls.
        let always = std::mem::take(&mut self.modal.call_always);
        let cycle = self.last_cycle.clone();
        self.blocks(depth + 1)?;
        let same = matches!((&cycle, &self.last_cycle), (Some(before), Some(now)) if Arc::ptr_eq(before, now));
        self.modal.call_always |= always && same;
        (self.event.at, self.inside, self.probing) = (at, inside, probing);
        Ok(())
    }

    /// Executes blocks until the calls that deep have returned, or to the end.
    fn blocks(&mut self, depth: usize) -> Done {
        loop {
            if depth > 0 && self.flow.depth() < depth {
                return Ok(());
            }
            self.flow.advance(&self.engine.limits)?;
            let Some(block) = self.programs.get(self.flow.program).and_then(|p| p.block(self.flow.block)) else {
                if self.flow.return_from_program() {
                    continue;
                }
                return Ok(());
            };
            self.locate(block);
            if block.skip && self.engine.skip_blocks {
                continue;
            }
            if self.block(block)? == After::End && !self.flow.return_from_program() {
                return Ok(());
            }
        }
    }

    /// Sets the place that events belong to.
    fn locate(&mut self, block: &Block) {
        self.event.at.line = block.line;
        self.event.at.block = block.number;
        self.event.at.cycle = None;
        let name = self.programs.get(self.flow.program).map_or("", |prepared| prepared.program.source().name());
        if *self.event.at.program != *name {
            self.event.at.program = self.flow.program_name(&self.programs);
        }
    }

    /// The text at a place of the program being executed.
    pub(in crate::engine) fn slice(&self, span: crate::base::diag::Span) -> &'e str {
        self.programs.get(self.flow.program).map_or("", |prepared| prepared.program.slice(span))
    }

    pub(in crate::engine) fn label(&mut self, label: &LabelRef) -> Done {
        if label.target == Label::END {
            self.flow.return_from_subprogram();
        }
        Ok(())
    }

    fn label_block(&self, label: &LabelRef) -> Result<usize, Fault> {
        let internal = || Fault::new(super::Class::Internal, "no-program");
        let prepared = self.programs.get(self.flow.program).ok_or_else(internal)?;
        match label.target {
            Label::Q(q) if q.kind == QKind::Qs => {
                let name = self.params.text(q)?;
                prepared.label(label.target, Some(&name))
            }
            Label::Q(q) => {
                let number = self.params.number(q)?;
                let valid = number >= 1.0 && number.fract() == 0.0 && number <= f64::from(u16::MAX);
                let missing = || Fault::program("jump-target-missing").arg("label", number);
                if valid { prepared.numbered_label(number as u16) } else { Err(missing()) }
            }
            _ => prepared.label(label.target, None),
        }
    }

    pub(in crate::engine) fn call_label(&mut self, call: &CallLbl) -> Done {
        let target = self.label_block(&call.label)?;
        match &call.repeat {
            Some(times) => {
                let times = self.operand(times)?;
                if !(0.0..=65_535.0).contains(&times) || times.fract() != 0.0 {
                    return Err(Fault::program("repeat-count").arg("found", times).into());
                }
                self.flow.repeat(target, times as u32, &self.engine.limits)
            }
            None => self.flow.call(self.flow.program, target, Call::Subprogram(target), &self.engine.limits),
        }
    }

    pub(in crate::engine) fn call_program(&mut self, name: &str) -> Done {
        // A program call ends radius compensation.
        self.end_contour()?;
        let Some(program) = self.called(program_key(name)) else {
            return Err(Fault::program("program-missing").arg("name", name).into());
        };
        self.flow.call(program, 0, Call::Program, &self.engine.limits)
    }

    /// The number of a program that is called, which is looked for at its first call.
    fn called(&mut self, key: String) -> Option<usize> {
        if let Some(known) = self.names.get(&key) {
            return Some(*known);
        }
        let given = self.engine.others.get(&key).copied();
        let prepared = Prepared::new(given.or_else(|| self.engine.around?.program(&key))?);
        self.flow.add(&prepared);
        self.programs.push(prepared);
        let number = self.programs.len() - 1;
        self.names.insert(key, number);
        Some(number)
    }

    pub(in crate::engine) fn jump(&mut self, jump: &FnJump) -> Done {
        let is_text = |operand: &Operand| match operand.amount {
            Amount::Q { q, .. } => q.kind == QKind::Qs,
            Amount::Text(_) => true,
            Amount::Number(_) => false,
        };
        if let Some(text) = [&jump.a, &jump.b].into_iter().find(|operand| is_text(operand)) {
            let word = format!("IF {}", self.slice(text.span));
            return Err(Fault::unsupported("unsupported-block").arg("word", word).into());
        }
        let (a, b) = (self.operand(&jump.a)?, self.operand(&jump.b)?);
        let Some(holds) = jump.relation.holds(a, b) else {
            return Err(Fault::unsupported("unsupported-block").arg("word", "IF … IS UNDEFINED").into());
        };
        if holds {
            let target = self.label_block(&jump.label)?;
            self.flow.jump(target, &self.engine.limits)?;
        }
        Ok(())
    }

    /// The operator's answer to a question; nothing if he does not answer.
    pub(in crate::engine) fn ask(&mut self, question: &str) -> Option<bool> {
        let said = self.world.answers.next(question)?;
        Some(!matches!(said.to_ascii_lowercase().as_str(), "no" | "cancel" | "stop" | "false" | "0"))
    }

    /// Stops until the operator continues.
    pub(in crate::engine) fn stop(&mut self) -> Done {
        let answer = self.ask("stop");
        let id: Arc<str> = "stop".into();
        self.tell(super::EventKind::Message { kind: super::MessageKind::Stop, id, answer });
        if answer == Some(true) { Ok(()) } else { Err(super::Leave::Stopped) }
    }
}
