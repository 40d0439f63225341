//! A decimal comma in a program that has decimal points everywhere else: the control reads one of the two only.
//!
//! In values of cycle definitions, where at least one other has a point and fewer have a comma, and in the only movement of a
//! program that has one. Reported once a program.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, CycleForm, ValueKind};

pub(super) const RULE: Rule = Rule { code: "decimal-comma", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut first, mut commas, mut points): (Option<Span>, usize, usize) = (None, 0, 0);
    for own in &facts.definitions {
        let CycleForm::Parameters(written) = &own.view.form else { continue };
        for value in written.parameters.iter().map(|own| own.value) {
            if !matches!(value.kind, ValueKind::Number(_)) {
                continue;
            }
            let text = facts.text(value.span);
            if text.contains(',') {
                commas += 1;
                first = first.or(Some(value.span));
            }
            points += usize::from(text.contains('.'));
        }
    }
    if let Some(span) = first.filter(|_| commas < points) {
        return found.push(rule.at(facts, span));
    }
    if first.is_none() {
        found.extend(coordinate(facts, points).map(|span| rule.at(facts, span)));
    }
}

/// The only movement with a decimal comma, in a program without any or with decimal points in at least two other places.
fn coordinate(facts: &Facts<'_>, mut points: usize) -> Option<Span> {
    let text = facts.program.source().text();
    memchr::memchr(b',', text.as_bytes())?;
    let mut comma = None;
    for block in facts.program.blocks() {
        if !matches!(block.kind, BlockKind::Motion(_)) {
            continue;
        }
        let span = facts.content(block);
        let code = facts.text(span).split(';').next().unwrap_or_default().as_bytes();
        let between =
            |sign: u8| code.windows(3).any(|own| own[1] == sign && own[0].is_ascii_digit() && own[2].is_ascii_digit());
        if between(b',') && comma.replace(span).is_some() {
            return None;
        }
        points += usize::from(between(b'.'));
    }
    comma.filter(|_| points != 1)
}
