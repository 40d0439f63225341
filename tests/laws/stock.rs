//! The stock against figures that are calculated here: volumes and heights after lines, arcs, helices and plunges with
//! every form of tool, and meshes that are closed.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use ciklo::base::diag::Source;
use ciklo::engine::geometry::{Axis, Frame};
use ciklo::engine::scene::Scene;
use ciklo::engine::solid::{Path, Shape};
use ciklo::engine::stock::{Batch, Blank, Cut, Cutter, Neck, Stock, StockTrouble, Tip};
use ciklo::program::syntax;
use glam::DVec3;
use proptest::prelude::*;

const MIN: DVec3 = DVec3::new(0.0, 0.0, -20.0);
const MAX: DVec3 = DVec3::new(60.0, 40.0, 0.0);

fn block(resolution: f64) -> Stock {
    Stock::new(&Shape::Box { min: MIN, max: MAX }, [MIN, MAX], Frame::IDENTITY, Axis::Z, resolution).expect("a block")
}

const fn tool(radius: f64, tip: Tip) -> Cutter {
    Cutter { radius, tip, neck: None, edges: 0.0 }
}

fn cut(stock: &mut Stock, cutter: &Cutter, axis: DVec3, paths: &[Path]) -> Vec<Cut> {
    let mut batch = Batch::default();
    paths.iter().for_each(|path| stock.add(&mut batch, path, axis, cutter, false));
    stock.carry_out(&mut batch)
}

fn tip() -> impl Strategy<Value = Tip> {
    prop_oneof![
        Just(Tip::Flat),
        (0.1..1.0).prop_map(Tip::Round),
        Just(Tip::Round(4.0)),
        (0.2..1.5).prop_map(Tip::Point)
    ]
}

/// Height of the tool's end at a distance from its axis.
fn end(cutter: &Cutter, far: f64) -> f64 {
    match cutter.tip {
        Tip::Flat => 0.0,
        Tip::Point(slope) => slope * far,
        Tip::Round(corner) => {
            let over = (far - cutter.radius + corner).max(0.0);
            corner - (corner * corner - over * over).max(0.0).sqrt()
        }
    }
}

/// Each column is as low as the tool ever was over it, seen at many points of the way; `slack` is what the points may
/// miss.
fn follows(stock: &Stock, path: &Path, cutter: &Cutter, slack: f64) {
    const SAMPLES: usize = 1500;
    let points: Vec<DVec3> = (0..=SAMPLES).map(|n| path.at(n as f64 / SAMPLES as f64)).collect();
    let (columns, rows) = stock.size();
    for row in 0..rows {
        for column in 0..columns {
            let place = stock.place(column, row);
            let (mut low, mut wide) = (0.0_f64, 0.0_f64);
            for p in &points {
                let far = (p.x - place.x).hypot(p.y - place.y);
                if far <= cutter.radius {
                    low = low.min(p.z + end(cutter, far));
                }
                if far <= cutter.radius + slack {
                    wide = wide.min(p.z - slack + end(cutter, (far - slack).clamp(0.0, cutter.radius)));
                }
            }
            let (low, wide) = (low.max(MIN.z), wide.max(MIN.z));
            let top = stock.top(column, row).unwrap_or(MIN.z);
            assert!(top <= low + 1e-9, "{place}: {top} is above {low} {path:?} {cutter:?}");
            assert!(top >= wide - 1e-9, "{place}: {top} is below {wide} {path:?} {cutter:?}");
        }
    }
}

