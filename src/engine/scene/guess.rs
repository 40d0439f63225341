//! A scene for programs that come without one: their tools with what they define themselves, their blank, a probe if
//! they probe.
//!
//! Invariant: whatever the programs do not say is named as assumed; what comes out is the text of a scene file, which
//! is read as any other.
use std::fmt::Write as _;

use super::super::geometry::INCH;
use crate::base::expr::{QKind, QRef};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, CycleDef, CycleKeyword, Program, ToolRef, ValueKind};
use crate::program::table::{Cell, Quantity, Table};
use crate::spec::{CycleKey, Group, Keyword, OnControl};

/// The radius of a tool of which nothing is known, mm.
pub const RADIUS: f64 = 5.0;
/// The length of such a tool, mm.
pub const LENGTH: f64 = 100.0;
/// The angle at which it plunges, if a cycle asks for one, degrees.
pub const ANGLE: f64 = 5.0;
/// The radius of the ball of a probe of which nothing is known, mm.
pub const BALL: f64 = 2.0;
/// What is assumed of an insert: the radius of its nose, the angle of its main edge to the rotary axis and that of its
/// point, mm and degrees.
pub const INSERT: [f64; 3] = [0.8, 95.0, 80.0];
/// What is assumed of an insert for recesses: its width and the radius of its corners, mm.
pub const RECESSING: [f64; 2] = [3.0, 0.2];
/// The same of a tool that the tool table has, but not its insert: narrow enough for any recess.
const NARROW: [f64; 2] = [1.5, 0.1];
/// Machines on which a program that turns can run, the best first: the workpiece turns without end on them.
const TURNING_MACHINES: [&str; 2] = ["mill-turn", "mill-table-c"];
/// The machine for programs that move B and not A.
const TILTING_ABOUT_Y: &str = "mill-table-bc";
/// Where a tool setter is assumed, in machine coordinates, and its width: in a corner of the machine, mm.
const SETTER: [f64; 4] = [900.0, 900.0, -900.0, 40.0];
/// What machine parameters of tool measurement are assumed to be, by their neutral names: mm, mm/min, m/min.
const MEASURING: [(&str, f64); 5] = [
    ("setter-safety-distance", 5.0),
    ("setter-axis-offset", 3.0),
    ("stationary-probing-feed", 100.0),
    ("max-peripheral-speed", 31.5),
    ("measuring-tolerance", 0.01),
];
/// The meaning of the parameter that only recessing cycles have.
const RECESS: &str = "recess-clearance";
/// How far above the blank the tool starts, mm.
const ABOVE: f64 = 100.0;
/// The type of a touch probe in the tool table.
const PROBE: &str = "TCHP";
/// The meaning of the parameter that says how a cycle plunges; 0 is vertically.
const PLUNGING: &str = "plunging-strategy";

/// Where the data of a tool come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// `TOOL DEF` of the program.
    Program,
    /// A tool table.
    Table,
    /// Nothing is known.
    Assumed,
}

/// A tool that is called.
#[derive(Clone, Debug)]
pub struct GuessedTool {
    /// Its number; of one that is called by name, a free one.
    pub number: f64,
    /// The name by which it is called.
    pub name: Option<String>,
    /// Its length and radius, mm.
    pub size: [f64; 2],
    /// Whether it must plunge at an angle.
    pub plunges: bool,
    /// Whether it is a touch probe.
    pub probes: bool,
    /// Whether it turns the workpiece.
    pub turns: bool,
    /// Whether it recesses.
    pub recesses: bool,
    /// Where length and radius come from.
    pub origin: Origin,
}

/// The blank of a program.
#[derive(Clone, Debug)]
pub struct GuessedBlank {
    /// Its shape as a scene writes a solid.
    pub solid: String,
    /// The highest Z in it, mm.
    pub top: f64,
}

