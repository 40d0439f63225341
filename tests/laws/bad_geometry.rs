//! Geometry that determines nothing or nearly nothing: points that nearly coincide or lie nearly on a line, lines that are
//! nearly parallel, tiny arcs. Every family of probing cycles has its cases; each ends with finite results and tables, or with an
//! error that is explained in every language.
use std::fmt::Write as _;
use std::sync::OnceLock;

use ciklo::base::diag::Source;
use ciklo::base::expr::{QKind, QRef};
use ciklo::engine::run::{Class, Content, Engine, EventKind};
use ciklo::engine::scene::Scene;
use ciklo::language::locale::{Locales, Scope};
use ciklo::program::syntax;
use ciklo::spec::Catalogue;
use ciklo::tools::conform::LogTexts;
use proptest::prelude::*;

struct Data {
    files: ciklo::base::data::Files,
    catalogue: &'static Catalogue,
    locales: &'static Locales,
}

fn data() -> &'static Data {
    static DATA: OnceLock<Data> = OnceLock::new();
    DATA.get_or_init(|| {
        let files = ciklo::base::data::embedded();
        let catalogue = &crate::built::built().catalogue;
        let locales = &*crate::built::built().locales;
        Data { files, catalogue, locales }
    })
}

/// A cycle with the values that matter, the part, and where the probe starts.
struct Case {
    number: u32,
    values: Vec<(u16, f64)>,
    solid: String,
    start: [f64; 3],
}

const PLATE: &str = "box: {min: [-150, -150, -40], max: [150, 150, 0]}";

fn holes(holes: &[(f64, f64)], diameter: f64) -> String {
    let cylinder =
        |(x, y): &(f64, f64)| format!("{{cylinder: {{centre: [{x}, {y}], diameter: {diameter}, from: -50, to: 0}}}}");
    let all: Vec<String> = holes.iter().map(cylinder).collect();
    format!("{{difference: [{{{PLATE}}}, {}]}}", all.join(", "))
}

fn studs(studs: &[(f64, f64)], diameter: f64) -> String {
    let cylinder =
        |(x, y): &(f64, f64)| format!("{{cylinder: {{centre: [{x}, {y}], diameter: {diameter}, from: -40, to: 0}}}}");
    let all: Vec<String> = studs.iter().map(cylinder).collect();
    format!("{{union: [{{box: {{min: [-150, -150, -60], max: [150, 150, -40]}}}}, {}]}}", all.join(", "))
}

/// How many families there are.
const FAMILIES: usize = 20;

