//! Laws of milling cycles over random legal parameters: the part left is the nominal solid with the allowances that
//! the program leaves, nothing else is cut, rapid traverse touches no material, no step is deeper and no cut wider than
//! the program allows, milling climbs or not as asked for, and the tool ends where the manual says.
//!
//! Nominal solids and the engagement of the tool are calculated here, with plain trigonometry. A failure shrinks to a
//! program and a scene, which `ciklo run --stock` executes. `PROPTEST_CASES=1000 cargo test --release --test laws milling`
//! tries more of them.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
mod contours;
mod faces;
mod field;
mod job;
mod limits;
mod pockets;
mod slots;
mod studs;
