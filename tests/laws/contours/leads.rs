//! Every form of `APPR` and `DEP`, right-angled and polar: where its lines and arcs lie, and that they join the path beside
//! the contour and keep off it.
use ciklo::engine::run::Status;
use glam::DVec2;
use proptest::prelude::*;

use super::outline::{Outline, Program, outline};
use super::path::{NEAR, Piece, config, run};

/// Where the tool stands before the approach, and where `DEP LCT` leads.
const BEFORE: DVec2 = DVec2::splat(90.0);
const BEHIND: DVec2 = DVec2::splat(95.0);

/// The forms of both blocks.
#[derive(Clone, Copy, Debug)]
enum Form {
    /// `LT`: that far along the contour.
    Along(f64),
    /// `LN`: that far across it.
    Across(f64),
    /// `CT`: radius, negative on the side of the workpiece, and angle.
    Arc(f64, f64),
    /// `LCT`: an arc of that radius and a line.
    ArcAndLine(f64),
}

fn form() -> impl Strategy<Value = (Form, bool)> {
    let hundredths = |low: i32, high: i32| (low..high).prop_map(|value| f64::from(value) / 100.0);
    let radius = (hundredths(50, 1500), prop_oneof![3 => Just(1.0), 1 => Just(-1.0)]).prop_map(|(r, sign)| r * sign);
    let form = prop_oneof![
        hundredths(50, 3000).prop_map(Form::Along),
        hundredths(50, 3000).prop_map(Form::Across),
        (radius, 10..=270).prop_map(|(radius, angle)| Form::Arc(radius, f64::from(angle))),
        hundredths(50, 1500).prop_map(Form::ArcAndLine),
    ];
    (form, any::<bool>())
}

/// The words of a point, right-angled or polar.
fn point(outline: &Outline, place: DVec2, polar: bool) -> String {
    if polar {
        format!("PR{:+} PA{:+}", place.length(), place.y.atan2(place.x).to_degrees())
    } else {
        outline.view.words(place)
    }
}

impl Form {
    /// Its name and words.
    fn words(self) -> (&'static str, String) {
        match self {
            Self::Along(length) => ("LT", format!("LEN{length}")),
            Self::Across(length) => ("LN", format!("LEN{length}")),
            Self::Arc(radius, angle) => ("CT", format!("CCA{angle} R{radius:+}")),
            Self::ArcAndLine(radius) => ("LCT", format!("R{radius}")),
        }
    }

    fn approach(self, outline: &Outline, polar: bool) -> String {
        let (name, words) = self.words();
        let side = if outline.left { "RL" } else { "RR" };
        let letters = if polar { "P" } else { "" };
        format!("APPR {letters}{name} {} {words} {side} F300", point(outline, outline.begin(), polar))
    }

    fn departure(self, outline: &Outline, polar: bool) -> String {
        let (name, words) = self.words();
        match self {
            Self::ArcAndLine(_) => {
                let letters = if polar { "P" } else { "" };
                format!("DEP {letters}{name} {} {words} F300", point(outline, BEHIND, polar))
            }
            _ => format!("DEP {name} {words} F300"),
        }
    }

    /// The legs between the contour and its end, from the contour on: `on` is beside its end, `along` leads away, and `out`
    /// is across it on the side of the tool. What is left out is found from the tangents.
    fn holds(self, legs: &[Piece], on: DVec2, along: DVec2, out: DVec2) -> Result<(), String> {
        let near = |name: &str, found: DVec2, wanted: DVec2| {
            if found.distance(wanted) < NEAR { Ok(()) } else { Err(format!("{name} is {found} and not {wanted}")) }
        };
        let first = legs.first().ok_or("no leg")?;
        near("the joint", first.from, on)?;
        let line = |way: DVec2| {
            near("the end", first.to, on + way)?;
            if first.arc.is_none() && legs.len() == 1 { Ok(()) } else { Err("no line".to_owned()) }
        };
        match self {
            Self::Along(length) => line(along * length),
            Self::Across(length) => line(out * length),
            Self::Arc(radius, _) | Self::ArcAndLine(radius) => {
                let (centre, found, sweep) = first.arc.ok_or("no arc")?;
                near("the centre", centre, on + out * radius)?;
                near("the tangent", first.heading(on), along)?;
                if (found - radius.abs()).abs() > NEAR {
                    return Err(format!("the radius is {found}"));
                }
                if let Self::Arc(_, angle) = self {
                    let turn = sweep.abs().to_degrees();
                    return if legs.len() == 1 && (turn - angle).abs() < 1e-6 {
                        Ok(())
                    } else {
                        Err(format!("{} legs, the first turns by {turn}", legs.len()))
                    };
                }
                let line = legs.get(1).filter(|leg| leg.arc.is_none()).ok_or("no line behind the arc")?;
                near("the second tangent", line.heading(line.from), first.heading(first.to))
            }
        }
    }

