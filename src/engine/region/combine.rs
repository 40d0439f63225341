//! Union, difference and intersection of regions, from the same of two plain closed lines.
//!
//! Invariant: the parts of a region do not overlap, and each hole lies inside of its outer boundary and outside of
//! the other holes.
use cavalier_contours::polyline::{
    BooleanOp, BooleanResult, BooleanResultInfo, PlineBooleanOptions, PlineCreation, PlineOrientation, PlineSource,
    PlineSourceMut, Polyline, seg_midpoint,
};
use cavalier_contours::static_aabb2d_index::AABB;

use super::boundary::{has_area, inverted};
use super::{NEAR, NO_AREA, Part, Region};

pub(super) fn intersection(one: &Region, other: &Region) -> Region {
    let parts = other.parts.iter().flat_map(|part| {
        let common = one.parts.iter().flat_map(|own| meet(own, &part.outer)).collect();
        without_all(common, &part.holes)
    });
    Region { parts: parts.collect() }
}

pub(super) fn difference(one: &Region, other: &Region) -> Region {
    let mut parts = one.parts.clone();
    for part in &other.parts {
        // What lies in the holes of the other stays.
        let kept: Vec<Part> = part
            .holes
            .iter()
            .flat_map(|hole| parts.iter().flat_map(|own| meet(own, hole)).collect::<Vec<_>>())
            .collect();
        parts = parts.into_iter().flat_map(|own| without(own, &part.outer)).collect();
        parts.extend(kept);
    }
    Region { parts }
}

pub(super) fn union(one: &Region, other: &Region) -> Region {
    // All that neither has, taken from a frame around both.
    let Some(frame) = frame(one, other, 0.0) else { return Region::default() };
    difference(&frame, &difference(&difference(&frame, one), other))
}

/// A rectangle that both lie inside of, wider by more than a margin in mm.
pub(super) fn frame(one: &Region, other: &Region, margin: f64) -> Option<Region> {
    let extents = one.parts.iter().chain(&other.parts).filter_map(|part| part.outer.extents());
    let bounds = extents.reduce(|a, b| AABB {
        min_x: a.min_x.min(b.min_x),
        min_y: a.min_y.min(b.min_y),
        max_x: a.max_x.max(b.max_x),
        max_y: a.max_y.max(b.max_y),
    })?;
    let margin = margin + 1.0 + (bounds.max_x - bounds.min_x) + (bounds.max_y - bounds.min_y);
    let mut outer = Polyline::with_capacity(4, true);
    outer.add(bounds.min_x - margin, bounds.min_y - margin, 0.0);
    outer.add(bounds.max_x + margin, bounds.min_y - margin, 0.0);
    outer.add(bounds.max_x + margin, bounds.max_y + margin, 0.0);
    outer.add(bounds.min_x - margin, bounds.max_y + margin, 0.0);
    Some(Region { parts: vec![Part { outer, holes: Vec::new() }] })
}