laws! {
    #![proptest_config(crate::cases::config(24))]

    #[test]
    fn a_line_leaves_its_envelope(
        tip in tip(), a in (8.0..52.0, 8.0..32.0, -12.0..1.0), b in (8.0..52.0, 8.0..32.0, -12.0..1.0), level in any::<bool>(),
    ) {
        let cutter = tool(4.0, tip);
        let (from, mut to) = (DVec3::from(a), DVec3::from(b));
        if level {
            to.z = from.z;
        }
        let path = Path::line(from, to);
        let mut stock = block(3.0);
        cut(&mut stock, &cutter, DVec3::Z, &[path]);
        follows(&stock, &path, &cutter, 0.05);
    }

    #[test]
    fn an_arc_leaves_its_envelope(
        tip in tip(), radius in 0.5..12.0, start in 0.0..360.0_f64, sweep in -800.0..800.0_f64, fall in prop_oneof![Just(0.0), -9.0..9.0],
    ) {
        let cutter = tool(4.0, tip);
        let centre = DVec3::new(30.0, 20.0, -10.0);
        let from = centre + DVec3::new(start.to_radians().cos(), start.to_radians().sin(), 0.0) * radius;
        let path = Path::Arc { centre, axis: DVec3::Z, from, sweep, rise: fall };
        let mut stock = block(3.0);
        cut(&mut stock, &cutter, DVec3::Z, &[path]);
        follows(&stock, &path, &cutter, 0.08);
    }

    /// A way in many pieces leaves what it leaves in one: what was cut before may be passed over, and nothing else.
    #[test]
    fn pieces_leave_what_the_whole_leaves(
        tip in tip(), corners in prop::collection::vec((5.0..55.0, 5.0..35.0, -12.0..0.0), 3..7), parts in 2..9_usize,
    ) {
        let cutter = tool(4.0, tip);
        let points: Vec<DVec3> = corners.into_iter().map(DVec3::from).collect();
        let whole: Vec<Path> = points.windows(2).map(|pair| Path::line(pair[0], pair[1])).collect();
        let mut pieces = Vec::new();
        for path in &whole {
            let at = |n: usize| path.at(n as f64 / parts as f64);
            pieces.extend((0..parts).map(|n| Path::line(at(n), at(n + 1))));
        }
        let (mut one, mut many) = (block(0.7), block(0.7));
        // In batches of their own nothing is known of the way before.
        whole.iter().for_each(|path| drop(cut(&mut one, &cutter, DVec3::Z, &[*path])));
        cut(&mut many, &cutter, DVec3::Z, &pieces);
        let (columns, rows) = one.size();
        let mut off = 0;
        for row in 0..rows {
            for column in 0..columns {
                let (a, b) = (one.top(column, row).unwrap_or(MIN.z), many.top(column, row).unwrap_or(MIN.z));
                off += usize::from((a - b).abs() > 1e-6);
            }
        }
        // A column on the very rim may fall to either side.
        prop_assert!(off <= 2, "{off} columns differ");
    }

    /// The same on arcs and helices, whose pieces are passed over where the tool has stood.
    #[test]
    fn pieces_of_arcs_leave_what_the_whole_leaves(
        tip in tip(), radius in 0.5..14.0, start in 0.0..360.0_f64, sweep in -300.0..300.0_f64, fall in prop_oneof![Just(0.0), -3.0..3.0],
        parts in 2..40_u8,
    ) {
        let cutter = tool(4.0, tip);
        let centre = DVec3::new(30.0, 20.0, -6.0);
        let arm = |degrees: f64| DVec3::new(degrees.to_radians().cos(), degrees.to_radians().sin(), 0.0) * radius;
        let part = |from: f64, sweep: f64, low: f64, rise: f64| Path::Arc {
            centre: centre + DVec3::Z * low, axis: DVec3::Z, from: centre + DVec3::Z * low + arm(from), sweep, rise,
        };
        let share = 1.0 / f64::from(parts);
        let at = |n: u8| f64::from(n) * share;
        let pieces: Vec<Path> =
            (0..parts).map(|n| part(start + sweep * at(n), sweep * share, fall * at(n), fall * share)).collect();
        let (mut one, mut many) = (block(0.7), block(0.7));
        cut(&mut one, &cutter, DVec3::Z, &[part(start, sweep, 0.0, fall)]);
        cut(&mut many, &cutter, DVec3::Z, &pieces);
        let (columns, rows) = one.size();
        let mut off = 0;
        for row in 0..rows {
            for column in 0..columns {
                let (a, b) = (one.top(column, row).unwrap_or(MIN.z), many.top(column, row).unwrap_or(MIN.z));
                off += usize::from((a - b).abs() > 1e-6);
            }
        }
        prop_assert!(off <= 2, "{off} columns differ");
    }

    /// A tool that lies across the columns, against one that stands along them: point by point. It is followed in steps of
    /// a quarter of a cell, so it takes nothing that is not to go, and what is further from a surface than that.
    #[test]
    fn columns_may_stand_otherwise(tip in tip(), from in (10.0..50.0, 10.0..30.0), to in (10.0..50.0, 10.0..30.0), z in 1..10_i8) {
        let z = f64::from(-z);
        let cutter = tool(4.0, tip);
        let path = Path::line(DVec3::new(from.0, from.1, z), DVec3::new(to.0, to.1, z));
        let shape = Shape::Box { min: MIN, max: MAX };
        // Three columns to each of the others, the middle one of which is where that is.
        let mut along = block(0.3334);
        cut(&mut along, &cutter, DVec3::Z, &[path]);
        let mut across = Stock::new(&shape, [MIN, MAX], Frame::IDENTITY, Axis::X, 1.0).expect("a block");
        cut(&mut across, &cutter, DVec3::Z, &[path]);
        prop_assert_eq!((along.size(), across.size()), ((180, 120), (40, 20)));
        let top = |column: usize, row: usize| along.top(column, row).unwrap_or(MIN.z);
        for (level, row) in (0..20).flat_map(|level| (0..40).map(move |row| (level, row))) {
            let (place, stretches, line) = (across.place(row, level), across.column(row, level), 3 * row + 1);
            for column in 1..179 {
                let at = along.place(column, line);
                prop_assert!((at.y - place.x).abs() < 1e-9);
                let left = stretches.iter().any(|[low, high]| (*low..=*high).contains(&at.x));
                prop_assert!(left || top(column, line) < place.y + 1e-6, "{} is gone at {}", at, place.y);
                // The way of a convex body along a line is convex: what is between four corners of it is of it.
                let corners = [(0, 0), (2, 0), (0, 2), (2, 2)];
                let inside = corners.iter().all(|(x, y)| top(column + x - 1, line + y - 1) <= place.y - 0.25);
                prop_assert!(!left || !inside, "{} is left at {}", at, place.y);
            }
        }
    }
}

