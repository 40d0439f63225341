//! Worked programs: whole programs with comments, which the manual shows and `conform` executes.
//!
//! Invariant: a comment is an id here, `;{id}` at the end of a line; its words are in the locales.
use super::catalogue::{Cycle, CycleKey, OnControl};
use super::decode::{Entries, Name, record};
use super::figure_form::Figure;
use super::form::{Example, See, Tree};

record! {
    /// A control that can execute the program as it is.
    pub struct WorkedOn {
        /// The control.
        control: Name,
    }
}

record! {
    /// The file of a worked program.
    pub struct WorkedFile {
        /// Its name; texts `program-<name>` with the attribute `.shows`.
        worked: Name,
        /// The cycle that it is about: its cases are executed with those of that cycle.
        of: See,
        /// The controls that can execute it.
        controls: Vec<WorkedOn>,
        /// The program, with English names and labels; `;{id}` at the end of a line is the comment `comment-<id>`.
        program: Name,
        /// The programs that it calls, by their names, written like it.
        programs: Entries<Name>,
        /// The scene.
        scene: Option<Tree>,
        /// Its pictures, as figures of a cycle.
        figures: Vec<Figure>,
        /// What must come out, as in a conformance case.
        expect: Option<Tree>,
        /// Where the expected numbers come from.
        why: Option<String>,
    }
}

/// A worked program on a control.
#[derive(Clone, Debug)]
pub struct Worked {
    /// The cycle that it is about.
    pub key: CycleKey,
    /// It as a conformance case.
    pub example: Example,
    /// Its pictures.
    pub figures: Vec<Figure>,
}

impl Worked {
    /// The program of a file, if that control can execute it.
    pub(super) fn new(file: WorkedFile, control: &str) -> Option<Self> {
        file.controls.iter().any(|own| own.control.as_str() == control).then_some(())?;
        let example = Example {
            name: file.worked,
            given: Entries::default(),
            form: None,
            program: Some(file.program),
            programs: file.programs,
            before: Vec::new(),
            after: Vec::new(),
            scene: file.scene,
            proves: Vec::new(),
            expect: file.expect,
            why: file.why,
            skip: None,
            place: file.place,
        };
        Some(Self { key: CycleKey::new(file.of.keyword, file.of.cycle), example, figures: file.figures })
    }

    /// Its name.
    pub fn name(&self) -> &str {
        self.example.name.as_str()
    }

    /// The program, with ids in place of comments.
    pub fn text(&self) -> &str {
        self.example.program.as_ref().map_or("", Name::as_str)
    }

    /// The programs that it calls: the name and the text of each.
    pub fn called(&self) -> impl Iterator<Item = (&str, &str)> {
        self.example.programs.0.iter().map(|(name, text)| (name.as_str(), text.as_str()))
    }

    /// The ids of the comments of all of its programs, in their order.
    pub fn comments(&self) -> impl Iterator<Item = &str> {
        let all = std::iter::once(self.text()).chain(self.called().map(|(_, text)| text));
        all.flat_map(str::lines).filter_map(|line| comment(line).map(|(_, id)| id))
    }

    /// The program with other words in place of the ids of its comments.
    pub fn with_comments(text: &str, words: &dyn Fn(&str) -> String) -> String {
        let mut out = String::with_capacity(text.len());
        for line in text.lines() {
            match comment(line) {
                Some((block, id)) => {
                    out.push_str(block);
                    out.push_str("; ");
                    out.push_str(&words(id));
                }
                None => out.push_str(line),
            }
            out.push('\n');
        }
        out
    }
}

/// A line that ends with `;{id}`: what is before that, and the id.
fn comment(line: &str) -> Option<(&str, &str)> {
    line.trim_end().strip_suffix('}')?.rsplit_once(";{")
}

impl OnControl {
    /// The worked programs about a cycle.
    pub fn worked_of(&self, key: CycleKey) -> impl Iterator<Item = &Worked> {
        self.worked.iter().filter(move |worked| worked.key == key)
    }

    /// What is executed for a cycle: its own conformance cases, then the worked programs about it.
    pub fn cases_of<'c>(&'c self, cycle: &'c Cycle) -> impl Iterator<Item = &'c Example> {
        cycle.file.examples.iter().chain(self.worked_of(cycle.key).map(|worked| &worked.example))
    }
}
