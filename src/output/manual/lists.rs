//! The lists of an edition: by Q parameter, by keyword, and the glossary.
use std::collections::BTreeMap;

use minijinja::value::Serde;
use minijinja::{Value, context};
use serde::Serialize;

use super::edition::{Edition, Entry, GLOSSARY, PARAMETERS, TERM};
use super::links::Linker;
use super::page::{Here, link};
use super::view::{LetterView, LinkView, QView, TermView, UseView};
use super::{Site, inline};
use crate::base::diag::Diagnostic;
use crate::language::locale::{Args, Scope};
use crate::language::text::with_texts;

/// The file of the index.
pub(super) const KEYWORDS: &str = "keywords.html";

/// A parameter of a cycle with its name.
struct Used<'s, 'a> {
    entry: &'s Entry<'a>,
    /// `Q200`, and nothing for old-style fields.
    q: Option<String>,
    name: String,
}

/// Every parameter of every cycle, in the order of the cycles.
fn used<'s, 'a>(edition: &'s Edition<'a>) -> Result<Vec<Used<'s, 'a>>, Vec<Diagnostic>> {
    let mut all = Vec::new();
    let mut faults = Vec::new();
    for entry in &edition.entries {
        let names = with_texts(edition.on, entry.cycle, edition.language, |text| {
            let named = |param: &crate::spec::Param| (param.q.map(|q| q.to_string()), text.name_of(param).into_owned());
            text.cycle.params.iter().map(named).collect::<Vec<_>>()
        });
        match names {
            Ok(names) => all.extend(names.into_iter().map(|(q, name)| Used { entry, q, name })),
            Err(more) => faults.extend(more),
        }
    }
    if faults.is_empty() { Ok(all) } else { Err(faults) }
}

/// The link to a parameter on the page of its cycle.
fn to_parameter(used: &Used) -> LinkView {
    let mut link = link(used.entry);
    if let (Some(href), Some(q)) = (&mut link.href, &used.q) {
        href.push('#');
        href.push_str(q);
    }
    link
}

/// Adds a place below a name, each place once.
fn add(uses: &mut Vec<UseView>, name: &str, place: LinkView) {
    let at = uses.iter().position(|known| known.name == name).unwrap_or_else(|| {
        uses.push(UseView { name: name.to_owned(), places: Vec::new() });
        uses.len() - 1
    });
    let places = &mut uses[at].places;
    if !places.iter().any(|known| known.href == place.href) {
        places.push(place);
    }
}

fn render(
    site: &Site,
    edition: &Edition,
    (file, title, template): (&str, &str, &str),
    list: &impl Serialize,
) -> Result<String, Vec<Diagnostic>> {
    let args = Args::new().text("control", edition.on.control.title.as_str());
    let title = edition.text(title, &args)?.into_owned();
    let frame = site.frame(edition, title, Here::Every(file))?;
    let context = context! {
        page => Value::from(Serde(&frame)),
        words => edition.words.clone(),
        list => Value::from(Serde(list)),
    };
    site.render(template, context)
}

/// Where is Q351 used, and what is it called there?
pub(super) fn parameters(site: &Site, edition: &Edition) -> Result<String, Vec<Diagnostic>> {
    let mut by_q: BTreeMap<(u64, String), Vec<UseView>> = BTreeMap::new();
    for used in used(edition)? {
        let Some(q) = &used.q else { continue };
        let number = q.trim_start_matches(|c: char| !c.is_ascii_digit()).parse().unwrap_or(0);
        add(by_q.entry((number, q.clone())).or_default(), &used.name, to_parameter(&used));
    }
    let list: Vec<QView> = by_q.into_iter().map(|((_, q), uses)| QView { q, uses }).collect();
    render(site, edition, (PARAMETERS, "page-parameters-title", "parameters.html"), &list)
}

/// Cycles, parameters, topics and terms, in the order of the language.
pub(super) fn keywords(site: &Site, edition: &Edition) -> Result<String, Vec<Diagnostic>> {
    let mut uses: BTreeMap<String, Vec<LinkView>> = BTreeMap::new();
    let mut note = |name: &str, place: LinkView| {
        let places = uses.entry(name.to_owned()).or_default();
        if !places.iter().any(|known| known.href == place.href) {
            places.push(place);
        }
    };
    for entry in &edition.entries {
        note(&entry.name, link(entry));
    }
    for used in used(edition)? {
        note(&used.name, to_parameter(&used));
    }
    for topic in &edition.topics {
        note(&topic.title, plain_link(topic.file.clone(), topic.title.clone()));
    }
    for term in terms(edition)? {
        let word = edition.text("site-glossary", &Args::new())?.into_owned();
        note(&term.term, plain_link(format!("{GLOSSARY}#{}", term.id), word));
    }
    let mut entries: Vec<UseView> = uses.into_iter().map(|(name, places)| UseView { name, places }).collect();
    edition
        .language
        .collation()
        .sort_by_key(&mut entries, |entry| entry.name.trim_start_matches(|c: char| !c.is_alphanumeric()));
    let mut letters: Vec<LetterView> = Vec::new();
    for entry in entries {
        let letter = letter(&entry.name);
        match letters.last_mut() {
            Some(last) if edition.language.collation().same(&last.letter, &letter) => last.entries.push(entry),
            _ => letters.push(LetterView { id: format!("letter-{}", letters.len() + 1), letter, entries: vec![entry] }),
        }
    }
    render(site, edition, (KEYWORDS, "page-keywords-title", "keywords.html"), &letters)
}

fn plain_link(href: String, name: String) -> LinkView {
    LinkView { href: Some(href), key: String::new(), number: 0, name, name_lang: None }
}

/// The letter under which a name is listed; digits share a heading.
fn letter(name: &str) -> String {
    match name.chars().find(|c| c.is_alphanumeric()) {
        Some(c) if c.is_alphabetic() => c.to_uppercase().collect(),
        _ => "0\u{2013}9".to_owned(),
    }
}

pub(super) fn terms(edition: &Edition) -> Result<Vec<TermView>, Vec<Diagnostic>> {
    let mut views = Vec::new();
    for (at, id) in edition.terms.iter().enumerate() {
        let linker = Linker::of_term(edition, at);
        let key = format!("{TERM}{id}");
        let definition = edition.text(&format!("{key}.definition"), &Args::new())?;
        views.push(TermView {
            id: format!("term-{id}"),
            term: edition.text(&key, &Args::new())?.into_owned(),
            definition: Value::from_safe_string(inline::html(&definition, &linker)),
            source: None,
        });
    }
    edition.language.collation().sort_by_key(&mut views, |view| &view.term);
    Ok(views)
}

/// The words of the trade.
pub(super) fn glossary(site: &Site, edition: &Edition) -> Result<String, Vec<Diagnostic>> {
    let mut list = terms(edition)?;
    for view in &mut list {
        let word = site.source.and_then(|source| source.plain(view.id.as_str(), &Scope::NONE).ok());
        view.source = word.map(|word| word.into_owned()).filter(|word| *word != view.term);
    }
    render(site, edition, (GLOSSARY, "page-glossary-title", "glossary.html"), &list)
}
