//! The command line as `clap` knows it, in the reader's language.
//!
//! `clap` speaks English only, so its headings are replaced and its errors are reported in our words.
//! Invariant: nothing that a user reads comes from `clap` except what they typed.
use std::ffi::OsString;
use std::path::PathBuf;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, ArgAction};

use super::arguments::{self, DATA, PSEUDO, UI_LANGUAGE};
use super::session::Output;
use super::{COMMANDS, Command, Failure, Outcome};
use crate::base::diag::Diagnostic;
use crate::language::locale::{Args, Ui};
use crate::tools::exchange::Pseudo;

/// Columns of the help where the width of the terminal is not known, and at most.
const WIDTH: usize = 100;

/// The language asked for by `--ui-lang`, looked for before anything can be reported in a language.
pub(super) fn interface_language(words: &[OsString]) -> Option<String> {
    value_of(words, UI_LANGUAGE)
}

/// The working copy asked for by `--data`, looked for in the same way.
pub(super) fn data(words: &[OsString]) -> Option<PathBuf> {
    value_of(words, DATA).map(PathBuf::from)
}

/// The first value of an option among the words of a command line.
fn value_of(words: &[OsString], option: &str) -> Option<String> {
    let mut words = words.iter().map(|word| word.to_string_lossy()).take_while(|word| word != "--");
    while let Some(word) = words.next() {
        match word.strip_prefix("--").and_then(|rest| rest.strip_prefix(option)) {
            Some("") => return words.next().map(|value| value.into_owned()),
            Some(rest) if rest.starts_with('=') => return rest.strip_prefix('=').map(str::to_owned),
            _ => {}
        }
    }
    None
}

/// The pseudo-language asked for by `--pseudo`, looked for in the same way.
pub(super) fn pseudo(words: &[OsString]) -> Option<Pseudo> {
    let words = words.iter().map(|word| word.to_string_lossy()).take_while(|word| word != "--");
    let mut kinds = words.filter_map(|word| match word.strip_prefix("--")?.strip_prefix(PSEUDO)? {
        "" | "=accents" => Some(Pseudo::Accents),
        "=bidi" => Some(Pseudo::Bidi),
        _ => None,
    });
    kinds.next()
}

/// The whole command line.
pub(super) fn command_line(ui: &Ui) -> clap::Command {
    let about = ui.text("cli-about", &Args::new());
    let commands = COMMANDS.iter().map(|command| subcommand(command, ui));
    let examples: Vec<String> =
        COMMANDS.iter().filter_map(|command| examples(command, ui).lines().next().map(str::to_owned)).collect();
    let root = shared(clap::Command::new("ciklo"), ui, "ciklo COMMAND", &examples.join("\n"))
        .about(about)
        .version(env!("CARGO_PKG_VERSION"))
        .disable_version_flag(true)
        .disable_help_subcommand(true)
        .subcommand_help_heading(ui.text("cli-heading-commands", &Args::new()))
        .subcommand_required(true)
        .arg(arguments::data(ui))
        .arg(arguments::ui_language(ui))
        .arg(arguments::pseudo(ui))
        .arg(flag(ui, "version", 'V', ArgAction::Version))
        .subcommands(commands);
    headed(root, ui)
}

fn subcommand(command: &Command, ui: &Ui) -> clap::Command {
    let usage = format!("ciklo {} {}", command.name, command.usage);
    let words = clap::Command::new(command.name).args((command.arguments)(ui));
    let own = shared(words, ui, usage.trim_end(), &examples(command, ui))
        .about(ui.text(&format!("cli-{}", command.name), &Args::new()));
    headed(own, ui)
}

/// Command lines to try, a line each. They name cycles, so they are with the texts.
fn examples(command: &Command, ui: &Ui) -> String {
    ui.text(&format!("cli-examples-{}", command.name), &Args::new())
}

fn shared(command: clap::Command, ui: &Ui, usage: &str, examples: &str) -> clap::Command {
    let heading = |name| ui.text(name, &Args::new());
    let lines: String = examples.lines().map(|example| format!("\n  {example}")).collect();
    let after = match lines.as_str() {
        "" => String::new(),
        lines => format!("{}{lines}", heading("cli-heading-examples")),
    };
    command
        .override_usage(usage.to_owned())
        .help_template(format!(
            "{{about-with-newline}}\n{} {{usage}}\n\n{{all-args}}{{after-help}}",
            heading("cli-heading-usage")
        ))
        .after_help(after)
        .max_term_width(WIDTH)
        .disable_help_flag(true)
        .arg(flag(ui, "help", 'h', ArgAction::Help))
}

fn flag(ui: &Ui, name: &'static str, short: char, action: ArgAction) -> Arg {
    arguments::argument(ui, name, &format!("cli-arg-{name}")).long(name).short(short).action(action)
}

/// Puts every argument below a heading in the reader's language.
fn headed(command: clap::Command, ui: &Ui) -> clap::Command {
    let (arguments, options) =
        (ui.text("cli-heading-arguments", &Args::new()), ui.text("cli-heading-options", &Args::new()));
    command.mut_args(|arg| {
        let heading = if arg.is_positional() { &arguments } else { &options };
        arg.help_heading(heading.clone())
    })
}

/// Reports what `clap` found: help, the version, or a mistake on the command line.
pub(super) fn explain(error: &clap::Error, ui: &Ui, output: &mut Output) -> Result<Outcome, Failure> {
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
            output.print(&error.render().to_string())?;
            Ok(Outcome::Clean)
        }
        kind => Err(mistake(kind, error, ui).into()),
    }
}

fn mistake(kind: ErrorKind, error: &clap::Error, ui: &Ui) -> Diagnostic {
    let reason = match kind {
        ErrorKind::InvalidValue | ErrorKind::ValueValidation if text(error, ContextKind::InvalidValue).is_empty() => {
            "no-value"
        }
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => "invalid-value",
        ErrorKind::UnknownArgument => "unknown-argument",
        ErrorKind::InvalidSubcommand => "unknown-command",
        ErrorKind::MissingSubcommand | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => "no-command",
        ErrorKind::MissingRequiredArgument => "missing-argument",
        ErrorKind::ArgumentConflict => "conflict",
        ErrorKind::TooManyValues | ErrorKind::WrongNumberOfValues => "too-many-values",
        ErrorKind::TooFewValues | ErrorKind::NoEquals => "no-value",
        ErrorKind::InvalidUtf8 => "not-text",
        _ => "other",
    };
    let subject = [ContextKind::InvalidArg, ContextKind::InvalidSubcommand].map(|kind| text(error, kind));
    let suggestions = [
        ContextKind::SuggestedArg,
        ContextKind::SuggestedSubcommand,
        ContextKind::SuggestedValue,
        ContextKind::ValidValue,
    ];
    let suggestion = suggestions.map(|kind| text(error, kind)).into_iter().find(|text| !text.is_empty());
    let hint = match suggestion {
        Some(suggestion) => ui.text("cli-usage-hint", &Args::new().text("suggestion", suggestion)),
        None => ui.text("cli-usage-help", &Args::new()),
    };
    Diagnostic::global("usage")
        .arg("reason", reason)
        .arg("subject", subject.concat().replace("...", ""))
        .arg("value", text(error, ContextKind::InvalidValue))
        .arg("hint", hint)
}

fn text(error: &clap::Error, kind: ContextKind) -> String {
    match error.get(kind) {
        Some(ContextValue::String(text)) => text.clone(),
        Some(ContextValue::Strings(texts)) => texts.join(", "),
        _ => String::new(),
    }
}
