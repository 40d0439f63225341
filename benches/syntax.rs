//! How fast programs are parsed, checked and edited, and how much memory they take: `cargo bench --bench syntax`.
//!
//! Times are those that the thread had a core for, where the system tells (Linux), so other work on the machine counts
//! little. The plain scan looks for the ends of lines and nothing else.
use std::fs;
use std::hint::black_box;
use std::time::{Duration, Instant};

use ciklo::base::data;
use ciklo::base::diag::{Source, Span};
use ciklo::check::{Against, LabelBook, check};
use ciklo::language::locale::Locales;
use ciklo::program::layout::laid_out;
use ciklo::program::syntax::encoding::{Charset, Encoding};
use ciklo::program::syntax::{Document, parse};
use ciklo::spec::Catalogue;
use ciklo::tools::compare::compare;
use ciklo::tools::translate::replacing;

const MEGABYTE: usize = 1_000_000;
const ROUNDS: u32 = 9;
/// Blocks of the long program, and edits of it.
const LONG: usize = 100_000;
const EDITS: u32 = 1000;
/// Plain scans that are measured together: the core time is counted in steps that are longer than one.
const SCANS: u32 = 50;

const CYCLES: &str = "5 CYCL DEF 200 VRTANJE\nQ200=2 ;VARNOSTNA RAZDALJA\nQ201=-15 ;GLOBINA\nQ206=250 ;POM. PRI GLOB. PRIM.\n\
    Q202=5 ;GLOBINA PRIMIKA\nQ210=0 ;ČAS ZADRŽ. ZGORAJ\nQ203=+20 ;KOOR. POVRŠINE\nQ204=100 ;2. VARNOSTNA RAZDALJA\n\
    Q211=0.1 ;ČAS ZADRŽ. SPODAJ\n6 L X+10 Y+10 R0 FMAX M99\n7 CYCL DEF 7.0 NIČELNA TOČKA\n8 CYCL DEF 7.1 X+60\n";

fn contour(blocks: usize) -> String {
    let head = "0 BEGIN PGM BENCH MM\n1 TOOL CALL 1 Z S2000 F500\n2 L Z+100 R0 FMAX M3\n".to_owned();
    let line = |n: usize| format!("{n} L X+{}.125 Y-{}.5 R0 F500\n", n % 97, n % 31);
    head + &(3..blocks).map(line).collect::<String>() + "9 END PGM BENCH MM\n"
}

fn repeated(unit: &str) -> String {
    let frame = "0 BEGIN PGM BENCH MM\n1 TOOL CALL 1 Z S2000\n2 L Z+100 R0 FMAX M3\n";
    frame.to_owned() + &unit.repeat(16 * MEGABYTE / unit.len())
}

/// Nanoseconds that this thread had a core for.
fn on_core() -> Option<Duration> {
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    told.split_whitespace().next()?.parse().ok().map(Duration::from_nanos)
}

/// The best of some rounds: the others were disturbed.
fn best(mut work: impl FnMut()) -> Duration {
    let once = |work: &mut dyn FnMut()| {
        let (start, before) = (Instant::now(), on_core());
        work();
        on_core().zip(before).map_or_else(|| start.elapsed(), |(now, before)| now - before)
    };
    (0..ROUNDS).map(|_| once(&mut work)).min().unwrap_or_default()
}

/// Bytes of memory that the process has, if the system tells.
fn memory() -> Option<f64> {
    let told = fs::read_to_string("/proc/self/status").ok()?;
    let line = told.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.split_whitespace().next()?.parse().ok().map(|kilobytes: f64| kilobytes * 1024.0)
}

/// The most memory that the process has had, if the system tells; from now on it is counted anew.
fn peak() -> Option<f64> {
    let told = fs::read_to_string("/proc/self/status").ok()?;
    let line = told.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: f64 = line.split_whitespace().next()?.parse().ok()?;
    fs::write("/proc/self/clear_refs", "5").ok()?;
    Some(kilobytes * 1024.0)
}

fn main() {
    let files = data::embedded();
    let (catalogue, _) = Catalogue::load(&files);
    let (locales, _) = Locales::load(files);
    let Some(on) = catalogue.on("tnc640") else { return };
    let labels = LabelBook::new(on, &locales);
    let against = Against { catalogue: &catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
    // Each text is parsed and checked once before anything is measured twice: memory that was given back is used again.
    let texts = || [("contour", contour(500_000)), ("cycles", repeated(CYCLES))];
    for (name, text) in texts() {
        let size = text.len() as f64;
        let (before, _) = (memory(), peak());
        let source = Source::new("long.h", text);
        let program = parse(&source);
        let (parsed, _) = (memory(), peak());
        let found = check(&program, &against).len();
        let most = peak();
        if let (Some(before), Some(parsed), Some(most)) = (before, parsed, most) {
            let times = |now: f64| 1.0 + (now - before) / size;
            let (megabytes, tree, all) = (size / MEGABYTE as f64, times(parsed), times(most));
            println!(
                "{name:8} {megabytes:5.1} MB   memory parsed {tree:.1}, while checking {all:.1} times the text ({found} findings)"
            );
            // The most of each, the tree and the text included; what is made is dropped again.
            let most = |work: &dyn Fn()| {
                peak();
                work();
                peak().map_or(f64::NAN, times)
            };
            let laid_out = most(&|| drop(black_box(laid_out(&program))));
            let compared = most(&|| drop(black_box(compare(&program, &program, &against))));
            let encoding = Encoding { charset: Charset::Utf8, bom: false };
            let translated = most(&|| {
                black_box(replacing(&program, &against, "en", encoding, true, |all| all.count()));
            });
            println!(
                "{name:8} {megabytes:5.1} MB   memory while laying out {laid_out:.1}, comparing {compared:.1}, translating {translated:.1} times the text"
            );
        }
    }
    for (name, text) in texts() {
        let size = text.len() as f64 / MEGABYTE as f64;
        let speed = |time: Duration| size / time.as_secs_f64();
        let scans = || {
            (0..SCANS).for_each(|_| {
                black_box(black_box(&text).lines().count());
            })
        };
        let scan = speed(best(scans) / SCANS);
        let source = Source::new("bench.h", text.as_str());
        let parsing = speed(best(|| drop(black_box(parse(black_box(&source))))));
        let program = parse(&source);
        // Checking keeps nothing in a program, so each round does the same.
        let checking = speed(best(|| drop(black_box(check(black_box(&program), &against)))));
        let both = speed(best(|| {
            let source = Source::new("bench.h", black_box(&text).as_str());
            black_box(check(&parse(&source), &against));
        }));
        let share = parsing / scan * 100.0;
        println!(
            "{name:8} {size:5.1} MB   parse {parsing:7.1} MB/s ({share:.1} % of a plain line scan)   check {checking:7.1} MB/s   both {both:7.1} MB/s"
        );
    }
    let mut document = Document::new("long.h", &contour(LONG));
    let middle = document.pieces().nth(document.pieces().count() / 2).map_or(0, |piece| piece.start);
    let time = best(|| {
        for round in 0..EDITS {
            let line = format!("L X+{round}\n");
            document.edit(Span::new(middle, middle), &line);
            document.edit(Span::new(middle, middle + line.len()), "");
        }
    });
    println!("edit     {LONG} blocks   {:.1} microseconds a change", time.as_secs_f64() * 1e6 / f64::from(2 * EDITS));
}
