//! Texts on their way to translators and back: what is unchanged keeps every byte, what is not sound is refused.
use ciklo::spec::Catalogue;
use ciklo::tools::exchange::{self, Form, Imported, Why, markdown};

use crate::built::built;

const FORMS: [Form; 3] = [Form::Xliff, Form::Xliff2, Form::Po];
const ENGLISH: &str = "# A comment.\na = Move to { $depth } at { $feed }.\nb =\n    First line\n    second line\n    .tip = Tip & \"more\"\nholes = { $count ->\n        [one] { $count } hole\n       *[other] { $count } holes\n    }\n-probe = touch probe\nc = The { -probe } waits.\n";
const FINNISH: &str = "# Kommentti.\na   =  Aja { $depth } { $feed }.\n\nb =\n      Eka rivi\n      toka rivi\n    .tip = Vihje\nholes = { $count ->\n        [one] { $count } reikä\n       *[other] { $count } reikää\n    }\n-probe = { $case ->\n       *[nominative] kosketuspää\n        [genitive] kosketuspään\n    }\nc = { -probe(case: \"nominative\") } odottaa.\n";

fn files(finnish: &str) -> Vec<(String, String)> {
    let file = |path: &str, text: &str| (path.to_owned(), text.to_owned());
    let mut all = vec![file("locales/en/a.ftl", ENGLISH)];
    if !finnish.is_empty() {
        all.push(file("locales/fi/a.ftl", finnish));
    }
    all
}

fn export(files: &[(String, String)], tag: &str, form: Form) -> String {
    let (locales, found) = ciklo::language::locale::Locales::load(files.iter().map(|(path, text)| (path, text)));
    assert!(found.is_empty(), "{found:?}");
    // Accepted, so that every unit with a translation is final.
    let mut all = files.to_vec();
    if locales.language(tag).is_ok() {
        let none = ciklo::language::locale::Meanings::new();
        let lock = locales.accept(tag, &none, ciklo::language::locale::Accept::All).unwrap().lock;
        all.push((format!("locales/{tag}/source.lock"), lock));
    }
    let (locales, _) = ciklo::language::locale::Locales::load(all.iter().map(|(path, text)| (path, text)));
    let units = exchange::units(&locales, &ciklo::language::locale::Meanings::new(), tag).unwrap();
    exchange::write(&units, tag, form)
}

fn import(files: &[(String, String)], tag: &str, text: &str) -> Imported {
    let returned = exchange::read(text).unwrap_or_else(|refused| panic!("{refused:?}\n{text}"));
    assert_eq!(returned.language.as_deref(), Some(tag));
    exchange::import(&Catalogue::load(files).0, files, tag, returned.units).unwrap()
}

#[test]
fn what_comes_back_as_it_went_changes_nothing() {
    let files = files(FINNISH);
    for form in FORMS {
        let imported = import(&files, "fi", &export(&files, "fi", form));
        assert!(imported.refused.is_empty() && imported.files.is_empty(), "{form:?} {imported:?}");
        assert_eq!(imported.unchanged, 8, "a, b, b.tip, two holes, two probes, c");
    }
}

#[test]
fn a_tool_may_lose_states_and_original_data() {
    let files = files(FINNISH);
    let text = export(&files, "fi", Form::Xliff2).replace("Aja ", "Siirry ").replace(" state=\"final\"", "");
    let without: Vec<&str> =
        text.split("<originalData>").map(|part| part.split("</originalData>").last().unwrap()).collect();
    let mut returned = exchange::read(&without.concat()).unwrap();
    let catalogue = Catalogue::load(&files).0;
    let left = exchange::import(&catalogue, &files, "fi", returned.units.clone()).unwrap();
    assert_eq!((left.taken.len(), left.unchanged, left.refused.len()), (0, 0, 0), "nothing is final");
    returned.units.iter_mut().for_each(exchange::Received::settle);
    let imported = exchange::import(&catalogue, &files, "fi", returned.units).unwrap();
    assert!(imported.refused.is_empty(), "{:?}", imported.refused);
    assert_eq!(imported.files, [("locales/fi/a.ftl".to_owned(), FINNISH.replace("Aja ", "Siirry "))]);
    // The words of the source in place of a translation are none.
    let copied = export(&files, "fi", Form::Xliff).replace("Vihje", "Tip &amp; &quot;more&quot;");
    let mut returned =
        exchange::read(&copied.replace("final", "needs-translation").replace(" approved=\"yes\"", "")).unwrap();
    returned.units.iter_mut().for_each(exchange::Received::settle);
    let open: Vec<&str> = returned.units.iter().filter(|unit| !unit.is_final).map(|unit| unit.id.as_str()).collect();
    assert_eq!(open, ["b.tip"]);
}

#[test]
fn elements_that_a_tool_has_laid_out_in_lines_are_read_as_they_were() {
    let files = files(FINNISH);
    let text = export(&files, "fi", Form::Xliff).replace("Aja ", "Siirry ");
    let line = "\n          ";
    let laid_out = text.replace("<ph ", &format!("{line}<ph ")).replace(".</", &format!(".{line}</"));
    let imported = import(&files, "fi", &laid_out);
    assert!(imported.refused.is_empty(), "{:?}", imported.refused);
    assert_eq!(imported.files, [("locales/fi/a.ftl".to_owned(), FINNISH.replace("Aja ", "Siirry "))]);
}

