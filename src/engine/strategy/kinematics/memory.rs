//! Strategies that save the kinematics and restore them.
//!
//! Invariant: what is restored describes the same axes as the kinematics in effect (001:14060-14062).
use super::along_z;
use crate::engine::machine::{Machine, MemoryReport, SavedKinematics, matches_pattern};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::signature::{results, strategy};

strategy! {
    /// Saves the kinematics in effect in the memory that is named; what was in it is overwritten.
    SaveKinematics = "save-kinematics" {
        /// How many memories there are.
        most: f64 = Number,
    }
}

strategy! {
    /// How many memories fit the name that is entered, in which wildcards may be.
    FindSavedKinematics = "find-saved-kinematics" {}
}

strategy! {
    /// Text parameters have no values any more: a cycle has used them for itself.
    UseTextParameters = "use-text-parameters" {
        /// The first of them.
        first: f64 = Number,
        /// The last.
        last: f64 = Number,
    }
}

results! {
    /// What fits a name.
    FoundMemories {
        /// How many memories.
        count: f64 = Number,
    }
}

strategy! {
    /// Puts the kinematics into effect that are saved under a name; of several that fit it, their mean.
    RestoreKinematics = "restore-kinematics" {}
}

strategy! {
    /// Lists what is saved.
    ShowSavedKinematics = "show-saved-kinematics" {}
}

strategy! {
    /// Deletes all that is saved under a name.
    DeleteSavedKinematics = "delete-saved-kinematics" {}
}

/// The parameter that names the memory.
const LOCATION: &str = "kinematics-memory-location";

fn listed(memories: &[SavedKinematics]) -> Vec<(String, String)> {
    memories.iter().map(|memory| (memory.name.clone(), memory.saved.clone())).collect()
}

/// The memories that fit the name that is entered.
fn chosen(control: &dyn Control) -> Result<(String, Vec<SavedKinematics>), Fault> {
    let name = control.name_given(LOCATION)?;
    let mut memories = control.memories();
    memories.retain(|memory| matches_pattern(&name, &memory.name));
    if memories.is_empty() {
        return Err(Fault::control("kinematics-not-saved").arg("name", name));
    }
    Ok((name, memories))
}

impl Action for SaveKinematics {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        along_z(control)?;
        let name = control.name_given(LOCATION)?;
        let machine = control.kinematics();
        let saved = SavedKinematics { name: name.clone(), saved: control.moment(), machine: machine.clone() };
        let mut memories = control.memories();
        match memories.iter().position(|memory| memory.name == name) {
            Some(known) => memories[known] = saved,
            None if memories.len() as f64 >= self.most => {
                return Err(Fault::control("kinematics-memory-full").arg("count", self.most).into());
            }
            None => memories.push(saved),
        }
        control.set_memories(memories);
        control.keep_memory_report(MemoryReport { name, before: Some(machine), ..MemoryReport::default() });
        Ok(())
    }
}

impl Action for FindSavedKinematics {
    type Results = FoundMemories;

    fn act(&self, control: &mut dyn Control) -> Done<FoundMemories> {
        along_z(control)?;
        let (_, memories) = chosen(control)?;
        Ok(FoundMemories { count: memories.len() as f64 })
    }
}

impl Action for RestoreKinematics {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        along_z(control)?;
        let (name, memories) = chosen(control)?;
        let before = control.kinematics();
        if let Some(other) = memories.iter().find(|memory| !memory.machine.is_same_description(&before)) {
            return Err(Fault::control("kinematics-differs").arg("name", other.name.clone()).into());
        }
        let machines: Vec<Machine> = memories.iter().map(|memory| memory.machine.clone()).collect();
        let after = before.with_mean_of(&machines);
        control.set_kinematics(after.clone());
        let (before, after) = (Some(before), Some(after));
        control.keep_memory_report(MemoryReport { name, before, after, memories: listed(&memories) });
        Ok(())
    }
}

impl Action for ShowSavedKinematics {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        along_z(control)?;
        let memories = listed(&control.memories());
        control.keep_memory_report(MemoryReport { memories, ..MemoryReport::default() });
        Ok(())
    }
}

impl Action for DeleteSavedKinematics {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let (name, chosen) = chosen(control)?;
        let mut memories = control.memories();
        memories.retain(|memory| !chosen.contains(memory));
        control.set_memories(memories);
        control.keep_memory_report(MemoryReport { name, memories: listed(&chosen), ..MemoryReport::default() });
        Ok(())
    }
}

impl Action for UseTextParameters {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        control.forget_texts(self.first as u16..=self.last as u16);
        Ok(())
    }
}
