//! What is read off a program by itself, without its run and without other files.
//!
//! Start reading in [`reading`]. Invariant: nothing here knows rules, or what blocks before others have done.
mod blocks;
mod definition;
mod fields;
mod item;
mod language;
mod reading;
mod unread;
mod values;
pub(super) mod words;
mod work;

pub(super) use blocks::{
    assigned, calls_in, constant, copied, each_function, is_silent, needs_feed, reads, remark, stops,
};
pub(super) use definition::with_meaning;
pub use definition::{Defined, Definition};
pub use item::Item;
pub(super) use language::language_of;
pub use reading::{Flow, Reading};
pub use unread::Unread;
pub(super) use unread::{Hides, hides, names_end};
pub(super) use values::{bits, each_refused, kind, number, refused, refused_by_all, shown};
pub(super) use work::Work;
pub use work::mills_by_name;
