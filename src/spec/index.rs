//! What the specifications hold, a line each, so that only what is asked for has to be read: the controls, the
//! fragments, the cycles of each control, and the ranges that all parameters together have.
//!
//! The build script writes it from the trees of the embedded files. Invariant: nothing is in it that the files do not
//! say; the tests compare it with what comes of reading them all.
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use super::filter;
use super::yaml::Node;

/// The index, in the words of the files.
#[derive(Debug, Default)]
pub(crate) struct Index<'i> {
    /// The ids of the controls with the paths of their profiles.
    pub(crate) controls: Vec<(&'i str, &'i str)>,
    /// The names of the fragments with the paths of their files.
    pub(crate) fragments: Vec<(&'i str, &'i str)>,
    /// The names of the meanings with the paths of their files.
    pub(crate) meanings: Vec<(&'i str, &'i str)>,
    /// The cycles of the controls.
    pub(crate) cycles: Vec<CycleLine<'i>>,
    /// The ranges of the parameters.
    pub(crate) ranges: Vec<RangeLine<'i>>,
}

/// A cycle on a control.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CycleLine<'i> {
    pub(crate) path: &'i str,
    pub(crate) control: &'i str,
    pub(crate) keyword: &'i str,
    pub(crate) number: u32,
    pub(crate) name: &'i str,
    /// The cycle whose run it has.
    pub(crate) like: Option<&'i str>,
    codes: &'i str,
    parameters: &'i str,
}

/// What is printed for all parameters that mean the same and are of the same kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RangeLine<'i> {
    pub(crate) meaning: &'i str,
    pub(crate) kind: &'i str,
    pub(crate) quantity: &'i str,
    /// Whether they are fields of old-style lines.
    pub(crate) field: bool,
    /// The widest range of those that have both ends.
    pub(crate) range: Option<(f64, f64)>,
    /// The greatest value of any.
    pub(crate) greatest: Option<f64>,
}

#[allow(dead_code, reason = "the build script writes, the program reads")]
impl<'i> CycleLine<'i> {
    /// Its DIN/ISO codes, each with the index of the form that it stands for.
    pub(crate) fn codes(&self) -> impl Iterator<Item = (Option<usize>, &'i str)> {
        self.codes
            .split_whitespace()
            .filter_map(|code| code.split_once(':'))
            .map(|(form, code)| (form.parse().ok(), code))
    }

    /// The Q parameters that its definition has.
    pub(crate) fn parameters(&self) -> impl Iterator<Item = &'i str> {
        self.parameters.split_whitespace()
    }
}

#[allow(dead_code, reason = "the build script writes, the program reads")]
impl<'i> Index<'i> {
    /// Reads an index; lines that are none are passed over.
    pub(crate) fn read(text: &'i str) -> Self {
        let mut index = Self::default();
        for line in text.lines() {
            let mut words = line.split('\t');
            let kind = words.next();
            let mut word = || words.next().unwrap_or_default();
            match kind {
                Some("control") => index.controls.push((word(), word())),
                Some("fragment") => index.fragments.push((word(), word())),
                Some("meaning") => index.meanings.push((word(), word())),
                Some("cycle") => index.cycles.push(CycleLine {
                    path: word(),
                    control: word(),
                    keyword: word(),
                    number: word().parse().unwrap_or_default(),
                    name: word(),
                    like: Some(word()).filter(|like| !like.is_empty()),
                    codes: word(),
                    parameters: word(),
                }),
                Some("range") => {
                    let (meaning, kind, quantity, field) = (word(), word(), word(), word() == "field");
                    let mut number = || word().parse().ok();
                    let range = number().zip(number());
                    index.ranges.push(RangeLine { meaning, kind, quantity, field, range, greatest: number() });
                }
                _ => {}
            }
        }
        index
    }
}

