//! Translations that come back: which of them are sound, and the files with them in place.
//!
//! Invariant: only bytes of texts that are taken over change; what is refused is named with the reason.
use std::cell::LazyCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::fluent::{Pattern, Piece, flat, merged, written};
use super::outcome::{Imported, Refusal, Why};
use super::prose;
use super::received::{Received, code_length, has_hidden};
use super::unit::{self, Text, Unit};
use crate::base::diag::{Arg, Diagnostic};
use crate::language::consistency::{self, Negation};
use crate::language::label;
use crate::language::locale::{LocaleError, Locales};
use crate::spec::Catalogue;

/// So often the texts are checked again after some of them were refused.
const ROUNDS: usize = 6;

/// So often units with unsound ones among them are divided.
const ATTEMPTS: usize = 24;

/// What the codes of findings about labels begin with; they are at the text of the label.
const LABEL: &str = "label-";

/// A unit that can be taken over.
#[derive(Clone)]
pub(super) struct Edit {
    /// Where it is in the file.
    pub(super) at: usize,
    /// Its text, by number.
    pub(super) text: usize,
    /// Which variant of it.
    pub(super) path: String,
    pub(super) pieces: Vec<Piece>,
}

pub(super) type Edits = BTreeMap<String, Edit>;

/// Takes over the final units of a file for a language.
///
/// # Errors
/// If the source language was not loaded.
pub fn import(
    catalogue: &Catalogue,
    files: &[(String, String)],
    tag: &str,
    received: Vec<Received>,
) -> Result<Imported, LocaleError> {
    let (locales, before) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    let texts = unit::texts(&locales, tag)?;
    let mut imported = Imported::default();
    let (of_pages, received) = received.into_iter().partition(|unit| unit.id.starts_with(prose::TOPICS));
    let negation = Negation::of(&locales, tag);
    let negation = negation.as_ref();
    let mut edits = sift(&texts, tag, received, negation, &mut imported);
    drop_incomplete(&texts, tag, &mut edits, &mut imported);
    settled(catalogue, files, tag, (&locales, before), &texts, edits, &mut imported);
    prose::import(files, &prose::pages(&locales, tag), of_pages, negation, &mut imported);
    imported.refused.sort_by_key(|refusal| refusal.at);
    Ok(imported)
}

/// Takes over the edits that the checks of texts have nothing against, and refuses the others.
pub(super) fn settled(
    catalogue: &Catalogue,
    files: &[(String, String)],
    tag: &str,
    (locales, before): (&Locales, Vec<Diagnostic>),
    texts: &[Text],
    mut edits: Edits,
    imported: &mut Imported,
) {
    // What is found today matters only where something is found afterwards.
    let before = LazyCell::new(|| findings(catalogue, locales, tag, before));
    let known = LazyCell::new(|| before.iter().map(signature).collect::<BTreeSet<_>>());
    let shared: BTreeSet<String> = consistency::shared_labels(locales).iter().map(signature).collect();
    drop_swapped(texts, || &before, &mut edits, imported);
    let new = |edits: &Edits| {
        let changed = applied(files, texts, tag, edits);
        let own: HashMap<&str, &str> = changed.iter().map(|(path, text)| (path.as_str(), text.as_str())).collect();
        let kept = files.iter().filter(|(path, _)| !own.contains_key(path.as_str()));
        let all = kept.map(|(path, text)| (path.as_str(), text.as_str())).chain(own.iter().map(|(a, b)| (*a, *b)));
        let (after, found) = Locales::load(all);
        let mut found = findings(catalogue, &after, tag, found);
        found.retain(|found| !known.contains(&signature(found)));
        let labels = consistency::shared_labels(&after);
        found.extend(labels.into_iter().filter(|found| !shared.contains(&signature(found))));
        found
    };
    let had = locales.language(tag).is_ok();
    let mut attempts = ATTEMPTS;
    for round in 0..=ROUNDS {
        let found = if edits.is_empty() { Vec::new() } else { new(&edits) };
        if found.is_empty() {
            break;
        }
        if !refuse(texts, &found, &mut edits, imported) {
            // In a new language, what is missing is found in many places.
            if !had {
                break;
            }
            for (id, why) in culprits(&edits, &new, &mut attempts) {
                drop_one(&id, why, &mut edits, imported);
            }
        }
        if round == ROUNDS {
            let first = found.first().map(|found| Box::new(found.clone()));
            for (id, why) in edits.keys().cloned().zip(std::iter::repeat(first)).collect::<Vec<_>>() {
                why.into_iter().for_each(|why| drop_one(&id, why, &mut edits, imported));
            }
        }
        drop_incomplete(texts, tag, &mut edits, imported);
    }
    imported.files = applied(files, texts, tag, &edits);
    let refused: BTreeSet<&str> = imported.refused.iter().map(|refusal| key_of(&refusal.id)).collect();
    let mut confirmed = std::mem::take(&mut imported.confirmed);
    confirmed.extend(edits.values().filter_map(|edit| texts.get(edit.text)).map(|text| text.pair.key.clone()));
    confirmed.retain(|key| !refused.contains(key.as_str()));
    confirmed.sort();
    confirmed.dedup();
    imported.confirmed = confirmed;
    imported.taken = edits.into_keys().collect();
}

