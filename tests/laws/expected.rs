//! A run that touches as expected: whatever is measured has its nominal size and place, in a scene without any part.
use ciklo::base::diag::Source;
use ciklo::base::expr::QRef;
use ciklo::engine::run::{Content, Engine, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use proptest::prelude::*;

use crate::built::{Built, built};

const SCENE: &str = "scene: 1\nunits: mm\nmachine: mill-3-axis\ntools: [{T: 1, L: 100, R: 2, TP_NO: 1}]\n\
                     probe: {NO: 1, ball_radius: 2}\nstart: {X: 0, Y: 0, Z: 100}\n";

/// The results of a cycle with these values, all others 0.
fn results(number: u32, values: &[(u16, f64)]) -> Outcome {
    let Built { files, catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    let (_, cycle) = on
        .cycles
        .iter()
        .find(|(key, _)| key.number == number && key.to_string().starts_with("TCH PROBE"))
        .expect("the control has the cycle");
    let value = |q: QRef| values.iter().find(|(own, _)| *own == q.number).map_or(0.0, |(_, value)| *value);
    let written: String =
        cycle.params.iter().filter_map(|param| param.q).map(|q| format!("{q}={}\n", value(q))).collect();
    let program = format!("BEGIN PGM A MM\nTOOL CALL 1 Z\nTCH PROBE {number}\n{written}END PGM A MM\n");
    let scene = Scene::parse(&Source::new("scene.yaml", SCENE), files).expect("a scene");
    let tree = syntax::parse(&Source::new("A.H", program));
    Engine::new(&tree, on, &scene, &NoTexts).touching_as_expected().run(&mut drop)
}

fn q(outcome: &Outcome, number: u16) -> f64 {
    match outcome.params.get(QRef::q(number)) {
        Some(Content::Number(number)) => number,
        other => panic!("Q{number} is {other:?}; {:?}", outcome.fault),
    }
}

proptest! {
    #![proptest_config(crate::cases::config(60))]

    /// The hole, and the rectangular stud, that a measurement expects is what it finds, whatever the clearance.
    #[test]
    fn what_is_measured_is_nominal(
        x in -80.0..80.0_f64,
        y in -80.0..80.0_f64,
        size in 30.0..90.0_f64,
        other in 30.0..90.0_f64,
        clearance in 0.0..5.0_f64,
    ) {
        let place = [(273, x), (274, y), (261, -5.0), (320, clearance), (260, 20.0)];
        let hole: Vec<(u16, f64)> = place.iter().copied().chain([(262, size), (247, 90.0), (423, 4.0)]).collect();
        let outcome = results(421, &hole);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        for (number, nominal) in [(151, x), (152, y), (153, size), (161, 0.0), (162, 0.0), (163, 0.0)] {
            prop_assert!((q(&outcome, number) - nominal).abs() < 1e-9, "Q{number}: {}", q(&outcome, number));
        }
        let stud: Vec<(u16, f64)> = place.iter().copied().chain([(282, size), (283, other)]).collect();
        let outcome = results(424, &stud);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        for (number, nominal) in [(151, x), (152, y), (154, size), (155, other), (164, 0.0), (165, 0.0)] {
            prop_assert!((q(&outcome, number) - nominal).abs() < 1e-9, "Q{number}: {}", q(&outcome, number));
        }
    }
}
