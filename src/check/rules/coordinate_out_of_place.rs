//! Coordinates that their contour element does not have: polar ones in a Cartesian element, no polar one in a polar
//! element, a polar radius or no angle in an arc about the pole, a centre with three axes, a corner with coordinates.
//!
//! Centres with three axes are reported once a program: some post-processors print all of them.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, Path, is_misplaced};

pub(super) const RULE: Rule = Rule { code: "coordinate-out-of-place", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut centre = false;
    for (_, block) in facts.marked() {
        if let BlockKind::Motion(motion) = &block.kind
            && motion.outline().has_odd_coords()
            && !(centre && motion.path() == Path::Cc)
            && is_misplaced(&motion.words())
        {
            centre |= motion.path() == Path::Cc;
            found.push(rule.at(facts, facts.content(block)).arg("path", motion.path().name().to_uppercase()));
        }
    }
}
