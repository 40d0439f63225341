//! Laws of probing at a tilt: cycle 444 in a tilted plane and with TCPM, on tables, heads and both; and of movements in which
//! several axes move at once: the tip that is held, and the contact on the way.
//!
//! Where workpiece and tool are follows from the files of the machines by plain trigonometry, written here once more.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::fmt::Write as _;
use std::sync::OnceLock;

use ciklo::base::diag::Source;
use ciklo::base::expr::QRef;
use ciklo::engine::run::{Content, Engine, EventKind, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::language::locale::Locales;
use ciklo::program::syntax;
use ciklo::spec::Catalogue;
use ciklo::tools::conform::LogTexts;
use glam::{DMat3, DVec3};
use proptest::prelude::*;

fn data() -> &'static (ciklo::base::data::Files, &'static Catalogue, &'static Locales) {
    static DATA: OnceLock<(ciklo::base::data::Files, &'static Catalogue, &'static Locales)> = OnceLock::new();
    DATA.get_or_init(|| {
        let files = ciklo::base::data::embedded();
        let catalogue = &crate::built::built().catalogue;
        let locales = &*crate::built::built().locales;
        (files, catalogue, locales)
    })
}

/// The tool is so long, and the ball so large.
const LENGTH: f64 = 100.0;
const BALL: f64 = 2.0;

/// Linear axes that reach far enough.
const AXES: &str = "axes: [{axis: X, min: -2000, max: 2000, rapid: 20000}, {axis: Y, min: -2000, max: 2000, rapid: 20000}, {axis: Z, min: -2000, max: 2000, rapid: 20000}]";

/// A machine: its text, the axes of its table and its head from outside (letter, sign of the turn, centre), its pivot.
struct Kinematics {
    text: String,
    table: Vec<(char, f64, DVec3)>,
    head: Vec<(char, f64)>,
    pivot: f64,
}

fn machine(kind: usize) -> Kinematics {
    match kind {
        0 => Kinematics {
            text: "mill-table-ac".to_owned(),
            table: vec![('A', -1.0, DVec3::ZERO), ('C', -1.0, DVec3::ZERO)],
            head: Vec::new(),
            pivot: 0.0,
        },
        1 => Kinematics {
            text: "mill-head-ac".to_owned(),
            table: Vec::new(),
            head: vec![('C', 1.0), ('A', 1.0)],
            pivot: 150.0,
        },
        2 => Kinematics {
            text: format!(
                "{{{AXES}, rotary: [{{axis: B, carries: workpiece, centre: [10, -5, -40], rapid: 3000}}, {{axis: C, carries: workpiece, centre: [-6, 8, 0], rapid: 3000}}]}}"
            ),
            table: vec![('B', -1.0, DVec3::new(10.0, -5.0, -40.0)), ('C', -1.0, DVec3::new(-6.0, 8.0, 0.0))],
            head: Vec::new(),
            pivot: 0.0,
        },
        _ => Kinematics {
            text: format!(
                "{{{AXES}, pivot: 90, rotary: [{{axis: B, carries: tool, rapid: 3000}}, {{axis: C, carries: workpiece, centre: [20, 30, 0], rapid: 3000}}]}}"
            ),
            table: vec![('C', -1.0, DVec3::new(20.0, 30.0, 0.0))],
            head: vec![('B', 1.0)],
            pivot: 90.0,
        },
    }
}

fn turn(letter: char, degrees: f64) -> DMat3 {
    let (s, c) = degrees.to_radians().sin_cos();
    let (x, y, z) = match letter {
        'A' => (DVec3::X, DVec3::new(0.0, c, s), DVec3::new(0.0, -s, c)),
        'B' => (DVec3::new(c, 0.0, -s), DVec3::Y, DVec3::new(s, 0.0, c)),
        _ => (DVec3::new(c, s, 0.0), DVec3::new(-s, c, 0.0), DVec3::Z),
    };
    DMat3::from_cols(x, y, z)
}

