//! A contour with radius compensation that comes back to a corner which it has already, other than the one where it began: a
//! sign or a coordinate of the corner is wrong. Also one that goes back along the line on which it has come: a corner between
//! is missing.
//!
//! Of corners only straight lines and arcs whose ends are known, in programs with a box as their blank. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::contours::{Contour, NEAR, compensated};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "contour-returns", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::CornerPassedTwice(place) => Some(place),
        _ => None,
    });
    let finding = |span: Span, what: &'static str, [x, y]: [f64; 2]| {
        let round = |own: f64| Arg::Number((own * 1000.0).round() / 1000.0);
        rule.at(facts, span).arg("what", what).arg("value", round(x)).arg("other", round(y))
    };
    let corner = first.map(|(span, place)| finding(span, "corner", place));
    let back = || compensated(facts).iter().find_map(goes_back).map(|(span, place)| finding(span, "back", place));
    found.extend(corner.or_else(back));
}

/// Where a contour turns back along the line on which it has come, with the block that does.
fn goes_back(contour: &Contour) -> Option<(Span, [f64; 2])> {
    let way = |one: [f64; 2], other: [f64; 2]| [other[0] - one[0], other[1] - one[1]];
    contour.windows(3).find_map(|three| {
        let [(before, _), (corner, _), (after, place)] = three else { return None };
        let (one, other) = (way(*before, *corner), way(*corner, *after));
        let (along, across) = (one[0] * other[0] + one[1] * other[1], one[0] * other[1] - one[1] * other[0]);
        (along < -NEAR && across.abs() <= NEAR * NEAR * along.abs()).then_some((*place, *corner))
    })
}
