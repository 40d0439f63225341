//! Walking over Fluent patterns, and templates: patterns simple enough to be filled without Fluent.
//!
//! Invariant: nothing here formats or looks anything up.
use fluent_syntax::ast::{CallArguments, Expression, InlineExpression, Pattern, PatternElement, VariantKey};

/// Something in a pattern that a check wants to know of.
pub(super) enum Node<'a> {
    /// A variable whose value is shown or handed to a function.
    Shown(&'a str),
    /// A variable that a selector chooses by, with the keys of its variants.
    Chosen(&'a str, Vec<&'a str>),
    /// A reference to a message.
    Message { id: &'a str, attribute: Option<&'a str> },
    /// A reference to a term.
    Term { id: &'a str, attribute: Option<&'a str>, arguments: Option<&'a CallArguments<&'a str>> },
    /// A call of a function.
    Function { id: &'a str, arguments: &'a CallArguments<&'a str> },
}

/// Shows every node of the pattern to `see`, from left to right.
pub(super) fn visit<'a>(pattern: &'a Pattern<&'a str>, see: &mut dyn FnMut(Node<'a>)) {
    for element in &pattern.elements {
        if let PatternElement::Placeable { expression } = element {
            visit_expression(expression, see);
        }
    }
}

fn visit_expression<'a>(expression: &'a Expression<&'a str>, see: &mut dyn FnMut(Node<'a>)) {
    match expression {
        Expression::Inline(inline) => visit_inline(inline, see),
        Expression::Select { selector, variants } => {
            if let InlineExpression::VariableReference { id } = selector {
                let keys = variants.iter().map(|variant| match &variant.key {
                    VariantKey::Identifier { name } => *name,
                    VariantKey::NumberLiteral { value } => *value,
                });
                see(Node::Chosen(id.name, keys.collect()));
            } else {
                visit_inline(selector, see);
            }
            for variant in variants {
                visit(&variant.value, see);
            }
        }
    }
}

fn visit_inline<'a>(inline: &'a InlineExpression<&'a str>, see: &mut dyn FnMut(Node<'a>)) {
    match inline {
        InlineExpression::StringLiteral { .. } | InlineExpression::NumberLiteral { .. } => {}
        InlineExpression::VariableReference { id } => see(Node::Shown(id.name)),
        InlineExpression::MessageReference { id, attribute } => {
            see(Node::Message { id: id.name, attribute: attribute.as_ref().map(|attribute| attribute.name) });
        }
        InlineExpression::TermReference { id, attribute, arguments } => {
            let attribute = attribute.as_ref().map(|attribute| attribute.name);
            see(Node::Term { id: id.name, attribute, arguments: arguments.as_ref() });
        }
        InlineExpression::FunctionReference { id, arguments } => {
            see(Node::Function { id: id.name, arguments });
            arguments.positional.iter().for_each(|argument| visit_inline(argument, see));
        }
        InlineExpression::Placeable { expression } => visit_expression(expression, see),
    }
}

/// The text of a pattern that has nothing to fill in.
pub(super) fn plain<'a>(pattern: &Pattern<&'a str>) -> Option<&'a str> {
    match pattern.elements.as_slice() {
        [PatternElement::TextElement { value }] => Some(value),
        _ => None,
    }
}

/// Which variants are taken: names of variables with the keys of their variants.
type Chosen = Vec<(String, String)>;

/// The pattern as a reader may see it without arguments: variables as `‹name›`, the default of each
/// selection, terms as `term` gives them.
pub(super) fn sketch(pattern: &Pattern<&str>, term: &dyn Fn(&str) -> Option<String>) -> String {
    sketch_with(pattern, term, &Chosen::new())
}

fn sketch_with(pattern: &Pattern<&str>, term: &dyn Fn(&str) -> Option<String>, chosen: &Chosen) -> String {
    pattern.elements.iter().map(|element| sketch_element(element, term, chosen)).collect()
}

