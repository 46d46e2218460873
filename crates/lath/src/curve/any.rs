//! A curve whose dimension is known at run time.

use crate::curve::interval::{Interval, Outside};
use crate::curve::protocol::{Curve, check_finite};
use crate::error::{Code, Count, Error, Result};
use crate::knot::Side;
use alloc::boxed::Box;
use alloc::format;
use alloc::sync::Arc;
use alloc::vec::Vec;
use core::any::Any;

/// The greatest dimension that [`AnyCurve`] holds.
pub const MAX_DIMENSION: usize = 16;

/// A curve of 1 to 16 dimensions, the number known at run time: what comes from files and other languages.
///
/// Inside, the dimension is one of 1, 2, 3, 4, 8 and 16, padded with coordinates that are zero; padding changes no bit
/// of the others. Cloning is cheap: the curve is shared.
///
/// ```
/// use lath::curve::{AnyCurve, Bezier, Curve, CurveBuilder, Outside, pad};
/// use lath::error::Result;
///
/// /// Builds a Bézier curve from rows of coordinates, in whatever dimension it is asked for.
/// struct Points<'a>(&'a [f64], usize);
///
/// impl CurveBuilder for Points<'_> {
///     fn build<const D: usize>(self) -> Result<Box<dyn Curve<D>>> {
///         Ok(Box::new(Bezier::new(pad::<D>(self.0, self.1))?))
///     }
/// }
///
/// let rows = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0];
/// let curve = AnyCurve::build(5, Points(&rows, 5))?;
/// let mut point = [0.0; 5];
/// curve.eval_into(0.5, Outside::Error, &mut point)?;
/// assert_eq!(point, [2.5, 3.5, 4.5, 5.5, 6.5]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct AnyCurve {
    dimension: usize,
    held: Held,
}

/// Makes a curve in any dimension; see [`AnyCurve`] for an example.
pub trait CurveBuilder {
    /// The curve in D dimensions; coordinates beyond the data's own are zero.
    ///
    /// # Errors
    /// Those of the family's constructor.
    fn build<const D: usize>(self) -> Result<Box<dyn Curve<D>>>;
}

/// Looks at a curve in its own dimension.
pub trait CurveVisitor {
    /// What the visit yields.
    type Output;

    /// Receives the curve; `dimension` ≤ D is the true one, and coordinates beyond it are zero.
    ///
    /// The family is found by `(curve as &dyn Any).downcast_ref::<BSpline<D>>()`.
    fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Self::Output;
}

/// The rows of a flat row-major table as points, padded with zeros.
pub fn pad<const D: usize>(rows: &[f64], dimension: usize) -> Vec<[f64; D]> {
    let row = |row: &[f64]| core::array::from_fn(|c| row.get(c).copied().unwrap_or(0.0));
    rows.chunks_exact(dimension.max(1)).map(row).collect()
}

macro_rules! instances {
    ($($name:ident $d:literal)*) => {
        #[derive(Clone, Debug)]
        enum Held {
            $($name(Arc<dyn Curve<$d>>),)*
        }

        impl AnyCurve {
            /// Builds the curve in the smallest instance that holds the dimension.
            ///
            /// # Errors
            /// P006 for dimension 0 or above 16, and the builder's own.
            pub fn build<B: CurveBuilder>(dimension: usize, builder: B) -> Result<AnyCurve> {
                let held = match dimension {
                    0 => None,
                    $(..=$d => Some(Held::$name(Arc::from(builder.build::<$d>()?))),)*
                    _ => None,
                };
                match held {
                    Some(held) => Ok(AnyCurve { dimension, held }),
                    None => Err(Error::new(Code::P006, format!("points of {dimension} coordinates"))),
                }
            }

            /// Takes a curve of a dimension that is an instance: 1, 2, 3, 4, 8 or 16.
            ///
            /// ```
            /// use lath::curve::{AnyCurve, Bezier};
            ///
            /// let curve = AnyCurve::of(Bezier::new([[0.0, 0.0], [1.0, 1.0]])?)?;
            /// assert_eq!((curve.kind(), curve.dimension()), ("bezier", 2));
            /// # Ok::<(), lath::error::Error>(())
            /// ```
            ///
            /// # Errors
            /// P006 for another dimension: build those with [`AnyCurve::build`].
            pub fn of<const D: usize>(curve: impl Curve<D>) -> Result<AnyCurve> {
                let curve: Arc<dyn Curve<D>> = Arc::new(curve);
                let any: &dyn Any = &curve;
                $(
                    if let Some(curve) = any.downcast_ref::<Arc<dyn Curve<$d>>>() {
                        return Ok(AnyCurve { dimension: $d, held: Held::$name(curve.clone()) });
                    }
                )*
                Err(Error::new(Code::P006, format!("a curve in {D} dimensions")))
            }

            /// Shows the curve in its own dimension to a visitor.
            pub fn visit<V: CurveVisitor>(&self, visitor: V) -> V::Output {
                match &self.held {
                    $(Held::$name(curve) => visitor.visit::<$d>(&**curve, self.dimension),)*
                }
            }
        }
    };
}

