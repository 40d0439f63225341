//! Specifications: the registry test over all embedded files, and files with mistakes beside what
//! must be said of them.
//!
//! `tests/specs/bad/*.yaml` begin with lines `# expect: CODE LINE:COLUMN`, in the order of places;
//! `UPDATE=1 cargo test --test specs` rewrites those lines. The files of `tests/specs/base/` are
//! loaded with each of them.
use std::path::Path;
use std::{env, fs};

use ciklo::data::Files;
use ciklo::diag::{Diagnostic, Severity};
use ciklo::spec::{Catalogue, lint, schema};

fn place(diagnostic: &Diagnostic) -> String {
    diagnostic.place.as_ref().map_or_else(String::new, |place| {
        let start = place.start();
        format!("{}:{}", start.line, start.column)
    })
}

/// A diagnostic as one line: file, place, code, arguments.
fn line(diagnostic: &Diagnostic) -> String {
    let file = diagnostic.place.as_ref().map_or("", |place| place.source.name());
    let args: Vec<String> = diagnostic.args.iter().map(|(name, value)| format!("{name}={value:?}")).collect();
    format!("{file}:{}: {} {} {}", place(diagnostic), diagnostic.severity.as_str(), diagnostic.code, args.join(" "))
}

#[test]
fn every_file_reads_and_is_free_of_errors() {
    let (catalogue, mut found) = Catalogue::load(&ciklo::data::embedded());
    found.extend(lint(&catalogue));
    let (errors, warnings): (Vec<_>, Vec<_>) = found.iter().partition(|d| d.severity == Severity::Error);
    let show = |list: &[&Diagnostic]| list.iter().map(|d| line(d)).collect::<Vec<_>>().join("\n");
    println!("{} warnings:\n{}", warnings.len(), show(&warnings));
    assert!(errors.is_empty(), "{} errors:\n{}", errors.len(), show(&errors));
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
fn every_mistake_is_found_at_its_place_in_one_run() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/specs");
    let base: Files = files_of(&root.join("base"))
        .into_iter()
        .map(|(name, text)| (format!("cycle-specs/{}", name.replace("__", "/")), text))
        .collect();
    let mut failures = Vec::new();
    for (name, text) in files_of(&root.join("bad")) {
        let body: String = text.lines().filter(|l| !l.starts_with("# expect:")).map(|l| format!("{l}\n")).collect();
        let mut files = base.clone();
        let path = format!("cycle-specs/drilling/{name}");
        files.push((path.clone(), body.clone()));
        let (catalogue, mut found) = Catalogue::load(&files);
        found.extend(lint(&catalogue));
        let ours = |d: &&Diagnostic| d.place.as_ref().is_some_and(|p| p.source.name() == path);
        let mut said: Vec<_> =
            found.iter().filter(ours).map(|d| (d.place.as_ref().map(|p| p.span), d.code, place(d))).collect();
        said.sort();
        let said: String = said.iter().map(|(_, code, place)| format!("# expect: {code} {place}\n")).collect();
        let expected = format!("{said}{body}");
        if env::var_os("UPDATE").is_some() {
            fs::write(root.join("bad").join(&name), &expected).expect("a writable test file");
        } else if expected != text {
            failures.push(format!("{name} says\n{said}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn every_file_fits_the_schema() {
    let mut compiler = boon::Compiler::new();
    let mut schemas = boon::Schemas::new();
    compiler.add_resource("file:///schema.json", schema()).expect("the schema is JSON");
    let id = compiler.compile("file:///schema.json", &mut schemas).expect("the schema is a JSON Schema");
    let mut seen = 0;
    for (path, text) in ciklo::data::embedded() {
        if !path.starts_with("cycle-specs/") || path.contains("/machines/") || !path.ends_with(".yaml") {
            continue;
        }
        let value: serde_json::Value = serde_yaml::from_str(&text).expect("YAML");
        let result = schemas.validate(&value, id);
        assert!(result.is_ok(), "{path}: {:#}", result.err().expect("an error"));
        seen += 1;
    }
    assert!(seen > 0, "no file was looked at");
}
