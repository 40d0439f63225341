//! The manual of a control in a language as a book: its pages in order, its contents, and EPUB 3. Books on paper are in `print`.
//!
//! Invariant: the pages of a book are those of the site without what only a site has (switches, search, comparisons), so
//! that no sentence exists twice; the same input gives the same bytes.
use std::fmt::Write as _;
use std::io::{Cursor, Write as _};

use minijinja::value::Serde;
use minijinja::{Value, context};
use serde::Serialize;
use zip::write::{SimpleFileOptions, ZipWriter};
use zip::{CompressionMethod, result::ZipError};

use super::edition::{Edition, GLOSSARY, PARAMETERS};
use super::escape::escape;
use super::page::Here;
use super::site::Site;
use super::{cycle, in_parallel, lists, lock, notes, programs, topic};
use crate::base::diag::Diagnostic;
use crate::language::locale::Args;
use crate::spec::Group;

/// A book.
#[derive(Debug)]
pub struct Book {
    /// The name of its file, such as `tnc640-fi.epub` or `tnc640-fi.pdf`.
    pub name: String,
    /// The whole file.
    pub bytes: Vec<u8>,
    /// How many pages it has; in EPUB, those that the site would have for it.
    pub pages: usize,
}

/// An entry of the contents.
#[derive(Serialize)]
pub(super) struct Listed {
    pub(super) href: String,
    pub(super) title: String,
}

/// A chapter of the contents.
#[derive(Serialize)]
pub(super) struct Chapter {
    pub(super) href: Option<String>,
    pub(super) title: String,
    pub(super) pages: Vec<Listed>,
}

/// A page to make.
#[derive(Clone, Copy)]
pub(super) enum Page {
    Cycle(usize),
    Topic(usize),
    Parameters,
    Keywords,
    Glossary,
    Notes,
    Programs,
}

/// A page that was made.
pub(super) struct Made {
    pub(super) page: Page,
    pub(super) html: String,
}

/// The name of the first page of a book.
const TITLE: &str = "title.xhtml";
/// The style sheets: that of books, and that of figures.
const STYLES: [&str; 2] = [STYLE, "assets/figure.css"];
/// The style sheet that only books have.
pub(super) const STYLE: &str = "assets/book.css";
/// The name of the contents.
const CONTENTS: &str = "contents.xhtml";

impl<'a> Site<'a> {
    /// A book for each control and language.
    ///
    /// # Errors
    /// Every text that is missing, every mistake of a template.
    pub fn books(&mut self) -> Result<Vec<Book>, Vec<Diagnostic>> {
        self.is_book = true;
        self.editions.iter().map(|edition| self.book(edition)).collect()
    }

    fn book(&self, edition: &Edition<'a>) -> Result<Book, Vec<Diagnostic>> {
        let made = self.made_pages(edition)?;
        let mut files = vec![
            (TITLE.to_owned(), self.frame_page("book-title.html", edition, Vec::new())?),
            (CONTENTS.to_owned(), self.frame_page("book-contents.html", edition, self.chapters(edition)?)?),
        ];
        let pages = made.len();
        files.extend(made.iter().map(|made| (book_name(file_of(edition, made.page)), with_book_links(&made.html))));
        let name = format!("{}-{}.epub", edition.on.id(), edition.language.tag());
        let package = self.package(edition, &files)?;
        let bytes = self.pack(&package, &files).map_err(|error| {
            vec![Diagnostic::global("book-not-packed").arg("path", name.as_str()).arg("reason", error.to_string())]
        })?;
        Ok(Book { name, bytes, pages })
    }

    /// The pages in the order of reading, as the site has them.
    pub(super) fn made_pages(&self, edition: &Edition<'a>) -> Result<Vec<Made>, Vec<Diagnostic>> {
        let pages = pages(edition);
        let made: std::sync::Mutex<Vec<(usize, Made)>> = std::sync::Mutex::default();
        let faults = in_parallel(pages.len(), &|at| {
            let Some(&page) = pages.get(at) else { return Ok(()) };
            let html = match page {
                Page::Cycle(entry) => cycle::page(self, edition, entry)?,
                Page::Topic(own) => topic::page(self, edition, own)?,
                Page::Parameters => lists::parameters(self, edition)?,
                Page::Keywords => lists::keywords(self, edition)?,
                Page::Glossary => lists::glossary(self, edition)?,
                Page::Notes => notes::page(self, edition)?,
                Page::Programs => programs::page(self, edition)?,
            };
            lock(&made).push((at, Made { page, html }));
            Ok(())
        });
        if !faults.is_empty() {
            return Err(faults);
        }
        let mut made = made.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
        made.sort_by_key(|(at, _)| *at);
        Ok(made.into_iter().map(|(_, made)| made).collect())
    }

