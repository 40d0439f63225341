//! `LN`: straight lines whose blocks give directions, of the surface (`NX NY NZ`) and of the tool (`TX TY TZ`).
//!
//! A tool with oversizes touches the surface where the tool without them does; the program describes the way of the one
//! without. While the tip is held (`M128`, `FUNCTION TCPM`) the rotary axes turn the tool into its direction, or, where a
//! block gives none, across the surface; otherwise the direction of the tool is ignored.
use glam::DVec3;

use crate::engine::flow::state::Run;
use crate::engine::geometry::RotaryAxis;
use crate::engine::motion::moves::Speed;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::table::TableKind;
use crate::program::syntax::Motion;

/// Lengths of directions that differ by less are the same.
const SAME_SIZE: f64 = 1e-9;

impl Run<'_, '_> {
    /// `LN`.
    pub(super) fn line_with_normal(&mut self, motion: &Motion, speed: Result<Speed, Fault>) -> Done {
        let refused = || Fault::unsupported("unsupported-path").arg("word", "LN");
        if self.is_in_contour(motion) {
            return Err(refused().into());
        }
        let nominal = self.target(&motion.coords, self.programmed())?;
        let (normal, tool) = (self.direction_of(motion, 'N')?, self.direction_of(motion, 'T')?);
        let held = self.drives.world.system.tip_held;
        let along = tool.or(normal).filter(|_| held);
        let turns = along.map_or(Ok(Vec::new()), |along| self.drives.turns_along(along))?;
        let (radius, corner) = self.oversizes()?;
        // Where a block gives the direction of the tool alone, nothing says where it touches.
        if (radius, corner) == (0.0, 0.0) || (normal.is_none() && tool.is_some()) {
            return if turns.is_empty() {
                self.straight_block(motion, nominal, speed)
            } else {
                self.turning_line(&turns, nominal, speed)
            };
        }
        let up = along.unwrap_or_else(|| self.drives.world.up().normalize());
        let normal = normal.ok_or_else(|| Fault::program("value-missing"))?;
        // Scaled the oversizes would be, too; below the tool nothing of it touches the surface.
        let unscaled = (self.drives.world.system.frame().vector(normal).length() - 1.0).abs() < SAME_SIZE;
        if !unscaled || normal.dot(up) < -SAME_SIZE {
            return Err(refused().into());
        }
        // The centre of the rounding, of the ring on which it lies, and back to the tip below it.
        let across = normal.reject_from_normalized(up);
        let across = if across.length() < SAME_SIZE { DVec3::ZERO } else { across.normalize() };
        let to = nominal + (normal - up) * corner + across * (radius - corner);
        self.contour.forget();
        self.turning_line(&turns, to, speed)?;
        self.contour.went_along(nominal, self.drives.world.here);
        Ok(())
    }

    /// A straight line of the tip on which rotary axes turn.
    fn turning_line(&mut self, turns: &[(RotaryAxis, f64)], to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let speed = self.plunging_speed(to, speed);
        self.contour.forget();
        self.drives.turn_and_go(turns, to, None, speed, None)
    }

    /// A direction of a block, of length 1: `NX NY NZ` or `TX TY TZ`. Nothing where it has none of the three.
    fn direction_of(&self, motion: &Motion, letter: char) -> Result<Option<DVec3>, Fault> {
        let part = |axis: char| {
            let is_it = |name: &str| name.trim().chars().map(|c| c.to_ascii_uppercase()).eq([letter, axis]);
            let word = motion.words.iter().find(|word| is_it(self.slice(word.name)));
            word.map(|word| self.number_of(&word.value)).transpose()
        };
        let parts = [part('X')?, part('Y')?, part('Z')?];
        if parts.iter().all(Option::is_none) {
            return Ok(None);
        }
        let direction = DVec3::from_array(parts.map(Option::unwrap_or_default));
        if direction.length() > 0.0 { Ok(Some(direction.normalize())) } else { Err(Fault::program("value-missing")) }
    }

    /// The oversizes of the tool in radius and corner radius, those of the table and of the call together, mm. Its length
    /// is compensated whatever it is.
    fn oversizes(&self) -> Result<(f64, f64), Fault> {
        let Some(tool) = self.drives.world.tool() else { return Ok((0.0, 0.0)) };
        let table = self.drives.world.table(TableKind::Tool)?;
        let oversize = |column| table.number(tool.number, column).map(Option::unwrap_or_default);
        Ok((oversize("DR")? + tool.deltas.0, oversize("DR2")?))
    }
}
