//! What a folder of programs says of the hand that wrote them, such as a CAM post-processor:
//! by program, cycle and rule.
//!
//! Invariants: nothing is judged here, the checker's findings are counted; what no specification describes is neither
//! right nor wrong but out of the subset, and is reported.
use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::Facts;
use crate::program::syntax::{BlockKind, IsoKind};
use crate::spec::{CycleKey, Known};

/// How something came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// No error was found.
    Pass,
    /// An error was found, or what else was asked to fail.
    Fail,
    /// No error was found, but not all of it could be judged.
    OutOfSubset,
}

impl Verdict {
    /// The word in documents and messages.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Fail => "fail",
            Self::OutOfSubset => "out-of-subset",
        }
    }

    const fn of(wrong: bool, judged: bool) -> Self {
        match (wrong, judged) {
            (true, _) => Self::Fail,
            (false, false) => Self::OutOfSubset,
            (false, true) => Self::Pass,
        }
    }
}

/// A program.
#[derive(Clone, Debug, Serialize)]
pub struct ProgramReport {
    /// Its file.
    pub file: String,
    /// How it came out.
    pub verdict: Verdict,
    /// Blocks that are neither empty nor comments.
    pub blocks: usize,
    /// Errors in it.
    pub errors: usize,
    /// Warnings in it.
    pub warnings: usize,
}

/// A cycle in all programs.
#[derive(Clone, Debug, Serialize)]
pub struct CycleReport {
    /// Such as `CYCL DEF 200`; of a DIN/ISO code that no specification describes the code.
    pub cycle: String,
    /// How it came out.
    pub verdict: Verdict,
    /// How often it is defined.
    pub definitions: usize,
    /// Definitions with an error inside.
    pub wrong: usize,
}

/// A rule in all programs.
#[derive(Clone, Debug, Serialize)]
pub struct RuleReport {
    /// Its code.
    pub rule: String,
    /// How bad its findings are.
    #[serde(serialize_with = "word")]
    pub severity: Severity,
    /// How many there are.
    pub findings: usize,
    /// In how many programs.
    pub programs: usize,
    /// The first of them: `file:line:column`.
    pub first: String,
}

/// A severity as documents name it.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "the signature is that of serde")]
fn word<S: serde::Serializer>(severity: &Severity, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(severity.as_str())
}

/// What was seen so far.
#[derive(Clone, Debug)]
pub struct Tally {
    /// With what findings a program or definition fails.
    least: Severity,
    programs: Vec<ProgramReport>,
    cycles: BTreeMap<CycleKey, (bool, usize, usize)>,
    /// Codes of DIN/ISO that no specification describes, and how often they come.
    codes: BTreeMap<u16, usize>,
    rules: BTreeMap<(&'static str, Severity), Rule>,
}

#[derive(Clone, Debug)]
struct Rule {
    findings: usize,
    programs: BTreeSet<usize>,
    first: String,
}

impl Tally {
    /// A tally of programs that fail with findings of a severity or worse ones.
    pub fn new(least: Severity) -> Self {
        let (programs, cycles, codes, rules) = Default::default();
        Self { least, programs, cycles, codes, rules }
    }

    /// Counts a program: what it consists of and what was found in it.
    pub fn add(&mut self, file: &str, facts: &Facts<'_>, found: &[Diagnostic]) {
        let at = self.programs.len();
        let count = |severity| found.iter().filter(|finding| finding.severity == severity).count();
        let (errors, warnings) = (count(Severity::Error), count(Severity::Warning));
        let mut judged = true;
        let fails = found.iter().any(|finding| finding.severity >= self.least);
        let wrong = found.iter().filter(|finding| finding.severity >= self.least);
        let mut wrong: Vec<usize> = wrong.filter_map(|own| own.place.as_ref().map(|place| place.span.start)).collect();
        wrong.sort_unstable();
        for definition in &facts.definitions {
            let described = matches!(definition.known, Known::Described(_));
            judged &= described;
            let blocks = facts.program.blocks().get(definition.view.first..=definition.view.last).unwrap_or_default();
            let start = blocks.first().map_or(0, |block| block.span.start);
            let end = blocks.last().map_or(0, |block| block.span.end);
            let is_wrong = wrong.get(wrong.partition_point(|at| *at < start)).is_some_and(|at| *at < end);
            let entry = self.cycles.entry(definition.key).or_insert((described, 0, 0));
            entry.1 += 1;
            entry.2 += usize::from(is_wrong);
        }
        for block in facts.program.blocks() {
            let BlockKind::Iso(own) = &block.kind else { continue };
            if let IsoKind::Cycle(code) = own.kind {
                judged = false;
                *self.codes.entry(code).or_default() += 1;
            }
        }
        for finding in found {
            let place = finding.place.as_ref().map(|place| place.start());
            let rule = self.rules.entry((finding.code, finding.severity)).or_insert_with(|| Rule {
                findings: 0,
                programs: BTreeSet::new(),
                first: place.map_or_else(|| file.to_owned(), |at| format!("{file}:{}:{}", at.line, at.column)),
            });
            rule.findings += 1;
            rule.programs.insert(at);
        }
        let blocks = facts.acting().count();
        let verdict = Verdict::of(fails, judged);
        self.programs.push(ProgramReport { file: file.to_owned(), verdict, blocks, errors, warnings });
    }

    /// The programs in the order in which they came.
    pub fn programs(&self) -> &[ProgramReport] {
        &self.programs
    }

    /// How many programs came out so.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.programs.iter().filter(|program| program.verdict == verdict).count()
    }

    /// The cycles in their order.
    pub fn cycles(&self) -> Vec<CycleReport> {
        let report = |(key, &(described, definitions, wrong)): (&CycleKey, &(bool, usize, usize))| CycleReport {
            cycle: key.to_string(),
            verdict: Verdict::of(wrong > 0, described),
            definitions,
            wrong,
        };
        let coded = self.codes.iter().map(|(code, definitions)| CycleReport {
            cycle: format!("G{code:02}"),
            verdict: Verdict::OutOfSubset,
            definitions: *definitions,
            wrong: 0,
        });
        self.cycles.iter().map(report).chain(coded).collect()
    }

    /// The rules that found something, once for each severity of their findings, the worst first.
    pub fn rules(&self) -> Vec<RuleReport> {
        let mut rules: Vec<_> = self.rules.iter().collect();
        rules.sort_by_key(|((code, severity), rule)| {
            (std::cmp::Reverse(*severity), std::cmp::Reverse(rule.findings), *code)
        });
        let report = |((code, severity), rule): (&(&'static str, Severity), &Rule)| RuleReport {
            rule: (*code).to_owned(),
            severity: *severity,
            findings: rule.findings,
            programs: rule.programs.len(),
            first: rule.first.clone(),
        };
        rules.into_iter().map(report).collect()
    }
}
