//! `FN 16: F-PRINT`: texts and values by a mask, into a file of the run or onto the screen.
//!
//! Invariant: the run writes no file itself; the name of an output has no way out of the folder of the outputs.
use super::mask::{self, Form, Piece, Source};
use crate::base::expr::QKind;
use crate::engine::flow::state::Run;
use crate::engine::params::Content;
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;
use crate::engine::report::fault::{Class, Fault};
use crate::program::syntax::{Block, Statement};

/// A kilobyte of a file.
const KILOBYTE: usize = 1024;
/// A name of a language has as many letters at least.
const SHORTEST: usize = 5;
/// The message that has the name of the language in masks.
const LANGUAGE: &str = "log-mask-language";

/// Where an output goes.
enum Target {
    File(String),
    Screen,
    /// Data that leave the control, and windows that are closed.
    Elsewhere,
}

impl Run<'_, '_> {
    /// `FN 16: F-PRINT TNC:\MASK.A / TNC:\LOG.TXT`.
    pub(super) fn print_by_mask(&mut self, block: &Block, statement: &Statement) -> Done {
        // What is only assumed is not printed.
        if self.settings.only_assumes() {
            return Ok(());
        }
        let written = statement.words.first().map_or("", |word| self.slice(word.value.span)).to_owned();
        let Some((name, target)) = written.split_once('/') else { return Err(Fault::program("value-missing").into()) };
        let (name, target) = (self.path_of(name)?, self.path_of(target)?);
        let target = target_of(&target)?;
        if matches!(target, Target::Elsewhere) {
            self.report_function(block);
            return Ok(());
        }
        let masks = &self.drives.world.scene.masks;
        let Some((file, text)) = masks.iter().find(|(known, _)| is_same_file(known, &name)) else {
            return Err(Fault::program("mask-missing").arg("name", name).into());
        };
        let unreadable = |(line, found): mask::Mistake| {
            Fault::program("mask-unreadable").arg("file", file.as_str()).arg("line", line as f64).arg("found", found)
        };
        let statements = mask::read(text).map_err(unreadable)?;
        let (mut printed, mut is_meant, mut hides) = (String::new(), true, false);
        let (mut closes, mut appends, mut anew, mut most) = (false, false, false, None);
        for statement in &statements {
            match statement {
                mask::Statement::Line(pieces) if is_meant => {
                    let line = self.printed_line(pieces)?;
                    if !(hides && line.trim().is_empty()) {
                        printed.push_str(&line);
                        printed.push('\n');
                    }
                }
                mask::Statement::Line(_) => {}
                mask::Statement::Close => closes = true,
                mask::Statement::Append => appends = true,
                mask::Statement::AppendUpTo(size) => (appends, most) = (true, Some(*size as usize * KILOBYTE)),
                mask::Statement::Truncate => anew = true,
                mask::Statement::HideEmpty(empty) => hides = *empty,
                mask::Statement::Language(None) => is_meant = true,
                mask::Statement::Language(Some(language)) => is_meant = self.is_own_language(language)?,
            }
        }
        // A contour that is only read prints nothing: each cycle that machines it reads it again.
        if self.drives.report.is_rehearsing() {
            return Ok(());
        }
        let Target::File(file) = target else {
            self.records.screens.push(printed.clone());
            self.drives.report.report(EventKind::Log { file: None, text: printed });
            return Ok(());
        };
        if anew || (self.records.closed.remove(&file) && !appends) {
            self.records.logs.retain(|(known, _)| *known != file);
        }
        match self.records.logs.iter_mut().find(|(known, _)| *known == file) {
            Some((_, all)) if most.is_some_and(|most| all.len() >= most) => return Ok(()),
            Some((_, all)) => all.push_str(&printed),
            None => self.records.logs.push((file.clone(), printed.clone())),
        }
        if closes {
            self.records.closed.insert(file.clone());
        }
        self.drives.report.report(EventKind::Log { file: Some(file), text: printed });
        Ok(())
    }

    /// A path as it is written, or the text of the parameter that is written in its place: `:'QS1'`.
    pub(super) fn path_of(&self, written: &str) -> Result<String, Fault> {
        let bare = written.trim().trim_matches('"').trim();
        let named = bare.strip_prefix(":'").and_then(|rest| rest.strip_suffix('\'')).unwrap_or(bare);
        let path = self.named_text(named)?.trim().to_owned();
        if path.is_empty() { Err(Fault::program("value-missing")) } else { Ok(path) }
    }

