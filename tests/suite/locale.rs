//! The languages: look-up, numbers, functions, findings, and how diagnostics are shown.
use ciklo::base::diag::{Diagnostic, Place, Source};
use ciklo::language::locale::render::{render, to_json_line};
use ciklo::language::locale::{Accept, Args, Collation, Digits, Fault, Locales, Meanings, Numbers, Scope, Ui};
use proptest::prelude::*;

/// The units and lists that the tests share.
const UNITS: &str = "
unit-mm = { $value }{\"\\u00A0\"}mm
unit-deg = { $value }°
list-and = { $first } ja { $last }
    .more = { $first }, { $last }
list-or = { $first } tai { $last }
    .more = { $first }, { $last }
";

fn load(files: &[(&str, &str)]) -> (Locales, Vec<Diagnostic>) {
    Locales::load(files.iter().copied())
}

fn finnish(text: &str) -> Locales {
    let (locales, diagnostics) = load(&[("locales/fi/a.ftl", text), ("locales/fi/units.ftl", UNITS)]);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    locales
}

/// The files in `locales/` whose names `wanted` accepts.
fn stored(wanted: fn(&str) -> bool) -> Locales {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    let mut waiting = vec![("locales".to_owned(), root.join("locales"))];
    while let Some((name, path)) = waiting.pop() {
        if path.is_dir() {
            for entry in std::fs::read_dir(&path).unwrap() {
                let entry = entry.unwrap();
                waiting.push((format!("{name}/{}", entry.file_name().display()), entry.path()));
            }
        } else if wanted(&name) {
            files.push((name, std::fs::read(&path).unwrap()));
        }
    }
    let (locales, diagnostics) = Locales::load(files);
    let ui = Ui::new(&locales, None, &[]).unwrap();
    let texts: Vec<String> = diagnostics.iter().map(|diagnostic| to_json_line(diagnostic, &ui)).collect();
    assert!(texts.is_empty(), "{}", texts.join("\n"));
    locales
}

/// The words in double quotes that follow one of the openings in a source text.
fn quoted_after<'t>(text: &'t str, openings: &[&str]) -> Vec<&'t str> {
    let starts = openings.iter().flat_map(|opening| text.match_indices(opening).map(|(at, it)| at + it.len()));
    let words = starts.filter_map(|at| text.get(at..)?.trim_start().strip_prefix('"')?.split('"').next());
    words.filter(|word| !word.is_empty() && word.bytes().all(|b| b.is_ascii_lowercase() || b == b'-')).collect()
}

