//! One case: its program made, run and compared.
//!
//! Invariant: the frame around a definition is the same for every cycle; nothing depends on a cycle's number.
use std::collections::BTreeMap;
use std::sync::Arc;

use super::expect::Expectation;
use super::part::Part;
use super::report::{CaseReport, Clause, Mismatch, Verdict};
use super::{LogTexts, World, show};
use crate::base::diag::{Diagnostic, Source};
use crate::engine::plan::{self, Plan};
use crate::engine::run::{Engine, Event, Outcome, Programs, Shown, Status, program_key};
use crate::engine::scene::Scene;
use crate::language::label::{Request, block};
use crate::language::locale::{Language, SOURCE_LANGUAGE};
use crate::program::syntax::{self, Program};
use crate::spec::{Cycle, Example, Kind, Node, OnControl, TakesEffect};

/// Executes a case.
pub(super) fn execute(
    world: &World<'_>,
    on: &OnControl,
    cycle: &Cycle,
    example: &Example,
) -> (CaseReport, Shown, Vec<Diagnostic>) {
    let mut found = clauses(cycle, on, example);
    let verdict = |verdict| report(on, cycle, example, verdict);
    if let Some(reason) = &example.skip {
        return (verdict(Verdict::Skipped { reason: reason.clone() }), Shown::default(), found);
    }
    match prepare(world, on, cycle, example) {
        Ok(Prepared { program, called, scene, expectation, language }) => {
            let texts = LogTexts::new(language, on.id(), world.files);
            let program = syntax::parse(&program);
            let called = Called::new(&called);
            let mut events: Vec<Event> = Vec::new();
            let engine = Engine::new(&program, on, &scene, &texts).with_catalogue(world.catalogue);
            let engine = engine.with_programs(&called);
            let mut machining = match expectation.part.as_ref().map(|_| Part::follow(&program, &scene)).transpose() {
                Ok(machining) => machining,
                Err(mistake) => {
                    let mismatch = Mismatch::new("part", "a sound case", mistake.code);
                    found.push(mistake);
                    return (verdict(Verdict::Fail { mismatches: vec![mismatch] }), Shown::default(), found);
                }
            };
            let outcome = engine.run(&mut |event| {
                if let Some(machining) = &mut machining {
                    machining.see(&event);
                }
                events.push(event);
            });
            let mut result = judge(cycle, example, &expectation, &outcome, &events, true);
            if let (Some(part), Some(machining)) = (&expectation.part, machining) {
                part.add_to(&mut result, machining);
            }
            (verdict(result), outcome.shown, found)
        }
        Err(mistakes) => {
            let list = mistakes.iter().map(|mistake| Mismatch::new("case", "a sound case", mistake.code)).collect();
            found.extend(mistakes);
            (verdict(Verdict::Fail { mismatches: list }), Shown::default(), found)
        }
    }
}

/// The report of a case with what came out.
pub(super) fn report(on: &OnControl, cycle: &Cycle, example: &Example, verdict: Verdict) -> CaseReport {
    CaseReport {
        control: on.id().to_owned(),
        keyword: cycle.key.keyword.as_str(),
        number: cycle.key.number,
        cycle: cycle.name().to_owned(),
        case: example.name.as_str().to_owned(),
        proves: example.proves.iter().filter_map(clause).collect(),
        why: example.why.clone(),
        place: format!("{}:{}", example.place.source.name(), example.place.start().line),
        manual: cycle.described.sources.iter().map(|of| format!("{}:{}", of.manual, of.lines)).collect(),
        verdict,
    }
}

/// The programs that a case calls.
pub struct Called(BTreeMap<String, Program>);

impl Called {
    /// Those with these texts, by the names of the sources.
    pub fn new(sources: &[Arc<Source>]) -> Self {
        Self(sources.iter().map(|source| (program_key(source.name()), syntax::parse(source))).collect())
    }
}

impl Programs for Called {
    fn program(&self, key: &str) -> Option<&Program> {
        self.0.get(key)
    }
}

