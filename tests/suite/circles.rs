//! The house rules about what imports what: no large circle of files, and the rooms inside the engine in their order.
use std::collections::{BTreeMap, BTreeSet};

use super::tidy::all;

/// A circle of imports of so many files is the largest that a reader can hold in mind.
const MOST: usize = 4;

/// The rooms of the engine, and which of the rooms before it each may use.
const ENGINE: &[(&str, &[&str])] = &[
    ("geometry", &[]),
    ("read", &["geometry"]),
    ("region", &[]),
    ("sphere", &["geometry"]),
    ("machine", &["geometry", "read"]),
    ("solid", &["geometry", "region", "machine"]),
    ("scene", &["geometry", "read", "machine", "solid"]),
    ("params", &[]),
    ("report", &["geometry", "machine", "solid", "scene", "params"]),
    ("strategy", &["geometry", "region", "sphere", "machine", "report"]),
    ("plan", &["geometry", "report", "strategy"]),
    ("world", &["geometry", "machine", "solid", "scene", "report"]),
    ("motion", &["geometry", "region", "machine", "solid", "scene", "report", "world"]),
    ("contour", &["geometry", "report", "world", "motion"]),
    (
        "flow",
        &[
            "geometry", "machine", "scene", "region", "strategy", "plan", "params", "report", "world", "motion",
            "contour",
        ],
    ),
    (
        "cycle",
        &[
            "geometry", "region", "sphere", "machine", "solid", "scene", "params", "report", "strategy", "plan",
            "world", "motion", "contour", "flow",
        ],
    ),
    (
        "run",
        &[
            "geometry", "machine", "solid", "scene", "plan", "params", "report", "world", "motion", "contour", "flow",
            "cycle",
        ],
    ),
    ("stock", &["geometry", "region", "machine", "solid", "scene", "report"]),
];

/// The rooms of the checker, folders and files, from the ground up: a room uses only those before it.
const CHECKER: &[&str] = &[
    "cycle",
    "against",
    "machine",
    "program",
    "toolwords",
    "slip",
    "incident",
    "first_way",
    "flow",
    "facts",
    "speech",
    "tools",
    "early",
    "guards",
    "blank",
    "contours",
    "spikes",
    "floors",
    "milled",
    "outcomes",
    "loops",
    "travel",
    "rule",
    "rules",
    "allow",
    "config",
];

/// The source files as modules.
struct Tree {
    /// By module path: its file.
    modules: BTreeMap<Vec<String>, String>,
    /// By file: its module path, and its code without comments and tests.
    files: BTreeMap<String, (Vec<String>, String)>,
    /// By module path: names that it hands on, and where they come from.
    handed_on: BTreeMap<Vec<String>, BTreeMap<String, Vec<String>>>,
}

fn words(path: &str) -> Vec<String> {
    path.split("::").map(str::to_owned).collect()
}

/// The code of a file without its comments.
fn code(text: &str) -> String {
    text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

/// The paths of an import or of a place in the code: `a::{b, c::d}` is `a::b` and `a::c::d`.
fn paths(text: &str) -> Vec<Vec<String>> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let word: String = text.chars().take_while(|c| is_word(*c)).collect();
    if word.is_empty() {
        return vec![Vec::new()];
    }
    let Some(rest) = text[word.len()..].strip_prefix("::") else { return vec![vec![word]] };
    let mut found = Vec::new();
    if let Some(list) = rest.strip_prefix('{') {
        let (mut depth, mut begin) = (0, 0);
        for (at, c) in list.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth > 0 => depth -= 1,
                ',' | '}' => {
                    if depth == 0 {
                        found.extend(paths(list[begin..at].trim_start()));
                        begin = at + 1;
                    }
                    if c == '}' && depth == 0 {
                        break;
                    }
                }
                _ => {}
            }
        }
    } else {
        found = paths(rest);
    }
    found.into_iter().map(|path| std::iter::once(word.clone()).chain(path).collect()).collect()
}

