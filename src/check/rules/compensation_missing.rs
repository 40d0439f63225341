//! A contour that one tool machines with RL or RR, and that is gone along at the same points with R0 elsewhere: the middle of
//! the tool is on the contour there, which becomes smaller by its radius.
//!
//! Only straight lines and arcs with coordinates as written; tools that break edges or engrave are left out. Said once a program.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::contours::written;
use crate::check::program::is_silent;
use crate::check::tools::kind_of_call;
use crate::check::{Facts, Loaded, Rule, ToolKind};
use crate::program::syntax::{BlockKind, Compensates, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "compensation-missing", severity: Severity::Warning, run };

/// Longer programs are written by posts.
const MOST: usize = 3_000;
/// A contour has so many elements.
const LEAST: usize = 4;

/// Elements of one way, as their coordinates are written, with the place where it begins.
struct Course {
    place: Span,
    block: usize,
    beside: bool,
    elements: Vec<String>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.program.blocks().len() > MOST || facts.shaped().next().is_none() {
        return;
    }
    let courses = courses(facts);
    // All stretches of contours that are long enough.
    let contours = courses.iter().filter(|own| own.beside);
    let known: BTreeSet<&[String]> = contours.flat_map(|own| own.elements.windows(LEAST)).collect();
    let wrong = courses.iter().filter(|own| !own.beside && !breaks_edges(facts, own.block));
    let mut wrong = wrong.filter(|own| own.elements.windows(LEAST).any(|part| known.contains(part)));
    if let Some(own) = wrong.next() {
        found.push(rule.at(facts, own.place));
    }
}

/// Whether the tool at a block is there for edges or lines.
fn breaks_edges(facts: &Facts<'_>, block: usize) -> bool {
    let Some(Loaded::By(call)) = facts.run.before(block).map(|modal| modal.loaded) else { return true };
    matches!(
        kind_of_call(facts, call as usize),
        Some(ToolKind::Chamfer | ToolKind::Spot | ToolKind::Engraver | ToolKind::Ball)
    )
}

/// The ways in the plane at feed, with and without radius compensation.
fn courses(facts: &Facts<'_>) -> Vec<Course> {
    let mut found = Vec::new();
    let mut current: Option<Course> = None;
    let mut beside = false;
    for (index, block) in facts.program.blocks().iter().enumerate() {
        let motion = match &block.kind {
            _ if is_silent(block) || block.is_blend() => continue,
            BlockKind::Motion(motion) => motion,
            _ => {
                found.extend(current.take());
                continue;
            }
        };
        if matches!(motion.path(), Path::Rnd | Path::Chf | Path::Cc) {
            continue;
        }
        let side = match motion.outline().compensates() {
            Compensates::Beside => true,
            Compensates::Off => false,
            Compensates::Unsaid | Compensates::Along => beside,
        };
        let words = motion.words();
        if side != beside || motion.outline().is_rapid() || !is_flat(&words) {
            found.extend(current.take());
        }
        beside = side;
        if motion.outline().is_rapid() || !is_flat(&words) {
            continue;
        }
        let place = facts.content(block);
        let course = current.get_or_insert_with(|| Course { place, block: index, beside, elements: Vec::new() });
        course.elements.push(written(facts, &words));
    }
    found.extend(current);
    found
}

/// Whether a movement names places in the plane alone, by numbers that are not incremental.
fn is_flat(words: &Motion) -> bool {
    use crate::program::syntax::Axis::{X, Y};
    let flat = words.coords.iter().all(|own| matches!(own.axis, X | Y) && !own.incremental);
    flat && !words.coords.is_empty()
}
