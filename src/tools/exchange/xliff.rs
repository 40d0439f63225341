//! XLIFF 1.2 and 2.0: placeables are protected codes, `ph`, with what they are in Fluent as their native data.
//!
//! Invariant: a document type is refused, and with it every entity of its own; nothing is fetched or expanded.
use std::collections::HashMap;
use std::fmt::Write as _;

use quick_xml::escape::escape;

use super::fluent::{Piece, merged};
use super::received::{Form, Received, Returned, Unreadable};
use super::status::State;
use super::unit::Unit;
use crate::base::xml::{self, Node};
use crate::language::locale::SOURCE_LANGUAGE;

const HEAD: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
/// States in which a translation is taken over.
const FINAL: [&str; 2] = ["final", "signed-off"];

/// The units of a language as a file.
pub(super) fn write(units: &[Unit], tag: &str, form: Form) -> String {
    let mut text = String::from(HEAD);
    let two = form == Form::Xliff2;
    let tag = escape(tag);
    let _ = match two {
        true => writeln!(
            text,
            "<xliff version=\"2.0\" xmlns=\"urn:oasis:names:tc:xliff:document:2.0\" srcLang=\"{SOURCE_LANGUAGE}\" trgLang=\"{tag}\">"
        ),
        false => writeln!(text, "<xliff version=\"1.2\" xmlns=\"urn:oasis:names:tc:xliff:document:1.2\">"),
    };
    let mut from = 0;
    for (index, group) in units.chunk_by(|a, b| a.file == b.file).enumerate() {
        let file = escape(group.first().map_or("", |unit| unit.file.as_str()));
        let _ = match two {
            true => writeln!(text, "  <file id=\"f{}\" original=\"{file}\">", index + 1),
            false => writeln!(
                text,
                "  <file original=\"{file}\" source-language=\"{SOURCE_LANGUAGE}\" target-language=\"{tag}\" datatype=\"plaintext\">\n    <body>"
            ),
        };
        for unit in group {
            from += 1;
            if two { second(&mut text, unit, from) } else { first(&mut text, unit) }
        }
        text += if two { "  </file>\n" } else { "    </body>\n  </file>\n" };
    }
    text + "</xliff>\n"
}

fn first(text: &mut String, unit: &Unit) {
    let approved = if unit.state.is_none() { " approved=\"yes\"" } else { "" };
    let most = unit.most.map_or_else(String::new, |most| format!(" maxwidth=\"{most}\" size-unit=\"char\""));
    let _ = writeln!(text, "      <trans-unit id=\"{}\"{approved}{most} xml:space=\"preserve\">", escape(&unit.id));
    let mut data = Codes::default();
    let _ = writeln!(text, "        <source>{}</source>", inline(&unit.source, &mut data, false));
    if !unit.target.is_empty() {
        let state = match unit.state {
            None => "final",
            Some(State::Missing) => "needs-translation",
            Some(_) => "needs-review-translation",
        };
        let _ = writeln!(text, "        <target state=\"{state}\">{}</target>", inline(&unit.target, &mut data, false));
    }
    for note in &unit.notes {
        let _ = writeln!(text, "        <note>{}</note>", escape(note));
    }
    *text += "      </trans-unit>\n";
}

fn second(text: &mut String, unit: &Unit, number: usize) {
    let mut data = Codes::default();
    let source = inline(&unit.source, &mut data, true);
    let target = inline(&unit.target, &mut data, true);
    let _ = writeln!(text, "    <unit id=\"u{number}\" name=\"{}\" xml:space=\"preserve\">", escape(&unit.id));
    *text += "      <notes>\n";
    for note in &unit.notes {
        let _ = writeln!(text, "        <note>{}</note>", escape(note));
    }
    *text += "      </notes>\n";
    if !data.0.is_empty() {
        *text += "      <originalData>\n";
        for (index, code) in data.0.iter().enumerate() {
            let _ = writeln!(text, "        <data id=\"d{}\">{}</data>", index + 1, escape(code));
        }
        *text += "      </originalData>\n";
    }
    let state = match unit.state {
        None => "final",
        Some(State::Missing) => "initial",
        Some(_) => "translated",
    };
    let _ = writeln!(text, "      <segment state=\"{state}\">\n        <source>{source}</source>");
    if !unit.target.is_empty() {
        let _ = writeln!(text, "        <target>{target}</target>");
    }
    *text += "      </segment>\n    </unit>\n";
}

/// The codes of a unit, numbered as they are met.
#[derive(Default)]
struct Codes(Vec<String>);

