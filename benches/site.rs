//! Prints how fast specifications load and how many pages a second the manual is written at.
//! `cargo bench --bench site`; nothing is judged here.
use std::time::{Duration, Instant};

use ciklo::base::data;
use ciklo::language::locale::Locales;
use ciklo::output::manual::{Request, Site};
use ciklo::spec::Catalogue;

/// How long each figure is measured.
const SPAN: Duration = Duration::from_secs(2);

/// Runs `work` again and again for the span; seconds for one run.
fn seconds(mut work: impl FnMut()) -> f64 {
    work();
    let start = Instant::now();
    let mut runs = 0_u32;
    while start.elapsed() < SPAN {
        work();
        runs += 1;
    }
    start.elapsed().as_secs_f64() / f64::from(runs)
}

fn main() {
    let files = data::embedded();
    let load = seconds(|| drop(Catalogue::load(&files)));
    println!("specifications loaded: {:.1} ms", load * 1e3);
    let texts = || Locales::load(files.iter().map(|(path, text)| (path, text)));
    println!("locales loaded: {:.1} ms", seconds(|| drop(texts())) * 1e3);

    let (catalogue, _) = Catalogue::load(&files);
    let (locales, _) = texts();
    let request = Request {
        catalogue: &catalogue,
        locales: &locales,
        files: &files,
        controls: &[],
        languages: &[],
        base_url: None,
    };
    let site = match Site::new(&request) {
        Ok(site) => site,
        Err(found) => {
            println!("the manual cannot be built: {} findings; see `ciklo lint`", found.len());
            return;
        }
    };
    let write = seconds(|| drop(site.write(&|_, _| Ok(()))));
    println!("manual: {} pages in {:.1} ms, {:.0} pages/s", site.pages(), write * 1e3, site.pages() as f64 / write);
}
