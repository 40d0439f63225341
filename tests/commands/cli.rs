//! The command as a user meets it: exit codes, what goes to which stream, and the reference of its
//! help. `UPDATE=1 cargo test --test commands cli` rewrites the expectations in `tests/cli/` and `docs/cli.md`.
use std::fmt::Write as _;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

const HELP: &str = "docs/cli.md";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn ciklo(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ciklo"));
    command.args(arguments).current_dir(root()).stdin(Stdio::null());
    for name in ["LC_ALL", "LC_MESSAGES", "LANG", "NO_COLOR", "CLICOLOR_FORCE"] {
        command.env_remove(name);
    }
    command.env("COLUMNS", "100");
    command
}

fn run(arguments: &[&str]) -> Output {
    ciklo(arguments).output().unwrap()
}

fn updating() -> bool {
    std::env::var_os("UPDATE").is_some()
}

/// Compares with a stored text, or stores it.
fn stored(path: &Path, actual: &str) {
    if updating() {
        std::fs::write(path, actual).unwrap();
        return;
    }
    let expected = std::fs::read_to_string(path).unwrap_or_default();
    let (mut now, mut before) = (actual.lines(), expected.lines());
    for line in 1.. {
        let (now, before) = (now.next(), before.next());
        let stale = format!("{}:{line} is stale; UPDATE=1 cargo test --test commands cli rewrites it", path.display());
        assert_eq!(now, before, "{stale}");
        if now.is_none() {
            return;
        }
    }
}

/// How many files there are in a directory, which may be about to change.
#[cfg(unix)]
fn files(folder: &Path) -> usize {
    let all = std::fs::read_dir(folder).into_iter().flatten().flatten();
    all.map(|entry| if entry.file_type().is_ok_and(|kind| kind.is_dir()) { files(&entry.path()) } else { 1 }).sum()
}

/// Whoever runs the tests in the background may have them pass over a signal; the program passes over it as well.
#[cfg(unix)]
fn is_passed_over(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:")).unwrap_or("0");
    u64::from_str_radix(mask.trim(), 16).unwrap() >> (signal - 1) & 1 == 1
}

/// A manual takes seconds to write; it grows beside its place, and goes away when the program is told to end.
#[cfg(unix)]
#[test]
fn a_signal_leaves_nothing_half_made() {
    use std::os::unix::process::ExitStatusExt as _;
    let folder = tempfile::tempdir().unwrap();
    let half_made = || {
        let all = std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().path());
        let mut own = all.filter(|path| path.file_name().unwrap().to_string_lossy().starts_with(".ciklo-"));
        let first = own.next();
        assert_eq!(own.next(), None);
        first
    };
    // Early, and while many threads write.
    let (term, others) = (("-TERM", 15), [("-INT", 2), ("-HUP", 1)]);
    let told = [0, 5, 50, 500].map(|at| (term, at)).into_iter().chain(others.map(|told| (told, 50)));
    for ((name, number), at_least) in told {
        if is_passed_over(number) {
            continue;
        }
        let out = folder.path().join("manual");
        let mut child = ciklo(&["build", "--out", out.to_str().unwrap()]).stdout(Stdio::null()).spawn().unwrap();
        let begun = (0..6000).any(|_| {
            std::thread::sleep(std::time::Duration::from_millis(10));
            half_made().is_some_and(|path| files(&path) >= at_least)
        });
        assert!(begun, "fewer than {at_least} files");
        let sent = Command::new("kill").args([name, &child.id().to_string()]).status().unwrap();
        assert!(sent.success());
        assert_eq!(child.wait().unwrap().signal(), Some(number), "it ends by the signal");
        assert_eq!(half_made(), None, "after {name} with {at_least} files");
        assert!(!out.exists());
    }
}

/// As the writing of a manual, but nothing else: a directory that many threads write into.
#[cfg(unix)]
#[test]
fn a_signal_waits_for_threads_that_write() {
    use std::os::unix::process::ExitStatusExt as _;
    const OUT: &str = "CIKLO_TEST_WRITES_INTO";
    if let Some(out) = std::env::var_os(OUT) {
        let staged = ciklo::system::Staged::new(Path::new(&out)).unwrap();
        // Whoever told it to end waits for it; more than any round waits for ends it anyway.
        let write = |thread: usize| {
            (0..1_000_000).for_each(|at| staged.write(&format!("{thread}/{at}"), b"1").unwrap());
        };
        return std::thread::scope(|scope| {
            (1..4).for_each(|thread| drop(scope.spawn(move || write(thread))));
            write(0);
        });
    }
    let folder = tempfile::tempdir().unwrap();
    let rounds = if is_passed_over(15) { 0 } else { 20 };
    for round in 0..rounds {
        let mut child = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "cli::a_signal_waits_for_threads_that_write"])
            .env(OUT, folder.path().join("out"))
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        while files(folder.path()) < round * 40 + 2 {
            assert_eq!(child.try_wait().unwrap(), None, "it writes until it is told to end");
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        assert!(Command::new("kill").arg(child.id().to_string()).status().unwrap().success());
        assert_eq!(child.wait().unwrap().signal(), Some(15), "it ends by the signal");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0, "in round {round}");
    }
}

