//! A cutter from the side, to scale: a flat end, a point, a rounded corner or a ball, and a shank that is cut off above.
//!
//! Invariant: everything but the tool itself is on the sheet, in pixels.
use glam::DVec2;

use super::pen::{Pen, short};
use crate::base::expr::tand;
use crate::engine::machine::Tool;

/// The end of a cutter on the sheet.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    /// Half its width.
    pub(super) radius: f64,
    /// The height of its point; 0 if it has none.
    pub(super) rise: f64,
    /// The radius between end and side: 0 of a flat end, half the width of a ball.
    pub(super) corner: f64,
}

impl End {
    /// The end of a tool with its radius, as large as the sheet shows it.
    pub(super) fn of(tool: &Tool, scale: f64) -> Self {
        let radius = tool.radius * scale;
        let rise = if tool.point > 0.0 { radius / tand(tool.point / 2.0) } else { 0.0 };
        Self { radius, rise, corner: tool.corner * scale }
    }
}

/// The data of its outline, with the middle of its end there, up to the height where the drawing ends, or beyond it if
/// the tool is so far up that nothing of its shank could be seen.
pub(super) fn outline(end: End, place: DVec2, top: f64) -> String {
    let End { radius, rise, corner } = end;
    let corner = if rise > 0.0 { 0.0 } else { corner.clamp(0.0, radius) };
    let wave = (radius * 0.35).min(5.0);
    let at = |x: f64, y: f64| DVec2::new(place.x + x, y);
    let shoulder = place.y - rise - corner;
    let top = top.min(shoulder - 3.0 * wave);
    let shank = [
        at(radius, shoulder),
        at(radius, top + wave),
        at(radius / 3.0, top),
        at(-radius / 3.0, top + 2.0 * wave),
        at(-radius, top + wave),
        at(-radius, shoulder),
    ];
    if corner <= 0.0 {
        return Pen::data(&[&[place], &shank[..]].concat(), true);
    }
    let flat = [at(corner - radius, place.y), at(radius - corner, place.y)];
    let arc = |to: DVec2| format!("A{0} {0} 0 0 0 {1} {2}", short(corner), short(to.x), short(to.y));
    let (flat_end, side) = (Pen::data(&flat, false), Pen::data(&shank, false));
    // The side begins where the first arc ends.
    let side = side.find('L').map_or("", |after| &side[after..]);
    format!("{flat_end}{}{side}{}Z", arc(shank[0]), arc(flat[0]))
}