/// The key of the text that a unit belongs to.
fn key_of(id: &str) -> &str {
    id.split('#').next().unwrap_or(id)
}

/// Final units that are sound by themselves and differ from what is there.
fn sift(
    texts: &[Text],
    tag: &str,
    received: Vec<Received>,
    negation: Option<&Negation>,
    imported: &mut Imported,
) -> Edits {
    let mut known: HashMap<String, (usize, Unit)> = HashMap::new();
    for (index, text) in texts.iter().enumerate() {
        known.extend(unit::units_of(text, tag).into_iter().map(|(unit, _)| (unit.id.clone(), (index, unit))));
    }
    let mut times: HashMap<String, usize> = HashMap::new();
    received.iter().for_each(|unit| *times.entry(unit.id.clone()).or_default() += 1);
    let mut edits = Edits::new();
    let mut open: BTreeSet<String> = BTreeSet::new();
    for unit in received {
        let at = unit.at;
        if !unit.is_final {
            imported.passed_over += 1;
            open.insert(key_of(&unit.id).to_owned());
            continue;
        }
        let is_twice = times.get(&unit.id).is_some_and(|times| *times > 1);
        match known
            .get(&unit.id)
            .ok_or(Why::Unknown)
            .and_then(|(text, own)| Ok((*text, own, sound(own, unit.clone(), negation, is_twice)?)))
        {
            Err(why) => imported.refused.push(Refusal { id: unit.id, at, why }),
            Ok((_, own, None)) => {
                imported.unchanged += 1;
                imported.confirmed.push(own.key.clone());
            }
            Ok((text, own, Some(pieces))) => {
                let path = unit.id.get(own.key.len()..).unwrap_or_default().to_owned();
                edits.insert(unit.id, Edit { at, text, path, pieces });
            }
        }
    }
    imported.confirmed.retain(|key| !open.contains(key));
    edits
}

/// The new pieces of a unit; nothing if they are those that are there.
fn sound(own: &Unit, unit: Received, negation: Option<&Negation>, is_twice: bool) -> Result<Option<Vec<Piece>>, Why> {
    if is_twice {
        return Err(Why::Twice);
    }
    let unit = unit.into_exported_form(&merged(own.source.clone()), &own.target);
    if unit.source.as_ref() != Some(&merged(own.source.clone())) {
        return Err(Why::SourceChanged);
    }
    let pieces = trimmed(unit.target.clone().ok_or(Why::NotRead)?);
    if pieces.is_empty() || has_hidden(&pieces) {
        return Err(Why::NotRead);
    }
    if pieces == trimmed(merged(own.target.clone())) {
        return Ok(None);
    }
    check_codes(own, &pieces)?;
    if negation.is_some_and(|words| words.is_lost(&flat(&own.source), &flat(&own.target), &flat(&pieces))) {
        return Err(Why::Negation);
    }
    Ok(Some(pieces))
}

