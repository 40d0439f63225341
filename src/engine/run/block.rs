//! Blocks: what each kind does, and the M functions.
//!
//! Invariant: an M function that is not listed here is a fault, never ignored.
use glam::DVec3;

use super::program::After;
use crate::base::diag::Span;
use crate::base::expr::{Env, EvalError, QKind, QRef, Value, atan2d, cosd, sind};
use crate::engine::flow::state::Run;
use crate::engine::geometry::RotaryAxis;
use crate::engine::motion::axis::linear;
use crate::engine::motion::functions::{Effect, effect};
use crate::engine::motion::moves::Speed;
use crate::engine::motion::tilt::Back;
use crate::engine::params::Content;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::table::{Cell, TableKind};
use crate::engine::world::insert::Aligned;
use crate::engine::world::state::LOCKED;
use crate::program::syntax::{
    Amount, Block, BlockKind, CallForm, CyclCall, FeedKind, FnAssign, FnOp, MFunction, Motion, Operand, Path,
    StatementKind, ToolCall, ToolDef, ToolRef,
};

/// The parameter that has the radius of the tool in the spindle.
const TOOL_RADIUS: u16 = 108;

/// Q parameters while a program's formula is evaluated: there are no other names.
struct ProgramEnv<'p>(&'p super::Params);

static NOTHING: Value = Value::Bool(false);

impl Env for ProgramEnv<'_> {
    fn slot(&self, _: usize) -> &Value {
        &NOTHING
    }

    fn number(&self, q: QRef) -> Result<f64, EvalError> {
        self.0.number(q)
    }

    fn text(&self, q: QRef) -> Result<std::sync::Arc<str>, EvalError> {
        self.0.text(q)
    }
}

