//! Execution of a cycle from its plan: values, guards, steps, series, patterns, logs, rehearsals.
//!
//! Start reading at [`execute`] (guards, steps, choices), then `act` (what each verb does) and `strategy` (how a
//! strategy is called). Invariant: knows plans and no blocks; no cycle is known by its number. Whoever is executed here
//! does not know whether it is rehearsed.
mod act;
mod contours;
mod control;
mod execute;
mod kinematics_log;
mod log;
mod pattern;
mod rehearsal;
mod series;
mod strategy;
mod synchronized;
