//! Links that sentences get by what they mention: cycles, Q parameters, miscellaneous functions, terms.
//!
//! Invariant: the text itself is never changed; a link leads to a page of the edition, never to the place where it is,
//! and a term is linked where a page mentions it first.
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};

use super::edition::{Edition, GLOSSARY, PARAMETERS, TERM, file_of};
use super::escape::escape;
use super::stem::Stems;
use crate::base::expr::QRef;
use crate::language::locale::{Language, Scope};
use crate::spec::{Cycle, CycleKey, Keyword, OnControl};

/// What words of an edition can lead to; made once.
pub(super) struct Targets {
    stems: Stems,
    /// Beginnings of the word for a cycle.
    cycle_words: Vec<String>,
    /// Words between numbers of cycles: and, or, to.
    joining: Vec<String>,
    /// Q parameters of any cycle.
    parameters: HashSet<String>,
    /// Terms by the first letters of their first word.
    terms: HashMap<Start, Vec<usize>>,
    meanings: Vec<Meaning>,
    /// Files by miscellaneous function.
    functions: HashMap<String, String>,
}

/// A term.
struct Meaning {
    /// In lower case.
    term: String,
    /// The stems of its words.
    stems: Vec<String>,
    /// The file, with the anchor, that explains it.
    file: String,
}

impl Meaning {
    /// Whether a word may be a form of the term: of a single word more than the stem must be there, so that a verb does
    /// not lead to its noun.
    fn begins_like(&self, word: &str) -> bool {
        let shared = self.term.chars().zip(word.chars()).take_while(|(own, other)| own == other).count();
        self.stems.len() > 1 || shared + 2 >= self.term.chars().count()
    }
}

/// The letters that decide which terms a word is compared with, in lower case.
type Start = u64;

fn start(word: &str) -> Start {
    // A character has 21 bits, and none is 0.
    word.chars()
        .flat_map(char::to_lowercase)
        .take(3)
        .fold(0, |start, letter| start << 21 | u64::from(u32::from(letter)))
}

/// Whether a word begins with another one that is in lower case.
fn begins_with(word: &str, own: &str) -> bool {
    let mut letters = word.chars().flat_map(char::to_lowercase);
    own.chars().all(|letter| letters.next() == Some(letter))
}

impl Targets {
    /// The targets of a control in a language; `pages` are the topics with the files of their pages, `terms` the ids of
    /// the glossary.
    pub(super) fn new(
        on: &OnControl,
        language: &Language,
        pages: &[(&crate::spec::Topic, &str)],
        terms: &[&str],
    ) -> Self {
        let list = |id: &str| {
            let text = language.plain(id, &Scope::NONE).unwrap_or_default();
            text.split_whitespace().map(str::to_owned).collect::<Vec<_>>()
        };
        let stems = Stems::of(language);
        let mut meanings: Vec<Meaning> = Vec::new();
        let mut by_start: HashMap<Start, Vec<usize>> = HashMap::new();
        for id in terms {
            let term = language.plain(&format!("{TERM}{id}"), &Scope::control(on.id())).unwrap_or_default();
            let words: Vec<String> = term.split_whitespace().map(str::to_lowercase).collect();
            let first = words.first().map_or("", String::as_str);
            let table = id.strip_suffix("-table");
            let explains = |topic: &crate::spec::Topic| topic.tables.iter().any(|own| Some(own.as_str()) == table);
            let topic = pages.iter().find(|(topic, _)| explains(topic)).map(|(_, file)| (*file).to_owned());
            by_start.entry(start(first)).or_default().push(meanings.len());
            let file = topic.unwrap_or_else(|| format!("{GLOSSARY}#{TERM}{id}"));
            let stems = words.iter().map(|word| stems.stem(word)).collect();
            meanings.push(Meaning { term: words.join(" "), stems, file });
        }
        for candidates in by_start.values_mut() {
            candidates.sort_by_key(|at| std::cmp::Reverse(meanings[*at].stems.len()));
        }
        let functions = pages
            .iter()
            .flat_map(|(topic, file)| topic.functions.iter().map(|function| (function.clone(), (*file).to_owned())));
        let q =
            |cycle: &Cycle| cycle.params.iter().filter_map(|param| param.q.map(|q| q.to_string())).collect::<Vec<_>>();
        Self {
            cycle_words: list("page-mentions.cycle"),
            joining: list("page-mentions.joining"),
            parameters: on.cycles.values().flat_map(q).collect(),
            functions: functions.collect(),
            terms: by_start,
            meanings,
            stems,
        }
    }
}

/// Where a text is shown.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Shown {
    /// On the page of the cycle that it is about.
    Here,
    /// On another page of the edition.
    Elsewhere,
    /// Where nothing can be linked.
    Apart,
}

/// Gives the sentences of one page their links.
pub(super) struct Linker<'l, 'a> {
    pub(super) edition: &'l Edition<'a>,
    own: Option<&'l Cycle>,
    shown: Shown,
    /// Terms that the page has linked.
    seen: RefCell<HashSet<usize>>,
}

/// A word or number of a text.
#[derive(Clone, Copy)]
struct Token<'t> {
    start: usize,
    text: &'t str,
}

impl<'l, 'a> Linker<'l, 'a> {
    pub(super) fn new(edition: &'l Edition<'a>, own: Option<&'l Cycle>, shown: Shown) -> Self {
        Self { edition, own, shown, seen: RefCell::default() }
    }

    /// For the definition of a term, which does not lead to itself.
    pub(super) fn of_term(edition: &'l Edition<'a>, term: usize) -> Self {
        let seen = RefCell::new(HashSet::from([term]));
        Self { edition, own: None, shown: Shown::Elsewhere, seen }
    }

