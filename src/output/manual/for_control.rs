//! The text of a topic cut to one control: what it says of other controls goes.
//!
//! Topics are written once for all controls that they cover, and name a control where something holds for it alone: in a
//! heading, in the head of a column, in a cell of its own, or in a sentence. Invariant: what names no control, or this one,
//! stays; a topic that covers one control is not changed.

/// The names of controls in texts: those of this control, and those of the others that the topic covers.
pub struct Names<'n> {
    /// Of this control.
    pub own: Vec<&'n str>,
    /// Of the others.
    pub others: Vec<&'n str>,
}

/// The names that a printed title consists of: `TNC 426 / TNC 430` is called by either.
pub(super) fn names(title: &str) -> impl Iterator<Item = &str> {
    title.split('/').map(str::trim)
}

/// Of which controls a text speaks.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Of {
    /// Of none by name.
    All,
    /// Of this control, perhaps of others as well.
    Own,
    /// Of others only.
    Others,
}

impl Names<'_> {
    fn of(&self, text: &str) -> Of {
        match (self.own.iter().any(|name| has(text, name)), self.others.iter().any(|name| has(text, name))) {
            (true, _) => Of::Own,
            (false, true) => Of::Others,
            (false, false) => Of::All,
        }
    }

    /// Whether a text is nothing but names of controls.
    fn is_list(&self, text: &str) -> bool {
        if self.of(text) == Of::All {
            return false;
        }
        let mut rest = text.to_owned();
        for name in self.own.iter().chain(&self.others) {
            rest = rest.replace(name, "");
        }
        // Between the names there is a comma, a stroke or a word such as "and".
        let letters = rest.chars().filter(|c| c.is_alphabetic()).count();
        letters <= 4 && rest.chars().all(|c| c.is_lowercase() || c.is_whitespace() || matches!(c, ',' | '/'))
    }
}

/// Whether a name is in a text, and not the end of a longer one (`TNC 530` in `iTNC 530`).
fn has(text: &str, name: &str) -> bool {
    let starts = |at: usize| !text[..at].ends_with(|c: char| c.is_alphanumeric());
    text.match_indices(name).any(|(at, _)| starts(at))
}

/// The Markdown of a topic for one control.
pub fn keep(markdown: &str, names: &Names) -> String {
    if names.others.is_empty() {
        return markdown.to_owned();
    }
    let mut out = String::with_capacity(markdown.len());
    // The level of the heading that is left out with what is below it.
    let mut without: Option<usize> = None;
    // A block that introduced what follows was left out.
    let mut introduced = false;
    for block in blocks(markdown) {
        let first = block.first().copied().unwrap_or_default();
        let level = first.bytes().take_while(|byte| *byte == b'#').count();
        if level > 0 {
            introduced = false;
            if without.is_some_and(|own| level > own) {
                continue;
            }
            without = (names.of(first) == Of::Others).then_some(level);
        }
        if without.is_some() {
            continue;
        }
        let kind = Kind::of(first);
        let continues = matches!(kind, Kind::Table | Kind::List | Kind::Code);
        if introduced && continues {
            continue;
        }
        let kept = match kind {
            Kind::Code | Kind::Heading => block.join("\n"),
            Kind::Table => table(&block, names),
            Kind::List => list(&block, names),
            Kind::Text => prose(&block.join("\n"), names),
        };
        let leads_on = block.last().is_some_and(|line| line.trim_end().ends_with(':'));
        introduced = leads_on && !kept.trim_end().ends_with(':') || introduced && kept.is_empty();
        if !kept.is_empty() {
            out.push_str(&kept);
            out.push_str("\n\n");
        }
    }
    without_empty_headings(&out)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Heading,
    Table,
    List,
    Code,
    Text,
}

impl Kind {
    fn of(line: &str) -> Self {
        let numbered =
            line.split_once(". ").is_some_and(|(number, _)| number.bytes().all(|byte| byte.is_ascii_digit()));
        match line {
            _ if line.starts_with('#') => Self::Heading,
            _ if line.starts_with('|') => Self::Table,
            _ if line.starts_with("```") => Self::Code,
            _ if line.starts_with("- ") || numbered => Self::List,
            _ => Self::Text,
        }
    }
}

