//! `ciklo parse`: what the parser sees in a program.
use std::path::Path;

use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, program};
use crate::language::locale::Ui;
use crate::program::syntax::json;

pub(super) const COMMAND: Command = Command { name: "parse", usage: "FILE [--print]", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![arguments::file(ui), arguments::switch(ui, "print", "cli-parse-print")]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let file = program::read(Path::new(&arguments::text(matches, "file")))?;
    if matches.get_flag("print") {
        let program = &file.program;
        let pieces = program.blocks().iter().map(|block| program.slice(block.span));
        program::print_pieces(session, file.encoding, pieces, program.source())?;
    } else {
        session.print_json(&json::document(&file.program))?;
    }
    Ok(Outcome::Clean)
}
