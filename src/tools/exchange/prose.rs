//! Pages of prose on their way to translators and back: a unit is a segment, with its marks as codes.
//!
//! The identifier of a unit is the key of the page and, after `#`, what the segment is and a number for its words:
//! `topics/threads#p-1a2b3c4d`; so it does not change when segments are added before it. A translation whose blocks are not
//! those of its source has no segments that belong together: it is exported as one that is missing.
//! Invariant: bytes outside of segments that are taken over stay.
use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::fluent::{Piece, flat, merged};
use super::markdown::{self, Segment};
use super::outcome::{Imported, Refusal, Why};
use super::received::{Received, has_hidden};
use super::unit::Unit;
use crate::language::consistency::{self, Negation};
use crate::language::locale::{Locales, SOURCE_LANGUAGE};

/// What the keys of pages begin with.
pub(super) const TOPICS: &str = "topics/";

/// A page with its translation.
pub(super) struct Page {
    key: String,
    source: String,
    /// The file of the translation.
    path: String,
    /// The translation, if its blocks are those of the source.
    target: Option<String>,
    segments: Vec<Segment>,
    translated: Vec<Segment>,
    ids: Vec<String>,
}

/// The pages of a language in the order of their names.
pub(super) fn pages(locales: &Locales, tag: &str) -> Vec<Page> {
    let Some(source) = locales.source() else { return Vec::new() };
    let other = locales.language(tag).ok();
    let page = |(name, page): (&str, &std::sync::Arc<crate::base::diag::Source>)| {
        let segments = markdown::segments(page.text());
        let translation = other.and_then(|other| other.topic(name)).map(|page| page.text().to_owned());
        let translated = translation.as_deref().map_or_else(Vec::new, markdown::segments);
        let kinds = |all: &[Segment]| all.iter().map(|segment| segment.kind.clone()).collect::<Vec<_>>();
        let target = translation.filter(|_| kinds(&segments) == kinds(&translated));
        let key = format!("{TOPICS}{name}");
        Page {
            ids: ids(&key, &segments),
            path: format!("locales/{tag}/{key}.md"),
            source: page.text().to_owned(),
            translated: if target.is_some() { translated } else { Vec::new() },
            key,
            target,
            segments,
        }
    };
    source.topics().map(page).collect()
}

fn ids(key: &str, segments: &[Segment]) -> Vec<String> {
    let mut times: HashMap<String, usize> = HashMap::new();
    let id = |segment: &Segment| {
        let id = format!("{key}#{}-{:08x}", segment.kind, digest(&markdown::written(&segment.pieces, false)));
        let times = times.entry(id.clone()).and_modify(|times| *times += 1).or_insert(1);
        if *times == 1 { id } else { format!("{id}-{times}") }
    };
    segments.iter().map(id).collect()
}