#[test]
fn blanks_between_codes_that_a_tool_loses_are_put_back() {
    let files = files(FINNISH);
    for form in [Form::Xliff, Form::Xliff2] {
        let text = export(&files, "fi", form);
        let lost = text.replace("</ph> <ph", "</ph><ph").replace("/> <ph", "/><ph");
        assert_ne!(lost, text, "{form:?}: there is such a blank");
        let imported = import(&files, "fi", &lost);
        assert!(imported.refused.is_empty() && imported.files.is_empty(), "{form:?} {imported:?}");
        let edited = import(&files, "fi", &lost.replace("Aja ", "Siirry "));
        assert_eq!(edited.files, [("locales/fi/a.ftl".to_owned(), FINNISH.replace("Aja ", "Siirry "))], "{form:?}");
    }
}

#[test]
fn an_edit_changes_its_own_bytes_and_no_others() {
    let files = files(FINNISH);
    let edits = [
        ("Aja ", "Siirry "),
        ("toka rivi", "toinen"),
        ("Vihje", "Vihje < v"),
        (" reikää", " reiät"),
        ("kosketuspään", "anturin"),
    ];
    for form in FORMS {
        for (old, new) in edits {
            let written = new.replace('<', if form == Form::Po { "<" } else { "&lt;" });
            let text = export(&files, "fi", form).replace(old, &written);
            let imported = import(&files, "fi", &text);
            assert!(imported.refused.is_empty(), "{form:?} {old}: {:?}", imported.refused);
            assert_eq!(imported.files, [("locales/fi/a.ftl".to_owned(), FINNISH.replace(old, new))], "{form:?}");
        }
    }
}

#[test]
fn a_new_language_gets_the_variants_that_it_needs() {
    let files = files("");
    let text = export(&files, "sl", Form::Po);
    for category in ["one", "two", "few", "other"] {
        assert!(text.contains(&format!("msgctxt \"holes#0[{category}]\"")), "{text}");
    }
    let translated: String = text
        .lines()
        .map(|line| {
            let id = line.strip_prefix("msgid ").filter(|id| *id != "\"\"");
            id.map_or_else(|| format!("{line}\n"), |id| format!("{line}\nmsgstr {}\n", id.replace("hole", "vrtina")))
        })
        .collect::<String>()
        .replace("\"\nmsgstr \"\"\n", "\"\n")
        .replace("msgstr \"\"\n\n", "\n");
    let imported = import(&files, "sl", &translated);
    let (path, new) = &imported.files[0];
    assert_eq!(path, "locales/sl/a.ftl");
    assert!(new.contains("[two] { $count } vrtinas") && new.contains("*[other] { $count } vrtinas"), "{new}");
    let (_, found) = ciklo::language::locale::Locales::load([(path, new)]);
    assert!(found.iter().all(|found| found.code != "locale-syntax"), "{found:?}");
}

#[test]
fn units_that_are_not_sound_are_refused_and_the_others_are_taken() {
    let files = files(FINNISH);
    let good = export(&files, "fi", Form::Xliff);
    let why = |text: &str| {
        let imported = import(&files, "fi", &text.replace("Vihje", "Neuvo"));
        assert_eq!(imported.taken, ["b.tip"], "the sound half is taken");
        imported.refused.into_iter().map(|refusal| (refusal.id, refusal.why)).collect::<Vec<_>>()
    };
    let code = "<ph id=\"2\" equiv-text=\"feed\">{ $feed }</ph>.</target>";
    assert!(good.contains(code), "{good}");
    let dropped = why(&good.replace(code, ".</target>"));
    assert!(
        matches!(&dropped[..], [(id, Why::Codes { missing, .. })] if id == "a" && missing == "$feed"),
        "{dropped:?}"
    );
    let foreign = why(&good.replace(code, "<ph id=\"2\">{ $feed }</ph><ph id=\"9\">{ $other }</ph></target>"));
    assert!(matches!(&foreign[..], [(_, Why::Codes { foreign, .. })] if foreign == "{ $other }"), "{foreign:?}");
    let swapped = why(&good
        .replace("{ $depth }</ph> <ph", "{ $feed }</ph> <ph")
        .replace(code, "<ph id=\"1\">{ $depth }</ph>.</target>"));
    assert!(matches!(&swapped[..], [(id, Why::Exchanged)] if id == "a"), "{swapped:?}");
    let changed = why(&good.replace("<source>Move to", "<source>Drive to"));
    assert!(matches!(&changed[..], [(_, Why::SourceChanged)]), "{changed:?}");
    let unknown = why(&good.replace("id=\"a\" approved", "id=\"z\" approved"));
    assert!(matches!(&unknown[..], [(_, Why::Unknown)]), "{unknown:?}");
    let twice = why(&good.replace("id=\"c\" approved", "id=\"a\" approved"));
    assert!(twice.len() == 2 && twice.iter().all(|(_, why)| matches!(why, Why::Twice)), "{twice:?}");
    let case = why(&good.replace("{ -probe(case: &quot;nominative&quot;) }", "{ -probe(case: &quot;dative&quot;) }"));
    assert!(matches!(&case[..], [(id, Why::Found(_))] if id == "c"), "{case:?}");
}

