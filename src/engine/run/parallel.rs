//! Parallel axes (U, V, W) of the machine: they go where a straight block says, beside the other axes.
//!
//! Invariant: what they carry is not part of the world, so neither the tool path nor the stock follows them where they
//! move by themselves. With `FUNCTION PARAXMODE` one moves instead of the linear axis beside it: the program goes on with
//! X, Y and Z, and the tool goes where it says. With `FUNCTION PARAXCOMP MOVE` the linear axis takes the way of the
//! parallel one back, and the tool stays.
use std::collections::BTreeSet;

use glam::DVec3;

use crate::engine::flow::state::Run;
use crate::engine::geometry::Axis as LinearAxis;
use crate::engine::motion::axis::parallel;
use crate::engine::motion::moves::Speed;
use crate::engine::report::ending::Done;
use crate::engine::report::event::{EventKind, Slid};
use crate::engine::report::fault::Fault;
use crate::engine::world::parallel::beside;
use crate::program::syntax::{Coord, Motion, Statement};

impl Run<'_, '_> {
    /// A straight block with parallel axes. Their coordinates are those of the machine; other axes of the block go at the
    /// same time.
    pub(super) fn slide(&mut self, motion: &Motion, in_machine: bool, speed: Result<Speed, Fault>) -> Done {
        let (parallels, others): (Vec<Coord>, Vec<Coord>) =
            motion.coords.iter().copied().partition(|coord| parallel(coord.axis).is_some());
        let mut axes = Vec::with_capacity(parallels.len());
        let mut rapid = f64::INFINITY;
        let mut back = DVec3::ZERO;
        for coord in &parallels {
            let Some(letter) = parallel(coord.axis) else { continue };
            let missing = || Fault::unsupported("unsupported-axis").arg("axis", coord.axis.name());
            let own = *self.drives.world.scene.machine.parallel(letter).ok_or_else(missing)?;
            let from = self.drives.world.parallels.at(letter);
            let value = self.operand(&coord.value)? * self.drives.unit();
            let to = if coord.incremental { from + value } else { value };
            if !(own.min..=own.max).contains(&to) {
                let fault = Fault::control("axis-limit").arg("axis", letter.to_string()).arg("found", to);
                return Err(fault.arg("min", own.min).arg("max", own.max).arg("unit", "mm").into());
            }
            if to != from {
                rapid = rapid.min(own.rapid);
                axes.push(Slid { axis: letter, from, to });
                if let Some(linear) = self.drives.world.parallels.taken_back_by(letter) {
                    back = linear.with(back, linear.of(back) - (to - from));
                    rapid = rapid.min(self.drives.world.scene.machine.axis(linear).map_or(rapid, |axis| axis.rapid));
                }
            }
        }
        if !axes.is_empty() {
            self.drives.not_beside_contour(axes.iter().map(|axis| axis.axis).collect::<String>())?;
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
        let world = &self.drives.world;
        let linear = world.parallels.linear(world.machine);
        if let Some(beyond) = world.scene.machine.beyond_limits(linear + back) {
            let fault = Fault::control("axis-limit").arg("axis", beyond.axis.letter().to_string());
            let fault = fault.arg("found", beyond.axis.of(linear + back)).arg("min", beyond.min).arg("max", beyond.max);
            return Err(fault.arg("unit", "mm").into());
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
        axes.iter().for_each(|axis| self.drives.world.parallels.moved(axis.axis, axis.to));
        let taken_back = LinearAxis::ALL.into_iter().filter(|axis| axis.of(back) != 0.0);
        axes.extend(taken_back.map(|axis| {
            let from = axis.of(linear);
            Slid { axis: axis.letter(), from, to: from + axis.of(back) }
        }));
        let at_rapid = self.modal.rapid;
        self.drives.report.report(EventKind::Slide { axes, feed, rapid: at_rapid, together });
        Ok(())
    }

    /// The letters of axes in a `FUNCTION` block, without its other words.
    fn letters(&self, statement: &Statement, others: &[&str]) -> Result<Vec<char>, Fault> {
        let mut letters = Vec::new();
        for word in &statement.words {
            let name = self.slice(word.name).trim().to_ascii_uppercase();
            if others.contains(&name.as_str()) {
                continue;
            }
            let mut chars = name.chars();
            match (chars.next(), chars.next()) {
                (Some(letter @ ('U'..='Z')), None) => letters.push(letter),
                _ => {
                    let word = format!("{} {name}", self.slice(statement.head));
                    return Err(Fault::unsupported("unsupported-block").arg("word", word));
                }
            }
        }
        for letter in letters.iter().filter(|letter| beside(**letter).is_some()) {
            if self.drives.world.scene.machine.parallel(*letter).is_none() {
                return Err(Fault::unsupported("unsupported-axis").arg("axis", letter.to_string()));
            }
        }
        Ok(letters)
    }

    /// `FUNCTION PARAXCOMP`: `MOVE` with axes whose way the linear axes take back from now on, and no other; without it
    /// none.
    pub(super) fn compensate_parallel(&mut self, statement: &Statement) -> Done {
        let is_move = statement.words.iter().any(|word| self.slice(word.name).trim().eq_ignore_ascii_case("MOVE"));
        let letters = if is_move { self.letters(statement, &["MOVE"])? } else { Vec::new() };
        self.drives.world.parallels.compensate(letters.into_iter().collect::<BTreeSet<_>>());
        Ok(())
    }

    /// `FUNCTION PARAXMODE X Y W`: the axes that move where a program says X, Y and Z, one of each direction. `OFF`: the
    /// linear ones.
    pub(super) fn choose_axes(&mut self, statement: &Statement) -> Done {
        self.drives.not_beside_contour("FUNCTION PARAXMODE")?;
        let letters = self.letters(statement, &["OFF"])?;
        let direction = |letter: &char| beside(*letter).or(LinearAxis::from_letter(*letter));
        let of = |axis: LinearAxis| letters.iter().filter(move |letter| direction(letter) == Some(axis)).count();
        if !letters.is_empty() && LinearAxis::ALL.into_iter().any(|axis| of(axis) != 1) {
            return Err(Fault::program("value-missing").into());
        }
        let chosen: Vec<char> = letters.iter().copied().filter(|letter| beside(*letter).is_some()).collect();
        let world = &mut self.drives.world;
        world.parallels.choose(&chosen, world.machine);
        Ok(())
    }

    /// While a parallel axis moves instead of a linear one, a block that names it, the linear axis by itself (`&Z`) or
    /// machine coordinates is a fault: from where those count, and what the other axis does meanwhile, the machine
    /// builder decides.
    pub(super) fn only_driven(&self, motion: &Motion, in_machine: bool) -> Done {
        let refused = |word: String| Err(Fault::unsupported("unsupported-path").arg("word", word).into());
        if in_machine {
            return refused("M91".to_owned());
        }
        for coord in &motion.coords {
            let own = parallel(coord.axis).is_some_and(|letter| self.drives.world.parallels.drives(letter));
            if own || self.slice(coord.span).starts_with('&') {
                let mark = if own { "" } else { "&" };
                return refused(format!("{mark}{}", coord.axis.name()));
            }
        }
        Ok(())
    }
}
