//! Whether a sentence that denies something does so in every language.
//!
//! Each language lists its words for that (`lexicon-negation`): words, beginnings of words (`un-`), endings (`-less`) and what
//! is inside of them (`-less-`), separated by ` | `. Only where all languages but one have such a word is that one reported: there are many ways to say what
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

/// Whether one of the words of the text is in the list. The names of arguments are no words.
fn is_in(text: &str, list: &[String]) -> bool {
    let mut inside = false;
    let lower = text.to_lowercase();
    let words = lower.split(|c: char| {
        inside = (inside || c == '‹') && c != '›';
        inside || !c.is_alphanumeric()
    });
    words.filter(|word| !word.is_empty()).any(|word| {
        list.iter().any(|entry| match (entry.strip_suffix('-'), entry.strip_prefix('-')) {
            (Some(_), Some(_)) => word.contains(entry.trim_matches('-')),
            (Some(begin), _) => word.starts_with(begin),
            (_, Some(end)) => word.ends_with(end),
            _ => word == entry,
        })
    })
}
