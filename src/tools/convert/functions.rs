//! Functions of a program that the other control's manual does not show.
//!
//! Invariant: which control has which function is said by its profile.
use std::collections::BTreeMap;

use super::Writer;
use crate::base::diag::{Severity, Span};
use crate::program::syntax::functions;

impl Writer<'_, '_> {
    /// Says which functions of the program the other control's manual does not show, or has as an option; each once.
    pub(super) fn functions(&mut self) {
        let mut used: BTreeMap<String, (Span, usize)> = BTreeMap::new();
        for block in self.program.blocks() {
            for (name, span) in functions(self.program, block) {
                used.entry(name).or_insert((span, 0)).1 += 1;
            }
        }
        let control = &self.request.to.on.control;
        for (name, (span, count)) in used {
            let shown = control.functions.iter().find(|own| own.function.contains(&name));
            let code = match shown {
                None => "convert-function-not-shown",
                Some(own) if own.option.is_some() => "convert-function-option",
                Some(_) => continue,
            };
            let finding = self.at(code, Severity::Note, span).arg("function", name).arg("count", count);
            let option = shown.and_then(|own| own.option).unwrap_or_default();
            self.found
                .push(finding.arg("option", option as usize).arg("control", self.request.to.on.control.title.as_str()));
        }
    }
}
