//! The data that the program works on: specifications, locales and templates, embedded or from a
//! working copy.
//!
//! Invariant: plain paths and texts; whoever reads a directory does it outside of this module, and what the prepared
//! forms mean is known to those who read them.

mod embedded {
    include!(concat!(env!("OUT_DIR"), "/embedded.rs"));
}

/// Paths (with `/`, such as `locales/fi/parameters.ftl`) and texts, sorted by path.
pub type Files = Vec<(String, String)>;

/// The data that the program was built with, as the build script prepared it.
#[derive(Debug)]
pub struct Prepared {
    /// Path and text of each file, sorted by path.
    pub files: &'static [(&'static str, &'static str)],
    /// The trees of the specifications: the index of a file, where its tree begins in `trees` and where it ends. What
    /// few ask for is a second tree, from there to the last number.
    pub tree_table: &'static [(usize, usize, usize, usize)],
    /// All trees; the form is in `spec::tree`.
    pub trees: &'static [u8],
    /// What the specifications hold, a line each; the form is in `spec::index`.
    pub index: &'static str,
    /// Where the messages of each language are, by its tag; the form is in `language::locale::index`.
    pub messages: &'static [(&'static str, &'static [u8])],
    /// Whether every file could be prepared.
    sound: bool,
}

impl Prepared {
    /// The text of a file.
    pub fn text(&self, path: &str) -> Option<&'static str> {
        let at = self.files.binary_search_by(|(own, _)| (*own).cmp(path)).ok()?;
        self.files.get(at).map(|(_, text)| *text)
    }

    /// The files whose paths begin like this.
    pub fn below(&self, prefix: &str) -> impl Iterator<Item = (&'static str, &'static str)> {
        let from = self.files.partition_point(|(path, _)| *path < prefix);
        self.files.iter().skip(from).take_while(move |(path, _)| path.starts_with(prefix)).copied()
    }
}

/// The data that the program was built with.
pub fn embedded() -> Files {
    embedded::DATA.files.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned())).collect()
}

/// The embedded data as they were prepared; nothing if they have mistakes that whoever reads all files reports.
pub fn prepared() -> Option<&'static Prepared> {
    Some(&embedded::DATA).filter(|data| data.sound)
}
