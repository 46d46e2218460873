//! lath-draw