/// What is guessed.
#[derive(Clone, Debug, Default)]
pub struct Guess {
    /// The tools in the order of their first calls.
    pub tools: Vec<GuessedTool>,
    /// The blank.
    pub blank: Option<GuessedBlank>,
    /// Rotary axes that the programs move.
    rotary: [bool; 3],
    /// Whether a plane is tilted by a block of its own, with whatever axes.
    tilts: bool,
    /// Whether blocks name positions of rotary axes.
    positioned: bool,
    /// Whether tools are measured.
    measures: bool,
    /// The machine parameters that measuring them needs, as the control calls them.
    parameters: Vec<(String, f64)>,
    /// The machine for programs that move B and not A.
    tilting_machine: &'static str,
    /// The machine for programs that turn.
    turning_machine: &'static str,
    /// The rows of the tool table, as a scene writes them.
    rows: Vec<(f64, String)>,
}

/// What a line of the text of a scene is about.
#[derive(Clone, Copy, Debug)]
pub enum Line<'g> {
    /// The whole.
    Head,
    /// A tool.
    Tool(&'g GuessedTool),
    /// The touch probe.
    Probe,
    /// What measures tools.
    Setter,
    /// The blank.
    Blank,
}

impl Guess {
    /// What the programs, the first one with those that it calls, say of their world. `blank` is that of the first one;
    /// tools of a table are as it has them. `machines` are the paths of the files of machines.
    pub fn of(
        on: &OnControl,
        programs: &[&Program],
        blank: Option<GuessedBlank>,
        table: Option<&Table>,
        machines: &[(String, String)],
    ) -> Self {
        let is_there = |name: &&str| machines.iter().any(|(path, _)| path.ends_with(&format!("/{name}.yaml")));
        let turning_machine = TURNING_MACHINES.into_iter().find(is_there).unwrap_or_default();
        let tilting_machine = Some(TILTING_ABOUT_Y).filter(is_there).unwrap_or_default();
        let printed = |(name, value): (&str, f64)| Some((on.datum(name)?.to_owned(), value));
        let parameters = MEASURING.into_iter().filter_map(printed).collect();
        let mut guess = Self { blank, turning_machine, tilting_machine, parameters, ..Self::default() };
        for program in programs {
            guess.read(on, program, table);
        }
        let in_use = |guess: &Self, number: f64| guess.tools.iter().any(|tool| tool.number == number);
        let mut free = 1.0;
        for index in 0..guess.tools.len() {
            if guess.tools.get(index).is_some_and(|tool| tool.number < 0.0) {
                while in_use(&guess, free) || table.is_some_and(|table| table.has_row(free)) {
                    free += 1.0;
                }
                if let Some(tool) = guess.tools.get_mut(index) {
                    tool.number = free;
                }
            }
        }
        if let Some(table) = table {
            guess.rows = guess.tools.iter().filter_map(|tool| Some((tool.number, row(table, tool.number)?))).collect();
        }
        guess
    }

    /// Whether blocks name positions of rotary axes other than those of a tilted plane: where these lead to depends on
    /// the machine, which is assumed.
    pub const fn positions_rotary_axes(&self) -> bool {
        self.positioned
    }

    /// Gives tools that recess, and that the tool table has without a cutting width, an insert in the table of turning
    /// tools.
    pub fn assume_inserts(&self, tools: &Table, turning: &mut Table) {
        let [width, nose] = NARROW;
        for tool in self.tools.iter().filter(|tool| tool.recesses && tools.has_row(tool.number)) {
            let listed = tools.number(tool.number, "CUTWIDTH").is_ok_and(|width| width.is_some_and(|own| own > 0.0));
            if listed || turning.has_row(tool.number) || turning.add_row(tool.number).is_err() {
                continue;
            }
            for (column, value) in [("ZL", tool.size[0]), ("RS", nose), ("CUTWIDTH", width)] {
                // A table without the column says nothing of it, as before.
                let _ = turning.set(tool.number, column, &Cell::Number(value));
            }
        }
    }