#[test]
fn hostile_files_are_refused_with_a_place() {
    let good = export(&files(FINNISH), "fi", Form::Xliff);
    let what = |text: &str| exchange::read(text).map(|_| ()).unwrap_err().what;
    let entities = "<!DOCTYPE xliff [<!ENTITY a \"b\">]>\n<xliff";
    assert_eq!(what(&good.replacen("<xliff", entities, 1)), "document-type");
    assert_eq!(what(&good.replace("Aja ", "&a;")), "entity");
    assert_eq!(what(&good.replace("UTF-8", "UTF-16")), "encoding");
    assert_eq!(what(&"<a>".repeat(100_000)), "depth");
    assert_eq!(what("<html/>"), "xliff");
    assert_eq!(what(&good.replacen("</target>", "", 1)), "form");
    assert_eq!(what("msgid \"a\nmsgstr \"b\"\n"), "form");
    for hidden in ["\u{0}", "&#1;", "\u{202e}"] {
        let imported = import(&files(FINNISH), "fi", &good.replace("Aja ", &format!("Aja {hidden}")));
        assert!(matches!(&imported.refused[..], [one] if matches!(one.why, Why::NotRead)), "{imported:?}");
        assert!(imported.files.is_empty());
    }
    let refused = exchange::read(&good.replace("Aja ", "&a;")).unwrap_err();
    assert_eq!(good.get(refused.at..).map(|rest| rest.starts_with("Aja ")), Some(true));
}

#[test]
fn what_is_not_final_is_passed_over() {
    let files = files(FINNISH);
    let text =
        export(&files, "fi", Form::Xliff2).replace("state=\"final\"", "state=\"translated\"").replace("Aja ", "X ");
    let imported = import(&files, "fi", &text);
    assert_eq!((imported.passed_over, imported.taken.len(), imported.files.len()), (8, 0, 0));
}

/// A translation of texts of the shipped data into a language that has none yet.
fn into_german(texts: &[(&str, &str)]) -> Imported {
    let units = exchange::units(&built().locales, &ciklo::language::locale::Meanings::new(), "de").unwrap();
    let received = texts.iter().map(|(id, words)| {
        let unit = units.iter().find(|unit| unit.id == *id).unwrap();
        let target = Some(vec![exchange::Piece::Text((*words).to_owned())]);
        let source = Some(unit.source.clone());
        exchange::Received { id: unit.id.clone(), at: 0, is_final: true, source, target }
    });
    exchange::import(&built().catalogue, &built().files, "de", received.collect()).unwrap()
}

#[test]
fn labels_of_a_new_language_obey_the_rules_of_the_controls() {
    let long = "SICHERHEITSABSTAND ZUR OBERFLAECHE DES WERKSTUECKS";
    let imported = into_german(&[
        ("cycle-drilling", "Bohren"),
        ("cycle-drilling.nc", "De BOHREN"),
        ("cycle-reaming.nc", "REIBEN"),
        ("parameter-depth.label", "TIEFE Ω"),
        ("parameter-set-up-clearance.label", long),
    ]);
    let code = |refusal: &exchange::Refusal| match &refusal.why {
        Why::Found(found) => (refusal.id.clone(), found.code),
        other => panic!("{other:?}"),
    };
    let mut refused: Vec<(String, &str)> = imported.refused.iter().map(code).collect();
    refused.sort();
    let expected = [
        ("cycle-drilling.nc", "label-lower-case"),
        ("parameter-depth.label", "label-character"),
        ("parameter-set-up-clearance.label", "label-too-long"),
    ];
    assert_eq!(refused, expected.map(|(id, code)| (id.to_owned(), code)));
    assert_eq!(imported.taken, ["cycle-drilling", "cycle-reaming.nc"]);
}

/// All pages of the shipped data, with a page of prose in a language that does not have it.
fn pages() -> Vec<(String, String)> {
    let page = "# Threads\n\nUse [cycle 206](cycle:CYCL-DEF-206) for **all** threads up to 12 mm.\n\n| Sign | Sense |\n|---|---|\n| + | right |\n\n- first\n- second\n";
    let finnish = "# Kierteet\n\nKäytä [työkiertoa 206](cycle:CYCL-DEF-206) **kaikille** kierteille\n12 mm:iin saakka.\n\n| Merkki   | Suunta |\n|---|---|\n| + | oikea |\n\n* eka\n* toka\n";
    let mut all = files(FINNISH);
    all.push(("locales/en/topics/threads.md".to_owned(), page.to_owned()));
    all.push(("locales/fi/topics/threads.md".to_owned(), finnish.to_owned()));
    all
}

#[test]
fn an_edit_of_a_page_changes_its_own_segment_and_no_other_byte() {
    let files = pages();
    for form in FORMS {
        let text = export(&files, "fi", form);
        let same = import(&files, "fi", &text);
        assert!(same.refused.is_empty() && same.files.is_empty(), "{form:?} {same:?}");
        assert_eq!(same.unchanged, 8 + 7, "segments of the page: title, sentence, three cells with words, two items");
        for (old, new) in [("oikea", "oikealle"), ("Kierteet", "Kierteistä"), ("toka", "toinen")] {
            let imported = import(&files, "fi", &text.replace(old, new));
            let page = &files.last().unwrap().1;
            let expected = [("locales/fi/topics/threads.md".to_owned(), page.replace(old, new))];
            assert_eq!(imported.files.last(), expected.first(), "{form:?}");
        }
    }
}

