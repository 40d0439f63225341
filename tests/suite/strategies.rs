//! Strategies: the registry beside the specifications and their documentation, and single strategies called alone.
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;
use std::{env, fs};

use ciklo::base::diag::Source;
use ciklo::base::expr::Type;
use ciklo::engine::geometry::{Around, Axis, Frame, RotaryAxis, WorkingPlane};
use ciklo::engine::machine::{Arm, Machine, MemoryReport, SavedKinematics, Survey, matches_pattern};
use ciklo::engine::region::contours::Contour;
use ciklo::engine::region::{Edge, Way};
use ciklo::engine::run::Fault;
use ciklo::engine::strategy::action::{
    Calibrated, Coordinate, Course, Felt, Function, Kept, Kinematics, KnownSetter, Probe, Probing, Programs, Rotary,
    RotaryAxes, Running, Spindle, Stopped, Stylus, System, Tables, ToolSetter, Turntable,
};
use ciklo::engine::strategy::alignment::{basic_rotation, datum, rotary};
use ciklo::engine::strategy::contour::{self, Contours};
use ciklo::engine::strategy::contour::{contour_train, cylinder, cylinder_wall};
use ciklo::engine::strategy::digitizing::range::Digitizing;
use ciklo::engine::strategy::kinematics::memory;
use ciklo::engine::strategy::probing::{self, measure};
use ciklo::engine::strategy::shape::{face, font, pocket_and_slot, stud};
use ciklo::engine::strategy::{
    Action, Calculation, Cutter, Done, Leg, Milling, Mm, OverContours, STRATEGIES, Strategy,
};
use ciklo::engine::strategy::{program, spindle};
use ciklo::engine::table::{Cell, TableKind};
use ciklo::spec::{Argument, Quantity, Verb};
use glam::{DVec2, DVec3};

/// The names of all strategies that specifications use.
fn used() -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let catalogue = &crate::built::built().catalogue;
    for on in catalogue.controls.values() {
        let fragments = on.fragments.values().flat_map(|fragment| {
            let cases = fragment.choose.iter().flat_map(|case| &case.actions);
            fragment.actions.iter().chain(cases).chain(&fragment.then).collect::<Vec<_>>()
        });
        let mut actions: Vec<_> = fragments.collect();
        let mut open: Vec<_> = on.cycles.values().flat_map(|cycle| &cycle.file.run).collect();
        while let Some(item) = open.pop() {
            actions.extend(&item.body.actions);
            actions.extend(item.choose.iter().flat_map(|case| &case.actions));
            actions.extend(&item.then);
            open.extend(item.body.items.iter().chain(&item.items).chain(&item.between));
        }
        for action in actions {
            if let (Verb::Strategy, Argument::One(name)) = (action.verb, &action.argument) {
                found.insert(name.as_str().to_owned());
            }
        }
    }
    found
}

#[test]
fn every_strategy_of_the_registry_is_used_and_none_twice() {
    let names: BTreeSet<&str> = STRATEGIES.iter().map(|strategy| strategy.name).collect();
    assert_eq!(names.len(), STRATEGIES.len(), "a name is taken twice");
    let used = used();
    let unused: Vec<_> = names.iter().filter(|name| !used.contains(**name)).collect();
    assert!(unused.is_empty(), "no specification uses {unused:?}");
}

/// A strategy as a row of the table in `docs/spec-format.md`.
fn row(strategy: &Strategy) -> String {
    let word = |quantity: Quantity| match quantity {
        Quantity::Number | Quantity::Text => String::new(),
        measured => format!(" {}", measured.as_str()),
    };
    let parameters = strategy.parameters.iter().map(|parameter| {
        let left_out = if parameter.required { "" } else { "?" };
        let kind = match parameter.ty {
            Type::Point => " point".to_owned(),
            Type::Text => " text".to_owned(),
            _ => word(parameter.quantity),
        };
        format!("`{}`{left_out}{kind}", parameter.name)
    });
    let outputs = strategy.outputs.iter().map(|output| format!("`{}`{}", output.name, word(output.quantity)));
    let list = |items: Vec<String>| items.join(", ");
    format!("| `{}` | {} | {} |", strategy.name, list(parameters.collect()), list(outputs.collect()))
}

/// `UPDATE=1 cargo test --test suite strategies` rewrites the table.
#[test]
fn the_documentation_lists_every_strategy_with_its_arguments() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/spec-format.md");
    let text = fs::read_to_string(&path).expect("the documentation");
    let head = "| strategy | arguments | results |\n|---|---|---|\n";
    let (before, rest) = text.split_once(head).expect("the table of strategies");
    let end = rest.find("\n\n").map_or(0, |at| at + 1);
    let after = if rest.starts_with('\n') { rest } else { &rest[end..] };
    let mut rows: Vec<String> = STRATEGIES.iter().map(row).collect();
    rows.sort();
    let wanted = format!("{before}{head}{}\n{after}", rows.join("\n"));
    if env::var_os("UPDATE").is_some() {
        fs::write(&path, &wanted).expect("the documentation is written");
    }
    assert!(
        text == wanted || env::var_os("UPDATE").is_some(),
        "the table in docs/spec-format.md is not that of the engine"
    );
    let explained = |strategy: &&Strategy| wanted.matches(&format!("`{}`", strategy.name)).count() > 1;
    let missing: Vec<_> =
        STRATEGIES.iter().filter(|strategy| !explained(strategy)).map(|strategy| strategy.name).collect();
    assert!(missing.is_empty(), "docs/spec-format.md does not say what they do: {missing:?}");
}

