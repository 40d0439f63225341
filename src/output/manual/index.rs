//! The first page of the site: what it is, for which controls and software, in which languages; and the page that a
//! server shows instead of one that does not exist.
use minijinja::value::Serde;
use minijinja::{Value, context};

use super::edition::{Edition, OVERVIEW};
use super::view::{ChoiceRow, Invitation, PageView, SwitchView};
use super::{Site, search, translation_state};
use crate::base::diag::Diagnostic;
use crate::language::locale::{Args, SOURCE_LANGUAGE};

/// The file that servers show instead of a page that does not exist.
pub(super) const MISSING: &str = "404.html";

pub(super) fn page(site: &Site) -> Result<String, Vec<Diagnostic>> {
    let own = source_section(site)?;
    let mut rows: Vec<ChoiceRow> = Vec::new();
    for edition in &site.editions {
        let link = link(edition, &edition.language_name);
        match rows.last_mut() {
            Some(row) if row.name == edition.on.control.title => row.links.push(link),
            _ => rows.push(ChoiceRow {
                name: edition.on.control.title.clone(),
                states: edition.on.control.states.clone(),
                cycles: edition.entries.len(),
                links: vec![link],
            }),
        }
    }
    let title = own.text("site-manual", &Args::new())?.into_owned();
    let mut imprint = site.imprint(own)?;
    // The control and its software are in the table.
    imprint.drain(..imprint.len().saturating_sub(2));
    let view = context! {
        page => Value::from(Serde(&PageView { canonical: site.address(""), ..of(site, own, title) })),
        words => own.words.clone(),
        rows => Value::from(Serde(&rows)),
        search => own.path(search::PAGE),
        imprint => imprint,
        texts => site.is_served.then(|| format!("{}/index.html", translation_state::FOLDER)),
        invitations => Value::from(Serde(&invitations(site)?)),
    };
    site.render("index.html", view)
}

/// The page for addresses that do not exist.
pub(super) fn missing(site: &Site) -> Result<String, Vec<Diagnostic>> {
    let own = source_section(site)?;
    // A server shows it at any address, so its links are whole where the address of the site is known.
    let title = MISSING.trim_end_matches(".html").to_owned();
    let root = if site.is_served { "/".to_owned() } else { site.base_url.clone().unwrap_or_default() };
    let view = context! {
        page => Value::from(Serde(&PageView { root, ..of(site, own, title) })),
        words => own.words.clone(),
        invitations => Value::from(Serde(&invitations(site)?)),
    };
    site.render(MISSING, view)
}

/// The first edition in the source language, or in any.
fn source_section<'s, 'a>(site: &'s Site<'a>) -> Result<&'s Edition<'a>, Vec<Diagnostic>> {
    let own = site.editions.iter().find(|one| one.language.tag() == SOURCE_LANGUAGE).or(site.editions.first());
    own.ok_or_else(|| vec![Diagnostic::global("manual-empty")])
}

fn link(edition: &Edition, name: &str) -> SwitchView {
    SwitchView {
        href: edition.path(OVERVIEW),
        lang: edition.language.tag().to_owned(),
        name: name.to_owned(),
        current: false,
        overview: false,
    }
}

/// What the pages say in each language.
fn invitations(site: &Site) -> Result<Vec<Invitation>, Vec<Diagnostic>> {
    let mut invitations: Vec<Invitation> = Vec::new();
    for edition in &site.editions {
        let control = link(edition, &edition.on.control.title);
        if let Some(known) = invitations.iter_mut().find(|own| own.lang == edition.language.tag()) {
            known.controls.push(control);
            continue;
        }
        let text = |id: &str| edition.text(id, &Args::new()).map(|text| text.into_owned());
        invitations.push(Invitation {
            lang: edition.language.tag().to_owned(),
            name: edition.language_name.clone(),
            manual: text("site-manual")?,
            intro: text("site-home-intro")?,
            safety: text("site-home-safety")?,
            missing: text("site-page-missing")?,
            controls: vec![control],
        });
    }
    Ok(invitations)
}

fn of(site: &Site, own: &Edition, title: String) -> PageView {
    PageView { lang: own.language.tag().to_owned(), ..frame(site, title) }
}

/// The frame of a page that belongs to no control and no language.
pub(super) fn frame(site: &Site, title: String) -> PageView {
    PageView {
        book: false,
        draft: site.is_draft,
        lang: String::new(),
        title,
        root: String::new(),
        canonical: None,
        control: String::new(),
        imprint: Vec::new(),
        sheet: None,
        trail: Vec::new(),
        home: String::new(),
        languages: Vec::new(),
        controls: Vec::new(),
        previous: None,
        next: None,
    }
}
