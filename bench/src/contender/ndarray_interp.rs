//! The crate `ndarray-interp`: natural cubic splines through rows of any dimension, borrowed from the caller.

use crate::Result;
use crate::interpolation::{Data, Interpolates};
use ndarray::{ArrayView1, ArrayView2, Ix2, ViewRepr};
use ndarray_interp::interp1d::Interp1D;
use ndarray_interp::interp1d::cubic_spline::{BoundaryCondition, CubicSpline, CubicSplineStrategy};

pub(crate) struct NdarrayInterp;

impl Interpolates for NdarrayInterp {
    const NAME: &'static str = "ndarray-interp 0.6";
    type Curve<'a> = Interp1D<ViewRepr<&'a f64>, ViewRepr<&'a f64>, Ix2, CubicSplineStrategy<ViewRepr<&'a f64>, Ix2>>;

    fn through(data: &Data) -> Result<Self::Curve<'_>> {
        let points = ArrayView2::from_shape((data.points.len(), 3), data.points.as_flattened())?;
        let natural = CubicSpline::new().boundary(BoundaryCondition::Natural);
        Ok(Interp1D::builder(points).x(ArrayView1::from(&data.parameters[..])).strategy(natural).build()?)
    }

    fn point(curve: &Self::Curve<'_>, t: f64) -> Result<[f64; 3]> {
        let point = curve.interp(t)?;
        Ok([point[0], point[1], point[2]])
    }
}