#[test]
fn facts_and_marks_of_a_page_are_kept() {
    let files = pages();
    let text = export(&files, "fi", Form::Xliff);
    let why = |from: &str, to: &str| {
        assert!(text.contains(from), "{from} in {text}");
        let imported = import(&files, "fi", &text.replace(from, to));
        assert!(imported.files.is_empty());
        imported.refused.into_iter().map(|refusal| refusal.why).next()
    };
    let numbers = why("12 mm:iin", "10 mm:iin");
    assert!(
        matches!(&numbers, Some(Why::Numbers { missing, foreign }) if missing == "12 mm" && foreign == "10 mm"),
        "{numbers:?}"
    );
    let minus = why("12 mm:iin", "−12 mm:iin");
    assert!(matches!(&minus, Some(Why::Numbers { foreign, .. }) if foreign == "\u{2212}12 mm"), "{minus:?}");
    let unit = why("12 mm:iin", "12 %:iin");
    assert!(matches!(&unit, Some(Why::Numbers { missing, .. }) if missing == "12 mm"), "{unit:?}");
    let reference = why("kierteille", "inkrementaalisille kierteille");
    assert!(matches!(&reference, Some(Why::Numbers { foreign, .. }) if foreign == "incremental"), "{reference:?}");
    let angle = why("12 mm:iin", "12 °:een");
    assert!(matches!(&angle, Some(Why::Numbers { foreign, .. }) if foreign == "12 °"), "{angle:?}");
    let code = "<ph id=\"1\" equiv-text=\"[\">[</ph>työkiertoa";
    assert!(matches!(why(code, "työkiertoa"), Some(Why::Codes { .. })), "a mark is missing");
    // A sign that would be a mark is written so that it is none.
    let imported = import(&files, "fi", &text.replace("oikea<", "oikea | *kyllä*<"));
    assert!(imported.files.last().unwrap().1.contains("| oikea \\| \\*kyllä\\* |"), "{imported:?}");
    assert_eq!(import(&files, "fi", &text.replace(">eka<", "># eka<")).files.len(), 1, "no heading in an item");
}

/// Files with a language that lists its words that deny.
fn denying() -> Vec<(String, String)> {
    let file = |path: &str, text: &str| (path.to_owned(), text.to_owned());
    let english = "lexicon-negation = not | no | nor+\na = It must not turn, if no tool is there.\nb = It turns.\nchoice-left = To the left\nchoice-right = To the right\n";
    let finnish = "lexicon-negation = ei | eikä\na = Se ei saa pyöriä, jos työkalua ei ole.\nb = Se ei ei pyöri.\nchoice-left = Vasemmalle\nchoice-right = Oikealle\n";
    vec![
        file("locales/en/a.ftl", english),
        file("locales/fi/a.ftl", finnish),
        file("locales/en/topics/t.md", "# Turning\n\nIt must not turn, if no tool is there.\n"),
        file("locales/fi/topics/t.md", "# Pyöriminen\n\nSe ei saa pyöriä, jos työkalua ei ole.\n"),
    ]
}

#[test]
fn a_denial_is_not_taken_out() {
    let files = denying();
    for form in FORMS {
        let text = export(&files, "fi", form);
        // In a text with two of them, and in a page.
        let imported = import(&files, "fi", &text.replace("Se ei saa pyöriä", "Se saa pyöriä"));
        let refused: Vec<_> = imported.refused.iter().map(|it| (it.id.split('#').next().unwrap(), &it.why)).collect();
        assert!(
            matches!(&refused[..], [("a", Why::Negation), ("topics/t", Why::Negation)]) && imported.files.is_empty(),
            "{refused:?}"
        );
        // Where the source denies nothing, where a word was there twice, or where it is said in other words.
        for (old, new) in [
            ("Se ei ei pyöri", "Se ei pyöri"),
            ("Se ei ei pyöri", "Se pyörii"),
            ("Se ei saa pyöriä", "Älä pyöritä sitä"),
        ] {
            let imported = import(&files, "fi", &text.replace(old, new));
            assert!(imported.refused.is_empty() && !imported.files.is_empty(), "{new}: {imported:?}");
        }
    }
}

#[test]
fn two_choices_do_not_change_places() {
    let files = denying();
    let text = export(&files, "fi", Form::Po);
    let swapped = text.replace("Vasemmalle", "\u{1}").replace("Oikealle", "Vasemmalle").replace('\u{1}', "Oikealle");
    let imported = import(&files, "fi", &swapped);
    let refused: Vec<_> = imported.refused.iter().map(|it| (it.id.as_str(), &it.why)).collect();
    assert!(
        matches!(&refused[..], [("choice-left", Why::Swapped { other }), ("choice-right", Why::Swapped { .. })] if other == "choice-right"),
        "{refused:?}"
    );
    assert!(imported.files.is_empty());
    let better = text.replace("Vasemmalle", "Vasempaan").replace("Oikealle", "Oikeaan");
    assert_eq!(import(&files, "fi", &better).taken, ["choice-left", "choice-right"]);
}

