//! Free contours: closed outlines of lines and arcs, tangential or not, of which a program tells only what determines
//! them, element by element or with the elements that follow, must come out as they are.
//!
//! Where the data leave several contours, the run says so, and exactly one of the selections gives the outline.
use ciklo::base::diag::Source;
use ciklo::engine::run::{Engine, EventKind, NoTexts, Status};
use ciklo::engine::scene::Scene;
use ciklo::engine::solid::Path;
use ciklo::program::syntax;
use glam::DVec2;
use proptest::prelude::*;

use super::path::config;
use crate::built::{Built, built};

/// What a point of the outline may be wrong, mm.
const EXACT: f64 = 1e-9;
/// The pole of polar data.
const POLE: DVec2 = DVec2::new(3.0, -2.0);
/// More selections than that belong to no program here.
const MOST_SELECTIONS: usize = 8;

/// An element of an outline: an arc has a centre and a signed angle in radians.
#[derive(Clone, Copy, Debug)]
pub(super) struct Real {
    pub(super) from: DVec2,
    pub(super) to: DVec2,
    pub(super) arc: Option<(DVec2, f64)>,
}

/// What is drawn.
#[derive(Clone, Debug)]
pub(super) struct Drawn {
    /// Of each corner: its angle and radius about the origin.
    pub(super) corners: Vec<(f64, f64)>,
    /// Of each edge: the angle of its arc in degrees, 0 for a line.
    edges: Vec<f64>,
    /// Of each corner: the share of the room that its rounding takes, if it is rounded.
    rounded: Vec<Option<f64>>,
    /// Which data are given.
    pub(super) given: Vec<u8>,
}

pub(super) fn drawn() -> impl Strategy<Value = Drawn> {
    let edge = prop_oneof![3 => Just(0.0), 1 => 20.0..150.0_f64, 1 => -150.0..-20.0_f64];
    let round = prop_oneof![1 => Just(None), 1 => (0.2..0.9_f64).prop_map(Some)];
    (3_usize..8).prop_flat_map(move |n| {
        let corner = (-0.3..0.3_f64, 25.0..60.0_f64);
        let all = |n| prop::collection::vec(any::<u8>(), n);
        (
            prop::collection::vec(corner, n),
            prop::collection::vec(edge.clone(), n),
            prop::collection::vec(round.clone(), n),
            all(3 * n),
        )
            .prop_map(move |(corners, edges, rounded, given)| {
                let step = 360.0 / n as f64;
                let placed = |(i, (jitter, radius)): (usize, (f64, f64))| ((i as f64 + jitter) * step, radius);
                Drawn { corners: corners.into_iter().enumerate().map(placed).collect(), edges, rounded, given }
            })
    })
}

fn unit(degrees: f64) -> DVec2 {
    let (s, c) = degrees.to_radians().sin_cos();
    DVec2::new(c, s)
}

pub(super) fn angle(v: DVec2) -> f64 {
    v.y.atan2(v.x).to_degrees()
}

impl Real {
    pub(super) fn heading(&self) -> DVec2 {
        match self.arc {
            None => (self.to - self.from).normalize(),
            Some((centre, sweep)) => (self.from - centre).perp().normalize() * sweep.signum(),
        }
    }

    pub(super) fn heading_at_end(&self) -> DVec2 {
        match self.arc {
            None => self.heading(),
            Some((centre, sweep)) => (self.to - centre).perp().normalize() * sweep.signum(),
        }
    }

    pub(super) fn length(&self) -> f64 {
        self.from.distance(self.to)
    }

    pub(super) fn radius(&self) -> f64 {
        self.arc.map_or(0.0, |(centre, _)| centre.distance(self.from))
    }

    pub(super) fn turn(&self) -> String {
        let sweep = self.arc.map_or(0.0, |(_, sweep)| sweep);
        format!("DR{}", if sweep > 0.0 { '+' } else { '-' })
    }

    pub(super) fn sweep(&self) -> f64 {
        self.arc.map_or(0.0, |(_, sweep)| sweep.to_degrees().abs())
    }

