//! What every page has: title, switches of language and control, neighbours.
use super::Site;
use super::section::{Entry, Section};
use super::view::{LinkView, PageView, SwitchView};
use crate::base::diag::Source;
use crate::check::Against;
use crate::language::locale::Scope;
use crate::program::syntax;
use crate::program::syntax::encoding::{Charset, Encoding};
use crate::spec::CycleKey;
use crate::tools::translate;

/// Which page of a section.
#[derive(Clone, Copy)]
pub(super) enum Here<'h> {
    /// One that every section has, by its file name.
    Every(&'h str),
    /// That of a cycle, by its place among the entries.
    Cycle(usize),
    /// That of a topic.
    Topic(&'h str),
}

impl Here<'_> {
    /// The same page of another section; `from` is the section of this one.
    fn file_in<'s>(&'s self, other: &'s Section, from: &Section) -> Option<&'s str> {
        match self {
            Here::Every(file) => Some(file),
            Here::Cycle(at) => Some(&other.entry(from.entries.get(*at)?.cycle.key)?.file),
            Here::Topic(name) => Some(&other.topics.iter().find(|topic| topic.id == *name)?.file),
        }
    }
}

impl Site<'_> {
    /// The name in the language of a cycle that this control only names: that of a control which describes it.
    pub(super) fn name_elsewhere(&self, section: &Section, key: CycleKey) -> Option<String> {
        let described = self.catalogue.controls.values().find_map(|on| Some((on, on.cycles.get(&key)?)));
        let (on, cycle) = described?;
        let id = format!("cycle-{}", cycle.name());
        section.language.plain(&id, &Scope::new(cycle.name(), on.id())).ok().map(|name| name.into_owned())
    }

    /// Lines that a manual prints around a block, with the names and labels of the language.
    pub(super) fn relabelled(&self, section: &Section, lines: &[String]) -> String {
        let mut text = lines.join("\n");
        if text.is_empty() {
            return text;
        }
        text.push('\n');
        let Some(labels) = self.labels.get(section.on.id()) else { return text };
        let against =
            Against { catalogue: self.catalogue, on: section.on, labels, language: None, software: None, readers: &[] };
        let program = syntax::parse(&Source::new("example", text));
        let encoding = Encoding { charset: Charset::Utf8, bom: false };
        translate::translate(&program, &against, section.language.tag(), encoding).text
    }

    /// The frame of a page below `control/language/`.
    pub(super) fn frame(&self, section: &Section, title: String, here: Here) -> PageView {
        let entry = if let Here::Cycle(at) = here { Some(at) } else { None };
        let mut languages = Vec::new();
        let mut controls = Vec::new();
        for other in &self.sections {
            let Some(file) = here.file_in(other, section) else { continue };
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
            home: String::new(),
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
