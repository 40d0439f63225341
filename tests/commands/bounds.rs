//! What is too large, leads round in a circle or has a strange name: it is said, in bounded memory, and nothing else is
//! read or written.
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn ciklo(folder: &Path, words: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ciklo"));
    told(&command.args(words).current_dir(folder).stdin(Stdio::null()).env("LC_ALL", "C").output().unwrap())
}

/// Exit code, standard output and standard error.
fn told(output: &Output) -> (Option<i32>, String, String) {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

fn write(folder: &Path, name: &str, text: &str) {
    std::fs::write(folder.join(name), text).unwrap();
}

const EMPTY: &str = "BEGIN PGM E MM\nEND PGM E MM\n";
const UNTIDY: &str = "0 BEGIN PGM U MM\n1  L   X1\n2 END PGM U MM\n";
const BLANK: &str = "BLK FORM 0.1 Z X+0 Y+0 Z-20\nBLK FORM 0.2 X+100 Y+100 Z+0\n";

#[test]
fn a_helix_of_countless_turns_ends_a_run_with_a_stock() {
    let folder = tempfile::tempdir().unwrap();
    let helix = |turn: &str| {
        format!(
            "BEGIN PGM H MM\n{BLANK}TOOL CALL 1 Z S4500 F200\nL Z+50 R0 FMAX M3\nCC X+0 Y+0\nL X+10 Y+0 F100\n\
             CP IPA+{turn} IZ-0.001 DR+ F100\nEND PGM H MM\n"
        )
    };
    write(folder.path(), "s.yaml", "scene: 1\ntools: [{T: 1, L: 50, R: 3}]\n");
    for (turn, code) in [("10000000000", Some(1)), ("3600", Some(0))] {
        write(folder.path(), "h.h", &helix(turn));
        let words = ["run", "h.h", "--control", "tnc640", "--scene", "s.yaml", "--stock", "h.stl", "--resolution", "5"];
        let (ended, _, errors) = ciklo(folder.path(), &words);
        assert_eq!(ended, code, "{turn}: {errors}");
        assert_eq!(errors.contains("error[turn-limit]"), code == Some(1), "{turn}: {errors}");
    }
}

#[test]
fn a_stock_of_too_many_columns_is_refused_before_it_is_made() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "b.h", &format!("BEGIN PGM B MM\n{BLANK}END PGM B MM\n"));
    let words = ["run", "b.h", "--control", "tnc640", "--stock", "b.stl", "--resolution", "0.02"];
    let (code, _, errors) = ciklo(folder.path(), &words);
    assert!(code == Some(2) && errors.contains("error[stock-resolution]"), "{errors}");
}

#[test]
fn a_scene_of_too_many_surfaces_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "e.h", EMPTY);
    let sphere = |at: usize| format!("  - solid: {{sphere: {{centre: [{at}, 0, 0], radius: 0.4}}}}\n");
    let hole = |at: usize| format!("        - box: {{min: [{at}, 0, -9], max: [{at}.5, 1, 0]}}\n");
    let scene = |parts: String| format!("scene: 1\nparts:\n{parts}");
    let block = "  - solid:\n      difference:\n        - box: {min: [-1, -1, -9], max: [9999, 9, 0]}\n";
    let many = [
        (scene((0..3_000).map(sphere).collect()), Some(0)),
        (scene((0..40_000).map(sphere).collect()), Some(1)),
        (scene(format!("{block}{}", (0..3_000).map(hole).collect::<String>())), Some(1)),
    ];
    for (text, code) in many {
        write(folder.path(), "s.yaml", &text);
        let (ended, _, errors) = ciklo(folder.path(), &["run", "e.h", "--control", "tnc640", "--scene", "s.yaml"]);
        assert_eq!(ended, code, "{errors}");
        assert_eq!(errors.contains("error[solid-too-many]"), code == Some(1), "{errors}");
    }
}

