//! lath and its peers, one file each. Every peer is asked in the way its own documentation recommends.

pub(crate) mod bspline;
#[cfg(feature = "heavy")]
pub(crate) mod curvo;
pub(crate) mod enterpolation;
#[cfg(feature = "heavy")]
pub(crate) mod geo;
pub(crate) mod lath;
pub(crate) mod ndarray_interp;
pub(crate) mod scipy;
#[cfg(feature = "heavy")]
pub(crate) mod scirs2;
mod vec3;

use crate::Result;
use std::time::Duration;

pub(crate) type Sample<'a> = Box<dyn FnMut() -> Result<Vec<[f64; 3]>> + 'a>;

/// Somebody who can do one workload.
pub(crate) struct Contender<'a> {
    pub(crate) name: &'static str,
    /// Whether it runs in this process, so that its allocations can be counted.
    pub(crate) here: bool,
    /// Points to compare; none for a yardstick, which computes nothing.
    pub(crate) sample: Option<Sample<'a>>,
    /// Does the work once and says how long it took.
    pub(crate) run: Box<dyn FnMut() -> Result<Duration> + 'a>,
}
