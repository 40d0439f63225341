//! What a block does to the state.
//!
//! Invariant: what is not known for certain to stay as it is, is forgotten.
use super::effects::{Effects, shifted};
use super::project::Callees;
use super::state::{Known, Loaded, Modal, Pending, State, Values};
use crate::base::diag::Span;
use crate::base::expr::{Code, EvalError, Expr, OnlyParameters, QKind, compile};
use crate::check::cycle::{Aspect, Tri};
use crate::check::program::{Hides, Reading, each_function, hides};
use crate::program::syntax::{
    Amount, Axis, Block, BlockKind, CallForm, Compensates, Element, Feed, FeedKind, FnAssign, FnOp, IsoKind, NamedWord,
    Operand, Path, Program, Statement, StatementKind, ToolRef, ValueKind,
};

/// What stepping needs besides the state.
pub(super) struct Steps<'f, 'a> {
    pub(super) program: &'a Program,
    /// What the definitions do.
    effects: Effects<'f, 'a>,
    /// What called programs do.
    callees: &'f Callees,
}

impl<'f, 'a> Steps<'f, 'a> {
    pub(super) fn new(reading: &'f Reading<'a>, callees: &'f Callees) -> Self {
        Self { program: reading.program, effects: Effects::of(reading), callees }
    }

    /// What a call of the pending cycle leaves behind: its feed may stay, and a program may do what it does.
    fn called(&self, state: &mut State) {
        state.modal.set(Aspect::Feed, Tri::Unknown);
        if let Pending::Definition(index) = state.modal.pending
            && self.effects.stops_spindle(index)
        {
            state.modal.set(Aspect::Spindle, Tri::No);
            state.modal.set(Aspect::Stopped, Tri::Yes);
        }
        if let Pending::Definition(index) = state.modal.pending
            && self.effects.taps_rigidly(index)
        {
            state.modal.set(Aspect::Spindle, Tri::Unknown);
        }
        match state.modal.pending {
            Pending::Definition(index) if self.effects.cuts(index) => state.modal.set(Aspect::Cut, Tri::Yes),
            Pending::Definition(_) | Pending::None => {}
            Pending::Unknown => state.modal.set(Aspect::Cut, Tri::Unknown),
        }
        if self.callees.made.is_empty() {
            return;
        }
        match state.modal.pending {
            Pending::Definition(index) if !self.callees.made.contains(&(index as usize)) => {}
            Pending::Definition(index) => match self.callees.cycles.get(&(index as usize)) {
                Some(callee) => callee.effect.apply(state),
                None => state.forget(),
            },
            Pending::Unknown => state.forget(),
            Pending::None => {}
        }
    }

