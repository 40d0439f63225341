//! Laws of contours over random outlines of lines, arcs, roundings and chamfers, on both sides and in both directions, for
//! every tool axis, level and rising, mirrored, turned and scaled: the tool's centre keeps the distance of its radius,
//! reaches every point of the outline that it can reach, and leaves the nominal part; a tool that does not fit between
//! neighbours is refused; every way to a contour and away from it lies where its words say.
//!
//! Distances are calculated here from points, with plain trigonometry. Roundings and chamfers are proven first, on the
//! path without compensation, against the corners of the outline.
//! `CIKLO_SEARCH=1 CIKLO_CASES=2000 cargo test --release --test laws contours` tries more of them.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
mod free;
mod leads;
mod outline;
mod path;
mod withheld;
