//! Scenes: the world in which a program runs, as one YAML file. `docs/scene.md` describes the form.
//!
//! Invariant: a scene that is read is sound (numbers are finite, solids have an extent, the active preset
//! exists, the machine can be at the start), and anything unknown in it was an error with its place.
mod answers;
mod clock;
pub mod guess;
mod kinematics;
mod probe;
mod rows;
mod setter;
mod solid;
mod stl;

pub use answers::Answers;
pub use clock::Clock;
pub use probe::{Orientation, PreTravel, Probe, Shaft};
pub use setter::{Edge, Plate, ToolSetter, TrueTool};
pub use stl::Beside;

use super::geometry::{Frame, INCH, RotaryAxis};
use super::machine::Neck;
use super::machine::{Machine, SavedKinematics, TrueMachine};
use super::read::Reader;
use super::solid::{Body, Shape};
use super::table::{Table, TableError, TableKind};
use crate::base::diag::{Diagnostic, Source};
use crate::spec::{Kind, Node, read_yaml};
use glam::DVec3;
use std::sync::Arc;

/// The version of scene files that is understood.
const VERSION: &str = "1";
/// The machine of a scene that names none.
const DEFAULT_MACHINE: &str = "mill-3-axis";
/// Where the tool is at the start of a scene that does not say it, in the coordinates of the active preset.
const DEFAULT_START: DVec3 = DVec3::new(0.0, 0.0, 100.0);
/// The keys of a scene.
const KEYS: &[&str] = &[
    "scene",
    "units",
    "clock",
    "machine",
    "kinematics",
    "machine_parameters",
    "tools",
    "turning_tools",
    "probe",
    "tool_setter",
    "presets",
    "datums",
    "points",
    "tables",
    "masks",
    "start",
    "stock",
    "parts",
    "answers",
];

/// The value of a machine parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum ParameterValue {
    /// A number, in the unit of the machine parameter.
    Number(f64),
    /// A word or text.
    Text(String),
    /// Several numbers.
    List(Vec<f64>),
}

/// A world.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The time at which the run starts.
    pub clock: Clock,
    /// The machine.
    pub machine: Machine,
    /// The machine as it really is, where that is not what the control believes.
    pub truth: Option<TrueMachine>,
    /// The kinematics that are saved at the start.
    pub saved_kinematics: Vec<SavedKinematics>,
    /// Machine parameters by name, in the order of the file.
    pub machine_parameters: Vec<(String, ParameterValue)>,
    /// The tool table.
    pub tools: Table,
    /// The table of the turning tools.
    pub turning_tools: Table,
    /// The necks of side cutters, by the number of the tool.
    pub necks: Vec<(f64, Neck)>,
    /// Tools that are not as the tool table says, by their number.
    pub true_tools: Vec<(f64, TrueTool)>,
    /// The tool setter, if there is one.
    pub setter: Option<ToolSetter>,
    /// The touch probe table.
    pub probes: Table,
    /// The touch probe, if there is one.
    pub probe: Option<Probe>,
    /// The preset table.
    pub presets: Table,
    /// The number of the preset that is active at the start.
    pub active_preset: f64,
    /// The datum tables; the first one is active at the start.
    pub datums: Vec<Table>,
    /// The point tables.
    pub points: Vec<Table>,
    /// Freely definable tables.
    pub free_tables: Vec<Table>,
    /// The masks of formatted output: names of files and their texts.
    pub masks: Vec<(String, String)>,
    /// From the coordinates of the preset that is active at the start to the machine.
    pub frame: Frame,
    /// Where the tool tip is at the start, in machine coordinates.
    pub start: DVec3,
    /// Where the rotary axes are at the start, in machine coordinates.
    pub start_angles: DVec3,
    /// The raw material, in machine coordinates.
    pub stock: Option<Shape>,
    /// All parts together, in machine coordinates while the table is as at the start. They stay where they are when a
    /// program changes its preset, and turn with the table.
    pub parts: Shape,
    /// The parts, ready for contact.
    pub body: Body,
    /// What the operator says.
    pub answers: Answers,
}

/// A preset in machine coordinates; empty cells of its row are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Preset {
    /// X, Y, Z.
    pub origin: DVec3,
    /// Its spatial angles SPA, SPB, SPC: a basic rotation.
    pub basic: DVec3,
    /// A, B, C: where the rotary axes have the coordinate 0.
    pub angles: DVec3,
}

