//! The crate `curvo`: NURBS curves, here with unit weights, and an evaluator that remembers the last span.

use crate::Result;
use crate::evaluation::{DEGREE, Evaluates, Spline};
use curvo::prelude::NurbsCurve3D;
use nalgebra::Point4;

pub(crate) struct Curvo;

impl Evaluates for Curvo {
    const NAME: &'static str = "curvo 0.3";
    type Curve = NurbsCurve3D<f64>;

    fn build(spline: &Spline) -> Result<Self::Curve> {
        let points = spline.points.iter().map(|p| Point4::new(p[0], p[1], p[2], 1.0)).collect();
        Ok(NurbsCurve3D::try_new(DEGREE, points, spline.knots.clone())?)
    }

    fn evaluate(curve: &Self::Curve, parameters: &[f64], out: &mut Vec<[f64; 3]>) -> Result<()> {
        let mut evaluator = curve.evaluator();
        out.extend(parameters.iter().map(|t| <[f64; 3]>::from(evaluator.point_at(*t))));
        Ok(())
    }
}
