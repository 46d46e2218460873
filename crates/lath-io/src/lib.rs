//! lath-io