    fn read(&mut self, on: &OnControl, program: &Program, table: Option<&Table>) {
        let (mut unit, mut loaded) = (1.0, None);
        for block in program.blocks() {
            match &block.kind {
                BlockKind::BeginPgm(frame) => unit = if frame.inch { INCH } else { 1.0 },
                BlockKind::ToolCall(call) => {
                    if let Some(tool) = call.tool {
                        loaded = self.tool(program, tool, table);
                    }
                }
                BlockKind::ToolDef(own) => {
                    let size = [own.length, own.radius].map(|value| match value?.amount {
                        Amount::Number(number) => Some(number * unit),
                        Amount::Q { .. } | Amount::Text(_) => None,
                    });
                    if let (Some(index), [length, radius]) = (self.tool(program, own.tool, table), size)
                        && let Some(tool) = self.tools.get_mut(index)
                        && tool.origin != Origin::Table
                    {
                        let [old_length, old_radius] = tool.size;
                        tool.size = [length.unwrap_or(old_length), radius.unwrap_or(old_radius)];
                        if radius.is_some() {
                            tool.origin = Origin::Program;
                        }
                    }
                }
                BlockKind::CycleDef(definition) => {
                    self.measures |= is_of(on, definition.keyword, definition.number, Group::ToolMeasurement);
                    if let Some(tool) = loaded.and_then(|index| self.tools.get_mut(index)) {
                        tool.plunges |= plunges(on, definition);
                        tool.probes |= probes(on, definition.keyword, definition.number, &is_probe(table, tool));
                        tool.turns |= is_of(on, definition.keyword, definition.number, Group::Turning);
                        tool.recesses |= has(on, definition, RECESS);
                    }
                }
                BlockKind::OldCycleLine(line) => {
                    self.measures |= is_of(on, line.keyword, line.number, Group::ToolMeasurement);
                    if let Some(tool) = loaded.and_then(|index| self.tools.get_mut(index)) {
                        tool.probes |= probes(on, line.keyword, line.number, &is_probe(table, tool));
                    }
                }
                _ => self.turns(block),
            }
        }
    }

    /// The place of a tool among all, which is made if it is new; nothing of one that a parameter chooses.
    fn tool(&mut self, program: &Program, tool: ToolRef, table: Option<&Table>) -> Option<usize> {
        let (number, name) = match tool {
            ToolRef::Number(operand) => match operand.amount {
                Amount::Number(number) if number > 0.0 => (Some(number), None),
                _ => return None,
            },
            ToolRef::Name(span) => {
                let name = program.slice(span).trim();
                let listed = table.and_then(|table| table.find("NAME", name).ok().flatten());
                (listed, Some(name.to_owned()))
            }
        };
        let known = self.tools.iter().position(|own| match &name {
            Some(name) => own.name.as_deref() == Some(name),
            None => number == Some(own.number),
        });
        if known.is_some() {
            return known;
        }
        let listed = |column| table.zip(number).and_then(|(table, number)| table.number(number, column).ok().flatten());
        let named = name.as_deref().and_then(diameter).map(|diameter| diameter / 2.0);
        let has_row = table.zip(number).is_some_and(|(table, number)| table.has_row(number));
        self.tools.push(GuessedTool {
            number: number.unwrap_or(-1.0),
            name,
            size: [listed("L").unwrap_or(LENGTH), listed("R").or(named).unwrap_or(RADIUS)],
            plunges: false,
            probes: false,
            turns: false,
            recesses: false,
            origin: if has_row { Origin::Table } else { Origin::Assumed },
        });
        Some(self.tools.len() - 1)
    }

    fn turns(&mut self, block: &Block) {
        let [a, b, c] = &mut self.rotary;
        match &block.kind {
            BlockKind::Motion(element) => {
                for coord in &element.words().coords {
                    *a |= coord.axis == Axis::A;
                    *b |= coord.axis == Axis::B;
                    *c |= coord.axis == Axis::C;
                    let rotary = matches!(coord.axis, Axis::A | Axis::B | Axis::C);
                    self.positioned |= rotary && !leads_to_plane(coord.value.amount);
                }
            }
            BlockKind::Statement(statement) => {
                self.tilts |= statement.kind == crate::program::syntax::StatementKind::Plane;
            }
            _ => {}
        }
    }

