//! `ciklo figure`: the figures of a cycle as files.
use std::path::Path;

use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, session};
use crate::base::diag::Diagnostic;
use crate::language::locale::{Args, Ui};
use crate::language::text::with_texts;
use crate::output::figure::{self, Medium};
use crate::system;
use crate::tools::conform::World;

pub(super) const COMMAND: Command =
    Command { name: "figure", usage: "CYCLE --control CONTROL [--lang LANG] --out DIR", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::words(ui, "cycle", "CYCLE", "cli-arg-cycle"),
        arguments::control(ui),
        arguments::language(ui),
        arguments::valued(ui, "out", "DIR", "cli-figure-out").required(true),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let files = session.files()?;
    let on = cycle::control(&catalogue, &arguments::text(matches, "control"))?;
    let language = cycle::language_for(&locales, on, &session.ui, matches)?;
    let cycle = cycle::find(on, &arguments::all(matches, "cycle").join(" "))?;
    let world = World { catalogue: &catalogue, locales: &locales, files: &files };
    let (figures, found) = figure::prepare(&world, on, cycle);
    if !found.is_empty() {
        return Err(Failure::Data(found));
    }
    if figures.is_empty() {
        return Err(Diagnostic::global("figure-none").arg("cycle", cycle.key.to_string()).into());
    }
    let out = arguments::text(matches, "out");
    system::create_directory(Path::new(&out))?;
    let drawn = with_texts(on, cycle, language, |text| {
        figures.iter().map(|figure| (figure.stem(cycle), figure.svg(text, Medium::File))).collect::<Vec<_>>()
    });
    for (stem, svg) in drawn.map_err(session::in_texts(&locales))? {
        let path = Path::new(&out).join(format!("{stem}.svg"));
        system::write(&path, svg.text.as_bytes())?;
        let line = session.ui.text("cli-written", &Args::new().text("path", path.display().to_string()));
        session.output.remark(&line);
    }
    Ok(Outcome::Clean)
}