#[test]
fn volumes_are_those_of_geometry() {
    let mut stock = block(0.1);
    let whole = 60.0 * 40.0 * 20.0;
    assert!((stock.volume() - whole).abs() < 1e-6);
    let (r, l) = (5.0, 30.0);
    let slot = Path::line(DVec3::new(15.0, 20.0, -4.0), DVec3::new(45.0, 20.0, -4.0));
    let done = cut(&mut stock, &tool(r, Tip::Flat), DVec3::Z, &[slot])[0];
    let wanted = 4.0 * (PI * r * r + 2.0 * r * l);
    assert!((done.volume - wanted).abs() < 0.002 * wanted, "{} {wanted}", done.volume);
    assert!((done.depth - 4.0).abs() < 1e-12 && (done.width - 10.0).abs() < 0.2);
    assert!((stock.volume() - whole + done.volume).abs() < 1e-6);
    // The same again takes nothing.
    assert_eq!(cut(&mut stock, &tool(r, Tip::Flat), DVec3::Z, &[slot])[0].volume, 0.0);
    // A drill of 118 degrees through a fresh block: cylinder and cone.
    let slope = 1.0 / 59.0_f64.to_radians().tan();
    let mut stock = block(0.05);
    let down = Path::line(DVec3::new(30.0, 20.0, 5.0), DVec3::new(30.0, 20.0, -10.0));
    let done = cut(&mut stock, &tool(4.0, Tip::Point(slope)), DVec3::Z, &[down])[0];
    let cone = 4.0 * slope;
    let wanted = PI * 16.0 * (10.0 - cone) + PI * 16.0 * cone / 3.0;
    assert!((done.volume - wanted).abs() < 0.003 * wanted, "{} {wanted}", done.volume);
    assert_eq!(done.width, 0.0);
    // A ball along a circle: half a torus and the ring above it.
    let mut stock = block(0.05);
    let centre = DVec3::new(30.0, 20.0, -5.0);
    let ring = Path::Arc { centre, axis: DVec3::Z, from: centre + DVec3::X * 10.0, sweep: 360.0, rise: 0.0 };
    let done = cut(&mut stock, &tool(3.0, Tip::Round(3.0)), DVec3::Z, &[ring])[0];
    let wanted = TAU * 10.0 * (FRAC_PI_2 * 9.0 + 2.0 * 6.0);
    assert!((done.volume - wanted).abs() < 0.003 * wanted, "{} {wanted}", done.volume);
}

