//! Conformance: the examples of the specifications executed by the engine.
//!
//! Invariant: what an example expects is compared, never adapted.
mod texts;

pub use texts::LogTexts;
