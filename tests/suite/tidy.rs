//! The house rules that the compiler does not hold: dependencies between modules, heads and sizes of
//! files, words that do not belong in the library.
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Which modules a module may use. They are one crate, so only this table holds the layers.
/// A module never uses one that stands below it.
const LAYERS: &[(&str, &[&str])] = &[
    ("base::data", &[]),
    ("base::demand", &[]),
    ("base::diag", &[]),
    ("base::parallel", &[]),
    ("base::renamed", &[]),
    ("base::xml", &[]),
    ("base::expr", &["base::diag"]),
    ("spec", &["base::data", "base::demand", "base::diag", "base::expr"]),
    ("language::locale", &["base::data", "base::demand", "base::diag", "base::parallel"]),
    ("language::text", &["base::diag", "base::expr", "spec", "language::locale"]),
    ("language::label", &["base::diag", "base::expr", "spec", "language::locale", "language::text"]),
    ("language::consistency", &["base::diag", "base::parallel", "spec", "language::locale", "language::text"]),
    ("program::syntax", &["base::diag", "base::expr"]),
    ("program::fields", &["spec", "program::syntax"]),
    ("program::table", &["base::diag"]),
    ("program::layout", &["base::diag", "program::syntax"]),
    ("program::iso", &["base::diag", "base::expr", "spec", "program::syntax", "program::fields"]),
    (
        "check",
        &[
            "base::diag",
            "base::renamed",
            "base::expr",
            "spec",
            "language::locale",
            "language::text",
            "program::syntax",
            "program::fields",
        ],
    ),
    (
        "engine",
        &["base::diag", "base::parallel", "base::expr", "spec", "program::syntax", "program::fields", "program::table"],
    ),
    ("tools::certify", &["base::diag", "spec", "program::syntax", "check"]),
    ("tools::translate", &["base::diag", "program::syntax", "check"]),
    ("tools::compare", &["base::diag", "program::syntax", "check"]),
    (
        "tools::convert",
        &["base::diag", "base::expr", "spec", "language::locale", "language::label", "program::syntax", "check"],
    ),
    (
        "tools::conform",
        &[
            "base::diag",
            "base::parallel",
            "base::expr",
            "spec",
            "language::locale",
            "language::text",
            "language::label",
            "program::syntax",
            "engine",
        ],
    ),
    (
        "tools::rehearse",
        &["base::diag", "spec", "program::fields", "program::syntax", "program::table", "check", "engine"],
    ),
    ("tools::coverage", &["base::diag", "base::expr", "spec", "language::locale", "engine"]),
    (
        "tools::exchange",
        &[
            "base::diag",
            "base::xml",
            "spec",
            "language::locale",
            "language::text",
            "language::label",
            "language::consistency",
        ],
    ),
    ("output::export", &["base::diag", "spec", "language::locale", "language::text"]),
    ("output::dialog", &["base::diag", "spec", "language::locale", "language::text", "output::export"]),
    (
        "output::figure",
        &["base::diag", "base::expr", "spec", "language::text", "program::syntax", "engine", "tools::conform"],
    ),
    (
        "output::manual",
        &[
            "base::diag",
            "base::parallel",
            "base::xml",
            "base::expr",
            "spec",
            "language::locale",
            "language::text",
            "program::syntax",
            "language::label",
            "output::dialog",
            "output::export",
            "output::figure",
            "check",
            "tools::translate",
            "tools::conform",
            "tools::exchange",
        ],
    ),
    ("system", &["base::diag"]),
    (
        "cli",
        &[
            "base::data",
            "base::diag",
            "base::parallel",
            "base::renamed",
            "base::expr",
            "spec",
            "language::locale",
            "language::text",
            "program::syntax",
            "language::label",
            "language::consistency",
            "output::dialog",
            "output::export",
            "output::figure",
            "output::manual",
            "check",
            "tools::certify",
            "tools::translate",
            "tools::compare",
            "tools::convert",
            "program::iso",
            "program::layout",
            "program::table",
            "engine",
            "tools::conform",
            "tools::coverage",
            "tools::exchange",
            "tools::rehearse",
            "system",
        ],
    ),
];

/// Longest file that a newcomer can be asked to read.
const MAX_LINES: usize = 700;

fn sources(dir: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(dir).expect("a source directory") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|ext| ext == "rs") {
            found.push(path);
        }
    }
}