impl Preset {
    /// The row of a preset table.
    ///
    /// # Errors
    /// There is no such row.
    pub fn of_row(presets: &Table, row: f64) -> Result<Self, TableError> {
        let number = |column| presets.number(row, column).map(Option::unwrap_or_default);
        Ok(Self {
            origin: DVec3::new(number("X")?, number("Y")?, number("Z")?),
            basic: DVec3::new(number("SPA")?, number("SPB")?, number("SPC")?),
            angles: DVec3::new(number("A")?, number("B")?, number("C")?),
        })
    }

    /// From its coordinates to the machine.
    pub fn frame(&self) -> Frame {
        Frame::placed(self.origin, self.basic)
    }
}

impl Scene {
    /// Reads a scene file; machines are looked up among `files`, the paths and texts of the data.
    ///
    /// # Errors
    /// All mistakes with their places.
    pub fn parse(source: &Arc<Source>, files: &[(String, String)]) -> Result<Self, Vec<Diagnostic>> {
        Self::parse_beside(source, files, None)
    }

    /// The same of a scene that may name files beside it.
    ///
    /// # Errors
    /// All mistakes with their places.
    pub fn parse_beside(
        source: &Arc<Source>,
        files: &[(String, String)],
        beside: Option<&dyn Beside>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let mut reader = Reader::new(source);
        let Some(node) = read_yaml(source, &mut reader.found) else {
            if reader.found.is_empty() {
                let nothing = Node { span: (0..0).into(), kind: Kind::Scalar("".into(), true) };
                return Self::read(&nothing, reader, files, beside);
            }
            return Err(reader.found);
        };
        reader.need(&node, "scene");
        Self::read(&node, reader, files, beside)
    }

    /// Reads a scene that is written out in another file of which `node` is a part; `scene: 1` may be left out.
    ///
    /// # Errors
    /// All mistakes with their places.
    pub fn from_node(node: &Node, source: &Arc<Source>, files: &[(String, String)]) -> Result<Self, Vec<Diagnostic>> {
        Self::read(node, Reader::new(source), files, None)
    }

    fn read(
        node: &Node,
        mut reader: Reader<'_>,
        files: &[(String, String)],
        beside: Option<&dyn Beside>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let r = &mut reader;
        r.only_keys(node, KEYS);
        if let Some(version) = node.get("scene").filter(|version| version.text() != Some(VERSION)) {
            r.report("scene-version", version, vec![("known", VERSION.into())]);
        }
        units(node, r);
        let clock = node.get("clock").map_or(Some(Clock::DEFAULT), |node| clock(node, r));
        let machine = machine(node, r, files);
        let (truth, saved_kinematics) =
            node.get("kinematics").map_or_else(Default::default, |node| kinematics::read(node, machine.as_ref(), r));
        let machine_parameters = node.get("machine_parameters").map_or_else(Vec::new, |node| parameters(node, r));
        let (mut necks, mut true_tools) = (Vec::new(), Vec::new());
        let mut tools = Table::new(TableKind::Tool, TableKind::Tool.file_name());
        if let Some(node) = node.get("tools") {
            (necks, true_tools) = tool_rows(node, &mut tools, r);
        }
        let mut turning_tools = Table::new(TableKind::Turning, TableKind::Turning.file_name());
        if let Some(node) = node.get("turning_tools") {
            rows::rows(node, &mut turning_tools, r);
        }
        let mut probes = Table::new(TableKind::Probe, TableKind::Probe.file_name());
        let probe = node.get("probe").and_then(|node| probe::probe(node, &mut probes, r));
        let setter = node.get("tool_setter").and_then(|node| setter::setter(node, r));
        let (presets, active_preset) = presets(node, r);
        let (datums, points) =
            (of_files(node, "datums", TableKind::Datum, r), of_files(node, "points", TableKind::Points, r));
        let free_tables = node.get("tables").map_or_else(Vec::new, |node| rows::free_tables(node, r));
        let masks = node.get("masks").map_or_else(Vec::new, |node| masks(node, r));
        // A row that is missing was reported.
        let preset = Preset::of_row(&presets, active_preset).unwrap_or_default();
        let frame = preset.frame();
        let (start, start_angles) = start(node, machine.as_ref(), &preset, r);
        let placed = |shape| Shape::Placed { frame, shape: Box::new(shape) };
        let mut models = stl::Models::new(beside);
        let stock = node.get("stock").and_then(|node| solid::stock(node, r, &mut models)).map(placed);
        let list = node.get("parts").map_or(&[][..], |node| r.items(node));
        let parts = list.iter().filter_map(|item| solid::part(item, r, &mut models)).collect();
        let parts = placed(Shape::Union(parts));
        let answers = node.get("answers").map_or_else(Answers::default, |node| Answers::read(node, r));
        let body = Body::new(&parts).map_err(|error| r.report(error.code(), node, Vec::new())).ok();
        match (clock, machine, body) {
            (Some(clock), Some(machine), Some(body)) if reader.found.is_empty() => Ok(Self {
                clock,
                machine,
                truth,
                saved_kinematics,
                machine_parameters,
                tools,
                turning_tools,
                necks,
                true_tools,
                setter,
                probes,
                probe,
                presets,
                active_preset,
                datums,
                points,
                free_tables,
                masks,
                frame,
                start,
                start_angles,
                stock,
                parts,
                body,
                answers,
            }),
            _ => Err(reader.found),
        }
    }

