//! German as a fifth translation for a family of cycles, from the file for translators to dialogs, blocks and pages.
//! `tests/texts/german.txt` is what a translator writes into the units of cycles 200, 201, 203 and 410.
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Mutex;

use ciklo::base::data::Files;
use ciklo::base::diag::Source;
use ciklo::check::{Against, LabelBook};
use ciklo::language::label;
use ciklo::language::locale::{Locales, Meanings, Scope};
use ciklo::output::dialog;
use ciklo::output::manual::{self, Request, Site};
use ciklo::program::syntax::encoding::{Charset, Encoding};
use ciklo::program::syntax::parse;
use ciklo::spec::{self, Catalogue, Cycle, OnControl};
use ciklo::tools::exchange::{self, Form};

use crate::built::built;

const TRANSLATED: &str = include_str!("../texts/german.txt");
const UTF_8: Encoding = Encoding { charset: Charset::Utf8, bom: false };
/// The cycles that the translator was asked for.
const FAMILY: [u32; 4] = [200, 201, 203, 410];

/// The units that a translator has filled in, by identifier.
fn translated() -> BTreeMap<&'static str, &'static str> {
    TRANSLATED.lines().filter(|line| !line.starts_with('#')).filter_map(|line| line.split_once('\t')).collect()
}

fn family(catalogue: &Catalogue) -> impl Iterator<Item = (&OnControl, &Cycle)> {
    let all = catalogue.controls.values().flat_map(|on| on.cycles.values().map(move |cycle| (on, cycle)));
    all.filter(|(_, cycle)| FAMILY.contains(&cycle.key.number))
}

fn between<'t>(text: &'t str, begin: &str, end: &str) -> &'t str {
    text.split_once(begin).and_then(|(_, rest)| rest.split_once(end)).map_or("", |(inside, _)| inside)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// A unit of XLIFF with the translator's words; codes are those of its source, as a translation tool copies them.
fn filled(unit: &str, words: &str) -> String {
    let source = between(unit, "<source>", "</source>");
    let mut target = escaped(words);
    let mut rest = source;
    while let Some((_, code)) = rest.split_once("<ph ") {
        let (element, after) = code.split_once("</ph>").expect("the element is closed");
        let native = element.split_once('>').expect("it has native data").1;
        target = target.replace(native, &format!("<ph {element}</ph>").replace('{', "\u{1}").replace('}', "\u{2}"));
        rest = after;
    }
    let target = target.replace('\u{1}', "{").replace('\u{2}', "}");
    unit.replace("</source>", &format!("</source>\n        <target state=\"final\">{target}</target>"))
}

/// The export of the family, as it comes back.
fn returned(locales: &Locales, catalogue: &Catalogue) -> (String, usize) {
    let used: BTreeSet<String> =
        family(catalogue).flat_map(|(on, cycle)| spec::texts(cycle, on)).map(|text| text.id).collect();
    let words = translated();
    let mut units = exchange::units(locales, &Meanings::new(), "de").unwrap();
    units.retain(|unit| used.contains(&unit.message));
    let exported = exchange::write(&units, "de", Form::Xliff);
    let mut whole = String::new();
    let mut count = 0;
    for part in exported.split_inclusive("</trans-unit>") {
        match words.get(between(part, "<trans-unit id=\"", "\"")) {
            Some(words) => {
                whole += &filled(part, words);
                count += 1;
            }
            None => whole += part,
        }
    }
    (whole, count)
}

/// The shipped data with the translation taken over.
fn with_german() -> (Files, Vec<String>) {
    let data = built();
    let (file, count) = returned(&data.locales, &data.catalogue);
    assert_eq!(count, translated().len(), "every line of the data has its unit in the export");
    let returned = exchange::read(&file).unwrap();
    assert_eq!(returned.language.as_deref(), Some("de"));
    let imported = exchange::import(&data.catalogue, &data.files, "de", returned.units).unwrap();
    assert!(imported.refused.is_empty(), "{:?}", imported.refused);
    assert_eq!(imported.taken.len(), count);
    let mut files = data.files.clone();
    files.extend(imported.files.iter().cloned());
    (files, imported.files.into_iter().map(|(path, _)| path).collect())
}