const TOOL: Cutter = Cutter { radius: 5.0 };

#[test]
fn a_pocket_that_is_too_narrow_is_no_path() {
    let pocket =
        pocket_and_slot::ClearCircleLevel { centre: DVec3::ZERO, climb: 1.0, diameter: 9.0, stepover: 3.0, at: 500.0 };
    let path = pocket.path(TOOL, DVec3::ZERO);
    assert!(path.legs.is_empty());
    assert_eq!(path.fault.map(|fault| fault.code.into_owned()).as_deref(), Some("shape-impossible"));
}

#[test]
fn the_legs_before_a_fault_are_there() {
    let floor = pocket_and_slot::FinishCircleFloor {
        centre: DVec3::ZERO,
        climb: 1.0,
        diameter: 40.0,
        stepover: 0.0,
        from: -9.0,
        level: -10.0,
        at: 500.0,
    };
    let path = floor.path(TOOL, DVec3::new(0.0, 0.0, -5.0));
    assert_eq!(path.fault.map(|fault| fault.code.into_owned()).as_deref(), Some("series-limit"));
    assert_eq!(path.legs.last().map(Leg::end), Some(DVec3::new(0.0, 0.0, -10.0)));
}

/// To and fro over a surface of 100 x 20 mm in three lines, from its lower left corner, at the height of the tool.
#[test]
fn lines_of_a_face_go_to_and_fro() {
    let face = face::MillFaceLevel {
        mode: 0.0,
        begin: -7.0,
        end: 107.0,
        inner_begin: -6.0,
        inner_end: 106.0,
        first: 0.0,
        step: 8.0,
        lines: 3.0,
        across: 2000.0,
        lift: 5.0,
        at: 500.0,
    };
    let path = face.path(TOOL, DVec3::new(-7.0, 0.0, -1.0));
    let ends: Vec<DVec2> = path.legs.iter().map(|leg| leg.end().truncate()).collect();
    let wanted = [(106.0, 0.0), (106.0, 8.0), (-6.0, 8.0), (-6.0, 16.0), (107.0, 16.0)];
    assert_eq!(ends, wanted.map(DVec2::from));
    assert!(path.legs.iter().all(|leg| leg.end().z == -1.0));
}

#[test]
fn half_a_turn_ends_on_the_other_side() {
    let turn = stud::HalfTurn { centre: DVec3::ZERO, direction: -1.0, radius: 20.0, at: 300.0 };
    let path = turn.path(TOOL, DVec3::new(0.0, 30.0, -4.0));
    let [Leg::Arc { centre, to, direction, .. }] = path.legs.as_slice() else { panic!("{path:?}") };
    assert!((*to - DVec3::new(0.0, -20.0, -4.0)).length() < 1e-12, "{to}");
    assert!((*centre - DVec3::new(0.0, 5.0, -4.0)).length() < 1e-12, "{centre}");
    assert_eq!(*direction, -1.0);
}

fn flat() -> WorkingPlane {
    WorkingPlane::of_tool_axis(Axis::Z)
}

#[test]
fn lines_meet_where_they_cross() {
    let at = |x, y| DVec3::new(x, y, -3.0);
    let lines = measure::IntersectLines {
        first: at(0.0, 5.0),
        second: at(10.0, 5.0),
        third: at(4.0, 0.0),
        fourth: at(4.0, 1.0),
    };
    let met = lines.calculate(flat()).expect("a point");
    assert!((met.main - 4.0).abs() < 1e-12 && (met.minor - 5.0).abs() < 1e-12, "{met:?}");
    let parallel = measure::IntersectLines { third: at(0.0, 7.0), fourth: at(9.0, 7.0), ..lines };
    assert_eq!(parallel.calculate(flat()).map_err(|fault| fault.code.into_owned()), Err("lines-parallel".to_owned()));
}

#[test]
fn a_text_of_a_tolerance_is_a_band() {
    let band = |text: &str| {
        let band = measure::ToleranceBand { text: Arc::from(text) }.calculate(flat()).expect("a band");
        (band.upper, band.lower, band.monitored)
    };
    // The rows of the manual (004, lines 151-162) and what the example of the NC block says.
    assert_eq!(band("0.4-0.1"), (0.4, -0.1, 1.0));
    assert_eq!(band("0.4"), (0.4, 0.0, 1.0));
    assert_eq!(band("-0.1"), (0.0, -0.1, 1.0));
    assert_eq!(band("1-1"), (1.0, -1.0, 1.0));
    for none in [" ", "", "0", "0.1+0.1", "x", "-", "--1", "1e3", "0.1-"] {
        assert_eq!(band(none), (0.0, 0.0, 0.0), "{none:?}");
    }
}

