//! DIN/ISO in Klartext.
//!
//! Invariant: each block is read with the codes that act where it is in the text: the plane, the motion. `G90` and `G91`
//! are those of the run (`modes`); a block that is reached with both, or never, is read in the order of the text.
use super::codes::Codes;
use super::home::Lowered;
use super::modes::{self, InRun};
use super::words::{AXES, CENTRE, PLAIN, POLAR, Words};
use super::writer::Writer;
use crate::base::diag::{Diagnostic, Place, Source, Span};
use crate::base::expr::QRef;
use crate::program::syntax::{
    self, Axis, Block, BlockKind, IsoBlock, IsoKind, MFunction, NamedWord, Program, SyntaxError, ValueKind,
};
use crate::spec::{CycleKey, Field};

/// Names and labels of Klartext that DIN/ISO does without.
pub trait Labels {
    /// The name of a cycle.
    fn name(&self, key: CycleKey) -> Option<String>;
    /// The label of a parameter.
    fn parameter(&self, key: CycleKey, q: QRef) -> Option<String>;
    /// The printed word of a field.
    fn field(&self, key: CycleKey, field: &Field) -> Option<String>;
}

/// Why a block is not written.
pub(super) enum Refusal {
    /// Klartext has no equivalent of what is there.
    NoEquivalent(Span),
    /// No manual names the cycle of the code.
    UnknownCode(Span),
    /// A word that nothing in the block takes.
    Leftover(Span),
    /// `G05` without a direction before it.
    NoDirection(Span),
}

/// What a block's writing gives.
pub(super) type Written<T = ()> = Result<T, Refusal>;

/// A DIN/ISO program in Klartext. Blocks that Klartext has no equivalent of are comments there, and blocks of DIN/ISO
/// to its executor.
pub fn to_klartext(program: &Program, codes: &Codes<'_>, labels: Option<&dyn Labels>) -> Lowered {
    let text = program.source().text();
    let eol = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let mut lowering = Lowering {
        program,
        codes,
        labels,
        out: Writer::new(text),
        eol,
        number: 0,
        absolute: true,
        modes: modes::in_run(program),
        mode_reported: false,
        axis: None,
        feed: None,
        direction: None,
        inch: program.blocks().iter().find_map(|block| match &block.kind {
            BlockKind::BeginPgm(frame) => Some(frame.inch),
            _ => None,
        }),
        homes: Vec::new(),
        diagnostics: program.diagnostics(),
    };
    for (index, block) in program.blocks().iter().enumerate() {
        lowering.block(index, block);
    }
    let Lowering { out, homes, mut diagnostics, .. } = lowering;
    let source = Source::new(program.source().name(), out.text);
    let klartext = syntax::parse(&source).with_blocks(&mut |own| {
        let at = homes.partition_point(|(start, ..)| *start <= own.span.start);
        let Some((_, index, refused)) = at.checked_sub(1).and_then(|at| homes.get(at)) else { return };
        let Some(home) = program.blocks().get(*index) else { return };
        (own.line, own.number) = (home.line, home.number.or(own.number));
        if *refused {
            own.kind = match (&home.kind, own.comment()) {
                (BlockKind::Unknown(error), Some(comment)) => BlockKind::Unknown(Box::new(SyntaxError {
                    span: Span::new(comment.start + 1, comment.end),
                    ..**error
                })),
                (kind, _) => kind.clone(),
            };
        }
    });
    let numbers: Vec<u32> = program.blocks().iter().filter_map(|block| block.number).collect();
    let rising = numbers.is_sorted_by(|before, number| before < number);
    diagnostics.sort_by_key(|finding| finding.place.as_ref().map(|place| place.span.start));
    Lowered { program: klartext, diagnostics, source: program.source().clone(), pieces: out.pieces, rising }
}

/// The place of a name with the quotation marks that it has.
pub(super) fn with_quotation_marks(program: &Program, name: Span) -> Span {
    let text = program.source().text().as_bytes();
    let quoted = name.start > 0 && text.get(name.start - 1) == Some(&b'"');
    if quoted { Span::new(name.start - 1, name.end + 1) } else { name }
}

