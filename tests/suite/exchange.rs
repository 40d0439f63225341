//! Texts on their way to translators and back: what is unchanged keeps every byte, what is not sound is refused.
use ciklo::spec::Catalogue;
use ciklo::tools::exchange::{self, Form, Imported, Why};

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
