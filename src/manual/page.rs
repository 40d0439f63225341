//! What every page has: title, switches of language and control, neighbours.
use super::Site;
use super::section::{Entry, Section};
use super::view::{LinkView, PageView, SwitchView};

impl Site<'_> {
    /// The frame of a page below `control/language/`; `entry` is the number of the cycle in its section.
    pub(super) fn frame(&self, section: &Section, title: String, entry: Option<usize>) -> PageView {
        let key = entry.and_then(|at| section.entries.get(at)).map(|entry| entry.cycle.key);
        let mut languages = Vec::new();
        let mut controls = Vec::new();
        for other in &self.sections {
            let file = match key {
                None => "index.html",
                Some(key) => match other.entry(key) {
                    Some(entry) => entry.file.as_str(),
                    None => continue,
                },
            };
            let (same_control, same_language) =
                (other.on.id() == section.on.id(), other.language.tag() == section.language.tag());
            let switch = |name: &str| SwitchView {
                href: format!("../../{}", other.path(file)),
                lang: other.language.tag().to_owned(),
                name: name.to_owned(),
                current: same_control && same_language,
            };
            if same_control {
                languages.push(switch(&other.language_name));
            }
            if same_language {
                controls.push(switch(&other.on.control.title));
            }
        }
        let neighbour = |at: Option<usize>| at.and_then(|at| section.entries.get(at)).map(link);
        PageView {
            lang: section.language.tag().to_owned(),
            title,
            root: "../../",
            control: section.on.control.title.clone(),
            languages,
            controls,
            previous: neighbour(entry.and_then(|at| at.checked_sub(1))),
            next: neighbour(entry.map(|at| at + 1)),
        }
    }
}

/// The link to a page of the same section.
pub(super) fn link(entry: &Entry) -> LinkView {
    LinkView {
        href: Some(entry.file.clone()),
        key: entry.cycle.key.to_string(),
        number: entry.cycle.key.number,
        name: entry.name.clone(),
        name_lang: None,
    }
}
