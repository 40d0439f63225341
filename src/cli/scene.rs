//! `ciklo scene`: a scene file for a program that has none, to be corrected.
use std::path::Path;

use clap::ArgMatches;

use super::execution::{Execution, tool_table, tool_table_of, tools};
use super::session::Session;
use super::{Command, Failure, Outcome, arguments};
use crate::base::diag::visible;
use crate::engine::scene::guess::{Line, Origin};
use crate::language::locale::{Args, Ui};
use crate::system;

pub(super) const COMMAND: Command =
    Command { name: "scene", usage: "FILE --control CONTROL [--tool-table FILE] [--out FILE]", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::file(ui),
        arguments::control(ui),
        tool_table(ui),
        arguments::valued(ui, "out", "FILE", "cli-scene-out"),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let catalogue = session.catalogue()?;
    let execution = Execution::new(session, &catalogue, matches)?;
    let guess = execution.guess(tool_table_of(&tools(matches)?))?;
    let ui = session.ui;
    let text = guess.to_yaml(&|line| remark(line, &execution.path, &ui));
    match matches.get_one::<String>("out") {
        Some(out) => {
            system::write(Path::new(out), text.as_bytes())?;
            let line = ui.text("cli-written", &Args::new().text("path", out.as_str()));
            session.output.remark(&line);
        }
        None => session.output.print(&text)?,
    }
    execution.readable()?;
    Ok(Outcome::Clean)
}

/// The comment on a line of a scene file.
fn remark(line: Line<'_>, path: &str, ui: &Ui) -> String {
    let text = |id: &str| ui.text(id, &Args::new().text("path", &*visible(path)));
    match line {
        Line::Head => text("cli-scene-head"),
        Line::Tool(tool) => match tool.origin {
            Origin::Program => "TOOL DEF".to_owned(),
            Origin::Table => text("cli-scene-from-table"),
            Origin::Assumed => text("cli-scene-is-assumed"),
        },
        Line::Probe | Line::Setter => text("cli-scene-is-assumed"),
        Line::Blank => "BLK FORM".to_owned(),
    }
}
