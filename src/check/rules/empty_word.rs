//! A block that ends with an `M` without a number, as older controls and their posts print it.
//!
//! It does nothing. Said once a program.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity, Span};
use crate::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "empty-word", severity: Severity::Note, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let text = facts.program.source().text().as_bytes();
    for (_, block) in facts.marked() {
        if !matches!(block.kind, BlockKind::Motion(_) | BlockKind::CyclCall(_)) {
            continue;
        }
        let end = block.comment().map_or(block.span.end, |comment| comment.start);
        let line = text.get(block.span.start..end).unwrap_or_default().trim_ascii_end();
        if let [.., b' ' | b'\t', b'M' | b'm'] = line {
            let at = block.span.start + line.len();
            found.push(rule.at(facts, Span::new(at - 1, at)));
            return;
        }
    }
}
