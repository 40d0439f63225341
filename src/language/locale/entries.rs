//! The messages and terms of a language: all of them, or each when it is asked for.
//!
//! Invariant: a message that is asked for is what it would be if all files had been read.
use std::collections::HashMap;
use std::sync::{Arc, OnceLock};

use fluent::FluentResource;

use super::index;
use super::language::Entry;
use super::load;
use crate::base::data::Prepared;
use crate::base::diag::{Mistakes, Source};

/// The messages and terms of a language, by their identifiers without variants; those of terms begin with `-`.
pub(super) enum Entries {
    /// All were read.
    Read(HashMap<String, Entry>),
    /// Each is read when it is asked for.
    OnDemand(OnDemand),
}

impl Entries {
    pub(super) fn get(&self, id: &str) -> Option<&Entry> {
        match self {
            Self::Read(entries) => entries.get(id),
            Self::OnDemand(entries) => entries.get(id),
        }
    }

    /// The identifiers, in no order.
    pub(super) fn ids(&self) -> Box<dyn Iterator<Item = &str> + '_> {
        match self {
            Self::Read(entries) => Box::new(entries.keys().map(String::as_str)),
            Self::OnDemand(entries) => {
                let ids: Vec<&'static str> = entries.ids().collect();
                Box::new(ids.into_iter())
            }
        }
    }

    /// Everything, in no order.
    pub(super) fn iter(&self) -> impl Iterator<Item = (&str, &Entry)> {
        self.ids().filter_map(|id| Some((id, self.get(id)?)))
    }

    /// The identifiers of the messages that were read, in order.
    pub(super) fn read(&self) -> Vec<&str> {
        let known = |id: &&str| match self {
            Self::Read(_) => true,
            Self::OnDemand(own) => own.first(id).and_then(|at| own.cells.get(at)).is_some_and(|it| it.get().is_some()),
        };
        let mut ids: Vec<&str> = self.ids().filter(known).collect();
        ids.sort_unstable();
        ids
    }
}

/// The messages of embedded files.
pub(super) struct OnDemand {
    data: &'static Prepared,
    records: &'static [u8],
    /// What was read, at the first record of each message.
    cells: Box<[OnceLock<Option<Box<Entry>>>]>,
    mistakes: Mistakes,
}

impl OnDemand {
    pub(super) fn new(data: &'static Prepared, records: &'static [u8], mistakes: Mistakes) -> Self {
        let cells = (0..index::len(records)).map(|_| OnceLock::new()).collect();
        Self { data, records, cells, mistakes }
    }

    fn get(&self, id: &str) -> Option<&Entry> {
        let cell = self.cells.get(self.first(id)?)?;
        cell.get_or_init(|| self.read(id).map(Box::new)).as_deref()
    }

    /// The file with the message of a record, and the stretch of it.
    fn message(&self, at: usize) -> Option<(&'static str, &'static str, index::Found)> {
        let found = index::at(self.records, at)?;
        let (path, text) = self.data.files.get(found.file)?;
        Some((path, text, found))
    }

    fn id(&self, at: usize) -> Option<&'static str> {
        let (_, text, found) = self.message(at)?;
        Some(index::base(index::identifier(text.get(found.span)?)))
    }

    fn first(&self, id: &str) -> Option<usize> {
        index::find(self.records, id).find(|at| self.id(*at) == Some(id))
    }

    fn ids(&self) -> impl Iterator<Item = &'static str> {
        let all = (0..self.cells.len()).filter_map(|at| Some((at, self.id(at)?)));
        // Variants of a message, and what has the same number, are beside each other.
        let is_first = |at: usize, id: &str| {
            let before = (0..at).rev().take_while(|other| index::alike(self.records, *other, at));
            before.filter_map(|other| self.id(other)).all(|other| other != id)
        };
        all.filter(move |(at, id)| is_first(*at, id)).map(|(_, id)| id)
    }

    fn read(&self, id: &str) -> Option<Entry> {
        let mut found = Vec::new();
        let mut reader = load::Reader::new(&mut found);
        for at in index::find(self.records, id).filter(|at| self.id(*at) == Some(id)) {
            let (path, text, message) = self.message(at)?;
            let (source, start) = (Source::embedded(path, text), message.span.start);
            let resource: Arc<FluentResource> = reader.parse(&source, message.span);
            reader.collect(&source, &resource, start);
        }
        let entry = reader.entries.remove(id);
        self.mistakes.extend(found);
        entry
    }
}
