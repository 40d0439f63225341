//! Prints how many blocks, cycle calls and probing cycles the engine executes in a second, how many moves take material
//! from a stock, how long the paths of strategies take by themselves, and what memory a run of many moves takes:
//! `cargo bench --bench engine`, or one part of it: `cargo bench --bench engine -- stock` (`memory`, `strategy`,
//! `contour`, `turning`, `blocks`, `process`, `kinematics`, `surface`). A region of 10,000 elements with 50 islands is to be cleared in less than 2 s, in a time
//! that grows no faster than n log n, and a contour of the manual's size (`22 rough-out`) in less than 5 ms a call.
//!
//! Where LinuxCNC's `rs274` is installed (Debian package `linuxcnc-uspace`), the same work as RS274 text runs beside it.
//! A move of the stock is one of 0.25 to 1 mm, as programs of such parts have them; a longer way is told by the steps of
//! 0.25 mm that it stands for as well. Nothing is judged here.
use std::hint::black_box;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::time::{Duration, Instant};
use std::{env, fs};

use ciklo::base::data;
use ciklo::base::diag::Source;
use ciklo::base::expr::{cosd, sind};
use ciklo::engine::geometry::{Axis, Frame};
use ciklo::engine::region::contours::{Closed, Contour};
use ciklo::engine::region::{Edge, Way};
use ciklo::engine::run::{Engine, EventKind, NoTexts};
use ciklo::engine::scene::Scene;
use ciklo::engine::solid::{Body, Mesh, Path, Shape};
use ciklo::engine::stock::{Batch, Cutter, Machining, Stock, Tip};
use ciklo::engine::strategy::contour::{Clearing, Contours};
use ciklo::engine::strategy::shape::{pocket_and_slot, thread};
use ciklo::engine::strategy::{self, Milling};
use ciklo::program::syntax::parse;
use ciklo::spec::{Catalogue, OnControl};
use glam::{DVec2, DVec3};

const ROUNDS: u32 = 3;
const PROCESS_ROUNDS: u32 = 7;
const BLOCKS: usize = 200_000;
const CALLS: usize = 20_000;
/// Calls of a program that is executed by a process of its own.
const PROCESS_CALLS: usize = 50_000;
const PROBINGS: usize = 1_000;
const ROUGHINGS: usize = 100;

/// A contour of the size of the manual's examples: two pockets that overlap, with an island in each (TNC 640 manual,
/// lines 4897-5044).
const ROUGHING: &str = "CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL 1 /2 /3 /4\n\
    CYCL DEF 20 CONTOUR DATA Q1=-20 Q2=1 Q3=+0.5 Q4=+0.5 Q5=+0 Q6=2 Q7=+100 Q8=0.1 Q9=-1\n\
    CYCL DEF 22 ROUGH-OUT Q10=5 Q11=100 Q12=350 Q18=0 Q19=0 Q208=9999\n";
const PARTIAL: &str = "L Z+100 R0 FMAX M2\nLBL 1\nCC X+35 Y+50\nL X+10 Y+50 RR\nC X+10 DR-\nLBL 0\n\
    LBL 2\nCC X+65 Y+50\nL X+90 Y+50 RR\nC X+90 DR-\nLBL 0\n\
    LBL 3\nL X+27 Y+50 RL\nL Y+58\nL X+43\nL Y+42\nL X+27\nL Y+50\nLBL 0\n\
    LBL 4\nL X+65 Y+42 RL\nL X+57\nL X+65 Y+58\nL X+73 Y+42\nL X+65\nLBL 0\n";

const SCENE: &str = "scene: 1\nmachine: mill-3-axis\ntools: [{T: 1, L: 80, R: 5}, {T: 2, L: 100, R: 2, TP_NO: 1}]\n\
    probe: {NO: 1, ball_radius: 2}\nstart: [0, 0, 50]\nparts:\n  - solid:\n      difference:\n        \
    - box: {min: [-50, -50, -20], max: [50, 50, 0]}\n        - cylinder: {axis: Z, diameter: 40, from: 0, to: -20}\n";

