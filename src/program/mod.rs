//! NC programs and tables as files: read without loss, understood as blocks and words, written again.
//!
//! [`syntax`] parses Klartext and DIN/ISO, [`iso`] carries one over into the other, [`table`] reads the tables of a
//! control, [`layout`] formats. Invariant: knows what is written, and not whether it is right (`check`) or what it
//! does (`engine`). Start with [`syntax`].
pub mod fields;
pub mod iso;
pub mod layout;
pub mod syntax;
pub mod table;
