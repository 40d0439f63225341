//! The checker on programs: for every rule one that it objects to and one that it leaves alone, and
//! the blocks that the manuals print.
//!
//! Programs stand in `tests/check/<code>.h` and `<code>-not.h`; their first line names the control.
//! What is found stands beside each in `*.expect`; `UPDATE=1 cargo test --test suite check` writes it anew.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::{env, fs};

use ciklo::base::diag::{Diagnostic, Severity, Source};
use ciklo::base::renamed;
use ciklo::check::{
    ALLOW_CODES, Against, Called, Callee, Facts, LabelBook, Machine, Observed, Project, RULES, Rows, ToolName, check,
    check_in, named,
};
use ciklo::language::locale::{Locales, Ui};
use ciklo::program::syntax::{Program, parse};
use ciklo::program::table::{Table, TableKind};
use ciklo::spec::{Catalogue, OnControl};
use ciklo::tools::rehearse::Rehearsal;
use proptest::prelude::*;

use crate::cases;

struct Data {
    catalogue: &'static Catalogue,
    locales: &'static Locales,
}

impl Data {
    fn new() -> Self {
        let catalogue = &crate::built::built().catalogue;
        let locales = &*crate::built::built().locales;
        Self { catalogue, locales }
    }

    fn with<T>(&self, control: &str, then: impl FnOnce(&Against<'_>) -> T) -> T {
        let on: &OnControl = self.catalogue.on(control).unwrap_or_else(|| panic!("no control {control}"));
        let labels = LabelBook::new(on, self.locales);
        let readers = [self.locales.source().expect("English is there")];
        then(&Against {
            catalogue: self.catalogue,
            on,
            labels: &labels,
            language: None,
            software: None,
            readers: &readers,
        })
    }

    fn check(&self, control: &str, program: &Program) -> Vec<Diagnostic> {
        self.with(control, |against| check(program, against))
    }
}

/// The value of a word such as `control:` in the first line.
fn head<'t>(text: &'t str, word: &str) -> &'t str {
    let line = text.lines().next().unwrap_or_default();
    line.split(word).nth(1).and_then(|rest| rest.split_whitespace().next()).unwrap_or("tnc640")
}

fn files(directory: &str, extension: &str) -> Vec<PathBuf> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join(directory);
    let entries = fs::read_dir(directory).expect("the directory");
    let mut found: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    found.retain(|path| path.extension().is_some_and(|own| own == extension));
    found.sort();
    found
}

fn stem(path: &Path) -> String {
    path.file_stem().expect("a name").to_string_lossy().into_owned()
}

fn line(diagnostic: &Diagnostic) -> String {
    let place = diagnostic.place.as_ref().expect("a place");
    let (start, end) = (place.start(), place.end());
    let place = format!("{}:{}-{}:{}", start.line, start.column, end.line, end.column);
    format!("{place} {} {}\n", diagnostic.severity.as_str(), diagnostic.code)
}

fn found_in(data: &Data, path: &Path) -> Vec<Diagnostic> {
    let text = fs::read_to_string(path).expect("a program");
    let program = parse(&Source::new("program.h", text.clone()));
    data.with(head(&text, "control:"), |against| {
        // Those that say so stand among the programs of `tests/check/beside`.
        if text.lines().next().is_some_and(|line| line.contains("beside")) {
            check_in(&program, against, &Beside { against, own: stem(path), machine: machine(), tools: tools(path) })
        } else {
            check(&program, against)
        }
    })
}

/// The programs of `tests/check/beside`, a tool table with the tools 1, MILL, TAP, PROBE, CENTRE, RECESSER for turned
/// recesses, WORN and TWIN, which are locked, and UNMEASURED, which has no length; tables with the rows 0 to 3.
///
/// Where a program has a tool table of its own, `<name>.t`, its tools are those, and the execution has them.
struct Beside<'a> {
    against: &'a Against<'a>,
    own: String,
    machine: Machine,
    tools: Option<Table>,
}

/// The tool table of a program.
fn tools(program: &Path) -> Option<Table> {
    let text = fs::read_to_string(program.with_extension("t")).ok()?;
    Some(Table::parse(TableKind::Tool, &Source::new("tool.t", text)).expect("a table"))
}

