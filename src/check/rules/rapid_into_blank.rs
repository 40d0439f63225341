//! A rapid movement along the tool axis alone that ends inside of the blank, before anything has been cut.
//!
//! Looked at from the beginning of a program with a box as its blank up to the first block that is no plain movement,
//! tool call or M function: what has cut or moved the coordinates then is not known. The place in the plane must be
//! known and lie inside of the blank with its edges left out. Said once a program.
use crate::check::contours::moved;
use crate::check::{Facts, Rule};
use crate::diag::{Arg, Diagnostic, Severity};
use crate::syntax::{Amount, Axis, BlkForm, Block, BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "rapid-into-blank", severity: Severity::Warning, run };

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// The corners of a blank, the lower one first.
struct Blank {
    low: [f64; 3],
    high: [f64; 3],
}

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
        let Some(blank) = Blank::of(first, second).filter(|_| tool) else { return };
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
            && (blank.low[2]..blank.high[2]).contains(&z)
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

impl Blank {
    /// The blank with its corners in order.
    fn of(first: &BlkForm, second: &BlkForm) -> Option<Self> {
        if first.axis != Some(Axis::Z) {
            return None;
        }
        let number = |form: &BlkForm, axis: Axis| {
            let coord = form.coords.iter().find(|coord| coord.axis == axis)?;
            match coord.value.amount {
                Amount::Number(number) => Some((number, coord.incremental)),
                Amount::Q { .. } | Amount::Text(_) => None,
            }
        };
        let mut blank = Self { low: [0.0; 3], high: [0.0; 3] };
        for (place, axis) in AXES.into_iter().enumerate() {
            let (one, _) = number(first, axis)?;
            let (other, incremental) = number(second, axis)?;
            let other = if incremental { one + other } else { other };
            (blank.low[place], blank.high[place]) = (one.min(other), one.max(other));
        }
        Some(blank)
    }

    /// Whether a place of the plane lies inside.
    fn holds(&self, x: f64, y: f64) -> bool {
        self.low[0] < x && x < self.high[0] && self.low[1] < y && y < self.high[1]
    }
}
