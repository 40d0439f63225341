//! A contour with RL or RR whose coordinates are all incremental and do not lead back to its beginning, while the same numbers
//! as absolute ones do: G91 was left on, or the I of the axes is wrong.
//!
//! Only contours all of whose coordinates are numbers.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::contours::{Line, closed};
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Axis, BlockKind, Compensation, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "incremental-left-on", severity: Severity::Warning, run };

const PLANE: [Axis; 2] = [Axis::X, Axis::Y];
/// A closed contour has so many elements with coordinates.
const LEAST: usize = 4;

/// A contour under way, as it is written and with absolute coordinates.
struct Course {
    written: Line,
    absolute: Line,
    elements: usize,
    place: Span,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.shaped().next().is_none() {
        return;
    }
    let mut course: Option<Course> = None;
    for block in facts.program.blocks() {
        let motion = match &block.kind {
            _ if is_silent(block) || block.is_blend() => continue,
            BlockKind::Motion(motion) if !block.skip => motion,
            _ => {
                course = None;
                continue;
            }
        };
        let words = motion.words();
        if words.compensation == Some(Compensation::R0) || matches!(words.path, Path::Dep(_)) {
            if let Some(own) = course.take().filter(is_meant_absolute) {
                return found.push(rule.at(facts, own.place));
            }
            continue;
        }
        let begins = matches!(words.compensation, Some(Compensation::Rl | Compensation::Rr));
        if begins && course.is_none() {
            // Where it begins does not matter: the increments add up all the same.
            let mut written = Line::default();
            let origin = |axis| words.coord(axis).is_some();
            if origin(Axis::X) && origin(Axis::Y) && matches!(words.path, Path::L) {
                let _ = written.go_on(&at_zero(), PLANE);
                written.begin();
                course = Some(Course { written, absolute: Line::default(), elements: 0, place: facts.content(block) });
            }
        }
        if let Some(own) = &mut course
            && own.follow(&words).is_none()
        {
            course = None;
        }
    }
}

/// A movement to the origin.
fn at_zero() -> Motion {
    use crate::program::syntax::{Amount, Coord, Operand};
    let zero = |axis| {
        let value = Operand { span: Span::new(0, 0), amount: Amount::Number(0.0) };
        Coord { span: Span::new(0, 0), axis, incremental: false, value }
    };
    Motion { coords: vec![zero(Axis::X), zero(Axis::Y)], ..Motion::new(Path::L) }
}

impl Course {
    /// Follows an element; nothing if it does not belong to such a contour.
    fn follow(&mut self, words: &Motion) -> Option<()> {
        let mut absolute = words.clone();
        for coord in &mut absolute.coords {
            let flat = matches!(coord.axis, Axis::X | Axis::Y);
            if !flat || !std::mem::replace(&mut coord.incremental, false) {
                return None;
            }
        }
        self.elements += usize::from(!words.coords.is_empty() && words.path != Path::Cc);
        // An arc that fits one way does not fit the other way: only lines count as written.
        let written = if words.path == Path::Cc { words.clone() } else { Motion { path: Path::L, ..words.clone() } };
        if !matches!(words.path, Path::Rnd | Path::Chf) {
            self.written.go_on(&written, PLANE)?;
        }
        self.absolute.go_on(&absolute, PLANE)
    }
}

/// Whether a contour comes back to its beginning only if its coordinates are absolute.
fn is_meant_absolute(own: &Course) -> bool {
    own.elements >= LEAST && closed(&own.absolute.points).is_some() && closed(&own.written.points).is_none()
}
