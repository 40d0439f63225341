//! The insert with which the workpiece is turned: what the tables say of it, how a program corrects it, and how the
//! coordinate system of turning is aligned with it.
//!
//! Invariant: nothing moves; program coordinates follow what changes.
use glam::DVec2;

use super::state::World;
use crate::engine::machine::{InsertCorrection, Tool, TurningInsert};
use crate::engine::report::fault::Fault;
use crate::engine::table::{TableError, TableKind};

/// What is set for turning with the tool in the spindle, up to the next tool call.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Aligned {
    /// The precession angle, degrees.
    pub(crate) precession: f64,
    /// Whether the tool is turned round by half a turn.
    pub(crate) reversed: bool,
    /// How the program corrects the tool.
    pub(crate) correction: InsertCorrection,
}

impl World<'_> {
    /// The insert of the tool in the spindle: that of the table of turning tools, of a tool that it does not have that
    /// of the tool table.
    pub(crate) fn turning_insert(&self) -> Result<TurningInsert, TableError> {
        let Some(Tool { number: tool, .. }) = self.tool() else { return Ok(TurningInsert::default()) };
        let (turning, tools) = (self.table(TableKind::Turning)?, self.table(TableKind::Tool)?);
        let Aligned { reversed, correction, .. } = self.aligned;
        let mut insert = TurningInsert { tool, reversed, ..TurningInsert::default() };
        let listed = turning.has_row(tool);
        if listed || tools.has_row(tool) {
            let table = if listed { turning } else { tools };
            let value = |column| table.number(tool, column).map(Option::unwrap_or_default);
            let of_turning = |column| if listed { value(column) } else { Ok(0.0) };
            insert.radius = value("RS")? + of_turning("DRS")?;
            insert.width = value("CUTWIDTH")? + of_turning("DCW")?;
            // A round insert has no edges beside its nose.
            let round = listed && turning.text(tool, "TYPE").is_ok_and(|kind| kind == "BUTTON");
            if !round {
                (insert.angle, insert.point) = (value("T-ANGLE")?, value("P-ANGLE")?);
            }
            insert.way = TurningInsert::way_of(of_turning("TO")?, reversed);
        }
        insert.radius = (insert.radius + correction.radius).max(0.0);
        if insert.width > 0.0 {
            insert.width = (insert.width + correction.width).max(0.0);
        }
        Ok(insert)
    }

    /// The length of a turning tool with its oversize, mm; nothing if its table does not say it.
    pub(super) fn turning_length(&self, tool: f64) -> Result<Option<f64>, TableError> {
        let table = self.table(TableKind::Turning)?;
        if !table.has_row(tool) {
            return Ok(None);
        }
        let oversize = table.number(tool, "DZL")?.unwrap_or_default();
        Ok(table.number(tool, "ZL")?.map(|length| length + oversize))
    }

    /// Whether it is an insert that runs beside contours, and not the side of the tool. Where a contour is only read,
    /// nothing does.
    pub(crate) fn insert_runs_beside(&self) -> bool {
        self.system.contour_plane() != self.system.plane
    }

    /// Where the tip of the insert is from the centre of its nose, along the axes of the plane of contours, while the nose
    /// runs so far beside a contour.
    pub(crate) fn tip_of_nose(&self, offset: f64) -> Result<DVec2, Fault> {
        if offset == 0.0 || !self.insert_runs_beside() {
            return Ok(DVec2::ZERO);
        }
        let insert = self.turning_insert()?;
        let way = insert.way.ok_or_else(|| Fault::control("orientation-missing").arg("tool", insert.tool))?;
        // The plane goes from the rotary axis to X.
        Ok(DVec2::new(way.y, way.x) * insert.radius)
    }

    /// At which angle the insert is to the main axis while the spindle is at 0, degrees.
    pub(crate) fn insert_angle(&self) -> Result<f64, TableError> {
        let Some(Tool { number, .. }) = self.tool() else { return Ok(0.0) };
        let table = self.table(TableKind::Turning)?;
        if table.has_row(number) { Ok(table.number(number, "ORI")?.unwrap_or_default()) } else { Ok(0.0) }
    }

    /// How turning is aligned with the tool in the spindle.
    pub(crate) const fn aligned(&self) -> Aligned {
        self.aligned
    }

    /// Changes how turning is aligned; program coordinates follow.
    pub(crate) fn align(&mut self, aligned: Aligned) {
        if self.aligned == aligned {
            return;
        }
        self.aligned = aligned;
        let way: Option<DVec2> = self.turning_insert().ok().and_then(|insert| insert.way);
        self.system.set_turned(aligned.precession, aligned.correction.beside(way));
        self.renew();
    }
}
