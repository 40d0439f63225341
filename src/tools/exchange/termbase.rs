//! Terms that come back: a termbase, TBX, or a table, as [`super::tbx`] and [`super::csv`] write them.
//!
//! A file has no states of its own: what differs from today's words is what someone has changed, and is taken over after the
//! same checks as a text. What a file leaves out stays as it is; nothing is removed. A concept is only taken over beside its
//! source words as they are today, and only texts without codes: the others travel as XLIFF or PO.
use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::fluent::{Pattern, Piece};
use super::import::{Edit, Edits, settled};
use super::outcome::{Imported, Refusal, Why};
use super::received::Unreadable;
use super::terms::{BETWEEN, Concept, Words, concepts, definition_of};
use super::unit::{self, Text};
use crate::base::xml::{self, Node};
use crate::language::locale::{Key, LocaleError, Locales, Pair, SOURCE_LANGUAGE, Scope};
use crate::spec::Catalogue;

/// Names of the root element: in the form of 2008, and in that of 2019.
const ROOTS: [&str; 2] = ["martif", "tbx"];
const ENTRIES: [&str; 2] = ["termEntry", "conceptEntry"];
const LANGUAGES: [&str; 2] = ["langSet", "langSec"];
const TERMS: [&str; 3] = ["tig", "ntig", "termSec"];
/// The columns that say which word of which language a row of a table has.
const CONCEPT: &str = "concept";
const LANGUAGE: &str = "language";

/// A concept in a language, as a file has it.
#[derive(Clone, Debug)]
pub struct Row {
    /// The message: `term-infeed`.
    pub id: String,
    /// Where it is in the file.
    pub at: usize,
    /// Its words; what the file does not say is empty.
    pub words: Words,
}

/// Whether a file is one with terms, and not one with units.
pub fn is_terms(text: &str) -> bool {
    let begin = text.trim_start_matches('\u{feff}').trim_start();
    root(begin).map_or_else(|| separator(begin).is_some(), |name| ROOTS.contains(&name))
}

/// What separates the columns, if the first line is the head of a table with concepts.
fn separator(begin: &str) -> Option<u8> {
    let head = begin.lines().next().unwrap_or_default();
    let is_concept = |cell: &str| cell.trim().trim_matches('"') == CONCEPT;
    [',', ';', '\t']
        .into_iter()
        .find(|sign| head.contains(*sign) && head.split(*sign).any(is_concept))
        .map(|sign| sign as u8)
}

/// The name of the first element, if this is XML.
fn root(text: &str) -> Option<&str> {
    let mut rest = text;
    loop {
        rest = rest.trim_start().strip_prefix('<')?;
        if rest.starts_with(char::is_alphabetic) {
            return rest.split(|c: char| !c.is_alphanumeric()).next();
        }
        let end = if rest.starts_with("!--") { "-->" } else { ">" };
        rest = rest.split_once(end)?.1;
    }
}

/// The rows of a file with terms.
///
/// # Errors
/// If its form is wrong.
pub fn read_terms(text: &str) -> Result<Vec<Row>, Unreadable> {
    let begin = text.trim_start_matches('\u{feff}').trim_start();
    if begin.starts_with('<') { of_termbase(text) } else { of_table(text) }
}

fn of_termbase(text: &str) -> Result<Vec<Row>, Unreadable> {
    let root = xml::parse(text)?;
    if !ROOTS.contains(&root.name.as_str()) {
        return Err(Unreadable { at: 0, what: "xliff" });
    }
    let mut rows = Vec::new();
    gather(&root, &mut rows);
    Ok(rows)
}

fn gather(node: &Node, rows: &mut Vec<Row>) {
    for child in &node.children {
        if ENTRIES.contains(&child.name.as_str()) {
            let id = child.attribute("id").unwrap_or_default();
            let languages = child.children.iter().filter(|inner| LANGUAGES.contains(&inner.name.as_str()));
            rows.extend(languages.map(|inner| Row { id: id.to_owned(), at: inner.at, words: words(inner) }));
        } else {
            gather(child, rows);
        }
    }
}

