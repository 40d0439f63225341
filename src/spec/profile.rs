//! Profiles of the controls, the errata of their manuals, and the topics that they cover.
use super::decode::{Entries, Name, record, words};
use super::form::ManualLines;
use super::vocabulary::{Group, Keyword};
use crate::base::expr::QRef;

record! {
    /// The greatest length of labels, prompts or names on a control.
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
    /// Parameters that a software version of the control added after the one that its manual describes.
    pub struct Later {
        /// The keyword of the cycles.
        keyword: Keyword,
        /// Their numbers.
        cycles: Vec<u32>,
        /// The parameters.
        parameters: Vec<QRef>,
        /// A software version that certainly has them; none if only a later one than the manual's is known to.
        since: Option<String>,
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
        /// The software version that its manual describes, such as `340590-02`.
        software: Option<String>,
        /// The NC software from which its manuals hold, as they print it.
        states: Vec<String>,
        /// What later versions added.
        later: Vec<Later>,
        /// The language of its manual.
        language: Name,
        /// The rules of NC labels.
        label: LabelRules,
        /// The greatest length of a question of the dialog.
        prompt: Option<LabelRules>,
        /// The greatest length of the name of a cycle in NC programs.
        cycle_name: Option<LabelRules>,
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
        /// The greatest number of a Q parameter, if it is less than 1999.
        greatest_parameter: Option<u32>,
        /// Functions and cycles that it does not have, where no manual needs to say so.
        lacks: Vec<FunctionLacking>,
        /// Every cycle that its manuals name.
        named: Vec<Named>,
    }
}

/// A software version in its order: the number of the family without its last digit, which names the variant, and the
/// number after the dash; nothing if the text is none.
pub fn software(text: &str) -> Option<(u32, u32)> {
    let (family, version) = text.trim().split_once('-')?;
    let digits = |own: &str| own.bytes().all(|byte| byte.is_ascii_digit());
    let variant = family.get(5..).filter(|own| digits(own) || matches!(*own, "x" | "X"))?;
    let family = family.get(..5).filter(|own| digits(own))?;
    (variant.len() == 1 && version.len() == 2 && digits(version)).then_some(())?;
    Some((family.parse().ok()?, version.parse().ok()?))
}

/// What a software version knows of a parameter that the manual does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Since {
    /// The version has it.
    There,
    /// A later version has it; which one the control has is not known.
    Later,
    /// The version does not have it.
    NotYet,
    /// No version is known to have it.
    Never,
}

impl Control {
    /// Whether the control has a parameter that its manual does not have, with a software version if one is given.
    pub fn since(&self, keyword: Keyword, cycle: u32, q: QRef, version: Option<&str>) -> Since {
        let own = self.software.as_deref().and_then(software);
        let version = version.and_then(software);
        let is_it =
            |later: &&Later| later.keyword == keyword && later.cycles.contains(&cycle) && later.parameters.contains(&q);
        let Some(later) = self.later.iter().find(is_it) else {
            // What the manual describes is all that its version has.
            return if version.is_some() && version <= own { Since::NotYet } else { Since::Never };
        };
        match (version, later.since.as_deref().and_then(software)) {
            (None, _) => Since::Later,
            (version, _) if version <= own => Since::NotYet,
            (version, since) if since.is_none() || version >= since => Since::There,
            _ => Since::Later,
        }
    }

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
        /// The groups of cycles that it is about.
        groups: Vec<Group>,
        /// The miscellaneous functions that it explains, such as `M99`.
        functions: Vec<String>,
        /// The tables that it explains, as cycles name them.
        tables: Vec<Name>,
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
