//! Files as the program handles them: replaced whole, folders exchanged, names found in any case, lines of any bytes.
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};
use std::{fs, iter};

use ciklo::base::diag::Diagnostic;
use ciklo::system::{
    Folder, LONGEST_LINE, Seen, Staged, beside, line_of, read, spelled, write, write_all, write_parts,
};

#[test]
fn a_file_is_replaced_whole_and_keeps_its_permissions() {
    let root = tempfile::tempdir().unwrap();
    let path = root.path().join("a.h");
    write(&path, b"one").unwrap();
    write(&path, b"two").unwrap();
    assert_eq!(read(&path).unwrap(), b"two");
    assert_eq!(fs::read_dir(root.path()).unwrap().count(), 1);
    let missing = read(&root.path().join("none")).unwrap_err();
    assert_eq!(Diagnostic::from(missing).code, "io-read");
    assert!(write(&root.path().join("none/a.h"), b"").is_err());
}

#[test]
fn several_files_are_replaced_together_or_not_at_all() {
    let root = tempfile::tempdir().unwrap();
    let at = |name: &str| root.path().join(name);
    fs::write(at("a"), "old a").unwrap();
    fs::create_dir_all(at("d/e")).unwrap();
    let text = |name: &str| fs::read_to_string(at(name)).ok();
    write_all(&[(at("a"), b"1"), (at("b"), b"2")]).unwrap();
    assert_eq!((text("a").as_deref(), text("b").as_deref()), (Some("1"), Some("2")));
    // One that cannot be written: a directory, a name that is too long, a folder that is not there.
    for bad in [at("d"), at(&"x".repeat(300)), at("none/x")] {
        let trouble = write_all(&[(at("a"), b"3"), (at("new"), b"4"), (bad, b"5")]).unwrap_err();
        assert_eq!(Diagnostic::from(trouble).code, "io-write");
        assert_eq!((text("a").as_deref(), text("new")), (Some("1"), None));
        assert_eq!(fs::read_dir(root.path()).unwrap().count(), 3, "nothing temporary is left");
    }
}

#[test]
fn what_was_read_is_replaced_only_as_it_was_read() {
    let root = tempfile::tempdir().unwrap();
    let (path, other) = (root.path().join("a.h"), root.path().join("b.h"));
    let replace = |target: &Path, seen: &Seen| write_parts(target, Some(seen), iter::once(&b"new"[..]));
    fs::write(&path, "old").unwrap();
    let seen = Seen::of(&path, b"old");
    // Another one may be any.
    fs::write(&other, "any").unwrap();
    replace(&other, &seen).unwrap();
    // Somebody writes while the new one is written.
    let parts = [&b"n"[..], b"ew"].into_iter().inspect(|part| {
        if *part == b"ew" {
            fs::write(&path, "theirs").unwrap();
        }
    });
    assert_eq!(write_parts(&path, Some(&seen), parts).map_err(Diagnostic::from).unwrap_err().code, "fix-file-changed");
    assert_eq!(read(&path).unwrap(), b"theirs");
    assert_eq!(
        replace(&root.path().join("./a.h"), &seen).map_err(Diagnostic::from).unwrap_err().code,
        "fix-file-changed"
    );
    fs::write(&path, "old").unwrap();
    replace(&path, &seen).unwrap();
    assert_eq!(read(&path).unwrap(), b"new");
    assert_eq!(fs::read_dir(root.path()).unwrap().count(), 2, "nothing temporary is left");
}

#[cfg(unix)]
#[test]
fn links_stay_and_what_they_name_is_written() {
    use std::os::unix::fs::symlink;
    let root = tempfile::tempdir().unwrap();
    let at = |name: &str| root.path().join(name);
    fs::create_dir(at("deep")).unwrap();
    symlink("deep/second", at("first")).unwrap();
    symlink("../a.h", at("deep/second")).unwrap();
    for text in [&b"one"[..], b"two"] {
        write(&at("first"), text).unwrap();
        assert_eq!(read(&at("a.h")).unwrap(), text);
    }
    let seen = Seen::of(&at("a.h"), b"two");
    fs::write(at("a.h"), "theirs").unwrap();
    let replaced = write_parts(&at("first"), Some(&seen), iter::once(&b"three"[..]));
    assert_eq!(Diagnostic::from(replaced.unwrap_err()).code, "fix-file-changed");
    symlink("loop", at("loop")).unwrap();
    assert!(write(&at("loop"), b"").is_err());
    symlink("none/a.h", at("nowhere")).unwrap();
    assert!(write(&at("nowhere"), b"").is_err());
    for link in ["first", "deep/second", "loop", "nowhere"] {
        assert!(fs::symlink_metadata(at(link)).unwrap().is_symlink(), "{link}");
    }
}

#[test]
fn a_directory_is_exchanged_when_whole_and_not_before() {
    let root = tempfile::tempdir().unwrap();
    let target = root.path().join("a/out");
    let first = Staged::new(&target).unwrap();
    first.write("x/y.txt", b"1").unwrap();
    first.write("../../escape.txt", b"1").unwrap();
    assert!(!target.exists());
    first.commit().unwrap();
    assert_eq!(fs::read(target.join("x/y.txt")).unwrap(), b"1");
    assert!(!root.path().join("escape.txt").exists());

    let abandoned = Staged::new(&target).unwrap();
    abandoned.write("x/y.txt", b"2").unwrap();
    drop(abandoned);
    assert_eq!(fs::read(target.join("x/y.txt")).unwrap(), b"1");

    let second = Staged::new(&target).unwrap();
    second.write("z.txt", b"3").unwrap();
    second.commit().unwrap();
    assert!(!target.join("x").exists());
    assert_eq!(fs::read(target.join("z.txt")).unwrap(), b"3");
    let beside: Vec<_> = fs::read_dir(root.path().join("a")).unwrap().collect();
    assert_eq!(beside.len(), 1, "nothing temporary is left");
}