/// `tiny` is what should be large: a distance, a step, a slope.
fn case(family: usize, tiny: f64, minus: bool) -> Case {
    let sense = if minus { -1.0 } else { 1.0 };
    let at = |values: &[(u16, f64)]| {
        let mut all =
            vec![(261, -5.0), (320, 1.0), (260, 30.0), (301, 1.0), (423, 4.0), (365, 1.0), (305, 0.0), (303, 1.0)];
        all.extend_from_slice(values);
        all
    };
    let made = |number, values: &[(u16, f64)], solid: String, start| Case { number, values: at(values), solid, start };
    let edge = "{box: {min: [-150, 0, -40], max: [150, 150, 0]}}".to_owned();
    let (two_points, above) =
        ([(263, 0.0), (264, 0.0), (265, tiny * sense), (266, 0.0), (272, 2.0), (267, 1.0)], [0.0, -60.0, 60.0]);
    let circle = |offset: f64, step: f64| {
        [(321, offset), (322, 0.0), (273, offset), (274, 0.0), (262, 30.0), (325, 10.0), (247, step * sense)]
    };
    let bolt = [
        (273, 0.0),
        (274, 0.0),
        (262, 80.0),
        (291, 20.0),
        (292, 20.0 + tiny * sense),
        (293, 20.0 + 2.0 * tiny * sense),
    ];
    let on_bolt: Vec<(f64, f64)> = bolt[3..]
        .iter()
        .map(|(_, angle)| {
            let angle = angle * std::f64::consts::PI / 180.0;
            (40.0 * libm::cos(angle), 40.0 * libm::sin(angle))
        })
        .collect();
    match family {
        0 => made(400, &two_points, edge, above),
        1 => made(420, &two_points, edge, above),
        2 => made(403, &[&two_points[..], &[(312, 6.0)]].concat(), edge, above),
        // Two holes, two studs that nearly coincide.
        3 => made(401, &[(268, 0.0), (269, 0.0), (270, tiny * sense), (271, 0.0)], holes(&[(0.0, 0.0)], 20.0), [0.0, 0.0, 60.0]),
        4 => made(402, &[(268, 0.0), (269, 0.0), (270, 0.0), (271, tiny), (313, 20.0), (314, 20.0), (315, -5.0)], studs(&[(0.0, 0.0)], 20.0), [0.0, 0.0, 60.0]),
        // A hole that lies nearly on the axis about which it is to turn.
        5 => made(405, &circle(tiny * sense, 90.0), holes(&[(0.0, 0.0)], 30.0), [0.0, 0.0, 60.0]),
        6 => made(412, &circle(0.0, tiny), holes(&[(0.0, 0.0)], 30.0), [0.0, 0.0, 60.0]),
        7 => made(413, &circle(0.0, tiny), studs(&[(0.0, 0.0)], 30.0), [0.0, 0.0, 60.0]),
        8 => made(421, &circle(0.0, tiny), holes(&[(0.0, 0.0)], 30.0), [0.0, 0.0, 60.0]),
        9 => made(422, &circle(0.0, tiny), studs(&[(0.0, 0.0)], 30.0), [0.0, 0.0, 60.0]),
        // Three holes nearly at one place.
        10 => made(416, &bolt, holes(&on_bolt[..1], 20.0), [0.0, 0.0, 60.0]),
        11 => made(430, &bolt, holes(&on_bolt[..1], 20.0), [0.0, 0.0, 60.0]),
        // Outside: a corner so flat that its edges nearly make one line. Inside: points that nearly coincide.
        12 => made(414, &[(263, -40.0), (264, 0.0), (326, 30.0 * sense), (296, 0.0), (297, 10.0), (327, tiny)],
            format!("{{difference: [{{half_space: {{normal: [{}, -1, 0], point: [0, 0, 0]}}}}, {{half_space: {{normal: [0, 0, -1], point: [0, 0, 0]}}}}]}}", tiny.min(1.0)), [-60.0, -60.0, 60.0]),
        13 => made(415, &[(263, 10.0), (264, 10.0), (326, tiny), (327, tiny), (308, if minus { 3.0 } else { 1.0 })],
            "{difference: [{box: {min: [-150, -150, -40], max: [150, 150, 0]}}, {box: {min: [0, 0, -50], max: [80, 80, 1]}}]}".to_owned(), [40.0, 40.0, 60.0]),
        // The connecting lines of four holes are nearly parallel, or hardly lines.
        14 => {
            let own = [(-60.0, 0.0), (-20.0, tiny.min(8.0) * sense), (20.0, 0.0), (60.0, 0.0)];
            let values = [(268, own[0].0), (269, own[0].1), (270, own[1].0), (271, own[1].1), (316, own[2].0), (317, own[2].1), (318, own[3].0), (319, own[3].1)];
            made(418, &values, holes(&own, 16.0), [0.0, 0.0, 60.0])
        }
        // Three points of a plane nearly on a line.
        15 => made(431, &[(263, 0.0), (264, 0.0), (294, 0.0), (265, 20.0), (266, 0.0), (295, 0.0), (296, 40.0), (297, tiny * sense), (298, 0.0)], format!("{{{PLATE}}}"), [0.0, 0.0, 60.0]),
        // A normal that hardly has a length.
        16 => made(444, &[(263, 5.0), (264, 5.0), (294, 0.0), (581, tiny.min(1.0) * 0.3), (582, 0.0), (583, tiny.min(1.0))], format!("{{{PLATE}}}"), [0.0, 0.0, 60.0]),
        // Calibration on hardly anything.
        17 => made(460, &[(407, tiny.min(12.0)), (380, 0.0), (433, 1.0)], format!("{{sphere: {{centre: [0, 0, -12], radius: {}}}}}", tiny.min(12.0)), [0.0, 0.0, 12.0]),
        18 => made(463, &[(407, tiny.min(12.0)), (380, 0.0)], format!("{{cylinder: {{diameter: {}, from: -40, to: 0}}}}", 2.0 * tiny.min(12.0)), [0.0, 0.0, 12.0]),
        _ => made(462, &[(407, 2.0 + tiny), (380, 0.0)], holes(&[(0.0, 0.0)], 2.0 * (2.0 + tiny)), [0.0, 0.0, -10.0]),
    }
}

