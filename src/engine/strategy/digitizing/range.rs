//! What digitizing keeps between the cycles and steps of a program: the range, the lines in it, and the blocks of the
//! file of digitized data.
//!
//! A position is that of the south pole of the stylus. Points of a range and of a record are given by axis; lines are in
//! the working plane. In a range with a rotary axis they are in its chart: the coordinate of the linear axis of the
//! plane, and the angle, in which a degree counts as 1 mm. Invariant: nothing moves here.
use glam::{DVec2, DVec3};

use crate::engine::geometry::{Axis, RotaryAxis, WorkingPlane};
use crate::engine::report::fault::Fault;

/// Places that are nearer to each other are one, mm.
pub(super) const SAME: f64 = 1e-9;
/// A line so near to the boundary of the range, mm, is looked for that far inside of it.
const INSIDE: f64 = 1e-9;
/// A remainder of the range beyond the last line that is smaller, mm, gets no line of its own.
const REMAINDER: f64 = 1e-6;
/// The file of data whose name has no letter or digit.
const NAMELESS: &str = "DATA";

/// The range that cycles digitize.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// The name of the file of digitized data.
    pub file: String,
    /// The touch probe axis.
    pub axis: DVec3,
    /// The least coordinates.
    pub least: DVec3,
    /// The greatest.
    pub greatest: DVec3,
    /// The boundary in the working plane, of a range from a point table.
    pub corners: Option<Vec<DVec3>>,
    /// The clearance height, in the touch probe axis.
    pub height: f64,
    /// The rotary axis of a range that has one.
    pub rotary: Option<RotaryRange>,
}

/// The rotary axis of a range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotaryRange {
    /// The axis.
    pub axis: RotaryAxis,
    /// The linear axis beside it in the working plane; the third linear axis stays where it is.
    pub line: Axis,
    /// The least angle, program coordinates, degrees.
    pub least: f64,
    /// The greatest.
    pub greatest: f64,
}

/// A block of the file, and where the rotary axis of the range is in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// The block.
    pub row: Row,
    /// The angle, program coordinates, degrees.
    pub angle: f64,
}

/// What a block of the file does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Row {
    /// Rapid traverse along the tool axis.
    Height(f64),
    /// Rapid traverse in the working plane.
    Over(DVec3),
    /// Along the tool axis at the feed of the program that calls this one.
    Down(f64),
    /// In the working plane at that feed.
    Back(DVec3),
    /// A digitized point.
    Point(DVec3),
}

/// What digitizing keeps.
#[derive(Clone, Debug, Default)]
pub struct Digitizing {
    /// The range of the last definition.
    pub range: Option<Range>,
    /// What was digitized by the cycle that is executed.
    pub rows: Vec<Block>,
    /// Where the rotary axis of the range is, program coordinates, degrees.
    pub(super) angle: f64,
    /// The lines of that cycle.
    pub(super) lines: Option<Lines>,
    /// Where sudden changes of direction were in the line before, main and minor coordinate.
    pub(super) corners: Vec<DVec2>,
    /// Whether the block form is enlarged, mm.
    pub(super) enlarged: f64,
    /// Where the stylus was when the cycle began: an axis that the range does not have stays there.
    pub(super) began: DVec3,
    /// From where the part was approached in the plane last.
    pub(super) first: DVec3,
    /// The distance to the next line.
    pub(super) next_step: f64,
}

/// Parallel lines over the range.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Lines {
    /// The direction of the first one, of length 1.
    pub along: DVec2,
    /// From one line to the next, of length 1.
    pub across: DVec2,
    /// The boundary of the range.
    pub corners: Vec<DVec2>,
    /// Where across the present line is, and the end of the range.
    pub now: f64,
    /// The end of the range.
    pub last: f64,
    /// How many lines were begun before this one.
    pub count: usize,
}

impl Range {
    /// The boundary in the working plane, or in the chart.
    pub(super) fn boundary(&self, plane: WorkingPlane) -> Vec<DVec2> {
        if let Some(corners) = &self.corners {
            return corners.iter().map(|corner| plane.flat(*corner)).collect();
        }
        let (a, b) = match self.rotary {
            None => (plane.flat(self.least), plane.flat(self.greatest)),
            Some(RotaryRange { line, least, greatest, .. }) => {
                (DVec2::new(line.of(self.least), least), DVec2::new(line.of(self.greatest), greatest))
            }
        };
        vec![a, DVec2::new(b.x, a.y), b, DVec2::new(a.x, b.y)]
    }

