//! A PLANE that lacks an angle, component or coordinate of its form, or a word that says how the axes turn.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::{BlockKind, StatementKind};

pub(super) const RULE: Rule = Rule { code: "plane-incomplete", severity: Severity::Warning, run };

/// The forms of the function with the words of which none can be left out.
const FORMS: [(&str, &[&str]); 5] = [
    ("SPATIAL", &["SPA", "SPB", "SPC"]),
    ("PROJECTED", &["PROPR", "PROMIN"]),
    ("EULER", &["EULPR", "EULNU", "EULROT"]),
    ("VECTOR", &["BX", "BY", "BZ", "NX", "NY", "NZ"]),
    ("POINTS", &["P1X", "P1Y", "P1Z", "P2X", "P2Y", "P2Z", "P3X", "P3Y", "P3Z"]),
];
/// How the axes turn: one of these.
const MOVES: [&str; 3] = ["MOVE", "TURN", "STAY"];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let BlockKind::Statement(own) = &block.kind else { continue };
        if own.kind != StatementKind::Plane {
            continue;
        }
        let head = facts.text(own.head).split_ascii_whitespace();
        let names = || own.words.iter().map(|word| facts.text(word.name).trim());
        let has = |name: &&str| names().chain(head.clone()).any(|own| own.eq_ignore_ascii_case(name));
        let form = FORMS.iter().find(|(form, _)| has(form));
        let lacking = form.and_then(|(_, needed)| needed.iter().find(|name| !has(name)));
        let lacking = lacking.copied().or_else(|| (!MOVES.iter().any(has)).then_some("MOVE, TURN, STAY"));
        if let Some(lacking) = lacking {
            found.push(rule.at(facts, facts.content(block)).arg("word", lacking));
        }
    }
}