#[test]
fn a_family_of_cycles_reaches_its_readers_in_german() {
    let (files, paths) = with_german();
    assert!(paths.iter().all(|path| path.starts_with("locales/de/") && path.ends_with(".ftl")), "{paths:?}");
    // What is translated is whole: no text of the family is missing for any control, and labels obey the rules.
    let (catalogue, _) = Catalogue::load(&files);
    let (locales, found) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    assert!(found.is_empty(), "{found:?}");
    let german = locales.language("de").unwrap();
    for (on, cycle) in family(&catalogue) {
        let scope = Scope::new(cycle.name(), on.id());
        let missing = spec::texts(cycle, on).into_iter().map(|text| text.key());
        let missing: Vec<String> = missing.filter(|key| !german.has(key, &scope)).collect();
        assert!(missing.is_empty(), "{} on {}: {missing:?}", cycle.key, on.id());
    }
    assert!(label::check(&catalogue, &locales).is_empty(), "{:?}", label::check(&catalogue, &locales).first());

    let (draft, gaps) = exchange::draft(&files, "de").unwrap();
    assert!(gaps > 1000, "nearly everything else is missing: {gaps}");
    let (locales, found) = Locales::load(draft.iter().map(|(path, text)| (path, text)));
    assert!(found.is_empty(), "{:?}", found.first());
    let german = locales.language("de").unwrap();
    let on = catalogue.on("tnc640").expect("the control");

    // The dialog is in German, but for the words of the program around it.
    let drilling = on.by_name("drilling").unwrap();
    let shown = dialog::render(&dialog::dialog(on, drilling, german).unwrap(), german).unwrap();
    for words in ["Bohren", "Sicherheits-Abstand", "Vorschub Tiefenzustellung", "Verweilzeit unten"] {
        assert!(shown.contains(words), "{words} in {shown}");
    }
    assert!(!shown.contains("Depth") && !shown.contains("clearance"), "{shown}");

    // The block has the labels that programs from controls with German dialogs have.
    let block = label::block(on, drilling, german, &label::Request::default()).unwrap();
    let program = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cli/german.h")).unwrap();
    let labels = |text: &str| -> Vec<(String, String)> {
        let lines = text.lines().filter_map(|line| line.trim().trim_end_matches([' ', '~']).split_once(';'));
        let q = |line: &str| line.split('=').next().unwrap_or_default().trim().to_owned();
        lines.map(|(line, label)| (q(line), label.to_owned())).collect()
    };
    let known: BTreeMap<String, String> = labels(&program).into_iter().collect();
    let printed = labels(&block);
    assert!(printed.len() >= 8 && block.contains("CYCL DEF 200 BOHREN"), "{block}");
    for (q, label) in printed {
        assert_eq!(known.get(&q).unwrap_or(&label), &label, "{q} in {block}");
    }

    // A program with German labels is in a known language now.
    let book = LabelBook::new(on, &locales);
    let against = Against { catalogue: &catalogue, on, labels: &book, language: None, software: None, readers: &[] };
    let tree = parse(&Source::new("german.h", program.as_str()));
    let english = ciklo::tools::translate::relabel(&tree, &against, "en", UTF_8).text;
    assert!(english.contains("CYCL DEF 200 DRILLING") && english.contains(";SET-UP CLEARANCE"), "{english}");
    let tree = parse(&Source::new("english.h", english.as_str()));
    assert_eq!(ciklo::tools::translate::relabel(&tree, &against, "de", UTF_8).text, program, "and back");

    pages(&draft, &catalogue, &locales);
}

/// Pages have the German sentences; what is missing is marked, and every page says that it is a draft.
fn pages(files: &Files, catalogue: &Catalogue, locales: &Locales) {
    let made = Mutex::new(BTreeMap::new());
    let sink = |path: &str, bytes: &[u8]| {
        made.lock().expect("no thread panics").insert(path.to_owned(), bytes.to_vec());
        Ok(())
    };
    let (controls, languages) = (["tnc640".to_owned()], ["de".to_owned()]);
    let request = Request { catalogue, locales, files, controls: &controls, languages: &languages, base_url: None };
    let mut site = Site::new(&request).unwrap();
    site.mark_as_draft();
    site.write(&sink).unwrap_or_else(|faults| panic!("{:?}", faults.first()));
    let made = made.into_inner().expect("no thread panics");
    let on = catalogue.on("tnc640").expect("the control");
    let page = |number: u32| {
        let cycle = on.cycles.values().find(|cycle| cycle.key.number == number).expect("the cycle");
        let bytes = made.get(&manual::path_of_cycle("tnc640", "de", cycle.key)).expect("the page");
        crate::html::read(&String::from_utf8_lossy(bytes)).text
    };
    let whole = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let drilling = whole(&page(200));
    for words in [
        "Bohrt eine Bohrung in einer oder mehreren Zustellungen.",
        "Das Werkzeug verweilt Q211 am Bohrungsgrund, falls eingegeben.",
        "Maß, um das das Werkzeug jeweils zugestellt wird.",
        "SICHERHEITS-ABST.",
    ] {
        assert!(drilling.contains(words), "{words} in {drilling}");
    }
    assert!(!drilling.contains("Distance between") && !drilling.contains("PLNGNG"), "{drilling}");
    let probing = whole(&page(410));
    assert!(probing.contains("Ermittelt die Mitte einer Rechtecktasche"), "{probing}");
    // Another family is in English, with marks.
    let other = whole(&page(202));
    assert!(other.contains('⟦') && other.matches('⟦').count() == other.matches('⟧').count(), "{other}");
    let drafts = made.iter().filter(|(path, _)| path.ends_with(".html"));
    let unmarked: Vec<&String> = drafts
        .filter(|(_, bytes)| !String::from_utf8_lossy(bytes).contains("class=\"draft\""))
        .map(|(path, _)| path)
        .collect();
    assert!(unmarked.is_empty(), "{unmarked:?}");
}
