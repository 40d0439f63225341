//! The overview of a control: its cycles by group, those only named, topics and worked programs.
use minijinja::value::Serde;
use minijinja::{Value, context};

use super::edition::Edition;
use super::page::{Here, link};
use super::view::{GroupView, LinkView, OverviewView, TopicLink};
use super::{Site, programs};
use crate::base::diag::Diagnostic;
use crate::language::locale::Args;
use crate::spec::{CycleKey, Group, Named};

pub(super) fn page(site: &Site, edition: &Edition) -> Result<String, Vec<Diagnostic>> {
    let args = Args::new().text("control", edition.on.control.title.as_str());
    let title = edition.text("page-overview-title", &args)?.into_owned();
    let topics = edition.topics.iter().map(|topic| TopicLink { href: topic.file.clone(), title: topic.title.clone() });
    let topics = topics.collect();
    let programs = programs::titles(edition)?;
    let view = OverviewView { groups: groups(edition)?, named: named(site, edition), programs, topics };
    let frame = site.frame(edition, title, Here::Every("index.html"))?;
    let context = context! {
        page => Value::from(Serde(&frame)),
        words => edition.words.clone(),
        overview => Value::from(Serde(&view)),
    };
    site.render("overview.html", context)
}

/// The groups that have cycles here, in the order of the groups.
fn groups(edition: &Edition) -> Result<Vec<GroupView>, Vec<Diagnostic>> {
    let mut groups = Vec::new();
    for group in Group::ALL {
        let members = edition.entries.iter().filter(|entry| {
            let file = &entry.cycle.file;
            file.group == *group || file.also_in.contains(group)
        });
        let cycles: Vec<LinkView> = members.map(link).collect();
        if !cycles.is_empty() {
            let title = edition.group_title(*group)?;
            groups.push(GroupView { id: group.as_str(), title, cycles });
        }
    }
    Ok(groups)
}

/// Cycles without a page: in the language of the control's manual with the names that it prints, in another
/// one with the name that the cycle has where it is described, if it is.
fn named(site: &Site, edition: &Edition) -> Vec<LinkView> {
    let manual = edition.on.control.language.as_str();
    let foreign = manual != edition.language.tag();
    let entry = |cycle: &Named| {
        let key = CycleKey::new(cycle.keyword, cycle.number);
        let elsewhere = site.name_elsewhere(edition, key).filter(|_| foreign);
        LinkView {
            href: None,
            key: key.to_string(),
            number: key.number,
            name_lang: (foreign && elsewhere.is_none()).then(|| manual.to_owned()),
            name: elsewhere.unwrap_or_else(|| cycle.name.clone()),
        }
    };
    let control = &edition.on.control;
    let only = |cycle: &&Named| edition.entry(CycleKey::new(cycle.keyword, cycle.number)).is_none();
    let mut named: Vec<LinkView> = control.named.iter().filter(only).map(entry).collect();
    named.sort_by(|a, b| a.key.split(' ').next().cmp(&b.key.split(' ').next()).then(a.number.cmp(&b.number)));
    named
}