#[test]
fn the_state_counts_groups_and_variants_that_are_missing() {
    let mut files = ciklo::base::data::embedded();
    let status = |files: &[(String, String)]| {
        let (locales, _) = ciklo::language::locale::Locales::load(files.iter().map(|(path, text)| (path, text)));
        let (catalogue, _) = Catalogue::load(files);
        let meanings = ciklo::language::consistency::meanings(&catalogue);
        exchange::status(&catalogue, &locales, &meanings, "fi").unwrap()
    };
    let before = status(&files);
    let (_, english) = files.iter_mut().find(|(path, _)| path == "locales/en/drilling.ftl").unwrap();
    assert!(english.contains("\nstep-break-chip = "), "the text is there");
    english.push_str("step-break-chip__drilling__tnc640 = The tool retracts by 99 mm.\n");
    let after = status(&files);
    assert_eq!(after.total.missing, before.total.missing + 1);
    let open = after.open.iter().find(|open| open.key == "step-break-chip__drilling__tnc640").unwrap();
    assert_eq!((open.state, open.file.as_str()), (exchange::State::Missing, "drilling.ftl"));
    let more = |group: &str| after.groups[group].missing - before.groups[group].missing;
    assert_eq!((more("drilling"), more("datum")), (1, 0), "{:?}", after.groups.keys());
    assert_eq!(after.groups["drilling"].words_to_do, before.groups["drilling"].words_to_do + 5);
}

#[test]
fn a_page_that_is_new_needs_all_of_its_segments() {
    let mut files = pages();
    files.pop();
    let text = export(&files, "fi", Form::Po);
    let translated = |text: &str| {
        let mut page = false;
        let mut id = String::new();
        text.lines()
            .map(|line| {
                page = if line.starts_with("msgctxt") { line.contains("topics/") } else { page };
                id = line.strip_prefix("msgid ").map_or(id.clone(), str::to_owned);
                if page && line == "msgstr \"\"" { format!("msgstr {id}\n") } else { format!("{line}\n") }
            })
            .collect::<String>()
    };
    let whole = translated(&text);
    let imported = import(&files, "fi", &whole);
    assert_eq!(imported.files, [("locales/fi/topics/threads.md".to_owned(), files.last().unwrap().1.clone())]);
    assert!(imported.confirmed.contains(&"topics/threads".to_owned()));
    let one_less = whole.replace("msgstr \"second\"", "msgstr \"\"");
    let imported = import(&files, "fi", &one_less);
    assert!(
        imported.files.is_empty() && imported.refused.iter().all(|it| matches!(it.why, Why::Incomplete)),
        "{imported:?}"
    );
}

#[test]
fn all_shipped_texts_come_back_without_a_change() {
    let (files, catalogue, locales) = (&built().files, &built().catalogue, &*built().locales);
    let meanings = ciklo::language::consistency::meanings(catalogue);
    for (tag, form) in [("fi", Form::Xliff), ("sl", Form::Xliff2), ("it", Form::Po), ("pt", Form::Xliff)] {
        let units = exchange::units(locales, &meanings, tag).unwrap();
        let open = units.iter().filter(|unit| unit.state.is_some()).count();
        let count = units.len() - open;
        let returned = exchange::read(&exchange::write(&units, tag, form)).unwrap();
        let imported = exchange::import(catalogue, files, tag, returned.units).unwrap();
        assert!(imported.refused.is_empty(), "{tag}: {:?}", imported.refused);
        assert_eq!((imported.files.len(), imported.unchanged, imported.passed_over), (0, count, open), "{tag}");
        let segments = units.iter().filter(|unit| unit.key.starts_with("topics/"));
        assert!(segments.clone().count() > 1000 && segments.clone().all(|unit| !unit.target.is_empty()), "{tag}");
    }
}

#[test]
fn memories_have_what_is_accepted_and_termbases_every_language() {
    let (catalogue, locales) = (&built().catalogue, &*built().locales);
    let meanings = ciklo::language::consistency::meanings(catalogue);
    let tags = ["fi", "pt"].map(str::to_owned);
    let entries = exchange::entries(locales, &meanings, &tags).unwrap();
    let tmx = exchange::tmx(&entries);
    let root = quick_xml::Reader::from_str(&tmx).read_event().is_ok();
    assert!(root && tmx.matches("<tu ").count() == entries.len());
    let depth = entries.iter().find(|entry| entry.unit.id == "parameter-depth").unwrap();
    assert_eq!(depth.translations.keys().collect::<Vec<_>>(), ["fi", "pt"]);
    let ids: std::collections::BTreeSet<&str> = entries.iter().map(|entry| entry.unit.id.as_str()).collect();
    assert_eq!(ids.len(), entries.len(), "each identifier once");

    let concepts = exchange::concepts(locales, &tags);
    let clearance = concepts.iter().find(|concept| concept.id == "term-set-up-clearance").unwrap();
    let languages: Vec<&str> = clearance.words.iter().map(|words| words.language.as_str()).collect();
    assert_eq!(languages, ["en", "fi", "pt"]);
    let finnish = &clearance.words[1];
    assert_eq!(
        (finnish.term.as_str(), &*finnish.forbidden),
        ("Varmuusetäisyys", &["turvaetäisyy".to_owned(), "turvallisuusetäisyy".to_owned()][..])
    );
    let csv = exchange::csv(&concepts);
    assert!(csv.contains(
        "\r\nterm-set-up-clearance,fi,Varmuusetäisyys,,varmuusetäisyy | varmuusraja,turvaetäisyy | turvallisuusetäisyy,"
    ));
    let tbx = exchange::tbx(&concepts);
    assert!(tbx.contains("<term>turvaetäisyy</term>\n            <termNote type=\"termType\">variant</termNote>\n            <termNote type=\"administrativeStatus\">deprecatedTerm-admn-sts"));
}

/// Words that are the same in all languages: units, and names that a control prints.
fn is_name(word: &str) -> bool {
    matches!(word, "mm" | "min" | "inch" | "rpm" | "s" | "rev" | "px") || word.chars().skip(1).any(char::is_uppercase)
}