fn sketch_element(element: &PatternElement<&str>, term: &dyn Fn(&str) -> Option<String>, chosen: &Chosen) -> String {
    let inline = match element {
        PatternElement::TextElement { value } => return (*value).to_owned(),
        PatternElement::Placeable { expression: Expression::Inline(inline) } => inline,
        PatternElement::Placeable { expression: Expression::Select { selector, variants } } => {
            let name = variable(selector);
            let key = chosen.iter().find(|(own, _)| Some(own.as_str()) == name).map(|(_, key)| key.as_str());
            let wanted = variants.iter().find(|variant| key.is_some_and(|key| key == key_of(&variant.key)));
            return wanted
                .or_else(|| variants.iter().find(|variant| variant.default))
                .map_or_else(String::new, |it| sketch_with(&it.value, term, chosen));
        }
    };
    match inline {
        InlineExpression::StringLiteral { value } | InlineExpression::NumberLiteral { value } => {
            fluent_syntax::unicode::unescape_unicode_to_string(value).into_owned()
        }
        InlineExpression::TermReference { id, .. } => term(id.name).unwrap_or_else(|| format!("‹{}›", id.name)),
        InlineExpression::VariableReference { id } | InlineExpression::MessageReference { id, .. } => {
            format!("‹{}›", id.name)
        }
        InlineExpression::FunctionReference { arguments, .. } => match arguments.positional.first() {
            Some(InlineExpression::VariableReference { id }) => format!("‹{}›", id.name),
            _ => String::new(),
        },
        InlineExpression::Placeable { .. } => String::new(),
    }
}

/// Categories of numbers, which each language has as it needs them.
const CATEGORIES: [&str; 6] = ["zero", "one", "two", "few", "many", "other"];

/// What the pattern says where a selection takes another variant than the default: what is chosen, such as `what=twice`, and
/// the sketch of the whole. Variants for categories of numbers are left out.
pub(super) fn variants(pattern: &Pattern<&str>, term: &dyn Fn(&str) -> Option<String>) -> Vec<(String, String)> {
    let mut choices = Vec::new();
    choices_in(pattern, &Chosen::new(), &mut choices);
    let named = |chosen: &Chosen| chosen.iter().map(|(name, key)| format!("{name}={key} ")).collect();
    choices.into_iter().map(|chosen| (named(&chosen), sketch_with(pattern, term, &chosen))).collect()
}

fn choices_in(pattern: &Pattern<&str>, before: &Chosen, choices: &mut Vec<Chosen>) {
    for element in &pattern.elements {
        let PatternElement::Placeable { expression: Expression::Select { selector, variants } } = element else {
            continue;
        };
        let Some(name) = variable(selector) else { continue };
        let is_plural = variants.iter().any(|variant| key_of(&variant.key) == "other");
        for variant in variants {
            let key = key_of(&variant.key);
            let mut chosen = before.clone();
            if !variant.default && !(is_plural && CATEGORIES.contains(&key)) {
                chosen.push((name.to_owned(), key.to_owned()));
                choices.push(chosen.clone());
            }
            choices_in(&variant.value, &chosen, choices);
        }
    }
}

fn variable<'a>(selector: &InlineExpression<&'a str>) -> Option<&'a str> {
    if let InlineExpression::VariableReference { id } = selector { Some(id.name) } else { None }
}

const fn key_of<'a>(key: &VariantKey<&'a str>) -> &'a str {
    match key {
        VariantKey::Identifier { name } => name,
        VariantKey::NumberLiteral { value } => value,
    }
}

#[derive(Clone, Debug)]
enum Part {
    Text(String),
    Slot(usize),
}

/// A pattern of text and plain variables.
#[derive(Clone, Debug)]
pub(super) struct Template(Vec<Part>);

impl Template {
    /// The pattern as a template, if it has nothing but text and the variables in `slots`, each once.
    pub(super) fn of(pattern: &Pattern<&str>, slots: &[&str]) -> Option<Self> {
        let mut parts = Vec::new();
        let mut used = vec![false; slots.len()];
        for element in &pattern.elements {
            parts.push(match element {
                PatternElement::TextElement { value } => Part::Text((*value).to_owned()),
                PatternElement::Placeable { expression: Expression::Inline(inline) } => match inline {
                    InlineExpression::StringLiteral { value } => {
                        Part::Text(fluent_syntax::unicode::unescape_unicode_to_string(value).into_owned())
                    }
                    InlineExpression::VariableReference { id } => {
                        let slot = slots.iter().position(|name| *name == id.name)?;
                        let seen = used.get_mut(slot)?;
                        if std::mem::replace(seen, true) {
                            return None;
                        }
                        Part::Slot(slot)
                    }
                    _ => return None,
                },
                PatternElement::Placeable { .. } => return None,
            });
        }
        used.iter().all(|used| *used).then_some(Self(parts))
    }

    /// The text with the values in their slots.
    pub(super) fn fill(&self, values: &[&str]) -> String {
        self.0
            .iter()
            .map(|part| match part {
                Part::Text(text) => text.as_str(),
                Part::Slot(slot) => values.get(*slot).copied().unwrap_or_default(),
            })
            .collect()
    }
}
