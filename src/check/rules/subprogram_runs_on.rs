//! A subprogram that runs into the next one, because no LBL 0 stands between them.
//!
//! Only said where both are called, neither is jumped to or repeated, and nothing but blocks that always follow each
//! other stands between the labels.
use crate::check::{Facts, Mark, Rule, Way};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::{BlockKind, Label};

pub(super) const RULE: Rule = Rule { code: "subprogram-runs-on", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut before: Option<(String, crate::diag::Span)> = None;
    for block in facts.program.blocks() {
        match &block.kind {
            BlockKind::Lbl(label) => {
                let mark = match label.target {
                    Label::Number(number) => Mark::Number(number),
                    Label::Name(name) => Mark::Name(facts.text(name).to_owned()),
                    Label::Q(_) => continue,
                };
                if mark == Mark::Number(0) {
                    before = None;
                    continue;
                }
                let called = only_called(facts, &mark);
                if let (true, Some((name, span))) = (called, &before) {
                    let finding = rule.at(facts, *span).arg("label", name.as_str()).arg("next", mark.to_string());
                    found.push(finding);
                }
                before = called.then(|| (mark.to_string(), label.span));
            }
            BlockKind::FnJump(_) => before = None,
            _ if facts.ends(block) => before = None,
            _ => {}
        }
    }
}

fn only_called(facts: &Facts<'_>, mark: &Mark) -> bool {
    let mut uses = facts.run.graph.uses.iter().filter(|own| own.mark.as_ref() == Some(mark)).peekable();
    uses.peek().is_some() && uses.all(|own| own.way == Way::Call)
}
