//! The manual of a control in a language on paper: PDF with bookmarks and tags (PDF/UA-1).
//!
//! Invariant: the pages are those of the other books, translated to the markup of the press; no sentence is made here, and
//! the same input gives the same bytes.
mod markup;
mod press;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use self::markup::{Places, Translation, place, say, string};
use self::press::{Misprint, Press};
use super::book::{Book, Chapter, Page, file_of};
use super::edition::Edition;
use super::site::Site;
use crate::base::diag::Diagnostic;
use crate::base::xml::{self, Node};
use crate::language::locale::Args;

/// What the functions are that pages call.
const LOOK: &str = "book.typ";
/// The style sheet of figures, and what of it is for paper.
const FIGURES: [&str; 2] = ["templates/assets/figure.css", "templates/print/figure.css"];

impl<'a> Site<'a> {
    /// A book as PDF for each control and language.
    ///
    /// # Errors
    /// Every text that is missing, every mistake of a template, every mistake of the markup.
    pub fn printed(&mut self) -> Result<Vec<Book>, Vec<Diagnostic>> {
        self.is_book = true;
        let press = Press::new();
        self.editions.iter().map(|edition| self.print(edition, &press)).collect()
    }

    fn print(&self, edition: &Edition<'a>, press: &Press) -> Result<Book, Vec<Diagnostic>> {
        let (control, tag) = (edition.on.id(), edition.language.tag());
        let name = format!("{control}-{tag}.pdf");
        let wrong = |found: Vec<Misprint>| found.into_iter().map(|one| misprinted(&name, one)).collect::<Vec<_>>();
        let files = self.sheets(edition).map_err(|fault| match fault {
            Fault::Found(found) => found,
            Fault::Misprint(one) => wrong(vec![one]),
        })?;
        let printed = press.print(files, &format!("urn:x-ciklo:{control}:{tag}")).map_err(wrong)?;
        Ok(Book { name, bytes: printed.bytes, pages: printed.pages })
    }

    /// The files that the press takes.
    fn sheets(&self, edition: &Edition<'a>) -> Result<BTreeMap<String, String>, Fault> {
        let made = self.made_pages(edition)?;
        let title = self.frame_page("book-title.html", edition, Vec::new())?;
        let chapters = self.chapters(edition)?;
        let read = |file: &str, html: &str| tree(file, html).map_err(Fault::Misprint);
        let mut pages = Vec::new();
        for page in &made {
            let file = file_of(edition, page.page);
            pages.push((page, file, read(file, &page.html)?));
        }
        let mut places = Places::default();
        pages.iter().for_each(|(_, file, tree)| places.note(file, tree));
        let style = self.figure_style();
        let mut files = BTreeMap::new();
        let look = self.figures.file(&format!("templates/print/{LOOK}")).unwrap_or_default();
        files.insert(LOOK.to_owned(), look.to_owned());
        for (page, file, tree) in &pages {
            let (level, is_index) = kind(page.page);
            let mut translation = Translation {
                file,
                text: body(&page.html),
                level,
                is_index,
                places: &places,
                style: &style,
                is_repeated: false,
                drawings: Vec::new(),
            };
            let text = translation.inside(tree);
            files.extend(translation.drawings.into_iter().map(|drawing| (drawing.file, drawing.svg)));
            files.insert(sheet(file), with_look(&text));
        }
        let tree = read("title.html", &title)?;
        let mut front = Translation {
            file: "title.html",
            text: "",
            level: 0,
            is_index: false,
            places: &places,
            style: &style,
            is_repeated: false,
            drawings: Vec::new(),
        };
        files.insert(sheet("title.html"), with_look(&front.inside(&tree)));
        files.insert("main.typ".to_owned(), self.main(edition, &chapters)?);
        Ok(files)
    }

