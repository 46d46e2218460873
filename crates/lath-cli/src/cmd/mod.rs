//! The verbs, one file each: its options, its help with examples, and what it does.

pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod convert;
pub(crate) mod curve;
pub(crate) mod draw;
pub(crate) mod eval;
pub(crate) mod exact;
pub(crate) mod info;
pub(crate) mod length;
pub(crate) mod man;
pub(crate) mod refine;
pub(crate) mod sample;
pub(crate) mod subdivide;
pub(crate) mod through;
