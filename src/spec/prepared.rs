//! The catalogue of the embedded files: each is decoded when something asks for it.
//!
//! The build script read the trees and wrote the index; from there on it is the way of all files, `load`. Invariant:
//! what comes out is what comes of reading all files; mistakes of a file are reported when it is read.
use std::collections::BTreeMap;
use std::sync::Arc;

use super::catalogue::{Catalogue, Cycle, CycleKey, OnControl, Outline};
use super::decode::Decode;
use super::form::Meaning;
use super::index::{CycleLine, Index};
use super::language::LanguageFile;
use super::load::{self, File};
use super::tree;
use super::vocabulary::Keyword;
use crate::base::data::Prepared;
use crate::base::demand::{Deferred, Made, OnDemand};
use crate::base::diag::{Diagnostic, Mistakes, Source};
use crate::base::expr::QRef;

impl Catalogue {
    /// The catalogue of the prepared files. [`Catalogue::mistakes`] are those of the files that were read so far.
    pub fn open(data: &'static Prepared) -> Self {
        let paths = data.below("cycle-specs/parameters/").map(|(path, _)| path);
        let dictionary = Arc::new(OnDemand::new(paths, move |path| file(data, path)));
        let files = Reader { data, dictionary, mistakes: Mistakes::default() };
        let index = Arc::new(Index::read(data.index));
        let mistakes = files.mistakes.clone();
        let controls = {
            let (files, index) = (files.clone(), Arc::clone(&index));
            let ids: Vec<String> = index.controls.iter().map(|(id, _)| (*id).to_owned()).collect();
            OnDemand::new(ids, move |id| control(id, &files, &index))
        };
        let ranges = Deferred::new(move || {
            let lines = index.ranges.iter();
            let range = |own: &super::index::RangeLine<'_>| {
                load::printed_range(own.meaning, own.kind, own.quantity, own.field, own.range, own.greatest)
            };
            lines.filter_map(range).collect()
        });
        let errata = files.clone().of_file("cycle-specs/errata.yaml", load::errata);
        let topics = files.clone().of_file("cycle-specs/topics.yaml", load::topics);
        let pages = files.clone().of_file("cycle-specs/pages.yaml", File::decode);
        let language = Arc::new(files.of_file("cycle-specs/language.yaml", File::decode::<LanguageFile>));
        let blocks = of_language(&language, |own| &own.blocks);
        let globals = of_language(&language, |own| &own.globals);
        let old_cycles = of_language(&language, |own| &own.old_cycles);
        Self { controls, errata, topics, pages, blocks, globals, old_cycles, ranges, mistakes }
    }
}

/// The folder of worked programs.
const PROGRAMS: &str = "cycle-specs/programs/";

/// Reads prepared files.
#[derive(Clone)]
struct Reader {
    data: &'static Prepared,
    /// The dictionary files, of which many have parts that something asks for.
    dictionary: Arc<OnDemand<&'static str, File>>,
    mistakes: Mistakes,
}

/// A file as a tree, without what few ask for.
fn file(data: &'static Prepared, path: &str) -> Option<File> {
    let (source, start, end, _) = entry(data, path)?;
    Some(File { source, node: tree::read(data.trees.get(start..end)?)? })
}

/// What few ask for of the file of a cycle.
fn later(data: &'static Prepared, path: &str) -> Option<File> {
    let (source, _, start, end) = entry(data, path)?;
    Some(File { source, node: tree::read(data.trees.get(start..end)?)? })
}

/// A file, and where its trees begin and end.
fn entry(data: &'static Prepared, path: &str) -> Option<(Arc<Source>, usize, usize, usize)> {
    let at = data.files.binary_search_by(|(own, _)| (*own).cmp(path)).ok()?;
    let (name, text) = data.files.get(at)?;
    let entry = data.tree_table.binary_search_by_key(&at, |(own, ..)| *own).ok()?;
    let (_, start, end, later) = *data.tree_table.get(entry)?;
    Some((Source::embedded(name, text), start, end, later))
}

impl Reader {
    /// What something makes of a file, with its mistakes kept.
    fn read<T>(&self, path: &str, make: impl FnOnce(&File, &mut Vec<Diagnostic>) -> T) -> Option<T> {
        let mut found = Vec::new();
        let made = make(&file(self.data, path)?, &mut found);
        self.mistakes.extend(found);
        Some(made)
    }

    /// The same, when it is asked for.
    fn of_file<T: Default>(
        self,
        path: &'static str,
        make: impl Fn(&File, &mut Vec<Diagnostic>) -> T + Send + Sync + 'static,
    ) -> Deferred<T> {
        Deferred::new(move || self.read(path, &make).unwrap_or_default())
    }
}

