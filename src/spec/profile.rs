//! Profiles of the controls, the errata of their manuals, and the topics that they cover.
use super::decode::{Entries, Name, record, words};
use super::form::ManualLines;
use super::vocabulary::Keyword;

record! {
    /// The rules of NC labels on a control.
    pub struct LabelRules {
        /// The greatest number of characters.
        max_length: u32,
        /// Where the limit comes from.
        why: String,
    }
}

record! {
    /// How a control joins the lines of a printed block.
    pub struct BlockLayout {
        /// The sign at the end of every line that is continued.
        continuation: String,
        /// The manuals that print it.
        manuals: Vec<String>,
    }
}

record! {
    /// A software option.
    pub struct OptionName {
        /// Its number.
        number: u32,
        /// Its id.
        option: Name,
    }
}

record! {
    /// Where a manual names something.
    pub struct NamedIn {
        /// The three-digit head of the manual's file name.
        manual: String,
        /// The lines.
        lines: String,
    }
}

record! {
    /// Functions of the language that a manual shows.
    pub struct FunctionShown {
        /// The words that they are printed with, such as `PLANE SPATIAL` or `M128`.
        function: Vec<String>,
        /// Where.
        source: NamedIn,
        /// The number of the software option that they belong to.
        option: Option<u32>,
    }
}

record! {
    /// Functions of the language, and cycles, that a control does not have.
    pub struct FunctionLacking {
        /// The words that they are printed with, such as `PATTERN DEF` or `CYCL DEF 251`;
        /// what follows them does not matter.
        function: Vec<String>,
        /// How that is known.
        why: String,
    }
}

words! {
    /// A transformation that the engine knows to be in effect but does not execute.
    pub enum Transformation {
        /// A mirror image.
        Mirroring = "mirroring",
        /// Scaling.
        Scaling = "scaling",
        /// Scaling by axes.
        AxisScaling = "axis-scaling",
        /// A tilted working plane.
        Tilting = "tilting",
        /// Turning mode; a block of the program brings it into effect.
        Turning = "turning",
    }
}

record! {
    /// A cycle that a manual names.
    pub struct Named {
        /// How it is written.
        keyword: Keyword,
        /// Its number.
        number: u32,
        /// The printed name.
        name: String,
        /// Where.
        source: NamedIn,
        /// What its definition brings into effect: enough for cycles that refuse it.
        activates: Option<Transformation>,
    }
}

record! {
    /// A control.
    pub struct Control {
        /// Its id, such as `tnc640`.
        control: Name,
        /// Other names for it on the command line and in configurations: those of single models.
        also: Vec<Name>,
        /// Its printed name.
        title: String,
        /// The heads of the file names of its manuals.
        manuals: Vec<String>,
        /// The language of its manual.
        language: Name,
        /// The rules of NC labels.
        label: LabelRules,
        /// The layout of printed blocks.
        block: Option<BlockLayout>,
        /// Printed names of machine data by their neutral names.
        data: Entries<Name>,
        /// Names of its table files, by the tables that cycles name.
        files: Entries<Name>,
        /// Software options.
        options: Vec<OptionName>,
        /// The keywords of the cycles that its manuals give in full: what they do not name there does not exist.
        covers: Vec<Keyword>,
        /// Functions of the language, beyond cycles and what every control has, that its manuals show.
        functions: Vec<FunctionShown>,
        /// The greatest number of a label, if it is less than labels can have at all.
        greatest_label: Option<u32>,
        /// Functions and cycles that it does not have, where no manual needs to say so.
        lacks: Vec<FunctionLacking>,
        /// Every cycle that its manuals name.
        named: Vec<Named>,
    }
}

impl Control {
    /// Whether a name is one of its other names, in whichever case.
    pub fn is_called(&self, name: &str) -> bool {
        self.also.iter().any(|own| own.as_str().eq_ignore_ascii_case(name))
    }

    /// Its id, followed in brackets by its other names.
    pub fn names(&self) -> String {
        let also: Vec<&str> = self.also.iter().map(Name::as_str).collect();
        match also.as_slice() {
            [] => self.control.as_str().to_owned(),
            _ => format!("{} ({})", self.control.as_str(), also.join(", ")),
        }
    }
}

record! {
    /// A control whose manual covers a topic.
    pub struct TopicOn {
        /// The control.
        control: Name,
        /// Where its manual speaks of it.
        sources: Vec<ManualLines>,
    }
}

record! {
    /// A page of prose about what surrounds the cycles; the text is `topics/<topic>.md` of each language.
    pub struct Topic {
        /// Its id, which is also the name of its file.
        topic: Name,
        /// The controls whose manuals cover it.
        controls: Vec<TopicOn>,
    }
}

record! {
    /// The file of topics.
    pub struct Topics {
        /// The topics, in the order of the overview.
        topics: Option<Vec<Topic>>,
    }
}

record! {
    /// A misprint, contradiction or silence, and what was decided.
    pub struct Erratum {
        /// Its id.
        id: Name,
        /// The control.
        control: Option<Name>,
        /// The cycle, keyword and number.
        cycle: Option<Name>,
        /// The parameter: what it does otherwise than in other cycles is meant so.
        q: Option<Name>,
        /// The manual.
        manual: Option<String>,
        /// The lines.
        lines: Option<String>,
        /// What is printed; nothing for silences.
        printed: Option<String>,
        /// What is right.
        right: Option<String>,
        /// Why.
        why: String,
    }
}

record! {
    /// The file of errata.
    pub struct Errata {
        /// The entries.
        errata: Option<Vec<Erratum>>,
    }
}
