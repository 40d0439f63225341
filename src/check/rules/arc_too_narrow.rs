//! An arc or a rounding on the inside of a contour whose radius is smaller than that of the tool: the tool does not
//! come into it, and the control refuses the block.
//!
//! The radius of the tool is that of TOOL DEF or of the tool table, where it is named. Only corners and arcs are looked
//! at whose points are written as numbers. Of contours that cycles read, the narrowest tool that mills their walls decides.
//! Rectangular pockets that are finished are looked at, too: 0 is the radius of the tool.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::contours::{led, listed};
use crate::check::cycle::removes_material;
use crate::check::program::{number, with_meaning};
use crate::check::tools::Tools;
use crate::check::{Aspect, Defined, Facts, Pending, Rule, Tri};
use crate::program::syntax::{Amount, BlockKind, Compensation, Path};

pub(super) const RULE: Rule = Rule { code: "arc-too-narrow", severity: Severity::Warning, run };

/// By how much the tool must be wider, mm or inch: coordinates are rounded.
const TOLERANCE: f64 = 1e-3;

/// Where a contour has come to.
#[derive(Default)]
struct Course {
    /// +1 where the tool goes on the left of the contour, -1 on the right.
    side: f64,
    /// The last two points.
    from: Option<[f64; 2]>,
    at: Option<[f64; 2]>,
    /// The centre of arcs.
    centre: Option<[f64; 2]>,
    /// The last rounding with the point where it is, of which the line after it decides.
    corner: Option<(usize, f64)>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(tools) = Tools::of(facts) else { return };
    listed_contours(rule, facts, &tools, found);
    pockets(rule, facts, &tools, found);
    let blocks = facts.program.blocks();
    for (from, to, modal) in facts.run.stretches() {
        let Some(modal) = modal.filter(|modal| modal.is(Aspect::OtherAxis) == Tri::No) else { continue };
        let Some(tool) = tools.get(modal.loaded) else { continue };
        // The stretch may begin within a contour: what led to it is read again.
        let begin = (0..from).rev().take(BACK).take_while(|at| matches!(blocks[*at].kind, BlockKind::Motion(_))).last();
        let mut course = Course::default();
        for at in begin.unwrap_or(from)..to {
            let Some((place, radius)) = course.go_on(at, &blocks[at].kind) else { continue };
            if at >= from && radius < tool.radius - TOLERANCE {
                let finding = rule.at(facts, facts.content(&blocks[place])).arg("radius", Arg::Number(radius));
                found.push(finding.arg("tool", Arg::Number(tool.radius)));
            }
        }
    }
}

/// The meanings of what cycles have that mill the wall of a contour.
const WALLS: [&str; 2] = ["remaining-side-allowance", "coarse-roughing-tool"];

/// The meanings of the allowance of a contour train, and of what only cycles on a cylinder have.
const TRAIN: &str = "side-allowance";
const CYLINDER: &str = "cylinder-radius";

/// Contours that cycles read: the narrowest tool that mills their walls says what fits.
fn listed_contours(rule: &Rule, facts: &Facts<'_>, tools: &Tools, found: &mut Vec<Diagnostic>) {
    let mut seen = std::collections::HashSet::new();
    for list in listed(facts) {
        let mills = |own: &&Defined<'_>| {
            own.related_cycle().is_some_and(|cycle| {
                let has = |meaning: &str| with_meaning(cycle, meaning).is_some();
                WALLS.into_iter().any(has) || has(TRAIN) && removes_material(cycle) && !has(CYLINDER)
            })
        };
        let mut narrowest: Option<f64> = None;
        let mut open = false;
        for reader in list.readers.iter().copied().filter(|own| mills(own)) {
            for call in &facts.run.calls {
                let Pending::Definition(index) = call.modal.pending else { continue };
                let same = facts.definitions.get(index as usize).is_some_and(|own| own.view.first == reader.view.first);
                if same {
                    let radius = tools.get(call.modal.loaded).map(|tool| tool.radius);
                    open |= radius.is_none();
                    narrowest = radius.map(|own| narrowest.map_or(own, |other| other.min(own))).or(narrowest);
                }
            }
        }
        let Some(tool) = narrowest.filter(|_| !open) else { continue };
        for contour in &list.contours {
            let mut course = Course::default();
            for (at, block) in contour.iter().enumerate() {
                let Some((place, radius)) = course.go_on(at, &block.kind) else { continue };
                if radius < tool - TOLERANCE && seen.insert(contour[place].span.start) {
                    let finding = rule.at(facts, facts.content(&contour[place])).arg("radius", Arg::Number(radius));
                    found.push(finding.arg("tool", Arg::Number(tool)));
                }
            }
        }
    }
}