/// A part without what a line encloses.
fn without(part: Part, line: &Polyline) -> Vec<Part> {
    let mut line = line.clone();
    // Holes that the line reaches become one with it, and what they enclose together is left over.
    let (mut kept, mut joined, mut cavities) = (Vec::new(), Vec::new(), Vec::new());
    for (n, hole) in part.holes.iter().enumerate() {
        let both = boolean(&line, hole, BooleanOp::Or);
        match both.result_info {
            BooleanResultInfo::Pline1InsidePline2 | BooleanResultInfo::Overlapping => return vec![part],
            BooleanResultInfo::Pline2InsidePline1 => {}
            BooleanResultInfo::Intersected if both.pos_plines.len() == 1 => {
                joined.push(n);
                cavities.extend(plain(both.neg_plines).into_iter().map(|cavity| (cavity, joined.clone())));
                line = plain(both.pos_plines).pop().unwrap_or(line);
            }
            _ => kept.push(hole.clone()),
        }
    }
    let mut found = Vec::new();
    for (cavity, joined) in cavities {
        let others = part.holes.iter().enumerate().filter(|(n, _)| !joined.contains(n)).map(|(_, hole)| hole);
        let inside = Part { outer: part.outer.clone(), holes: Vec::new() };
        found.extend(others.fold(meet(&inside, &cavity), |parts, hole| without_all(parts, std::slice::from_ref(hole))));
    }
    let rest = boolean(&part.outer, &line, BooleanOp::Not);
    match rest.result_info {
        BooleanResultInfo::Disjoint | BooleanResultInfo::InvalidInput => {
            found.push(Part { outer: part.outer, holes: kept })
        }
        BooleanResultInfo::Pline1InsidePline2 | BooleanResultInfo::Overlapping => {}
        BooleanResultInfo::Pline2InsidePline1 => {
            kept.retain(|hole| !is_inside(hole, &line));
            kept.push(line);
            found.push(Part { outer: part.outer, holes: kept });
        }
        BooleanResultInfo::Intersected => {
            found.extend(assembled(plain(rest.pos_plines), kept).parts);
        }
    }
    found
}

/// Some parts without what several lines enclose.
fn without_all(parts: Vec<Part>, lines: &[Polyline]) -> Vec<Part> {
    lines.iter().fold(parts, |parts, line| parts.into_iter().flat_map(|part| without(part, line)).collect())
}

/// What of a part a line encloses.
fn meet(part: &Part, line: &Polyline) -> Vec<Part> {
    let common = boolean(&part.outer, line, BooleanOp::And);
    let parts = match common.result_info {
        BooleanResultInfo::Pline1InsidePline2 | BooleanResultInfo::Overlapping => vec![part.outer.clone()],
        BooleanResultInfo::Pline2InsidePline1 => vec![line.clone()],
        BooleanResultInfo::Disjoint | BooleanResultInfo::InvalidInput => Vec::new(),
        BooleanResultInfo::Intersected => plain(common.pos_plines),
    };
    let parts = parts.into_iter().map(|outer| Part { outer, holes: Vec::new() }).collect();
    without_all(parts, &part.holes)
}

/// Lines as a region, each hole in the smallest outer boundary around it; holes outside of all are none.
pub(super) fn assembled(mut outer: Vec<Polyline>, holes: Vec<Polyline>) -> Region {
    outer.sort_by(|a, b| a.area().total_cmp(&b.area()));
    let mut parts: Vec<Part> = outer.into_iter().map(|outer| Part { outer, holes: Vec::new() }).collect();
    for hole in holes {
        if let Some(part) = parts.iter_mut().find(|part| is_inside(&hole, &part.outer)) {
            part.holes.push(hole);
        }
    }
    Region { parts }
}

/// Whether a line that does not cross another one lies inside of it: some point of it that is not on the other does.
fn is_inside(line: &Polyline, around: &Polyline) -> bool {
    let points = line.iter_segments().flat_map(|(from, to)| [from.pos(), seg_midpoint(from, to)]);
    let off = |at: &_| around.closest_point(*at, NEAR).is_none_or(|near| near.distance > 100.0 * NEAR);
    points.into_iter().find(off).map_or_else(|| line.area() <= around.area(), |at| around.winding_number(at) != 0)
}

fn boolean(one: &Polyline, other: &Polyline, operation: BooleanOp) -> BooleanResult<Polyline> {
    let options =
        PlineBooleanOptions { pline1_aabb_index: None, pos_equal_eps: NEAR, collapsed_area_eps: Some(NO_AREA) };
    one.boolean_opt(other, operation, &options)
}

/// The lines of a result that enclose something, counterclockwise.
fn plain(lines: Vec<cavalier_contours::polyline::BooleanResultPline<Polyline>>) -> Vec<Polyline> {
    let lines = lines.into_iter().map(|line| line.pline).filter(has_area);
    lines.map(|line| if line.orientation() == PlineOrientation::Clockwise { inverted(&line) } else { line }).collect()
}
