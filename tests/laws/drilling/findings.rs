//! What the events of a run say about moves in the material, and what they do not say.
use ciklo::engine::run::{Event, EventKind, FindingKind, Status};

use super::setup::{machine, run};

const SCENE: &str = "scene: 1\nstock: {box: {min: [0, 0, -20], max: [100, 60, 0]}}\nstart: [0, 0, 100]\n\
    tools: [{T: 1, L: 50, R: 5}, {T: 2, L: 50, R: 3, LCUTS: 4}, {T: 3, L: 50}]\n";
const HEAD: &str = "TOOL CALL 1 Z S1000\nL X+10 Y+30 Z+5 R0 FMAX M3\n";

fn events(body: &str) -> Vec<Event> {
    let (outcome, events, ..) = machine(&format!("BEGIN PGM F MM\n{body}END PGM F MM\n"), SCENE, 1.0);
    assert_eq!(outcome.status, Status::Done, "{body} {:?}", outcome.fault);
    events
}

/// Line, kind and amount of a finding.
type Found = (usize, FindingKind, f64);

fn found(events: &[Event]) -> Vec<Found> {
    let finding = |event: &Event| match event.kind {
        EventKind::Finding { kind, amount } => Some((event.at.line, kind, amount)),
        _ => None,
    };
    events.iter().filter_map(finding).collect()
}

#[test]
fn moves_in_the_material_are_told_behind_them() {
    let cases: [(&str, &[Found]); 8] = [
        // Down at feed, and through the part at rapid traverse.
        ("L Z-4 F200\nL X+60 FMAX\n", &[(5, FindingKind::Rapid, 4.0)]),
        // Down at rapid traverse.
        ("L Z-3 FMAX\n", &[(4, FindingKind::Rapid, 3.0)]),
        // An arc at rapid traverse, 2 mm deep.
        ("L Z-2 F200\nCC X+30 Y+30\nC X+50 Y+30 DR+ FMAX\n", &[(6, FindingKind::Rapid, 2.0)]),
        // More than rounding.
        ("L Z-0.002 FMAX\n", &[(4, FindingKind::Rapid, 0.002)]),
        // M5 acts at the end of its block.
        ("L Z-4 F200 M5\nL X+60\n", &[(5, FindingKind::SpindleStopped, 4.0)]),
        // Edges of 4 mm in a depth of 6.
        ("TOOL CALL 2 Z S1000\nL Z-6 F200 M3\nL X+60\n", &[(6, FindingKind::EdgesTooShort, 6.0)]),
        // A tool without radius is named once.
        ("TOOL CALL 3 Z S1000\nL Z-6 F200 M3\nL X+60\nL X+20\n", &[(5, FindingKind::NoRadius, 3.0)]),
        // A cycle that takes the surface 5 mm too low: its set-up clearance lies in the material.
        (
            "CYCL DEF 200\nQ200=2\nQ201=-8\nQ206=250\nQ202=8\nQ210=0\nQ203=-5\nQ204=0\nQ211=0\nCYCL CALL\n",
            &[(13, FindingKind::Rapid, 3.0)],
        ),
    ];
    for (body, wanted) in cases {
        let events = events(&format!("{HEAD}{body}"));
        let found = found(&events);
        assert_eq!(found.len(), wanted.len(), "{body} {found:?}");
        for ((line, kind, amount), (at, what, much)) in found.iter().zip(wanted) {
            assert!((line, kind) == (at, what) && (amount - much).abs() < 1e-6, "{body} {found:?}");
        }
        for pair in events.windows(2) {
            if let [before, Event { at, kind: EventKind::Finding { .. } }] = pair {
                assert!(matches!(before.kind, EventKind::Move { .. }) && before.at.line == at.line, "{body} {pair:?}");
                assert_eq!(before.at.cycle, at.cycle, "{body}");
            }
        }
    }
}

