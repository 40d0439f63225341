//! A file that is no program: no BEGIN PGM, no END PGM, and most of its blocks cannot be read; or bytes of which too
//! many are no characters of any text, as in archives, pictures and executables.
//!
//! Header files of other languages end with `.h`, too. It is the only finding of such a file.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "not-a-program", severity: Severity::Error, run };

/// Fewer blocks than that may be a piece of a program with mistakes.
const LEAST: usize = 4;
/// Of so many characters one may be a control character: a single stray byte makes no program unreadable.
const STRAY: usize = 50;
/// What editors and transfers leave in programs: tabs, form feeds, the ends of texts and files, the marks of serial
/// lines.
const LEFT: [char; 12] = ['\t', '\r', '\x0c', '\x1a', '\x02', '\x03', '\x04', '\x11', '\x12', '\x13', '\x14', '\x1b'];
/// How many bytes of a file are looked at for control characters.
const LOOKED_AT: usize = 1 << 16;

/// The finding of a file that is no program.
pub(in crate::check) fn whole(facts: &Facts<'_>) -> Option<Diagnostic> {
    let mut found = Vec::new();
    run(&RULE, facts, &mut found);
    found.pop()
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if is_binary(facts.program.source().text()) {
        found.push(rule.at(facts, Span::new(0, 0)));
        return;
    }
    if facts.begins() || facts.end.is_some() {
        return;
    }
    let (mut all, mut unread) = (0, 0);
    for block in facts.acting() {
        all += 1;
        unread += usize::from(block.is_unread());
    }
    if all < LEAST || unread * 2 <= all || facts.unread("BEGIN") || facts.unread("END") || facts.unread("%") {
        return;
    }
    if let Some(first) = facts.acting().next() {
        found.push(rule.at(facts, facts.content(first)));
    }
}

/// Whether a text has more control characters than a stray one. Zero bytes after or between blocks are what a transfer
/// leaves that was cut off: they count where something else is with them in their line.
fn is_binary(text: &str) -> bool {
    let (mut all, mut stray) = (0_usize, 0_usize);
    let end = (0..=LOOKED_AT.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or_default();
    for line in text.get(..end).unwrap_or_default().lines() {
        if line.chars().all(|own| own == '\0') {
            continue;
        }
        all += line.chars().count();
        stray += line.chars().filter(|own| own.is_control() && !LEFT.contains(own)).count();
    }
    stray > 2 && stray * STRAY > all
}
