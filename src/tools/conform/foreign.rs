//! Another engine put to the cases: asked by the protocol, judged like ours.
//!
//! Invariant: what it cannot report (which sentences were executed) is not held against it; silence is, and one that
//! stays silent is not asked for ever.
use super::case::{self, Prepared};
use super::protocol::{Answer, CycleName, PROTOCOL, Request};
use super::{CaseReport, CycleReport, Job, Mismatch, Report, Selection, Verdict, World, jobs};
use crate::base::diag::{Diagnostic, dedupe};

/// Why an engine gave no answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Silence {
    /// It took longer than it may.
    TimeLimit,
    /// Its answer had no end within so many bytes.
    TooLong(usize),
    /// It ended, or could not be started, for that reason.
    Ended(String),
}

/// So many cases in a row an engine may be silent that has never answered.
const NEVER: usize = 3;
/// The same of one that has answered before: cases of one cycle, on which it may fail, are kept together.
const NO_MORE: usize = 12;

/// Another engine: gets a line and gives a line.
pub trait Partner {
    /// What reports call it.
    fn name(&self) -> &str {
        "another engine"
    }

    /// The answer to a request.
    ///
    /// # Errors
    /// There is none. The next request is asked all the same.
    fn ask(&mut self, line: &str) -> Result<String, Silence>;
}

/// An engine with what is known of its silence.
struct Patience<'p> {
    partner: &'p mut dyn Partner,
    answered: bool,
    /// Cases without an answer since the last one.
    silent: usize,
}

impl Patience<'_> {
    fn ask(&mut self, line: &str) -> Result<String, Silence> {
        let answer = self.partner.ask(line);
        self.answered |= answer.is_ok();
        self.silent = if answer.is_ok() { 0 } else { self.silent + 1 };
        answer
    }

    fn is_over(&self) -> bool {
        self.silent >= if self.answered { NO_MORE } else { NEVER }
    }
}

/// Puts the examples chosen to another engine. One that was silent too
/// often in a row is not asked further: `engine-not-responding` says how many cases are left.
pub fn run(world: &World<'_>, chosen: &Selection<'_>, partner: &mut dyn Partner) -> (Report, Vec<Diagnostic>) {
    let (mut cases, mut found, mut cycles) = (Vec::new(), Vec::new(), Vec::<CycleReport>::new());
    let jobs = jobs(world, chosen);
    let mut partner = Patience { partner, answered: false, silent: 0 };
    for (id, job) in (1..).zip(&jobs) {
        if partner.is_over() {
            let left = jobs.len() - cases.len();
            let silent = Diagnostic::global("engine-not-responding").arg("silent", partner.silent as f64);
            found.push(silent.arg("left", left as f64));
            break;
        }
        let (report, mistakes) = execute(world, job, id, &mut partner);
        found.extend(mistakes);
        if !cycles.iter().rev().any(|known| known.is_of(&report)) {
            cycles.push(CycleReport::unseen(&report));
        }
        cases.push(report);
    }
    dedupe(&mut found);
    (Report::new(partner.partner.name(), cases, cycles), found)
}

fn execute(world: &World<'_>, job: &Job<'_>, id: u64, partner: &mut Patience<'_>) -> (CaseReport, Vec<Diagnostic>) {
    if let Some(reason) = &job.example.skip {
        return (job.report(Verdict::Skipped { reason: reason.clone() }), Vec::new());
    }
    match case::prepare(world, job.on, job.cycle, job.example) {
        Ok(prepared) => (job.report(judge(job, &prepared, id, partner)), Vec::new()),
        Err(mistakes) => {
            let list = mistakes.iter().map(|mistake| Mismatch::new("case", "a sound case", mistake.code)).collect();
            (job.report(Verdict::Fail { mismatches: list }), mistakes)
        }
    }
}

fn judge(job: &Job<'_>, prepared: &Prepared<'_>, id: u64, partner: &mut Patience<'_>) -> Verdict {
    let key = job.cycle.key;
    let request = Request {
        format: PROTOCOL.to_owned(),
        id,
        control: job.on.id().to_owned(),
        cycle: CycleName { keyword: key.keyword.as_str().to_owned(), number: key.number },
        case: job.example.name.as_str().to_owned(),
        language: prepared.language.tag().to_owned(),
        program: prepared.program.text().to_owned(),
        programs: prepared.called.iter().map(|own| (own.name().to_owned(), own.text().to_owned())).collect(),
        scene: Request::scene(job.example.scene.as_ref().map(|tree| &tree.0)),
        tables: Request::tables(&prepared.scene),
    };
    let fails = |what: &str, expected: &str, found: String| Verdict::Fail {
        mismatches: vec![Mismatch::new(what, expected, found)],
    };
    let line = serde_json::to_string(&request).unwrap_or_default();
    let answer = match partner.ask(&line) {
        Ok(line) => line,
        Err(Silence::TimeLimit) => return fails("engine", "an answer", "none within the time limit".to_owned()),
        Err(Silence::TooLong(most)) => {
            return fails("engine", "an answer", format!("a line without an end, in bytes: {most}"));
        }
        Err(Silence::Ended(reason)) => return fails("engine", "an answer", format!("it ended: {reason}")),
    };
    let answer: Answer = match serde_json::from_str(&answer) {
        Ok(answer) => answer,
        Err(error) => return fails("engine", "an answer", error.to_string()),
    };
    if answer.id != id {
        return fails("id", &id.to_string(), answer.id.to_string());
    }
    let has_moves = answer.moves.is_some();
    match answer.read(&prepared.scene) {
        Ok(answer) => {
            let (outcome, events) = answer.outcome(key);
            let expected = if has_moves { prepared.expectation.clone() } else { prepared.expectation.without_moves() };
            case::judge(job.cycle, job.example, &expected, &outcome, &events, false)
        }
        Err(word) => fails("engine", "an answer of the protocol", word),
    }
}
