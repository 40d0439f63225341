//! The overview of a control: its cycles by group, and those only named.
use minijinja::value::Serde;
use minijinja::{Value, context};

use super::page::{Here, link};
use super::section::Section;
use super::view::{GroupView, LinkView, OverviewView, TopicLink};
use super::{Site, programs};
use crate::base::diag::Diagnostic;
use crate::language::locale::Args;
use crate::spec::{CycleKey, Group, Named};

pub(super) fn page(site: &Site, section: &Section) -> Result<String, Vec<Diagnostic>> {
    let args = Args::new().text("control", section.on.control.title.as_str());
    let title = section.text("page-overview-title", &args)?.into_owned();
    let topics = section.topics.iter().map(|topic| TopicLink { href: topic.file.clone(), title: topic.title.clone() });
    let topics = topics.collect();
    let programs = programs::titles(section)?;
    let view = OverviewView { groups: groups(section)?, named: named(site, section), programs, topics };
    let frame = site.frame(section, title, Here::Every("index.html"))?;
    let context = context! {
        page => Value::from(Serde(&frame)),
        words => section.words.clone(),
        overview => Value::from(Serde(&view)),
    };
    site.render("overview.html", context)
}

/// The groups that have cycles here, in the order of the groups.
fn groups(section: &Section) -> Result<Vec<GroupView>, Vec<Diagnostic>> {
    let mut groups = Vec::new();
    for group in Group::ALL {
        let members = section.entries.iter().filter(|entry| {
            let file = &entry.cycle.file;
            file.group == *group || file.also_in.contains(group)
        });
        let cycles: Vec<LinkView> = members.map(link).collect();
        if !cycles.is_empty() {
            let title = section.group_title(*group)?;
            groups.push(GroupView { id: group.as_str(), title, cycles });
        }
    }
    Ok(groups)
}

/// Cycles without a page: in the language of the control's manual with the names that it prints, in another
/// one with the name that the cycle has where it is described, if it is.
fn named(site: &Site, section: &Section) -> Vec<LinkView> {
    let manual = section.on.control.language.as_str();
    let foreign = manual != section.language.tag();
    let entry = |cycle: &Named| {
        let key = CycleKey::new(cycle.keyword, cycle.number);
        let elsewhere = site.name_elsewhere(section, key).filter(|_| foreign);
        LinkView {
            href: None,
            key: key.to_string(),
            number: key.number,
            name_lang: (foreign && elsewhere.is_none()).then(|| manual.to_owned()),
            name: elsewhere.unwrap_or_else(|| cycle.name.clone()),
        }
    };
    let control = &section.on.control;
    let only = |cycle: &&Named| section.entry(CycleKey::new(cycle.keyword, cycle.number)).is_none();
    let mut named: Vec<LinkView> = control.named.iter().filter(only).map(entry).collect();
    named.sort_by(|a, b| a.key.split(' ').next().cmp(&b.key.split(' ').next()).then(a.number.cmp(&b.number)));
    named
}
