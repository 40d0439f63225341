//! A rapid movement along the tool axis alone that ends inside of the blank, before anything has been cut.
//!
//! Looked at from the beginning of a program with a box as its blank up to the first block that is no plain movement,
//! tool call or M function: what has cut or moved the coordinates then is not known. The place in the plane must be
//! known and lie inside of the blank with its edges left out. Reported once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::blank::{AXES, Blank};
use crate::check::contours::moved;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Axis, Block, BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "rapid-into-blank", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.begins() {
        return;
    }
    let (mut corners, mut tool) = ([None, None], false);
    let mut at: [Option<f64>; 3] = [None; 3];
    for block in facts.program.blocks() {
        if block.skip {
            return;
        }
        let motion = match &block.kind {
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) | BlockKind::BeginPgm(_) => continue,
            BlockKind::ToolDef(_) | BlockKind::FnAssign(_) => continue,
            BlockKind::BlkForm(form) => {
                let Some(corner) = corners.get_mut(usize::from(form.part).wrapping_sub(1)) else { return };
                *corner = Some(form.as_ref());
                continue;
            }
            BlockKind::ToolCall(call) => {
                if call.tool.is_some() {
                    tool = call.axis == Some(Axis::Z);
                    at = [None; 3];
                }
                continue;
            }
            BlockKind::Functions(_) if is_plain(facts, block) => continue,
            BlockKind::Motion(motion) if motion.path() == Path::L && is_plain(facts, block) => motion,
            _ => return,
        };
        let words = motion.words();
        let [Some(first), Some(second)] = corners else { return };
        let Some(blank) = Blank::between(first, second).filter(|_| tool) else { return };
        if words.coords.iter().any(|coord| !AXES.contains(&coord.axis)) {
            return;
        }
        let Some(to) = moved(&words, AXES, at) else { return };
        // A movement at feed may have cut.
        if !motion.outline().is_rapid() {
            return;
        }
        let alone = matches!(words.coords.as_slice(), [only] if only.axis == Axis::Z);
        if let (true, [Some(x), Some(y), Some(z)]) = (alone, to)
            && blank.holds(x, y)
            && blank.is_inside(z)
        {
            let finding = rule.at(facts, facts.content(block)).arg("value", Arg::Number(z));
            found.push(finding.arg("top", Arg::Number(blank.high[2])));
            return;
        }
        at = to;
    }
}

/// Whether a block has no M functions but those of the spindle and the coolant.
fn is_plain(facts: &Facts<'_>, block: &Block) -> bool {
    facts.functions(block).iter().all(|own| matches!(own.number, 3..=5 | 7..=9 | 13 | 14))
}
