//! A closed contour that is written twice with the same points, once with RL and once with RR: the second time the tool
//! goes along its other side.
//!
//! Its elements may be those of a subprogram that is called after the approach.
//!
//! Only contours with coordinates and no parameters, at the same points in the same order. Said once a program.
use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::mem::discriminant;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Compensates, Compensation, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "compensation-other-side", severity: Severity::Warning, run };

/// A closed contour has so many elements.
const LEAST: usize = 4;

/// A contour that is being read.
struct Contour {
    side: Compensation,
    place: Span,
    /// Its elements, and how many they are.
    shape: DefaultHasher,
    count: usize,
    /// The coordinates of its first point and of its last one.
    first: Vec<(Axis, f64)>,
    last: Vec<(Axis, f64)>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut seen: HashMap<(u64, usize), Compensation> = HashMap::new();
    let mut contour: Option<Contour> = None;
    for (index, block) in facts.program.blocks().iter().enumerate() {
        let BlockKind::Motion(motion) = &block.kind else {
            if !is_silent(block) && !block.is_blend() {
                contour = contour.and_then(|own| through(facts, own, index, block));
            }
            continue;
        };
        let compensates = motion.outline().compensates();
        if contour.is_none() && compensates != Compensates::Beside {
            continue;
        }
        let words = motion.words();
        if compensates == Compensates::Off || matches!(words.path, Path::Dep(_)) {
            let Some(whole) = contour.take().filter(is_closed) else { continue };
            let before = *seen.entry((whole.shape.finish(), whole.count)).or_insert(whole.side);
            if before != whole.side {
                return found.push(rule.at(facts, whole.place));
            }
            continue;
        }
        let side = words.compensation.filter(|own| matches!(own, Compensation::Rl | Compensation::Rr));
        if let (None, Some(side)) = (&contour, side) {
            let (place, shape) = (facts.content(block), DefaultHasher::new());
            contour = Some(Contour { side, place, shape, count: 0, first: Vec::new(), last: Vec::new() });
        }
        contour = contour.filter(|own| side.is_none_or(|side| side == own.side)).and_then(|own| longer(own, &words));
    }
}

/// A contour that goes on in a subprogram; nothing if a block is not the call of one that only moves along it.
fn through(facts: &Facts<'_>, mut contour: Contour, index: usize, block: &Block) -> Option<Contour> {
    let BlockKind::CallLbl(call) = &block.kind else { return None };
    let label = facts.run.graph.called_from(index).filter(|_| call.repeat.is_none() && !block.skip)?;
    for own in facts.subprogram(label)?.iter().filter(|own| !is_silent(own) && !own.is_blend()) {
        let BlockKind::Motion(motion) = &own.kind else { return None };
        let words = motion.words();
        let plain = words.compensation.is_none() && !matches!(words.path, Path::Appr(_) | Path::Dep(_));
        contour = longer(contour, &words).filter(|_| plain && !own.skip)?;
    }
    Some(contour)
}

/// A contour with one more element; nothing if its shape is not certain.
fn longer(mut contour: Contour, words: &Motion) -> Option<Contour> {
    // The words of an approach say how long it is.
    if !words.words.is_empty() && !matches!(words.path, Path::Appr(_)) {
        return None;
    }
    discriminant(&words.path).hash(&mut contour.shape);
    words.counter_clockwise.hash(&mut contour.shape);
    contour.count += 1;
    contour.last.clear();
    for own in &words.coords {
        let Amount::Number(number) = own.value.amount else { return None };
        discriminant(&own.axis).hash(&mut contour.shape);
        own.incremental.hash(&mut contour.shape);
        (number + 0.0).to_bits().hash(&mut contour.shape);
        if !own.incremental {
            contour.last.push((own.axis, number));
        }
    }
    if let Some(radius) = words.radius {
        let Amount::Number(number) = radius.amount else { return None };
        number.to_bits().hash(&mut contour.shape);
    }
    if contour.count == 1 {
        contour.first.clone_from(&contour.last);
    }
    Some(contour)
}

/// Whether a contour ends where it begins.
fn is_closed(own: &Contour) -> bool {
    own.count >= LEAST && !own.last.is_empty() && own.last.iter().all(|place| own.first.contains(place))
}