#[cfg(not(feature = "pdf"))]
#[test]
fn a_program_without_pdf_says_how_to_get_it() {
    for lang in ["en", "fi", "it", "pt", "sl"] {
        let mut command = ciklo(&["build", "--format", "pdf"]);
        let output = command.env("LANG", format!("{lang}.UTF-8")).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains("[pdf-not-built-in]") && said.contains("--features pdf"), "{said}");
    }
}

/// A case file has lines `$ arguments`, each followed by what the command gave: `exit N`, lines of
/// standard output, and lines of standard error behind `! `. `| N` at the end of the arguments keeps
/// the first N lines of each stream. Words in double quotes are one argument.
#[test]
fn cases() {
    // Cases write there, wherever cargo builds.
    std::fs::create_dir_all(root().join("target")).unwrap();
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(root().join("tests/cli")).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "txt"));
    files.sort();
    assert!(!files.is_empty());
    for file in files {
        let text = std::fs::read_to_string(&file).unwrap();
        let mut actual = String::new();
        for line in own(&text) {
            let _ = writeln!(actual, "{line}");
            if let Some(command) = line.strip_prefix("$ ") {
                case(command, &mut actual);
            }
        }
        stored(&file, &actual);
    }
}

/// The lines of a file that are not output: commands, and remarks, which follow an empty line or another remark.
fn own(text: &str) -> Vec<&str> {
    let (mut own, mut begins) = (Vec::new(), true);
    for line in text.lines() {
        let is_remark = begins && line.starts_with('#');
        if is_remark || line.starts_with("$ ") {
            own.push(line);
        }
        begins = is_remark || line.is_empty();
    }
    own
}

fn case(line: &str, actual: &mut String) {
    let (line, most) = match line.rsplit_once('|') {
        Some((line, most)) => (line, most.trim().parse().unwrap()),
        None => (line, usize::MAX),
    };
    let arguments: Vec<&str> = line
        .split('"')
        .enumerate()
        .flat_map(|(index, part)| if index % 2 == 1 { vec![part] } else { part.split_whitespace().collect() })
        .collect();
    let output = run(&arguments);
    let _ = writeln!(actual, "exit {}", output.status.code().unwrap_or(-1));
    for line in String::from_utf8_lossy(&output.stdout).lines().take(most) {
        let _ = writeln!(actual, "{line}");
    }
    for line in String::from_utf8_lossy(&output.stderr).lines().take(most) {
        let _ = writeln!(actual, "! {line}");
    }
    actual.push('\n');
}

#[test]
fn the_reference_is_the_help() {
    let help = |arguments: &[&str]| {
        let output = run(&[arguments, &["--ui-lang", "en", "--help"]].concat());
        assert!(output.status.success() && output.stderr.is_empty());
        String::from_utf8(output.stdout).unwrap()
    };
    let overview = help(&[]);
    let commands = overview.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let mut page = String::from("# The command line\n\nThis is what `ciklo --help` says; a test keeps it so.\n\n");
    let _ = write!(page, "```text\n{overview}```\n");
    let mut count = 0;
    for name in commands.filter_map(|line| line.strip_prefix("  ")).filter(|line| !line.starts_with(' ')) {
        let name = name.split_whitespace().next().unwrap();
        let text = help(&[name]);
        assert!(text.contains("Examples:\n  ciklo "), "{name} has no examples");
        let _ = write!(page, "\n## {name}\n\n```text\n{text}```\n");
        count += 1;
    }
    assert!(count >= 5);
    stored(&root().join(HELP), &page);
}

#[test]
fn every_language_has_all_of_the_help() {
    for language in ["fi", "sl", "it", "pt"] {
        let output = run(&["--ui-lang", language, "--help"]);
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(!text.contains("cli-") && !text.contains("Usage") && !text.contains("Options"), "{text}");
    }
}

