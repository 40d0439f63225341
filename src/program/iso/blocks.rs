//! Blocks of DIN/ISO that are no motions, in Klartext.
use super::lower::{Lowering, Refusal, Written, with_quotation_marks};
use super::old;
use super::words::{AXES, CENTRE, PLAIN, Words};
use crate::base::diag::Span;
use crate::program::syntax::{self, Axis, Block, IsoBlock, IsoKind, Parameter, Value, ValueKind};
use crate::spec::CycleKey;

impl Lowering<'_, '_> {
    pub(super) fn centre(&mut self, block: &Block, own: &IsoBlock, words: &mut Words<'_>) -> Written {
        self.begin(block);
        self.out.put("CC");
        self.coordinates(words, &CENTRE, usize::MAX);
        self.end();
        words.take_codes(|code| code == 29);
        self.modal(words);
        self.functions_alone(block, &own.functions);
        words.finish()
    }

    pub(super) fn corner(&mut self, block: &Block, own: &IsoBlock, words: &mut Words<'_>) -> Written {
        let radius = words.take("R").ok_or(Refusal::NoEquivalent(words.span()))?;
        self.begin(block);
        let rounding = own.kind == IsoKind::Rounding;
        self.out.put(if rounding { "RND R" } else { "CHF " });
        self.out.copy(radius.value.span);
        if let Some(feed) = words.take("F") {
            self.out.put(" ");
            self.out.copy(feed.span);
        }
        self.functions(&own.functions);
        self.end();
        words.take_codes(|code| matches!(code, 24 | 25));
        words.finish()
    }

    pub(super) fn blank(&mut self, block: &Block, own: &IsoBlock, words: &mut Words<'_>, part: u8) -> Written {
        let before = self.absolute;
        self.begin(block);
        self.out.put(&format!("BLK FORM 0.{part}"));
        if part == 1 {
            self.modal_plane(words);
            let axis = self.axis.ok_or(Refusal::NoEquivalent(words.span()))?;
            self.out.put(" ");
            self.out.put(axis.name());
        }
        self.coordinates(words, &PLAIN, usize::MAX);
        self.end();
        words.take_codes(|code| matches!(code, 30 | 31));
        self.modal(words);
        self.absolute = if part == 1 { before } else { self.absolute };
        self.functions_alone(block, &own.functions);
        words.finish()
    }

    /// Follows `G17` to `G19` without taking them as all of the block.
    pub(super) fn modal_plane(&mut self, words: &mut Words<'_>) {
        for (at, code) in words.codes() {
            let axis = match code {
                17 => Axis::Z,
                18 => Axis::Y,
                19 => Axis::X,
                _ => continue,
            };
            self.axis = Some(axis);
            words.used[at] = true;
        }
    }

    pub(super) fn tool_call(&mut self, block: &Block, own: &IsoBlock, words: &mut Words<'_>) -> Written {
        self.begin(block);
        self.out.put("TOOL CALL");
        self.modal_plane(words);
        if let Some(tool) = words.take("T") {
            self.out.put(" ");
            self.out.copy(tool.value.span);
            if let Some(axis) = self.axis {
                self.out.put(" ");
                self.out.put(axis.name());
            }
        }
        for name in ["S", "F", "DL", "DR", "DR2"] {
            if let Some(word) = words.take(name) {
                self.out.put(" ");
                self.out.copy(word.span);
                self.feed = self.feed.filter(|_| name != "F");
            }
        }
        self.end();
        self.modal(words);
        self.functions_alone(block, &own.functions);
        words.finish()
    }

    pub(super) fn tool_def(&mut self, block: &Block, own: &IsoBlock, words: &mut Words<'_>) -> Written {
        let tool = words.take("T").ok_or(Refusal::NoEquivalent(words.span()))?;
        self.begin(block);
        self.out.put("TOOL DEF ");
        self.out.copy(tool.value.span);
        for name in ["L", "R"] {
            if let Some(word) = words.take(name) {
                self.out.put(" ");
                self.out.copy(word.span);
            }
        }
        self.end();
        words.take_codes(|code| matches!(code, 99 | 51));
        self.functions_alone(block, &own.functions);
        words.finish()
    }