/// A control that writes down what is done to it. Its parts are there for the strategies that ask for them.
#[derive(Default)]
struct Notebook {
    origin: DVec3,
    basic: f64,
    zero: (f64, f64),
    angle: f64,
    running: Running,
    pressed: bool,
    cells: Vec<(TableKind, f64, String, f64)>,
    contours: Contours,
    digitizing: Digitizing,
    around: Around,
    memories: Vec<SavedKinematics>,
    done: Vec<String>,
}

impl Stylus for Notebook {
    fn stylus(&self) -> Result<(DVec3, f64), Fault> {
        Ok((DVec3::new(0.0, 0.0, 100.0), 300.0))
    }

    fn feel(&self, _: Course) -> Result<Option<Felt>, Fault> {
        Ok(None)
    }

    fn touches(&self, _: DVec3, _: f64) -> Result<bool, Fault> {
        Ok(false)
    }

    fn fly(&mut self, to: DVec3, feed: Option<f64>) -> Done {
        self.done.push(format!("fly to {to} at {feed:?}"));
        Ok(())
    }

    fn slide(&mut self, to: DVec3, out: DVec3, feed: f64) -> Done {
        self.done.push(format!("slide to {to} at {feed}, away {out}"));
        Ok(())
    }

    fn digitizing(&mut self) -> &mut Digitizing {
        &mut self.digitizing
    }

    fn coordinates(&self, _: &str) -> Vec<Coordinate> {
        [Axis::X, Axis::Y, Axis::Z].map(|axis| Coordinate { axis, rotary: false, value: 0.0 }).to_vec()
    }

    fn feel_turned(&self, _: (RotaryAxis, f64), _: DVec3, _: DVec3) -> Result<Option<Felt>, Fault> {
        Ok(None)
    }

    fn touches_while_turning(&self, _: (RotaryAxis, f64), _: DVec3) -> Result<bool, Fault> {
        Ok(false)
    }

    fn way_in_degree(&self, _: RotaryAxis, _: DVec3) -> Result<DVec3, Fault> {
        Ok(DVec3::ZERO)
    }

    fn fly_turning(&mut self, (axis, angle): (RotaryAxis, f64), to: DVec3, feed: Option<f64>) -> Done {
        self.done.push(format!("fly to {to} at {feed:?}, {} {angle}", axis.letter()));
        Ok(())
    }

    fn points_of_table(&self, _: &str) -> Result<Vec<DVec3>, Fault> {
        Ok(Vec::new())
    }

    fn write_data(&mut self) -> Done {
        self.done.push(format!("write {} rows", self.digitizing.rows.len()));
        Ok(())
    }
}

impl Kinematics for Notebook {
    fn kinematics(&self) -> Machine {
        let text = "machine: 1\nname: shop\naxes: [{axis: X, min: 0, max: 1, rapid: 1}]\n";
        Machine::parse(&Source::new("machine.yaml", text)).expect("a machine")
    }

    fn set_kinematics(&mut self, machine: Machine) {
        self.done.push(format!("kinematics of {}", machine.name));
    }

    fn memories(&self) -> Vec<SavedKinematics> {
        self.memories.clone()
    }

    fn set_memories(&mut self, memories: Vec<SavedKinematics>) {
        self.memories = memories;
    }

    fn name_given(&self, meaning: &str) -> Result<String, Fault> {
        Ok(meaning.to_owned())
    }

    fn forget_texts(&mut self, numbers: std::ops::RangeInclusive<u16>) {
        self.done.push(format!("texts {} to {} forgotten", numbers.start(), numbers.end()));
    }

    fn moment(&self) -> String {
        "01-01-2000 0:00:00".to_owned()
    }

    fn keep_memory_report(&mut self, report: MemoryReport) {
        self.done.push(format!("report on {}", report.name));
    }

    fn survey(&self) -> Result<Survey, Fault> {
        unreachable!("nothing is measured")
    }

    fn keep_survey(&mut self, _: Survey) {}

    fn limit(&self, _: &str) -> Option<f64> {
        None
    }

    fn angles(&self) -> DVec3 {
        DVec3::ZERO
    }

    fn angle_datum(&self) -> DVec3 {
        DVec3::ZERO
    }

    fn preset_in_effect(&self) -> (f64, DVec3) {
        (0.0, DVec3::ZERO)
    }

    fn linear(&self) -> DVec3 {
        DVec3::ZERO
    }

    fn arm(&self) -> Result<Arm, Fault> {
        Ok(Arm::default())
    }

    fn probing(&self) -> Result<Probing, Fault> {
        Ok(Probing { set_up: 2.0, feed: 1000.0, radius: 2.0 })
    }

    fn release_tip(&mut self) -> Done {
        Ok(())
    }

