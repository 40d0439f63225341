//! Free contours of which data are withheld until just enough is left, wherever that may be: most of their elements are
//! open then, and only all of them together say what they are.
//!
//! The contour must come out as it was for one selection of the solutions, and each other one must have the data and the
//! tangents that were given: the run proves its own data, the law the ends.
use glam::DVec2;
use proptest::prelude::*;

use super::free::{Real, Text, an, outline, run, solutions};
use super::path::config;

/// What is said of an element, one word after the other.
type Words = Vec<String>;

#[derive(Clone, Debug)]
struct Withheld {
    drawn: super::free::Drawn,
    /// In which order data are added.
    order: Vec<u16>,
}

fn withheld() -> impl Strategy<Value = Withheld> {
    let drawn = super::free::drawn().prop_filter("few corners", |drawn| drawn.corners.len() <= 4);
    (drawn, prop::collection::vec(any::<u16>(), 60)).prop_map(|(drawn, order)| Withheld { drawn, order })
}

/// Whether an element goes on in the direction in which the one before it ends.
fn is_tangential(before: Option<&Real>, real: &Real) -> bool {
    before.is_some_and(|before| before.heading_at_end().distance(real.heading()) < 1e-9)
}

/// All that can be said of an element, each datum by itself.
fn data(real: &Real, is_last: bool) -> Vec<Words> {
    let mut all: Vec<Words> = Vec::new();
    let end = |p: DVec2| [format!("X{:+}", p.x), format!("Y{:+}", p.y)];
    if !is_last {
        all.extend(end(real.to).into_iter().map(|word| vec![word]));
    }
    if real.arc.is_some() {
        let centre = real.centre();
        all.push(vec![format!("R{}", real.radius())]);
        all.push(vec![format!("CCA{}", real.sweep())]);
        all.push(vec![format!("CCX{:+}", centre.x)]);
        all.push(vec![format!("CCY{:+}", centre.y)]);
    } else {
        let on = real.from + real.heading() * 23.0;
        all.push(vec![an(real.heading())]);
        all.push(vec![format!("LEN{}", real.length())]);
        all.push(vec![format!("P1X{:+}", on.x), format!("P1Y{:+}", on.y)]);
    }
    all
}

/// The program with the data that are given of each element.
fn text(reals: &[Real], given: &[Vec<Words>]) -> Text {
    let mut text = Text::default();
    for (i, real) in reals.iter().enumerate() {
        let before = i.checked_sub(1).map(|before| &reals[before]);
        let name = match (real.arc.is_some(), is_tangential(before, real)) {
            (false, false) => "FL",
            (false, true) => "FLT",
            (true, false) => "FC",
            (true, true) => "FCT",
        };
        let turn = if real.arc.is_some() { real.turn() } else { String::new() };
        text.element(name, format!("{turn} {}", given[i].concat().join(" ")));
    }
    text
}

laws! {
    #![proptest_config(config(6))]

    #[test]
    fn contours_come_out_of_just_enough_data(withheld in withheld()) {
        let reals: Vec<Real> = outline(&withheld.drawn).into_iter().flatten().collect();
        let mut left: Vec<(usize, Words)> = Vec::new();
        for (i, real) in reals.iter().enumerate() {
            left.extend(data(real, i + 1 == reals.len()).into_iter().map(|words| (i, words)));
        }
        let tangents = (1..reals.len()).filter(|i| is_tangential(Some(&reals[i - 1]), &reals[*i])).count();
        let unknown: usize = reals.iter().map(|real| if real.arc.is_some() { 3 } else { 2 }).sum();
        // The end of the last element is known.
        let needed = unknown - 2 - tangents;
        let mut given: Vec<Vec<Words>> = vec![Vec::new(); reals.len()];
        let mut order = withheld.order.iter();
        let mut next = |given: &mut Vec<Vec<Words>>| {
            let pick = order.next().map_or(0, |pick| usize::from(*pick));
            if left.is_empty() {
                return false;
            }
            let (i, words) = left.swap_remove(pick % left.len());
            given[i].push(words);
            true
        };
        for _ in 0..needed {
            next(&mut given);
        }
        // Data that depend on each other leave something open: one more then.
        let start = reals[0].from;
        while run(&text(&reals, &given).program(start, &[])).code == "free-contour-open" {
            prop_assert!(next(&mut given), "all data leave something open");
        }
        let text = text(&reals, &given);
        let mut others = Vec::new();
        let found = solutions(&text, &reals, &mut Vec::new(), &mut others);
        prop_assert_eq!(found, Ok(1), "{:?}\n{}", others, text.program(start, &[]));
    }
}

/// What searches have found.
mod found {
    use super::*;

