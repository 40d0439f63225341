//! The body that the engine leaves of a blank, for the laws of turning: what cycles do, followed by the stock.
use std::fmt::Write as _;

use ciklo::base::diag::Source;
use ciklo::engine::region::section::{Cell, Section};
use ciklo::engine::run::{Engine, Event, FindingKind, NoTexts, Status};
use ciklo::engine::scene::Scene;
use ciklo::engine::stock::{Machining, Report};
use ciklo::program::syntax;
use glam::DVec2;
use proptest::prelude::*;

use crate::built::{Built, built};

/// A blank: what lies between two places of the rotary axis, and two radii.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ring {
    pub z: [f64; 2],
    pub radii: [f64; 2],
}

impl Ring {
    fn scene(&self) -> String {
        let [from, to] = self.z;
        let cylinder = |radius: f64| format!("{{cylinder: {{radius: {radius}, from: {from}, to: {to}}}}}");
        let outer = cylinder(self.radii[1]);
        match self.radii[0] > 0.0 {
            true => format!("stock: {{difference: [{outer}, {}]}}\n", cylinder(self.radii[0])),
            false => format!("stock: {outer}\n"),
        }
    }

    /// The block that makes it the blank that turning updates, if that is wanted, and the subprogram for it.
    pub(crate) fn updated(&self, is_wanted: bool) -> (&'static str, String) {
        if !is_wanted {
            return ("", String::new());
        }
        let ([from, to], [inner, outer]) = (self.z, self.radii.map(|radius| 2.0 * radius));
        let mut text = format!("LBL 20\nL X{inner:+} Z{from:+}\nL X{outer:+}\n");
        let _ = write!(text, "L Z{to:+}\nL X{inner:+}\nL Z{from:+}\nLBL 0\n");
        ("FUNCTION TURNDATA BLANK LBL 20\n", text)
    }

    /// Whether it has a point, by more than a margin.
    pub(crate) fn has(&self, point: DVec2, margin: f64) -> bool {
        let within = |[low, high]: [f64; 2], at: f64| low + margin < at && at < high - margin;
        within(self.z, point.x) && within(self.radii, point.y)
    }
}

/// What is left of a blank.
pub(crate) struct Left {
    cells: Vec<Cell>,
    /// The volume of the blank, mm³.
    volume: f64,
    report: Report,
}

/// The events of a program in a scene, and what it leaves of a blank.
pub(crate) fn run(
    program: &str,
    scene: &str,
    blank: Option<Ring>,
) -> Result<(Vec<Event>, Option<Left>), TestCaseError> {
    let Built { files, catalogue, .. } = built();
    let text = format!("{scene}{}", blank.map_or_else(String::new, |blank| blank.scene()));
    let scene = Scene::parse(&Source::new("scene.yaml", text.clone()), files);
    let scene = scene.unwrap_or_else(|found| panic!("{found:?}\n{text}"));
    let tree = syntax::parse(&Source::new("LAW.H", program.to_owned()));
    let mut machining = blank.map(|_| Machining::new(&tree, &scene, Some(20.0)).expect("a blank"));
    let mut events = Vec::new();
    let engine = Engine::new(&tree, catalogue.on("tnc640").expect("a control"), &scene, &NoTexts);
    let outcome = engine.with_catalogue(catalogue).run(&mut |event| {
        if let Some(machining) = &mut machining {
            machining.see(&event);
        }
        events.push(event.clone());
    });
    prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, program);
    let left = machining.zip(blank).map(|(machining, Ring { z, radii })| {
        let report = machining.finish().1;
        // Where no insert came into the half plane of the blank, all of it is left.
        let whole = Section::ring(z, radii);
        let (volume, cells) = match &report.turned {
            Some(cells) => (report.blank, cells.clone()),
            None => (whole.volume(), whole.in_order()),
        };
        Left { cells, volume, report }
    });
    Ok((events, left))
}

impl Left {
    /// Whether there is material at a place of the rotary axis and a radius.
    pub(crate) fn has(&self, point: DVec2) -> bool {
        self.cells.iter().any(|cell| cell.contains(point))
    }

    /// Its volume, mm³.
    pub(crate) fn volume(&self) -> f64 {
        self.cells.iter().map(Cell::volume).sum()
    }

    /// Rapid traverse stays in the open after roughing, the insert is always known, and nothing is lost but what was cut.
    pub(crate) fn is_sound(&self, roughed: bool, program: &str) -> Result<(), TestCaseError> {
        let found = &self.report.findings;
        let is_known = |kind| !roughed && kind == FindingKind::Rapid;
        prop_assert!(found.iter().all(|found| is_known(found.kind)), "{:?}\n{}", found, program);
        let (blank, removed, rest) = (self.volume, self.report.removed, self.volume());
        prop_assert!((blank - removed - rest).abs() < 1e-9 * blank, "{} {} {}\n{}", blank, removed, rest, program);
        Ok(())
    }
}
