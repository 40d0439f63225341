//! Embeds the specifications, locales and templates into the program, and prepares what would take time at each start:
//! the trees of the specifications, an index of what is in them, and where the messages of each language are.
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

// What reads and writes the prepared forms is the same in the program.
#[path = "src/base"]
#[allow(dead_code, unreachable_pub)]
mod base {
    pub(crate) mod diag;
}
#[path = "src/spec"]
#[allow(dead_code, unreachable_pub)]
mod spec {
    pub(crate) mod filter;
    pub(crate) mod index;
    pub(crate) mod tree;
    pub(crate) mod yaml;
}
#[path = "src/language/locale"]
#[allow(dead_code, unreachable_pub)]
mod locale {
    pub(crate) mod index;
}

use base::diag::Source;

type Files = Vec<(String, String)>;

fn main() -> io::Result<()> {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").ok_or(io::ErrorKind::NotFound)?);
    let target = PathBuf::from(env::var_os("OUT_DIR").ok_or(io::ErrorKind::NotFound)?);
    println!("cargo:rerun-if-changed=build.rs");
    for shared in ["base/diag.rs", "spec/filter.rs", "spec/index.rs", "spec/tree.rs", "spec/yaml.rs"] {
        println!("cargo:rerun-if-changed=src/{shared}");
    }
    println!("cargo:rerun-if-changed=src/language/locale/index.rs");
    let mut names = Vec::new();
    for top in ["cycle-specs", "locales", "templates"] {
        println!("cargo:rerun-if-changed={top}");
        collect(&root.join(top), top, &mut names)?;
    }
    names.sort();
    let read = |name: String| fs::read_to_string(root.join(&name)).map(|text| (name, text));
    let files: Files = names.into_iter().map(read).collect::<Result<_, _>>()?;
    // All paths in one piece: a search for one of them does not touch the pages of the texts between them.
    let mut paths = String::new();
    let mut out = String::new();
    out.push_str("static PATHS: &str = include_str!(concat!(env!(\"OUT_DIR\"), \"/paths.txt\"));\n");
    out.push_str("pub(super) static DATA: super::Prepared = super::Prepared {\n    files: &[\n");
    for (name, _) in &files {
        // Beneath the manifest as the compiler finds it: a folder that is moved together with its build stays whole.
        let (start, beneath) = (paths.len(), format!("/{name}"));
        let path = format!("PATHS.split_at({start}).1.split_at({}).0", name.len());
        let _ = writeln!(out, "        ({path}, include_str!(concat!(env!(\"CARGO_MANIFEST_DIR\"), {beneath:?}))),");
        paths.push_str(name);
    }
    fs::write(target.join("paths.txt"), paths)?;
    out.push_str("    ],\n");
    let sound = specifications(&files, &target, &mut out)?;
    messages(&files, &target, &mut out)?;
    let _ = writeln!(out, "    sound: {sound},\n}};");
    fs::write(target.join("embedded.rs"), out)
}

/// Writes the trees of the specifications and their index; says whether all files could be read.
fn specifications(files: &Files, target: &Path, out: &mut String) -> io::Result<bool> {
    let (mut found, mut trees, mut bytes) = (Vec::new(), Vec::new(), Vec::new());
    out.push_str("    tree_table: &[");
    for (at, (name, text)) in files.iter().enumerate() {
        if !name.starts_with("cycle-specs/") || !name.ends_with(".yaml") || name.starts_with("cycle-specs/machines/") {
            continue;
        }
        let Some(tree) = spec::yaml::read(&Source::new(name.as_str(), text.as_str()), &mut found) else { continue };
        trees.push((name.clone(), tree.clone()));
        let start = bytes.len();
        let (now, later) = spec::tree::parted(tree);
        spec::tree::write(&now, &mut bytes);
        let end = bytes.len();
        later.iter().for_each(|later| spec::tree::write(later, &mut bytes));
        let _ = write!(out, "({at}, {start}, {end}, {}), ", bytes.len());
    }
    out.push_str("],\n");
    let index = spec::index::write(&trees).filter(|_| found.is_empty());
    fs::write(target.join("trees.bin"), bytes)?;
    fs::write(target.join("specifications.txt"), index.as_deref().unwrap_or_default())?;
    out.push_str("    trees: include_bytes!(concat!(env!(\"OUT_DIR\"), \"/trees.bin\")),\n");
    out.push_str("    index: include_str!(concat!(env!(\"OUT_DIR\"), \"/specifications.txt\")),\n");
    Ok(index.is_some())
}

/// Writes where the messages of each language are.
fn messages(files: &Files, target: &Path, out: &mut String) -> io::Result<()> {
    let tag = |name: &str| Some(name.strip_prefix("locales/")?.split_once('/')?.0.to_owned());
    let mut tags: Vec<String> = files.iter().filter_map(|(name, _)| tag(name)).collect();
    tags.dedup();
    out.push_str("    messages: &[\n");
    for own in tags {
        let texts = files
            .iter()
            .enumerate()
            .filter(|(_, (name, _))| tag(name).is_some_and(|tag| tag == own) && name.ends_with(".ftl"));
        let file = format!("messages-{own}.bin");
        fs::write(target.join(&file), locale::index::write(texts.map(|(at, (_, text))| (at, text.as_str()))))?;
        let _ = writeln!(out, "        ({own:?}, include_bytes!(concat!(env!(\"OUT_DIR\"), \"/{file}\"))),");
    }
    out.push_str("    ],\n");
    Ok(())
}

fn collect(dir: &Path, name: &str, files: &mut Vec<String>) -> io::Result<()> {
    if !dir.is_dir() {
        return Ok(());
    }
    for entry in fs::read_dir(dir)? {
        let entry = entry?;
        let child = format!("{name}/{}", entry.file_name().to_string_lossy());
        if child.rsplit('/').next().is_some_and(|n| n.starts_with('.')) {
            continue;
        }
        if entry.file_type()?.is_dir() {
            collect(&entry.path(), &child, files)?;
        } else {
            files.push(child);
        }
    }
    Ok(())
}
