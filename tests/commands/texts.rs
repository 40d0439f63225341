//! `ciklo texts` as a process: a language that is only a folder, texts of the program from the working copy, several files
//! taken over together.
#[path = "../support/small.rs"]
mod small;

use std::path::Path;
use std::process::{Command, Output, Stdio};

/// A working copy of the small catalogue with the texts of the program.
fn copy() -> tempfile::TempDir {
    let root = tempfile::tempdir().unwrap();
    let is_general = |path: &str| {
        let name = path.strip_prefix("locales/en/").unwrap_or_default();
        path.starts_with("templates/")
            || ["cli", "diag-", "explain-", "site", "text", "units"].iter().any(|it| name.starts_with(it))
    };
    for (path, text) in small::files(is_general) {
        put(root.path(), &path, &text);
    }
    root
}

fn put(root: &Path, name: &str, text: &str) {
    let path = root.join(name);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::write(path, text).unwrap();
}

fn run(root: &Path, arguments: &[&str]) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ciklo"));
    let command = command.args(["--data", "."]).args(arguments).current_dir(root).stdin(Stdio::null());
    let Output { status, stdout, stderr } = command.env("LC_ALL", "C").output().unwrap();
    let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
    (status.code().unwrap(), text(&stdout), text(&stderr))
}

/// All files below `locales/de`.
fn german(root: &Path) -> Vec<(String, String)> {
    let Ok(folder) = std::fs::read_dir(root.join("locales/de")) else { return Vec::new() };
    let paths = folder.map(|entry| entry.unwrap().path());
    let file = |path: std::path::PathBuf| {
        (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read_to_string(&path).unwrap())
    };
    let mut all: Vec<_> = paths.filter(|path| path.is_file()).map(file).collect();
    all.sort();
    all
}

#[test]
fn an_empty_folder_is_a_language_whose_texts_are_counted() {
    let root = copy();
    let root = root.path();
    assert_eq!(run(root, &["texts", "status", "--lang", "de"]).0, 2, "there is no such language");
    std::fs::create_dir(root.join("locales/de")).unwrap();
    let (code, counts, _) = run(root, &["texts", "status", "--lang", "de"]);
    assert_eq!(code, 0);
    let lines: Vec<&str> = counts.lines().collect();
    assert!(lines[0].starts_with("de: 0 of ") && lines[0].contains(" missing"), "{counts}");
    assert!(lines.iter().any(|line| line.contains("small.ftl: 0 of ")), "{counts}");
    let named = lines.iter().filter(|line| line.starts_with("    ")).count();
    assert_eq!(named, 20 + 1, "the next twenty, and how many follow:\n{counts}");
    let (code, found, _) = run(root, &["lint"]);
    assert_eq!(code, 1, "{found}");
    let of_german = found.lines().filter(|line| line.contains("“de”")).count();
    assert_eq!(of_german, 1, "one line for all that is missing:\n{found}");
    assert!(found.contains("error[locale-unfinished]"), "{found}");
    let (_, each, _) = run(root, &["lint", "--format", "json"]);
    assert!(each.lines().filter(|line| line.contains("locale-missing-translation")).count() > 100, "each one in JSON");
}

#[test]
fn the_program_speaks_a_language_of_the_working_copy() {
    let root = copy();
    let root = root.path();
    let line = "cli-texts-count = { $name }: { $translated } von { $texts } übersetzt\n";
    put(root, "locales/de/cli-texts.ftl", line);
    let (code, counts, _) = run(root, &["texts", "status", "--lang", "de", "--ui-lang", "de"]);
    assert_eq!(code, 0);
    assert!(counts.starts_with("de: 0 von "), "{counts}");
    let (code, _, help) = run(root, &["texts", "status", "--lang", "xx", "--ui-lang", "de"]);
    assert_eq!(code, 2);
    assert!(help.contains("error"), "what the copy lacks is in English: {help}");
    // A language that only the program has is spoken, too; one that neither has is refused.
    assert!(run(root, &["texts", "status", "--ui-lang", "fi"]).1.contains("käännetty"));
    assert_eq!(run(root, &["texts", "status", "--ui-lang", "nl"]).0, 2);
}

fn po(units: &[(&str, &str, &str)]) -> String {
    let mut text = "msgid \"\"\nmsgstr \"\"\n\"Language: de\\n\"\n".to_owned();
    for (key, source, target) in units {
        text += &format!("\nmsgctxt \"{key}\"\nmsgid \"{source}\"\nmsgstr \"{target}\"\n");
    }
    text
}

#[test]
fn several_files_are_taken_over_together_or_not_at_all() {
    let root = copy();
    let root = root.path();
    let drilling = ("cycle-group-drilling", "Drilling", "Bohren");
    let transforms = ("cycle-group-transforms", "Transformations", "Koordinaten-Umrechnung");
    put(root, "one.po", &po(&[drilling]));
    put(root, "two.po", &po(&[transforms, ("no-such-text", "A", "B")]));
    put(root, "broken.xlf", "<xliff version=\"1.2\"><file target-language=\"de\">");
    let (code, _, told) = run(root, &["texts", "import", "one.po", "broken.xlf"]);
    assert_eq!(code, 2, "{told}");
    assert!(german(root).is_empty(), "nothing of the first one");
    let (code, _, told) = run(root, &["texts", "import", "one.po", "two.po", "--dry-run"]);
    assert_eq!((code, german(root).len()), (1, 0), "{told}");
    let (code, found, told) = run(root, &["texts", "import", "one.po", "two.po"]);
    assert_eq!(code, 1, "one unit is refused");
    assert!(found.contains("texts-unit-unknown") && found.contains("two.po:"), "{found}");
    assert_eq!(
        told.lines().filter(|line| line.starts_with("de: ")).count(),
        2 + 1,
        "a line a file, and one for what is accepted"
    );
    let files = german(root);
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["small.ftl", "source.lock"]);
    assert!(
        files[0].1.contains("cycle-group-drilling = Bohren\n") && files[0].1.contains("= Koordinaten-Umrechnung\n")
    );
    assert_eq!(files[1].1.lines().filter(|line| line.starts_with("cycle-group-")).count(), 2, "both are accepted");
}

#[test]
fn a_file_without_anything_in_it_is_refused_and_the_pseudo_language_is_seen_whatever_language_is_asked_for() {
    let root = copy();
    let root = root.path();
    for name in ["nothing.xlf", "nothing.csv"] {
        put(root, name, "\u{feff} \n");
        let (code, _, told) = run(root, &["texts", "import", name, "--to", "de"]);
        assert!(code == 2 && told.contains("texts-file-unreadable") && told.contains("empty"), "{told}");
    }
    let plain = run(root, &["--ui-lang", "en", "texts", "--help"]);
    let pseudo = run(root, &["--ui-lang", "en", "--pseudo", "texts", "--help"]);
    assert!(plain.1.contains("Usage") && !pseudo.1.contains("Usage"), "{}", pseudo.1);
    assert_eq!(pseudo.1, run(root, &["--pseudo", "texts", "--help"]).1);
}