#[test]
fn the_pseudo_language_leaves_nothing_in_english_and_cuts_nothing() {
    let mut files = ciklo::base::data::embedded();
    let kind = exchange::Pseudo::Accents;
    files.extend(exchange::pseudo(&files, kind));
    let (locales, found) = ciklo::language::locale::Locales::load(files.iter().map(|(path, text)| (path, text)));
    assert!(found.is_empty(), "{:?}", found.first());
    let (catalogue, _) = Catalogue::load(&files);
    let (source, own) = (locales.source().unwrap(), locales.language(kind.tag()).unwrap());
    let mut lengths = (0, 0);
    for on in catalogue.controls.values() {
        for cycle in on.cycles.values() {
            let text = |language| {
                let dialog = ciklo::output::dialog::dialog(on, cycle, language).unwrap();
                ciklo::output::dialog::render(&dialog, language).unwrap()
            };
            let (english, pseudo) = (text(source), text(own));
            assert_eq!(pseudo.matches('⟦').count(), pseudo.matches('⟧').count(), "{pseudo}");
            lengths = (lengths.0 + english.chars().count(), lengths.1 + pseudo.chars().count());
            // Fields and forms of the old kind are called by their names in the specification.
            let fields = cycle.params.iter().map(|param| param.label_in(cycle.key.number));
            let forms = cycle.file.forms.iter().map(|form| format!("({})", form.form.as_str()));
            let pseudo = fields.chain(forms).fold(pseudo, |text, field| text.replace(&field, ""));
            for word in pseudo.split(|c: char| !c.is_alphanumeric()).filter(|word| !is_name(word)) {
                let is_english = |c: char| c.is_ascii_lowercase() && !"bfmpqvx".contains(c);
                assert!(!word.contains(is_english), "{word} in {}: {pseudo}", cycle.key);
            }
        }
    }
    assert!(lengths.1 * 10 > lengths.0 * 12, "{lengths:?}");
    // Labels keep their length and the rules of the controls; prompts are longer on purpose.
    let mut labels = ciklo::language::label::check(&catalogue, &locales);
    labels.retain(|found| found.code != "prompt-too-long");
    assert!(labels.is_empty(), "{:?}", labels.first());
}

#[test]
fn a_draft_has_every_text_and_marks_those_that_are_missing() {
    let files = files("a = Aja { $depth } { $feed }.\n");
    let (all, missing) = exchange::draft(&files, "fi").unwrap();
    assert_eq!(missing, 5, "b, b.tip, holes, the term, c");
    let (_, text) = all.iter().find(|(path, _)| path == "locales/fi/a.ftl").unwrap();
    assert!(text.starts_with("a = Aja { $depth } { $feed }.\n"), "{text}");
    assert!(text.contains("c = ⟦The { -probe } waits.⟧") && text.contains("[one] ⟦{ $count } hole⟧"), "{text}");
    assert!(text.contains("-probe = touch probe\n"), "a term has no marks: it stands in marked texts\n{text}");
    let (locales, found) = ciklo::language::locale::Locales::load(all.iter().map(|(path, text)| (path, text)));
    assert!(found.is_empty() && locales.audit("fi").unwrap().missing.is_empty(), "{found:?}");
    assert_eq!(all.len(), files.len());
}

#[test]
fn a_wider_text_with_other_facts_leaves_a_gap() {
    let file = |path: &str, text: &str| (path.to_owned(), text.to_owned());
    let english = "step-a = Drill 5 holes.\nstep-a__odd = Drill 7 holes.\nstep-b = Wait.\nstep-b__odd = Wait here.\n";
    let files = vec![
        file("locales/en/a.ftl", english),
        file("locales/fi/a.ftl", "step-a = Poraa 5 reikää.\nstep-b = Odota.\n"),
    ];
    let (locales, _) = ciklo::language::locale::Locales::load(files.iter().map(|(path, text)| (path, text)));
    let found = ciklo::language::consistency::check(&Catalogue::load(&files).0, &locales);
    assert_eq!(found.iter().map(|found| found.code).collect::<Vec<_>>(), ["consistency-variant"], "{found:?}");
    let text = export(&files, "fi", Form::Po);
    assert!(text.contains("msgctxt \"step-a__odd\"\nmsgid \"Drill 7 holes.\"\nmsgstr \"\"\n"), "{text}");
    assert!(!text.contains("step-b__odd"), "a text with the same facts serves\n{text}");
    let filled = text.replace("holes.\"\nmsgstr \"\"", "holes.\"\nmsgstr \"Poraa 7 reikää.\"");
    let imported = import(&files, "fi", &filled);
    assert!(
        imported.refused.is_empty() && imported.files[0].1.contains("step-a__odd = Poraa 7 reikää.\n"),
        "{imported:?}"
    );
    // An edit of the wider text is no fault of the missing one.
    assert_eq!(import(&files, "fi", &text.replace("Poraa 5", "Tee 5")).taken, ["step-a"]);
    let (draft, missing) = exchange::draft(&files, "fi").unwrap();
    assert_eq!(missing, 1);
    assert!(draft.iter().any(|(_, text)| text.contains("step-a__odd = ⟦Drill 7 holes.⟧\n")), "{draft:?}");
}

