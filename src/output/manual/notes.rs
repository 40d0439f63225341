//! The notes of a cycle in sections, and the page that says once what holds for many cycles.
//!
//! Invariant: no note of a cycle is lost: it is on the page of the cycle or on the page that this one links to.
use minijinja::value::Serde;
use minijinja::{Value, context};

use super::Site;
use super::cycle::Maker;
use super::edition::Edition;
use super::links::{Linker, Shown};
use super::page::{Here, link};
use super::view::{NoteSectionView, NotesView, ThemeNoteView, ThemeView, TopicLink};
use crate::base::diag::Diagnostic;
use crate::language::locale::Args;
use crate::language::text::{CycleText, Vocabulary};
use crate::spec::{Name, Note, NoteKind, NoteSection, Pages, Theme};

/// The file of the notes for many cycles.
pub(super) const PAGE: &str = "notes.html";

/// The order of the notes: what can hurt comes first.
const KINDS: [NoteKind; 4] = [NoteKind::Danger, NoteKind::Caution, NoteKind::MachineBuilder, NoteKind::Note];

impl Maker<'_, '_, '_> {
    fn pages(&self) -> Option<&Pages> {
        self.site.catalogue.pages.as_ref()
    }

    /// The theme that says a note, if the page of notes has it in the same words.
    fn theme(&self, note: &Note) -> Option<&Theme> {
        self.pages()?.theme(note.note.as_str())
    }

    /// The notes of this cycle in their sections.
    pub(super) fn notes(&self) -> Vec<NoteSectionView> {
        let notes = self.text.cycle.file.notes.iter().zip(self.text.notes());
        let own: Vec<_> = notes.filter(|(note, _)| self.theme(note).is_none()).collect();
        let section_of = |note: &Note| self.pages().map(|pages| pages.section(note.note.as_str()));
        let kinds = |section: Option<NoteSection>| {
            let of_kind = |kind: NoteKind| NotesView {
                kind: kind.as_str(),
                texts: own
                    .iter()
                    .filter(|(note, _)| note.kind == kind && section_of(note) == section)
                    .map(|(_, (_, text))| self.html(text))
                    .collect(),
            };
            KINDS.into_iter().map(of_kind).filter(|notes| !notes.texts.is_empty()).collect::<Vec<_>>()
        };
        let view = |section: NoteSection| NoteSectionView {
            id: section.as_str(),
            title: self.text.general(&format!("site-notes-{}", section.as_str()), &Args::new()).into_owned(),
            kinds: kinds(Some(section)),
        };
        let mut sections: Vec<_> = NoteSection::ALL.iter().map(|section| view(*section)).collect();
        sections.push(NoteSectionView { id: "", title: String::new(), kinds: kinds(None) });
        sections.retain(|section| !section.kinds.is_empty());
        sections
    }

    /// The themes of the notes that the page of notes says for this cycle.
    pub(super) fn general(&self) -> Vec<TopicLink> {
        let Some(pages) = self.pages() else { return Vec::new() };
        let has = |theme: &&Theme| {
            let notes = &self.text.cycle.file.notes;
            notes.iter().any(|note| theme.notes.iter().any(|name| name.as_str() == note.note.as_str()))
        };
        let to = |theme: &Theme| TopicLink {
            href: format!("{PAGE}#{}", theme.theme.as_str()),
            title: self.text.general(&title(theme), &Args::new()).into_owned(),
        };
        pages.themes.iter().filter(has).map(to).collect()
    }

    /// The pages of prose about what surrounds the cycle.
    pub(super) fn topics(&self) -> Vec<TopicLink> {
        let group = self.text.cycle.file.group;
        let about = self.edition.topics.iter().filter(|topic| topic.groups.contains(&group));
        about.map(|topic| TopicLink { href: topic.file.clone(), title: topic.title.clone() }).collect()
    }
}

fn title(theme: &Theme) -> String {
    format!("theme-{}", theme.theme.as_str())
}

/// The page of the notes for many cycles; each text once, with the cycles that it holds for.
pub(super) fn page<'a>(site: &Site<'a>, edition: &Edition<'a>) -> Result<String, Vec<Diagnostic>> {
    let themes: &[Theme] = site.catalogue.pages.as_ref().map_or(&[], |pages| &pages.themes);
    let mut said = said(site, edition, themes)?;
    let mut views = Vec::new();
    for (at, theme) in themes.iter().enumerate() {
        let notes: Vec<ThemeNoteView> = said.extract_if(.., |own| own.theme == at).map(|own| own.view).collect();
        if notes.is_empty() {
            continue;
        }
        let topic = theme.topic.as_ref().and_then(|id| edition.topics.iter().find(|own| own.id == id.as_str()));
        views.push(ThemeView {
            id: theme.theme.as_str().to_owned(),
            title: edition.text(&title(theme), &Args::new())?.into_owned(),
            topic: topic.map(|own| TopicLink { href: own.file.clone(), title: own.title.clone() }),
            notes,
        });
    }
    let args = Args::new().text("control", edition.on.control.title.as_str());
    let title = edition.text("page-notes-title", &args)?.into_owned();
    let frame = site.frame(edition, title, Here::Every(PAGE))?;
    let context = context! {
        page => Value::from(Serde(&frame)),
        words => edition.words.clone(),
        themes => Value::from(Serde(&views)),
    };
    site.render("notes.html", context)
}

/// A note of a theme as some cycles have it.
struct Said {
    /// The number of the theme and that of the note in it.
    theme: usize,
    note: usize,
    text: String,
    view: ThemeNoteView,
}

/// The notes of the themes that cycles of this control have, in the order of the themes.
fn said<'a>(site: &Site<'a>, edition: &Edition<'a>, themes: &[Theme]) -> Result<Vec<Said>, Vec<Diagnostic>> {
    let place_of = |name: &Name| {
        let places = themes.iter().enumerate();
        places.filter_map(|(at, theme)| Some((at, theme.notes.iter().position(|own| own == name)?))).next()
    };
    let mut all: Vec<Said> = Vec::new();
    for entry in &edition.entries {
        let listed = entry.cycle.file.notes.iter().filter_map(|note| Some((note, place_of(&note.note)?)));
        let listed: Vec<_> = listed.collect();
        if listed.is_empty() {
            continue;
        }
        let vocabulary = Vocabulary::of(edition.on, entry.cycle, edition.language);
        let text = CycleText::new(edition.on, entry.cycle, edition.language, &vocabulary);
        let linker = Linker::new(edition, Some(entry.cycle), Shown::Elsewhere);
        let maker = Maker { text: &text, edition, site, linker: &linker };
        for (own, (theme, note)) in listed {
            let words = text.note(own).into_owned();
            let kind = own.kind.as_str();
            let same = |known: &&mut Said| {
                (known.theme, known.note, known.view.kind) == (theme, note, kind) && known.text == words
            };
            if let Some(known) = all.iter_mut().find(same) {
                known.view.cycles.push(link(entry));
                continue;
            }
            let view = ThemeNoteView { kind, text: maker.html(&words), cycles: vec![link(entry)] };
            all.push(Said { theme, note, text: words, view });
        }
        let faults = text.faults();
        if !faults.is_empty() {
            return Err(faults);
        }
    }
    all.sort_by_key(|own| (own.theme, own.note));
    Ok(all)
}