fn spatial(angles: [f64; 3]) -> DMat3 {
    turn('C', angles[2]) * turn('B', angles[1]) * turn('A', angles[0])
}

impl Kinematics {
    fn letters(&self) -> Vec<char> {
        self.table.iter().map(|axis| axis.0).chain(self.head.iter().map(|axis| axis.0)).collect()
    }

    /// Where a point of the machine is on the workpiece, as the workpiece lies while all axes stand at 0.
    fn on_workpiece(&self, point: DVec3, angles: &dyn Fn(char) -> f64) -> DVec3 {
        self.table.iter().fold(point, |seen, (letter, sign, centre)| {
            turn(*letter, -sign * angles(*letter)) * (seen - centre) + centre
        })
    }

    fn vector_on_workpiece(&self, vector: DVec3, angles: &dyn Fn(char) -> f64) -> DVec3 {
        self.table.iter().fold(vector, |seen, (letter, sign, _)| turn(*letter, -sign * angles(*letter)) * seen)
    }

    /// The direction along the tool.
    fn tool(&self, angles: &dyn Fn(char) -> f64) -> DVec3 {
        self.head.iter().rev().fold(DVec3::Z, |tool, (letter, sign)| turn(*letter, sign * angles(*letter)) * tool)
    }
}

fn scene(machine: &Kinematics, preset: (DVec3, f64), offset: (f64, f64), start: DVec3, parts: &str) -> String {
    let ((origin, turned), DVec3 { x, y, z }) = (preset, start);
    format!(
        "scene: 1\nmachine: {}\nmachine_parameters: {{chkTiltingAxes: 1}}\ntools: [{{T: 1, L: {LENGTH}, R: 1.97, TP_NO: 1}}]\n\
         probe: {{NO: 1, ball_radius: {BALL}, pre_travel: 0.03, length: {}, DIST: 40, SET_UP: 3, CAL_OF1: {}, CAL_OF2: {}}}\n\
         presets: {{active: 1, rows: [{{NO: 1, X: {}, Y: {}, Z: {}, SPC: {turned}}}]}}\nstart: [{x}, {y}, {z}]\nparts:\n  - solid: {parts}\n",
        machine.text,
        LENGTH + 0.03,
        offset.0,
        offset.1,
        origin.x,
        origin.y,
        origin.z
    )
}

fn run(program: &str, scene: &str) -> (Outcome, Vec<EventKind>) {
    let (files, catalogue, locales) = data();
    let parsed = Scene::parse(&Source::new("scene.yaml", scene), files);
    let scene = parsed.unwrap_or_else(|found| panic!("{found:?}\n{scene}"));
    let tree = syntax::parse(&Source::new("LAW.H", format!("BEGIN PGM LAW MM\nTOOL CALL 1 Z\n{program}")));
    let mut events = Vec::new();
    let texts = LogTexts::new(locales.language("en").expect("English"), "tnc640", files);
    let engine = Engine::new(&tree, catalogue.on("tnc640").expect("a control"), &scene, &texts);
    let outcome = engine.with_catalogue(catalogue).run(&mut |event| events.push(event.kind));
    (outcome, events)
}

fn q(outcome: &Outcome, number: u16) -> f64 {
    match outcome.params.get(QRef::q(number)) {
        Some(Content::Number(number)) => number,
        other => panic!("Q{number} is {other:?}"),
    }
}

fn words(p: DVec3) -> String {
    format!("X{:+} Y{:+} Z{:+}", p.x, p.y, p.z)
}

fn probing(p: DVec3, n: DVec3) -> String {
    format!(
        "TCH PROBE 444\nQ263={}\nQ264={}\nQ294={}\nQ581={}\nQ582={}\nQ583={}\nQ320=1\nQ260=120\nQS400=\"0\"\nQ309=0\n",
        p.x, p.y, p.z, n.x, n.y, n.z
    )
}

