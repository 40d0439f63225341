//! Contours that cycles machine: the subprograms and programs that are named as such are executed without moving, and
//! what they describe becomes contours of the working plane, and areas that formulas combine.
//!
//! Invariant: the machine, the parameters and the coordinate system are afterwards what they were before; which cycle
//! asks is not known here.
use std::sync::Arc;

use glam::{DVec2, DVec3};

use crate::base::expr::{QKind, Value};
use crate::engine::flow::calls::{Call, program_key};
use crate::engine::flow::sources::{Listed, Of, Selected, Sources};
use crate::engine::flow::state::Run;
use crate::engine::geometry::Axis;
use crate::engine::motion::blank::TurnedBlank;
use crate::engine::region::contours::Contour;
use crate::engine::region::formula::{self, Unknown};
use crate::engine::region::relief::{Operator, Relief};
use crate::engine::region::{Edge, Flaw, Region, Way};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::solid::Path;
use crate::engine::strategy::contour::Contours;
use crate::engine::world::coordinates::System;
use crate::engine::world::state::ASIDE;
use crate::program::syntax::{ContourFormula, NamedWord, Statement, ValueKind};

/// Contours have at most so many elements together (TNC 640 manual, line 4363).
const MOST_ELEMENTS: usize = 16_384;
/// Formulas consist of so many contours at most (TNC 640 manual, lines 5464 and 5864).
const MOST_CONTOURS: usize = 128;
/// A simple formula consists of so many (line 5860).
const MOST_LISTED: usize = 9;
/// What a definition remembers that names the labels of contours.
pub(super) const LABELS: &str = "contour";
/// Ways along the tool axis that are shorter, mm, are rounding.
const LEVEL: f64 = 1e-6;
/// How much deeper a contour may be by calculation alone, mm.
const SPARE: f64 = 1e-6;
/// The feed of contours that are only read: any will do.
const ANY_FEED: f64 = 1.0;

/// What a contour is read for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reading {
    /// A subprogram that a cycle machines: its first block has both coordinates of the plane, and it has none in the tool
    /// axis (TNC 640 manual, lines 4374-4375).
    OfLabel,
    /// A part of a formula: coordinates in the tool axis are ignored (lines 5892-5893).
    OfFormula,
    /// A contour that is turned.
    Turned,
}