/// Lines between blank ones; a program is one block whatever is in it.
fn blocks(markdown: &str) -> Vec<Vec<&str>> {
    let mut blocks: Vec<Vec<&str>> = vec![Vec::new()];
    let mut in_code = false;
    for line in markdown.lines() {
        let fence = line.starts_with("```");
        let kind = |own: &Vec<&str>| own.first().map(|first| Kind::of(first));
        // A list or table may follow the line that introduces it without a blank one.
        let begins = !in_code
            && blocks.last().is_some_and(|last| {
                !last.is_empty() && kind(last) != Some(Kind::of(line)) && (fence || Kind::of(line) != Kind::Text)
            });
        if begins || (line.is_empty() && !in_code) {
            blocks.push(Vec::new());
        }
        if (!line.is_empty() || in_code)
            && let Some(last) = blocks.last_mut()
        {
            last.push(line);
        }
        in_code ^= fence;
        if fence && !in_code {
            blocks.push(Vec::new());
        }
    }
    blocks.retain(|block| !block.is_empty());
    blocks
}

/// Headings below which nothing is left are left out as well.
fn without_empty_headings(markdown: &str) -> String {
    let blocks = blocks(markdown);
    let level =
        |block: &Vec<&str>| block.first().map_or(0, |line| line.bytes().take_while(|byte| *byte == b'#').count());
    let mut out = String::with_capacity(markdown.len());
    for (at, block) in blocks.iter().enumerate() {
        let own = level(block);
        let empty = blocks.get(at + 1).is_none_or(|next| level(next) > 0 && level(next) <= own);
        if own == 0 || !empty {
            out.push_str(&block.join("\n"));
            out.push_str("\n\n");
        }
    }
    out
}

/// Rows and columns of other controls go, and what cells say of them.
fn table(lines: &[&str], names: &Names) -> String {
    let cells = |line: &str| -> Vec<String> {
        let line = line.trim().trim_start_matches('|');
        line.strip_suffix('|').unwrap_or(line).split('|').map(|cell| cell.trim().to_owned()).collect()
    };
    let rows: Vec<Vec<String>> = lines.iter().map(|line| cells(line)).collect();
    let Some(head) = rows.first() else { return String::new() };
    let keeps: Vec<bool> = head.iter().map(|cell| !(names.is_list(cell) && names.of(cell) == Of::Others)).collect();
    let of_controls = head.iter().filter(|cell| names.is_list(cell)).count();
    if of_controls > 1 && head.iter().zip(&keeps).all(|(cell, keep)| !keep || !names.is_list(cell)) {
        // It compares other controls only.
        return String::new();
    }
    let mut kept = Vec::new();
    for (at, row) in rows.iter().enumerate() {
        let own = row.iter().zip(keeps.iter().chain(std::iter::repeat(&true))).filter(|(_, keep)| **keep);
        let mut own: Vec<String> = own.map(|(cell, _)| cell.clone()).collect();
        if at > 1 {
            if own.iter().any(|cell| names.is_list(cell) && names.of(cell) == Of::Others) {
                continue;
            }
            let whole: Vec<String> = own.iter().map(|cell| prose(cell, names)).collect();
            if own.iter().zip(&whole).any(|(before, after)| after.is_empty() && !before.is_empty()) {
                continue;
            }
            own = whole;
            // What is left of a row is the meaning alone: this control has nothing for it.
            if of_controls > 0 && own.len() > 1 && own[1..].iter().all(|cell| matches!(cell.as_str(), "" | "–" | "-"))
            {
                continue;
            }
        }
        kept.push(format!("| {} |", own.join(" | ")));
    }
    if kept.len() > 2 { kept.join("\n") } else { String::new() }
}

/// Items of other controls go with what belongs to them.
fn list(lines: &[&str], names: &Names) -> String {
    let mut kept: Vec<String> = Vec::new();
    let mut without: Option<usize> = None;
    for line in lines {
        let indent = line.len() - line.trim_start().len();
        if without.is_some_and(|own| indent > own) {
            continue;
        }
        without = None;
        let body = line.trim_start();
        let mark = if body.starts_with("- ") { 2 } else { body.find(". ").map_or(0, |at| at + 2) };
        let text = prose(&body[mark..], names);
        if text.is_empty() {
            without = Some(indent);
        } else {
            kept.push(format!("{}{}{text}", &line[..indent], &body[..mark]));
        }
    }
    kept.join("\n")
}

