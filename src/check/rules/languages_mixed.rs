//! Cycle definitions in another language than most of the program.
//!
//! Reported once a program, at the first of them, with the lines of the others: parts of two programs were put
//! together, or a subprogram was taken over. Single labels in a definition are another finding.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Place, Severity};
use crate::check::speech::is_in_own_language;
use crate::check::{Facts, Rule, Speech, speech};

pub(super) const RULE: Rule = Rule { code: "languages-mixed", severity: Severity::Note, run };

/// So many lines are listed.
const LISTED: usize = 12;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(language) = facts.language.as_deref() else { return };
    let source = facts.program.source();
    let mut first = None;
    let (mut lines, mut languages) = (Vec::new(), BTreeSet::new());
    for definition in facts.definitions.iter().filter(|own| !is_in_own_language(facts, own)) {
        let definition = facts.read(definition);
        if definition.items.iter().all(|item| item.label.is_none()) {
            continue;
        }
        let tag = match speech(facts, &definition) {
            Speech::In(tag) if tag != language => tag,
            // Three dots stand for a language that is not known.
            Speech::Foreign => "…".to_owned(),
            _ => continue,
        };
        languages.insert(tag);
        first.get_or_insert(definition.view.head);
        lines.push(Place::new(source, definition.view.head).start().line);
    }
    let Some(first) = first else { return };
    let more = if lines.len() > LISTED { ", …" } else { "" };
    let listed: Vec<String> = lines.iter().take(LISTED).map(ToString::to_string).collect();
    let languages: Vec<String> = languages.into_iter().collect();
    let finding = rule.at(facts, first).arg("language", language).arg("others", languages.join(", "));
    found.push(finding.arg("lines", listed.join(", ") + more));
}