    /// The number that a machine parameter has, by its name; switches are 0 or 1.
    pub fn machine_number(&self, name: &str) -> Option<f64> {
        match self.machine_parameter(name)? {
            ParameterValue::Number(number) => Some(*number),
            ParameterValue::Text(word) => match word.to_ascii_lowercase().as_str() {
                "on" | "true" | "yes" => Some(1.0),
                "off" | "false" | "no" => Some(0.0),
                _ => None,
            },
            ParameterValue::List(_) => None,
        }
    }

    /// The value of a machine parameter by its name.
    pub fn machine_parameter(&self, name: &str) -> Option<&ParameterValue> {
        self.machine_parameters.iter().find(|(known, _)| known == name).map(|(_, value)| value)
    }
}

/// Sets the unit of the lengths that follow.
fn units(node: &Node, r: &mut Reader<'_>) {
    let Some(units) = node.get("units") else { return };
    match units.text() {
        Some("mm") => {}
        Some("inch") => r.scale = INCH,
        _ => r.expected(units, "unit"),
    }
}

fn clock(node: &Node, r: &mut Reader<'_>) -> Option<Clock> {
    let clock = node.text().and_then(Clock::parse);
    if clock.is_none() {
        r.expected(node, "clock");
    }
    clock
}

/// The machine by name, or written out.
fn machine(node: &Node, r: &mut Reader<'_>, files: &[(String, String)]) -> Option<Machine> {
    let name = match node.get("machine") {
        Some(inline @ Node { kind: Kind::Map(_), .. }) => return Machine::read(inline, r),
        Some(name) => r.text(name)?,
        None => DEFAULT_MACHINE,
    };
    match Machine::named(name, files) {
        Ok(machine) => Some(machine),
        Err(found) if found.is_empty() => {
            let known = Machine::names(files).join(", ");
            let at = node.get("machine").unwrap_or(node);
            r.report("scene-unknown-machine", at, vec![("name", name.into()), ("known", known.into())]);
            None
        }
        Err(found) => {
            r.found.extend(found);
            None
        }
    }
}

fn parameters(node: &Node, r: &mut Reader<'_>) -> Vec<(String, ParameterValue)> {
    let mut all = Vec::new();
    for (name, value) in r.entries(node) {
        let value = match &value.kind {
            Kind::Scalar(text, plain) => match text.parse::<f64>() {
                Ok(number) if *plain && number.is_finite() => ParameterValue::Number(number),
                _ => ParameterValue::Text(text.to_string()),
            },
            Kind::List(items) => ParameterValue::List(items.iter().filter_map(|item| r.number(item)).collect()),
            Kind::Map(_) => {
                r.expected(value, "number");
                continue;
            }
        };
        all.push((name.text.to_string(), value));
    }
    all
}

/// Necks and true tools, by the number of the tool.
type OfTools = (Vec<(f64, Neck)>, Vec<(f64, TrueTool)>);

