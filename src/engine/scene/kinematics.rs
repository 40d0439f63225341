//! What a scene says of the kinematics beside the machine's model: how the machine really is, and what was saved.
//!
//! Invariant: the control sees none of the errors; it can only measure them.
use glam::DVec3;

use crate::engine::geometry::RotaryAxis;
use crate::engine::machine::{Machine, SavedKinematics, TrueMachine};
use crate::engine::read::Reader;
use crate::spec::Node;

/// What `kinematics` says: the true machine, where it is another one, and the memories.
pub(super) fn read(
    node: &Node,
    machine: Option<&Machine>,
    r: &mut Reader<'_>,
) -> (Option<TrueMachine>, Vec<SavedKinematics>) {
    r.only_keys(node, &["errors", "drift", "saved"]);
    let saved = node.get("saved").map_or_else(Vec::new, |list| SavedKinematics::read_all(list, r));
    let Some(machine) = machine else { return (None, saved) };
    let mut truth = TrueMachine::as_model(machine);
    if let Some(drift) = node.get("drift").and_then(|node| r.vector(node)) {
        truth.drift = drift;
    }
    let list = node.get("errors").map_or(&[][..], |node| r.items(node));
    for item in list {
        error(item, machine, &mut truth, r);
    }
    ((truth != TrueMachine::as_model(machine)).then_some(truth), saved)
}

/// The errors of one axis.
fn error(node: &Node, machine: &Machine, truth: &mut TrueMachine, r: &mut Reader<'_>) -> Option<()> {
    r.only_keys(node, &["axis", "centre", "askew", "backlash", "scatter"]);
    let letter = r.need(node, "axis")?;
    let found = letter.text().and_then(|text| {
        let mut letters = text.chars();
        letters.next().and_then(RotaryAxis::from_letter).filter(|_| letters.next().is_none())
    });
    let Some(axis) = found else {
        r.expected(letter, "rotary-axis");
        return None;
    };
    if machine.rotary(axis).is_none() {
        r.report("scene-no-axis", letter, vec![("axis", axis.letter().to_string().into())]);
        return None;
    }
    let centre = node.get("centre").map_or(Some(DVec3::ZERO), |node| r.vector(node))?;
    let askew = node.get("askew").map_or(Some(DVec3::ZERO), |node| r.angles(node))?;
    let backlash = node.get("backlash").map_or(Some(0.0), |node| r.number(node))?;
    let list = node.get("scatter").map_or(&[][..], |node| r.items(node));
    let scatter: Option<Vec<f64>> = list.iter().map(|item| r.number(item)).collect();
    truth.scatter.extend(scatter.filter(|list| !list.is_empty()).map(|list| (axis, list)));
    truth.displace(axis, centre, askew);
    truth.backlash = axis.with(truth.backlash, backlash);
    Some(())
}
