//! Pages of the manual in Typst's markup.
//!
//! Invariant: what a page says is taken from its elements, and how it looks is left to the functions of `templates/print/book.typ`: nothing
//! of the content is decided here.
use std::collections::BTreeSet;
use std::fmt::Write as _;

use crate::base::xml::Node;

/// A drawing that a page shows.
pub(super) struct Drawing {
    /// The name of its file.
    pub(super) file: String,
    /// The SVG by itself.
    pub(super) svg: String,
}

/// How the pages of a book refer to each other.
#[derive(Default)]
pub(super) struct Places {
    linked: BTreeSet<String>,
}

impl Places {
    /// Notes where the links of a page lead.
    pub(super) fn note(&mut self, file: &str, node: &Node) {
        if let (true, Some(href)) = (node.name == "a", node.attribute("href")) {
            self.linked.insert(place(file, href));
        }
        node.children.iter().for_each(|child| self.note(file, child));
    }
}

/// A page under translation.
pub(super) struct Translation<'p> {
    /// The name of its file on the site.
    pub(super) file: &'p str,
    /// The text of that file, for its drawings.
    pub(super) text: &'p str,
    /// The level of its title: 1 if it is a chapter of its own, 0 if it is the title of the book.
    pub(super) level: usize,
    /// Whether its links are those of an index, which say the page.
    pub(super) is_index: bool,
    /// Where links of the book lead.
    pub(super) places: &'p Places,
    /// What the styles of drawings are.
    pub(super) style: &'p str,
    /// Whether links are left out, as in what a sheet repeats.
    pub(super) is_repeated: bool,
    /// The drawings that were met.
    pub(super) drawings: Vec<Drawing>,
}

/// Elements that are read past: what only a screen has.
const SKIPPED: [&str; 4] = ["nav", "head", "style", "script"];
/// The section of links to other pages, which say the page on paper.
const SEE_ALSO: &str = "see-also";
/// Elements that stand by themselves and not in a line of text.
const BLOCKS: [&str; 17] = [
    "article", "body", "dd", "div", "dl", "figure", "h1", "h2", "h3", "header", "main", "ol", "p", "pre", "section",
    "table", "ul",
];

