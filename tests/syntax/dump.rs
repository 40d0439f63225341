//! A readable form of parsed programs, for expectations.
use std::fmt::Write as _;

use ciklo::base::diag::Span;
use ciklo::program::syntax::{
    Amount, Axis, Block, BlockKind, CallForm, Compensation, Coord, Feed, FeedKind, IsoBlock, IsoKind, Label, LabelRef,
    MFunction, Motion, NamedWord, Operand, Parameter, Path, Program, ToolRef, Value, ValueKind,
};

/// The blocks, one a line, with what hangs on them indented.
pub(crate) fn dump(program: &Program) -> String {
    let mut out = String::new();
    for block in program.blocks() {
        head(program, block, &mut out);
        if let BlockKind::GlobalDef(definition) = &block.kind {
            definition.parameters.iter().for_each(|parameter| self::parameter(program, parameter, &mut out));
        }
        if let BlockKind::Iso(own) = &block.kind {
            own.parameters.iter().for_each(|parameter| self::parameter(program, parameter, &mut out));
            for error in &own.errors {
                let _ = writeln!(out, "    ! {} {:?}, not {}", error.code, program.slice(error.span), error.expected);
            }
        }
        if let BlockKind::CycleDef(cycle) = &block.kind {
            cycle.parameters.iter().for_each(|parameter| self::parameter(program, &parameter, &mut out));
            for error in &cycle.errors {
                let _ = writeln!(out, "    ! {} {:?}, not {}", error.code, program.slice(error.span), error.expected);
            }
        }
    }
    for cycle in program.cycles() {
        let name = cycle.name.map_or("-", |name| program.slice(name));
        let blocks = cycle.last - cycle.first + 1;
        let _ = writeln!(
            out,
            "= {} {} {name:?} on line {}, blocks {blocks}",
            cycle.keyword.as_str(),
            cycle.number,
            cycle.line
        );
    }
    for finding in program.diagnostics() {
        let at = finding.place.as_ref().map(|place| place.start());
        let at = at.map_or(String::new(), |at| format!("{}:{}", at.line, at.column));
        let _ = writeln!(out, "{at} {} {} {:?}", finding.severity.as_str(), finding.code, finding.args);
    }
    out
}

fn head(program: &Program, block: &Block, out: &mut String) {
    let last = block.line + block.lines - 1;
    let _ = if block.lines == 1 { write!(out, "{}", block.line) } else { write!(out, "{}-{last}", block.line) };
    let _ = write!(out, ": {}", block.kind.name());
    if let Some(number) = block.number {
        let _ = write!(out, " N{number}");
    }
    if block.skip {
        out.push_str(" /");
    }
    let body = body(program, &block.kind);
    if !body.is_empty() {
        let _ = write!(out, " | {body}");
    }
    if let Some(comment) = block.comment() {
        let _ = write!(out, " | {}", program.slice(comment));
    }
    if let Some(remark) = program.remark(block) {
        let _ = write!(out, " | remark {}", program.slice(remark));
    }
    out.push('\n');
}

