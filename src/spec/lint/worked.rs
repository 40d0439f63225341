//! Worked programs are about cycles that exist and say what must come out.
use super::super::catalogue::OnControl;
use super::names::{duplicates, slug};
use super::reference::unknown_cycle;
use crate::base::diag::Diagnostic;

pub(super) fn worked(on: &OnControl, found: &mut Vec<Diagnostic>) {
    duplicates(on.worked.iter().map(|worked| &worked.example.name), found);
    for worked in on.worked.iter() {
        let name = &worked.example.name;
        slug(name, found);
        if on.cycles.get(&worked.key).is_none() {
            found.push(unknown_cycle(name.place.clone(), worked.key, on));
        }
        if worked.example.scene.is_none() || worked.example.expect.is_none() {
            found.push(Diagnostic::error("spec-case-incomplete", name.place.clone()).arg("name", name.as_str()));
        }
        duplicates(worked.figures.iter().map(|figure| &figure.name), found);
        worked.figures.iter().for_each(|figure| slug(&figure.name, found));
    }
}
