//! Times, ways, volumes and engagement of the report against closed forms.
use ciklo::engine::stock::Report;
use proptest::prelude::*;

use super::setup::{config, machine};

/// Accelerations in mm/s² and rapid traverse in mm/min, by axis.
const GAINS: [f64; 3] = [1000.0, 500.0, 250.0];
const RAPIDS: [f64; 3] = [6000.0, 9000.0, 3000.0];
/// How far the control may round a corner, mm (`docs/stock.md`).
const CORNER: f64 = 0.01;

fn report(body: &str) -> Report {
    let axis = |n: usize, name: char| {
        format!("{{axis: {name}, min: -500, max: 500, rapid: {}, acceleration: {}}}", RAPIDS[n], GAINS[n])
    };
    let scene = format!(
        "scene: 1\nmachine: {{axes: [{}, {}, {}]}}\ntools: [{{T: 1, L: 50, R: 5}}]\nstart: [0, 0, 100]\n",
        axis(0, 'X'),
        axis(1, 'Y'),
        axis(2, 'Z')
    );
    let program = format!(
        "BEGIN PGM CLOCK MM\nBLK FORM 0.1 Z X+0 Y+0 Z-20\nBLK FORM 0.2 X+100 Y+60 Z+0\nTOOL CALL 1 Z S1000\n{body}END PGM CLOCK MM\n"
    );
    let (outcome, _, _, report) = machine(&program, &scene, 1.0);
    assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
    report
}

/// The time of a way with even acceleration, from one speed to another, at most at a third (mm, mm/s, mm/s²).
fn time(way: f64, most: f64, gain: f64, from: f64, to: f64) -> f64 {
    let up = (most * most - from * from) / (2.0 * gain);
    let down = (most * most - to * to) / (2.0 * gain);
    if up + down <= way {
        (most - from) / gain + (most - to) / gain + (way - up - down) / most
    } else {
        // The greatest speed v with (v² - from²) + (v² - to²) = 2 gain · way.
        let v = (gain * way + (from * from + to * to) / 2.0).sqrt();
        (2.0 * v - from - to) / gain
    }
}

/// What the slowest axis allows in a direction.
fn along(limits: [f64; 3], way: [f64; 3]) -> f64 {
    let length = way.iter().map(|part| part * part).sum::<f64>().sqrt();
    let shares = limits.iter().zip(way).filter(|(_, part)| *part != 0.0);
    shares.map(|(limit, part)| limit * length / part.abs()).fold(f64::INFINITY, f64::min)
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-7 * (1.0 + b.abs())
}

