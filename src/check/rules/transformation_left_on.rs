//! A datum shift, rotation, mirror image or scaling that is certainly still active where the program ends.
//!
//! A machine parameter decides whether the end of a program resets it, so this is no error. A program that ends with
//! END PGM only may set it for those that call it.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "transformation-left-on", severity: Severity::Warning, run };

/// What may be left on, with the word by which the message knows it.
const LEFT: [(Aspect, &str); 5] = [
    (Aspect::DatumShift, "datum-shift"),
    (Aspect::Rotation, "rotation"),
    (Aspect::Mirroring, "mirroring"),
    (Aspect::Scaling, "scaling"),
    (Aspect::AxisScaling, "scaling"),
];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (aspect, what) in LEFT {
        let ends = facts.run.ends.iter().filter(|(_, modal)| modal.is(aspect) == Tri::Yes);
        let mut blocks = ends.filter_map(|(block, _)| facts.program.blocks().get(*block));
        if let Some(block) = blocks.find(|block| !matches!(block.kind, BlockKind::EndPgm(_))) {
            found.push(rule.at(facts, facts.content(block)).arg("what", what));
        }
    }
}
