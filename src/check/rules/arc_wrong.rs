//! An arc whose end does not lie on it: farther from the centre than its start, or farther from its start than its
//! radius allows; a full circle that is given by its radius; an angle whose sign contradicts DR.
//!
//! Of ends it is only reported where start, end and centre are written as numbers, one after the other, in the plane of
//! X and Y. Controls allow for rounding, each as its machine is set; what is reported here is more than any of that.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Approach, Axis, Block, BlockKind, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "arc-wrong", severity: Severity::Error, run };

/// What an arc may be off, mm.
const TOLERANCE: f64 = 0.05;
const MM_PER_INCH: f64 = 25.4;

type Point = [Option<f64>; 2];

/// Where the program is, as far as its numbers say.
#[derive(Default)]
struct Way {
    at: Point,
    centre: Point,
    /// Whether X and Y are the plane.
    plane: bool,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let tolerance = if facts.inch { TOLERANCE / MM_PER_INCH } else { TOLERANCE };
    if !facts.turns {
        return;
    }
    let mut way = Way::default();
    let mut words = Motion::new(Path::L);
    for block in facts.program.blocks() {
        let wrong = way.follow(block, &mut words, tolerance);
        if let Some((what, first, second)) = wrong {
            let finding = rule.at(facts, facts.content(block)).arg("what", what);
            let finding = finding.arg("first", rounded(first)).arg("second", rounded(second));
            // Posts write such angles for years: some control takes them.
            let severity = if what == "sense" { Severity::Warning } else { finding.severity };
            found.push(Diagnostic { severity, ..finding });
        }
    }
}

fn rounded(value: f64) -> Arg {
    Arg::Number(libm::round(value * 1e4) / 1e4)
}

impl Way {
    /// Follows a block: what is wrong with its arc.
    fn follow(&mut self, block: &Block, words: &mut Motion, tolerance: f64) -> Option<(&'static str, f64, f64)> {
        if block.skip {
            self.forget();
            return None;
        }
        match &block.kind {
            BlockKind::Motion(motion) => {
                motion.read_into(words);
                self.motion(words, tolerance)
            }
            BlockKind::ToolCall(call) => {
                if call.tool.is_some() || call.axis.is_some() {
                    self.plane = call.axis == Some(Axis::Z);
                }
                None
            }
            BlockKind::Empty
            | BlockKind::Comment
            | BlockKind::Structure(_)
            | BlockKind::Functions(_)
            | BlockKind::BeginPgm(_)
            | BlockKind::BlkForm(_)
            | BlockKind::FnAssign(_)
            | BlockKind::Formula(_) => None,
            _ if block.is_blend() => None,
            _ => {
                self.forget();
                None
            }
        }
    }

    fn forget(&mut self) {
        (self.at, self.centre) = (Point::default(), Point::default());
    }

    fn motion(&mut self, motion: &Motion, tolerance: f64) -> Option<(&'static str, f64, f64)> {
        // What moves in other coordinates, or moves the coordinates.
        if motion.functions.iter().any(|function| !matches!(function.number, 0..=9 | 13 | 14 | 30)) {
            self.forget();
            return None;
        }
        let others = motion.coords.iter().any(|coord| !matches!(coord.axis, Axis::X | Axis::Y));
        let flat = !others && self.plane;
        let end = self.end(motion);
        match motion.path {
            // The coordinates of an approach are those of the first point of the contour.
            Path::L | Path::Ct | Path::Appr(Approach::Lt | Approach::Ln | Approach::Ct | Approach::Lct) => {
                self.at = end
            }
            Path::Cc if motion.coords.is_empty() => self.centre = self.at,
            // Of a centre with one coordinate the manuals do not say where the other comes from.
            Path::Cc => {
                // One in another plane is no centre of arcs in this one.
                let written = |axis: Axis| !others && motion.coord(axis).is_some();
                self.centre = [end[0].filter(|_| written(Axis::X)), end[1].filter(|_| written(Axis::Y))];
            }
            Path::Rnd | Path::Chf => {}
            Path::C => {
                let (start, centre) = (self.at, self.centre);
                self.at = end;
                let (first, second) = (distance(start, centre)?, distance(end, centre)?);
                if flat && ((first - second).abs() > tolerance || (first == 0.0 && second == 0.0)) {
                    return Some(("centre", first, second));
                }
            }
            Path::Cr => {
                let start = self.at;
                self.at = end;
                let radius = match motion.radius?.amount {
                    Amount::Number(radius) => radius.abs(),
                    Amount::Q { .. } | Amount::Text(_) => return None,
                };
                let apart = distance(start, end)?;
                if flat && apart > 2.0 * radius + tolerance {
                    return Some(("radius", radius, apart));
                }
                // Any circle through the point has that radius.
                if flat && apart == 0.0 {
                    return Some(("full", radius, apart));
                }
            }
            Path::Cp => {
                self.forget();
                let angle = motion.coord(Axis::Pa).filter(|angle| angle.incremental)?;
                let (Amount::Number(angle), Some(counter)) = (angle.value.amount, motion.counter_clockwise) else {
                    return None;
                };
                if angle != 0.0 && (angle > 0.0) != counter {
                    return Some(("sense", angle, 0.0));
                }
            }
            _ => self.forget(),
        }
        None
    }

    /// Where a motion leads; a coordinate that is not written stays.
    fn end(&self, motion: &Motion) -> Point {
        let mut end = self.at;
        for coord in &motion.coords {
            let index = match coord.axis {
                Axis::X => 0,
                Axis::Y => 1,
                _ => continue,
            };
            end[index] = match coord.value.amount {
                Amount::Number(number) if coord.incremental => self.at[index].map(|from| from + number),
                Amount::Number(number) => Some(number),
                Amount::Q { .. } | Amount::Text(_) => None,
            };
        }
        end
    }
}

fn distance(one: Point, other: Point) -> Option<f64> {
    Some(libm::hypot(one[0]? - other[0]?, one[1]? - other[1]?))
}
