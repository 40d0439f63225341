//! Free contours as a program writes them: the blocks from one element on to the last one are read ahead, solved together
//! and executed one after the other.
//!
//! Between the elements come roundings, chamfers, poles, selections, M functions and comments; any other block ends the
//! contour. Parameters cannot change in between, so reading ahead finds the values with which the blocks are executed.
use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use crate::base::expr::{cosd, sind};
use crate::engine::contour::element::{Element, Shape};
use crate::engine::contour::free::{Datum, Flaw, Given, Missing, Point, solve};
use crate::engine::flow::state::{Run, Solved};
use crate::engine::geometry::Axis as LinearAxis;
use crate::engine::motion::axis::linear;
use crate::engine::motion::moves::{Speed, Turn};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Axis, Block, BlockKind, Coord, Motion, NamedWord, Path, StatementKind, ValueKind};

/// Where a contour that was solved goes on: mm.
const SAME: f64 = 1e-6;

/// What of a program belongs to a free contour: by element, its block.
#[derive(Default)]
struct Ahead {
    given: Vec<Given>,
    blocks: Vec<usize>,
    selections: Vec<usize>,
    /// By printed number: how many elements of the contour have ended with that block.
    numbers: BTreeMap<u32, usize>,
    /// The element that `CLSD+` begins.
    begun: Option<usize>,
}

/// An axis that a word names after its first letters.
fn axis_of(word: &str, head: &str) -> Option<LinearAxis> {
    match word.strip_prefix(head)? {
        "X" => Some(LinearAxis::X),
        "Y" => Some(LinearAxis::Y),
        "Z" => Some(LinearAxis::Z),
        _ => None,
    }
}

impl Run<'_, '_> {
    /// `FL`, `FLT`, `FC`, `FCT`: the element as the whole contour determines it.
    pub(super) fn free_element(&mut self, motion: &Motion, speed: Result<Speed, Fault>) -> Done {
        let plane = self.drives.world.system.contour_plane();
        let from = self.programmed();
        let here = (self.calls.program, self.calls.block);
        let solved = self.free.elements.front().filter(|(block, element)| {
            (self.free.program, *block) == here && element.from.distance(plane.flat(from)) < SAME
        });
        if solved.is_none() {
            self.solve_ahead()?;
        }
        let Some((_, Element { to, shape, .. })) = self.free.elements.pop_front() else {
            return Err(Fault::unsupported("unsupported-path").arg("word", "FL").into());
        };
        let height = plane.tool.of(from);
        let to = plane.lift(to, height);
        match shape {
            Shape::Line => self.straight_block(motion, to, speed),
            Shape::Arc { centre, sweep } => {
                let centre = plane.lift(centre, height);
                self.arc_block(motion, Turn { plane, centre, direction: sweep.signum(), sweep: Some(sweep) }, to, speed)
            }
        }
    }

    /// `FPOL`: the pole of the elements that follow.
    pub(super) fn free_pole(&mut self, motion: &Motion) -> Done {
        let from = self.programmed();
        self.modal.free_pole = Some(self.pole_of(motion, Some(from))?);
        Ok(())
    }

    /// `FSELECT`: it belongs to the elements before it, with which it was read.
    pub(super) fn selection(&self) -> Done {
        let known = self.free.program == self.calls.program && self.free.selections.contains(&self.calls.block);
        if known { Ok(()) } else { Err(selection(0, 0).into()) }
    }

    fn pole_of(&self, motion: &Motion, from: Option<DVec3>) -> Result<DVec2, Fault> {
        let plane = self.drives.world.system.contour_plane();
        let mut pole = DVec3::ZERO;
        let mut axes = Vec::with_capacity(2);
        for coord in &motion.coords {
            let axis = linear(coord.axis)?;
            let Some(now) = from.or(Some(DVec3::ZERO).filter(|_| !coord.incremental)) else {
                return Err(out_of_place(coord.axis.name()));
            };
            pole = axis.with(pole, self.coordinate(coord, axis.of(now))?);
            axes.push(axis);
        }
        if axes.contains(&plane.main) && axes.contains(&plane.secondary) && axes.len() == 2 {
            Ok(plane.flat(pole))
        } else {
            Err(Fault::program("pole-missing"))
        }
    }

