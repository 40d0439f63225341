//! A catalogue of two cycles on one control: every kind of run item, the old and the new form.
use std::path::Path;

use ciklo::base::data::{self, Files};

const OWN: [&str; 8] = [
    "cycle-specs/controls/small.yaml",
    "cycle-specs/parameters/small.yaml",
    "cycle-specs/fragments/move-clear.yaml",
    "cycle-specs/drilling/901-pecking.yaml",
    "cycle-specs/transforms/9-turning-round.yaml",
    "cycle-specs/topics.yaml",
    "locales/en/small.ftl",
    "locales/en/topics/pecking-basics.md",
];

/// Its files, with those of the program that are `general`.
pub(crate) fn files(general: fn(&str) -> bool) -> Files {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/small");
    let read = |name: &str| (name.to_owned(), std::fs::read_to_string(root.join(name)).expect(name));
    let mut files: Files = OWN.into_iter().map(read).collect();
    files.extend(data::embedded().into_iter().filter(|(path, _)| general(path)));
    files
}
