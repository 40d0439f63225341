//! The arguments that several commands share.
//!
//! Invariant: an argument has its help in the message `cli-arg-<name>`, or in `cli-<command>-<name>`
//! where a command gives it a meaning of its own.
use std::path::PathBuf;

use clap::{Arg, ArgAction, ArgMatches, builder::PossibleValuesParser, value_parser};

use crate::base::diag::Severity;
use crate::language::locale::{Args, Ui};

pub(super) const DATA: &str = "data";
pub(super) const UI_LANGUAGE: &str = "ui-lang";
pub(super) const PSEUDO: &str = "pseudo";
const FORMAT: &str = "format";
const FAIL_ON: &str = "fail-on";

/// An option or positional argument with its help.
pub(super) fn argument(ui: &Ui, name: &'static str, help: &str) -> Arg {
    Arg::new(name).help(ui.text(help, &Args::new()))
}

/// An option with a value, `--name VALUE`, with its help in a message of the command.
pub(super) fn valued(ui: &Ui, name: &'static str, value: &'static str, help: &str) -> Arg {
    argument(ui, name, help).long(name).value_name(value)
}

/// The same for an option that may be given several times.
pub(super) fn several(ui: &Ui, name: &'static str, value: &'static str, help: &str) -> Arg {
    valued(ui, name, value, help).action(ArgAction::Append)
}

/// An option with a value and the help that it has for every command.
pub(super) fn option(ui: &Ui, name: &'static str, value: &'static str) -> Arg {
    valued(ui, name, value, &format!("cli-arg-{name}"))
}

/// A switch, `--name`, with its help in a message of the command.
pub(super) fn switch(ui: &Ui, name: &'static str, help: &str) -> Arg {
    argument(ui, name, help).long(name).action(ArgAction::SetTrue)
}

/// `--data DIR`, before or after the command.
pub(super) fn data(ui: &Ui) -> Arg {
    option(ui, DATA, "DIR").global(true).value_parser(value_parser!(PathBuf))
}

/// `--ui-lang LANG`, before or after the command.
pub(super) fn ui_language(ui: &Ui) -> Arg {
    option(ui, UI_LANGUAGE, "LANG").global(true)
}

/// `--pseudo[=KIND]`, before or after the command.
pub(super) fn pseudo(ui: &Ui) -> Arg {
    let kinds = PossibleValuesParser::new(["accents", "bidi"]);
    let arg = option(ui, PSEUDO, "KIND").global(true).value_parser(kinds).hide_possible_values(true);
    arg.num_args(0..=1).require_equals(true).default_missing_value("accents")
}

/// One program.
pub(super) fn file(ui: &Ui) -> Arg {
    argument(ui, "file", "cli-arg-file").value_name("FILE").required(true)
}

/// `--control CONTROL`, which must be given.
pub(super) fn control(ui: &Ui) -> Arg {
    option(ui, "control", "CONTROL").required(true)
}

/// `--lang LANG`.
pub(super) fn language(ui: &Ui) -> Arg {
    option(ui, "lang", "LANG")
}

/// One or more words without a name, with its help in that message.
pub(super) fn words(ui: &Ui, name: &'static str, value: &'static str, help: &str) -> Arg {
    argument(ui, name, help).value_name(value).num_args(1..).required(true)
}

/// The value of an argument that must be given.
pub(super) fn text(matches: &ArgMatches, name: &str) -> String {
    matches.get_one::<String>(name).cloned().unwrap_or_default()
}

/// All values of an argument.
pub(super) fn all(matches: &ArgMatches, name: &str) -> Vec<String> {
    matches.get_many::<String>(name).into_iter().flatten().cloned().collect()
}

/// `--format`, with the first of the formats as default.
pub(super) fn format(ui: &Ui, formats: &'static [&'static str]) -> Arg {
    let arg = option(ui, FORMAT, "FORMAT").value_parser(PossibleValuesParser::new(formats));
    // What `clap` would say about possible values and the default is in English; the help says it.
    arg.default_values(formats.iter().take(1).copied()).hide_possible_values(true).hide_default_value(true)
}

/// `--fail-on LEVEL`.
pub(super) fn fail_on(ui: &Ui) -> Arg {
    let levels = PossibleValuesParser::new(["error", "warning", "note"]);
    valued(ui, FAIL_ON, "LEVEL", "cli-check-fail-on").value_parser(levels).hide_possible_values(true)
}

/// The severity with which findings make the command fail, if one is asked for.
pub(super) fn chosen_fail_on(matches: &ArgMatches) -> Option<Severity> {
    matches.get_one::<String>(FAIL_ON).and_then(|word| Severity::from_word(word))
}

/// The chosen format.
pub(super) fn chosen_format(matches: &ArgMatches) -> &str {
    matches.get_one::<String>(FORMAT).map_or("text", String::as_str)
}
