//! A coordinate of a movement beyond what the manuals let anybody enter for coordinates.
//!
//! The manuals print ranges for the coordinates in cycles; the widest of them is the limit here. Long programs are only
//! searched for six digits in a row, as such a number has.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Axis, Block, BlockKind};
use crate::spec::MM_PER_INCH;

pub(super) const RULE: Rule = Rule { code: "coordinate-out-of-range", severity: Severity::Warning, run };

/// How many digits before the point a number beyond the range has.
const DIGITS: usize = 6;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(limit) = facts.against.labels.limits(facts.against.catalogue).coordinate else { return };
    for block in facts.program.blocks() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if !has_long_number(facts, block) {
            continue;
        }
        for coord in &motion.words().coords {
            let turns = matches!(coord.axis, Axis::A | Axis::B | Axis::C | Axis::Pa);
            let limit = if facts.inch && !turns { limit / MM_PER_INCH } else { limit };
            let Some(value) = facts.number(&coord.value).filter(|value| value.abs() > limit) else { continue };
            let finding = rule.at(facts, coord.span).arg("value", Arg::Number(value));
            found.push(finding.arg("limit", Arg::Number(limit)));
        }
    }
}

/// Whether a block has enough digits in a row; only every sixth byte of most blocks is looked at.
fn has_long_number(facts: &Facts<'_>, block: &Block) -> bool {
    let bytes = facts.text(block.span).as_bytes();
    let needed = if facts.inch { DIGITS - 2 } else { DIGITS };
    let mut at = needed - 1;
    while let Some(byte) = bytes.get(at) {
        if byte.is_ascii_digit() {
            let before = bytes[..at].iter().rev().take_while(|byte| byte.is_ascii_digit()).count();
            let after = bytes[at..].iter().take_while(|byte| byte.is_ascii_digit()).count();
            if before + after >= needed {
                return true;
            }
        }
        at += needed;
    }
    false
}
