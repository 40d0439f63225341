//! A word of a block with a value that it does not take, or that contradicts another word: SPA+400, MOVE and TURN, an
//! error number of FN 14 that does not exist, a tool number below 0, `FN 4 … / …` for DIV. Also an undersize of
//! millimetres for the length of a tool: it then goes so much deeper.
//!
//! What words take is in the file of the language. Parameters are passed over.
use std::collections::BTreeMap;

use memchr::memmem;

use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::base::expr::{QKind, QRef};
use crate::check::program::words::{self, Words};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, BlockKind, CallForm, FnOp, Operand, Path, ToolRef, misfitting};
use crate::spec::WordLimit;

pub(super) const RULE: Rule = Rule { code: "word-wrong", severity: Severity::Warning, run };

/// The greatest number of a tool; its decimal is the step of an indexed tool (TNC 640 manual line 13327).
const TOOL: f64 = 32767.9;
/// The greatest oversize of a tool in mm.
const OVERSIZE: f64 = 99.9999;
/// No tool is so much shorter than the table says, mm.
const SHORTER: f64 = 2.0;

/// Two vectors are so far from perpendicular, as a cosine, or so near to it: an example of the manuals is not exact.
const ASKEW: f64 = 0.1;
const SQUARE: f64 = 0.01;

/// Where the findings go.
struct Telling<'t, 'f, 'a> {
    rule: &'t Rule,
    facts: &'f Facts<'a>,
    found: &'t mut Vec<Diagnostic>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let functions = words::functions(facts);
    let mut reported = Telling { rule, facts, found };
    let mut texts: Option<BTreeMap<QRef, &str>> = None;
    for (_, block) in facts.marked() {
        match &block.kind {
            BlockKind::Sel(_) | BlockKind::CallPgm(_) | BlockKind::Lbl(_) | BlockKind::CallLbl(_)
                if is_nameless(facts.text(facts.content(block))) =>
            {
                reported.report("empty", facts.content(block), "", "");
                continue;
            }
            BlockKind::Statement(_) | BlockKind::TextFormula(_) | BlockKind::Sel(_) | BlockKind::CallPgm(_) => {}
            BlockKind::ToolCall(call) => {
                reported.tool(call.tool.as_ref());
                let oversizes = [("DL", &call.dl), ("DR", &call.dr), ("DR2", &call.dr2)];
                for (word, value) in oversizes.into_iter().filter_map(|(word, own)| Some((word, own.as_ref()?))) {
                    reported.number(word, value, -OVERSIZE, OVERSIZE);
                }
                reported.shorter(call.dl.as_ref());
                continue;
            }
            BlockKind::ToolDef(own) => {
                reported.tool(Some(&own.tool));
                if let Some(radius) = &own.radius {
                    reported.number("R", radius, 0.0, f64::MAX);
                }
                continue;
            }
            BlockKind::CyclCall(call) if matches!(call.form, CallForm::Pattern) => {
                if !words::has_function(block, &functions) {
                    continue;
                }
            }
            BlockKind::FnAssign(own) if own.op == FnOp::Div => {
                let content = facts.content(block);
                let text = facts.text(content);
                let code = text.split(';').next().unwrap_or_default();
                if code.contains('/') {
                    reported.report("operator", content, "/", "DIV");
                }
                continue;
            }
            BlockKind::Motion(motion) if motion.outline().has_odd_coords() => {
                if let Some(word) = misfitting(&motion.words()) {
                    reported.report("place", facts.content(block), word, "");
                }
                if !words::has_function(block, &functions) {
                    continue;
                }
            }
            _ if words::has_function(block, &functions) => {}
            _ => continue,
        }
        if let BlockKind::TextFormula(_) = &block.kind {
            let texts = texts.get_or_insert_with(|| words::texts(facts));
            words::of(facts, block).iter().for_each(|words| reported.texts(words, texts));
        }
        for words in words::of(facts, block) {
            reported.words(&words);
        }
    }
    for (_, block) in facts.shaped() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if motion.path() == Path::Ln && has_no_direction(facts.text(block.span)) {
            reported.report("zero", facts.content(block), "NX, NY, NZ", "0");
        }
        if !matches!(motion.path(), Path::Appr(_) | Path::Dep(_)) {
            continue;
        }
        let motion = motion.words();
        for word in &motion.words {
            let name = facts.text(word.name).trim();
            let crate::program::syntax::ValueKind::Number(number) = word.value.kind else { continue };
            let (least, greatest) = match name {
                "LEN" => (f64::MIN_POSITIVE, f64::MAX),
                "CCA" => (f64::MIN_POSITIVE, 360.0),
                _ => continue,
            };
            reported.limit(name, number, word.span, least, greatest);
        }
    }
}