fn words(node: &Node) -> Words {
    let mut words = Words {
        language: node.attribute("lang").unwrap_or_default().to_owned(),
        term: String::new(),
        label: None,
        forms: Vec::new(),
        forbidden: Vec::new(),
        definition: None,
    };
    for descrip in described(node) {
        words.definition = Some(line(&descrip.text())).filter(|text| !text.is_empty());
    }
    for term in node.children.iter().filter(|child| TERMS.contains(&child.name.as_str())) {
        let Some(said) = inside(term, "term").map(|term| line(&term.text())) else { continue };
        let note = |kind: &str| {
            let notes = all(term, "termNote").into_iter();
            notes.filter(|note| note.attribute("type") == Some(kind)).map(Node::text).next().unwrap_or_default()
        };
        let status = note("administrativeStatus");
        if status.starts_with("deprecatedTerm") || status.starts_with("supersededTerm") {
            words.forbidden.push(said);
        } else if note("termType") == "abbreviation" {
            words.label = Some(said);
        } else if status.starts_with("preferredTerm") && words.term.is_empty() {
            words.term = said;
            words.forms = inside(term, "note").map_or_else(Vec::new, |note| list(&note.text()));
        }
    }
    words
}

/// The definitions of a concept in a language, in a group or not.
fn described(node: &Node) -> impl Iterator<Item = &Node> {
    let descrips = node.children.iter().flat_map(|child| match child.name.as_str() {
        "descrip" => vec![child],
        "descripGrp" => all(child, "descrip"),
        _ => Vec::new(),
    });
    descrips.filter(|descrip| descrip.attribute("type") == Some("definition"))
}

/// All elements of a name at any depth.
fn all<'n>(node: &'n Node, name: &str) -> Vec<&'n Node> {
    let inner = node.children.iter().flat_map(|child| {
        let own = (child.name == name).then_some(child);
        own.into_iter().chain(all(child, name))
    });
    inner.collect()
}

fn inside<'n>(node: &'n Node, name: &str) -> Option<&'n Node> {
    all(node, name).into_iter().next()
}

fn line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn list(text: &str) -> Vec<String> {
    text.split(BETWEEN.trim()).map(line).filter(|word| !word.is_empty()).collect()
}

/// Where a cell in quotation marks begins that does not end.
fn unclosed(table: &str, separator: u8) -> Option<usize> {
    let mut opened = None;
    // Whether a quotation mark here would begin a cell.
    let mut is_start = true;
    for (at, byte) in table.bytes().enumerate() {
        match (byte, opened) {
            (b'"', None) if is_start => opened = Some(at),
            // A doubled one closes and opens again.
            (b'"', Some(_)) => opened = None,
            _ => {}
        }
        is_start = byte == separator || matches!(byte, b'\n' | b'\r' | b'"');
    }
    opened
}

fn of_table(text: &str) -> Result<Vec<Row>, Unreadable> {
    let table = text.trim_start_matches('\u{feff}').trim_start();
    let begin = text.len() - table.len();
    let separator = separator(table).unwrap_or(b',');
    if let Some(at) = unclosed(table, separator) {
        return Err(Unreadable { at: begin + at, what: "quote" });
    }
    // A row may be said to begin before the end of the line above it.
    let place = |at: u64| {
        let at = usize::try_from(at).map_or(table.len(), |at| at.min(table.len()));
        let rest = table.get(at..).unwrap_or_default();
        begin + at + (rest.len() - rest.trim_start_matches(['\r', '\n']).len())
    };
    let mut reader = csv::ReaderBuilder::new().delimiter(separator).from_reader(table.as_bytes());
    let refused = |error: &csv::Error| Unreadable {
        at: error.position().map_or(begin, |position| place(position.byte())),
        what: "form",
    };
    let head = reader.headers().map_err(|error| refused(&error))?.clone();
    let column = |name: &str| head.iter().position(|own| own.trim() == name);
    let (Some(concept), Some(language)) = (column(CONCEPT), column(LANGUAGE)) else {
        return Err(Unreadable { at: begin, what: "columns" });
    };
    let columns = ["term", "label", "forms", "forbidden", "definition"].map(column);
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| refused(&error))?;
        let cell = |at: Option<usize>| at.and_then(|at| record.get(at)).map(line).unwrap_or_default();
        let [term, label, forms, forbidden, definition] = columns.map(cell);
        rows.push(Row {
            id: cell(Some(concept)),
            at: record.position().map_or(begin, |position| place(position.byte())),
            words: Words {
                language: cell(Some(language)),
                term,
                label: Some(label).filter(|label| !label.is_empty()),
                forms: list(&forms),
                forbidden: list(&forbidden),
                definition: Some(definition).filter(|text| !text.is_empty()),
            },
        });
    }
    Ok(rows)
}

