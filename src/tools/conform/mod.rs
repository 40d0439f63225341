//! Conformance: the examples of the specifications executed by the engine.
//!
//! Each example is one case for each control that has the cycle; what it expects is compared with what the
//! engine reports. Invariant: an expectation is never adapted to a result; what no example shows is reported.
mod case;
mod expect;
mod foreign;
mod part;
mod protocol;
mod report;
mod show;
mod texts;

use std::collections::BTreeMap;
use std::sync::Arc;

pub use case::Called;
pub use foreign::{Partner, Silence, run as run_foreign};
pub use protocol::{Answer, CellWritten, CycleName, Moved, PROTOCOL, Request, serve};
pub use report::{CaseReport, Clause, CycleReport, FORMAT, Mismatch, Report, Summary, Verdict, junit};
pub use show::WORDS;
pub use texts::{LogTexts, template};

use crate::base::diag::{Diagnostic, Source, dedupe};
use crate::base::parallel;
use crate::engine::plan;
use crate::engine::run::Shown;
use crate::engine::scene::Scene;
use crate::language::locale::Locales;
use crate::spec::{Catalogue, Cycle, CycleKey, Example, Keyword, OnControl};

/// What conformance works on.
#[derive(Clone, Copy, Debug)]
pub struct World<'w> {
    /// The specifications.
    pub catalogue: &'w Catalogue,
    /// The languages, for labels and logs.
    pub locales: &'w Locales,
    /// All data files: machines and templates of logs are among them.
    pub files: &'w [(String, String)],
}

/// What reports call the engine of this library.
const OURS: &str = "ciklo";

/// Which cases are executed: those that each list allows; an empty list allows all.
#[derive(Clone, Copy, Debug, Default)]
pub struct Selection<'s> {
    /// Controls by their ids.
    pub controls: &'s [&'s str],
    /// Cycles by their numbers, with the keyword where it matters.
    pub cycles: &'s [(Option<Keyword>, u32)],
    /// Names of cases.
    pub cases: &'s [&'s str],
}

impl<'s> Selection<'s> {
    /// All cases of these controls.
    pub fn of(controls: &'s [&'s str]) -> Self {
        Self { controls, ..Self::default() }
    }

    fn has_control(&self, on: &OnControl) -> bool {
        self.controls.is_empty() || self.controls.contains(&on.id())
    }

    /// Whether a cycle is one of them.
    pub fn has_cycle(&self, cycle: &Cycle) -> bool {
        let is_it = |(keyword, number): &(Option<Keyword>, u32)| {
            cycle.key.number == *number && keyword.is_none_or(|keyword| keyword == cycle.key.keyword)
        };
        self.cycles.is_empty() || self.cycles.iter().any(is_it)
    }

    fn has_case(&self, example: &Example) -> bool {
        self.cases.is_empty() || self.cases.contains(&example.name.as_str())
    }
}

/// An example on a control.
struct Job<'w> {
    on: &'w OnControl,
    cycle: &'w Cycle,
    example: &'w Example,
}

impl Job<'_> {
    fn report(&self, verdict: Verdict) -> CaseReport {
        case::report(self.on, self.cycle, self.example, verdict)
    }
}

/// Runs the examples chosen. Mistakes in the examples themselves come back as diagnostics.
pub fn run(world: &World<'_>, chosen: &Selection<'_>) -> (Report, Vec<Diagnostic>) {
    let jobs = jobs(world, chosen);
    let results = execute(world, &jobs);
    let mut shown: BTreeMap<(String, CycleKey), Shown> = BTreeMap::new();
    let (mut cases, mut found) = (Vec::new(), Vec::new());
    for (job, (report, seen, mistakes)) in jobs.iter().zip(results) {
        cases.push(report);
        found.extend(mistakes);
        for (key, sentence) in seen.sentences {
            shown.entry((job.on.id().to_owned(), key)).or_default().sentences.insert((key, sentence));
        }
        for (key, code) in seen.guards {
            shown.entry((job.on.id().to_owned(), key)).or_default().guards.insert((key, code));
        }
    }
    let mut cycles = Vec::new();
    if !chosen.cases.is_empty() {
        // Of a cycle that shows some of its cases only, nothing can be said about what no case shows.
        let mut seen: Vec<CycleReport> = cases.iter().map(CycleReport::unseen).collect();
        seen.dedup_by(|a, b| a.control == b.control && a.keyword == b.keyword && a.number == b.number);
        dedupe(&mut found);
        return (Report::new(OURS, cases, seen), found);
    }
    for on in world.catalogue.controls.values().filter(|on| chosen.has_control(on)) {
        for cycle in on.cycles.values().filter(|cycle| chosen.has_cycle(cycle)) {
            let seen = shown.remove(&(on.id().to_owned(), cycle.key)).unwrap_or_default();
            cycles.push(cycle_report(on, cycle, &seen));
        }
    }
    dedupe(&mut found);
    (Report::new(OURS, cases, cycles), found)
}

