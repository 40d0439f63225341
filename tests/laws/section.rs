//! Laws of half sections and of what inserts sweep in them, against points that are looked at one by one: a point is
//! taken away if some place of the way brings it into the insert.
use std::f64::consts::PI;

use ciklo::engine::region::section::{Cell, Section};
use ciklo::engine::region::sweep::{Rounded, TipWay};
use glam::DVec2;
use proptest::prelude::*;

/// A point that is nearer to a surface, mm, is not decided by places that are a little apart: on an arc of 300 degrees with
/// a radius of 15 mm there are 0.02 mm between them.
const BESIDE: f64 = 0.02;
/// Places of a way that are looked at.
const PLACES: u32 = 4000;

/// A wedge with a nose, its tip at the origin.
#[derive(Clone, Debug)]
struct Wedge {
    radius: f64,
    edges: [f64; 2],
    length: f64,
}

impl Wedge {
    fn corners(&self) -> [DVec2; 3] {
        [DVec2::ZERO, DVec2::from_angle(self.edges[0]) * self.length, DVec2::from_angle(self.edges[1]) * self.length]
    }

    /// How far a point is outside of it; negative inside.
    fn distance(&self, point: DVec2) -> f64 {
        let corners = self.corners();
        let mut least = f64::INFINITY;
        let mut inside = true;
        for n in 0..3 {
            let (a, b) = (corners[n], corners[(n + 1) % 3]);
            let (way, arm) = (b - a, point - a);
            inside &= way.perp_dot(arm) >= 0.0;
            least = least.min((arm - way * (arm.dot(way) / way.length_squared()).clamp(0.0, 1.0)).length());
        }
        (if inside { -least } else { least }) - self.radius
    }
}

fn wedge() -> impl Strategy<Value = Wedge> {
    let radius = prop_oneof![Just(0.0), 0.1..2.0_f64];
    (radius, -PI..PI, 0.4..2.6_f64, 3.0..60.0_f64).prop_map(|(radius, front, open, length)| Wedge {
        radius,
        edges: [front, front + open],
        length,
    })
}

fn place() -> impl Strategy<Value = DVec2> {
    (-5.0..45.0_f64, 2.0..28.0_f64).prop_map(|(x, y)| DVec2::new(x, y))
}

fn way() -> impl Strategy<Value = TipWay> {
    let straight = (place(), place()).prop_map(|(from, to)| TipWay::Line { from, to });
    let along = (place(), -20.0..20.0_f64).prop_map(|(from, by)| TipWay::Line { from, to: from + DVec2::new(by, 0.0) });
    let into = (place(), -20.0..20.0_f64).prop_map(|(from, by)| TipWay::Line { from, to: from + DVec2::new(0.0, by) });
    let arc = (place(), 0.05..15.0_f64, -PI..PI, -300.0..300.0_f64).prop_map(|(from, radius, to, sweep)| TipWay::Arc {
        centre: from + DVec2::from_angle(to) * radius,
        from,
        sweep,
    });
    prop_oneof![2 => straight, 1 => along, 1 => into, 3 => arc]
}

fn at(way: &TipWay, share: f64) -> DVec2 {
    match *way {
        TipWay::Line { from, to } => from.lerp(to, share),
        TipWay::Arc { centre, from, sweep } => {
            centre + DVec2::from_angle((sweep * share).to_radians()).rotate(from - centre)
        }
    }
}

/// How far the nearest place of a way keeps a point outside of the wedge.
fn nearest(wedge: &Wedge, way: &TipWay, point: DVec2) -> f64 {
    let places = (0..=PLACES).map(|n| wedge.distance(point - at(way, f64::from(n) / f64::from(PLACES))));
    places.fold(f64::INFINITY, f64::min)
}

fn has(cells: &[Cell], point: DVec2) -> bool {
    cells.iter().any(|cell| cell.contains(point))
}

/// Places beside each other, as far apart as a step, leave cusps; the way from the first to the last of them takes these
/// away, and no more.
fn levels_cusps(
    radius: f64,
    (step, count): (f64, u32),
    at: DVec2,
    edges: [f64; 2],
    to_and_fro: bool,
) -> Result<(), TestCaseError> {
    let corners = [DVec2::ZERO, DVec2::from_angle(edges[0]) * 100.0, DVec2::from_angle(edges[1]) * 100.0];
    let insert = Rounded::around(&corners, radius);
    let mut section = Section::ring([-30.0, 60.0], [2.0, 28.0]);
    let places: Vec<DVec2> = (0..count).map(|n| at + DVec2::new(f64::from(n) * step, 0.0)).collect();
    for place in &places {
        section.cut(&insert.swept(TipWay::Line { from: *place, to: *place }, false), &mut |_| {});
    }
    let (mut from, mut to) = (places[0], places[places.len() - 1]);
    if to_and_fro {
        (from, to) = (to, from);
    }
    section.cut(&insert.swept(TipWay::Line { from, to }, false), &mut |_| {});
    let level = at.y - radius;
    for n in 0..=400 {
        let x = from.lerp(to, f64::from(n) / 400.0).x;
        let top = section.at(x).first().map_or(0.0, |stretch| stretch[1]);
        prop_assert!((top - level).abs() < 1e-6, "{} instead of {} at {}", top, level, x);
    }
    Ok(())
}