    pub(super) fn centre(&self) -> DVec2 {
        self.arc.map_or(DVec2::ZERO, |(centre, _)| centre)
    }
}

/// The outline in groups: one element, or the two lines of a rounded corner with its arc.
pub(super) fn outline(drawn: &Drawn) -> Vec<Vec<Real>> {
    let n = drawn.corners.len();
    let corner = |i: usize| {
        let (degrees, radius) = drawn.corners[i % n];
        unit(degrees) * radius
    };
    let mut groups = Vec::new();
    let mut i = 0;
    while i < n {
        let (a, b, c) = (corner(i), corner(i + 1), corner(i + 2));
        let straight = |edge: usize| drawn.edges.get(edge) == Some(&0.0);
        if let (Some(share), true) = (drawn.rounded[i], straight(i) && straight(i + 1)) {
            let (u, v) = ((b - a).normalize(), (c - b).normalize());
            let turn = u.perp_dot(v).atan2(u.dot(v));
            // Corners that are nearly none, and very sharp ones, are left as they are.
            if (0.2..2.6).contains(&turn.abs()) {
                let cut = share * a.distance(b).min(b.distance(c)) * 0.8;
                let (from, to) = (b - u * cut, b + v * cut);
                let radius = cut / (turn.abs() / 2.0).tan();
                let centre = from + u.perp() * (radius * turn.signum());
                let line = |from, to| Real { from, to, arc: None };
                groups.push(vec![line(a, from), Real { from, to, arc: Some((centre, turn)) }, line(to, c)]);
                i += 2;
                continue;
            }
        }
        let sweep = drawn.edges[i].to_radians();
        let arc = (sweep != 0.0).then(|| {
            // A counter-clockwise arc has its centre to the left.
            let height = a.distance(b) / 2.0 / (sweep / 2.0).tan();
            ((a + b) / 2.0 + (b - a).normalize().perp() * height, sweep)
        });
        groups.push(vec![Real { from: a, to: b, arc }]);
        i += 1;
    }
    groups
}

/// The blocks of a program; each element is one, with its number in the outline.
#[derive(Clone, Debug, Default)]
pub(super) struct Text {
    pub(super) blocks: Vec<(String, Option<usize>)>,
    /// Where the first element ends.
    first: DVec2,
}

fn xy(p: DVec2) -> String {
    format!("X{:+} Y{:+}", p.x, p.y)
}

/// The coordinate that crosses the line better.
fn one(p: DVec2, along: DVec2) -> String {
    if along.x.abs() > along.y.abs() { format!("X{:+}", p.x) } else { format!("Y{:+}", p.y) }
}

pub(super) fn an(v: DVec2) -> String {
    format!("AN{:+}", angle(v))
}

/// A point beside a line, its distance, and the direction of the line.
fn beside(real: &Real) -> String {
    let at = (real.from + real.to) / 2.0 + real.heading().perp() * 7.5;
    format!("PDX{:+} PDY{:+} D7.5", at.x, at.y)
}

impl Text {
    pub(super) fn element(&mut self, name: &str, words: String) {
        let number = self.blocks.iter().filter(|(_, own)| own.is_some()).count();
        self.blocks.push((format!("{name} {words}"), Some(number)));
    }

    /// The pole; a contour may have several.
    fn pole(&mut self, at: DVec2) {
        self.blocks.push((format!("FPOL {}", xy(at)), None));
    }

    fn number_of(&self, element: usize) -> usize {
        100 + self.blocks.iter().position(|(_, own)| *own == Some(element)).expect("an element")
    }

