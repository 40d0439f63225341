//! The notes of a cycle in sections, and the page that says once what holds for many cycles.
//!
//! Invariant: no note of a cycle is lost: it is on the page of the cycle or on the page that this one links to.
use minijinja::value::Serde;
use minijinja::{Value, context};

use super::Site;
use super::cycle::Maker;
use super::links::{Linker, Shown};
use super::page::{Here, link};
use super::section::Section;
use super::view::{NoteSectionView, NotesView, ThemeNoteView, ThemeView, TopicLink};
use crate::base::diag::Diagnostic;
use crate::language::locale::Args;
use crate::language::text::{CycleText, Vocabulary};
use crate::spec::{Note, NoteKind, NoteSection, Pages, Theme};

/// The file of the notes for many cycles.
pub(super) const PAGE: &str = "notes.html";

/// The order of the notes: what can hurt comes first.
const KINDS: [NoteKind; 4] = [NoteKind::Danger, NoteKind::Caution, NoteKind::MachineBuilder, NoteKind::Note];

impl Maker<'_, '_> {
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
        let about = self.section.topics.iter().filter(|topic| topic.groups.contains(&group));
        about.map(|topic| TopicLink { href: topic.file.clone(), title: topic.title.clone() }).collect()
    }
}

fn title(theme: &Theme) -> String {
    format!("theme-{}", theme.theme.as_str())
}

/// The page of the notes for many cycles; each text once, with the cycles that it holds for.
pub(super) fn page(site: &Site, section: &Section) -> Result<String, Vec<Diagnostic>> {
    let mut views = Vec::new();
    for theme in site.catalogue.pages.iter().flat_map(|pages| &pages.themes) {
        let notes = of_theme(site, section, theme)?;
        if notes.is_empty() {
            continue;
        }
        let topic = theme.topic.as_ref().and_then(|id| section.topics.iter().find(|own| own.id == id.as_str()));
        views.push(ThemeView {
            id: theme.theme.as_str().to_owned(),
            title: section.text(&title(theme), &Args::new())?.into_owned(),
            topic: topic.map(|own| TopicLink { href: own.file.clone(), title: own.title.clone() }),
            notes,
        });
    }
    let args = Args::new().text("control", section.on.control.title.as_str());
    let title = section.text("page-notes-title", &args)?.into_owned();
    let frame = site.frame(section, title, Here::Every(PAGE))?;
    let context = context! {
        page => Value::from(Serde(&frame)),
        words => section.words.clone(),
        themes => Value::from(Serde(&views)),
    };
    site.render("notes.html", context)
}

/// The notes of a theme that cycles of this control have.
fn of_theme(site: &Site, section: &Section, theme: &Theme) -> Result<Vec<ThemeNoteView>, Vec<Diagnostic>> {
    let mut notes: Vec<(String, ThemeNoteView)> = Vec::new();
    for name in &theme.notes {
        for entry in &section.entries {
            let Some(note) = entry.cycle.file.notes.iter().find(|own| own.note == *name) else { continue };
            let vocabulary = Vocabulary::of(section.on, entry.cycle, section.language);
            let text = CycleText::new(section.on, entry.cycle, section.language, &vocabulary);
            let own = text.note(note).into_owned();
            let linker = Linker::new(section, Some(entry.cycle), Shown::Elsewhere);
            let html = Maker { text: &text, section, site, linker: &linker }.html(&own);
            let faults = text.faults();
            if !faults.is_empty() {
                return Err(faults);
            }
            match notes.iter_mut().find(|(known, view)| *known == own && view.kind == note.kind.as_str()) {
                Some((_, view)) => view.cycles.push(link(entry)),
                None => {
                    let view = ThemeNoteView { kind: note.kind.as_str(), text: html, cycles: vec![link(entry)] };
                    notes.push((own, view));
                }
            }
        }
    }
    Ok(notes.into_iter().map(|(_, view)| view).collect())
}