    fn go_turning(&mut self, turns: &[(RotaryAxis, f64)], to: DVec3, feed: f64) -> Done {
        self.done.push(format!("turn {turns:?} and go to {to} at {feed}"));
        Ok(())
    }

    fn touch(&mut self, way: DVec3) -> Done<DVec3> {
        self.done.push(format!("touch {way}"));
        Ok(DVec3::ZERO)
    }
}

/// Of 001:14070-14079.
#[test]
fn wildcards_stand_for_one_sign_or_a_chain() {
    let fits = [
        ("AB", "AB", true),
        ("AB", "ABC", false),
        ("A?", "A1", true),
        ("A?", "A", false),
        ("A$", "Ab", true),
        ("A$", "A1", false),
        ("A#", "A1", true),
        ("A#", "AB", false),
        ("*", "", true),
        ("*B*", "ABBA", true),
        ("A*C", "ABCBC", true),
        ("A*C", "ABCB", false),
        ("", "A", false),
    ];
    for (pattern, name, wanted) in fits {
        assert_eq!(matches_pattern(pattern, name), wanted, "{pattern} and {name}");
    }
}

#[test]
fn a_memory_is_overwritten_and_the_last_one_is_not_exceeded() {
    let mut control = Notebook::default();
    let save = memory::SaveKinematics { most: 1.0 };
    save.act(&mut control).expect("the first");
    save.act(&mut control).expect("the same again");
    assert_eq!(control.memories.len(), 1);
    control.memories[0].name = "other".to_owned();
    assert!(save.act(&mut control).is_err());
    memory::RestoreKinematics {}.act(&mut control).expect_err("another name");
}

impl ToolSetter for Notebook {
    fn setter_frame(&self) -> Result<Frame, Fault> {
        Ok(Frame::IDENTITY)
    }

    fn setter(&self) -> Result<KnownSetter, Fault> {
        Ok(KnownSetter { at: DVec3::new(300.0, 200.0, -50.0), radius: 20.0, is_round: true })
    }

    fn calibrate_setter(&mut self, known: KnownSetter) {
        self.done.push(format!("setter at {} of {}", known.at, known.radius));
    }

    fn setting(&self, name: &str) -> Result<f64, Fault> {
        Ok(name.len() as f64)
    }

    fn setting_word(&self, _: &str) -> Option<String> {
        None
    }

    fn tip(&self) -> Result<DVec3, Fault> {
        Ok(DVec3::new(0.0, 0.0, 100.0))
    }

    fn reckoned(&self) -> (f64, f64) {
        (5.0, 80.0)
    }

    fn go(&mut self, to: DVec3) -> Done {
        self.done.push(format!("go to {to}"));
        Ok(())
    }

    fn touch_setter(&mut self, way: DVec3, feed: f64, at: Option<f64>) -> Done<Option<DVec3>> {
        self.done.push(format!("touch {way} at {feed}, spindle {at:?}"));
        Ok(Some(DVec3::ZERO))
    }

    fn orient(&mut self, angle: f64) {
        self.done.push(format!("orient {angle}"));
    }

    fn cuts_counter_clockwise(&self) -> Result<bool, Fault> {
        Ok(false)
    }

    fn first_edge(&self) -> Result<f64, Fault> {
        Ok(0.0)
    }
}

impl Turntable for Notebook {
    fn around(&self) -> Result<Around, Fault> {
        Ok(self.around)
    }

    fn datum_off_table(&self) -> Result<f64, Fault> {
        Ok(0.0)
    }

    fn go_around(&mut self, to: Around, radius: f64, feed: f64) -> Done {
        if to != self.around {
            let Around { turn, across, along, height } = to;
            self.done.push(format!("{turn:.3}° {across:.3} {along:.3} {height:.3} on {radius} at {feed}"));
        }
        self.around = to;
        Ok(())
    }
}

impl Kept for Notebook {
    fn outline_of_blank(&self, _: &dyn Fn(&Way) -> Way) -> Option<Way> {
        None
    }

    fn updates_blank(&self) -> bool {
        false
    }

    fn kept(&self, name: &str) -> Option<f64> {
        Some(name.len() as f64)
    }

    fn read_contours(&mut self, _: f64) -> Done {
        self.contours = pocket();
        Ok(())
    }

    fn read_first_contour(&mut self) -> Done {
        self.contours = train();
        Ok(())
    }

    fn read_developed_contour(&mut self, mm_in_degree: Option<f64>) -> Done {
        self.contours = train();
        self.done.push(format!("read the development, {mm_in_degree:?} mm in a degree"));
        Ok(())
    }

    fn read_turned_contour(&mut self) -> Done<Way> {
        Ok(train().open[0].way.clone())
    }

    fn contours(&self) -> &Contours {
        &self.contours
    }

    fn note_left(&mut self, area: f64, at: DVec3) {
        self.done.push(format!("{area:.3} mm² left at {at:.3}"));
    }

    fn keep_thread(&mut self, thread: ciklo::engine::strategy::turning::thread::TurnedThread) {
        self.contours.thread = Some(thread);
    }