    /// Whether a leg keeps off the contour: the line of the first edge, with the tool on one side.
    fn keeps_off(self, legs: &[Piece], begin: DVec2, out: DVec2, tool: f64) -> bool {
        let inward = matches!(self, Self::Arc(radius, _) if radius < 0.0);
        // The line behind an arc leads anywhere.
        let own = match self {
            Self::ArcAndLine(_) => &legs[..1],
            _ => legs,
        };
        own.iter().all(|leg| {
            (0..=32)
                .map(|n| (leg.at(f64::from(n) / 32.0) - begin).dot(out))
                .all(|far| if inward { far <= tool + NEAR } else { far >= tool - NEAR })
        })
    }
}

/// The same way from its end to its beginning.
fn reversed(piece: &Piece) -> Piece {
    let arc = piece.arc.map(|(centre, radius, angle)| (centre, radius, -angle));
    Piece { from: piece.to, to: piece.from, arc, heights: [piece.heights[1], piece.heights[0]], ..*piece }
}

fn leads(outline: &Outline, enter: (Form, bool), leave: (Form, bool)) -> Result<(), TestCaseError> {
    let (plane, begin, heading) = (outline.view.plane(), outline.begin(), outline.heading());
    let polar = format!("CC {}+0 {}+0\n", plane.main.letter(), plane.secondary.letter());
    let approach = polar + &enter.0.approach(outline, enter.1);
    let program: Program = outline.program_between(&approach, &leave.0.departure(outline, leave.1));
    let ran = run(&outline.view, &program.text, outline.tool);
    let both = &ran.both;
    if matches!(&*ran.code, "compensation-too-large" | "rounding-impossible") {
        return Err(TestCaseError::reject("no contour for that tool"));
    }
    prop_assert_eq!(ran.status, Status::Done, "{}{}", ran.code, both);
    let out = heading.perp() * if outline.left { 1.0 } else { -1.0 };
    let on = begin + out * outline.tool;
    let of_line = |line: usize| ran.path.iter().filter(|piece| piece.line == line).copied().collect::<Vec<_>>();

    // Backwards: from the contour to where the tool stood.
    let entered: Vec<Piece> = of_line(program.first).iter().rev().map(reversed).collect();
    prop_assert!(entered.last().is_some_and(|last| last.to.distance(BEFORE) < NEAR), "{:?}{}", entered, both);
    let own = if matches!(enter.0, Form::ArcAndLine(_)) { entered.len() } else { 1 };
    let found = enter.0.holds(&entered[..own], on, -heading, out);
    prop_assert!(found.is_ok(), "APPR: {:?} {:?}{}", found, entered, both);
    prop_assert!(entered.len() == 2, "{:?}{}", entered, both);
    prop_assert!(enter.0.keeps_off(&entered[..own], begin, out, outline.tool), "APPR cuts the contour{}", both);

    let left = of_line(program.last);
    let found = leave.0.holds(&left, on, heading, out);
    prop_assert!(found.is_ok(), "DEP: {:?} {:?}{}", found, left, both);
    prop_assert!(leave.0.keeps_off(&left, begin, out, outline.tool), "DEP cuts the contour{}", both);
    if matches!(leave.0, Form::ArcAndLine(_)) {
        prop_assert!(left.last().is_some_and(|last| last.to.distance(BEHIND) < NEAR), "{:?}{}", left, both);
    }
    prop_assert!(entered.iter().chain(&left).all(|leg| leg.length() > 0.0), "no way{}", both);
    Ok(())
}

laws! {
    #![proptest_config(config(24))]

    #[test]
    fn approaches_and_departures_join_the_contour(outline in outline(false), enter in form(), leave in form()) {
        leads(&outline, enter, leave)?;
    }
}