pub(super) struct Lowering<'p, 'c> {
    pub(super) program: &'p Program,
    pub(super) codes: &'p Codes<'c>,
    pub(super) labels: Option<&'p dyn Labels>,
    pub(super) out: Writer<'p>,
    eol: &'static str,
    /// The number of the next block of Klartext.
    number: u32,
    /// Whether `G90` acts.
    pub(super) absolute: bool,
    /// `G90` and `G91` in the order of the run, where that is not the order of the text.
    modes: Option<InRun>,
    /// Whether it has been reported that the run has another one than the text here.
    mode_reported: bool,
    /// The tool axis of the plane that acts.
    pub(super) axis: Option<Axis>,
    /// A feed that was written in a block at rapid traverse: it acts from the next one on.
    pub(super) feed: Option<Span>,
    /// The direction of the last circle: true for counter-clockwise.
    direction: Option<bool>,
    /// Whether the program is in inches, if it says so.
    inch: Option<bool>,
    /// Where the text of each block begins, the block, and whether it was refused.
    homes: Vec<(usize, usize, bool)>,
    diagnostics: Vec<Diagnostic>,
}

impl Lowering<'_, '_> {
    fn block(&mut self, index: usize, block: &Block) {
        self.out.home = block.span;
        let start = self.out.text.len();
        let number = self.number;
        self.homes.push((start, index, false));
        self.follow_mode(index, block);
        match self.write(block) {
            Ok(()) => self.comment(block, start),
            Err(refusal) => {
                self.out.truncate(start);
                self.number = number;
                self.refuse(block, &refusal);
            }
        }
    }

    /// Takes over what acts in the run, and reports the first block whose coordinates mean something else than they say.
    fn follow_mode(&mut self, index: usize, block: &Block) {
        let Some(modes) = &self.modes else { return };
        self.absolute = modes.absolute(index).unwrap_or(self.absolute);
        let differs = modes.differs(index);
        let place = match &block.kind {
            BlockKind::Iso(own) => Words::new(self.program, own).meant_by_mode(),
            _ => None,
        };
        self.mode_reported &= differs;
        let (true, false, Some(span)) = (differs, self.mode_reported, place) else { return };
        self.mode_reported = true;
        let found = if modes.written(index) { "G90" } else { "G91" };
        let place = Place::new(self.program.source(), span);
        self.diagnostics.push(Diagnostic::warning("iso-mode-left-on", place).arg("found", found));
    }

    /// A refused block is a comment.
    fn refuse(&mut self, block: &Block, refusal: &Refusal) {
        if let Some(home) = self.homes.last_mut() {
            home.2 = true;
        }
        let (code, span) = match refusal {
            Refusal::NoEquivalent(span) => ("klartext-no-equivalent", *span),
            Refusal::Leftover(span) => ("iso-word-not-allowed", *span),
            Refusal::UnknownCode(span) => ("iso-unknown-code", *span),
            Refusal::NoDirection(span) => ("iso-no-direction", *span),
        };
        // What cannot be read has been reported already.
        if !matches!(block.kind, BlockKind::Unknown(_)) {
            let found = self.program.slice(span).trim().to_owned();
            let place = Place::new(self.program.source(), span);
            self.diagnostics.push(Diagnostic::warning(code, place).arg("found", found));
        }
        self.begin(block);
        self.out.put("; ");
        let content = self.program.content(block);
        for (turn, line) in
            self.program.slice(content).split(['\r', '\n']).filter(|line| !line.trim().is_empty()).enumerate()
        {
            let at = line.as_ptr() as usize - self.program.source().text().as_ptr() as usize;
            self.out.put(if turn > 0 { " " } else { "" });
            self.out.copy(Span::new(at, at + line.trim_end().trim_end_matches('~').len()));
        }
        self.end();
    }

    /// Begins a block of Klartext.
    pub(super) fn begin(&mut self, block: &Block) {
        if block.skip {
            self.out.put("/");
        }
        let number = self.number;
        self.out.put(&format!("{number} "));
        self.number = self.number.saturating_add(1);
    }

    pub(super) fn end(&mut self) {
        self.out.put(self.eol);
    }

