//! Contours: elements, the path of the tool beside them, and the ways to them and away from them.
pub(in crate::engine) mod approach;
pub(in crate::engine) mod element;
pub(in crate::engine) mod outline;
pub(in crate::engine) mod path;
