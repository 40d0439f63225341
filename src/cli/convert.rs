//! `ciklo convert`: programs of one control for another one, or in the other language of the controls.
use std::path::Path;

use clap::ArgMatches;
use clap::builder::PossibleValuesParser;
use serde::Serialize;

use super::session::{Session, json};
use super::{Command, Failure, Outcome, arguments, by_klartext, cycle, dialect, program};
use crate::base::diag::{Diagnostic, Edit, Severity};
use crate::check::{Against, LabelBook};
use crate::language::locale::{Args, Locales, Ui};
use crate::program::syntax::encoding::{self, Decoded};
use crate::program::syntax::{self, Dialect, Program};
use crate::system::{self, Seen};
use crate::tools::convert::{self, Conversion, Form, Request, Step};

pub(super) const COMMAND: Command = Command {
    name: "convert",
    usage: "FILE… (--from CONTROL --to CONTROL [--form FORM] | --to-iso | --to-klartext [--control CONTROL] \
            [--lang LANG])\n       [--out FILE | --in-place] [--format FORMAT]",
    arguments: own,
    run,
};

/// The format of the document.
const FORMAT: &str = "ciklo-convert/1";

fn own(ui: &Ui) -> Vec<clap::Arg> {
    let mut arguments = vec![
        arguments::words(ui, "file", "FILE", "cli-convert-file"),
        arguments::valued(ui, "from", "CONTROL", "cli-convert-from").requires("to"),
        arguments::valued(ui, "to", "CONTROL", "cli-convert-to")
            .requires("from")
            .required_unless_present_any(["to-iso", "to-klartext"]),
        arguments::valued(ui, "form", "FORM", "cli-convert-form")
            .value_parser(PossibleValuesParser::new(["new", "old"]))
            .hide_possible_values(true)
            .requires("to"),
        arguments::valued(ui, "out", "FILE", "cli-convert-out").conflicts_with("in-place"),
        arguments::switch(ui, "in-place", "cli-convert-in-place").requires("to"),
        arguments::format(ui, &["text", "json"]).requires("to"),
    ];
    arguments.splice(4..4, dialect::own(ui));
    arguments
}

/// What the document says of a program.
#[derive(Serialize)]
struct Report<'r> {
    format: &'static str,
    file: &'r str,
    from: &'r str,
    to: &'r str,
    rewritten: usize,
    findings: Vec<Finding>,
    text: &'r str,
}

#[derive(Serialize)]
struct Finding {
    line: usize,
    column: usize,
    severity: &'static str,
    code: &'static str,
    message: String,
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let names = arguments::all(matches, "file");
    let in_place = matches.get_flag("in-place");
    if names.len() > 1 && !in_place {
        return Err(Diagnostic::global("convert-one-file").into());
    }
    if !matches.contains_id("to") {
        return dialect::write(session, matches, names.first().map_or("-", String::as_str));
    }
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let from = cycle::control(&catalogue, &arguments::text(matches, "from"))?;
    let to = cycle::control(&catalogue, &arguments::text(matches, "to"))?;
    let form = match matches.get_one::<String>("form").map(String::as_str) {
        Some("new") => Form::New,
        Some("old") => Form::Old,
        _ => Form::AsWritten,
    };
    let books = (LabelBook::new(from, &locales), LabelBook::new(to, &locales));
    let against =
        |on, labels| Against { catalogue: &catalogue, on, labels, language: None, software: None, readers: &[] };
    let (from, to) = (against(from, &books.0), against(to, &books.1));
    let work = Work { from, to, locales: &locales, form, matches };
    let (mut errors, mut troubles) = (false, Vec::new());
    for name in &names {
        match work.convert(session, name) {
            Ok(own) => errors |= own,
            // The other files are converted all the same.
            Err(Failure::Trouble(trouble)) => troubles.push(*trouble),
            Err(failure) => return Err(failure),
        }
    }
    let last = troubles.pop();
    troubles.iter().for_each(|trouble| session.output.complain(trouble, &session.ui));
    match last {
        Some(trouble) => Err(trouble.into()),
        None => Ok(if errors { Outcome::Errors } else { Outcome::Clean }),
    }
}