#[test]
fn a_directory_of_someone_else_is_left_alone() {
    let root = tempfile::tempdir().unwrap();
    fs::write(root.path().join("thesis.txt"), "all my work").unwrap();
    let trouble = Staged::new(root.path()).unwrap_err();
    assert_eq!(Diagnostic::from(trouble).code, "io-foreign-directory");
    assert!(root.path().join("thesis.txt").exists());
}

#[test]
fn files_of_someone_else_in_a_built_directory_stay() {
    let root = tempfile::tempdir().unwrap();
    let target = root.path().join("out");
    let build = |files: &[&str]| {
        let staged = Staged::new(&target).unwrap();
        files.iter().for_each(|file| staged.write(file, b"built").unwrap());
        staged.commit().unwrap();
    };
    build(&["a/1.html", "b/2.html", "index.html"]);
    for (name, text) in [("CNAME", "here"), ("mine/deep/x.txt", "mine"), ("a/note.txt", "note")] {
        fs::create_dir_all(target.join(name).parent().unwrap()).unwrap();
        fs::write(target.join(name), text).unwrap();
    }
    fs::create_dir(target.join("empty")).unwrap();
    build(&["a/3.html", "index.html"]);
    let text = |name: &str| fs::read_to_string(target.join(name)).unwrap();
    assert_eq!(
        (text("CNAME"), text("mine/deep/x.txt"), text("a/note.txt")),
        ("here".into(), "mine".into(), "note".into())
    );
    assert_eq!((text("index.html"), text("a/3.html")), ("built".into(), "built".into()));
    for gone in ["a/1.html", "b"] {
        assert!(!target.join(gone).exists(), "{gone} was built before and is not any more");
    }
    assert!(target.join("empty").is_dir());
    // A directory of an older version has no list: nothing of it goes away.
    fs::write(target.join(".ciklo-build"), "ciklo build 1\n").unwrap();
    build(&["index.html"]);
    assert_eq!((text("a/3.html"), text("CNAME")), ("built".into(), "here".into()));
}

#[cfg(unix)]
#[test]
fn the_permissions_of_the_directory_stay() {
    use std::os::unix::fs::PermissionsExt as _;
    let root = tempfile::tempdir().unwrap();
    let target = root.path().join("out");
    fs::create_dir(&target).unwrap();
    fs::set_permissions(&target, fs::Permissions::from_mode(0o750)).unwrap();
    let staged = Staged::new(&target).unwrap();
    staged.write("a", b"1").unwrap();
    staged.commit().unwrap();
    assert_eq!(fs::metadata(&target).unwrap().permissions().mode() & 0o7777, 0o750);
}

#[test]
fn a_file_is_found_in_any_case_and_a_directory_is_none() {
    let root = tempfile::tempdir().unwrap();
    let names = |folder: &Folder, name| folder.file(name).map(|path| path.file_name().unwrap().to_owned());
    fs::create_dir(root.path().join("dir.h")).unwrap();
    for name in ["Part.H", "other.i"] {
        fs::write(root.path().join(name), "").unwrap();
    }
    let folder = Folder::of(root.path()).unwrap();
    assert_eq!(names(&folder, "pART.h").unwrap(), "Part.H");
    assert_eq!(names(&folder, "OTHER.I").unwrap(), "other.i");
    assert_eq!(names(&folder, "dir.h"), None);
    assert!(Folder::of(&root.path().join("none")).is_err());
}

#[test]
fn a_path_has_one_spelling() {
    let root = tempfile::tempdir().unwrap();
    let folder = root.path().join("a");
    fs::create_dir(&folder).unwrap();
    let own = spelled(&folder.join("x.h"));
    assert_eq!(spelled(&folder.join("../a/./x.h")), own);
    assert_eq!(spelled(Path::new("Cargo.toml")), spelled(Path::new("./Cargo.toml")));
    // A file without a directory has neighbours without one.
    assert!(beside(Path::new("Cargo.toml"), "lock").unwrap().contains(&PathBuf::from("Cargo.lock")));
    assert!(beside(Path::new("./Cargo.toml"), "toml").unwrap().iter().all(|path| path.starts_with(".")));
}

#[test]
fn a_line_is_taken_whatever_bytes_it_has() {
    let mut input = &b"{\"a\"}\r\n\xff\xfe\n\nlast"[..];
    let mut next = || line_of(&mut input).unwrap();
    assert_eq!(next().as_deref(), Some("{\"a\"}"));
    assert_eq!(next().as_deref(), Some("\u{fffd}\u{fffd}"));
    assert_eq!(next().as_deref(), Some(""));
    assert_eq!(next().as_deref(), Some("last"));
    assert_eq!(next(), None);
}

#[test]
fn a_line_that_is_too_long_is_passed_over() {
    let mut input = io::BufReader::new(io::repeat(b'a').take(LONGEST_LINE as u64 * 3).chain(&b"\nnext\n"[..]));
    assert_eq!(line_of(&mut input).unwrap().as_deref(), Some(""));
    assert_eq!(line_of(&mut input).unwrap().as_deref(), Some("next"));
    let mut longest = io::BufReader::new(io::repeat(b'a').take(LONGEST_LINE as u64).chain(&b"\n"[..]));
    assert_eq!(line_of(&mut longest).unwrap().map(|line| line.len()), Some(LONGEST_LINE));
}