/// A case made ready.
pub(super) struct Prepared<'w> {
    pub(super) program: Arc<Source>,
    /// The programs that it calls.
    pub(super) called: Vec<Arc<Source>>,
    pub(super) scene: Scene,
    pub(super) expectation: Expectation,
    pub(super) language: &'w Language,
}

/// Makes a case ready: its program, its scene, what it expects.
pub(super) fn prepare<'w>(
    world: &World<'w>,
    on: &OnControl,
    cycle: &Cycle,
    example: &Example,
) -> Result<Prepared<'w>, Vec<Diagnostic>> {
    let source = &example.place.source;
    let nothing = Node { span: example.place.span, kind: Kind::Map(Vec::new()) };
    let scene = example.scene.as_ref().map_or(&nothing, |tree| &tree.0);
    let scene = Scene::from_node(scene, source, world.files);
    let expect = example.expect.as_ref().map_or(&nothing, |tree| &tree.0);
    let expectation = Expectation::read(expect, source);
    // What a case proves does not depend on the language; the source language is the one that is complete.
    let language = world.locales.language(SOURCE_LANGUAGE).map_err(|error| vec![error.into()]);
    let (scene, expectation, language) = match (scene, expectation, language) {
        (Ok(scene), Ok(expectation), Ok(language)) => (scene, expectation, language),
        (scene, expectation, language) => {
            let mut all = scene.err().unwrap_or_default();
            all.extend(expectation.err().unwrap_or_default());
            all.extend(language.err().unwrap_or_default());
            return Err(all);
        }
    };
    let text = match &example.program {
        Some(program) => program.as_str().to_owned(),
        None => framed(on, cycle, example, &scene, language)?,
    };
    let program = Source::new(format!("{}.H", example.name.as_str().to_ascii_uppercase()), text);
    let called = example.programs.0.iter().map(|(name, text)| Source::new(name.as_str(), text.as_str())).collect();
    Ok(Prepared { program, called, scene, expectation, language })
}

/// The definition with its values in the usual frame: a tool is called before, and the cycle if it wants a call.
fn framed(
    on: &OnControl,
    cycle: &Cycle,
    example: &Example,
    scene: &Scene,
    language: &Language,
) -> Result<String, Vec<Diagnostic>> {
    let values: Vec<(String, String)> =
        example.given.0.iter().map(|(name, value)| (name.as_str().to_owned(), value.as_str().to_owned())).collect();
    let definition = if cycle.is_old_style() {
        let form = example.form.as_ref().map(|form| form.as_str());
        block(on, cycle, language, &Request { values: &values, form, ..Request::default() })?
    } else {
        definition(cycle, &values)?
    };
    let name = example.name.as_str().to_ascii_uppercase();
    let tool = scene.tools.rows().next().unwrap_or(1.0);
    let mut lines = vec![format!("BEGIN PGM {name} MM"), format!("TOOL CALL {tool} Z S1000 F500")];
    lines.extend(example.before.iter().cloned());
    lines.extend(definition.lines().map(str::to_owned));
    if cycle.file.takes_effect == TakesEffect::OnCall {
        lines.push("CYCL CALL M3".to_owned());
    }
    lines.extend(example.after.iter().cloned());
    lines.push(format!("END PGM {name} MM"));
    Ok(lines.iter().map(|line| format!("{line}\n")).collect())
}

/// A definition with Q parameters. Cases may give values that a printed block must not have, so it is made here.
fn definition(cycle: &Cycle, values: &[(String, String)]) -> Result<String, Vec<Diagnostic>> {
    let example = cycle.file.nc_examples.first();
    let mut text = format!("{} {}\n", cycle.key.keyword.as_str(), cycle.key.number);
    for param in &cycle.params {
        let Some(q) = param.q else { continue };
        let name = q.to_string();
        let given = values.iter().find(|(known, _)| *known == name).map(|(_, value)| value.as_str());
        let printed = || example.and_then(|example| example.values.get(&name)).map(String::as_str);
        let Some(value) = given.or_else(printed).or(param.example.as_deref()) else {
            let diagnostic = Diagnostic::error("conform-no-value", param.place.clone());
            return Err(vec![diagnostic.arg("name", name)]);
        };
        text.push_str(&format!("{name}={value}\n"));
    }
    Ok(text)
}

