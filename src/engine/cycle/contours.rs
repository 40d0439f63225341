//! Contours that cycles machine: the subprograms that a definition names are executed without moving, and what they
//! describe becomes contours of the working plane.
//!
//! Invariant: the machine, the parameters and the coordinate system are afterwards what they were before; which cycle
//! asks is not known here.
use glam::DVec3;

use super::rehearsal::Before;
use crate::base::expr::Value;
use crate::engine::flow::calls::Call;
use crate::engine::flow::state::Run;
use crate::engine::region::contours::Contour;
use crate::engine::region::{Edge, Flaw, Way};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::solid::Path;
use crate::engine::strategy::contour::Contours;

/// Contours have at most so many elements together (TNC 640 manual, line 4363).
const MOST_ELEMENTS: usize = 16_384;
/// The feed of contours that are only read: any will do.
const ANY_FEED: f64 = 1.0;

impl<'e> Run<'_, 'e> {
    /// Reads the closed contours that the definition in effect names.
    pub(super) fn read_contours(&mut self) -> Done {
        let mut closed = Vec::new();
        for (label, contour) in self.contours_of_labels(usize::MAX)? {
            let about = |code: &'static str| Fault::program(code).arg("label", &*label);
            closed.push(contour.closed().map_err(|flaw| match flaw {
                Flaw::Open { from, to } => about("contour-open").arg("distance", from.distance(to)),
                Flaw::Crossing(at) => about("contour-crossing").arg("x", at.x).arg("y", at.y),
                Flaw::NoArea => about("contour-empty"),
            })?);
        }
        let from = self.drives.in_plane(self.drives.world.here).truncate();
        self.cycles.contours = Contours::new(closed, from);
        Ok(())
    }

    /// Reads the first contour that the definition in effect names, open or closed.
    pub(super) fn read_first_contour(&mut self) -> Done {
        let open = self.contours_of_labels(1)?.into_iter().map(|(_, contour)| contour).collect();
        self.cycles.contours = Contours { open, ..Contours::default() };
        Ok(())
    }

    /// So many contours of the labels in the definition that is in effect, with the present parameters; each with its
    /// label and a side.
    fn contours_of_labels(&mut self, most: usize) -> Done<Vec<(String, Contour)>> {
        let Some(Value::Text(labels)) = self.cycles.remembered.get("contour").cloned() else {
            return Err(Fault::program("contour-not-defined").into());
        };
        let before = self.kept();
        self.modal.feed = Some(ANY_FEED);
        self.drives.report.rehearse(true);
        (self.drives.probing, self.cycles.inside) = (false, 0);
        let labels = labels.split('/').map(str::trim).filter(|label| !label.is_empty()).take(most);
        let contours: Done<Vec<_>> =
            labels.map(|label| Ok((label.to_owned(), self.contour_of(label, &before)?))).collect();
        self.drives.traced = None;
        self.drives.report.rehearse(false);
        let contours = contours?;
        self.return_to(&before);
        self.enter_program();
        if contours.iter().map(|(_, contour)| contour.way.edges.len()).sum::<usize>() > MOST_ELEMENTS {
            return Err(Fault::control("contour-elements").arg("limit", MOST_ELEMENTS as f64).into());
        }
        if let Some((label, _)) = contours.iter().find(|(_, contour)| contour.side == 0) {
            return Err(Fault::program("contour-side-missing").arg("label", &**label).into());
        }
        Ok(contours)
    }

    /// Executes the subprogram of a label, and takes what it describes.
    fn contour_of(&mut self, label: &str, before: &Before<'e>) -> Done<Contour> {
        let missing = || Fault::program("jump-target-missing").arg("label", label);
        let prepared = self.calls.here().ok_or_else(missing)?;
        let block = match label.parse::<u16>() {
            Ok(number) => prepared.numbered_label(number)?,
            Err(_) => prepared.named_label(label.trim_matches('"'))?,
        };
        let depth = self.calls.depth();
        self.calls.call(self.calls.program, block, Call::Subprogram(block), &self.settings.limits)?;
        self.drives.world.stand_aside();
        self.drives.traced = Some(Vec::new());
        (self.blocks)(self, depth + 1)?;
        let side = self.contour.side();
        self.end_contour()?;
        let traced = self.drives.traced.take().unwrap_or_default();
        self.contour_of_moves(&traced, before, side)
            .ok_or_else(|| Fault::program("contour-empty").arg("label", label).into())
    }

    /// The contour of moves in machine coordinates, in the coordinates of the call. The first move goes to where it
    /// begins.
    fn contour_of_moves(&self, moves: &[Path], before: &Before<'e>, side: i8) -> Option<Contour> {
        let system = &before.world.system;
        let (back, up) = (system.back(), system.frame().vector(system.plane.tool.unit()));
        let flat = |point: DVec3| system.in_plane(back.point(point)).truncate();
        let (lead, elements) = moves.split_first()?;
        let edge = |path: &Path| {
            let to = flat(path.at(1.0));
            match *path {
                Path::Line { .. } => Edge::Line(to),
                Path::Arc { centre, axis, sweep, .. } => {
                    // Seen along the tool axis of a mirrored system a circle goes round the other way.
                    let same = (axis.dot(up) > 0.0) != system.frame().mirrors();
                    Edge::Arc { to, centre: flat(centre), sweep: if same { sweep } else { -sweep } }
                }
            }
        };
        Some(Contour { way: Way { start: flat(lead.at(1.0)), edges: elements.iter().map(edge).collect() }, side })
    }
}