impl Tree {
    fn new() -> Self {
        let mut tree = Self { modules: BTreeMap::new(), files: BTreeMap::new(), handed_on: BTreeMap::new() };
        for (file, text) in all() {
            let path = file.trim_end_matches(".rs").trim_end_matches("/mod");
            let module = if matches!(path, "lib" | "main") { Vec::new() } else { words(&path.replace('/', "::")) };
            if path != "main" {
                tree.modules.insert(module.clone(), file.clone());
            }
            tree.files.insert(file, (module, code(&text)));
        }
        let mut handed_on = BTreeMap::new();
        for (module, text) in tree.files.values() {
            let mut names = BTreeMap::new();
            for statement in text.split(';').map(str::trim) {
                let Some((head, rest)) = statement.split_once("use ") else { continue };
                if head.lines().last().is_none_or(|line| !line.trim_start().starts_with("pub")) {
                    continue;
                }
                for path in paths(rest) {
                    if let (Some(name), path) = (path.last().cloned(), tree.absolute(module, &path)) {
                        names.insert(name, path);
                    }
                }
            }
            handed_on.insert(module.clone(), names);
        }
        tree.handed_on = handed_on;
        tree
    }

    /// A path as it is seen from the root of the crate.
    fn absolute(&self, module: &[String], path: &[String]) -> Vec<String> {
        let mut from = module.to_vec();
        let mut rest = path;
        match path.first().map(String::as_str) {
            Some("crate") => (from, rest) = (Vec::new(), &path[1..]),
            Some("self") => rest = &path[1..],
            _ => {}
        }
        while let Some((first, behind)) = rest.split_first().filter(|(first, _)| *first == "super") {
            debug_assert_eq!(first, "super");
            from.pop();
            rest = behind;
        }
        from.extend(rest.iter().cloned());
        from
    }

    /// The file that defines what a path names.
    fn file_of(&self, path: &[String]) -> Option<&str> {
        let mut module = Vec::new();
        for (at, word) in path.iter().enumerate() {
            module.push(word.clone());
            if self.modules.contains_key(&module) {
                continue;
            }
            module.pop();
            if let Some(target) = self.handed_on.get(&module).and_then(|names| names.get(word)) {
                let target: Vec<String> = target.iter().chain(&path[at + 1..]).cloned().collect();
                return if target == path { None } else { self.file_of(&target) };
            }
            break;
        }
        self.modules.get(&module).map(String::as_str)
    }

    /// Which files each file imports.
    fn imports(&self) -> BTreeMap<&str, BTreeSet<&str>> {
        let mut arrows: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        for (file, (module, text)) in &self.files {
            let found = arrows.entry(file.as_str()).or_default();
            let children: Vec<String> = self
                .modules
                .keys()
                .filter(|other| other.len() == module.len() + 1 && other.starts_with(module))
                .filter_map(|other| other.last().cloned())
                .collect();
            let starts = ["crate", "super", "self"].into_iter().chain(children.iter().map(String::as_str));
            for start in starts {
                for (at, _) in text.match_indices(&format!("{start}::")) {
                    let before = text[..at].chars().next_back().unwrap_or(' ');
                    let line = text[..at].lines().last().unwrap_or_default();
                    // What is handed on is not used here, and neither is what the head of a room lists.
                    let listed = line.trim_start().starts_with("(&") || is_listed(&text[at..]);
                    let head = children.iter().any(|child| child == start);
                    if before.is_alphanumeric()
                        || matches!(before, '_' | ':')
                        || line.trim_start().starts_with("pub")
                        || head && listed
                    {
                        continue;
                    }
                    for path in paths(&text[at..]) {
                        found.extend(self.file_of(&self.absolute(module, &path)).filter(|other| other != file));
                    }
                }
            }
        }
        arrows
    }
}

/// Whether a place names a constant of a file, as the lists of rules and commands do: `axis_twice::RULE`.
fn is_listed(text: &str) -> bool {
    let path = text.split(|c: char| !c.is_alphanumeric() && !matches!(c, '_' | ':')).next().unwrap_or_default();
    let name = path.rsplit("::").next().unwrap_or_default();
    !name.is_empty() && name.chars().all(|c| c.is_ascii_uppercase() || c == '_')
}

fn reached<'f>(arrows: &BTreeMap<&'f str, BTreeSet<&'f str>>, from: &'f str) -> BTreeSet<&'f str> {
    let (mut found, mut open) = (BTreeSet::new(), vec![from]);
    while let Some(file) = open.pop() {
        for next in arrows.get(file).into_iter().flatten() {
            if found.insert(*next) {
                open.push(next);
            }
        }
    }
    found
}