    /// A line whose beginning is known.
    fn line(&mut self, real: &Real, before: Option<&Real>, given: u8) {
        let (u, length, way) = (real.heading(), real.length(), real.to - real.from);
        let polar = real.to - POLE;
        let elements = self.blocks.iter().filter(|(_, own)| own.is_some()).count();
        let words = match (given % 11, before) {
            (0, _) => xy(real.to),
            (1, _) => format!("{} LEN{length}", an(u)),
            (2, _) => format!("{} {}", an(u), one(real.to, u)),
            (3, _) => {
                self.pole(POLE);
                format!("PR{:+} PA{:+}", polar.length(), angle(polar))
            }
            (4, _) => format!("IX{:+} IY{:+}", way.x, way.y),
            (5, Some(before)) => {
                let turned = angle(u) - angle(before.heading_at_end());
                format!("IAN{turned:+} LEN{length}")
            }
            // Two circles and lines meet twice, unless they touch.
            (6, _) if u.x.abs() < 0.9 => format!("LEN{length} X{:+}", real.to.x),
            (7, _) => {
                let on = real.from + u * 33.0;
                format!("P1X{:+} P1Y{:+} {}", on.x, on.y, one(real.to, u))
            }
            (8, Some(_)) => {
                let (first, far) = (self.number_of(0), real.to);
                let from = self.first;
                format!("IX{:+} RX{first} IY{:+} RY{first}", far.x - from.x, far.y - from.y)
            }
            (9, Some(before)) => {
                let turned = angle(u) - angle(before.heading_at_end());
                format!("IAN{turned:+} RAN{} {}", self.number_of(elements - 1), one(real.to, u))
            }
            (10, _) => format!("{} PR{:+}", an(u), (real.to - POLE).length()),
            _ => xy(real.to),
        };
        if given % 11 == 10 {
            self.pole(POLE);
        }
        self.element("FL", words);
    }

    /// An arc whose beginning is known.
    fn arc(&mut self, real: &Real, given: u8) {
        let (centre, radius, turn, sweep) = (real.centre(), real.radius(), real.turn(), real.sweep());
        let arm = centre - real.from;
        let polar = centre - POLE;
        let cc = |p: DVec2| format!("CCX{:+} CCY{:+}", p.x, p.y);
        let words = match given % 10 {
            0 => format!("{turn} {} {}", cc(centre), xy(real.to)),
            1 => format!("{turn} {} CCA{sweep}", cc(centre)),
            2 => format!("{turn} R{radius} {}", xy(real.to)),
            3 => format!("{turn} R{radius} {} CCA{sweep}", an(real.heading())),
            4 => {
                self.pole(centre);
                format!("{turn} {} PA{:+}", cc(centre), angle(real.to - centre))
            }
            5 => format!("{turn} {} {}", an(real.heading()), xy(real.to)),
            6 => format!("{turn} ICCX{:+} ICCY{:+} CCA{sweep}", arm.x, arm.y),
            7 => {
                self.pole(POLE);
                format!("{turn} CCPR{} CCPA{:+} CCA{sweep}", polar.length(), angle(polar))
            }
            8 => format!("{turn} {} CCA{sweep}", xy(real.to)),
            _ => format!("{turn} R{radius} {} LEN{}", an(real.heading()), real.length()),
        };
        self.element("FC", words);
    }

    /// A line, an arc tangential to it and a line tangential to that.
    fn rounded(&mut self, [a, arc, b]: [&Real; 3], given: u8) {
        let (u, v, turn, radius) = (a.heading(), b.heading(), arc.turn(), arc.radius());
        let centre = arc.centre();
        match given % 6 {
            0 => {
                self.element("FL", an(u));
                self.element("FCT", format!("{turn} R{radius}"));
                self.element("FLT", format!("{} {}", an(v), xy(b.to)));
            }
            1 => {
                self.element("FL", format!("{} LEN{}", an(u), a.length()));
                self.element("FCT", format!("{turn} R{radius} CCA{}", arc.sweep()));
                self.element("FLT", format!("LEN{}", b.length()));
            }
            2 => {
                self.element("FL", xy(a.to));
                self.element("FCT", format!("{turn} {}", xy(arc.to)));
                self.element("FLT", one(b.to, v));
            }
            3 => {
                self.element("FL", String::new());
                self.element("FCT", format!("{turn} R{radius} CCX{:+} CCY{:+}", centre.x, centre.y));
                self.element("FLT", xy(b.to));
            }
            4 => {
                self.element("FL", an(u));
                self.element("FCT", format!("{turn} R{radius}"));
                self.element("FLT", format!("{} {} {}", an(v), beside(b), one(b.to, v)));
            }
            _ => {
                // The arc is known by its angle, whose place the line after it gives.
                self.element("FL", an(u));
                self.element("FCT", format!("{turn} R{radius} CCA{}", arc.sweep()));
                self.element("FLT", xy(b.to));
            }
        }
    }

