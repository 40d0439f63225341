//! Laws of plane and ruled surfaces: what lies within is machined down to its height, and nothing farther away than the
//! tool reaches is touched.
use ciklo::engine::solid::Shape;
use glam::DVec2;
use proptest::prelude::*;

use super::job::{FINISH, Job, MILL, NEAR, PLUNGE, config, definition, job, mm};

/// The feed across, and that of prepositioning.
const ACROSS: f64 = 700.0;

/// The blank without a box over a rectangle of the program (two corners), which is greater by `grow`.
fn without(job: &Job, corner: DVec2, opposite: DVec2, grow: f64, floor: f64) -> Shape {
    let (k, half) = (job.view.scale, job.half);
    let top = job.surface * k;
    let block =
        Shape::Box { min: job.at(-half.x, -half.y, top - super::job::HEIGHT), max: job.at(half.x, half.y, top) };
    let middle = (corner + opposite) / 2.0;
    let size = (opposite - corner).abs() / 2.0 + DVec2::splat(grow);
    Shape::Difference(vec![block, job.rectangle(middle, size, 0.0, 0.0, floor)])
}

laws! {
    #![proptest_config(config())]

    /// The strategies meander over the edges or within them, or go back above each line.
    #[test]
    fn plane_faces(
        job in job(), strategy in 0..3_u8, corner in (mm(-20.0..20.0), mm(-20.0..20.0)), size in (mm(2.0..35.0), mm(2.0..35.0)),
        signs in (any::<bool>(), any::<bool>()), overlap in mm(0.1..1.99), floor in prop_oneof![Just(0.0), mm(0.05..2.0)], beside in mm(0.0..4.0),
        bull in prop_oneof![Just(0.0), 0.1..0.6_f64], trimmed in any::<bool>(), lap in prop_oneof![4 => Just(None), 1 => mm(0.1..2.0).prop_map(Some)],
    ) {
        let sign = |yes: bool| if yes { 1.0 } else { -1.0 };
        // Laps that are shorter than the tool, where it steps sideways within the face.
        let size = lap.map_or(size, |lap| (2.0 * job.tool() + lap, size.1));
        let size = DVec2::new(size.0 * sign(signs.0), size.1 * sign(signs.1));
        let corner = DVec2::from(corner);
        let round = (bull * job.radius * 100.0).floor() / 100.0;
        let mut job = Job { corner: round, ..job };
        let mut corner = corner;
        if trimmed {
            // The blank is as wide as the face, and its sides lie along the axes.
            job.view.turn = (job.view.turn / 90.0).round() * 90.0;
            corner = -size / 2.0;
            let lies = (job.view.turn / 90.0).rem_euclid(2.0) == 1.0;
            job.half = if lies { DVec2::new(corner.y, corner.x) } else { corner }.abs() * job.view.scale;
        }
        let end = job.surface - job.depth;
        let body = definition(232, &[
            (389, f64::from(strategy)), (225, corner.x), (226, corner.y), (227, job.surface), (386, end), (218, size.x), (219, size.y),
            (202, job.infeed), (369, floor), (370, overlap), (207, MILL), (385, FINISH), (253, ACROSS), (200, job.clearance),
            (357, beside), (204, job.second.max(job.clearance)),
        ]);
        let (done, stock) = job.machined(&(body + "CYCL CALL\n"), job.edges > 0.0)?;
        let inner = stock.compare(&without(&job, corner, corner + size, 0.0, end), NEAR).expect("a comparison");
        let outer = stock.compare(&without(&job, corner, corner + size, 2.0 * job.tool() + beside, end), NEAR).expect("a comparison");
        prop_assert!(inner.left_over.is_none(), "{:?}{}", inner, done.both);
        prop_assert!(outer.gouged.is_none(), "{:?}{}", outer, done.both);
        job.depth_at(&done, MILL, job.infeed)?;
        job.depth_at(&done, FINISH, floor)?;
        prop_assert!((done.end.z - (job.surface + job.second.max(job.clearance)) * job.view.scale).abs() < 1e-9, "ends at {}{}", done.end, done.both);
        // A tool with a round corner has its flat part for a diameter.
        let step = overlap * (job.tool() - round / job.view.scale);
        if trimmed {
            job.width_at(&done, MILL, step + round / job.view.scale, &|_| false)?;
        }
    }

    /// The lines lie next to each other where there are enough of them; the lower and the upper edge are met exactly.
    #[test]
    fn lines_over_a_plane(
        job in job(), corner in (mm(-20.0..10.0), mm(-20.0..10.0)), size in (mm(2.0..30.0), mm(2.0..30.0)), share in 0.2..0.9_f64,
    ) {
        let (corner, size) = (DVec2::from(corner), DVec2::from(size));
        let (r, depth) = (job.tool(), job.depth.min(8.0));
        let size = size + DVec2::Y * (2.0 * r);
        let cuts = ((size.y - 2.0 * r) / (2.0 * r * share)).ceil() + 1.0;
        let cuts = cuts.max(2.0);
        let floor = job.surface - depth;
        let body = definition(230, &[
            (225, corner.x), (226, corner.y), (227, floor), (218, size.x), (219, size.y), (240, cuts), (206, PLUNGE), (207, MILL),
            (209, ACROSS), (200, job.clearance + depth),
        ]);
        let above = format!("L {}{:+} R0 FMAX\n", job.axis.letter(), job.surface + 10.0);
        let (done, stock) = job.machined(&(above + &body + "CYCL CALL\n"), job.edges > 0.0)?;
        let inner = stock.compare(&without(&job, corner, corner + size, 0.0, floor), NEAR).expect("a comparison");
        prop_assert!(inner.left_over.is_none(), "{:?}{}", inner, done.both);
        // Upper and lower edge exactly; to the sides the tool runs out by its diameter.
        let wide = |x: f64, y: f64| without(&job, corner - DVec2::new(x, y), corner + size + DVec2::new(x, y), 0.0, floor);
        let outer = stock.compare(&wide(2.0 * r, 0.0), NEAR).expect("a comparison");
        prop_assert!(outer.gouged.is_none(), "{:?}{}", outer, done.both);
        let gap = (size.y - 2.0 * r) / (cuts - 1.0);
        job.width_at(&done, MILL, gap.max(0.0), &|at| {
            // The first line is as wide as the tool.
            let first = job.view.point(corner + DVec2::Y * r);
            let along = job.view.point(corner + DVec2::new(1.0, r)) - first;
            (along.normalize().perp_dot(at - first)).abs() < 0.2
        })?;
        prop_assert!((done.end.z - (floor + job.clearance + depth) * job.view.scale).abs() < 1e-9, "ends at {}{}", done.end, done.both);
    }

    /// A ball over a twisted surface leaves no column lower than the surface by more than the slope lets the ball in.
    #[test]
    fn ruled_surfaces(
        job in job(), corner in (mm(-25.0..0.0), mm(-25.0..0.0)), size in (mm(8.0..30.0), mm(8.0..30.0)),
        heights in (mm(0.5..4.0), mm(0.5..4.0), mm(0.5..4.0), mm(0.5..4.0)), share in 0.1..0.5_f64, turned in any::<bool>(),
    ) {
        let job = Job { corner: job.radius, edges: 0.0, ..job };
        let (r, corner, size) = (job.tool(), DVec2::from(corner), DVec2::from(size));
        let heights = [heights.0, heights.1, heights.2, heights.3].map(|down| job.surface - down);
        // A line that falls by more than the diameter is passed over at rapid traverse too low, as the manual has it.
        prop_assume!(heights[0] - heights[1] <= 2.0 * r && heights[3] - heights[2] <= 2.0 * r);
        // Either way round; the first line goes from the first to the second point.
        let (x, y) = (DVec2::X * size.x, DVec2::Y * size.y);
        let points = if turned {
            [corner, corner + y, corner + size, corner + x]
        } else {
            [corner, corner + x, corner + size, corner + y]
        };
        let across = if turned { size.x } else { size.y };
        let cuts = (across / (2.0 * r * share)).ceil() + 1.0;
        let mut values = Vec::new();
        for (n, (point, height)) in points.iter().zip(heights).enumerate() {
            let first = [225, 228, 231, 234][n];
            values.extend([(first, point.x), (first + 1, point.y), (first + 2, height)]);
        }
        values.extend([(240, cuts), (207, MILL)]);
        let body = definition(231, &values);
        let before = format!("L {} R0 FMAX\nL {}{:+} R0 FMAX\n", job.words(corner), job.axis.letter(), job.surface + 10.0);
        let (done, stock) = job.machined(&(body + &before + "CYCL CALL\n"), false)?;
        // The place of the surface over a point of the rectangle, by its rulings.
        let surface = |p: DVec2| {
            let (u, v) = ((p - corner) / size).into();
            let (u, v): (f64, f64) = if turned { (v, u) } else { (u, v) };
            let (a, b) = (heights[0] + (heights[1] - heights[0]) * u, heights[3] + (heights[2] - heights[3]) * u);
            a + (b - a) * v
        };
        let k = job.view.scale;
        // Steepest ways along and across the rulings.
        let [h0, h1, h2, h3] = heights;
        let (along, aside) = if turned { (size.y, size.x) } else { (size.x, size.y) };
        let slope = ((h1 - h0).abs().max((h2 - h3).abs()) / along).hypot((h3 - h0).abs().max((h2 - h1).abs()) / aside);
        // No two points of the surface differ in height by more than `slope` times their distance d over ground. The lowest
        // point of the ball runs on the surface, and d beside it the ball is r - √(r² - d²) higher. So at a place it is below
        // the surface by at most slope·d - r + √(r² - d²), which is greatest for the d whose tangent has that slope:
        let sinks = r * ((1.0 + slope * slope).sqrt() - 1.0) + 1e-3;
        // Some line passes within half a gap of every place, and there the ball has left no more than this:
        let gap = across / (cuts - 1.0);
        let aside = (gap / 2.0).min(r);
        let ridge = r - (r * r - aside * aside).sqrt() + slope * aside + 1e-3;
        let (columns, rows) = stock.size();
        for row in 0..rows {
            for column in 0..columns {
                let place = stock.place(column, row);
                let flat = back(&job, place);
                let inside = (flat - corner).cmpge(DVec2::ZERO).all() && (corner + size - flat).cmpge(DVec2::ZERO).all();
                let top = stock.top(column, row).unwrap_or(f64::NEG_INFINITY) / k;
                if inside {
                    let wanted = surface(flat);
                    prop_assert!(top >= wanted - sinks, "{} is below {} at {}{}", top, wanted, flat, done.both);
                    let most = (wanted + ridge).min(job.surface);
                    prop_assert!(top <= most, "{} is above {} at {}{}", top, most, flat, done.both);
                } else {
                    let beyond = (flat - flat.clamp(corner, corner + size)).length();
                    // On the rim of the ball rounding decides whether a column goes.
                    prop_assert!(beyond < r + 1e-9 || (top - job.surface).abs() < 1e-6, "cut beside at {}{}", flat, done.both);
                }
            }
        }
        let highest = heights.into_iter().fold(f64::NEG_INFINITY, f64::max);
        prop_assert!((done.end.z - (highest + 2.0 * r) * k).abs() < 1e-9, "ends at {}{}", done.end, done.both);
    }
}

/// The point of the program that lies at a place of the workpiece.
fn back(job: &Job, place: DVec2) -> DVec2 {
    let view = job.view;
    let p = DVec2::from_angle(-view.turn.to_radians()).rotate(place / view.scale);
    let flip = |yes: bool, value: f64| if yes { -value } else { value };
    DVec2::new(flip(view.mirror[0], p.x), flip(view.mirror[1], p.y))
}
