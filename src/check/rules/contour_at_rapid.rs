//! A contour with radius compensation along which the tool moves at rapid: all of it, or an element in the middle.
//!
//! An approach and a departure at rapid are usual, so a contour must have three such movements and no other, or one
//! between two at feed without a movement of the tool axis. Said once a program.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Axis, BlockKind, Compensates, Path};

pub(super) const RULE: Rule = Rule { code: "contour-at-rapid", severity: Severity::Warning, run };

/// A contour without a feed has so many movements.
const LEAST: usize = 3;

/// What is known of the contour so far.
#[derive(Default)]
struct Contour {
    /// Its movements at rapid, as long as none is at feed.
    rapid: Vec<Span>,
    /// Whether one at feed was there.
    fed: bool,
    /// Whether the tool was moved along its axis at rapid since.
    lifted: bool,
    /// The movement at rapid after one at feed.
    middle: Option<Span>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut contour: Option<Contour> = None;
    for block in facts.program.blocks() {
        let BlockKind::Motion(motion) = &block.kind else {
            if !is_silent(block) {
                contour = None;
            }
            continue;
        };
        let outline = motion.outline();
        let begins = match outline.compensates() {
            Compensates::Beside => true,
            Compensates::Unsaid => false,
            Compensates::Off | Compensates::Along => {
                if let Some(span) = contour.take().and_then(|own| whole(&own)) {
                    return found.push(rule.at(facts, span));
                }
                continue;
            }
        };
        if contour.is_none() && !begins {
            continue;
        }
        let contour = contour.get_or_insert_default();
        match motion.path() {
            Path::L | Path::Lp | Path::C | Path::Cr | Path::Ct | Path::Cp | Path::Ctp => {}
            Path::Cc | Path::Rnd | Path::Chf => continue,
            _ => {
                *contour = Contour { fed: true, ..Contour::default() };
                continue;
            }
        }
        if !outline.has_coords() {
            continue;
        }
        if !outline.is_rapid() {
            if let Some(span) = contour.middle {
                return found.push(rule.at(facts, span));
            }
            *contour = Contour { fed: true, ..Contour::default() };
            continue;
        }
        let along = motion.words().coords.iter().any(|own| own.axis == Axis::Z);
        let span = facts.content(block);
        if along {
            *contour = Contour { fed: contour.fed, lifted: true, ..Contour::default() };
        } else if contour.fed && !contour.lifted {
            contour.middle = contour.middle.or(Some(span));
        } else if !contour.fed {
            contour.rapid.push(span);
        }
    }
}

/// The first movement of a contour that is rapid from beginning to end.
fn whole(contour: &Contour) -> Option<Span> {
    let first = contour.rapid.first().filter(|_| !contour.fed && contour.rapid.len() >= LEAST);
    first.copied()
}