const PECKING: &str = "CYCL DEF 200 DRILLING\nQ200=2\nQ201=-20\nQ206=250\nQ202=5\nQ210=0\nQ203=+0\nQ204=10\nQ211=0\n";

const PROBING: &str = "TCH PROBE 421 MEASURE HOLE\nQ273=+0\nQ274=+0\nQ262=40\nQ325=+0\nQ247=+90\nQ261=-5\nQ320=0\n\
    Q260=+20\nQ301=0\nQ275=0\nQ276=0\nQ279=0\nQ280=0\nQ281=0\nQ309=0\nQ330=0\nQ423=4\nQ365=1\n";

struct Work {
    name: &'static str,
    count: usize,
    klartext: String,
    rs274: Option<String>,
}

fn frame(tool: u8, body: &str) -> String {
    format!("BEGIN PGM BENCH MM\nTOOL CALL {tool} Z S2000\nL Z+50 R0 FMAX M3\n{body}END PGM BENCH MM\n")
}

fn works(calls: usize) -> Vec<Work> {
    let at = |n: usize| (n % 97, n % 31);
    let lines: String = (0..BLOCKS).map(at).map(|(x, y)| format!("L X+{x}.125 Y-{y}.5 R0 F500\n")).collect();
    let lines_rs: String = (0..BLOCKS).map(at).map(|(x, y)| format!("G1 X{x}.125 Y-{y}.5\n")).collect();
    let called: String = (0..calls).map(at).map(|(x, y)| format!("L X+{x} Y+{y} R0 FMAX M99\n")).collect();
    let calls_rs: String = (0..calls).map(at).map(|(x, y)| format!("G83 X{x} Y{y} Z-20 R2 Q5\n")).collect();
    let head = "G21 G90 G17 G94\nF500\nS2000 M3\nG0 Z50\n";
    vec![
        Work {
            name: "straight blocks",
            count: BLOCKS,
            klartext: frame(1, &lines),
            rs274: Some(format!("{head}{lines_rs}M2\n")),
        },
        Work {
            name: "pecking calls (4 infeeds)",
            count: calls,
            klartext: frame(1, &format!("{PECKING}{called}")),
            rs274: Some(format!("{head}G99\n{calls_rs}G80\nM2\n")),
        },
        Work {
            name: "four-point probing cycles",
            count: PROBINGS,
            klartext: frame(2, &PROBING.repeat(PROBINGS)),
            rs274: None,
        },
        Work {
            name: "22 rough-out",
            count: ROUGHINGS,
            klartext: frame(1, &format!("{ROUGHING}{}{PARTIAL}", "CYCL CALL\n".repeat(ROUGHINGS))),
            rs274: None,
        },
    ]
}

