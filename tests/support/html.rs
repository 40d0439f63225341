//! Reads HTML with a conforming parser and keeps what the tests ask for: errors, ids and links.
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;

use html5ever::tendril::{StrTendril, TendrilSink};
use html5ever::tree_builder::{ElementFlags, NodeOrText, QuirksMode, TreeSink};
use html5ever::{Attribute, ExpandedName, ParseOpts, QualName, parse_document};

/// What a page says of itself.
#[derive(Debug, Default)]
pub(crate) struct Page {
    /// What the parser complained about.
    pub errors: Vec<String>,
    /// Values of `id`, in order.
    pub ids: Vec<String>,
    /// Values of `href`, `src` and `action`, in order.
    pub links: Vec<String>,
    /// `lang` of the root element.
    pub lang: String,
    /// Names of elements, in order.
    pub elements: Vec<String>,
    /// All text.
    pub text: String,
}

/// Reads a page.
pub(crate) fn read(text: &str) -> Page {
    let mut options = ParseOpts::default();
    options.tokenizer.exact_errors = true;
    options.tree_builder.exact_errors = true;
    parse_document(Sink::default(), options).one(text)
}

#[derive(Default)]
struct Sink {
    next: Cell<usize>,
    names: RefCell<HashMap<usize, &'static QualName>>,
    page: RefCell<Page>,
}

impl Sink {
    fn id(&self) -> usize {
        self.next.set(self.next.get() + 1);
        self.next.get()
    }
}

impl TreeSink for Sink {
    type Handle = usize;
    type Output = Page;
    type ElemName<'a> = ExpandedName<'a>;

    fn finish(self) -> Page {
        self.page.into_inner()
    }

    fn get_document(&self) -> usize {
        0
    }

    fn get_template_contents(&self, target: &usize) -> usize {
        *target
    }

    fn same_node(&self, x: &usize, y: &usize) -> bool {
        x == y
    }

    fn elem_name(&self, target: &usize) -> ExpandedName<'_> {
        self.names.borrow().get(target).expect("an element").expanded()
    }

    fn create_element(&self, name: QualName, attributes: Vec<Attribute>, _: ElementFlags) -> usize {
        let mut page = self.page.borrow_mut();
        for attribute in attributes {
            let value = attribute.value.to_string();
            match &*attribute.name.local {
                "id" => page.ids.push(value),
                "href" | "src" | "action" => page.links.push(value),
                "lang" if &*name.local == "html" => page.lang = value,
                _ => {}
            }
        }
        page.elements.push(name.local.to_string());
        let id = self.id();
        // Names must outlive the borrow of the map; a test process ends soon.
        self.names.borrow_mut().insert(id, Box::leak(Box::new(name)));
        id
    }

    fn create_comment(&self, _: StrTendril) -> usize {
        self.id()
    }

    fn create_pi(&self, _: StrTendril, _: StrTendril) -> usize {
        self.id()
    }

    fn append(&self, _: &usize, child: NodeOrText<usize>) {
        if let NodeOrText::AppendText(text) = child {
            self.page.borrow_mut().text.push_str(&text);
        }
    }

    fn append_before_sibling(&self, _: &usize, _: NodeOrText<usize>) {}
    fn append_based_on_parent_node(&self, _: &usize, _: &usize, _: NodeOrText<usize>) {}

    fn parse_error(&self, message: Cow<'static, str>) {
        self.page.borrow_mut().errors.push(message.into_owned());
    }

    fn set_quirks_mode(&self, mode: QuirksMode) {
        if mode != QuirksMode::NoQuirks {
            self.page.borrow_mut().errors.push("quirks mode".to_owned());
        }
    }

    fn append_doctype_to_document(&self, _: StrTendril, _: StrTendril, _: StrTendril) {}
    fn add_attrs_if_missing(&self, _: &usize, _: Vec<Attribute>) {}
    fn remove_from_parent(&self, _: &usize) {}
    fn reparent_children(&self, _: &usize, _: &usize) {}
}
