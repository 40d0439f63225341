//! How the insert of a turning tool meets the workpiece in a cycle, as it is reported.
//!
//! Where cuts go along a contour, its tip is in front of the centre of its nose and nearer to the part. Invariant:
//! nothing moves.
use glam::DVec2;

use super::area::{Sight, TIP};
use crate::base::expr::{atan2d, cosd, sind};
use crate::engine::machine::{Insert, InsertForm};
use crate::engine::region::groove::CuttingEdge;
use crate::engine::region::insert_envelope::Insert as Nose;
use crate::engine::report::ending::Done;
use crate::engine::strategy::action::Control;
use crate::engine::table::TableKind;

/// The direction away from the part, as cuts see it, degrees.
const AWAY: f64 = 90.0;

/// What the insert of a cycle is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Held {
    /// One with a nose, and where its tip is from the centre of the nose, in nose radii.
    Pointed(Nose, DVec2),
    /// One with a cutting edge.
    Recessing(CuttingEdge),
    /// One for threads.
    Thread,
}

/// Reports the insert of the tool in the spindle as the cuts of a cycle see it.
pub(super) fn hold(control: &mut dyn Control, sight: Sight, held: Held) -> Done {
    // The table of turning tools has a column of its own for how long the edges are.
    let mut length = 0.0;
    if let Some(tool) = control.tool() {
        for (table, column) in [(TableKind::Turning, "CUTLENGTH"), (TableKind::Tool, "LCUTS")] {
            if length <= 0.0 && control.has_row(table, tool)? {
                length = control.number(table, tool, column)?.unwrap_or_default();
            }
        }
    }
    // Along the main axis and along the rotary axis.
    let in_machine = |seen: DVec2| {
        let point = sight.point(seen, 0.0);
        [point.x, point.z]
    };
    let direction = |angle: f64| {
        let [main, rotary] = in_machine(DVec2::new(cosd(angle), sind(angle)));
        atan2d(main, rotary)
    };
    let (form, radius, width, edges, tip) = match held {
        Held::Pointed(nose, tip) => (InsertForm::Pointed, nose.radius, 0.0, nose.edges, tip),
        Held::Recessing(edge) => (InsertForm::Recessing, edge.radius, edge.width, None, TIP),
        Held::Thread => (InsertForm::Thread, 0.0, 0.0, None, -DVec2::Y),
    };
    let (front, back) = edges.unwrap_or((AWAY, AWAY));
    control.hold_insert(Insert {
        form,
        radius,
        tip: in_machine(tip),
        edges: [front, back].map(direction),
        width: (width, direction(180.0)),
        length: length.max(0.0),
    });
    Ok(())
}
