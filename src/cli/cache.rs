//! What is known of programs that were checked before, in the user's cache directory.
//!
//! An entry is known by everything that findings depend on: the bytes of the program, the dialect that its name is
//! for, the control, the language of its labels and of the reader, the version and data of this program. Invariant: a
//! cache that cannot be read, or not wholly, is as good as none, and what it says is what checking again would say; it
//! never makes a command fail.
use std::collections::{BTreeSet, HashMap};
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use serde_json::{Value, json};
use sha2::{Digest as _, Sha256};

use crate::base::data;
use crate::base::diag::{Arg, Diagnostic, Edit, Place, Severity, Source, Span, interned};
use crate::program::syntax::Dialect;
use crate::system;

/// So many programs are worth a cache.
pub(super) const LEAST: usize = 16;
/// How many entries are kept.
const MOST: usize = 100_000;
/// How many bytes they have together at most.
const MOST_BYTES: usize = 32 << 20;
/// How many bytes an entry has at most: a program with more findings is being worked on.
const LONGEST: usize = 16 << 10;
const FILE: &str = "check.cache";
/// The first line of the file.
const HEAD: &str = "ciklo-check-cache/2";
/// So many hexadecimal digits of the digest of an entry precede it.
const DIGEST: usize = 32;

/// The entries of earlier runs, and those of this one.
pub(super) struct Cache {
    file: PathBuf,
    /// What all entries of this run share.
    salt: u64,
    known: HashMap<u128, String>,
    fresh: Mutex<Vec<(u128, String)>>,
}

impl Cache {
    /// The cache of this user; nothing if there is no place for it, or something else is there.
    pub(super) fn open(reader: &str) -> Option<Self> {
        let file = system::cache_directory()?.join(FILE);
        if system::is_no_file(&file) {
            return None;
        }
        let mut hasher = DefaultHasher::new();
        (env!("CARGO_PKG_VERSION"), reader).hash(&mut hasher);
        for (path, text) in data::embedded() {
            (path, text).hash(&mut hasher);
        }
        // A larger one was not written here.
        let ours = system::size(&file).is_some_and(|size| size <= 2 * MOST_BYTES as u64);
        let bytes = ours.then(|| system::read(&file).ok()).flatten();
        let text = bytes.and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default();
        let mut lines = text.lines();
        let mut known = HashMap::new();
        if lines.next() == Some(HEAD) {
            for (key, found) in lines.filter_map(|line| line.split_once(' ')) {
                if let Ok(key) = u128::from_str_radix(key, 16) {
                    known.insert(key, found.to_owned());
                }
            }
        }
        Some(Self { file, salt: hasher.finish(), known, fresh: Mutex::default() })
    }

    /// The key of a program with what it is checked by.
    pub(super) fn key(&self, path: &Path, bytes: &[u8], control: &str, language: Option<&str>) -> u128 {
        let of_kind = Dialect::of_name(&path.to_string_lossy()) == Dialect::Iso;
        let half = |which: u8| {
            let mut hasher = DefaultHasher::new();
            (which, self.salt, of_kind, control, language, bytes).hash(&mut hasher);
            u128::from(hasher.finish())
        };
        (half(0) << 64) | half(1)
    }

    /// What was found in it, with the places in its text; nothing if that is not known.
    pub(super) fn find(&self, key: u128, source: impl FnOnce() -> Arc<Source>) -> Option<Vec<Diagnostic>> {
        let found = entry(key, self.known.get(&key)?)?;
        if found == "[]" {
            return Some(Vec::new());
        }
        let found: Value = serde_json::from_str(found).ok()?;
        let source = source();
        found.as_array()?.iter().map(|entry| read(entry, &source)).collect()
    }

    /// Keeps what was found.
    pub(super) fn keep(&self, key: u128, found: &[Diagnostic]) {
        if let Some(written) = found.iter().map(written).collect::<Option<Vec<Value>>>() {
            let line = Value::Array(written).to_string();
            if line.len() <= LONGEST {
                self.fresh.lock().unwrap_or_else(PoisonError::into_inner).push((key, line));
            }
        }
    }

