//! An approach without radius compensation, or a departure while none is active.
//!
//! Without RL or RR the tool centre runs on the contour. Where a program approaches with R0, its departures are left
//! alone, but for one after another departure in the text: that one has left the contour. Only reported where
//! compensation is certainly off. An approach perpendicular to the contour or on an arc of a given angle needs a side:
//! an error.
//!
//! Also a closed contour with roundings or chamfers that the tool goes round below the top of the blank, coming from outside and
//! leaving to there, without compensation, where R0 behind it switches off what was never switched on.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::blank::Blank;
use crate::check::contours::{Line, closed, holds};
use crate::check::program::is_silent;
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{Amount, Approach, Axis, BlockKind, Compensation, IsoKind, Path};

/// The code of DIN/ISO for a tangential approach.
const APPROACH: u16 = 26;

pub(super) const RULE: Rule = Rule { code: "approach-without-compensation", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if let Some(place) = uncompensated(facts) {
        found.push(rule.at(facts, place).arg("what", "contour"));
    }
    // Whether the contour is one that is meant for the tool centre.
    let mut centre = false;
    // Whether the contour has been left, and nothing but rapid movements come after.
    let mut left = false;
    for (from, to, modal) in facts.run.stretches() {
        let off = modal.is_some_and(|modal| modal.is(Aspect::Compensation) == Tri::No);
        for block in facts.program.blocks().get(from..to).unwrap_or_default() {
            if let BlockKind::Iso(own) = &block.kind
                && let IsoKind::Blend(code) = own.kind
                && off
            {
                let what = if code == APPROACH { "approach" } else { "departure" };
                found.push(rule.at(facts, block.comment().unwrap_or(block.span)).arg("what", what));
            }
            let BlockKind::Motion(motion) = &block.kind else {
                left &= matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_));
                continue;
            };
            if !matches!(motion.path(), Path::Dep(_)) {
                left &= !block.skip && motion.path() == Path::L && motion.outline().is_rapid();
            }
            let (what, wrong) = match motion.path() {
                Path::Appr(_) => {
                    let written = motion.compensation;
                    centre |= off && !matches!(written, Some(Compensation::Rl | Compensation::Rr));
                    let without = !matches!(written, Some(Compensation::Rl | Compensation::Rr));
                    ("approach", written == Some(Compensation::R0) || (off && without))
                }
                Path::Dep(_) => {
                    let again = std::mem::replace(&mut left, !block.skip);
                    ("departure", off && (!centre || again))
                }
                _ => continue,
            };
            if wrong {
                let sided = |form| matches!(form, Approach::Ln | Approach::Ct | Approach::Pln | Approach::Pct);
                let refused = matches!(motion.path(), Path::Appr(form) if sided(form));
                let severity = if refused { Severity::Error } else { rule.severity };
                let finding = rule.at(facts, facts.content(block)).arg("what", what);
                found.push(Diagnostic { severity, ..finding });
            }
        }
    }
}

/// A contour under way without compensation.
#[derive(Default)]
struct Course {
    line: Line,
    /// Where the tool was before it.
    start: Option<[f64; 2]>,
    /// Its first movement.
    place: Option<Span>,
    /// Whether corners are rounded or broken, and whether R0 was written within.
    shaped: bool,
    height: Option<f64>,
}

impl Course {
    fn begin(&mut self) {
        self.line.begin();
        (self.start, self.place, self.shaped) = (self.line.end(), None, false);
    }
}

/// The first closed contour without compensation that ends with R0 like one that has it.
fn uncompensated(facts: &Facts<'_>) -> Option<Span> {
    // Without corners there is nothing to be found.
    let blank = Blank::of(facts.program).filter(|_| facts.shaped().next().is_some())?;
    let mut course = Course::default();
    let mut stretches = facts.run.stretches().peekable();
    let mut off = false;
    for (index, block) in facts.program.blocks().iter().enumerate() {
        while let Some((_, _, modal)) = stretches.next_if(|(from, _, _)| *from <= index) {
            let is = |aspect| modal.is_some_and(|modal| modal.is(aspect) == Tri::No);
            off = is(Aspect::Compensation) && is(Aspect::OtherAxis) && is(Aspect::Turning);
        }
        let motion = match &block.kind {
            _ if is_silent(block) || block.is_blend() => continue,
            BlockKind::Motion(motion) if off && !block.skip => motion,
            _ => {
                course = Course::default();
                continue;
            }
        };
        let words = motion.words();
        let beside = matches!(words.compensation, Some(Compensation::Rl | Compensation::Rr));
        if beside || words.functions.iter().any(|own| matches!(own.number, 91 | 92)) {
            course = Course::default();
            continue;
        }
        if matches!(words.path, Path::Rnd | Path::Chf) {
            course.shaped |= course.place.is_some();
            continue;
        }
        let flat = words.coords.iter().all(|own| matches!(own.axis, Axis::X | Axis::Y | Axis::Pr | Axis::Pa));
        let leaves = words.compensation == Some(Compensation::R0) && flat && !words.coords.is_empty();
        let before = std::mem::take(&mut course.line.points);
        let from = (course.start, course.place, course.shaped, course.height);
        if course.line.go_on(&words, [Axis::X, Axis::Y]).is_none() {
            course = Course::default();
            continue;
        }
        if words.path == Path::Cc {
            course.line.points = before;
            continue;
        }
        if let (true, (Some(start), Some(place), true, Some(height)), Some(end)) = (leaves, from, course.line.end())
            && height < blank.high[2]
            && let Some(ring) = closed(&before)
            && !holds(&ring, start)
            && !holds(&ring, end)
            && !blank.holds(end[0], end[1])
        {
            return Some(place);
        }
        let new = std::mem::take(&mut course.line.points);
        course.line.points = before;
        course.line.points.extend(new);
        if let Some(own) = words.coord(Axis::Z) {
            course.height = match own.value.amount {
                Amount::Number(number) if !own.incremental => Some(number),
                _ => None,
            };
        }
        if !flat
            || words.compensation.is_some()
            || motion.outline().is_rapid()
            || matches!(words.path, Path::Appr(_) | Path::Dep(_))
        {
            course.begin();
        } else if course.place.is_none() {
            course.place = Some(facts.content(block));
        }
    }
    None
}