/// A definition with the parameters that the cycle has on the control; those not given are 0.
fn definition(control: &str, case: &Case) -> Option<String> {
    let on = data().catalogue.on(control).expect("a control");
    let (_, cycle) =
        on.cycles.iter().find(|(key, _)| key.number == case.number && key.to_string().starts_with("TCH PROBE"))?;
    let mut text = format!("TCH PROBE {}\n", case.number);
    for param in &cycle.params {
        let q = param.q?;
        let value = case.values.iter().rev().find(|(known, _)| *known == q.number).map_or(0.0, |(_, value)| *value);
        if q.kind == QKind::Qs {
            let _ = writeln!(text, "{q}=\"0\"");
        } else {
            let _ = writeln!(text, "{q}={value}");
        }
    }
    Some(text)
}

laws! {
    #![proptest_config(crate::cases::config(150))]

    #[test]
    fn bad_geometry_is_finite_or_explained(
        family in 0..FAMILIES, exponent in -13.0..1.2_f64, minus in any::<bool>(), control in prop_oneof![Just("tnc640"), Just("tnc320"), Just("tnc426-430")], scatter in any::<bool>(),
    ) {
        let data = data();
        let case = case(family, libm::pow(10.0, exponent), minus);
        let Some(definition) = definition(control, &case) else { return Ok(()) };
        let late = if scatter { "scatter: [0.002, 0, 0.001, 0.0005, 0.003]" } else { "scatter: []" };
        let scene = format!(
            "scene: 1\nmachine: mill-table-c\ntools: [{{T: 1, L: 100, R: 2, TP_NO: 1}}]\nprobe: {{NO: 1, ball_radius: 2, DIST: 30, SET_UP: 2, {late}}}\n\
             presets: {{active: 1, rows: [{{NO: 1}}]}}\ndatums: [{{D: 0}}]\nstart: {:?}\nparts:\n  - solid: {}\n", case.start, case.solid
        );
        let parsed = Scene::parse(&Source::new("scene.yaml", scene.as_str()), &data.files);
        let parsed = parsed.unwrap_or_else(|found| panic!("{found:?}\n{scene}"));
        let program = format!("BEGIN PGM BAD MM\nTOOL CALL 1 Z\n{definition}");
        let tree = syntax::parse(&Source::new("BAD.H", program.as_str()));
        let mut events = Vec::new();
        let texts = LogTexts::new(data.locales.language("en").expect("English"), control, &data.files);
        let engine = Engine::new(&tree, data.catalogue.on(control).expect("a control"), &parsed, &texts);
        let outcome = engine.with_catalogue(data.catalogue).run(&mut |event| events.push(event.kind));
        for event in &events {
            if let EventKind::Table { value: Content::Number(value), column, .. } = event {
                prop_assert!(value.is_finite(), "{column} {value}\n{program}{scene}");
            }
            if let EventKind::Transform(system) = event {
                prop_assert!(system.origin.is_finite() && system.basic_rotation.is_finite(), "{program}{scene}");
            }
        }
        for number in 100..200 {
            if let Some(Content::Number(value)) = outcome.params.get(QRef::q(number)) {
                prop_assert!(value.is_finite(), "Q{number} {value}\n{program}{scene}");
            }
        }
        prop_assert!(outcome.position.is_finite() && outcome.angles.is_finite());
        let Some(fault) = outcome.fault else { return Ok(()) };
        let told = matches!(fault.class, Class::Program | Class::Control) || fault.code.starts_with("solid-");
        prop_assert!(told, "{fault:?}\n{program}{scene}");
        let id = format!("{}-{}", if fault.of_cycle { "guard" } else { "diag" }, fault.code);
        for language in ["en", "fi", "sl", "it", "pt"] {
            let language = data.locales.language(language).expect("a language");
            let scope = Scope { cycle: None, control: Some(control) };
            prop_assert!(language.has(id.as_str(), &scope), "{id}");
        }
    }
}

/// Each family is one of a cycle that the controls have, and its cases reach a result as well as an error where that can be.
#[test]
fn every_family_is_looked_at() {
    let numbers: std::collections::BTreeSet<u32> =
        (0..FAMILIES).map(|family| case(family, 1.0, false).number).collect();
    assert_eq!(numbers.len(), FAMILIES);
    for family in 0..FAMILIES {
        assert!(definition("tnc640", &case(family, 1.0, false)).is_some(), "{family}");
    }
}
