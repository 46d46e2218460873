//! The crate `scirs2-interpolate`: natural cubic splines of one coordinate, so three of them. Its interpolation is
//! timed; its evaluation, which searches the segment from the first one on, only serves to compare.

use crate::Result;
use crate::interpolation::{Data, Interpolates};
use ndarray::{ArrayView1, ArrayView2};
use scirs2_interpolate::spline::CubicSpline;

pub(crate) struct Scirs2;

impl Interpolates for Scirs2 {
    const NAME: &'static str = "scirs2-interpolate 0.6, three";
    type Curve<'a> = [CubicSpline<f64>; 3];

    fn through(data: &Data) -> Result<Self::Curve<'_>> {
        let points = ArrayView2::from_shape((data.points.len(), 3), data.points.as_flattened())?;
        let parameters = ArrayView1::from(&data.parameters[..]);
        let spline = |axis| CubicSpline::new(&parameters, &points.column(axis));
        Ok([spline(0)?, spline(1)?, spline(2)?])
    }

    fn point(curve: &Self::Curve<'_>, t: f64) -> Result<[f64; 3]> {
        Ok([curve[0].evaluate(t)?, curve[1].evaluate(t)?, curve[2].evaluate(t)?])
    }
}