#[test]
fn no_large_circle_of_files_imports_each_other() {
    let tree = Tree::new();
    let arrows = tree.imports();
    assert!(arrows.values().map(BTreeSet::len).sum::<usize>() > tree.files.len(), "the imports are not read");
    let reach: BTreeMap<&str, BTreeSet<&str>> = arrows.keys().map(|file| (*file, reached(&arrows, file))).collect();
    let (mut seen, mut wrong) = (BTreeSet::new(), Vec::new());
    for file in arrows.keys() {
        if seen.contains(file) {
            continue;
        }
        let circle: Vec<&str> = reach[file].iter().copied().filter(|other| reach[other].contains(file)).collect();
        seen.extend(circle.iter().copied());
        if circle.len() <= MOST {
            continue;
        }
        let inside = |file: &&str| -> String {
            let others = arrows[file].iter().filter(|other| circle.contains(*other));
            format!("  {file} -> {}", others.copied().collect::<Vec<_>>().join(", "))
        };
        let lines: Vec<String> = circle.iter().map(inside).collect();
        wrong.push(format!("a circle of {} files:\n{}", circle.len(), lines.join("\n")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn rooms_of_the_engine_use_only_what_stands_above_them() {
    let tree = Tree::new();
    let room = |file: &str| -> Option<String> {
        let path = file.strip_prefix("engine/")?.trim_end_matches(".rs");
        let name = path.split('/').next().unwrap_or_default();
        (name != "mod").then(|| name.to_owned())
    };
    let places: BTreeMap<&str, usize> = ENGINE.iter().zip(0..).map(|((name, _), place)| (*name, place)).collect();
    let mut wrong = Vec::new();
    for (name, allowed) in ENGINE {
        for used in allowed.iter().filter(|used| places.get(*used).is_none_or(|place| *place >= places[name])) {
            wrong.push(format!("the table: {name} may use {used}, which does not stand before it"));
        }
    }
    for (file, used) in tree.imports() {
        let Some(own) = room(file) else { continue };
        let Some((_, allowed)) = ENGINE.iter().find(|(name, _)| *name == own) else {
            wrong.push(format!("{file}: the room {own} is not in the table"));
            continue;
        };
        let others = used.iter().filter_map(|other| Some((other, room(other)?)));
        let refused = others.filter(|(_, other)| *other != own && !allowed.contains(&other.as_str()));
        wrong.extend(refused.map(|(other, _)| format!("{file}: {own} may not use {other}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn rooms_of_the_checker_use_only_those_below_them() {
    let tree = Tree::new();
    let place = |file: &str| -> Option<usize> {
        let room = file.strip_prefix("check/")?.trim_end_matches(".rs").split('/').next()?;
        CHECKER.iter().position(|own| *own == room)
    };
    let mut wrong = Vec::new();
    for (file, used) in tree.imports() {
        match place(file) {
            Some(own) => {
                let above = used.iter().filter(|other| place(other).is_some_and(|other| other > own));
                wrong.extend(above.map(|other| format!("{file} uses {other}")));
            }
            None if file.starts_with("check/") && file != "check/mod.rs" => {
                wrong.push(format!("{file}: its room is not in the table"));
            }
            None => {}
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What strategies may know of the engine: a strategy that saw a run could not be called, drawn or timed alone.
const SEEN_BY_STRATEGIES: &[&str] = &[
    "engine/strategy/",
    "engine/geometry.rs",
    "engine/machine/",
    "engine/region/",
    "engine/sphere.rs",
    "engine/report/fault.rs",
    "engine/report/ending.rs",
];

#[test]
fn strategies_see_no_run() {
    let mut wrong = Vec::new();
    let mut families = 0;
    for (file, used) in Tree::new().imports() {
        if !file.starts_with("engine/strategy/") {
            continue;
        }
        families += 1;
        let seen = |other: &&str| SEEN_BY_STRATEGIES.iter().any(|allowed| other.starts_with(allowed));
        let beyond = used.iter().filter(|other| other.starts_with("engine/") && !seen(other));
        wrong.extend(beyond.map(|other| format!("{file} imports {other}")));
    }
    assert!(families > 10, "the strategies are not read");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The table of rooms in ARCHITECTURE.md has them in the same order.
#[test]
fn the_map_names_the_rooms_of_the_engine_in_their_order() {
    let map = include_str!("../../ARCHITECTURE.md");
    let rows = map.lines().skip_while(|line| !line.starts_with("| room |")).take_while(|line| line.starts_with('|'));
    let first = |row: &str| row.split('|').nth(1).unwrap_or_default().to_owned();
    let cells: String = rows.map(first).collect();
    let named: Vec<&str> = cells.split('`').skip(1).step_by(2).collect();
    assert_eq!(named, ENGINE.iter().map(|(room, _)| *room).collect::<Vec<_>>());
}