laws! {
    #![proptest_config(config())]

    /// From rest to rest, in any direction; short ways never reach the feed.
    #[test]
    fn one_way_takes_its_time(x in -90.0..90.0_f64, y in -90.0..90.0_f64, z in -9.0..90.0_f64, feed in 50.0..20000.0_f64, rapid in any::<bool>()) {
        let way = [x, y, z];
        let length = way.iter().map(|part| part * part).sum::<f64>().sqrt();
        let word = if rapid { "FMAX".to_owned() } else { format!("F{feed}") };
        let report = report(&format!("L IX{x:+} IY{y:+} IZ{z:+} R0 {word}\n"));
        let speed = if rapid { along(RAPIDS, way) } else { feed } / 60.0;
        let wanted = time(length, speed, along(GAINS, way), 0.0, 0.0);
        let (own, other) = if rapid { (report.time_rapid, report.time_feed) } else { (report.time_feed, report.time_rapid) };
        prop_assert!(near(own, wanted) && other == 0.0, "{own} {wanted}");
        let own = if rapid { report.length_rapid } else { report.length_feed };
        prop_assert!(near(own, length), "{own} {length}");
    }

    /// On one line, the second feed begins at the speed of the first one, or at what both can reach.
    #[test]
    fn feeds_change_without_a_stop(first in 20.0..90.0_f64, second in 20.0..90.0_f64, slow in 100.0..1000.0_f64, fast in 1000.0..3000.0_f64) {
        let report = report(&format!("L IX+{first} R0 F{slow}\nL IX+{second} F{fast}\n"));
        let (slow, fast, gain) = (slow / 60.0, fast / 60.0, GAINS[0]);
        let wanted = time(first, slow, gain, 0.0, slow) + time(second, fast, gain, slow, 0.0);
        prop_assert!(near(report.time_feed, wanted), "{} {wanted}", report.time_feed);
    }

    /// At a corner the speed is that of the arc between its legs which stays within the tolerance.
    #[test]
    fn corners_slow_down(first in 10.0..90.0_f64, second in 10.0..90.0_f64, angle in 5.0..175.0_f64, feed in 300.0..4000.0_f64) {
        let (s, c) = angle.to_radians().sin_cos();
        let report = report(&format!("L IX+{first} R0 F{feed}\nL IX{:+} IY{:+}\n", second * c, second * s));
        let speed = feed / 60.0;
        let gain = along(GAINS, [c, s, 0.0]);
        // Of a circle that touches both legs, the corner is r (1/cos(a/2) - 1) away: r follows from that distance.
        let half = (angle / 2.0).to_radians().cos();
        let radius = CORNER / (1.0 / half - 1.0);
        let corner = (gain * radius).sqrt().min(speed);
        let wanted = time(first, speed, GAINS[0], 0.0, corner) + time(second, speed, gain, corner, 0.0);
        prop_assert!(near(report.time_feed, wanted), "{} {wanted}", report.time_feed);
    }

    /// On a circle the slowest axis must hold the speed.
    #[test]
    fn circles_are_as_fast_as_the_slowest_axis(radius in 0.5..40.0_f64, feed in 100.0..6000.0_f64) {
        let report = report(&format!("CC X-{radius} Y+0\nC X+0 Y+0 DR+ R0 F{feed}\n"));
        let gain = GAINS[2];
        let speed = (feed / 60.0).min((gain * radius).sqrt());
        let way = std::f64::consts::TAU * radius;
        prop_assert!(near(report.time_feed, time(way, speed, gain, 0.0, 0.0)), "{}", report.time_feed);
        prop_assert!(near(report.length_feed, way), "{} {way}", report.length_feed);
    }

    /// A slot through the whole blank: volume, depth, width and rate are products of its measures.
    #[test]
    fn slots_have_the_volume_of_their_measures(depth in 1..19_u8, row in 10..50_u8, feed in 100.0..900.0_f64, again in 1..4_u8) {
        let (depth, row) = (f64::from(depth), f64::from(row));
        let there = format!("L X-10 Y+{row} R0 FMAX M3\nL Z-{depth} FMAX\n");
        let back = "L Z+5 FMAX\n";
        let passes: String = (0..again).map(|_| format!("{there}L X+110 F{feed}\n{back}")).collect();
        let report = report(&passes);
        let again = f64::from(again);
        let volume = 100.0 * 10.0 * depth;
        prop_assert!(near(report.removed, volume) && near(report.blank, 100.0 * 60.0 * 20.0), "{} {volume}", report.removed);
        prop_assert!(near(report.depth.value, depth), "{:?}", report.depth);
        // The width is measured between columns of 1 mm.
        prop_assert!((report.width.value - 10.0).abs() <= 1.0, "{:?}", report.width);
        prop_assert!(near(report.rate.value, volume / 120.0 * feed), "{:?}", report.rate);
        // Only the first way cuts.
        prop_assert!(near(report.length_cut, 120.0) && near(report.length_feed, 120.0 * again), "{}", report.length_cut);
        prop_assert_eq!((report.cuts, report.moves), (1, 4 * again as u64 ));
        prop_assert!(report.findings.is_empty(), "{:?}", report.findings);
    }

    /// Beside a wall a tool is engaged as wide as it overlaps.
    #[test]
    fn side_milling_is_as_wide_as_its_overlap(overlap in 1..10_u8, depth in 1..19_u8) {
        let (overlap, depth) = (f64::from(overlap), f64::from(depth));
        let report = report(&format!("L X-10 Y{:+} R0 FMAX M3\nL Z-{depth} FMAX\nL X+110 F500\n", overlap - 5.0));
        prop_assert!(near(report.removed, 100.0 * overlap * depth), "{}", report.removed);
        prop_assert!((report.width.value - overlap).abs() <= 1.0, "{:?} {overlap}", report.width);
        prop_assert!(near(report.depth.value, depth), "{:?}", report.depth);
    }
}

/// Dwells are waited for, and the machine stands before and after them, as at a tool call.
#[test]
fn dwells_and_tool_calls_interrupt() {
    let straight = report("L IX+60 R0 F1200\nL IX+30\n");
    let waited = report("L IX+60 R0 F1200\nCYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 1.5\nL IX+30\n");
    let changed = report("L IX+60 R0 F1200\nTOOL CALL 1 Z S1000\nL IX+30\n");
    let (speed, gain) = (20.0, GAINS[0]);
    assert!(near(straight.time_feed, time(90.0, speed, gain, 0.0, 0.0)), "{}", straight.time_feed);
    let twice = time(60.0, speed, gain, 0.0, 0.0) + time(30.0, speed, gain, 0.0, 0.0);
    assert!(
        near(waited.time_feed, twice) && near(waited.time_dwell, 1.5),
        "{} {}",
        waited.time_feed,
        waited.time_dwell
    );
    assert!(near(changed.time_feed, twice), "{}", changed.time_feed);
}
