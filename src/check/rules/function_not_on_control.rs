//! A function of the language, or a cycle, that the control does not have.
//!
//! Profiles of the controls name them. Each is reported once a program.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::{Facts, Rule};
use crate::program::syntax::functions;

pub(super) const RULE: Rule = Rule { code: "function-not-on-control", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let control = &facts.against.on.control;
    let lacking: Vec<&str> = control.lacks.iter().flat_map(|own| &own.function).map(String::as_str).collect();
    if lacking.is_empty() {
        return;
    }
    let mut reported: BTreeSet<&str> = BTreeSet::new();
    let mut report = |name: &str, span: Span| {
        let is = |own: &&&str| name.strip_prefix(**own).is_some_and(|rest| rest.is_empty() || rest.starts_with(' '));
        if let Some(own) = lacking.iter().find(is)
            && reported.insert(own)
        {
            let finding = rule.at(facts, span).arg("function", name.to_owned());
            found.push(finding.arg("control", control.title.as_str()));
        }
    };
    for (_, block) in facts.marked() {
        if !block.is_unread() {
            functions(facts.program, block).into_iter().for_each(|(name, span)| report(&name, span));
        }
    }
    for definition in &facts.definitions {
        report(&definition.key.to_string(), definition.view.head);
    }
}
