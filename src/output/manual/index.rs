//! The first page of the site: choose a control and a language.
use minijinja::value::Serde;
use minijinja::{Value, context};

use super::Site;
use super::view::{ChoiceRow, Invitation, PageView, SwitchView};
use crate::base::diag::Diagnostic;
use crate::language::locale::{SOURCE_LANGUAGE, Scope};

pub(super) fn page(site: &Site) -> Result<String, Vec<Diagnostic>> {
    let Some(own) = site.sections.iter().find(|one| one.language.tag() == SOURCE_LANGUAGE).or(site.sections.first())
    else {
        return Err(vec![Diagnostic::global("manual-empty")]);
    };
    let mut rows: Vec<ChoiceRow> = Vec::new();
    let mut invitations: Vec<Invitation> = Vec::new();
    for section in &site.sections {
        let link = SwitchView {
            href: section.path("index.html"),
            lang: section.language.tag().to_owned(),
            name: section.language_name.clone(),
            current: false,
        };
        match rows.last_mut() {
            Some(row) if row.name == section.on.control.title => row.links.push(link),
            _ => rows.push(ChoiceRow { name: section.on.control.title.clone(), links: vec![link] }),
        }
        if !invitations.iter().any(|invitation| invitation.lang == section.language.tag()) {
            let text = section.language.plain("site-choose", &Scope::NONE).map_err(|error| vec![error.into()])?;
            invitations.push(Invitation { lang: section.language.tag().to_owned(), text: text.into_owned() });
        }
    }
    let title = own.language.plain("site-manual", &Scope::NONE).map_err(|error| vec![error.into()])?.into_owned();
    let page = PageView {
        lang: own.language.tag().to_owned(),
        title,
        root: "",
        control: String::new(),
        home: String::new(),
        languages: Vec::new(),
        controls: Vec::new(),
        previous: None,
        next: None,
    };
    let view = context! {
        page => Value::from(Serde(&page)),
        words => own.words.clone(),
        rows => Value::from(Serde(&rows)),
        invitations => Value::from(Serde(&invitations)),
    };
    site.render("index.html", view)
}