fn trimmed(mut pieces: Vec<Piece>) -> Vec<Piece> {
    let blank = [' ', '\n', '\t', '\r'];
    if let Some(Piece::Text(words)) = pieces.first_mut() {
        *words = words.trim_start_matches(blank).to_owned();
    }
    if let Some(Piece::Text(words)) = pieces.last_mut() {
        *words = words.trim_end_matches(blank).to_owned();
    }
    merged(pieces)
}

/// What a code is, so that two can be compared: a term whatever its case, anything else as it is; nothing for literals,
/// which a translation has as it needs them.
fn identity(code: &str) -> Option<String> {
    let inside = code.trim_start_matches('{').trim_end_matches('}').trim();
    if inside.starts_with('"') {
        return None;
    }
    let end = if inside.starts_with('-') { inside.find(['(', ' ', '.']).unwrap_or(inside.len()) } else { inside.len() };
    Some(inside.get(..end).unwrap_or(inside).split_whitespace().collect::<Vec<_>>().join(" "))
}

fn codes(pieces: &[Piece]) -> impl Iterator<Item = &str> {
    pieces.iter().filter_map(|piece| match piece {
        Piece::Code(code) => Some(code.as_str()),
        Piece::Text(_) => None,
    })
}

fn check_codes(own: &Unit, pieces: &[Piece]) -> Result<(), Why> {
    let set = |pieces: &[Piece]| codes(pieces).filter_map(identity).collect::<BTreeSet<String>>();
    let (source, target, new) = (set(&own.source), set(&own.target), set(pieces));
    let needed: Vec<&String> = source.iter().filter(|code| own.target.is_empty() || target.contains(*code)).collect();
    let missing: Vec<&str> = needed.into_iter().filter(|code| !new.contains(*code)).map(String::as_str).collect();
    // What a file gives as a code must be one, and no more than one.
    let is_one = |code: &str| code_length(code) == Some(code.len()) && !code.contains('\n');
    let is_literal = |code: &str| {
        let inside = code.trim_start_matches('{').trim_end_matches('}').trim();
        inside.len() > 1 && inside.matches('"').count() == 2 && inside.ends_with('"')
    };
    let mut foreign = Vec::new();
    for code in codes(pieces) {
        let known = match identity(code) {
            None => is_literal(code),
            Some(id) => source.contains(&id) || target.contains(&id),
        };
        let as_it_was = codes(&own.source).chain(codes(&own.target)).any(|own| own == code);
        if !as_it_was && !(known && is_one(code)) {
            foreign.push(code);
        }
    }
    if missing.is_empty() && foreign.is_empty() {
        return if exchanged(&own.target, pieces) { Err(Why::Exchanged) } else { Ok(()) };
    }
    Err(Why::Codes { missing: missing.join(", "), foreign: foreign.join(", ") })
}

/// Whether the words are those that are there and only codes have changed places among them.
fn exchanged(old: &[Piece], new: &[Piece]) -> bool {
    let words = |pieces: &[Piece]| -> Vec<String> {
        let words = merged(pieces.to_vec()).into_iter().map(|piece| match piece {
            Piece::Text(words) => words.trim().to_owned(),
            Piece::Code(_) => String::new(),
        });
        words.collect()
    };
    let sorted = |pieces: &[Piece]| {
        let mut all: Vec<String> = codes(pieces).map(str::to_owned).collect();
        all.sort_unstable();
        all
    };
    words(old) == words(new) && sorted(old) == sorted(new) && !codes(old).eq(codes(new))
}

/// What the identifiers of texts begin with that are chosen from, so that each has the others beside it.
const CHOSEN: [&str; 2] = ["choice-", "result-"];

