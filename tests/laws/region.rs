//! Laws of regions: what belongs to a union, a difference, an intersection, a shrunk and a grown region is asked point
//! by point, of the contours themselves, which are given as functions here and not as lines.
use ciklo::engine::region::relief::Relief;
use ciklo::engine::region::{Boundary, Edge, Flaw, Nearest, Region, Way, clearing, formula};
use glam::DVec2;
use proptest::prelude::*;

use crate::cases;

/// Points so near to a boundary (mm) are not asked about.
const RIM: f64 = 1e-4;

/// A star of lines about a centre, with a corner at each angle; or a circle, where it has one radius only.
#[derive(Clone, Debug)]
struct Star {
    centre: DVec2,
    radii: Vec<f64>,
}

impl Star {
    fn corner(&self, n: usize) -> DVec2 {
        let angle = std::f64::consts::TAU * n as f64 / self.radii.len() as f64;
        self.centre + DVec2::new(angle.cos(), angle.sin()) * self.radii[n % self.radii.len()]
    }

    fn boundary(&self) -> Boundary {
        let start = self.corner(0);
        let edges: Vec<Edge> = match self.radii.len() {
            1 => vec![Edge::Arc { to: start, centre: self.centre, sweep: -360.0 }],
            count => (1..=count).map(|n| Edge::Line(self.corner(n % count))).collect(),
        };
        Boundary::new(start, &edges, 0.0).expect("a star")
    }

