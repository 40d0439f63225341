//! The pockets, slots, holes and studs that a program mills at places which the blocks of their calls name.
//!
//! Invariant: only what is certainly there; whether more is machined is not said.
use std::collections::HashMap;

use super::blank::is_unmoved;
use super::contours::place_of_call;
use super::cycle::removes_material;
use super::floors::{SURFACE, bottom};
use super::program::{number, with_meaning};
use super::{Definition, Facts, Loaded, Pending};
use crate::base::expr::{cosd, sind};
use crate::spec::{Cycle, Group};

/// The sizes of what is milled, by their meanings: a diameter, or two sides.
const INSIDE_ROUND: [&str; 2] = ["circle-diameter", "nominal-diameter"];
const INSIDE: [[&str; 2]; 2] = [["first-side-length", "second-side-length"], ["slot-length", "milled-slot-width"]];
const AROUND_ROUND: [&str; 2] = ["finished-part-diameter", "blank-diameter"];
const AROUND: [[&str; 2]; 2] =
    [["stud-first-side-length", "blank-first-side-length"], ["stud-second-side-length", "blank-second-side-length"]];
/// The meanings of the angle about which it is turned, and of the place that the call names in it.
const ANGLE: &str = "angle-of-rotation";
const POSITIONS: [&str; 3] = ["pocket-position", "slot-position", "stud-position"];
/// The meaning of the preset that a cycle activates.
const PRESET: &str = "preset-number";
/// So many are looked at.
const MOST: usize = 1 << 8;

/// A shape in the plane.
#[derive(Clone, Copy, Debug)]
pub(super) enum Shape {
    /// A circle, by its diameter.
    Round(f64),
    /// A rectangle, by its sides, turned by an angle.
    Sides([f64; 2], f64),
}

impl Shape {
    /// Whether a place, from its centre, lies inside by more than a margin.
    pub(super) fn holds(self, [x, y]: [f64; 2], margin: f64) -> bool {
        match self {
            Self::Round(diameter) => libm::hypot(x, y) < diameter / 2.0 - margin,
            Self::Sides(sides, angle) => {
                let (cos, sin) = (cosd(angle), sind(angle));
                let along = [x * cos + y * sin, y * cos - x * sin];
                (0..2).all(|own| along[own].abs() < sides[own] / 2.0 - margin)
            }
        }
    }

    /// The radius of the greatest circle in it.
    pub(super) fn inner(self) -> f64 {
        match self {
            Self::Round(diameter) => diameter / 2.0,
            Self::Sides([one, other], _) => one.min(other) / 2.0,
        }
    }

    /// The radius of a circle around it.
    pub(super) fn outer(self) -> f64 {
        match self {
            Self::Round(diameter) => diameter / 2.0,
            Self::Sides([one, other], _) => libm::hypot(one, other) / 2.0,
        }
    }

    /// How wide it is along X and along Y, if it is a rectangle that lies along them.
    pub(super) fn widths(self) -> Option<[f64; 2]> {
        match self {
            Self::Sides(sides, angle) if angle % 180.0 == 0.0 => Some(sides),
            Self::Sides([one, other], angle) if angle % 90.0 == 0.0 => Some([other, one]),
            _ => None,
        }
    }
}

/// Something that is milled.
#[derive(Clone, Copy, Debug)]
pub(super) struct Milled {
    /// The block of the call.
    pub(super) block: usize,
    /// The tool.
    pub(super) loaded: Loaded,
    /// Its centre.
    pub(super) at: [f64; 2],
    /// The pocket, or the stud.
    pub(super) shape: Shape,
    /// The blank of a stud.
    pub(super) blank: Option<Shape>,
    /// The surface and the floor, where they are known.
    pub(super) heights: [Option<f64>; 2],
}

impl Milled {
    /// All that a program mills at known places.
    pub(super) fn all(facts: &Facts<'_>) -> Vec<Self> {
        let mut shapes: HashMap<u32, Option<Kind>> = HashMap::new();
        let mut all = Vec::new();
        for call in facts.run.calls.iter().filter(|call| is_unmoved(&call.modal)) {
            let Pending::Definition(index) = call.modal.pending else { continue };
            let kind = shapes.entry(index).or_insert_with(|| {
                let own = facts.definitions.get(index as usize)?;
                own.related_cycle().filter(|cycle| removes_material(cycle))?;
                let related = own.as_related_cycle();
                Kind::of(&facts.read(&related))
            });
            let Some(kind) = *kind else { continue };
            let Some(at) = place_of_call(facts, call.block) else { continue };
            let (block, loaded) = (call.block, call.modal.loaded);
            let Kind { shape, blank, heights } = kind;
            all.push(Self { block, loaded, at, shape, blank, heights });
            if all.len() >= MOST {
                break;
            }
        }
        all
    }

    /// Whether nothing sets another datum between its call and a block.
    pub(super) fn same_datum(&self, facts: &Facts<'_>, block: usize) -> bool {
        let first = facts.definitions.partition_point(|own| own.view.first < self.block);
        let end = facts.definitions.partition_point(|own| own.view.first < block);
        let between = facts.definitions.get(first..end).unwrap_or_default();
        let keeps = |cycle: &Cycle| cycle.file.group != Group::Datum && with_meaning(cycle, PRESET).is_none();
        between.iter().all(|own| own.related_cycle().is_some_and(keeps))
    }

    /// A place from its centre.
    pub(super) fn from(&self, place: [f64; 2]) -> [f64; 2] {
        [place[0] - self.at[0], place[1] - self.at[1]]
    }

    /// Whether the surface at a place is removed, well away from its walls.
    pub(super) fn removes(&self, place: [f64; 2], margin: f64) -> bool {
        let from = self.from(place);
        match self.blank {
            None => self.shape.holds(from, margin),
            Some(blank) => blank.holds(from, margin) && !self.shape.holds(from, -margin),
        }
    }
}

/// What a definition mills.
#[derive(Clone, Copy)]
struct Kind {
    shape: Shape,
    blank: Option<Shape>,
    heights: [Option<f64>; 2],
}

impl Kind {
    fn of(read: &Definition<'_>) -> Option<Self> {
        let value = |meaning: &str| read.item(meaning).and_then(number);
        if POSITIONS.iter().any(|own| read.item(own).is_some_and(|item| number(item) != Some(0.0))) {
            return None;
        }
        let heights = [value(SURFACE), bottom(read)];
        let angle = match read.item(ANGLE) {
            Some(item) => number(item)?,
            None => 0.0,
        };
        let inside = INSIDE_ROUND.iter().find_map(|own| value(own)).map(Shape::Round);
        let inside = inside
            .or_else(|| INSIDE.iter().find_map(|[one, two]| Some(Shape::Sides([value(one)?, value(two)?], angle))));
        if let Some(shape) = inside {
            return Some(Self { shape, blank: None, heights });
        }
        let round = || AROUND_ROUND.map(value).map(|own| own.map(Shape::Round));
        let sides = |at: usize| Some(Shape::Sides([value(AROUND[0][at])?, value(AROUND[1][at])?], angle));
        let (shape, blank) = match round() {
            [Some(shape), blank] => (shape, blank?),
            [None, _] => (sides(0)?, sides(1)?),
        };
        Some(Self { shape, blank: Some(blank), heights })
    }
}
