//! The program checker: what a control, its manual or a reader would object to in a program.
//!
//! [`Facts`] reads off a program what the rules need, once; each rule under `rules/` is one file with
//! one code, registered in [`RULES`]. Invariant: a rule speaks only where it is certain. What depends
//! on the run of the program (jumps, parameters calculated, machine data) keeps it silent.
mod against;
mod allow;
mod blank;
mod config;
mod contours;
mod cycle;
mod early;
mod facts;
mod first_way;
mod floors;
mod flow;
mod guards;
mod incident;
mod loops;
mod machine;
mod milled;
mod outcomes;
mod program;
mod rule;
mod rules;
mod slip;
mod speech;
mod spikes;
mod tools;
mod toolwords;
mod travel;

pub use against::Against;
pub use allow::CODES as ALLOW_CODES;
pub use config::{Config, Known, Settings};
pub use cycle::{Aspect, CycleLabels, LabelBook, LanguageLabels, ParamLabels, Tri};
pub(crate) use cycle::{is_label, is_label_by_place, removes_material};
pub use facts::Facts;
pub use flow::{
    Called, Callee, CycleCall, Graph, Loaded, Mark, Modal, Pending, ProgramCall, Project, Rows, Run, ToolName, Use,
    Way, circles, named,
};
pub use incident::{Incident, Observed};
pub use machine::Machine;
pub use program::mills_by_name;
pub use program::{Defined, Definition, Flow, Item, Reading, Unread};
pub use rule::Rule;
pub use rules::RULES;
pub use slip::is_slip;
pub use speech::{Speech, speech};
pub use tools::COARSE;
pub use toolwords::{ToolKind, TurnedPart, diameter_of, is_left, is_milling, is_reaming};

use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::program::syntax::Program;

/// The language of a program's names and labels; nothing if none of them is known.
pub fn language(program: &Program, against: &Against<'_>) -> Option<String> {
    Facts::of(program, against).language
}

/// Everything that is to be reported on a program, syntax included, in the order of its text.
pub fn check(program: &Program, against: &Against<'_>) -> Vec<Diagnostic> {
    found_in(&Facts::of(program, against))
}

/// The same of a program of a project: with the programs that it calls, and tables.
pub fn check_in(program: &Program, against: &Against<'_>, project: &dyn Project) -> Vec<Diagnostic> {
    found_in(&Facts::within(program, against, Some(project)))
}

fn found_in(facts: &Facts<'_>) -> Vec<Diagnostic> {
    let (program, against) = (facts.program, &facts.against);
    if let Some(finding) = rules::not_a_program(facts) {
        return vec![finding];
    }
    let mut found = program.diagnostics();
    for rule in RULES {
        (rule.run)(rule, facts, &mut found);
    }
    // The room of one definition's values serves the next.
    let mut room = Vec::new();
    for definition in &facts.definitions {
        let mut definition = facts.read_into(room, definition);
        let first = found.len();
        look_at(facts, &definition, &mut found);
        // What is found on a pass of a loop is reported once.
        for pass in 0..facts.passes(&definition) {
            let told = found.len();
            facts.read_pass(&mut definition, pass);
            look_at(facts, &definition, &mut found);
            let mut own = found.split_off(told);
            let before = found.get(first..).unwrap_or_default();
            let place = |own: &Diagnostic| (own.code, own.place.as_ref().map(|place| place.span.start));
            own.retain(|own| before.iter().all(|before| place(before) != place(own)));
            found.append(&mut own);
        }
        room = definition.items;
    }
    allow::apply(program, against, &mut found);
    once(&mut found);
    // Of findings at one place those of the parser come first, then those of rules in the order of their codes.
    let place = |own: &Diagnostic| own.place.as_ref().map(|place| (place.span.start, place.span.end));
    found.sort_by(|one, other| place(one).cmp(&place(other)).then_with(|| rank(one.code).cmp(&rank(other.code))));
    found
}

/// What a program that was written by a habit has in every block is one finding: the first.
fn once(found: &mut Vec<Diagnostic>) {
    let habit = |own: &Diagnostic| {
        own.severity == Severity::Warning && ["syntax-spelling", "field-word-missing"].contains(&own.code)
    };
    found.sort_by_key(|own| own.place.as_ref().map(|place| place.span));
    let mut told = BTreeSet::new();
    found.retain(|own| !habit(own) || told.insert(own.code));
}

/// Lets the rules for definitions look at one.
fn look_at(facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    for (rule, each) in rules::OF_DEFINITIONS {
        each(rule, facts, definition, found);
    }
}

/// Where findings of a code are among those at the same place.
fn rank(code: &str) -> usize {
    let place = |code: &str| RULES.iter().position(|rule| rule.code == code);
    match place(code) {
        Some(at) => at + 1,
        None if code.starts_with("syntax-") => 0,
        None if ALLOW_CODES.contains(&code) => RULES.len() + 1,
        // Guards have codes of their own.
        None => place(rules::GUARD).map_or(0, |at| at + 1),
    }
}