    /// Whether a keyword of a mask means the language of the logs. Controls cut long names: `L_PORTUGUE`.
    fn is_own_language(&self, keyword: &str) -> Result<bool, Fault> {
        let own = self.settings.texts.message(LANGUAGE, &[]).map_err(|diagnostic| {
            Fault::new(Class::Internal, "log-text").arg("name", LANGUAGE).arg("reason", diagnostic.code)
        })?;
        let named = keyword.trim_start_matches("L_");
        Ok(named.len() >= SHORTEST && own.to_ascii_uppercase().starts_with(named))
    }

    fn printed_line(&self, pieces: &[Piece]) -> Result<String, Fault> {
        let mut line = String::new();
        for piece in pieces {
            match piece {
                Piece::Text(text) => line.push_str(text),
                Piece::Value { of, form, width, left, zeros } => {
                    let text = self.printed_value(*of, *form)?;
                    line.push_str(&Piece::fill(&text, *width, *left, *zeros));
                }
            }
        }
        Ok(line)
    }

    fn printed_value(&self, of: Source, form: Form) -> Result<String, Fault> {
        let now = self.drives.world.scene.clock;
        let value = match of {
            // A text that was never given has no characters.
            Source::Parameter(q) if q.kind == QKind::Qs => {
                self.params.get(q).unwrap_or_else(|| Content::Text("".into()))
            }
            Source::Parameter(q) => Content::Number(self.params.number(q)?),
            Source::CallPath => Content::Text(last_part(&self.drives.report.at().program).into()),
            Source::Hour => Content::Number(f64::from(now.hour)),
            Source::Minute => Content::Number(f64::from(now.minute)),
            Source::Second => Content::Number(f64::from(now.second)),
            Source::Day => Content::Number(f64::from(now.day)),
            Source::Month => Content::Number(f64::from(now.month)),
            Source::NamedMonth => Content::Text(month(now.month).into()),
            Source::ShortYear => Content::Number(f64::from(now.year % 100)),
            Source::Year => Content::Number(f64::from(now.year)),
        };
        let text = match (value, form) {
            (Content::Text(text), Form::Text) => return Ok(text.to_string()),
            (Content::Number(number), Form::Decimal(decimals)) => format!("{number:.decimals$}"),
            (Content::Number(number), Form::Whole) => format!("{number:.0}"),
            _ => return Err(Fault::program("text-or-number")),
        };
        // Nothing is below zero that rounds to it.
        let is_zero = text.starts_with('-') && text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
        Ok(if is_zero { text.trim_start_matches('-').to_owned() } else { text })
    }
}

/// A month from 1 with three letters.
fn month(number: u8) -> &'static str {
    const NAMES: [&str; 12] = ["JAN", "FEB", "MAR", "APR", "MAY", "JUN", "JUL", "AUG", "SEP", "OCT", "NOV", "DEC"];
    usize::from(number).checked_sub(1).and_then(|index| NAMES.get(index)).copied().unwrap_or_default()
}

/// Whether two paths of a control mean one file: drives and directories do not matter, nor does case.
fn is_same_file(own: &str, asked: &str) -> bool {
    last_part(own).eq_ignore_ascii_case(last_part(asked))
}

/// The name of a file without drive and directories.
fn last_part(path: &str) -> &str {
    path.rsplit(['\\', '/', ':']).next().unwrap_or_default()
}

/// Where a path leads: to a file of its name, whatever the drive of the control and its directories. A path that leads
/// upwards, or to a drive or the root of another system, is none.
fn target_of(path: &str) -> Result<Target, Fault> {
    let wrong = || Fault::program("output-path").arg("path", path);
    let upper = path.to_ascii_uppercase();
    if upper == "SCREEN:" {
        return Ok(Target::Screen);
    }
    if ["SCLR:", "PRINTER:", "RS232:", "RS422:"].iter().any(|device| upper.starts_with(device)) {
        return Ok(Target::Elsewhere);
    }
    let (drive, rest) = path.split_once(':').unwrap_or(("TNC", path));
    let is_rooted = rest.len() == path.len() && rest.starts_with(['\\', '/']);
    if is_rooted || !drive.eq_ignore_ascii_case("TNC") || rest.contains(':') {
        return Err(wrong());
    }
    let parts: Vec<&str> = rest.split(['\\', '/']).collect();
    match parts.last() {
        Some(name) if !name.trim().is_empty() && !parts.contains(&"..") && *name != "." => {
            Ok(Target::File(name.trim().to_owned()))
        }
        _ => Err(wrong()),
    }
}
