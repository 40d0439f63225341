//! The files that commands read and write: which are found, what becomes of them when somebody else writes them too,
//! and what is told of those that cannot be read.
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

/// A folder for programs.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn put(&self, name: &str, text: &str) {
        let path = self.path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }

    fn text(&self, name: &str) -> String {
        String::from_utf8(std::fs::read(self.path(name)).unwrap()).unwrap()
    }

    /// The command in this folder.
    fn command(&self, arguments: &[&str]) -> Command {
        self.command_of(Path::new(env!("CARGO_BIN_EXE_ciklo")), arguments)
    }

    fn command_of(&self, program: &Path, arguments: &[&str]) -> Command {
        let mut command = Command::new(program);
        command.args(arguments).args(["--ui-lang", "en"]).current_dir(self.0.path()).stdin(Stdio::null());
        for name in ["XDG_CACHE_HOME", "LOCALAPPDATA", "HOME"] {
            command.env(name, self.path("cache"));
        }
        command
    }

    fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().unwrap()
    }

    /// Runs the command as somebody whom permissions hold: they do not hold the administrator.
    #[cfg(unix)]
    fn run_as_user(&self, arguments: &[&str]) -> Output {
        use std::os::unix::fs::MetadataExt as _;
        use std::os::unix::process::CommandExt as _;
        const NOBODY: u32 = 65_534;
        // What is made belongs to who runs the tests.
        let _ = std::fs::remove_file(self.path("probe"));
        self.put("probe", "");
        if std::fs::metadata(self.path("probe")).unwrap().uid() != 0 {
            return self.run(arguments);
        }
        // The folders above the program may not be open to everybody.
        let program = self.path("ciklo.bin");
        std::fs::copy(env!("CARGO_BIN_EXE_ciklo"), &program).unwrap();
        std::os::unix::fs::chown(self.0.path(), Some(NOBODY), Some(NOBODY)).unwrap();
        let all = std::fs::read_dir(self.0.path()).unwrap();
        all.for_each(|own| std::os::unix::fs::chown(own.unwrap().path(), Some(NOBODY), Some(NOBODY)).unwrap());
        self.command_of(&program, arguments).uid(NOBODY).gid(NOBODY).output().unwrap()
    }
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn told(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn found(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// A program with some lines in the middle.
fn program(name: &str, body: &str) -> String {
    format!("0 BEGIN PGM {name} MM\n1 L Z+100 R0 FMAX M3\n{body}8 L X+1 R0 F100\n9 END PGM {name} MM\n")
}

fn calling(name: &str, called: &str) -> String {
    program(name, &format!("2 CALL PGM {called}\n"))
}

/// The same bytes are another program in a file whose name stands for the other dialect.
#[test]
fn what_is_remembered_of_one_dialect_is_not_told_of_the_other() {
    let folder = Folder::new();
    let body = "1 L X+5 R0 FMAX\nG01 X+5 F100\n";
    for number in 0..20 {
        folder.put(&format!("h/{number}.h"), body);
        folder.put(&format!("i/{number}.i"), body);
    }
    let check = |extension: &str, more: &[&str]| {
        found(&folder.run(&[&["check", extension, "--control", "tnc640", "--format", "json"], more].concat()))
    };
    let of = ["h", "i"].map(|extension| check(extension, &["--no-cache"]));
    let codes = |text: &str| text.lines().map(|line| line.split("\"line\"").nth(1).unwrap().to_owned()).next_back();
    assert_ne!(codes(&of[0]), codes(&of[1]));
    for which in [0, 1, 0] {
        assert!(check(["h", "i"][which], &[]) == of[which], "{which}");
    }
    assert!(folder.path("cache").exists());
}

/// However a file is named, it is the same one that others call.
#[test]
fn circles_are_found_however_files_are_named() {
    let folder = Folder::new();
    folder.put("a/l3.h", &calling("l3", "l3b"));
    folder.put("a/l3b.h", &calling("l3b", "L3.H"));
    folder.put("a/ends.h", &calling("ends", "sub"));
    folder.put("a/sub.h", &program("sub", ""));
    let inside = |arguments: &[&str]| folder.command(arguments).current_dir(folder.path("a")).output().unwrap();
    for (command, files) in [("check", &["l3.h", "./l3.h", ".././a/l3.h", "."][..]), ("certify", &["l3.h"])] {
        for file in files {
            let output = inside(&[command, file, "--control", "tnc640"]);
            assert_eq!(code(&output), 1, "{command} {file}: {}", told(&output));
            let circle = ["programs-call-in-circle", "error"];
            assert!(circle.iter().any(|word| found(&output).contains(word)), "{command} {file}: {}", found(&output));
        }
        assert_eq!(code(&inside(&[command, "ends.h", "--control", "tnc640"])), 0);
    }
    let [one, other] = ["l3.h", "./l3.h"].map(|file| inside(&["check", file, "--control", "tnc640"]));
    assert_eq!(found(&one), found(&other).replace("./", ""));
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/c200.scene.yaml");
    let [one, other] =
        ["l3.h", "./l3.h"].map(|file| told(&inside(&["run", file, "--control", "tnc640", "--scene", scene])));
    assert!(one.contains("l3b.h:"), "{one}");
    assert_eq!(one, other.replace("./", ""));
    // A name with folders means the one file that ends so, also where it is given twice.
    folder.put("b/c/one.h", &calling("one", "TNC:\\b\\c\\two.h"));
    folder.put("b/c/two.h", &calling("two", "TNC:\\b\\c\\one.h"));
    for files in [["b/c/one.h", "b/c/two.h"], ["b/c", "./b/c"]] {
        assert_eq!(code(&folder.run(&["check", files[0], files[1], "--control", "tnc640"])), 1, "{files:?}");
    }
}

/// Each program of a chain is looked at once: what grew with the square of the number took minutes here.
#[test]
fn thousands_of_programs_that_call_each_other_take_seconds() {
    const COUNT: usize = 3000;
    let folder = Folder::new();
    folder.put(&format!("p/{COUNT}.h"), &program("last", ""));
    for number in 0..COUNT {
        folder.put(&format!("p/{number}.h"), &calling("p", &format!("{}.h", number + 1)));
    }
    let begun = Instant::now();
    let output = folder.run(&["check", "p", "--control", "tnc640"]);
    assert_eq!((code(&output), found(&output).lines().count()), (0, 0), "{}", told(&output));
    assert!(begun.elapsed() < Duration::from_secs(60), "{:?}", begun.elapsed());
    // Whatever the first one calls changes the last one's circle.
    folder.put(&format!("p/{COUNT}.h"), &calling("p", "0"));
    let output = folder.run(&["check", "p", "--control", "tnc640", "--format", "json"]);
    assert_eq!((code(&output), found(&output).lines().count()), (1, COUNT + 1));
    assert!(begun.elapsed() < Duration::from_secs(120), "{:?}", begun.elapsed());
}

/// How many bytes a process has read.
#[cfg(target_os = "linux")]
fn bytes_read(process: u32) -> u64 {
    let text = std::fs::read_to_string(format!("/proc/{process}/io")).unwrap_or_default();
    text.lines().find_map(|line| line.strip_prefix("rchar: ")?.parse().ok()).unwrap_or_default()
}

/// Somebody writes a file anew while a command works on it: what he wrote stays.
#[cfg(target_os = "linux")]
#[test]
fn what_somebody_writes_meanwhile_stays() {
    const THEIRS: &str = "0 BEGIN PGM THEIRS MM\n1 END PGM THEIRS MM\n";
    let folder = Folder::new();
    let lines: String = (2..40_000).map(|number| format!("{number} L X+{number} R0 FMAX\n")).collect();
    let definition = "1 CYCL DEF 13.0 ORIENTATION\n2 CYCL DEF 13.1 ANGLE 0\n";
    let klartext = format!("0 BEGIN PGM LONG MM\n{definition}{lines}99999 END PGM LONG MM\n");
    let rows: String = (0..20_000).map(|number| format!("{number:<8} drill     +{number}\n")).collect();
    let table = format!("BEGIN TOOL.T MM\nT       NAME       L\n{rows}[END]\n");
    folder.put("deep/none.h", "");
    std::os::unix::fs::symlink("../a.h", folder.path("deep/link.h")).unwrap();
    for (name, text, words) in [
        ("a.h", &klartext, "fmt a.h"),
        ("TOOL.T", &table, "fmt TOOL.T"),
        ("a.h", &klartext, "translate a.h --to it --control tnc640 --out ./a.h"),
        ("a.h", &klartext, "convert a.h --to-iso --out deep/link.h"),
        ("a.h", &klartext, "convert a.h --from itnc530 --to tnc640 --out deep/../a.h"),
        ("a.h", &klartext, "convert a.h --from itnc530 --to tnc640 --in-place"),
    ] {
        // Whoever comes too late writes over what was written, which is nobody's loss.
        let refused = (0..5).any(|_| {
            folder.put(name, text);
            folder.put("theirs", THEIRS);
            let arguments: Vec<&str> = words.split(' ').collect();
            let mut child = folder.command(&arguments).stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
            while bytes_read(child.id()) < text.len() as u64 && child.try_wait().unwrap().is_none() {
                std::thread::sleep(Duration::from_millis(1));
            }
            std::fs::rename(folder.path("theirs"), folder.path(name)).unwrap();
            let output = child.wait_with_output().unwrap();
            assert_eq!(folder.text(name), THEIRS, "{words}: {}", told(&output));
            code(&output) == 2 && told(&output).contains("in the meantime")
        });
        assert!(refused, "{words}");
    }
    let all: Vec<_> = std::fs::read_dir(folder.0.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert!(all.iter().all(|name| !name.to_string_lossy().starts_with('.')), "{all:?}");
}

/// What cannot be looked into is told, and everything else is checked.
#[cfg(unix)]
#[test]
fn a_folder_that_cannot_be_read_hides_no_other() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = Folder::new();
    folder.put("shut/a.h", &program("a", ""));
    folder.put("open/b.h", "0 BEGIN PGM b MM\n5 L X+ R0 FMAX\n9 END PGM b MM\n");
    std::fs::set_permissions(folder.path("shut"), std::fs::Permissions::from_mode(0o0)).unwrap();
    let of = |words: &[&str]| {
        let output = folder.run_as_user(words);
        assert_eq!(code(&output), 2, "{words:?} {}", told(&output));
        assert!(told(&output).contains("shut cannot be read: permission is denied"), "{}", told(&output));
        format!("{}{}", found(&output), told(&output))
    };
    assert!(of(&["check", ".", "--control", "tnc640"]).contains("b.h:2:"));
    assert!(of(&["certify", ".", "--control", "tnc640"]).contains("b.h"));
    assert!(of(&["fmt", ".", "--check"]).contains("b.h"));
}

/// A file that may not be changed is not exchanged either.
#[cfg(unix)]
#[test]
fn a_file_that_may_not_be_written_stays() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = Folder::new();
    let text = "0 BEGIN PGM a MM\n5 L X+5 R0 FMAX\n9 END PGM a MM\n";
    folder.put("a.h", text);
    std::fs::set_permissions(folder.path("a.h"), std::fs::Permissions::from_mode(0o444)).unwrap();
    let output = folder.run_as_user(&["fmt", "a.h"]);
    assert_eq!(code(&output), 2);
    assert!(told(&output).contains("a.h cannot be written: permission is denied"), "{}", told(&output));
    assert_eq!(folder.text("a.h"), text);
    std::fs::set_permissions(folder.path("a.h"), std::fs::Permissions::from_mode(0o640)).unwrap();
    assert_eq!(code(&folder.run_as_user(&["fmt", "a.h"])), 0);
    assert_ne!(folder.text("a.h"), text);
    assert_eq!(std::fs::metadata(folder.path("a.h")).unwrap().permissions().mode() & 0o777, 0o640);
}

/// Who mends somebody else's file does not take it away.
#[cfg(unix)]
#[test]
fn a_file_keeps_its_owner() {
    use std::os::unix::fs::MetadataExt as _;
    let folder = Folder::new();
    folder.put("a.h", "0 BEGIN PGM a MM\n5 L X+5 R0 FMAX\n9 END PGM a MM\n");
    // Only the administrator may give it away first.
    let _ = std::os::unix::fs::chown(folder.path("a.h"), Some(4321), Some(4322));
    let owner = || std::fs::metadata(folder.path("a.h")).map(|known| (known.uid(), known.gid(), known.ino())).unwrap();
    let before = owner();
    assert_eq!(code(&folder.run(&["fmt", "a.h"])), 0);
    assert_ne!(owner().2, before.2, "it was exchanged");
    assert_eq!((owner().0, owner().1), (before.0, before.1));
}

/// What an export or a transfer that was cut off leaves behind does not pass without a word.
#[test]
fn files_without_a_block_are_told() {
    let folder = Folder::new();
    let zeros = "\0".repeat(4096);
    let empty = [("a.h", ""), ("b.i", ""), ("c.h", "\r\n\n"), ("d.h", &zeros), ("e.i", &zeros)];
    let others = [("mode.i", "G90\n"), ("comment.h", "; later\n"), ("comment.i", "; later\n")];
    empty.iter().chain(&others).for_each(|(name, text)| folder.put(name, text));
    let output = folder.run(&["check", ".", "--control", "tnc640", "--format", "json"]);
    let found_in = found(&output);
    let of: Vec<&str> = found_in.lines().filter(|line| line.contains("program-empty")).collect();
    assert_eq!((code(&output), of.len()), (1, empty.len()), "{of:?}");
    assert!(empty.iter().zip(of).all(|((name, _), line)| line.contains(name)));
    let output = folder.run(&["certify", ".", "--control", "tnc640"]);
    assert!(found(&output).contains("program-empty: 5 times"), "{}", found(&output));
}

/// One that is missing does not keep the others from being converted or laid out.
#[test]
fn files_behind_one_that_is_missing_are_written() {
    let text = "0 BEGIN PGM a MM\n5 L X+5 R0 FMAX\n9 END PGM a MM\n";
    for words in ["convert --from itnc530 --to tnc640 --in-place", "fmt"] {
        for missing in ["none.h", "none.txt"] {
            let folder = Folder::new();
            folder.put("a.h", text);
            folder.put("b.h", text);
            let arguments: Vec<&str> = words.split(' ').chain(["a.h", missing, "b.h"]).collect();
            let output = folder.run(&arguments);
            assert_eq!(code(&output), 2, "{arguments:?}");
            let told = told(&output);
            assert!(told.contains("a.h") && told.contains("b.h"), "{told}");
            assert!(told.contains(&format!("{missing} cannot be read: it does not exist")), "{told}");
        }
    }
    let output = Folder::new().run(&["convert", "-", "--from", "itnc530", "--to", "tnc640", "--in-place"]);
    assert!(code(&output) == 2 && told(&output).contains("name a file"), "{}", told(&output));
}

/// Tables and masks beside a program are found; what it prints and writes goes into the folder of `--out`, and nothing goes
/// anywhere else.
#[test]
fn tables_and_masks_are_beside_the_program_and_outputs_below_the_folder() {
    let folder = Folder::new();
    let table = "BEGIN TAB1.TAB MM\nNR   X       DOC\n0    1.5     left\n[END]\n";
    folder.put("part/tab1.tab", table);
    folder.put("part/mask.a", "\"X%6.2LF\",Q10;\nM_CLOSE;\n");
    let body = "2 FN 26: TABOPEN TNC:\\TAB1.TAB\n3 FN 28: TABREAD Q10 = 0/\"X\"\n\
                4 FN 27: TABWRITE 0/\"X\" = Q10\n5 FN 16: F-PRINT TNC:\\MASK.A / TNC:\\LOG\\OUT.TXT\n";
    folder.put("part/a.h", &program("a", body));
    let output = folder.run(&["run", "part/a.h", "--control", "tnc640"]);
    assert_eq!(code(&output), 0, "{}", told(&output));
    assert!(!folder.path("part/OUT.TXT").exists() && !folder.path("OUT.TXT").exists());
    let output = folder.run(&["run", "part/a.h", "--control", "tnc640", "--out", "results"]);
    assert_eq!(code(&output), 0, "{}", told(&output));
    assert_eq!(folder.text("results/OUT.TXT"), "X  1.50\n");
    assert_eq!((folder.text("results/tab1.tab"), folder.text("part/tab1.tab")), (table.to_owned(), table.to_owned()));
    folder.put("part/b.h", &program("b", "2 Q10 = 1\n3 FN 16: F-PRINT MASK.A / ..\\OUT.TXT\n"));
    let output = folder.run(&["run", "part/b.h", "--control", "tnc640", "--out", "results"]);
    assert!(code(&output) == 1 && told(&output).contains("output-path"), "{}", told(&output));
    let written = ["OUT.TXT", "part/OUT.TXT", "results/LOG/OUT.TXT"];
    assert!(written.iter().all(|name| !folder.path(name).exists()));
}

/// What a command that was killed has left in the folder goes when the next one writes there, but nothing that is young, that
/// another process holds, or that has another name.
#[cfg(unix)]
#[test]
fn what_a_killed_command_left_is_cleared_away() {
    let folder = Folder::new();
    folder.put("part.h", "0 BEGIN PGM PART MM\n1 L X1 R0 FMAX\n2 END PGM PART MM\n");
    #[expect(clippy::disallowed_methods, reason = "files on a disk have the age of a clock")]
    let long_ago = std::time::SystemTime::now() - Duration::from_secs(600);
    for name in [".ciklo-abc123", ".ciklo-held00", ".ciklo-build", ".ciklo-toolong"] {
        folder.put(name, "x");
        std::fs::File::open(folder.path(name)).unwrap().set_modified(long_ago).unwrap();
    }
    folder.put(".ciklo-young0", "x");
    let held = std::fs::File::open(folder.path(".ciklo-held00")).unwrap();
    held.lock().unwrap();
    assert!(folder.command(&["fmt", "part.h"]).status().unwrap().success());
    let all = std::fs::read_dir(folder.0.path()).unwrap().map(|entry| entry.unwrap().file_name());
    let mut left: Vec<_> = all.filter(|name| name != "cache").collect();
    left.sort();
    assert_eq!(left, [".ciklo-build", ".ciklo-held00", ".ciklo-toolong", ".ciklo-young0", "part.h"]);
}