    /// Appends a text with its links.
    pub(super) fn text(&self, text: &str, out: &mut String) {
        if self.shown == Shown::Apart {
            return escape(text, out);
        }
        let tokens = tokens(text);
        let mut written = 0;
        let mut at = 0;
        let mut of_cycle = false;
        while let Some(token) = tokens.get(at) {
            let (target, count) = match self.number(&tokens, at, &mut of_cycle) {
                Some(file) => (Some(file), 1),
                None => self.word(text, &tokens[at..]),
            };
            if let (Some(target), Some(last)) = (target, tokens.get(at + count - 1)) {
                escape(&text[written..token.start], out);
                out.push_str("<a href=\"");
                escape(&target, out);
                out.push_str("\">");
                written = last.start + last.text.len();
                escape(&text[token.start..written], out);
                out.push_str("</a>");
            }
            at += count;
        }
        escape(&text[written..], out);
    }

    /// The file of the cycle whose number a token is.
    fn number(&self, tokens: &[Token], at: usize, of_cycle: &mut bool) -> Option<String> {
        let targets = &self.edition.targets;
        let token = tokens.get(at)?;
        let Ok(number) = token.text.parse::<u32>() else {
            let names_cycle = targets.cycle_words.iter().any(|own| begins_with(token.text, own));
            *of_cycle = names_cycle || *of_cycle && targets.joining.contains(&token.text.to_lowercase());
            return None;
        };
        let before = |back: usize| at.checked_sub(back).and_then(|at| tokens.get(at)).map(|token| token.text);
        let keyword = match (before(2), before(1)) {
            (Some("CYCL"), Some("DEF")) => Some(Keyword::CyclDef),
            (Some("TCH"), Some("PROBE")) => Some(Keyword::TchProbe),
            _ => None,
        };
        let known = |keyword| self.edition.entry(CycleKey::new(keyword, number)).map(|entry| entry.cycle.key);
        let key = match keyword {
            Some(keyword) => known(keyword)?,
            None if *of_cycle => match (known(Keyword::CyclDef), known(Keyword::TchProbe)) {
                (Some(key), None) | (None, Some(key)) => key,
                (Some(_), Some(_)) => known(self.own?.key.keyword)?,
                (None, None) => return None,
            },
            None => return None,
        };
        let itself = self.shown == Shown::Here && self.own.is_some_and(|own| own.key == key);
        (!itself).then(|| file_of(key))
    }

    /// Where the words at the start of `tokens` lead, and how many they are.
    fn word(&self, text: &str, tokens: &[Token]) -> (Option<String>, usize) {
        let Some(first) = tokens.first() else { return (None, 1) };
        let targets = &self.edition.targets;
        if first.text.starts_with('Q') && first.text[1..].bytes().next().is_some_and(|byte| byte.is_ascii_digit()) {
            return (self.parameter(first.text), 1);
        }
        // Their words are written in capitals.
        let function = || targets.functions.get(first.text);
        if let Some(file) = first.text.bytes().next().filter(u8::is_ascii_uppercase).and_then(|_| function()) {
            return (Some(file.clone()), 1);
        }
        for at in targets.terms.get(&start(first.text)).into_iter().flatten() {
            let meaning = &targets.meanings[*at];
            let stems = &meaning.stems;
            let Some(words) = tokens.get(..stems.len()).filter(|_| !self.seen.borrow().contains(at)) else { continue };
            let apart = |pair: &[Token]| &text[pair[0].start + pair[0].text.len()..pair[1].start] != " ";
            let differs = |(word, stem): (&Token, &String)| targets.stems.stem(&word.text.to_lowercase()) != *stem;
            let like = || meaning.begins_like(&first.text.to_lowercase());
            if words.windows(2).any(apart) || !like() || words.iter().zip(stems).any(differs) {
                continue;
            }
            self.seen.borrow_mut().insert(*at);
            return (Some(meaning.file.clone()), stems.len());
        }
        (None, 1)
    }

    /// Where a Q parameter is explained.
    fn parameter(&self, name: &str) -> Option<String> {
        let own = self.own.and_then(|cycle| {
            let named = QRef::parse(name).filter(|q| q.to_string() == name)?;
            let has = |q: Option<QRef>| q == Some(named);
            if cycle.params.iter().any(|param| has(param.q)) {
                return Some((cycle.key, format!("#{name}")));
            }
            cycle.file.results.iter().any(|result| has(result.q)).then(|| (cycle.key, format!("#result-{name}")))
        });
        match own {
            Some((_, anchor)) if self.shown == Shown::Here => Some(anchor),
            Some((key, anchor)) => Some(format!("{}{anchor}", file_of(key))),
            None => self.edition.targets.parameters.contains(name).then(|| format!("{PARAMETERS}#{name}")),
        }
    }
}

/// The runs of letters and digits of a text.
fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    let mut start = None;
    for (at, c) in text.char_indices().chain([(text.len(), ' ')]) {
        // A decimal number is one token, so that its parts are not taken for numbers of cycles.
        let within = c.is_alphanumeric() || (c == '.' || c == ',') && is_decimal(text, start, at);
        match (within, start) {
            (true, None) => start = Some(at),
            (false, Some(begin)) => {
                tokens.push(Token { start: begin, text: &text[begin..at] });
                start = None;
            }
            _ => {}
        }
    }
    tokens
}

/// Whether the sign at `at` is between digits of the number that begins at `start`.
fn is_decimal(text: &str, start: Option<usize>, at: usize) -> bool {
    let digit = |byte: Option<&u8>| byte.is_some_and(u8::is_ascii_digit);
    start.is_some_and(|start| text[start..at].bytes().all(|byte| byte.is_ascii_digit()))
        && digit(text.as_bytes().get(at + 1))
}
