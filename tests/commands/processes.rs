//! The command among other processes: readers that leave, neighbours that are called or not, engines that misbehave,
//! and systems that give less than was asked for.
use std::path::Path;
use std::process::{Command, Output, Stdio};

const SCENE: &str = "tests/cli/part.scene.yaml";
const BORE_SCENE: &str = "tests/cli/bore.scene.yaml";

fn ciklo(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ciklo"));
    command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).stdin(Stdio::null());
    for name in ["LC_ALL", "LC_MESSAGES", "LANG", "NO_COLOR", "CLICOLOR_FORCE"] {
        command.env_remove(name);
    }
    command
}

fn run(arguments: &[&str]) -> Output {
    ciklo(arguments).output().unwrap()
}

/// Exit code and standard error.
fn told(output: &Output) -> (Option<i32>, String) {
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

/// The same where nobody reads standard output.
fn unread(arguments: &[&str]) -> (Option<i32>, String) {
    let mut child = ciklo(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    told(&child.wait_with_output().unwrap())
}

#[test]
fn the_outcome_does_not_depend_on_who_reads_it() {
    let folder = tempfile::tempdir().unwrap();
    let (bad, unlaid) = (folder.path().join("bad.h"), folder.path().join("unlaid.h"));
    std::fs::write(&bad, "0 BEGIN PGM BAD MM\n1 FOO\n2 END PGM BAD MM\n".repeat(100)).unwrap();
    std::fs::write(&unlaid, "0 BEGIN PGM U MM\n1  L   X1\n2 END PGM U MM\n").unwrap();
    let (bad, unlaid) = (bad.to_str().unwrap(), unlaid.to_str().unwrap());
    for words in [
        &["check", bad, "--control", "tnc640", "--format", "json"][..],
        &["check", bad, "--control", "tnc640", "--format", "sarif"],
        &["check", "tests/cli/bore.h", "--control", "tnc640", "--format", "json"],
        &["compare", "tests/cli/bore.h", "tests/cli/bore-deeper.h", "--control", "tnc640", "--format", "json"],
        &["parse", bad, "--control", "tnc640"],
        &["fmt", unlaid, "--control", "tnc640", "--check"],
        &["explain"],
    ] {
        assert_eq!(unread(words), told(&run(words)), "{words:?}");
    }
}

#[test]
fn files_are_written_when_nobody_reads_the_events() {
    let folder = tempfile::tempdir().unwrap();
    let of = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let scene = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(BORE_SCENE)).unwrap();
    std::fs::write(of("scene"), scene + "stock:\n  box: {min: [0, 0, -30], max: [100, 80, 0]}\n").unwrap();
    let results = |name: &str, run: &dyn Fn(&[&str]) -> (Option<i32>, String)| {
        let (part, out) = (of(&format!("{name}.stl")), of(name));
        let words = ["run", "tests/cli/bore.h", "--control", "tnc640", "--lang", "en", "--events"];
        let (code, _) = run(&[&words[..], &["--scene", &of("scene"), "--stock", &part, "--out", &out]].concat());
        let log = std::fs::read(Path::new(&out).join("TCHPR421.TXT"));
        (code, std::fs::read(&part).ok(), log.ok())
    };
    let read = results("read", &|words| told(&run(words)));
    assert!(read.0 == Some(0) && read.1.is_some() && read.2.is_some(), "{:?}", read.0);
    assert!(results("unread", &unread) == read);
}

/// A folder with a program that calls one that calls another one.
fn calling() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("main.h", "0 BEGIN PGM MAIN MM\n1 CALL PGM TNC:\\NC\\SUB.H\n2 END PGM MAIN MM\n");
    write("sub.h", "0 BEGIN PGM SUB MM\n1 CALL PGM DEEPER.I\n2 END PGM SUB MM\n");
    write("deeper.i", "%DEEPER G71 *\nN10 D00 Q7 P01 +7*\nN99999999 %DEEPER G71 *\n");
    folder
}

/// What a run in that folder says.
fn called(folder: &tempfile::TempDir) -> (Option<i32>, String, String) {
    let main = folder.path().join("main.h");
    let output = run(&["run", main.to_str().unwrap(), "--control", "tnc640", "--scene", SCENE, "--lang", "en"]);
    let (code, errors) = told(&output);
    (code, String::from_utf8(output.stdout).unwrap(), errors)
}

