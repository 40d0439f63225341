//! The contours that cycles read from subprograms of the same program, with the cycles that machine them.
//!
//! Invariant: a contour names only cycles that certainly machine it; a program that selects contours in another way has
//! none here.
use std::collections::{HashMap, HashSet};

use super::flow::{Pending, Way};
use super::{Defined, Facts};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Motion, Path, StatementKind};
use crate::spec::{ContourWanted, ParameterKind};

/// A list of contours, the definition that holds it, and the cycles that machine them.
pub(super) struct Listed<'f, 'a> {
    /// The definition with the list.
    pub(super) list: &'f Defined<'a>,
    /// The definitions of the cycles.
    pub(super) readers: Vec<&'f Defined<'a>>,
    /// The blocks of the contours, that of the label and the one that ends it left out.
    pub(super) contours: Vec<&'a [Block]>,
}

/// What a cycle wants of the contours that it machines.
pub(super) fn wanted<'a>(definition: &Defined<'a>) -> Option<&'a ContourWanted> {
    definition.related_cycle()?.file.contour.as_ref()
}

/// The lists of contours of a program that cycles machine.
pub(super) fn listed<'f, 'a>(facts: &'f Facts<'a>) -> Vec<Listed<'f, 'a>> {
    let lists: Vec<&Defined<'a>> =
        facts.definitions.iter().filter(|own| own.has_kind(ParameterKind::LabelList)).collect();
    if lists.is_empty() || facts.marked().any(|(_, block)| selects(facts, block)) {
        return Vec::new();
    }
    let graph = &facts.run.graph;
    let ends = ends(facts);
    let contours = |list: &Defined<'_>| {
        let named = graph.uses_in(list.view.last).iter().filter(|own| own.way == Way::Named);
        let starts = named.filter_map(|own| graph.block_of(own.mark.as_ref()?));
        starts.filter_map(|start| body(facts.program.blocks(), &ends, start)).collect()
    };
    let mut found: Vec<Listed<'f, 'a>> = Vec::new();
    // The places of the lists among those found, and the readers that each has.
    let (mut places, mut read) = (HashMap::new(), HashSet::new());
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(reader) = facts.definitions.get(index as usize).filter(|own| wanted(own).is_some()) else { continue };
        let list = match lists.as_slice() {
            [only] => Some(*only),
            _ if facts.flow.jumps => None,
            several => {
                let before = several.partition_point(|own| own.view.first < call.block);
                before.checked_sub(1).and_then(|at| several.get(at)).copied()
            }
        };
        let Some(list) = list else { continue };
        let place = *places.entry(list.view.first).or_insert_with(|| {
            found.push(Listed { list, readers: Vec::new(), contours: contours(list) });
            found.len() - 1
        });
        if read.insert((place, index)) {
            found[place].readers.push(reader);
        }
    }
    found
}

/// Whether a block names contours in another way than by labels.
fn selects(facts: &Facts<'_>, block: &Block) -> bool {
    match &block.kind {
        BlockKind::Sel(own) => facts.text(own.what).eq_ignore_ascii_case("CONTOUR"),
        BlockKind::Statement(own) => matches!(own.kind, StatementKind::ContourDef | StatementKind::DeclareContour),
        BlockKind::Iso(_) => !block.is_blend(),
        BlockKind::CallPgm(_) | BlockKind::Unknown(_) => true,
        _ => false,
    }
}

/// The blocks that end subprograms.
pub(super) fn ends(facts: &Facts<'_>) -> Vec<usize> {
    facts.marked().filter(|(_, block)| block.ends_subprogram()).map(|(at, _)| at).collect()
}

/// The blocks between a label and the first of those `ends` after it; nothing if there is none.
pub(super) fn body<'a>(blocks: &'a [Block], ends: &[usize], start: usize) -> Option<&'a [Block]> {
    blocks.get(start + 1..*ends.get(ends.partition_point(|end| *end <= start))?)
}

/// The corners of a contour whose elements are all written with numbers, its first point included;
/// nothing if that is not certain.
pub(super) fn corners(blocks: &[Block], axes: [Axis; 2]) -> Option<Vec<[f64; 2]>> {
    let mut points: Vec<[f64; 2]> = Vec::new();
    let (mut at, mut pole, mut polar) = ([None; 2], [None; 2], [None; 2]);
    for block in blocks {
        let motion = match &block.kind {
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) | BlockKind::Functions(_) => continue,
            BlockKind::Motion(motion) if !block.skip => motion.words(),
            _ if block.is_blend() => continue,
            _ => return None,
        };
        match motion.path {
            Path::Rnd | Path::Chf => continue,
            Path::Cc => {
                pole = moved(&motion, axes, if motion.coords.is_empty() { at } else { pole })?;
                continue;
            }
            Path::L | Path::C | Path::Cr | Path::Ct => at = moved(&motion, axes, at)?,
            Path::Lp | Path::Cp | Path::Ctp => {
                for (axis, known) in [Axis::Pr, Axis::Pa].into_iter().zip(&mut polar) {
                    if let Some((value, incremental)) = number(&motion, axis)? {
                        *known = Some(if incremental { (*known)? + value } else { value });
                    }
                }
                let ([Some(x), Some(y)], [Some(radius), Some(angle)]) = (pole, polar) else { return None };
                at = [
                    Some(x + radius * crate::base::expr::cosd(angle)),
                    Some(y + radius * crate::base::expr::sind(angle)),
                ];
            }
            _ => return None,
        }
        if !matches!(motion.path, Path::Lp | Path::Cp | Path::Ctp) {
            polar = [None; 2];
        }
        let [Some(x), Some(y)] = at else { return None };
        points.push([x, y]);
    }
    Some(points)
}

/// The number of an axis and whether it is incremental, if the axis is there; nothing if it is a parameter.
fn number(motion: &Motion, axis: Axis) -> Option<Option<(f64, bool)>> {
    match motion.coord(axis) {
        None => Some(None),
        Some(coord) => match coord.value.amount {
            Amount::Number(number) => Some(Some((number, coord.incremental))),
            _ => None,
        },
    }
}

/// Where a movement leads from a place in X and Y; nothing if that is not certain.
pub(super) fn led(from: Option<[f64; 2]>, motion: &Motion) -> Option<[f64; 2]> {
    match moved(motion, [Axis::X, Axis::Y], from.map_or([None; 2], |from| from.map(Some)))? {
        [Some(x), Some(y)] => Some([x, y]),
        _ => None,
    }
}

/// The same in any axes, of which some may be open before or remain so; nothing if a coordinate is not certain.
pub(super) fn moved<const AXES: usize>(
    motion: &Motion,
    axes: [Axis; AXES],
    from: [Option<f64>; AXES],
) -> Option<[Option<f64>; AXES]> {
    let mut to = from;
    for (axis, known) in axes.into_iter().zip(&mut to) {
        if let Some((value, incremental)) = number(motion, axis)? {
            *known = Some(if incremental { (*known)? + value } else { value });
        }
    }
    Some(to)
}
