//! Another program that is asked by lines and answers by lines, and lines from outside.
//!
//! Invariant: whatever the other program does, memory and time are bounded, and neither it nor a program that it has
//! started is left behind.
use std::io::{self, BufRead, Read as _, Write as _};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender, SyncSender};
use std::thread;
use std::time::Duration;

use super::Trouble;
use super::leftover::{self, Leftover, Made};

/// The bytes of the longest line that is taken: far more than any log or program that a case has.
pub const LONGEST_LINE: usize = 16 << 20;
/// How long a program that has closed its output may take to end by itself: how it ends is reported.
const ENDING: Duration = Duration::from_millis(50);

/// A line with its end, and no more than one byte over the limit.
fn line(input: &mut impl BufRead) -> io::Result<Vec<u8>> {
    let mut line = Vec::new();
    input.take(LONGEST_LINE as u64 + 1).read_until(b'\n', &mut line)?;
    Ok(line)
}

/// The text of a line without its end. Where it is not UTF-8 it is no JSON either, or not what was meant; both show.
fn text(line: &[u8]) -> String {
    String::from_utf8_lossy(line).trim_end_matches(['\r', '\n']).to_owned()
}

/// The next line of standard input, without its end; nothing at the end of the input. Of a line that is too long
/// nothing is left.
///
/// # Errors
/// `io-read`.
pub fn next_line() -> Result<Option<String>, Trouble> {
    line_of(&mut io::stdin().lock()).map_err(|error| Trouble::new("io-read", Path::new("-"), &error))
}

/// The next line of an input, as [`next_line`] takes them.
///
/// # Errors
/// Those of the input.
pub fn line_of(input: &mut impl BufRead) -> io::Result<Option<String>> {
    let first = line(input)?;
    if first.len() <= LONGEST_LINE || first.ends_with(b"\n") {
        return Ok((!first.is_empty()).then(|| text(&first)));
    }
    drop(first);
    loop {
        let more = line(input)?;
        if more.is_empty() || more.ends_with(b"\n") {
            return Ok(Some(String::new()));
        }
    }
}

/// Another program that answers each line by a line. It is started when it is first asked and again after it ended.
pub struct Answering {
    words: Vec<String>,
    limit: Duration,
    running: Option<Running>,
}

struct Running {
    child: Child,
    /// What ends its group with this program.
    group: Option<Leftover>,
    ask: Sender<String>,
    /// Nothing for one that is too long.
    answers: Receiver<Option<String>>,
}

impl Running {
    /// Ends the program and those that it has started.
    fn end(&mut self) -> io::Result<ExitStatus> {
        // It may have ended by itself.
        if let Some(group) = self.group.take() {
            group.end();
        }
        let _ = self.child.kill();
        self.child.wait()
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.end();
    }
}

/// Why a program gave no answer.
#[derive(Debug)]
pub enum NoAnswer {
    /// It took too long and was ended.
    TimeLimit,
    /// Its answer was longer than [`LONGEST_LINE`], and it was ended.
    TooLong,
    /// It ended or could not be started, for that reason.
    Ended(String),
}

impl Answering {
    /// The program of a command line: words with blanks between them, double quotes around words with blanks.
    pub fn new(command: &str, limit: Duration) -> Self {
        let mut words = Vec::new();
        for (index, part) in command.split('"').enumerate() {
            match index % 2 {
                1 => words.push(part.to_owned()),
                _ => words.extend(part.split_whitespace().map(str::to_owned)),
            }
        }
        Self { words, limit, running: None }
    }

    /// Starts the program, unless it runs.
    ///
    /// # Errors
    /// `engine-start` if it cannot be started.
    pub fn begin(&mut self) -> Result<(), Trouble> {
        if self.running.is_none() {
            let program = self.words.first().map_or("", String::as_str);
            let started = self.start().map_err(|error| Trouble::new("engine-start", Path::new(program), &error));
            self.running = Some(started?);
        }
        Ok(())
    }

    /// The answer to a line.
    ///
    /// # Errors
    /// There is none in time; the program was ended.
    pub fn ask(&mut self, line: &str) -> Result<String, NoAnswer> {
        let mut running = match self.running.take() {
            Some(running) => running,
            None => self.start().map_err(|error| NoAnswer::Ended(error.to_string()))?,
        };
        // A program that has ended shows when it does not answer.
        let _ = running.ask.send(format!("{line}\n"));
        match running.answers.recv_timeout(self.limit) {
            Ok(Some(answer)) => {
                self.running = Some(running);
                Ok(answer)
            }
            Ok(None) => Err(NoAnswer::TooLong),
            Err(RecvTimeoutError::Timeout) => Err(NoAnswer::TimeLimit),
            Err(RecvTimeoutError::Disconnected) => {
                thread::sleep(ENDING.min(self.limit));
                let ended = running.end().map_or_else(|error| error.to_string(), |status| status.to_string());
                Err(NoAnswer::Ended(ended))
            }
        }
    }

    fn start(&self) -> io::Result<Running> {
        let (program, words) = self.words.split_first().ok_or(io::ErrorKind::NotFound)?;
        let mut command = Command::new(program);
        command.args(words).stdin(Stdio::piped()).stdout(Stdio::piped());
        // What it starts belongs to it.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let (group, mut child) = leftover::make(|| command.spawn(), |child| Made::Group(child.id()))?;
        let (input, output) = (child.stdin.take(), child.stdout.take());
        let (ask, asked) = mpsc::channel::<String>();
        // One answer may wait; a program that writes more waits.
        let (tell, answers) = mpsc::sync_channel(1);
        // From here on whatever fails ends the program.
        let running = Running { child, group: Some(group), ask, answers };
        let (Some(input), Some(output)) = (input, output) else { return Err(io::ErrorKind::BrokenPipe.into()) };
        thread::Builder::new().spawn(move || hand_over(input, asked))?;
        thread::Builder::new().spawn(move || take_in(output, &tell))?;
        Ok(running)
    }
}

fn hand_over(mut input: ChildStdin, asked: Receiver<String>) {
    for line in asked {
        if input.write_all(line.as_bytes()).and_then(|()| input.flush()).is_err() {
            return;
        }
    }
}

fn take_in(output: ChildStdout, tell: &SyncSender<Option<String>>) {
    let mut output = io::BufReader::new(output);
    while let Ok(line) = line(&mut output) {
        let too_long = line.len() > LONGEST_LINE;
        if line.is_empty() || tell.send((!too_long).then(|| text(&line))).is_err() || too_long {
            return;
        }
    }
}
