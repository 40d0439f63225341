//! END PGM with another name or unit than BEGIN PGM: a part of another program, or a copy that was half renamed.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, Frame};

pub(super) const RULE: Rule = Rule { code: "begin-end-mismatch", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut begin: Option<&Frame> = None;
    for (_, block) in facts.marked() {
        match &block.kind {
            BlockKind::BeginPgm(frame) => begin = Some(frame),
            BlockKind::EndPgm(end) => {
                let Some(begin) = begin.take() else { continue };
                let (first, last) = (facts.text(begin.name).trim(), facts.text(end.name).trim());
                let unit = |frame: &Frame| if frame.inch { "INCH" } else { "MM" };
                if !first.eq_ignore_ascii_case(last) {
                    let place = if last.is_empty() { facts.content(block) } else { end.name };
                    found.push(rule.at(facts, place).arg("begin", first).arg("end", last));
                } else if begin.inch != end.inch {
                    found.push(rule.at(facts, facts.content(block)).arg("begin", unit(begin)).arg("end", unit(end)));
                }
            }
            _ => {}
        }
    }
}