/// A direction that leans by at most 25° from the tool axis of its system.
fn leaning() -> impl Strategy<Value = DVec3> {
    (0.0..25.0_f64, -180.0..180.0_f64).prop_map(|(lean, about)| turn('C', about) * turn('B', lean) * DVec3::Z)
}

fn small() -> impl Strategy<Value = DVec3> {
    (-20.0..20.0_f64, -20.0..20.0_f64, -20.0..20.0_f64).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

/// A face at a point, or a ball around which the surface is round.
fn face(round: bool, point: DVec3, normal: DVec3) -> String {
    if round {
        let centre = point - normal * 30.0;
        return format!("{{sphere: {{centre: [{}, {}, {}], radius: 30}}}}", centre.x, centre.y, centre.z);
    }
    format!(
        "{{half_space: {{point: [{}, {}, {}], normal: [{}, {}, {}]}}}}",
        point.x, point.y, point.z, normal.x, normal.y, normal.z
    )
}

laws! {
    #![proptest_config(crate::cases::config(50))]

    /// In a tilted plane and with TCPM, however the rotary axes got there and stand: the point that 444 reports is the one of
    /// the surface, within 1e-6.
    #[test]
    fn a_point_probed_at_a_tilt_is_where_the_surface_is(
        kind in 0..4usize, way in 0..5usize, tilt in (-17.0..17.0_f64, -17.0..17.0_f64, -180.0..180.0_f64),
        axes in (-25.0..25.0_f64, -25.0..25.0_f64, -170.0..170.0_f64), preset in (small(), -90.0..90.0_f64), nominal in small(), normal in leaning(),
        off in -0.8..0.8_f64, offset in (-0.3..0.3_f64, -0.3..0.3_f64), round in any::<bool>(),
    ) {
        let machine = machine(kind);
        let tilt = [tilt.0, tilt.1, tilt.2];
        let angle = |letter: char| match letter { 'A' => axes.0, 'B' => axes.1, _ => axes.2 };
        // Beside its normal a ball touches a round surface elsewhere.
        let offset = if round { (0.0, 0.0) } else { offset };
        let plane = format!("PLANE SPATIAL SPA{:+} SPB{:+} SPC{:+}", tilt[0], tilt[1], tilt[2]);
        let stands: String = machine.letters().iter().fold("L".to_owned(), |mut text, letter| {
            let _ = write!(text, " {letter}{:+}", angle(*letter));
            text
        });
        let (program, tilted) = match way {
            0 => (format!("{plane} MOVE DIST20 FMAX\n"), true),
            1 => (format!("{plane} TURN FMAX\n"), true),
            // The plane is tilted, and the axes stand otherwise.
            2 => (format!("{plane} STAY\n{stands} R0 FMAX M128\n"), true),
            3 => (format!("M128\n{stands} R0 F2000\n"), false),
            _ => (format!("{stands} R0 FMAX\nFUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n"), false),
        };
        // Parts are given in the system of the preset.
        let of_plane = if tilted { spatial(tilt) } else { DMat3::IDENTITY };
        let surface = nominal + normal * off;
        let solid = face(round, of_plane * surface, of_plane * normal);
        let above = nominal + DVec3::Z * 150.0;
        let program = format!("{program}L {} R0 FMAX\n{}", words(above), probing(nominal, normal));
        let scene = scene(&machine, preset, offset, DVec3::new(0.0, 0.0, 420.0), &solid);
        let (outcome, events) = run(&program, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}{}", outcome.fault, program, scene);
        let found = DVec3::new(q(&outcome, 151), q(&outcome, 152), q(&outcome, 153));
        prop_assert!((found - surface).length() < 1e-6, "{found} is not {surface}\n{program}{scene}");
        prop_assert!((q(&outcome, 164) - off).abs() < 1e-6);
        let probed = events.iter().find_map(|event| match event {
            EventKind::Probe(probing) => probing.contact.map(|(point, _)| point),
            _ => None,
        });
        // A ball beside the normal touches the face beside it.
        prop_assert!((probed.expect("a contact") - surface).dot(normal).abs() < 1e-6);
    }

    /// A tip that is held goes straight on the workpiece and ends where the block says, whatever turns; seen from the linear
    /// axes it stands where the trigonometry of the machine says.
    #[test]
    fn a_held_tip_stays_on_the_workpiece(
        kind in 0..4usize, first in (-25.0..25.0_f64, -25.0..25.0_f64, -170.0..170.0_f64), second in (-25.0..25.0_f64, -25.0..25.0_f64, -170.0..170.0_f64),
        to in small(), goes in any::<bool>(),
    ) {
        let machine = machine(kind);
        let angle = |set: (f64, f64, f64), letter: char| match letter { 'A' => set.0, 'B' => set.1, _ => set.2 };
        let block = |set, words: &str| machine.letters().iter().fold(format!("L {words}"), |mut text, letter| {
            let _ = write!(text, " {letter}{:+}", angle(set, *letter));
            text
        });
        let point = if goes { words(to) } else { String::new() };
        let program = format!("L {} R0 FMAX M128\n{} R0 FMAX\n{} R0 F500\n", words(DVec3::new(5.0, 6.0, 7.0)), block(first, ""), block(second, &point));
        let (outcome, events) = run(&program, &scene(&machine, (DVec3::ZERO, 0.0), (0.0, 0.0), DVec3::new(0.0, 0.0, 100.0), "{sphere: {centre: [0, 0, -900], radius: 5}}"));
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, program);
        let wanted = if goes { to } else { DVec3::new(5.0, 6.0, 7.0) };
        prop_assert!((outcome.position - wanted).length() < 1e-9, "{}", outcome.position);
        let linear = events.iter().rev().find_map(|event| if let EventKind::Move { machine, .. } = event { Some(*machine) } else { None });
        let up = DVec3::Z * (LENGTH + machine.pivot);
        let angles = |letter| angle(second, letter);
        // The nose stands above the linear axes' point by the length; the head turns the tool about its pivot.
        let tip = linear.expect("a move") + up - machine.tool(&angles) * up.z;
        prop_assert!((machine.on_workpiece(tip, &angles) - wanted).length() < 1e-9);
        let turned = events.iter().filter(|event| matches!(event, EventKind::Turn { together: true, .. })).count();
        prop_assert_eq!(turned, 2);
    }

    /// While the tip is held, a block with a direction of the tool, or of the surface alone, turns the tool into it,
    /// wherever the axes were; the tip goes where the block says, and no axis turns farther than it must.
    #[test]
    fn a_tool_turns_into_the_direction_of_a_block(
        kind in 0..4usize, first in (-25.0..25.0_f64, -25.0..25.0_f64, -170.0..170.0_f64), preset in (small(), -90.0..90.0_f64),
        directions in proptest::collection::vec((leaning(), small(), any::<bool>(), 0.3..3.0_f64), 1..4),
    ) {
        let machine = machine(kind);
        let angle = |letter: char| match letter { 'A' => first.0, 'B' => first.1, _ => first.2 };
        let mut program = machine.letters().iter().fold("L X+0 Y+0 Z+50".to_owned(), |mut text, letter| {
            let _ = write!(text, " {letter}{:+}", angle(*letter));
            text
        });
        program.push_str(" R0 FMAX M128\n");
        for (direction, to, of_surface, long) in &directions {
            let letter = if *of_surface { 'N' } else { 'T' };
            let DVec3 { x, y, z } = *direction * *long;
            let _ = writeln!(program, "LN {} {letter}X{x:+} {letter}Y{y:+} {letter}Z{z:+} F500", words(*to));
        }
        let scene = scene(&machine, preset, (0.0, 0.0), DVec3::new(0.0, 0.0, 300.0), "{sphere: {centre: [0, 0, -900], radius: 5}}");
        let (outcome, events) = run(&program, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}{}", outcome.fault, program, scene);
        let (direction, to, ..) = *directions.last().expect("one at least");
        prop_assert!((outcome.position - to).length() < 1e-9, "{}", outcome.position);
        let turned: Vec<_> = events.iter().filter_map(|event| if let EventKind::Turn { axes, .. } = event { Some(axes) } else { None }).collect();
        let now = |letter: char| {
            let mut of = turned.iter().flat_map(|axes| axes.iter()).rev();
            of.find(|own| own.axis.letter() == letter).map_or(0.0, |own| own.machine)
        };
        let seen = machine.vector_on_workpiece(machine.tool(&now), &now);
        let wanted = turn('C', preset.1) * direction;
        prop_assert!((seen - wanted).length() < 1e-8, "{seen} is not {wanted}\n{program}{scene}");
        for own in turned.iter().skip(1).flat_map(|axes| axes.iter()) {
            // Half a turn about the tool brings it anywhere, from one leaning position to the other.
            prop_assert!((own.to - own.from).abs() < 180.0 + 1e-9, "{own:?}\n{program}{scene}");
        }
        let linear = events.iter().rev().find_map(|event| if let EventKind::Move { machine, .. } = event { Some(*machine) } else { None });
        let up = DVec3::Z * (LENGTH + machine.pivot);
        let tip = linear.expect("a move") + up - machine.tool(&now) * up.z;
        prop_assert!((machine.on_workpiece(tip, &now) - (preset.0 + turn('C', preset.1) * to)).length() < 1e-8);
    }

    /// With M144 the linear axes stay where they are while the rotary ones turn, positions count from where these have
    /// brought the tool on the workpiece, and a straight block after that leads there; M145 ends it.
    #[test]
    fn positions_count_from_rotary_axes(
        kind in 0..4usize, first in (-25.0..25.0_f64, -25.0..25.0_f64, -170.0..170.0_f64), preset in (small(), -90.0..90.0_f64), from in small(), to in small(),
    ) {
        let machine = machine(kind);
        let angle = |letter: char| match letter { 'A' => first.0, 'B' => first.1, _ => first.2 };
        let turns = machine.letters().iter().fold("L".to_owned(), |mut text, letter| {
            let _ = write!(text, " {letter}{:+}", angle(*letter));
            text
        });
        let scene = scene(&machine, preset, (0.0, 0.0), DVec3::new(0.0, 0.0, 300.0), "{sphere: {centre: [0, 0, -900], radius: 5}}");
        let upright = preset.0 + turn('C', preset.1) * from;
        let up = DVec3::Z * (LENGTH + machine.pivot);
        let seen = |linear: DVec3| {
            let tip = machine.on_workpiece(linear + up - machine.tool(&angle) * up.z, &angle);
            turn('C', -preset.1) * (tip - preset.0)
        };
        let begin = format!("L {} R0 FMAX M144\n{turns} R0 FMAX\n", words(from));
        let (outcome, _) = run(&begin, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}{}", outcome.fault, begin, scene);
        prop_assert!((outcome.position - seen(upright)).length() < 1e-8, "{}", outcome.position);
        let program = format!("{begin}L {} R0 F500\n", words(to));
        let (outcome, events) = run(&program, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}{}", outcome.fault, program, scene);
        let linear = events.iter().rev().find_map(|event| if let EventKind::Move { machine, .. } = event { Some(*machine) } else { None });
        prop_assert!((seen(linear.expect("a move")) - to).length() < 1e-8);
        // Without it they count from where the linear axes are.
        let (outcome, _) = run(&format!("{begin}M145\n"), &scene);
        prop_assert!((outcome.position - from).length() < 1e-8, "{}", outcome.position);
    }

    /// Contact while several axes move: whoever samples the way finds the same.
    #[test]
    fn contact_on_the_way_is_found(
        kind in 0..4usize, held in any::<bool>(), from in (-30.0..30.0_f64, -30.0..30.0_f64, 12.0..40.0_f64), to in (-30.0..30.0_f64, -30.0..30.0_f64, 12.0..40.0_f64),
        first in (-20.0..20.0_f64, -20.0..20.0_f64, -60.0..60.0_f64), second in (-20.0..20.0_f64, -20.0..20.0_f64, -60.0..60.0_f64), half in (5.0..12.0_f64, 5.0..12.0_f64, 2.0..9.0_f64),
    ) {
        let machine = machine(kind);
        let (from, to, half) = (DVec3::from(from), DVec3::from(to), DVec3::from(half));
        let at = |set: (f64, f64, f64), letter: char| match letter { 'A' => set.0, 'B' => set.1, _ => set.2 };
        let axes = |set| machine.letters().iter().fold(String::new(), |mut text, letter| {
            let _ = write!(text, " {letter}{:+}", at(set, *letter));
            text
        });
        let function = if held { " M128" } else { "" };
        // Another tool of the same length, that is no probe, gets to the start.
        let program = format!("TOOL CALL 2 Z\nL {}{} R0 FMAX{function}\nTOOL CALL 1 Z\nL {}{} R0 FMAX\n", words(from), axes(first), words(to), axes(second));
        let solid = format!("{{box: {{min: [{}, {}, {}], max: [{}, {}, {}]}}}}", -half.x, -half.y, -half.z, half.x, half.y, half.z);
        let text = scene(&machine, (DVec3::ZERO, 0.0), (0.0, 0.0), DVec3::new(0.0, 0.0, 100.0), &solid)
            .replace("tools: [", &format!("tools: [{{T: 2, L: {LENGTH}, R: 1}}, "));
        let (outcome, _) = run(&program, &text);
        let up = DVec3::Z * (LENGTH + machine.pivot);
        // The tool table has the length to where the probe triggers.
        let lift = BALL - 0.03;
        let ball = |share: f64| {
            let set = (first.0 + (second.0 - first.0) * share, first.1 + (second.1 - first.1) * share, first.2 + (second.2 - first.2) * share);
            let angles = |letter| at(set, letter);
            let (line, tool) = (from + (to - from) * share, machine.tool(&angles));
            if held {
                // The tip goes straight on the workpiece.
                return line + machine.vector_on_workpiece(tool * lift, &angles);
            }
            machine.on_workpiece(line + up - tool * (up.z - lift), &angles)
        };
        let gap = |p: DVec3| (p.abs() - half).max(DVec3::ZERO).length();
        let least = (0..=3000).map(|step| gap(ball(f64::from(step) / 3000.0))).fold(f64::INFINITY, f64::min);
        let code = outcome.fault.as_ref().map_or("", |fault| &fault.code);
        if least < BALL - 1e-6 {
            prop_assert_eq!(code, "collision", "{} {:?}\n{}{}", least, outcome.fault, program, text);
        } else if code == "collision" {
            prop_assert!(least < BALL + 1e-3, "{least}\n{program}{text}");
        } else {
            prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, program);
        }
    }
}