/// Writes the index of all files, paths and trees; nothing if they contradict each other.
#[allow(dead_code, reason = "the build script writes, the program reads")]
pub(crate) fn write(files: &[(String, Node)]) -> Option<String> {
    let below = |folder: &str| {
        let prefix = format!("cycle-specs/{folder}/");
        files.iter().filter(move |(path, _)| path.starts_with(&prefix))
    };
    let mut out = String::new();
    let mut controls = BTreeSet::new();
    for (path, node) in below("controls") {
        let id = text(node, "control")?;
        let _ = writeln!(out, "control\t{id}\t{path}");
        controls.insert(id).then_some(())?;
    }
    let mut fragments = BTreeSet::new();
    for (path, node) in below("fragments") {
        let name = text(node, "fragment")?;
        let _ = writeln!(out, "fragment\t{name}\t{path}");
        fragments.insert(name).then_some(())?;
    }
    for (path, node) in below("parameters") {
        let super::yaml::Kind::Map(entries) = &node.get("parameters")?.kind else { return None };
        for (name, _) in entries {
            let _ = writeln!(out, "meaning\t{}\t{path}", name.text);
        }
    }
    let dictionary: Vec<&Node> = below("parameters").map(|(_, node)| node).collect();
    let cycles = files.iter().filter(|(path, _)| {
        let folder = path.strip_prefix("cycle-specs/").and_then(|rest| rest.split_once('/'));
        folder.is_some_and(|(folder, _)| {
            !["controls", "fragments", "machines", "parameters", "programs"].contains(&folder)
        })
    });
    let cycles: Vec<&(String, Node)> = cycles.collect();
    let mut ranges = Ranges::default();
    for control in controls {
        let dictionary: Vec<Node> = dictionary.iter().map(|file| filter::for_control(file, control)).collect();
        let meanings = meanings(&dictionary)?;
        let mut known = BTreeSet::new();
        for (path, file) in &cycles {
            let file = filter::for_control(file, control);
            if !items(&file, "controls").iter().any(|own| text(own, "control") == Some(control)) {
                continue;
            }
            let (keyword, number, name) = (text(&file, "keyword")?, text(&file, "cycle")?, text(&file, "name")?);
            let like = text(&file, "like").unwrap_or_default();
            let new = known.insert(format!("{keyword} {number}")) && known.insert(name.to_owned());
            new.then_some(())?;
            let (codes, parameters) = (codes(&file), parameters(&file));
            let _ =
                writeln!(out, "cycle\t{path}\t{control}\t{keyword}\t{number}\t{name}\t{like}\t{codes}\t{parameters}");
            ranges.add(&file, &meanings)?;
        }
    }
    ranges.write(&mut out);
    Some(out)
}

fn text<'n>(node: &'n Node, key: &str) -> Option<&'n str> {
    node.get(key)?.text()
}

fn items<'n>(node: &'n Node, key: &str) -> &'n [Node] {
    node.get(key).map_or(&[], Node::items)
}

fn meanings(dictionary: &[Node]) -> Option<BTreeMap<&str, &Node>> {
    let mut meanings = BTreeMap::new();
    for file in dictionary {
        let super::yaml::Kind::Map(entries) = &file.get("parameters")?.kind else { return None };
        for (name, meaning) in entries {
            meanings.insert(&*name.text, meaning).is_none().then_some(())?;
        }
    }
    Some(meanings)
}

fn codes(file: &Node) -> String {
    let mut codes = String::new();
    let whole = items(file, "iso").iter().map(|iso| ("-".to_owned(), iso));
    let forms = items(file, "forms").iter().enumerate();
    let forms = forms.flat_map(|(at, form)| items(form, "iso").iter().map(move |iso| (at.to_string(), iso)));
    for (form, iso) in whole.chain(forms) {
        let _ = write!(codes, "{form}:{} ", text(iso, "code").unwrap_or_default());
    }
    codes
}

fn parameters(file: &Node) -> String {
    let all: Vec<&str> = items(file, "parameters").iter().filter_map(|own| text(own, "q")).collect();
    all.join(" ")
}

/// Meaning, kind, quantity, and whether it is a field.
type Alike = (String, String, String, bool);

#[derive(Default)]
struct Ranges(BTreeMap<Alike, (Option<(f64, f64)>, Option<f64>)>);

impl Ranges {
    fn add(&mut self, file: &Node, meanings: &BTreeMap<&str, &Node>) -> Option<()> {
        let fields = items(file, "forms").iter().flat_map(|form| items(form, "lines"));
        let fields = fields.flat_map(|line| items(line, "fields")).map(|own| (own, true));
        for (own, field) in items(file, "parameters").iter().map(|own| (own, false)).chain(fields) {
            let name = text(own, "is")?;
            let meaning = meanings.get(name)?;
            let either = |key: &str| own.get(key).or_else(|| meaning.get(key));
            let word = |key: &str, usual: &str| either(key).and_then(Node::text).unwrap_or(usual).to_owned();
            let range = either("ranges").and_then(|ranges| ranges.items().first());
            let end = |key: &str| range.and_then(|range| text(range, key)).and_then(|end| end.parse::<f64>().ok());
            let key = (name.to_owned(), word("kind", "number"), word("quantity", "none"), field);
            let (known, greatest) = self.0.entry(key).or_default();
            if let Some((least, most)) = end("min").zip(end("max")) {
                *known = Some(known.map_or((least, most), |(from, to)| (from.min(least), to.max(most))));
            }
            *greatest = [*greatest, end("max")].into_iter().flatten().reduce(f64::max);
        }
        Some(())
    }

    fn write(&self, out: &mut String) {
        let shown = |number: Option<f64>| number.map_or(String::new(), |number| number.to_string());
        for ((meaning, kind, quantity, field), (range, greatest)) in &self.0 {
            let field = if *field { "field" } else { "" };
            let (least, most) = (shown(range.map(|range| range.0)), shown(range.map(|range| range.1)));
            let greatest = shown(*greatest);
            let _ = writeln!(out, "range\t{meaning}\t{kind}\t{quantity}\t{field}\t{least}\t{most}\t{greatest}");
        }
    }
}
