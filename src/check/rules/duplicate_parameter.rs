//! A parameter that the same definition has had before, be it as a number and as a name.
use std::collections::HashMap;

use super::together;
use crate::base::diag::{Diagnostic, Place, Severity};
use crate::base::expr::QRef;
use crate::check::{Definition, Facts, Item, Rule};

pub(super) const RULE: Rule = Rule { code: "duplicate-parameter", severity: Severity::Error, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if definition.in_order || definition.items.len() < 2 {
        return;
    }
    let mut seen = Seen::default();
    for item in &definition.items {
        let repeats = item.param.is_some_and(|param| param.field.as_ref().is_some_and(|field| field.repeat));
        let q = item.param.and_then(|param| param.q);
        let key = q.map_or(Key::Name(&item.name), Key::Q);
        let first = seen.first(key, item);
        // Fields without a printed word have no name to distinguish them by.
        let named = item.name.starts_with('Q') || item.name.ends_with(':');
        if named && !repeats && !std::ptr::eq(first, item) {
            let place = Place::new(facts.program.source(), first.span);
            let finding = rule.at(facts, item.span).arg("parameter", item.name.as_ref());
            found.push(finding.arg("cycle", definition.key.to_string()).related("first-place", place));
        }
    }
}

/// What distinguishes items.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Key<'i> {
    Q(QRef),
    Name(&'i str),
}

/// The items that were seen; most definitions have so few that looking through them is quickest.
#[derive(Default)]
struct Seen<'i, 'a> {
    few: Vec<(Key<'i>, &'i Item<'a>)>,
    many: HashMap<Key<'i>, &'i Item<'a>>,
}

/// How many are few.
const FEW: usize = 48;

impl<'i, 'a> Seen<'i, 'a> {
    /// The first item of that key: this one, if there was none before.
    fn first(&mut self, key: Key<'i>, item: &'i Item<'a>) -> &'i Item<'a> {
        if self.few.len() < FEW {
            if let Some((_, first)) = self.few.iter().find(|(own, _)| *own == key) {
                return first;
            }
            self.few.push((key, item));
            return item;
        }
        if self.many.is_empty() {
            self.many.extend(self.few.iter().copied());
        }
        self.many.entry(key).or_insert(item)
    }
}
