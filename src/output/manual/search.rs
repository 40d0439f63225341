//! The search: a page in each edition, and an index a language that a script of the site reads without a network.
//!
//! The index has every sentence of the pages with the place that it is at, once for all controls that have it in the same
//! words, and the forms of words that have the same stem. Invariant: every page of the index exists.
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use minijinja::value::Serde;
use minijinja::{Value, context};
use serde::Serialize;

use super::Site;
use super::edition::Edition;
use super::page::Here;
use super::stem::{Stems, words};
use crate::base::diag::Diagnostic;
use crate::language::locale::{Args, Language};

/// The file of the page.
pub(super) const PAGE: &str = "search.html";

/// The file of the index of a language.
pub(super) fn index_file(tag: &str) -> String {
    format!("search/{tag}.js")
}

/// A page that can be found.
pub(super) struct Found {
    /// Its file within an edition.
    pub(super) file: String,
    pub(super) title: String,
    /// Its sentences with the ids of the places where they are.
    pub(super) sentences: Vec<(String, String)>,
}

/// The index as the script reads it.
#[derive(Serialize)]
struct Index<'a> {
    language: &'a str,
    /// Id and name of each control; a number of a control is a bit of `on`.
    controls: Vec<(&'a str, &'a str)>,
    /// File and title of each page, and the controls that have it.
    pages: Vec<(&'a str, &'a str, u32)>,
    /// By page: place, sentence and, where they are not those of the page, the controls that have it.
    sentences: Vec<Vec<(&'a str, &'a str, u32)>>,
    /// Stems with several forms: the stem, then the forms.
    stems: Vec<String>,
}

pub(super) fn page(site: &Site, edition: &Edition) -> Result<String, Vec<Diagnostic>> {
    let args = Args::new().text("control", edition.on.control.title.as_str());
    let title = edition.text("page-search-title", &args)?.into_owned();
    let frame = site.frame(edition, title, Here::Every(PAGE))?;
    let context = context! {
        page => Value::from(Serde(&frame)),
        words => edition.words.clone(),
        own => edition.on.id(),
        index => index_file(edition.language.tag()),
    };
    site.render("search.html", context)
}

/// The index of a language; `found` are the pages of its editions, each with the number of its control.
pub(super) fn index(
    language: &Language,
    controls: Vec<(&str, &str)>,
    found: &[(usize, Vec<Found>)],
) -> Result<String, Vec<Diagnostic>> {
    let mut pages: Vec<(&str, &str, u32)> = Vec::new();
    let mut sentences: Vec<Vec<(&str, &str, u32)>> = Vec::new();
    let mut numbers: HashMap<(&str, &str), usize> = HashMap::new();
    let mut known: HashMap<(usize, &str, &str), usize> = HashMap::new();
    for (control, page) in found.iter().flat_map(|(control, pages)| pages.iter().map(move |page| (*control, page))) {
        let bit = 1 << control;
        let number = *numbers.entry((&page.file, &page.title)).or_insert_with(|| {
            pages.push((&page.file, &page.title, 0));
            sentences.push(Vec::new());
            pages.len() - 1
        });
        pages[number].2 |= bit;
        for (place, sentence) in &page.sentences {
            let own = &mut sentences[number];
            let at = *known.entry((number, place, sentence)).or_insert_with(|| {
                own.push((place, sentence, 0));
                own.len() - 1
            });
            own[at].2 |= bit;
        }
    }
    let index =
        Index { language: language.tag(), controls, stems: stems(language, &pages, &sentences), pages, sentences };
    let json = serde_json::to_string(&index)
        .map_err(|error| vec![Diagnostic::global("manual-json").arg("reason", error.to_string())])?;
    Ok(format!("const cikloIndex = {json};\n"))
}

/// The stems that have several forms among the words of the texts, each followed by its forms.
fn stems(language: &Language, pages: &[(&str, &str, u32)], sentences: &[Vec<(&str, &str, u32)>]) -> Vec<String> {
    let stems = Stems::of(language);
    let texts = pages.iter().map(|page| page.1).chain(sentences.iter().flatten().map(|sentence| sentence.1));
    let written: HashSet<&str> = texts.flat_map(words).collect();
    let letters = written.into_iter().filter(|word| !word.bytes().any(|byte| byte.is_ascii_digit()));
    let forms: BTreeSet<String> = letters.map(str::to_lowercase).collect();
    let mut groups: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for form in &forms {
        groups.entry(stems.stem(form)).or_default().push(form);
    }
    let several = |(stem, forms): (String, Vec<&str>)| (forms.len() > 1).then(|| format!("{stem} {}", forms.join(" ")));
    groups.into_iter().filter_map(several).collect()
}