    /// Reads the contour from the block being executed on, and solves it.
    fn solve_ahead(&mut self) -> Done {
        let plane = self.drives.world.system.contour_plane();
        let ahead = self.read_ahead()?;
        let start = plane.flat(self.programmed());
        let heading = self.contour.heading(&self.drives.world).ok();
        let program = self.calls.program;
        match solve(start, heading, &ahead.given) {
            Ok(elements) => {
                let elements = ahead.blocks.into_iter().zip(elements).collect();
                self.free = Solved { program, elements, selections: ahead.selections };
                Ok(())
            }
            Err(flaw) => {
                let (element, fault) = told(flaw);
                self.contour.blame((program, ahead.blocks.get(element).copied().unwrap_or(self.calls.block)));
                Err(fault.into())
            }
        }
    }

    fn read_ahead(&mut self) -> Result<Ahead, Fault> {
        let mut ahead = Ahead::default();
        let Some(blocks) = self.calls.here().map(|prepared| prepared.program.blocks()) else { return Ok(ahead) };
        let first = self.calls.block;
        let before = blocks.get(..first).unwrap_or_default().iter().rev();
        if let Some(number) = before.filter(|block| matches!(block.kind, BlockKind::Motion(_))).find_map(|b| b.number) {
            ahead.numbers.insert(number, 0);
        }
        let mut pole = self.modal.free_pole;
        for (index, block) in blocks.iter().enumerate().skip(first) {
            if block.skip && self.settings.skip_blocks {
                continue;
            }
            if !self.takes_ahead((index, block), &mut ahead, &mut pole).inspect_err(|_| {
                self.contour.blame((self.calls.program, index));
            })? {
                break;
            }
        }
        Ok(ahead)
    }

    /// Takes in a block that follows an element; whether the contour goes on.
    fn takes_ahead(
        &self,
        (index, block): (usize, &Block),
        ahead: &mut Ahead,
        pole: &mut Option<DVec2>,
    ) -> Result<bool, Fault> {
        match &block.kind {
            BlockKind::Motion(element) => match element.path() {
                Path::Fl | Path::Flt | Path::Fc | Path::Fct => {
                    let given = self.given(&element.words(), *pole, ahead)?;
                    ahead.given.push(given);
                    ahead.blocks.push(index);
                    if let Some(number) = block.number {
                        ahead.numbers.insert(number, ahead.given.len());
                    }
                }
                Path::Fpol => *pole = Some(self.pole_of(&element.words(), None)?),
                Path::Rnd | Path::Chf => {}
                _ => return Ok(false),
            },
            BlockKind::Statement(own) if own.kind == StatementKind::Fselect => {
                let number = own.words.first().map_or(Ok(0.0), |word| self.number_of(&word.value))?;
                if let Some(last) = ahead.given.last_mut() {
                    // Where it is no whole number, no solution is meant.
                    last.selected.push(if number.fract() == 0.0 && number > 0.0 { number as usize } else { 0 });
                    ahead.selections.push(index);
                }
            }
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) | BlockKind::Functions(_) => {}
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// The words of an element.
    fn given(&self, motion: &Motion, pole: Option<DVec2>, ahead: &mut Ahead) -> Result<Given, Fault> {
        let words = Words { run: self, motion, ahead, pole };
        let mut given = Given {
            is_arc: matches!(motion.path, Path::Fc | Path::Fct),
            is_tangential: matches!(motion.path, Path::Flt | Path::Fct),
            pole,
            end: words.end()?,
            heading: words.heading()?,
            length: words.length("LEN")?,
            centre: words.centre()?,
            radius: motion.radius.as_ref().map(|radius| self.operand(radius)).transpose()?,
            counter_clockwise: motion.counter_clockwise,
            sweep: words.either("CCA", "ICCA")?.map(f64::abs),
            on: ["P1", "P2", "P3"]
                .into_iter()
                .filter_map(|name| words.point(name).transpose())
                .collect::<Result<_, _>>()?,
            beside: words.beside()?,
            parallel: words.parallel()?,
            closes: None,
            selected: Vec::new(),
        };
        if let Some(radius) = &mut given.radius {
            *radius *= self.drives.unit();
        }
        let positive = [given.radius, given.length, given.sweep];
        if positive.into_iter().flatten().any(|size| size <= 0.0) || given.sweep.is_some_and(|sweep| sweep > 360.0) {
            return Err(Fault::program("free-contour-contradicts"));
        }
        let closed = words.find("CLSD").and_then(|word| match word.value.kind {
            ValueKind::Sign(negative) => Some(negative),
            _ => None,
        });
        match closed {
            Some(false) => ahead.begun = Some(ahead.given.len()),
            // What begins nowhere cannot be closed.
            Some(true) => given.closes = Some(ahead.begun.take().ok_or_else(|| open(Missing::End, 1))?),
            None => {}
        }
        Ok(given)
    }
}

/// The words of an element, and what they are read with.
struct Words<'w, 'r, 'e> {
    run: &'w Run<'r, 'e>,
    motion: &'w Motion,
    ahead: &'w Ahead,
    pole: Option<DVec2>,
}

