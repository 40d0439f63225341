//! `ciklo plot`: tool path and part of a program as a drawing.
use std::path::Path;

use clap::ArgMatches;
use clap::builder::PossibleValuesParser;

use super::execution::{self, Execution};
use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, stock};
use crate::engine::stock::Blank;
use crate::language::locale::{Args, Ui};
use crate::output::figure::{Legend, Plot, View};
use crate::system;
use crate::tools::conform::LogTexts;

pub(super) const COMMAND: Command = Command {
    name: "plot",
    usage: "FILE --control CONTROL --out FILE [--scene FILE] [--tool-table FILE] [--view VIEW] [--resolution MM]",
    arguments: own,
    run: plot,
};

const VIEWS: [&str; 3] = ["isometric", "top", "side"];

fn own(ui: &Ui) -> Vec<clap::Arg> {
    let view = arguments::valued(ui, "view", "VIEW", "cli-plot-view");
    let view = view.value_parser(PossibleValuesParser::new(VIEWS)).hide_possible_values(true);
    vec![
        arguments::file(ui),
        arguments::control(ui),
        arguments::valued(ui, "out", "FILE", "cli-plot-out").required(true),
        arguments::valued(ui, "scene", "FILE", "cli-run-scene"),
        execution::tool_table(ui),
        view,
        stock::resolution(ui),
    ]
}

fn plot(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let execution = Execution::new(session, &catalogue, matches)?;
    let scene = execution.scene(session, matches)?;
    let language = cycle::language(&locales, session.ui.tag())?;
    let texts = LogTexts::new(language, execution.on.id(), &execution.files);
    let engine = execution.engine(&scene, &texts);
    let file = &execution.file;
    let mut part = stock::begin_if_any(file, &scene, matches)?;
    let (mut drawing, mut failed) = (Plot::new(&file.program, &scene), None);
    let result = engine.observe(&mut |event| {
        failed = execution::failed(event).or(failed);
        if let Some(machining) = &mut part {
            machining.see(event);
        }
        drawing.see(event);
    });
    let part = part.map(|machining| machining.finish().0);
    if part.is_none() && Blank::of_parts(&scene).is_none() {
        session.output.remark(&session.ui.text("cli-plot-no-blank", &Args::new()));
    }
    let view = View::by_word(matches.get_one::<String>("view").map_or("isometric", String::as_str));
    let word = |id: &str| session.ui.text(id, &Args::new());
    let title =
        Path::new(&arguments::text(matches, "file")).file_name().map(|name| name.to_string_lossy().into_owned());
    let legend = Legend { title: title.unwrap_or_default(), ways: ["way-rapid", "way-feed", "way-probing"].map(word) };
    let drawing = drawing.draw(part.as_ref(), view.unwrap_or(View::Isometric), &legend);
    let out = arguments::text(matches, "out");
    system::write(Path::new(&out), drawing.as_bytes())?;
    let line = session.ui.text("cli-written", &Args::new().text("path", out));
    session.output.remark(&line);
    execution.end(session, &locales, &result, failed)
}
