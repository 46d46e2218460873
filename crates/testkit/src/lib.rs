//! What the tests of lath stand on; published nowhere.
//!
//! - [`layers`]: does the house keep its order?
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // tests stop at the first fault, loudly

pub mod layers;
