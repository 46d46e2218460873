//! lath
