//! `ciklo schema`: the JSON Schema of the specifications.
use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome};
use crate::spec;

pub(super) const COMMAND: Command = Command { name: "schema", usage: "", arguments: |_| Vec::new(), run };

fn run(session: &mut Session, _: &ArgMatches) -> Result<Outcome, Failure> {
    session.output.print(&format!("{:#}\n", spec::schema()))?;
    Ok(Outcome::Clean)
}
