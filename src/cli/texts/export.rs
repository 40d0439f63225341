//! `ciklo texts export`: the texts of a language as a file for translators.
use std::collections::BTreeSet;
use std::path::Path;

use clap::ArgMatches;

use super::shared::{Texts, language};
use crate::cli::session::Session;
use crate::cli::{Failure, Outcome, arguments, conform};
use crate::language::locale::Args;
use crate::spec;
use crate::system;
use crate::tools::conform::Selection;
use crate::tools::exchange::{self, Form, State, Unit};

pub(super) fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let tag = language(&arguments::text(matches, "to"))?;
    let form = match arguments::chosen_format(matches) {
        "xliff2" => Form::Xliff2,
        "po" => Form::Po,
        _ => Form::Xliff,
    };
    let texts = Texts::of(&session.files()?);
    let mut units = exchange::units(&texts.locales, &texts.meanings, &tag)?;
    let (stale, missing) = (matches.get_flag("stale"), matches.get_flag("missing"));
    let files = arguments::all(matches, "file");
    let cycles = arguments::all(matches, "cycle");
    let used = if cycles.is_empty() { None } else { Some(used(&texts, &cycles)?) };
    units.retain(|unit: &Unit| {
        let is_open = match unit.state {
            Some(State::Missing) => missing,
            Some(_) => stale,
            None => false,
        };
        (is_open || !stale && !missing)
            && (files.is_empty() || files.contains(&unit.file))
            && used.as_ref().is_none_or(|used| used.contains(&unit.message))
    });
    let text = exchange::write(&units, &tag, form);
    match matches.get_one::<String>("out") {
        Some(path) => {
            system::write(Path::new(path), text.as_bytes())?;
            let line = session.ui.text("cli-written", &Args::new().text("path", path.as_str()));
            session.output.remark(&line);
        }
        None => session.output.print(&text)?,
    }
    let line = session.ui.text("cli-texts-exported", &Args::new().number("count", units.len() as f64));
    session.output.remark(&line);
    Ok(Outcome::Clean)
}

/// The messages that cycles need on any control.
fn used(texts: &Texts, cycles: &[String]) -> Result<BTreeSet<String>, Failure> {
    let only = conform::cycles(cycles)?;
    let chosen = Selection { cycles: &only, ..Selection::default() };
    let mut ids = BTreeSet::new();
    for (_, on) in texts.catalogue.controls.iter() {
        for cycle in on.cycles.values().filter(|cycle| chosen.has_cycle(cycle)) {
            ids.extend(spec::texts(cycle, on).into_iter().map(|text| text.id));
        }
    }
    Ok(ids)
}