#[test]
fn every_code_in_the_sources_has_a_text() {
    let locales = stored(|_| true);
    let source = locales.source().unwrap();
    let mut waiting = vec![std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
    let mut silent = Vec::new();
    while let Some(path) = waiting.pop() {
        if path.is_dir() {
            waiting.extend(std::fs::read_dir(&path).unwrap().map(|entry| entry.unwrap().path()));
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        for code in quoted_after(&text, &["Diagnostic::error(", "Diagnostic::warning(", "Diagnostic::global("]) {
            if !source.has(&format!("diag-{code}"), &Scope::NONE) {
                silent.push(format!("{}: diag-{code}", path.display()));
            }
        }
        for caption in quoted_after(&text, &[".related("]) {
            if !source.has(&format!("related-{caption}"), &Scope::NONE) {
                silent.push(format!("{}: related-{caption}", path.display()));
            }
        }
    }
    assert!(silent.is_empty(), "{}", silent.join("\n"));
}

/// The files that belong to this module.
fn own() -> Locales {
    stored(|name| ["units.ftl", "interface.ftl", "diag-locale.ftl", "cli.ftl"].iter().any(|own| name.ends_with(own)))
}

#[test]
fn no_stored_file_has_a_mistake() {
    assert!(stored(|_| true).tags().count() >= 5);
}

/// `code line:column`, sorted.
fn findings(diagnostics: &[Diagnostic]) -> Vec<String> {
    let mut all: Vec<String> = diagnostics
        .iter()
        .map(|diagnostic| match &diagnostic.place {
            Some(place) => format!("{} {}:{}", diagnostic.code, place.start().line, place.start().column),
            None => diagnostic.code.to_owned(),
        })
        .collect();
    all.sort();
    all
}

#[test]
fn the_most_specific_variant_wins_for_each_attribute() {
    let locales = finnish(
        "depth = base\n    .help = base help\ndepth__tnc640 = control\ndepth__drilling = cycle\n    .help = cycle help\ndepth__drilling__tnc640 = both\n",
    );
    let fi = locales.language("fi").unwrap();
    // (key, cycle, control, text)
    let table = [
        ("depth", None, None, "base"),
        ("depth", Some("tapping"), Some("tnc320"), "base"),
        ("depth", Some("tapping"), Some("tnc640"), "control"),
        ("depth", Some("drilling"), Some("tnc320"), "cycle"),
        ("depth", Some("drilling"), Some("tnc640"), "both"),
        ("depth", Some("drilling"), None, "cycle"),
        ("depth.help", Some("drilling"), Some("tnc640"), "cycle help"),
        ("depth.help", Some("tapping"), Some("tnc640"), "base help"),
    ];
    for (key, cycle, control, text) in table {
        assert_eq!(fi.plain(key, &Scope { cycle, control }).unwrap(), text, "{key} {cycle:?} {control:?}");
    }
    let suffixes: Vec<&str> = fi.suffixes().into_iter().map(|(suffix, _)| suffix).collect();
    assert_eq!(suffixes, ["drilling", "drilling", "drilling", "tnc640", "tnc640"]);
}

#[test]
fn references_see_the_same_variants() {
    let locales = finnish(
        "-tool = { $case ->\n   *[nominative] työkalu\n    [genitive] työkalun\n }\n-tool__tnc320 = { $case ->\n   *[nominative] terä\n    [genitive] terän\n }\nstep = { -tool(case: \"genitive\") } säde, { name }\nname = nimi\nname__drilling__tnc320 = poran nimi\n",
    );
    let fi = locales.language("fi").unwrap();
    let step = |scope: Scope| fi.plain("step", &scope).unwrap().into_owned();
    assert_eq!(step(Scope::NONE), "työkalun säde, nimi");
    assert_eq!(step(Scope::control("tnc320")), "terän säde, nimi");
    assert_eq!(step(Scope::new("drilling", "tnc320")), "terän säde, poran nimi");
    assert_eq!(step(Scope::new("drilling", "tnc640")), "työkalun säde, nimi");
}

#[test]
fn isolation_marks_never_appear() {
    let locales =
        finnish("a = x { $text } y { $number } { UNIT($number, \"mm\") } { -t } { b }\nb = { $text }!\n-t = t\n");
    let args = Args::new().text("text", "T").number("number", -0.5);
    let text = locales.language("fi").unwrap().text("a", &Scope::NONE, &args).unwrap().into_owned();
    assert_eq!(text, "x T y \u{2212}0,5 \u{2212}0,5\u{a0}mm t T!");
}

#[test]
fn functions_write_as_the_language_does() {
    let locales = finnish(
        "n = { NUMBER($x, minimumFractionDigits: 3) }\nm = { NUMBER($x, maximumFractionDigits: 1) }\nu = { UNIT($x, \"deg\", minimumFractionDigits: 1) }\nv = { UNIT($x, $unit) }\nand = { LIST($items) }\nor = { LIST($items, type: \"or\") }\nraw = { $items }\nlit = { 2.50 }\n",
    );
    let fi = locales.language("fi").unwrap();
    let at = |key: &str, x: f64| {
        fi.text(key, &Scope::NONE, &Args::new().number("x", x).text("unit", "mm")).unwrap().into_owned()
    };
    assert_eq!(at("n", 0.5), "0,500");
    assert_eq!(at("n", 99999.9999), "99999,9999");
    assert_eq!(at("m", 0.25), "0,3");
    assert_eq!(at("m", -0.04), "0");
    assert_eq!(at("u", 90.0), "90,0°");
    assert_eq!(at("v", 12.0), "12\u{a0}mm");
    assert_eq!(at("lit", 0.0), "2,50");
    // (items, and, or)
    let table: [(&[&str], &str, &str); 4] = [
        (&[], "", ""),
        (&["X"], "X", "X"),
        (&["X", "Y"], "X ja Y", "X tai Y"),
        (&["X", "Y", "Z"], "X, Y ja Z", "X, Y tai Z"),
    ];
    for (items, and, or) in table {
        let text =
            |key| fi.text(key, &Scope::NONE, &Args::new().list("items", items.iter().copied())).unwrap().into_owned();
        assert_eq!((text("and").as_str(), text("or").as_str()), (and, or));
        assert_eq!(text("raw"), items.join(", "));
    }
}

#[test]
fn slovenian_has_a_dual() {
    let text = "holes = { $n ->\n    [0] brez lukenj\n    [one] { $n } luknja\n    [two] { $n } luknji\n    [few] { $n } luknje\n   *[other] { $n } lukenj\n }\n";
    let (locales, diagnostics) = load(&[("locales/sl/a.ftl", text)]);
    assert!(diagnostics.is_empty());
    let sl = locales.language("sl").unwrap();
    let table = [
        (0.0, "brez lukenj"),
        (1.0, "1 luknja"),
        (2.0, "2 luknji"),
        (3.0, "3 luknje"),
        (5.0, "5 lukenj"),
        (102.0, "102 luknji"),
        (1.5, "1,5 luknje"),
    ];
    for (n, text) in table {
        assert_eq!(sl.text("holes", &Scope::NONE, &Args::new().number("n", n)).unwrap(), text);
    }
}

#[test]
fn what_cannot_be_formatted_is_an_error() {
    let (locales, _) = load(&[
        (
            "locales/fi/a.ftl",
            "arg = { $x }\nref = { gone }\nterm = { -gone }\nattr = { arg.gone }\nfun = { GONE($x) }\nchosen = { GONE($x) ->\n   *[other] silent\n }\ncyc = { cyc2 }\ncyc2 = { cyc }\nnum = { NUMBER($t) }\nunit = { UNIT($n, \"parsec\") }\nlist = { LIST($t) }\nsel = { NUMBER($t) ->\n   *[other] silent\n }\nplain = { $n }\nonly-attribute =\n    .a = b\n",
        ),
        ("locales/fi/units.ftl", UNITS),
    ]);
    let fi = locales.language("fi").unwrap();
    let args = |n| Args::new().text("t", "text").number("n", n);
    let table = [
        ("arg", Fault::MissingArgument("x".into())),
        ("ref", Fault::UnknownReference("gone".into())),
        ("term", Fault::UnknownReference("-gone".into())),
        ("attr", Fault::UnknownReference("arg.gone".into())),
        ("cyc", Fault::Cyclic),
        ("num", Fault::FunctionFailed("NUMBER", "not-a-number")),
        ("unit", Fault::FunctionFailed("UNIT", "unknown-unit")),
        ("list", Fault::FunctionFailed("LIST", "not-a-list")),
        ("sel", Fault::FunctionFailed("NUMBER", "not-a-number")),
        ("none", Fault::MissingText),
        ("only-attribute", Fault::MissingText),
        ("arg.none", Fault::MissingText),
    ];
    for (key, fault) in table {
        let error = fi.text(key, &Scope::NONE, &args(1.0)).unwrap_err();
        assert_eq!(error.fault, fault, "{key}");
        assert_eq!(error.key, key);
    }
    for number in [f64::NAN, f64::INFINITY] {
        let error = fi.text("plain", &Scope::NONE, &args(number)).unwrap_err();
        assert_eq!(error.fault, Fault::FunctionFailed("NUMBER", "not-finite"));
        assert!(fi.text("arg", &Scope::NONE, &args(0.0).number("x", 1.0)).is_ok(), "a fault does not outlive its text");
    }
    assert_eq!(
        fi.text("fun", &Scope::NONE, &args(1.0).number("x", 1.0)).unwrap_err().fault.code(),
        "locale-unknown-function"
    );
    assert!(fi.text("chosen", &Scope::NONE, &args(1.0)).is_err());
    assert_eq!(locales.language("xx").unwrap_err().fault, Fault::UnknownLanguage);
}

#[test]
fn mistakes_of_all_files_come_together_with_their_places() {
    let cases: [(&str, &[&str]); 13] = [
        ("a = b\nc = { $x\nd = e\n", &["locale-syntax 3:1"]),
        ("a = b\na = c\n", &["locale-duplicate 2:1"]),
        ("a = b\n-a = c\n", &["locale-duplicate 2:2"]),
        ("a = b\n    .x = 1\n    .x = 2\n", &["locale-duplicate 3:6"]),
        ("a__b__c__d = e\nb____c = d\n", &["locale-variant 1:1", "locale-variant 2:1"]),
        ("a = { gone } { -gone } { a.gone }\n", &["locale-unknown-reference 1:1"; 3]),
        ("a = { GONE(1) }\n", &["locale-unknown-function 1:1"]),
        (
            "a = { NUMBER($x, maximumFractionDigit: 1) } { NUMBER($x, maximumFractionDigits: 99) } { NUMBER() } { LIST($x, type: \"xor\") }\n",
            &[
                "locale-function-arguments 1:1",
                "locale-function-option 1:1",
                "locale-function-option 1:1",
                "locale-function-option 1:1",
            ],
        ),
        ("a = { UNIT($x, \"parsec\") }\n", &["locale-unknown-unit 1:1"]),
        (
            "-t = { $case ->\n   *[nominative] x\n }\n-s = { $n }\na = { -t(case: \"genitiv\") } { -t(kase: \"x\") } { -s }\n",
            &["locale-term-argument 5:1", "locale-term-needs 5:1", "locale-term-value 5:1"],
        ),
        (
            "a = { b }\nb = { c }\nc = { a }\nd = { d.e }\n    .e = { d }\nf = x\n    .g = { f }\n",
            &["locale-cyclic 3:1", "locale-cyclic 5:6"],
        ),
        ("a = \u{2068}x\u{2069}\n", &["locale-isolation-mark 1:5", "locale-isolation-mark 1:7"]),
        ("a = { { { { x } } } }\nx = y\n", &[]),
    ];
    for (text, expected) in cases {
        let (_, diagnostics) = load(&[("locales/fi/a.ftl", text), ("locales/fi/units.ftl", UNITS)]);
        assert_eq!(findings(&diagnostics), expected, "{text}");
    }
    let (_, diagnostics) = load(&[
        ("locales/fi/units.ftl", "unit-x = { $valeu }\nlist-y = { $first } { $last }\n"),
        ("locales/fi/source.lock", "# comment\n\na 0123abcd\na.b xyz\n"),
        ("locales/n°/a.ftl", "a = b\n"),
        ("locales/fi/README.md", "not ours"),
        ("elsewhere/fi/a.ftl", "{"),
    ]);
    let expected = ["locale-lock-line 4:1", "locale-tag 1:1", "locale-unit-form 1:1", "locale-unit-form 2:1"];
    assert_eq!(findings(&diagnostics), expected);
    let (_, diagnostics) = Locales::load([("locales/fi/a.ftl", &[0xff_u8, 0xfe][..])]);
    assert_eq!(findings(&diagnostics), ["locale-encoding 1:1"]);
    let long = "a = { 1.00000000000000000000 ->\n   *[one] x\n }\n";
    assert_eq!(findings(&load(&[("locales/fi/a.ftl", long)]).1), ["locale-long-number 1:9"]);
    let deep = format!("a = {}", "{".repeat(100_000));
    assert_eq!(findings(&load(&[("locales/fi/a.ftl", &deep)]).1), ["locale-nesting 1:69"]);
    // Balanced at the end of the line, and calls in place of braces.
    let (open, close) = ("{ ".repeat(20_000), " }".repeat(20_000));
    let deep = format!("a = {open}\"x\"{close}\n");
    assert_eq!(findings(&load(&[("locales/fi/a.ftl", &deep)]).1), ["locale-nesting 1:133"]);
    let deep = format!("a = {{ {}", "F(".repeat(20_000));
    assert_eq!(findings(&load(&[("locales/fi/a.ftl", &deep)]).1), ["locale-nesting 1:134"]);
}

#[test]
fn a_duplicate_names_both_places() {
    let (_, diagnostics) = load(&[("locales/fi/a.ftl", "x = 1\n"), ("locales/fi/b.ftl", "\nx = 2\n")]);
    let diagnostic = &diagnostics[0];
    assert_eq!(diagnostic.place.as_ref().unwrap().source.name(), "locales/fi/b.ftl");
    assert_eq!(diagnostic.related[0].1.source.name(), "locales/fi/a.ftl");
}

#[test]
fn a_file_with_a_mistake_keeps_its_sound_messages() {
    let (locales, _) = load(&[("locales/fi/a.ftl", "\u{feff}a = A\r\nb = { $x\r\nc = C\r\n")]);
    let fi = locales.language("fi").unwrap();
    assert_eq!(fi.plain("a", &Scope::NONE).unwrap(), "A");
    assert_eq!(fi.plain("c", &Scope::NONE).unwrap(), "C");
}

const ENGLISH: &str = "a = A { $x }\nb = B\n    .tip = T\nc = C\nc__drilling = D\n-t = t\n";

fn audited(translation: &str, lock: &str) -> ciklo::language::locale::Audit {
    let (locales, _) =
        load(&[("locales/en/a.ftl", ENGLISH), ("locales/fi/a.ftl", translation), ("locales/fi/source.lock", lock)]);
    locales.audit("fi").unwrap()
}

fn keys(findings: &[ciklo::language::locale::Finding]) -> Vec<&str> {
    findings.iter().map(|finding| finding.key.as_str()).collect()
}

#[test]
fn the_audit_finds_what_is_missing_left_over_and_too_much() {
    let audit = audited("a = { $x } { $y }\nb = B\nc__tnc640 = only one control\nd = orphan\n-u = own term\n", "");
    assert_eq!(audit.total, 5);
    assert_eq!(keys(&audit.missing), ["b.tip", "c", "c__drilling"]);
    assert_eq!(keys(&audit.orphans), ["d"]);
    assert_eq!(keys(&audit.unknown_arguments), ["a"]);
    assert_eq!(audit.unknown_arguments[0].argument.as_deref(), Some("y"));
    assert_eq!(keys(&audit.unrecorded), ["a", "b", "c__tnc640"]);
    let codes: Vec<&str> = audit.diagnostics().iter().map(|diagnostic| diagnostic.code).collect();
    assert_eq!(codes.iter().filter(|code| **code == "locale-missing-translation").count(), 3);
    assert_eq!(codes.len(), 3 + 1 + 1 + 3);
}

#[test]
fn an_accepted_translation_is_stale_once_its_source_changes() {
    let translation = "a = { $x } A\nb = B\n    .tip = T\nc = C\n-t = t\n";
    let files = |english: &str, lock: &str| {
        load(&[("locales/en/a.ftl", english), ("locales/fi/a.ftl", translation), ("locales/fi/source.lock", lock)]).0
    };
    let lock = files(ENGLISH, "").accept("fi", &Meanings::new(), Accept::Changed).unwrap().lock;
    let names: Vec<&str> = lock.lines().filter_map(|line| line.split(' ').next()).collect();
    assert_eq!(names, ["-t", "a", "b", "b.tip", "c"]);
    let audit = files(ENGLISH, &lock).audit("fi").unwrap();
    assert!(audit.diagnostics().is_empty(), "{audit:?}");
    let changed = ENGLISH.replace("A { $x }", "not A { $x }").replace("T\n", "X\n");
    let audit = files(&changed, &lock).audit("fi").unwrap();
    assert_eq!(keys(&audit.stale), ["a", "b.tip"]);
    let mended = ENGLISH.replace("A { $x }", "A: { $x }");
    assert!(files(&mended, &lock).audit("fi").unwrap().stale.is_empty(), "a comma changes nothing");
    let moved = ENGLISH.replace("a = A", "# a comment\na =\n    A");
    assert!(files(&moved, &lock).audit("fi").unwrap().stale.is_empty(), "layout and comments change nothing");
}

#[test]
fn a_translation_with_the_words_of_another_text_is_accepted_only_by_name() {
    let english = "a = Clockwise\nb = Counterclockwise\nc = Stop\nd = Stop\ne = Wait\n";
    let load_with = |finnish: &str, lock: &str| {
        load(&[("locales/en/a.ftl", english), ("locales/fi/a.ftl", finnish), ("locales/fi/source.lock", lock)]).0
    };
    let none = Meanings::new();
    let first = load_with("a = Myötäpäivään\nb = Vastapäivään\nc = Seis\nd = Pysähdy\ne = Odota\n", "");
    let lock = first.accept("fi", &none, Accept::Changed).unwrap().lock;
    assert!(load_with("a = Myötäpäivään\nb = Vastapäivään\nc = Seis\n", &lock).audit("fi").unwrap().moved.is_empty());
    // Two change places; `d` says the same as `c` in English, too; `e` is new wording.
    let second = "a = Vastapäivään\nb = Myötäpäivään\nc = Seis\nd = Seis\ne = Odota hetki\n";
    let audit = load_with(second, &lock).audit("fi").unwrap();
    assert_eq!(keys(&audit.moved), ["a", "b"]);
    assert_eq!(audit.moved[0].argument.as_deref(), Some("b"));
    assert_eq!(audit.diagnostics().iter().map(|found| found.code).collect::<Vec<_>>(), ["locale-moved"; 2]);
    let changed = load_with(second, &lock).accept("fi", &none, Accept::Changed).unwrap();
    assert_eq!(changed.moved, ["a", "b"]);
    assert_eq!(keys(&load_with(second, &changed.lock).audit("fi").unwrap().moved), ["a", "b"], "nothing is recorded");
    let named = load_with(second, &changed.lock).accept("fi", &none, Accept::Named(&["a".to_owned(), "b".to_owned()]));
    let named = named.unwrap();
    assert!(named.moved.is_empty());
    assert!(load_with(second, &named.lock).audit("fi").unwrap().diagnostics().is_empty());
}

#[test]
fn what_was_stale_is_accepted_only_by_name_or_after_a_change() {
    let load_with = |english: &str, finnish: &str, lock: &str, originals: &str| {
        load(&[
            ("locales/en/a.ftl", english),
            ("locales/en/accepted.lock", originals),
            ("locales/fi/a.ftl", finnish),
            ("locales/fi/source.lock", lock),
        ])
        .0
    };
    let none = Meanings::new();
    let (english, finnish) = ("a = Drill here.\nb = Stop.\n", "a = Poraa.\nb = Seis.\n");
    let first = load_with(english, finnish, "", "");
    let lock = first.accept("fi", &none, Accept::Changed).unwrap().lock;
    let originals = first.originals(std::slice::from_ref(&lock)).unwrap();

    // Both English texts change, one translation with them.
    let english = "a = Drill there slowly.\nb = Wait.\n";
    let second = load_with(english, "a = Poraa hitaasti.\nb = Seis.\n", &lock, &originals);
    let audit = second.audit("fi").unwrap();
    assert_eq!(keys(&audit.stale), ["a", "b"]);
    assert_eq!(audit.stale[0].change.as_deref(), Some("“here.” → “there slowly.”"));
    let accepted = second.accept("fi", &none, Accept::Changed).unwrap();
    assert_eq!((accepted.taken, accepted.stale), (vec!["a".to_owned()], vec!["b".to_owned()]));
    // What remains stale still shows what it was made from, also after the file was written anew.
    let kept = second.originals(std::slice::from_ref(&accepted.lock)).unwrap();
    let third = load_with(english, "a = Poraa hitaasti.\nb = Seis.\n", &accepted.lock, &kept);
    let audit = third.audit("fi").unwrap();
    assert_eq!(keys(&audit.stale), ["b"]);
    assert_eq!(audit.stale[0].change.as_deref(), Some("“Stop.” → “Wait.”"));
    let named = third.accept("fi", &none, Accept::Named(&["b".to_owned()])).unwrap();
    assert!(named.stale.is_empty() && named.taken == ["b"]);
}

#[test]
fn a_copy_of_the_source_is_no_translation_unless_a_list_says_so() {
    let english = "a = Drill { $x } holes\nb = PLANE SPATIAL { $x }\nc = Software\nd = ciklo fmt\n";
    let audit = |lists: &[(&str, &str)]| {
        let mut files = vec![("locales/en/a.ftl", english), ("locales/fi/a.ftl", english)];
        files.extend(lists);
        keys(&load(&files).0.audit("fi").unwrap().same).iter().map(|key| (*key).to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(audit(&[]), ["a", "c", "d"], "words in capitals are no words of a language");
    let lists = [("locales/en/same-as-source.txt", "# keys\nd*\n"), ("locales/fi/same-as-source.txt", "Software\n")];
    assert_eq!(audit(&lists), ["a"]);
}

#[test]
fn a_slip_of_the_pen_leaves_translations_fresh_and_a_new_meaning_does_not() {
    let english = "step = The touch probe retracts to { $height } after 2 probings.\nchoice = move upwards\n";
    let translation = "step = { $height } 2\nchoice = ylös\n";
    let files = |english: &str, lock: &str| {
        load(&[("locales/en/a.ftl", english), ("locales/fi/a.ftl", translation), ("locales/fi/source.lock", lock)]).0
    };
    let meanings: Meanings = [("step".to_owned(), 1), ("choice".to_owned(), 2)].into_iter().collect();
    let lock = files(english, "").accept("fi", &meanings, Accept::Changed).unwrap().lock;
    let stale = |english: &str, meanings: &Meanings| {
        keys(&files(english, &lock).audit_with("fi", meanings).unwrap().stale)
            .iter()
            .map(|key| (*key).to_owned())
            .collect::<Vec<_>>()
    };
    for slip in ["Teh touch probe", "The tuoch probe", "The touch probbe", "The touch prope", "The  touch probe,"] {
        let mended = slip != "The touch prope";
        let text = english.replace("The touch probe", slip);
        assert_eq!(stale(&text, &meanings).is_empty(), mended, "{slip}");
    }
    for other in ["after 3 probings", "before 2 probings", "not after 2 probings"] {
        assert_eq!(stale(&english.replace("after 2 probings", other), &meanings), ["step"], "{other}");
    }
    assert_eq!(stale(&english.replace("$height", "$depth"), &meanings), ["step"]);
    assert_eq!(stale(&english.replace("upwards", "downwards"), &meanings), ["choice"]);
    // Words that differ in one letter, of which each has the same consonant.
    for [word, other] in [["an", "no"], ["on", "no"], ["in", "on"]] {
        let source = format!("step = Show {word} error of {{ $height }} in 2.\nchoice = move upwards\n");
        let lock = files(&source, "").accept("fi", &meanings, Accept::Changed).unwrap().lock;
        let now = source.replace(&format!("Show {word} "), &format!("Show {other} "));
        let audit = files(&now, &lock).audit_with("fi", &meanings).unwrap();
        assert_eq!(keys(&audit.stale), ["step"], "{word} → {other}");
    }
    let changed: Meanings = [("step".to_owned(), 1), ("choice".to_owned(), 3)].into_iter().collect();
    assert_eq!(stale(english, &changed), ["choice"], "the specification means something else");
}

#[test]
fn every_language_sorts_and_searches_its_own_way() {
    // (language, sorted)
    let table: [(&str, &[&str]); 4] = [
        ("sl", &["cona", "čas", "dolžina", "sla", "šoba", "zamik", "žaga"]),
        ("fi", &["arvo", "omena", "zoomi", "åre", "äly", "öljy"]),
        ("it", &["è", "età", "zero"]),
        ("pt", &["acao", "ação", "zona"]),
    ];
    for (tag, sorted) in table {
        let mut words: Vec<&str> = sorted.iter().rev().copied().collect();
        Collation::of(tag).sort_by_key(&mut words, |word| word);
        assert_eq!(words, sorted, "{tag}");
    }
    assert!(Collation::of("pt").same("POSIÇÃO", "posicao"));
    assert!(!Collation::of("fi").same("tyokalu", "työkalu"));
    assert!(!Collation::of("sl").same("zaga", "žaga"));
}

#[test]
fn the_programs_language_follows_the_request_and_the_environment() {
    let locales = own();
    let tag = |asked, environment: &[Option<&str>]| Ui::new(&locales, asked, environment).map(|ui| ui.tag().to_owned());
    assert_eq!(tag(Some("sl"), &[Some("fi_FI")]).unwrap(), "sl");
    assert_eq!(tag(None, &[None, Some(""), Some("fi_FI.UTF-8")]).unwrap(), "fi");
    assert_eq!(tag(None, &[Some("C"), None, Some("fi_FI.UTF-8")]).unwrap(), "en");
    assert_eq!(tag(None, &[Some("pt")]).unwrap(), "pt");
    assert_eq!(tag(None, &[Some("tlh_QO")]).unwrap(), "en");
    assert_eq!(tag(None, &[]).unwrap(), "en");
    assert!(tag(Some("xx"), &[]).is_err());
}

#[test]
fn a_text_can_be_sketched_without_arguments() {
    let locales = finnish("a = { $n ->\n    [one] yksi\n   *[other] { UNIT($n, \"mm\") } ja { $name }{ \"!\" }\n }\n");
    assert_eq!(locales.language("fi").unwrap().sketch("a").as_deref(), Some("‹n› ja ‹name›!"));
}

#[test]
fn interface_texts_fall_back_to_english_and_always_say_something() {
    let (locales, _) = load(&[
        ("locales/en/a.ftl", "diag-known = known { $n }\ndiagnostic-without-text = no text for { $code }{ $values }\n"),
        ("locales/fi/a.ftl", "own = oma\n"),
    ]);
    let ui = Ui::new(&locales, Some("fi"), &[]).unwrap();
    assert_eq!(ui.text("own", &Args::new()), "oma");
    assert_eq!(ui.diagnostic(&Diagnostic::global("known").arg("n", 1.5)), "known 1.5");
    assert_eq!(ui.diagnostic(&Diagnostic::global("known")), "no text for known");
    assert_eq!(ui.diagnostic(&Diagnostic::global("odd").arg("a", "b")), "no text for odd a=b");
    let (empty, _) = load(&[]);
    assert_eq!(Ui::new(&empty, None, &[]).unwrap().diagnostic(&Diagnostic::global("odd")), "odd");
}

#[test]
fn an_excerpt_shows_the_line_and_both_formats_the_position() {
    let locales = own();
    let ui = Ui::new(&locales, Some("fi"), &[]).unwrap();
    let source = Source::new("ohjelma.h", "0 BEGIN PGM Ä MM\r\n1 L X+ä Y+5\r\n2 END PGM Ä MM\r\n");
    let at = source.text().find("Y+5").unwrap();
    let diagnostic = Diagnostic::error("locale-unknown-reference", Place::new(&source, at..at + 3)).arg("name", "x");
    let text = render(&diagnostic, &ui, false);
    for part in ["virhe[locale-unknown-reference]: Kohdetta ”x” ei ole.", "ohjelma.h:2:9", "2 | 1 L X+ä Y+5", "^^^"]
    {
        assert!(text.contains(part), "{part} in\n{text}");
    }
    assert!(!text.contains('\u{1b}'));
    assert!(render(&diagnostic, &ui, true).contains('\u{1b}'));
    assert_eq!(
        to_json_line(&diagnostic, &ui),
        r#"{"file":"ohjelma.h","line":2,"column":9,"end_line":2,"end_column":12,"severity":"error","code":"locale-unknown-reference","message":"Kohdetta ”x” ei ole."}"#
    );
    let global = Diagnostic::global("locale-encoding");
    assert!(to_json_line(&global, &ui).starts_with(r#"{"file":null,"line":null,"#));
    assert!(render(&global, &ui, false).starts_with("virhe[locale-encoding]"));
}

#[test]
fn an_excerpt_of_a_very_long_line_is_short() {
    let locales = own();
    let ui = Ui::new(&locales, None, &[]).unwrap();
    let long = format!("{}ŽX{}", "ä".repeat(1_000_000), "b".repeat(1_000_000));
    let source = Source::new("a.h", long);
    for span in [2_000_000..2_000_003, 0..4_000_000, 1..1, 4_000_000..9_000_000] {
        let text = render(&Diagnostic::error("locale-encoding", Place::new(&source, span)), &ui, false);
        assert!(text.len() < 8000, "{}", text.len());
    }
    let place = Place::new(&source, 2_000_000..2_000_003);
    let text = render(&Diagnostic::error("locale-encoding", place), &ui, false);
    assert!(text.contains("a.h:1:1000001"), "{text}");
}

#[test]
fn the_languages_agree_on_their_messages() {
    let locales = own();
    for tag in locales.tags() {
        let audit = locales.audit(tag).unwrap();
        assert_eq!(keys(&audit.missing), Vec::<&str>::new(), "{tag}");
        assert_eq!(keys(&audit.unknown_arguments), Vec::<&str>::new(), "{tag}");
    }
    for (tag, half, angle) in [
        ("en", "0.5\u{a0}mm", "90°"),
        ("fi", "0,5\u{a0}mm", "90°"),
        ("sl", "0,5\u{a0}mm", "90°"),
        ("it", "0,5\u{a0}mm", "90°"),
        ("pt", "0,5\u{a0}mm", "90°"),
    ] {
        let language = locales.language(tag).unwrap();
        assert_eq!(language.unit(0.5, "mm", Digits::default()).as_deref(), Some(half));
        assert_eq!(language.unit(90.0, "deg", Digits::default()).as_deref(), Some(angle));
    }
}

#[test]
fn numbers_are_plain_exact_and_without_negative_zero() {
    let fi = finnish("").language("fi").unwrap().numbers().clone();
    let usual = Digits::default();
    let table = [
        (0.0, "0"),
        (-0.0, "0"),
        (100.0, "100"),
        (1234567.0, "1234567"),
        (0.1 + 0.2, "0,3"),
        (-99999.9999, "\u{2212}99999,9999"),
        (1e-9, "0,000000001"),
        (1.234e-8, "0,000000012"),
        (9.99e-8, "0,0000001"),
        (2.5e21, "2500000000000000000000"),
    ];
    for (value, text) in table {
        assert_eq!(fi.prose(value, usual).as_deref(), Some(text));
    }
    assert_eq!(fi.nc(-0.5, Digits::exactly(3)).as_deref(), Some("-0,500"));
    assert_eq!(fi.nc(-0.0004, Digits::exactly(3)).as_deref(), Some("0,000"));
    assert_eq!(Numbers::plain().nc(-20.0, usual).as_deref(), Some("-20"));
    for bad in ["", "-", ",5", "5,", "1.5", "1 000", "1,5,5"] {
        assert_eq!(fi.parse(bad), None, "{bad}");
    }
}

laws! {
    #![proptest_config(crate::cases::config(256))]

    #[test]
    fn a_number_reads_back_within_its_digits(value in -1e9..1e9_f64, digits in 0_u8..=6, tag in 0..5_usize) {
        let tags = ["en", "fi", "sl", "it", "pt"];
        let (locales, _) = load(&[(&format!("locales/{}/a.ftl", tags[tag]), "")]);
        let numbers = locales.language(tags[tag]).unwrap().numbers().clone();
        let exact = Digits::exactly(digits);
        for text in [numbers.prose(value, exact).unwrap(), numbers.nc(value, exact).unwrap()] {
            let back = numbers.parse(&text).unwrap();
            prop_assert!((back - value).abs() <= 0.5001 * libm::pow(0.1, f64::from(digits)) + 1e-7, "{text}");
            prop_assert_eq!(numbers.nc(back, exact), numbers.nc(value, exact));
        }
    }

    #[test]
    fn no_file_makes_loading_panic(text in "[ab{}\\[\\]=\\-.$\"\n *>_()1,]{0,200}") {
        let (locales, _) = load(&[("locales/en/a.ftl", &text), ("locales/fi/a.ftl", &text), ("locales/fi/units.ftl", &text)]);
        for language in locales.iter() {
            for id in language.ids() {
                if let Ok(text) = language.plain(id, &Scope::new("a", "b")) {
                    let marked = text.contains(['\u{2068}', '\u{2069}']);
                    prop_assert!(!marked);
                }
            }
        }
        for tag in locales.tags() {
            prop_assert!(locales.audit(tag).is_ok());
            prop_assert!(locales.accept(tag, &Meanings::new(), Accept::All).is_ok());
        }
    }
}
