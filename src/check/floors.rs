//! How deep a program has machined before a definition, as far as its numbers say it.
//!
//! Invariant: nothing is said where something may go deeper that is not known.
use super::cycle::removes_material;
use super::program::{Work, number};
use super::{Definition, Facts};
use crate::program::syntax::{Amount, Axis, BlockKind, StatementKind};
use crate::spec::Group;

/// The meanings of the surface at which a cycle begins, and of its depths.
pub(super) const SURFACE: &str = "surface-coordinate";
pub(super) const DEPTHS: [&str; 3] = ["depth", "thread-depth", "milling-depth"];
/// The meaning of the height down to which a face is milled.
const FACE: &str = "end-point-tool";

/// The lowest floor of the definitions before one, by its index, and of all plain movements; nothing if one of them is
/// not known.
pub(super) fn lowest_before(facts: &Facts<'_>, index: usize) -> Option<f64> {
    let mut lowest = f64::INFINITY;
    for block in facts.program.blocks() {
        match &block.kind {
            BlockKind::Motion(motion) => {
                let words = motion.words();
                let Some(coord) = words.coord(Axis::Z) else { continue };
                let Amount::Number(value) = coord.value.amount else { return None };
                match coord.incremental {
                    false => lowest = lowest.min(value),
                    true if value >= 0.0 => {}
                    true => return None,
                }
            }
            BlockKind::Statement(own) if own.kind == StatementKind::CallSelected => return None,
            BlockKind::CallPgm(_) | BlockKind::Unknown(_) => return None,
            _ => {}
        }
    }
    for own in facts.definitions.get(..index)? {
        if Work::of(facts.program, own).is_some() {
            return None;
        }
        if own.related_cycle().is_some_and(removes_material) {
            let related = own.as_related_cycle();
            lowest = lowest.min(floor(&facts.read(&related), own.related_cycle()?.file.group)?);
        }
    }
    lowest.is_finite().then_some(lowest)
}

/// The height down to which a cycle goes.
fn floor(read: &Definition<'_>, group: Group) -> Option<f64> {
    if group == Group::Surfaces {
        return read.item(FACE).and_then(number);
    }
    bottom(read)
}

/// The bottom of what a cycle machines below its surface.
pub(super) fn bottom(read: &Definition<'_>) -> Option<f64> {
    let value = |meaning: &str| read.item(meaning).and_then(number);
    Some(value(SURFACE)? + DEPTHS.into_iter().find_map(value)?)
}