#[test]
fn what_is_right_is_not_told() {
    let cases = [
        "L Z-4 F200\nL X+60\nL Z+5 FMAX\n",
        // Where it was milled before there is room for rapid traverse.
        "L Z-4 F200\nL X+60\nL X+10 FMAX\nL Z+5 FMAX\n",
        // On the surface, and as deep as rounding goes.
        "L Z+0 FMAX\nL X+60 FMAX\nL Z-0.0005 FMAX\n",
        // Beside the part.
        "L X-10 FMAX\nL Z-15 FMAX\nL Y+0 FMAX\n",
        // A spindle that stands over the part.
        "M5\nL X+60 F500\n",
        "TOOL CALL 2 Z S1000\nL Z-4 F200 M3\nL X+60\n",
        "CYCL DEF 200\nQ200=2\nQ201=-8\nQ206=250\nQ202=3\nQ210=0\nQ203=+0\nQ204=0\nQ211=0\nCYCL CALL\n",
    ];
    for body in cases {
        assert_eq!(found(&events(&format!("{HEAD}{body}"))), [], "{body}");
    }
}

/// More moves than are carried out together: all events are there, in order, and each finding behind its move.
#[test]
fn many_moves_keep_their_order() {
    let body = format!("{HEAD}LBL 1\nL IZ-8 FMAX\nL IZ+8 FMAX\nQ1=Q1+1\nL IX+0.01 FMAX\nCALL LBL 1 REP 3000\n");
    let program = format!("BEGIN PGM F MM\nQ1=0\n{body}END PGM F MM\n");
    let (_, with, ..) = machine(&program, SCENE, 1.0);
    let (_, without) = run(&program, SCENE);
    let plain: Vec<&Event> = with.iter().filter(|event| !matches!(event.kind, EventKind::Finding { .. })).collect();
    assert_eq!(plain.len(), without.len());
    assert!(plain.iter().zip(&without).all(|(a, b)| a.to_line() == b.to_line()));
    // Only ways down into columns that are still there: over 30 mm, about one for each millimetre and pair of rows.
    let found: Vec<usize> = with
        .iter()
        .enumerate()
        .filter(|(_, event)| matches!(event.kind, EventKind::Finding { .. }))
        .map(|(n, _)| n)
        .collect();
    assert!(found.len() > 100 && found.len() < 200, "{}", found.len());
    for n in found {
        let EventKind::Move { from, to, .. } = &with[n - 1].kind else { panic!("{:?}", with[n - 1]) };
        assert!(to.z < from.z, "{:?}", with[n - 1]);
    }
}

/// An axis limit ends the run; what would pass it is not executed.
#[test]
fn axis_limits_are_errors() {
    let cases = [
        ("L X+1000.1 FMAX\n", "X"),
        ("L X+995 FMAX\nCC X+995 Y+20\nC X+995 Y+10 DR- F500\n", "X"),
        ("CYCL DEF 200\nQ200=2\nQ201=-1010\nQ206=250\nQ202=8\nQ210=0\nQ203=-5\nQ204=0\nQ211=0\nCYCL CALL\n", "Z"),
    ];
    for (body, axis) in cases {
        let (outcome, events) = run(&format!("{HEAD}{body}L X+0 Y+0 Z+50 FMAX\n"), SCENE);
        let fault = outcome.fault.unwrap_or_else(|| panic!("{body} passes"));
        assert_eq!((&*fault.code, outcome.status), ("axis-limit", Status::Error), "{body}");
        assert!(
            fault.args.iter().any(|(name, value)| *name == "axis" && *value == axis.into()),
            "{body} {:?}",
            fault.args
        );
        let within = |event: &Event| match &event.kind {
            EventKind::Move { machine, .. } => machine.abs().max_element() <= 1000.0,
            _ => true,
        };
        assert!(events.iter().all(within), "{body}");
        assert!(
            matches!(&events[events.len() - 2].kind, EventKind::Error(error) if error.code == "axis-limit"),
            "{body}"
        );
    }
    let (outcome, _) = run(&format!("{HEAD}L X+999.9 FMAX\n"), SCENE);
    assert_eq!(outcome.status, Status::Done);
}