/// FNV-1a: identifiers must not change with a library's hash.
fn digest(text: &str) -> u32 {
    text.bytes().fold(0x811c_9dc5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

impl Page {
    /// Its units.
    pub(super) fn units(&self) -> impl Iterator<Item = Unit> {
        self.segments.iter().zip(&self.ids).enumerate().map(|(at, (segment, id))| Unit {
            id: id.clone(),
            key: self.key.clone(),
            message: self.key.clone(),
            file: format!("{}.md", self.key),
            source: segment.pieces.clone(),
            target: self.translated.get(at).map_or_else(Vec::new, |segment| segment.pieces.clone()),
            state: None,
            notes: Vec::new(),
            most: None,
        })
    }

    /// The tag of the language of the translation.
    fn language(&self) -> &str {
        self.path.split('/').nth(1).unwrap_or_default()
    }

    /// The page as it is, or its source where there is no translation to begin with.
    fn ground(&self) -> (&str, &[Segment]) {
        match &self.target {
            Some(target) => (target, &self.translated),
            None => (&self.source, &self.segments),
        }
    }

    /// The words of a segment in the file, so that they are read again as these pieces and nothing around them changes.
    fn put(&self, at: usize, pieces: &[Piece]) -> Option<String> {
        let (page, segments) = self.ground();
        let segment = segments.get(at)?;
        let same = |text: &String| {
            let changed = spliced(page, &[(segment.span.clone(), text.clone())]);
            let after = markdown::segments(&changed);
            let others = |all: &[Segment]| -> Vec<(String, Vec<Piece>)> {
                let others = all.iter().enumerate().filter(|(other, _)| *other != at);
                others.map(|(_, segment)| (segment.kind.clone(), segment.pieces.clone())).collect()
            };
            let own = after.get(at).filter(|own| own.kind == segment.kind);
            let means = own.map(|own| plain(&own.pieces));
            others(&after) == others(segments) && means == Some(plain(pieces))
        };
        [false, true].map(|escaped| markdown::written(pieces, escaped)).into_iter().find(same)
    }
}

/// Pieces with the signs after backslashes as they are read.
fn plain(pieces: &[Piece]) -> Vec<Piece> {
    let words = |words: &str| {
        let mut out = String::new();
        let mut chars = words.chars().peekable();
        while let Some(c) = chars.next() {
            if c != '\\' || !chars.peek().is_some_and(char::is_ascii_punctuation) {
                out.push(c);
            } else {
                out.extend(chars.next());
            }
        }
        out
    };
    let piece = |piece: &Piece| match piece {
        Piece::Text(text) => Piece::Text(words(text)),
        Piece::Code(code) => Piece::Code(code.clone()),
    };
    merged(pieces.iter().map(piece).collect())
}

fn spliced(page: &str, edits: &[(std::ops::Range<usize>, String)]) -> String {
    let mut text = String::new();
    let mut at = 0;
    for (span, words) in edits {
        text += page.get(at..span.start).unwrap_or_default();
        text += words;
        at = span.end;
    }
    text + page.get(at..).unwrap_or_default()
}

/// The pages that a language lacks, as files: those of the source with marks around the words.
pub(super) fn gaps(locales: &Locales, tag: &str, marks: (&str, &str)) -> Vec<(String, String)> {
    let lacks = |key: &str| {
        let name = key.strip_prefix(TOPICS).unwrap_or(key);
        locales.language(tag).ok().and_then(|language| language.topic(name)).is_none()
    };
    let page = |page: Page| {
        let words = page.segments.iter().filter(|segment| segment.kind != markdown::CODE);
        let marked = |segment: &Segment| {
            let words = page.source.get(segment.span.clone()).unwrap_or_default();
            (segment.span.clone(), format!("{}{words}{}", marks.0, marks.1))
        };
        (page.path.clone(), spliced(&page.source, &words.map(marked).collect::<Vec<_>>()))
    };
    pages(locales, tag).into_iter().filter(|page| lacks(&page.key)).map(page).collect()
}

/// Takes over the final units of pages: what is refused is added to the report, as are the files that change.
pub(super) fn import(
    files: &[(String, String)],
    pages: &[Page],
    received: Vec<Received>,
    negation: Option<&Negation>,
    imported: &mut Imported,
) {
    let by_id: HashMap<&str, (&Page, usize)> = pages
        .iter()
        .flat_map(|page| page.ids.iter().enumerate().map(move |(at, id)| (id.as_str(), (page, at))))
        .collect();
    let mut times: HashMap<&str, usize> = HashMap::new();
    received.iter().for_each(|unit| *times.entry(unit.id.as_str()).or_default() += 1);
    let mut sound: BTreeMap<&str, BTreeMap<usize, (usize, String)>> = BTreeMap::new();
    let mut same: BTreeMap<&str, BTreeSet<usize>> = BTreeMap::new();
    for unit in &received {
        if !unit.is_final {
            imported.passed_over += 1;
            continue;
        }
        let is_twice = times.get(unit.id.as_str()).is_some_and(|times| *times > 1);
        let found = by_id.get(unit.id.as_str()).ok_or(Why::Unknown);
        match found.and_then(|(page, at)| Ok((*page, *at, checked(page, *at, unit, negation, is_twice)?))) {
            Err(why) => imported.refused.push(Refusal { id: unit.id.clone(), at: unit.at, why }),
            Ok((page, at, None)) => {
                imported.unchanged += 1;
                same.entry(&page.key).or_default().insert(at);
            }
            Ok((page, at, Some(words))) => {
                sound.entry(&page.key).or_default().insert(at, (unit.at, words));
            }
        }
    }
    for page in pages {
        let edits = sound.remove(page.key.as_str()).unwrap_or_default();
        let unchanged = same.get(page.key.as_str()).map_or(0, BTreeSet::len);
        let is_whole = edits.len() + unchanged == page.segments.len();
        let id = |at: &usize| page.ids.get(*at).cloned().unwrap_or_default();
        if page.target.is_none() && !is_whole {
            let refusal =
                |(at, (place, _)): (&usize, &(usize, String))| Refusal { id: id(at), at: *place, why: Why::Incomplete };
            imported.refused.extend(edits.iter().map(refusal));
            continue;
        }
        if is_whole && !page.segments.is_empty() {
            imported.confirmed.push(page.key.clone());
        }
        if edits.is_empty() {
            continue;
        }
        imported.taken.extend(edits.keys().map(id));
        let (ground, segments) = page.ground();
        let spans = edits.into_iter().filter_map(|(at, (_, words))| Some((segments.get(at)?.span.clone(), words)));
        // Places in files do not count a byte order mark.
        let old = files.iter().find(|(path, _)| *path == page.path).map_or("", |(_, text)| text.as_str());
        let mark = if old.starts_with('\u{feff}') { "\u{feff}" } else { "" };
        imported.files.push((page.path.clone(), mark.to_owned() + &spliced(ground, &spans.collect::<Vec<_>>())));
    }
}

/// The new words of a unit as the file has them; nothing if they are those that are there.
fn checked(
    page: &Page,
    at: usize,
    unit: &Received,
    negation: Option<&Negation>,
    is_twice: bool,
) -> Result<Option<String>, Why> {
    if is_twice {
        return Err(Why::Twice);
    }
    let own = page.segments.get(at).ok_or(Why::Unknown)?;
    let old = page.translated.get(at).map(|segment| segment.pieces.as_slice());
    let unit = unit.clone().into_exported_form(&own.pieces, old.unwrap_or_default());
    if unit.source.as_ref() != Some(&own.pieces) {
        return Err(Why::SourceChanged);
    }
    let pieces = unit.target.clone().ok_or(Why::NotRead)?;
    let pieces = if own.kind == markdown::CODE { pieces } else { in_one_line(pieces) };
    if pieces.is_empty() || has_hidden(&pieces) {
        return Err(Why::NotRead);
    }
    if old == Some(pieces.as_slice()) {
        return Ok(None);
    }
    same_codes(&own.pieces, old, &pieces)?;
    same_numbers((&own.pieces, SOURCE_LANGUAGE), old, (&pieces, page.language()))?;
    same_references(&own.pieces, old, &pieces)?;
    if let (Some(words), Some(old)) = (negation, old)
        && words.is_lost(&flat(&own.pieces), &flat(old), &flat(&pieces))
    {
        return Err(Why::Negation);
    }
    page.put(at, &pieces).map(Some).ok_or(Why::Markup)
}

/// Pieces whose lines follow each other with a blank.
fn in_one_line(pieces: Vec<Piece>) -> Vec<Piece> {
    let line = |piece| match piece {
        Piece::Text(words) => Piece::Text(words.replace('\n', " ")),
        code => code,
    };
    markdown::trimmed(merged(pieces.into_iter().map(line).collect()))
}

fn sorted(pieces: &[Piece]) -> Vec<&str> {
    let codes = pieces.iter().filter_map(|piece| match piece {
        Piece::Code(code) => Some(code.as_str()),
        Piece::Text(_) => None,
    });
    let mut all: Vec<&str> = codes.collect();
    all.sort_unstable();
    all
}

/// The marks are those of the source, or those that the translation has already.
fn same_codes(source: &[Piece], old: Option<&[Piece]>, new: &[Piece]) -> Result<(), Why> {
    let (wanted, own) = (sorted(source), sorted(new));
    if own == wanted || old.is_some_and(|old| sorted(old) == own) {
        return Ok(());
    }
    let (missing, foreign) = difference(&wanted, &own);
    Err(Why::Codes { missing, foreign })
}

/// The words with digits are those of the source, or those that the translation has already.
fn same_numbers(source: (&[Piece], &str), old: Option<&[Piece]>, (new, language): (&[Piece], &str)) -> Result<(), Why> {
    let (wanted, own) = (numbers(source.0, source.1), numbers(new, language));
    if own == wanted || old.is_some_and(|old| numbers(old, language) == own) {
        return Ok(());
    }
    let (missing, foreign) = difference(
        &wanted.iter().map(String::as_str).collect::<Vec<_>>(),
        &own.iter().map(String::as_str).collect::<Vec<_>>(),
    );
    Err(Why::Numbers { missing, foreign })
}

/// What the one list has more often than the other, and the other way round.
fn difference(wanted: &[&str], own: &[&str]) -> (String, String) {
    let more = |one: &[&str], other: &[&str]| {
        let mut rest = other.to_vec();
        let left = one.iter().filter(|word| match rest.iter().position(|known| known == *word) {
            Some(at) => {
                rest.swap_remove(at);
                false
            }
            None => true,
        });
        left.copied().collect::<Vec<_>>().join(", ")
    };
    (more(wanted, own), more(own, wanted))
}

/// Words with digits, whatever the decimal sign, with the minus before and the unit after them, in the order of the alphabet.
fn numbers(pieces: &[Piece], language: &str) -> Vec<String> {
    let mut all = Vec::new();
    for piece in pieces {
        let Piece::Text(words) = piece else { continue };
        let inside = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | ',');
        let mut at = 0;
        while let Some(start) = words.get(at..).and_then(|rest| rest.find(inside)).map(|found| at + found) {
            let rest = words.get(start..).unwrap_or_default();
            let end = start + rest.find(|c| !inside(c)).unwrap_or(rest.len());
            at = end;
            let word = words.get(start..end).unwrap_or_default().trim_matches(['.', ',']).replace(',', ".");
            if !word.bytes().any(|byte| byte.is_ascii_digit()) {
                continue;
            }
            let begins_with_digit = word.starts_with(|c: char| c.is_ascii_digit());
            let (before, after) = (words.get(..start).unwrap_or_default(), words.get(end..).unwrap_or_default());
            let rest = before.strip_suffix(['-', '\u{2212}']).filter(|_| begins_with_digit);
            let is_negative = rest.is_some_and(|rest| !rest.ends_with(char::is_alphanumeric));
            let unit = consistency::UNITS.iter().find(|unit| {
                let rest = after.trim_start_matches([' ', '\u{a0}', '\u{202f}']).strip_prefix(**unit);
                let ends = rest.filter(|rest| !rest.starts_with(char::is_alphanumeric));
                let value = word.parse().unwrap_or_default();
                let is_ordinal =
                    |rest| **unit == "°" && after.starts_with('°') && consistency::is_ordinal(value, rest, language);
                begins_with_digit && ends.is_some_and(|rest| !is_ordinal(rest))
            });
            let minus = if is_negative { "\u{2212}" } else { "" };
            all.push(format!("{minus}{word}{}", unit.map_or_else(String::new, |unit| format!(" {unit}"))));
        }
    }
    all.sort_unstable();
    all
}

/// Words for absolute and incremental are as many as in the translation that is there, or as in the source.
fn same_references(source: &[Piece], old: Option<&[Piece]>, new: &[Piece]) -> Result<(), Why> {
    let stated = |pieces: &[Piece]| consistency::references(&markdown::written(pieces, false));
    let own = stated(new);
    if old.is_none_or(|old| stated(old) == own) || stated(source) == own {
        return Ok(());
    }
    let names = ["absolute", "incremental"];
    let more = |a: [usize; 2], b: [usize; 2]| {
        let all = names.iter().zip(a.iter().zip(b)).filter(|(_, (a, b))| **a > *b).map(|(name, _)| *name);
        all.collect::<Vec<_>>().join(", ")
    };
    let wanted = stated(source);
    Err(Why::Numbers { missing: more(wanted, own), foreign: more(own, wanted) })
}
