//! Parallel axes (U, V, W) of the machine: they go where a straight block says, beside the other axes.
//!
//! Invariant: what they carry is not part of the world, so neither the tool path nor the stock follows them; a block that
//! asks for that is a fault.
use crate::engine::flow::state::Run;
use crate::engine::motion::axis::parallel;
use crate::engine::motion::moves::Speed;
use crate::engine::report::ending::Done;
use crate::engine::report::event::{EventKind, Slid};
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Coord, Motion};

impl Run<'_, '_> {
    /// A straight block with parallel axes. Their coordinates are those of the machine; other axes of the block go at the
    /// same time.
    pub(super) fn slide(&mut self, motion: &Motion, in_machine: bool, speed: Result<Speed, Fault>) -> Done {
        let (parallels, others): (Vec<Coord>, Vec<Coord>) =
            motion.coords.iter().copied().partition(|coord| parallel(coord.axis).is_some());
        let mut axes = Vec::with_capacity(parallels.len());
        let mut rapid = f64::INFINITY;
        for coord in &parallels {
            let Some(letter) = parallel(coord.axis) else { continue };
            let missing = || Fault::unsupported("unsupported-axis").arg("axis", coord.axis.name());
            let own = *self.drives.world.scene.machine.parallel(letter).ok_or_else(missing)?;
            let from = self.drives.world.parallel.get(&letter).copied().unwrap_or_default();
            let value = self.operand(&coord.value)? * self.drives.unit();
            let to = if coord.incremental { from + value } else { value };
            if !(own.min..=own.max).contains(&to) {
                let fault = Fault::control("axis-limit").arg("axis", letter.to_string()).arg("found", to);
                return Err(fault.arg("min", own.min).arg("max", own.max).arg("unit", "mm").into());
            }
            if to != from {
                rapid = rapid.min(own.rapid);
                axes.push(Slid { axis: letter, from, to });
            }
        }
        if !axes.is_empty() {
            self.drives.not_beside_contour(&axes.iter().map(|axis| axis.axis).collect::<String>())?;
        }
        let before = (self.drives.world.here, self.drives.world.angles);
        if !others.is_empty() {
            let mut rest = motion.clone();
            rest.coords = others;
            self.line(&rest, in_machine, speed.clone())?;
        }
        if axes.is_empty() {
            return Ok(());
        }
        let longest = axes.iter().map(|axis| (axis.to - axis.from).abs()).fold(0.0, f64::max);
        let way = (self.drives.world.here - before.0).length();
        let feed = match speed? {
            Speed::Rapid => rapid,
            // Axes that go at once end at once.
            Speed::Feed(feed) if way > 0.0 => (feed * longest / way).min(rapid),
            Speed::Feed(feed) => feed.min(rapid),
        };
        let together = before != (self.drives.world.here, self.drives.world.angles);
        self.drives.world.parallel.extend(axes.iter().map(|axis| (axis.axis, axis.to)));
        let at_rapid = self.modal.rapid;
        self.drives.report.report(EventKind::Slide { axes, feed, rapid: at_rapid, together });
        Ok(())
    }
}
