//! Drilling, boring and thread cycles proved on the part that they leave and on the events that they tell, over random
//! legal parameters: tool axes, mirrored, turned and shifted systems, both hands, both signs of the depth.
//!
//! Nominal shapes, grooves and times are calculated here from the parameters, with plain trigonometry. A failure shrinks
//! to a small program and its scene, both printed, which `ciklo run --stock` executes.
//! `PROPTEST_CASES=2000 cargo test --release --test laws drilling` tries more of them.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
mod boring;
mod clock;
mod findings;
mod groove;
mod infeeds;
mod milled;
mod scaled;
mod setup;
mod signs;
mod tapped;
