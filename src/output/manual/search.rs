//! The search of a section: a page, and an index that a script of the site reads without a network.
//!
//! The index lists every form of every word that the pages contain, with its stem: a form that a
//! reader types leads to all forms of the word. Invariant: every page of the index exists.
use std::collections::{BTreeMap, BTreeSet};

use minijinja::value::Serde;
use minijinja::{Value, context};
use serde::Serialize;

use super::page::Here;
use super::section::Section;
use super::stem::{Stems, words};
use super::{Site, cycle, lists, topic};
use crate::base::diag::Diagnostic;
use crate::language::locale::Args;

/// The file of the page.
pub(super) const PAGE: &str = "search.html";
/// The file of the index.
pub(super) const INDEX: &str = "search-index.js";

/// What a word counts in a title, as against elsewhere on the page.
const IN_TITLE: u32 = 8;
/// More of the same word on one page says nothing more.
const MOST: u32 = 9;

/// The index as the script reads it.
#[derive(Serialize)]
struct Index {
    /// File and title of each page.
    pages: Vec<(String, String)>,
    /// Each form of a word in order, with the number of its stem.
    forms: Vec<(String, usize)>,
    /// By stem: numbers of pages, each followed by its weight.
    stems: Vec<Vec<u32>>,
}

pub(super) fn page(site: &Site, section: &Section) -> Result<String, Vec<Diagnostic>> {
    let args = Args::new().text("control", section.on.control.title.as_str());
    let title = section.text("page-search-title", &args)?.into_owned();
    let frame = site.frame(section, title, Here::Every(PAGE));
    let context = context! { page => Value::from(Serde(&frame)), words => section.words.clone() };
    site.render("search.html", context)
}

pub(super) fn index(site: &Site, section: &Section) -> Result<String, Vec<Diagnostic>> {
    let stems = Stems::of(section.language);
    let mut pages = Vec::new();
    let mut weights: BTreeMap<String, BTreeMap<u32, u32>> = BTreeMap::new();
    let mut forms: BTreeSet<String> = BTreeSet::new();
    let mut add = |file: &str, title: String, text: &str| {
        let page = pages.len() as u32;
        let found = words(&title).map(|word| (word, IN_TITLE)).chain(words(text).map(|word| (word, 1)));
        for (word, weight) in found {
            let total = weights.entry(stems.stem(&word)).or_default().entry(page).or_default();
            *total = (*total + weight).min(IN_TITLE + MOST);
            forms.insert(word);
        }
        pages.push((file.to_owned(), title));
    };
    for (at, entry) in section.entries.iter().enumerate() {
        let html = cycle::page(site, section, at)?;
        add(&entry.file, format!("{} {}", entry.cycle.key, entry.name), &content(&html));
    }
    for (at, own) in section.topics.iter().enumerate() {
        add(&own.file, own.title.clone(), &content(&topic::page(site, section, at)?));
    }
    let glossary = lists::glossary(site, section)?;
    add(lists::GLOSSARY, section.text("site-glossary", &Args::new())?.into_owned(), &content(&glossary));
    let numbers: BTreeMap<&str, usize> = weights.keys().enumerate().map(|(at, stem)| (stem.as_str(), at)).collect();
    let numbered = |form: &String| Some((form.clone(), *numbers.get(stems.stem(form).as_str())?));
    let index = Index {
        forms: forms.iter().filter_map(numbered).collect(),
        stems: weights.values().map(|on| on.iter().flat_map(|(page, weight)| [*page, *weight]).collect()).collect(),
        pages,
    };
    let json = serde_json::to_string(&index)
        .map_err(|error| vec![Diagnostic::global("manual-json").arg("reason", error.to_string())])?;
    Ok(format!("const cikloIndex = {json};\n"))
}

/// The text of the content of a page: what is in `main`, without marks.
fn content(html: &str) -> String {
    let inside =
        html.split_once("<main").and_then(|(_, rest)| rest.split_once("</main>")).map_or(html, |(main, _)| main);
    let mut out = String::with_capacity(inside.len() / 2);
    let mut in_tag = true;
    for c in inside.chars() {
        match c {
            '<' => {
                in_tag = true;
                out.push(' ');
            }
            '>' => in_tag = false,
            c if !in_tag => out.push(c),
            _ => {}
        }
    }
    // Only these can occur in the pages; the rest of the characters are themselves.
    out.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
}
