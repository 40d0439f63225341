//! Klartext in DIN/ISO.
//!
//! Every block names the code of its motion, and where a program has incremental values at all, what each coordinate
//! counts from: so a label may be reached from anywhere. Invariant:
//! what DIN/ISO has no equivalent of is a comment and a finding.
use super::codes::Codes;
use super::lower::with_quotation_marks;
use super::old::{self, coordinate};
use crate::base::diag::{Diagnostic, Place, Span};
use crate::program::fields;
use crate::program::syntax::{
    Axis, Block, BlockKind, CallForm, Compensation, Coord, CycleDef, CycleForm, CycleView, FeedKind, FnAssign, FnJump,
    FnOp, GlobalDef, Label, LabelRef, MFunction, Motion, Operand, Parameter, Path, Program, Relation, Statement,
    StatementKind, ToolCall, ToolRef,
};

/// How far the numbers of two blocks are apart.
const STEP: u32 = 10;
/// The number of a program's last block.
const LAST: u32 = 99_999_999;

/// A program in DIN/ISO.
#[derive(Debug)]
pub struct Raised {
    /// Its text.
    pub text: String,
    /// What DIN/ISO has no equivalent of; the blocks are comments.
    pub diagnostics: Vec<Diagnostic>,
}

/// Why a block is not written.
struct Refusal {
    code: &'static str,
    span: Span,
}

type Written = Result<String, Refusal>;

const fn no_equivalent(span: Span) -> Refusal {
    Refusal { code: "iso-no-equivalent", span }
}

/// A Klartext program in DIN/ISO.
pub fn to_iso(program: &Program, codes: &Codes<'_>) -> Raised {
    let text = program.source().text();
    let views = program.cycles();
    let explicit = program.blocks().iter().any(|block| is_incremental(program, block));
    let mut raising = Raising {
        program,
        codes,
        explicit,
        eol: if text.contains("\r\n") { "\r\n" } else { "\n" },
        number: 0,
        refused: None,
        text: String::with_capacity(text.len() * 2),
        diagnostics: Vec::new(),
    };
    let mut next = 0;
    let head =
        program.blocks().iter().position(|block| matches!(block.kind, BlockKind::BeginPgm(_))).unwrap_or_default();
    for (index, block) in program.blocks().iter().enumerate() {
        if index < head && matches!(block.kind, BlockKind::Comment) {
            raising.sheet(block);
            continue;
        }
        while views.get(next).is_some_and(|view| view.last < index) {
            next += 1;
        }
        raising.block(index, block, views.get(next).filter(|view| view.first <= index));
    }
    Raised { text: raising.text, diagnostics: raising.diagnostics }
}

/// Whether a block has values that count from the last position.
fn is_incremental(program: &Program, block: &Block) -> bool {
    match &block.kind {
        BlockKind::Motion(motion) => motion.coords.iter().any(|coord| coord.incremental),
        BlockKind::BlkForm(form) => form.coords.iter().any(|coord| coord.incremental),
        BlockKind::CyclCall(call) => {
            matches!(&call.form, CallForm::Position(coords) if coords.iter().any(|coord| coord.incremental))
        }
        BlockKind::OldCycleLine(line) => line.words.iter().any(|word| program.slice(word.name).starts_with(['I', 'i'])),
        _ => false,
    }
}

struct Raising<'p, 'c> {
    program: &'p Program,
    codes: &'p Codes<'c>,
    /// Whether every coordinate says what it counts from.
    explicit: bool,
    eol: &'static str,
    number: u32,
    /// The index of the last block that was refused.
    refused: Option<usize>,
    text: String,
    diagnostics: Vec<Diagnostic>,
}

impl Raising<'_, '_> {
    fn text(&self, span: Span) -> &str {
        self.program.slice(span)
    }

