//! What every page has: title, trail, switches of language and control, neighbours; and NC lines in its language.
use super::edition::{Edition, Entry, OVERVIEW};
use super::view::{Html, LinkView, PageView, SwitchView, TrailView};
use super::{Site, programs};
use crate::base::diag::{Diagnostic, Source};
use crate::check::Against;
use crate::language::locale::{Args, Scope};
use crate::program::syntax;
use crate::program::syntax::encoding::{Charset, Encoding};
use crate::spec::CycleKey;
use crate::tools::translate;

/// Which page of an edition.
#[derive(Clone, Copy)]
pub(super) enum Here<'h> {
    /// One that every edition has, by its file name.
    Every(&'h str),
    /// That of a cycle, by its place among the entries.
    Cycle(usize),
    /// That of a topic.
    Topic(&'h str),
    /// That of the worked programs.
    Programs,
}

impl Here<'_> {
    /// The same page of another edition; `from` is the edition of this one.
    fn file_in<'s>(&'s self, other: &'s Edition, from: &Edition) -> Option<&'s str> {
        match self {
            Here::Every(file) => Some(file),
            Here::Programs => (!other.on.worked.is_empty()).then_some(programs::PAGE),
            Here::Cycle(at) => Some(&other.entry(from.entries.get(*at)?.cycle.key)?.file),
            Here::Topic(name) => Some(&other.topics.iter().find(|topic| topic.id == *name)?.file),
        }
    }
}

impl Site<'_> {
    /// The name in the language of a cycle that this control only names: that of a control which describes it.
    pub(super) fn name_elsewhere(&self, edition: &Edition, key: CycleKey) -> Option<String> {
        let described = self.catalogue.controls.values().find_map(|on| Some((on, on.cycles.get(&key)?)));
        let (id, scope) = match described {
            Some((on, cycle)) => (format!("cycle-{}", cycle.name()), Scope::new(cycle.name(), on.id())),
            // No specification describes it: `named-cycl-def-39`.
            None => (format!("named-{}", key.to_string().to_lowercase().replace(' ', "-")), Scope::NONE),
        };
        edition.language.plain(&id, &scope).ok().map(|name| name.into_owned())
    }

    /// Lines that a manual prints around a block, with the names and labels of the language.
    pub(super) fn relabelled(&self, edition: &Edition, lines: &[String]) -> String {
        let mut text = lines.join("\n");
        if text.is_empty() {
            return text;
        }
        text.push('\n');
        let Some(labels) = self.labels.get(edition.on.id()) else { return text };
        let against =
            Against { catalogue: self.catalogue, on: edition.on, labels, language: None, software: None, readers: &[] };
        let program = syntax::parse(&Source::new("example", text));
        let encoding = Encoding { charset: Charset::Utf8, bom: false };
        translate::translate(&program, &against, edition.language.tag(), encoding).text
    }

    /// The frame of a page below `control/language/`.
    pub(super) fn frame(&self, edition: &Edition, title: String, here: Here) -> Result<PageView, Vec<Diagnostic>> {
        let entry = if let Here::Cycle(at) = here { Some(at) } else { None };
        let mut languages = Vec::new();
        let mut controls = Vec::new();
        for other in &self.editions {
            let file = here.file_in(other, edition);
            let (same_control, same_language) =
                (other.on.id() == edition.on.id(), other.language.tag() == edition.language.tag());
            let switch = |name: &str| SwitchView {
                href: format!("../../{}", other.path(file.unwrap_or(OVERVIEW))),
                lang: other.language.tag().to_owned(),
                name: name.to_owned(),
                current: same_control && same_language,
                overview: file.is_none(),
            };
            if same_control && file.is_some() {
                languages.push(switch(&other.language_name));
            }
            if same_language {
                controls.push(switch(&other.on.control.title));
            }
        }
        let neighbour = |at: Option<usize>| at.and_then(|at| edition.entries.get(at)).map(link);
        let imprint = self.imprint(edition)?;
        Ok(PageView {
            book: self.is_book,
            draft: self.is_draft,
            lang: edition.language.tag().to_owned(),
            root: "../../".to_owned(),
            canonical: here.file_in(edition, edition).and_then(|file| self.address(&edition.path(file))),
            control: edition.on.control.title.clone(),
            sheet: Some((css_string(&title), css_string(&imprint.join(" \u{b7} ")))),
            imprint,
            trail: self.trail(edition, &title, here)?,
            title,
            languages,
            controls,
            home: String::new(),
            previous: neighbour(entry.and_then(|at| at.checked_sub(1))),
            next: neighbour(entry.map(|at| at + 1)),
        })
    }

    /// Control, software and date of the data.
    pub(super) fn imprint(&self, edition: &Edition) -> Result<Vec<String>, Vec<Diagnostic>> {
        let mut lines = vec![edition.on.control.title.clone()];
        if self.is_draft {
            lines.push(edition.text("site-draft", &Args::new())?.into_owned());
        }
        let states = edition.on.control.states.join(", ");
        if !states.is_empty() {
            lines.push(edition.text("page-software", &Args::new().text("software", states.as_str()))?.into_owned());
        }
        let date = self.catalogue.pages.as_ref().and_then(|pages| pages.edition.as_deref());
        if let Some(date) = date {
            lines.push(edition.text("page-edition", &Args::new().text("date", date))?.into_owned());
        }
        lines.push(concat!("Ciklo ", env!("CARGO_PKG_VERSION")).to_owned());
        Ok(lines)
    }

    /// The control, the group of a cycle or the list of topics, and the page.
    fn trail(&self, edition: &Edition, title: &str, here: Here) -> Result<Vec<TrailView>, Vec<Diagnostic>> {
        let step = |href: Option<String>, text: String| TrailView { href, text };
        let control = edition.on.control.title.clone();
        let to_overview = |anchor: &str| Some(format!("{OVERVIEW}{anchor}"));
        Ok(match here {
            Here::Every(OVERVIEW) => vec![step(None, control)],
            Here::Every(_) | Here::Programs => vec![step(to_overview(""), control), step(None, title.to_owned())],
            Here::Topic(name) => {
                let topics = edition.text("site-topics", &Args::new())?.into_owned();
                let own = edition.topics.iter().find(|topic| topic.id == name).map(|topic| topic.title.clone());
                vec![
                    step(to_overview(""), control),
                    step(to_overview("#topics"), topics),
                    step(None, own.unwrap_or_default()),
                ]
            }
            Here::Cycle(at) => {
                let Some(entry) = edition.entries.get(at) else { return Ok(Vec::new()) };
                let group = entry.cycle.file.group;
                vec![
                    step(to_overview(""), control),
                    step(to_overview(&format!("#group-{}", group.as_str())), edition.group_title(group)?),
                    step(None, entry.cycle.key.to_string()),
                ]
            }
        })
    }
}

/// A text as a string of CSS within an element `style`.
pub(super) fn css_string(text: &str) -> Html {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' | '<' | '>' | '&' | '\n' => out.push_str(&format!("\\{:x} ", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
    Html::from_safe_string(out)
}

/// The link to a page of the same edition.
pub(super) fn link(entry: &Entry) -> LinkView {
    LinkView {
        href: Some(entry.file.clone()),
        key: entry.cycle.key.to_string(),
        number: entry.cycle.key.number,
        name: entry.name.clone(),
        name_lang: None,
    }
}
