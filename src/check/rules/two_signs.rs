//! A coordinate or a parameter with two signs, as a post-processor writes it that puts a plus before every number.
//!
//! They are read as their product. Only a plus and a minus are mended: a program with `--` may mean either.
use memchr::memmem;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "two-signs", severity: Severity::Warning, run };

/// So many of each are looked at: others are lines drawn in comments.
const FEW: usize = 1000;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let text = facts.program.source().text().as_bytes();
    let mut places: Vec<usize> = ["+-", "-+", "--", "++"]
        .iter()
        .flat_map(|signs| memmem::find_iter(text, signs).filter(|&at| precedes_number(text, at)).take(FEW))
        .collect();
    places.sort_unstable();
    let blocks = facts.program.blocks();
    for at in places {
        let index = blocks.partition_point(|block| block.span.end <= at);
        let Some(block) = blocks.get(index).filter(|block| block.span.start <= at && !block.is_unread()) else {
            continue;
        };
        let line = text.get(block.span.start..at).unwrap_or_default().rsplit(|&byte| byte == b'\n').next();
        // A comment, or a text.
        if line.is_none_or(|line| line.iter().any(|byte| matches!(byte, b';' | b'"' | b'*' | b'('))) {
            continue;
        }
        let span = Span::new(at, at + 2);
        let printed = facts.text(span);
        let mixed = matches!(printed, "+-" | "-+");
        let finding = rule.at(facts, span).arg("printed", printed).arg("right", if mixed { "-" } else { "+" });
        found.push(if mixed { finding.fix(span, "-") } else { finding });
    }
}

/// Whether two signs are between the letter of an axis, or the sign of an assignment, and a number or parameter.
fn precedes_number(text: &[u8], at: usize) -> bool {
    let before = at.checked_sub(1).and_then(|before| text.get(before));
    let after = text.get(at + 2);
    before.is_some_and(|byte| *byte == b'=' || byte.is_ascii_alphabetic())
        && after.is_some_and(|byte| matches!(byte, b'.' | b'Q' | b'q') || byte.is_ascii_digit())
}