/// A tool of 5 goes around at the radius 10: its rim passes at 5 and 15, and so do the columns at (3, 4), (5, 0), (9, 12)
/// and (15, 0) from the centre. Rounding decides on which side of them it passes, and differs by where a circle begins;
/// even so the first level takes all that it is to take, and the second its own infeed.
#[test]
fn columns_on_a_wall_go_with_their_level() {
    let cutter = tool(5.0, Tip::Flat);
    for start in 0..72 {
        let mut stock = block(1.0);
        for level in 1..=3 {
            let centre = DVec3::new(30.5, 20.5, -f64::from(level));
            // Each level begins elsewhere.
            let angle = f64::from(start * 5 + level * 67).to_radians();
            let from = centre + DVec3::new(angle.cos(), angle.sin(), 0.0) * 10.0;
            let circle = Path::Arc { centre, axis: DVec3::Z, from, sweep: 360.0, rise: 0.0 };
            let found = cut(&mut stock, &cutter, DVec3::Z, &[circle]);
            assert!(found[0].depth <= 1.0 + 1e-9, "from {angle} at {level}: {}", found[0].depth);
        }
        for (x, y) in [(3.0, 4.0), (-4.0, 3.0), (5.0, 0.0), (9.0, 12.0), (-12.0, -9.0), (15.0, 0.0), (0.0, -15.0)] {
            let (column, row) = ((30.0 + x) as usize, (20.0 + y) as usize);
            assert_eq!(stock.place(column, row).to_array(), [30.5 + x, 20.5 + y]);
            assert_eq!(stock.top(column, row), Some(-3.0), "the column at {x} {y}, from {start}");
        }
    }
}

#[test]
fn a_head_behind_a_neck_cuts_from_below() {
    let mut stock = block(0.1);
    let hole = Path::line(DVec3::new(30.0, 20.0, 5.0), DVec3::new(30.0, 20.0, -25.0));
    cut(&mut stock, &tool(5.0, Tip::Flat), DVec3::Z, &[hole]);
    let cutter = Cutter { neck: Some(Neck { head: 3.0, radius: 4.0 }), ..tool(8.0, Tip::Flat) };
    // From below the block up to 4 mm below its top.
    let up = Path::line(DVec3::new(30.0, 20.0, -25.0), DVec3::new(30.0, 20.0, -7.0));
    let done = cut(&mut stock, &cutter, DVec3::Z, &[up])[0];
    let wanted = PI * (64.0 - 25.0) * 16.0;
    assert!((done.volume - wanted).abs() < 0.005 * wanted, "{} {wanted}", done.volume);
    let (column, row) = (365, 200);
    let stretches = stock.column(column, row);
    assert_eq!(stretches.len(), 1);
    assert!((stretches[0][0] + 4.0).abs() < 1e-9 && stretches[0][1] == 0.0, "{stretches:?}");
    let wanted = Shape::Difference(vec![
        Shape::Box { min: MIN, max: MAX },
        Shape::Cylinder { from: DVec3::new(30.0, 20.0, 0.0), to: DVec3::new(30.0, 20.0, -20.0), radius: 5.0 },
        Shape::Cylinder { from: DVec3::new(30.0, 20.0, -4.0), to: DVec3::new(30.0, 20.0, -20.0), radius: 8.0 },
    ]);
    assert!(stock.compare(&wanted, 1e-3).expect("a comparison").is_none());
}

