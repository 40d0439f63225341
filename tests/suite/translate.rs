//! Programs in other languages: only names and labels change, and they come back.
use std::path::Path;
use std::{env, fs};

use ciklo::base::diag::{Arg, Diagnostic, Severity, Source};
use ciklo::check::{Against, LabelBook};
use ciklo::language::locale::{Locales, Scope};
use ciklo::program::syntax::encoding::{Charset, Encoding, decode_as};
use ciklo::program::syntax::parse;
use ciklo::spec::Catalogue;
use ciklo::tools::translate::{Translation, translate};
use proptest::prelude::*;

const UTF_8: Encoding = Encoding { charset: Charset::Utf8, bom: false };
const WINDOWS_1252: Encoding = Encoding { charset: Charset::Windows1252, bom: false };

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

    fn translate(&self, control: &str, text: &str, to: &str, encoding: Encoding) -> Translation {
        let on = self.catalogue.on(control).expect("the control");
        let labels = LabelBook::new(on, self.locales);
        let against =
            Against { catalogue: self.catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
        translate(&parse(&Source::new("program.h", text)), &against, to, encoding)
    }

    /// The languages that have texts for the cycles.
    fn languages(&self) -> Vec<&str> {
        let speaks = |tag: &&str| {
            self.locales.language(tag).is_ok_and(|language| language.has("cycle-drilling.nc", &Scope::NONE))
        };
        self.locales.tags().filter(speaks).collect()
    }
}

/// The printed blocks with their controls and languages.
fn printed() -> Vec<(String, String, String)> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/printed");
    let mut paths: Vec<_> = fs::read_dir(directory).expect("the blocks").map(|e| e.expect("an entry").path()).collect();
    paths.sort();
    let read = |path: &Path| {
        let text = fs::read_to_string(path).expect("a block");
        let (head, body) = text.split_once('\n').expect("a head");
        let word =
            |key: &str| head.split(key).nth(1).and_then(|rest| rest.split_whitespace().next()).map(str::to_owned);
        (word("control:").expect("a control"), word("lang:").expect("a language"), body.to_owned())
    };
    paths.iter().map(|path| read(path)).collect()
}

/// Everything but the replaced places is the same.
fn assert_else_unchanged(old: &str, translation: &Translation) {
    let (mut from, mut to) = (0, 0);
    for change in &translation.changes {
        let same = &old[from..change.span.start];
        assert!(translation.text[to..].starts_with(same));
        assert_eq!(&old[change.span.start..change.span.end], change.from);
        to += same.len();
        assert!(translation.text[to..].starts_with(&change.to));
        to += change.to.len();
        from = change.span.end;
    }
    assert_eq!(&old[from..], &translation.text[to..]);
}

#[test]
fn printed_blocks_come_back_from_every_language() {
    let data = Data::new();
    let languages = data.languages();
    for (control, language, text) in printed() {
        if !languages.contains(&language.as_str()) {
            continue;
        }
        // Printed variants of a label become the label.
        let canonical = data.translate(&control, &text, &language, UTF_8).text;
        let mut now = canonical.clone();
        for to in languages.iter().chain([&language.as_str()]) {
            let translation = data.translate(&control, &now, to, UTF_8);
            let wrong = |own: &Diagnostic| own.severity != Severity::Note;
            assert!(!translation.diagnostics.iter().any(wrong), "{control} {to} {:?}", translation.diagnostics);
            assert_else_unchanged(&now, &translation);
            now = translation.text;
        }
        assert_eq!(now, canonical, "{control} {language}");
    }
}

