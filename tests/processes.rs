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