    fn hold_insert(&mut self, _: ciklo::engine::machine::Insert) {}

    fn keep_turned(&mut self, turned: ciklo::engine::strategy::turning::area::Turned) {
        self.contours.turned = Some(turned);
    }

    fn keep_groove(&mut self, groove: ciklo::engine::strategy::turning::groove::Groove) {
        self.contours.groove = Some(groove);
    }

    fn tool_radius(&self) -> f64 {
        5.0
    }
}

/// A pocket 40 by 20, clockwise with the tool on its right, seen from where a tool is at (20, 40).
fn pocket() -> Contours {
    let corners = [(0.0, 20.0), (40.0, 20.0), (40.0, 0.0), (0.0, 0.0)];
    let edges = corners.map(|(x, y)| Edge::Line(DVec2::new(x, y))).to_vec();
    let contour = Contour { way: Way { start: DVec2::ZERO, edges }, side: -1 };
    Contours::new(vec![contour.closed().expect("a pocket")], DVec2::new(20.0, 40.0), 10.0)
}

/// An open contour along X to 50, then along Y to 30, with the tool on its left.
fn train() -> Contours {
    let edges = [(50.0, 0.0), (50.0, 30.0)].map(|(x, y)| Edge::Line(DVec2::new(x, y))).to_vec();
    Contours { open: vec![Contour { way: Way { start: DVec2::ZERO, edges }, side: 1 }], ..Contours::default() }
}

#[test]
fn a_contour_is_followed_on_its_side_forwards_in_climb_and_backwards_in_up_cut() {
    let mut control = Notebook::default();
    let begin = contour_train::FindContourStart { allowance: 1.0, climb: -1.0 }.act(&mut control).expect("a start");
    assert_eq!((begin.main, begin.minor), (44.0, 30.0));
    let ends = |climb: f64, turn: f64, from: DVec3| -> Vec<(f64, f64)> {
        let follow = contour_train::FollowContour { level: -3.0, allowance: 1.0, climb, turn, at: 200.0 };
        let path = follow.path(&control.contours, TOOL, from);
        assert_eq!(path.fault, None);
        path.legs.iter().map(|leg| (leg.end().x, leg.end().y)).collect()
    };
    // Six millimetres beside it the corner is at (44, 6).
    let (first, last) = (DVec3::new(0.0, 6.0, -3.0), DVec3::new(44.0, 30.0, -3.0));
    assert_eq!(ends(1.0, 2.0, first), [(44.0, 6.0), (44.0, 30.0)]);
    assert_eq!(ends(-1.0, 1.0, last), [(44.0, 6.0), (0.0, 6.0)]);
    assert_eq!(ends(0.0, 1.0, first), ends(1.0, 1.0, first));
    assert_eq!(ends(0.0, 2.0, last), ends(-1.0, 1.0, last));
    let over = contour_train::MoveOverContourStart { allowance: 1.0, climb: 1.0, turn: 2.0, above: 50.0 };
    let path = over.path(&control.contours, TOOL, last);
    let ends: Vec<DVec3> = path.legs.iter().map(|leg| leg.end()).collect();
    assert_eq!(ends, [DVec3::new(44.0, 30.0, 50.0), DVec3::new(0.0, 6.0, 50.0)]);
    assert!(over.path(&control.contours, TOOL, DVec3::new(0.0, 6.0, 50.0)).legs.is_empty());
}

#[test]
fn a_contour_is_wrapped_on_a_cylinder() {
    let mut control = Notebook { around: Around { height: 90.0, ..Around::default() }, ..Notebook::default() };
    let wrap = |radius: f64, dimensions: f64| cylinder::WrapOnCylinder { radius, dimensions };
    let found = wrap(100.0, 1.0).act(&mut control).expect("a contour");
    assert_eq!((found.height, found.centred), (90.0, 1.0));
    for wrong in [wrap(0.0, 1.0), wrap(100.0, 2.0)] {
        assert!(wrong.act(&mut control).is_err());
    }
    // Six millimetres on its left; a radian of a radius of 100 is 57.296 degrees.
    let over = cylinder::MoveOverWrappedContour { radius: 100.0, allowance: 1.0, height: 107.0 };
    over.act(&mut control).expect("room");
    cylinder::PlungeIntoCylinder { level: 97.0, at: 100.0 }.act(&mut control).expect("room");
    let follow = cylinder::FollowWrappedContour { level: 97.0, radius: 100.0, allowance: 1.0, at: 300.0 };
    follow.act(&mut control).expect("room");
    cylinder::RetractFromCylinder { height: 107.0 }.act(&mut control).expect("room");
    let wanted = [
        "read the development, None mm in a degree",
        "0.000° 0.000 0.000 107.000 on 100 at 99999.999",
        "0.000° 0.000 6.000 107.000 on 100 at 99999.999",
        "0.000° 0.000 6.000 97.000 on 1 at 100",
        "25.210° 0.000 6.000 97.000 on 100 at 300",
        "25.210° 0.000 30.000 97.000 on 100 at 300",
        "25.210° 0.000 30.000 107.000 on 1 at 99999.999",
    ];
    assert_eq!(control.done, wanted);
}

