//! `ciklo serve` as a process: pages by their addresses, the state of the translations, data that change, and its end.
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A server that ends with the test.
struct Serving {
    child: Child,
    port: u16,
}

impl Drop for Serving {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn command(root: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ciklo"));
    command.args(["--data", "."]).args(words).current_dir(root).stdin(Stdio::null()).env("LC_ALL", "C");
    command
}

/// Starts it on a port that is free, which it names in its first line.
fn serve(root: &Path, words: &[&str]) -> Serving {
    let words = [&["serve", "--port", "0"], words].concat();
    let mut child = command(root, &words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut line = String::new();
    BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut line).unwrap();
    let port = line.split("http://127.0.0.1:").nth(1).and_then(|rest| rest.split('/').next()).unwrap_or_default();
    match port.parse() {
        Ok(port) => Serving { child, port },
        Err(_) => panic!("{line}{:?}", child.wait_with_output()),
    }
}

impl Serving {
    /// What comes back for these bytes.
    fn sent(&self, bytes: &str) -> String {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(300))).unwrap();
        stream.write_all(bytes.as_bytes()).unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        String::from_utf8_lossy(&answer).into_owned()
    }

    /// Status line and headers, and what follows them.
    fn get(&self, path: &str) -> (String, String) {
        let answer = self.sent(&format!("GET {path} HTTP/1.1\r\nHost: localhost:{}\r\n\r\n", self.port));
        let (head, body) = answer.split_once("\r\n\r\n").expect("a head and what follows it");
        (head.to_owned(), body.to_owned())
    }

    fn status(&self, path: &str) -> String {
        self.get(path).0.split(' ').nth(1).unwrap().to_owned()
    }
}

/// A copy of the data.
fn copy() -> tempfile::TempDir {
    let root = tempfile::tempdir().unwrap();
    for (path, text) in ciklo::base::data::embedded() {
        let path = root.path().join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    root
}

/// The row of a table with this name, its cells separated by blanks.
fn row(page: &str, name: &str) -> String {
    let row =
        page.split("<tr").find(|row| row.contains(&format!(">{name}<"))).unwrap_or_else(|| panic!("{name}: {page}"));
    let cells = row.split("<td>").skip(1).map(|cell| cell.split('<').next().unwrap());
    cells.collect::<Vec<_>>().join(" ")
}

#[cfg(unix)]
#[test]
fn the_manual_and_the_state_of_the_translations_are_served() {
    use std::os::unix::process::ExitStatusExt as _;
    let root = copy();
    let mut serving = serve(root.path(), &["--control", "tnc426-430", "--lang", "fi"]);

    let (head, page) = serving.get("/");
    assert!(head.starts_with("HTTP/1.1 200 ") && head.contains("Content-Type: text/html; charset=utf-8"), "{head}");
    assert!(page.contains("href=\"texts/index.html\"") && page.contains("TNC 426"), "{page}");
    let (head, style) = serving.get("/assets/ciklo.css?v=1");
    assert!(head.contains("Content-Type: text/css") && style.contains(":root"), "{head}");
    assert!(head.contains(&format!("Content-Length: {}\r\n", style.len())), "{head}");
    assert!(serving.get("/tnc426-430/fi/").1.contains("<html lang=\"fi\">"));
    assert!(serving.get("/tnc426-430/fi").0.contains("\r\nLocation: /tnc426-430/fi/"));
    let head_only = serving.sent("HEAD /texts/ HTTP/1.0\r\n\r\n");
    assert!(head_only.starts_with("HTTP/1.1 200 ") && head_only.ends_with("\r\n\r\n"), "{head_only}");

    // What is not a page is nothing, whatever file of the machine it may name.
    for path in ["/nothing", "/../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/tnc640/en/", "/locales/en/site.ftl"]
    {
        let (head, page) = serving.get(path);
        assert!(head.starts_with("HTTP/1.1 404 ") && page.contains("href=\"/assets/ciklo.css\""), "{path}: {head}");
    }
    assert!(serving.sent("POST / HTTP/1.1\r\n\r\n").starts_with("HTTP/1.1 405 "));
    assert!(serving.sent("no request\r\n\r\n").starts_with("HTTP/1.1 400 "));
    assert!(serving.sent(&format!("GET /{} HTTP/1.1\r\n\r\n", "a".repeat(20_000))).starts_with("HTTP/1.1 400 "));
    assert!(serving.sent("GET / HTTP/1.1\r\nHost: elsewhere.example\r\n\r\n").starts_with("HTTP/1.1 421 "));

    // A text that is taken away is missing in its file, and the pages know it as soon as they are asked for again.
    let before = row(&serving.get("/texts/").1, "suomi");
    let file = root.path().join("locales/fi/measuring.ftl");
    let text = std::fs::read_to_string(&file).unwrap();
    let line = text.lines().find(|line| line.starts_with("say-no-log = ")).unwrap();
    std::fs::write(&file, text.replace(&format!("{line}\n"), "")).unwrap();
    std::thread::sleep(Duration::from_millis(400));
    let after = row(&serving.get("/texts/").1, "suomi");
    let missing = |row: &str| row.split(' ').nth(3).unwrap().parse::<usize>().unwrap();
    assert_eq!(missing(&after), missing(&before) + 1, "{before} → {after}");
    let page = serving.get("/texts/fi.html").1;
    assert_eq!(missing(&row(&page, "measuring.ftl")), 1);
    assert_eq!(missing(&row(&page, "Workpiece measurement")), 1);
    assert!(page.contains("<code>say-no-log</code>"), "{page}");

    // A page of the manual that lacks a text is not shown.
    let (head, said) = serving.get("/");
    assert!(head.starts_with("HTTP/1.1 500 ") && said.contains("say-no-log"), "{head} {said}");

    // Data that cannot be read are said instead of pages, until they are mended.
    std::fs::write(&file, format!("{text}\nthis is no text\n")).unwrap();
    std::thread::sleep(Duration::from_millis(400));
    let (head, said) = serving.get("/");
    assert!(head.starts_with("HTTP/1.1 500 ") && said.contains("locales/fi/measuring.ftl:"), "{head} {said}");
    std::fs::write(&file, &text).unwrap();
    std::thread::sleep(Duration::from_millis(400));
    assert_eq!(serving.status("/"), "200");

    // Another one cannot have the port.
    let second = command(root.path(), &["serve", "--port", &serving.port.to_string()]).output().unwrap();
    assert_eq!(second.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&second.stderr).contains("error[serve-address]"), "{second:?}");

    // A client that says nothing keeps nobody waiting, and a signal ends it.
    let silent = TcpStream::connect(("127.0.0.1", serving.port)).unwrap();
    assert_eq!(serving.status("/texts/"), "200");
    assert!(Command::new("kill").arg(serving.child.id().to_string()).status().unwrap().success());
    let ended = serving.child.wait().unwrap();
    assert_eq!((ended.code(), ended.signal()), (Some(0), None));
    drop(silent);
}