/// Two choices, or two results, that have got the words of each other, unless the checks found them exchanged before.
fn drop_swapped<'d>(
    texts: &[Text],
    before: impl Fn() -> &'d Vec<Diagnostic>,
    edits: &mut Edits,
    imported: &mut Imported,
) {
    let old = |edit: &Edit| {
        let text = texts.get(edit.text)?;
        let is_one = CHOSEN.iter().any(|head| text.pair.id.starts_with(head)) && edit.path.is_empty();
        let (target, place) = (text.target.as_ref()?, text.pair.target.as_ref()?);
        is_one.then(|| (trimmed(merged(target.pieces(place.source.text()))), text.pair.key.clone()))
    };
    let known: Vec<(&String, Vec<Piece>, String)> =
        edits.iter().filter_map(|(id, edit)| old(edit).map(|(pieces, key)| (id, pieces, key))).collect();
    let by_words: HashMap<String, &(&String, Vec<Piece>, String)> =
        known.iter().map(|own| (flat(&own.1), own)).collect();
    let said = |found: &Diagnostic, name, key: &str| matches!(found.get(name), Some(Arg::Text(text)) if text == key);
    let is_found = |one: &str, other: &str| {
        before().iter().any(|found| {
            found.code == consistency::SWAPPED
                && (said(found, "key", one) && said(found, "other", other)
                    || said(found, "key", other) && said(found, "other", one))
        })
    };
    let mut swapped = Vec::new();
    for (id, words, key) in &known {
        let Some(edit) = edits.get(*id) else { continue };
        let Some((other_id, other_words, other_key)) = by_words.get(&flat(&edit.pieces)) else { continue };
        let is_back = edits.get(*other_id).is_some_and(|other| other.pieces == *words);
        if is_back && edit.pieces == *other_words && !is_found(key, other_key) {
            swapped.push(((*id).clone(), other_key.clone()));
        }
    }
    for (id, other) in swapped {
        if let Some(edit) = edits.remove(&id) {
            imported.refused.push(Refusal { id, at: edit.at, why: Why::Swapped { other } });
        }
    }
}

/// Texts that the language does not have yet need all of their units.
fn drop_incomplete(texts: &[Text], tag: &str, edits: &mut Edits, imported: &mut Imported) {
    let mut short: Vec<String> = Vec::new();
    for (id, edit) in edits.iter() {
        let Some(text) = texts.get(edit.text).filter(|text| text.target.is_none()) else { continue };
        if unit::units_of(text, tag).iter().any(|(unit, _)| !edits.contains_key(&unit.id)) {
            short.push(id.clone());
        }
    }
    for id in short {
        if let Some(edit) = edits.remove(&id) {
            imported.refused.push(Refusal { id, at: edit.at, why: Why::Incomplete });
        }
    }
}

/// What the checks of texts find in all languages.
fn findings(catalogue: &Catalogue, locales: &Locales, tag: &str, mut found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    if let Ok(audit) = locales.audit(tag) {
        let of_texts = |one: &Diagnostic| matches!(one.code, "locale-unknown-argument" | "locale-same-as-source");
        found.extend(audit.diagnostics().into_iter().filter(of_texts));
    }
    found.extend(label::check(catalogue, locales));
    found.extend(consistency::check_translations(catalogue, locales));
    // What a language lacks is no fault of a text that it has.
    found.retain(|one| one.code != consistency::VARIANT);
    found
}

/// What a finding says, wherever in its file it is.
fn signature(found: &Diagnostic) -> String {
    let file = found.place.as_ref().map_or("", |place| place.source.name());
    format!("{} {file} {:?}", found.code, found.args)
}

fn drop_one(id: &str, why: Box<Diagnostic>, edits: &mut Edits, imported: &mut Imported) {
    if let Some(edit) = edits.remove(id) {
        imported.refused.push(Refusal { id: id.to_owned(), at: edit.at, why: Why::Found(why) });
    }
}

