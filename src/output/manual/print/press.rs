//! The press: Typst with files from memory, the fonts that it brings, and neither clock nor network.
//!
//! Invariant: the same files give the same bytes. Typst is seen in this file only.
use std::collections::BTreeMap;

use typst::diag::{FileError, FileResult, SourceDiagnostic};
use typst::foundations::{Bytes, Datetime, Smart};
use typst::layout::PagedDocument;
use typst::syntax::{FileId, Source, VirtualPath};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Feature, Library, LibraryExt, World};
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards};

/// The families of fonts that books are set in: text, and programs. Their licences (SIL Open Font License, Bitstream Vera) allow to embed them.
const FAMILIES: [&str; 2] = ["Libertinus Serif", "DejaVu Sans Mono"];

/// Why a book cannot be set.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Misprint {
    /// The file, or nothing if it is none in particular.
    pub(super) file: String,
    /// The line, counted from 1; 0 if it is not known.
    pub(super) line: usize,
    pub(super) reason: String,
}

/// A book that is printed.
pub(super) struct Printed {
    pub(super) bytes: Vec<u8>,
    pub(super) pages: usize,
}

/// What is needed for every book.
pub(super) struct Press {
    library: LazyHash<Library>,
    book: LazyHash<FontBook>,
    fonts: Vec<Font>,
}

impl Press {
    pub(super) fn new() -> Self {
        let all = typst_assets::fonts().flat_map(|data| Font::iter(Bytes::new(data)));
        let fonts: Vec<Font> = all.filter(|font| FAMILIES.contains(&font.info().family.as_str())).collect();
        // Heads of rows in tables.
        let library = Library::builder().with_features([Feature::A11yExtras].into_iter().collect()).build();
        Self { library: LazyHash::new(library), book: LazyHash::new(FontBook::from_fonts(&fonts)), fonts }
    }

    /// Prints the sheets that the file `main.typ` sets; `identity` tells the book from all others.
    pub(super) fn print(&self, files: BTreeMap<String, String>, identity: &str) -> Result<Printed, Vec<Misprint>> {
        let (mut sources, mut pictures) = (BTreeMap::new(), BTreeMap::new());
        for (path, text) in files {
            if path.ends_with(".typ") {
                sources.insert(path.clone(), Source::new(id(&path), text));
            } else {
                pictures.insert(path, Bytes::from_string(text));
            }
        }
        let sheets = Sheets { press: self, sources, pictures };
        let misprints = |found: &[SourceDiagnostic]| found.iter().map(|one| sheets.misprint(one)).collect::<Vec<_>>();
        let document = typst::compile::<PagedDocument>(&sheets).output.map_err(|found| misprints(&found))?;
        let standards = PdfStandards::new(&[PdfStandard::Ua_1])
            .map_err(|reason| vec![Misprint { file: String::new(), line: 0, reason: reason.to_string() }])?;
        let options = PdfOptions { ident: Smart::Custom(identity), standards, ..PdfOptions::default() };
        let bytes = typst_pdf::pdf(&document, &options).map_err(|found| misprints(&found))?;
        // What was remembered of this book is of no use for the next one.
        typst::comemo::evict(0);
        Ok(Printed { bytes, pages: document.pages.len() })
    }
}

/// The files of a book on the press.
struct Sheets<'p> {
    press: &'p Press,
    sources: BTreeMap<String, Source>,
    pictures: BTreeMap<String, Bytes>,
}

impl Sheets<'_> {
    fn misprint(&self, found: &SourceDiagnostic) -> Misprint {
        let source = found.span.id().and_then(|id| self.source(id).ok());
        let start = source.as_ref().and_then(|source| source.range(found.span)).map(|range| range.start);
        let line = source.as_ref().zip(start).and_then(|(source, start)| source.lines().byte_to_line(start));
        Misprint {
            file: source.map(|source| path_of(source.id())).unwrap_or_default(),
            line: line.map_or(0, |line| line + 1),
            reason: found.message.to_string(),
        }
    }
}

impl World for Sheets<'_> {
    fn library(&self) -> &LazyHash<Library> {
        &self.press.library
    }

    fn book(&self) -> &LazyHash<FontBook> {
        &self.press.book
    }

    fn main(&self) -> FileId {
        id("main.typ")
    }

    fn source(&self, id: FileId) -> FileResult<Source> {
        self.sources.get(&path_of(id)).cloned().ok_or_else(|| absent(id))
    }

    fn file(&self, id: FileId) -> FileResult<Bytes> {
        self.pictures.get(&path_of(id)).cloned().ok_or_else(|| absent(id))
    }

    fn font(&self, index: usize) -> Option<Font> {
        self.press.fonts.get(index).cloned()
    }

    /// A book has the date of its data.
    fn today(&self, _: Option<i64>) -> Option<Datetime> {
        None
    }
}

fn id(path: &str) -> FileId {
    FileId::new(None, VirtualPath::new(path))
}

fn path_of(id: FileId) -> String {
    id.vpath().as_rootless_path().to_string_lossy().replace('\\', "/")
}

fn absent(id: FileId) -> FileError {
    FileError::NotFound(id.vpath().as_rootless_path().to_owned())
}
