//! The reference engine: the virtual world in which programs run.
//!
//! Invariant: nothing here prints, reads files or knows a cycle; worlds are built from texts that are handed in.
mod contour;
mod cycle;
mod flow;
pub mod geometry;
pub mod machine;
mod motion;
mod params;
pub mod plan;
mod read;
pub mod region;
mod report;
pub mod run;
pub mod scene;
pub mod solid;
pub mod sphere;
pub mod stock;
pub mod strategy;
mod world;

pub use crate::program::table;
