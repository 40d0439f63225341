//! Which word of an old-style line is which field of a specification, for everyone who reads such lines.
//!
//! Fields are known by their line, their shape and their order, never by the printed word, which is
//! another one in each language. Invariant: nothing here judges a value.
use crate::program::syntax::{Axis, CycleKeyword, NamedWord, OldCycleLine, Program, SHORTEST_LABEL, ValueKind};
use crate::spec::{CycleKey, Field, Keyword, Shape};

/// The key of a cycle that a program writes.
pub const fn key(keyword: CycleKeyword, number: u32) -> CycleKey {
    let keyword = match keyword {
        CycleKeyword::CyclDef => Keyword::CyclDef,
        CycleKeyword::TchProbe => Keyword::TchProbe,
    };
    CycleKey::new(keyword, number)
}

/// Whether a field may be on a line: on its own one, or on a later one if its line may be repeated.
pub const fn stands_on(field: &Field, line: &OldCycleLine) -> bool {
    field.line == line.line || (field.repeat && line.line > field.line)
}

/// The place of the first of the fields that the words begin with, and how many words make it up. Fields are
/// in their order: those before it are not written on this line.
pub fn first<'f>(
    program: &Program,
    mut fields: impl Iterator<Item = &'f Field>,
    words: &[NamedWord],
) -> Option<(usize, usize)> {
    let mut count = 0;
    let at = fields.position(|field| {
        count = width(program, field, words);
        count > 0
    })?;
    Some((at, count))
}

/// How many of the words make up the field: 0 if the first one does not.
fn width(program: &Program, field: &Field, words: &[NamedWord]) -> usize {
    let Some(word) = words.first() else { return 0 };
    let name = program.slice(word.name);
    let fits = match field.shape {
        Shape::Row => name == "#",
        Shape::Q => name.is_empty() && matches!(word.value.kind, ValueKind::Q { negative: false, .. }),
        Shape::AxisDirection => is_axis(name, false) && matches!(word.value.kind, ValueKind::Sign(_)),
        Shape::AxisCoordinate => is_coordinate(program, word, field.incremental),
        Shape::Position => {
            return words.iter().take_while(|word| is_coordinate(program, word, field.incremental)).count();
        }
        Shape::Word => {
            let own = field.word.as_deref().unwrap_or_default();
            let plain = name.strip_prefix(['I', 'i']).filter(|_| field.incremental);
            name.eq_ignore_ascii_case(own) || plain.is_some_and(|plain| plain.eq_ignore_ascii_case(own))
        }
        // Most are printed with a colon, the second value of a pair after a bar; of the others, short words are
        // those of other fields.
        Shape::Labelled => {
            let letters = name.chars().filter(|c| c.is_alphabetic()).count();
            name.ends_with([':', '/']) || (letters >= SHORTEST_LABEL && word.value.kind != ValueKind::Missing)
        }
        Shape::Axes => {
            let alone =
                |word: &&NamedWord| word.value.kind == ValueKind::Missing && is_axis(program.slice(word.name), false);
            return words.iter().take_while(alone).count();
        }
        Shape::Centre => return words.iter().take_while(|word| is_of_centre(program, word)).count(),
    };
    usize::from(fits)
}

fn is_axis(name: &str, incremental: bool) -> bool {
    let name = if incremental { name.strip_prefix(['I', 'i']).unwrap_or(name) } else { name };
    matches!(name.as_bytes(), [letter] if Axis::by_name(&[letter.to_ascii_uppercase()]).is_some())
}

fn is_of_centre(program: &Program, word: &NamedWord) -> bool {
    let valued = matches!(word.value.kind, ValueKind::Number(_) | ValueKind::Q { .. });
    let (centre, axis) = program.slice(word.name).split_at_checked(2).unwrap_or_default();
    valued && centre.eq_ignore_ascii_case("CC") && is_axis(axis, false)
}

fn is_coordinate(program: &Program, word: &NamedWord, incremental: bool) -> bool {
    let valued = matches!(word.value.kind, ValueKind::Number(_) | ValueKind::Q { .. });
    valued && is_axis(program.slice(word.name), incremental)
}