    /// A page that only books have.
    pub(super) fn frame_page(
        &self,
        template: &str,
        edition: &Edition<'a>,
        chapters: Vec<Chapter>,
    ) -> Result<String, Vec<Diagnostic>> {
        let title = edition.text("site-manual", &Args::new())?.into_owned();
        let frame = self.frame(edition, title, Here::Every("index.html"))?;
        let context = context! {
            page => Value::from(Serde(&frame)),
            words => edition.words.clone(),
            chapters => Value::from(Serde(&chapters)),
        };
        self.render(template, context)
    }

    /// The contents: the groups with their cycles, the topics, the lists.
    pub(super) fn chapters(&self, edition: &Edition<'a>) -> Result<Vec<Chapter>, Vec<Diagnostic>> {
        let mut chapters = Vec::new();
        for group in Group::ALL {
            let members = edition.entries.iter().filter(|entry| entry.cycle.file.group == *group);
            let pages: Vec<Listed> = members
                .map(|entry| Listed {
                    href: book_name(&entry.file),
                    title: format!("{} {}", entry.cycle.key, entry.name),
                })
                .collect();
            if !pages.is_empty() {
                chapters.push(Chapter { href: None, title: edition.group_title(*group)?, pages });
            }
        }
        let text = |key: &str| edition.text(key, &Args::new()).map(|text| text.into_owned());
        let topics = edition.topics.iter();
        let pages: Vec<Listed> =
            topics.map(|topic| Listed { href: book_name(&topic.file), title: topic.title.clone() }).collect();
        if !pages.is_empty() {
            chapters.push(Chapter { href: None, title: text("site-topics")?, pages });
        }
        let list = |page: Page, key: &str| {
            Ok::<_, Vec<Diagnostic>>(Chapter {
                href: Some(book_name(file_of(edition, page))),
                title: text(key)?,
                pages: Vec::new(),
            })
        };
        if !edition.on.worked.is_empty() {
            chapters.push(list(Page::Programs, "site-worked-programs")?);
        }
        chapters.push(list(Page::Notes, "site-general-notes")?);
        chapters.push(list(Page::Parameters, "site-parameters-short")?);
        chapters.push(list(Page::Glossary, "site-glossary")?);
        chapters.push(list(Page::Keywords, "site-keywords")?);
        Ok(chapters)
    }

    /// The package document: what the book is, what it consists of, and the order of reading.
    fn package(&self, edition: &Edition<'a>, files: &[(String, String)]) -> Result<String, Vec<Diagnostic>> {
        let (control, tag) = (edition.on.id(), edition.language.tag());
        let title = edition.text("site-manual", &Args::new())?;
        let date = self.catalogue.pages.as_ref().and_then(|pages| pages.edition.as_deref()).unwrap_or("2000-01-01");
        let mut title_of_book = String::new();
        escape(&format!("{}: {title}", edition.on.control.title), &mut title_of_book);
        let mut out = format!(
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
             <package xmlns=\"http://www.idpf.org/2007/opf\" version=\"3.0\" unique-identifier=\"id\" xml:lang=\"{tag}\">\n\
             <metadata xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n\
             <dc:identifier id=\"id\">urn:x-ciklo:{control}:{tag}</dc:identifier>\n\
             <dc:title>{title_of_book}</dc:title>\n\
             <dc:language>{tag}</dc:language>\n\
             <dc:creator>Ciklo</dc:creator>\n\
             <dc:date>{date}</dc:date>\n\
             <meta property=\"dcterms:modified\">{date}T00:00:00Z</meta>\n\
             <meta property=\"schema:accessMode\">textual</meta>\n\
             <meta property=\"schema:accessMode\">visual</meta>\n\
             <meta property=\"schema:accessModeSufficient\">textual</meta>\n\
             <meta property=\"schema:accessibilityFeature\">structuralNavigation</meta>\n\
             <meta property=\"schema:accessibilityFeature\">tableOfContents</meta>\n\
             <meta property=\"schema:accessibilityHazard\">none</meta>\n\
             </metadata>\n<manifest>\n"
        );
        for (index, (path, text)) in files.iter().enumerate() {
            let has_figure = text.contains("<svg");
            let properties = match (path == CONTENTS, has_figure) {
                (true, _) => " properties=\"nav\"",
                (false, true) => " properties=\"svg\"",
                (false, false) => "",
            };
            let _ = writeln!(
                out,
                "<item id=\"p{index}\" href=\"{path}\" media-type=\"application/xhtml+xml\"{properties}/>"
            );
        }
        for (index, (path, _)) in self.styles().enumerate() {
            let _ = writeln!(out, "<item id=\"s{index}\" href=\"{path}\" media-type=\"text/css\"/>");
        }
        out.push_str("</manifest>\n<spine>\n");
        for index in 0..files.len() {
            let _ = writeln!(out, "<itemref idref=\"p{index}\"/>");
        }
        out.push_str("</spine>\n</package>\n");
        Ok(out)
    }