    fn block(&mut self, index: usize, block: &Block, view: Option<&CycleView<'_>>) {
        let written = match &block.kind {
            BlockKind::Empty => {
                self.text.push_str(self.eol);
                return;
            }
            BlockKind::Comment => Ok(self.foreign(block)),
            BlockKind::OldCycleLine(_) => match view.filter(|view| view.first == index) {
                Some(view) => self.old(view),
                None if view.is_some_and(|view| self.refused == Some(view.first)) => return self.left_out(block),
                // The line has been written with the first one of its definition.
                None => return self.lone_comment(block),
            },
            _ => self.content(block),
        };
        match written {
            Ok(content) => self.put(block, &content),
            Err(refusal) => {
                self.refused = Some(index);
                let found = self.text(refusal.span).trim().to_owned();
                let place = Place::new(self.program.source(), refusal.span);
                self.diagnostics.push(Diagnostic::error(refusal.code, place).arg("found", found));
                self.left_out(block);
            }
        }
    }

    /// What is in a line of other languages, as a comment: nothing in a line that is a comment itself.
    fn foreign(&self, block: &Block) -> String {
        let content = self.program.content(block);
        let end = block.comment().map_or(content.end, |comment| comment.start.min(content.end));
        let own = self.flat(Span::new(content.start.min(end), end));
        if own.is_empty() { own } else { format!("; {own}") }
    }

    /// A comment before the program: a file in DIN/ISO begins with `%` or with such lines.
    fn sheet(&mut self, block: &Block) {
        let foreign = self.foreign(block);
        let comment = block.comment().map_or("", |comment| self.text(comment));
        let blank = if foreign.is_empty() || comment.is_empty() { "" } else { " " };
        let line = format!("{foreign}{blank}{comment}{}", self.eol);
        self.text.push_str(&line);
    }

    fn put(&mut self, block: &Block, content: &str) {
        if block.skip {
            self.text.push('/');
        }
        let frame = matches!(block.kind, BlockKind::BeginPgm(_));
        if !frame {
            let last = matches!(block.kind, BlockKind::EndPgm(_));
            self.number = if last { LAST } else { self.number.saturating_add(STEP) };
            self.text.push_str(&format!("N{} ", self.number));
        }
        self.text.push_str(content);
        let labelled = matches!(&block.kind, BlockKind::CycleDef(_) | BlockKind::GlobalDef(_));
        match block.comment().filter(|_| !labelled) {
            Some(comment) => {
                let blank = if content.is_empty() { "" } else { " " };
                let comment =
                    self.text(comment).split(['\r', '\n']).map(|line| line.trim().trim_end_matches('~').trim_end());
                let mut comment: Vec<&str> = comment.filter(|line| !line.is_empty()).collect();
                let wrapped = self.program.wrapped(block).map(|rest| self.flat(rest));
                comment.extend(wrapped.as_deref());
                let comment = format!("{blank}{}*", comment.join(" "));
                self.text.push_str(&comment);
            }
            // A comment ends at the mark itself.
            None if content.starts_with(';') => self.text.push('*'),
            None => self.text.push_str(if content.ends_with('*') { "" } else { " *" }),
        }
        self.text.push_str(self.eol);
    }

    fn lone_comment(&mut self, block: &Block) {
        if let Some(comment) = block.comment() {
            self.number = self.number.saturating_add(STEP);
            let line = format!("N{} {}*{}", self.number, self.text(comment).trim_end(), self.eol);
            self.text.push_str(&line);
        }
    }

    /// Writes a block as a comment.
    fn left_out(&mut self, block: &Block) {
        let printed = self.flat(self.program.content(block));
        let mut comment = block.clone().without_comment();
        comment.kind = BlockKind::Comment;
        self.put(&comment, &format!("; {printed}"));
    }