#[test]
fn the_environment_chooses_the_language() {
    let complaint = |name, value| {
        let output = ciklo(&["nonsense"]).env(name, value).output().unwrap();
        String::from_utf8(output.stderr).unwrap()
    };
    assert!(complaint("LANG", "fi_FI.UTF-8").starts_with("virhe["));
    assert!(complaint("LC_ALL", "sl_SI").starts_with("napaka["));
    assert!(complaint("LANG", "de_DE.UTF-8").starts_with("error["));
}

#[test]
fn a_reader_that_leaves_is_no_error() {
    let mut child = ciklo(&["schema"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let mut told = String::new();
    child.stderr.take().unwrap().read_to_string(&mut told).unwrap();
    assert_eq!((child.wait().unwrap().code(), told.as_str()), (Some(0), ""));
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_told() {
    let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
    let output = ciklo(&["schema"]).stdout(full).stderr(Stdio::piped()).spawn().unwrap().wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("no space is left"));
}

#[test]
fn a_working_copy_replaces_the_built_in_data() {
    let copy = tempfile::tempdir().unwrap();
    let data = copy.path().to_str().unwrap();
    assert_eq!(run(&["lint", "--data", data]).status.code(), Some(2), "an empty directory has no data");
    let english = copy.path().join("locales/en");
    std::fs::create_dir_all(&english).unwrap();
    let lacks = run(&["lint", "--data", data]);
    assert_eq!(lacks.status.code(), Some(2), "one directory of three is no working copy");
    assert!(String::from_utf8_lossy(&lacks.stderr).contains("cycle-specs"));
    std::fs::create_dir(copy.path().join("cycle-specs")).unwrap();
    std::fs::create_dir(copy.path().join("templates")).unwrap();
    std::fs::create_dir_all(copy.path().join("locales/fi")).unwrap();
    std::fs::write(english.join("a.ftl"), "a = A\nb = { gone }\n").unwrap();
    std::fs::write(copy.path().join("locales/fi/a.ftl"), "a = B\n").unwrap();
    let output = run(&["lint", "--data", data, "--format", "json"]);
    assert_eq!(output.status.code(), Some(1));
    let lines: Vec<serde_json::Value> =
        String::from_utf8(output.stdout).unwrap().lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let codes: Vec<&str> = lines.iter().filter_map(|line| line["code"].as_str()).collect();
    assert_eq!(codes, ["locale-missing-translation", "locale-unknown-reference", "locale-unrecorded"]);
    assert_eq!((lines[1]["line"].as_u64(), lines[1]["file"].as_str()), (Some(2), Some("locales/en/a.ftl")));

    assert_eq!(run(&["lint", "--data", data, "--accept-translations"]).status.code(), Some(0));
    let lock = std::fs::read_to_string(copy.path().join("locales/fi/source.lock")).unwrap();
    assert!(lock.starts_with("a ") && lock.len() == "a 01234567 =01234567\n".len(), "{lock}");
    let originals = std::fs::read_to_string(copy.path().join("locales/en/accepted.lock")).unwrap();
    assert!(originals.starts_with("a ") && originals.ends_with(" \"A\"\n"), "{originals}");
}

/// Copies a directory, whole.
fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).unwrap();
        }
    }
}

#[test]
fn a_build_that_fails_leaves_the_last_good_one() {
    let scratch = tempfile::tempdir().unwrap();
    let data = scratch.path().join("data");
    for top in ["cycle-specs", "locales", "templates"] {
        copy(&root().join(top), &data.join(top));
    }
    let out = scratch.path().join("site");
    let words = ["build", "--control", "tnc320", "--lang", "en"];
    let paths = ["--out", out.to_str().unwrap(), "--data", data.to_str().unwrap()];
    let build = || run(&[&words[..], &paths[..]].concat());

    let first = build();
    assert!(first.status.success(), "{}", String::from_utf8_lossy(&first.stderr));
    assert!(first.stdout.is_empty(), "a pipe gets no progress");
    let index = std::fs::read(out.join("index.html")).unwrap();

    // A text that is needed disappears.
    let groups = data.join("locales/en/cycle-groups.ftl");
    let kept = std::fs::read(&groups).unwrap();
    std::fs::write(&groups, "").unwrap();
    let failed = build();
    assert_eq!(failed.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&failed.stderr).contains("locale-missing-text"));
    assert_eq!(std::fs::read(out.join("index.html")).unwrap(), index);
    std::fs::write(&groups, kept).unwrap();

    // A file of the user's own stands where the site should go.
    let own = scratch.path().join("own");
    std::fs::create_dir(&own).unwrap();
    std::fs::write(own.join("thesis.txt"), "all of it").unwrap();
    let refused = run(&["build", "--out", own.to_str().unwrap()]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("io-foreign-directory"));
    assert!(own.join("thesis.txt").exists());

    assert!(build().status.success(), "the site is exchanged");
    let left: Vec<_> = std::fs::read_dir(scratch.path()).unwrap().collect();
    assert_eq!(left.len(), 3, "nothing temporary is left: {left:?}");
}

