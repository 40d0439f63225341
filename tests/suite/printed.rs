//! Books on paper (PDF/UA-1), with the feature `pdf`: the press refuses a character that its fonts lack, a figure without a description and a link
//! that leads nowhere, so that a book that is printed has none.
use std::collections::BTreeSet;

use ciklo::base::data;
use ciklo::base::diag::Diagnostic;
use ciklo::language::locale::Locales;
use ciklo::output::manual::{Book, Request, Site};
use ciklo::spec::Catalogue;

type Files = Vec<(String, String)>;

fn printed(files: &Files, control: &str, languages: &[&str]) -> Result<Vec<Book>, Vec<Diagnostic>> {
    let (catalogue, _) = Catalogue::load(files);
    let (locales, _) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    let languages: Vec<String> = languages.iter().map(|&tag| tag.to_owned()).collect();
    let request = Request {
        catalogue: &catalogue,
        locales: &locales,
        files,
        controls: &[control.to_owned()],
        languages: &languages,
        base_url: None,
    };
    Site::new(&request)?.printed()
}

/// How often a piece of a PDF occurs; what is compressed is not looked into.
fn count(book: &Book, piece: &str) -> usize {
    book.bytes.windows(piece.len()).filter(|window| *window == piece.as_bytes()).count()
}

#[test]
fn a_manual_is_printed_in_every_language_with_tags_bookmarks_and_described_figures() {
    let files = data::embedded();
    let books = printed(&files, "tnc426-430", &["en", "fi", "it", "pt", "sl"]).expect("books");
    assert_eq!(books.len(), 5);
    let names: BTreeSet<&str> = books.iter().map(|book| book.name.as_str()).collect();
    assert!(names.contains("tnc426-430-pt.pdf"), "{names:?}");
    for book in &books {
        let name = &book.name;
        assert!(book.bytes.starts_with(b"%PDF-1.7"), "{name}");
        assert!(book.pages > 100, "{name}: {} pages", book.pages);
        assert_eq!(count(book, "/Type /Page\n"), book.pages, "{name}: what it counts is what is there");
        for piece in ["<pdfuaid:part>1", "/StructTreeRoot", "/Outlines", "/S /TOC\n", "/S /TH\n", "/S /H3\n"] {
            assert_ne!(count(book, piece), 0, "{name}: {piece}");
        }
        let figures = count(book, "/S /Figure\n");
        assert!(figures > 50 && count(book, "/Alt ") >= figures, "{name}: {figures} figures with what they show");
        let tag = name.trim_end_matches(".pdf").rsplit('-').next().expect("a tag");
        assert_ne!(count(book, &format!("/Lang ({tag}")), 0, "{name}: the language");
        let fonts = count(book, "/FontFile2") + count(book, "/FontFile3");
        assert_eq!(count(book, "/Type /FontDescriptor"), fonts, "{name}: every font is in the file");
    }
}

#[test]
fn a_book_on_paper_comes_out_the_same_every_time_and_has_the_date_of_its_data() {
    let files = data::embedded();
    let [one, other] = [(); 2].map(|()| printed(&files, "tnc426-430", &["sl"]).expect("a book").remove(0));
    assert!(one.bytes == other.bytes, "the same bytes");
    let (catalogue, _) = Catalogue::load(&files);
    let edition = catalogue.pages.as_ref().and_then(|pages| pages.edition.clone()).expect("a date");
    assert_ne!(count(&one, &format!("(D:{}", edition.replace('-', ""))), 0, "{edition}");
}

#[test]
fn a_mistake_of_the_look_is_named_with_its_line() {
    let mut files = data::embedded();
    let (_, look) = files.iter_mut().find(|(path, _)| path == "templates/print/book.typ").expect("the look");
    let line = look.lines().count() + 1;
    look.push_str("#unheard-of()\n");
    let found = printed(&files, "tnc426-430", &["en"]).expect_err("it is refused");
    let shown = format!("{found:?}");
    assert!(found.iter().all(|one| one.code == "book-not-set"), "{shown}");
    assert!(shown.contains("unheard-of") && shown.contains("book.typ") && shown.contains(&line.to_string()), "{shown}");
}
