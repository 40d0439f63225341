//! Blocks that name what they do, and neither move nor define a cycle: `FN 14` to `FN 38`, `SEL PGM`, `FUNCTION` blocks
//! that only change how the drives keep the feed.
//!
//! Invariant: what changes nothing that other events say is an event of its own with the block as it is written; what
//! the engine cannot execute is a fault.
use crate::base::diag::Span;
use crate::base::expr::QKind;
use crate::base::expr::QRef;
use crate::engine::flow::state::Run;
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Block, NamedWord, Statement, StatementKind, ValueKind};

impl Run<'_, '_> {
    /// A block that has no place of its own elsewhere.
    pub(super) fn statement(&mut self, block: &Block, statement: &Statement) -> Done {
        match statement.kind {
            StatementKind::Fn(14) => self.error_of_program(statement),
            StatementKind::Fn(18) => self.read_system(&statement.words),
            // What goes to the PLC, waits for it or is sent away neither moves the tool nor sets a parameter.
            StatementKind::Fn(19 | 20 | 29 | 38) => {
                self.report_function(block);
                Ok(())
            }
            StatementKind::Fn(number) => {
                Err(Fault::unsupported("unsupported-block").arg("word", format!("FN {number}")).into())
            }
            StatementKind::SetUndefined => self.undefine(statement),
            StatementKind::CallSelected => self.call_selected(statement),
            _ => Err(self.not_executed(statement.head).into()),
        }
    }

    /// Reports a block that only the machine notices.
    pub(super) fn report_function(&mut self, block: &Block) {
        let end = block.comment().map_or(block.span.end, |span| span.start);
        let written = self.slice(Span::new(block.span.start, end)).trim();
        let bare = written.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
        self.drives.report.report(EventKind::Function(bare.into()));
    }

    /// `FN 14: ERROR = 1000`: the program ends with an error of its own.
    fn error_of_program(&self, statement: &Statement) -> Done {
        let number = statement.words.iter().find_map(|word| match word.value.kind {
            ValueKind::Number(_) | ValueKind::Q { .. } => Some(self.number_of(&word.value)),
            _ => None,
        });
        let number = number.ok_or_else(|| Fault::program("value-missing"))??;
        Err(Fault::control("error-of-program").arg("number", number).into())
    }

    /// `Q1 SET UNDEFINED`.
    fn undefine(&mut self, statement: &Statement) -> Done {
        let head = self.slice(statement.head);
        let named = |text: &str| text.split_ascii_whitespace().next().and_then(QRef::parse);
        let of_word = |word: &NamedWord| match word.value.kind {
            ValueKind::Q { q, .. } => Some(q),
            _ => None,
        };
        let Some(q) = named(head).or_else(|| statement.words.iter().find_map(of_word)) else {
            return Err(self.not_executed(statement.head).into());
        };
        self.params.forget(q);
        Ok(())
    }

    /// `SEL PGM "PART.H"`: the program that `CALL SELECTED PGM` calls.
    pub(super) fn select_program(&mut self, name: &str) -> Done {
        self.selected_program = Some(self.named_text(name)?.into());
        Ok(())
    }

    fn call_selected(&mut self, statement: &Statement) -> Done {
        if !self.slice(statement.head).trim_end().to_ascii_uppercase().ends_with("PGM") {
            return Err(self.not_executed(statement.head).into());
        }
        let Some(name) = self.selected_program.clone() else {
            return Err(Fault::program("program-missing").arg("name", "CALL SELECTED PGM").into());
        };
        self.call_program(&name)
    }

    /// A name as it is written, or the text of the parameter that is written in its place.
    pub(super) fn named_text(&self, written: &str) -> Result<String, Fault> {
        match QRef::parse(written.trim()) {
            Some(q) if q.kind == QKind::Qs => Ok(self.params.text(q)?.to_string()),
            _ => Ok(written.to_owned()),
        }
    }
}
