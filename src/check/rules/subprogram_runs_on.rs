//! A subprogram that runs into the next one, because no LBL 0 is between them.
//!
//! Only reported where both are called, or read as contours, and neither is jumped to or repeated. Jumps and repeats between
//! the labels must lead to labels between them, and nothing else may lead to those.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::{Facts, Mark, Rule, Way};
use crate::program::syntax::{BlockKind, Label};

pub(super) const RULE: Rule = Rule { code: "subprogram-runs-on", severity: Severity::Warning, run };

/// What leads to a label.
#[derive(Default)]
struct Uses {
    /// Whether something calls it, or reads it as a contour, and whether something jumps to it or repeats it.
    called: bool,
    jumped: bool,
    /// The first block and the last one.
    range: Option<(usize, usize)>,
}

/// A subprogram that has begun.
struct Begun {
    name: String,
    mark: Mark,
    span: Span,
    block: usize,
    /// The labels in it, and those to which it jumps.
    inner: BTreeSet<Mark>,
    targets: BTreeSet<Mark>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let uses = uses(facts);
    let only_called = |mark: &Mark| uses.get(mark).is_some_and(|own| own.called && !own.jumped);
    let mut before: Option<Begun> = None;
    for (index, block) in facts.marked() {
        match &block.kind {
            BlockKind::Lbl(label) => {
                let mark = match label.target {
                    Label::Number(number) => Mark::Number(number),
                    Label::Name(name) => Mark::Name(facts.text(name).to_owned()),
                    Label::Q(_) => continue,
                };
                if mark == Mark::Number(0) {
                    before = None;
                } else if only_called(&mark) {
                    if let Some(own) = before.take().filter(|own| stays_within(own, index, &uses)) {
                        let finding = rule.at(facts, own.span).arg("label", own.name).arg("next", mark.to_string());
                        found.push(finding);
                    }
                    let (name, span) = (mark.to_string(), label.span);
                    let (inner, targets) = (BTreeSet::new(), BTreeSet::new());
                    before = Some(Begun { name, mark, span, block: index, inner, targets });
                } else if let Some(own) = &mut before {
                    own.inner.insert(mark);
                }
            }
            BlockKind::FnJump(_) | BlockKind::CallLbl(_) => {
                for jump in facts.run.graph.uses_in(index).iter().filter(|own| own.way != Way::Call) {
                    match (&jump.mark, &mut before) {
                        (Some(mark), Some(own)) => {
                            own.targets.insert(mark.clone());
                        }
                        (None, _) => before = None,
                        (_, None) => {}
                    }
                }
            }
            _ if facts.ends(block) => before = None,
            _ => {}
        }
    }
}

/// Whether a subprogram, up to a block, neither jumps out nor is jumped into.
fn stays_within(own: &Begun, end: usize, uses: &BTreeMap<&Mark, Uses>) -> bool {
    let inside = |mark: &Mark| {
        let range = uses.get(mark).and_then(|own| own.range);
        range.is_none_or(|(first, last)| own.block < first && last < end)
    };
    own.targets.iter().all(|mark| *mark == own.mark || own.inner.contains(mark)) && own.inner.iter().all(inside)
}

/// What leads to the labels.
fn uses<'f>(facts: &'f Facts<'_>) -> BTreeMap<&'f Mark, Uses> {
    let mut all: BTreeMap<&Mark, Uses> = BTreeMap::new();
    for own in &facts.run.graph.uses {
        if let Some(mark) = &own.mark {
            let entry = all.entry(mark).or_default();
            let calls = matches!(own.way, Way::Call | Way::Named);
            (entry.called, entry.jumped) = (entry.called || calls, entry.jumped || !calls);
            let (first, last) = entry.range.unwrap_or((own.block, own.block));
            entry.range = Some((first.min(own.block), last.max(own.block)));
        }
    }
    all
}
