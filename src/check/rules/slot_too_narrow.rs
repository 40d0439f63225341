//! Three lines of a contour between which the tool would have to turn in less room than it needs: a slot that is narrower
//! than the tool, which the control refuses or leaves damaged.
//!
//! The radius of the tool is that of TOOL DEF or of the tool table, where it is named. Only lines are looked at whose points
//! are written as numbers, and nothing where M97 or M120 lets the control leave such elements out.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::contours::led;
use crate::check::program::each_function;
use crate::check::tools::Tools;
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{BlockKind, Compensation, Path};

pub(super) const RULE: Rule = Rule { code: "slot-too-narrow", severity: Severity::Warning, run };

/// By how much the tool must be wider, mm or inch: coordinates are rounded.
const TOLERANCE: f64 = 1e-3;
/// So many movements are read before a stretch.
const BACK: usize = 16;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(tools) = Tools::of(facts) else { return };
    let mut looks_ahead = false;
    for (_, block) in facts.marked() {
        each_function(block, |number| looks_ahead |= matches!(number, 97 | 120));
    }
    if looks_ahead {
        return;
    }
    let blocks = facts.program.blocks();
    for (from, to, modal) in facts.run.stretches() {
        let Some(modal) = modal.filter(|modal| modal.is(Aspect::OtherAxis) == Tri::No) else { continue };
        let Some(tool) = tools.get(modal.loaded) else { continue };
        let begin = (0..from).rev().take(BACK).take_while(|at| matches!(blocks[*at].kind, BlockKind::Motion(_))).last();
        let mut course = Course::default();
        for at in begin.unwrap_or(from)..to {
            let Some((place, length)) = course.go_on(at, &blocks[at].kind, tool.radius) else { continue };
            if at >= from {
                let finding = rule.at(facts, facts.content(&blocks[place])).arg("value", Arg::Number(length));
                found.push(finding.arg("tool", Arg::Number(2.0 * tool.radius)));
            }
        }
    }
}

/// Where a contour has come to.
#[derive(Default)]
struct Course {
    /// +1 where the tool goes on the left of the contour, -1 on the right.
    side: f64,
    /// The last points, the newest last.
    points: Vec<[f64; 2]>,
    /// The block of the last line.
    line: usize,
}

impl Course {
    /// Follows a block; the block and length of a line that is too short between two corners inside.
    fn go_on(&mut self, at: usize, block: &BlockKind, radius: f64) -> Option<(usize, f64)> {
        let motion = match block {
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) => return None,
            BlockKind::Motion(motion) => motion.words(),
            _ => {
                *self = Self::default();
                return None;
            }
        };
        let before = self.side;
        match motion.compensation {
            Some(Compensation::Rl) => self.side = 1.0,
            Some(Compensation::Rr) => self.side = -1.0,
            Some(_) => self.side = 0.0,
            None => {}
        }
        let end = led(self.points.last().copied(), &motion);
        let (Path::L, Some(end)) = (motion.path, end) else {
            self.points.clear();
            return None;
        };
        if self.points.last() == Some(&end) {
            return None;
        }
        // The contour begins at the end of the line that leads to it.
        if before == 0.0 {
            self.points.clear();
        }
        self.points.push(end);
        if self.points.len() > 4 {
            self.points.remove(0);
        }
        let line = std::mem::replace(&mut self.line, at);
        if before == 0.0 || self.side != before {
            return None;
        }
        let [a, b, c, d] = self.points.as_slice() else { return None };
        let (one, other) = (corner(*a, *b, *c)? * self.side, corner(*b, *c, *d)? * self.side);
        let length = libm::hypot(c[0] - b[0], c[1] - b[1]);
        let needs = radius * (libm::tan(one / 2.0) + libm::tan(other / 2.0));
        (one > TOLERANCE && other > TOLERANCE && length < needs - TOLERANCE).then_some((line, length))
    }
}

/// The angle in radians by which a contour turns to the left at a corner; nothing where it turns back.
fn corner(from: [f64; 2], at: [f64; 2], to: [f64; 2]) -> Option<f64> {
    let (one, two) = ([at[0] - from[0], at[1] - from[1]], [to[0] - at[0], to[1] - at[1]]);
    let angle = libm::atan2(one[0] * two[1] - one[1] * two[0], one[0] * two[0] + one[1] * two[1]);
    (angle.abs() < 3.1).then_some(angle)
}
