//! Names in specifications: their form, names that occur twice, names that nothing uses.
use super::super::decode::Name;
use crate::base::diag::{Diagnostic, Place, Severity};

/// Ids are kebab case: they become message ids.
pub(super) fn slug(name: &Name, found: &mut Vec<Diagnostic>) {
    let good = name.as_str().starts_with(|c: char| c.is_ascii_lowercase())
        && name.as_str().bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-')
        && !name.as_str().ends_with('-')
        && !name.as_str().contains("--");
    if !good {
        found.push(Diagnostic::error("spec-id-form", name.place.clone()).arg("name", name.as_str()));
    }
}

/// Reports every name that occurs twice in a list.
pub(super) fn duplicates<'n>(names: impl IntoIterator<Item = &'n Name>, found: &mut Vec<Diagnostic>) {
    let mut seen: Vec<&Name> = Vec::new();
    for name in names {
        match seen.iter().find(|other| other.text == name.text) {
            Some(first) => found.push(
                Diagnostic::error("spec-duplicate-name", name.place.clone())
                    .arg("name", name.as_str())
                    .related("first-place", first.place.clone()),
            ),
            None => seen.push(name),
        }
    }
}

pub(super) fn unused_name(name: &str, place: Place) -> Diagnostic {
    Diagnostic { severity: Severity::Warning, ..Diagnostic::error("spec-unused", place) }.arg("name", name)
}