impl<'e> Run<'_, 'e> {
    fn motion_block(&mut self, motion: &Motion) -> Done<After> {
        let goes = motion.path != Path::L || !motion.coords.is_empty();
        let fed = motion.feed.is_some_and(|feed| feed.kind != FeedKind::Max);
        self.before(&motion.functions, !goes && !fed)?;
        let in_machine = motion
            .functions
            .iter()
            .any(|function| matches!(effect(function.number), Some(Effect::MachineCoordinates | Effect::SecondDatum)));
        let positioned = self.motion(motion, in_machine)?;
        self.after(&motion.functions, positioned)
    }

    pub(super) fn block(&mut self, block: &'e Block) -> Done<After> {
        if self.contour.is_under_way() {
            self.contour.no_more_waits(&self.drives.report)?;
        }
        match &block.kind {
            BlockKind::Empty
            | BlockKind::Comment
            | BlockKind::Structure(_)
            | BlockKind::BlkForm(_)
            | BlockKind::OldCycleLine(_)
                if self.definition_here().is_none() => {}
            BlockKind::BeginPgm(_) => {}
            BlockKind::EndPgm(_) => return Ok(After::End),
            BlockKind::ToolCall(call) => self.tool_call(call)?,
            BlockKind::ToolDef(definition) => self.tool_definition(definition)?,
            BlockKind::Motion(element) if self.calls.is_first_time() => {
                // The words of blocks that are executed once are not kept: programs of CAM systems have millions.
                let mut words = std::mem::replace(&mut self.words, Motion::new(Path::L));
                element.read_into(&mut words);
                let done = self.motion_block(&words);
                self.words = words;
                return done;
            }
            BlockKind::Motion(element) => return self.motion_block(element),
            BlockKind::Functions(functions) => {
                let content = Span::new(block.span.start, block.comment().map_or(block.span.end, |span| span.start));
                self.before(functions, !self.slice(content).contains(['F', 'f']))?;
                return self.after(functions, false);
            }
            BlockKind::Lbl(label) => self.label(label)?,
            BlockKind::CallLbl(call) => self.call_label(call)?,
            BlockKind::CallPgm(name) => {
                let name = self.named_text(self.slice(*name))?;
                self.call_program(&name)?;
            }
            BlockKind::Sel(selection) => self.select(self.slice(selection.what), self.slice(selection.name))?,
            BlockKind::FnAssign(assign) => self.assign(assign)?,
            BlockKind::FnJump(jump) => self.jump(jump)?,
            BlockKind::Formula(formula) => self.formula(formula.target)?,
            BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) => self.define_here()?,
            BlockKind::CyclCall(call) => return self.cycle_call(call),
            BlockKind::Stop(functions) => {
                self.before(functions, false)?;
                self.stop()?;
                return self.after(functions, false);
            }
            BlockKind::Statement(statement) if statement.kind == StatementKind::Fselect => self.selection()?,
            BlockKind::Statement(statement) if self.is_form_element(statement) => self.form_element(statement)?,
            BlockKind::Statement(statement) if self.drives.beside_contour => {
                let head = self.slice(statement.head).trim();
                match statement.kind {
                    StatementKind::Plane => self.drives.not_compensated(head)?,
                    _ => self.drives.not_beside_contour(head)?,
                }
            }
            BlockKind::Statement(_) if self.switches_mode(block)? => {}
            BlockKind::Statement(statement) if statement.kind == StatementKind::Function => {
                self.function(block, statement)?;
            }
            BlockKind::Statement(statement) if statement.kind == StatementKind::Plane => self.plane(statement)?,
            BlockKind::Statement(statement) if statement.kind == StatementKind::Trans => {
                self.transform_system(statement)?
            }
            BlockKind::Statement(statement) if statement.kind == StatementKind::BlkForm => {}
            BlockKind::Statement(statement) if statement.kind == StatementKind::DeclareContour => {
                self.declare_contour(statement)?;
            }
            BlockKind::Statement(statement) if statement.kind == StatementKind::ContourDef => {
                self.define_contour(statement)?;
            }
            BlockKind::Statement(statement) => self.statement(block, statement)?,
            BlockKind::PatternDef(_) => self.define_pattern(block)?,
            BlockKind::GlobalDef(values) => self.predefine(values)?,
            BlockKind::ContourFormula(formula) => self.contour_formula(formula)?,
            BlockKind::TextFormula(formula) => self.text_formula(formula)?,
            // What Klartext has no equivalent of is left over, and is in a comment.
            BlockKind::Iso(_) => {
                let span = block.comment().unwrap_or(block.span);
                return Err(self.not_executed(Span::new(span.start + 1, span.end)).into());
            }
            BlockKind::Unknown(error) => {
                let found = self.slice(error.span).trim().chars().take(40).collect::<String>();
                return Err(Fault::program("block-unreadable").arg("found", found).into());
            }
            _ => {}
        }
        Ok(After::GoOn)
    }

    fn assign(&mut self, assign: &FnAssign) -> Done {
        let a = self.operand(&assign.a)?;
        let b = assign.b.as_ref().map_or(Ok(0.0), |b| self.operand(b))?;
        let value = match assign.op {
            FnOp::Set => a,
            FnOp::Add => a + b,
            FnOp::Sub => a - b,
            FnOp::Mul => a * b,
            FnOp::Div if b == 0.0 => return Err(EvalError::DivisionByZero.into()),
            FnOp::Div => a / b,
            FnOp::Sqrt if a < 0.0 => return Err(EvalError::Domain(crate::base::expr::Func::Sqrt, a).into()),
            FnOp::Sqrt => libm::sqrt(a),
            FnOp::Sin => sind(a),
            FnOp::Cos => cosd(a),
            FnOp::Len => libm::hypot(a, b),
            FnOp::Ang => atan2d(a, b).rem_euclid(360.0),
        };
        if !value.is_finite() {
            return Err(EvalError::Overflow.into());
        }
        Ok(self.set(assign.target, Content::Number(value))?)
    }

    fn formula(&mut self, target: QRef) -> Done {
        let code = self.calls.here().and_then(|prepared| prepared.formula(self.calls.block));
        let Some(code) = code else { return Err(EvalError::Kind.into()) };
        let value = match (target.kind, code.eval(&ProgramEnv(&self.params))?) {
            (QKind::Qs, Value::Text(text)) => Content::Text(text),
            (QKind::Q | QKind::Ql | QKind::Qr, Value::Number(number)) => Content::Number(number),
            _ => return Err(EvalError::Kind.into()),
        };
        Ok(self.set(target, value)?)
    }

    /// `FUNCTION MODE TURN` and `FUNCTION MODE MILL`: in turning X is a diameter. A name after that is the kinematics to
    /// be used; the scene has one machine, which must be that.
    fn switches_mode(&mut self, block: &Block) -> Result<bool, Fault> {
        let text = self.slice(block.span);
        let words: Vec<String> = text
            .split_ascii_whitespace()
            .skip_while(|word| word.bytes().all(|b| b.is_ascii_digit()))
            .take(3)
            .map(str::to_ascii_uppercase)
            .collect();
        let turning = match words.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
            ["FUNCTION", "MODE", "TURN"] => true,
            ["FUNCTION", "MODE", "MILL"] => false,
            _ => return Ok(false),
        };
        let machine = &self.drives.world.kinematics().name;
        let named = text.split(';').next().and_then(|text| text.split('"').nth(1)).map(str::trim);
        if let Some(name) = named.filter(|name| !name.eq_ignore_ascii_case(machine)) {
            return Err(Fault::unsupported("kinematics-unknown").arg("name", name).arg("machine", machine.clone()));
        }
        self.drives.world.system.turning = turning;
        if !turning {
            self.drives.align(Aligned::default());
        }
        Ok(true)
    }

    fn select(&mut self, what: &str, name: &str) -> Done {
        if what.eq_ignore_ascii_case("PATTERN") {
            return self.select_pattern(name);
        }
        if what.eq_ignore_ascii_case("CONTOUR") {
            return self.select_contour(name);
        }
        if what.eq_ignore_ascii_case("PGM") {
            return self.select_program(name);
        }
        if !what.eq_ignore_ascii_case("TABLE") {
            return Err(Fault::unsupported("unsupported-block").arg("word", format!("SEL {what}")).into());
        }
        Ok(self.drives.world.select_datum_table(name)?)
    }

    fn tool_number(&self, tool: &ToolRef) -> Result<f64, Fault> {
        let named = |name: &str| match self.drives.world.tool_named(name)? {
            Some(number) => Ok(number),
            None => Err(Fault::program("tool-not-in-table").arg("tool", name)),
        };
        match tool {
            ToolRef::Number(Operand { amount: Amount::Q { q, .. }, .. }) if q.kind == QKind::Qs => {
                named(&self.params.text(*q)?)
            }
            ToolRef::Number(operand) => self.operand(operand),
            ToolRef::Name(span) => named(self.slice(*span)),
        }
    }

    fn tool_call(&mut self, call: &ToolCall) -> Done {
        self.drives.not_beside_contour("TOOL CALL")?;
        let before = self.drives.switched.spindle;
        if call.cutting_speed.is_some() {
            return Err(Fault::unsupported("unsupported-block").arg("word", "TOOL CALL VC").into());
        }
        if let Some(axis) = call.axis {
            self.drives.world.system.set_plane(linear(axis)?);
            self.drives.world.renew();
        }
        if let Some(tool) = &call.tool {
            let number = self.tool_number(tool)?;
            let delta = |value: &Option<Operand>| {
                value.as_ref().map_or(Ok(0.0), |value| Ok::<_, Fault>(self.operand(value)? * self.drives.unit()))
            };
            let (delta_radius, delta_length) = (delta(&call.dr)?, delta(&call.dl)?);
            let table = self.drives.world.table(TableKind::Tool)?;
            if self.drives.world.has_tools() && !self.drives.world.has_tool(number) {
                return Err(Fault::program("tool-not-in-table").arg("tool", number).into());
            }
            if table.has_row(number) && table.text(number, "TL")? == LOCKED {
                return Err(Fault::control("tool-locked").arg("tool", number).into());
            }
            let mut tool = self.drives.world.tool_data(number, delta_radius, delta_length)?;
            tool.corner += delta(&call.dr2)?;
            let before = self.drives.world.system.reported();
            // The active radius, as formulas of programs read it.
            let radius = Content::Number(tool.radius / self.drives.unit());
            self.params.set(QRef { kind: QKind::Q, number: TOOL_RADIUS }, &radius)?;
            self.drives.world.take_tool(tool);
            self.drives.transformed(before);
        }
        if let Some(speed) = &call.speed {
            self.drives.switched.spindle.speed = self.operand(speed)?;
        }
        if let Some(feed) = &call.feed {
            let turns = match feed.kind {
                FeedKind::Value(_) => 1.0,
                FeedKind::PerRevolution(_) => self.drives.switched.spindle.speed,
                FeedKind::PerTooth(_) => {
                    self.drives.switched.spindle.speed * self.drives.world.tool().map_or(0.0, |tool| tool.teeth)
                }
                FeedKind::Max | FeedKind::Auto => 0.0,
            };
            match feed.kind {
                FeedKind::Value(value) | FeedKind::PerRevolution(value) | FeedKind::PerTooth(value) => {
                    let value = self.operand(&value)? * self.drives.unit() * turns;
                    (self.modal.feed, self.modal.tool_feed) = (Some(value), Some(value));
                }
                FeedKind::Max | FeedKind::Auto => {
                    return Err(Fault::unsupported("unsupported-feed").arg("word", self.slice(feed.span)).into());
                }
            }
        }
        let called = call.tool.as_ref().and(self.drives.world.tool());
        let turns_otherwise = self.drives.switched.spindle != before && before.direction != 0;
        if called.is_some() || turns_otherwise {
            self.drives.report_spindle(called.map(|tool| (tool, self.drives.world.system.plane.tool)));
        }
        Ok(())
    }

    /// Tool data in the program: they are as good as a row of the table.
    fn tool_definition(&mut self, definition: &ToolDef) -> Done {
        let number = self.tool_number(&definition.tool)?;
        for (column, value) in [("L", &definition.length), ("R", &definition.radius)] {
            let Some(value) = value else { continue };
            let value = self.operand(value)? * self.drives.unit();
            if let Some(table) = self.drives.world.tools_of_program() {
                table.add_row(number)?;
                table.set(number, column, &Cell::Number(value))?;
            }
        }
        Ok(())
    }

    fn cycle_call(&mut self, call: &CyclCall) -> Done<After> {
        self.before(&call.functions, false)?;
        match &call.form {
            CallForm::Plain => self.call_last_cycle()?,
            CallForm::Pattern => self.call_on_pattern(call.feed.as_ref())?,
            CallForm::Position(coords) => self.call_at(coords, call.feed.as_ref())?,
        }
        self.after(&call.functions, false)
    }

    /// M functions that act at the beginning of their block; whether one may retract there.
    fn before(&mut self, functions: &[MFunction], retracts: bool) -> Done {
        for function in functions {
            let Some(effect) = effect(function.number) else { return Err(self.no_function(function).into()) };
            match effect {
                // In a block that moves, too, a length comes first.
                Effect::Retract if retracts || function.with.is_some() => self.retract(function)?,
                Effect::Retract => return Err(self.no_function(function).into()),
                Effect::SecondDatum if self.drives.world.scene.machine.second_datum.is_none() => {
                    return Err(self.no_function(function).into());
                }
                Effect::ArcFeed(feed) => self.contour.arc_feed = feed,
                Effect::PlungeFactor => self.modal.plunge_factor = self.factor_of(function)?,
                Effect::ShorterWay(shorter) => self.modal.shorter_way = shorter,
                Effect::ReduceDisplay => self.reduce_display(),
                Effect::FeedAtTool(on) => self.modal.feed_at_tool = on,
                Effect::TiltingAxes => self.choose_tilting_axes(function)?,
                Effect::EndBasicRotation => {
                    let before = self.drives.world.system.reported();
                    self.drives.world.system.set_basic_rotation(0.0);
                    self.drives.transformed(before);
                }
                Effect::Spindle(direction) if direction != 0 => self.drives.spindle(direction),
                Effect::Coolant(true) => self.drives.coolant(true),
                Effect::TurnWorkpiece(direction) if direction != 0 => self.drives.turn_workpiece(direction)?,
                Effect::PerRevolution(on) => self.drives.switched.per_revolution = on,
                Effect::HoldTip(true) => self.drives.hold_tip(true)?,
                Effect::CountAxes(true) => self.drives.count_axes(true)?,
                Effect::Orient => self.drives.orient(self.drives.switched.orientation),
                Effect::SpindleAndCoolant(direction) => {
                    self.drives.spindle(direction);
                    self.drives.coolant(true);
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn no_function(&self, function: &MFunction) -> Fault {
        Fault::unsupported("unsupported-m").arg("word", self.slice(function.span).trim())
    }

    /// `M103 F20`: the share of the feed; nothing where none is written, which ends it.
    fn factor_of(&self, function: &MFunction) -> Result<Option<f64>, Fault> {
        let Some(with) = function.with else { return Ok(None) };
        let written = self.slice(with).trim();
        let Some(number) = written.strip_prefix(['F', 'f']) else { return Err(self.no_function(function)) };
        let percent = self.written_number(number)?;
        if percent > 0.0 { Ok(Some(percent / 100.0)) } else { Err(Fault::program("feed-missing").arg("feed", percent)) }
    }

    /// `M138 A C`: only these axes are turned for a tilted plane, others stay at 0; `M138` alone: all of them again.
    fn choose_tilting_axes(&mut self, function: &MFunction) -> Done {
        if self.drives.world.system.tip_held {
            return Err(self.no_function(function).into());
        }
        let written = function.with.map_or("", |with| self.slice(with));
        let mut axes = Vec::new();
        for letter in written.chars().filter(|c| c.is_ascii_alphabetic()) {
            let axis =
                RotaryAxis::from_letter(letter.to_ascii_uppercase()).ok_or_else(|| self.no_function(function))?;
            self.drives.rotary_axis(axis)?;
            axes.push(axis);
        }
        self.drives.world.tilting_axes = Some(axes).filter(|axes| !axes.is_empty());
        Ok(())
    }

    /// `M94`: the rotary axes are displayed below 360 degrees. Nothing turns.
    fn reduce_display(&mut self) {
        let endless = self.drives.world.scene.machine.rotary.iter().filter(|axis| axis.is_endless());
        let axes: Vec<_> = endless.map(|axis| axis.axis).collect();
        let reduced = |angles: DVec3, axis: &RotaryAxis| axis.with(angles, axis.of(angles).rem_euclid(360.0));
        let angles = axes.iter().fold(self.drives.world.angles, reduced);
        self.drives.world.turn(angles);
    }

    /// `M140 MB50`, `M140 MB50 F750`, `M140 MB MAX`: away from the workpiece, by a length or to the end of the axes, at
    /// rapid traverse where no feed is written. In a tilted working plane along its tool axis. Only where the tool is
    /// along the tool axis that the control reckons with.
    fn retract(&mut self, function: &MFunction) -> Done {
        let length = function.with.map(|with| self.slice(with).to_ascii_uppercase());
        let written = length.as_deref().and_then(|with| with.trim().strip_prefix("MB")).map(str::trim);
        let (length, feed) = match written.and_then(|written| written.split_once('F')) {
            Some((length, feed)) => (Some(length.trim()), Some(feed.trim())),
            None => (written, None),
        };
        let speed = match feed.filter(|feed| *feed != "MAX") {
            Some(feed) => Speed::of_feed(self.written_number(feed)? * self.drives.unit()),
            None => Ok(Speed::Rapid),
        };
        let along = self.drives.along_tool_axis().filter(|_| !self.drives.world.parallels.drive());
        let (Some(length), Some(along), false) = (length, along, self.contour.is_under_way()) else {
            return Err(self.no_function(function).into());
        };
        let back = match length.replace(',', ".").parse::<f64>() {
            _ if length == "MAX" => Back::ToLimit,
            Ok(length) => Back::By(length * self.drives.unit()),
            Err(_) => return Err(self.no_function(function).into()),
        };
        self.drives.retract_along(along, back, speed)
    }

    /// M functions that act at the end of their block, and the call of the last cycle.
    fn after(&mut self, functions: &[MFunction], positioned: bool) -> Done<After> {
        let has = |wanted| functions.iter().any(|function| effect(function.number) == Some(wanted));
        if has(Effect::CallAlways) {
            self.modal.call_always = true;
        }
        let once = has(Effect::CallOnce);
        if once || (self.modal.call_always && (positioned || has(Effect::CallAlways))) {
            self.call_last_cycle()?;
        }
        if once {
            self.modal.call_always = false;
        }
        let ends = has(Effect::End);
        if ends {
            self.end_contour()?;
        }
        if has(Effect::Spindle(0)) || (ends && self.drives.switched.spindle.direction != 0) {
            self.drives.spindle(0);
        }
        if has(Effect::TurnWorkpiece(0)) || (ends && self.drives.switched.turned.direction != 0) {
            self.drives.turn_workpiece(0)?;
        }
        if has(Effect::Coolant(false)) || (ends && self.drives.switched.coolant) {
            self.drives.coolant(false);
        }
        if has(Effect::HoldTip(false)) {
            self.drives.hold_tip(false)?;
        }
        if has(Effect::CountAxes(false)) {
            self.drives.count_axes(false)?;
        }
        if has(Effect::Stop) {
            self.stop()?;
        }
        if ends {
            self.modal.feed_at_tool = false;
            self.drives.end_changes();
        }
        Ok(if ends { After::End } else { After::GoOn })
    }
}
