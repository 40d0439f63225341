//! Prints how many blocks, cycle calls and probing cycles the engine executes in a second:
//! `cargo bench --bench engine`. Where LinuxCNC's `rs274` is installed (Debian package
//! `linuxcnc-uspace`), the same work as RS274 text runs beside it. Nothing is judged here.
use std::hint::black_box;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs};

use ciklo::data;
use ciklo::diag::Source;
use ciklo::engine::run::{Engine, NoTexts};
use ciklo::engine::scene::Scene;
use ciklo::spec::{Catalogue, OnControl};
use ciklo::syntax::parse;

const ROUNDS: u32 = 3;
const BLOCKS: usize = 200_000;
const CALLS: usize = 20_000;
const PROBINGS: usize = 1_000;

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

fn works() -> Vec<Work> {
    let at = |n: usize| (n % 97, n % 31);
    let lines: String = (0..BLOCKS).map(at).map(|(x, y)| format!("L X+{x}.125 Y-{y}.5 R0 F500\n")).collect();
    let lines_rs: String = (0..BLOCKS).map(at).map(|(x, y)| format!("G1 X{x}.125 Y-{y}.5\n")).collect();
    let calls: String = (0..CALLS).map(at).map(|(x, y)| format!("L X+{x} Y+{y} R0 FMAX M99\n")).collect();
    let calls_rs: String = (0..CALLS).map(at).map(|(x, y)| format!("G83 X{x} Y{y} Z-20 R2 Q5\n")).collect();
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
            count: CALLS,
            klartext: frame(1, &format!("{PECKING}{calls}")),
            rs274: Some(format!("{head}G99\n{calls_rs}G80\nM2\n")),
        },
        Work {
            name: "four-point probing cycles",
            count: PROBINGS,
            klartext: frame(2, &PROBING.repeat(PROBINGS)),
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
        let outcome = Engine::new(&program, on, scene, &NoTexts).run(&mut |event| {
            black_box(&event);
            events += 1;
        });
        if let Some(diagnostic) = outcome.diagnostic {
            println!("{}: ended with {} {:?}", work.name, diagnostic.code, diagnostic.args);
        }
    });
    (time, events)
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

fn main() {
    let files = data::embedded();
    let (catalogue, _) = Catalogue::load(&files);
    let Some(on) = catalogue.on("tnc640") else { return };
    let Ok(scene) = Scene::parse(&Source::new("bench.scene.yaml", SCENE), &files) else { return };
    for work in works() {
        let (time, events) = execute(&work, on, &scene);
        let rate = |time: Duration| work.count as f64 / time.as_secs_f64();
        println!(
            "{:26} ciklo {:>10.0}/s ({events} events in {:.1} ms)",
            work.name,
            rate(time),
            time.as_secs_f64() * 1e3
        );
        if let Some(time) = work.rs274.as_deref().and_then(peer) {
            println!("{:26} rs274 {:>10.0}/s (whole process, text output)", "", rate(time));
        }
    }
}
