//! What is done in a tilted plane: whether it meets the blank at all.
use super::watcher::Watcher;
use crate::check::Incident;
use crate::engine::solid::Path;
use crate::spec::CycleKey;

/// So far outside of the blank a hole in a tilted plane still meets it, mm.
const MEETS: f64 = 1.0;

impl Watcher<'_> {
    /// A movement while nothing is said of where the tool goes: what it may remove, if that is known.
    pub(super) fn cut_tilted(&mut self, path: &Path, feeds: bool, plain: bool) {
        if !feeds || self.is_probe() {
            return;
        }
        self.worked = true;
        // Without a tilted plane, where tool and workpiece are to each other depends on the machine.
        if self.lost || self.across || !self.tilted || self.depends_on_machine || self.known != [true; 3] {
            self.remains.open = true;
            self.tilted_ways = None;
        } else {
            let places = self.places_of(path);
            if let Some(body) = self.body {
                let reach = self.radius() + MEETS;
                let met = !plain || places.iter().any(|place| body.holds(*place, -reach));
                let (line, before) = self.tilted_ways.unwrap_or((self.line, false));
                self.tilted_ways = Some((line, before || met));
            }
            self.cut(&places);
        }
    }

    /// All that was done in a tilted plane, or with a tool in it, is over.
    pub(super) fn judge_tilted_ways(&mut self) {
        if let Some((line, false)) = self.tilted_ways.take() {
            self.report(line, Incident::OutsideBlank([self.at.x * self.unit, self.at.y * self.unit]));
        }
    }

    /// A movement in a tilted plane to which the rotary axes have turned: whether a cycle for holes meets the blank at
    /// all.
    pub(super) fn drill_tilted(&mut self, path: &Path, feeds: bool, key: Option<CycleKey>) {
        let turned = self.angles.iter().any(|(_, angle)| angle.abs() > 1e-6);
        let certain = self.tilted && turned && !self.lost && !self.across && !self.depends_on_machine;
        let certain = certain && self.known == [true; 3];
        let drills = key.and_then(|key| self.cycle(key)).is_some_and(|own| {
            matches!(super::work::job(own), Some(super::work::Job::Hole | super::work::Job::Thread))
        });
        if !drills || self.tilted_holes.is_some_and(|(line, _)| line != self.line) {
            self.judge_tilted();
        }
        let Some(body) = self.body.filter(|_| drills && feeds && certain && !self.is_probe()) else { return };
        let met = self.places_of(path).into_iter().any(|place| body.holds(place, -MEETS));
        let (_, before) = self.tilted_holes.unwrap_or((self.line, false));
        self.tilted_holes = Some((self.line, before || met));
    }

    /// A cycle for holes in the tilted plane is over.
    pub(super) fn judge_tilted(&mut self) {
        if let Some((line, false)) = self.tilted_holes.take() {
            self.report(line, Incident::MissesBlankInTiltedPlane);
        }
    }
}
