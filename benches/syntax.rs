//! How fast programs are parsed and checked: `cargo bench --bench syntax` prints MB/s.
use std::hint::black_box;
use std::time::{Duration, Instant};

use ciklo::check::{Against, LabelBook, check};
use ciklo::data;
use ciklo::diag::Source;
use ciklo::locale::Locales;
use ciklo::spec::Catalogue;
use ciklo::syntax::parse;

/// Long enough that start-up does not count.
const MEGABYTE: usize = 1_000_000;
const ROUNDS: u32 = 5;

const CYCLES: &str = "5 CYCL DEF 200 VRTANJE\nQ200=2 ;VARNOSTNA RAZDALJA\nQ201=-15 ;GLOBINA\nQ206=250 ;POM. PRI GLOB. PRIM.\n\
    Q202=5 ;GLOBINA PRIMIKA\nQ210=0 ;ČAS ZADRŽ. ZGORAJ\nQ203=+20 ;KOOR. POVRŠINE\nQ204=100 ;2. VARNOSTNA RAZDALJA\n\
    Q211=0.1 ;ČAS ZADRŽ. SPODAJ\n6 L X+10 Y+10 R0 FMAX M99\n7 CYCL DEF 7.0 NIČELNA TOČKA\n8 CYCL DEF 7.1 X+60\n";

fn contour() -> String {
    (0..40_000).map(|n| format!("{n} L X+{}.125 Y-{}.5 R0 F500\n", n % 97, n % 31)).collect()
}

fn repeated(unit: &str) -> String {
    let frame = "0 BEGIN PGM BENCH MM\n1 TOOL CALL 1 Z S2000\n2 L Z+100 R0 FMAX M3\n";
    frame.to_owned() + &unit.repeat(MEGABYTE / unit.len())
}

/// The best of some rounds: the others were disturbed.
fn best(mut work: impl FnMut()) -> Duration {
    let once = |work: &mut dyn FnMut()| {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    (0..ROUNDS).map(|_| once(&mut work)).min().unwrap_or_default()
}

fn main() {
    let files = data::embedded();
    let (catalogue, _) = Catalogue::load(&files);
    let (locales, _) = Locales::load(files);
    let Some(on) = catalogue.on("tnc640") else { return };
    let labels = LabelBook::new(on, &locales);
    let against = Against { catalogue: &catalogue, on, labels: &labels, language: None, readers: &[] };
    for (name, text) in [("contour", contour()), ("cycles", repeated(CYCLES))] {
        let size = text.len() as f64 / MEGABYTE as f64;
        let source = Source::new("bench.h", text);
        let parsing = best(|| drop(black_box(parse(black_box(&source)))));
        let program = parse(&source);
        let checking = best(|| drop(black_box(check(black_box(&program), &against))));
        let speed = |time: Duration| size / time.as_secs_f64();
        println!("{name:8} {size:5.1} MB   parse {:7.1} MB/s   check {:7.1} MB/s", speed(parsing), speed(checking));
    }
}