fn body(program: &Program, kind: &BlockKind) -> String {
    let text = |span: Span| program.slice(span);
    match kind {
        BlockKind::Iso(block) => iso(program, block),
        BlockKind::Structure(span) | BlockKind::CallPgm(span) => format!("{:?}", text(*span)),
        BlockKind::BeginPgm(frame) | BlockKind::EndPgm(frame) => {
            format!("{:?} {}", text(frame.name), if frame.inch { "inch" } else { "mm" })
        }
        BlockKind::BlkForm(form) => {
            format!("{} {}{}", form.part, form.axis.map_or("", Axis::name), coords(&form.coords))
        }
        BlockKind::ToolCall(call) => {
            let tool = call.tool.map_or("-".to_owned(), |tool| self::tool(program, tool));
            let mut out = format!("{tool} {}", call.axis.map_or("-", Axis::name));
            for (name, value) in
                [("S", call.speed), ("VC", call.cutting_speed), ("DL", call.dl), ("DR", call.dr), ("DR2", call.dr2)]
            {
                if let Some(value) = value {
                    let _ = write!(out, " {name}={}", operand(value));
                }
            }
            out + &feed(call.feed)
        }
        BlockKind::ToolDef(def) => {
            let size = |value: Option<Operand>| value.map_or("-".to_owned(), operand);
            format!("{} L={} R={}", tool(program, def.tool), size(def.length), size(def.radius))
        }
        BlockKind::Motion(motion) => self::motion(program, motion),
        BlockKind::Functions(list) | BlockKind::Stop(list) => functions(program, list).trim_start().to_owned(),
        BlockKind::Lbl(label) => self::label(program, **label),
        BlockKind::CallLbl(call) => {
            let repeat = call.repeat.map_or(String::new(), |repeat| format!(" rep {}", operand(repeat)));
            label(program, call.label) + &repeat
        }
        BlockKind::Sel(selection) => format!("{} {:?}", text(selection.what), text(selection.name)),
        BlockKind::FnAssign(assign) => {
            let second = assign.b.map_or(String::new(), |b| format!(", {}", operand(b)));
            format!("{} = {:?} {}{second}", assign.target, assign.op, operand(assign.a))
        }
        BlockKind::FnJump(jump) => {
            let label = label(program, jump.label);
            format!("{} {:?} {} -> {label}", operand(jump.a), jump.relation, operand(jump.b))
        }
        BlockKind::Formula(formula) => {
            format!("{} = {:?} reads {:?}", formula.target, text(formula.text), formula.expr.q_refs())
        }
        BlockKind::CycleDef(cycle) => {
            format!("{} {:?}", text(cycle.head), cycle.name.map_or("", text))
        }
        BlockKind::OldCycleLine(line) => {
            let mut out = format!("{}.{} {:?}", line.number, line.line, line.name.map_or("", text));
            for word in &line.words {
                let _ = write!(out, " [{}={}]", text(word.name), value(program, word.value));
            }
            out
        }
        BlockKind::CyclCall(call) => {
            let form = match &call.form {
                CallForm::Plain => "here".to_owned(),
                CallForm::Pattern => "pattern".to_owned(),
                CallForm::Position(position) => format!("position{}", coords(position)),
            };
            form + &feed(call.feed) + &functions(program, &call.functions)
        }
        BlockKind::Statement(statement) => format!("{:?}{}", text(statement.head), named(program, &statement.words)),
        BlockKind::PatternDef(pattern) => pattern.items.iter().fold(String::new(), |mut out, item| {
            let _ = write!(out, "{}({}) ", text(item.name), named(program, &item.words).trim_start());
            out
        }),
        BlockKind::GlobalDef(definition) => format!("{} {:?}", text(definition.head), definition.name.map_or("", text)),
        BlockKind::ContourFormula(formula) => {
            let reads: Vec<u32> = formula.reads.iter().map(|(number, _)| *number).collect();
            format!("QC{} = {:?} reads {reads:?}", formula.target, text(formula.text))
        }
        BlockKind::TextFormula(formula) => {
            let calls = formula.calls.iter().fold(String::new(), |mut out, call| {
                let _ = write!(out, " {}({})", text(call.name), named(program, &call.words).trim_start());
                out
            });
            format!("{} = {:?} calls{calls}", formula.target, text(formula.text))
        }
        BlockKind::Unknown(error) => format!("{} {:?}, not {}", error.code, text(error.span), error.expected),
        _ => String::new(),
    }
}

fn parameter(program: &Program, parameter: &Parameter, out: &mut String) {
    let label = parameter.label.map_or(String::new(), |label| format!(" {:?}", program.slice(label)));
    let _ = writeln!(out, "    {} = {}{label}", parameter.q, value(program, parameter.value));
}

fn value(program: &Program, value: Value) -> String {
    match value.kind {
        ValueKind::Number(number) => format!("{number}"),
        ValueKind::Q { negative, q } => format!("{}{q}", if negative { "-" } else { "" }),
        ValueKind::Word => format!("word {}", program.slice(value.span)),
        ValueKind::Text(inside) => format!("text {:?}", program.slice(inside)),
        ValueKind::Sign(minus) => format!("sign {}", if minus { '-' } else { '+' }),
        ValueKind::Missing => "nothing".to_owned(),
    }
}