    pub(super) fn label(&mut self, block: &Block, own: &IsoBlock, words: &mut Words<'_>) -> Written {
        let label = words.take("L").ok_or(Refusal::NoEquivalent(words.span()))?;
        self.begin(block);
        self.out.put(if own.kind == IsoKind::Label { "LBL " } else { "CALL LBL " });
        self.out.copy(label.value.span);
        if let Some(times) = words.take(",")
            && times.value.kind != ValueKind::Number(0.0)
        {
            self.out.put(" REP ");
            self.out.copy(times.value.span);
        }
        self.end();
        words.take_codes(|code| code == 98);
        self.functions_alone(block, &own.functions);
        words.finish()
    }

    pub(super) fn select(&mut self, block: &Block, what: Span, name: Span) -> Written {
        let word = self.program.slice(what).to_ascii_uppercase();
        let what = match &*word {
            "TAB" => "TABLE",
            "PAT" => "PATTERN",
            "CNT" => "CONTOUR",
            "PGM" => "PGM",
            _ => return Err(Refusal::NoEquivalent(what)),
        };
        self.begin(block);
        self.out.put(&format!("SEL {what} "));
        self.out.copy(with_quotation_marks(self.program, name));
        self.end();
        Ok(())
    }

    pub(super) fn function(&mut self, block: &Block, own: &IsoBlock, words: &mut Words<'_>, number: u16) -> Written {
        let missing = Refusal::NoEquivalent(words.span());
        words.take("D");
        let target = words.take("");
        let values: Vec<Value> =
            ["P01", "P02", "P03"].into_iter().filter_map(|name| Some(words.take(name)?.value)).collect();
        self.begin(block);
        self.out.put(&format!("FN {number}: "));
        match (number, target, values.as_slice()) {
            (0 | 5..=7, Some(target), [a]) => {
                self.out.copy(target.value.span);
                self.out.put(match number {
                    5 => " = SQRT ",
                    6 => " = SIN ",
                    7 => " = COS ",
                    _ => " = ",
                });
                self.out.copy(a.span);
            }
            (1..=4 | 8 | 13, Some(target), [a, b]) => {
                self.out.copy(target.value.span);
                self.out.put(" = ");
                self.out.copy(a.span);
                self.out.put(match number {
                    1 => " + ",
                    2 => " - ",
                    3 => " * ",
                    4 => " DIV ",
                    8 => " LEN ",
                    _ => " ANG ",
                });
                self.out.copy(b.span);
            }
            (9..=12, None, [a, b, label]) => {
                self.out.put("IF ");
                self.out.copy(a.span);
                self.out.put([" EQU ", " NE ", " GT ", " LT "][usize::from(number) - 9]);
                self.out.copy(b.span);
                self.out.put(" GOTO LBL ");
                self.out.copy(label.span);
            }
            (14, None, [value]) => {
                self.out.put("ERROR = ");
                self.out.copy(value.span);
            }
            (18, Some(target), []) => {
                self.out.put("SYSREAD ");
                self.out.copy(target.value.span);
                self.out.put(" =");
                for name in ["ID", "NR", "IDX"] {
                    if let Some(word) = words.take(name) {
                        self.out.put(" ");
                        self.out.copy(word.span);
                    }
                }
            }
            (19 | 29, None, [first, others @ ..]) => {
                self.out.put("PLC = ");
                self.out.copy(first.span);
                for other in others {
                    self.out.put(" / ");
                    self.out.copy(other.span);
                }
            }
            (15.., Some(printed), []) => {
                let text = self.program.slice(printed.value.span);
                let skipped = text.len() - text.strip_prefix("P01 ").unwrap_or(text).len();
                self.out.copy(Span::new(printed.value.span.start + skipped, printed.value.span.end));
            }
            _ => return Err(missing),
        }
        self.end();
        self.functions_alone(block, &own.functions);
        words.finish()
    }

