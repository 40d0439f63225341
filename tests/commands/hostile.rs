//! Data that is broken on purpose: what is wrong is said, with its place, and nothing overflows, hangs or fills memory.
use ciklo::base::data::Files;
use ciklo::engine::plan;
use ciklo::spec::Catalogue;

const DRILLING: &str = "cycle-specs/drilling/200-drilling.yaml";

/// The embedded files with one text replaced in the description of drilling.
fn files_with(old: &str, new: &str) -> Files {
    let mut files = ciklo::base::data::embedded();
    let (_, text) = files.iter_mut().find(|(path, _)| path == DRILLING).expect("drilling is described");
    assert!(text.contains(old), "{old} stands in the file");
    *text = text.replacen(old, new, 1);
    files
}

/// The codes of all errors of the files, with the files where they are.
fn errors(files: &Files) -> Vec<(String, &'static str)> {
    let (catalogue, mut found) = Catalogue::load(files);
    found.extend(plan::check(&catalogue));
    let file = |place: &ciklo::base::diag::Place| place.source.name().to_owned();
    found.iter().map(|it| (it.place.as_ref().map(file).unwrap_or_default(), it.code)).collect()
}

fn assert_found(files: &Files, path: &str, code: &str) {
    let found = errors(files);
    assert!(found.iter().any(|(file, found)| file == path && *found == code), "{code} in {path}: {found:?}");
}

#[test]
fn a_chain_of_operators_is_no_deeper_than_the_stack() {
    let chain = format!("clear: \"1{}\"", "+1".repeat(50_000));
    assert_found(&files_with("clear: Q203 - dir * Q200", &chain), DRILLING, "spec-expression");
    // The longest that is allowed works.
    let chain = format!("clear: \"1{}\"", "+1".repeat(190));
    assert_eq!(errors(&files_with("clear: Q203 - dir * Q200", &chain)), []);
}

#[test]
fn fragments_that_multiply_are_refused() {
    let mut files = files_with("do: [{rapid: {tool: clear}}]", "do: [{rapid: {tool: clear}}, {use: f0}]");
    for level in 0..9 {
        let uses = format!("  - {{use: f{}}}\n", level + 1).repeat(10);
        files.push((format!("cycle-specs/fragments/f{level}.yaml"), format!("fragment: f{level}\ndo:\n{uses}")));
    }
    files.push(("cycle-specs/fragments/f9.yaml".to_owned(), "fragment: f9\ndo:\n  - {dwell: 1}\n".to_owned()));
    let found = errors(&files);
    assert_eq!(found.iter().filter(|(_, code)| *code == "plan-too-many-fragments").count(), 1, "{found:?}");
}

#[test]
fn an_empty_file_is_a_mistake() {
    let mut files = ciklo::base::data::embedded();
    for (path, text) in &mut files {
        if path == DRILLING {
            text.clear();
        }
    }
    assert_found(&files, DRILLING, "spec-yaml-feature");
}