/// The tool table, and what the tools have that is no column of it.
fn tool_rows(node: &Node, table: &mut Table, r: &mut Reader<'_>) -> OfTools {
    let (mut necks, mut true_tools) = (Vec::new(), Vec::new());
    for item in r.items(node) {
        let columns = r.entries(item).iter().filter(|(key, _)| !setter::OWN.contains(&&*key.text));
        let Some(number) = rows::row(item, columns, None, table, r) else { continue };
        if let Some(tool) = setter::true_tool(item, r) {
            true_tools.push((number, tool));
        }
        let Some(neck) = item.get("neck") else { continue };
        r.only_keys(neck, &["head", "radius"]);
        let head = r.need(neck, "head").and_then(|node| r.positive(node));
        let radius = r.need(neck, "radius").and_then(|node| r.positive(node));
        if let (Some(head), Some(radius)) = (head, radius) {
            necks.push((number, Neck { head, radius }));
        }
    }
    (necks, true_tools)
}

/// The preset table, which always has a row 0, and the number of the active row.
fn presets(node: &Node, r: &mut Reader<'_>) -> (Table, f64) {
    let mut table = Table::new(TableKind::Preset, TableKind::Preset.file_name());
    let (mut active, mut at) = (0.0, None);
    if let Some(node) = node.get("presets") {
        r.only_keys(node, &["active", "rows"]);
        if let Some(list) = node.get("rows") {
            rows::rows(list, &mut table, r);
        }
        at = node.get("active");
        active = at.and_then(|node| rows::row_number(node, r)).unwrap_or(0.0);
    }
    let _ = table.add_row(0.0);
    if let Some(node) = at.filter(|_| !table.has_row(active)) {
        let found = TableError::NoRow { file: table.file().to_owned(), row: active }.diagnostic();
        r.report(found.code, node, found.args);
    }
    (table, active)
}

/// Datum or point tables: one as a list of rows, or several as a mapping by file name.
fn of_files(node: &Node, key: &str, kind: TableKind, r: &mut Reader<'_>) -> Vec<Table> {
    let mut tables = Vec::new();
    let Some(node) = node.get(key) else { return tables };
    let mut add = |file: &str, node: &Node, r: &mut Reader<'_>| {
        let mut table = Table::new(kind, file);
        rows::rows(node, &mut table, r);
        tables.push(table);
    };
    if let Kind::Map(entries) = &node.kind {
        for (name, node) in entries {
            if TableKind::of_file(&name.text) != Some(kind) {
                r.expected(node, "datum-file");
            }
            add(&name.text, node, r);
        }
    } else {
        add(kind.file_name(), node, r);
    }
    tables
}

/// Masks of formatted output by the name of their file.
fn masks(node: &Node, r: &mut Reader<'_>) -> Vec<(String, String)> {
    let mut masks = Vec::new();
    for (name, text) in r.entries(node) {
        if let Some(text) = r.text(text) {
            masks.push((name.text.to_string(), text.to_owned()));
        }
    }
    masks
}

/// The start in machine coordinates, where the machine must be able to be: the tool tip and the rotary axes.
fn start(node: &Node, machine: Option<&Machine>, preset: &Preset, r: &mut Reader<'_>) -> (DVec3, DVec3) {
    let given = node.get("start");
    let default = (DEFAULT_START, DVec3::ZERO);
    let (start, angles) = given.map_or(Some(default), |node| r.position(node)).unwrap_or(default);
    let (start, angles) = (preset.frame().point(start), angles + preset.angles);
    let (Some(node), Some(machine)) = (given, machine) else { return (start, angles) };
    for axis in RotaryAxis::ALL {
        let letter = axis.letter().to_string();
        if let (Some(at), None) = (node.get(&letter), machine.rotary(axis)) {
            r.report("scene-no-axis", at, vec![("axis", letter.into())]);
        }
    }
    let linear =
        machine.beyond_limits(start).map(|axis| (axis.axis.letter(), axis.axis.of(start), axis.min, axis.max, "mm"));
    let rotary = machine
        .turned_too_far(angles)
        .and_then(|axis| axis.limits.map(|(min, max)| (axis.axis.letter(), axis.axis.of(angles), min, max, "°")));
    if let Some((axis, found, min, max, unit)) = linear.or(rotary) {
        let args = vec![
            ("axis", axis.to_string().into()),
            ("found", found.into()),
            ("min", min.into()),
            ("max", max.into()),
            ("unit", unit.into()),
        ];
        r.report("scene-start-outside", node, args);
    }
    (start, angles)
}