/// Sentences, and parts of them between semicolons, that speak of other controls only go. A sentence that names no control
/// and follows one that went belongs to it.
fn prose(text: &str, names: &Names) -> String {
    if names.of(text) == Of::All {
        return text.to_owned();
    }
    let mut kept: Vec<String> = Vec::new();
    // Whether the sentence before went.
    let mut gone = false;
    for sentence in sentences(text) {
        let sentence = without_asides(sentence, names);
        let end = sentence.trim_end().chars().next_back().filter(|c| matches!(c, '.' | ':' | '!' | '?'));
        let all = parts(&sentence);
        let mut went = gone;
        let mut own: Vec<&str> = Vec::new();
        for part in &all {
            went = match names.of(&without_brackets(part)) {
                Of::Others => true,
                Of::Own => false,
                Of::All => went,
            };
            if !went {
                own.push(part);
            }
        }
        gone = own.is_empty();
        let mut whole = own.join("; ");
        // A name such as iTNC keeps its small letter.
        let is_name = whole.chars().nth(1).is_some_and(char::is_uppercase);
        if own.first() != all.first() && !is_name {
            let mut letters = whole.chars();
            whole = letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect());
        }
        if let Some(end) = end.filter(|end| !gone && !whole.trim_end().ends_with(*end)) {
            whole.push(end);
        }
        kept.extend((!gone).then_some(whole));
    }
    kept.join(" ")
}

/// The parts of a sentence between semicolons; those within brackets separate nothing.
fn parts(sentence: &str) -> Vec<&str> {
    let mut parts = Vec::new();
    let mut start = 0;
    let mut depth = 0usize;
    for (at, c) in sentence.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            ';' if depth == 0 && sentence[at + 1..].starts_with(' ') => {
                parts.push(&sentence[start..at]);
                start = at + 2;
            }
            _ => {}
        }
    }
    parts.push(&sentence[start..]);
    parts
}

/// Sentences: each ends with a full stop before a capital letter, a code or a link.
fn sentences(text: &str) -> Vec<&str> {
    let mut sentences = Vec::new();
    let mut start = 0;
    for (at, sign) in text.match_indices(['.', '!', '?']) {
        let after = &text[at + sign.len()..];
        let begins = |c: char| c.is_uppercase() || matches!(c, '`' | '[' | '*' | '"');
        if after.starts_with([' ', '\n']) && after.trim_start().starts_with(begins) {
            sentences.push(text[start..=at].trim());
            start = at + 1;
        }
    }
    sentences.push(text[start..].trim());
    sentences.retain(|sentence| !sentence.is_empty());
    sentences
}

/// The sentence without what brackets say with a colon of other controls: `(TNC 320: only Q173)` as a whole, of
/// `(set by M1; TNC 320: by M2)` the second part.
fn without_asides(sentence: &str, names: &Names) -> String {
    let mut out = String::with_capacity(sentence.len());
    let mut rest = sentence;
    while let Some((before, inside)) = rest.split_once(" (") {
        let Some((aside, after)) = inside.split_once(')') else { break };
        out.push_str(before);
        let of_others = |part: &&str| {
            part.split_once(':').is_some_and(|(who, _)| names.is_list(who)) && names.of(part) == Of::Others
        };
        let own: Vec<&str> = aside.split("; ").filter(|part| !of_others(part)).collect();
        if !own.is_empty() {
            out.push_str(" (");
            out.push_str(&own.join("; "));
            out.push(')');
        }
        rest = after;
    }
    out.push_str(rest);
    out
}

/// The text without its brackets: what they mention does not decide of which control a sentence speaks.
fn without_brackets(text: &str) -> String {
    let mut depth = 0usize;
    let outside = |c: &char| {
        match c {
            '(' => depth += 1,
            ')' if depth > 0 => {
                depth -= 1;
                return false;
            }
            _ => {}
        }
        depth == 0
    };
    text.chars().filter(outside).collect()
}
