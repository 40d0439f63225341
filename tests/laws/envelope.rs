//! The worst case of probing cycles: rehearsals leave no trace, and no cycle does worse than its envelope says.
use std::fs;
use std::path::{Path, PathBuf};

use ciklo::base::data::{self, Files};
use ciklo::base::diag::Source;
use ciklo::engine::run::{Engine, Event, EventKind, Obstacle, Outcome, Touching};
use ciklo::engine::scene::Scene;
use ciklo::language::locale::Locales;
use ciklo::program::syntax::parse;
use ciklo::spec::Catalogue;
use ciklo::tools::conform::LogTexts;

struct Data {
    files: Files,
    catalogue: &'static Catalogue,
    locales: &'static Locales,
}

impl Data {
    fn new() -> Self {
        let files = data::embedded();
        let catalogue = &crate::built::built().catalogue;
        let locales = &*crate::built::built().locales;
        Self { files, catalogue, locales }
    }

    fn run(&self, program: &str, scene: &str, envelope: bool) -> (Outcome, Vec<Event>) {
        let scene = Scene::parse(&Source::new("scene", scene), &self.files).expect("a sound scene");
        let on = self.catalogue.on("tnc640").expect("the control");
        let texts = LogTexts::new(self.locales.source().expect("English"), on.id(), &self.files);
        let program = parse(&Source::new("PROGRAM.H", program));
        let engine = Engine::new(&program, on, &scene, &texts).with_catalogue(self.catalogue);
        let engine = if envelope { engine.with_envelope() } else { engine };
        let mut events = Vec::new();
        let outcome = engine.run(&mut |event| events.push(event));
        (outcome, events)
    }
}

fn examples() -> Vec<(String, String, String)> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut paths: Vec<PathBuf> = fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.to_string_lossy().ends_with(".scene.yaml"));
    paths.sort();
    let read = |path: &Path| fs::read_to_string(path).unwrap();
    let of = |path: &PathBuf| {
        let program = PathBuf::from(path.to_string_lossy().replace(".scene.yaml", ".h"));
        // Programs that are called are left out.
        let text: String = read(&program)
            .lines()
            .filter(|line| !line.contains("CALL PGM"))
            .fold(String::new(), |text, line| text + line + "\n");
        (path.display().to_string(), text, read(path))
    };
    paths.iter().map(of).collect()
}

#[test]
fn rehearsals_leave_no_trace() {
    let data = Data::new();
    let mut cycles = 0;
    for (name, program, scene) in examples() {
        let (plain, told) = data.run(&program, &scene, false);
        let (outcome, events) = data.run(&program, &scene, true);
        let lines = |events: &[Event]| events.iter().map(Event::to_line).collect::<String>();
        assert_eq!(lines(&told), lines(&events), "{name}");
        assert_eq!((plain.status, plain.tables, plain.logs), (outcome.status, outcome.tables, outcome.logs), "{name}");
        assert_eq!(plain.shown.sentences, outcome.shown.sentences, "{name}");
        assert!(plain.envelopes.is_empty());
        cycles += outcome.envelopes.len();
    }
    assert!(cycles >= 6, "{cycles}");
}

#[test]
fn no_cycle_does_worse_than_its_envelope() {
    let data = Data::new();
    for (name, program, scene) in examples() {
        let (outcome, events) = data.run(&program, &scene, true);
        for envelope in &outcome.envelopes {
            let (lowest, highest) = (envelope.lowest.unwrap(), envelope.highest.unwrap());
            let longest = envelope.longest_probing.unwrap();
            for event in events.iter().filter(|event| event.at.line == envelope.line && event.at.cycle.is_some()) {
                match &event.kind {
                    EventKind::Transform(_) => break,
                    EventKind::Move { from, to, .. } => {
                        for height in [from.z, to.z] {
                            assert!((lowest - 1e-6..=highest + 1e-6).contains(&height), "{name}: {height}");
                        }
                    }
                    EventKind::Probe(probing) => {
                        assert!((probing.target - probing.from).length() <= longest + 1e-6, "{name}");
                    }
                    _ => {}
                }
            }
            // These cycles end well, so nothing but what they probe is touched.
            assert!(envelope.ends.iter().all(|end| end.touching != Touching::AsScene || end.error.is_none()));
            for near in envelope.near.iter().filter(|near| near.to != Obstacle::Stock) {
                assert!(near.distance.is_some_and(|distance| distance > 0.0), "{name}: {near:?}");
            }
        }
    }
}