    /// Several lines as one, without joints and the comments between them.
    fn flat(&self, span: Span) -> String {
        let lines = self.text(span).split(['\r', '\n']).map(|line| {
            let mut quoted = false;
            let comment = line.find(|c| {
                quoted ^= c == '"';
                c == ';' && !quoted
            });
            line.get(..comment.unwrap_or(line.len())).unwrap_or(line).trim().trim_end_matches('~').trim_end()
        });
        lines.filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" ")
    }

    /// Whether a block is the first that begins a program.
    fn is_first(&self, block: &Block) -> bool {
        let begins = |own: &&Block| matches!(own.kind, BlockKind::BeginPgm(_));
        self.program.blocks().iter().find(begins).is_some_and(|first| first.span == block.span)
    }

    fn content(&self, block: &Block) -> Written {
        let whole = self.program.content(block);
        Ok(match &block.kind {
            // A second one would be read back as the end of the program.
            BlockKind::BeginPgm(_) if !self.is_first(block) => return Err(no_equivalent(whole)),
            BlockKind::BeginPgm(frame) | BlockKind::EndPgm(frame) => {
                format!("%{} {}", self.text(frame.name), if frame.inch { "G70" } else { "G71" })
            }
            BlockKind::Structure(_) => self.text(whole).to_owned(),
            BlockKind::BlkForm(form) => {
                let mut out = match (form.part, form.axis) {
                    (1, Some(axis)) => format!("G30 {}", plane(axis).ok_or(no_equivalent(whole))?),
                    (1, None) => return Err(no_equivalent(whole)),
                    _ => "G31".to_owned(),
                };
                self.coordinates(&form.coords, &mut out);
                out
            }
            BlockKind::ToolCall(call) => self.tool_call(call, whole)?,
            BlockKind::ToolDef(definition) => {
                let known = definition.length.is_some() || definition.radius.is_some();
                let mut out = format!("{} T{}", if known { "G99" } else { "G51" }, self.tool(&definition.tool));
                for (name, value) in [("L", definition.length), ("R", definition.radius)] {
                    self.word(name, value, &mut out);
                }
                out
            }
            BlockKind::Motion(motion) => self.motion(motion, whole)?,
            BlockKind::Functions(functions) => self.functions(functions).trim_start().to_owned(),
            BlockKind::Stop(functions) => format!("G38{}", self.functions(functions)),
            BlockKind::Lbl(label) => format!("G98 L{}", self.label(label)),
            BlockKind::CallLbl(call) => {
                let times = call.repeat.map_or("0", |times| self.text(times.span));
                format!("L{},{}", self.label(&call.label), times.trim_start_matches('+'))
            }
            BlockKind::CallPgm(name) => format!("%{}", self.named(*name)),
            BlockKind::Sel(selection) => {
                let what = match &*self.text(selection.what).to_ascii_uppercase() {
                    "TABLE" => "TAB",
                    "PATTERN" => "PAT",
                    "CONTOUR" => "CNT",
                    "PGM" => "PGM",
                    _ => return Err(no_equivalent(whole)),
                };
                format!("%:{what}: {}", self.named(selection.name))
            }
            BlockKind::FnAssign(assign) => self.assign(assign),
            BlockKind::FnJump(jump) => self.jump(jump, whole)?,
            BlockKind::CyclCall(call) => {
                let mut out = "G79".to_owned();
                match &call.form {
                    CallForm::Plain => {}
                    CallForm::Pattern => out.push_str(" \"PAT\""),
                    CallForm::Position(coords) => {
                        out.push_str(":G01");
                        self.coordinates(coords, &mut out);
                    }
                }
                if let Some(feed) = &call.feed {
                    out.push_str(&self.feed(feed.kind, feed.span)?);
                }
                out + &self.functions(&call.functions)
            }
            BlockKind::CycleDef(cycle) => self.cycle(cycle)?,
            BlockKind::GlobalDef(definition) => self.global(definition)?,
            BlockKind::Statement(statement) => self.statement(statement, whole)?,
            // Both languages write these alike.
            BlockKind::Formula(_) | BlockKind::TextFormula(_) | BlockKind::ContourFormula(_) => {
                let end = self.program.wrapped(block).map_or(whole.end, |rest| rest.start);
                let flat = self.flat(Span::new(whole.start, end));
                match flat.split_once(':') {
                    Some((function, _)) if function.to_ascii_uppercase().starts_with("FN") => {
                        return Err(no_equivalent(whole));
                    }
                    _ => flat,
                }
            }
            BlockKind::PatternDef(_) => self.flat(whole),
            _ => return Err(no_equivalent(whole)),
        })
    }

    fn coordinates(&self, coords: &[Coord], out: &mut String) {
        for coord in coords {
            coordinate(self.text(coord.span), self.explicit, out);
        }
    }

    /// Coordinates under letters of their own.
    fn renamed(&self, coords: &[Coord], name: impl Fn(Axis) -> Option<&'static str>, whole: Span) -> Written {
        let mut out = String::new();
        for coord in coords {
            let name = name(coord.axis).ok_or(no_equivalent(whole))?;
            let written = format!("{}{name}{}", if coord.incremental { "I" } else { "" }, self.text(coord.value.span));
            coordinate(&written, self.explicit, &mut out);
        }
        Ok(out)
    }

    fn motion(&self, motion: &Motion, whole: Span) -> Written {
        let refused = || no_equivalent(whole);
        let direction = |codes: [&'static str; 2]| motion.counter_clockwise.map(|counter| codes[usize::from(counter)]);
        let rapid = matches!(motion.feed, Some(feed) if feed.kind == FeedKind::Max);
        let line = matches!(motion.path, Path::L | Path::Lp);
        let along = motion.path == Path::Axis;
        if (rapid && !line && !along) || !motion.words.is_empty() {
            return Err(refused());
        }
        let plain = |axis: Axis| (!matches!(axis, Axis::Pr | Axis::Pa)).then(|| axis.name());
        let polar = |axis: Axis| {
            Some(match axis {
                Axis::Pr => "R",
                Axis::Pa => "H",
                axis => axis.name(),
            })
        };
        let angle = |axis: Axis| (axis != Axis::Pr).then(|| polar(axis)).flatten();
        let mut out = match motion.path {
            Path::L => if rapid { "G00" } else { "G01" }.to_owned() + &self.renamed(&motion.coords, plain, whole)?,
            Path::Lp => if rapid { "G10" } else { "G11" }.to_owned() + &self.renamed(&motion.coords, polar, whole)?,
            Path::Axis => "G07".to_owned() + &self.renamed(&motion.coords, plain, whole)?,
            Path::Cc => return self.centre(motion, whole),
            Path::C => {
                direction(["G02", "G03"]).ok_or_else(refused)?.to_owned()
                    + &self.renamed(&motion.coords, plain, whole)?
            }
            Path::Cr => {
                let radius = motion.radius.ok_or_else(refused)?;
                let code = direction(["G02", "G03"]).ok_or_else(refused)?;
                format!("{code}{} R{}", self.renamed(&motion.coords, plain, whole)?, self.text(radius.span))
            }
            Path::Ct => "G06".to_owned() + &self.renamed(&motion.coords, plain, whole)?,
            Path::Cp => {
                direction(["G12", "G13"]).ok_or_else(refused)?.to_owned()
                    + &self.renamed(&motion.coords, angle, whole)?
            }
            Path::Ctp => "G16".to_owned() + &self.renamed(&motion.coords, polar, whole)?,
            Path::Rnd | Path::Chf if motion.coords.is_empty() => {
                let code = if motion.path == Path::Rnd { "G25" } else { "G24" };
                format!("{code} R{}", self.text(motion.radius.ok_or_else(refused)?.span))
            }
            _ => return Err(refused()),
        };
        if motion.radius.is_some() && !matches!(motion.path, Path::Cr | Path::Rnd | Path::Chf) {
            return Err(refused());
        }
        out.push_str(match motion.compensation {
            None => "",
            Some(Compensation::R0) => " G40",
            Some(Compensation::Rl) => " G41",
            Some(Compensation::Rr) => " G42",
            Some(Compensation::Longer) => " G43",
            Some(Compensation::Shorter) => " G44",
        });
        if let Some(feed) = motion.feed.filter(|_| !rapid || along) {
            out.push_str(&self.feed(feed.kind, feed.span)?);
        }
        // A block with nothing but its code would only change what acts.
        let empty = motion.coords.is_empty() && motion.compensation.is_none() && motion.feed.is_none();
        let corner = matches!(motion.path, Path::Rnd | Path::Chf);
        if empty && !corner && (!line || motion.functions.is_empty()) {
            return Err(refused());
        }
        if motion.coords.is_empty() && rapid && motion.compensation.is_none() && motion.functions.is_empty() {
            return Err(refused());
        }
        if empty && line {
            return Ok(self.functions(&motion.functions).trim_start().to_owned());
        }
        Ok(out + &self.functions(&motion.functions))
    }

    fn centre(&self, motion: &Motion, whole: Span) -> Written {
        let more = motion.compensation.is_some() || motion.feed.is_some() || !motion.functions.is_empty();
        if more {
            return Err(no_equivalent(whole));
        }
        if motion.coords.is_empty() {
            return Ok("G29".to_owned());
        }
        let name = |axis: Axis| match axis {
            Axis::X => Some("I"),
            Axis::Y => Some("J"),
            Axis::Z => Some("K"),
            _ => None,
        };
        let mut out = String::new();
        for coord in &motion.coords {
            let name = name(coord.axis).ok_or(no_equivalent(whole))?;
            let value = self.text(coord.value.span);
            out.push_str(match (coord.incremental, self.explicit) {
                (true, _) => " G91",
                (false, true) => " G90",
                (false, false) => "",
            });
            out.push_str(&format!(" {name}{value}"));
        }
        Ok(out.trim_start().to_owned())
    }

    fn feed(&self, kind: FeedKind, span: Span) -> Written {
        match kind {
            FeedKind::Value(value) => Ok(format!(" F{}", self.text(value.span))),
            FeedKind::Max => Ok(" FMAX".to_owned()),
            FeedKind::Auto => Ok(" FAUTO".to_owned()),
            FeedKind::PerRevolution(_) | FeedKind::PerTooth(_) => Err(no_equivalent(span)),
        }
    }

    fn functions(&self, functions: &[MFunction]) -> String {
        functions.iter().map(|function| format!(" {}", self.text(function.span))).collect()
    }

    fn word(&self, name: &str, value: Option<Operand>, out: &mut String) {
        if let Some(value) = value {
            out.push_str(&format!(" {name}{}", self.text(value.span)));
        }
    }

    fn tool(&self, tool: &ToolRef) -> String {
        match tool {
            ToolRef::Number(number) => self.text(number.span).to_owned(),
            ToolRef::Name(name) => format!("\"{}\"", self.text(*name)),
        }
    }

    fn tool_call(&self, call: &ToolCall, whole: Span) -> Written {
        let more = call.feed.is_some() || call.dl.is_some() || call.dr.is_some() || call.dr2.is_some();
        if call.cutting_speed.is_some()
            || (call.tool.is_none() && (more || call.axis.is_some() || call.speed.is_none()))
        {
            return Err(no_equivalent(whole));
        }
        let mut out = String::new();
        if let Some(tool) = &call.tool {
            out.push_str(&format!("T{}", self.tool(tool)));
        }
        if let Some(axis) = call.axis {
            out.push(' ');
            out.push_str(plane(axis).ok_or(no_equivalent(whole))?);
        }
        self.word("S", call.speed, &mut out);
        if let Some(feed) = &call.feed {
            out.push_str(&self.feed(feed.kind, feed.span)?);
        }
        for (name, value) in [("DL", call.dl), ("DR", call.dr), ("DR2", call.dr2)] {
            // `DR2` is another word than an oversize of 2.
            let signed = value.filter(|value| name != "DR" || !self.text(value.span).starts_with('2'));
            if let Some(value) = value.filter(|_| signed.is_none()) {
                out.push_str(&format!(" {name}+{}", self.text(value.span)));
            }
            self.word(name, signed, &mut out);
        }
        Ok(out.trim_start().to_owned())
    }

    fn label(&self, label: &LabelRef) -> String {
        match label.target {
            Label::Number(number) => number.to_string(),
            Label::Name(name) => format!("\"{}\"", self.text(name)),
            Label::Q(_) => self.text(label.span).to_owned(),
        }
    }

    /// A name with the quotation marks that it has.
    fn named(&self, name: Span) -> &str {
        self.text(with_quotation_marks(self.program, name))
    }

    fn assign(&self, assign: &FnAssign) -> String {
        let number = match assign.op {
            FnOp::Set => 0,
            FnOp::Add => 1,
            FnOp::Sub => 2,
            FnOp::Mul => 3,
            FnOp::Div => 4,
            FnOp::Sqrt => 5,
            FnOp::Sin => 6,
            FnOp::Cos => 7,
            FnOp::Len => 8,
            FnOp::Ang => 13,
        };
        let mut out = format!("D{number:02} {} P01 {}", assign.target, self.text(assign.a.span));
        if let Some(b) = &assign.b {
            out.push_str(&format!(" P02 {}", self.text(b.span)));
        }
        out
    }

    fn jump(&self, jump: &FnJump, whole: Span) -> Written {
        let number = match jump.relation {
            Relation::Equal => 9,
            Relation::NotEqual => 10,
            Relation::Greater => 11,
            Relation::Less => 12,
            Relation::Undefined | Relation::Defined => return Err(no_equivalent(whole)),
        };
        let (a, b) = (self.text(jump.a.span), self.text(jump.b.span));
        Ok(format!("D{number:02} P01 {a} P02 {b} P03 {}", self.label(&jump.label)))
    }

    fn parameters(&self, head: String, parameters: &[Parameter]) -> String {
        let mut out = head;
        for (turn, parameter) in parameters.iter().enumerate() {
            out.push_str(self.eol);
            out.push_str(self.text(parameter.span));
            if let Some(label) = parameter.label {
                out.push_str(&format!(" ;{}", self.text(label)));
            }
            if turn + 1 == parameters.len() {
                out.push('*');
            }
        }
        out
    }

    fn cycle(&self, cycle: &CycleDef) -> Written {
        if let Some(error) = cycle.errors.first() {
            return Err(no_equivalent(error.span));
        }
        let key = fields::key(cycle.keyword, cycle.number);
        let code = self.codes.code(key).ok_or(Refusal { code: "iso-no-code", span: cycle.head })?;
        let name = cycle.name.map_or(String::new(), |name| format!(" {}", self.text(name)));
        Ok(self.parameters(code + &name, &cycle.parameters.to_vec()))
    }

    fn global(&self, definition: &GlobalDef) -> Written {
        if let Some(error) = definition.errors.first() {
            return Err(no_equivalent(error.span));
        }
        let name = definition.name.map_or(String::new(), |name| format!(" {}", self.text(name)));
        let head = format!("GLOBAL DEF {}{name}", definition.number);
        Ok(self.parameters(head, &definition.parameters))
    }

    fn old(&self, view: &CycleView<'_>) -> Written {
        let CycleForm::Lines(lines) = &view.form else { return Err(no_equivalent(view.head)) };
        let key = fields::key(view.keyword, view.number);
        if self.codes.forms(key).next().is_none() {
            return Err(Refusal { code: "iso-no-code", span: view.head });
        }
        old::raise(self.program, lines, self.codes, key, self.explicit).map_err(no_equivalent)
    }

    fn statement(&self, statement: &Statement, whole: Span) -> Written {
        let values: Vec<&str> = statement.words.iter().map(|word| self.text(word.span)).collect();
        Ok(match statement.kind {
            StatementKind::CallSelected => {
                let program = self.flat(whole).to_ascii_uppercase().ends_with("PGM");
                if !program {
                    return Err(no_equivalent(whole));
                }
                "%<>%".to_owned()
            }
            StatementKind::Fn(14) => match values.as_slice() {
                [value] => format!("D14 P01 {value}"),
                _ => return Err(no_equivalent(whole)),
            },
            StatementKind::Fn(18) => format!("D18 {}", values.join(" ")),
            StatementKind::Fn(number @ (19 | 29)) => {
                let words = values.iter().zip(1..).map(|(value, at)| format!(" P{at:02} {value}"));
                format!("D{number}{}", words.collect::<String>())
            }
            StatementKind::Fn(number) => {
                let flat = self.flat(whole);
                let rest = flat.split_once(':').map(|(_, rest)| rest.trim()).ok_or(no_equivalent(whole))?;
                format!("D{number}: {rest}")
            }
            StatementKind::Fselect => return Err(no_equivalent(whole)),
            StatementKind::SetUndefined if !self.flat(whole).starts_with(['Q', 'q']) => {
                return Err(no_equivalent(whole));
            }
            _ => self.flat(whole),
        })
    }
}

/// The plane that stands for a tool axis.
const fn plane(axis: Axis) -> Option<&'static str> {
    match axis {
        Axis::Z => Some("G17"),
        Axis::Y => Some("G18"),
        Axis::X => Some("G19"),
        _ => None,
    }
}