#[test]
fn a_part_that_is_wrong_is_told_apart() {
    let hole = |radius: f64, to: f64| {
        let mut stock = block(0.2);
        let path = Path::line(DVec3::new(30.0, 20.0, 5.0), DVec3::new(30.0, 20.0, to));
        cut(&mut stock, &tool(radius, Tip::Flat), DVec3::Z, &[path]);
        let wanted = Shape::Difference(vec![
            Shape::Box { min: MIN, max: MAX },
            Shape::Cylinder { from: DVec3::new(30.0, 20.0, 0.0), to: DVec3::new(30.0, 20.0, -10.0), radius: 5.0 },
        ]);
        stock.compare(&wanted, 0.01).expect("a comparison")
    };
    assert!(hole(5.0, -10.0).is_none());
    assert!(hole(5.005, -10.005).is_none());
    let wide = hole(5.5, -10.0);
    assert!(wide.left_over.is_none() && wide.gouged.is_some_and(|(_, height, _)| (height - 10.0).abs() < 1e-9));
    let shallow = hole(5.0, -9.5);
    assert!(shallow.gouged.is_none() && shallow.left_over.is_some_and(|(_, height, _)| (height - 0.5).abs() < 1e-9));
}

/// Rapid traverse along the walls and the ground of what was cut touches nothing; a little deeper, it does.
#[test]
fn rapid_traverse_beside_the_material() {
    let mut stock = block(0.1);
    let cutter = tool(5.0, Tip::Round(5.0));
    let slot = Path::line(DVec3::new(15.0, 20.0, -4.0), DVec3::new(45.0, 21.0, -6.0));
    cut(&mut stock, &cutter, DVec3::Z, &[slot]);
    let mut rapid = |path: &Path| {
        let mut batch = Batch::default();
        stock.add(&mut batch, path, DVec3::Z, &cutter, true);
        stock.carry_out(&mut batch)[0].volume
    };
    let back = Path::line(slot.at(1.0), slot.at(0.0));
    assert_eq!(rapid(&back), 0.0);
    assert_eq!(rapid(&Path::line(slot.at(0.0), slot.at(0.0) + DVec3::Z * 30.0)), 0.0);
    let down = DVec3::Z * 0.003;
    assert!(rapid(&Path::line(slot.at(1.0) - down, slot.at(0.0) - down)) > 0.0);
}

/// The same moves again and again add nothing to what is kept.
#[test]
fn memory_does_not_grow_with_moves() {
    let mut stock = block(1.0);
    let cutter = Cutter { neck: Some(Neck { head: 1.0, radius: 1.0 }), ..tool(3.0, Tip::Flat) };
    let at = |n: usize| DVec3::new((n * 7 % 55) as f64 + 2.0, (n * 11 % 37) as f64 + 1.5, -((n * 5 % 19) as f64) - 0.3);
    let paths: Vec<Path> = (0..200).map(|n| Path::line(at(n), at(n + 1))).collect();
    let stretches = |stock: &Stock| {
        let (columns, rows) = stock.size();
        (0..columns * rows).map(|n| stock.column(n % columns, n / columns).len()).sum::<usize>()
    };
    cut(&mut stock, &cutter, DVec3::Z, &paths);
    let (kept, volume) = (stretches(&stock), stock.volume());
    for _ in 0..5 {
        cut(&mut stock, &cutter, DVec3::Z, &paths);
    }
    assert_eq!(stretches(&stock), kept);
    assert!((stock.volume() - volume).abs() < 1e-6);
}

