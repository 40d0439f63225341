//! One file, several controls: `only`, `except` and `vary` are applied to the tree before anything
//! else reads it, so that every later stage sees a specification for exactly one control.
use std::sync::Arc;

use super::yaml::{Key, Kind, Node};
use crate::base::diag::{Diagnostic, Place, Source};

/// The tree as the control sees it.
pub(super) fn for_control(node: &Node, control: &str) -> Node {
    let kind = match &node.kind {
        Kind::Scalar(text, plain) => Kind::Scalar(Arc::clone(text), *plain),
        Kind::List(items) => Kind::List(
            items.iter().filter(|item| applies(item, control)).map(|item| for_control(item, control)).collect(),
        ),
        Kind::Map(entries) => Kind::Map(overlaid(entries, control)),
    };
    Node { span: node.span, kind }
}

/// Whether the filters of an item let the control through.
fn applies(item: &Node, control: &str) -> bool {
    let names = |key: &str| item.get(key).map(|list| list.items().iter().any(|name| name.text() == Some(control)));
    names("only").unwrap_or(true) && !names("except").unwrap_or(false)
}

fn overlaid(entries: &[(Key, Node)], control: &str) -> Vec<(Key, Node)> {
    let is_filter = |key: &Key| matches!(&*key.text, "only" | "except" | "vary");
    let mut result: Vec<(Key, Node)> = Vec::with_capacity(entries.len());
    for (key, value) in entries.iter().filter(|(key, _)| !is_filter(key)) {
        result.push((key.clone(), for_control(value, control)));
    }
    let Some((_, variants)) = entries.iter().find(|(key, _)| &*key.text == "vary") else {
        return result;
    };
    for variant in variants.items().iter().filter(|variant| applies(variant, control)) {
        let Kind::Map(overrides) = &variant.kind else { continue };
        for (key, value) in overrides.iter().filter(|(key, _)| !is_filter(key)) {
            let value = for_control(value, control);
            match result.iter_mut().find(|(known, _)| known.text == key.text) {
                Some(entry) => entry.1 = value,
                None => result.push((key.clone(), value)),
            }
        }
    }
    result
}

/// Reports filters that name an unknown control, name none, or contradict each other.
pub(super) fn check(node: &Node, controls: &[&str], source: &Arc<Source>, found: &mut Vec<Diagnostic>) {
    match &node.kind {
        Kind::Scalar(..) => {}
        Kind::List(items) => items.iter().for_each(|item| check(item, controls, source, found)),
        Kind::Map(entries) => {
            for (key, value) in entries {
                if matches!(&*key.text, "only" | "except") {
                    check_names(value, controls, source, found);
                } else {
                    check(value, controls, source, found);
                }
            }
            if node.get("only").is_some() && node.get("except").is_some() {
                found.push(Diagnostic::error("spec-only-and-except", Place::new(source, node.span)));
            }
        }
    }
}

fn check_names(list: &Node, controls: &[&str], source: &Arc<Source>, found: &mut Vec<Diagnostic>) {
    let place = || Place::new(source, list.span);
    if list.items().is_empty() {
        let shown = list.shown(source);
        found.push(Diagnostic::error("spec-expected", place()).arg("expected", "list").arg("found", shown));
    }
    for item in list.items() {
        let name = item.text().unwrap_or_default();
        if !controls.contains(&name) {
            let place = Place::new(source, item.span);
            let known = controls.join(", ");
            found.push(Diagnostic::error("spec-unknown-control", place).arg("control", name).arg("known", known));
        }
    }
}
