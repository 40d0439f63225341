//! The world of the engine: geometry, solids, tables, scenes.
#![expect(clippy::disallowed_methods, reason = "expected numbers are calculated without the functions under test")]
mod geometry;
mod meshes;
mod scenes;
mod solid_cases;
mod solid_laws;
mod tables;
mod texts;
