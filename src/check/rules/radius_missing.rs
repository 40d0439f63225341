//! An arc CR or a rounding RND without its radius.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "radius-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for block in facts.program.blocks() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if matches!(motion.path(), Path::Cr | Path::Rnd) && motion.words().radius.is_none() {
            found.push(rule.at(facts, facts.content(block)));
        }
    }
}