    /// Puts the comment of a block after its last line, or makes it a block of its own.
    fn comment(&mut self, block: &Block, start: usize) {
        let remarks = match &block.kind {
            BlockKind::Iso(own) => own.remarks.as_slice(),
            _ => &[],
        };
        let has_labels = matches!(&block.kind, BlockKind::Iso(own) if !own.parameters.is_empty())
            || matches!(&block.kind, BlockKind::CycleDef(_) | BlockKind::GlobalDef(_));
        let comment = block
            .comment()
            .filter(|_| !has_labels && !matches!(block.kind, BlockKind::Comment | BlockKind::Structure(_)));
        if comment.is_none() && remarks.is_empty() {
            return;
        }
        if self.out.text.len() > start && self.out.text.ends_with(self.eol) && !has_labels {
            let end = self.out.text.len() - self.eol.len();
            self.out.truncate(end);
            self.out.put(" ");
        } else {
            self.begin(block);
        }
        if let Some(comment) = comment {
            self.out.copy(comment);
        } else {
            self.out.put(";");
        }
        for remark in remarks {
            self.out.put(" ");
            self.out.copy(*remark);
        }
        self.end();
    }

    fn write(&mut self, block: &Block) -> Written {
        match &block.kind {
            BlockKind::Empty => self.out.put(self.eol),
            BlockKind::Comment => self.comment_block(block),
            BlockKind::BeginPgm(frame) | BlockKind::EndPgm(frame) => {
                self.begin(block);
                let begins = matches!(block.kind, BlockKind::BeginPgm(_));
                self.out.put(if begins { "BEGIN PGM " } else { "END PGM " });
                self.out.copy(frame.name);
                self.out.put(if frame.inch { " INCH" } else { " MM" });
                self.end();
            }
            BlockKind::Functions(functions) => self.functions_alone(block, functions),
            BlockKind::CallPgm(name) => {
                self.begin(block);
                self.out.put("CALL PGM ");
                self.out.copy(with_quotation_marks(self.program, *name));
                self.end();
            }
            BlockKind::Unknown(error) => return Err(Refusal::NoEquivalent(error.span)),
            BlockKind::Iso(own) => return self.iso(block, own),
            // Both languages write these alike.
            BlockKind::GlobalDef(definition) => {
                self.begin(block);
                self.out.copy(definition.head);
                if let Some(name) = definition.name {
                    self.out.put(" ");
                    self.out.copy(name);
                }
                self.parameters(&definition.parameters, None);
                self.end();
            }
            _ => {
                self.begin(block);
                self.out.copy(self.program.content(block));
                self.end();
            }
        }
        Ok(())
    }

    fn comment_block(&mut self, block: &Block) {
        self.begin(block);
        if let Some(comment) = block.comment() {
            self.out.copy(comment);
        } else {
            self.out.put("; ");
            self.out.copy(self.program.content(block));
        }
        self.end();
    }

    pub(super) fn functions_alone(&mut self, block: &Block, functions: &[MFunction]) {
        if functions.is_empty() {
            return;
        }
        self.begin(block);
        for (turn, function) in functions.iter().enumerate() {
            self.out.put(if turn > 0 { " " } else { "" });
            self.out.copy(function.span);
        }
        self.end();
    }

    pub(super) fn functions(&mut self, functions: &[MFunction]) {
        for function in functions {
            self.out.put(" ");
            self.out.copy(function.span);
        }
    }

    fn iso(&mut self, block: &Block, own: &IsoBlock) -> Written {
        let mut words = Words::new(self.program, own);
        match own.kind {
            IsoKind::Path(code) => self.path(block, own, &mut words, code),
            IsoKind::Centre => self.centre(block, own, &mut words),
            IsoKind::Chamfer | IsoKind::Rounding => self.corner(block, own, &mut words),
            IsoKind::Blend(_) => Err(Refusal::NoEquivalent(words.span())),
            IsoKind::Blank(part) => self.blank(block, own, &mut words, part),
            IsoKind::ToolCall => self.tool_call(block, own, &mut words),
            IsoKind::ToolDef => self.tool_def(block, own, &mut words),
            IsoKind::Label | IsoKind::CallLabel => self.label(block, own, &mut words),
            IsoKind::Select { what, name } => self.select(block, what, name),
            IsoKind::CallSelected => {
                self.begin(block);
                self.out.put("CALL SELECTED PGM");
                self.end();
                Ok(())
            }
            IsoKind::Function(number) => self.function(block, own, &mut words, number),
            IsoKind::Call => self.call(block, own, &mut words),
            IsoKind::Cycle(code) => self.cycle(block, own, &mut words, code),
            IsoKind::Stop => {
                self.begin(block);
                self.out.put("STOP");
                self.functions(&own.functions);
                self.end();
                words.take("G");
                words.finish()
            }
            IsoKind::Modal => {
                self.modal(&mut words);
                self.functions_alone(block, &own.functions);
                words.finish()
            }
        }
    }

