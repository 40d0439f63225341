//! The data that the program works on: specifications, locales and templates, embedded or from a
//! working copy.
//!
//! Invariant: plain paths and texts; directories are read outside of this module.

mod embedded {
    include!(concat!(env!("OUT_DIR"), "/embedded.rs"));
}

/// Paths (with `/`, such as `locales/fi/parameters.ftl`) and texts, sorted by path.
pub type Files = Vec<(String, String)>;

/// The data that the program was built with.
pub fn embedded() -> Files {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    embedded::FILES.iter().map(|(path, bytes)| ((*path).to_owned(), text(bytes))).collect()
}
