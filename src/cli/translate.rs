//! `ciklo translate`: a program with the names and labels of another language.
use std::path::Path;
use std::sync::Arc;

use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, program};
use crate::base::diag::{Severity, Source, Span};
use crate::check::{Against, LabelBook};
use crate::language::locale::{Args, Language, Ui};
use crate::program::syntax::Dialect;
use crate::program::syntax::encoding::Encoding;
use crate::system::{self, Seen};
use crate::tools::translate::{self, Replacement, Told};

pub(super) const COMMAND: Command = Command {
    name: "translate",
    usage: "FILE --to LANG [--from LANG] [--control CONTROL] [--relabel] [--out FILE]",
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
    let file = program::understood_bytes(path, bytes, &catalogue);
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
            put(session, to_file, file.encoding, &mut all.into_iter(), source)
        } else {
            put(session, to_file, file.encoding, &mut counted, source)
        };
        written.map(|()| count)
    };
    let (written, Told { diagnostics, sources }) =
        translate::replacing(&file.program, &against, to, file.encoding, relabel, write);
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
