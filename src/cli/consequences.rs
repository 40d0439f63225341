//! What `ciklo lint` shows of its findings: causes without what only follows from them, those about some cycles, counts.
//!
//! Invariant: a finding is only left out where another one, which is shown, is its cause.
use std::collections::{BTreeMap, BTreeSet, HashSet};

use crate::base::diag::{Arg, Diagnostic, Place, Severity};
use crate::language::locale::{Args, Ui};
use crate::spec::{self, Catalogue, Cycle, OnControl};
use crate::tools::conform::{CaseReport, Mismatch, Verdict};

/// A parameter whose meaning no one knows is none that the rest of the file could use.
const CAUSE: &str = "spec-unknown-meaning";
/// What is then said of each use of it.
const USES: [&str; 3] = ["plan-unknown-name", "spec-unknown-parameter", "conform-unknown-clause"];
/// What a run ends with whose specification has a mistake, which is found and shown at its own place.
const MISTAKE: &str = "plan-mistake";

/// Leaves out the uses of parameters whose meaning is not known.
pub(super) fn without_uses(found: &mut Vec<Diagnostic>) {
    let causes: Vec<(String, String)> = found
        .iter()
        .filter(|finding| finding.code == CAUSE)
        .filter_map(|finding| {
            let place = finding.place.as_ref()?;
            Some((place.source.name().to_owned(), line_of(place).to_owned()))
        })
        .collect();
    let follows = |finding: &Diagnostic| {
        let (Some(Arg::Text(name)), Some(place)) = (finding.get("name"), &finding.place) else { return false };
        causes.iter().any(|(file, line)| file == place.source.name() && has_word(line, name))
    };
    found.retain(|finding| !(USES.contains(&finding.code) && follows(finding)));
}

/// The line in which a place begins.
fn line_of(place: &Place) -> &str {
    let text = place.source.text();
    let start = text.get(..place.span.start).and_then(|before| before.rfind('\n')).map_or(0, |at| at + 1);
    text.get(start..).and_then(|rest| rest.lines().next()).unwrap_or_default()
}

fn has_word(line: &str, word: &str) -> bool {
    line.split(|sign: char| !sign.is_alphanumeric()).any(|own| own == word)
}

/// The differences of a case that are worth a finding each: nothing where a mistake in the specification, which is found
/// by itself, ended the run; lists not next to their first difference, sentences not next to an error.
pub(super) fn causes(case: &CaseReport) -> Vec<&Mismatch> {
    let Verdict::Fail { mismatches } = &case.verdict else { return Vec::new() };
    if mismatches.iter().any(|one| one.what == "errors" && one.found.starts_with(MISTAKE)) {
        return Vec::new();
    }
    let ended = mismatches.iter().any(|one| one.what == "errors" || one.what == "end");
    let list = |one: &&Mismatch| one.expected.contains('\n') || one.found.contains('\n');
    mismatches.iter().filter(|one| !list(one) && !(ended && one.what.starts_with("step."))).collect()
}

/// Keeps the findings in the files and texts of the cycles that are wanted.
pub(super) fn only(
    found: &mut Vec<Diagnostic>,
    catalogue: &Catalogue,
    wanted: &dyn Fn(&Cycle) -> bool,
    files: &[String],
) {
    let cycles: Vec<(&OnControl, &Cycle)> = catalogue
        .controls
        .values()
        .flat_map(|on| on.cycles.values().map(move |cycle| (on, cycle)))
        .filter(|(_, cycle)| wanted(cycle))
        .collect();
    let ids: HashSet<String> =
        cycles.iter().flat_map(|(on, cycle)| spec::texts(cycle, on)).map(|text| text.id).collect();
    let own: BTreeSet<&str> = cycles.iter().map(|(_, cycle)| cycle.file.name.place.source.name()).collect();
    found.retain(|finding| {
        let here = finding.place.as_ref().is_some_and(|place| {
            let name = place.source.name();
            own.contains(name) || files.iter().any(|file| file == name)
        });
        let id = |key: &str| key.split(['.', '_']).next().is_some_and(|id| ids.contains(id));
        here || matches!(finding.get("key"), Some(Arg::Text(key)) if id(key))
    });
}

/// How many findings each file has, the worst first, a line each.
pub(super) fn by_file(found: &[Diagnostic], ui: &Ui) -> String {
    let mut counts: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for finding in found {
        let file = finding.place.as_ref().map_or("-", |place| place.source.name());
        let (errors, others) = counts.entry(file).or_default();
        *(if finding.severity == Severity::Error { errors } else { others }) += 1;
    }
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by(|(a, (errors, others)), (b, (more, and))| (more, and, a).cmp(&(errors, others, b)));
    let line = |(file, (errors, others)): (&str, (usize, usize))| {
        let args = Args::new().text("path", file).number("errors", errors as f64).number("others", others as f64);
        ui.text("cli-lint-file", &args) + "\n"
    };
    counts.into_iter().map(line).collect()
}