/// A machine with an axis X of 800 mm and an axis C.
fn machine() -> Machine {
    Machine {
        speed: Some(20000.0),
        feed: Some(30000.0),
        helix: Some(5400.0),
        travel: [("X".to_owned(), [-400.0, 400.0]), ("C".to_owned(), [-360.0, 360.0])].into(),
    }
}

impl Beside<'_> {
    /// The row of a tool in its own table.
    fn row(&self, tool: ToolName<'_>) -> Option<(&Table, f64)> {
        let table = self.tools.as_ref()?;
        let row = match tool {
            ToolName::Number(number) => table.has_row(number).then_some(number),
            ToolName::Name(name) => table.find("NAME", name).ok()?,
        };
        Some((table, row?))
    }

    fn read(name: &str) -> Option<Program> {
        let path = format!("{}/tests/check/beside/{name}.h", env!("CARGO_MANIFEST_DIR"));
        fs::read_to_string(path).ok().map(|text| parse(&Source::new("beside.h", text)))
    }
}

impl Project for Beside<'_> {
    fn called(&self, name: &str) -> Called {
        let name = name.trim_end_matches(".H");
        let Some(program) = Self::read(name) else { return Called::Missing(Severity::Warning) };
        let round = named(&program, self.against).iter().any(|called| called.eq_ignore_ascii_case(&self.own));
        Called::Is { callee: Arc::new(Callee::of(&program, self.against, None)), round }
    }

    fn lacks_file(&self, name: &str) -> Option<Severity> {
        match name {
            "HOLE.PNT" => Some(Severity::Warning),
            "ELSEWHERE.D" => Some(Severity::Note),
            _ => None,
        }
    }

    fn has_tool(&self, tool: ToolName<'_>) -> Option<bool> {
        if self.tools.is_some() {
            return Some(self.row(tool).is_some());
        }
        Some(matches!(
            tool,
            ToolName::Number(1.0)
                | ToolName::Name(
                    "MILL"
                        | "TAP"
                        | "PROBE"
                        | "CENTRE"
                        | "WORN"
                        | "TWIN"
                        | "UNMEASURED"
                        | "RECESSER"
                        | "INSIDE"
                        | "OUTSIDE"
                )
        ))
    }

    fn knows_tools(&self) -> bool {
        true
    }

    fn machine(&self) -> Option<&Machine> {
        Some(&self.machine)
    }

    fn tool_value(&self, tool: ToolName<'_>, column: &str) -> Option<f64> {
        if self.tools.is_some() {
            return self.row(tool).and_then(|(table, row)| table.number(row, column).ok()?);
        }
        match (tool, column) {
            (ToolName::Number(1.0), "NMAX") => Some(8000.0),
            (ToolName::Number(1.0), "LCUTS") => Some(20.0),
            (ToolName::Number(1.0), "R") => Some(5.0),
            (ToolName::Number(1.0), "CUT") => Some(4.0),
            (ToolName::Name("UNMEASURED"), "L") => None,
            (_, "L") => Some(100.0),
            (ToolName::Name("TAP"), "R") => Some(3.0),
            (ToolName::Name("PROBE"), "R") => Some(2.0),
            (ToolName::Name("CENTRE"), "T-ANGLE") => Some(0.0),
            (ToolName::Name("TWIN"), "T-ANGLE") => Some(90.0),
            _ => None,
        }
    }

    fn tool_word(&self, tool: ToolName<'_>, column: &str) -> Option<&str> {
        if self.tools.is_some() {
            let word = self.row(tool).and_then(|(table, row)| table.text(row, column).ok());
            return word.map(str::trim).filter(|word| !word.is_empty());
        }
        match (tool, column) {
            (ToolName::Number(1.0) | ToolName::Name("MILL"), "TYP") => Some("MILL"),
            (ToolName::Name("TAP"), "TYP") => Some("TAP"),
            (ToolName::Name("PROBE"), "TYP") => Some("TCHP"),
            (ToolName::Name("WORN" | "TWIN"), "TL") => Some("L"),
            (ToolName::Name("WORN"), "RT") => Some("0"),
            (ToolName::Name("TWIN"), "RT") => Some("7"),
            _ => None,
        }
    }

    fn turning_type(&self, tool: ToolName<'_>) -> Option<&str> {
        (tool == ToolName::Name("RECESSER")).then_some("RECESS")
    }

    fn turning_value(&self, tool: ToolName<'_>, column: &str) -> Option<f64> {
        // An inside tool, and one for outside that cuts towards lower Z.
        match (tool, column) {
            (ToolName::Name("INSIDE"), "TO") => Some(7.0),
            (ToolName::Name("OUTSIDE"), "TO") => Some(1.0),
            (ToolName::Name("RECESSER"), "CUTWIDTH") => Some(4.0),
            _ => None,
        }
    }

    fn observed(&self, program: &Program) -> Vec<Observed> {
        let Against { on, catalogue, .. } = *self.against;
        Rehearsal { on, catalogue, files: &crate::built::built().files, tools: self.tools.as_ref(), programs: None }
            .observed(program, &|_| {})
    }

    fn has_row(&self, rows: Rows<'_>, row: f64) -> Option<bool> {
        (rows != Rows::Datums(Some("OTHER.D"))).then(|| [0.0, 1.0, 2.0, 3.0].contains(&row))
    }
}