/// The sentences of the content of a page: what is in `main` but for links to other pages and programs. A row of a table
/// is one sentence.
pub fn sentences(html: &str) -> Vec<(String, String)> {
    let inside =
        parted_by(html, "<main").and_then(|(_, rest)| parted_by(rest, "</main>")).map_or(html, |(main, _)| main);
    let inside = parted(inside, b'>').map_or("", |(_, rest)| rest);
    let mut reader = Reader {
        attribute: memchr::memmem::Finder::new(ID),
        found: Vec::new(),
        place: String::new(),
        text: String::new(),
        skipped: 0,
        in_row: false,
    };
    // What only names the cycle and other pages is found there.
    let inside = parted_by(inside, "<section id=\"see-also\"").map_or(inside, |(before, _)| before);
    let facts = parted_by(inside, "<section class=\"facts\"");
    let after = facts.and_then(|(_, facts)| parted_by(facts, "</section>")).map_or("", |(_, after)| after);
    for part in [facts.map_or(inside, |(before, _)| before), after] {
        reader.read(part);
    }
    reader.found
}

/// What is before and after the first such byte, which is no part of another character.
fn parted(text: &str, byte: u8) -> Option<(&str, &str)> {
    let at = memchr::memchr(byte, text.as_bytes())?;
    Some((&text[..at], &text[at + 1..]))
}

/// What is before and after the first such words: pages are long, and their drawings have nothing of what is looked for.
fn parted_by<'t>(text: &'t str, words: &str) -> Option<(&'t str, &'t str)> {
    let at = memchr::memmem::find(text.as_bytes(), words.as_bytes())?;
    Some((&text[..at], &text[at + words.len()..]))
}

/// What stands before the id of an element.
const ID: &str = " id=\"";

/// Puts sentences together from texts and tags.
struct Reader {
    attribute: memchr::memmem::Finder<'static>,
    found: Vec<(String, String)>,
    place: String,
    text: String,
    /// Within how many elements whose text is not searched.
    skipped: usize,
    in_row: bool,
}

/// Elements whose text is on other pages or a title, or is a program.
const SKIPPED: [&str; 5] = ["nav", "pre", "thead", "svg", "h1"];

/// Where a drawing ends.
const DRAWN: &[u8] = b"</svg>";

impl Reader {
    fn read(&mut self, html: &str) {
        let mut rest = html;
        while let Some((text, after)) = parted(rest, b'<') {
            self.text(text);
            let Some((tag, after)) = parted(after, b'>') else { break };
            // A drawing has neither sentences nor places, and it is long.
            if tag.starts_with("svg ") {
                let end = memchr::memmem::find(after.as_bytes(), DRAWN);
                rest = end.and_then(|end| after.get(end + DRAWN.len()..)).unwrap_or_default();
                continue;
            }
            self.tag(tag);
            rest = after;
        }
        self.end();
    }

    fn text(&mut self, text: &str) {
        if self.skipped == 0 {
            self.text.push_str(text);
        }
    }

    fn tag(&mut self, tag: &str) {
        let (closes, name) = tag.strip_prefix('/').map_or((false, tag), |name| (true, name));
        let name = name.split(|c: char| c.is_whitespace()).next().unwrap_or_default();
        if SKIPPED.contains(&name) {
            self.skipped = if closes { self.skipped.saturating_sub(1) } else { self.skipped + 1 };
            return;
        }
        let block =
            matches!(name, "p" | "li" | "h1" | "h2" | "h3" | "dd" | "dl" | "ol" | "ul" | "caption" | "figcaption");
        match name {
            "tr" => {
                self.end();
                self.in_row = !closes;
            }
            _ if block && !self.in_row => self.end(),
            _ if block || matches!(name, "td" | "th" | "div" | "dt" | "br") => self.text.push(' '),
            _ => {}
        }
        if let Some(at) = self.attribute.find(tag.as_bytes()).filter(|_| !closes) {
            let id = &tag[at + ID.len()..];
            self.place.clear();
            self.place.push_str(parted(id, b'"').map_or(id, |(id, _)| id));
        }
    }

    fn end(&mut self) {
        let mut text = self.text.split_whitespace().collect::<Vec<_>>().join(" ");
        self.text.clear();
        if text.contains('&') {
            for (entity, sign) in [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#x2f;", "/"), ("&#x27;", "'")] {
                text = text.replace(entity, sign);
            }
            text = text.replace("&amp;", "&");
        }
        if text.chars().any(char::is_alphanumeric) {
            self.found.push((self.place.clone(), text));
        }
    }
}
