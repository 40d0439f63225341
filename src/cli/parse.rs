//! `ciklo parse`: what the parser sees in a program.
use std::path::Path;

use clap::ArgMatches;

use super::session::{self, Session};
use super::{Command, Failure, Outcome, arguments, program};
use crate::locale::Ui;
use crate::syntax::json;

pub(super) const COMMAND: Command = Command { name: "parse", usage: "FILE [--print]", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![arguments::file(ui), arguments::switch(ui, "print", "cli-parse-print")]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let file = program::read(Path::new(&arguments::text(matches, "file")))?;
    if matches.get_flag("print") {
        // Text that came from a file in this encoding can be written in it.
        let text = file.program.text();
        let bytes = file.encoding.encode(&text).map_err(|sign| program::not_encodable(sign, &file))?;
        session.output.write(&bytes)?;
    } else {
        session.output.print(&session::json(&json::document(&file.program))?)?;
    }
    Ok(Outcome::Clean)
}