laws! {
    #![proptest_config(crate::cases::config(30))]

    #[test]
    fn an_insert_takes_away_what_it_sweeps(
        wedge in wedge(), ways in proptest::collection::vec(way(), 1..5), points in proptest::collection::vec(place(), 60),
    ) {
        let mut section = Section::ring([0.0, 40.0], [5.0, 25.0]);
        let insert = Rounded::around(&wedge.corners(), wedge.radius);
        let (whole, mut removed) = (section.volume(), 0.0);
        for way in &ways {
            section.cut(&insert.swept(*way, false), &mut |cell| removed += cell.volume());
        }
        let rest = section.volume();
        prop_assert!((whole - rest - removed).abs() < 1e-5, "{whole} {rest} {removed}");
        for point in points {
            let outside = ways.iter().map(|way| nearest(&wedge, way, point)).fold(f64::INFINITY, f64::min);
            let was = (0.0..=40.0).contains(&point.x) && (5.0..=25.0).contains(&point.y);
            let is = has(section.cells(), point);
            prop_assert!(!is || was, "{point} is new");
            let is_clear = outside.abs() > BESIDE;
            prop_assert!(
                !was || !is_clear || is == (outside > 0.0), "{point}: {is}, {outside} outside {wedge:?} {ways:?}"
            );
        }
        // What was taken away cannot be taken away again, and in order it is the same.
        for way in &ways {
            let mut again = 0.0;
            section.cut(&insert.swept(*way, false), &mut |cell| again += cell.volume());
            prop_assert!(again < 1e-5, "{again}");
        }
        let ordered: f64 = section.in_order().iter().map(Cell::volume).sum();
        prop_assert!((ordered - rest).abs() < 1e-5, "{ordered} {rest}");
    }

    /// A skin takes from an insert what is nearer to its surface than it is thick.
    #[test]
    fn a_skin_is_as_thick_everywhere(wedge in wedge(), at in place(), points in proptest::collection::vec(place(), 40)) {
        let insert = Rounded::around(&wedge.corners(), wedge.radius);
        let skin = 0.1;
        let mut section = Section::ring([-20.0, 60.0], [0.0, 60.0]);
        section.cut(&insert.shrunk(skin).swept(TipWay::Line { from: at, to: at }, false), &mut |_| {});
        for point in points {
            let outside = wedge.distance(point - at) + skin;
            if outside.abs() > 1e-9 && wedge.length > 10.0 && wedge.edges[1] - wedge.edges[0] > 0.5 {
                // Within sharp corners a skin is no rounded thing.
                let sharp = outside > 0.0 && wedge.radius < skin && wedge.distance(point - at) < 0.0;
                prop_assert!(sharp || has(section.cells(), point) == (outside > 0.0), "{point} {outside}");
            }
        }
    }

    /// A ring of which an arc is the profile has the volume that slices have.
    #[test]
    fn a_way_along_cusps_levels_them(
        (radius, share, count) in (0.2..2.0_f64, 0.05..1.9_f64, 2..14_u32), (x, y) in (-5.0..5.0_f64, 10.0..20.0_f64),
        (front, open) in (0.6..1.6_f64, 0.2..1.2_f64), to_and_fro in any::<bool>(),
    ) {
        levels_cusps(radius, (radius * share, count), DVec2::new(x, y), [front, front + open], to_and_fro)?;
    }

    #[test]
    fn volumes_are_exact(radius in 1.0..8.0_f64, high in 0.0..20.0_f64, from in -9.0..0.0_f64, to in 0.1..9.0_f64) {
        let mut section = Section::ring([from, to], [0.0, 40.0]);
        let ball = Rounded::around(&[DVec2::new(0.0, high + radius)], radius);
        let mut removed = 0.0;
        let at = TipWay::Line { from: DVec2::ZERO, to: DVec2::ZERO };
        section.cut(&ball.swept(at, false), &mut |cell| removed += cell.volume());
        let (low, top) = (from.max(-radius), to.min(radius));
        let slices = 20_000;
        let slice = |n: i32| {
            let x = low + (top - low) * (f64::from(n) + 0.5) / f64::from(slices);
            let half = (radius * radius - x * x).sqrt();
            let (inner, outer) = (high + radius - half, high + radius + half);
            PI * (outer * outer - inner * inner) * (top - low) / f64::from(slices)
        };
        let truth: f64 = (0..slices).map(slice).sum();
        prop_assert!((removed - truth).abs() < 1e-5 * truth, "{removed} {truth}");
    }
}

/// Cuts that end at a wall with a nose of 1.13 and 0.584 between them, and the way along that wall.
#[test]
fn a_way_along_a_wall_levels_the_cusps_of_cuts() {
    let edges = [130.14_f64, 165.14].map(f64::to_radians);
    // Seen with the wall below: what leans back along it leans along the way.
    for (front, back) in [(edges[0], edges[1]), (PI - edges[1], PI - edges[0]), (0.7, 1.3)] {
        for start in [-13.5, -14.63, 0.0, 0.1] {
            levels_cusps(1.13, (0.584, 14), DVec2::new(start, 16.13), [front, back], false)
                .unwrap_or_else(|wrong| panic!("{wrong}"));
        }
    }
}
