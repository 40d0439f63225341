//! `ciklo plot`: tool path and part of a program as a drawing.
use std::path::Path;

use clap::ArgMatches;
use clap::builder::PossibleValuesParser;

use super::neighbours::Neighbours;
use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, program, run, stock};
use crate::base::diag::Source;
use crate::engine::draw::{Track, View};
use crate::engine::run::{Engine, NoTexts, Status};
use crate::engine::scene::Scene;
use crate::language::locale::{Args, Ui};
use crate::system;

pub(super) const COMMAND: Command = Command {
    name: "plot",
    usage: "FILE --control CONTROL --out FILE [--scene FILE] [--view VIEW] [--resolution MM]",
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
        arguments::valued(ui, "scene", "FILE", "cli-plot-scene"),
        view,
        stock::resolution(ui),
    ]
}

fn plot(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let catalogue = session.catalogue()?;
    let on = cycle::control(&catalogue, &arguments::text(matches, "control"))?;
    let path = arguments::text(matches, "file");
    let file = program::understand(Path::new(&path), &catalogue)?;
    let neighbours = Neighbours::new(Path::new(&path), &catalogue);
    let files = session.files()?;
    let scene = match matches.get_one::<String>("scene") {
        Some(path) => run::scene(path, &files)?,
        None => Scene::parse(&Source::new("scene", "scene: 1\n"), &files).map_err(Failure::Data)?,
    };
    let engine = Engine::new(&file.program, on, &scene, &NoTexts).with_catalogue(&catalogue).with_programs(&neighbours);
    let mut machining = stock::begin(&file, &scene, matches)?;
    let mut track = Track::default();
    let result = engine.observe(&mut |event| {
        machining.see(event);
        track.see(event, machining.stock());
    });
    let (part, _) = machining.finish();
    let view = View::by_word(matches.get_one::<String>("view").map_or("isometric", String::as_str));
    let drawing = track.draw(&part, view.unwrap_or(View::Isometric));
    let out = arguments::text(matches, "out");
    system::write(Path::new(&out), drawing.as_bytes())?;
    let line = session.ui.text("cli-written", &Args::new().text("path", out));
    session.output.remark(&line);
    if let Some(diagnostic) = result.diagnostic.clone().map(|diagnostic| file.at_home(diagnostic)) {
        let diagnostic = &diagnostic;
        session.output.complain(diagnostic, &session.ui);
    }
    neighbours.readable()?;
    Ok(match result.status {
        Status::Done | Status::Stopped => Outcome::Clean,
        Status::Error | Status::Limit | Status::Unsupported => Outcome::Errors,
    })
}
