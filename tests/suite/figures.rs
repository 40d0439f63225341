//! Figures: what they say is measured, and what they show can be read.
use std::sync::OnceLock;

use ciklo::base::data;
use ciklo::language::text::with_texts;
use ciklo::output::figure::{self, Medium, Svg};
use ciklo::spec::{Catalogue, Cycle};
use ciklo::tools::conform::World;

use crate::built::built;

type Files = Vec<(String, String)>;

/// The embedded files, that of a cycle altered.
fn files_with(cycle: u32, from: &str, to: &str) -> Files {
    let name = format!("/{cycle}-");
    let mut files: Files = data::embedded();
    let file = files.iter_mut().find(|(path, _)| path.starts_with("cycle-specs/") && path.contains(&name));
    let (path, text) = file.expect("the specification");
    assert!(text.contains(from), "{path}: {from}");
    *text = text.replacen(from, to, 1);
    files
}

/// The codes of what is wrong with the figures of a cycle after its file was altered.
fn altered(cycle: u32, from: &str, to: &str) -> Vec<&'static str> {
    let files = files_with(cycle, from, to);
    let (catalogue, found) = Catalogue::load(&files);
    assert!(found.is_empty(), "{found:?}");
    let world = World { catalogue: &catalogue, locales: &built().locales, files: &files };
    let chosen = |own: &Cycle| own.key.number == cycle;
    figure::check(&catalogue, &world, &chosen).into_iter().map(|found| found.code).collect()
}

/// The drawing of a figure of the TNC 640 in English, after the file of its cycle was altered.
fn redrawn(cycle: u32, from: &str, to: &str, stem: &str) -> String {
    let files = files_with(cycle, from, to);
    let (catalogue, found) = Catalogue::load(&files);
    assert!(found.is_empty(), "{found:?}");
    let world = World { catalogue: &catalogue, locales: &built().locales, files: &files };
    let on = catalogue.on("tnc640").expect("the control");
    let own = on.cycles.values().find(|own| own.key.number == cycle).expect("the cycle");
    let (figures, found) = figure::prepare(&world, on, own);
    assert!(found.is_empty(), "{found:?}");
    let figure = figures.iter().find(|figure| figure.stem(own) == stem).expect("the figure");
    let language = built().locales.language("en").expect("the language");
    let svg = with_texts(on, own, language, |text| figure.svg(text, Medium::Page)).expect("all texts are there");
    svg.text.rsplit("</desc>").next().unwrap_or_default().to_owned()
}

/// The outline of the tool, and the line of what is left of the blank: their data.
fn tool_and_surface(drawing: &str) -> [&str; 2] {
    ["<path class=\"t\" d=\"", "<path class=\"o\" d=\""].map(|begin| {
        let (_, after) = drawing.split_once(begin).expect("the path");
        after.split('"').next().unwrap_or_default()
    })
}

/// The numbers of the data of a path, in their order.
fn numbers(data: &str) -> Vec<f64> {
    let split = data.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'));
    split.filter(|part| !part.is_empty()).map(|part| part.parse().expect("a number")).collect()
}

/// Every figure of every cycle, in every language, with where it is from.
fn all() -> Vec<(String, Svg)> {
    let (catalogue, locales) = (&built().catalogue, &*built().locales);
    let world = World { catalogue, locales, files: &built().files };
    let mut drawn = Vec::new();
    for on in catalogue.controls.values() {
        for cycle in on.cycles.values() {
            let (figures, found) = figure::prepare(&world, on, cycle);
            assert!(found.is_empty(), "{} {found:?}", cycle.key);
            for language in locales.iter().filter(|_| !figures.is_empty()) {
                let svgs = with_texts(on, cycle, language, |text| {
                    figures
                        .iter()
                        .map(|figure| (figure.stem(cycle), figure.svg(text, Medium::Page)))
                        .collect::<Vec<_>>()
                });
                let place = format!("{} {}", on.id(), language.tag());
                let named = svgs.expect("all texts are there").into_iter();
                drawn.extend(named.map(|(stem, svg)| (format!("{place} {stem}"), svg)));
            }
        }
    }
    drawn
}

/// The same, drawn once for all tests.
fn drawn() -> &'static [(String, Svg)] {
    static DRAWN: OnceLock<Vec<(String, Svg)>> = OnceLock::new();
    DRAWN.get_or_init(all)
}