impl<'e> Run<'_, 'e> {
    /// Reads the closed contours that are in effect, down to a depth below the surface, mm.
    pub(super) fn read_contours(&mut self, depth: f64) -> Done {
        let from = self.drives.in_plane(self.drives.world.here).truncate();
        let relief = match self.cycles.sources.selected.clone() {
            None => {
                let mut closed = Vec::new();
                for (label, contour) in self.contours_of_labels(usize::MAX)? {
                    closed.push(contour.closed().map_err(|flaw| flawed(flaw, &label))?);
                }
                self.cycles.contours = Contours::new(closed, from, depth);
                return Ok(());
            }
            Some(Selected::Formula(number)) => self.cycles.sources.declared.get(&number).cloned(),
            Some(Selected::Program(program)) => self.contour_of_formulas(program)?,
            Some(Selected::List(list)) => Some(self.contour_of_list(&list)?),
        };
        let relief = relief.ok_or_else(|| Fault::program("contour-not-defined"))?;
        if relief.deepest() > depth + SPARE {
            return Err(Fault::program("contour-depth").arg("what", "cycle").arg("depth", relief.deepest()).into());
        }
        let bands = relief.bands(depth);
        if bands.is_empty() {
            return Err(Fault::program("contour-not-defined").into());
        }
        self.cycles.contours = Contours { bands, from, ..Contours::default() };
        Ok(())
    }

    /// Reads the first contour that the definition in effect names, open or closed.
    pub(super) fn read_first_contour(&mut self) -> Done {
        let open = self.contours_of_labels(1)?.into_iter().map(|(_, contour)| contour).collect();
        self.cycles.contours = Contours { open, ..Contours::default() };
        Ok(())
    }

    /// The first contour that the definition in effect names, open or closed, as one that is turned: `x` along the
    /// rotary axis, `y` a radius. Circles, roundings and chamfers lie in the plane of the tool axis and the main axis.
    pub(super) fn read_turned_contour(&mut self) -> Done<Way> {
        let Some(Value::Text(labels)) = self.cycles.remembered.get(LABELS).cloned() else {
            return Err(Fault::program("contour-not-defined").into());
        };
        let label = labels.split('/').map(str::trim).find(|label| !label.is_empty());
        let label = label.ok_or_else(|| Fault::program("contour-not-defined"))?.trim_matches('"');
        Ok(self.turned_contour(&Of::Label(label.into()))?.way)
    }

    fn turned_contour(&mut self, of: &Of) -> Done<Contour> {
        let contour = self.described(|run, before| {
            let across = before.plane.secondary;
            let mut half = System::clone(before);
            half.set_plane(across);
            run.drives.world.system.set_plane(across);
            run.drives.world.renew();
            run.contour_of(of, &half, Reading::Turned)
        })?;
        if contour.way.edges.len() > MOST_ELEMENTS {
            return Err(Fault::control("contour-elements").arg("limit", MOST_ELEMENTS as f64).into());
        }
        Ok(contour)
    }

    /// `FUNCTION TURNDATA BLANK LBL 20`, `BLANK RING.H`, `BLANK FILE=QS1`: the blank that turning updates from now on,
    /// described by a subprogram or a program as a closed contour in the half plane; `OFF` ends that.
    pub(crate) fn describe_blank(&mut self, words: &[NamedWord]) -> Done {
        let mut of = None;
        for word in words {
            let name = self.slice(word.name).trim().to_ascii_uppercase();
            let value = match word.value.kind {
                ValueKind::Q { q, .. } if q.kind == QKind::Qs => self.params.text(q)?.trim().to_owned(),
                ValueKind::Q { q, .. } => self.params.number(q)?.to_string(),
                ValueKind::Text(span) => self.slice(span).trim().to_owned(),
                _ => self.slice(word.value.span).trim().to_owned(),
            };
            match (name.as_str(), value.as_str()) {
                ("OFF", "") | ("", "OFF" | "off") => {
                    self.drives.blank = None;
                    return Ok(());
                }
                ("LBL", label) => of = Some(Of::Label(label.into())),
                // The name follows.
                ("FILE", "") => {}
                ("" | "FILE", name) if !name.is_empty() => {
                    of = Some(Of::Program(self.program_named(name)?, name.into()));
                }
                (name, _) => {
                    let word = format!("TURNDATA BLANK {name}");
                    return Err(Fault::unsupported("unsupported-block").arg("word", word).into());
                }
            }
        }
        let of = of.ok_or_else(|| Fault::program("contour-not-defined"))?;
        let contour = self.turned_contour(&of)?;
        let boundary = contour.boundary().map_err(|flaw| flawed(flaw, of.name()))?;
        let way = Way { start: boundary.start(), edges: boundary.edges() };
        self.drives.blank = Some(TurnedBlank::new(&way, self.drives.world.system.frame()));
        Ok(())
    }

    /// Reads the first contour that the definition in effect names, in the development of a cylinder: X is the way round
    /// it, in degrees if there are so many mm in one, and Y the way along it, whatever the axes of the machine are
    /// (TNC 640 manual, lines 5105-5109).
    pub(super) fn read_developed_contour(&mut self, mm_in_degree: Option<f64>) -> Done {
        let plane = self.drives.world.system.plane;
        if plane.tool != Axis::Z {
            let axis = plane.tool.letter().to_string();
            return Err(Fault::unsupported("unsupported-axis").arg("axis", axis).into());
        }
        self.drives.world.system.unrolled = mm_in_degree;
        let read = self.contours_of_labels(1);
        self.drives.world.system.unrolled = None;
        let read = read?;
        // The plane in which the contour lies is that of the development: what mirrors and turns it acts there.
        let system = &self.drives.world.system;
        let turned = system.turned_about_datum();
        let place = |at: DVec2| system.in_plane(turned.point(system.axes(at.extend(0.0)))).truncate();
        let open = read.into_iter().map(|(_, contour)| contour.placed(&place, turned.mirrors())).collect();
        self.cycles.contours = Contours { open, ..Contours::default() };
        Ok(())
    }

    /// `SEL CONTOUR "MODEL"`.
    pub(crate) fn select_contour(&mut self, name: &str) -> Done {
        self.cycles.sources.selected = Some(Selected::Program(self.program_named(name)?));
        Ok(())
    }

    /// `DECLARE CONTOUR QC1 = "CIRCLE" DEPTH5`: the contour is that of the present parameters.
    pub(crate) fn declare_contour(&mut self, statement: &Statement) -> Done {
        let (mut name, mut depth) = (None, None);
        for word in &statement.words {
            let key = self.slice(word.name).trim().to_ascii_uppercase();
            match key.strip_prefix("QC").map(|number| number.trim().parse::<u32>()) {
                Some(Ok(number)) => name = Some((number, self.source_of(&word.value)?)),
                _ => depth = self.depth_word(&key, word)?,
            }
        }
        let Some((number, of)) = name else { return Err(Fault::program("contour-not-defined").into()) };
        let relief = self.described(|run, before| run.relief_of(&of, depth, before))?;
        self.cycles.sources.declared.insert(number, counted(relief)?);
        Ok(())
    }

    /// `QC10 = ( QC1 | QC2 ) \\ QC3`: the contour of the cycles that follow.
    pub(crate) fn contour_formula(&mut self, formula: &ContourFormula) -> Done {
        let text = self.slice(formula.text);
        let declared = &self.cycles.sources.declared;
        let relief = formula::evaluate(text, |number| declared.get(&number).cloned()).map_err(|unknown| {
            let contour = match unknown {
                Unknown::Contour(number) => format!("QC{number}"),
                Unknown::Form => text.trim().to_owned(),
            };
            Fault::program("contour-undeclared").arg("what", "nothing").arg("contour", contour)
        })?;
        self.cycles.sources.declared.insert(formula.target, counted(relief)?);
        self.cycles.sources.selected = Some(Selected::Formula(formula.target));
        Ok(())
    }

    /// `CONTOUR DEF P1 = "POCKET.H" I2 = LBL 2 DEPTH5`.
    pub(crate) fn define_contour(&mut self, statement: &Statement) -> Done {
        let mut list: Vec<Listed> = Vec::new();
        for word in &statement.words {
            let key = self.slice(word.name).trim().to_ascii_uppercase();
            match key.as_bytes() {
                [kind @ (b'P' | b'I'), b'0'..=b'9', ..] => {
                    list.push(Listed { of: self.source_of(&word.value)?, is_pocket: *kind == b'P', depth: None });
                }
                _ => {
                    let depth = self.depth_word(&key, word)?;
                    // It belongs to the contour before it.
                    if let Some(last) = list.last_mut() {
                        last.depth = depth;
                    }
                }
            }
        }
        if list.len() > MOST_LISTED {
            return Err(Fault::control("contour-count").arg("limit", MOST_LISTED as f64).into());
        }
        // The first one is the deepest pocket (TNC 640 manual, lines 5920 and 5929).
        let first = list.first().and_then(|first| first.depth);
        let depths = list.iter().filter(|own| own.is_pocket).map(|own| own.depth.unwrap_or(f64::INFINITY));
        let deepest = depths.fold(0.0, f64::max);
        if first.is_some_and(|first| deepest > first + SPARE) {
            return Err(Fault::program("contour-depth").arg("what", "first").arg("depth", deepest).into());
        }
        self.cycles.sources.selected = Some(Selected::List(list.into()));
        Ok(())
    }

    /// A depth of its own, mm; 0 is that of the contour data.
    fn depth_word(&self, key: &str, word: &NamedWord) -> Result<Option<f64>, Fault> {
        if key != "DEPTH" {
            return Err(Fault::unsupported("unsupported-block").arg("word", key));
        }
        let depth = self.number_of(&word.value)? * self.drives.unit();
        // It is written without a sign (TNC 640 manual, line 5931).
        if depth < 0.0 {
            return Err(Fault::program("parameter-out-of-range").arg("q", "DEPTH").arg("value", depth));
        }
        Ok(Some(depth).filter(|depth| *depth > 0.0))
    }

    fn program_named(&mut self, name: &str) -> Result<usize, Fault> {
        let name = name.trim().trim_matches('"');
        let program = self.calls.called(program_key(name), self.settings);
        program.ok_or_else(|| Fault::program("program-missing").arg("name", name))
    }

    /// What a word names: a program, a label, or a text parameter with the name of a program.
    fn source_of(&mut self, value: &crate::program::syntax::Value) -> Result<Of, Fault> {
        let text = match value.kind {
            ValueKind::Q { q, .. } if q.kind == QKind::Qs => self.params.text(q)?.to_string(),
            _ => self.slice(value.span).trim().to_owned(),
        };
        let label = text.get(..3).filter(|head| head.eq_ignore_ascii_case("LBL")).and_then(|_| text.get(3..));
        match label {
            Some(label) => Ok(Of::Label(label.trim().into())),
            None => Ok(Of::Program(self.program_named(&text)?, text.trim().trim_matches('"').into())),
        }
    }

    /// The contour of the last formula of a program.
    fn contour_of_formulas(&mut self, program: usize) -> Done<Option<Relief>> {
        let own = std::mem::take(&mut self.cycles.sources);
        let found = self.described(|run, before| {
            run.cycles.sources.reading = Some(Arc::clone(before));
            let depth = run.calls.depth();
            run.calls.call(program, 0, Call::Program, &run.settings.limits)?;
            run.enter_program();
            (run.blocks)(run, depth + 1)?;
            let Sources { selected, declared, .. } = &mut run.cycles.sources;
            Ok(match selected {
                Some(Selected::Formula(number)) => declared.remove(number),
                _ => None,
            })
        });
        self.cycles.sources = own;
        found
    }

    /// Pockets together, without the islands after them.
    fn contour_of_list(&mut self, list: &[Listed]) -> Done<Relief> {
        self.described(|run, before| {
            let mut relief: Option<Relief> = None;
            for Listed { of, is_pocket, depth } in list {
                let own = run.relief_of(of, *depth, before)?;
                let operator = if *is_pocket { Operator::Or } else { Operator::Without };
                relief = Some(match relief {
                    Some(relief) => relief.joined(operator, &own),
                    None if *is_pocket => own,
                    None => Relief::new(Region::default(), 0, None).joined(operator, &own),
                });
            }
            relief.map(counted).transpose()?.ok_or_else(|| Fault::program("contour-not-defined").into())
        })
    }

    /// What a contour encloses that is described without a side, with its own depth.
    fn relief_of(&mut self, of: &Of, depth: Option<f64>, before: &System) -> Done<Relief> {
        let contour = self.contour_of(of, before, Reading::OfFormula)?;
        let boundary = contour.boundary().map_err(|flaw| flawed(flaw, of.name()))?;
        Ok(Relief::new(Region::within(&boundary), contour.way.edges.len(), depth))
    }

    /// Executes what describes contours without moving; afterwards all is as it was. Within a program with declarations
    /// its transformations stay.
    fn described<T>(&mut self, read: impl FnOnce(&mut Self, &Arc<System>) -> Done<T>) -> Done<T> {
        if let Some(before) = self.cycles.sources.reading.clone() {
            return read(self, &before);
        }
        let before = self.kept();
        let system = Arc::new(before.world.system.clone());
        self.modal.feed = Some(ANY_FEED);
        self.drives.report.rehearse(true);
        (self.drives.probing, self.cycles.inside) = (false, 0);
        let found = read(self, &system);
        self.drives.traced = None;
        self.drives.report.rehearse(false);
        let found = found?;
        self.return_to(&before);
        self.enter_program();
        Ok(found)
    }

    /// So many contours of the labels in the definition that is in effect, with the present parameters; each with its
    /// label and a side.
    fn contours_of_labels(&mut self, most: usize) -> Done<Vec<(String, Contour)>> {
        let Some(Value::Text(labels)) = self.cycles.remembered.get(LABELS).cloned() else {
            return Err(Fault::program("contour-not-defined").into());
        };
        let labels = labels.split('/').map(str::trim).filter(|label| !label.is_empty()).take(most);
        let contours = self.described(|run, before| {
            let own = |label: &str| Of::Label(label.trim_matches('"').into());
            labels
                .map(|label| Ok((label.to_owned(), run.contour_of(&own(label), before, Reading::OfLabel)?)))
                .collect::<Done<Vec<_>>>()
        })?;
        if contours.iter().map(|(_, contour)| contour.way.edges.len()).sum::<usize>() > MOST_ELEMENTS {
            return Err(Fault::control("contour-elements").arg("limit", MOST_ELEMENTS as f64).into());
        }
        if let Some((label, _)) = contours.iter().find(|(_, contour)| contour.side == 0) {
            return Err(Fault::program("contour-side-missing").arg("label", &**label).into());
        }
        Ok(contours)
    }

    /// Executes what describes a contour, and takes it.
    fn contour_of(&mut self, of: &Of, before: &System, reading: Reading) -> Done<Contour> {
        let (program, block, call) = match of {
            Of::Program(number, _) => (*number, 0, Call::Program),
            Of::Label(label) => {
                let missing = || Fault::program("jump-target-missing").arg("label", &**label);
                let prepared = self.calls.here().ok_or_else(missing)?;
                let block = match label.parse::<u16>() {
                    Ok(number) => prepared.numbered_label(number)?,
                    Err(_) => prepared.named_label(label.trim_matches('"'))?,
                };
                (self.calls.program, block, Call::Subprogram(block))
            }
        };
        let depth = self.calls.depth();
        self.calls.call(program, block, call, &self.settings.limits)?;
        self.enter_program();
        let here = self.drives.world.machine;
        self.drives.world.stand_aside(reading != Reading::Turned);
        self.drives.traced = Some(Vec::new());
        // Local parameters that a subprogram of a contour uses it must set itself (TNC 640 manual, line 4367).
        let is_label = matches!(of, Of::Label(_));
        let locals = if is_label { self.params.take_locals() } else { None };
        (self.blocks)(self, depth + 1)?;
        if is_label {
            self.params.return_locals(locals);
        }
        let side = self.contour.side();
        self.end_contour()?;
        self.enter_program();
        let traced = self.drives.traced.take().unwrap_or_default();
        let up = before.frame().vector(before.plane.tool.unit()).normalize();
        // What the first block leaves out shows by being where nothing is.
        let is_incomplete = |lead: &Path| (lead.at(1.0) - here).reject_from_normalized(up).length() > ASIDE / 2.0;
        if reading != Reading::Turned && traced.first().is_some_and(is_incomplete) {
            return Err(Fault::program("contour-begin-incomplete").arg("label", of.name()).into());
        }
        let is_level = |path: &Path| (path.at(1.0) - path.at(0.0)).dot(up).abs() < LEVEL;
        if reading == Reading::OfLabel && !traced.iter().all(is_level) {
            return Err(Fault::program("contour-tool-axis").arg("label", of.name()).into());
        }
        self.contour_of_moves(&traced, before, side)
            .ok_or_else(|| Fault::program("contour-empty").arg("label", of.name()).into())
    }

    /// The contour of moves in machine coordinates, in the coordinates of the call. The first move goes to where it
    /// begins.
    fn contour_of_moves(&self, moves: &[Path], before: &System, side: i8) -> Option<Contour> {
        let system = before;
        let (back, up) = (system.back(), system.frame().vector(system.plane.tool.unit()));
        // The axes of the machine, and the tip that a turned head has moved.
        let swung = self.drives.world.swung();
        let flat = |point: DVec3| system.in_plane(back.point(point + swung)).truncate();
        let (lead, elements) = moves.split_first()?;
        let edge = |path: &Path| {
            let to = flat(path.at(1.0));
            match *path {
                Path::Line { .. } => Edge::Line(to),
                Path::Arc { centre, axis, sweep, .. } => {
                    // Seen along the tool axis of a mirrored system a circle goes round the other way.
                    let same = (axis.dot(up) > 0.0) != system.frame().mirrors();
                    Edge::Arc { to, centre: flat(centre), sweep: if same { sweep } else { -sweep } }
                }
            }
        };
        Some(Contour { way: Way { start: flat(lead.at(1.0)), edges: elements.iter().map(edge).collect() }, side })
    }
}

/// The same relief, unless it consists of more than a control keeps.
fn counted(relief: Relief) -> Result<Relief, Fault> {
    if relief.contours > MOST_CONTOURS {
        return Err(Fault::control("contour-count").arg("limit", MOST_CONTOURS as f64));
    }
    if relief.elements > MOST_ELEMENTS {
        return Err(Fault::control("contour-elements").arg("limit", MOST_ELEMENTS as f64));
    }
    Ok(relief)
}

/// What is wrong with the contour of a label or program.
fn flawed(flaw: Flaw, name: &str) -> Fault {
    let about = |code: &'static str| Fault::program(code).arg("label", name);
    match flaw {
        Flaw::Open { from, to } => about("contour-open").arg("distance", from.distance(to)),
        Flaw::Crossing(at) => about("contour-crossing").arg("x", at.x).arg("y", at.y),
        Flaw::NoArea => about("contour-empty"),
    }
}