#[test]
fn walls_are_reworked_as_often_as_the_tolerance_asks_for() {
    // Half of the radius at the floor: 0.5 / (2 √0.5) is the tangent of 19.47°. With an arm of 5 and 0.02 mm the angle
    // of two passes is 2 acos(0.996) = 10.25° at most: two passes more, by 0.2929 / (2 · 0.8409), 9.88°.
    let radii = cylinder_wall::radii_of_walls(40.0, 20.0, 5.0, 0.02, 10).expect("few");
    let wanted = [40.0 * 0.5_f64.sqrt(), 20.0];
    assert!(
        radii.len() == 2 && radii.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-9),
        "{radii:?}"
    );
    assert_eq!(cylinder_wall::radii_of_walls(40.0, 20.0, 0.01, 0.02, 10), Some(Vec::new()));
    assert_eq!(cylinder_wall::radii_of_walls(40.0, 20.0, 5.0, 1e-9, 10), None);
}

#[test]
fn strategies_over_contours_work_on_what_was_read() {
    let mut control = Notebook::default();
    let data = contour::RecallContourData {}.act(&mut control).expect("data");
    assert_eq!((data.depth, data.direction), (5.0, 9.0));
    let find = contour::FindInfeedPoints {
        overlap: 0.8,
        allowance: 0.0,
        rounding: 0.0,
        tool: None,
        coarse: None,
        floors: None,
    };
    let points = find.act(&mut control).expect("points");
    assert_eq!((points.count, points.radius, points.stepover), (1.0, 5.0, 4.0));
    // In each corner a square without a quarter of a circle, 25 - 25 pi / 4, but for what a micrometre more reaches.
    let left = contour::FindMaterialLeft { allowance: 0.0, rounding: 0.0, surface: 1.0, depth: -10.0 };
    assert_eq!(left.act(&mut control).expect("corners").places, 4.0);
    let mut places = control.done.clone();
    places.sort();
    assert!(places.iter().all(|place| place.starts_with("5.35") && place.ends_with("-9.000]")), "{places:?}");
    let tool = Cutter { radius: 5.0 };
    let clear = contour::ClearRegionAtLevel {
        part: 1.0,
        stepover: 4.0,
        allowance: 0.0,
        rounding: 0.0,
        climb: 1.0,
        radius: None,
        coarse: None,
        floors: None,
        level: -3.0,
        at: 200.0,
    };
    // The centre may be in 30 by 10; one step of 4 further in 22 by 2 are left, which the tool enters on the upper side.
    let path = clear.path(&control.contours, tool, DVec3::new(20.0, 11.0, -3.0));
    assert_eq!(path.fault, None);
    let ends: Vec<DVec2> = path.legs.iter().map(|leg| leg.end().truncate()).collect();
    let inner = [(9.0, 11.0), (9.0, 9.0), (31.0, 9.0), (31.0, 11.0), (20.0, 11.0)];
    let outer = [(20.0, 15.0), (5.0, 15.0), (5.0, 5.0), (35.0, 5.0), (35.0, 15.0), (20.0, 15.0)];
    let wanted: Vec<DVec2> = inner.iter().chain(&outer).map(|(x, y)| DVec2::new(*x, *y)).collect();
    let same = ends.len() == wanted.len() && ends.iter().zip(&wanted).all(|(a, b)| a.distance(*b) < 1e-9);
    assert!(same, "{ends:?}");
    let deep = contour::StopDistance { depth: -100.0 }.calculate(flat()).expect("a distance");
    let shallow = contour::StopDistance { depth: -30.0 }.calculate(flat()).expect("a distance");
    assert_eq!((deep.distance, shallow.distance), (2.0, 0.6));
}

impl System for Notebook {
    fn plane(&self) -> WorkingPlane {
        flat()
    }

    fn frame(&self) -> Frame {
        Frame::placed(self.origin, DVec3::new(0.0, 0.0, self.basic))
    }

    fn around_datum(&self) -> (Frame, Frame) {
        (self.frame(), Frame::IDENTITY)
    }

    fn datums_are_of_machine(&self) -> bool {
        false
    }

    fn move_preset(&mut self, way: DVec3) {
        self.origin += way;
    }

    fn basic_rotation(&self) -> f64 {
        self.basic
    }

    fn set_basic_rotation(&mut self, degrees: f64, _: Option<DVec3>) {
        self.basic = degrees;
    }

    fn align_turning(&mut self, precession: Option<f64>, _: Option<bool>) -> Done {
        self.basic = precession.unwrap_or(self.basic);
        Ok(())
    }

    fn end_turning_alignment(&mut self) {
        self.basic = 0.0;
    }

    fn zero_of(&self, _: RotaryAxis) -> (f64, f64) {
        self.zero
    }

    fn set_zero_of(&mut self, _: RotaryAxis, zero: (f64, f64)) {
        self.zero = zero;
    }
}