pub(super) fn all() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut paths = Vec::new();
    sources(&root, &mut paths);
    let name = |path: &Path| path.strip_prefix(&root).expect("below src").to_string_lossy().replace('\\', "/");
    let mut files: Vec<_> =
        paths.iter().map(|path| (name(path), fs::read_to_string(path).expect("a source file"))).collect();
    files.sort();
    files
}

/// Whether a directory of `src/` only groups modules.
fn is_group(name: &str) -> bool {
    LAYERS.iter().any(|(module, _)| module.split_once("::").is_some_and(|(group, _)| group == name))
}

/// `engine/run/mod.rs` belongs to `engine`, `base/diag.rs` and `program/iso/words.rs` to `base::diag` and
/// `program::iso`. The head of a group belongs to the group.
fn module(file: &str) -> String {
    let mut parts = file.trim_end_matches(".rs").split('/');
    let first = parts.next().unwrap_or_default();
    match parts.next() {
        Some(second) if is_group(first) && second != "mod" => format!("{first}::{second}"),
        _ => first.to_owned(),
    }
}

/// The modules that a text uses as `crate::x` or `crate::group::x`.
fn uses(text: &str) -> BTreeSet<String> {
    let word = |text: &str| text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
    let mut found = BTreeSet::new();
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    for line in code {
        for (at, _) in line.match_indices("crate::") {
            let rest = &line[at + "crate::".len()..];
            let first = word(rest);
            match rest[first.len()..].strip_prefix("::") {
                Some(inner) if is_group(&first) => {
                    let list = inner.strip_prefix('{').map_or(inner, |list| list.split('}').next().unwrap_or(list));
                    let names = if inner.starts_with('{') { list.split(',').collect() } else { vec![list] };
                    found.extend(names.into_iter().map(|name| format!("{first}::{}", word(name.trim()))));
                }
                _ if !first.is_empty() => _ = found.insert(first),
                _ => {}
            }
        }
    }
    found
}

