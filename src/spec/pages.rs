//! What pages of the manual need beyond the cycles: the date of the data, the sections of notes, and the notes that a
//! page of their own says once for all cycles.
use super::decode::{Name, record, words};

words! {
    /// A section of the notes of a cycle, in the order of the page.
    pub enum NoteSection {
        /// What must be so before the cycle is called.
        BeforeTheCall = "before-the-call",
        /// Where the tool or the touch probe must be, and how much room it needs.
        PositionsAndClearances = "positions-and-clearances",
        /// What the values of parameters do together.
        Values = "values",
        /// How the contour is described.
        Contour = "contour",
        /// How the cycle proceeds.
        DuringTheRun = "during-the-run",
        /// The tool and its data.
        ToolTable = "tool-table",
        /// The touch probe and its data.
        TouchProbe = "touch-probe",
        /// Datums, tables of datums, coordinate systems.
        Coordinates = "coordinates",
        /// How exactly it works, and what that depends on.
        Accuracy = "accuracy",
        /// What it measures, and where that is stored and shown.
        ResultsAndLogs = "results-and-logs",
        /// Machine parameters and what the machine builder decides.
        MachineParameters = "machine-parameters",
        /// What is in effect after it, and how it is reset.
        AfterTheCycle = "after-the-cycle",
        /// What else it can be used for, and with which cycles and software.
        Use = "use",
    }
}

record! {
    /// The notes of a section.
    pub struct NotesOfSection {
        /// The section.
        section: NoteSection,
        /// Their ids.
        notes: Vec<Name>,
    }
}

record! {
    /// Notes that hold for many cycles.
    pub struct Theme {
        /// Its id; its heading is the text `theme-<id>`.
        theme: Name,
        /// The topic that says more.
        topic: Option<Name>,
        /// The ids of the notes.
        notes: Vec<Name>,
    }
}

record! {
    /// The file `pages.yaml`.
    pub struct Pages {
        /// The date of the data, such as `2026-11-23`.
        edition: Option<String>,
        /// The sections of notes.
        sections: Vec<NotesOfSection>,
        /// Notes that pages of cycles only link to.
        themes: Vec<Theme>,
    }
}

impl Pages {
    /// The section of a note; notes that are not listed are about how the cycle proceeds.
    pub fn section(&self, note: &str) -> NoteSection {
        let lists = |own: &&NotesOfSection| own.notes.iter().any(|name| name.as_str() == note);
        self.sections.iter().find(lists).map_or(NoteSection::DuringTheRun, |own| own.section)
    }

    /// The theme that says a note for all cycles.
    pub fn theme(&self, note: &str) -> Option<&Theme> {
        self.themes.iter().find(|theme| theme.notes.iter().any(|name| name.as_str() == note))
    }
}
