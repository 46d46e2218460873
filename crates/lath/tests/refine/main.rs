//! The verbs of the floor `refine`: run on fractions they leave the curve equal, not nearly equal; on floats they stay within a few
//! units of the last place.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests stop at the first fault, loudly

mod accuracy;
mod exact;
mod rational;
mod splines;