/// A triangulated surface is a file beside its scene, wherever the command is called.
#[test]
fn a_scene_names_a_surface_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("shop")).unwrap();
    // A tetrahedron whose tip is at Z 10; the probe comes down 1 beside it.
    let corners = [[-10.0, -10.0, 0.0], [10.0, -10.0, 0.0], [0.0, 10.0, 0.0], [0.0, 0.0, 10.0_f32]];
    let mut bytes = vec![0; 80];
    bytes.extend(4_u32.to_le_bytes());
    for face in [[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3]] {
        bytes.extend([0; 12]);
        bytes.extend(face.iter().flat_map(|at: &usize| corners[*at]).flat_map(f32::to_le_bytes));
        bytes.extend([0; 2]);
    }
    std::fs::write(folder.path().join("shop/tip.stl"), &bytes).unwrap();
    let scene =
        "scene: 1\ntools: [{T: 1, L: 80, R: 2, TP_NO: 1}]\nprobe: {ball_radius: 2}\nparts: [{solid: {stl: tip.stl}}]\n";
    write(&folder.path().join("shop"), "s.yaml", scene);
    let program = "BEGIN PGM P MM\nTOOL CALL 1 Z\nL X+0 Y+0 Z+20 R0 FMAX\nTCH PROBE 0.0 REF. PLANE Q1 Z-\nTCH PROBE 0.1 X+0 Y+0 Z+13\nEND PGM P MM\n";
    write(folder.path(), "p.h", program);
    let words = ["run", "p.h", "--control", "tnc640", "--scene", "shop/s.yaml"];
    let (code, out, errors) = ciklo(folder.path(), &words);
    assert_eq!(code, Some(0), "{errors}");
    assert!(out.contains("Q1 = 10\n"), "{out}");
    for (name, length, wanted) in [("gone.stl", 0, "error[io-read]"), ("tip.stl", 200, "error[scene-stl]")] {
        std::fs::write(folder.path().join("shop/tip.stl"), &bytes[..length]).unwrap();
        write(&folder.path().join("shop"), "s.yaml", &scene.replace("tip.stl", name));
        let (code, _, errors) = ciklo(folder.path(), &words);
        assert_eq!(code, Some(1), "{errors}");
        assert!(errors.contains(wanted) && errors.contains("s.yaml:4"), "{errors}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn labels_with_many_parameters_take_bounded_memory() {
    let folder = tempfile::tempdir().unwrap();
    let parameters: String = (0..1_900).map(|at| format!("QR{at} = {at}\n")).collect();
    let labels: String = (1..20_000).map(|at| format!("LBL {at}\nL X+{}\n", at % 100)).collect();
    write(folder.path(), "l.h", &format!("BEGIN PGM L MM\n{BLANK}{parameters}{labels}END PGM L MM\n"));
    let script = format!("ulimit -v 2000000; exec \"{}\" check l.h --control tnc640", env!("CARGO_BIN_EXE_ciklo"));
    let mut shell = Command::new("sh");
    let (code, out, errors) = told(&shell.args(["-c", &script]).current_dir(folder.path()).output().unwrap());
    assert!(matches!(code, Some(0 | 1)) && errors.contains("1 program checked"), "{code:?} {out} {errors}");
}

#[test]
#[cfg(unix)]
fn links_in_folders_are_passed_over_and_what_they_name_stays_as_it_is() {
    use std::os::unix::fs::symlink;
    let (folder, elsewhere) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    write(elsewhere.path(), "p.h", UNTIDY);
    write(folder.path(), "own.h", UNTIDY);
    symlink(elsewhere.path().join("p.h"), folder.path().join("l.h")).unwrap();
    symlink(elsewhere.path(), folder.path().join("sub")).unwrap();
    symlink("nowhere", folder.path().join("x.h")).unwrap();
    let (code, _, errors) = ciklo(folder.path(), &["check", ".", "--control", "tnc640"]);
    assert_eq!(code, Some(0), "{errors}");
    assert!(errors.contains("note[passed-over]: ./sub and one other entry were skipped"), "{errors}");
    assert!(errors.contains("2 programs checked"), "{errors}");
    let (code, _, errors) = ciklo(folder.path(), &["fmt", "."]);
    assert_eq!(code, Some(0), "{errors}");
    assert!(errors.contains("./l.h and 2 other entries were skipped"), "{errors}");
    assert_eq!(std::fs::read_to_string(elsewhere.path().join("p.h")).unwrap(), UNTIDY);
    assert_ne!(std::fs::read_to_string(folder.path().join("own.h")).unwrap(), UNTIDY);
    // What is named itself is written.
    let (code, _, errors) = ciklo(folder.path(), &["fmt", "l.h"]);
    assert_eq!(code, Some(0), "{errors}");
    assert_ne!(std::fs::read_to_string(elsewhere.path().join("p.h")).unwrap(), UNTIDY);
}

#[test]
#[cfg(unix)]
fn links_between_folders_of_data_are_refused() {
    use std::os::unix::fs::symlink;
    let folder = tempfile::tempdir().unwrap();
    for top in ["cycle-specs", "locales", "templates"] {
        std::fs::create_dir(folder.path().join(top)).unwrap();
    }
    symlink("..", folder.path().join("cycle-specs/up")).unwrap();
    let (code, out, errors) = ciklo(folder.path(), &["lint", "--data", "."]);
    assert!(code == Some(2) && out.is_empty(), "{out}{errors}");
    assert!(errors.starts_with("error[io-read]: ./cycle-specs/up ") && errors.contains("link"), "{errors}");
}

#[test]
#[cfg(unix)]
fn names_of_files_do_not_reach_the_terminal_as_commands() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt as _;
    let folder = tempfile::tempdir().unwrap();
    let name = "a\u{1b}[31m\n--> b.h";
    write(folder.path(), name, &UNTIDY.replace("X1", "X1\n2 FOO"));
    for words in [&["check", name, "--control", "tnc640"][..], &["fmt", "--check", name], &["fmt", name]] {
        let (_, out, errors) = ciklo(folder.path(), words);
        let all = out + &errors;
        assert!(all.contains("a␛[31m␊--> b.h") && !all.contains('\u{1b}'), "{words:?}: {all}");
    }
    // One that is no text is refused as a word of the command line, and checked in its folder.
    std::fs::remove_file(folder.path().join(name)).unwrap();
    let name = OsStr::from_bytes(b"\xff.h");
    std::fs::write(folder.path().join(name), EMPTY).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_ciklo"));
    let command = command.arg("check").arg(name).args(["--control", "tnc640"]).current_dir(folder.path());
    let (code, _, errors) = told(&command.env("LC_ALL", "C").output().unwrap());
    assert!(code == Some(2) && errors.starts_with("error[usage]: An argument is not valid text"), "{errors}");
    let (code, _, errors) = ciklo(folder.path(), &["check", ".", "--control", "tnc640"]);
    assert!(code == Some(0) && errors.contains("1 program checked"), "{errors}");
}