    /// The style sheets.
    fn styles(&self) -> impl Iterator<Item = (&str, &str)> {
        self.assets.iter().filter(|(path, _)| STYLES.contains(path)).copied()
    }

    /// The container: the media type first and as it is, all else compressed, without times.
    fn pack(&self, package: &str, files: &[(String, String)]) -> Result<Vec<u8>, ZipError> {
        const CONTAINER: &str = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
            <container version=\"1.0\" xmlns=\"urn:oasis:names:tc:opendocument:xmlns:container\">\n\
            <rootfiles><rootfile full-path=\"book/package.opf\" media-type=\"application/oebps-package+xml\"/></rootfiles>\n\
            </container>\n";
        let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
        let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        let deflated = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
        let mut add = |path: &str, text: &str, options| {
            zip.start_file(path, options)?;
            zip.write_all(text.as_bytes()).map_err(ZipError::from)
        };
        add("mimetype", "application/epub+zip", stored)?;
        add("META-INF/container.xml", CONTAINER, deflated)?;
        add("book/package.opf", package, deflated)?;
        for (path, text) in files {
            add(&format!("book/{path}"), text, deflated)?;
        }
        for (path, text) in self.styles() {
            add(&format!("book/{path}"), text, deflated)?;
        }
        Ok(zip.finish()?.into_inner())
    }
}

/// The pages in the order of reading.
fn pages(edition: &Edition) -> Vec<Page> {
    let of_group =
        |group: Group| (0..edition.entries.len()).filter(move |at| edition.entries[*at].cycle.file.group == group);
    let cycles = Group::ALL.iter().flat_map(|group| of_group(*group)).map(Page::Cycle);
    let topics = (0..edition.topics.len()).map(Page::Topic);
    let programs = (!edition.on.worked.is_empty()).then_some(Page::Programs);
    cycles
        .chain(topics)
        .chain(programs)
        .chain([Page::Notes, Page::Parameters, Page::Glossary, Page::Keywords])
        .collect()
}

/// The name of its file on the site.
pub(super) fn file_of<'s>(edition: &'s Edition, page: Page) -> &'s str {
    match page {
        Page::Cycle(at) => &edition.entries[at].file,
        Page::Topic(at) => &edition.topics[at].file,
        Page::Parameters => PARAMETERS,
        Page::Keywords => lists::KEYWORDS,
        Page::Glossary => GLOSSARY,
        Page::Notes => notes::PAGE,
        Page::Programs => programs::PAGE,
    }
}

/// The name of a page in a book.
fn book_name(file: &str) -> String {
    file.strip_suffix(".html").map_or_else(|| file.to_owned(), |name| format!("{name}.xhtml"))
}

/// Links to pages of the site lead to those of the book.
fn with_book_links(html: &str) -> String {
    const LINK: &str = " href=\"";
    let mut out = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = rest.find(LINK) {
        let (before, after) = rest.split_at(at + LINK.len());
        out.push_str(before);
        let link = after.split('"').next().unwrap_or_default();
        let (file, anchor) = link.find('#').map_or((link, ""), |at| link.split_at(at));
        let file = if file.contains(':') { file.to_owned() } else { book_name(file) };
        out.push_str(&file);
        out.push_str(anchor);
        rest = &after[link.len()..];
        // Readers speak the link of a dimension by its title.
        let tag = before.rfind('<').map_or("", |at| &before[at..]);
        if let (true, Some(end)) = (tag.starts_with("<a class=\"d "), rest.find('>')) {
            let (open, inside) = rest.split_at(end + 1);
            let _ = write!(out, "{open}<title>{}</title>", anchor.trim_start_matches('#'));
            rest = inside;
        }
    }
    out.push_str(rest);
    out
}
