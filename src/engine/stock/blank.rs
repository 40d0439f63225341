//! The blank: the stock of a scene, or the blank form of a program.
//!
//! Invariant: this is the only place that makes a body of a blank form. The manuals describe the cuboid alone; the cylinder
//! is the form that newer software of the TNC 640 has, with the words that the parser knows.
use glam::{DVec2, DVec3};

use super::{FARTHEST, Stock};
use crate::base::diag::{self, Diagnostic};
use crate::engine::geometry::{Axis, Frame, INCH, WorkingPlane};
use crate::engine::scene::Scene;
use crate::engine::scene::guess::GuessedBlank;
use crate::engine::solid::{Shape, SolidError};
use crate::program::syntax::{self, Amount, Block, BlockKind, Coord, Program, Statement, StatementKind, ValueKind};

/// Why there is no stock.
#[derive(Clone, Debug, PartialEq)]
pub enum StockTrouble {
    /// Neither the scene nor the program has a blank.
    Missing,
    /// The blank of the program has no extent, or its corners are no numbers.
    Blank,
    /// The program has a blank of a form that is not carried out.
    Form {
        /// Its word.
        word: String,
    },
    /// The blank reaches too far from its zero point.
    Extent,
    /// The resolution is not positive or makes too many columns.
    Resolution {
        /// What was asked for.
        found: f64,
    },
    /// The blank, or the part that it is compared with, cannot be decided.
    Solid(SolidError),
}

impl StockTrouble {
    /// As a finding for a reader.
    pub fn diagnostic(&self) -> Diagnostic {
        match self {
            Self::Missing => Diagnostic::global("stock-missing"),
            Self::Blank => Diagnostic::global("stock-blank"),
            Self::Extent => Diagnostic::global("stock-extent").arg("limit", FARTHEST),
            Self::Form { word } => Diagnostic::global("stock-form").arg("word", word.as_str()),
            Self::Resolution { found } => Diagnostic::global("stock-resolution").arg("found", *found),
            Self::Solid(error) => Diagnostic::global(error.code()),
        }
    }

    /// The same with its place in the program, if the blank is the program's: the block that is to blame, or the
    /// beginning of a program without a blank.
    pub fn diagnostic_in(&self, program: &Program, scene: &Scene) -> Diagnostic {
        let mut diagnostic = self.diagnostic();
        if scene.stock.is_none() {
            let blocks = program.blocks();
            let is_form = |block: &&Block| match &block.kind {
                BlockKind::BlkForm(_) => true,
                BlockKind::Statement(statement) => statement.kind == StatementKind::BlkForm,
                _ => false,
            };
            let unknown = blocks.iter().filter(is_form).find(|block| match &block.kind {
                BlockKind::BlkForm(form) => form.coords.iter().any(|coord| corner_value(coord).is_none()),
                _ => true,
            });
            let blamed = unknown.or_else(|| blocks.iter().rfind(is_form)).or_else(|| blocks.first());
            diagnostic.place = blamed.map(|block| {
                let text = program.slice(block.span);
                let start = block.span.start + (text.len() - text.trim_start().len());
                diag::Place::new(program.source(), start..(block.span.start + text.trim_end().len()).max(start))
            });
        }
        diagnostic
    }
}

/// The axis and the number of a coordinate of a corner.
fn corner_value(coord: &Coord) -> Option<(Axis, f64)> {
    match (linear(coord.axis), coord.value.amount) {
        (Some(axis), Amount::Number(value)) => Some((axis, value)),
        _ => None,
    }
}

/// The blank.
#[derive(Clone, Debug)]
pub struct Blank {
    /// Its shape in its own coordinates.
    pub shape: Shape,
    /// The box that holds it.
    pub bounds: [DVec3; 2],
    /// From its coordinates to the machine.
    pub frame: Frame,
    /// The tool axis.
    pub axis: Axis,
}

impl Blank {
    /// The stock of the scene, or the blank form of the program in the coordinates of the preset that is active at
    /// the start.
    ///
    /// # Errors
    /// There is none, or it has no extent.
    pub fn find(program: &Program, scene: &Scene) -> Result<Self, StockTrouble> {
        let form = Self::of_program(program, scene.machine.spindle);
        match &scene.stock {
            None => form.unwrap_or(Err(StockTrouble::Missing)).map(|form| Self { frame: scene.frame, ..form }),
            Some(shape) => {
                let axis = form.and_then(Result::ok).map_or(scene.machine.spindle, |form| form.axis);
                let (frame, shape) = match shape {
                    Shape::Placed { frame, shape } => (*frame, (**shape).clone()),
                    other => (Frame::IDENTITY, other.clone()),
                };
                let bounds = bounds(&shape).ok_or(StockTrouble::Blank)?;
                Ok(Self { shape, bounds, frame, axis })
            }
        }
    }

