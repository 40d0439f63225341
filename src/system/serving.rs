//! A small server of files in memory, for browsers on this machine.
//!
//! Invariant: it listens on the loopback address only, answers GET and HEAD only, and looks at no file: what an address
//! means is for the one who answers. Whatever a client sends, or does not send, memory and time are bounded.
use std::io::{self, Read as _, Write as _};
use std::net::{Ipv4Addr, Shutdown, SocketAddr, TcpListener, TcpStream};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;
use std::time::{Duration, Instant};

use super::Trouble;

/// The bytes of the longest request, without what follows its head.
const LONGEST_HEAD: usize = 16 << 10;
/// Lines in the head of a request.
const MOST_LINES: usize = 64;
/// How long a client may take to send a request, and to take the answer or a part of it.
const PATIENCE: Duration = Duration::from_secs(10);
/// So many clients are heard at a time; browsers open a few connections each.
const MOST_CLIENTS: usize = 64;
/// Names of this machine in the addresses of its server. Under another name, a foreign page would be asking.
const OWN_NAMES: [&str; 2] = ["localhost", "127.0.0.1"];

/// What comes of a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Here it is.
    Found,
    /// It has another address.
    Moved,
    /// What was sent is no request.
    Malformed,
    /// There is nothing of this address.
    Missing,
    /// Only GET and HEAD are answered.
    WrongMethod,
    /// The request was for another machine.
    WrongHost,
    /// It cannot be made.
    Faulty,
}

impl Status {
    const fn line(self) -> (u16, &'static str) {
        match self {
            Self::Found => (200_u16, "OK"),
            Self::Moved => (301_u16, "Moved Permanently"),
            Self::Malformed => (400_u16, "Bad Request"),
            Self::Missing => (404_u16, "Not Found"),
            Self::WrongMethod => (405_u16, "Method Not Allowed"),
            Self::WrongHost => (421_u16, "Misdirected Request"),
            Self::Faulty => (500_u16, "Internal Server Error"),
        }
    }
}

/// What a client asks for.
#[derive(Debug)]
pub struct Asked {
    /// The path of the address as it was sent, with what is written as `%20`, without a question after it.
    pub path: String,
    only_head: bool,
    stream: TcpStream,
    _place: Place,
}

impl Asked {
    /// Answers with these bytes of this type. A client that has gone away is not missed.
    pub fn answer(self, status: Status, kind: &str, bytes: &[u8]) {
        let _ = respond(&self.stream, status, &[("Content-Type", kind)], bytes, self.only_head);
    }

    /// Answers that it is at another path.
    pub fn send_to(self, path: &str) {
        let _ = respond(&self.stream, Status::Moved, &[("Location", path)], b"", self.only_head);
    }
}

enum Event {
    Asked(Asked),
    End,
}

/// A server that listens.
#[derive(Debug)]
pub struct Server {
    address: SocketAddr,
    events: Receiver<Event>,
}

impl Server {
    /// Begins to listen on a port of this machine; on any that is free for 0.
    ///
    /// # Errors
    /// `serve-address` if the port is used already or not permitted.
    pub fn new(port: u16) -> Result<Self, Trouble> {
        let wanted = SocketAddr::from((Ipv4Addr::LOCALHOST, port));
        let trouble = |error: io::Error| {
            let trouble = Trouble::new("serve-address", Path::new(&wanted.to_string()), &error);
            let is_used = error.kind() == io::ErrorKind::AddrInUse;
            if is_used { Trouble { reason: "in-use", ..trouble } } else { trouble }
        };
        let listener = TcpListener::bind(wanted).map_err(trouble)?;
        let address = listener.local_addr().map_err(trouble)?;
        let (tell, events) = mpsc::channel();
        listen_for_the_end(&tell).map_err(trouble)?;
        thread::Builder::new().spawn(move || accept(&listener, &tell)).map_err(trouble)?;
        Ok(Self { address, events })
    }

    /// The address of what it serves: `http://127.0.0.1:8477/`.
    pub fn address(&self) -> String {
        format!("http://{}/", self.address)
    }

    /// The next request; nothing when the program is asked to end. It waits.
    pub fn next(&self) -> Option<Asked> {
        match self.events.recv() {
            Ok(Event::Asked(asked)) => Some(asked),
            Ok(Event::End) | Err(_) => None,
        }
    }
}

/// Counts the clients that are heard.
#[derive(Debug)]
struct Place(Arc<AtomicUsize>);

impl Drop for Place {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}

