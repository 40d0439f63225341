//! Blocks that name what they do, and neither move nor define a cycle: `FN 14` to `FN 38`, SQL, `SEL PGM`, `FUNCTION` blocks
//! that only change how the drives keep the feed.
//!
//! Invariant: what changes nothing that other events say is an event of its own with the block as it is written; what
//! the engine cannot execute is a fault.
use crate::base::diag::Span;
use crate::base::expr::QKind;
use crate::base::expr::QRef;
use crate::engine::flow::state::Run;
use crate::engine::params::Content;
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Block, NamedWord, Statement, StatementKind, ValueKind};

impl Run<'_, '_> {
    /// A block that has no place of its own elsewhere.
    pub(super) fn statement(&mut self, block: &Block, statement: &Statement) -> Done {
        match statement.kind {
            StatementKind::Fn(14) => self.error_of_program(statement),
            StatementKind::Fn(16) => self.print_by_mask(block, statement),
            StatementKind::Fn(17) => self.write_system(block, statement),
            StatementKind::Fn(18) => self.read_system(&statement.words),
            // What goes to the PLC, waits for it or is sent away neither moves the tool nor sets a parameter.
            StatementKind::Fn(15 | 19 | 20 | 29 | 38) => {
                self.report_function(block);
                Ok(())
            }
            StatementKind::Fn(26) => self.open_table(statement),
            StatementKind::Fn(27) => self.write_open_table(statement),
            StatementKind::Fn(28) => self.read_open_table(statement),
            StatementKind::Fn(37) => self.export(statement),
            StatementKind::Sql => self.sql(statement),
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

    /// `FN 17: SYSWRITE ID990 NR6 = 1`: to which input the probe is connected, which moves nothing.
    fn write_system(&mut self, block: &Block, statement: &Statement) -> Done {
        let value = |name: &str| {
            let word = statement.words.iter().find(|word| self.slice(word.name).trim().eq_ignore_ascii_case(name));
            word.map_or(Err(Fault::program("value-missing")), |word| self.number_of(&word.value))
        };
        let (id, number) = (value("ID")?, value("NR")?);
        if (id, number) == (990.0, 6.0) {
            self.report_function(block);
            return Ok(());
        }
        Err(Fault::unsupported("unsupported-block").arg("word", format!("SYSWRITE ID{id} NR{number}")).into())
    }

    /// `FN 37: EXPORT QL1`: the calling program gets the value of a local parameter; others it has anyway.
    fn export(&mut self, statement: &Statement) -> Done {
        for word in &statement.words {
            let ValueKind::Q { q, negative: false } = word.value.kind else {
                return Err(Fault::program("text-or-number").into());
            };
            if q.kind == QKind::Ql && self.params.export(q)? {
                let value = Content::Number(self.params.number(q)?);
                self.drives.report.report(EventKind::Set { q, value });
            }
        }
        Ok(())
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
