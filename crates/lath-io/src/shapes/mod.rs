//! Shapes: lath JSON, `{"lath": 1, "shapes": [ … ]}`.
//!
//! Each shape is an object with a `"kind"` and the members that define it:
//!
//! | kind | members |
//! |---|---|
//! | `bezier` | `points`; `weights`; `domain` `[a,b]`, without it `[0,1]` |
//! | `bspline` | `degree`, `points`; `weights`; `knots`: points + degree + 1, without them uniform; `closed`: then one period, points + 1 knots |
//! | `hermite` | `parameters`, `points`, `tangents`; `closed`: then one more parameter than points |
//! | `path` | `pieces`, shapes one after another; `closed`: the end is the start |
//! | `polyline` | `points`; t = 0, 1, 2, … |
//! | `power` | `breaks`, `coefficients`: `[piece][ascending power of t − break][coordinate]` |
//! | `quintic-hermite` | `parameters`, `points`, `tangents`, `seconds` |
//!
//! Every shape may have a `"name"`. `points` are `[[x,y],…]`, or `[x,…]` in one dimension. `weights`, one a point, make the curve
//! rational; its points are Cartesian, never multiplied by their weights. Nothing is ignored: unknown members are refused.
//!
//! What is written reads back with the same bits, one point a line.
//!
//! The same as JSON Schema is `schema/lath.schema.json`. Shapes of other systems that come as JSON are recognised by
//! their members: geomdl's export and SciPy's `t`, `c`, `k`.
//!
//! A kind that travels is one file here and one line in the registry (`kinds.rs`).

mod bezier;
mod bspline;
pub(crate) mod geomdl;
mod hermite;
mod kinds;
mod object;
mod path;
mod polyline;
mod power;
mod quintic;
mod read;
pub(crate) mod scipy;
mod write;

pub use read::read;
pub(crate) use read::{from_tree, list, recognise, shape};
pub use write::{to_string, write};

use lath::curve::AnyCurve;

/// A curve as it travels: with the name it may have.
///
/// Surfaces will be shapes too; then [`Shape::curve`] is none for them.
#[derive(Clone, Debug)]
pub struct Shape {
    name: Option<String>,
    curve: AnyCurve,
}

impl Shape {
    /// The same shape under a name.
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Shape {
        self.name = Some(name.into());
        self
    }

    /// The name, where there is one.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// The curve, where the shape is one.
    #[must_use]
    pub fn curve(&self) -> Option<&AnyCurve> {
        Some(&self.curve)
    }

    /// The kind, as it stands in the file.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        self.curve.kind()
    }
}

impl From<AnyCurve> for Shape {
    fn from(curve: AnyCurve) -> Shape {
        Shape { name: None, curve }
    }
}