impl Translation<'_> {
    /// What is in an element.
    pub(super) fn inside(&mut self, node: &Node) -> String {
        let mut out = String::new();
        for child in &node.children {
            match &*child.name {
                "" => say(&child.words, &mut out),
                name if SKIPPED.contains(&name) => {}
                _ => self.element(child, &mut out),
            }
        }
        out
    }

    /// What is in an element that the head of a sheet or of a table repeats: links are not allowed there.
    fn repeated(&mut self, node: &Node) -> String {
        let was_repeated = std::mem::replace(&mut self.is_repeated, true);
        let body = self.inside(node);
        self.is_repeated = was_repeated;
        body
    }

    fn element(&mut self, node: &Node, out: &mut String) {
        let class = node.attribute("class").unwrap_or_default();
        match (&*node.name, class) {
            ("h1" | "h2" | "h3", _) => self.heading(node, out),
            ("main", _) if self.is_index => {
                named(node, "h1").for_each(|head| self.heading(head, out));
                out.push_str("#index[\n");
                node.children
                    .iter()
                    .filter(|child| !["", "h1", "nav"].contains(&&*child.name))
                    .for_each(|child| self.element(child, out));
                out.push_str("];\n");
            }
            ("section", _) if node.attribute("id") == Some(SEE_ALSO) => {
                let was_index = std::mem::replace(&mut self.is_index, true);
                self.see_also(node, out);
                self.is_index = was_index;
            }
            ("p", "signal" | "control" | "effective" | "of" | "example-title") => self.call(class, node, out),
            ("p", _) => self.call("par", node, out),
            ("div", "figures") => self.drawings(node, out),
            ("div", _) if class.starts_with("notes ") => {
                let kind = class.trim_start_matches("notes ");
                let body = self.inside(node);
                let _ = writeln!(out, "#notes(\"{kind}\")[{body}]");
            }
            ("ul" | "ol", _) => self.list(node, out),
            ("dl", _) => self.terms(node, class, out),
            ("table", _) if class.contains("uses") => self.uses(node, out),
            ("table", _) => self.table(node, class, out),
            ("figure", "nc") => self.program(node, out),
            ("pre", _) => program(node, "", out),
            ("a", _) => self.link(node, class, out),
            ("strong" | "dfn", _) => self.call("strong", node, out),
            ("em", _) => self.call("emph", node, out),
            ("code", "label") => self.call("label-of", node, out),
            ("code", _) => self.call("code", node, out),
            ("span", "badge" | "key") => self.call(class, node, out),
            ("span", "q") => self.call("strong", node, out),
            ("br", _) => out.push_str("#linebreak();"),
            _ => {
                self.anchor(node, out);
                let body = self.inside(node);
                match node.attribute("lang") {
                    Some(lang) => {
                        let _ = write!(out, "#text(lang: \"{lang}\")[{body}];");
                    }
                    None => out.push_str(&body),
                }
            }
        }
    }

    /// Links to other pages, one after the other.
    fn see_also(&mut self, node: &Node, out: &mut String) {
        named(node, "h2").for_each(|head| self.heading(head, out));
        let items: Vec<&Node> = named(node, "ul").flat_map(|list| named(list, "li")).collect();
        let items: Vec<String> = items.into_iter().map(|item| format!("[{}]", self.inside(item))).collect();
        let _ = writeln!(out, "#see-also({});", items.join(", "));
    }

    /// An element as the function of that name.
    fn call(&mut self, function: &str, node: &Node, out: &mut String) {
        let body = self.inside(node);
        let end = if BLOCKS.contains(&&*node.name) { "\n" } else { "" };
        let _ = write!(out, "#{function}[{body}];{end}");
    }

    /// A place that a link leads to.
    fn anchor(&self, node: &Node, out: &mut String) {
        if let Some(place) = self.own_place(node) {
            let _ = write!(out, "#anchor({});", string(&place));
        }
    }

    fn own_place(&self, node: &Node) -> Option<String> {
        let id = node.attribute("id")?;
        Some(place(self.file, &format!("#{id}"))).filter(|place| self.places.linked.contains(place))
    }

    fn heading(&mut self, node: &Node, out: &mut String) {
        let depth = node.name.bytes().last().map_or(1, |digit| usize::from(digit - b'0'));
        let body = if depth == 1 { self.repeated(node) } else { self.inside(node) };
        if depth == 1 && self.level == 0 {
            let _ = writeln!(out, "#front-title[{body}]");
            return;
        }
        if depth == 1 {
            let place = string(&place(self.file, ""));
            let _ = writeln!(out, "#page-title({}, {place})[{body}]", self.level);
            return;
        }
        self.anchor(node, out);
        let _ = writeln!(out, "#section({})[{body}]", self.level + depth - 1);
    }

    fn link(&mut self, node: &Node, class: &str, out: &mut String) {
        let body = self.inside(node);
        let href = node.attribute("href").unwrap_or_default();
        let target = place(self.file, href);
        if self.is_repeated {
            out.push_str(&body);
            return;
        }
        let _ = match (class, href.contains(':')) {
            // A parameter in its own row leads to itself.
            ("q", _) => write!(out, "#strong[{body}];"),
            (_, true) => write!(out, "#link({})[{body}];", string(href)),
            _ if self.is_index => write!(out, "#seen({})[{body}];", string(&target)),
            _ => write!(out, "#to({})[{body}];", string(&target)),
        };
    }

    fn list(&mut self, node: &Node, out: &mut String) {
        let function = match (&*node.name, node.attribute("class")) {
            ("ol", _) => "steps",
            (_, Some("columns")) => "entries",
            _ => "points",
        };
        let _ = write!(out, "#{function}(");
        if let Some(start) = node.attribute("start").and_then(|start| start.parse::<u32>().ok()) {
            let _ = write!(out, "start: {start}, ");
        }
        for item in named(node, "li") {
            let mut body = String::new();
            self.anchor(item, &mut body);
            body += &self.inside(item);
            let _ = write!(out, "[{body}], ");
        }
        out.push_str(");\n");
    }

    fn terms(&mut self, node: &Node, class: &str, out: &mut String) {
        let function = if class.is_empty() { "facts" } else { class };
        let _ = write!(out, "#{function}(");
        for pair in named(node, "div") {
            let mut term = String::new();
            self.anchor(pair, &mut term);
            let mut body = String::new();
            for child in &pair.children {
                match &*child.name {
                    "dt" => term += &self.inside(child),
                    "dd" => body += &self.inside(child),
                    _ => {}
                }
            }
            let _ = write!(out, "([{term}], [{body}]), ");
        }
        out.push_str(");\n");
    }

    fn table(&mut self, node: &Node, class: &str, out: &mut String) {
        let function = if class.starts_with("parameters") { "parameter-table" } else { "plain-table" };
        let rows = rows(node, "thead");
        let columns = rows.first().map_or(1, |row| row.children.iter().filter(|cell| is_cell(cell)).count());
        if let Some(caption) = node.child("caption") {
            self.call("table-title", caption, out);
        }
        let _ = write!(out, "#{function}({columns}, (");
        for cell in rows.iter().flat_map(|row| &row.children).filter(|cell| is_cell(cell)) {
            let body = self.repeated(cell);
            let _ = write!(out, "[{body}], ");
        }
        out.push_str("),\n");
        for row in self::rows(node, "tbody") {
            let mut anchor = String::new();
            self.anchor(row, &mut anchor);
            for cell in row.children.iter().filter(|cell| is_cell(cell)) {
                let body = std::mem::take(&mut anchor) + &self.inside(cell);
                let function = if cell.name == "th" { "row-head" } else { "table.cell" };
                let rowspan = cell.attribute("rowspan").unwrap_or("1");
                let _ = write!(out, "{function}(rowspan: {rowspan})[{body}], ");
            }
            out.push('\n');
        }
        out.push_str(");\n");
    }

    /// The list by parameter, as entries of an index: the parameter, and its meanings with their pages.
    fn uses(&mut self, node: &Node, out: &mut String) {
        for group in named(node, "tbody") {
            let mut heads = String::new();
            let mut meanings = String::new();
            self.anchor(group, &mut heads);
            for row in named(group, "tr") {
                if let Some(head) = row.child("th") {
                    heads += &self.inside(head);
                }
                let cells: Vec<String> = named(row, "td").map(|cell| self.inside(cell)).collect();
                if let [name, places] = cells.as_slice() {
                    let _ = write!(meanings, "([{name}], [{places}]), ");
                }
            }
            let _ = writeln!(out, "#parameter([{heads}], {meanings});");
        }
    }

    fn program(&mut self, node: &Node, out: &mut String) {
        let title = node.child("figcaption").map(|caption| self.inside(caption)).unwrap_or_default();
        if let Some(block) = node.child("pre") {
            program(block, &title, out);
        }
    }

    /// The drawings of a cycle; small ones are kept together.
    fn drawings(&mut self, node: &Node, out: &mut String) {
        let (mut large, mut small) = (String::new(), String::new());
        for figure in named(node, "figure") {
            let Some(svg) = figure.child("svg") else { continue };
            let caption = figure.child("figcaption").map(|caption| self.inside(caption)).unwrap_or_default();
            let said = |name: &str| svg.child(name).map(Node::text).unwrap_or_default();
            let alt = [said("title"), said("desc")].map(|text| text.trim().to_owned());
            let alt = alt.iter().filter(|text| !text.is_empty()).map(String::as_str).collect::<Vec<_>>().join(". ");
            let Some(drawing) = self.drawing(svg) else { continue };
            let row = if figure.attribute("class").is_some_and(|class| class.contains("small")) {
                &mut small
            } else {
                &mut large
            };
            let _ = write!(row, "drawing({}, {})[{caption}], ", string(&drawing), string(&alt));
        }
        let _ = writeln!(out, "#drawings(({large}), ({small}));");
    }

    /// Sets a drawing aside as a file of its own, which has its colours in itself.
    fn drawing(&mut self, svg: &Node) -> Option<String> {
        let rest = self.text.get(svg.at..)?;
        let whole = &rest[..rest.find("</svg>")? + "</svg>".len()];
        let head = whole.find('>')? + 1;
        let stem = place(self.file, "");
        let file = format!("figures/{stem}-{}.svg", self.drawings.len() + 1);
        let svg = format!("{}<style>{}</style>{}", &whole[..head], self.style, &whole[head..]);
        self.drawings.push(Drawing { file: file.clone(), svg });
        Some(file)
    }
}