    fn machine(&self) -> &'static str {
        if self.tools.iter().any(|tool| tool.turns) && !self.turning_machine.is_empty() {
            return self.turning_machine;
        }
        match self.rotary {
            [false, true, _] if !self.tilting_machine.is_empty() => self.tilting_machine,
            [false, false, false] if !self.tilts => "mill-3-axis",
            [false, false, true] if !self.tilts => "mill-table-c",
            _ => "mill-table-ac",
        }
    }

    /// The text of a scene file; `remark` gives the comment on a line, without its sign.
    pub fn to_yaml(&self, remark: &dyn Fn(Line<'_>) -> String) -> String {
        let comment = |line| match remark(line) {
            text if text.is_empty() => String::new(),
            text => format!("  # {text}"),
        };
        let mut text = String::new();
        remark(Line::Head).lines().for_each(|line| {
            let _ = writeln!(text, "# {line}");
        });
        let _ = writeln!(text, "scene: 1\nunits: mm\nmachine: {}", self.machine());
        // Tools of a tool table are rows of it, whatever they do.
        let listed = |tool: &GuessedTool| self.rows.iter().find(|(number, _)| *number == tool.number);
        let of_turning = |tool: &&GuessedTool| tool.turns && listed(tool).is_none();
        let (turning, others): (Vec<_>, Vec<_>) = self.tools.iter().partition(of_turning);
        for (table, tools) in [("tools", others), ("turning_tools", turning)] {
            if !tools.is_empty() {
                let _ = writeln!(text, "{table}:");
            }
            for tool in tools {
                let row = listed(tool).map_or_else(|| tool.row(), |(_, row)| row.clone());
                let _ = writeln!(text, "  - {{{row}}}{}", comment(Line::Tool(tool)));
            }
        }
        if self.tools.iter().any(|tool| tool.probes) {
            let ball = self.tools.iter().find(|tool| tool.probes && tool.origin != Origin::Assumed);
            let ball = ball.map_or(BALL, |tool| tool.size[1]);
            let _ = writeln!(text, "probe: {{NO: 1, ball_radius: {ball}}}{}", comment(Line::Probe));
        }
        if self.measures {
            let [x, y, z, wide] = SETTER;
            let _ = writeln!(text, "tool_setter: {{at: [{x}, {y}, {z}], diameter: {wide}}}{}", comment(Line::Setter));
            let parameters: Vec<String> =
                self.parameters.iter().map(|(name, value)| format!("{name}: {value}")).collect();
            let _ = writeln!(text, "machine_parameters: {{{}}}{}", parameters.join(", "), comment(Line::Setter));
        }
        let top = self.blank.as_ref().map_or(0.0, |blank| blank.top);
        let _ = writeln!(text, "start: {{X: 0, Y: 0, Z: {}}}", top + ABOVE);
        if let Some(GuessedBlank { solid, .. }) = &self.blank {
            let _ = writeln!(text, "stock: {solid}{}", comment(Line::Blank));
            if self.tools.iter().any(|tool| tool.probes) {
                let _ = writeln!(text, "parts:\n  - solid: {solid}");
            }
        }
        text
    }
}

impl GuessedTool {
    /// Its row as a scene writes it: in the table of turning tools if it turns.
    fn row(&self) -> String {
        let [length, radius] = self.size;
        let name = self.name.as_ref().map(|name| format!(", NAME: {}", quoted(name))).unwrap_or_default();
        if self.turns {
            let insert = if self.recesses {
                let [width, nose] = RECESSING;
                format!("RS: {nose}, CUTWIDTH: {width}")
            } else {
                let [nose, angle, point] = INSERT;
                format!("RS: {nose}, T-ANGLE: {angle}, P-ANGLE: {point}")
            };
            return format!("T: {}{name}, ZL: {length}, {insert}", self.number);
        }
        let radius = if self.probes && self.origin == Origin::Assumed { BALL } else { radius };
        let angle = if self.plunges { format!(", ANGLE: {ANGLE}") } else { String::new() };
        let probe = if self.probes { ", TP_NO: 1" } else { "" };
        format!("T: {}{name}, L: {length}, R: {radius}{angle}{probe}", self.number)
    }
}