impl Codes {
    fn number(&mut self, code: &str) -> usize {
        let known = self.0.iter().position(|own| own == code);
        known.unwrap_or_else(|| {
            self.0.push(code.to_owned());
            self.0.len() - 1
        }) + 1
    }
}

fn inline(pieces: &[Piece], codes: &mut Codes, two: bool) -> String {
    let mut text = String::new();
    let mut met: HashMap<usize, usize> = HashMap::new();
    for piece in pieces {
        match piece {
            Piece::Text(words) => text += &escape(words),
            Piece::Code(code) => {
                let number = codes.number(code);
                // The same code may be there several times; every one has an identifier of its own.
                let times = met.entry(number).and_modify(|times| *times += 1).or_insert(1);
                let id = if *times == 1 { number.to_string() } else { format!("{number}-{times}") };
                let reads = escape(readable(code));
                let code = escape(code);
                let _ = match two {
                    true => write!(text, "<ph id=\"{id}\" dataRef=\"d{number}\" equiv=\"{reads}\" disp=\"{code}\"/>"),
                    false => write!(text, "<ph id=\"{id}\" equiv-text=\"{reads}\">{code}</ph>"),
                };
            }
        }
    }
    text
}

/// What a person reads in place of a code.
fn readable(code: &str) -> &str {
    let inside = code.trim_start_matches(['{', ' ', '$', '-']).trim_end_matches(['}', ' ']);
    inside.split(['(', ' ']).next().unwrap_or(inside)
}

/// The units of a file.
pub(super) fn read(text: &str) -> Result<Returned, Unreadable> {
    let root = xml::parse(text)?;
    let version = root.attribute("version").unwrap_or_default();
    if root.name != "xliff" || !(version == "1.2" || version.starts_with("2.")) {
        return Err(Unreadable { at: 0, what: "xliff" });
    }
    let mut units = Vec::new();
    gather(&root, &mut units);
    let first = root.child("file").and_then(|file| file.attribute("target-language"));
    let language = root.attribute("trgLang").or(first).map(str::to_owned);
    Ok(Returned { language, units })
}

fn gather(node: &Node, units: &mut Vec<Received>) {
    for child in &node.children {
        match child.name.as_str() {
            "trans-unit" => units.push(of_first(child)),
            "unit" => units.push(of_second(child)),
            "file" | "body" | "group" => gather(child, units),
            _ => {}
        }
    }
}

fn of_first(node: &Node) -> Received {
    let target = node.child("target");
    let state = target.and_then(|target| target.attribute("state"));
    let approved = node.attribute("approved") == Some("yes");
    let data = HashMap::new();
    Received {
        id: node.attribute("id").unwrap_or_default().to_owned(),
        at: node.at,
        is_final: approved && state.is_none_or(|state| FINAL.contains(&state) || state == "translated")
            || state.is_some_and(|state| FINAL.contains(&state)),
        source: node.child("source").and_then(|node| pieces(node, &data)),
        target: target.and_then(|node| pieces(node, &data)),
    }
}

fn of_second(node: &Node) -> Received {
    let data = node.child("originalData").map_or_else(HashMap::new, |data| {
        data.children.iter().filter_map(|data| Some((data.attribute("id")?, data.text()))).collect()
    });
    let segments: Vec<&Node> = node.children.iter().filter(|child| child.name == "segment").collect();
    let joined = |name: &str| {
        let parts = segments.iter().map(|segment| pieces(segment.child(name)?, &data));
        let parts: Option<Vec<Vec<Piece>>> = parts.collect();
        parts.map(|parts| merged(parts.concat()))
    };
    Received {
        id: node.attribute("name").unwrap_or_default().to_owned(),
        at: node.at,
        is_final: !segments.is_empty() && segments.iter().all(|segment| segment.attribute("state") == Some("final")),
        source: joined("source"),
        target: joined("target"),
    }
}

/// Text and codes of a source or target; nothing if there is something else in it.
fn pieces(node: &Node, data: &HashMap<&str, String>) -> Option<Vec<Piece>> {
    let mut all = Vec::new();
    for child in &node.children {
        match child.name.as_str() {
            "" => all.push(Piece::Text(child.words.clone())),
            "mrk" => all.extend(pieces(child, data)?),
            "ph" => all.push(Piece::Code(match child.attribute("dataRef") {
                // Some tools lose the original data, and keep what is displayed.
                Some(id) => data.get(id).map(String::as_str).or(child.attribute("disp"))?.to_owned(),
                None => child.text(),
            })),
            _ => return None,
        }
    }
    Some(merged(all))
}
