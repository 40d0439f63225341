//! What is remembered of the curves and contours of plain movements.
use std::collections::{BTreeSet, HashMap};

use glam::{DVec2, DVec3};

/// The ends of a movement, hundredths of a millimetre.
pub(super) type Ends = [i64; 6];

/// What is known of the curves.
#[derive(Default)]
pub(super) struct Curves {
    /// The block that draws now, and its height, hundredths of a millimetre.
    pub(super) block: (usize, i64),
    pub(super) count: usize,
    /// Whether it began in the blank, and where it was outside of it.
    pub(super) inside: bool,
    pub(super) left: Option<DVec3>,
    /// Where the tool went down last.
    pub(super) entry: Option<DVec2>,
    /// The movements along contours, with the tool call: the line of each and where the tool went down before it.
    pub(super) gone: HashMap<(u32, Ends), (usize, Option<DVec2>)>,
    /// The heights at which contours are gone along, hundredths of a millimetre: line, tool call.
    pub(super) heights: BTreeSet<(usize, usize, i64)>,
    /// The last level movements, one after the other, and the places that may be left between lines to and fro: line, place,
    /// step and width of the tool.
    pub(super) lines: Vec<[DVec3; 2]>,
    pub(super) ribs: Vec<(usize, DVec3, [f64; 2])>,
    /// So many of the last ones others have made before, of which the first line is this.
    pub(super) again: (usize, usize),
}