/// Rectangular pockets that are finished: the control makes their corners as round as the tool.
fn pockets(rule: &Rule, facts: &Facts<'_>, tools: &Tools, found: &mut Vec<Diagnostic>) {
    let mut seen = std::collections::HashSet::new();
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(own) = facts.definitions.get(index as usize) else { continue };
        let Some(tool) = tools.get(call.modal.loaded) else { continue };
        let has = |meaning: &str| own.related_cycle().is_some_and(|cycle| with_meaning(cycle, meaning).is_some());
        if !has("corner-radius") || !has("pocket-position") || !seen.insert(index) {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        // Roughing may be done with a larger tool.
        let roughs = read.item("machining-operation").and_then(number) == Some(1.0);
        let Some((item, radius)) = read.item("corner-radius").and_then(|item| Some((item, number(item)?))) else {
            continue;
        };
        // 0 is the radius of the tool.
        if !roughs && radius > 0.0 && radius < tool.radius - TOLERANCE {
            let finding = rule.at(facts, item.value_span).arg("radius", Arg::Number(radius));
            found.push(finding.arg("tool", Arg::Number(tool.radius)));
        }
    }
}

/// So many movements are read before a stretch.
const BACK: usize = 16;

impl Course {
    /// Follows a block; the block and radius of what turns to the side of the tool.
    fn go_on(&mut self, at: usize, block: &BlockKind) -> Option<(usize, f64)> {
        let motion = match block {
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) => return None,
            BlockKind::Motion(motion) => motion.words(),
            _ => {
                *self = Self::default();
                return None;
            }
        };
        match motion.compensation {
            Some(Compensation::Rl) => self.side = 1.0,
            Some(Compensation::Rr) => self.side = -1.0,
            Some(_) => self.side = 0.0,
            None => {}
        }
        let path = motion.path;
        if path == Path::Cc {
            self.centre = led(self.at, &motion);
            return None;
        }
        let size = motion.radius.and_then(|radius| match radius.amount {
            Amount::Number(number) => Some(number.abs()),
            Amount::Q { .. } | Amount::Text(_) => None,
        });
        if path == Path::Rnd {
            self.corner = size.map(|size| (at, size));
            return None;
        }
        let (before, start) = (self.from, self.at);
        let end = match path {
            Path::L | Path::C | Path::Cr | Path::Ct => led(start, &motion),
            _ => None,
        };
        let corner = self.corner.take();
        if start != end || end.is_none() {
            (self.from, self.at) = (start, end);
        }
        let turn = match (path, motion.counter_clockwise) {
            (Path::C | Path::Cr, Some(left)) => Some(if left { 1.0 } else { -1.0 }),
            _ => None,
        };
        if turn.is_some_and(|turn| turn * self.side > 0.0) {
            let radius = match path {
                Path::Cr => size,
                _ => self.centre.zip(end).map(|(centre, end)| libm::hypot(end[0] - centre[0], end[1] - centre[1])),
            };
            return radius.map(|radius| (at, radius));
        }
        let (place, radius) = corner.filter(|_| path == Path::L)?;
        let (first, corner, last) = (before?, start?, end?);
        let one = [corner[0] - first[0], corner[1] - first[1]];
        let two = [last[0] - corner[0], last[1] - corner[1]];
        let turn = one[0] * two[1] - one[1] * two[0];
        (turn * self.side > TOLERANCE).then_some((place, radius))
    }
}
