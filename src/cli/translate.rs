//! `ciklo translate`: a program with the names and labels of another language.
use std::path::Path;
use std::sync::Arc;

use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, program};
use crate::base::diag::{Diagnostic, Severity, Source, Span};
use crate::check::{Against, LabelBook};
use crate::language::locale::{Args, Language, Ui};
use crate::program::syntax::Dialect;
use crate::program::syntax::encoding::{Charset, Encoding, decode_as};
use crate::system::{self, Seen};
use crate::tools::translate::{self, Replacement, Told};

pub(super) const COMMAND: Command = Command {
    name: "translate",
    usage: "FILE --to LANG [--from LANG] [--control CONTROL] [--relabel] [--encoding NAME] [--out FILE]",
    arguments: own,
    run,
};

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::file(ui),
        arguments::valued(ui, "to", "LANG", "cli-translate-to").required(true),
        arguments::valued(ui, "from", "LANG", "cli-translate-from"),
        arguments::valued(ui, "control", "CONTROL", "cli-translate-control"),
        arguments::switch(ui, "relabel", "cli-translate-relabel"),
        arguments::valued(ui, "encoding", "NAME", "cli-translate-encoding"),
        arguments::valued(ui, "out", "FILE", "cli-translate-out"),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let to = cycle::language(&locales, &arguments::text(matches, "to"))?.tag();
    let from = matches.get_one::<String>("from").map(|tag| cycle::language(&locales, tag)).transpose()?;
    let path = arguments::text(matches, "file");
    let path = Path::new(&path);
    let bytes = system::read(path)?;
    let seen = Seen::of(path, &bytes);
    let wanted = matches.get_one::<String>("encoding").map(|name| charset(name)).transpose()?;
    let file = match wanted {
        None => program::understood_bytes(path, bytes, &catalogue),
        Some(charset) => {
            let decoded = decode_as(&bytes, charset).ok_or_else(|| unreadable(path, charset))?;
            program::understood(path, decoded.text, decoded.encoding, &catalogue)
        }
    };
    let on = match matches.get_one::<String>("control") {
        Some(id) => Some(cycle::control(&catalogue, id)?),
        None => cycle::likeliest(&file.program, &catalogue, &locales),
    };
    let Some(on) = on else { return Ok(Outcome::Clean) };
    let labels = LabelBook::new(on, &locales);
    let against = Against {
        catalogue: &catalogue,
        on,
        labels: &labels,
        language: from.map(Language::tag),
        software: None,
        readers: &[],
    };
    let relabel = matches.get_flag("relabel");
    let source = file.written().source();
    let encoding = match encoding_for(&file, &against, to, relabel, wanted.is_some()) {
        Ok(encoding) => encoding,
        // A program that is in two languages helps no one: nothing is written.
        Err(found) => {
            found.iter().for_each(|own| session.output.complain(&file.at_home(own.clone()), &session.ui));
            return Ok(Outcome::Errors);
        }
    };
    if encoding != file.encoding {
        let name = encoding.charset.name();
        let note = Diagnostic::global("translate-encoding").arg("encoding", name);
        session.output.complain(&Diagnostic { severity: Severity::Note, ..note }, &session.ui);
    }
    let out = matches.get_one::<String>("out").map(String::as_str);
    let to_file = out.map(|out| (Path::new(out), &seen));
    let write = |all: &mut dyn Iterator<Item = Replacement<'_>>| {
        let mut count = 0;
        let at_home = all.filter_map(|own| Some((file.exact(own.span)?, own.to)));
        let mut counted = at_home.inspect(|_| count += 1);
        // What comes from DIN/ISO is there in another order.
        let sorted = file.written().dialect() == Dialect::Iso;
        let written = if sorted {
            let mut all: Vec<_> = counted.collect();
            all.sort_by_key(|(span, _)| *span);
            put(session, to_file, encoding, &mut all.into_iter(), source)
        } else {
            put(session, to_file, encoding, &mut counted, source)
        };
        written.map(|()| count)
    };
    let (written, Told { diagnostics, sources }) =
        translate::replacing(&file.program, &against, to, encoding, relabel, write);
    let count = written?;
    if let Some(out) = out {
        let args = Args::new().number("count", f64::from(count)).text("path", out);
        let line = session.ui.text("cli-translated", &args);
        session.output.remark(&line);
    }
    if from.is_none() && !sources.is_empty() {
        let mut sources: Vec<(String, usize)> = sources.into_iter().collect();
        sources.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        let listed: Vec<String> = sources.iter().map(|(tag, count)| format!("{tag} ({count})")).collect();
        let args = Args::new().number("count", listed.len() as f64).text("languages", listed.join(", "));
        let line = session.ui.text("cli-translate-sources", &args);
        session.output.remark(&line);
    }
    // What could not be said in the language stays as it was, and that is reported.
    let diagnostics: Vec<_> = diagnostics.into_iter().map(|diagnostic| file.at_home(diagnostic)).collect();
    diagnostics.iter().for_each(|diagnostic| session.output.complain(diagnostic, &session.ui));
    let errors = diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error);
    Ok(if errors { Outcome::Errors } else { Outcome::Clean })
}

/// The character set of a name.
fn charset(name: &str) -> Result<Charset, Failure> {
    let known = || Charset::NAMES.map(|(name, _)| name).join(", ");
    let unknown = || Diagnostic::global("translate-encoding-unknown").arg("encoding", name).arg("known", known());
    Charset::named(name).ok_or_else(|| unknown().into())
}

fn unreadable(path: &Path, charset: Charset) -> Failure {
    let trouble = Diagnostic::global("translate-encoding-wrong").arg("path", path.display().to_string());
    trouble.arg("encoding", charset.name()).into()
}

/// The encoding that all labels of a translation can be written in: that of the file, or another code page in which the
/// file has the same characters.
///
/// # Errors
/// What cannot be written, where there is none.
fn encoding_for(
    file: &program::Understood,
    against: &Against<'_>,
    to: &str,
    relabel: bool,
    fixed: bool,
) -> Result<Encoding, Vec<Diagnostic>> {
    let lacking = |encoding: Encoding| {
        let ((), told) = translate::replacing(&file.program, against, to, encoding, relabel, |all| all.for_each(drop));
        let lacks = |own: &Diagnostic| own.code == "label-not-encodable";
        told.diagnostics.into_iter().filter(lacks).collect::<Vec<_>>()
    };
    // All characters are in these.
    if matches!(file.encoding.charset, Charset::Utf8 | Charset::Utf16Le | Charset::Utf16Be) {
        return Ok(file.encoding);
    }
    let found = lacking(file.encoding);
    if found.is_empty() {
        return Ok(file.encoding);
    }
    let text = file.written().source().text();
    let mut others = file.encoding.alike(text).filter(|_| !fixed);
    others.find(|other| lacking(*other).is_empty()).ok_or(found)
}

/// Writes the program with what is replaced in it: to a file, made from the one that was read, or to standard output.
fn put<'t>(
    session: &mut Session,
    out: Option<(&Path, &Seen)>,
    encoding: Encoding,
    replaced: &mut dyn Iterator<Item = (Span, &'t str)>,
    source: &'t Arc<Source>,
) -> Result<(), Failure> {
    let pieces = program::pieces(source.text(), replaced);
    match out {
        Some((out, from)) => program::write_pieces(out, from, encoding, pieces, source),
        None => program::print_pieces(session, encoding, pieces, source),
    }
}