/// Whether a position of a rotary axis is 0, or the one that the control has calculated for the tilted plane (Q120 to
/// Q122): these lead to the same place of the part on any machine.
fn leads_to_plane(amount: Amount) -> bool {
    match amount {
        Amount::Number(number) => number == 0.0,
        Amount::Q { q, negative } => !negative && q.kind == QKind::Q && (120..=122).contains(&q.number),
        Amount::Text(_) => false,
    }
}

/// The diameter that a name such as `MILL_D10` says, mm.
fn diameter(name: &str) -> Option<f64> {
    let mut parts = name.split(|sign: char| !(sign.is_ascii_alphanumeric() || sign == '.'));
    let of = |part: &str| part.strip_prefix(['D', 'd']).and_then(|rest| rest.parse::<f64>().ok());
    parts.find_map(of).filter(|diameter| *diameter > 0.0 && diameter.is_finite())
}

/// The row of a table as a scene writes it; nothing if there is none.
fn row(table: &Table, number: f64) -> Option<String> {
    let mut cells = Vec::new();
    for column in table.kind().columns() {
        match (column.quantity, table.get(number, column.name).ok()?) {
            (_, Cell::Empty) => {}
            (Quantity::Text, Cell::Text(text)) => cells.push(format!("{}: {}", column.name, quoted(&text))),
            (_, Cell::Number(value)) => cells.push(format!("{}: {value}", column.name)),
            (_, Cell::Text(_)) => {}
        }
    }
    (!cells.is_empty()).then(|| cells.join(", "))
}

fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// Whether a definition plunges otherwise than vertically.
fn plunges(on: &OnControl, definition: &CycleDef) -> bool {
    let cycle = key(definition.keyword, definition.number).and_then(|key| on.cycles.get(&key));
    let strategy: Option<QRef> =
        cycle.and_then(|cycle| cycle.params.iter().find(|param| param.is.as_str() == PLUNGING)).and_then(|own| own.q);
    let value =
        |q| (0..definition.parameters.len()).filter_map(|at| definition.parameters.get(at)).find(|own| own.q == q);
    strategy.and_then(value).is_some_and(|own| own.value.kind != ValueKind::Number(0.0))
}

/// Whether a definition is one of a group of cycles.
fn is_of(on: &OnControl, keyword: CycleKeyword, number: u32, group: Group) -> bool {
    let cycle = key(keyword, number).and_then(|key| on.cycles.get(&key));
    cycle.is_some_and(|cycle| cycle.file.group == group)
}

/// Whether the cycle of a definition has a parameter of a meaning.
fn has(on: &OnControl, definition: &CycleDef, meaning: &str) -> bool {
    let cycle = key(definition.keyword, definition.number).and_then(|key| on.cycles.get(&key));
    cycle.is_some_and(|cycle| cycle.params.iter().any(|param| param.is.as_str() == meaning))
}

/// Whether a cycle needs a touch probe for workpieces. Of one that no manual of the control describes the tool decides:
/// it may measure the tool as well.
fn probes(on: &OnControl, keyword: CycleKeyword, number: u32, is_probe: &dyn Fn() -> bool) -> bool {
    let cycle = key(keyword, number).and_then(|key| on.cycles.get(&key));
    keyword == CycleKeyword::TchProbe && cycle.map_or_else(is_probe, |cycle| cycle.file.group != Group::ToolMeasurement)
}

/// Whether the table says that a tool is a touch probe.
fn is_probe<'t>(table: Option<&'t Table>, tool: &GuessedTool) -> impl Fn() -> bool + 't {
    let number = tool.number;
    move || table.and_then(|table| table.text(number, "TYP").ok()).is_some_and(|kind| kind.eq_ignore_ascii_case(PROBE))
}

fn key(keyword: CycleKeyword, number: u32) -> Option<CycleKey> {
    Keyword::by_word(keyword.as_str()).map(|keyword| CycleKey::new(keyword, number))
}