#[test]
fn programs_have_the_expected_findings() {
    let data = Data::new();
    let mut wrong = Vec::new();
    for path in files("tests/check", "h") {
        let found: String = found_in(&data, &path).iter().map(line).collect();
        let beside = path.with_extension("expect");
        if env::var_os("UPDATE").is_some() {
            fs::write(&beside, found).expect("the expectation written");
        } else if fs::read_to_string(&beside).ok().as_ref() != Some(&found) {
            wrong.push(format!("{} should be\n{found}", beside.display()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_expectation_has_its_program() {
    if env::var_os("UPDATE").is_some() {
        return;
    }
    let stems = |extension| files("tests/check", extension).iter().map(|path| stem(path)).collect::<BTreeSet<_>>();
    assert_eq!(stems("expect"), stems("h"));
}

#[test]
fn every_rule_fires_once_and_stays_silent_once() {
    let data = Data::new();
    let fires = |name: &str, code: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/check/{name}.h"));
        assert!(
            path.exists(),
            "{} is missing: one program that the rule objects to, one that it leaves alone",
            path.display()
        );
        let found = found_in(&data, &path);
        found.iter().filter(|diagnostic| diagnostic.code == code).count()
    };
    for rule in RULES {
        // Guards speak with codes of their own; this is one of them.
        let code = if rule.code == "guard" { "depth-positive" } else { rule.code };
        assert!(fires(rule.code, code) > 0, "{} does not fire", rule.code);
        assert_eq!(fires(&format!("{}-not", rule.code), code), 0, "{} fires where it must not", rule.code);
    }
}

#[test]
fn every_code_has_a_text_and_an_explanation_in_every_language() {
    let data = Data::new();
    let codes = RULES.iter().map(|rule| rule.code).chain(["label-not-encodable", "label-missing"]).chain(ALLOW_CODES);
    for code in codes {
        for tag in data.locales.tags() {
            let language = data.locales.language(tag).expect("it is listed");
            for key in [format!("diag-{code}"), format!("explain-{code}")] {
                assert!(
                    language.has(key.as_str(), &ciklo::language::locale::Scope::NONE),
                    "locales/{tag} has no {key}"
                );
            }
        }
    }
}

#[test]
fn every_code_is_documented() {
    let page = include_str!("../../docs/check.md");
    for code in RULES.iter().map(|rule| rule.code).chain(ALLOW_CODES) {
        assert!(page.contains(&format!("`{code}`")), "docs/check.md has no line for {code}");
    }
}

#[test]
fn every_finding_can_be_said() {
    let data = Data::new();
    for tag in data.locales.tags() {
        let ui = Ui::new(data.locales, Some(tag), &[]).expect("it is listed");
        for path in files("tests/check", "h") {
            for diagnostic in found_in(&data, &path) {
                let text = ui.diagnostic(&diagnostic);
                assert!(!text.contains(diagnostic.code) && !text.contains('{'), "{tag}: {text}");
            }
        }
    }
}

/// What the manuals print is right, apart from what is known to be a misprint.
#[test]
fn printed_blocks_are_free_of_errors() {
    let data = Data::new();
    let mut wrong = Vec::new();
    for path in files("tests/printed", "nc") {
        let text = fs::read_to_string(&path).expect("a block");
        let control = head(&text, "control:").to_owned();
        let found = data.check(&control, &parse(&Source::new("printed.h", text.clone())));
        // A block by itself has no tool.
        let errors = found.iter().filter(|d| d.severity == Severity::Error && d.code != "tool-missing");
        let misprint = |diagnostic: &&Diagnostic| {
            let place = diagnostic.place.as_ref().expect("a place");
            let written = &text[place.span.start..place.span.end];
            data.catalogue.errata.iter().any(|erratum| erratum.printed.as_deref() == Some(written))
        };
        let errors = errors.filter(|diagnostic| !misprint(diagnostic));
        wrong.extend(errors.map(|diagnostic| format!("{}: {}", stem(&path), line(diagnostic))));
    }
    assert_eq!(wrong, Vec::<String>::new());
}

#[test]
fn the_language_of_a_program_is_that_of_its_labels() {
    let data = Data::new();
    for path in files("tests/printed", "nc") {
        let text = fs::read_to_string(&path).expect("a block");
        let language = head(&text, "lang:").to_owned();
        let program = parse(&Source::new("printed.h", text.clone()));
        let found = data.with(head(&text, "control:"), |against| Facts::of(&program, against).language);
        let has_labels = text.lines().any(|line| line.starts_with('Q') && line.contains(';'));
        if has_labels
            && data
                .locales
                .language(&language)
                .is_ok_and(|l| l.has("cycle-drilling", &ciklo::language::locale::Scope::NONE))
        {
            assert_eq!(found.as_deref(), Some(language.as_str()), "{}", stem(&path));
        }
    }
}

thread_local! {
    /// Loaded once for all cases.
    static DATA: Data = Data::new();
}

laws! {
    #![proptest_config(crate::cases::config(256))]

    /// Whatever a program says, it is checked, and every finding has a place in it.
    #[test]
    fn any_program_is_checked(pieces in proptest::collection::vec((0..1000_usize, 0..8_usize), 0..30)) {
        let printed = files("tests/printed", "nc");
        let mut text = String::new();
        for (which, part) in pieces {
            let block = fs::read_to_string(&printed[which % printed.len()]).expect("a block");
            let lines: Vec<&str> = block.lines().collect();
            text.push_str(match part {
                0 => &block,
                1 => "L X+5 M99\n",
                2 => "CYCL CALL M3 ~\n",
                3 => "TOOL CALL 5 Z\n",
                4 => "CALL LBL 1\n",
                _ => lines[which % lines.len()],
            });
            text.push_str(if part % 2 == 0 { "" } else { "\n" });
        }
        let program = parse(&Source::new("any.h", text.clone()));
        for control in ["tnc640", "tnc320", "itnc530", "tnc426-430"] {
            for diagnostic in DATA.with(|data| data.check(control, &program)) {
                let span = diagnostic.place.expect("a place").span;
                prop_assert!(text.get(span.start..span.end).is_some());
            }
        }
    }
}

#[test]
fn a_definition_of_many_lines_is_checked_in_linear_time() {
    let data = Data::new();
    let text = "1 CYCL DEF 200 VRTANJE\n".to_owned() + &"Q201=-5 ;GLOBINA\n".repeat(50_000);
    let found = data.check("tnc640", &parse(&Source::new("long.h", text)));
    // All but the first one stand there again.
    assert_eq!(found.iter().filter(|diagnostic| diagnostic.code == "duplicate-parameter").count(), 49_999);
}

/// A mistake planted into a program: where it must be told, by which codes, and the edits that plant it.
struct Planted<'t> {
    program: &'t str,
    line: usize,
    codes: Vec<&'t str>,
    edits: Vec<&'t str>,
}

fn planted(text: &str) -> Vec<Planted<'_>> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines
        .map(|line| {
            let (head, edits) = line.split_once(" | ").expect("program, line, codes | edits");
            let mut words = head.split_whitespace();
            let program = words.next().expect("a program");
            let line = words.next().and_then(|line| line.parse().ok()).expect("a line");
            let one = edits.contains(" s|") || edits.contains(" a|");
            let edits = if one { vec![edits] } else { edits.split(';').collect() };
            Planted { program, line, codes: words.collect(), edits }
        })
        .collect()
}

fn edit(lines: &mut Vec<String>, edit: &str) {
    let (number, what) = edit.split_once(' ').expect("a line and what becomes of it");
    let at = number.parse::<usize>().expect("a line") - 1;
    let mut parts = what.split('|');
    match parts.next() {
        Some("d") => drop(lines.remove(at)),
        Some("t") => lines.truncate(at + 1),
        Some("a") => lines.insert(at + 1, parts.next().expect("a text").to_owned()),
        Some("s") => {
            let (old, new) = (parts.next().expect("a text"), parts.next().expect("a text"));
            assert!(lines[at].contains(old), "{edit}: {}", lines[at]);
            lines[at] = lines[at].replacen(old, new, 1);
        }
        Some(swap) => {
            let other: usize = swap.trim_start_matches("x ").parse().expect("a line");
            lines.swap(at, other - 1);
        }
        None => unreachable!("split gives something"),
    }
}

/// Of the mistakes that people make, all that are planted are told at their line.
#[test]
fn planted_mistakes_are_found_at_their_line() {
    let data = Data::new();
    let all = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/check/planted.txt")).expect("it");
    let mut missed = Vec::new();
    let all = planted(&all);
    for own in &all {
        let path = format!("{}/tests/check/planted/{}.h", env!("CARGO_MANIFEST_DIR"), own.program);
        let text = fs::read_to_string(path).expect("a program");
        let control = head(&text, "control:").to_owned();
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        own.edits.iter().for_each(|one| edit(&mut lines, one));
        let text = lines.join("\n") + "\n";
        let found = data.check(&control, &parse(&Source::new("planted.h", text)));
        let told = |diagnostic: &Diagnostic| {
            let line = diagnostic.place.as_ref().expect("a place").start().line;
            line == own.line && own.codes.contains(&diagnostic.code)
        };
        if !found.iter().any(told) {
            missed.push(format!("{} {}", own.program, own.edits.join(";")));
        }
    }
    assert!(all.len() >= 400, "{} mistakes", all.len());
    assert_eq!(missed, Vec::<String>::new());
}

#[test]
fn what_mistakes_are_planted_into_is_good() {
    let data = Data::new();
    for path in files("tests/check/planted", "h") {
        let found: String = found_in(&data, &path).iter().map(line).collect();
        assert_eq!(found, "", "{}", path.display());
    }
}

#[test]
fn old_names_of_codes_are_in_order_and_none_is_both_old_and_present() {
    assert!(renamed::RENAMED.is_sorted_by(|one, next| one.0 < next.0), "{:?}", renamed::RENAMED);
    for (old, new) in renamed::RENAMED {
        assert_eq!((renamed::present(old), renamed::present(new)), (*new, *new));
    }
}

/// The parameters of cycle 200 in the order of the control.
const DRILLING: [&str; 8] = [
    "Q200=2 ;SET-UP CLEARANCE",
    "Q201=-15 ;DEPTH",
    "Q206=250 ;FEED RATE FOR PLNGNG",
    "Q202=5 ;PLUNGING DEPTH",
    "Q210=0 ;DWELL TIME AT TOP",
    "Q203=+20 ;SURFACE COORDINATE",
    "Q204=100 ;2ND SET-UP CLEARANCE",
    "Q211=0 ;DWELL TIME AT DEPTH",
];

/// How many numbers can stay where they are so that they rise, by trying every choice.
fn most_that_rise(numbers: &[usize]) -> u32 {
    let rises = |choice: u32| {
        let kept = (0..numbers.len()).filter(|at| choice & 1 << at != 0).map(|at| numbers[at]);
        kept.is_sorted()
    };
    (0..1_u32 << numbers.len()).filter(|choice| rises(*choice)).map(u32::count_ones).max().unwrap_or_default()
}

laws! {
    #![proptest_config(cases::config(60))]

    /// A definition is in order, or one parameter is named that must move: the others have as long an order without it.
    #[test]
    fn the_parameter_that_is_named_is_one_that_must_move(order in Just((0..8_usize).collect::<Vec<_>>()).prop_shuffle()) {
        let rows: String = order.iter().map(|own| format!("  {}\n", DRILLING[*own])).collect();
        let text = format!("0 BEGIN PGM A MM\n1 CYCL DEF 200 DRILLING\n{rows}2 END PGM A MM\n");
        let mut found = Data::new().check("tnc640", &parse(&Source::new("a.h", text)));
        found.retain(|finding| finding.code == "misordered-parameter");
        prop_assert_eq!(found.len(), usize::from(!order.is_sorted()));
        if let Some(finding) = found.first() {
            let line = finding.place.as_ref().expect("a place").start().line;
            let mut others = order.clone();
            others.remove(line - 3);
            prop_assert_eq!(most_that_rise(&others), most_that_rise(&order));
        }
    }
}
