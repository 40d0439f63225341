//! The JSON Schema of the files, made from the types that read them.
use serde_json::{Map, Value, json};

use super::decode::Decode;
use super::form::{CycleFile, Dictionary, Fragment};
use super::language::LanguageFile;
use super::pages::Pages;
use super::profile::{Control, Errata, Topics};
use super::worked::WorkedFile;

/// One schema for every kind of file below `cycle-specs/`.
pub fn schema() -> Value {
    let mut defs = Map::new();
    let kinds = [
        CycleFile::schema(&mut defs),
        Fragment::schema(&mut defs),
        Dictionary::schema(&mut defs),
        Control::schema(&mut defs),
        Errata::schema(&mut defs),
        Topics::schema(&mut defs),
        Pages::schema(&mut defs),
        LanguageFile::schema(&mut defs),
        WorkedFile::schema(&mut defs),
    ];
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "ciklo specification",
        "description": "A cycle, a fragment, a dictionary of meanings, a control, the errata, the topics, the \
                        pages, the language or a worked program.",
        "anyOf": kinds,
        "$defs": defs,
    })
}
