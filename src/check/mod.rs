//! The program checker: what a control, its manual or a reader would object to in a program.
//!
//! [`Facts`] reads off a program what the rules need, once; each rule under `rules/` is one file with
//! one code, registered in [`RULES`]. Invariant: a rule speaks only where it is certain. What depends
//! on the run of the program (jumps, parameters calculated, machine data) keeps it silent.
mod allow;
mod among;
mod blank;
mod config;
mod contours;
mod definition;
mod facts;
mod fields;
mod flow;
mod guards;
mod labels;
mod rules;
mod tools;
mod unread;
mod values;
mod words;

pub use allow::CODES as ALLOW_CODES;
pub use among::{Among, Called, Callee, ProgramCall, Rows, ToolName, named};
pub use config::{Config, Known, Settings};
pub use definition::{Defined, Definition, Item};
pub use facts::{Facts, Flow};
pub use flow::{Aspect, CycleCall, Graph, Loaded, Mark, Modal, Pending, Run, Tri, Use, Way, circles};
pub(crate) use labels::is_label;
pub use labels::{CycleLabels, LabelBook, LanguageLabels, ParamLabels, Speech, speech};
pub use rules::RULES;
pub use unread::Unread;

use crate::base::diag::{Diagnostic, Place, Severity, Span};
use crate::language::locale::Language;
use crate::program::syntax::Program;
use crate::spec::{Catalogue, OnControl};

/// A rule of the checker.
#[derive(Debug)]
pub struct Rule {
    /// The stable code of its findings.
    pub code: &'static str,
    /// How bad they are; guards of specifications have a severity each.
    pub severity: Severity,
    /// Looks for them.
    run: fn(&Rule, &Facts<'_>, &mut Vec<Diagnostic>),
}

impl Rule {
    /// A finding of this rule.
    fn at(&self, facts: &Facts<'_>, span: Span) -> Diagnostic {
        let place = Place::new(facts.program.source(), span);
        Diagnostic { severity: self.severity, ..Diagnostic::error(self.code, place) }
    }
}

/// What programs are checked against.
#[derive(Clone, Copy)]
pub struct Against<'a> {
    /// All controls, to tell on which of them a cycle exists.
    pub catalogue: &'a Catalogue,
    /// The control that the program is for.
    pub on: &'a OnControl,
    /// Its labels in all languages.
    pub labels: &'a LabelBook<'a>,
    /// The language of the program's labels; found out from them if not given.
    pub language: Option<&'a str>,
    /// Languages for the sentences of guards, the first that has a sentence wins.
    pub readers: &'a [&'a Language],
}

/// The language of a program's names and labels; nothing if none of them is known.
pub fn language(program: &Program, against: &Against<'_>) -> Option<String> {
    Facts::of(program, against).language
}

/// Everything that can be said against a program, syntax included, in the order of its text.
pub fn check(program: &Program, against: &Against<'_>) -> Vec<Diagnostic> {
    found_in(&Facts::of(program, against))
}

/// The same of a program that stands among others, which it calls, and tables.
pub fn check_among(program: &Program, against: &Against<'_>, among: &dyn Among) -> Vec<Diagnostic> {
    found_in(&Facts::among(program, against, Some(among)))
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
        // What is found on a pass of a loop is told once.
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
    // Of findings at one place those of the parser come first, then those of rules in the order of their codes.
    let place = |own: &Diagnostic| own.place.as_ref().map(|place| (place.span.start, place.span.end));
    found.sort_by(|one, other| place(one).cmp(&place(other)).then_with(|| rank(one.code).cmp(&rank(other.code))));
    found
}

/// Lets the rules for definitions look at one.
fn look_at(facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    for (rule, each) in rules::OF_DEFINITIONS {
        each(rule, facts, definition, found);
    }
}

/// Where findings of a code stand among those at the same place.
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