#[test]
fn any_file_is_parsed_and_printed_again() {
    let scratch = tempfile::tempdir().unwrap();
    let path = scratch.path().join("odd.h");
    let file = path.to_str().unwrap();
    let odd: [&[u8]; 5] =
        [b"", b"\xff\xfe\x00\x01 L X", b"0 BEGIN PGM A MM\r\n1 L X\xe4\r2", b"\xef\xbb\xbf; \xc4\x8d", b"\0\0\0"];
    for bytes in odd {
        std::fs::write(&path, bytes).unwrap();
        let printed = run(&["parse", file, "--print"]);
        assert!(printed.status.success());
        assert_eq!(printed.stdout, bytes);
        let document: serde_json::Value = serde_json::from_slice(&run(&["parse", file]).stdout).unwrap();
        assert_eq!(document["format"], "ciklo-parse/1");
    }
    assert_eq!(run(&["parse", "no-such-file.h"]).status.code(), Some(2));
}

/// The document against the structure that the standard gives it, and its indices against each other.
#[test]
fn findings_as_sarif_are_what_the_standard_says() {
    let schema: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(root().join("tests/sarif-2.1.0.json")).unwrap()).unwrap();
    let mut compiler = boon::Compiler::new();
    let mut schemas = boon::Schemas::new();
    compiler.add_resource("mem:///sarif.json", schema).unwrap();
    let index = compiler.compile("mem:///sarif.json", &mut schemas).unwrap();
    for language in ["en", "fi", "sl", "it", "pt"] {
        let output = run(&["--ui-lang", language, "check", "tests/cli/folder", "--format", "sarif"]);
        assert_eq!(output.status.code(), Some(1));
        let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        schemas.validate(&document, index).unwrap_or_else(|error| panic!("{error}"));
        let run = &document["runs"][0];
        let results = run["results"].as_array().unwrap();
        assert!(results.len() >= 3 && results.iter().any(|result| result["fixes"].is_array()));
        for result in results {
            let rule = &run["tool"]["driver"]["rules"][result["ruleIndex"].as_u64().unwrap() as usize];
            assert_eq!(rule["id"], result["ruleId"]);
        }
    }
    let clean = run(&["check", "tests/cli/folder/good.H", "--format", "sarif"]);
    assert_eq!(clean.status.code(), Some(0));
    let document: serde_json::Value = serde_json::from_slice(&clean.stdout).unwrap();
    schemas.validate(&document, index).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn labels_are_mended_where_they_stand() {
    let scratch = tempfile::tempdir().unwrap();
    let path = scratch.path().join("mixed.h");
    let file = path.to_str().unwrap();
    let original = std::fs::read_to_string(root().join("tests/cli/folder/old/mixed.i")).unwrap();
    std::fs::write(&path, original.replace('\n', "\r\n")).unwrap();
    let words = ["check", file, "--control", "tnc640", "--fix"];
    let mended = run(&words);
    assert_eq!(mended.status.code(), Some(0), "{}", String::from_utf8_lossy(&mended.stdout));
    assert!(String::from_utf8_lossy(&mended.stderr).contains("2 places were corrected."));
    let expected = original.replace("PROFONDITÀ", "DEPTH").replace("Q202=5 ;DEPTH", "Q202=5 ;PLUNGING DEPTH");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), expected.replace('\n', "\r\n"));
    let again = run(&words);
    assert!(String::from_utf8_lossy(&again.stderr).contains("Nothing was corrected."));
    // What only an execution shows is found as well.
    let slots = scratch.path().join("slots.h");
    std::fs::copy(root().join("tests/cli/dry/slots.h"), &slots).unwrap();
    let table = ["--table", "tests/cli/dry/TOOL.T", "--format", "json"];
    let executed = run(&[&["check", slots.to_str().unwrap(), "--control", "tnc640", "--fix"][..], &table].concat());
    assert!(String::from_utf8_lossy(&executed.stdout).contains("\"rapid-through-material\""), "{executed:?}");
}

