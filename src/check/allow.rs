//! Comments that take a finding back: `; ciklo: allow RULE reason`.
//!
//! After a block such a comment speaks for that block, on a line of its own for the block that follows.
//! Invariant: without a reason nothing is taken back, and a comment that takes nothing back is reported.
use std::collections::HashSet;

use super::{Against, RULES};
use crate::base::diag::{Diagnostic, Place, Severity, Span};
use crate::base::renamed;
use crate::language::locale::Scope;
use crate::program::syntax::{Block, BlockKind, Program};

/// What such a comment begins with, in any case.
const MARK: &str = "ciklo:";
const VERB: &str = "allow";

/// Codes of findings about such comments.
pub const CODES: [&str; 3] = ["allow-without-reason", "allow-unknown-rule", "allow-unused"];

/// A comment that takes back findings of a rule.
struct Allowance {
    place: Span,
    rule: String,
    reason: bool,
    /// The block that it speaks for.
    block: Option<Span>,
}

impl Allowance {
    /// What is allowed, and the beginning of the block in which it is.
    fn key(&self) -> Option<(usize, &str)> {
        Some((self.block?.start, self.rule.as_str()))
    }
}

/// Takes back what the program's comments allow, and adds what is wrong with them.
pub(super) fn apply(program: &Program, against: &Against<'_>, found: &mut Vec<Diagnostic>) {
    if !holds(program.source().text(), MARK) {
        return;
    }
    let all = allowances(program);
    let allowed: HashSet<_> = all.iter().filter(|own| own.reason).filter_map(Allowance::key).collect();
    let mut used = HashSet::new();
    found.retain(|diagnostic| {
        let Some(place) = &diagnostic.place else { return true };
        let at = place.span.start;
        // They are in the order of their blocks.
        let first = all.partition_point(|own| own.block.is_some_and(|block| block.end <= at));
        let block = all.get(first).and_then(|own| own.block).filter(|block| block.start <= at);
        let Some(key) = block.and_then(|block| allowed.get(&(block.start, diagnostic.code))) else { return true };
        used.insert(*key);
        false
    });
    for own in &all {
        let (code, severity) = match own {
            own if !is_rule(&own.rule, against) => ("allow-unknown-rule", Severity::Warning),
            own if !own.reason => ("allow-without-reason", Severity::Warning),
            own if own.key().is_none_or(|own| !used.contains(&own)) => ("allow-unused", Severity::Note),
            _ => continue,
        };
        let place = Place::new(program.source(), own.place);
        found.push(Diagnostic { severity, ..Diagnostic::error(code, place) }.arg("rule", own.rule.as_str()));
    }
}

/// Whether findings can have that code.
fn is_rule(code: &str, against: &Against<'_>) -> bool {
    let readers = against.readers;
    let guard = || {
        let key = format!("guard-{code}");
        readers.is_empty() || readers.iter().any(|language| language.has(key.as_str(), &Scope::NONE))
    };
    code.starts_with("syntax-") || RULES.iter().any(|rule| rule.code == code) || guard()
}

fn holds(text: &str, mark: &str) -> bool {
    // The last character is rare, and looked for as fast as memory is read.
    let Some(last) = mark.chars().next_back() else { return true };
    text.match_indices(last).any(|(at, found)| {
        let end = at + found.len();
        let own = end.checked_sub(mark.len()).and_then(|start| text.as_bytes().get(start..end));
        own.is_some_and(|own| own.eq_ignore_ascii_case(mark.as_bytes()))
    })
}

fn allowances(program: &Program) -> Vec<Allowance> {
    let mut all: Vec<Allowance> = Vec::new();
    // Those on lines of their own that wait for their block.
    let mut waiting = 0;
    for block in program.blocks() {
        collect(program, block, &mut all);
        if !matches!(block.kind, BlockKind::Comment | BlockKind::Empty) {
            all.iter_mut().skip(waiting).for_each(|allowance| allowance.block = Some(block.span));
            waiting = all.len();
        }
    }
    all
}

/// Where the comment with the mark begins in a line, and what follows the mark.
fn marked(line: &str) -> Option<(usize, &str)> {
    let mut after = 0;
    while let Some(at) = line.get(after..)?.find(';') {
        let from = after + at;
        let rest = line.get(from + 1..)?.trim_start_matches([';', ' ', '\t']);
        let (mark, words) = rest.split_at_checked(MARK.len()).unwrap_or_default();
        if mark.eq_ignore_ascii_case(MARK) {
            return Some((from, words));
        }
        after = line.len() - rest.len();
    }
    None
}

fn collect(program: &Program, block: &Block, all: &mut Vec<Allowance>) {
    let text = program.slice(block.span);
    if !holds(text, MARK) {
        return;
    }
    let mut at = block.span.start;
    for line in text.split_inclusive(['\n', '\r']) {
        if let Some((from, words)) = marked(line) {
            let words = words.trim().trim_end_matches('~');
            let mut words = words.split_whitespace();
            if words.next().is_some_and(|verb| verb.eq_ignore_ascii_case(VERB)) {
                let end = at + line.trim_end().len();
                all.push(Allowance {
                    place: Span::new(at + from, end),
                    rule: renamed::present(&words.next().unwrap_or_default().to_ascii_lowercase()).to_owned(),
                    reason: words.next().is_some(),
                    block: None,
                });
            }
        }
        at += line.len();
    }
}