    /// Takes the codes that act from here on and say nothing else.
    /// Axes and coordinates take `G90` and `G91` themselves.
    pub(super) fn modal(&mut self, words: &mut Words<'_>) {
        for word in words.codes() {
            match word.1 {
                17 => self.axis = Some(Axis::Z),
                18 => self.axis = Some(Axis::Y),
                19 => self.axis = Some(Axis::X),
                90 => self.absolute = true,
                91 => self.absolute = false,
                70 | 71 if self.is_unit(word.1) => {}
                _ => continue,
            }
            words.used[word.0] = true;
        }
    }

    /// Whether a code says again what the first block says.
    fn is_unit(&self, code: u16) -> bool {
        self.inch == Some(code == 70)
    }

    /// Writes the words of a list of names as coordinates, `G90` and `G91` between them being followed.
    pub(super) fn coordinates(&mut self, words: &mut Words<'_>, names: &[(&str, &str)], most: usize) -> usize {
        self.values(words, names, most, true)
    }

    /// The same, with `I` before them only where there are incremental ones at all.
    pub(super) fn values(
        &mut self,
        words: &mut Words<'_>,
        names: &[(&str, &str)],
        most: usize,
        incremental: bool,
    ) -> usize {
        let mut count = 0;
        let mut absolute = self.absolute;
        for at in 0..words.own.words.len() {
            let word = words.own.words[at];
            match words.code(&word) {
                Some(90) => absolute = true,
                Some(91) => absolute = false,
                _ => {}
            }
            let written = words.program.slice(word.name);
            let valued = matches!(word.value.kind, ValueKind::Number(_) | ValueKind::Q { .. });
            let Some((_, axis)) = names.iter().find(|(own, _)| written.eq_ignore_ascii_case(own)) else { continue };
            if words.used[at] || !valued || count >= most {
                continue;
            }
            words.used[at] = true;
            count += 1;
            self.out.put(if absolute || !incremental { " " } else { " I" });
            if written.eq_ignore_ascii_case(axis) {
                self.out.copy(word.span);
            } else {
                self.out.put(axis);
                self.out.copy(word.value.span);
            }
        }
        count
    }

    /// Whether `G90` acts at the end of a block.
    pub(super) fn absolute_in(&self, words: &Words<'_>) -> bool {
        let mut codes = words.own.words.iter().filter_map(|word| words.code(word));
        codes.rfind(|code| matches!(code, 90 | 91)).map_or(self.absolute, |code| code == 90)
    }

    /// Takes back a block of Klartext that begins at a byte.
    pub(super) fn unwrite(&mut self, start: usize) {
        self.out.truncate(start);
        self.number = self.number.saturating_sub(1);
    }

