//! Embeds the specifications, locales and templates into the program.
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").ok_or(io::ErrorKind::NotFound)?);
    let mut files = Vec::new();
    for top in ["cycle-specs", "locales", "templates"] {
        println!("cargo:rerun-if-changed={top}");
        collect(&root.join(top), top, &mut files)?;
    }
    files.sort();
    let mut out = String::from(
        "/// Path and bytes of each embedded file, in the order of paths.\npub(super) static FILES: &[(&str, &[u8])] = &[\n",
    );
    for name in &files {
        // Beneath the manifest as the compiler finds it: a folder that is moved together with its build stays whole.
        let beneath = format!("/{name}");
        let _ = writeln!(out, "    ({name:?}, include_bytes!(concat!(env!(\"CARGO_MANIFEST_DIR\"), {beneath:?}))),");
    }
    out.push_str("];\n");
    let target = PathBuf::from(env::var_os("OUT_DIR").ok_or(io::ErrorKind::NotFound)?);
    fs::write(target.join("embedded.rs"), out)
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