/// An example on a control as what it executes.
#[derive(Clone, Debug)]
pub struct Executed<'w> {
    /// The control.
    pub on: &'w OnControl,
    /// The cycle that has it.
    pub cycle: &'w Cycle,
    /// Its name.
    pub name: &'w str,
    /// The program.
    pub program: Arc<Source>,
    /// The programs that it calls, by their names.
    pub called: Vec<Arc<Source>>,
    /// The scene.
    pub scene: Scene,
}

/// The programs and scenes of all sound examples on the controls, or on all of them if the list is empty; those that
/// are skipped are left out.
pub fn executed<'w>(world: &World<'w>, controls: &[&str]) -> Vec<Executed<'w>> {
    let ready = |job: Job<'w>| {
        let Job { on, cycle, example } = job;
        let case::Prepared { program, called, scene, .. } = case::prepare(world, on, cycle, example).ok()?;
        Some(Executed { on, cycle, name: example.name.as_str(), program, called, scene })
    };
    let jobs = jobs(world, &Selection::of(controls)).into_iter();
    jobs.filter(|job| job.example.skip.is_none()).filter_map(ready).collect()
}

/// The examples chosen, without executing them: each with an empty verdict, `skipped`.
pub fn listed(world: &World<'_>, chosen: &Selection<'_>) -> Vec<CaseReport> {
    let nothing = || Verdict::Skipped { reason: String::new() };
    jobs(world, chosen).iter().map(|job| job.report(nothing())).collect()
}

/// The examples chosen.
fn jobs<'w>(world: &World<'w>, chosen: &Selection<'_>) -> Vec<Job<'w>> {
    let mut jobs = Vec::new();
    for on in world.catalogue.controls.values().filter(|on| chosen.has_control(on)) {
        for cycle in on.cycles.values().filter(|cycle| chosen.has_cycle(cycle)) {
            let examples = on.cases_of(cycle).filter(|example| chosen.has_case(example));
            jobs.extend(examples.map(|example| Job { on, cycle, example }));
        }
    }
    jobs
}

type Result = (CaseReport, Shown, Vec<Diagnostic>);

/// Executes the cases on all cores; the results come in the order of the jobs.
fn execute(world: &World<'_>, jobs: &[Job<'_>]) -> Vec<Result> {
    parallel::map(jobs, |job| case::execute(world, job.on, job.cycle, job.example))
}

/// What the examples showed of a cycle, and what they did not.
fn cycle_report(on: &OnControl, cycle: &Cycle, seen: &Shown) -> CycleReport {
    let plan = &plan::compiled(cycle, on).plan;
    let id = |sentence: &plan::Sentence| match sentence.kind {
        plan::SentenceKind::Step => format!("step-{}", sentence.id),
        plan::SentenceKind::Say => format!("say-{}", sentence.id),
    };
    let executed = |sentence: &&plan::Sentence| seen.sentences.contains(&(cycle.key, (**sentence).clone()));
    let provoked = |code: &&std::sync::Arc<str>| seen.guards.contains(&(cycle.key, std::sync::Arc::clone(code)));
    CycleReport {
        control: on.id().to_owned(),
        keyword: cycle.key.keyword.as_str(),
        number: cycle.key.number,
        name: cycle.name().to_owned(),
        executed: plan.sentences.iter().filter(executed).map(id).collect(),
        unexecuted: plan.sentences.iter().filter(|sentence| !executed(sentence)).map(id).collect(),
        provoked: plan.codes.iter().filter(provoked).map(|code| code.to_string()).collect(),
        unprovoked: plan.codes.iter().filter(|code| !provoked(code)).map(|code| code.to_string()).collect(),
    }
}

/// The program, the programs that it calls, and the scene of an example.
///
/// # Errors
/// A scene or values that are wrong.
pub fn ready(
    world: &World<'_>,
    on: &OnControl,
    cycle: &Cycle,
    example: &Example,
) -> std::result::Result<(Arc<Source>, Called, Scene), Vec<Diagnostic>> {
    let case::Prepared { program, called, scene, .. } = case::prepare(world, on, cycle, example)?;
    Ok((program, Called::new(&called), scene))
}