    /// The fault of a range that has no extent along an axis.
    pub(super) fn check(&self) -> Result<(), Fault> {
        let linear = Axis::ALL
            .into_iter()
            .filter(|axis| self.rotary.is_none_or(|rotary| *axis == rotary.line || axis.of(self.axis).abs() > SAME));
        let rotary = self.rotary.map(|rotary| (rotary.axis.letter(), rotary.least, rotary.greatest));
        let mut all = linear.map(|axis| (axis.letter(), axis.of(self.least), axis.of(self.greatest))).chain(rotary);
        let Some((letter, min, max)) = all.find(|(_, least, greatest)| greatest - least <= SAME) else { return Ok(()) };
        let fault = Fault::program("digitizing-range-wrong").arg("axis", letter.to_string());
        Err(fault.arg("min", min).arg("max", max))
    }
}

impl Lines {
    /// Lines along an axis of the plane, turned by an angle, from the MIN point on.
    pub(super) fn new(axis: DVec2, turned: DVec2, corners: Vec<DVec2>) -> Self {
        let along = turned.rotate(axis);
        // Lines along the minor axis are to the right of each other: the first one, too, begins at the MIN point.
        let across = if axis.x.abs() > axis.y.abs() { along.perp() } else { -along.perp() };
        let ways = || corners.iter().map(|corner| corner.dot(across));
        let (first, last) = (ways().fold(f64::INFINITY, f64::min), ways().fold(f64::NEG_INFINITY, f64::max));
        Self { along, across, corners, now: first, last, count: 0 }
    }

    /// The stretches of the present line within the range, in its direction.
    pub(super) fn stretches(&self) -> Vec<(DVec2, DVec2)> {
        let (low, high) = (self.now.min(self.last - INSIDE), self.last - INSIDE);
        let ways = self.corners.iter().map(|corner| corner.dot(self.across));
        let least = ways.fold(f64::INFINITY, f64::min) + INSIDE;
        let at = low.clamp(least.min(high), high);
        let mut crossed = Vec::new();
        for (a, b) in edges(&self.corners) {
            let (from, to) = (a.dot(self.across) - at, b.dot(self.across) - at);
            if (from < 0.0) != (to < 0.0) {
                crossed.push((a + (b - a) * (from / (from - to))).dot(self.along));
            }
        }
        crossed.sort_by(f64::total_cmp);
        let place = |way: f64| self.along * way + self.across * self.now;
        crossed.chunks_exact(2).map(|pair| (place(pair[0]), place(pair[1]))).collect()
    }

    /// Goes to the next line at a distance, the last of them at the end of the range; whether there is one.
    pub(super) fn go_on(&mut self, by: f64) -> bool {
        if self.last - self.now <= REMAINDER {
            return false;
        }
        self.now = (self.now + by).min(self.last);
        self.count += 1;
        true
    }

    /// Whether the straight way between two places leaves the range.
    pub(super) fn leaves(&self, from: DVec2, to: DVec2) -> bool {
        let side = |a: DVec2, b: DVec2, p: DVec2| (b - a).perp_dot(p - a);
        let apart = |a: f64, b: f64| a.min(b) < -REMAINDER && a.max(b) > REMAINDER;
        let crosses = |(a, b): (DVec2, DVec2)| {
            apart(side(a, b, from), side(a, b, to)) && apart(side(from, to, a), side(from, to, b))
        };
        edges(&self.corners).any(crosses) || !self.holds(from.midpoint(to))
    }

    /// Whether a place lies in the range, or on its boundary.
    fn holds(&self, place: DVec2) -> bool {
        let mut inside = false;
        for (a, b) in edges(&self.corners) {
            let foot = a + (b - a) * ((place - a).dot(b - a) / (b - a).length_squared().max(SAME)).clamp(0.0, 1.0);
            if foot.distance(place) <= REMAINDER {
                return true;
            }
            if (a.y > place.y) != (b.y > place.y) && place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y) {
                inside = !inside;
            }
        }
        inside
    }
}

