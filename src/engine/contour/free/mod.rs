//! Free contours: elements of which a drawing says anything but their ends, solved as far as that determines them.
//!
//! Start reading at [`solve`]. [`Given`] is an element as a program describes it, `state` what is known of a contour so
//! far and how one thing follows from another, `curve` the geometry. Invariant: elements in, elements out; nothing of a
//! run, of blocks or of parameters is known here.
//!
//! Elements are taken in one after the other, and with each one everything is calculated that can be: lines and circles
//! from what is given of them, from points, directions and neighbours that they touch, and ends from both elements that
//! meet there. What a later element determines is calculated when it comes. Where nothing follows by itself any more, what
//! the open elements determine together is calculated as one system (`system`). Where a condition has several solutions
//! all are kept, in an order that is told in `docs/contours.md`, until data rule them out or one is selected.
mod curve;
mod determine;
mod matrix;
mod state;
mod system;

use glam::DVec2;

use self::state::State;
use crate::engine::contour::element::Element;

/// More solutions than that are not kept.
const MOST_SOLUTIONS: usize = 128;

/// A coordinate, or a direction in degrees: absolute, or from the point at which so many elements of the contour have
/// ended, or the direction there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Datum {
    pub(crate) value: f64,
    pub(crate) from: Option<usize>,
}

/// What is given of a point: two coordinates, and radius and angle about the pole.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Point {
    pub(crate) cartesian: [Option<Datum>; 2],
    pub(crate) polar: [Option<Datum>; 2],
}

/// An element as a program describes it. Lengths in mm, angles in degrees.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Given {
    pub(crate) is_arc: bool,
    /// Whether it goes on in the direction in which the element before it ends.
    pub(crate) is_tangential: bool,
    pub(crate) pole: Option<DVec2>,
    pub(crate) end: Point,
    /// The direction at its beginning.
    pub(crate) heading: Option<Datum>,
    /// From its beginning to its end, straight.
    pub(crate) length: Option<f64>,
    pub(crate) centre: Point,
    pub(crate) radius: Option<f64>,
    /// Whether an arc goes round counter-clockwise.
    pub(crate) counter_clockwise: Option<bool>,
    /// The angle of an arc.
    pub(crate) sweep: Option<f64>,
    /// Points on its line or circle.
    pub(crate) on: Vec<DVec2>,
    /// A point and its distance from the line or circle.
    pub(crate) beside: Option<(DVec2, f64)>,
    /// The element to which a line is parallel, counted as points are, and at which distance.
    pub(crate) parallel: Option<(usize, Option<f64>)>,
    /// It closes the contour: it ends where so many elements had ended.
    pub(crate) closes: Option<usize>,
    /// The solutions that are selected after it, from 1.
    pub(crate) selected: Vec<usize>,
}

/// What of an element is not determined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Missing {
    /// The position or the direction of a line.
    Line,
    /// The centre or the radius of an arc.
    Arc,
    /// Its end.
    End,
}

/// Why a contour has no solution. Elements are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flaw {
    /// Nothing meets the data of that element and of those before it.
    Contradiction { element: usize },
    /// That element is not determined; so many values are missing until all are.
    Open { element: usize, missing: Missing, values: usize },
    /// Since that element there are several solutions.
    Several { element: usize, solutions: usize },
    /// There are not so many solutions.
    Selection { element: usize, wanted: usize, solutions: usize },
}

/// The lines and arcs of a contour that begins at a point, in a direction if one leads there.
pub(crate) fn solve(start: DVec2, heading: Option<DVec2>, given: &[Given]) -> Result<Vec<Element>, Flaw> {
    let mut states = vec![State::new(start, heading)];
    let mut since = 0;
    for (element, own) in given.iter().enumerate() {
        let before = states.len();
        let mut found = Vec::with_capacity(before);
        for state in states {
            state.with(given, element, &mut found);
        }
        let mut next: Vec<State> = Vec::with_capacity(found.len());
        for state in found {
            if !next.iter().any(|known| known.is(&state)) {
                next.push(state);
            }
        }
        if next.is_empty() {
            return Err(Flaw::Contradiction { element });
        }
        for wanted in &own.selected {
            let solutions = next.len();
            if *wanted == 0 || *wanted > solutions {
                return Err(Flaw::Selection { element, wanted: *wanted, solutions });
            }
            next = vec![next.swap_remove(wanted - 1)];
        }
        if next.len() > before {
            since = element;
        }
        if next.len() > MOST_SOLUTIONS {
            return Err(Flaw::Several { element: since, solutions: next.len() });
        }
        states = next;
    }
    let solutions = states.len();
    match states.as_slice() {
        [only] => only.elements(given),
        [first, ..] => first.elements(given).and(Err(Flaw::Several { element: since, solutions })),
        [] => Err(Flaw::Contradiction { element: 0 }),
    }
}
