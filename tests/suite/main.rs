//! What the library does, module by module: mostly data beside this directory (`tests/check/`, `tests/syntax/` …)
//! with a runner here. `UPDATE=1 cargo test --test suite` rewrites expectations; `git diff` shows what changed.
//!
//! One program, so that the library is linked once; a file is a module of tests.
// A result is compared with one that was calculated in another way, to a tolerance: other bits are no matter here.
#![allow(clippy::disallowed_methods)]

#[macro_use]
#[path = "../support/laws.rs"]
mod laws;
mod blocks;
mod books;
#[path = "../support/built.rs"]
mod built;
#[path = "../support/cases.rs"]
mod cases;
mod check;
mod circles;
mod compare;
mod conform;
mod consistency;
mod convert;
mod courses;
mod coverage;
mod documents;
mod engine;
mod engine_plan;
mod exchange;
mod export;
mod expr;
mod figures;
mod files;
mod german;
mod habits;
#[path = "../support/html.rs"]
mod html;
mod iso;
mod layout;
mod locale;
mod logs;
mod long;
mod manual;
mod manuals;
#[path = "../support/mistakes.rs"]
mod mistakes;
mod on_demand;
mod page_parts;
mod plain_lines;
mod presets;
#[cfg(feature = "pdf")]
mod printed;
mod programs;
mod settings;
#[path = "../support/small.rs"]
mod small;
mod specs;
mod spheres;
mod strategies;
mod syntax;
mod tidy;
mod translate;
mod turning_tools;
mod world;
