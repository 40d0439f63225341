//! A contour that changes from RL to RR or back without a block between them that has no compensation.
//!
//! Only said where the two stand one behind the other in the text, with movements between them and nothing that another
//! way of the run could come in by.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Place, Severity};
use crate::syntax::{BlockKind, Compensates, Compensation, Path};

pub(super) const RULE: Rule = Rule { code: "compensation-switched", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut last = None;
    for block in facts.program.blocks() {
        match &block.kind {
            BlockKind::Motion(motion) => {
                let approach = matches!(motion.path(), Path::Appr(_) | Path::Dep(_));
                match motion.outline().compensates() {
                    _ if approach || block.skip => last = None,
                    Compensates::Unsaid => {}
                    Compensates::Off | Compensates::Along => last = None,
                    Compensates::Beside => {
                        let side = motion.words().compensation;
                        let before = last.replace((side, block.span));
                        if let Some((other, span)) = before.filter(|(other, _)| *other != side)
                            && matches!(other, Some(Compensation::Rl | Compensation::Rr))
                        {
                            let place = Place::new(facts.program.source(), span);
                            found.push(rule.at(facts, facts.content(block)).related("first-place", place));
                        }
                    }
                }
            }
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) | BlockKind::Functions(_) => {}
            _ => last = None,
        }
    }
}