impl Tables for Notebook {
    fn has_row(&self, table: TableKind, row: f64) -> Result<bool, Fault> {
        Ok(self.cells.iter().any(|(kind, own, ..)| (*kind, *own) == (table, row)))
    }

    fn number(&self, table: TableKind, row: f64, column: &str) -> Result<Option<f64>, Fault> {
        let of = |(kind, own, name, _): &&(TableKind, f64, String, f64)| (*kind, *own, &**name) == (table, row, column);
        Ok(self.cells.iter().rev().find(of).map(|(.., value)| *value))
    }

    fn preset(&self, _: f64) -> Result<(DVec3, Frame), Fault> {
        Ok((DVec3::ZERO, Frame::IDENTITY))
    }

    fn write(&mut self, table: TableKind, row: f64, column: &str, cell: &Cell) -> Done {
        let Cell::Number(value) = cell else { panic!("{column} gets {cell:?}") };
        self.cells.push((table, row, column.to_owned(), *value));
        Ok(())
    }

    fn tool(&self) -> Option<f64> {
        Some(1.0)
    }

    fn insert(&self) -> Result<ciklo::engine::machine::TurningInsert, Fault> {
        let number = |column| Ok::<_, Fault>(self.number(TableKind::Tool, 1.0, column)?.unwrap_or_default());
        let (radius, width) = (number("RS")?, number("CUTWIDTH")?);
        Ok(ciklo::engine::machine::TurningInsert { tool: 1.0, radius, width, ..Default::default() })
    }
}

impl RotaryAxes for Notebook {
    fn rotary(&self, axis: RotaryAxis) -> Result<Rotary, Fault> {
        Ok(Rotary { about: axis.0.unit(), carries_workpiece: true })
    }

    fn angle(&self, _: RotaryAxis) -> f64 {
        self.angle
    }

    fn turn_to(&mut self, _: RotaryAxis, angle: f64) -> Done {
        self.angle = angle;
        Ok(())
    }

    fn for_tilted_plane(&self) -> Result<DVec3, Fault> {
        Ok(DVec3::ZERO)
    }

    fn turn_about_point(&mut self, angles: DVec3, _: f64, _: f64) -> Done {
        self.angle = angles.z;
        Ok(())
    }

    fn spindle_is_across(&self) -> bool {
        false
    }
}

impl Probe for Notebook {
    fn ball(&self) -> Result<DVec3, Fault> {
        Ok(DVec3::new(1.0, 2.0, 3.0))
    }

    fn stroke(&mut self, way: DVec3, feed: f64) -> Done<Stopped> {
        self.done.push(format!("approach {way} at {feed}"));
        Ok(Stopped { centre: self.ball()? + way / 2.0, touched: self.pressed })
    }

    fn retract(&mut self, way: f64) -> Done {
        self.done.push(format!("retract {way}"));
        Ok(())
    }

    fn calibration(&self) -> Result<Calibrated, Fault> {
        Ok(Calibrated { row: 7.0, offset: DVec2::new(0.1, 0.2), tool: 1.0, oversizes: (0.01, 0.02) })
    }

    fn renew(&mut self) -> Result<(), Fault> {
        self.done.push("renew".to_owned());
        Ok(())
    }
}

impl Spindle for Notebook {
    fn running(&self) -> Running {
        self.running
    }

    fn at_begin(&self) -> Running {
        Running { direction: 1, speed: 800.0, coolant: false }
    }

    fn turn(&mut self, direction: i8, speed: f64) {
        (self.running.direction, self.running.speed) = (direction, speed);
        self.done.push(format!("turn {direction} {speed}"));
    }

    fn coolant(&mut self, on: bool) {
        self.running.coolant = on;
        self.done.push(format!("coolant {on}"));
    }

    fn keep_orientation(&mut self, angle: f64) {
        self.done.push(format!("orient {angle}"));
    }

    fn function(&self, number: f64) -> Option<Function> {
        (number == 4.0).then_some(Function { spindle: Some(-1), coolant: None })
    }
}

impl Programs for Notebook {
    fn call(&mut self, name: &str) -> Done {
        self.done.push(format!("call {name}"));
        Ok(())
    }

    fn keep_tolerance(&mut self, tolerance: Option<[f64; 3]>) {
        self.done.push(format!("tolerance {tolerance:?}"));
    }
}

#[test]
fn a_point_gets_its_coordinates() {
    let mut control = Notebook { origin: DVec3::new(100.0, 50.0, 0.0), ..Notebook::default() };
    let point = Mm(DVec3::new(3.0, 4.0, 5.0));
    let set = datum::SetDatum { point, main: Some(Mm(0.0)), minor: None, tool: Some(Mm(10.0)) };
    set.act(&mut control).expect("a datum");
    assert_eq!(control.origin, DVec3::new(103.0, 50.0, -5.0));
    let row = datum::WriteDatumRow { point, main: None, minor: Some(Mm(1.0)), tool: None, row: 3.0 };
    row.act(&mut control).expect("a row");
    assert_eq!(control.cells, [(TableKind::Datum, 3.0, "Y".to_owned(), 3.0)]);
}

