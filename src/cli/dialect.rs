//! `ciklo convert --to-iso`, `--to-klartext`: a program in the words of the other language of the controls.
use std::path::Path;

use clap::ArgMatches;

use super::session::Session;
use super::{Failure, Outcome, arguments, cycle, program};
use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::QRef;
use crate::check::LabelBook;
use crate::language::locale::{Args, Ui};
use crate::program::iso::{Codes, Labels, to_iso, to_klartext};
use crate::program::syntax::Dialect;
use crate::program::syntax::encoding::Encoding;
use crate::spec::{CycleKey, Field, OnControl, Param};
use crate::system::{self, Seen};

/// The arguments that ask for it.
pub(super) fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::switch(ui, "to-iso", "cli-convert-to-iso").conflicts_with_all(["to-klartext", "to"]),
        arguments::switch(ui, "to-klartext", "cli-convert-to-klartext").conflicts_with("to"),
        arguments::valued(ui, "control", "CONTROL", "cli-convert-control").conflicts_with("to"),
        arguments::valued(ui, "lang", "LANG", "cli-convert-lang").conflicts_with("to"),
    ]
}

/// The names and labels of a control in a language, as far as the file's encoding has their characters.
struct Words<'a> {
    on: &'a OnControl,
    book: LabelBook<'a>,
    language: &'a str,
    encoding: Encoding,
}

impl Words<'_> {
    fn label(&self, key: CycleKey, is_it: &dyn Fn(&Param) -> bool) -> Option<String> {
        let at = self.on.cycles.get(&key)?.params.iter().position(is_it)?;
        self.writable(self.book.cycle(key)?.language(self.language)?.params.get(at)?.label.clone()?)
    }

    fn writable(&self, label: String) -> Option<String> {
        self.encoding.encode(&label).is_ok().then_some(label)
    }
}

impl Labels for Words<'_> {
    fn name(&self, key: CycleKey) -> Option<String> {
        self.writable(self.book.cycle(key)?.language(self.language)?.name.label.clone()?)
    }

    fn parameter(&self, key: CycleKey, q: QRef) -> Option<String> {
        self.label(key, &|own| own.q == Some(q) || own.q_of_name() == Some(q))
    }

    fn field(&self, key: CycleKey, field: &Field) -> Option<String> {
        let is_it = |own: &Field| own.form == field.form && own.id.as_str() == field.id.as_str();
        self.label(key, &|own| own.field.as_ref().is_some_and(is_it))
    }
}

/// Findings about how a program is written.
const READING: &str = "syntax-";

/// Writes a program in the other language.
pub(super) fn write(session: &mut Session, matches: &ArgMatches, path: &str) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let path = Path::new(path);
    let bytes = system::read(path)?;
    let seen = Seen::of(path, &bytes);
    let file = program::understood_bytes(path, bytes, &catalogue);
    let codes = Codes::new(&catalogue);
    let wanted = if matches.get_flag("to-iso") { Dialect::Iso } else { Dialect::Klartext };
    let (text, diagnostics) = if file.written().dialect() == wanted {
        (file.written().source().text().to_owned(), Vec::new())
    } else if wanted == Dialect::Iso {
        let raised = to_iso(&file.program, &codes);
        let mut diagnostics = file.program.diagnostics();
        diagnostics.retain(|finding| finding.severity == Severity::Error);
        diagnostics.extend(raised.diagnostics);
        (raised.text, diagnostics)
    } else {
        let on = match matches.get_one::<String>("control") {
            Some(id) => Some(cycle::control(&catalogue, id)?),
            None => cycle::likeliest(&file.program, &catalogue, &locales),
        };
        let Some(on) = on else { return Ok(Outcome::Clean) };
        let language = cycle::language_for(&locales, on, &session.ui, matches)?.tag();
        let words = Words { on, book: LabelBook::new(on, &locales), language, encoding: file.encoding };
        let lowered = to_klartext(file.written(), &codes, Some(&words));
        (lowered.program.source().text().to_owned(), lowered.diagnostics)
    };
    let source = file.written().source();
    let bytes = file.encoding.encode(&text).map_err(|sign| program::unwritable(sign, source))?;
    match matches.get_one::<String>("out") {
        Some(out) => {
            system::write_parts(Path::new(out), Some(&seen), std::iter::once(&*bytes))?;
            let line = session.ui.text("cli-written", &Args::new().text("path", out.as_str()));
            session.output.remark(&line);
        }
        None => session.output.write(&bytes)?,
    }
    // Every block that was left out is reported; what the reading found is as bad as it says.
    let reported: Vec<Diagnostic> = diagnostics
        .into_iter()
        .map(|finding| match finding.code.starts_with(READING) {
            true => finding,
            false => Diagnostic { severity: Severity::Error, ..finding },
        })
        .collect();
    reported.iter().for_each(|diagnostic| session.output.complain(diagnostic, &session.ui));
    let refused = reported.iter().any(|finding| finding.severity == Severity::Error);
    Ok(if refused { Outcome::Errors } else { Outcome::Clean })
}
