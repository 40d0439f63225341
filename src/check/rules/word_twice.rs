//! A word that is written twice in a block that may have it once: an angle of PLANE, a dimension of a blank, an axis of
//! TRANS, a part of a pattern or one of its points, an axis in the lines of a cycle.
use std::borrow::Cow;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

use crate::base::diag::{Diagnostic, Place, Severity, Span};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, CycleForm, NamedWord, StatementKind};
use crate::spec::Keyword;

pub(super) const RULE: Rule = Rule { code: "word-twice", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let words = |words: &[NamedWord]| words.iter().map(|word| word.name).collect::<Vec<_>>();
    for (_, block) in facts.marked() {
        match &block.kind {
            BlockKind::Statement(own)
                if matches!(own.kind, StatementKind::Plane | StatementKind::BlkForm | StatementKind::Trans) =>
            {
                report(rule, facts, &words(&own.words), found);
            }
            BlockKind::PatternDef(own) => {
                report(rule, facts, &own.items.iter().map(|item| item.name).collect::<Vec<_>>(), found);
                own.items.iter().for_each(|item| report(rule, facts, &words(&item.words), found));
            }
            _ => {}
        }
    }
    for definition in &facts.definitions {
        // Touch-probe cycles name an axis and its range, or the directions of two passes.
        if definition.key.keyword == Keyword::CyclDef
            && let CycleForm::Lines(lines) = &definition.view.form
        {
            let words = || lines.iter().filter(|line| line.line > 0).flat_map(|line| &line.words);
            if words().nth(1).is_some() {
                axes(rule, facts, words(), found);
            }
        }
    }
}

/// The axes in the lines of a cycle.
fn axes<'w>(rule: &Rule, facts: &Facts<'_>, words: impl Iterator<Item = &'w NamedWord>, found: &mut Vec<Diagnostic>) {
    let is_axis = |name: &str| matches!(name.trim().as_bytes(), [b'A'..=b'C' | b'U'..=b'Z']);
    let names: Vec<Span> = words.map(|word| word.name).filter(|name| is_axis(facts.text(*name))).collect();
    report(rule, facts, &names, found);
}

fn report(rule: &Rule, facts: &Facts<'_>, names: &[Span], found: &mut Vec<Diagnostic>) {
    let mut seen: HashMap<Cow<'_, str>, Span> = HashMap::new();
    for name in names {
        let text = facts.text(*name).trim();
        match seen.entry(in_capitals(text)) {
            Entry::Occupied(first) if !text.is_empty() => {
                let place = Place::new(facts.program.source(), *first.get());
                found.push(rule.at(facts, *name).arg("word", text).related("first-place", place));
            }
            Entry::Occupied(_) => {}
            Entry::Vacant(none) => _ = none.insert(*name),
        }
    }
}

/// A word without regard to case.
fn in_capitals(text: &str) -> Cow<'_, str> {
    if text.bytes().any(|byte| byte.is_ascii_lowercase()) { text.to_ascii_uppercase().into() } else { text.into() }
}
