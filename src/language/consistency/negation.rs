//! Whether a sentence that denies something does so in every language.
//!
//! Each language lists its words for that (`lexicon-negation`): words, beginnings of words (`un-`), endings (`-less`) and what
//! is inside of them (`-less-`), separated by ` | `. A word with a plus (`nor+`) goes on with what another one denies: alone it
//! denies only at the beginning of a clause. Only where all languages but one have such a word is that one reported: there are many ways to say what
//! is not so. Invariant: a language without a list is not judged, and has no vote.
use super::{Said, keys, said, scope_of};
use crate::base::diag::Diagnostic;
use crate::language::locale::{Key, Language, Locales, SOURCE_LANGUAGE, Scope};

/// Beginnings of the messages that say what a cycle does; names of parameters and words of the program are too short.
const TEXTS: [&str; 11] = [
    "step-",
    "say-",
    "until-",
    "note-",
    "guard-",
    "choice-",
    "cycle-",
    "parameter-",
    "condition-",
    "message-",
    "term-",
];
/// So many languages must deny it.
const LEAST: usize = 3;

/// Reports sentences that say in one language what all others deny.
pub(super) fn check(locales: &Locales, found: &mut Vec<Diagnostic>) {
    let lists: Vec<(&Language, Vec<String>)> = locales.iter().map(|language| (language, listed(language))).collect();
    let denies = |said: &Said| {
        let list = lists.iter().find(|(language, _)| language.tag() == said.language.tag());
        list.filter(|(_, list)| !list.is_empty()).map(|(_, list)| is_in(&said.text, list))
    };
    for (id, attribute, suffixes) in &keys(locales) {
        if !TEXTS.iter().any(|head| id.starts_with(head)) {
            continue;
        }
        let key = Key { id, attribute: attribute.as_deref() };
        let all = said(locales, key, scope_of(suffixes));
        let exact = all.iter().any(|said| said.exact);
        let judged: Vec<(&Said, bool)> =
            all.iter().filter(|said| said.exact || !exact).filter_map(|said| Some((said, denies(said)?))).collect();
        let [(alone, _)] = judged.iter().filter(|(_, denies)| !denies).collect::<Vec<_>>()[..] else { continue };
        if judged.len() <= LEAST || alone.language.tag() == SOURCE_LANGUAGE {
            continue;
        }
        let others: Vec<&str> =
            judged.iter().filter(|(_, denies)| *denies).map(|(said, _)| said.language.tag()).collect();
        found.push(
            Diagnostic::error("consistency-negation", alone.place.clone())
                .arg("key", key.to_string())
                .arg("language", alone.language.tag())
                .arg("others", others.join(", ")),
        );
    }
}

fn listed(language: &Language) -> Vec<String> {
    let list = language.plain("lexicon-negation", &Scope::NONE).unwrap_or_default();
    list.split('|').map(|word| word.trim().to_lowercase()).filter(|word| !word.is_empty()).collect()
}

/// Whether something in the text denies.
fn is_in(text: &str, list: &[String]) -> bool {
    tokens(text).iter().any(|token| match denies(&token.word, list) {
        Some(Denial::GoesOn) => token.begins,
        Some(Denial::Whole) => true,
        None => false,
    })
}

/// How a word denies.
enum Denial {
    Whole,
    /// With another word before it.
    GoesOn,
}

fn denies(word: &str, list: &[String]) -> Option<Denial> {
    let is = |entry: &str| match (entry.strip_suffix('-'), entry.strip_prefix('-')) {
        (Some(_), Some(_)) => word.contains(entry.trim_matches('-')),
        (Some(begin), _) => word.starts_with(begin),
        (_, Some(end)) => word.ends_with(end),
        _ => word == entry,
    };
    list.iter().find_map(|entry| match entry.strip_suffix('+') {
        Some(entry) => (word == entry).then_some(Denial::GoesOn),
        None => is(entry).then_some(Denial::Whole),
    })
}

/// A word of a text in small letters, or an argument with its quotation marks.
struct Token {
    word: String,
    /// Whether a clause may begin with it.
    begins: bool,
}

fn tokens(text: &str) -> Vec<Token> {
    let mut all: Vec<Token> = Vec::new();
    let (mut word, mut begins, mut inside) = (String::new(), true, false);
    for c in text.to_lowercase().chars().chain([' ']) {
        inside |= c == '‹';
        if inside || c.is_alphanumeric() {
            word.push(c);
            inside &= c != '›';
            continue;
        }
        if !word.is_empty() {
            all.push(Token { word: std::mem::take(&mut word), begins });
            begins = false;
        }
        begins |= matches!(c, ',' | ';' | ':' | '.' | '!' | '?' | '(' | '–' | '—');
    }
    all
}

/// The words with which a translation and its source deny.
pub struct Negation {
    own: Vec<String>,
    source: Vec<String>,
}

impl Negation {
    /// Those of a language; none that lists no such words.
    pub fn of(locales: &Locales, tag: &str) -> Option<Self> {
        let (own, source) = (listed(locales.language(tag).ok()?), listed(locales.source()?));
        (!own.is_empty()).then_some(Self { own, source })
    }

    /// Whether words that deny were taken out of a text, or one word was put in the place of one, and nothing else was
    /// changed, though the source denies. Codes are between `‹` and `›`.
    pub fn is_lost(&self, source: &str, old: &str, new: &str) -> bool {
        let (old, new) = (tokens(old), tokens(new));
        let same = |(a, b): &(&Token, &Token)| a.word == b.word;
        let head = old.iter().zip(&new).take_while(same).count();
        let rest = old.len().min(new.len()) - head;
        let tail = old.iter().rev().zip(new.iter().rev()).take(rest).take_while(same).count();
        let middle = |all: &[Token]| -> Vec<String> {
            let inner = all.iter().take(all.len() - tail).skip(head);
            inner.map(|token| token.word.clone()).collect()
        };
        let (gone, come) = (middle(&old), middle(&new));
        let is_denial = |word: &String| denies(word, &self.own).is_some();
        // A word that was there twice was a slip.
        let is_slip = || head > 0 && gone.first() == old.get(head - 1).map(|token| &token.word);
        let taken_out = come.is_empty() && !is_slip();
        // `ni` becomes `je`; what denies in another way is a longer word.
        let replaced = matches!((&gone[..], &come[..]), ([one], [other])
            if other.chars().count() <= one.chars().count() && !is_denial(other));
        let is_less = !gone.is_empty() && gone.iter().all(is_denial) && (taken_out || replaced);
        is_less && is_in(source, &self.source)
    }
}