/// The shaft is looked at on such a way, too.
#[test]
fn a_shaft_that_leans_onto_the_part_is_a_collision() {
    let with_shaft = |turned: f64| {
        let machine = machine(1);
        let text = scene(
            &machine,
            (DVec3::ZERO, 0.0),
            (0.0, 0.0),
            DVec3::new(0.0, -8.0, 20.0),
            "{box: {min: [-50, 0, -50], max: [50, 50, 40]}}",
        )
        .replace("pre_travel: 0.03", "pre_travel: 0.03, shaft: {diameter: 2, length: 50}");
        let (outcome, _) = run(&format!("M128\nL A{turned:+} C+1 R0 F500\n"), &text);
        outcome.fault.map(|fault| fault.code.to_string())
    };
    // Turned by +A the tool leans to -Y, away from the wall; turned by -A onto it: at 20° the shaft reaches it at once.
    assert_eq!(with_shaft(30.0), None);
    assert_eq!(with_shaft(-30.0).as_deref(), Some("shaft-collision"));
}

/// A held tip whose linear axes would leave their range on the way is told, though both ends are within it.
#[test]
fn limits_are_kept_between_the_ends() {
    let machine = machine(0);
    let text = scene(
        &machine,
        (DVec3::ZERO, 0.0),
        (0.0, 0.0),
        DVec3::new(999.0, 0.0, 0.0),
        "{sphere: {centre: [0, 0, -900], radius: 5}}",
    );
    // Half a turn of the table: the tip at X+999 goes round by Y±999, and beyond X+999 in between when it starts at Y.
    let fault = |block: &str| run(&format!("M128\n{block}\n"), &text).0.fault.map(|fault| fault.code.to_string());
    assert_eq!(fault("L C+30 R0 FMAX"), None);
    let corner = text.replace("start: [999, 0, 0]", "start: [800, 700, 0]");
    let (outcome, _) = run("M128\nL C+82.37 R0 FMAX\n", &corner);
    // By C+82.37 the point (800, 700) comes to (800, -700): on a circle of radius 1063 through (1063, 0).
    assert_eq!(outcome.fault.map(|fault| fault.code.to_string()).as_deref(), Some("axis-limit"));
}

