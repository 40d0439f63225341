//! What comes out of a conformance run, and its form for machines (`docs/conform.md`).
//!
//! Invariant: data and its JSON and JUnit forms; how a person reads it is the caller's.
use serde::Serialize;

/// The name and version of the JSON form.
pub const FORMAT: &str = "ciklo-conform/1";

/// The whole report.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// `ciklo-conform/1`.
    pub format: &'static str,
    /// Who was tested with what, and how it went.
    pub summary: Summary,
    /// The cases by control, cycle and order of the file.
    pub cases: Vec<CaseReport>,
    /// What the cases showed of each cycle.
    pub cycles: Vec<CycleReport>,
}

/// The head of a report.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// The engine: `ciklo`, or the command of another one.
    pub engine: String,
    /// The version of the program whose specifications hold the cases.
    pub suite_version: &'static str,
    /// How many cases passed.
    pub pass: usize,
    /// How many failed.
    pub fail: usize,
    /// How many the engine cannot execute.
    pub out_of_subset: usize,
    /// How many the specifications leave out.
    pub skipped: usize,
}

impl Report {
    /// The report of an engine.
    pub(super) fn new(engine: &str, cases: Vec<CaseReport>, cycles: Vec<CycleReport>) -> Self {
        let count = |wanted: fn(&Verdict) -> bool| cases.iter().filter(|case| wanted(&case.verdict)).count();
        let summary = Summary {
            engine: engine.to_owned(),
            suite_version: env!("CARGO_PKG_VERSION"),
            pass: count(|verdict| matches!(verdict, Verdict::Pass)),
            fail: count(|verdict| matches!(verdict, Verdict::Fail { .. })),
            out_of_subset: count(|verdict| matches!(verdict, Verdict::OutOfSubset { .. })),
            skipped: count(|verdict| matches!(verdict, Verdict::Skipped { .. })),
        };
        Self { format: FORMAT, summary, cases, cycles }
    }

    /// How many cases have that verdict.
    pub fn count(&self, wanted: fn(&Verdict) -> bool) -> usize {
        self.cases.iter().filter(|case| wanted(&case.verdict)).count()
    }

    /// Whether no case fails.
    pub fn is_clean(&self) -> bool {
        self.summary.fail == 0
    }
}

/// A case on a control.
#[derive(Clone, Debug, Serialize)]
pub struct CaseReport {
    /// The control.
    pub control: String,
    /// `CYCL DEF` or `TCH PROBE`.
    pub keyword: &'static str,
    /// The number of the cycle.
    pub number: u32,
    /// The name of the cycle.
    pub cycle: String,
    /// The name of the case.
    pub case: String,
    /// What it proves.
    pub proves: Vec<Clause>,
    /// Where its expected values come from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub why: Option<String>,
    /// Its place in the specification, `file:line`.
    pub place: String,
    /// Where the manual of the control describes the cycle, `manual:lines`.
    pub manual: Vec<String>,
    /// What came out.
    #[serde(flatten)]
    pub verdict: Verdict,
}

impl CaseReport {
    /// What it proves, in words: `step drill, parameter Q200`.
    pub fn clauses(&self) -> String {
        let clauses: Vec<String> = self.proves.iter().map(|clause| format!("{} {}", clause.kind, clause.id)).collect();
        clauses.join(", ")
    }
}

/// A clause of a specification.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Clause {
    /// `step`, `parameter`, `guard` or `result`.
    pub kind: &'static str,
    /// Its id.
    pub id: String,
}

/// What came out of a case.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "verdict", rename_all = "kebab-case")]
pub enum Verdict {
    /// Everything as expected.
    Pass,
    /// Something differs.
    Fail {
        /// What.
        mismatches: Vec<Mismatch>,
    },
    /// The engine cannot execute it.
    OutOfSubset {
        /// Why.
        reason: String,
    },
    /// The specification says that it cannot be executed.
    Skipped {
        /// Why.
        reason: String,
    },
}

/// A difference.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Mismatch {
    /// What differs: `q.Q151`, `end`, `table.PRESET.PR.12.X` …
    pub what: String,
    /// What the case expects.
    pub expected: String,
    /// What came out.
    pub found: String,
}

impl Mismatch {
    pub(super) fn new(what: impl Into<String>, expected: impl ToString, found: impl ToString) -> Self {
        Self { what: what.into(), expected: expected.to_string(), found: found.to_string() }
    }
}