    /// Two elements that meet in a point of which nothing is told: both are known by themselves.
    fn meeting(&mut self, a: &Real, b: &Real) {
        for (real, end) in [(a, String::new()), (b, xy(b.to))] {
            if real.arc.is_some() {
                let centre = real.centre();
                let words = format!("{} R{} CCX{:+} CCY{:+} {end}", real.turn(), real.radius(), centre.x, centre.y);
                self.element("FC", words);
            } else {
                self.element("FL", format!("{} {end}", an(real.heading())));
            }
        }
    }

    /// The last element ends where the contour began.
    fn closing(&mut self, real: &Real, given: u8) {
        let turn = real.turn();
        match (real.arc.is_some(), given % 3) {
            (false, 0) => self.element("FL", String::new()),
            (false, _) => self.element("FL", an(real.heading())),
            (true, 0) => self.element("FC", format!("{turn} R{}", real.radius())),
            (true, 1) => self.element("FC", format!("{turn} CCA{}", real.sweep())),
            (true, _) => {
                self.element("FC", format!("R{} CCX{:+} CCY{:+}", real.radius(), real.centre().x, real.centre().y))
            }
        }
    }

    /// The program, with selections after blocks.
    pub(super) fn program(&self, start: DVec2, selected: &[(usize, usize)]) -> String {
        let mut text = format!("BEGIN PGM LAW MM\nTOOL CALL 1 Z S1000 F500\n99 L {} R0 FMAX\n", xy(start));
        let last = self.blocks.iter().rposition(|(_, own)| own.is_some());
        for (index, (block, own)) in self.blocks.iter().enumerate() {
            let closing = match own {
                Some(0) => " CLSD+",
                Some(_) if Some(index) == last => " CLSD-",
                _ => "",
            };
            text += &format!("{} {block}{closing}\n", 100 + index);
            for (_, number) in selected.iter().filter(|(after, _)| *after == index) {
                text += &format!("FSELECT {number}\n");
            }
        }
        text + "END PGM LAW MM\n"
    }
}

fn told(groups: &[Vec<Real>], given: &[u8]) -> Text {
    let mut text = Text::default();
    let mut before: Option<Real> = None;
    let mut given = given.iter().copied();
    text.first = groups[0][0].to;
    let mut rest = groups;
    while let [group, after @ ..] = rest {
        let choice = given.next().unwrap_or_default();
        rest = after;
        match (group.as_slice(), after) {
            ([a], [next, further @ ..]) if choice >= 192 && next.len() == 1 && !bends_little(a, &next[0]) => {
                text.meeting(a, &next[0]);
                before = Some(next[0]);
                rest = further;
                continue;
            }
            ([real], []) if choice >= 128 => text.closing(real, choice),
            _ => text.group(group, before.as_ref(), choice),
        }
        before = group.last().copied();
    }
    text
}

/// Elements that meet at a flat angle meet where a rounding error of their data says.
fn bends_little(a: &Real, b: &Real) -> bool {
    a.heading_at_end().perp_dot(b.heading()).abs() < 0.2
}

impl Text {
    fn group(&mut self, group: &[Real], before: Option<&Real>, choice: u8) {
        match group {
            [a, arc, b] => self.rounded([a, arc, b], choice),
            [real] if real.arc.is_some() => self.arc(real, choice),
            [real] => self.line(real, before, choice),
            _ => {}
        }
    }
}

/// How a run ended: the code of its fault, its line, and the elements.
pub(super) struct Ran {
    pub(super) code: String,
    line: Option<usize>,
    pub(super) elements: Vec<Real>,
}

