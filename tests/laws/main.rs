//! Laws of the engine over random legal input, and machining proved by the part that is left.
//!
//! `cargo test` draws the same cases everywhere; how to search for new ones is in `tests/support/cases.rs`.
// A result is compared with one that was calculated in another way, to a tolerance: other bits are no matter here.
#![allow(clippy::disallowed_methods)]

#[macro_use]
#[path = "../support/laws.rs"]
mod laws;
mod bad_geometry;
#[path = "../support/built.rs"]
mod built;
#[path = "../support/cases.rs"]
mod cases;
mod contours;
mod cylinder;
mod digitizing;
mod drilling;
mod envelope;
mod expected;
#[path = "../support/in_inches.rs"]
mod in_inches;
mod inch;
mod kinematics;
mod machining;
mod measuring;
mod milling;
mod patterns;
mod probing;
mod recess;
mod region;
mod rotary;
mod section;
mod special_cycles;
mod stock;
mod stock_steps;
mod strategies;
mod tcpm;
mod tool_setter;
mod touch;
mod transforms;
mod turned_body;
mod turning;
mod turning_contours;
mod turning_threads;
mod worked;
