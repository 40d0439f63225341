//! The logs of the cycles that write one, as a whole: every line of every log that an example writes, in all languages.
//!
//! `tests/logs/<cycle>.txt` holds them; `UPDATE=1 cargo test --test suite logs` writes them anew, `git diff` shows what changed. What
//! stands there was compared with the values of the example and with the layout that the manuals print for cycle 421
//! (000:4556-4585, 001:12512-12558, 003:1669-1692) and for 423 (003:2628); the laws below hold each line to it.
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::PathBuf;
use std::sync::OnceLock;

use ciklo::base::diag::Source;
use ciklo::engine::run::Engine;
use ciklo::engine::scene::Scene;
use ciklo::language::locale::Locales;
use ciklo::program::syntax;
use ciklo::spec::Catalogue;
use ciklo::tools::conform::{self, LogTexts, Partner, Selection, Silence, World};
use serde_json::Value;

struct Data {
    files: ciklo::base::data::Files,
    catalogue: &'static Catalogue,
    locales: &'static Locales,
}

fn data() -> &'static Data {
    static DATA: OnceLock<Data> = OnceLock::new();
    DATA.get_or_init(|| {
        let files = ciklo::base::data::embedded();
        let catalogue = &crate::built::built().catalogue;
        let locales = &*crate::built::built().locales;
        Data { files, catalogue, locales }
    })
}

const LANGUAGES: [&str; 5] = ["en", "fi", "sl", "it", "pt"];

/// All that a program writes into files and shows on the screen.
fn logs(control: &str, language: &str, program: &str, scene: &str) -> Vec<(String, String)> {
    let data = data();
    let on = data.catalogue.on(control).expect("a control");
    let Ok(scene) = Scene::parse(&Source::new("scene.yaml", scene), &data.files) else { return Vec::new() };
    let texts = LogTexts::new(data.locales.language(language).expect("a language"), control, &data.files);
    let tree = syntax::parse(&Source::new("LOG.H", program));
    let engine = Engine::new(&tree, on, &scene, &texts).with_catalogue(data.catalogue);
    let outcome = engine.run(&mut |_| {});
    let screens = outcome.screens.into_iter().map(|text| ("screen".to_owned(), text));
    // A file of digitized data is a program.
    let logs = outcome.logs.into_iter().filter(|(_, text)| !text.starts_with("0 BEGIN PGM"));
    logs.chain(screens).collect()
}

/// A log of an example: control, case, where it goes, and its text by language.
struct Written {
    control: String,
    case: String,
    to: String,
    texts: BTreeMap<&'static str, String>,
}

/// The logs of all examples, by cycle.
#[derive(Default)]
struct Writing(BTreeMap<String, Vec<Written>>);

impl Partner for Writing {
    fn ask(&mut self, line: &str) -> Result<String, Silence> {
        let answer = conform::serve(&world(), line);
        let request: Value = serde_json::from_str(line).expect("a request");
        if request["cycle"]["keyword"] != "TCH PROBE" {
            return Ok(answer);
        }
        let text = |name: &str| request[name].as_str().unwrap_or_default().to_owned();
        let (control, case, scene) = (text("control"), text("case"), request["scene"].to_string());
        // Worked programs have logs of several cycles.
        let on = data().catalogue.on(&control).expect("a control");
        if on.worked.iter().any(|worked| worked.name() == case) {
            return Ok(answer);
        }
        let in_language = |language| logs(&control, language, &text("program"), &scene);
        let first = in_language(LANGUAGES[0]);
        for (index, (to, english)) in first.into_iter().enumerate() {
            let mut texts = BTreeMap::from([(LANGUAGES[0], english)]);
            for language in &LANGUAGES[1..] {
                texts.insert(language, in_language(language).swap_remove(index).1);
            }
            let written = Written { control: control.clone(), case: case.clone(), to, texts };
            self.0.entry(request["cycle"]["number"].to_string()).or_default().push(written);
        }
        Ok(answer)
    }
}

fn world() -> World<'static> {
    let data = data();
    World { catalogue: data.catalogue, locales: data.locales, files: &data.files }
}

fn written() -> &'static BTreeMap<String, Vec<Written>> {
    static WRITTEN: OnceLock<BTreeMap<String, Vec<Written>>> = OnceLock::new();
    WRITTEN.get_or_init(|| {
        let mut writing = Writing::default();
        let (report, _) = conform::run_foreign(&world(), &Selection::default(), &mut writing);
        assert!(report.cases.len() > 900);
        writing.0
    })
}

/// The manuals: every cycle that measures a workpiece by itself, apart from 0 and 1, can write a log (001:12498, 000:4544,
/// 003:1658), by Q281; 444 always does (004:80-88), and so do those of the kinematics (001:14104-14130, 14455-14476). Nothing speaks of a log of the datum, rotation and calibration cycles.
const CYCLES: [&str; 14] =
    ["420", "421", "422", "423", "424", "425", "426", "427", "430", "431", "444", "450", "451", "452"];