/// Removes the units that new findings are about, and says whether there were any.
fn refuse(texts: &[Text], new: &[Diagnostic], edits: &mut Edits, imported: &mut Imported) -> bool {
    let mut any = false;
    for found in new {
        let named = message_at(found);
        let said = |name| match found.get(name) {
            Some(Arg::Text(text)) => Some(text.as_str()),
            _ => None,
        };
        let key = said("key");
        // Of which attribute, where the finding says that.
        let of = key.and_then(|key| key.split_once('.')).map(|(_, attribute)| attribute);
        // Where a label is tells which of the variants of its text it is.
        let by_place = found.code.starts_with(LABEL) && named.is_some();
        let concerns = |edit: &Edit| {
            let Some(text) = texts.get(edit.text) else { return false };
            let (message, attribute) =
                text.pair.key.split_once('.').map_or((text.pair.key.as_str(), None), |(a, b)| (a, Some(b)));
            let is_named =
                named.as_deref() == Some(message.trim_start_matches('-')) && (of.is_none() || of == attribute);
            is_named || !by_place && key.is_some_and(|key| key == text.pair.key || key == text.pair.id)
        };
        // The other one of two that do not agree, or the word of the glossary that a text does not keep to.
        let concerns_too = |edit: &Edit| {
            let Some(text) = texts.get(edit.text) else { return false };
            let is_label = text.pair.key.ends_with(".label")
                && matches!(edit.pieces.as_slice(), [Piece::Text(words)] if said("label") == Some(words));
            // Specifications are named without what the identifiers of their messages begin with.
            let is_choice = text.pair.id.strip_prefix("choice-").is_some_and(|name| said("name") == Some(name));
            let named = [("other", &text.pair.key), ("concept", &text.pair.id), ("parameter", &text.pair.id)];
            is_label || is_choice || named.iter().any(|(name, own)| said(name) == Some(own))
        };
        let of_edits = |concerns: &dyn Fn(&Edit) -> bool| -> Vec<String> {
            edits.iter().filter(|(_, edit)| concerns(edit)).map(|(id, _)| id.clone()).collect()
        };
        let mut ids = of_edits(&concerns);
        if ids.is_empty() {
            ids = of_edits(&concerns_too);
        }
        for id in ids {
            any = true;
            drop_one(&id, Box::new(found.clone()), edits, imported);
        }
    }
    any
}

/// The units with which findings come that do not say to what they belong, each with the first of them: found by taking over
/// half of the units, and halves of it. All of them, where only together they are not sound, or after so many attempts.
fn culprits(
    edits: &Edits,
    new: &dyn Fn(&Edits) -> Vec<Diagnostic>,
    attempts: &mut usize,
) -> Vec<(String, Box<Diagnostic>)> {
    let Some(first) = new(edits).into_iter().next() else { return Vec::new() };
    *attempts = attempts.saturating_sub(1);
    if edits.len() > 1 && *attempts > 0 {
        let mut one = edits.clone();
        let middle = edits.keys().nth(edits.len() / 2).cloned().unwrap_or_default();
        let other = one.split_off(&middle);
        let found = [culprits(&one, new, attempts), culprits(&other, new, attempts)].concat();
        if !found.is_empty() {
            return found;
        }
    }
    edits.keys().map(|id| (id.clone(), Box::new(first.clone()))).collect()
}

/// The message in which a finding is.
fn message_at(found: &Diagnostic) -> Option<String> {
    let place = found.place.as_ref()?;
    let text = place.source.text();
    let end = text.get(place.span.start..)?.find('\n').map_or(text.len(), |at| place.span.start + at);
    let lines = text.get(..end)?.lines().rev();
    let name = |line: &str| {
        let line = line.strip_prefix('-').unwrap_or(line);
        let (name, _) = line.split_once('=')?;
        line.starts_with(|c: char| c.is_ascii_alphabetic()).then(|| name.trim().to_owned())
    };
    lines.take_while(|line| !line.starts_with('#')).find_map(name)
}