/// Lines of a program, as they are.
fn program(node: &Node, title: &str, out: &mut String) {
    let text = node.text();
    let _ = writeln!(out, "#program([{title}], {});", string(text.trim_end_matches('\n')));
}

fn is_cell(node: &Node) -> bool {
    node.name == "td" || node.name == "th"
}

fn named<'n>(node: &'n Node, name: &'static str) -> impl Iterator<Item = &'n Node> {
    node.children.iter().filter(move |child| child.name == name)
}

/// The rows of a part of a table.
fn rows<'n>(table: &'n Node, part: &'static str) -> Vec<&'n Node> {
    named(table, part).flat_map(|part| named(part, "tr")).collect()
}

/// The place in the book that a link of a page leads to: `tch-probe-412--Q305`.
pub(super) fn place(file: &str, link: &str) -> String {
    let (target, anchor) = link.split_once('#').map_or((link, None), |(target, anchor)| (target, Some(anchor)));
    let target = if target.is_empty() { file } else { target };
    let stem = target.split_once('.').map_or(target, |(stem, _)| stem);
    anchor.filter(|anchor| !anchor.is_empty()).map_or_else(|| stem.to_owned(), |anchor| format!("{stem}--{anchor}"))
}

/// A text as a string of Typst.
pub(super) fn string(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            '\n' => out.push_str("\\n"),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// A text as markup that means nothing but itself; white space counts once.
pub(super) fn say(text: &str, out: &mut String) {
    let mut was_space = false;
    for c in text.chars() {
        let is_space = c.is_ascii_whitespace();
        match c {
            _ if is_space && was_space => {}
            _ if is_space => out.push(' '),
            _ if c.is_ascii_punctuation() => out.extend(['\\', c]),
            c => out.push(c),
        }
        was_space = is_space;
    }
}