    fn path(&mut self, block: &Block, own: &IsoBlock, words: &mut Words<'_>, code: Option<u16>) -> Written {
        let rapid = matches!(code, Some(0 | 10));
        let circle = matches!(code, Some(2 | 3 | 5 | 12 | 13 | 15));
        match code {
            Some(2 | 12) => self.direction = Some(false),
            Some(3 | 13) => self.direction = Some(true),
            _ => {}
        }
        let polar = matches!(code, Some(10..=13 | 15 | 16));
        // Along one axis, whose letter begins the block.
        let along = code == Some(7);
        let speed = words.find("S");
        if let Some(speed) = speed {
            self.begin(block);
            self.out.put("TOOL CALL ");
            self.out.copy(speed.span);
            self.end();
            words.take("S");
        }
        if words.has(&["I", "J", "K"]) {
            self.begin(block);
            self.out.put("CC");
            self.coordinates(words, &CENTRE, usize::MAX);
            self.end();
        }
        let codes = words.codes();
        let moves = words.has(&AXES) || words.has(&["R", "H"]);
        let compensation = codes.iter().rev().find(|(_, code)| matches!(code, 40..=44)).map(|(_, code)| *code);
        let feed = words.find("F");
        let start = self.out.text.len();
        let number = self.number;
        self.begin(block);
        let direction = match circle {
            true => Some(self.direction.ok_or(Refusal::NoDirection(words.span()))?),
            false => None,
        };
        let radius = words.find("R").filter(|_| !polar);
        self.out.put(match code {
            Some(2 | 3 | 5) if radius.is_some() => "CR",
            Some(2 | 3 | 5) => "C",
            Some(6) => "CT",
            Some(10 | 11) => "LP",
            Some(12 | 13 | 15) => "CP",
            Some(16) => "CTP",
            Some(7) => "",
            _ => "L",
        });
        let names = if polar { &POLAR[..] } else { &PLAIN[..] };
        if along {
            let end = self.out.text.len();
            self.out.truncate(end - 1);
        }
        let count = self.coordinates(words, names, usize::MAX);
        if along && moves && count != 1 {
            return Err(Refusal::NoEquivalent(words.span()));
        }
        if let Some(radius) = radius {
            if !circle {
                return Err(Refusal::NoEquivalent(radius.span));
            }
            // `R0` alone would be no radius but no compensation.
            self.out.put(if self.program.slice(radius.value.span) == "0" { " R+" } else { " R" });
            self.out.copy(radius.value.span);
            words.take("R");
        }
        if let Some(counter_clockwise) = direction {
            self.out.put(if counter_clockwise { " DR+" } else { " DR-" });
        }
        match compensation {
            Some(40) => self.out.put(" R0"),
            Some(41) => self.out.put(" RL"),
            Some(42) => self.out.put(" RR"),
            Some(43) if along => self.out.put(" R+"),
            Some(44) if along => self.out.put(" R-"),
            Some(43 | 44) => return Err(Refusal::NoEquivalent(words.span())),
            _ => {}
        }
        let said = self.path_feed(words, feed, rapid, moves);
        self.functions(&own.functions);
        self.end();
        words.take_codes(|code| syntax::is_path(code) || matches!(code, 40..=44));
        self.modal(words);
        self.call_at_end(block, words);
        // A function with words of its own, such as a retraction, goes at rapid traverse.
        let goes = rapid && own.functions.iter().any(|function| function.with.is_some());
        if !(moves || compensation.is_some() || said || goes) {
            // A code alone acts from here on, and moves nothing.
            self.out.truncate(start);
            self.number = number;
            self.functions_alone(block, &own.functions);
        }
        words.finish()
    }

    /// A movement that ends with `G79` calls the cycle where it ends.
    fn call_at_end(&mut self, block: &Block, words: &mut Words<'_>) {
        if words.codes().iter().any(|(_, code)| *code == 79) {
            words.take_codes(|code| code == 79);
            self.begin(block);
            self.out.put("CYCL CALL");
            self.end();
        }
    }

    /// Writes the feed of a motion; whether there is something to say even without coordinates.
    fn path_feed(&mut self, words: &mut Words<'_>, feed: Option<NamedWord>, rapid: bool, moves: bool) -> bool {
        words.take("F");
        let word = feed.filter(|feed| feed.value.kind == ValueKind::Word);
        if rapid {
            self.out.put(" FMAX");
            if word.is_none() {
                self.feed = feed.map(|feed| feed.span).or(self.feed);
            }
            return false;
        }
        match (feed, self.feed) {
            (Some(feed), _) => {
                self.out.put(" ");
                self.out.copy(feed.span);
                // `FMAX` acts in its block only.
                self.feed = self.feed.filter(|_| word.is_some());
                true
            }
            (None, Some(kept)) if moves => {
                self.out.put(" ");
                self.out.copy(kept);
                self.feed = None;
                true
            }
            _ => false,
        }
    }
}