/// The files with the edits in place.
fn applied(files: &[(String, String)], texts: &[Text], tag: &str, edits: &Edits) -> Vec<(String, String)> {
    let mut by_text: BTreeMap<usize, HashMap<String, Vec<Piece>>> = BTreeMap::new();
    for edit in edits.values() {
        by_text.entry(edit.text).or_default().insert(edit.path.clone(), edit.pieces.clone());
    }
    let mut replaced: BTreeMap<&str, Vec<(usize, usize, String)>> = BTreeMap::new();
    let mut added: BTreeMap<&str, Vec<(String, String)>> = BTreeMap::new();
    for (index, own) in &by_text {
        let Some(text) = texts.get(*index) else { continue };
        if let (Some(target), Some(place)) = (&text.target, &text.pair.target) {
            let new = target.rewritten(place.source.text(), "", own);
            replaced.entry(&text.path).or_default().push((target.span.start, target.span.end, new));
            continue;
        }
        let value = assembled(text, &text.source, "", tag, own);
        let (message, attribute) =
            text.pair.key.split_once('.').map_or((text.pair.key.as_str(), None), |(a, b)| (a, Some(b)));
        // An attribute goes behind what its message has already.
        let same = |other: &&Text| other.path == text.path && other.pair.key.split('.').next() == Some(message);
        let last = texts.iter().filter(same).filter_map(|other| other.target.as_ref()).map(|it| it.span.end).max();
        match (attribute, last) {
            (Some(name), Some(end)) => {
                replaced.entry(&text.path).or_default().push((end, end, format!("\n    .{name} = {value}")));
            }
            (attribute, _) => {
                let list = added.entry(&text.path).or_default();
                let is_first = list.last().is_none_or(|(own, _)| own != message);
                let line = match attribute {
                    None => format!("{message} = {value}\n"),
                    Some(name) if is_first => format!("{message} =\n    .{name} = {value}\n"),
                    Some(name) => format!("    .{name} = {value}\n"),
                };
                list.push((message.to_owned(), line));
            }
        }
    }
    let paths: BTreeSet<&str> = replaced.keys().chain(added.keys()).copied().collect();
    paths.into_iter().map(|path| (path.to_owned(), rewritten(files, path, &mut replaced, &added))).collect()
}

/// The files that change where texts that are missing get these words.
pub(super) fn filled(
    files: &[(String, String)],
    texts: &[Text],
    tag: &str,
    words: &dyn Fn(&Unit) -> Vec<Piece>,
) -> Vec<(String, String)> {
    let mut edits = Edits::new();
    for (index, text) in texts.iter().enumerate().filter(|(_, text)| text.target.is_none()) {
        for (unit, _) in unit::units_of(text, tag) {
            let path = unit.id.get(unit.key.len()..).unwrap_or_default().to_owned();
            let edit = Edit { at: 0, text: index, path, pieces: words(&unit) };
            edits.insert(unit.id, edit);
        }
    }
    applied(files, texts, tag, &edits)
}

fn rewritten(
    files: &[(String, String)],
    path: &str,
    replaced: &mut BTreeMap<&str, Vec<(usize, usize, String)>>,
    added: &BTreeMap<&str, Vec<(String, String)>>,
) -> String {
    let old = files.iter().find(|(own, _)| own == path).map_or("", |(_, text)| text.as_str());
    // Places in files do not count a byte order mark.
    let (mark, old) = old.strip_prefix('\u{feff}').map_or(("", old), |rest| ("\u{feff}", rest));
    let mut edits = replaced.remove(path).unwrap_or_default();
    edits.sort_by_key(|(start, end, _)| (*start, *end));
    let mut text = mark.to_owned();
    let mut at = 0;
    for (start, end, new) in edits {
        text += old.get(at..start).unwrap_or_default();
        text += &new;
        at = end;
    }
    text += old.get(at..).unwrap_or_default();
    if let Some(lines) = added.get(path) {
        if !text.is_empty() && !text.ends_with('\n') {
            text.push('\n');
        }
        text.extend(lines.iter().map(|(_, line)| line.as_str()));
    }
    text
}

/// A text in the form of its source, with the selections that the language needs.
fn assembled(text: &Text, shape: &Pattern, path: &str, tag: &str, own: &HashMap<String, Vec<Piece>>) -> String {
    let file = text.pair.source.source.text();
    let selects: Vec<String> = shape
        .selects()
        .enumerate()
        .map(|(index, select)| {
            let default = select.variants.iter().find(|variant| variant.default).map_or("other", |it| it.key.as_str());
            let lines: String = unit::keys(select, Some(tag))
                .into_iter()
                .map(|key| {
                    let inner = unit::variant(select, &key).unwrap_or(shape);
                    let value = assembled(text, inner, &format!("{path}#{index}[{key}]"), tag, own);
                    let star = if key == default { "*" } else { " " };
                    format!("\n       {star}[{key}] {value}")
                })
                .collect();
            format!("{{ {} ->{lines}\n    }}", select.selector)
        })
        .collect();
    let pieces = own.get(path).cloned().unwrap_or_else(|| shape.pieces(file));
    written(&pieces, 4, &|index| selects.get(index).cloned())
}