    /// The call that a block is which defines a pattern: it calls the cycle before it.
    pub(super) fn pattern_at(&self, index: usize, block: &Block) -> Option<Span> {
        let defines = matches!(block.kind, BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_));
        if defines { self.effects.pattern_at(index) } else { None }
    }

    fn functions(&self, block: &Block, state: &mut State) {
        start(block, &mut state.modal);
        each_function(block, |number| match number {
            // Here another tool may be put in by hand.
            0 | 6 => {
                state.modal.set(Aspect::Spindle, Tri::No);
                tool_unknown(&mut state.modal);
            }
            2 | 5 | 30 => state.modal.set(Aspect::Spindle, Tri::No),
            128 => state.modal.set(Aspect::Tcpm, Tri::Yes),
            129 => state.modal.set(Aspect::Tcpm, Tri::No),
            136 => state.modal.set(Aspect::PerRevolution, Tri::Yes),
            137 => state.modal.set(Aspect::PerRevolution, Tri::No),
            // From here on every movement calls it.
            89 if !self.callees.made.is_empty() => state.forget(),
            89 | 99 => self.called(state),
            1 | 3 | 4 | 8 | 9 | 13 | 14 | 90..=199 => {}
            // What else an M function does is the machine builder's affair.
            _ => {
                state.modal.set(Aspect::Spindle, Tri::Unknown);
                state.modal.set(Aspect::Unstarted, Tri::Unknown);
                state.modal.set(Aspect::Counterclockwise, Tri::Unknown);
                tool_unknown(&mut state.modal);
            }
        });
    }

    /// The state after the M functions at the start of a block, where its call happens.
    pub(super) fn at_call(&self, block: &Block, state: &State) -> Modal {
        let mut modal = state.modal;
        if let BlockKind::Motion(motion) = &block.kind {
            self.motion(motion, &mut modal);
        }
        start(block, &mut modal);
        modal
    }

    /// Carries the state over a block; what may be skipped may also not happen.
    pub(super) fn step(&self, index: usize, block: &Block, state: &mut State) {
        let skipped = block.skip.then(|| state.clone());
        self.act(index, block, state);
        if let Some(skipped) = skipped {
            *state = state.join(&skipped);
        }
    }

    fn act(&self, index: usize, block: &Block, state: &mut State) {
        match &block.kind {
            BlockKind::Motion(motion) => {
                self.motion(motion, &mut state.modal);
                if motion.has_functions() {
                    self.functions(block, state);
                }
            }
            BlockKind::Functions(_) => self.functions(block, state),
            BlockKind::Stop(_) => {
                self.functions(block, state);
                tool_unknown(&mut state.modal);
            }
            BlockKind::ToolCall(call) => {
                if let Some(tool) = call.tool {
                    let other = self.is_other(tool, state);
                    state.modal.set(Aspect::Unstarted, other);
                    let named = if call.axis.is_some() { Tri::Yes } else { Tri::Unknown };
                    state.modal.set(Aspect::Tool, named);
                    state.modal.set(Aspect::Probed, Tri::No);
                    state.modal.set(Aspect::Cut, Tri::No);
                    state.modal.set(Aspect::Aligned, Tri::No);
                    state.modal.loaded = u32::try_from(index).map_or(Loaded::Unknown, Loaded::By);
                    // Whether the change stops the spindle is the machine builder's affair.
                    if state.modal.is(Aspect::Spindle) != Tri::No {
                        state.modal.set(Aspect::Spindle, Tri::Unknown);
                    }
                } else if call.axis.is_some() {
                    state.modal.set(Aspect::Tool, Tri::Yes);
                }
                // Without a tool, other oversizes are those of the same one.
                if call.tool.is_none() && (call.dl.is_some() || call.dr.is_some() || call.dr2.is_some()) {
                    state.modal.loaded = Loaded::Unknown;
                }
                if let Some(axis) = call.axis {
                    state.modal.set(Aspect::OtherAxis, Tri::of(Some(axis != Axis::Z)));
                }
                match call.feed.as_ref().map(|feed| feed.kind) {
                    Some(FeedKind::Value(own)) => {
                        state.modal.set(Aspect::ToolFeed, Tri::of(Some(own.amount != Amount::Number(0.0))));
                    }
                    Some(_) => state.modal.set(Aspect::ToolFeed, Tri::Yes),
                    // Whether a new tool keeps the feed of the one before is not said anywhere.
                    None if call.tool.is_some() && state.modal.is(Aspect::ToolFeed) != Tri::No => {
                        state.modal.set(Aspect::ToolFeed, Tri::Unknown);
                    }
                    None => {}
                }
                // S0 turns nothing.
                let zero = |own: &Operand| own.amount == Amount::Number(0.0);
                if let Some(speed) = call.speed.as_ref().or(call.cutting_speed.as_ref()) {
                    state.modal.set(Aspect::Speed, Tri::of(Some(!zero(speed))));
                }
                feed(call.feed.as_ref(), &mut state.modal);
            }
            BlockKind::CyclCall(call) => {
                self.functions(block, state);
                feed(call.feed.as_ref(), &mut state.modal);
                self.called(state);
                if let CallForm::Position(_) = call.form {
                    state.modal.set(Aspect::Feed, Tri::Unknown);
                }
            }
            BlockKind::FnAssign(assign) => state.set(assign.target, assigned(assign, state)),
            BlockKind::Formula(formula) => {
                let value = self.formula(&formula.expr, state);
                state.set(formula.target, value);
            }
            BlockKind::TextFormula(formula) => state.set(formula.target, Known::Unknown),
            BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) => self.effects.apply(index, state),
            BlockKind::GlobalDef(definition) => {
                for parameter in &definition.parameters {
                    state.set(parameter.q, Known::Unknown);
                }
            }
            BlockKind::PatternDef(_) => state.modal.set(Aspect::Pattern, Tri::Yes),
            BlockKind::ContourFormula(_) => state.modal.set(Aspect::Contour, Tri::Yes),
            BlockKind::Sel(own) => {
                let what = self.program.slice(own.what);
                let is = |word: &str| what.eq_ignore_ascii_case(word);
                let (program, table) = (is("PGM") || is("CYCLE"), is("TABLE"));
                if program {
                    state.modal.set(Aspect::Selected, Tri::Yes);
                }
                // A table of datums is neither a pattern nor a contour.
                for (aspect, own, other) in
                    [(Aspect::Pattern, "PATTERN", "CONTOUR"), (Aspect::Contour, "CONTOUR", "PATTERN")]
                {
                    if is(own) || !(program || table || is(other)) {
                        state.modal.set(aspect, Tri::Unknown);
                    }
                }
            }
            BlockKind::Statement(own) if own.kind == StatementKind::CallSelected => self.program_called(index, state),
            BlockKind::Statement(statement) => self.statement(statement, state),
            BlockKind::CallPgm(_) => self.program_called(index, state),
            BlockKind::Iso(_) if block.is_blend() => {}
            BlockKind::Unknown(_) | BlockKind::Iso(_) => self.unread(block, state),
            _ => {}
        }
    }

    /// Whether a tool is another one than that in the spindle.
    fn is_other(&self, tool: ToolRef, state: &State) -> Tri {
        let Loaded::By(block) = state.modal.loaded else { return Tri::Unknown };
        let Some(BlockKind::ToolCall(before)) = self.program.blocks().get(block as usize).map(|block| &block.kind)
        else {
            return Tri::Unknown;
        };
        match (before.tool, tool) {
            (Some(ToolRef::Number(one)), ToolRef::Number(other)) => match (value(&one, state), value(&other, state)) {
                (Known::Number(one), Known::Number(other)) => Tri::of(Some(libm::trunc(one) != libm::trunc(other))),
                _ => Tri::Unknown,
            },
            (Some(ToolRef::Name(one)), ToolRef::Name(other)) => {
                Tri::of(Some(self.program.slice(one).trim() != self.program.slice(other).trim()))
            }
            _ => Tri::Unknown,
        }
    }

    /// What a block that cannot be read may have done.
    fn unread(&self, block: &Block, state: &mut State) {
        match hides(self.program, block) {
            // A call of a cycle that is a program may do whatever the program does.
            Hides::Movement if self.callees.made.is_empty() => {
                for aspect in [
                    Aspect::Spindle,
                    Aspect::Stopped,
                    Aspect::Unstarted,
                    Aspect::Counterclockwise,
                    Aspect::Feed,
                    Aspect::Pole,
                    Aspect::Compensation,
                    Aspect::Tcpm,
                    Aspect::PerRevolution,
                ] {
                    state.modal.set(aspect, Tri::Unknown);
                }
                tool_unknown(&mut state.modal);
            }
            Hides::Tool => {
                for aspect in [
                    Aspect::Tool,
                    Aspect::ToolFeed,
                    Aspect::Aligned,
                    Aspect::OtherAxis,
                    Aspect::Speed,
                    Aspect::Feed,
                    Aspect::Spindle,
                    Aspect::Stopped,
                    Aspect::Unstarted,
                    Aspect::Counterclockwise,
                ] {
                    state.modal.set(aspect, Tri::Unknown);
                }
                tool_unknown(&mut state.modal);
                state.modal.loaded = Loaded::Unknown;
            }
            Hides::Machining => {
                state.modal.pending = Pending::Unknown;
                state.modal.set(Aspect::Feed, Tri::Unknown);
                state.modal.set(Aspect::Compensation, Tri::Unknown);
            }
            Hides::Assignment(parameters) => parameters.into_iter().for_each(|q| state.set(q, Known::Unknown)),
            // A definition of a cycle sets no centre.
            Hides::Anything if matches!(&block.kind, BlockKind::Iso(own) if matches!(own.kind, IsoKind::Cycle(_))) => {
                let pole = state.modal.is(Aspect::Pole);
                state.forget();
                state.modal.set(Aspect::Pole, pole);
            }
            Hides::Movement | Hides::Anything => state.forget(),
        }
    }

    fn program_called(&self, index: usize, state: &mut State) {
        match self.callees.blocks.get(&index) {
            Some(callee) => callee.effect.apply(state),
            None => state.forget(),
        }
    }

    fn motion(&self, motion: &Element, modal: &mut Modal) {
        let outline = motion.outline();
        match outline.compensates() {
            Compensates::Off => modal.set(Aspect::Compensation, Tri::No),
            Compensates::Beside | Compensates::Along => modal.set(Aspect::Compensation, Tri::Yes),
            Compensates::Unsaid => {}
        }
        match motion.path() {
            Path::Cc | Path::Fpol => modal.set(Aspect::Pole, Tri::Yes),
            Path::Dep(_) => modal.set(Aspect::Compensation, Tri::No),
            _ => {}
        }
        if outline.has_feed() {
            modal.set(Aspect::Feed, Tri::Yes);
        }
    }

    fn statement(&self, statement: &Statement, state: &mut State) {
        // Parameters that it names may be what it writes to.
        for word in &statement.words {
            if let ValueKind::Q { q, .. } = word.value.kind {
                state.set(q, Known::Unknown);
            }
        }
        let word = |at: usize| self.word(statement, at);
        match statement.kind {
            StatementKind::ContourDef | StatementKind::DeclareContour => {
                state.modal.set(Aspect::Contour, Tri::Yes);
            }
            StatementKind::Plane => {
                let flat = word(1) == "RESET" || self.is_untilted(statement);
                state.modal.set(Aspect::Tilting, if flat { Tri::No } else { Tri::Yes });
                state.modal.set(Aspect::Feed, Tri::Unknown);
            }
            StatementKind::Trans => self.transforms(statement, state),
            StatementKind::Function
                if word(0) == "FUNCTION" && matches!(word(1), "TCPM" | "RESET" | "DWELL" | "FEED") =>
            {
                state.modal.set(Aspect::Feed, Tri::Unknown);
                match (word(1), word(2)) {
                    ("TCPM", _) => state.modal.set(Aspect::Tcpm, Tri::Yes),
                    ("RESET", "TCPM") => state.modal.set(Aspect::Tcpm, Tri::No),
                    _ => {}
                }
            }
            // It is what holds already.
            StatementKind::Function
                if word(0) == "FUNCTION"
                    && (word(1), word(2)) == ("MODE", "MILL")
                    && state.modal.is(Aspect::Turning) == Tri::No => {}
            StatementKind::Function if word(0) == "FUNCTION" && matches!(word(1), "MODE" | "TURNDATA") => {
                for aspect in [
                    Aspect::Unstarted,
                    Aspect::Counterclockwise,
                    Aspect::Speed,
                    Aspect::Feed,
                    Aspect::Compensation,
                    Aspect::Tilting,
                    Aspect::Tcpm,
                    Aspect::OtherAxis,
                ] {
                    state.modal.set(aspect, Tri::Unknown);
                }
                match (word(1), word(2)) {
                    ("MODE", "TURN") => {
                        state.modal.set(Aspect::Turning, Tri::Yes);
                        // It is another spindle that turns from here on, and nothing has turned it on.
                        if state.modal.is(Aspect::Spindle) == Tri::Yes {
                            state.modal.set(Aspect::Spindle, Tri::No);
                        }
                    }
                    ("MODE", "MILL") => {
                        state.modal.set(Aspect::Turning, Tri::No);
                        state.modal.set(Aspect::Spindle, Tri::Unknown);
                    }
                    ("MODE", _) => {
                        state.modal.set(Aspect::Turning, Tri::Unknown);
                        state.modal.set(Aspect::Spindle, Tri::Unknown);
                    }
                    _ => {}
                }
            }
            StatementKind::Function => {
                let (modal, parameters) = (State::unknown().modal, state.clone());
                *state = parameters;
                state.modal = modal;
            }
            // A query that fetches writes to parameters that others have bound.
            StatementKind::Sql if !self.is_query(statement) => state.forget_parameters(),
            // Which parameter is read or written, and what the block does besides, is not known.
            StatementKind::Indirect | StatementKind::Refused => {
                let modal = State::unknown().modal;
                state.forget_parameters();
                state.modal = modal;
            }
            _ => {}
        }
    }

    /// What a block `TRANS` does: one of the transformations, and no other.
    fn transforms(&self, statement: &Statement, state: &mut State) {
        let head = self.program.slice(statement.head).split_ascii_whitespace();
        let names = statement.words.iter().map(|word| self.program.slice(word.name).trim());
        let all: Vec<String> = head.chain(names).map(str::to_ascii_uppercase).collect();
        let resets = all.iter().any(|word| word == "RESET");
        let aspect = match all.get(1).map(String::as_str) {
            Some("DATUM") => Aspect::DatumShift,
            Some("MIRROR") => Aspect::Mirroring,
            Some("ROTATION") => Aspect::Rotation,
            Some("SCALE") => Aspect::Scaling,
            _ => {
                for aspect in [Aspect::DatumShift, Aspect::Mirroring, Aspect::Rotation, Aspect::Scaling] {
                    state.modal.set(aspect, Tri::Unknown);
                }
                return;
            }
        };
        let shift = || {
            let words = statement.words.iter().filter(|word| !matches!(word.value.kind, ValueKind::Missing));
            shifted(self.program, words, state)
        };
        match (resets, aspect) {
            (true, _) => state.modal.set(aspect, Tri::No),
            (false, Aspect::DatumShift) => match shift() {
                Some(axes) => state.modal.shift(axes),
                None => state.modal.set(aspect, Tri::Unknown),
            },
            (false, _) => state.modal.set(aspect, Tri::Unknown),
        }
    }

    /// Whether a block of SQL writes to no parameters but those that it names.
    fn is_query(&self, statement: &Statement) -> bool {
        let Some(first) = statement.words.first() else { return false };
        let name = self.program.slice(first.name).trim();
        let gives = matches!(first.value.kind, ValueKind::Q { .. });
        gives || ["BIND", "UPDATE", "INSERT", "COMMIT", "ROLLBACK"].iter().any(|own| own.eq_ignore_ascii_case(name))
    }

    /// Whether a PLANE has angles, and all of them are 0.
    fn is_untilted(&self, plane: &Statement) -> bool {
        let angle = |word: &&NamedWord| {
            let name = self.program.slice(word.name).trim();
            ["SPA", "SPB", "SPC", "A", "B", "C"].iter().any(|angle| angle.eq_ignore_ascii_case(name))
        };
        let mut angles = plane.words.iter().filter(angle).peekable();
        angles.peek().is_some() && angles.all(|word| word.value.kind == ValueKind::Number(0.0))
    }

    /// A word of what names a statement, in capitals if it is one that matters.
    fn word(&self, statement: &Statement, at: usize) -> &'static str {
        const WORDS: [&str; 9] = ["FUNCTION", "TCPM", "RESET", "DWELL", "FEED", "MODE", "TURN", "MILL", "TURNDATA"];
        let head = self.program.slice(statement.head).split_ascii_whitespace();
        // A name may follow a word: `TURN "AC"`.
        let written = |word: &NamedWord| self.program.slice(word.span).split_ascii_whitespace();
        let words = head.chain(statement.words.iter().flat_map(written));
        let found = words.into_iter().nth(at).unwrap_or_default();
        WORDS.into_iter().find(|word| word.eq_ignore_ascii_case(found)).unwrap_or_default()
    }

    /// Whether a jump is taken, if it compares numbers and may not be skipped.
    pub(super) fn decided(&self, block: usize) -> Option<bool> {
        let own = self.program.blocks().get(block).filter(|own| !own.skip)?;
        match &own.kind {
            BlockKind::FnJump(jump) => jump.decided(),
            _ => None,
        }
    }

    /// The states where a jump leads and after it, if they are others than that before it. A switch at the beginning
    /// of a program may be set otherwise: on the way that its number rules out,
    /// the parameters that are compared are unknown.
    pub(super) fn branches(&self, block: usize, state: &State) -> (Option<State>, Option<State>) {
        let Some(BlockKind::FnJump(jump)) = self.program.blocks().get(block).map(|block| &block.kind) else {
            return (None, None);
        };
        let (Known::Number(a), Known::Number(b)) = (value(&jump.a, state), value(&jump.b, state)) else {
            return (None, None);
        };
        let Some(holds) = jump.relation.holds(a, b) else { return (None, None) };
        let mut other = state.clone();
        for operand in [&jump.a, &jump.b] {
            if let Amount::Q { q, .. } = operand.amount {
                other.set(q, Known::Unknown);
            }
        }
        if holds { (None, Some(other)) } else { (Some(other), None) }
    }

    /// The place of a calculation that fails on every way, and why.
    pub(super) fn failing(block: &Block, states: &[State]) -> Option<(Span, &'static str)> {
        let (span, why) = match &block.kind {
            BlockKind::Formula(formula) => {
                let (first, others) = states.split_first()?;
                let why = Self::failure(&formula.expr, first)?;
                (
                    formula.text,
                    others.iter().all(|state| Self::failure(&formula.expr, state) == Some(why)).then_some(why),
                )
            }
            BlockKind::FnAssign(assign) if assign.op == FnOp::Sqrt => {
                let negative = |state: &State| matches!(value(&assign.a, state), Known::Number(a) if a < 0.0);
                (assign.a.span, (!states.is_empty() && states.iter().all(negative)).then_some("domain"))
            }
            _ => return None,
        };
        Some((span, why?))
    }

    /// Why a formula certainly has no result.
    pub(super) fn failure(expr: &Expr, state: &State) -> Option<&'static str> {
        let code = compile(expr, &OnlyParameters).ok()?;
        match code.number(&Values(state, &[])) {
            Err(EvalError::DivisionByZero) => Some("division"),
            Err(EvalError::Domain(..)) => Some("domain"),
            Err(EvalError::Overflow) => Some("large"),
            _ => None,
        }
    }

    fn formula(&self, expr: &Expr, state: &State) -> Known {
        let Ok(code) = compile(expr, &OnlyParameters) else { return Known::Unknown };
        number(&code, state)
    }
}