/// What one text of a concept is to say.
struct Wish {
    key: String,
    attribute: Option<&'static str>,
    new: String,
    now: String,
}

/// Takes over what is new in the words of a language.
///
/// # Errors
/// If the source language was not loaded.
pub fn import_terms(
    catalogue: &Catalogue,
    files: &[(String, String)],
    tag: &str,
    rows: &[Row],
) -> Result<Imported, LocaleError> {
    let (locales, before) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    let mut texts = unit::texts(&locales, tag)?;
    let today: BTreeMap<String, Concept> =
        concepts(&locales, &[tag.to_owned()]).into_iter().map(|concept| (concept.id.clone(), concept)).collect();
    let sources: HashMap<&str, &Words> = of(rows, SOURCE_LANGUAGE).map(|row| (row.id.as_str(), &row.words)).collect();
    let mut times: HashMap<&str, usize> = HashMap::new();
    of(rows, tag).for_each(|row| *times.entry(&row.id).or_default() += 1);
    let mut imported = Imported::default();
    let (mut edits, mut own) = (Edits::new(), BTreeSet::new());
    for row in of(rows, tag) {
        let refuse = |id: &str, why| Refusal { id: id.to_owned(), at: row.at, why };
        if times.get(row.id.as_str()).is_some_and(|times| *times > 1) {
            imported.refused.push(refuse(&row.id, Why::Twice));
            continue;
        }
        let Some(concept) = today.get(&row.id) else {
            imported.refused.push(refuse(&row.id, Why::Unknown));
            continue;
        };
        let known = concept.words.iter().find(|words| words.language == tag);
        let wishes: Vec<Wish> = wishes(&row.id, &row.words, known).collect();
        let (same, other): (Vec<Wish>, Vec<Wish>) = wishes.into_iter().partition(|wish| wish.new == wish.now);
        imported.unchanged += same.len();
        let source = concept.words.first().filter(|words| words.language == SOURCE_LANGUAGE);
        let is_of_today = match (sources.get(row.id.as_str()), source) {
            (Some(file), Some(source)) => is_same(file, source),
            _ => false,
        };
        for wish in other {
            if !is_of_today {
                imported.refused.push(refuse(&wish.key, Why::SourceChanged));
                continue;
            }
            let text = match texts.iter().position(|text| text.pair.key == wish.key) {
                Some(at) => at,
                None => {
                    let added = wish.attribute.filter(|name| OWN.contains(name));
                    let Some(text) = added.and_then(|name| text_of(&locales, tag, &texts, &row.id, name)) else {
                        imported.refused.push(refuse(&wish.key, Why::Unknown));
                        continue;
                    };
                    own.insert(wish.key.clone());
                    texts.push(text);
                    texts.len() - 1
                }
            };
            let codes = texts.get(text).map_or_else(Vec::new, codes);
            if !codes.is_empty() {
                let why = Why::Codes { missing: codes.join(", "), foreign: String::new() };
                imported.refused.push(refuse(&wish.key, why));
                continue;
            }
            let edit = Edit { at: row.at, text, path: String::new(), pieces: vec![Piece::Text(wish.new)] };
            edits.insert(wish.key, edit);
        }
    }
    in_order(&mut texts, &mut edits);
    settled(catalogue, files, tag, (&locales, before), &texts, edits, &mut imported);
    // What a language has alone is not accepted by its source.
    imported.confirmed.retain(|key| !own.contains(key));
    imported.refused.sort_by_key(|refusal| refusal.at);
    Ok(imported)
}