#[test]
fn only_programs_that_are_called_are_read() {
    let folder = calling();
    // A file that is there and cannot be read, whoever runs this.
    #[cfg(target_os = "linux")]
    std::os::unix::fs::symlink("/proc/self/mem", folder.path().join("other.h")).unwrap();
    let (code, told, errors) = called(&folder);
    assert_eq!((code, errors.as_str()), (Some(0), ""));
    assert!(told.contains("Q7 = 7"), "{told}");
    let missing = std::fs::remove_file(folder.path().join("deeper.i")).map(|()| called(&folder)).unwrap();
    assert!(missing.0 == Some(1) && missing.2.contains("program-missing"), "{missing:?}");
}

#[test]
#[cfg(target_os = "linux")]
fn a_called_program_that_cannot_be_read_is_trouble() {
    let folder = calling();
    let deeper = folder.path().join("deeper.i");
    std::fs::remove_file(&deeper).unwrap();
    std::os::unix::fs::symlink("/proc/self/mem", &deeper).unwrap();
    let (code, _, errors) = called(&folder);
    assert_eq!(code, Some(2));
    assert!(errors.contains("io-read") && errors.contains("deeper.i"), "{errors}");
    assert!(errors.contains("sub.h:2"), "where it is called: {errors}");
    let (main, out) = (folder.path().join("main.h"), folder.path().join("a.svg"));
    let plot =
        ["plot", main.to_str().unwrap(), "--control", "tnc640", "--scene", SCENE, "--out", out.to_str().unwrap()];
    assert_eq!(run(&plot).status.code(), Some(2));
}

/// What `conform` says of an engine that a shell is.
#[cfg(unix)]
fn engine(script: &str, limit: &str) -> Output {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("engine.sh");
    std::fs::write(&path, script).unwrap();
    let command = format!("sh \"{}\"", path.display());
    run(&["conform", "--control", "tnc320", "--format", "json", "--engine", &command, "--time-limit", limit])
}

/// How many cases there are in a report.
#[cfg(unix)]
fn cases(output: &Output) -> usize {
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    report["cases"].as_array().unwrap().len()
}

#[test]
#[cfg(unix)]
fn an_engine_that_stays_silent_is_given_up() {
    let all = cases(&run(&["conform", "--control", "tnc320", "--format", "json"]));
    // One that says nothing, one that ends, one whose line has no end, and one that ends after its first answer.
    let no_more =
        "[ -e \"$0.asked\" ] && exec sleep 60; touch \"$0.asked\"; read line; echo '{\"id\":1,\"end\":\"done\"}'";
    for (script, limit, asked) in
        [("exec sleep 60", "0.1", 3), ("exit 3", "10", 3), ("exec cat /dev/zero", "60", 3), (no_more, "0.2", 13)]
    {
        let output = engine(script, limit);
        let (code, errors) = told(&output);
        assert_eq!(code, Some(1), "{script}: {errors}");
        assert!(cases(&output) >= asked && cases(&output) < asked + 3, "{script}: {} of {all}", cases(&output));
        assert_eq!(errors.matches("error[engine-not-responding]").count(), 1, "{script}: {errors}");
    }
}

/// Whether a process is there that has not ended; one that nobody has waited for counts as ended.
#[cfg(target_os = "linux")]
fn lives(id: &str) -> bool {
    let status = std::fs::read_to_string(format!("/proc/{id}/stat")).unwrap_or_default();
    status.rsplit_once(") ").is_some_and(|(_, rest)| !rest.starts_with(['Z', 'X']))
}

/// Says whether it comes true within some seconds.
#[cfg(target_os = "linux")]
fn becomes(is: impl Fn() -> bool) -> bool {
    (0..500).any(|_| {
        std::thread::sleep(std::time::Duration::from_millis(20));
        is()
    })
}

#[test]
#[cfg(target_os = "linux")]
fn what_an_engine_starts_ends_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let ids = folder.path().join("ids");
    let script = format!("sleep 300 & echo $! >> \"{0}\"; echo $$ >> \"{0}\"; wait", ids.display());
    let path = folder.path().join("engine.sh");
    std::fs::write(&path, &script).unwrap();
    let all =
        || -> Vec<String> { std::fs::read_to_string(&ids).unwrap_or_default().lines().map(str::to_owned).collect() };
    let output = engine(&script, "0.3");
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(all().len(), 6);
    assert!(becomes(|| !all().iter().any(|id| lives(id))), "{:?}", all());
    // A signal ends them as well.
    let command = format!("sh \"{}\"", path.display());
    let mut child = ciklo(&["conform", "--engine", &command]).stdout(Stdio::null()).spawn().unwrap();
    assert!(becomes(|| all().len() == 8), "the engine runs");
    assert!(all().iter().any(|id| lives(id)));
    assert!(Command::new("kill").args(["-USR1", &child.id().to_string()]).status().unwrap().success());
    child.wait().unwrap();
    assert!(becomes(|| !all().iter().any(|id| lives(id))), "{:?}", all());
}

