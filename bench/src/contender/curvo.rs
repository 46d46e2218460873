//! The crate `curvo`: NURBS curves, here with unit weights, and an evaluator that remembers the last span.

use crate::Result;
use crate::accuracy::{Answers, Case, ORDERS};
use crate::evaluation::{DEGREE, Evaluates, Spline};
use curvo::prelude::{NurbsCurve2D, NurbsCurve3D};
use nalgebra::{Point3, Point4};

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

/// The coordinate is x; curves of one dimension there are none.
impl Answers for Curvo {
    const NAME: &'static str = "curvo 0.3";
    const ORDERS: usize = ORDERS;
    type Curve = NurbsCurve2D<f64>;

    fn curve(case: &Case) -> Result<Self::Curve> {
        let points = case.points.iter().map(|x| Point3::new(*x, 0.0, 1.0)).collect();
        Ok(NurbsCurve2D::try_new(case.degree, points, case.knots.clone())?)
    }

    fn answer(curve: &Self::Curve, t: f64, out: &mut [f64]) -> Result<()> {
        let derivatives = curve.rational_derivatives(t, ORDERS - 1);
        out.iter_mut().zip(&derivatives).for_each(|(out, derivative)| *out = derivative.x);
        out[0] = curve.point_at(t).x;
        Ok(())
    }
}