    /// Writes the file anew, if anything was learned.
    pub(super) fn close(self) {
        let mut fresh = self.fresh.into_inner().unwrap_or_else(PoisonError::into_inner);
        if fresh.is_empty() {
            return;
        }
        fresh.sort_unstable();
        let room = MOST.saturating_sub(fresh.len());
        let mut text = format!("{HEAD}\n");
        let learned: BTreeSet<u128> = fresh.iter().map(|(key, _)| *key).collect();
        let known = self.known.iter().filter(|(key, line)| !learned.contains(key) && entry(**key, line).is_some());
        let known: BTreeSet<(u128, &str)> = known.map(|(key, line)| (*key, line.as_str())).collect();
        let fresh = fresh.iter().map(|(key, found)| (*key, format!("{} {found}", digest(*key, found))));
        for (key, line) in fresh.chain(known.into_iter().take(room).map(|(key, line)| (key, line.to_owned()))) {
            let line = format!("{key:032x} {line}\n");
            if line.len() <= MOST_BYTES - text.len().min(MOST_BYTES) {
                text.push_str(&line);
            }
        }
        // Without it the next run takes longer, and nothing else.
        if let Some(directory) = self.file.parent()
            && system::create_directory(directory).is_ok()
        {
            let _ = system::write(&self.file, text.as_bytes());
        }
    }
}

/// The digest of an entry, which shows whether the file was damaged.
fn digest(key: u128, found: &str) -> String {
    let digest = Sha256::new().chain_update(key.to_be_bytes()).chain_update(found).finalize();
    digest
        .iter()
        .flat_map(|byte| [byte >> 4, byte & 15])
        .take(DIGEST)
        .filter_map(|it| char::from_digit(u32::from(it), 16))
        .collect()
}

/// What a line of the file says of a key, if nothing of it was damaged.
fn entry(key: u128, line: &str) -> Option<&str> {
    let (own, found) = line.split_at_checked(DIGEST)?;
    let found = found.strip_prefix(' ')?;
    (own == digest(key, found)).then_some(found)
}

/// A finding as the file keeps it; nothing for one without a place.
fn written(diagnostic: &Diagnostic) -> Option<Value> {
    let span = |span: Span| json!([span.start, span.end]);
    let place = diagnostic.place.as_ref()?;
    let arg = |(name, value): &(&str, Arg)| match value {
        Arg::Text(text) => Some(json!([name, text])),
        // What JSON cannot say exactly is not kept.
        Arg::Number(number) => number.is_finite().then(|| json!([name, number])),
    };
    let args = diagnostic.args.iter().map(arg).collect::<Option<Vec<Value>>>()?;
    let own = |other: &Place| Arc::ptr_eq(&other.source, &place.source);
    let related = diagnostic.related.iter();
    let related = related.map(|(caption, place)| own(place).then(|| json!([caption, span(place.span)])));
    let related = related.collect::<Option<Vec<Value>>>()?;
    let fix = diagnostic.fix.as_ref().map(|fix| json!([span(fix.span), fix.text]));
    Some(json!([diagnostic.code, diagnostic.severity.as_str(), span(place.span), args, related, fix]))
}

fn read(entry: &Value, source: &Arc<Source>) -> Option<Diagnostic> {
    let [code, severity, place, args, related, fix] = entry.as_array()?.as_slice() else { return None };
    let span = |value: &Value| {
        let number = |at: usize| usize::try_from(value.get(at)?.as_u64()?).ok();
        let (start, end) = (number(0)?, number(1)?);
        source.text().get(start..end).map(|_| Span::new(start, end))
    };
    let severity = [Severity::Note, Severity::Warning, Severity::Error]
        .into_iter()
        .find(|own| Some(own.as_str()) == severity.as_str())?;
    let arg = |value: &Value| {
        let name = interned(value.get(0)?.as_str()?);
        let value = value.get(1)?;
        let value = value.as_str().map(Arg::from).or_else(|| value.as_f64().map(Arg::Number))?;
        Some((name, value))
    };
    let beside = |value: &Value| Some((interned(value.get(0)?.as_str()?), Place::new(source, span(value.get(1)?)?)));
    let fix = match fix {
        Value::Null => None,
        fix => Some(Edit { span: span(fix.get(0)?)?, text: fix.get(1)?.as_str()?.to_owned() }),
    };
    Some(Diagnostic {
        code: interned(code.as_str()?),
        severity,
        place: Some(Place::new(source, span(place)?)),
        args: args.as_array()?.iter().map(arg).collect::<Option<_>>()?,
        related: related.as_array()?.iter().map(beside).collect::<Option<_>>()?,
        fix,
    })
}
