//! Books (EPUB 3): every page of every book is well-formed XML whose links lead somewhere, and the container is as the
//! format asks for.
use std::collections::{BTreeMap, BTreeSet};
use std::io::{Cursor, Read};

use ciklo::output::manual::{Book, Request, Site};
use quick_xml::events::Event;
use zip::{CompressionMethod, ZipArchive};

use crate::built::built;

fn books(control: &str, languages: &[&str]) -> Vec<Book> {
    let languages: Vec<String> = languages.iter().map(|&tag| tag.to_owned()).collect();
    let request = Request {
        catalogue: &built().catalogue,
        locales: &built().locales,
        files: &built().files,
        controls: &[control.to_owned()],
        languages: &languages,
        base_url: None,
    };
    let mut site = Site::new(&request).expect("a site");
    site.books().expect("books")
}

/// The files of a book by their paths.
fn unpacked(book: &Book) -> BTreeMap<String, String> {
    let mut zip = ZipArchive::new(Cursor::new(&book.bytes)).expect("a container");
    let mut files = BTreeMap::new();
    for index in 0..zip.len() {
        let mut file = zip.by_index(index).expect("a file");
        let mut text = String::new();
        file.read_to_string(&mut text).expect("text");
        let name = file.name().to_owned();
        assert!(files.insert(name.clone(), text).is_none(), "{name} is there twice");
    }
    files
}

/// The values of the attributes of that name in a well-formed document.
fn values(path: &str, text: &str, wanted: &[&str]) -> Vec<(String, String)> {
    let mut reader = quick_xml::Reader::from_str(text);
    let mut found = Vec::new();
    loop {
        let event = reader.read_event().unwrap_or_else(|error| panic!("{path}: {error}"));
        let (Event::Start(tag) | Event::Empty(tag)) = &event else {
            if matches!(event, Event::Eof) {
                return found;
            }
            continue;
        };
        for attribute in tag.attributes() {
            let attribute = attribute.unwrap_or_else(|error| panic!("{path}: {error}"));
            let name = attribute.key.as_ref().to_owned();
            if wanted.contains(&name.as_str()) {
                found.push((name, attribute.value.into_owned()));
            }
        }
    }
}

#[test]
fn every_page_of_a_book_is_well_formed_and_its_links_lead_somewhere() {
    // Every control and every language once; the largest book has all kinds of pages.
    let some = [("tnc640", "en"), ("tnc320", "it"), ("itnc530", "pt"), ("tnc320", "sl"), ("tnc426-430", "fi")];
    for book in some.into_iter().flat_map(|(control, language)| books(control, &[language])) {
        let files = unpacked(&book);
        let (mut places, mut links) = (BTreeSet::new(), Vec::new());
        for (path, text) in files.iter().filter(|(path, _)| path.ends_with(".xhtml")) {
            let file = path.trim_start_matches("book/");
            places.insert(file.to_owned());
            for (name, value) in values(path, text, &["id", "href"]) {
                if name == "id" {
                    assert!(places.insert(format!("{file}#{value}")), "{}: {path}: the id {value} twice", book.name);
                } else if let Some(anchor) = value.strip_prefix('#') {
                    links.push((path, format!("{file}#{anchor}")));
                } else if !value.ends_with(".css") {
                    links.push((path, value));
                }
            }
        }
        let dead: Vec<_> = links.iter().filter(|(_, link)| !places.contains(link)).collect();
        assert!(dead.is_empty(), "{}: {dead:?}", book.name);
        let listed: BTreeSet<String> = values("package.opf", &files["book/package.opf"], &["href"])
            .into_iter()
            .map(|(_, href)| format!("book/{href}"))
            .collect();
        let packed: BTreeSet<String> =
            files.keys().filter(|path| path.starts_with("book/") && !path.ends_with(".opf")).cloned().collect();
        assert_eq!(listed, packed, "{}: what the package lists is what is there", book.name);
    }
}

#[test]
fn the_container_names_its_type_first_and_as_it_is() {
    let book = books("tnc320", &["fi"]).remove(0);
    assert_eq!(book.name, "tnc320-fi.epub");
    let mut zip = ZipArchive::new(Cursor::new(&book.bytes)).expect("a container");
    let mut first = zip.by_index(0).expect("a file");
    let mut text = String::new();
    first.read_to_string(&mut text).expect("text");
    assert_eq!((first.name(), text.as_str()), ("mimetype", "application/epub+zip"));
    assert_eq!(first.compression(), CompressionMethod::Stored);
    // Readers look for it at this place of the file.
    assert_eq!(&book.bytes[30..58], b"mimetypeapplication/epub+zip");
}

#[test]
fn a_book_comes_out_the_same_every_time() {
    let bytes = || books("tnc426-430", &["en"]).remove(0).bytes;
    assert_eq!(bytes(), bytes());
}