const HOLE: &str = "BEGIN PGM A MM
TOOL CALL 1 Z
TCH PROBE 421
Q273=+0
Q274=+0
Q262=20
Q325=+0
Q247=+90
Q261=-5
Q320=+0
Q260=+CLEAR
Q301=+1
Q275=20.1
Q276=19.9
Q279=0
Q280=0
Q281=0
Q309=0
Q330=0
Q423=4
Q365=1
END PGM A MM
";

/// Ball of 2 mm, set-up clearance 3: it stands at 10 - 3 - 2 = 5 from the centre, 3 from the wall of the nominal hole.
const SCENE: &str = "scene: 1
tools: [{T: 1, NAME: PROBE, L: 100, R: 2, TP_NO: 1}]
probe: {NO: 1, F: 300, FMAX: 2000, DIST: 8, SET_UP: 3, ball_radius: 2}
start: [0, 0, 60]
stock: {box: {min: [-50, -50, -20], max: [50, 50, -19]}}
parts:
  - solid:
      difference:
        - box: {min: [-50, -50, -20], max: [50, 50, 0]}
        - cylinder: {diameter: 20, from: 1, to: -21}
  - solid: {box: {min: [12, -2, 0], max: [30, 2, 14]}}
  - solid: {box: {min: [2, -2, 20], max: [12, 2, 25]}}
";

#[test]
fn distances_are_those_of_the_geometry() {
    let data = Data::new();
    let (outcome, _) = data.run(&HOLE.replace("CLEAR", "16"), SCENE, true);
    assert_eq!(outcome.envelopes.len(), 1);
    let envelope = &outcome.envelopes[0];
    let is = |found: Option<f64>, wanted: f64| {
        assert!(found.is_some_and(|found| (found - wanted).abs() < 2e-6), "{found:?} {wanted}")
    };
    // The tip measures at -5 - 2.
    is(envelope.lowest, -7.0);
    is(envelope.highest, 60.0);
    is(envelope.longest_probing, 8.0);
    assert_eq!(envelope.probings, 4);
    assert_eq!(envelope.travelled, [60.0, 16.0]);
    let near = |to| envelope.near.iter().find(|near| near.to == to).unwrap();
    // The stock is a plate 12 below the tip.
    is(near(Obstacle::Stock).distance, 12.0);
    is(near(Obstacle::Part(1)).distance, 3.0);
    assert!(near(Obstacle::Part(1)).probed && !near(Obstacle::Stock).probed);
    // The clamp begins 7 from where the probe goes up and down: 5 from the ball.
    is(near(Obstacle::Part(2)).distance, 5.0);
    assert!(!near(Obstacle::Part(2)).probed);
    // A bar stands where the probe goes down: a collision.
    is(near(Obstacle::Part(3)).distance, 0.0);
    let scene = envelope.ends.iter().find(|end| end.touching == Touching::AsScene).unwrap();
    assert_eq!(scene.error.as_deref(), Some("collision"));
    assert!(outcome.fault.is_none(), "the program goes on: {:?}", outcome.fault);
}

#[test]
fn a_cycle_that_refuses_to_begin_does_not_move() {
    let data = Data::new();
    let program = HOLE.replace("CLEAR", "16").replace("TOOL CALL 1 Z\n", "");
    let (outcome, _) = data.run(&program, SCENE, true);
    let envelope = &outcome.envelopes[0];
    assert_eq!((envelope.lowest, envelope.probings), (None, 0));
    assert!(envelope.ends.iter().all(|end| end.error.as_deref() == Some("probe-axis-undefined")));
    assert!(envelope.near.iter().all(|near| near.distance.is_none()));
    assert!(outcome.fault.is_some());
}