impl Words<'_, '_, '_> {
    fn find(&self, name: &str) -> Option<&NamedWord> {
        self.motion.words.iter().find(|word| self.run.slice(word.name).trim().eq_ignore_ascii_case(name))
    }

    fn number(&self, name: &str) -> Result<Option<f64>, Fault> {
        self.find(name).map(|word| self.run.number_of(&word.value)).transpose()
    }

    /// In mm.
    fn length(&self, name: &str) -> Result<Option<f64>, Fault> {
        Ok(self.number(name)?.map(|number| number * self.run.drives.unit()))
    }

    fn either(&self, name: &str, other: &str) -> Result<Option<f64>, Fault> {
        Ok(self.number(name)?.or(self.number(other)?))
    }

    /// The block to which a word refers: how many elements of the contour have ended with it.
    fn reference(&self, name: &str) -> Result<Option<usize>, Fault> {
        let Some(number) = self.number(name)? else { return Ok(None) };
        let found = self.ahead.numbers.iter().find(|(own, _)| f64::from(**own) == number);
        let Some((_, joint)) = found else {
            return Err(Fault::program("free-contour-reference").arg("block", number));
        };
        Ok(Some(*joint))
    }

    /// The main and secondary axis.
    fn axes(&self) -> [LinearAxis; 2] {
        let plane = self.run.drives.world.system.contour_plane();
        [plane.main, plane.secondary]
    }

    /// Words end with the letters of axes; those of the tool axis have no place.
    fn coordinate(&self, head: &str, axis: LinearAxis) -> Result<Option<f64>, Fault> {
        let found = self.motion.words.iter().find(|word| {
            let name = self.run.slice(word.name).trim().to_ascii_uppercase();
            axis_of(&name, head) == Some(axis)
        });
        let Some(word) = found else { return Ok(None) };
        let scale = self.run.drives.unit() / self.run.drives.world.system.doubled(axis);
        Ok(Some(self.run.number_of(&word.value)? * scale))
    }

    /// From where a coordinate counts: it is absolute, from the beginning of its element, or from another block.
    fn datum(&self, value: f64, incremental: bool, reference: Option<usize>) -> Datum {
        Datum { value, from: reference.or_else(|| incremental.then_some(self.ahead.given.len())) }
    }

    fn end(&self) -> Result<Point, Fault> {
        let mut end = Point::default();
        let axes = self.axes();
        for coord in &self.motion.coords {
            let Coord { axis, incremental, .. } = *coord;
            let value = self.run.coordinate(&Coord { incremental: false, ..*coord }, 0.0)?;
            let place = match axis {
                Axis::Pr | Axis::Pa => {
                    self.needs_pole()?;
                    let name = if axis == Axis::Pr { "RPR" } else { "RPA" };
                    let datum = self.datum(value, incremental, self.reference(name)?);
                    end.polar[usize::from(axis == Axis::Pa)] = Some(datum);
                    continue;
                }
                axis => linear(axis)?,
            };
            let Some(index) = axes.iter().position(|own| *own == place) else { return Err(out_of_place(axis.name())) };
            let reference = self.reference(["RX", "RY", "RZ"][place as usize])?;
            end.cartesian[index] = Some(self.datum(value, incremental, reference));
        }
        Ok(end)
    }

    fn centre(&self) -> Result<Point, Fault> {
        let mut centre = Point::default();
        for (index, axis) in self.axes().into_iter().enumerate() {
            let reference = self.reference(["RCCX", "RCCY", "RCCZ"][axis as usize])?;
            let absolute = self.coordinate("CC", axis)?.map(|value| self.datum(value, false, reference));
            let relative = self.coordinate("ICC", axis)?.map(|value| self.datum(value, true, reference));
            centre.cartesian[index] = absolute.or(relative);
        }
        let radius = (self.length("CCPR")?, self.length("ICCPR")?);
        let angle = (self.number("CCPA")?, self.number("ICCPA")?);
        for (index, (absolute, relative)) in [radius, angle].into_iter().enumerate() {
            let reference = self.reference(["RCCPR", "RCCPA"][index])?;
            let absolute = absolute.map(|value| self.datum(value, false, reference));
            centre.polar[index] = absolute.or(relative.map(|value| self.datum(value, true, reference)));
            if centre.polar[index].is_some() {
                self.needs_pole()?;
            }
        }
        Ok(centre)
    }

    fn needs_pole(&self) -> Result<DVec2, Fault> {
        self.pole.ok_or_else(|| Fault::program("pole-missing"))
    }

    /// `AN`, and `IAN`, which counts from the direction at the end of the element before it or of another block (`RAN`).
    fn heading(&self) -> Result<Option<Datum>, Fault> {
        let reference = self.reference("RAN")?;
        let absolute = self.number("AN")?.map(|value| self.datum(value, false, reference));
        Ok(absolute.or(self.number("IAN")?.map(|value| self.datum(value, true, reference))))
    }

    /// A point on the element.
    fn point(&self, name: &str) -> Result<Option<DVec2>, Fault> {
        let [main, secondary] = self.axes();
        match (self.coordinate(name, main)?, self.coordinate(name, secondary)?) {
            (Some(x), Some(y)) => Ok(Some(DVec2::new(x, y))),
            (None, None) => Ok(None),
            _ => Err(out_of_place(name)),
        }
    }

    /// `PDX`, `PDY` or `PDPR`, `PDPA`, and `D`, the distance of that point.
    fn beside(&self) -> Result<Option<(DVec2, f64)>, Fault> {
        let polar = match (self.length("PDPR")?, self.number("PDPA")?) {
            (Some(radius), Some(angle)) => {
                Some(self.needs_pole()? + DVec2::new(radius * cosd(angle), radius * sind(angle)))
            }
            (None, None) => None,
            _ => return Err(out_of_place("PDPR")),
        };
        match (self.point("PD")?.or(polar), self.length("D")?) {
            (Some(at), Some(far)) => Ok(Some((at, far.abs()))),
            (None, None) => Ok(None),
            (None, Some(_)) => Err(out_of_place("D")),
            (Some(_), None) => Err(out_of_place("PD")),
        }
    }

    fn parallel(&self) -> Result<Option<(usize, Option<f64>)>, Fault> {
        let far = self.length("DP")?.map(f64::abs);
        match self.reference("PAR")? {
            Some(joint) => Ok(Some((joint, far))),
            None if far.is_some() => Err(out_of_place("DP")),
            None => Ok(None),
        }
    }
}

/// A word that means nothing where it is written.
fn out_of_place(word: &str) -> Fault {
    Fault::program("free-contour-word").arg("word", word.to_owned())
}

fn open(missing: Missing, values: usize) -> Fault {
    let what = match missing {
        Missing::Line => "line",
        Missing::Arc => "arc",
        Missing::End => "end",
    };
    Fault::program("free-contour-open").arg("what", what).arg("values", values as f64)
}

fn selection(wanted: usize, solutions: usize) -> Fault {
    let fault = Fault::program("free-contour-selection").arg("wanted", wanted as f64);
    fault.arg("solutions", solutions as f64)
}

/// Which element is to blame, and for what.
fn told(flaw: Flaw) -> (usize, Fault) {
    match flaw {
        Flaw::Contradiction { element } => (element, Fault::program("free-contour-contradicts")),
        Flaw::Open { element, missing, values } => (element, open(missing, values)),
        Flaw::Several { element, solutions } => {
            (element, Fault::program("free-contour-several").arg("solutions", solutions as f64))
        }
        Flaw::Selection { element, wanted, solutions } => (element, selection(wanted, solutions)),
    }
}