/// Compares what came out with what is expected; of sentences executed only an engine that reports them is asked.
pub(super) fn judge(
    cycle: &Cycle,
    example: &Example,
    expected: &Expectation,
    outcome: &Outcome,
    events: &[Event],
    tells_sentences: bool,
) -> Verdict {
    if outcome.status == Status::Unsupported && !expected.wants_refusal() {
        let reason = outcome.fault.as_ref().map_or_else(|| Status::Unsupported.as_str().to_owned(), show::fault);
        return Verdict::OutOfSubset { reason };
    }
    let mut mismatches = expected.compare(cycle.key, outcome, events);
    for guard in example.proves.iter().filter_map(|clause| clause.guard.as_ref()) {
        let is_guard = |fault: &crate::engine::run::Fault| *fault.code == *guard.text;
        let provoked = outcome.shown.guards.iter().any(|(_, code)| **code == *guard.text);
        if !provoked && !outcome.fault.as_ref().is_some_and(is_guard) {
            mismatches.push(Mismatch::new(format!("guard.{}", guard.as_str()), "provoked", "not provoked"));
        }
    }
    for step in example.proves.iter().filter_map(|clause| clause.step.as_ref()).filter(|_| tells_sentences) {
        let shown = outcome.shown.sentences.iter().any(|(key, sentence)| *key == cycle.key && sentence.id == step.text);
        if !shown {
            mismatches.push(Mismatch::new(format!("step.{}", step.as_str()), "executed", "not executed"));
        }
    }
    if mismatches.is_empty() { Verdict::Pass } else { Verdict::Fail { mismatches } }
}

fn clause(clause: &crate::spec::Clause) -> Option<Clause> {
    let parts = [
        ("step", &clause.step),
        ("parameter", &clause.parameter),
        ("guard", &clause.guard),
        ("result", &clause.result),
    ];
    let (kind, id) = parts.into_iter().find_map(|(kind, id)| id.as_ref().map(|id| (kind, id)))?;
    Some(Clause { kind, id: id.as_str().to_owned() })
}

/// Clauses that a case claims to prove and that the cycle does not have.
fn clauses(cycle: &Cycle, on: &OnControl, example: &Example) -> Vec<Diagnostic> {
    let plan = &plan::compiled(cycle, on).plan;
    let mut found = Vec::new();
    for clause in &example.proves {
        let unknown = [
            clause.step.as_ref().filter(|id| !has_step(plan, id.as_str())),
            clause.parameter.as_ref().filter(|id| !has_parameter(cycle, id.as_str())),
            clause.result.as_ref().filter(|id| !has_result(cycle, id.as_str())),
        ];
        for id in unknown.into_iter().flatten() {
            let diagnostic = Diagnostic::error("conform-unknown-clause", id.place.clone());
            found.push(diagnostic.arg("name", id.as_str()).arg("cycle", cycle.key.to_string()));
        }
    }
    found
}

fn has_step(plan: &Plan, id: &str) -> bool {
    plan.sentences.iter().any(|sentence| *sentence.id == *id)
}

fn has_parameter(cycle: &Cycle, id: &str) -> bool {
    let q = crate::base::expr::QRef::parse(id);
    cycle.params.iter().any(|param| match &param.field {
        Some(field) => field.id.as_str() == id,
        None => q.is_some() && param.q == q,
    })
}

fn has_result(cycle: &Cycle, id: &str) -> bool {
    let q = crate::base::expr::QRef::parse(id);
    let results = cycle.file.results.iter();
    results.clone().any(|result| result.q == q && q.is_some())
        || results.clone().any(|result| result.field.as_ref().is_some_and(|field| field.as_str() == id))
}