#[test]
fn modules_use_only_what_stands_above_them() {
    let layers: BTreeMap<&str, &[&str]> = LAYERS.iter().copied().collect();
    let mut wrong = Vec::new();
    for (file, text) in all() {
        let own = module(&file);
        if matches!(own.as_str(), "lib" | "main") || (is_group(&own) && file.ends_with("/mod.rs")) {
            continue;
        }
        let Some(allowed) = layers.get(own.as_str()) else {
            wrong.push(format!("{file}: the module {own} is not in the table of layers"));
            continue;
        };
        for used in uses(&text) {
            if used != own && layers.contains_key(used.as_str()) && !allowed.contains(&used.as_str()) {
                wrong.push(format!("{file}: {own} may not use {used}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_table_of_layers_has_no_cycle() {
    for (index, (module, allowed)) in LAYERS.iter().enumerate() {
        for used in *allowed {
            let place = LAYERS.iter().position(|(name, _)| name == used);
            assert!(place.is_some_and(|place| place < index), "{module} uses {used}, which stands below it");
        }
    }
}

#[test]
fn every_file_has_a_head_and_a_size_to_read() {
    let mut wrong = Vec::new();
    for (file, text) in all() {
        if !text.starts_with("//! ") {
            wrong.push(format!("{file}: does not begin with what it is (`//! …`)"));
        }
        let lines = text.lines().count();
        if lines > MAX_LINES {
            wrong.push(format!("{file}: {lines} lines, more than {MAX_LINES}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A file that no `mod` names is neither compiled nor tested, and nothing else would say so.
#[test]
fn every_file_is_a_module_of_its_directory() {
    let files = all();
    let mut wrong = Vec::new();
    for (file, _) in &files {
        let path = file.trim_end_matches(".rs").trim_end_matches("/mod");
        let (directory, name) = path.rsplit_once('/').unwrap_or(("", path));
        if directory.is_empty() && matches!(name, "lib" | "main") {
            continue;
        }
        let parents = match directory {
            "" => vec!["lib.rs".to_owned()],
            _ => vec![format!("{directory}/mod.rs"), format!("{directory}.rs")],
        };
        let declared = |text: &str| text.lines().any(|line| line.trim().ends_with(&format!("mod {name};")));
        if !files.iter().any(|(parent, text)| parents.contains(parent) && declared(text)) {
            wrong.push(format!("{file}: no `mod {name};` in {}", parents[0]));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The map shows the modules in the order in which they may use each other.
#[test]
fn the_map_names_the_modules_in_the_order_of_the_layers() {
    let map = include_str!("../../ARCHITECTURE.md");
    let rows = map.lines().skip_while(|line| !line.starts_with("| module |")).take_while(|line| line.starts_with('|'));
    let first = |row: &str| row.split('|').nth(1).unwrap_or_default().to_owned();
    let cells: String = rows.map(first).collect();
    let named: Vec<&str> = cells.split('`').skip(1).step_by(2).collect();
    assert_eq!(named, LAYERS.iter().map(|(module, _)| *module).collect::<Vec<_>>());
}

/// Only the command line and the system below it speak to the world.
#[test]
fn the_library_does_not_touch_files_environment_or_terminal() {
    let words = ["std::fs", "std::env", "std::process", "println!", "print!(", "eprintln!", "dbg!("];
    let mut wrong = Vec::new();
    for (file, text) in all() {
        if matches!(module(&file).as_str(), "cli" | "system" | "main") {
            continue;
        }
        for (number, line) in text.lines().enumerate() {
            if line.trim_start().starts_with("//") {
                continue;
            }
            wrong.extend(
                words.iter().filter(|word| line.contains(*word)).map(|word| format!("{file}:{}: {word}", number + 1)),
            );
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The same input gives the same bits on every machine: `f64` asks the machine's own library for these.
#[test]
fn trigonometry_does_not_depend_on_the_machine() {
    let words = [
        ".sin()",
        ".cos()",
        ".tan()",
        ".sin_cos()",
        ".asin()",
        ".acos()",
        ".atan()",
        ".atan2(",
        ".hypot(",
        ".exp()",
        ".ln()",
        ".log10()",
        ".powf(",
        ".cbrt()",
    ];
    let mut wrong = Vec::new();
    for (file, text) in all() {
        for (number, line) in text.lines().enumerate() {
            wrong.extend(
                words.iter().filter(|word| line.contains(*word)).map(|word| format!("{file}:{}: {word}", number + 1)),
            );
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Unfinished places and switched-off tests are not left behind.
#[test]
fn nothing_is_left_unfinished() {
    let words = ["todo!", "unimplemented!", "#[ignore", "FIXME", "XXX"];
    let mut wrong = Vec::new();
    for (file, text) in all() {
        for (number, line) in text.lines().enumerate() {
            wrong.extend(
                words.iter().filter(|word| line.contains(*word)).map(|word| format!("{file}:{}: {word}", number + 1)),
            );
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What is known of a cycle stands in its specification.
#[test]
fn no_cycle_number_stands_in_the_sources() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("cycle-specs");
    let mut numbers = BTreeSet::new();
    for group in fs::read_dir(root).expect("the specifications") {
        let group = group.expect("an entry").path();
        for file in fs::read_dir(&group).into_iter().flatten() {
            let name = file.expect("an entry").file_name().to_string_lossy().into_owned();
            let number: String = name.chars().take_while(char::is_ascii_digit).collect();
            // Short numbers are too common to mean a cycle.
            if number.len() == 3 && name[number.len()..].starts_with('-') {
                numbers.insert(number);
            }
        }
    }
    let mut wrong = Vec::new();
    for (file, text) in all() {
        for (line_number, line) in text.lines().enumerate() {
            if line.trim_start().starts_with("//") {
                continue;
            }
            let words = line.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '.'));
            wrong.extend(
                words.filter(|word| numbers.contains(*word)).map(|word| format!("{file}:{}: {word}", line_number + 1)),
            );
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Findings at one place come in the order of the rules, which is that of their codes.
#[test]
fn rules_are_in_the_order_of_their_names() {
    let text =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/check/rules/mod.rs")).expect("the rules");
    let list = text.split("pub const RULES").nth(1).and_then(|rest| rest.split("];").next()).expect("the list");
    let names: Vec<&str> = list.lines().filter_map(|line| line.trim().strip_suffix("::RULE,")).collect();
    assert!(names.len() > 100 && names.is_sorted(), "{:?}", names.windows(2).find(|pair| pair[0] > pair[1]));
}

/// The library and the program are not built for tests inside of them: such tests would never run.
#[test]
fn tests_are_not_in_the_sources() {
    let hidden: Vec<_> = all()
        .into_iter()
        .filter(|(_, text)| text.contains("cfg(test)") || text.contains("#[test]"))
        .map(|(file, _)| file)
        .collect();
    assert!(hidden.is_empty(), "{hidden:?}");
}