fn said(page: &str) -> Vec<(String, String, usize)> {
    let codes =
        |pieces: &[exchange::Piece]| pieces.iter().filter(|piece| matches!(piece, exchange::Piece::Code(_))).count();
    let all = markdown::segments(page).into_iter();
    all.map(|segment| (segment.kind.clone(), markdown::written(&segment.pieces, false), codes(&segment.pieces)))
        .collect()
}

#[test]
fn words_are_segments_and_marks_are_codes() {
    let page = "# Title\n\nOne **two** [three](cycle:A)\nand `four` 2 \\* 3.\n\n- item\n  more\n- \n\n| a | [b](topic:x) |\n|---|---|\n| | 5 |\n\n```\nx\n y\n```\n";
    let expected = [
        ("h1", "Title", 0),
        ("p", "One **two** [three](cycle:A) and `four` 2 \\* 3.", 5),
        ("item", "item more", 0),
        ("cell", "a", 0),
        ("cell", "[b](topic:x)", 2),
        ("cell", "5", 0),
        ("code", "x\n y", 0),
    ];
    let expected = expected.map(|(kind, text, codes)| (kind.to_owned(), text.to_owned(), codes));
    assert_eq!(said(page), expected);
    for segment in markdown::segments(page).iter().filter(|segment| segment.kind != markdown::CODE) {
        assert_eq!(markdown::inline(&markdown::written(&segment.pieces, false)), segment.pieces, "the same alone");
    }
}

#[test]
fn words_change_and_everything_else_stays() {
    let file = "# Comment here\nfirst = Move to { $depth } in { -axis(case: \"x\") }, FMAX\n    .label = SET-UP 2\n    .help =\n        One line\n        and one more\nunit-mm = { $value } mm\nempty =\n    .nc = A B\nholes = { $count ->\n        [one] a hole\n       *[other] { $count } holes\n    }\n";
    let expected = "# Comment here\nfirst = ⟦Möövéé ťöö { $depth } íín { -axis(case: \"x\") }, FMAX⟧\n    .label = ŠÉŤ-ÜP 2\n    .help =\n        ⟦Öñéé ĺííñéé\n        ààñď ööñéé möřéé⟧\nunit-mm = { $value } mm\nempty =\n    .nc = À B\nholes = { $count ->\n        [one] ⟦àà ĥööĺéé⟧\n       *[other] ⟦{ $count } ĥööĺééš⟧\n    }\n";
    let expected = expected.replace("íín", "ííñ").replace("möřéé", "mööřéé");
    let made = exchange::pseudo(&[("locales/en/a.ftl".to_owned(), file.to_owned())], exchange::Pseudo::Accents);
    assert_eq!(made, [(format!("locales/{}/a.ftl", exchange::Pseudo::Accents.tag()), expected)]);
}

const TERMS: &str = "-probe = probe\nterm-depth = Depth\n    .definition = How deep, in all.\n    .forms = depth\nterm-feed = Feed rate\n    .definition = Speed of the { -probe }.\nparameter-depth = Depth\n    .label = DEPTH\n    .help = How deep.\nstep-go = Go to the depth.\n";
const FINNISH_TERMS: &str = "# Sanasto.\n-probe = anturi\nterm-depth =   Syvyys\n    .definition = Kuinka syvä,\n        kaikkiaan.\n    .forms = syvyy\n    .source = 12\nterm-feed = Syöttö\n    .definition = Nopeus ({ -probe }).\nparameter-depth = Syvyys\n    .label = SYVYYS\n    .help = Kuinka syvä.\nstep-go = Aja syvyyteen, pohjalle.\n";

fn with_terms(finnish: &str) -> Vec<(String, String)> {
    let file = |path: &str, text: &str| (path.to_owned(), text.to_owned());
    vec![file("locales/en/a.ftl", TERMS), file("locales/fi/a.ftl", finnish)]
}

/// The files as terms, in both forms.
fn exported_terms(files: &[(String, String)]) -> [String; 2] {
    let (locales, found) = ciklo::language::locale::Locales::load(files.iter().map(|(path, text)| (path, text)));
    assert!(found.is_empty(), "{found:?}");
    let concepts = exchange::concepts(&locales, &["fi".to_owned()]);
    [exchange::csv(&concepts), exchange::tbx(&concepts)]
}

fn import_terms(files: &[(String, String)], text: &str) -> Imported {
    assert!(exchange::is_terms(text), "{text}");
    let rows = exchange::read_terms(text).unwrap_or_else(|refused| panic!("{refused:?}\n{text}"));
    exchange::import_terms(&Catalogue::load(files).0, files, "fi", &rows).unwrap()
}

#[test]
fn terms_that_come_back_change_what_was_changed_and_no_other_byte() {
    let files = with_terms(FINNISH_TERMS);
    for text in exported_terms(&files) {
        let same = import_terms(&files, &text);
        assert!(same.files.is_empty() && same.refused.is_empty() && same.confirmed.is_empty(), "{same:?}");
        assert_eq!(same.unchanged, 3 + 2 + 3, "terms, definitions, forms and the label");
        for (old, new, in_file) in [
            ("SYVYYS", "SYV. & UU", ("SYVYYS", "SYV. & UU")),
            ("syvyy", "syvyy | syvä", ("syvyy\n", "syvyy | syvä\n")),
            ("Kuinka syvä.", "Miten syvä <se> on.", ("Kuinka syvä.", "Miten syvä <se> on.")),
            ("Kuinka syvä, kaikkiaan.", "Miten syvä.", ("Kuinka syvä,\n        kaikkiaan.", "Miten syvä.")),
        ] {
            let new =
                if text.starts_with('<') { new.replace('&', "&amp;").replace('<', "&lt;") } else { new.to_owned() };
            let imported = import_terms(&files, &text.replace(old, &new));
            assert!(imported.refused.is_empty(), "{old}: {:?}", imported.refused);
            let expected = FINNISH_TERMS.replace(in_file.0, in_file.1);
            assert_eq!(imported.files, [("locales/fi/a.ftl".to_owned(), expected)], "{text}");
        }
    }
}

