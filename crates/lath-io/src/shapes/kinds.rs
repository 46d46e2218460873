//! The registry of kinds.

use lath::curve::AnyCurve;

use crate::error::Result;
use crate::json::Members;
use crate::shapes::object::Object;
use crate::shapes::{bezier, bspline, hermite, polyline, quintic};

/// How one family of curves travels.
pub(crate) struct Kind {
    /// The value of `"kind"`, which is also what the curve calls its kind.
    pub(crate) name: &'static str,
    /// Takes the members that define the curve and builds it.
    pub(crate) read: fn(&mut Members) -> Result<AnyCurve>,
    /// The members that define the curve; none for a curve of another family.
    pub(crate) write: fn(&AnyCurve) -> Option<Object>,
}

/// Every family that travels.
pub(crate) const KINDS: &[Kind] = &[bezier::KIND, bspline::KIND, hermite::KIND, polyline::KIND, quintic::KIND];

/// Kinds that the format defines and this version does not hold yet.
pub(crate) const PENDING: &[&str] = &["power", "path", "bezier-surface", "bspline-surface"];