fn number(code: &Code, state: &State) -> Known {
    match code.number(&Values(state, &[])) {
        Ok(number) if number.is_finite() => Known::Number(number),
        _ => Known::Unknown,
    }
}

fn feed(feed: Option<&Feed>, modal: &mut Modal) {
    match feed.map(|feed| feed.kind) {
        None | Some(FeedKind::Max) => {}
        Some(_) => modal.set(Aspect::Feed, Tri::Yes),
    }
}

/// The M functions that act at the start of their block.
fn start(block: &Block, modal: &mut Modal) {
    each_function(block, |number| {
        if matches!(number, 3 | 4 | 13 | 14) {
            modal.set(Aspect::Spindle, Tri::Yes);
            modal.set(Aspect::Stopped, Tri::No);
            modal.set(Aspect::Unstarted, Tri::No);
            modal.set(Aspect::Counterclockwise, Tri::of(Some(matches!(number, 4 | 14))));
        }
    });
}

/// Another tool may be in the spindle.
const fn tool_unknown(modal: &mut Modal) {
    modal.set(Aspect::Probed, Tri::Unknown);
    modal.set(Aspect::Cut, Tri::Unknown);
}

/// The value of an operand.
pub(super) fn value(operand: &Operand, state: &State) -> Known {
    match operand.amount {
        Amount::Number(number) => Known::Number(number),
        Amount::Q { negative, q } => match state.get(q) {
            Known::Number(number) => Known::Number(if negative { -number } else { number }),
            _ => Known::Unknown,
        },
        Amount::Text(_) => Known::Unknown,
    }
}

fn assigned(assign: &FnAssign, state: &State) -> Known {
    if assign.target.kind == QKind::Qs {
        return Known::Unknown;
    }
    let of = |operand: &Operand| match value(operand, state) {
        Known::Number(number) => Some(number),
        _ => None,
    };
    let (Some(a), b) = (of(&assign.a), assign.b.as_ref().map(of)) else { return Known::Unknown };
    let result = match (assign.op, b) {
        (FnOp::Set, _) => a,
        (FnOp::Add, Some(Some(b))) => a + b,
        (FnOp::Sub, Some(Some(b))) => a - b,
        (FnOp::Mul, Some(Some(b))) => a * b,
        (FnOp::Div, Some(Some(b))) => a / b,
        (FnOp::Sqrt, _) => libm::sqrt(a),
        _ => return Known::Unknown,
    };
    if result.is_finite() { Known::Number(result) } else { Known::Unknown }
}