#[test]
fn a_turned_workpiece_is_turned_back() {
    let mut control = Notebook { angle: 10.0, ..Notebook::default() };
    let found = rotary::AlignRotaryTable { angle: 2.0 }.act(&mut control).expect("a way");
    assert_eq!((found.way, control.angle), (-2.0, 8.0));
    rotary::ZeroRotaryTable { axis: None }.act(&mut control).expect("a zero");
    assert_eq!(control.zero, (8.0, 0.0));
    basic_rotation::WriteBasicRotation { angle: 1.5, row: Some(4.0) }.act(&mut control).expect("a row");
    assert_eq!(control.cells, [(TableKind::Preset, 4.0, "SPC".to_owned(), 1.5)]);
}

#[test]
fn a_probe_reports_what_it_found() {
    let probing = probing::ProbeWithOwnPath {
        direction: -DVec3::Z,
        path: Mm(4.0),
        feed: Mm(200.0),
        in_machine: None,
        tolerant: None,
        silent: None,
    };
    let mut control = Notebook { pressed: true, ..Notebook::default() };
    let found = probing.act(&mut control).expect("a contact");
    assert_eq!((found.main, found.minor, found.tool, found.status), (Mm(1.0), Mm(2.0), Mm(1.0), 0.0));
    control.pressed = false;
    assert!(probing.act(&mut control).is_err(), "nothing was there");
    let tolerant = probing::ProbeWithOwnPath { tolerant: Some(true), ..probing };
    assert_eq!(tolerant.act(&mut control).map(|found| found.status).ok(), Some(1.0));
}

#[test]
fn a_calibration_leaves_oversizes_as_they_are() {
    let mut control = Notebook::default();
    control.cells.push((TableKind::Tool, 1.0, "DR".to_owned(), 0.3));
    let store = probing::StoreProbeCalibration { radius: Some(Mm(2.5)), length: None, offset: Some(Mm(DVec3::X)) };
    store.act(&mut control).expect("a calibration");
    assert!((control.cells[1].3 - (2.5 - 0.3 - 0.01)).abs() < 1e-12, "{:?}", control.cells);
    assert_eq!(control.cells[2], (TableKind::Probe, 7.0, "CAL_OF1".to_owned(), 1.1));
    assert_eq!(control.done, ["renew"]);
}

#[test]
fn the_spindle_becomes_what_it_was() {
    let mut control =
        Notebook { running: Running { direction: 1, speed: 800.0, coolant: true }, ..Notebook::default() };
    spindle::ReverseSpindle {}.act(&mut control).expect("a spindle");
    spindle::RestoreSpindleAndCoolant {}.act(&mut control).expect("a spindle");
    spindle::TurnSpindle { function: 4.0, speed: 250.0 }.act(&mut control).expect("a function");
    assert_eq!(control.done, ["turn -1 800", "turn 1 800", "coolant false", "turn -1 250"]);
    assert!(spindle::TurnSpindle { function: 8.0, speed: 250.0 }.act(&mut control).is_err());
}

#[test]
fn a_tolerance_without_a_contour_is_that_of_the_machine() {
    let mut control = Notebook::default();
    let keep = |contour| program::KeepTolerance { contour, hsc_mode: None, rotary: None };
    keep(None).act(&mut control).expect("a tolerance");
    keep(Some(0.02)).act(&mut control).expect("a tolerance");
    assert_eq!(control.done, ["tolerance None", "tolerance Some([0.02, 0.0, 0.0])"]);
}

#[test]
fn every_character_is_within_its_box_and_no_arc_is_bent() {
    for character in font::characters() {
        let glyph = font::glyph(character).expect("a character");
        assert!(!glyph.strokes.is_empty(), "{character}");
        for way in &glyph.strokes {
            assert!(way.length() > 0.5, "{character} has a stroke without a length");
            for part in 0..=100 {
                let at = way.shortened(way.length() * f64::from(part) / 100.0).end();
                let inside = (-0.01..=glyph.width + 0.01).contains(&at.x) && (-4.01..=13.01).contains(&at.y);
                assert!(inside, "{character} goes to {at}");
            }
            let mut from = way.start;
            for edge in &way.edges {
                if let Edge::Arc { to, centre, .. } = edge {
                    assert!((from.distance(*centre) - to.distance(*centre)).abs() < 1e-9, "{character} at {to}");
                }
                from = edge.to();
            }
        }
    }
    let all: BTreeSet<char> = font::characters().collect();
    assert_eq!(all.len(), font::characters().count(), "a character is there twice");
    // Letters, digits, and what the manual lists besides (TNC 640, 001:7213-7217).
    let wanted = ('A'..='Z').chain('a'..='z').chain('0'..='9').chain("!#$%&'()*+,-./:;<=>?@[\\]_".chars());
    assert!(wanted.clone().all(|own| all.contains(&own)) && wanted.count() == all.len());
}