/// Attributes that a language may have alone.
const OWN: [&str; 2] = ["forms", "forbidden"];

fn of<'r>(rows: &'r [Row], tag: &str) -> impl Iterator<Item = &'r Row> {
    rows.iter().filter(move |row| row.words.language == tag)
}

fn wishes(id: &str, new: &Words, now: Option<&Words>) -> impl Iterator<Item = Wish> {
    let lists = |words: &Words| [words.forms.join(BETWEEN), words.forbidden.join(BETWEEN)];
    let of = |words: &Words| {
        let [forms, forbidden] = lists(words);
        let (label, definition) = (words.label.clone(), words.definition.clone());
        [words.term.clone(), label.unwrap_or_default(), definition.unwrap_or_default(), forms, forbidden]
    };
    let names = [None, Some("label"), Some(definition_of(id)), Some(OWN[0]), Some(OWN[1])];
    let now = now.map(of).unwrap_or_default();
    let id = id.to_owned();
    let all = names.into_iter().zip(of(new)).zip(now).map(move |((attribute, new), now)| Wish {
        key: attribute.map_or_else(|| id.clone(), |name| format!("{id}.{name}")),
        attribute,
        new,
        now,
    });
    all.filter(|wish| !wish.new.is_empty())
}

/// Whether a file has the source words of today, as far as it has them.
fn is_same(file: &Words, today: &Words) -> bool {
    let same = |file: &Option<String>, today: &Option<String>| file.is_none() || file == today;
    file.term == today.term && same(&file.label, &today.label) && same(&file.definition, &today.definition)
}

fn codes(text: &Text) -> Vec<String> {
    let source = text.source.pieces(text.pair.source.source.text());
    let target = text.target.as_ref().zip(text.pair.target.as_ref());
    let target = target.map_or_else(Vec::new, |(target, place)| target.pieces(place.source.text()));
    let code = |piece: Piece| match piece {
        Piece::Code(code) => Some(code),
        Piece::Text(_) => None,
    };
    source.into_iter().chain(target).filter_map(code).collect()
}

/// An attribute that the source need not have, as a text of its own.
fn text_of(locales: &Locales, tag: &str, texts: &[Text], id: &str, name: &'static str) -> Option<Text> {
    let message = texts.iter().find(|text| text.pair.key == id)?;
    let key = Key { id, attribute: Some(name) };
    let place = locales.language(tag).ok().and_then(|language| language.raw(key, Scope::NONE)).map(|(_, place)| place);
    let target = place.as_ref().and_then(|place| Pattern::after(place.source.text(), place.span.start..place.span.end));
    Some(Text {
        pair: Pair {
            key: format!("{id}.{name}"),
            id: id.to_owned(),
            source: message.pair.source.clone(),
            target: place.clone(),
        },
        path: place.map_or_else(|| message.path.clone(), |place| place.source.name().to_owned()),
        source: message.source.clone(),
        target,
    })
}

/// Puts added texts after the others of their message.
fn in_order(texts: &mut [Text], edits: &mut Edits) {
    let mut places: HashMap<String, usize> = HashMap::new();
    for text in texts.iter() {
        let next = places.len();
        places.entry(text.pair.key.split('.').next().unwrap_or_default().to_owned()).or_insert(next);
    }
    let message = |text: &Text| places.get(text.pair.key.split('.').next().unwrap_or_default()).copied();
    texts.sort_by_key(message);
    let by_key: HashMap<&str, usize> =
        texts.iter().enumerate().map(|(at, text)| (text.pair.key.as_str(), at)).collect();
    for (key, edit) in edits.iter_mut() {
        edit.text = by_key.get(key.as_str()).copied().unwrap_or(edit.text);
    }
}