    /// All parts of a scene as one body, in the coordinates of the preset that is active at the start; nothing if there
    /// are none, or one of them has no end.
    pub fn of_parts(scene: &Scene) -> Option<Self> {
        let axis = scene.machine.spindle;
        let shape = Shape::Placed { frame: scene.frame.inverse(), shape: Box::new(scene.parts.clone()) };
        let [min, max] = around(&scene.parts, &scene.frame.inverse())?;
        let bounds = [min, max];
        min.cmplt(max).all().then_some(Self { shape, bounds, frame: scene.frame, axis })
    }

    /// The body as it is before it is cut, with columns at most so far from each other as a two-hundredth of it.
    ///
    /// # Errors
    /// The body cannot be had, or it is too flat for columns.
    pub fn uncut(&self) -> Result<Stock, StockTrouble> {
        let [min, max] = self.bounds;
        Stock::new(&self.shape, self.bounds, self.frame, self.axis, (max - min).max_element() / 200.0)
    }

    /// What a scene says of it.
    pub fn guessed(&self) -> Option<GuessedBlank> {
        let [_, max] = self.bounds;
        Some(GuessedBlank { solid: self.solid()?, top: max.z })
    }

    /// Its shape as a scene writes a solid (docs/scene.md); nothing for shapes that no blank form has.
    fn solid(&self) -> Option<String> {
        let one = |shape: &Shape| match shape {
            Shape::Box { min, max } => {
                let corner = |p: &DVec3| format!("[{}, {}, {}]", p.x, p.y, p.z);
                Some(format!("{{box: {{min: {}, max: {}}}}}", corner(min), corner(max)))
            }
            Shape::Cylinder { from, to, radius } => {
                let axis = self.axis;
                let is_centred = *from == axis.unit() * axis.of(*from) && *to == axis.unit() * axis.of(*to);
                let (from, to, letter) = (axis.of(*from), axis.of(*to), axis.letter());
                is_centred
                    .then(|| format!("{{cylinder: {{axis: {letter}, radius: {radius}, from: {from}, to: {to}}}}}"))
            }
            _ => None,
        };
        match &self.shape {
            Shape::Difference(shapes) => {
                let all: Option<Vec<String>> = shapes.iter().map(one).collect();
                Some(format!("{{difference: [{}]}}", all?.join(", ")))
            }
            shape => one(shape),
        }
    }

    /// The blank form of a program, in the coordinates of its own; nothing if it has none. `spindle` is the tool axis where
    /// the form names none.
    ///
    /// # Errors
    /// It has no extent, values that are no numbers, or a form that cannot be had.
    pub fn of_program(program: &Program, spindle: Axis) -> Option<Result<Self, StockTrouble>> {
        let mut corners: [Option<DVec3>; 2] = [None, None];
        let mut axis = spindle;
        let mut any = false;
        let mut unit = 1.0;
        for block in program.blocks() {
            let form = match &block.kind {
                BlockKind::BeginPgm(frame) => {
                    unit = if frame.inch { INCH } else { 1.0 };
                    continue;
                }
                BlockKind::Statement(own) if own.kind == StatementKind::BlkForm => {
                    return Some(Self::of_statement(program, own, unit));
                }
                BlockKind::BlkForm(form) => form,
                _ => continue,
            };
            any = true;
            if let Some(found) = form.axis.and_then(linear) {
                axis = found;
            }
            let [first, second] = &mut corners;
            let start = if form.part == 1 { DVec3::ZERO } else { first.unwrap_or(DVec3::ZERO) };
            let mut corner = start;
            let mut known = true;
            for coord in &form.coords {
                match corner_value(coord) {
                    Some((axis, value)) => {
                        let value = value * unit;
                        let value = if coord.incremental { axis.of(start) + value } else { value };
                        corner = axis.with(corner, value);
                    }
                    None => known = false,
                }
            }
            *(if form.part == 1 { first } else { second }) = known.then_some(corner);
        }
        any.then(|| {
            let [Some(min), Some(max)] = corners else { return Err(StockTrouble::Blank) };
            Self::within(Shape::Box { min, max }, [min, max], axis)
        })
    }