/// Those that always write a file, and nothing on the screen.
const ALWAYS: [&str; 4] = ["444", "450", "451", "452"];

#[test]
fn the_cycles_that_the_manuals_name_write_logs() {
    let found: BTreeSet<&str> = written().keys().map(String::as_str).collect();
    assert_eq!(found, BTreeSet::from(CYCLES));
    let data = data();
    for (cycle, logs) in written() {
        let described = data.catalogue.controls.values().filter(|on| {
            on.cycles.keys().any(|key| key.to_string() == format!("TCH PROBE {cycle}"))
                && on.cycles.values().any(|known| known.key.number.to_string() == *cycle)
        });
        for on in described {
            let own: Vec<&Written> = logs.iter().filter(|log| log.control == on.id()).collect();
            assert!(own.iter().any(|log| log.to != "screen"), "{cycle} on {} writes no file", on.id());
            // The oldest control knows no log on the screen.
            let screen = !ALWAYS.contains(&cycle.as_str()) && on.id() != "tnc426-430";
            assert_eq!(own.iter().any(|log| log.to == "screen"), screen, "{cycle} on {}", on.id());
            let ending = if cycle == "444" { "html" } else { "TXT" };
            let files = own.iter().filter(|log| log.to != "screen");
            assert!(files.clone().all(|log| log.to == format!("TCHPR{cycle}.{ending}")), "{cycle}");
        }
    }
}

#[test]
fn a_log_whose_template_has_no_end_ends_the_run() {
    const PROGRAM: &str = "BEGIN PGM L MM\nTOOL CALL 1 Z S100\nTCH PROBE 421 MEASURE HOLE\nQ273=+0\nQ274=+0\nQ262=40\n\
        Q325=+0\nQ247=+90\nQ261=-5\nQ320=0\nQ260=+20\nQ301=0\nQ275=0\nQ276=0\nQ279=0\nQ280=0\nQ281=1\nQ309=0\n\
        Q330=0\nQ423=4\nQ365=1\nEND PGM L MM\n";
    const SCENE: &str = "scene: 1\ntools: [{T: 1, L: 100, R: 2, TP_NO: 1}]\nprobe: {NO: 1, ball_radius: 2}\nparts:\n  \
        - solid:\n      difference:\n        - box: {min: [-50, -50, -20], max: [50, 50, 0]}\n        \
        - cylinder: {axis: Z, diameter: 40, from: 0, to: -20}\n";
    let data = data();
    let on = data.catalogue.on("tnc640").expect("a control");
    let scene = Scene::parse(&Source::new("scene.yaml", SCENE), &data.files).expect("a scene");
    let tree = syntax::parse(&Source::new("LOG.H", PROGRAM));
    let ended = |files: &ciklo::base::data::Files| {
        let texts = LogTexts::new(data.locales.language("en").expect("a language"), "tnc640", files);
        Engine::new(&tree, on, &scene, &texts).run(&mut |_| {}).fault.map(|fault| fault.code)
    };
    assert_eq!(ended(&data.files), None);
    let mut endless = data.files.clone();
    for (_, text) in endless.iter_mut().filter(|(path, _)| path.starts_with("templates/logs/")) {
        text.insert_str(0, "{% for i in range(100000) %}{% for j in range(100000) %}{% endfor %}{% endfor %}");
    }
    assert_eq!(ended(&endless).as_deref(), Some("log-failed"));
}