instances! { D1 1 D2 2 D3 3 D4 4 D8 8 D16 16 }

/// Defines a visitor that asks one question of any curve.
macro_rules! ask {
    ($self:ident, $output:ty, $curve:ident => $answer:expr) => {{
        struct Ask;
        impl CurveVisitor for Ask {
            type Output = $output;
            fn visit<const D: usize>(self, $curve: &dyn Curve<D>, _dimension: usize) -> $output {
                $answer
            }
        }
        $self.visit(Ask)
    }};
}

impl AnyCurve {
    /// The number of coordinates of a point.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The curve itself, if it lies in a plane: what is asked of plane curves alone.
    pub fn in_plane(&self) -> Option<&dyn Curve<2>> {
        match &self.held {
            Held::D2(curve) => Some(&**curve),
            _ => None,
        }
    }

    /// See [`Curve::kind`].
    pub fn kind(&self) -> &'static str {
        ask!(self, &'static str, curve => curve.kind())
    }

    /// See [`Curve::degree`].
    pub fn degree(&self) -> usize {
        ask!(self, usize, curve => curve.degree())
    }

    /// See [`Curve::domain`].
    pub fn domain(&self) -> Interval {
        ask!(self, Interval, curve => curve.domain())
    }

    /// See [`Curve::breaks`].
    pub fn breaks(&self) -> Vec<f64> {
        ask!(self, Vec<f64>, curve => curve.breaks())
    }

    /// See [`Curve::is_closed`].
    pub fn is_closed(&self) -> bool {
        ask!(self, bool, curve => curve.is_closed())
    }

    /// See [`Curve::is_rational`].
    pub fn is_rational(&self) -> bool {
        ask!(self, bool, curve => curve.is_rational())
    }

    /// The point at t, outside the domain by a policy, into the first `dimension` places of `out`.
    ///
    /// # Errors
    /// T001, T002, P003 as [`Curve::eval_outside`]; P005 if `out` is too short.
    pub fn eval_into(&self, t: f64, outside: Outside, out: &mut [f64]) -> Result<()> {
        if out.len() < self.dimension {
            let message =
                format!("{} for a point of {}", Count(out.len(), "place"), Count(self.dimension, "coordinate"));
            return Err(Error::new(Code::P005, message));
        }
        let t = self.domain().resolve(t, outside)?;
        self.jet_into(t, Side::Right, 0, out);
        check_finite(t, &out[..self.dimension])
    }

    /// See [`Curve::jet_into`]: order + 1 rows of `dimension` numbers, value first. Places beyond are left alone, and
    /// rows that do not fit are left out.
    pub fn jet_into(&self, t: f64, side: Side, order: usize, out: &mut [f64]) {
        struct Jet<'a>(f64, Side, usize, &'a mut [f64]);
        impl CurveVisitor for Jet<'_> {
            type Output = ();
            fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) {
                let Jet(t, side, order, out) = self;
                let mut jet = alloc::vec![[0.0; D]; order + 1];
                curve.jet_into(t, side, &mut jet);
                for (row, derivative) in out.chunks_exact_mut(dimension).zip(&jet) {
                    row.copy_from_slice(&derivative[..dimension]);
                }
            }
        }
        self.visit(Jet(t, side, order, out));
    }
}