/// What the cases showed of a cycle on a control.
#[derive(Clone, Debug, Serialize)]
pub struct CycleReport {
    /// The control.
    pub control: String,
    /// `CYCL DEF` or `TCH PROBE`.
    pub keyword: &'static str,
    /// The number of the cycle.
    pub number: u32,
    /// Its name.
    pub name: String,
    /// Sentences that were executed, by message id.
    pub executed: Vec<String>,
    /// Sentences that were not.
    pub unexecuted: Vec<String>,
    /// Codes of guards and errors that were provoked.
    pub provoked: Vec<String>,
    /// Those that were not.
    pub unprovoked: Vec<String>,
}

impl CycleReport {
    /// The report of the cycle of a case of which nothing else is known.
    pub(super) fn unseen(case: &CaseReport) -> Self {
        Self {
            control: case.control.clone(),
            keyword: case.keyword,
            number: case.number,
            name: case.cycle.clone(),
            executed: Vec::new(),
            unexecuted: Vec::new(),
            provoked: Vec::new(),
            unprovoked: Vec::new(),
        }
    }

    /// Whether a case is one of this cycle.
    pub(super) fn is_of(&self, case: &CaseReport) -> bool {
        self.control == case.control && self.keyword == case.keyword && self.number == case.number
    }
}

fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            // Characters that XML cannot hold at all.
            c if c.is_control() && !matches!(c, '\n' | '\t') => escaped.push(char::REPLACEMENT_CHARACTER),
            c => escaped.push(c),
        }
    }
    escaped
}

/// The report as JUnit XML: a suite a control, a class a cycle.
pub fn junit(report: &Report) -> String {
    let of = &report.summary;
    let mut xml = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" \
         skipped=\"{}\">\n",
        escape(&format!("{FORMAT} {}, {}", of.suite_version, of.engine)),
        report.cases.len(),
        of.fail,
        of.skipped + of.out_of_subset,
    );
    let mut controls: Vec<&str> = report.cases.iter().map(|case| case.control.as_str()).collect();
    controls.dedup();
    for control in controls {
        let cases: Vec<&CaseReport> = report.cases.iter().filter(|case| case.control == control).collect();
        let count = |wanted: fn(&Verdict) -> bool| cases.iter().filter(|case| wanted(&case.verdict)).count();
        let failures = count(|verdict| matches!(verdict, Verdict::Fail { .. }));
        let skipped = count(|verdict| matches!(verdict, Verdict::Skipped { .. } | Verdict::OutOfSubset { .. }));
        let (name, tests) = (escape(control), cases.len());
        xml.push_str(&format!(
            "  <testsuite name=\"{name}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"0\" \
             skipped=\"{skipped}\">\n"
        ));
        for case in cases {
            xml.push_str(&junit_case(case));
        }
        xml.push_str("  </testsuite>\n");
    }
    xml.push_str("</testsuites>\n");
    xml
}

fn junit_case(case: &CaseReport) -> String {
    let class = escape(&format!("{}.{} {}", case.control, case.keyword, case.number));
    let head = format!("    <testcase classname=\"{class}\" name=\"{}\"", escape(&case.case));
    match &case.verdict {
        Verdict::Pass => format!("{head}/>\n"),
        Verdict::Fail { mismatches } => {
            let mut lines: Vec<String> = mismatches
                .iter()
                .map(|found| format!("{}: expected {}, found {}", found.what, found.expected, found.found))
                .collect();
            if !case.proves.is_empty() {
                lines.push(format!("proves: {}", case.clauses()));
            }
            lines.push(format!("case: {}", case.place));
            if !case.manual.is_empty() {
                lines.push(format!("manual: {}", case.manual.join("; ")));
            }
            lines.extend(case.why.iter().map(|why| format!("why: {why}")));
            let first = mismatches.first().map_or("mismatch", |found| found.what.as_str());
            let (message, text) = (escape(first), escape(&lines.join("\n")));
            format!("{head}>\n      <failure message=\"{message}\">{text}</failure>\n    </testcase>\n")
        }
        Verdict::OutOfSubset { reason } | Verdict::Skipped { reason } => {
            format!("{head}>\n      <skipped message=\"{}\"/>\n    </testcase>\n", escape(reason))
        }
    }
}