fn named(program: &Program, words: &[NamedWord]) -> String {
    words.iter().fold(String::new(), |mut out, word| {
        let _ = write!(out, " [{}={}]", program.slice(word.name), value(program, word.value));
        out
    })
}

fn operand(operand: Operand) -> String {
    match operand.amount {
        Amount::Number(number) => format!("{number}"),
        Amount::Q { negative, q } => format!("{}{q}", if negative { "-" } else { "" }),
        Amount::Text(_) => "a text".to_owned(),
    }
}

fn tool(program: &Program, tool: ToolRef) -> String {
    match tool {
        ToolRef::Number(number) => operand(number),
        ToolRef::Name(name) => format!("{:?}", program.slice(name)),
    }
}

fn coords(coords: &[Coord]) -> String {
    coords.iter().fold(String::new(), |mut out, coord| {
        let sign = if coord.incremental { "I" } else { "" };
        let _ = write!(out, " {sign}{}={}", coord.axis.name(), operand(coord.value));
        out
    })
}

fn feed(feed: Option<Feed>) -> String {
    match feed.map(|feed| feed.kind) {
        None => String::new(),
        Some(FeedKind::Value(value)) => format!(" F={}", operand(value)),
        Some(FeedKind::Max) => " FMAX".to_owned(),
        Some(FeedKind::Auto) => " FAUTO".to_owned(),
        Some(FeedKind::PerRevolution(value)) => format!(" FU={}", operand(value)),
        Some(FeedKind::PerTooth(value)) => format!(" FZ={}", operand(value)),
    }
}

fn functions(program: &Program, list: &[MFunction]) -> String {
    list.iter().fold(String::new(), |mut out, function| {
        let with = function.with.map_or(String::new(), |with| format!("({})", program.slice(with)));
        let _ = write!(out, " M{}{with}", function.number);
        out
    })
}

fn motion(program: &Program, motion: &Motion) -> String {
    let mut out = coords(&motion.coords);
    if let Some(radius) = motion.radius {
        let _ = write!(out, " r={}", operand(radius));
    }
    match motion.counter_clockwise {
        Some(true) => out.push_str(" DR+"),
        Some(false) => out.push_str(" DR-"),
        None => {}
    }
    out.push_str(match motion.compensation {
        None => "",
        Some(Compensation::R0) => " R0",
        Some(Compensation::Rl) => " RL",
        Some(Compensation::Rr) => " RR",
        Some(Compensation::Longer) => " R+",
        Some(Compensation::Shorter) => " R-",
    });
    let form = match motion.path {
        Path::Appr(form) | Path::Dep(form) => format!("{form:?}"),
        _ => String::new(),
    };
    let words = named(program, &motion.words);
    (form + &out + &words + &feed(motion.feed) + &functions(program, &motion.functions)).trim_start().to_owned()
}

fn label(program: &Program, label: LabelRef) -> String {
    match label.target {
        Label::Number(number) => format!("{number}"),
        Label::Name(name) => format!("{:?}", program.slice(name)),
        Label::Q(q) => format!("{q}"),
    }
}

fn iso(program: &Program, block: &IsoBlock) -> String {
    let mut out = match block.kind {
        IsoKind::Path(Some(code)) => format!("G{code:02}"),
        IsoKind::Select { what, name } => format!("{} {:?}", program.slice(what), program.slice(name)),
        _ => String::new(),
    };
    for word in &block.words {
        let _ = write!(out, " {}={}", program.slice(word.name), value(program, word.value));
    }
    out.push_str(&functions(program, &block.functions));
    if let Some(name) = block.name {
        let _ = write!(out, " {:?}", program.slice(name));
    }
    for remark in &block.remarks {
        let _ = write!(out, " {}", program.slice(*remark));
    }
    out.trim_start().to_owned()
}
