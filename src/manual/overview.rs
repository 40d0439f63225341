//! The overview of a control: its cycles by group, by number and by name, and those only named.
use minijinja::value::Serde;
use minijinja::{Value, context};

use super::Site;
use super::page::{Here, link};
use super::section::Section;
use super::view::{GroupView, LinkView, OverviewView, TopicLink};
use crate::diag::Diagnostic;
use crate::export;
use crate::locale::Args;
use crate::spec::Group;

pub(super) fn page(site: &Site, section: &Section) -> Result<String, Vec<Diagnostic>> {
    let args = Args::new().text("control", section.on.control.title.as_str());
    let title = section.text("page-overview-title", &args)?.into_owned();
    let by_number: Vec<LinkView> = section.entries.iter().map(link).collect();
    let mut by_name = by_number.clone();
    section.language.collation().sort_by_key(&mut by_name, |cycle| &cycle.name);
    let topics = section.topics.iter().map(|topic| TopicLink { href: topic.file.clone(), title: topic.title.clone() });
    let topics = topics.collect();
    let view = OverviewView { groups: groups(section)?, by_number, by_name, named: named(section), topics };
    let frame = site.frame(section, title, Here::Every("index.html"));
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
            let title = group_title(section, *group)?;
            groups.push(GroupView { id: group.as_str(), title, cycles });
        }
    }
    Ok(groups)
}

/// Cycles without a page, with the names that the manual prints.
fn named(section: &Section) -> Vec<LinkView> {
    let manual = section.on.control.language.as_str();
    let name_lang = (manual != section.language.tag()).then(|| manual.to_owned());
    let entry = |cycle: export::NamedCycle| LinkView {
        href: None,
        key: format!("{} {}", cycle.keyword, cycle.number),
        number: cycle.number,
        name: cycle.name,
        name_lang: name_lang.clone(),
    };
    export::named(section.on).into_iter().map(entry).collect()
}

/// The title of a group.
pub(super) fn group_title(section: &Section, group: Group) -> Result<String, Vec<Diagnostic>> {
    Ok(section.text(&format!("cycle-group-{}", group.as_str()), &Args::new())?.into_owned())
}
