//! DIN/ISO: programs told in Klartext and back, what is refused, and where everything comes from.
//!
//! `tests/iso/*.i` are told in Klartext in the `*.h` beside them, findings at the end; `UPDATE=1 cargo test --test suite iso` writes them.
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::{env, fs};

use ciklo::base::data::{self, Files};
use ciklo::base::diag::{Diagnostic, Source};
use ciklo::check::{Against, LabelBook, check};
use ciklo::engine::run::{Engine, Trace};
use ciklo::engine::scene::Scene;
use ciklo::language::label;
use ciklo::language::locale::Locales;
use ciklo::program::iso::{Codes, to_iso, to_klartext};
use ciklo::program::syntax::{Dialect, Program, parse};
use ciklo::spec::Catalogue;
use ciklo::tools::compare::compare;
use ciklo::tools::conform::{self, LogTexts, Partner, Request, Selection, Silence, World};
use proptest::prelude::*;

#[path = "../iso/programs.rs"]
mod programs;
use programs::{block, iso_block};

struct Data {
    files: Files,
    catalogue: &'static Catalogue,
    locales: &'static Locales,
}

impl Data {
    /// Read once for all tests.
    fn shared() -> &'static Self {
        static DATA: LazyLock<Data> = LazyLock::new(Data::new);
        &DATA
    }

    fn new() -> Self {
        let files = data::embedded();
        let catalogue = &crate::built::built().catalogue;
        let locales = &*crate::built::built().locales;
        Self { files, catalogue, locales }
    }

    fn with<T>(&self, control: &str, then: impl FnOnce(&Against<'_>) -> T) -> T {
        let on = self.catalogue.on(control).expect("the control");
        let labels = LabelBook::new(on, self.locales);
        then(&Against { catalogue: self.catalogue, on, labels: &labels, language: None, software: None, readers: &[] })
    }

    /// The differences of two programs.
    fn differences(&self, control: &str, a: &Program, b: &Program) -> Vec<String> {
        let found = self.with(control, |against| compare(a, b, against));
        found.iter().map(|difference| format!("{difference:?}")).collect()
    }
}

fn read(name: &str, text: &str) -> Program {
    parse(&Source::new(name, text))
}

/// A Klartext program by way of DIN/ISO; nothing if a block of it is refused.
fn by_way_of_iso(codes: &Codes<'_>, program: &Program) -> Option<(String, Program)> {
    let raised = to_iso(program, codes);
    raised.diagnostics.is_empty().then(|| {
        let iso = read(program.source().name(), &raised.text);
        assert_eq!(iso.dialect(), Dialect::Iso, "{}", raised.text);
        let lowered = to_klartext(&iso, codes, None);
        assert!(lowered.diagnostics.is_empty(), "{}\n{:?}", raised.text, lowered.diagnostics);
        (raised.text, lowered.program)
    })
}

fn files(extension: &str) -> Vec<PathBuf> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/iso");
    let mut found: Vec<PathBuf> =
        fs::read_dir(directory).expect("a folder").map(|e| e.expect("an entry").path()).collect();
    found.retain(|path| path.extension().is_some_and(|own| own == extension));
    found.sort();
    found
}

fn told(finding: &Diagnostic) -> String {
    let place = finding.place.as_ref().expect("a place").start();
    format!("; {}:{} {} {:?}\n", place.line, place.column, finding.code, finding.args)
}