/// The probing cycles that take the probe for upright are refused while it leans over, and only then.
#[test]
fn other_cycles_need_an_upright_probe() {
    let machine = machine(0);
    let text = scene(
        &machine,
        (DVec3::ZERO, 0.0),
        (0.0, 0.0),
        DVec3::new(0.0, 0.0, 60.0),
        "{box: {min: [-40, -40, -20], max: [40, 40, 0.25]}}",
    );
    let measure = "TCH PROBE 427\nQ263=3\nQ264=4\nQ261=0\nQ320=0\nQ272=3\nQ267=-1\nQ260=40\nQ281=0\nQ288=0\nQ289=0\nQ309=0\nQ330=0\n";
    let (upright, _) = run(&format!("M128\nL C+40 R0 FMAX\n{measure}"), &text);
    assert_eq!(upright.status, Status::Done, "{:?}", upright.fault);
    assert!((q(&upright, 160) - 0.25).abs() < 1e-9);
    let (leaning, _) = run(&format!("M128\nL A+5 R0 FMAX\n{measure}"), &text);
    assert_eq!(leaning.fault.map(|fault| fault.code.to_string()).as_deref(), Some("unsupported-tcpm"));
    let (again, _) = run(&format!("M128\nL A+5 R0 FMAX\nL A+0 R0 FMAX\nM129\n{measure}"), &text);
    assert_eq!(again.status, Status::Done, "{:?}", again.fault);
}

/// What `FUNCTION TCPM` may ask for beyond that is refused by its word.
#[test]
fn words_of_tcpm_are_not_ignored() {
    let machine = machine(0);
    let text = scene(
        &machine,
        (DVec3::ZERO, 0.0),
        (0.0, 0.0),
        DVec3::new(0.0, 0.0, 60.0),
        "{sphere: {centre: [0, 0, -900], radius: 5}}",
    );
    for (block, refused) in [
        ("FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT TIP-TIP F500", false),
        ("FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS", true),
        ("FUNCTION TCPM F CONT AXIS POS PATHCTRL AXIS", true),
        ("FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR", true),
        ("FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT TIP-CENTER", true),
        ("FUNCTION RESET TCPM", false),
    ] {
        let (outcome, _) = run(&format!("{block}\n"), &text);
        assert_eq!(outcome.fault.is_some(), refused, "{block}: {:?}", outcome.fault);
    }
}
