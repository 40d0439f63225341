//! The words of the trade: the glossary and the dictionary of parameters as a termbase, TBX (ISO 30042:2008), and as a table, CSV.
use std::fmt::Write as _;

use quick_xml::escape::escape;

use crate::language::locale::{Key, Language, Locales, SOURCE_LANGUAGE, Scope};

/// Kinds of concepts, with what the identifiers of their messages begin with.
const KINDS: [(&str, &str); 2] = [("term-", "definition"), ("parameter-", "help")];
/// What is between the words of a list.
pub(super) const BETWEEN: &str = " | ";
/// The columns of the table.
const COLUMNS: &str = "concept,language,term,label,forms,forbidden,definition,context\r\n";

/// A word of the trade or a parameter.
#[derive(Clone, Debug)]
pub struct Concept {
    /// The message: `term-infeed`, `parameter-depth`.
    pub id: String,
    /// What is said about it: units, ranges, cycles, a line each.
    pub context: Vec<String>,
    /// What it is called in each language, the source first.
    pub words: Vec<Words>,
}

/// A concept in a language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Words {
    /// The tag.
    pub language: String,
    /// The term.
    pub term: String,
    /// The label of a parameter in NC programs.
    pub label: Option<String>,
    /// Inflected forms, or what they begin with.
    pub forms: Vec<String>,
    /// Words that must not be used for it.
    pub forbidden: Vec<String>,
    /// What it means.
    pub definition: Option<String>,
}

/// The attribute that says what a concept means.
pub(super) fn definition_of(id: &str) -> &'static str {
    KINDS.iter().find(|(head, _)| id.starts_with(head)).map_or("definition", |(_, name)| name)
}

/// All concepts in these languages and in the source, in the order of their identifiers.
pub fn concepts(locales: &Locales, tags: &[String]) -> Vec<Concept> {
    let Some(source) = locales.source() else { return Vec::new() };
    let of = |id: &str| KINDS.iter().find(|(head, _)| id.starts_with(head));
    let mut ids: Vec<(&str, &str)> = source.ids().filter_map(|id| Some((id, of(id)?.1))).collect();
    ids.sort_unstable();
    let others = locales.iter().filter(|language| tags.iter().any(|tag| tag == language.tag()));
    let others: Vec<&Language> = others.filter(|language| language.tag() != SOURCE_LANGUAGE).collect();
    let concept = |(id, definition): (&str, &str)| {
        let all = std::iter::once(source).chain(others.iter().copied());
        let words: Vec<Words> = all.filter_map(|language| words(language, id, definition)).collect();
        (!words.is_empty()).then(|| Concept { id: id.to_owned(), context: Vec::new(), words })
    };
    ids.into_iter().filter_map(concept).collect()
}

fn words(language: &Language, id: &str, definition: &str) -> Option<Words> {
    let text = |attribute| {
        let (text, _) = language.raw(Key { id, attribute }, Scope::NONE)?;
        Some(text.split_whitespace().collect::<Vec<_>>().join(" ")).filter(|text| !text.is_empty())
    };
    let list = |name| {
        let text: String = text(Some(name)).unwrap_or_default();
        text.split('|').map(str::trim).filter(|word| !word.is_empty()).map(str::to_owned).collect()
    };
    Some(Words {
        language: language.tag().to_owned(),
        term: text(None)?,
        label: text(Some("label")),
        forms: list("forms"),
        forbidden: list("forbidden"),
        definition: text(Some(definition)),
    })
}

/// The concepts as a table, RFC 4180: a row a concept and language, lists separated by ` | `.
pub fn csv(concepts: &[Concept]) -> String {
    let mut csv = String::from(COLUMNS);
    for concept in concepts {
        let context = concept.context.join(BETWEEN);
        for words in &concept.words {
            let (forms, forbidden) = (words.forms.join(BETWEEN), words.forbidden.join(BETWEEN));
            let cells: [&str; 8] = [
                &concept.id,
                &words.language,
                &words.term,
                words.label.as_deref().unwrap_or_default(),
                &forms,
                &forbidden,
                words.definition.as_deref().unwrap_or_default(),
                &context,
            ];
            csv += &cells.map(cell).join(",");
            csv += "\r\n";
        }
    }
    csv
}

fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

/// The concepts as a termbase, TBX-Basic in the form that translation tools read, with the root `martif`. The label of a parameter is an abbreviation of its name, a
/// forbidden word a deprecated term; forms are a note, since they are beginnings of words.
pub fn tbx(concepts: &[Concept]) -> String {
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<martif type=\"TBX-Basic\" xml:lang=\"{SOURCE_LANGUAGE}\">\n  <martifHeader>\n    <fileDesc>\n      <sourceDesc>\n        <p>Ciklo {}</p>\n      </sourceDesc>\n    </fileDesc>\n    <encodingDesc>\n      <p type=\"XCSURI\">TBXBasicXCSV02.xcs</p>\n    </encodingDesc>\n  </martifHeader>\n  <text>\n    <body>\n",
        env!("CARGO_PKG_VERSION")
    );
    for concept in concepts {
        let _ = writeln!(text, "      <termEntry id=\"{}\">", escape(&concept.id));
        let subject = if concept.id.starts_with("parameter-") { "parameters of CNC cycles" } else { "CNC cycles" };
        let _ = writeln!(text, "        <descrip type=\"subjectField\">{subject}</descrip>");
        for line in &concept.context {
            let _ = writeln!(text, "        <note>{}</note>", escape(line));
        }
        concept.words.iter().for_each(|words| in_language(&mut text, words));
        text += "      </termEntry>\n";
    }
    text + "    </body>\n  </text>\n</martif>\n"
}

fn in_language(text: &mut String, words: &Words) {
    let _ = writeln!(text, "        <langSet xml:lang=\"{}\">", escape(&words.language));
    if let Some(definition) = &words.definition {
        let _ = writeln!(text, "          <descrip type=\"definition\">{}</descrip>", escape(definition));
    }
    let mut term = |term: &str, kind: &str, status: &str, note: &str| {
        let _ = writeln!(text, "          <tig>\n            <term>{}</term>", escape(term));
        let _ = writeln!(text, "            <termNote type=\"termType\">{kind}</termNote>");
        let _ = writeln!(text, "            <termNote type=\"administrativeStatus\">{status}-admn-sts</termNote>");
        if !note.is_empty() {
            let _ = writeln!(text, "            <note>{}</note>", escape(note));
        }
        *text += "          </tig>\n";
    };
    term(&words.term, "fullForm", "preferredTerm", &words.forms.join(BETWEEN));
    if let Some(label) = words.label.as_ref().filter(|label| **label != words.term) {
        term(label, "abbreviation", "admittedTerm", "");
    }
    words.forbidden.iter().for_each(|word| term(word, "variant", "deprecatedTerm", ""));
    *text += "        </langSet>\n";
}
