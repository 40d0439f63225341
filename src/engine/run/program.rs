//! The loop over blocks, and control flow: labels, calls, repeats, jumps, programs.
//!
//! Invariant: every block is either executed, without effect by its nature, or a fault.

use std::sync::Arc;

use crate::base::expr::{QKind, QRef};
use crate::engine::flow::calls::Call;
use crate::engine::flow::state::Run;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Amount, Block, CallLbl, FnJump, Label, LabelRef, Operand, Relation};

/// How it goes on after a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum After {
    /// With the next block.
    GoOn,
    /// The program ends here.
    End,
}

impl<'e> Run<'_, 'e> {
    /// Executes the program to its end.
    pub(super) fn program(&mut self) -> Done {
        self.blocks(0)?;
        self.enter_program();
        self.end_contour()
    }

    /// Executes blocks until the calls that deep have returned, or to the end.
    pub(super) fn blocks(&mut self, depth: usize) -> Done {
        loop {
            if depth > 0 && self.calls.depth() < depth {
                return Ok(());
            }
            self.calls.advance(&self.settings.limits)?;
            let Some(block) = self.calls.here().and_then(|p| p.block(self.calls.block)) else {
                if self.calls.return_from_program() {
                    continue;
                }
                return Ok(());
            };
            self.locate(block);
            self.params.inside_of(self.calls.of_programs());
            if block.skip && self.settings.skip_blocks {
                continue;
            }
            if self.block(block)? == After::End && !self.calls.return_from_program() {
                return Ok(());
            }
        }
    }

    /// Sets the place that events belong to, and the unit of lengths.
    fn locate(&mut self, block: &Block) {
        let at = self.drives.report.at_mut();
        at.line = block.line;
        at.block = block.number;
        at.cycle = None;
        let Some(prepared) = self.calls.here() else { return };
        self.drives.unit = prepared.unit;
        if *at.program != *prepared.program.source().name() {
            at.program = self.calls.program_name();
        }
    }

    pub(super) fn label(&mut self, label: &LabelRef) -> Done {
        if label.target == Label::END {
            self.calls.return_from_subprogram();
        }
        Ok(())
    }

    fn label_block(&self, label: &LabelRef) -> Result<usize, Fault> {
        let internal = || Fault::new(super::Class::Internal, "no-program");
        let prepared = self.calls.here().ok_or_else(internal)?;
        match label.target {
            Label::Q(q) if q.kind == QKind::Qs => self.named_label(&self.params.text(q)?),
            Label::Name(span) => self.named_label(prepared.program.slice(span)),
            Label::Q(q) => {
                let number = self.params.number(q)?;
                let valid = number >= 1.0 && number.fract() == 0.0 && number <= f64::from(u16::MAX);
                let missing = || Fault::program("jump-target-missing").arg("label", number);
                if valid { prepared.numbered_label(number as u16) } else { Err(missing()) }
            }
            Label::Number(_) => prepared.label(label.target),
        }
    }

    /// The block of a named label: one that is written, or one whose name is the text that a parameter has now
    /// (`LBL QS1`).
    fn named_label(&self, name: &str) -> Result<usize, Fault> {
        let internal = || Fault::new(super::Class::Internal, "no-program");
        let prepared = self.calls.here().ok_or_else(internal)?;
        let found = prepared.named_label(name);
        let is_it = |(_, q): &&(usize, QRef)| self.params.text(*q).is_ok_and(|text| *text == *name);
        match (&found, prepared.changing_labels().iter().find(is_it)) {
            (Ok(_), Some(_)) => Err(Fault::program("jump-target-twice").arg("label", name)),
            (Err(fault), Some((block, _))) if fault.code == "jump-target-missing" => Ok(*block),
            _ => found,
        }
    }

    pub(super) fn call_label(&mut self, call: &CallLbl) -> Done {
        let target = self.label_block(&call.label)?;
        match &call.repeat {
            Some(times) => {
                let times = self.operand(times)?;
                if !(0.0..=65_534.0).contains(&times) || times.fract() != 0.0 {
                    return Err(Fault::program("repeat-count").arg("found", times).into());
                }
                self.calls.repeat(target, times as u32, &self.settings.limits)
            }
            None => self.calls.call(self.calls.program, target, Call::Subprogram(target), &self.settings.limits),
        }
    }

    /// The text of an operand.
    fn text_operand(&self, operand: &Operand) -> Result<Arc<str>, Fault> {
        match operand.amount {
            Amount::Q { q, negative: false } => Ok(self.params.text(q)?),
            Amount::Text(span) => Ok(self.slice(span).into()),
            _ => Err(Fault::program("text-or-number")),
        }
    }

    pub(super) fn jump(&mut self, jump: &FnJump) -> Done {
        if let Relation::Undefined | Relation::Defined = jump.relation {
            let Amount::Q { q, .. } = jump.a.amount else { return Err(Fault::program("text-or-number").into()) };
            if self.params.get(q).is_some() == (jump.relation == Relation::Defined) {
                let target = self.label_block(&jump.label)?;
                self.calls.jump(target, &self.settings.limits)?;
            }
            return Ok(());
        }
        let is_text = |operand: &Operand| match operand.amount {
            Amount::Q { q, .. } => q.kind == QKind::Qs,
            Amount::Text(_) => true,
            Amount::Number(_) => false,
        };
        if is_text(&jump.a) || is_text(&jump.b) {
            let same = self.text_operand(&jump.a)? == self.text_operand(&jump.b)?;
            let holds = match jump.relation {
                Relation::Equal => same,
                Relation::NotEqual => !same,
                // Texts have no size.
                _ => return Err(Fault::program("text-or-number").into()),
            };
            if holds {
                let target = self.label_block(&jump.label)?;
                self.calls.jump(target, &self.settings.limits)?;
            }
            return Ok(());
        }
        let (a, b) = (self.operand(&jump.a)?, self.operand(&jump.b)?);
        let Some(holds) = jump.relation.holds(a, b) else {
            return Err(Fault::unsupported("unsupported-block").arg("word", "IF … IS UNDEFINED").into());
        };
        if holds {
            let target = self.label_block(&jump.label)?;
            self.calls.jump(target, &self.settings.limits)?;
        }
        Ok(())
    }
}
