//! A block of DIN/ISO in which something is missing without which it means nothing: a coordinate without its value,
//! `G98` without `L`, `G24` or `G25` without `R`, a D function without an operand or its label, a cycle of older
//! software without any of its words.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, IsoBlock, IsoKind, ValueKind, is_older};

pub(super) const RULE: Rule = Rule { code: "iso-incomplete", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        // Blocks that have an equivalent are read as such.
        if let BlockKind::Iso(own) = &block.kind
            && let Some(what) = missing(own)
        {
            found.push(rule.at(facts, block.comment().unwrap_or(block.span)).arg("what", what));
        }
    }
}

/// What the block lacks. Its words are known by their values and their number only: their places are those of the
/// DIN/ISO text.
fn missing(own: &IsoBlock) -> Option<&'static str> {
    let count = own.words.len();
    let moves = matches!(own.kind, IsoKind::Path(_) | IsoKind::Centre | IsoKind::Blank(_) | IsoKind::Call);
    if moves && own.words.iter().any(|word| word.value.kind == ValueKind::Missing) {
        return Some("value");
    }
    match own.kind {
        IsoKind::Label | IsoKind::CallLabel if count < 2 => Some("label"),
        IsoKind::Chamfer | IsoKind::Rounding | IsoKind::Blend(_) if count < 2 => Some("radius"),
        IsoKind::Function(0 | 5..=7) if count < 3 => Some("operand"),
        IsoKind::Function(1..=4 | 8 | 13) if count < 4 => Some("operand"),
        IsoKind::Function(9..=12) if count < 4 => Some("operand"),
        // Each has two words at least; an M function may come after the code.
        IsoKind::Cycle(code) if is_older(code) && count < 3 => Some("cycle"),
        _ => None,
    }
}