    pub(super) fn call(&mut self, block: &Block, own: &IsoBlock, words: &mut Words<'_>) -> Written {
        let pattern = words.find("").map(|word| self.program.slice(word.span).trim_matches('"').to_ascii_uppercase());
        let rapid = words.codes().iter().any(|(_, code)| *code == 0);
        self.begin(block);
        self.out.put("CYCL CALL");
        match pattern.as_deref() {
            Some("PAT") => {
                words.take("");
                self.out.put(" PAT");
            }
            Some(_) => return Err(Refusal::NoEquivalent(words.span())),
            None if words.has(&AXES) => {
                self.out.put(" POS");
                self.coordinates(words, &PLAIN, usize::MAX);
                words.take_codes(|code| code <= 1);
            }
            None => {}
        }
        match words.take("F") {
            Some(feed) => {
                self.out.put(" ");
                self.out.copy(feed.span);
            }
            None if rapid => self.out.put(" FMAX"),
            None => {}
        }
        self.functions(&own.functions);
        self.end();
        words.take_codes(|code| code == 79);
        self.modal(words);
        words.finish()
    }

    pub(super) fn cycle(&mut self, block: &Block, own: &IsoBlock, words: &mut Words<'_>, code: u16) -> Written {
        let coded = self.codes.of(u32::from(code));
        if let Some(coded) = coded
            && let Some(form) = coded.form
        {
            old::lower(self, block, words, coded, form)?;
            self.functions_alone(block, &own.functions);
            return words.finish();
        }
        let key = coded.map(|coded| coded.cycle.key).or_else(|| self.codes.numbered(u32::from(code)));
        let is_it = |word: &&crate::program::syntax::NamedWord| words.code(word) == Some(code);
        let span = words.own.words.iter().find(is_it).map_or(words.span(), |word| word.span);
        let unknown =
            if syntax::is_older(code) { Refusal::NoEquivalent(words.span()) } else { Refusal::UnknownCode(span) };
        let key = key.ok_or(unknown)?;
        if !own.functions.is_empty() {
            return Err(Refusal::NoEquivalent(words.span()));
        }
        self.begin(block);
        // Findings about the definition are at its code.
        let home = std::mem::replace(&mut self.out.home, span);
        self.out.put(&key.to_string());
        self.out.home = home;
        let name = self.labels.and_then(|labels| labels.name(key));
        match (own.name, name) {
            (Some(name), _) => {
                self.out.put(" ");
                self.out.copy(name);
            }
            (None, Some(name)) => self.out.put(&format!(" {name}")),
            (None, None) => {}
        }
        self.parameters(&own.parameters, Some(key));
        for error in &own.errors {
            self.out.put(" ~");
            self.end();
            self.out.put("    ");
            self.out.copy(self.line(error.span));
        }
        self.end();
        words.take("G");
        words.finish()
    }

    pub(super) fn parameters(&mut self, parameters: &[Parameter], key: Option<CycleKey>) {
        for parameter in parameters {
            self.out.put(" ~");
            self.end();
            self.out.put("    ");
            self.out.copy(parameter.span);
            let own = key.and_then(|key| self.labels?.parameter(key, parameter.q));
            match (parameter.label, own) {
                (Some(label), _) => {
                    self.out.put(" ;");
                    self.out.copy(label);
                }
                (None, Some(label)) => self.out.put(&format!(" ;{label}")),
                (None, None) => {}
            }
        }
    }

    /// The line around a place, without a comment.
    pub(super) fn line(&self, span: Span) -> Span {
        let text = self.program.source().text();
        let start = text.get(..span.start).and_then(|before| before.rfind(['\n', '\r'])).map_or(0, |at| at + 1);
        let rest = text.get(start..).unwrap_or_default();
        let length = rest.find(['\n', '\r', ';', '~', '*']).unwrap_or(rest.len());
        let blanks = rest.len() - rest.trim_start_matches([' ', '\t']).len();
        Span::new(start + blanks.min(length), start + length)
    }
}
