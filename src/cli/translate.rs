//! `ciklo translate`: a program with the names and labels of another language.
use std::path::Path;

use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, program};
use crate::check::{self, Against, LabelBook};
use crate::diag::Severity;
use crate::locale::{Locales, Ui};
use crate::spec::{Catalogue, OnControl};
use crate::syntax::Program;
use crate::system;
use crate::translate::{self, Translation};

pub(super) const COMMAND: Command =
    Command { name: "translate", usage: "FILE --to LANG [--control CONTROL] [--out FILE]", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::file(ui),
        arguments::valued(ui, "to", "LANG", "cli-translate-to").required(true),
        arguments::valued(ui, "control", "CONTROL", "cli-translate-control"),
        arguments::valued(ui, "out", "FILE", "cli-translate-out"),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let to = cycle::language(&locales, &arguments::text(matches, "to"))?.tag();
    let file = program::read(Path::new(&arguments::text(matches, "file")))?;
    let on = match matches.get_one::<String>("control") {
        Some(id) => Some(cycle::control(&catalogue, id)?),
        None => likeliest(&file.program, &catalogue, &locales),
    };
    let Some(on) = on else { return Ok(Outcome::Clean) };
    let labels = LabelBook::new(on, &locales);
    let against = Against { catalogue: &catalogue, on, labels: &labels, language: None, readers: &[] };
    let Translation { text, changes, diagnostics } = translate::translate(&file.program, &against, to, file.encoding);
    let bytes = file.encoding.encode(&text).map_err(|sign| program::not_encodable(sign, &file))?;
    match matches.get_one::<String>("out") {
        Some(out) => {
            system::write(Path::new(out), &bytes)?;
            let args = crate::locale::Args::new().number("count", changes.len() as f64).text("path", out.as_str());
            let line = session.ui.text("cli-translated", &args);
            session.output.remark(&line);
        }
        None => session.output.write(&bytes)?,
    }
    // What could not be said in the language stays as it was, and that is told.
    diagnostics.iter().for_each(|diagnostic| session.output.complain(diagnostic, &session.ui));
    let errors = diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error);
    Ok(if errors { Outcome::Errors } else { Outcome::Clean })
}

/// Findings that say that a control does not have a cycle as the program writes it.
const FOREIGN: [&str; 3] = ["unknown-cycle", "cycle-not-on-control", "cycle-not-described"];

/// The control that knows most cycles of the program and otherwise objects least to it.
fn likeliest<'c>(program: &Program, catalogue: &'c Catalogue, locales: &Locales) -> Option<&'c OnControl> {
    catalogue.controls.values().min_by_key(|on| {
        let labels = LabelBook::new(on, locales);
        let against = Against { catalogue, on, labels: &labels, language: None, readers: &[] };
        let found = check::check(program, &against);
        (found.iter().filter(|diagnostic| FOREIGN.contains(&diagnostic.code)).count(), found.len())
    })
}
