//! What each command costs on a small program as a whole process: time, and the most memory that it held.
//!
//! `cargo bench --bench start`; a word after `--` chooses the commands with it in their line, a number how often each
//! is run. Memory is read from `/proc`, so it is shown on Linux only.
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, thread};

/// Command lines, a line each.
const COMMANDS: &str = "\
--help
explain spindle-off
parse examples/hole.h
check examples/hole.h --control tnc640
check examples/hole.h --control tnc640 --ui-lang fi
run examples/hole.h --control tnc640 --scene examples/hole.scene.yaml
run examples/hole.h --control tnc640 --scene examples/hole.scene.yaml --events
translate examples/hole.h --to it
convert examples/hole.h --to-iso
convert examples/hole.h --from tnc640 --to itnc530
fmt --check examples/hole.h
compare examples/hole.h examples/hole.h --control tnc640
dialog 412 --control tnc640 --lang fi
block 412 Q321=50 Q322=50 --control tnc640 --lang sl";

/// How often a command is run without another wish.
const TIMES: usize = 20;

fn main() {
    let words: Vec<String> = env::args().skip(1).filter(|word| !word.starts_with("--")).collect();
    let times = words.iter().find_map(|word| word.parse().ok()).unwrap_or(TIMES).max(1);
    let wanted: Vec<&String> = words.iter().filter(|word| word.parse::<usize>().is_err()).collect();
    println!("{:>10} {:>10} {:>10}  command", "median ms", "least ms", "MiB");
    for line in COMMANDS.lines().filter(|line| wanted.iter().all(|word| line.contains(*word))) {
        let mut all: Vec<Duration> = (0..times).map(|_| time(line)).collect();
        all.sort();
        let milliseconds = |at: usize| all.get(at).map_or(0.0, |time| time.as_secs_f64() * 1e3);
        let memory = memory(line).map_or("?".to_owned(), |kib| format!("{:.1}", kib / 1024.0));
        println!("{:10.1} {:10.1} {memory:>10}  {line}", milliseconds(times / 2), milliseconds(0));
    }
}

fn command(line: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ciklo"));
    command.args(line.split(' ')).current_dir(env!("CARGO_MANIFEST_DIR"));
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

fn time(line: &str) -> Duration {
    let start = Instant::now();
    command(line).status().expect("it runs");
    start.elapsed()
}

/// The most memory that a run of the command held, in KiB: looked up again and again, the last look counts.
fn memory(line: &str) -> Option<f64> {
    let peak = || {
        let mut child = command(line).spawn().expect("it runs");
        let status = Path::new("/proc").join(child.id().to_string()).join("status");
        let mut most = None;
        while child.try_wait().ok()?.is_none() {
            let text = fs::read_to_string(&status).unwrap_or_default();
            let held = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
            most = held.and_then(|held| held.trim().trim_end_matches(" kB").parse().ok()).or(most);
            thread::sleep(Duration::from_micros(50));
        }
        most
    };
    (0..5).filter_map(|_| peak()).reduce(f64::max)
}