#[test]
fn an_engine_that_cannot_be_started_is_trouble() {
    for (command, reason) in [("no/such/engine --fast", "“no/such/engine”"), ("", "“”"), ("/", "“/”")] {
        let output = run(&["conform", "--engine", command]);
        let (code, errors) = told(&output);
        assert_eq!((code, output.stdout.len()), (Some(2), 0), "{errors}");
        assert!(errors.starts_with("error[engine-start]") && errors.contains(reason), "{errors}");
        assert_eq!(errors.lines().count(), 1, "{errors}");
    }
    assert!(told(&run(&["--ui-lang", "fi", "conform", "--engine", "no/such"])).1.starts_with("virhe[engine-start]"));
}

#[test]
fn a_time_limit_is_a_time() {
    for limit in ["nan", "0", "-1", "inf", "1e300", "1e-12", "soon"] {
        let limit = format!("--time-limit={limit}");
        let (code, errors) = told(&run(&["conform", "--engine", "no/such/engine", &limit]));
        assert_eq!(code, Some(2));
        assert!(errors.starts_with("error[usage]") && errors.contains("--time-limit"), "{errors}");
    }
}

#[test]
fn a_request_of_any_bytes_is_answered() {
    use std::io::Write as _;
    let mut child = ciklo(&["conform", "--serve"]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    let writer = std::thread::spawn(move || {
        input.write_all(b"\xff\xfe{\n\n").unwrap();
        input.write_all(&vec![b'a'; 40 << 20]).unwrap();
        input.write_all(b"\n{}").unwrap();
    });
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    assert_eq!(output.status.code(), Some(0));
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(text.lines().count(), 4, "{text}");
    assert!(text.lines().all(|line| line.contains("bad-request")), "{text}");
}

/// A stack that no thread can have: the system refuses each.
#[cfg(target_os = "linux")]
const NO_THREAD: (&str, &str) = ("RUST_MIN_STACK", "70368744177664");

#[test]
#[cfg(target_os = "linux")]
fn work_is_done_where_no_thread_can_be_had() {
    let folder = tempfile::tempdir().unwrap();
    let of = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let alone = |arguments: &[&str]| ciklo(arguments).env(NO_THREAD.0, NO_THREAD.1).output().unwrap();
    for words in [
        &["check", "tests/check/planted", "--control", "tnc640", "--no-cache", "--format", "json"][..],
        &["conform", "--control", "tnc320", "--format", "json"],
    ] {
        let output = alone(words);
        assert_eq!((told(&output), output.stdout), (told(&run(words)), run(words).stdout), "{words:?}");
    }
    let part = |name: &str, run: &dyn Fn(&[&str]) -> Output| {
        let part = of(name);
        let output = run(&["run", "tests/cli/part.h", "--control", "tnc640", "--scene", SCENE, "--stock", &part]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        std::fs::read(&part).unwrap()
    };
    assert!(part("alone.stl", &alone) == part("many.stl", &run));
    let output = alone(&["build", "--control", "tnc320", "--lang", "en", "--out", &of("manual")]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    // An engine is asked by threads of its own.
    let (code, errors) = told(&alone(&["conform", "--engine", "cat"]));
    assert!(code == Some(2) && errors.starts_with("error[engine-start]"), "{errors}");
}

#[test]
#[cfg(target_os = "linux")]
fn a_limit_on_the_size_of_files_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let limited = |words: &str| {
        let script = format!("ulimit -f 8; exec \"{}\" {words}", env!("CARGO_BIN_EXE_ciklo"));
        let mut shell = Command::new("sh");
        shell.args(["-c", &script]).current_dir(folder.path()).env_remove("LANG").env_remove("LC_ALL");
        told(&shell.output().unwrap())
    };
    for words in ["schema > schema.json", "build --control tnc320 --lang en --out manual"] {
        let (code, errors) = limited(words);
        assert_eq!(code, Some(2), "{words}: {errors}");
        assert!(errors.contains("error[io-write]") && errors.contains("that large"), "{words}: {errors}");
    }
    let left: Vec<_> = std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["schema.json"]);
}

#[test]
#[cfg(target_os = "linux")]
fn every_signal_that_ends_it_leaves_nothing_half_made() {
    use std::os::unix::process::ExitStatusExt as _;
    let passed_over = std::fs::read_to_string("/proc/self/status").unwrap();
    let mask = passed_over.lines().find_map(|line| line.strip_prefix("SigIgn:")).unwrap();
    let mask = u64::from_str_radix(mask.trim(), 16).unwrap();
    for (name, number) in [("QUIT", 3), ("USR1", 10), ("USR2", 12), ("ALRM", 14), ("XCPU", 24)] {
        if mask >> (number - 1) & 1 == 1 {
            continue;
        }
        let folder = tempfile::tempdir().unwrap();
        // Some of these signals write the memory of the program to a file where that is allowed.
        let script = format!("ulimit -c 0; exec \"{}\" build --out manual", env!("CARGO_BIN_EXE_ciklo"));
        let mut shell = Command::new("sh");
        let mut child = shell.args(["-c", &script]).current_dir(folder.path()).stdout(Stdio::null()).spawn().unwrap();
        let files = || std::fs::read_dir(folder.path()).unwrap().count();
        assert!(becomes(|| files() > 0), "{name}: it has begun");
        assert!(Command::new("kill").args([&format!("-{name}"), &child.id().to_string()]).status().unwrap().success());
        assert_eq!(child.wait().unwrap().signal(), Some(number));
        assert_eq!(files(), 0, "{name}");
    }
}

/// A folder with as many copies of a program as make a cache worth it, and the place of the cache.
fn programs(text: &str) -> (tempfile::TempDir, std::path::PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    for number in 0..16 {
        std::fs::write(folder.path().join(format!("{number}.h")), format!("{text}; {number}\n")).unwrap();
    }
    let place = folder.path().join("cache");
    std::fs::create_dir(&place).unwrap();
    (folder, place)
}

/// What a check of that folder says.
fn checked(folder: &tempfile::TempDir, place: &Path) -> Output {
    let words = ["check", folder.path().to_str().unwrap(), "--control", "tnc640", "--format", "json"];
    ciklo(&words).env("XDG_CACHE_HOME", place).output().unwrap()
}

#[test]
#[cfg(target_os = "linux")]
fn a_cache_is_a_file_and_bounded() {
    let (folder, place) = programs("0 BEGIN PGM A MM\n1 FOO\n2 END PGM A MM\n");
    let first = checked(&folder, &place);
    assert_eq!(first.status.code(), Some(1));
    let file = place.join("ciklo/check.cache");
    let entries = || std::fs::read_to_string(&file).unwrap().lines().count() - 1;
    assert_eq!(entries(), 16);
    // Many findings in one program are not kept.
    let long = format!("0 BEGIN PGM B MM\n{}END PGM B MM\n", "1 FOO\n".repeat(2000));
    std::fs::write(folder.path().join("long.h"), long).unwrap();
    std::fs::write(folder.path().join("short.h"), "0 BEGIN PGM B MM\n1 END PGM B MM\n").unwrap();
    let found = checked(&folder, &place);
    assert_eq!(entries(), 17);
    assert_eq!(checked(&folder, &place).stdout, found.stdout);
    // What is larger than a cache can be is not read.
    let whole = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, format!("{whole}{}", format!("{:032x} []\n", 1).repeat(2_000_000))).unwrap();
    std::fs::write(folder.path().join("new.h"), "0 BEGIN PGM N MM\n1 END PGM N MM\n").unwrap();
    assert_eq!(checked(&folder, &place).stdout, found.stdout);
    assert!(std::fs::metadata(&file).unwrap().len() < 32 << 20);
    // A pipe would wait for ever, for reading and for writing.
    std::fs::remove_file(&file).unwrap();
    assert!(Command::new("mkfifo").arg(&file).status().unwrap().success());
    assert_eq!(checked(&folder, &place).stdout, found.stdout);
    assert!(!std::fs::metadata(&file).unwrap().is_file());
}

#[test]
fn settings_that_cannot_be_read_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let program = folder.path().join("a.h");
    std::fs::write(&program, "0 BEGIN PGM A MM\n1 END PGM A MM\n").unwrap();
    let check = || told(&run(&["check", program.to_str().unwrap(), "--control", "tnc640"]));
    let settings = folder.path().join("ciklo.toml");
    std::fs::create_dir(&settings).unwrap();
    let (code, errors) = check();
    assert_eq!(code, Some(2));
    assert!(errors.contains("ciklo.toml cannot be read: it is a directory"), "{errors}");
    std::fs::remove_dir(&settings).unwrap();
    for (table, says) in [("missing.T", "error[io-read]"), ("a.h", "error[check-no-table]")] {
        std::fs::write(&settings, format!("# Tables\ntables = [\"{table}\"]\n")).unwrap();
        let (code, errors) = check();
        assert_eq!(code, Some(2));
        assert!(errors.contains(says) && errors.contains(table), "{errors}");
        assert!(errors.contains("ciklo.toml:2:11"), "{errors}");
    }
}
