//! A measuring height above everything that could be touched there: above the top of the blank, or, in a program without a
//! blank, above every surface that its cycles machine.
//!
//! Only probing cycles that measure sideways at a height. Without a blank only where no other measuring height is so high.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::blank::{Blank, is_unmoved};
use crate::check::cycle::{probes, removes_material};
use crate::check::program::number;
use crate::check::{Aspect, Facts, Modal, Rule, Tri};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "measuring-height-above-surface", severity: Severity::Warning, run };

/// The meanings of the values.
const HEIGHT: &str = "measuring-height";
const SURFACE: &str = "surface-coordinate";
const AXIS: &str = "measuring-axis";
/// The value of that for the axis of the probe.
const TOOL_AXIS: f64 = 3.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.begins() {
        return;
    }
    let blank = Blank::of(facts.program).map(|blank| blank.high[2]);
    let has_blank = facts.program.blocks().iter().any(|block| matches!(block.kind, BlockKind::BlkForm(_)));
    let mut surface: Option<f64> = None;
    let mut heights = Vec::new();
    for own in &facts.definitions {
        let Some(cycle) = own.related_cycle() else { continue };
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        if removes_material(cycle) {
            match read.item(SURFACE).map(number) {
                Some(Some(value)) => surface = Some(surface.map_or(value, |own| own.max(value))),
                Some(None) => return,
                None => {}
            }
        }
        // Along the tool axis it is touched from above.
        let sideways = read.item(AXIS).is_none_or(|item| number(item).is_some_and(|axis| axis != TOOL_AXIS));
        if let (true, Some(item)) = (probes(cycle) && sideways, read.item(HEIGHT))
            && let Some(height) = number(item)
        {
            let modal = facts.run.before(own.view.first);
            heights.push((height, item.value_span, modal.map(|modal| (is_unmoved(&modal), may_be_unmoved(&modal)))));
        }
    }
    let top = if has_blank { blank } else { surface };
    let Some(top) = top else { return };
    // After a preset that was probed nothing is certain, but what is machined says where the workpiece is.
    let probed = surface.filter(|_| has_blank).map(|surface| surface.max(top));
    let is_above = |height: f64, moved: Option<(bool, bool)>| match moved {
        Some((true, _)) => height > top,
        Some((false, true)) => probed.is_some_and(|probed| height > probed),
        _ => false,
    };
    let above: Vec<_> = heights.iter().filter(|(height, _, moved)| is_above(*height, *moved)).collect();
    if !has_blank && above.len() != 1 {
        return;
    }
    for (height, span, _) in above {
        found.push(rule.at(facts, *span).arg("value", Arg::Number(*height)).arg("other", Arg::Number(top)));
    }
}

/// Whether nothing certainly shifts, turns or tilts the coordinates along the tool axis.
fn may_be_unmoved(modal: &Modal) -> bool {
    let still = [Aspect::ShiftZ, Aspect::Tilting, Aspect::Scaling, Aspect::AxisScaling, Aspect::Mirroring];
    still.iter().all(|own| modal.is(*own) != Tri::Yes)
}