    /// A short arc whose end and beginning are both open, between two lines that it touches: the other circle that touches
    /// them would have the contour turn back where the arc ends.
    #[test]
    fn a_short_arc_between_two_open_lines() {
        let program = "BEGIN PGM LAW MM\nTOOL CALL 1 Z S1000 F500\n99 L X+25 Y+0 R0 FMAX\n\
            100 FL  Y+17.67817736928878 CLSD+\n101 FL  AN-96.60528268248464 LEN51.0857781160461\n\
            102 FCT DR+ CCY-33.505896689543256\n103 FLT  AN+40.706092937924424 CLSD-\nEND PGM LAW MM\n";
        // The data were taken of the corners at 25 mm and 0 and 135 degrees (about) and 49.3 mm and 240 degrees.
        let at = |radius: f64, degrees: f64| {
            let (s, c) = degrees.to_radians().sin_cos();
            DVec2::new(c, s) * radius
        };
        let (second, third) = (at(25.0, 134.99835399767483), at(49.34559155670587, 240.0));
        let ran = run(program);
        assert_eq!(ran.code, "");
        let [first, line, arc, last] = ran.elements.as_slice() else { panic!("{:?}", ran.elements) };
        assert!(first.to.distance(second) < 1e-6, "{first:?}");
        // The arc touches both lines at the same distance from their corner.
        let far = third.distance(line.to);
        assert!(
            (third - line.to).perp_dot(third - second).abs() < 1e-6 * far
                && (far - third.distance(arc.to)).abs() < 1e-6
        );
        assert!(last.to.distance(DVec2::new(25.0, 0.0)) < 1e-6);
    }

    /// Of an arc the end, the radius and the angle are known, and of its beginning only the height: it lies a chord of
    /// 2 · 96.66905513846112 · sin 10° = 33.572811 from the end, so in two places, root of 33.572811² - 31.961996² = 10.274456 on
    /// either side of it.
    #[test]
    fn an_arc_that_begins_a_chord_from_its_end() {
        let program = |choice: &str| {
            format!(
                "BEGIN PGM LAW MM\nTOOL CALL 1 Z S1000 F500\n99 L X+25 Y+0 R0 FMAX\n\
                100 FC DR- Y+10.311360474278821 CCA20 CLSD+\n\
                101 FC DR+ X-12.50000000000001 CCA20 Y-21.65063509461096 R96.66905513846112\n{choice}\
                102 FL  P1X+7.4185842870420835 P1Y-10.150635094610966 CLSD-\nEND PGM LAW MM\n"
            )
        };
        assert_eq!(run(&program("")).code, "free-contour-several");
        let mut begins: Vec<f64> = (1..=2)
            .map(|choice| {
                let ran = run(&program(&format!("FSELECT {choice}\n")));
                assert_eq!(ran.code, "", "{choice}");
                ran.elements[1].from.x
            })
            .collect();
        begins.sort_by(f64::total_cmp);
        let chord = 2.0 * 96.669_055_138_461_12 * 10.0_f64.to_radians().sin();
        let half = (chord * chord - (10.311_360_474_278_821_f64 + 21.650_635_094_610_96).powi(2)).sqrt();
        assert!((begins[0] + 12.5 + half).abs() < 1e-6 && (begins[1] + 12.5 - half).abs() < 1e-6, "{begins:?}");
        assert_eq!(run(&program("FSELECT 3\n")).code, "free-contour-selection");
    }

    /// Two circles fit an arc of which only the height of its centre and that of its end are known; the second one is found
    /// from few of the places from which it is looked for.
    #[test]
    fn an_arc_that_few_places_lead_to() {
        let program = |choice: &str| {
            format!(
                "BEGIN PGM LAW MM\nTOOL CALL 1 Z S1000 F500\n99 L X+34.53695277375441 Y+4.300152958264283 R0 FMAX\n\
                100 FC DR+ CCY+17.367559843532725 Y+46.72705946320228 CLSD+\n101 FL  LEN70.74651587566518\n\
                102 FCT DR+ CCX+7.925666624380831 CCY-23.574059438514475 X+13.367656199651597\n103 FLT   CLSD-\n{choice}\
                END PGM LAW MM\n"
            )
        };
        assert_eq!(run(&program("")).code, "free-contour-several");
        let mut ends: Vec<f64> = ["FSELECT1\n", "FSELECT2\n"]
            .map(|choice| {
                let ran = run(&program(choice));
                assert_eq!(ran.code, "");
                ran.elements[0].to.x
            })
            .to_vec();
        ends.sort_by(f64::total_cmp);
        // One is that of the drawing.
        assert!((ends[0] + 2.3597088763565295).abs() < 1e-6 && (ends[1] - 18.211042125118254).abs() < 1e-6, "{ends:?}");
        assert_eq!(run(&program("FSELECT3\n")).code, "free-contour-selection");
    }
}