#[test]
fn only_names_labels_and_printed_words_change() {
    let data = Data::new();
    let text = "\u{a0}7 CYCL DEF 200 VRTANJE ~\r\n\tQ200 = +2\t;  VARNOSTNA RAZDALJA\tremark ~\r\n  Q201=-15 ~ ;globina\r\n  \
                Q999=1 ;GLOBINA ~\r\n  Q202=5 ;OF MY OWN\r\n8 TCH PROBE 31.0 DOLŽINA ORODJA\r\n9 TCH PROBE 31.1 PREVERJANJE: 0 Q5\r\n\
                10 TCH PROBE 31.2 VIŠINA: +120 ; VIŠINA:\r\n; GLOBINA\r\nL X+5\r\n";
    let translation = data.translate("tnc640", text, "en", UTF_8);
    assert_else_unchanged(text, &translation);
    let changes: Vec<_> = translation.changes.iter().map(|change| (change.from.as_str(), change.to.as_str())).collect();
    assert_eq!(
        changes,
        [
            ("VRTANJE", "DRILLING"),
            ("VARNOSTNA RAZDALJA", "SET-UP CLEARANCE"),
            ("globina", "DEPTH"),
            ("DOLŽINA ORODJA", "TOOL LENGTH"),
            ("PREVERJANJE:", "CHECK:"),
            ("VIŠINA:", "HEIGHT:"),
        ]
    );
}

#[test]
fn a_label_that_the_file_cannot_write_stays() {
    let data = Data::new();
    let text = "1 CYCL DEF 200 DRILLING\nQ201=-15 ;DEPTH\nQ203=+0 ;SURFACE COORDINATE\n";
    let translation = data.translate("tnc640", text, "sl", WINDOWS_1252);
    // `š` is in Windows-1252, `Č` is not.
    assert_eq!(translation.text, "1 CYCL DEF 200 VRTANJE\nQ201=-15 ;GLOBINA\nQ203=+0 ;KOOR. POVRŠINE\n");
    let dwell = data.translate("tnc640", "1 CYCL DEF 200\nQ211=0.1 ;DWELL TIME AT DEPTH\n", "sl", WINDOWS_1252);
    assert_eq!(dwell.text, "1 CYCL DEF 200\nQ211=0.1 ;DWELL TIME AT DEPTH\n");
    let codes: Vec<_> = dwell.diagnostics.iter().map(|diagnostic| diagnostic.code).collect();
    assert_eq!(codes, ["label-not-encodable"]);
}

#[test]
fn labels_that_stay_among_others_are_counted() {
    let data = Data::new();
    let text =
        "1 CYCL DEF 200 DRILLING\nQ200=2 ;SET-UP CLEARANCE\nQ201=-15 ;HOW DEEP\nQ206=150 ;HOW FAST\nQ202=5 ;my own\n";
    let translation = data.translate("tnc640", text, "it", UTF_8);
    let codes: Vec<_> = translation.diagnostics.iter().map(|own| (own.code, own.severity.as_str())).collect();
    assert_eq!(codes, [("labels-not-known", "note")]);
    assert!(matches!(translation.diagnostics[0].get("count"), Some(Arg::Number(count)) if *count == 2.0));
}

#[test]
fn a_definition_that_cannot_be_read_stays() {
    let data = Data::new();
    let text = "0 CYCL DEF 200 DRILLING\nQ200=2 ;SET-UP CLEARANCE\nQ206=1e5 ;X\n";
    let translation = data.translate("tnc640", text, "it", UTF_8);
    assert_eq!(translation.text, text);
    assert_eq!(translation.diagnostics.iter().map(|own| own.code).collect::<Vec<_>>(), ["translate-unread"]);
}

#[test]
fn a_foreign_definition_with_one_label_and_small_letters_is_read_by_numbers() {
    let data = Data::new();
    let text = "1 CYCL DEF 247 INIT. PT DE REF. ~\n  Q339=+15 ;NUMERO POINT DE REF.\n2 CYCL DEF 200 PERCAGE ~\n\
                Q200=2 ;DISTANCE D'APPROCHE ~\nQ201=-20 ;PROFONDEUR ~\nQ206=150 ;AVANCE PLONGEE PROF. ~\n\
                Q204=50 ;2eme DISTANCE D'APPROCHE\n";
    let translation = data.translate("tnc640", text, "en", UTF_8);
    let changed: Vec<_> = translation.changes.iter().map(|change| change.from.as_str()).collect();
    for own in ["INIT. PT DE REF.", "NUMERO POINT DE REF.", "PERCAGE", "PROFONDEUR", "2eme DISTANCE D'APPROCHE"] {
        assert!(changed.contains(&own), "{own} stays: {changed:?}");
    }
}