#[test]
fn blanks_that_cannot_be() {
    let shape = Shape::Box { min: MIN, max: MAX };
    for resolution in [0.0, -1.0, f64::NAN, 1e-4] {
        let made = Stock::new(&shape, [MIN, MAX], Frame::IDENTITY, Axis::Z, resolution);
        assert!(matches!(made, Err(StockTrouble::Resolution { .. })));
    }
    for far in [2e9, 1e41, f64::MAX] {
        let max = DVec3::new(far, MAX.y, MAX.z);
        let made = Stock::new(&Shape::Box { min: MIN, max }, [MIN, max], Frame::IDENTITY, Axis::Z, far / 2.0);
        assert!(matches!(made, Err(StockTrouble::Extent)), "{far}");
    }
}

/// The mesh of a part with pocket, hole, undercut and round blank: every edge of a triangle lies against one that goes
/// the other way, and the volume inside is that of the columns.
#[test]
fn meshes_are_closed() {
    for axis in Axis::ALL {
        let blank =
            Shape::Cylinder { from: DVec3::new(30.0, 20.0, -20.0), to: DVec3::new(30.0, 20.0, 0.0), radius: 19.0 };
        let bounds = [DVec3::new(11.0, 1.0, -20.0), DVec3::new(49.0, 39.0, 0.0)];
        let mut stock = Stock::new(&blank, bounds, Frame::IDENTITY, axis, 0.8).expect("a blank");
        let spot = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
        cut(
            &mut stock,
            &tool(3.0, Tip::Round(3.0)),
            DVec3::Z,
            &[Path::line(spot(20.0, 12.0, -3.0), spot(38.0, 30.0, -7.0))],
        );
        cut(&mut stock, &tool(4.0, Tip::Flat), DVec3::Z, &[Path::line(spot(32.0, 16.0, 5.0), spot(32.0, 16.0, -25.0))]);
        let cutter = Cutter { neck: Some(Neck { head: 3.0, radius: 2.0 }), ..tool(6.0, Tip::Flat) };
        cut(&mut stock, &cutter, DVec3::Z, &[Path::line(spot(32.0, 16.0, -14.0), spot(32.0, 17.0, -13.0))]);
        let bytes = stock.to_stl().expect("a mesh");
        let count = u32::from_le_bytes(bytes[80..84].try_into().expect("four bytes")) as usize;
        assert_eq!(bytes.len(), 84 + 50 * count);
        let mut edges: BTreeMap<[[u32; 3]; 2], i64> = BTreeMap::new();
        let mut volume = 0.0;
        for triangle in bytes[84..].chunks(50) {
            let number = |n: usize| f32::from_le_bytes(triangle[n * 4..n * 4 + 4].try_into().expect("four bytes"));
            let corner = |n: usize| [number(3 * n + 3), number(3 * n + 4), number(3 * n + 5)];
            let [a, b, c] = [0, 1, 2].map(corner);
            let p = |v: [f32; 3]| DVec3::new(v[0].into(), v[1].into(), v[2].into());
            volume += p(a).dot(p(b).cross(p(c))) / 6.0;
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let [from, to] = [from, to].map(|v| v.map(|number| (number + 0.0).to_bits()));
                assert_ne!(from, to, "a triangle without an extent");
                *edges.entry([from, to]).or_default() += 1;
                *edges.entry([to, from]).or_default() -= 1;
            }
        }
        assert!(edges.values().all(|count| *count == 0), "{axis:?}: open edges");
        assert!((volume - stock.volume()).abs() < 1e-4 * volume, "{axis:?}: {volume} {}", stock.volume());
    }
}

