//! Plans: the registry test over all embedded specifications, and runs with mistakes beside what must be
//! said of them.
//!
//! `tests/engine/plan/bad/*.yaml` begin with lines `# expect: CODE LINE:COLUMN`, in the order of places;
//! `UPDATE=1 cargo test --test engine_plan` rewrites those lines. The files of `tests/engine/plan/base/` are
//! loaded with each of them.
use std::path::Path;
use std::{env, fs};

use ciklo::diag::Diagnostic;
use ciklo::engine::plan;
use ciklo::spec::Catalogue;

fn place(diagnostic: &Diagnostic) -> String {
    diagnostic.place.as_ref().map_or_else(String::new, |place| {
        let start = place.start();
        format!("{}:{}", start.line, start.column)
    })
}

fn line(diagnostic: &Diagnostic) -> String {
    let file = diagnostic.place.as_ref().map_or("", |place| place.source.name());
    let args: Vec<String> = diagnostic.args.iter().map(|(name, value)| format!("{name}={value:?}")).collect();
    format!("{file}:{}: {} {}", place(diagnostic), diagnostic.code, args.join(" "))
}

#[test]
fn every_run_compiles_for_every_control() {
    let (catalogue, _) = Catalogue::load(&ciklo::data::embedded());
    let found = plan::check(&catalogue);
    let shown: Vec<String> = found.iter().map(line).collect();
    assert!(found.is_empty(), "{} mistakes:\n{}", found.len(), shown.join("\n"));
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

#[test]
fn every_mistake_of_a_run_is_found_at_its_place() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/engine/plan");
    let base: Vec<(String, String)> = files_of(&root.join("base"))
        .into_iter()
        .map(|(name, text)| (format!("cycle-specs/{}", name.replace("__", "/")), text))
        .collect();
    let mut failures = Vec::new();
    for (name, text) in files_of(&root.join("bad")) {
        let body: String = text.lines().filter(|l| !l.starts_with("# expect:")).map(|l| format!("{l}\n")).collect();
        let mut files = base.clone();
        files.push((format!("cycle-specs/drilling/{name}"), body.clone()));
        let (catalogue, mut found) = Catalogue::load(&files);
        found.extend(plan::check(&catalogue));
        let key = |d: &Diagnostic| (d.place.as_ref().map(|p| (p.source.name().to_owned(), p.span)), d.code);
        found.sort_by_key(key);
        let said: String = found
            .iter()
            .map(|d| {
                let file = d.place.as_ref().map_or("", |p| p.source.name()).rsplit('/').next().unwrap_or_default();
                let file = if file == name { String::new() } else { format!("{file}:") };
                format!("# expect: {} {file}{}\n", d.code, place(d))
            })
            .collect();
        let expected = format!("{said}{body}");
        if env::var_os("UPDATE").is_some() {
            fs::write(root.join("bad").join(&name), &expected).expect("a writable test file");
        } else if expected != text {
            failures.push(format!("{name} says\n{said}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
