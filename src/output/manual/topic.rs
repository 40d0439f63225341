//! The page of a topic: Markdown of the locales as HTML.
//!
//! Invariant: whatever the text is, what comes out is well-formed, HTML in it shows as text, a link
//! leads to a page of the edition or is plain text, and every heading has an id of its own.
use std::collections::HashSet;

use minijinja::value::Serde;
use minijinja::{Value, context};
use pulldown_cmark::{CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};

use super::Site;
use super::edition::{Edition, link_target};
use super::links::{Linker, Shown};
use super::page::Here;
use super::view::TopicView;
use crate::base::diag::Diagnostic;
use crate::language::locale::Args;

pub(super) fn page(site: &Site, edition: &Edition, at: usize) -> Result<String, Vec<Diagnostic>> {
    let Some(topic) = edition.topics.get(at) else { return Ok(String::new()) };
    let args = Args::new().text("title", topic.title.as_str()).text("control", edition.on.control.title.as_str());
    let title = edition.text("page-topic-title", &args)?.into_owned();
    let frame = site.frame(edition, title, Here::Topic(topic.id))?;
    let view = TopicView { title: topic.title.clone(), body: Value::from_safe_string(body(&topic.body, edition)) };
    let context = context! {
        page => Value::from(Serde(&frame)),
        words => edition.words.clone(),
        topic => Value::from(Serde(&view)),
    };
    site.render("topic.html", context)
}

/// The Markdown below the title as HTML.
pub(super) fn body(markdown: &str, edition: &Edition) -> String {
    let mut events: Vec<Event> = Vec::new();
    let mut links: Vec<bool> = Vec::new();
    let mut heading: Option<usize> = None;
    let mut ids = HashSet::from(["content".to_owned()]);
    let linker = Linker::new(edition, None, Shown::Elsewhere);
    let linked = |text: &str| {
        let mut html = String::with_capacity(text.len());
        linker.text(text, &mut html);
        Event::InlineHtml(CowStr::from(html))
    };
    let mut in_code = false;
    for event in Parser::new_ext(markdown, Options::ENABLE_TABLES) {
        let plain = heading.is_none() && !links.contains(&true) && !in_code;
        let event = match event {
            Event::Html(text) | Event::InlineHtml(text) => Event::Text(text),
            Event::Text(text) if plain => linked(&text),
            Event::Start(Tag::CodeBlock(_)) | Event::End(TagEnd::CodeBlock) => {
                in_code = !in_code;
                event
            }
            Event::Start(Tag::Link { dest_url, link_type, title, id }) => {
                let file = target(&dest_url, edition);
                links.push(file.is_some());
                let Some(file) = file else { continue };
                Event::Start(Tag::Link { dest_url: CowStr::from(file), link_type, title, id })
            }
            Event::End(TagEnd::Link) if links.pop() != Some(true) => continue,
            // The title of the page is its only first heading.
            Event::Start(Tag::Heading { level: HeadingLevel::H1, id, classes, attrs }) => {
                heading = Some(events.len());
                Event::Start(Tag::Heading { level: HeadingLevel::H2, id, classes, attrs })
            }
            Event::End(TagEnd::Heading(HeadingLevel::H1)) => {
                name_heading(&mut events, heading.take(), &mut ids);
                Event::End(TagEnd::Heading(HeadingLevel::H2))
            }
            Event::Start(Tag::Heading { .. }) => {
                heading = Some(events.len());
                event
            }
            Event::End(TagEnd::Heading(_)) => {
                name_heading(&mut events, heading.take(), &mut ids);
                event
            }
            // Images and footnotes have no place here; their text stays.
            Event::Start(Tag::Image { .. }) | Event::End(TagEnd::Image) => continue,
            event => event,
        };
        events.push(event);
    }
    let mut out = String::with_capacity(markdown.len() * 5 / 4);
    html::push_html(&mut out, events.into_iter());
    // A program that is wider than the screen is scrolled with the keyboard, too.
    out.replace("<pre>", "<pre tabindex=\"0\">")
}

/// The file that a link such as `cycle:TCH-PROBE-412` or `topic:threads` leads to.
fn target(link: &str, edition: &Edition) -> Option<String> {
    if let Some(name) = link.strip_prefix("topic:") {
        return edition.topics.iter().find(|topic| topic.id == name).map(|topic| topic.file.clone());
    }
    edition.entry(link_target(link)?).map(|entry| entry.file.clone())
}

/// Gives the heading that began at `start` an id made of its words.
fn name_heading(events: &mut [Event], start: Option<usize>, ids: &mut HashSet<String>) {
    let Some(start) = start else { return };
    let mut words = String::new();
    for event in &events[start..] {
        if let Event::Text(text) | Event::Code(text) = event {
            words.push_str(text);
        }
    }
    let letters = words.to_lowercase().chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect::<String>();
    let slug = letters.split('-').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("-");
    let mut name = if slug.is_empty() { "section".to_owned() } else { slug };
    while !ids.insert(name.clone()) {
        name.push_str("-2");
    }
    if let Some(Event::Start(Tag::Heading { id, .. })) = events.get_mut(start) {
        *id = Some(CowStr::from(name));
    }
}