fn accept(listener: &TcpListener, tell: &Sender<Event>) {
    let clients = Arc::new(AtomicUsize::new(0));
    for stream in listener.incoming() {
        let Ok(stream) = stream else {
            // The system has nothing left for another connection: it may have later.
            thread::sleep(Duration::from_millis(50));
            continue;
        };
        let before = clients.fetch_add(1, Ordering::Relaxed);
        let place = Place(Arc::clone(&clients));
        if before >= MOST_CLIENTS {
            continue;
        }
        let tell = tell.clone();
        // Where no thread can be had, the client is turned away.
        let _ = thread::Builder::new().spawn(move || hear(stream, place, &tell));
    }
}

/// Reads the request of a client and hands it over, or says why it is none.
fn hear(stream: TcpStream, place: Place, tell: &Sender<Event>) {
    let patience = Some(PATIENCE);
    if stream.set_read_timeout(patience).and_then(|()| stream.set_write_timeout(patience)).is_err() {
        return;
    }
    match read(&stream) {
        Ok(Some((path, only_head))) => {
            // Nobody listens any more when the program ends.
            let _ = tell.send(Event::Asked(Asked { path, only_head, stream, _place: place }));
        }
        Ok(None) => {}
        Err(status) => {
            let headers: &[_] = if status == Status::WrongMethod { &[("Allow", "GET, HEAD")] } else { &[] };
            let _ = respond(&stream, status, headers, b"", false);
        }
    }
}

/// The path that is asked for, and whether only the head of the answer is; nothing if the client says nothing.
fn read(mut stream: &TcpStream) -> Result<Option<(String, bool)>, Status> {
    let begun = Instant::now();
    let mut bytes = Vec::new();
    let mut part = [0; 4096];
    loop {
        let count = match stream.read(&mut part) {
            Ok(0) | Err(_) if bytes.is_empty() => return Ok(None),
            Ok(0) | Err(_) => return Err(Status::Malformed),
            Ok(count) => count,
        };
        bytes.extend(part.get(..count).unwrap_or_default());
        let mut lines = [httparse::EMPTY_HEADER; MOST_LINES];
        let mut request = httparse::Request::new(&mut lines);
        match request.parse(&bytes) {
            Ok(httparse::Status::Complete(_)) => return asked(&request).map(Some),
            Ok(httparse::Status::Partial) if bytes.len() < LONGEST_HEAD && begun.elapsed() < PATIENCE => {}
            _ => return Err(Status::Malformed),
        }
    }
}

fn asked(request: &httparse::Request) -> Result<(String, bool), Status> {
    let only_head = match request.method {
        Some("GET") => false,
        Some("HEAD") => true,
        _ => return Err(Status::WrongMethod),
    };
    let host = request.headers.iter().find(|line| line.name.eq_ignore_ascii_case("host"));
    if let Some(host) = host {
        let name = std::str::from_utf8(host.value).unwrap_or_default();
        let name = name.rsplit_once(':').map_or(name, |(name, _)| name);
        if !OWN_NAMES.iter().any(|own| own.eq_ignore_ascii_case(name)) {
            return Err(Status::WrongHost);
        }
    }
    let target = request.path.unwrap_or_default();
    let path = target.split(['?', '#']).next().unwrap_or_default();
    if path.starts_with('/') { Ok((path.to_owned(), only_head)) } else { Err(Status::Malformed) }
}

fn respond(
    mut stream: &TcpStream,
    status: Status,
    headers: &[(&str, &str)],
    bytes: &[u8],
    only_head: bool,
) -> io::Result<()> {
    let (number, words) = status.line();
    let mut head = format!("HTTP/1.1 {number} {words}\r\nContent-Length: {}\r\n", bytes.len());
    for (name, value) in headers {
        head += &format!("{name}: {value}\r\n");
    }
    // A page may have changed when it is asked for again.
    head += "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n";
    stream.write_all(head.as_bytes())?;
    if !only_head {
        stream.write_all(bytes)?;
    }
    stream.flush()?;
    stream.shutdown(Shutdown::Write)
}

/// The first signal to end is told to the one who answers, the second one ends the program at once.
#[cfg(unix)]
fn listen_for_the_end(tell: &Sender<Event>) -> io::Result<()> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    let heard = [SIGHUP, SIGINT, SIGTERM].into_iter().filter(|signal| !super::leftover::is_ignored(*signal));
    let mut signals = signal_hook::iterator::Signals::new(heard)?;
    let tell = tell.clone();
    thread::Builder::new().spawn(move || {
        let mut is_told = false;
        for signal in signals.forever() {
            if is_told || tell.send(Event::End).is_err() {
                let _ = signal_hook::low_level::emulate_default_handler(signal);
            }
            is_told = true;
        }
    })?;
    Ok(())
}

/// Elsewhere the system ends the program.
#[cfg(not(unix))]
fn listen_for_the_end(_: &Sender<Event>) -> io::Result<()> {
    Ok(())
}
