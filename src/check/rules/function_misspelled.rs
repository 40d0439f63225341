//! A word behind FUNCTION MODE or FUNCTION RESET that no control knows and that is one letter away from one that they know;
//! VCONST: of FUNCTION TURNDATA that is neither ON nor OFF.
//!
//! Of other words nothing is said: newer software has more of them.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::{BlockKind, StatementKind, ValueKind};

pub(super) const RULE: Rule = Rule { code: "function-misspelled", severity: Severity::Warning, run };

/// What may follow these words.
const KNOWN: [(&str, &[&str]); 2] = [
    ("MODE", &["MILL", "TURN", "GRIND", "SET"]),
    ("RESET", &["TCPM", "TURNDATA", "DWELL", "FEED", "PARAXCOMP", "PARAXMODE", "POLARKIN", "SPINDLE", "COUNT"]),
];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let BlockKind::Statement(own) = &block.kind else { continue };
        if own.kind != StatementKind::Function {
            continue;
        }
        for word in own.words.iter().filter(|word| facts.text(word.name).trim().eq_ignore_ascii_case("VCONST:")) {
            let value = facts.text(word.value.span).trim();
            if word.value.kind == ValueKind::Word && !["ON", "OFF"].iter().any(|own| own.eq_ignore_ascii_case(value)) {
                found.push(rule.at(facts, word.span).arg("word", value).arg("meant", "ON, OFF"));
            }
        }
        let mut words = facts.text(facts.content(block)).split_ascii_whitespace().map(str::to_ascii_uppercase);
        let (Some(function), Some(kind), Some(word)) = (words.next(), words.next(), words.next()) else { continue };
        let Some((_, known)) = KNOWN.iter().find(|(name, _)| function == "FUNCTION" && kind == *name) else { continue };
        if known.contains(&word.as_str()) {
            continue;
        }
        if let Some(meant) = known.iter().find(|own| is_near(own.as_bytes(), word.as_bytes())) {
            let finding = rule.at(facts, facts.content(block)).arg("word", word.as_str());
            found.push(finding.arg("meant", *meant));
        }
    }
}

/// Whether two words differ by one letter: another, one more or less, or two that changed places.
fn is_near(one: &[u8], other: &[u8]) -> bool {
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