#[test]
fn the_document_of_a_comparison_is_described() {
    fn keys(value: &serde_json::Value, found: &mut Vec<String>) {
        match value {
            serde_json::Value::Object(entries) => {
                found.extend(entries.keys().cloned());
                // An event has its own page.
                entries.iter().filter(|(key, _)| *key != "event").for_each(|(_, value)| keys(value, found));
            }
            serde_json::Value::Array(values) => values.iter().for_each(|value| keys(value, found)),
            _ => {}
        }
    }
    let programs = ["compare", "tests/cli/bore.h", "tests/cli/bore-deeper.h", "--control", "tnc640"];
    let execution = ["--execute", "--scene", "tests/cli/bore.scene.yaml", "--format", "json"];
    let output = run(&[&programs[..], &execution].concat());
    let document = serde_json::from_slice(&output.stdout).unwrap();
    let mut found = Vec::new();
    keys(&document, &mut found);
    let page = std::fs::read_to_string(root().join("docs/compare.md")).unwrap();
    assert!(found.len() > 20);
    for key in found {
        assert!(page.contains(&format!("`{key}`")), "docs/compare.md does not say what {key} is");
    }
}

/// A line of the cache: the key, the first half of the digest of key and findings, the findings.
fn resealed(key: &str, findings: &str) -> String {
    use sha2::{Digest as _, Sha256};
    let number = u128::from_str_radix(key, 16).unwrap();
    let digest = Sha256::new().chain_update(number.to_be_bytes()).chain_update(findings).finalize();
    let digest: String = digest.iter().take(16).map(|byte| format!("{byte:02x}")).collect();
    format!("{key} {digest} {findings}\n")
}

/// What was found before is found again without checking, whatever became of the file that remembers it.
#[test]
fn programs_that_have_not_changed_are_remembered() {
    let scratch = tempfile::tempdir().unwrap();
    let (folder, place) = (scratch.path().join("programs"), scratch.path().join("cache"));
    std::fs::create_dir(&folder).unwrap();
    let good = std::fs::read_to_string(root().join("tests/check/planted/drilling.h")).unwrap();
    for number in 0..20 {
        let bad = good.replace("Q202=+5", &format!("Q202=-{number}"));
        std::fs::write(folder.join(format!("{number:02}.h")), bad).unwrap();
    }
    let check = |more: &[&str]| {
        let words = ["check", folder.to_str().unwrap(), "--control", "tnc640", "--format", "json"];
        let mut command = ciklo(&[&words, more].concat());
        // Each platform names the place in its own way.
        for name in ["XDG_CACHE_HOME", "LOCALAPPDATA", "HOME"] {
            command.env(name, &place);
        }
        let output = command.output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let found = check(&["--no-cache"]);
    assert_eq!(found.lines().count(), 20);
    assert!(!place.exists(), "nothing is kept that was not asked for");
    assert_eq!(check(&[]), found);
    let mut files = vec![place.clone()];
    let file = loop {
        let next = files.pop().expect("a file is kept");
        if next.is_file() {
            break next;
        }
        files.extend(std::fs::read_dir(&next).unwrap().map(|entry| entry.unwrap().path()));
    };
    assert_eq!(check(&[]), found);
    let kept = std::fs::read(&file).unwrap();
    for damaged in [&b""[..], b"\xff\xfe nonsense", &kept[..kept.len() / 2], &kept[1..]] {
        std::fs::write(&file, damaged).unwrap();
        assert_eq!(check(&[]), found);
    }
    // Nor is any line in which a bit has flipped.
    let kept = std::fs::read(&file).unwrap();
    for at in (3..kept.len() * 8).step_by(kept.len() * 8 / 16) {
        let mut damaged = kept.clone();
        damaged[at / 8] ^= 1 << (at % 8);
        std::fs::write(&file, damaged).unwrap();
        assert_eq!(check(&[]), found, "bit {at}");
    }
    // A changed finding is not believed, unless its digest is right: that shows that the file is read at all.
    let text = String::from_utf8(std::fs::read(&file).unwrap()).unwrap();
    std::fs::write(&file, text.replace("\"-7\"", "\"-7777\"")).unwrap();
    assert_eq!(check(&[]), found);
    std::fs::write(&file, text.replace("\"error\"", "\"note\"")).unwrap();
    assert_eq!(check(&[]), found);
    let resealed = text.lines().map(|line| match line.splitn(3, ' ').collect::<Vec<_>>()[..] {
        [key, _, findings] if findings.contains("\"-7\"") => resealed(key, &findings.replace("\"-7\"", "\"-7777\"")),
        _ => format!("{line}\n"),
    });
    std::fs::write(&file, resealed.collect::<String>()).unwrap();
    assert!(check(&[]).contains("-7777"));
    assert_eq!(check(&["--no-cache"]), found);
    // What has changed is checked again, and in other words for another reader.
    std::fs::write(folder.join("07.h"), &good).unwrap();
    assert_eq!(check(&[]).lines().count(), 19);
    assert!(check(&["--ui-lang", "fi"]).contains("liian pieni"));
}
