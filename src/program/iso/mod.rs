//! DIN/ISO and Klartext: each program in the words of the other language.
//!
//! [`to_klartext`] is the one place where DIN/ISO is understood: checker, engine and comparison read what it writes,
//! and [`Lowered`] knows where everything in it comes from. [`to_iso`] writes Klartext in DIN/ISO. Both refuse block by
//! block what the other language has no equivalent of. Invariant: a block is written in full or refused, never in part;
//! which code is which cycle, and which word which field, is in the specifications.
mod blocks;
mod codes;
mod home;
mod lower;
mod modes;
mod old;
mod raise;
mod words;
mod writer;

pub use codes::Codes;
pub use home::Lowered;
pub use lower::{Labels, to_klartext};
pub use raise::{Raised, to_iso};