/// Whole logs, line by line.
#[test]
fn logs_are_the_stored_ones() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/logs");
    let update = std::env::var_os("UPDATE").is_some();
    let mut wrong = Vec::new();
    for (cycle, logs) in written() {
        let mut text = String::new();
        let mut seen = BTreeSet::new();
        for log in logs {
            for (language, log_text) in &log.texts {
                // What another control or case writes the same is not kept again.
                if seen.insert((*language, log_text.as_str())) {
                    let _ = write!(text, "=== {} {} {language} {}\n{log_text}", log.control, log.case, log.to);
                }
            }
        }
        let path = folder.join(format!("{cycle}.txt"));
        if update {
            std::fs::create_dir_all(&folder).expect("a folder");
            std::fs::write(&path, &text).expect("written");
        }
        let stored = std::fs::read_to_string(&path).unwrap_or_default();
        for (number, (stored, found)) in (1..).zip(stored.lines().zip(text.lines())) {
            if stored != found {
                wrong.push(format!("{}:{number}: {stored}\n  is now {found}", path.display()));
                break;
            }
        }
        if stored.lines().count() != text.lines().count() {
            wrong.push(format!("{}: {} lines, not {}", path.display(), text.lines().count(), stored.lines().count()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The numbers with four decimals in a line.
fn numbers(line: &str) -> Vec<&str> {
    let number = |word: &&str| {
        let digits = word.trim_start_matches('-');
        digits.split_once('.').is_some_and(|(whole, rest)| {
            rest.len() == 4 && whole.bytes().chain(rest.bytes()).all(|byte| byte.is_ascii_digit())
        })
    };
    line.split(|c: char| c.is_whitespace() || c == '<' || c == '>').filter(number).collect()
}

/// In every language the same lines stand in the same order with the same numbers, and each value has words before it.
#[test]
fn languages_have_the_same_lines_with_the_same_values() {
    for (cycle, logs) in written() {
        for log in logs {
            let english: Vec<&str> = log.texts["en"].lines().collect();
            for (language, text) in &log.texts {
                let lines: Vec<&str> = text.lines().collect();
                assert_eq!(lines.len(), english.len(), "{cycle} {} {language}", log.case);
                for (line, same) in lines.iter().zip(&english) {
                    assert_eq!(numbers(line), numbers(same), "{cycle} {} {language}: {line}", log.case);
                    assert_eq!(line.is_empty(), same.is_empty(), "{cycle} {} {language}: {line}", log.case);
                    let valued = log.to.ends_with("TXT") && !numbers(line).is_empty();
                    assert!(!valued || line.contains(": "), "{cycle} {} {language}: {line}", log.case);
                }
                assert!(
                    !text.split_whitespace().any(|word| ["NaN", "inf", "-inf"].contains(&word)),
                    "{cycle} {}",
                    log.case
                );
            }
        }
    }
}

/// The values of the printed logs, line by line in the printed order: 421 (001:12522-12556) and 423 (003:2628, where the
/// coordinate of the first centre is lost and the length of the second side has another limit than in the program before it).
#[test]
fn printed_values_stand_in_the_printed_order() {
    let hole = "50.0000 65.0000 12.0000 50.1000 49.9000 65.1000 64.9000 12.0450 12.0000 50.0810 64.9530 12.0259 0.0810 -0.0470 0.0259 -5.0000";
    let pocket = "50.0000 40.0000 90.0000 70.0000 50.1500 49.8500 40.1000 39.9000 90.1500 89.9500 70.1000 69.9000 50.0905 39.9347 90.1200 69.9920 0.0905 -0.0653 0.1200 -0.0080 -5.0000";
    for (cycle, case, printed) in [("421", "printed-log", hole), ("423", "worked-program", pocket)] {
        let logs: Vec<&Written> = written()[cycle].iter().filter(|log| log.case == case).collect();
        assert!(!logs.is_empty());
        for (language, text) in logs.iter().flat_map(|log| &log.texts) {
            assert_eq!(text.lines().flat_map(numbers).collect::<Vec<_>>().join(" "), printed, "{cycle} {language}");
        }
    }
}

/// The order of the printed example: title, date, time, program, nominal values, limits, actual values, deviations, further
/// results, end; an empty line between them. What a cycle has no values for is left out.
#[test]
fn logs_have_the_printed_layout() {
    let language = data().locales.language("en").expect("English");
    let word = |id: &str| {
        let scope = ciklo::language::locale::Scope::NONE;
        language.text(id, &scope, &ciklo::language::locale::Args::new()).expect("a text").into_owned()
    };
    let order = [
        "log-date",
        "log-time",
        "log-program",
        "log-nominal-values",
        "log-limits",
        "log-actual-values",
        "log-deviations",
        "log-further-results",
        "log-end",
    ];
    let words = order.map(word);
    for (cycle, logs) in written().iter().filter(|(cycle, _)| !ALWAYS.contains(&cycle.as_str())) {
        for log in logs {
            let lines: Vec<&str> = log.texts["en"].lines().collect();
            let places: Vec<Option<usize>> =
                words.iter().map(|word| lines.iter().position(|line| line.starts_with(word.as_str()))).collect();
            let found: Vec<usize> = places.iter().copied().flatten().collect();
            assert!(found.is_sorted(), "{cycle} {}: {places:?}", log.case);
            assert_eq!(&places[..3], &[Some(2), Some(3), Some(4)], "{cycle}: the head");
            assert!(places[5].is_some() && places[8] == Some(lines.len() - 1), "{cycle} {}", log.case);
            // Each part but those of the head begins behind an empty line.
            for place in found.iter().skip(3) {
                assert!(lines[place - 1].is_empty(), "{cycle} {}: line {place}", log.case);
            }
            if ["421", "422", "423", "424", "430"].contains(&cycle.as_str()) {
                assert!(places.iter().all(Option::is_some), "{cycle} {}: {places:?}", log.case);
            }
        }
    }
}