/// The best of some rounds: the others were disturbed.
fn best(mut work: impl FnMut()) -> Duration {
    let once = |work: &mut dyn FnMut()| {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    (0..ROUNDS).map(|_| once(&mut work)).min().unwrap_or_default()
}

/// Events of the run, parsing not counted.
fn execute(work: &Work, on: &OnControl, scene: &Scene) -> (Duration, usize) {
    let program = parse(&Source::new("bench.h", work.klartext.as_str()));
    let mut events = 0_usize;
    let time = best(|| {
        events = 0;
        let outcome = Engine::new(&program, on, scene, &NoTexts).observe(&mut |event| {
            black_box(event);
            events += 1;
        });
        if let Some(diagnostic) = outcome.diagnostic {
            println!("{}: ended with {} {:?}", work.name, diagnostic.code, diagnostic.args);
        }
    });
    (time, events)
}

/// Programs as a user has them executed, in a process each that writes every event, beside `rs274 -g` that does the same:
/// the best of some rounds in turn, so that both are disturbed alike.
fn processes() {
    let Ok(folder) = tempfile::tempdir() else { return };
    let of = |name: &str| folder.path().join(name);
    let written = |name: &str, text: &str| fs::write(of(name), text).is_ok();
    let quiet = |command: &mut Command| {
        let start = Instant::now();
        let run = command.current_dir(folder.path()).stdout(Stdio::null()).stderr(Stdio::null()).status();
        run.ok().map(|_| start.elapsed())
    };
    for work in works(PROCESS_CALLS) {
        let Some(text) = &work.rs274 else { continue };
        if ![("w.h", work.klartext.as_str()), ("w.ngc", text), ("w.yaml", SCENE)].iter().all(|(n, t)| written(n, t)) {
            println!("{}: a temporary file could not be written", work.name);
            continue;
        }
        let (mut own, mut peer) = (Duration::MAX, None::<Duration>);
        for _ in 0..PROCESS_ROUNDS {
            let words = ["run", "w.h", "--control", "tnc640", "--scene", "w.yaml", "--events"];
            let time = quiet(Command::new(env!("CARGO_BIN_EXE_ciklo")).args(words));
            own = own.min(time.unwrap_or(Duration::MAX));
            let time = quiet(Command::new("rs274").args(["-g", "w.ngc"]));
            peer = time.map(|time| peer.map_or(time, |best| best.min(time))).or(peer);
        }
        let line = |name: &str, time: Duration| {
            println!("{:8} {:>7} {:26} {:>7.1} ms", name, work.count, work.name, time.as_secs_f64() * 1e3);
        };
        line("ciklo", own);
        match peer {
            Some(peer) => {
                line("rs274", peer);
                println!("{:43} {:>7.1} times as fast", "", peer.as_secs_f64() / own.as_secs_f64());
            }
            None => println!("rs274    is not installed (Debian package linuxcnc-uspace)"),
        }
    }
}

/// A tilting and a rotary table whose places are optimized from eight positions of each, as a process of its own.
fn kinematics() {
    const SCENE: &str = "scene: 1\nmachine: mill-table-ac\nkinematics:\n  errors: [{axis: A, centre: [0, 0.03, -0.02]}, {axis: C, centre: [0.02, -0.03, 0]}]\n\
        tools: [{T: 1, L: 100, R: 2, TP_NO: 1}]\nprobe: {NO: 1, ball_radius: 2, SET_UP: 5, F: 300, FMAX: 3000, DIST: 20}\n\
        presets: {active: 1, rows: [{NO: 1, X: 100, Y: 20, Z: -50}]}\nparts: [{solid: {sphere: {radius: 12.5}}}]\nstart: [0, 0, 60]\n";
    const PROGRAM: &str = "BEGIN PGM BENCH MM\nTOOL CALL 1 Z\nTCH PROBE 451\nQ406=1\nQ407=12.5\nQ320=0\nQ408=0\nQ253=2000\nQ380=0\n\
        Q411=-80\nQ412=70\nQ413=0\nQ414=8\nQ415=0\nQ416=0\nQ417=0\nQ418=0\nQ419=-170\nQ420=160\nQ421=0\nQ422=8\nQ423=4\nQ431=0\nQ432=0\n\
        END PGM BENCH MM\n";
    let Ok(folder) = tempfile::tempdir() else { return };
    if [("k.h", PROGRAM), ("k.yaml", SCENE)]
        .iter()
        .any(|(name, text)| fs::write(folder.path().join(name), text).is_err())
    {
        return println!("kinematics: a temporary file could not be written");
    }
    let mut best = Duration::MAX;
    for _ in 0..PROCESS_ROUNDS {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ciklo"));
        command.args(["run", "k.h", "--control", "tnc640", "--scene", "k.yaml"]).current_dir(folder.path());
        let start = Instant::now();
        let ended = command.stdout(Stdio::null()).stderr(Stdio::null()).status();
        if !ended.is_ok_and(|status| status.success()) {
            return println!("kinematics: the program did not end well");
        }
        best = best.min(start.elapsed());
    }
    println!("optimizing two rotary axes at 2 x 8 positions, whole process {:>7.1} ms", best.as_secs_f64() * 1e3);
}

/// Contacts of a ball of 6 mm with a wave of triangles: down on it, and along it where nothing is touched.
fn surface() {
    for cells in [22_usize, 71, 224, 707] {
        let at = |k: usize| k as f64 * PART / cells as f64;
        let height = |x: f64, y: f64| 5.0 * libm::sin(x / 9.0) * libm::cos(y / 7.0);
        let corner = |i: usize, j: usize| DVec3::new(at(i), at(j), height(at(i), at(j)));
        let triangles: Vec<[DVec3; 3]> = (0..cells * cells)
            .flat_map(|k| {
                let (i, j) = (k % cells, k / cells);
                let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
                [[a, b, c], [a, c, d]]
            })
            .collect();
        let start = Instant::now();
        let Some(mesh) = Mesh::new(&triangles) else { return };
        let Ok(body) = Body::new(&Shape::Mesh(Arc::new(mesh))) else { return };
        let made = start.elapsed();
        let place = |n: usize| DVec3::new(5.0 + (n * 37 % 90) as f64, 5.0 + (n * 53 % 90) as f64, 0.0);
        let down = best(|| {
            for n in 0..PROBINGS {
                let over = place(n) + DVec3::Z * 40.0;
                let _ = black_box(body.first_contact(3.0, over, over - DVec3::Z * 60.0));
            }
        });
        let across = best(|| {
            for n in 0..PROBINGS {
                let at = place(n) + DVec3::Z * 8.5;
                let _ = black_box(body.first_contact(3.0, at, at + DVec3::new(60.0, 20.0, 0.0)));
            }
        });
        let each = |time: Duration| time.as_secs_f64() * 1e6 / PROBINGS as f64;
        println!(
            "surface of {:>9} triangles: made in {:>7.1} ms, a contact {:>7.1} us, a free way of 63 mm {:>7.1} us",
            triangles.len(),
            made.as_secs_f64() * 1e3,
            each(down),
            each(across)
        );
    }
}

/// The same work by `rs274`, its start included; nothing if it is not installed.
fn peer(text: &str) -> Option<Duration> {
    let path = env::temp_dir().join(format!("ciklo-bench-{}.ngc", std::process::id()));
    fs::write(&path, text).ok()?;
    let run = || Command::new("rs274").arg("-g").arg(&path).stdout(Stdio::null()).stderr(Stdio::null()).status();
    let installed = run().is_ok();
    let time = installed.then(|| best(|| drop(run())));
    fs::remove_file(&path).ok()?;
    time
}

/// A part of 100 x 100 x 30 mm in columns of 0.1 mm.
const PART: f64 = 100.0;
const RESOLUTION: f64 = 0.1;
const TOGETHER: usize = 4096;

/// A way over the part, line by line to and fro, in moves of that length.
fn meander(step: f64, beside: f64, height: impl Fn(f64, f64) -> f64) -> Vec<DVec3> {
    let (along, lines) = ((PART / step) as usize, (PART / beside) as usize);
    let mut points = Vec::new();
    for line in 0..=lines {
        for n in 0..=along {
            let x = step * if line % 2 == 0 { n } else { along - n } as f64;
            let y = beside * line as f64;
            points.push(DVec3::new(x, y, height(x, y)));
        }
    }
    points
}

fn lines(points: &[DVec3]) -> Vec<Path> {
    points.windows(2).filter_map(|pair| Some(Path::line(*pair.first()?, *pair.last()?))).collect()
}

/// A tool that goes down along circles in short arcs, from the top again when it is 20 mm deep: what comes later cuts little.
fn ramps(radius: f64, length: f64, count: usize) -> Vec<Path> {
    let (middle, fall) = (DVec3::new(PART / 2.0, PART / 2.0, 0.0), length / 40.0);
    let turn = length / radius;
    let arc = |n: usize| {
        let (angle, z) = (turn * n as f64, -fall * n as f64 % 20.0);
        let centre = middle + DVec3::Z * z;
        let from = centre + DVec3::new(libm::cos(angle), libm::sin(angle), 0.0) * radius;
        Path::Arc { centre, axis: DVec3::Z, from, sweep: turn.to_degrees(), rise: -fall }
    };
    (0..count).map(arc).collect()
}

/// Seconds that all processors together have spent on this program, where the system tells it.
fn spent() -> f64 {
    let ticks = fs::read_to_string("/proc/self/stat").ok().and_then(|text| {
        let fields: Vec<f64> =
            text.rsplit(')').next()?.split_whitespace().skip(11).take(2).flat_map(str::parse).collect();
        Some(fields.iter().sum::<f64>())
    });
    ticks.unwrap_or(f64::NAN) / 100.0
}

/// The memory of this program now and at most so far, where the system tells it.
fn memory() -> String {
    let text = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = |key: &str| text.lines().find_map(|line| line.strip_prefix(key)).map_or("unknown", str::trim);
    format!("{} now, {} at most", line("VmRSS:"), line("VmHWM:"))
}

/// A million moves by a short program, so that its text does not count: they are executed, told and cut.
fn streaming() {
    const MARKS: [u64; 3] = [20_000, 200_000, 1_000_000];
    let there = "L IX+0.25 R0 F500\n".repeat(10);
    let back = "L IX-0.25 R0 F500\n".repeat(10);
    let text = format!(
        "BEGIN PGM BENCH MM\nBLK FORM 0.1 Z X+0 Y+0 Z-30\nBLK FORM 0.2 X+100 Y+100 Z+0\nTOOL CALL 1 Z S2000\n\
         L X+50 Y+50 R0 FMAX M3\nL Z-1 R0 FMAX\nLBL 1\n{there}{back}CALL LBL 1 REP 49999\nEND PGM BENCH MM\n"
    );
    let files = data::embedded();
    let (catalogue, _) = Catalogue::load(&files);
    let Some(on) = catalogue.on("tnc640") else { return };
    let Ok(scene) = Scene::parse(&Source::new("bench.scene.yaml", SCENE), &files) else { return };
    let program = parse(&Source::new("bench.h", text));
    let Ok(mut machining) = Machining::new(&program, &scene, Some(RESOLUTION)) else { return };
    let mut moves = 0;
    println!("memory before the first move          {}", memory());
    let outcome = Engine::new(&program, on, &scene, &NoTexts).observe(&mut |event| {
        machining.see(event);
        if matches!(event.kind, EventKind::Move { .. }) {
            moves += 1;
            if MARKS.contains(&moves) {
                println!("memory after {moves:>7} moves            {}", memory());
            }
        }
    });
    if let Some(diagnostic) = outcome.diagnostic {
        println!("ended with {} {:?}", diagnostic.code, diagnostic.args);
    }
}

/// Calls of a cycle that turns a shoulder in so many passes, and what its body costs beside them.
fn turning() {
    const SHOULDERS: usize = 1000;
    const PASSES: usize = 20;
    const BODIES: u32 = 500;
    let head = "BEGIN PGM BENCH MM\nTOOL CALL 1 Z\nFUNCTION MODE TURN\nFUNCTION TURNDATA SPIN VCONST:OFF S500\n\
        L X+124 Z+2 R0 FMAX M303\nCYCL DEF 812 SHOULDER\nQ215=+1\nQ460=+2\nQ491=+120\nQ492=+0\nQ493=+80\nQ494=-60\n\
        Q495=+0\nQ501=+1\nQ502=+0.5\nQ500=+1\nQ496=+0\nQ503=+1\nQ504=+0.5\nQ463=+1.1\nQ478=+300\nQ483=+0.4\nQ484=+0.2\n\
        Q505=+100\nQ506=+0\n";
    let scene = "scene: 1\ntools: [{T: 1, L: 80, R: 0, RS: 0.8, T-ANGLE: 95, P-ANGLE: 80}]\nstart: [62, 0, 2]\n\
        stock: {cylinder: {diameter: 120, from: -100, to: 0}}\n";
    let files = data::embedded();
    let (catalogue, _) = Catalogue::load(&files);
    let Some(on) = catalogue.on("tnc640") else { return };
    let Ok(scene) = Scene::parse(&Source::new("bench.scene.yaml", scene), &files) else { return };
    let program = |calls: usize| {
        parse(&Source::new("bench.h", format!("{head}{}END PGM BENCH MM\n", "CYCL CALL\n".repeat(calls))))
    };
    let (many, once) = (program(SHOULDERS), program(1));
    let is_move = |kind: &EventKind| matches!(kind, EventKind::Move { .. });
    let (mut moves, mut work) = (0_usize, f64::INFINITY);
    let time = best(|| {
        moves = 0;
        let before = spent();
        let outcome = Engine::new(&many, on, &scene, &NoTexts).with_catalogue(&catalogue).observe(&mut |event| {
            moves += usize::from(is_move(&event.kind));
            black_box(event);
        });
        work = work.min(spent() - before);
        if let Some(diagnostic) = outcome.diagnostic {
            println!("turning: ended with {} {:?}", diagnostic.code, diagnostic.args);
        }
    });
    let count = moves as f64;
    println!(
        "{SHOULDERS} shoulders: {moves} moves, {:.0}/s, {:.0} in a second of one processor",
        count / time.as_secs_f64(),
        count / work.max(0.01)
    );
    let (mut events, mut passes) = (Vec::new(), 0_u32);
    Engine::new(&once, on, &scene, &NoTexts).with_catalogue(&catalogue).observe(&mut |event| {
        let step = event.at.cycle.as_ref().and_then(|(_, step)| step.as_deref());
        passes += u32::from(is_move(&event.kind) && step == Some("cut-longitudinally"));
        events.push(event.clone());
    });
    let (mut least, mut work) = (Duration::MAX, 0.0);
    for _ in 0..BODIES {
        let Ok(mut machining) = Machining::new(&once, &scene, Some(20.0)) else { return };
        let (start, before) = (Instant::now(), spent());
        events.iter().for_each(|event| machining.see(event));
        least = least.min(start.elapsed());
        work += spent() - before;
        black_box(machining.finish());
    }
    let per_pass = |seconds: f64| seconds * 1e6 / f64::from(passes.max(1));
    println!(
        "body of a shoulder of {passes} passes (about {PASSES}): {:.1} us a pass at best, {:.1} us of one processor on average",
        per_pass(least.as_secs_f64()),
        per_pass(work / f64::from(BODIES))
    );
}

/// Full helices side by side.
fn helices() -> Vec<Path> {
    let at = |n: usize| DVec3::new((n % 10) as f64 * 9.0 + 5.0, (n / 10 % 10) as f64 * 9.0 + 5.0, -((n / 100) as f64));
    let helix =
        |centre: DVec3| Path::Arc { centre, axis: DVec3::Z, from: centre + DVec3::X * 2.0, sweep: 360.0, rise: -1.0 };
    (0..2000).map(at).map(helix).collect()
}

fn removal() {
    let flat = Cutter { radius: 5.0, tip: Tip::Flat, neck: None, edges: 0.0 };
    let ball = Cutter { radius: 3.0, tip: Tip::Round(3.0), neck: None, edges: 0.0 };
    let wave = |x: f64, y: f64| -12.0 + 3.0 * libm::sin(x / 9.0) * libm::cos(y / 7.0);
    let levels = |step: f64, beside: f64| -> Vec<Path> {
        (1..=10).flat_map(|level| lines(&meander(step, beside, |_, _| -f64::from(level)))).collect()
    };
    let wave_path = |left: f64, beside: f64| lines(&meander(0.25, beside, |x, y| wave(x, y) + left));
    // Name, tool, moves, steps of 0.25 mm in a move, and what has been cut before.
    let works = [
        ("roughing, flat 10 mm, 1 mm moves", flat, levels(1.0, 5.0), 4.0, vec![]),
        ("roughing, flat 10 mm, 0.25 mm moves", flat, levels(0.25, 5.0), 1.0, vec![]),
        ("finishing 0.5 mm, ball 6 mm, 0.25 mm", ball, wave_path(0.0, 0.2), 1.0, wave_path(0.5, 1.0)),
        ("from the solid, ball 6 mm, 0.25 mm", ball, wave_path(0.0, 0.2), 1.0, vec![]),
        ("levelling, ball 6 mm, 0.25 mm moves", ball, lines(&meander(0.25, 0.2, |_, _| -8.0)), 1.0, vec![]),
        ("helix of 60 mm, flat 10 mm, 0.25 mm", flat, ramps(30.0, 0.25, 40_000), 1.0, vec![]),
        ("  the same, in the solid alone", flat, ramps(30.0, 0.25, 3_000), 1.0, vec![]),
        ("helix of 60 mm, ball 6 mm, 0.25 mm", ball, ramps(30.0, 0.25, 40_000), 1.0, vec![]),
        ("helix of 6 mm, flat 10 mm, 0.25 mm", flat, ramps(3.0, 0.25, 20_000), 1.0, vec![]),
        ("full helices 14 mm wide, flat 10 mm", flat, helices(), std::f64::consts::TAU * 2.0 / 0.25, vec![]),
    ];
    let bounds = [DVec3::new(0.0, 0.0, -30.0), DVec3::new(PART, PART, 0.0)];
    let [min, max] = bounds;
    let Ok(blank) = Stock::new(&Shape::Box { min, max }, bounds, Frame::IDENTITY, Axis::Z, RESOLUTION) else { return };
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    println!("stock of 100 x 100 x 30 mm at 0.1 mm, {processors} processors");
    let cut = |stock: &mut Stock, cutter: &Cutter, paths: &[Path]| {
        let mut batch = Batch::default();
        for paths in paths.chunks(TOGETHER) {
            paths.iter().for_each(|path| stock.add(&mut batch, path, DVec3::Z, cutter, false));
            black_box(stock.carry_out(&mut batch));
        }
    };
    for (name, cutter, paths, steps, before) in works {
        let mut begun = blank.clone();
        cut(&mut begun, &cutter, &before);
        let (mut best, mut work) = (Duration::MAX, f64::INFINITY);
        for _ in 0..ROUNDS {
            let mut stock = begun.clone();
            let (start, before) = (Instant::now(), spent());
            cut(&mut stock, &cutter, &paths);
            best = best.min(start.elapsed());
            work = work.min(spent() - before);
        }
        let (count, time) = (paths.len() as f64, best.as_secs_f64());
        let rates = |count: f64| {
            let each = count / work.max(0.01);
            format!("{:>9.0}/s, {each:>9.0} in a second of one processor", count / time)
        };
        println!("{name:37} moves {}", rates(count));
        if steps > 1.0 {
            println!("{:37} steps {}", "  the same by steps of 0.25 mm", rates(count * steps));
        }
    }
}

/// The path of one strategy by itself: no cycle, no program, nothing moves.
fn drawing() {
    const PATHS: u32 = 10_000;
    let tool = strategy::Cutter { radius: 5.0 };
    let centre = DVec3::ZERO;
    let pocket = pocket_and_slot::ClearRectangleLevel {
        centre,
        climb: 1.0,
        length: 80.0,
        width: 60.0,
        corner: 8.0,
        rotation: 15.0,
        stepover: 4.0,
        at: 500.0,
    };
    let circle = pocket_and_slot::ClearCircleLevel { centre, climb: 1.0, diameter: 80.0, stepover: 4.0, at: 500.0 };
    let thread = thread::MillThreadHelix {
        centre,
        surface: 0.0,
        depth: -20.0,
        diameter: 16.0,
        pitch: 2.0,
        outside: 0.0,
        climb: 1.0,
        threads: 2.0,
        at: 500.0,
        between: 2000.0,
    };
    fn timed<S: Milling>(strategy: &S, tool: strategy::Cutter) {
        let mut legs = 0;
        let time = best(|| {
            legs = 0;
            for _ in 0..PATHS {
                legs += black_box(black_box(strategy).path(tool, DVec3::ZERO)).legs.len();
            }
        });
        println!(
            "{:26} paths {:>10.0}/s, legs {:>11.0}/s",
            S::NAME,
            f64::from(PATHS) / time.as_secs_f64(),
            legs as f64 / time.as_secs_f64()
        );
    }
    timed(&pocket, tool);
    timed(&circle, tool);
    timed(&thread, tool);
}

/// A region of so many elements: half of them of a pocket, the others of 50 islands.
fn region(elements: usize) -> Vec<Closed> {
    const ISLANDS: usize = 50;
    let wavy = |centre: DVec2, radius: f64, count: usize, side: i8| {
        let corner = |n: usize| {
            let turn = (n % count) as f64 * 360.0 / count as f64;
            let radius = radius * (1.0 + 0.05 * sind(turn * 11.0));
            centre + DVec2::new(cosd(turn), sind(turn)) * radius
        };
        let edges = (1..=count).map(|n| Edge::Line(corner(n))).collect();
        Contour { way: Way { start: corner(0), edges }, side }
    };
    let pocket = wavy(DVec2::ZERO, 400.0, elements / 2, 1);
    let places = (0..8).flat_map(|x| (0..8).map(move |y| DVec2::new(f64::from(x) - 3.5, f64::from(y) - 3.5) * 70.0));
    let inside = places.filter(|at| at.length() < 330.0).take(ISLANDS);
    let islands = inside.map(|at| wavy(at, 15.0, elements / 2 / ISLANDS, -1));
    std::iter::once(pocket).chain(islands).filter_map(|contour| contour.closed().ok()).collect()
}

/// Large regions cleared, and how the time grows.
fn clearing() {
    let way = Clearing { stepover: 10.0, allowance: 0.5, rounding: 0.0, climb: 1.0, coarse: None, floors: false };
    let mut first = None;
    for elements in [2_500, 5_000, 10_000] {
        let closed = region(elements);
        let mut edges = 0;
        let time = best(|| {
            let contours = Contours::new(closed.clone(), DVec2::ZERO, 10.0);
            edges = contours.paths(&way, 10.0).map_or(0, |parts| parts.iter().map(|part| part.path.edges.len()).sum());
        });
        let ideal = elements as f64 * libm::log(elements as f64);
        let growth = time.as_secs_f64() / ideal;
        println!(
            "{elements:>6} elements, {} islands: {:>8.1} ms, {edges} edges; over n log n {:.2} times the first one",
            closed.len() - 1,
            time.as_secs_f64() * 1e3,
            growth / *first.get_or_insert(growth)
        );
    }
}

fn main() {
    let chosen: Vec<String> = env::args().skip(1).filter(|arg| !arg.starts_with('-')).collect();
    let wants = |part: &str| chosen.is_empty() || chosen.iter().any(|name| name == part);
    // First, as memory that was used once does not come back.
    if wants("memory") {
        streaming();
    }
    if wants("stock") {
        removal();
    }
    if wants("strategy") {
        drawing();
    }
    if wants("contour") {
        clearing();
    }
    if wants("turning") {
        turning();
    }
    if wants("process") {
        processes();
    }
    if wants("kinematics") {
        kinematics();
    }
    if wants("surface") {
        surface();
    }
    if !wants("blocks") {
        return;
    }
    let files = data::embedded();
    let (catalogue, _) = Catalogue::load(&files);
    let Some(on) = catalogue.on("tnc640") else { return };
    let Ok(scene) = Scene::parse(&Source::new("bench.scene.yaml", SCENE), &files) else { return };
    for work in works(CALLS) {
        let (own, events) = execute(&work, on, &scene);
        let rate = |time: Duration| work.count as f64 / time.as_secs_f64();
        println!("{:26} ciklo {:>10.0}/s ({events} events in {:.1} ms)", work.name, rate(own), own.as_secs_f64() * 1e3);
        if let Some(time) = work.rs274.as_deref().and_then(peer) {
            println!("{:26} rs274 {:>10.0}/s (whole process, text output)", "", rate(time));
            println!("{:26} ratio {:>10.1}", "", rate(own) / rate(time));
        }
    }
}
