//! A word after FUNCTION, PLANE or TRANS DATUM that no control knows and that is one letter away from one that they
//! know, or begins like one.
//!
//! Which words those are is in the file of the language. Of other words nothing is reported:
//! newer software has more of them.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::words;
use crate::check::{Facts, Rule};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "function-misspelled", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        if !matches!(block.kind, BlockKind::Statement(_)) {
            continue;
        }
        for words in words::of(facts, block) {
            for known in words.known.iter().filter(|known| !known.follows.is_empty()) {
                let Some((word, _)) = words.at(known.block.split(' ').count()) else { continue };
                let word = word.to_ascii_uppercase();
                if known.follows.contains(&word) {
                    continue;
                }
                if let Some(meant) = known.follows.iter().find(|own| is_near(own.as_bytes(), word.as_bytes())) {
                    let finding = rule.at(facts, facts.content(block)).arg("word", word.as_str());
                    found.push(finding.arg("meant", meant.as_str()));
                }
            }
        }
    }
}

/// Whether two words are hardly different: one is the beginning of the other, or they differ by one letter.
fn is_near(one: &[u8], other: &[u8]) -> bool {
    let begins = one.len().min(other.len()) >= BEGINNING && (one.starts_with(other) || other.starts_with(one));
    begins || is_one_letter_away(one, other)
}

/// So many letters are the beginning of a word.
const BEGINNING: usize = 4;

/// Whether two words differ by one letter: another, one more or less, or two that changed places.
fn is_one_letter_away(one: &[u8], other: &[u8]) -> bool {
    let same = one.iter().zip(other).take_while(|(a, b)| a == b).count();
    let (one, other) = (one.get(same..).unwrap_or_default(), other.get(same..).unwrap_or_default());
    match (one, other) {
        ([a, b, one @ ..], [c, d, other @ ..]) if a == d && b == c => one == other,
        ([_, rest @ ..], _) if rest == other => true,
        (_, [_, rest @ ..]) if rest == one => true,
        ([_, one @ ..], [_, other @ ..]) => one == other,
        _ => false,
    }
}
