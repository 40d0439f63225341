//! LBL 0 without a label that it ends: none comes before it, or another LBL 0 has ended it already.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, Label};

pub(super) const RULE: Rule = Rule { code: "subprogram-end-without-label", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.begins() || facts.flow.unread.anything {
        return;
    }
    let mut begun = false;
    for (_, block) in facts.marked() {
        let BlockKind::Lbl(label) = &block.kind else { continue };
        let ends = label.target == Label::END;
        if ends && !begun {
            found.push(rule.at(facts, facts.content(block)));
        }
        begun = !ends || (begun && block.skip);
    }
}
