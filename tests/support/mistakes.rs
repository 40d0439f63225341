//! Specifications with mistakes beside what must be said of them.
//!
//! `<folder>/bad/*.yaml` (or `<folder>__*.yaml`) begin with lines `# expect: CODE LINE:COLUMN`, in the order of places; what is said of
//! another file has its name before the line. The files of `<folder>/base/` are loaded with each of them;
//! `UPDATE=1 cargo test` rewrites the lines.
use std::path::Path;
use std::{env, fs};

use ciklo::base::diag::Diagnostic;
use ciklo::spec::Catalogue;

fn source(diagnostic: &Diagnostic) -> &str {
    diagnostic.place.as_ref().map_or("", |place| place.source.name())
}

fn place(diagnostic: &Diagnostic) -> String {
    diagnostic.place.as_ref().map_or_else(String::new, |place| {
        let text = place.source.text();
        assert!(
            text.get(place.span.start..place.span.end).is_some(),
            "{}: {:?} is no place",
            source(diagnostic),
            place.span
        );
        let start = place.start();
        format!("{}:{}", start.line, start.column)
    })
}

/// A diagnostic as one line: file, place, severity, code, arguments.
pub(crate) fn line(diagnostic: &Diagnostic) -> String {
    let args: Vec<String> = diagnostic.args.iter().map(|(name, value)| format!("{name}={value:?}")).collect();
    let (file, place, severity) = (source(diagnostic), place(diagnostic), diagnostic.severity.as_str());
    format!("{file}:{place}: {severity} {} {}", diagnostic.code, args.join(" "))
}

fn files_of(dir: &Path) -> Vec<(String, String)> {
    let entries = fs::read_dir(dir).expect("a directory of the tests");
    let mut files: Vec<(String, String)> = entries
        .map(|entry| {
            let path = entry.expect("an entry").path();
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            (name, fs::read_to_string(&path).expect("a text"))
        })
        .collect();
    files.sort();
    files
}

/// Compares what is said of every file with its head. `find` looks beyond the form of the files; findings count
/// as far as they are `wanted`, given with the path of the file in question.
pub(crate) fn compare(
    folder: &str,
    find: fn(&Catalogue) -> Vec<Diagnostic>,
    wanted: fn(&Diagnostic, &str) -> bool,
) -> Result<(), String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let base = files_of(&root.join("base"));
    let base = base.into_iter().map(|(name, text)| (format!("cycle-specs/{}", name.replace("__", "/")), text));
    let base: Vec<(String, String)> = base.collect();
    let mut failures = Vec::new();
    for (name, text) in files_of(&root.join("bad")) {
        let body: String = text.lines().filter(|l| !l.starts_with("# expect:")).map(|l| format!("{l}\n")).collect();
        // Without a folder in its name it is a file of the first group.
        let path = match name.split_once("__") {
            Some((folder, file)) => format!("cycle-specs/{folder}/{file}"),
            None => format!("cycle-specs/drilling/{name}"),
        };
        let mut files = base.clone();
        files.push((path.clone(), body.clone()));
        let (catalogue, mut found) = Catalogue::load(&files);
        found.extend(find(&catalogue));
        found.retain(|diagnostic| wanted(diagnostic, &path));
        found.sort_by_key(|d| (source(d).to_owned(), d.place.as_ref().map(|place| place.span), d.code));
        let said = found.iter().map(|d| {
            let file = source(d).rsplit('/').next().unwrap_or_default();
            let file = if path.ends_with(&format!("/{file}")) { String::new() } else { format!("{file}:") };
            format!("# expect: {} {file}{}\n", d.code, place(d))
        });
        let said: String = said.collect();
        let expected = format!("{said}{body}");
        if env::var_os("UPDATE").is_some() {
            fs::write(root.join("bad").join(&name), &expected).expect("a writable test file");
        } else if expected != text {
            failures.push(format!("{name} says\n{said}"));
        }
    }
    if failures.is_empty() { Ok(()) } else { Err(failures.join("\n")) }
}