#[test]
fn code_pages_are_alike_where_a_text_has_the_same_bytes() {
    let alike = |text: &str| WINDOWS_1252.alike(text).map(|own| own.charset).collect::<Vec<_>>();
    assert!(alike("L X+5 ; 5° größer").contains(&Charset::Windows1250));
    assert!(alike("; père").is_empty());
    let bytes = [b';', 0xE8];
    assert_eq!(decode_as(&bytes, Charset::Windows1250).map(|own| own.text).as_deref(), Some(";č"));
    assert!(decode_as(&bytes, Charset::Utf8).is_none());
}

#[test]
fn a_parameter_of_newer_software_keeps_no_language_from_being_foreign() {
    let data = Data::new();
    let text = "1 CYCL DEF 200 TALADRADO ~\nQ200=+2 ;DISTANCIA SEGURIDAD ~\nQ201=-20 ;PROFUNDIDAD ~\nQ206=+150 ;AVANCE PROFUNDIDAD ~\n\
                Q202=+5 ;PASO PROFUNDIZACION ~\nQ210=0 ;TIEMPO ESPERA ARRIBA ~\n\
                Q204=50 ;2A DIST. SEGURIDAD ~\nQ211=0 ;TIEMPO ESPERA ABAJO ~\nQ203=+0 ;COORD. SUPERFICIE ~\nQ395=+0 ;REFERENCIA PROFUND.\n";
    let translation = data.translate("tnc640", text, "en", UTF_8);
    let changed: Vec<_> = translation.changes.iter().map(|change| change.to.as_str()).collect();
    assert!(changed.contains(&"DRILLING") && changed.contains(&"SURFACE COORDINATE"), "{changed:?}");
    assert!(translation.text.ends_with(";REFERENCIA PROFUND.\n"), "what the cycle does not have stays");
}

#[test]
fn a_language_without_texts_changes_nothing() {
    let data = Data::new();
    let text = "1 CYCL DEF 200 VRTANJE\nQ201=-15 ;GLOBINA\n";
    let translation = data.translate("tnc640", text, "xx", UTF_8);
    assert_eq!(translation.text, text);
    assert!(translation.diagnostics.iter().all(|diagnostic| diagnostic.code == "label-missing"));
    assert_eq!(translation.diagnostics.len(), 2);
}

/// Printed blocks one behind the other, each in one of the layouts that programs have.
fn laid_out(data: &Data, which: &[(usize, usize)], eol: &str) -> String {
    let languages = data.languages();
    let mine = |language: &String| languages.contains(&language.as_str());
    let blocks: Vec<_> =
        printed().into_iter().filter(|(control, language, _)| control == "tnc640" && mine(language)).collect();
    let mut text = String::new();
    for (index, layout) in which {
        let (_, _, body) = &blocks[index % blocks.len()];
        let lines: Vec<&str> = body.lines().collect();
        for (at, line) in lines.iter().enumerate() {
            let last = at + 1 == lines.len();
            let numbered = line.starts_with(|c: char| c.is_ascii_digit());
            text.push_str(match layout {
                1 if !numbered => "    ",
                2 => "\t",
                _ => "",
            });
            text.push_str(&if *layout == 3 { line.replace(" ;", "\t; ") } else { (*line).to_owned() });
            text.push_str(if *layout == 4 && !last && line.contains(';') { " ~" } else { "" });
            text.push_str(eol);
        }
        text.push_str("L X+10 FMAX M99 ; GLOBINA");
        text.push_str(eol);
    }
    text
}

thread_local! {
    /// Loaded once for all cases.
    static DATA: Data = Data::new();
}

