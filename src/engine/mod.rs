//! The reference engine: the virtual world in which programs run.
//!
//! Invariant: nothing here prints, reads files or knows a cycle; worlds are built from texts that are handed in.
pub mod draw;
pub mod geometry;
pub mod machine;
pub mod plan;
mod read;
pub mod run;
pub mod scene;
pub mod solid;
pub mod sphere;
pub mod stock;

pub use crate::program::table;
