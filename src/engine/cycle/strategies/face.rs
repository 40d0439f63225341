//! The strategy that mills a flat surface at one level in lines.
//!
//! Invariant: the level begins where the tool is, at one of the corners of the surface.
use glam::DVec3;

use super::clear::MAX_OUTLINES;
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::motion::moves::Speed;
use crate::engine::plan::StrategyCall;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::{Class, Fault};

/// The mode in which all lines of a level have the same direction.
const SAME_DIRECTION: f64 = 2.0;

impl<'e> Run<'_, 'e> {
    pub(super) fn mill_face_level(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let [mode, begin, end, inner_begin, inner_end] = self.all_given(call, 0, exec)?;
        let [first, step, lines, across, lift] = self.all_given(call, 5, exec)?;
        let feed = self.feed_given(call, exec)?;
        if lines.is_nan() || lines > MAX_OUTLINES {
            return Err(Fault::new(Class::Limit, "series-limit").arg("limit", MAX_OUTLINES).into());
        }
        let lines = lines.max(1.0) as u32;
        let minor = |line: u32| first + step * f64::from(line);
        let here = self.drives.in_plane(self.drives.world.here);
        let level = here.z;
        let mut at_begin = (here.x - begin).abs() <= (here.x - end).abs();
        let backwards = (here.y - minor(lines - 1)).abs() < (here.y - minor(0)).abs();
        for done in 0..lines {
            let line = if backwards { lines - 1 - done } else { done };
            let last = done + 1 == lines;
            let main = match (at_begin, last) {
                (true, true) => end,
                (true, false) => inner_end,
                (false, true) => begin,
                (false, false) => inner_begin,
            };
            self.face_to(DVec3::new(main, minor(line), level), feed)?;
            if last {
                break;
            }
            let next = minor(if backwards { line - 1 } else { line + 1 });
            if mode == SAME_DIRECTION {
                let back = if at_begin { begin } else { end };
                self.face_to(DVec3::new(main, minor(line), lift), across)?;
                self.face_to(DVec3::new(back, next, lift), across)?;
                self.face_to(DVec3::new(back, next, level), across)?;
            } else {
                self.face_to(DVec3::new(main, next, level), across)?;
                at_begin = !at_begin;
            }
        }
        Ok(())
    }

    fn face_to(&mut self, to: DVec3, feed: f64) -> Done {
        self.drives.straight_to(self.drives.world.system.axes(to), None, Speed::of_feed(feed))
    }
}
