//! The pages that say how far the translations are: one for all languages, and one for each. They belong to the site as
//! it is served to those who work on it, in the language of the program.
use minijinja::value::Serde;
use minijinja::{Value, context};
use serde::Serialize;

use super::view::{PageView, TrailView};
use super::{Site, edition, index};
use crate::base::diag::Diagnostic;
use crate::language::locale::{Language, Scope};
use crate::tools::exchange::{Count, LanguageStatus, State};

/// The folder of the pages.
pub(super) const FOLDER: &str = "texts";
/// So many open texts of a language are listed.
const LISTED: usize = 500;

/// A row of counts.
#[derive(Serialize)]
struct Row {
    name: String,
    /// The language of the name, if it is not that of the page.
    lang: Option<String>,
    href: Option<String>,
    count: Count,
    done: bool,
}

/// Counts of one kind.
#[derive(Serialize)]
struct Table {
    title: String,
    rows: Vec<Row>,
}

/// A text that is open.
#[derive(Serialize)]
struct OpenView<'s> {
    key: &'s str,
    state: String,
    file: &'s str,
    line: usize,
    change: &'s str,
}

impl Site<'_> {
    /// Has the first page lead to the pages about the translations, and 404.html be shown at any address of the server.
    pub const fn mark_as_served(&mut self) {
        self.is_served = true;
    }

    /// The pages about the translations as paths and texts, in a language that has the words of the site, or else in the
    /// source language.
    ///
    /// # Errors
    /// Words that are missing in the source language, mistakes of the template.
    pub fn state_pages(
        &self,
        tag: &str,
        languages: &[LanguageStatus],
    ) -> Result<Vec<(String, String)>, Vec<Diagnostic>> {
        let own = self.locales.language(tag).ok().filter(|own| edition::words(own, self.source).is_ok());
        let Some(language) = own.or(self.source) else { return Err(vec![Diagnostic::global("manual-empty")]) };
        let words = Words { site: self, language };
        let mut pages = vec![(format!("{FOLDER}/index.html"), words.overview(languages)?)];
        for status in languages {
            pages.push((format!("{FOLDER}/{}.html", status.language), words.one(status)?));
        }
        Ok(pages)
    }
}

struct Words<'w, 'a> {
    site: &'w Site<'a>,
    language: &'w Language,
}

impl Words<'_, '_> {
    fn text(&self, id: &str) -> Result<String, Vec<Diagnostic>> {
        Ok(self.language.plain(id, &Scope::NONE).map_err(|error| vec![error.into()])?.into_owned())
    }

    fn overview(&self, languages: &[LanguageStatus]) -> Result<String, Vec<Diagnostic>> {
        let rows = languages.iter().map(|status| Row {
            name: self.name_of(&status.language),
            lang: Some(status.language.clone()),
            href: Some(format!("{}.html", status.language)),
            ..row(String::new(), status.total)
        });
        let table = Table { title: self.text("site-languages")?, rows: rows.collect() };
        let title = self.text("site-texts")?;
        self.page(title, Vec::new(), &[table], &[], 0)
    }

    fn one(&self, status: &LanguageStatus) -> Result<String, Vec<Diagnostic>> {
        let name = self.name_of(&status.language);
        let control = |id: &String| {
            let on = self.site.catalogue.controls.get(id);
            on.map_or_else(|| id.clone(), |on| on.control.title.clone())
        };
        let group = |id: &String| self.text(&format!("cycle-group-{id}")).unwrap_or_else(|_| id.clone());
        let rows = |all: &std::collections::BTreeMap<String, Count>, name: &dyn Fn(&String) -> String| {
            all.iter().map(|(id, count)| row(name(id), *count)).collect::<Vec<Row>>()
        };
        let tables = [
            Table { title: self.text("site-texts-all")?, rows: vec![row(name.clone(), status.total)] },
            Table { title: self.text("site-controls")?, rows: rows(&status.controls, &control) },
            Table { title: self.text("site-texts-groups")?, rows: rows(&status.groups, &group) },
            Table { title: self.text("site-texts-files")?, rows: rows(&status.files, &String::clone) },
        ];
        let mut open = Vec::new();
        for text in status.open.iter().take(LISTED) {
            let state = match text.state {
                State::Missing => "site-texts-missing",
                State::Stale => "site-texts-stale",
                State::Unaccepted => "site-texts-unaccepted",
                State::SameAsSource => "site-texts-same",
            };
            let change = text.change.as_deref().unwrap_or_default();
            open.push(OpenView { key: &text.key, state: self.text(state)?, file: &text.file, line: text.line, change });
        }
        let more = status.open.len().saturating_sub(LISTED);
        let all = self.text("site-texts")?;
        let title = format!("{all} \u{b7} {name}");
        let step = |href: Option<&str>, text: String| TrailView { href: href.map(str::to_owned), text };
        self.page(title, vec![step(Some("index.html"), all), step(None, name)], &tables, &open, more)
    }

    fn page(
        &self,
        title: String,
        trail: Vec<TrailView>,
        tables: &[Table],
        open: &[OpenView],
        more: usize,
    ) -> Result<String, Vec<Diagnostic>> {
        let words = edition::words(self.language, self.site.source)?;
        let lang = self.language.tag().to_owned();
        let frame = PageView { root: "../".to_owned(), trail, lang, ..index::frame(self.site, title) };
        let view = context! {
            page => Value::from(Serde(&frame)),
            words => Value::from(Serde(&words)),
            tables => Value::from(Serde(&tables)),
            open => Value::from(Serde(&open)),
            more => more,
        };
        self.site.render("texts.html", view)
    }

    /// The name of a language in itself, its tag where it has none yet.
    fn name_of(&self, tag: &str) -> String {
        let name =
            self.site.locales.language(tag).ok().and_then(|own| own.plain("site-language-name", &Scope::NONE).ok());
        name.map_or_else(|| tag.to_owned(), |name| name.into_owned())
    }
}

fn row(name: String, count: Count) -> Row {
    let open = count.missing + count.stale + count.unaccepted + count.same_as_source + count.over_long;
    Row { name, lang: None, href: None, count, done: open == 0 }
}