    /// The book: first page, contents, chapters.
    fn main(&self, edition: &Edition<'a>, chapters: &[Chapter]) -> Result<String, Vec<Diagnostic>> {
        let control = edition.on.control.title.as_str();
        let title = edition.text("site-manual", &Args::new())?;
        let tag = edition.language.tag();
        let mut out = with_look("#show: book.with(");
        let _ = write!(out, "title: {}, ", string(&format!("{control}: {title}")));
        let _ = write!(out, "control: {}, lang: {}, ", string(control), string(tag.split('-').next().unwrap_or(tag)));
        let imprint = self.imprint(edition)?;
        let imprint: Vec<&str> = imprint.iter().map(String::as_str).filter(|line| *line != control).collect();
        let date = self.catalogue.pages.as_ref().and_then(|pages| pages.edition.as_deref()).and_then(date);
        let _ =
            writeln!(out, "imprint: {}, date: {})", string(&imprint.join(" · ")), date.as_deref().unwrap_or("none"));
        let _ = writeln!(out, "#front[#include {}]", string(&sheet("title.html")));
        let _ = writeln!(out, "#contents({})", string(&edition.text("site-contents", &Args::new())?));
        for chapter in chapters {
            if chapter.href.is_none() {
                let _ = write!(out, "#chapter({}, ", string(&chapter.title));
                for page in &chapter.pages {
                    let mut title = String::new();
                    say(&page.title, &mut title);
                    let _ = write!(out, "({}, [{title}]), ", string(&place(&page.href, "")));
                }
                out.push_str(")\n");
            }
            for href in chapter.href.iter().chain(chapter.pages.iter().map(|page| &page.href)) {
                let _ = writeln!(out, "#include {}", string(&sheet(href)));
            }
        }
        Ok(out)
    }

    /// The colours of figures on paper: those of a light screen.
    fn figure_style(&self) -> String {
        let light = |text: &'a str| text.split("@media").next().unwrap_or_default();
        FIGURES.iter().filter_map(|path| self.figures.file(path)).map(light).collect()
    }
}

/// Why there are no sheets.
enum Fault {
    Found(Vec<Diagnostic>),
    Misprint(Misprint),
}

impl From<Vec<Diagnostic>> for Fault {
    fn from(found: Vec<Diagnostic>) -> Self {
        Self::Found(found)
    }
}

fn misprinted(name: &str, found: Misprint) -> Diagnostic {
    let diagnostic = Diagnostic::global("book-not-set").arg("path", name).arg("file", found.file);
    diagnostic.arg("line", found.line).arg("reason", found.reason)
}

/// The level of the title of a page, and whether it is an index.
const fn kind(page: Page) -> (usize, bool) {
    match page {
        Page::Cycle(_) | Page::Topic(_) => (2, false),
        Page::Parameters | Page::Keywords => (1, true),
        Page::Glossary | Page::Notes | Page::Programs => (1, false),
    }
}

/// A page without what stands before its root.
fn body(html: &str) -> &str {
    html.find("<html").and_then(|at| html.get(at..)).unwrap_or(html)
}

fn tree(file: &str, html: &str) -> Result<Node, Misprint> {
    xml::parse(body(html)).map_err(|found| Misprint {
        file: file.to_owned(),
        line: body(html).get(..found.at).map_or(0, |before| before.lines().count()),
        reason: found.what.to_owned(),
    })
}

/// The name of the file of a page for the press.
fn sheet(file: &str) -> String {
    format!("{}.typ", place(file, ""))
}

fn with_look(text: &str) -> String {
    format!("#import \"{LOOK}\": *\n{text}")
}

/// A date such as `2026-11-23`, as the press takes it.
fn date(text: &str) -> Option<String> {
    let parts: Vec<u16> = text.split('-').map(str::parse).collect::<Result<_, _>>().ok()?;
    let [year, month, day] = parts.as_slice() else { return None };
    Some(format!("datetime(year: {year}, month: {month}, day: {day})"))
}
