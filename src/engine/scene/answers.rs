//! What the operator says when the program stops or asks.
//!
//! Invariant: an answer is used once; answers to the same question are used in the order of the scene.
use crate::engine::read::Reader;
use crate::spec::{Kind, Node};

/// The answers of a scene, consumed one by one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answers(Vec<Answer>);

/// An answer to whatever is asked next, or to one question only.
#[derive(Clone, Debug, PartialEq)]
struct Answer {
    to: Option<String>,
    say: String,
}

impl Answers {
    /// The next answer to a question (`stop`, `confirm`, or the id of a question); it is used up.
    pub fn next(&mut self, question: &str) -> Option<String> {
        let fits = |answer: &Answer| answer.to.as_deref().is_none_or(|to| to == question);
        let at = self.0.iter().position(fits)?;
        Some(self.0.remove(at).say)
    }

    /// Whether all answers were used.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn read(node: &Node, reader: &mut Reader<'_>) -> Self {
        let mut answers = Vec::new();
        for item in reader.items(node) {
            if !matches!(item.kind, Kind::Map(_)) {
                answers.extend(reader.text(item).map(|say| Answer { to: None, say: say.to_owned() }));
                continue;
            }
            reader.only_keys(item, &["to", "say"]);
            let to = item.get("to").and_then(|to| reader.text(to)).map(str::to_owned);
            let say = reader.need(item, "say").and_then(|say| reader.text(say));
            answers.extend(say.map(|say| Answer { to, say: say.to_owned() }));
        }
        Self(answers)
    }
}