/// A part of the file with the words of blocks.
fn of_language<T: Clone + 'static>(
    language: &Arc<Deferred<Option<LanguageFile>>>,
    part: fn(&LanguageFile) -> &Option<Vec<T>>,
) -> Deferred<Vec<T>> {
    let language = Arc::clone(language);
    Deferred::new(move || Option::as_ref(&language).and_then(|own| part(own).clone()).unwrap_or_default())
}

fn control(id: &str, files: &Reader, index: &Arc<Index<'static>>) -> Option<OnControl> {
    let (_, path) = index.controls.iter().find(|(own, _)| *own == id)?;
    let profile = files.read(path, File::decode)??;
    let meanings = {
        let (files, index, id) = (files.clone(), Arc::clone(index), id.to_owned());
        let names: Vec<String> = index.meanings.iter().map(|(name, _)| (*name).to_owned()).collect();
        Arc::new(OnDemand::new(names, move |name| {
            let (_, path) = index.meanings.iter().find(|(own, _)| own == name)?;
            let file = files.dictionary.get(path)?;
            let mut found = Vec::new();
            let meaning = file.decode_part(file.node.get("parameters")?.get(name)?, &id, &mut found);
            files.mistakes.extend(found);
            meaning
        }))
    };
    let lines = index.cycles.iter().filter(|line| line.control == id);
    let lines: BTreeMap<CycleKey, &CycleLine<'_>> = lines.filter_map(|line| Some((key(line)?, line))).collect();
    let outlines = lines.iter().map(|(key, line)| (*key, outline(line))).collect();
    let cycles = {
        let on = Cycles {
            control: id.to_owned(),
            files: files.clone(),
            meanings: Arc::clone(&meanings),
            index: Arc::clone(index),
        };
        OnDemand::new(lines.keys().copied().collect::<Vec<_>>(), move |key| on.cycle(*key))
    };
    let fragments = {
        let (files, index, id) = (files.clone(), Arc::clone(index), id.to_owned());
        let names: Vec<String> = index.fragments.iter().map(|(name, _)| (*name).to_owned()).collect();
        OnDemand::new(names, move |name| {
            let (_, path) = index.fragments.iter().find(|(own, _)| own == name)?;
            files.read(path, |file, found| file.decode_for(&id, found))?
        })
    };
    let worked = {
        let (files, id) = (files.clone(), id.to_owned());
        Deferred::new(move || {
            let paths = files.data.below(PROGRAMS).map(|(path, _)| path);
            let own = |path| files.read(path, |file, found| load::worked(file, &id, found))?;
            paths.filter_map(own).collect()
        })
    };
    Some(OnControl { control: profile, cycles, outlines, fragments, meanings, worked, made: Made::default() })
}

fn key(line: &CycleLine<'_>) -> Option<CycleKey> {
    Some(CycleKey::new(Keyword::by_word(line.keyword)?, line.number))
}

fn outline(line: &CycleLine<'_>) -> Outline {
    Outline {
        name: line.name.to_owned(),
        like: line.like.map(str::to_owned),
        codes: line.codes().map(|(form, code)| (form, code.to_owned())).collect(),
        parameters: line.parameters().filter_map(QRef::parse).collect(),
    }
}

/// What the cycles of a control are made from.
struct Cycles {
    control: String,
    files: Reader,
    meanings: Arc<OnDemand<String, Meaning>>,
    index: Arc<Index<'static>>,
}

impl Cycles {
    fn cycle(&self, key: CycleKey) -> Option<Cycle> {
        let line = self.lines().find(|line| line.number == key.number && line.keyword == key.keyword.as_str())?;
        let mut cycle = self.read(line)?;
        // A cycle whose run another one has has its own.
        let model = line.like.and_then(|name| self.lines().find(|line| line.name == name && line.like.is_none()));
        if let Some(model) = model.and_then(|model| self.read(model)) {
            load::share_run(&mut cycle, model);
        }
        Some(cycle)
    }

    fn lines(&self) -> impl Iterator<Item = &CycleLine<'static>> {
        self.index.cycles.iter().filter(|line| line.control == self.control)
    }

    fn read(&self, line: &CycleLine<'static>) -> Option<Cycle> {
        let read = |file: &File, found: &mut Vec<Diagnostic>| load::cycle(file, &self.control, &self.meanings, found);
        let mut cycle = self.files.read(line.path, read)??;
        cycle.file.figures = self.later(line.path, "figures");
        cycle.file.not_shown = self.later(line.path, "not_shown");
        cycle.file.examples = self.later(line.path, "examples");
        Some(cycle)
    }

    /// A part of a cycle that is read when it is asked for.
    fn later<T: Decode + Default>(&self, path: &'static str, key: &'static str) -> Deferred<T> {
        let (files, control) = (self.files.clone(), self.control.clone());
        Deferred::new(move || {
            let read = || {
                let file = later(files.data, path)?;
                let mut found = Vec::new();
                let part = file.decode_part(file.node.get(key)?, &control, &mut found);
                files.mistakes.extend(found);
                part
            };
            read().unwrap_or_default()
        })
    }
}