#[test]
fn programs_are_told_in_klartext() {
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    let mut wrong = Vec::new();
    for path in files("i") {
        let text = fs::read_to_string(&path).expect("a program");
        let program = read("part.i", &text);
        let lowered = to_klartext(&program, &codes, None);
        let mut expected = lowered.program.source().text().to_owned();
        for finding in &lowered.diagnostics {
            let _ = write!(expected, "{}", told(finding));
        }
        let beside = path.with_extension("h");
        if env::var_os("UPDATE").is_some() {
            fs::write(&beside, expected).expect("written");
        } else if fs::read_to_string(&beside).unwrap_or_default() != expected {
            wrong.push(format!("{} should be\n{expected}", beside.display()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Lines before a program do not make it one of the other language, and none is lost.
#[test]
fn a_sheet_before_the_program_stays_there() {
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    let text = "; setup\n\n( sheet ) ; 2\n0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+1 R0 FMAX\n( a note )\n3 END PGM A MM\n";
    let program = read("part.h", text);
    let (iso, back) = by_way_of_iso(&codes, &program).expect("everything has an equivalent");
    assert!(iso.starts_with("; setup\n\n; ( sheet ) ; 2\n%A G71 *\n"), "{iso}");
    assert!(iso.contains("; ( a note )*"), "{iso}");
    // The mark of a transfer is none of the program.
    let lowered = to_klartext(&read("part.i", &format!("%\n{iso}%\n")), &codes, None);
    assert_eq!(lowered.diagnostics.iter().map(|found| found.code).collect::<Vec<_>>(), ["syntax-foreign-line"; 2]);
    assert_eq!(lowered.program.errors().count(), 0, "{}", lowered.program.source().text());
    assert!(data.differences("tnc640", &program, &back).is_empty());
    assert!(data.differences("tnc640", &program, &lowered.program).is_empty());
}

/// Values with a point or a comma behind G99 are none of a label.
#[test]
fn lengths_of_tools_are_no_labels() {
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    let text = "%A G71 *\nN10 G99 T2 L75. R0.0*\nN20 G99 T3 L75,5 R2,5*\nN30 L1,2*\nN40 M140 MB MAX F500*\nN50 G00 M140 MB50*\nN99999999 %A G71 *\n";
    let lowered = to_klartext(&read("part.i", text), &codes, None);
    let expected = "0 BEGIN PGM A MM\n1 TOOL DEF 2 L75. R0.0\n2 TOOL DEF 3 L75,5 R2,5\n3 CALL LBL 1 REP 2\n4 L F500 M140 MB MAX\n5 L FMAX M140 MB50\n6 END PGM A MM\n";
    assert_eq!(lowered.program.source().text(), expected);
}

/// The table of codes in the page is that of the specifications.
#[test]
fn every_code_is_documented() {
    const HEAD: &str = "| code | cycle | words of its fields | source |\n|---|---|---|---|\n";
    let data = Data::shared();
    let mut rows = BTreeMap::<(u32, String), String>::new();
    for on in data.catalogue.controls.values() {
        for cycle in on.cycles.values() {
            let forms = cycle.file.forms.iter().flat_map(|form| &form.iso);
            for iso in cycle.file.iso.iter().chain(forms) {
                let number = iso.code.trim_start_matches('G').parse().expect("a number");
                let words = iso.words.iter().map(|word| match &word.word {
                    Some(own) => format!("`{own}` {}", word.field.as_str()),
                    None => format!("{} as in Klartext", word.field.as_str()),
                });
                let words = words.collect::<Vec<_>>().join(", ");
                let source = cycle.described.sources.first().expect("a source");
                let source = format!("{}:{}", source.manual.as_str(), source.lines.as_str());
                rows.entry((number, cycle.key.to_string()))
                    .or_insert_with(|| format!("| `{}` | `{}` | {words} | {source} |\n", iso.code, cycle.key));
            }
        }
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/iso.md");
    let page = fs::read_to_string(&path).expect("the page");
    let text = page.split(HEAD).next().unwrap_or_default();
    let expected = format!("{text}{HEAD}{}", rows.into_values().collect::<String>());
    if env::var_os("UPDATE").is_some() {
        fs::write(&path, &expected).expect("written");
    } else {
        assert_eq!(page, expected);
    }
}

/// What the checker finds in the Klartext is told where it stands in the file.
#[test]
fn findings_stand_in_the_file() {
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    let text = "%A G71 *\nN10 T1 G17 S1000 M3*\nN20 G200 Q200=2 Q201=-20 Q206=0 Q202=5 Q210=0 Q203=+0 Q204=50 Q211=0*\n\
                N30 G79*\nN40 G201 Q200=+2 ;SET-UP CLEARANCE\nQ201=-15 ;DEPTH\nQ206=99999999\nQ208=200*\nN50 G26 R2*\nN60 G333*\n\
                N70 G81 X*\nN99999999 %A G71*\n";
    let program = read("part.i", text);
    let lowered = to_klartext(&program, &codes, None);
    let found = data.with("tnc640", |against| check(&lowered.program, against));
    let found = lowered.findings(found, lowered.diagnostics.clone());
    let said: Vec<String> = found.iter().map(told).collect();
    let expected =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/iso/findings.txt")).unwrap_or_default();
    if env::var_os("UPDATE").is_some() {
        fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/iso/findings.txt"), said.concat())
            .expect("written");
        return;
    }
    assert_eq!(said.concat(), expected);
}

/// Every place of the Klartext has its place in the file, and what was copied is there letter by letter.
#[test]
fn copies_know_where_they_come_from() {
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    let mut copies = 0;
    for path in files("i") {
        let text = fs::read_to_string(&path).expect("a program");
        let program = read("part.i", &text);
        let lowered = to_klartext(&program, &codes, None);
        let klartext = lowered.program.source().text();
        for at in 0..klartext.len() {
            for length in [0, 1, 3] {
                let span = ciklo::base::diag::Span::new(at, (at + length).min(klartext.len()));
                let home = lowered.home(span);
                assert!(home.start <= home.end && home.end <= text.len());
                if let Some(exact) = lowered.exact(span) {
                    assert_eq!(text.get(exact.start..exact.end), klartext.get(span.start..span.end));
                    copies += 1;
                }
            }
        }
    }
    assert!(copies > 1000);
}

/// Every code that a manual prints, in `codes.txt` with its line, is that of a cycle whose definition is written with it and read
/// from it again.
#[test]
fn codes_of_the_manuals_are_those_of_cycles() {
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    let list = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/iso/codes.txt")).expect("the list");
    let mut written = BTreeMap::<String, Vec<&str>>::new();
    for on in data.catalogue.controls.values() {
        let language = data.locales.language(on.control.language.as_str()).expect("its language");
        for cycle in on.cycles.values() {
            let forms = cycle.file.forms.iter().map(|form| Some(form.form.as_str()));
            let forms = if cycle.file.forms.is_empty() { vec![None] } else { forms.collect() };
            for form in forms {
                let request = label::Request { form, number: Some(1), ..label::Request::default() };
                let Ok(block) = label::block(on, cycle, language, &request) else { continue };
                let program = read("part.h", &format!("0 BEGIN PGM A MM\n{block}99 END PGM A MM\n"));
                let Some((iso, back)) = by_way_of_iso(&codes, &program) else { continue };
                let differences = data.differences(on.id(), &program, &back);
                assert!(differences.is_empty(), "{block}{iso}\n{differences:#?}");
                let code = iso.split_whitespace().find(|word| word.starts_with('G') && *word != "G71").expect("a code");
                let manuals = on.control.manuals.iter().map(String::as_str);
                written.entry(code.to_owned()).or_default().extend(manuals);
            }
        }
    }
    let mut count = 0;
    for line in list.lines() {
        let (code, source) = line.split_once(' ').expect("a code and its place");
        let (manual, _) = source.split_once(':').expect("a manual and a line");
        assert!(written.get(code).is_some_and(|manuals| manuals.contains(&manual)), "{line}: {:?}", written.get(code));
        count += 1;
    }
    assert_eq!(count, 185);
}

/// The blocks that the manuals print, by way of DIN/ISO, say the same; those that have no code are few and named.
#[test]
fn printed_blocks_come_back() {
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/printed");
    let (mut count, mut refused) = (0, BTreeMap::<String, usize>::new());
    for entry in fs::read_dir(directory).expect("the blocks") {
        let path = entry.expect("an entry").path();
        let text = fs::read_to_string(&path).expect("a block");
        let control = text.split("control:").nth(1).and_then(|rest| rest.split_whitespace().next()).expect("a control");
        let body = text.split_once('\n').expect("a head").1;
        let program = read("part.h", &format!("0 BEGIN PGM A MM\n{body}\n99 END PGM A MM\n"));
        let Some((iso, back)) = by_way_of_iso(&codes, &program) else {
            let raised = to_iso(&program, &codes);
            for finding in raised.diagnostics {
                *refused.entry(format!("{} {:?}", finding.code, finding.get("found"))).or_default() += 1;
            }
            continue;
        };
        count += 1;
        let differences = data.differences(control, &program, &back);
        assert!(differences.is_empty(), "{}:\n{iso}\n{differences:#?}", path.display());
    }
    let list: String = refused.iter().map(|(what, count)| format!("{count} {what}\n")).collect();
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/iso/refused.txt");
    if env::var_os("UPDATE").is_some() {
        fs::write(&beside, &list).expect("written");
    }
    assert_eq!(fs::read_to_string(&beside).unwrap_or_default(), list);
    assert!(count > 250, "{count}");
}

/// A second frame in DIN/ISO is the end of the program: it is refused.
#[test]
fn a_second_program_in_a_file_is_refused() {
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    let program = read("two.h", "0 BEGIN PGM P MM\n1 L X+1\n2 BEGIN PGM P MM\n3 L X+2\n4 END PGM P MM\n");
    let raised = to_iso(&program, &codes);
    assert_eq!(raised.diagnostics.iter().map(|own| own.code).collect::<Vec<_>>(), ["iso-no-equivalent"]);
}

/// A code without coordinates would only change what acts, and an arc without radius is none: such blocks are reported
/// and left out.
#[test]
fn blocks_without_coordinates_or_radius_are_refused() {
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    for (line, refused) in [
        ("L", true),
        ("C DR+", true),
        ("CT M8", true),
        ("CP DR-", true),
        ("L M8", false),
        ("L R0 F100", false),
        ("CR X+0 R0 DR+", true),
        ("CR X+0 R+0 DR+", false),
        ("CR X+0 R-0 DR+", false),
    ] {
        let program = read("part.h", &format!("0 BEGIN PGM A MM\n1 CC X+0 Y+0\n2 {line}\n3 END PGM A MM\n"));
        let raised = to_iso(&program, &codes);
        assert_eq!(raised.diagnostics.len(), usize::from(refused), "{line}\n{}", raised.text);
    }
}

/// Every FN is a D of the same number, and comes back.
#[test]
fn functions_are_d_functions() {
    const FUNCTIONS: [&str; 34] = [
        "FN 0: Q5 = +60",
        "FN 1: Q1 = -Q2 + -5",
        "FN 2: Q1 = +10 - +5",
        "FN 3: Q2 = +3 * +Q3",
        "FN 4: Q4 = +4 DIV +Q2",
        "FN 5: Q20 = SQRT 4",
        "FN 6: Q20 = SIN -Q5",
        "FN 7: Q21 = COS -Q5",
        "FN 8: Q10 = +5 LEN +4",
        "FN 9: IF +Q1 EQU +Q3 GOTO LBL \"UPCAN25\"",
        "FN 10: IF +10 NE -Q5 GOTO LBL 10",
        "FN 11: IF +Q1 GT +10 GOTO LBL QS5",
        "FN 12: IF +Q5 LT +0 GOTO LBL 1",
        "FN 13: Q20 = +25 ANG -Q1",
        "FN 14: ERROR = 1000",
        "FN 15: PRINT 20",
        "FN 15: PRINT1/Q1/Q2/Q3",
        "FN 16: F-PRINT TNC:\\MASK\\MASK1.A / TNC:\\PROT1.TXT",
        "FN 17: SYSWRITE ID 990 NR 6 IDX 2 = +1",
        "FN 18: SYSREAD Q25 = ID210 NR4 IDX3",
        "FN 19: PLC = +10 / +Q3",
        "FN 20: WAIT FOR M4095==1",
        "FN 20: WAIT FOR SYNC",
        "FN 23: CDATA Q20 = Q30",
        "FN 24: CDATA Q20 = Q30",
        "FN 25: PRESET = X/+Q5/+0",
        "FN 26: TABOPEN TNC:\\DIR1\\TAB1.TAB",
        "FN 27: TABWRITE 5 / \"RADIUS,DEPTH,D\" = Q5",
        "FN 28: TABREAD Q10 = 6 / \"X,Y,D\"",
        "FN 29: PLC = +10 / +Q3",
        "FN 37: EXPORT Q25",
        "FN 37: EXPORT QS30",
        "FN 38: SEND /\"Q-Parameter Q1: %f Q23: %f\" / +Q1 / +Q23",
        "FN 38: SEND /\"done\"",
    ];
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    for line in FUNCTIONS {
        let program = read("part.h", &format!("0 BEGIN PGM A MM\n1 {line}\n2 END PGM A MM\n"));
        assert_eq!(program.errors().count(), 0, "{line}");
        let Some((iso, back)) = by_way_of_iso(&codes, &program) else { panic!("{line} is refused") };
        let number: u32 =
            line.trim_start_matches("FN ").split(':').next().and_then(|n| n.parse().ok()).expect("a number");
        assert!(iso.contains(&format!("N10 D{number:02}")), "{line}\n{iso}");
        let differences = data.differences("tnc640", &program, &back);
        assert!(differences.is_empty(), "{line}\n{iso}\n{}\n{differences:#?}", back.source().text());
    }
}

/// The programs of the manuals that lie with their scenes in `examples/` come back whole.
#[test]
fn programs_of_the_manuals_come_back() {
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    let mut count = 0;
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples")).expect("the programs") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|extension| extension != "h") {
            continue;
        }
        let text = fs::read_to_string(&path).expect("a program");
        let program = read("part.h", &text);
        let Some((iso, back)) = by_way_of_iso(&codes, &program) else {
            // DIN/ISO has no words for free contours.
            assert!(text.contains("FPOL"), "{} is refused", path.display());
            continue;
        };
        let differences = data.differences("tnc640", &program, &back);
        assert!(differences.is_empty(), "{}:\n{iso}\n{differences:#?}", path.display());
        count += 1;
    }
    assert!(count >= 15, "{count}");
}

/// Executes every example as it is and by way of DIN/ISO.
struct ByWayOfIso<'d> {
    data: &'d Data,
    codes: Codes<'d>,
    executed: usize,
    refused: usize,
}

impl ByWayOfIso<'_> {
    fn trace(&self, request: &Request, program: &Program) -> (String, usize, &'static str) {
        let on = self.data.catalogue.on(&request.control).expect("the control");
        let scene = Scene::parse(&Source::new("scene", request.scene.to_string()), &self.data.files).expect("a scene");
        let language = self.data.locales.language(&request.language).expect("the language");
        let texts = LogTexts::new(language, on.id(), &self.data.files);
        let mut trace = Trace::default();
        let engine = Engine::new(program, on, &scene, &texts).with_catalogue(self.data.catalogue);
        let outcome = engine.run(&mut |event| trace.push(event));
        (trace.fingerprint(), trace.events.len(), outcome.status.as_str())
    }
}

impl Partner for ByWayOfIso<'_> {
    fn ask(&mut self, line: &str) -> Result<String, Silence> {
        let request: Request = serde_json::from_str(line).expect("a request");
        let program = read("case.h", &request.program);
        match by_way_of_iso(&self.codes, &program) {
            Some((iso, back)) => {
                let differences = self.data.differences(&request.control, &program, &back);
                assert!(differences.is_empty(), "{} {}:\n{iso}\n{differences:#?}", request.control, request.case);
                let (there, here) = (self.trace(&request, &back), self.trace(&request, &program));
                assert_eq!(there, here, "{} {}:\n{}\n{iso}", request.control, request.case, request.program);
                self.executed += 1;
            }
            None => self.refused += 1,
        }
        Err(Silence::Ended(String::new()))
    }
}

#[test]
fn examples_do_the_same_by_way_of_iso() {
    let data = Data::shared();
    let world = World { catalogue: data.catalogue, locales: data.locales, files: &data.files };
    let mut partner = ByWayOfIso { data, codes: Codes::new(data.catalogue), executed: 0, refused: 0 };
    let _ = conform::run_foreign(&world, &Selection::of(&["tnc640", "tnc320"]), &mut partner);
    println!("{} executed, {} refused", partner.executed, partner.refused);
    assert!(partner.executed > 10 * partner.refused, "{} executed, {} refused", partner.executed, partner.refused);
}

/// Long programs take no longer than their length.
#[test]
fn long_programs_are_told_in_linear_time() {
    let data = Data::shared();
    let codes = Codes::new(data.catalogue);
    for unit in [
        "G70\n",
        "N10 G01 G91 X+5 F100 M3*\n",
        "N10 G200 Q200=2\nQ201=3 ;A*\n",
        "N10 G26 R2*\n",
        "G54 X+5*\n",
        "G91",
        "(a)",
    ] {
        let text = unit.repeat(20_000);
        let lowered = to_klartext(&read("part.i", &text), &codes, None);
        assert!(lowered.program.blocks().len() <= 4 * 20_000 + 4);
    }
}

/// Cases that laws once failed on.
#[test]
fn these_programs_come_back() {
    let codes = Codes::new(Data::shared().catalogue);
    for block in ["TCH PROBE 400 X ~\n Q263=+0 ;A ~\n Q264=+5", "CR X+0 R+0 DR-"] {
        let program = read("part.h", &format!("0 BEGIN PGM A MM\n{block}\nEND PGM A MM\n"));
        let (iso, back) = by_way_of_iso(&codes, &program).expect("nothing is refused");
        assert_eq!(Data::shared().differences("tnc640", &program, &back), Vec::<String>::new(), "{iso}");
    }
    for blocks in ["N10 G03 X+1 R+5 *\nN20 G02 X+0 R0 *", "N10 G01 G91 G90 X+0 *"] {
        let lowered = to_klartext(&read("part.i", &format!("%A G71 *\n{blocks}\nN99999999 %A G71 *\n")), &codes, None);
        let (iso, back) = by_way_of_iso(&codes, &lowered.program).expect("nothing is refused");
        assert_eq!(Data::shared().differences("tnc640", &lowered.program, &back), Vec::<String>::new(), "{iso}");
    }
}

laws! {
    #![proptest_config(crate::cases::config(300))]

    /// Klartext by way of DIN/ISO is the same program.
    #[test]
    fn klartext_comes_back(blocks in proptest::collection::vec(block(), 1..12), inch in any::<bool>()) {
        let data = Data::shared();
        let codes = Codes::new(data.catalogue);
        let unit = if inch { "INCH" } else { "MM" };
        let text = format!("0 BEGIN PGM A {unit}\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 BLK FORM 0.2 IX+100 Y+50 Z+0\n{}\nEND PGM A {unit}\n", blocks.join("\n"));
        let program = read("part.h", &text);
        prop_assert_eq!(program.errors().count(), 0, "{}", text);
        let raised = to_iso(&program, &codes);
        prop_assert!(raised.diagnostics.is_empty(), "{}\n{:?}", text, raised.diagnostics);
        let (iso, back) = by_way_of_iso(&codes, &program).expect("nothing is refused");
        let differences = data.differences("tnc640", &program, &back);
        prop_assert!(differences.is_empty(), "{}\n{}\n{}\n{:#?}", text, iso, back.source().text(), differences);
        // DIN/ISO by way of Klartext is the same text from then on.
        let again = to_iso(&back, &codes);
        prop_assert_eq!(again.text, iso);
    }

    /// DIN/ISO by way of Klartext is the same program: told in Klartext once more, it says the same.
    #[test]
    fn iso_comes_back(blocks in proptest::collection::vec(iso_block(), 1..12), inch in any::<bool>()) {
        let data = Data::shared();
        let codes = Codes::new(data.catalogue);
        let unit = if inch { "G70" } else { "G71" };
        let blocks = blocks.iter().filter(|block| !(inch && *block == "G71"));
        let body: String = blocks.flat_map(|block| block.split(" *\n").map(str::to_owned).collect::<Vec<_>>()).zip(1..)
            .map(|(block, number)| format!("N{}0 {block}*\n", number)).collect();
        let text = format!("%A {unit} *\nN1 G30 G17 X+0 Y+0 Z-20*\nN2 G31 G90 X+100 Y+50 Z+0*\nN3 G00 G40 G90 Z+50*\n{body}N99999999 %A {unit} *\n");
        let program = read("part.i", &text);
        prop_assert_eq!(program.errors().count(), 0, "{}", text);
        let lowered = to_klartext(&program, &codes, None);
        // G90 and G91 may be drawn side by side.
        let refused = lowered.diagnostics.iter().find(|finding| finding.code != "syntax-excluding-codes");
        prop_assert!(refused.is_none(), "{}\n{:?}", text, lowered.diagnostics);
        prop_assert_eq!(lowered.program.errors().count(), 0, "{}\n{}", text, lowered.program.source().text());
        let (iso, back) = by_way_of_iso(&codes, &lowered.program).expect("nothing is refused");
        let differences = data.differences("tnc640", &lowered.program, &back);
        prop_assert!(differences.is_empty(), "{}\n{}\n{}\n{:#?}", text, iso, back.source().text(), differences);
        let again = to_iso(&back, &codes);
        prop_assert_eq!(again.text, iso);
    }

    /// Any text is told in Klartext without a hitch.
    #[test]
    fn any_text_is_told(lines in proptest::collection::vec(proptest::sample::select(vec![
        "%A G71 *", "N10 G01 X+5 F100*", "G91", "G12 H", "G02 X+5 I+3", "G05 X1", "T5", "L1,5", "G98 L2", "D00 Q1 P01", "D09 P01 1 P02 2 P03 3",
        "G200 Q200=", "Q201=-5 ;DEPTH", "G83 P01 2", "G28", "G73 H", "G37 P01 1 P03 2", "( a", "G26 R5", "* - x", "~", "é", "N5 /G1", "M3", "S5 X1",
        "G55 P01 5 P02 X-", "G79:G01", "%:TAB:\"A\"", "%X", "G04", "G00 F5", "X1 ; c", "\"", "D16 x", "D18 Q1 ID5", "G30 X1", "G31 X1",
    ]), 0..12)) {
        let data = Data::shared();
        let codes = Codes::new(data.catalogue);
        let text = lines.join("\n");
        let lowered = to_klartext(&read("part.i", &text), &codes, None);
        for block in lowered.program.blocks() {
            let home = lowered.home(block.span);
            prop_assert!(text.get(home.start..home.end).is_some());
        }
        for finding in &lowered.diagnostics {
            let span = finding.place.as_ref().expect("a place").span;
            prop_assert!(text.get(span.start..span.end).is_some());
        }
        let _ = to_iso(&lowered.program, &codes);
    }
}