    /// `BLK FORM CYLINDER`: about the tool axis, its top at the displacement, its bottom lower by its length.
    fn of_statement(program: &Program, form: &Statement, unit: f64) -> Result<Self, StockTrouble> {
        let word = program.slice(form.head).split_whitespace().last().unwrap_or_default().to_ascii_uppercase();
        if word != "CYLINDER" {
            return Err(StockTrouble::Form { word });
        }
        let names = form.words.iter().map(|word| (program.slice(word.name).trim().to_ascii_uppercase(), word));
        let words: Vec<_> = names.collect();
        let value = |wanted: &str| match words.iter().find(|(name, _)| name == wanted).map(|(_, word)| &word.value.kind)
        {
            None => Ok(None),
            Some(ValueKind::Number(number)) => Ok(Some(number * unit)),
            Some(_) => Err(StockTrouble::Blank),
        };
        let radius = |radius: &str, diameter: &str| -> Result<Option<f64>, StockTrouble> {
            Ok(value(radius)?.or(value(diameter)?.map(|own| own / 2.0)))
        };
        let axis = words.iter().find_map(|(name, _)| match name.as_bytes() {
            &[letter @ b'X'..=b'Z'] => Axis::from_letter(char::from(letter)),
            _ => None,
        });
        let axis = axis.ok_or(StockTrouble::Blank)?;
        let outer = radius("R", "D")?.ok_or(StockTrouble::Blank)?;
        let top = value("DIST")?.unwrap_or(0.0);
        let bottom = top - value("L")?.ok_or(StockTrouble::Blank)?;
        let cylinder = |radius: f64, from: f64, to: f64| Shape::Cylinder {
            from: axis.unit() * from,
            to: axis.unit() * to,
            radius,
        };
        let reach = WorkingPlane::of_tool_axis(axis).lift(DVec2::splat(outer), 0.0);
        let bounds = [axis.with(-reach, bottom), axis.with(reach, top)];
        let body = cylinder(outer, bottom, top);
        let shape = match radius("RI", "DI")? {
            Some(inner) if inner >= outer => return Err(StockTrouble::Blank),
            // The bore is longer than the blank, so that it leaves no skin at the ends.
            Some(inner) if inner > 0.0 => Shape::Difference(vec![body, cylinder(inner, bottom - 1.0, top + 1.0)]),
            _ => body,
        };
        Self::within(shape, bounds, axis)
    }

    /// A body in a box, which must have an extent.
    fn within(shape: Shape, bounds: [DVec3; 2], axis: Axis) -> Result<Self, StockTrouble> {
        let [min, max] = bounds;
        let is_body = min.cmplt(max).all();
        is_body.then_some(Self { shape, bounds, frame: Frame::IDENTITY, axis }).ok_or(StockTrouble::Blank)
    }
}

fn linear(axis: syntax::Axis) -> Option<Axis> {
    axis.name().chars().next().filter(|_| axis.name().len() == 1).and_then(Axis::from_letter)
}

/// A box that holds a body that lies in a frame; nothing if it has no end or is empty.
fn around(shape: &Shape, frame: &Frame) -> Option<[DVec3; 2]> {
    match shape {
        Shape::Placed { frame: inner, shape } => around(shape, &frame.of(*inner)),
        Shape::Union(shapes) => {
            let all: Option<Vec<[DVec3; 2]>> = shapes.iter().map(|shape| around(shape, frame)).collect();
            all?.into_iter().reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
        }
        Shape::Difference(shapes) => around(shapes.first()?, frame),
        Shape::Sphere { centre, radius } => {
            let centre = frame.point(*centre);
            Some([centre - *radius, centre + *radius])
        }
        _ => {
            let [min, max] = bounds(shape)?;
            let corner = |n: u32| {
                let take = |bit: u32, low: f64, high: f64| if n & bit == 0 { low } else { high };
                frame.point(DVec3::new(take(1, min.x, max.x), take(2, min.y, max.y), take(4, min.z, max.z)))
            };
            (0..8).map(corner).map(|p| [p, p]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
        }
    }
}

/// The box that holds a blank.
fn bounds(shape: &Shape) -> Option<[DVec3; 2]> {
    match shape {
        Shape::Box { min, max } => Some([*min, *max]),
        Shape::Cylinder { from, to, radius } => {
            let axis = (*to - *from).normalize_or_zero();
            let reach = |part: f64| radius * (1.0 - part * part).max(0.0).sqrt();
            let reach = DVec3::new(reach(axis.x), reach(axis.y), reach(axis.z));
            Some([from.min(*to) - reach, from.max(*to) + reach])
        }
        Shape::Cone { from, to, radius_from, radius_to } => {
            let end = |from, to, radius| bounds(&Shape::Cylinder { from, to, radius });
            let (one, other) = (end(*from, *to, *radius_from)?, end(*from, *to, *radius_to)?);
            Some([one[0].min(other[0]), one[1].max(other[1])])
        }
        Shape::Difference(shapes) => bounds(shapes.first()?),
        _ => None,
    }
}