laws! {
    #![proptest_config(crate::cases::config(48))]

    /// However a program is laid out, it comes back from any chain of languages.
    #[test]
    fn programs_come_back(
        which in proptest::collection::vec((0..1000_usize, 0..5_usize), 1..4),
        eol in prop_oneof![Just("\n"), Just("\r\n"), Just("\r")],
        order in proptest::collection::vec(0..5_usize, 1..4),
    ) {
        let (now, canonical) = DATA.with(|data| {
            let text = laid_out(data, &which, eol);
            let languages = data.languages();
            let home = "sl";
            let canonical = data.translate("tnc640", &text, home, UTF_8).text;
            let mut now = canonical.clone();
            for step in order.into_iter().map(|index| languages[index % languages.len()]).chain([home]) {
                let translation = data.translate("tnc640", &now, step, UTF_8);
                assert_else_unchanged(&now, &translation);
                now = translation.text;
            }
            (now, canonical)
        });
        prop_assert_eq!(now, canonical);
    }
}

/// Labels in a language that has no locale are known by their form, other comments stay.
#[test]
fn unknown_labels_are_replaced_when_asked_for() {
    let data = Data::new();
    let german = "\
2 CYCL DEF 200 BOHREN ~
  Q200=2 ;SICHERHEITS-ABST. ~
  Q201=-15 ;TIEFE ~
  Q206=250 ;Vorschub langsam ~
  Q202=5 ;DEPTH ~
  Q5=1 ;UNBEKANNT
3 L X+10 ;TIEFE
";
    let english = "\
2 CYCL DEF 200 DRILLING ~
  Q200=2 ;SET-UP CLEARANCE ~
  Q201=-15 ;DEPTH ~
  Q206=250 ;Vorschub langsam ~
  Q202=5 ;DEPTH ~
  Q5=1 ;UNBEKANNT
3 L X+10 ;TIEFE
";
    let on = data.catalogue.on("tnc640").expect("the control");
    let labels = LabelBook::new(on, data.locales);
    let against =
        Against { catalogue: data.catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
    let program = parse(&Source::new("program.h", german));
    let translation = ciklo::tools::translate::relabel(&program, &against, "en", UTF_8);
    assert_else_unchanged(german, &translation);
    assert_eq!(translation.text, english);
    // Without being asked, only what is known to be a label changes.
    assert_eq!(data.translate("tnc640", german, "en", UTF_8).text, german);
}

/// A definition that a control wrote in another language is read by its numbers; what a programmer wrote stays.
#[test]
fn definitions_in_a_language_that_is_not_known_are_read_by_their_numbers() {
    let data = Data::new();
    let german = "\
1 CYCL DEF 7.0 NULLPUNKT
2 CYCL DEF 7.1 X+10
3 CYCL DEF 200 BOHREN ~
  Q200=2 ;SICHERHEITS-ABST. ~
  Q201=-15 ;TIEFE ~
  Q206=250 ;VORSCHUB TIEFENZ. ~
  Q202=5 ;ZUSTELL-TIEFE ~
  Q210=0 ;VERWEILZEIT OBEN ~
  Q203=+0 ;KOOR. OBERFLAECHE ~
  Q204=50 ;2. SICHERHEITS-ABST. ~
  Q211=0.1 ;unten warten
4 CYCL DEF 200 DRILLING ~
  Q200=2 ;ABSTAND ~
  Q201=-15 ;DEPTH
5 CYCL DEF 200 ~
  Q200=2 ~
  Q201=-15 ;TIEFES LOCH ~
  Q206=250
6 L X+10 ;TIEFE
";
    let english = "\
1 CYCL DEF 7.0 DATUM SHIFT
2 CYCL DEF 7.1 X+10
3 CYCL DEF 200 DRILLING ~
  Q200=2 ;SET-UP CLEARANCE ~
  Q201=-15 ;DEPTH ~
  Q206=250 ;FEED RATE FOR PLNGNG ~
  Q202=5 ;PLUNGING DEPTH ~
  Q210=0 ;DWELL TIME AT TOP ~
  Q203=+0 ;SURFACE COORDINATE ~
  Q204=50 ;2ND SET-UP CLEARANCE ~
  Q211=0.1 ;unten warten
4 CYCL DEF 200 DRILLING ~
  Q200=2 ;ABSTAND ~
  Q201=-15 ;DEPTH
5 CYCL DEF 200 ~
  Q200=2 ~
  Q201=-15 ;TIEFES LOCH ~
  Q206=250
6 L X+10 ;TIEFE
";
    let translation = data.translate("tnc640", german, "en", UTF_8);
    assert_else_unchanged(german, &translation);
    assert_eq!(translation.text, english);
    let told: Vec<_> =
        translation.diagnostics.iter().map(|own| (own.code, own.place.as_ref().map(|p| p.start().line))).collect();
    assert_eq!(told, [("labels-not-known", Some(13)), ("labels-of-unknown-language", Some(1))]);
    assert_eq!(translation.sources.into_iter().collect::<Vec<_>>(), [("en".to_owned(), 1)]);
}

/// With a language given, what is in another one stays.
#[test]
fn only_labels_of_the_language_that_is_given_are_replaced() {
    let data = Data::new();
    let mixed = "1 CYCL DEF 200 VRTANJE\nQ201=-15 ;GLOBINA\n2 CYCL DEF 201 REAMING\nQ201=-5 ;DEPTH\n";
    let whole = data.translate("tnc640", mixed, "it", UTF_8);
    assert_eq!(whole.changes.len(), 4, "{:?}", whole.changes);
    assert_eq!(whole.sources.into_iter().collect::<Vec<_>>(), [("en".to_owned(), 1), ("sl".to_owned(), 1)]);
    let on = data.catalogue.on("tnc640").expect("the control");
    let labels = LabelBook::new(on, data.locales);
    let against =
        Against { catalogue: data.catalogue, on, labels: &labels, language: Some("sl"), software: None, readers: &[] };
    let one = translate(&parse(&Source::new("program.h", mixed)), &against, "it", UTF_8);
    assert_eq!(one.changes.iter().map(|change| change.from.as_str()).collect::<Vec<_>>(), ["VRTANJE", "GLOBINA"]);
}

#[test]
fn a_name_that_a_parameter_follows_closed_up_is_left_alone() {
    // The mark between them would go with the name, and the parameter would become a part of the new one.
    let text = "0 BEGIN PGM A MM\n1 CYCL DEF 200 DRILLING[Q200=2 ;SET-UP CLEARANCE\nQ201=-15 ;DEPTH\n2 END PGM A MM\n";
    let there = Data::new().translate("tnc640", text, "fi", UTF_8).text;
    assert!(there.contains("DRILLING[Q200=2 ;"), "{there}");
    assert!(there.contains("Q201=-15 ;SYVYYS"), "{there}");
}

/// The axis of an angle stands before the word or behind it (000: 6755, 001: 13733): the colon stays where it stands.
#[test]
fn an_axis_between_a_label_and_its_colon_stays_there() {
    let data = Data::new();
    let first = "0 BEGIN PGM A MM\n1 TCH PROBE 3.0 MERJENJE\n2 TCH PROBE 3.1 Q5\n3 TCH PROBE 3.2 KOT X: +15\n\
                 4 TCH PROBE 3.3 ABST +10 F100 MB1 REFERENČNI SISTEM:0\n5 TCH PROBE 3.4 ERRORMODE1\n6 END PGM A MM\n";
    for (word, to) in [("KULMA", "fi"), ("ANGOLO", "it"), ("ÂNGULO", "pt"), ("ANGLE", "en")] {
        let there = data.translate("tnc640", first, to, UTF_8).text;
        assert!(there.contains(&format!("TCH PROBE 3.2 {word} X: +15\n")), "{there}");
        assert_eq!(data.translate("tnc640", &there, "sl", UTF_8).text, first);
        let before = first.replace("KOT X:", "X KOT:");
        assert!(data.translate("tnc640", &before, to, UTF_8).text.contains(&format!("X {word}: +15\n")));
    }
}