/// What is done with each program.
struct Work<'a> {
    from: Against<'a>,
    to: Against<'a>,
    locales: &'a Locales,
    form: Form,
    matches: &'a ArgMatches,
}

impl Work<'_> {
    /// Converts a program and says what was found: whether there were errors.
    fn convert(&self, session: &mut Session, name: &str) -> Result<bool, Failure> {
        let in_place = self.matches.get_flag("in-place");
        let path = Path::new(name);
        if in_place && name == "-" {
            return Err(Diagnostic::global("fix-no-file").into());
        }
        let bytes = system::read(path)?;
        let seen = Seen::of(path, &bytes);
        let Decoded { text, encoding } = encoding::decode_owned(bytes);
        let source = crate::base::diag::Source::new(name, text);
        let program = syntax::parse(&source);
        let request = Request { from: self.from, to: self.to, locales: self.locales, form: self.form, encoding };
        let format = arguments::chosen_format(self.matches);
        let converted = match program.dialect() {
            Dialect::Iso => Converted::Whole(by_klartext::convert(&program, &request)),
            Dialect::Klartext if format == "json" => Converted::Whole(convert::convert(&program, &request)),
            Dialect::Klartext => Converted::long(&program, &request),
        };
        let edits = converted.edits();
        let pieces = || program::pieces(source.text(), edits.iter().map(|edit| (edit.span, edit.text.as_str())));
        let written = match self.matches.get_one::<String>("out").map(String::as_str) {
            Some(out) => Some(out),
            None => in_place.then_some(name),
        };
        if let Some(written) = written {
            program::write_pieces(Path::new(written), &seen, encoding, pieces(), &source)?;
            let args = Args::new().number("count", edits.len() as f64).text("path", written);
            let line = session.ui.text("cli-converted", &args);
            session.output.remark(&line);
        }
        match &converted {
            Converted::Whole(conversion) if format == "json" => {
                let controls = (self.from.on.id(), self.to.on.id());
                let document = json(&report(session, name, controls, conversion))?;
                session.output.print(&document)?;
                return Ok(converted.errors());
            }
            _ if written.is_none() => program::print_pieces(session, encoding, pieces(), &source)?,
            _ => {}
        }
        match &converted {
            Converted::Whole(conversion) => {
                conversion.found.iter().for_each(|found| session.output.complain(found, &session.ui));
            }
            Converted::Long { .. } => convert::each(&program, &request, &mut |step| {
                if let Step::Found(found) = step {
                    session.output.complain(&found, &session.ui);
                }
            }),
        }
        Ok(converted.errors())
    }
}

/// What a conversion gave.
enum Converted {
    Whole(Conversion),
    /// What is reported of a long program takes more room than the program: it is found once more when it is reported.
    Long {
        edits: Vec<Edit>,
        errors: bool,
    },
}

impl Converted {
    fn long(program: &Program, request: &Request<'_>) -> Self {
        let (mut edits, mut errors) = (Vec::new(), false);
        convert::each(program, request, &mut |step| match step {
            Step::Edit(edit) => edits.push(edit),
            Step::Found(found) => errors |= found.severity == Severity::Error,
        });
        Self::Long { edits, errors }
    }

    fn edits(&self) -> &[Edit] {
        match self {
            Self::Whole(conversion) => &conversion.edits,
            Self::Long { edits, .. } => edits,
        }
    }

    fn errors(&self) -> bool {
        match self {
            Self::Whole(conversion) => conversion.found.iter().any(|found| found.severity == Severity::Error),
            Self::Long { errors, .. } => *errors,
        }
    }
}

fn report<'r>(
    session: &Session<'_>,
    file: &'r str,
    controls: (&'r str, &'r str),
    conversion: &'r Conversion,
) -> Report<'r> {
    let finding = |found: &Diagnostic| {
        let start = found.place.as_ref().map(crate::base::diag::Place::start);
        Finding {
            line: start.map_or(0, |start| start.line),
            column: start.map_or(0, |start| start.column),
            severity: found.severity.as_str(),
            code: found.code,
            message: session.ui.diagnostic(found),
        }
    };
    Report {
        format: FORMAT,
        file,
        from: controls.0,
        to: controls.1,
        rewritten: conversion.edits.len(),
        findings: conversion.found.iter().map(finding).collect(),
        text: &conversion.text,
    }
}