#[test]
fn terms_of_a_language_that_lacks_them_are_added_whole() {
    let files = with_terms("step-go = Aja syvyyteen.\n");
    let head = "concept,language,term,label,forms,forbidden,definition,context\r\n";
    let english =
        "term-depth,en,Depth,,depth,,\"How deep, in all.\",\r\nparameter-depth,en,Depth,DEPTH,,,How deep.,\r\n";
    let rows = "parameter-depth,fi,Syvyys,SYVYYS,,,,\r\nterm-depth,fi,Syvyys,,syvyy,pohja,Määrä.,\r\n";
    let imported = import_terms(&files, &format!("{head}{english}{rows}"));
    assert!(imported.refused.is_empty(), "{:?}", imported.refused);
    let added = "term-depth = Syvyys\n    .definition = Määrä.\n    .forms = syvyy\n    .forbidden = pohja\nparameter-depth = Syvyys\n    .label = SYVYYS\n";
    assert_eq!(imported.files[0].1, format!("step-go = Aja syvyyteen.\n{added}"));
    assert_eq!(imported.confirmed, ["parameter-depth", "parameter-depth.label", "term-depth", "term-depth.definition"]);
}

#[test]
fn terms_that_are_not_sound_are_refused_and_the_others_are_taken() {
    let files = with_terms(FINNISH_TERMS);
    let [table, base] = exported_terms(&files);
    let why = |text: &str| {
        let imported = import_terms(&files, &text.replace("SYVYYS", "SYV."));
        assert_eq!(imported.taken, ["parameter-depth.label"], "the sound half is taken: {imported:?}");
        imported.refused.into_iter().map(|refusal| (refusal.id, refusal.why)).collect::<Vec<_>>()
    };
    for text in [&table, &base] {
        let codes = why(&text.replace("Nopeus (", "Vauhti ("));
        assert!(matches!(&codes[..], [(id, Why::Codes { .. })] if id == "term-feed.definition"), "{codes:?}");
        let changed = why(&text.replace("How deep, in all.", "How high.").replace("kaikkiaan", "yhteensä"));
        assert!(matches!(&changed[..], [(id, Why::SourceChanged)] if id == "term-depth.definition"), "{changed:?}");
        let unknown = why(&text.replace("term-feed", "../term-feed"));
        assert!(matches!(&unknown[..], [(id, Why::Unknown)] if id == "../term-feed"), "{unknown:?}");
        let twice = why(&text.replace("term-feed", "term-depth"));
        assert!(twice.len() == 2 && twice.iter().all(|(_, why)| matches!(why, Why::Twice)), "{twice:?}");
    }
    // A word that other texts use cannot be forbidden.
    let forbidden = why(&table.replace(",syvyy,,", ",syvyy,pohja,"));
    assert!(
        matches!(&forbidden[..], [(id, Why::Found(found))] if id == "term-depth.forbidden" && found.code == "consistency-forbidden"),
        "{forbidden:?}"
    );
    let what = |text: &str| exchange::read_terms(text).map(|_| ()).unwrap_err().what;
    assert_eq!(what(&table.replace("language", "tongue")), "columns");
    assert_eq!(what(&table.replace("Depth,", "Depth,,")), "form");
    let open =
        exchange::read_terms("term,concept,language\nDepth,term-depth,en\n\"Syvyys,term-depth,fi\n").unwrap_err();
    assert_eq!((open.what, open.at), ("quote", "term,concept,language\nDepth,term-depth,en\n".len()));
    assert_eq!(what(&base.replacen("<martif", "<!DOCTYPE martif SYSTEM \"a.dtd\">\n<martif", 1)), "document-type");
    assert_eq!(what(&base.replace("Kuinka", "&a;")), "entity");
    let refused = exchange::read_terms(&table.replace("fi,Syöttö,", "fi,Syöttö,,")).unwrap_err();
    assert_eq!(table.get(refused.at..).map(|rest| rest.starts_with("term-feed,fi")), Some(true), "{refused:?}");
}

#[test]
fn the_columns_of_a_table_may_be_in_any_order_and_in_quotation_marks() {
    let files = with_terms(FINNISH_TERMS);
    let rows =
        [["language", "term", "concept"], ["en", "Depth", "parameter-depth"], ["fi", "Syvennys", "parameter-depth"]];
    for (sign, mark) in [(";", "\""), ("\t", "\""), (",", "")] {
        let table = rows.map(|cells| cells.map(|cell| format!("{mark}{cell}{mark}")).join(sign)).join("\r\n");
        assert!(exchange::is_terms(&table), "{table}");
        let imported = import_terms(&files, &table);
        assert!(imported.refused.is_empty(), "{:?}", imported.refused);
        assert_eq!(imported.taken, ["parameter-depth"], "{table}");
    }
    let po = "# concept, in a comment\nmsgid \"\"\nmsgstr \"\"\n";
    assert!(!exchange::is_terms(po), "a comment is no head of a table");
}
