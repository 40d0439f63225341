//! `ciklo serve`: the manuals and the state of the translations in a browser, made anew when the data change.
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use clap::{ArgMatches, value_parser};

use super::build::Data;
use super::progress::Progress;
use super::session::{self, Session};
use super::{Command, Failure, Outcome, arguments};
use crate::base::diag::Diagnostic;
use crate::language::consistency;
use crate::language::locale::{Args, SOURCE_LANGUAGE, Ui};
use crate::system::{Asked, Server, Status};
use crate::tools::exchange;

pub(super) const COMMAND: Command = Command {
    name: "serve",
    usage: "[--port PORT] [--control CONTROL]… [--lang LANG]… [--draft]",
    arguments: own,
    run,
};

/// The port if none is asked for.
const PORT: u16 = 8477;
/// Within this time the data are not looked at again: a page asks for several files at once.
const PAUSE: Duration = Duration::from_millis(300);
/// The page that is shown where there is none.
const MISSING: &str = "404.html";
const INDEX: &str = "index.html";
const ASSETS: &str = "assets/";
const PLAIN: &str = "text/plain; charset=utf-8";
/// Types of files by their endings.
const KINDS: [(&str, &str); 7] = [
    ("html", "text/html; charset=utf-8"),
    ("css", "text/css; charset=utf-8"),
    ("js", "text/javascript; charset=utf-8"),
    ("json", "application/json"),
    ("csv", "text/csv; charset=utf-8"),
    ("svg", "image/svg+xml"),
    ("xml", "application/xml"),
];

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::valued(ui, "port", "PORT", "cli-serve-port").value_parser(value_parser!(u16)),
        arguments::several(ui, "control", "CONTROL", "cli-build-control"),
        arguments::several(ui, "lang", "LANG", "cli-build-lang"),
        arguments::switch(ui, "draft", "cli-build-draft"),
    ]
}

/// The files of the site by their paths.
type Pages = BTreeMap<String, Vec<u8>>;

/// What there is to be served.
#[derive(Default)]
struct Made {
    pages: Pages,
    /// Why the pages of the manual are not among them.
    faults: Option<String>,
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let server = Server::new(matches.get_one::<u16>("port").copied().unwrap_or(PORT))?;
    let mut state = session.state_of_data();
    let mut made = make(session, matches)?;
    let line = session.ui.text("cli-serve-address", &Args::new().text("address", server.address()));
    session.output.print(&format!("{line}\n"))?;
    session.output.finish()?;
    let mut looked = Instant::now();
    while let Some(asked) = server.next() {
        if looked.elapsed() >= PAUSE {
            let now = session.state_of_data();
            if now != state {
                state = now;
                session.forget();
                made = make(session, matches)
                    .unwrap_or_else(|failure| Made { faults: Some(faults(session, failure)), ..Made::default() });
                let count = if made.faults.is_none() { made.pages.len() } else { 0 };
                let line = session.ui.text("cli-serve-anew", &Args::new().number("files", count as f64));
                session.output.remark(&line);
            }
            looked = Instant::now();
        }
        answer(asked, &made);
    }
    Ok(Outcome::Clean)
}

/// Makes the site and the pages about the translations; only these where a text is missing on a page.
fn make(session: &mut Session, matches: &ArgMatches) -> Result<Made, Failure> {
    let data = Data::of(session, matches)?;
    let mut site = data.site(None)?;
    site.mark_as_served();
    let pages = Mutex::new(Pages::new());
    let progress = Progress::new(session.ui.text("cli-building", &Args::new()), site.pages());
    let put = |path: &str, bytes: &[u8]| {
        progress.step();
        pages.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_owned(), bytes.to_owned());
        Ok(())
    };
    let written = site.write(&put).map_err(session::in_texts(&data.locales));
    drop(progress);
    let mut pages = pages.into_inner().unwrap_or_else(PoisonError::into_inner);
    let faults = written.err().map(|failure| faults(session, failure));
    if faults.is_some() {
        pages.retain(|path, _| path.starts_with(ASSETS));
    }
    let meanings = consistency::meanings(&data.catalogue);
    let tags = data.locales.tags().filter(|tag| *tag != SOURCE_LANGUAGE);
    let pseudo = session.pseudo().map(|kind| kind.tag());
    let status = |tag| exchange::status(&data.catalogue, &data.locales, &meanings, tag);
    let all = tags.filter(|tag| Some(*tag) != pseudo).map(status).collect::<Result<Vec<_>, _>>()?;
    let about = site.state_pages(session.ui.tag(), &all).map_err(session::in_texts(&data.locales))?;
    pages.extend(about.into_iter().map(|(path, text)| (path, text.into_bytes())));
    Ok(Made { pages, faults })
}

/// Why there is no site at the moment, as the terminal shows it and the browser as well.
fn faults(session: &mut Session, failure: Failure) -> String {
    let found: Vec<Diagnostic> = match failure {
        Failure::Trouble(one) => vec![*one],
        Failure::Data(all) => all,
    };
    found.iter().for_each(|one| session.output.complain(one, &session.ui));
    found.iter().map(|one| crate::language::locale::render::render(one, &session.ui, false) + "\n").collect()
}

fn answer(asked: Asked, made: &Made) {
    let pages = &made.pages;
    let path = decoded(asked.path.trim_start_matches('/'));
    let whole = if path.is_empty() || path.ends_with('/') { format!("{path}{INDEX}") } else { path };
    if let Some(bytes) = pages.get(&whole) {
        return asked.answer(Status::Found, kind(&whole), bytes);
    }
    // Links of an overview lead on only from its folder.
    if pages.contains_key(&format!("{whole}/{INDEX}")) {
        let folder = format!("/{whole}/");
        return asked.send_to(&folder);
    }
    if let Some(faults) = &made.faults {
        return asked.answer(Status::Faulty, PLAIN, faults.as_bytes());
    }
    let missing = pages.get(MISSING).map_or(&[][..], Vec::as_slice);
    asked.answer(Status::Missing, kind(MISSING), missing);
}

fn kind(path: &str) -> &'static str {
    let ending = path.rsplit_once('.').map_or("", |(_, ending)| ending);
    KINDS.iter().find(|(own, _)| *own == ending).map_or("application/octet-stream", |(_, kind)| kind)
}

/// A path with `%20` and the like as what it stands for; as it is where that is no text.
fn decoded(path: &str) -> String {
    let mut bytes = Vec::with_capacity(path.len());
    let mut rest = path.as_bytes();
    while let Some((first, after)) = rest.split_first() {
        let digits = after.get(..2).and_then(|digits| std::str::from_utf8(digits).ok());
        let byte = digits.filter(|_| *first == b'%').and_then(|digits| u8::from_str_radix(digits, 16).ok());
        bytes.push(byte.unwrap_or(*first));
        rest = if byte.is_some() { after.get(2..).unwrap_or_default() } else { after };
    }
    String::from_utf8(bytes).unwrap_or_else(|_| path.to_owned())
}