/// Whether the surface normal of a line that says one is 0 in all axes;
/// most lines are distinguished by their first component.
fn has_no_direction(text: &str) -> bool {
    let zero = |component: &str| {
        let value = text.split_ascii_whitespace().find_map(|word| word.strip_prefix(component));
        value.and_then(|value| value.parse::<f64>().ok()) == Some(0.0)
    };
    let first = memmem::find(text.as_bytes(), b"NX").and_then(|at| text.as_bytes().get(at + 2..));
    let begins = first.is_some_and(|rest| matches!(rest, [b'+' | b'-', b'0', ..] | [b'0', ..]));
    begins && ["NX", "NY", "NZ"].into_iter().all(zero)
}

fn cross(one: [f64; 3], other: [f64; 3]) -> [f64; 3] {
    let ([a, b, c], [d, e, f]) = (one, other);
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

/// Whether two vectors are far from perpendicular, and would be so with the sign of one component changed.
fn lacks_sign(one: [f64; 3], other: [f64; 3]) -> bool {
    let length = |[a, b, c]: [f64; 3]| (a * a + b * b + c * c).sqrt();
    let parts: Vec<f64> = one.iter().zip(other).map(|(a, b)| a * b).collect();
    let (sum, size) = (parts.iter().sum::<f64>(), length(one) * length(other));
    sum.abs() > ASKEW * size && parts.iter().any(|own| (sum - 2.0 * own).abs() <= SQUARE * size)
}

fn is_zero(vector: [f64; 3]) -> bool {
    vector.iter().all(|own| own.abs() < 1e-6)
}

/// Whether a name in quotation marks is empty.
fn is_nameless(text: &str) -> bool {
    let mut parts = text.split(';').next().unwrap_or_default().split('"').skip(1);
    parts.next().is_some_and(|name| name.trim().is_empty())
}

impl Telling<'_, '_, '_> {
    fn report(&mut self, what: &str, span: Span, word: &str, value: impl Into<Arg>) {
        let finding = self.rule.at(self.facts, span).arg("what", what).arg("word", word);
        self.found.push(finding.arg("value", value));
    }

    fn tool(&mut self, tool: Option<&ToolRef>) {
        match tool {
            Some(ToolRef::Number(own)) => {
                if let Amount::Number(number) = own.amount
                    && (number * 10.0).fract().abs() > 1e-9
                {
                    self.report("tool", own.span, "T", Arg::Number(number));
                } else {
                    self.number("T", own, 0.0, TOOL);
                }
            }
            Some(ToolRef::Name(span)) if self.facts.text(*span).trim_matches('"').trim().is_empty() => {
                self.report("empty", *span, "T", "");
            }
            _ => {}
        }
    }

    /// A number that is written, or that a parameter certainly has.
    fn number(&mut self, word: &str, value: &Operand, least: f64, greatest: f64) {
        if let Some(number) = self.facts.number(value) {
            self.limit(word, number, value.span, least, greatest);
        }
    }

    /// The oversize of a tool in length, if it makes the tool much shorter.
    fn shorter(&mut self, value: Option<&Operand>) {
        let Some((value, length)) = value.and_then(|own| Some((own, self.facts.number(own)?))) else { return };
        if (-OVERSIZE..-SHORTER * self.facts.millimetre()).contains(&length) {
            self.report("shorter", value.span, "DL", Arg::Number(length));
        }
    }

    fn limit(&mut self, word: &str, number: f64, span: Span, least: f64, greatest: f64) {
        if number < least {
            self.report("below", span, word, Arg::Number(number));
        } else if number > greatest {
            self.report("above", span, word, Arg::Number(number));
        }
    }

    /// What a text that is certain makes of functions on it.
    fn texts(&mut self, words: &Words<'_>, texts: &BTreeMap<QRef, &str>) {
        let named = |written: &words::WordValue<'_>| {
            let number = written.value.get(2..)?.parse().ok()?;
            texts.get(&QRef { kind: QKind::Qs, number }).copied()
        };
        let Some((name, _)) = words.at(0) else { return };
        let Some((text, written)) = words.each("SRC_").next().and_then(|written| Some((named(&written)?, written)))
        else {
            return;
        };
        let number = text.trim().replace(',', ".");
        if name.eq_ignore_ascii_case("TONUMB") && number.parse::<f64>().is_err() {
            self.report("number", written.span, written.value, text);
        }
        let begins = words.each("BEG").next().and_then(|own| own.number().map(|number| (number, own.span)));
        if let Some((begin, span)) = begins.filter(|(begin, _)| *begin >= text.chars().count() as f64) {
            self.report("beyond", span, "BEG", Arg::Number(begin));
        }
    }

    fn words(&mut self, words: &Words<'_>) {
        if let Some((word, span)) = words.without_value() {
            self.report("value", span, word, "");
        }
        for known in words.known.iter().copied() {
            for limit in &known.limits {
                self.limits(words, limit);
            }
            for group in &known.one_of {
                let mut there = group.split(' ').filter(|word| words.has(word));
                if let (Some(first), Some(second)) = (there.next(), there.next()) {
                    self.report("contradict", words.span(), first, second);
                }
            }
            for pair in &known.excludes {
                let Some((first, second)) =
                    pair.split_once(' ').filter(|(one, other)| words.has(one) && words.has(other))
                else {
                    continue;
                };
                self.report("contradict", words.span(), first, second);
            }
            for word in known.never.iter().filter(|word| words.has(word)) {
                self.report("place", words.span(), word, "");
            }
            if !known.none_but.is_empty() {
                let other = |(word, _): &(&str, Span)| !known.none_but.iter().any(|own| own.eq_ignore_ascii_case(word));
                if let Some((word, span)) = words.others().find(other) {
                    self.report("place", span, word, "");
                }
            }
            if let Some(list) = known.askew.as_deref()
                && let Some([a, b, c, d, e, f]) = words.numbers(list)
                && is_zero(cross([a, b, c], [d, e, f]))
                && !is_zero([a, b, c])
                && !is_zero([d, e, f])
            {
                self.report("parallel", words.span(), list, "");
            } else if let Some(list) = known.askew.as_deref()
                && let Some([a, b, c, d, e, f]) = words.numbers(list)
                && lacks_sign([a, b, c], [d, e, f])
            {
                self.report("askew", words.span(), list, "");
            }
            if let Some(list) = known.spread.as_deref()
                && let Some([a, b, c, d, e, f, g, h, i]) = words.numbers(list)
                && is_zero(cross([d - a, e - b, f - c], [g - a, h - b, i - c]))
            {
                self.report("line", words.span(), list, "");
            }
            if let Some((list, name)) = known.no_file.as_deref().zip(words.last_name())
                && let Some((_, own)) = name.0.rsplit_once('.')
                && list.split(' ').any(|no| no.trim_start_matches('.').eq_ignore_ascii_case(own))
            {
                self.report("file", name.1, ".H", name.0);
            }
            if let Some((extension, (name, span))) = known.file.as_deref().zip(words.quoted())
                && let Some((_, own)) = name.rsplit_once('.')
                && !own.eq_ignore_ascii_case(extension.trim_start_matches('.'))
            {
                self.report("file", span, extension, name);
            }
            let number = |word: &str| words.each(word).next().and_then(|written| written.number());
            for group in &known.nonzero {
                if group.split(' ').all(|word| number(word) == Some(0.0)) {
                    self.report("zero", words.span(), group, "0");
                }
            }
            for pair in &known.below {
                let Some((less, more)) = pair.split_once(' ') else { continue };
                if let Some((own, other)) = number(less).zip(number(more))
                    && own >= other
                {
                    self.report("not-below", words.span(), less, more);
                }
            }
        }
    }

    fn limits(&mut self, words: &Words<'_>, limit: &WordLimit) {
        for (place, written) in words.each(&limit.word).enumerate() {
            if !limit.offers.is_empty() {
                // A word may be as a value, too: PATHCTRL AXIS.
                if place > 0 {
                    break;
                }
                let begins = |own: &String| {
                    written.value.len() >= own.len()
                        && written.value.get(..own.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(own))
                };
                let text = written.value.starts_with('"');
                let offered = limit
                    .offers
                    .iter()
                    .any(|own| if own == "QS" { begins(own) || text } else { own.eq_ignore_ascii_case(written.value) });
                if !offered && written.number().is_none() && !written.value.eq_ignore_ascii_case("MAX") {
                    self.report("offers", written.span, &limit.word, limit.offers.join(", "));
                }
                continue;
            }
            let Some(number) = written.number() else { continue };
            if limit.whole && number.fract() != 0.0 {
                self.report("whole", written.span, &limit.word, Arg::Number(number));
                continue;
            }
            let (least, greatest) = (limit.min.unwrap_or(f64::MIN), limit.max.unwrap_or(f64::MAX));
            self.limit(&limit.word, number, written.span, least, greatest);
        }
    }
}