/// The blank of a program: a cuboid in its unit, its second corner also in increments, or a cylinder; of other forms a plain
/// word.
#[test]
fn the_blank_of_a_program_is_a_cuboid_or_a_cylinder_in_its_unit() {
    let files = ciklo::base::data::embedded();
    let find = |lines: &str, scene: &str| {
        let program = syntax::parse(&Source::new("A.H", lines));
        let scene = Scene::parse(&Source::new("scene.yaml", scene), &files).expect("a scene");
        Blank::find(&program, &scene).map(|blank| (blank.bounds, blank.axis))
    };
    let plain = "scene: 1\n";
    let near = |found: Result<([DVec3; 2], Axis), StockTrouble>, min: DVec3, max: DVec3, axis: Axis| {
        let (bounds, own) = found.expect("a blank");
        assert!(bounds[0].distance(min) < 1e-9 && bounds[1].distance(max) < 1e-9 && own == axis, "{bounds:?} {own:?}");
    };
    let cuboid = "BLK FORM 0.1 Z X+0 Y-1 Z-2\nBLK FORM 0.2 X+10 Y+4 Z+0.5\n";
    let mm = |text: &str| format!("BEGIN PGM A MM\n{text}END PGM A MM\n");
    near(find(&mm(cuboid), plain), DVec3::new(0.0, -1.0, -2.0), DVec3::new(10.0, 4.0, 0.5), Axis::Z);
    // 10 inches are 254 mm, 4 are 101.6, a half is 12.7.
    let inches = format!("BEGIN PGM A INCH\n{cuboid}END PGM A INCH\n");
    near(find(&inches, plain), DVec3::new(0.0, -25.4, -50.8), DVec3::new(254.0, 101.6, 12.7), Axis::Z);
    let increments = "BLK FORM 0.1 Y X+5 Y-20 Z+1\nBLK FORM 0.2 IX+10 IY+20 IZ+3\n";
    near(find(&mm(increments), plain), DVec3::new(5.0, -20.0, 1.0), DVec3::new(15.0, 0.0, 4.0), Axis::Y);
    let round = mm("BLK FORM CYLINDER Z R50 L100\n");
    near(find(&round, plain), DVec3::new(-50.0, -50.0, -100.0), DVec3::new(50.0, 50.0, 0.0), Axis::Z);
    // Its top is 5 mm above the datum, so its bottom is 95 mm below it; 30 mm across.
    let lying = mm("BLK FORM CYLINDER X D30 L100 DIST+5 DI10\n");
    near(find(&lying, plain), DVec3::new(-95.0, -15.0, -15.0), DVec3::new(5.0, 15.0, 15.0), Axis::X);
    let program = syntax::parse(&Source::new("A.H", &*lying));
    let blank = Blank::of_program(&program, Axis::Z).expect("a blank").expect("a body");
    let volume = blank.uncut().expect("columns").volume();
    let expected = std::f64::consts::PI * (15.0_f64.powi(2) - 5.0_f64.powi(2)) * 100.0;
    assert!((volume / expected - 1.0).abs() < 0.02, "{volume} {expected}");
    for wrong in ["Z R50", "Z L100", "R50 L100", "Z R50 L-1", "Z R50 L100 RI50", "Z RQ1 L100"] {
        let found = find(&mm(&format!("BLK FORM CYLINDER {wrong}\n")), plain);
        assert_eq!(found.err(), Some(StockTrouble::Blank), "{wrong}");
    }
    let drawn = mm("BLK FORM ROTATION Z DIM_R LBL 2\n");
    assert_eq!(find(&drawn, plain).err(), Some(StockTrouble::Form { word: "ROTATION".to_owned() }));
    // The stock of the scene goes before whatever the program says.
    let with_stock = "scene: 1\nstock: {box: {min: [0, 0, 0], max: [1, 2, 3]}}\n";
    near(find(&drawn, with_stock), DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0), Axis::Z);
    assert_eq!(
        find(&mm("BLK FORM 0.1 Z X+0 Y+0 Z+0\nBLK FORM 0.2 X+10 Y+0 Z+5\n"), plain).err(),
        Some(StockTrouble::Blank)
    );
    assert_eq!(find(&mm(""), plain).err(), Some(StockTrouble::Missing));
}
