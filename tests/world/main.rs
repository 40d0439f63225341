//! The world of the engine: geometry, solids, tables, scenes.
mod geometry;
mod scenes;
mod solid_cases;
mod solid_laws;
mod tables;
mod texts;