    /// How far inside (mm, outside negative), with the exact distance to the boundary.
    fn depth(&self, at: DVec2) -> f64 {
        let count = self.radii.len();
        if count == 1 {
            return self.radii[0] - at.distance(self.centre);
        }
        let (mut inside, mut distance) = (false, f64::INFINITY);
        for n in 0..count {
            let (a, b) = (self.corner(n), self.corner((n + 1) % count));
            if (a.y > at.y) != (b.y > at.y) && at.x < (b.x - a.x) * (at.y - a.y) / (b.y - a.y) + a.x {
                inside = !inside;
            }
            let along = ((at - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            distance = distance.min(at.distance(a.lerp(b, along)));
        }
        if inside { distance } else { -distance }
    }
}

fn star() -> impl Strategy<Value = Star> {
    let centre = (-40.0..40.0f64, -40.0..40.0f64).prop_map(|(x, y)| DVec2::new(x, y));
    let radii = prop_oneof![
        1 => prop::collection::vec(3.0..40.0f64, 1),
        4 => prop::collection::vec(3.0..40.0f64, 3..40),
    ];
    (centre, radii).prop_map(|(centre, radii)| Star { centre, radii })
}

fn points() -> impl Iterator<Item = DVec2> {
    // A grid that no corner of a star is likely to lie on.
    (0..60).flat_map(|x| (0..60).map(move |y| DVec2::new(-88.3 + 2.97 * f64::from(x), -88.7 + 3.01 * f64::from(y))))
}

/// A region of several stars, with the same as a function: + adds, - takes away, & keeps what is common.
fn built(first: &Star, rest: &[(char, Star)]) -> Region {
    rest.iter().fold(Region::within(&first.boundary()), |region, (how, star)| {
        let other = Region::within(&star.boundary());
        match how {
            '+' => region.union(&other),
            '-' => region.difference(&other),
            _ => region.intersection(&other),
        }
    })
}

fn belongs(first: &Star, rest: &[(char, Star)], at: DVec2) -> bool {
    rest.iter().fold(first.depth(at) > 0.0, |inside, (how, star)| {
        let other = star.depth(at) > 0.0;
        match how {
            '+' => inside || other,
            '-' => inside && !other,
            _ => inside && other,
        }
    })
}

fn is_near_a_rim(first: &Star, rest: &[(char, Star)], at: DVec2) -> bool {
    std::iter::once(first).chain(rest.iter().map(|(_, star)| star)).any(|star| star.depth(at).abs() < RIM)
}

fn others() -> impl Strategy<Value = Vec<(char, Star)>> {
    let how = prop_oneof![5 => Just('+'), 5 => Just('-'), 1 => Just('&')];
    prop::collection::vec((how, star()), 0..7)
}

/// The milling depth of contours without one of their own.
const WHOLE: f64 = 20.0;

/// What contours with depths are at a point: how deep it is machined, and from where on it stays where they are islands.
#[derive(Clone, Copy, Debug)]
struct There {
    pocket: f64,
    island: f64,
}

impl There {
    fn of(star: &Star, depth: Option<f64>, at: DVec2) -> Self {
        if star.depth(at) > 0.0 {
            Self { pocket: depth.unwrap_or(f64::INFINITY), island: depth.unwrap_or(0.0) }
        } else {
            Self { pocket: 0.0, island: f64::INFINITY }
        }
    }

    fn joined(self, operator: char, other: Self) -> Self {
        let covers = |own: Self| own.pocket > 0.0 || own.island.is_finite();
        match operator {
            '|' => Self { pocket: self.pocket.max(other.pocket), island: self.island.min(other.island) },
            '&' => Self { pocket: self.pocket.min(other.pocket), island: self.island.max(other.island) },
            '^' if covers(self) && covers(other) => Self { pocket: 0.0, island: f64::INFINITY },
            '^' => self.joined('|', other),
            _ => Self { pocket: self.pocket.min(other.island), island: self.island.max(other.pocket) },
        }
    }
}

/// Two groups of contours, each with an own depth or none and with the sign before it, and the sign between the groups.
#[derive(Clone, Debug)]
struct Formula {
    groups: [Vec<(char, Star, Option<f64>)>; 2],
    between: char,
}

impl Formula {
    fn text(&self) -> String {
        let mut number = 0;
        let mut groups = self.groups.iter().map(|group| {
            group.iter().fold(String::new(), |text, (sign, ..)| {
                number += 1;
                if text.is_empty() { format!("QC{number}") } else { format!("{text} {sign} QC{number}") }
            })
        });
        let (first, second) = (groups.next().unwrap_or_default(), groups.next().unwrap_or_default());
        format!("( {first} ) {} ( {second} )", self.between)
    }

    fn relief(&self, number: u32) -> Option<Relief> {
        let (_, star, depth) = self.groups.iter().flatten().nth(number as usize - 1)?;
        Some(Relief::new(Region::within(&star.boundary()), star.radii.len(), *depth))
    }

    fn at(&self, at: DVec2) -> f64 {
        let of = |group: &[(char, Star, Option<f64>)]| {
            let there = group.iter().map(|(sign, star, depth)| (*sign, There::of(star, *depth, at)));
            there.reduce(|(_, before), (sign, own)| (sign, before.joined(sign, own))).expect("a contour").1
        };
        of(&self.groups[0]).joined(self.between, of(&self.groups[1])).pocket.min(WHOLE)
    }
}

fn formulas() -> impl Strategy<Value = Formula> {
    let sign = || prop_oneof![4 => Just('|'), 4 => Just('\\'), 1 => Just('&'), 1 => Just('^')];
    let depth = prop_oneof![2 => Just(None), 3 => (1..7u32).prop_map(|third| Some(f64::from(third) * 3.0))];
    let group = move || prop::collection::vec((sign(), star(), depth.clone()), 1..4);
    (group(), sign(), group()).prop_map(|(first, between, second)| Formula { groups: [first, second], between })
}

laws! {
    #![proptest_config(cases::config(50))]

    #[test]
    fn an_index_finds_the_point_that_a_look_at_all_finds(first in star(), rest in others()) {
        let region = built(&first, &rest);
        let near = Nearest::of(&region);
        for at in points().step_by(7) {
            let (own, all) = (near.nearest(at), region.nearest(at));
            prop_assert_eq!(own.is_some(), all.is_some());
            if let (Some((p, far)), Some((q, other))) = (own, all) {
                prop_assert!((far - other).abs() < 1e-9 && p.distance(q) < 1e-6, "{p} and {q} from {at}");
            }
        }
    }

    #[test]
    fn contours_with_depths_are_machined_as_deep_as_their_formula_says(own in formulas()) {
        let relief = formula::evaluate(&own.text(), |number| own.relief(number)).expect("a formula");
        let bands = relief.bands(WHOLE);
        prop_assert!(bands.first().is_none_or(|band| band.from == 0.0));
        prop_assert!(bands.windows(2).all(|two| two[0].to == two[1].from));
        let stars = || own.groups.iter().flatten().map(|(_, star, _)| star);
        for at in points().filter(|at| !stars().any(|star| star.depth(*at).abs() < RIM)) {
            let inside: Vec<bool> = bands.iter().map(|band| band.region.contains(at)).collect();
            let count = inside.iter().take_while(|inside| **inside).count();
            prop_assert!(inside[count..].iter().all(|inside| !inside), "{} at {}", own.text(), at);
            let depth = count.checked_sub(1).map_or(0.0, |last| bands[last].to);
            prop_assert_eq!(depth, own.at(at), "{} at {}", own.text(), at);
        }
    }

    #[test]
    fn regions_hold_what_their_contours_say(first in star(), rest in others()) {
        let region = built(&first, &rest);
        for at in points().filter(|at| !is_near_a_rim(&first, &rest, *at)) {
            prop_assert_eq!(region.contains(at), belongs(&first, &rest, at), "at {}", at);
        }
        // The parts do not overlap, and together they are the whole.
        let parts: f64 = region.parts().map(|part| part.area()).sum();
        prop_assert!((parts - region.area()).abs() < 1e-6);
        for boundary in region.boundaries() {
            // Corners may touch other corners, but every boundary ends where it begins.
            let again = Boundary::new(boundary.start(), &boundary.edges(), 1e-6);
            prop_assert!(!matches!(again, Err(Flaw::Open { .. } | Flaw::NoArea)), "{:?}", again);
        }
    }

    #[test]
    fn a_cutter_in_a_shrunk_region_stays_inside(first in star(), rest in others(), radius in 0.3..8.0f64) {
        let region = built(&first, &rest);
        let centres = region.shrunk(radius);
        for at in points() {
            let Some((_, distance)) = region.nearest(at) else { continue };
            if (distance - radius).abs() < RIM || distance < RIM {
                continue;
            }
            let expected = region.contains(at) && distance > radius;
            prop_assert_eq!(centres.contains(at), expected, "at {}: {} from the boundary", at, distance);
        }
        // All of its boundary keeps exactly that distance.
        for boundary in centres.boundaries() {
            for edge in boundary.edges() {
                let distance = region.nearest(edge.to()).map_or(0.0, |(_, distance)| distance);
                prop_assert!((distance - radius).abs() < 1e-5, "{} instead of {}", distance, radius);
            }
        }
    }

    #[test]
    fn a_grown_region_has_all_that_is_near(first in star(), rest in others(), by in 0.3..8.0f64) {
        let region = built(&first, &rest);
        let grown = region.grown(by);
        for at in points() {
            let Some((_, distance)) = region.nearest(at) else { continue };
            if (distance - by).abs() < RIM || distance < RIM {
                continue;
            }
            let expected = region.contains(at) || distance < by;
            prop_assert_eq!(grown.contains(at), expected, "at {}: {} from the boundary", at, distance);
        }
    }
}

/// Points of an edge, no farther from each other than 0.2 mm, and how far they lie from the edge at most.
fn samples(from: DVec2, edge: &Edge) -> Vec<DVec2> {
    let count = (edge.length(from) / 0.2).ceil().max(1.0) as u32;
    let at = |n: u32| {
        let share = f64::from(n) / f64::from(count);
        match *edge {
            Edge::Line(to) => from.lerp(to, share),
            Edge::Arc { centre, sweep, .. } => {
                let (sin, cos) = (sweep * share).to_radians().sin_cos();
                let arm = from - centre;
                centre + DVec2::new(arm.x * cos - arm.y * sin, arm.x * sin + arm.y * cos)
            }
        }
    };
    (0..=count).map(at).collect()
}

laws! {
    #![proptest_config(cases::config(30))]

    #[test]
    fn clearing_reaches_all_that_the_cutter_can_reach_and_nothing_else(
        first in star(), rest in others(), radius in 0.8..6.0f64, overlap in 0.2..1.0f64, left in any::<bool>(),
    ) {
        let centres = built(&first, &rest).shrunk(radius);
        let paths = clearing::paths(&centres, overlap * radius, left, DVec2::ZERO).expect("few rings");
        prop_assert_eq!(paths.len(), centres.parts().count());
        let mut reached: Vec<DVec2> = Vec::new();
        for path in &paths {
            let mut at = path.start;
            for edge in &path.edges {
                if let Edge::Arc { to, centre, .. } = edge {
                    prop_assert!((at.distance(*centre) - to.distance(*centre)).abs() < 1e-6, "{:?}", edge);
                    let end = samples(at, edge).pop().unwrap_or(at);
                    prop_assert!(end.distance(*to) < 1e-5, "{:?} ends at {}", edge, end);
                }
                for point in samples(at, edge) {
                    let distance = centres.nearest(point).map_or(f64::INFINITY, |(_, distance)| distance);
                    prop_assert!(distance < 1e-5 || centres.contains(point), "{} leaves the region at {}", point, distance);
                    reached.push(point);
                }
                at = edge.to();
            }
        }
        // The nearest sample is at most half their distance away from the nearest point of the path.
        let reach = (radius * radius + 0.01).sqrt() + 1e-4;
        let area = centres.grown(radius);
        for at in points().filter(|at| area.contains(*at)) {
            let cut = reached.iter().any(|point| point.distance(at) <= reach);
            prop_assert!(cut, "nothing comes to {}", at);
        }
    }
}

#[test]
fn what_two_areas_enclose_together_may_be_reached_by_a_third() {
    // Two needles meet and enclose an area that a third one, which crosses both, reaches into.
    let needles = |x, y, count, long: &[(usize, f64)]| {
        let mut radii = vec![3.0; count];
        long.iter().for_each(|(n, radius)| radii[*n] = *radius);
        Star { centre: DVec2::new(x, y), radii }
    };
    let first = needles(-36.437, 39.566, 13, &[(11, 36.222)]);
    let second = needles(12.641, 0.0, 10, &[(4, 37.473)]);
    let third = needles(13.877, 19.964, 33, &[(16, 39.637), (18, 31.229), (19, 37.740)]);
    let [a, b, c] = [&first, &second, &third].map(|star| Region::within(&star.boundary()));
    let both = a.union(&b);
    let (all, common) = (both.union(&c), both.intersection(&c));
    assert!((all.area() - (both.area() + c.area() - common.area())).abs() < 1e-6, "{} {}", all.area(), common.area());
}

#[test]
fn a_contour_that_is_open_crosses_itself_or_encloses_nothing_is_refused() {
    let line = |x: f64, y: f64| Edge::Line(DVec2::new(x, y));
    let of = |edges: &[Edge]| Boundary::new(DVec2::ZERO, edges, 1e-3).map(|_| ());
    let (from, to) = (DVec2::ZERO, DVec2::new(0.0, 5.0));
    assert_eq!(of(&[line(5.0, 0.0), line(5.0, 5.0), line(0.0, 5.0)]), Err(Flaw::Open { from, to }));
    assert_eq!(of(&[line(5.0, 0.0), line(0.0, 0.0)]), Err(Flaw::NoArea));
    let crossing = of(&[line(9.0, 9.0), line(9.0, 0.0), line(0.0, 4.0), line(0.0, 0.0)]);
    // The diagonal and the last line but one: y = x and y = 4 - 4 x / 9.
    let Err(Flaw::Crossing(at)) = crossing else { panic!("{crossing:?}") };
    assert!(at.distance(DVec2::splat(36.0 / 13.0)) < 1e-9, "{at}");
}

/// An open contour that winds from left to right: lines, and arcs that bulge by a part of their chord.
fn winding() -> impl Strategy<Value = Way> {
    prop::collection::vec(
        (2.0..30.0f64, -25.0..25.0f64, prop_oneof![2 => Just(0.0), 1 => 0.02..0.9f64, 1 => -0.9..-0.02f64]),
        1..25,
    )
    .prop_map(|steps| {
        let mut at = DVec2::ZERO;
        let mut way = Way { start: at, edges: Vec::new() };
        for (x, y, bulge) in steps {
            let to = at + DVec2::new(x, y);
            way.edges.push(if bulge == 0.0 {
                Edge::Line(to)
            } else {
                // The centre of an arc whose height is that part of half its chord.
                let (half, middle) = (at.distance(to) / 2.0, at.midpoint(to));
                let off = half * (1.0 - bulge * bulge) / (2.0 * bulge);
                let centre = middle + (to - at).normalize().perp() * off;
                Edge::Arc { to, centre, sweep: 4.0 * bulge.atan().to_degrees() }
            });
            at = to;
        }
        way
    })
}

/// The distance of a point from a way.
fn distance(way: &Way, point: DVec2) -> f64 {
    let mut at = way.start;
    let mut far = f64::INFINITY;
    for edge in &way.edges {
        let to = edge.to();
        let own = match *edge {
            Edge::Line(_) => {
                let along = ((point - at).dot(to - at) / (to - at).length_squared()).clamp(0.0, 1.0);
                point.distance(at.lerp(to, along))
            }
            Edge::Arc { centre, sweep, .. } => {
                let turn = (at - centre).angle_to(point - centre).to_degrees() * sweep.signum();
                let turn = if turn < 0.0 { turn + 360.0 } else { turn };
                let ends = point.distance(at).min(point.distance(to));
                if turn <= sweep.abs() { ends.min((point.distance(centre) - at.distance(centre)).abs()) } else { ends }
            }
        };
        far = far.min(own);
        at = to;
    }
    far
}

laws! {
    #![proptest_config(cases::config(50))]

    /// A way beside another one has that distance from it everywhere, begins beside it, and the same holds the other way
    /// round.
    #[test]
    fn a_way_beside_another_keeps_its_distance(
        way in winding(), by in prop_oneof![0.1..12.0f64, -12.0..-0.1f64],
    ) {
        let ways = way.beside(by);
        for own in &ways {
            let length = own.length();
            prop_assert!(length > 0.0);
            for part in 0..=200 {
                let point = own.shortened(length * f64::from(part) / 200.0).end();
                let far = distance(&way, point);
                prop_assert!((far - by.abs()).abs() < 1e-4, "{point} is {far} from the way and not {by}");
            }
        }
        if let [own] = ways.as_slice() {
            // On the same side: where the way is not hemmed in at its beginning the two begin beside each other.
            let heading = (way.shortened(1e-6).end() - way.start).normalize();
            let beside = way.start + heading.perp() * by;
            if distance(&way, beside) > by.abs() - 1e-9 {
                prop_assert!(own.start.distance(beside) < 1e-4, "{} is not {beside}", own.start);
            }
            let back = way.reversed().beside(-by);
            prop_assert_eq!(back.len(), 1);
            prop_assert!((back[0].length() - own.length()).abs() < 1e-4);
            prop_assert!(back[0].start.distance(own.end()) < 1e-4);
        }
    }
}

/// A disc that the tool joins and leaves along the tangent at one point: it goes round once, though it comes back to where it
/// has passed before.
#[test]
fn a_contour_that_is_joined_and_left_at_one_point_has_one_way_beside_it() {
    let half = |to: f64| Edge::Arc { to: DVec2::new(to, 0.0), centre: DVec2::ZERO, sweep: -180.0 };
    let line = |y: f64| Edge::Line(DVec2::new(-30.0, y));
    let way = Way { start: DVec2::new(-30.0, -75.0), edges: vec![line(0.0), half(30.0), half(-30.0), line(75.0)] };
    let beside = way.beside(10.3);
    let [own] = beside.as_slice() else { panic!("{} ways", beside.len()) };
    assert!(own.start.distance(DVec2::new(-40.3, -75.0)) < 1e-6 && own.end().distance(DVec2::new(-40.3, 75.0)) < 1e-6);
    // Two lines of 75 mm and a circle with a radius of 40.3 mm.
    assert!((own.length() - (150.0 + std::f64::consts::TAU * 40.3)).abs() < 1e-3, "{}", own.length());
}