#[test]
fn figures_can_be_read() {
    let drawn = drawn();
    assert!(drawn.len() > 100, "{}", drawn.len());
    let mut wrong = Vec::new();
    for (name, svg) in drawn {
        for (n, a) in svg.texts.iter().enumerate() {
            let meets = |b: &&[f64; 4]| a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
            if let Some(b) = svg.texts.iter().skip(n + 1).find(meets) {
                wrong.push(format!("{name}: texts overlap at {a:?} and {b:?}"));
            }
        }
        if svg.text.len() > 16_000 {
            wrong.push(format!("{name}: {} bytes", svg.text.len()));
        }
        // What is drawn, without title and description.
        let drawing = svg.text.rsplit("</desc>").next().unwrap_or_default();
        for needless in [" id=", "<style", "NaN", "inf"] {
            if drawing.contains(needless) {
                wrong.push(format!("{name}: {needless}"));
            }
        }
        let count = |what: &str| svg.text.matches(what).count();
        if count("<g ") != count("</g>")
            || count("<a ") != count("</a>")
            || count("<title>") != 1
            || count("<desc>") != 1
        {
            wrong.push(format!("{name}: not well-formed"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_figure_comes_out_the_same_every_time() {
    let text = |(name, svg): &'_ (String, Svg)| (name.clone(), svg.text.clone());
    assert_eq!(drawn().iter().map(text).collect::<Vec<_>>(), all().iter().map(text).collect::<Vec<_>>());
}

#[test]
fn a_dimension_that_the_run_contradicts_is_an_error() {
    let clearance = "to: cut.to - dir * Q258}";
    assert_eq!(altered(205, clearance, clearance), Vec::<&str>::new());
    assert_eq!(altered(205, clearance, "to: cut.to - dir * (Q258 + 0.01)}"), ["figure-measured-otherwise"]);
    let shifted = "{q: Q258, from: cut.to + 0.25, to: cut.to + 0.25 - dir * Q258}";
    assert_eq!(altered(205, "{q: Q258, from: cut.to, to: cut.to - dir * Q258}", shifted), ["figure-place-not-reached"]);
}

#[test]
fn a_moment_that_never_comes_is_an_error() {
    let passes = "at: {step: retract-and-return-to-advanced-stop, pass: 2}}";
    assert_eq!(altered(205, passes, &passes.replace('2', "9")), ["figure-no-value"]);
    let of = "of: deepened-starting-point\n";
    assert_eq!(altered(205, of, "of: no-such-example\n"), ["figure-example-missing"]);
}

#[test]
fn two_figures_of_the_same_name_are_an_error() {
    // Both rows show the values 0 and 1: each of the second one would be written over one of the first.
    let found = altered(220, "name: between-holes", "name: traverse");
    assert_eq!(found, ["figure-name-taken", "figure-name-taken"]);
}

#[test]
fn a_clearance_is_shown_with_what_the_touch_probe_adds() {
    let sum = "{q: Q320, plus: set-up, ";
    assert_eq!(altered(419, sum, sum), Vec::<&str>::new());
    assert_eq!(altered(419, sum, "{q: Q320, "), ["figure-measured-otherwise"]);
}

#[test]
fn a_decrement_is_shown_with_the_infeed_that_it_makes_less() {
    let second = "{q: Q212, reduces: Q202, ";
    assert_eq!(altered(205, second, second), Vec::<&str>::new());
    assert_eq!(altered(205, second, "{q: Q212, "), ["figure-measured-otherwise"]);
    assert_eq!(altered(203, second, "{q: Q212, reduces: Q205, "), ["figure-measured-otherwise"]);
}

#[test]
fn a_choice_is_made_in_the_program_of_its_figure() {
    let built = crate::built::built();
    let world = World { catalogue: &built.catalogue, locales: &built.locales, files: &built.files };
    let on = built.catalogue.on("tnc640").expect("the control");
    let cycle = on.cycles.values().find(|cycle| cycle.name() == "cylinder-surface").expect("the cycle");
    let (figures, found) = figure::prepare(&world, on, cycle);
    assert!(found.is_empty(), "{found:?}");
    let language = built.locales.language("en").expect("the language");
    let drawn = |stem: &str| {
        let figure = figures.iter().find(|figure| figure.stem(cycle) == stem).expect("the figure");
        let svg = with_texts(on, cycle, language, |text| figure.svg(text, Medium::Page)).expect("all texts are there");
        svg.text.rsplit("</desc>").next().unwrap_or_default().to_owned()
    };
    // 90 degrees are a quarter of the cylinder, 90 mm on its radius of 36 are more.
    assert_ne!(drawn("27-around-cylinder-0"), drawn("27-around-cylinder-1"));
}

#[test]
fn a_new_datum_is_where_the_run_has_set_it() {
    let from = "{q: Q331, along: main, from: \"circle.centre - POINT(Q331, 0, 0)\", to: circle.centre}";
    let beside = from
        .replace("centre - POINT(Q331, 0, 0)\", to: circle.centre", "centre + POINT(Q331, 0, 0)\", to: circle.centre");
    assert_eq!(altered(412, from, &beside), ["figure-place-not-reached"]);
}

#[test]
fn contour_data_are_measured_in_the_run_that_reads_them() {
    let depth = "from: data.surface, to: data.surface + data.depth}";
    assert_eq!(altered(20, depth, &depth.replace("depth}", "depth / 2}")), ["figure-measured-otherwise"]);
    assert_eq!(altered(20, "run_of: 22", "run_of: 23"), ["figure-moment-never"]);
}

#[test]
fn a_transformation_is_measured_in_what_it_makes_of_the_program() {
    let turned = "ROT+60";
    assert_eq!(altered(10, turned, "ROT+45"), Vec::<&str>::new());
    assert_eq!(altered(10, "from: 0, to: angle}", "from: 0, to: angle + 1}"), ["figure-measured-otherwise"]);
}

#[test]
fn the_angle_of_a_plane_is_that_of_its_axes() {
    let about = "along: main, from: 0, to: angles.main}";
    assert_eq!(altered(19, about, about), Vec::<&str>::new());
    assert_eq!(altered(19, about, "along: main, from: 0, to: angles.main + 1}"), ["figure-place-not-reached"]);
    // The plane is not turned about the other axis.
    assert_eq!(altered(19, about, "along: minor, from: 0, to: angles.main}"), ["figure-place-not-reached"]);
    assert_eq!(altered(19, "A+30 B+0", "A+30 B+10"), ["figure-place-not-reached"]);
}

#[test]
fn a_boring_bar_cuts_where_its_edge_is() {
    let edge = "from: underside + Q249, to: underside + Q249 + Q252}";
    assert_eq!(altered(204, edge, edge), Vec::<&str>::new());
    assert_eq!(
        altered(204, edge, "from: underside + Q249 + 1, to: underside + Q249 + Q252 + 1}"),
        ["figure-place-not-reached"]
    );
}

#[test]
fn the_middle_of_a_hole_is_a_place_of_the_workpiece() {
    let middle = "to: circle.centre}";
    assert_eq!(altered(421, middle, middle), Vec::<&str>::new());
    assert_eq!(altered(421, middle, "to: \"circle.centre + POINT(0.5, 0, 0)\"}"), ["figure-measured-otherwise"]);
    let place = "{cylinder: {centre: [52, 55], diameter: 50";
    assert_eq!(altered(421, place, "{cylinder: {centre: [51, 55], diameter: 50").len(), 1);
}

#[test]
fn the_end_of_a_cutter_is_drawn_as_its_corner_radius_says() {
    // The slot of 253 by a cutter of radius 4: flat, with corners of 1 mm, and as a ball.
    let given =
        "given: {Q201: -20, Q202: 5, Q203: 10, Q200: 2, Q204: 50, Q206: 150, Q366: 0, Q367: 1, Q218: 80, Q219: 12";
    let flat = format!("{given}, Q374: 90}}\n    scene:\n      tools: [{{T: 1, NAME: MILL, L: 80, R: 4}}]");
    let drawn = |r2: &str| redrawn(253, &flat, &flat.replace("R: 4}", &format!("R: 4, R2: {r2}}}")), "253-section");
    let (plain, bull, ball) = (drawn("0"), drawn("1"), drawn("4"));
    assert!(!tool_and_surface(&plain)[0].contains('A'));
    // M left floor L right floor A r r 0 0 0 side shoulder …: so many mm are 4 - 1 of 4, and no way along the floor.
    for (drawing, corner) in [(&bull, 1.0), (&ball, 4.0)] {
        let [tool, surface] = tool_and_surface(drawing);
        assert_eq!(tool.matches('A').count(), 2, "{tool}");
        let begin = numbers(tool.split('A').next().unwrap_or_default());
        let arc = numbers(tool.split('A').nth(1).unwrap_or_default());
        let (right, floor) = (begin[begin.len() - 2], begin[begin.len() - 1]);
        let (radius, side, shoulder) = (arc[0], arc[5], arc[6]);
        assert!((side - right - radius).abs() < 0.15 && (floor - shoulder - radius).abs() < 0.15, "{tool}");
        let half = side - (begin[0] + right) / 2.0;
        assert!((radius / half - corner / 4.0).abs() < 0.01, "{tool}");
        // The floor that is left is as deep as the tool, and as round where it ends.
        let (before, after) = (tool_and_surface(&plain)[1], surface);
        let deepest = |data: &str| numbers(data).chunks(2).map(|place| place[1]).fold(0.0, f64::max);
        assert_eq!(deepest(before), deepest(after));
        let at_floor = |data: &str| {
            let places = numbers(data);
            let low = places.chunks(2).filter(|place| (place[1] - floor).abs() < 0.15).map(|place| place[0]);
            low.fold((f64::MAX, f64::MIN), |(least, greatest), x| (least.min(x), greatest.max(x)))
        };
        let ((l, r), (own_l, own_r)) = (at_floor(before), at_floor(after));
        // Near the floor the arc is as good as flat.
        let near = 0.25 * radius + 0.2;
        assert!((own_l - l - radius).abs() < near && (r - own_r - radius).abs() < near, "{before}\n{after}");
    }
}