pub(super) fn run(program: &str) -> Ran {
    let Built { files, catalogue, .. } = built();
    let scene = "scene: 1\ntools: [{T: 1, L: 100, R: 5}]\nstart: [0, 0, 100]\n";
    let scene = Scene::parse(&Source::new("scene.yaml", scene), files).expect("a scene");
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let on = catalogue.on("tnc640").expect("a control");
    let mut elements = Vec::new();
    let outcome = Engine::new(&tree, on, &scene, &NoTexts).with_catalogue(catalogue).run(&mut |event| {
        let EventKind::Move { path, .. } = &event.kind else { return };
        let arc = match path {
            Path::Line { .. } => None,
            Path::Arc { centre, axis, sweep, .. } => Some((centre.truncate(), sweep.to_radians() * axis.z)),
        };
        elements.push(Real { from: path.at(0.0).truncate(), to: path.at(1.0).truncate(), arc });
    });
    let place = outcome.diagnostic.as_ref().and_then(|diagnostic| diagnostic.place.as_ref());
    let line = place.map(|place| place.start().line);
    let code = match (&outcome.fault, outcome.status) {
        (Some(fault), _) => fault.code.to_string(),
        (None, Status::Done) => String::new(),
        (None, status) => format!("{status:?}"),
    };
    // The first way leads to where the contour begins.
    Ran { code, line, elements: elements.split_off(1.min(elements.len())) }
}

fn same(found: &[Real], wanted: &[Real]) -> Result<(), String> {
    if found.len() != wanted.len() {
        return Err(format!("{} elements, not {}", found.len(), wanted.len()));
    }
    for (index, (a, b)) in found.iter().zip(wanted).enumerate() {
        let arcs = match (a.arc, b.arc) {
            (None, None) => 0.0,
            (Some((m, s)), Some((n, t))) => m.distance(n).max((s - t).abs()),
            _ => f64::INFINITY,
        };
        let off = a.from.distance(b.from).max(a.to.distance(b.to)).max(arcs);
        if off > EXACT {
            return Err(format!("element {index} is off by {off}: {a:?}, not {b:?}"));
        }
    }
    Ok(())
}

/// How many selections give the outline; what else came out.
pub(super) fn solutions(
    text: &Text,
    wanted: &[Real],
    selected: &mut Vec<(usize, usize)>,
    others: &mut Vec<String>,
) -> Result<usize, String> {
    let program = text.program(wanted[0].from, selected);
    let ran = run(&program);
    match ran.code.as_str() {
        "" => match same(&ran.elements, wanted) {
            Ok(()) => Ok(1),
            Err(why) => {
                others.push(why);
                Ok(0)
            }
        },
        "free-contour-several" if selected.len() < MOST_SELECTIONS => {
            let line = ran.line.ok_or("a fault without a place")?;
            let named = program.lines().nth(line - 1).ok_or("no such line")?;
            let number = named.split(' ').next().and_then(|number| number.parse::<usize>().ok());
            let after = number.and_then(|number| number.checked_sub(100)).ok_or_else(|| format!("at {named}"))?;
            let mut found = 0;
            for choice in 1.. {
                selected.push((after, choice));
                let before = others.len();
                let own = solutions(text, wanted, selected, others)?;
                selected.pop();
                found += own;
                if others.get(before).is_some_and(|code| code == "free-contour-selection") {
                    break;
                }
            }
            Ok(found)
        }
        code => {
            others.push(code.to_owned());
            Ok(0)
        }
    }
}

laws! {
    #![proptest_config(config(50))]

    #[test]
    fn free_contours_come_out_as_they_are(drawn in drawn()) {
        let groups = outline(&drawn);
        let wanted: Vec<Real> = groups.iter().flatten().copied().collect();
        let text = told(&groups, &drawn.given);
        let mut others = Vec::new();
        let found = solutions(&text, &wanted, &mut Vec::new(), &mut others);
        let program = text.program(wanted[0].from, &[]);
        prop_assert_eq!(found, Ok(1), "{:?}\n{}", others, program);
    }
}