/// The edges of a closed polygon.
fn edges(corners: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
    corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| (*a, *b))
}

impl Digitizing {
    /// Forgets what an earlier cycle has digitized.
    pub(super) fn begin(&mut self) {
        self.rows.clear();
        self.corners.clear();
        self.lines = None;
        self.enlarged = 0.0;
    }

    /// Adds a block, with the rotary axis of the range where it is.
    pub(super) fn push(&mut self, row: Row) {
        self.rows.push(Block { row, angle: self.angle });
    }

    /// The file of digitized data in a unit of so many mm: its name and its text.
    pub(in crate::engine) fn file(&self, range: &Range, plane: WorkingPlane, mm: f64) -> (String, String) {
        let name = name_of(&range.file);
        let unit = if mm == 1.0 { "MM" } else { "INCH" };
        let mut blocks = vec![format!("BEGIN PGM {name} {unit}")];
        let writer = Writer { decimals: if mm == 1.0 { 4 } else { 5 } };
        let columns: Vec<Column> = match range.rotary {
            None => Axis::ALL.map(Column::Linear).to_vec(),
            Some(rotary) => {
                vec![Column::Linear(rotary.line), Column::Rotary(rotary.axis), Column::Linear(plane.tool)]
            }
        };
        if range.rotary.is_none() {
            let more = DVec3::splat(self.enlarged);
            let form = |point: DVec3| Axis::ALL.map(|axis| writer.word(axis.letter(), axis.of(point) / mm)).join(" ");
            blocks.push(format!("BLK FORM 0.1 {} {}", plane.tool.letter(), form(range.least - more)));
            blocks.push(format!("BLK FORM 0.2 {}", form(range.greatest + more)));
        }
        let tool = Column::Linear(plane.tool);
        let mut before: Vec<Option<String>> = vec![None; columns.len()];
        for Block { row, angle } in &self.rows {
            let (along_tool, in_plane, point, rapid) = match *row {
                Row::Height(height) => (true, false, plane.lift(DVec2::ZERO, height), true),
                Row::Down(height) => (true, false, plane.lift(DVec2::ZERO, height), false),
                Row::Over(point) => (false, true, point, true),
                Row::Back(point) => (false, true, point, false),
                Row::Point(point) => (true, true, point, false),
            };
            let mut words = Vec::new();
            for (column, known) in columns.iter().zip(&mut before) {
                let written = if *column == tool { along_tool } else { in_plane };
                let word = || match column {
                    Column::Linear(axis) => writer.word(axis.letter(), axis.of(point) / mm),
                    Column::Rotary(axis) => writer.word(axis.letter(), *angle),
                };
                if let Some(word) = written.then(word).filter(|word| known.as_ref() != Some(word)) {
                    words.push(word.clone());
                    *known = Some(word);
                }
            }
            if !words.is_empty() {
                let feed = if rapid { " FMAX" } else { "" };
                blocks.push(format!("L {}{feed}", words.join(" ")));
            }
        }
        blocks.push(format!("END PGM {name} {unit}"));
        let lines = blocks.iter().enumerate().map(|(number, block)| format!("{number} {block}\n"));
        (format!("{name}.H"), lines.collect())
    }
}

/// An axis whose coordinates the file has.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Column {
    Linear(Axis),
    Rotary(RotaryAxis),
}

/// The name of a program, of a file name with or without its path and extension.
fn name_of(file: &str) -> String {
    let last = file.rsplit(['\\', '/', ':']).next().unwrap_or(file);
    let stem = last.rsplit_once('.').map_or(last, |(stem, _)| stem);
    let name: String = stem.chars().filter(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-')).collect();
    if name.is_empty() { NAMELESS.to_owned() } else { name }
}

/// How coordinates are written.
struct Writer {
    decimals: usize,
}

impl Writer {
    fn word(&self, letter: char, value: f64) -> String {
        let text = format!("{value:+.*}", self.decimals);
        let text = text.trim_end_matches('0').trim_end_matches('.');
        let text = if text == "-0" { "+0" } else { text };
        format!("{letter}{text}")
    }
}
