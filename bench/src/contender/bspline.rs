//! The crate `bspline`: de Boor's algorithm on any type that can be blended.

use crate::Result;
use crate::accuracy::{Answers, Case};
use crate::contender::vec3::Vec3;
use crate::evaluation::{DEGREE, Evaluates, Spline};
use bspline::BSpline;

pub(crate) struct Bspline;

impl Evaluates for Bspline {
    const NAME: &'static str = "bspline 1.1";
    type Curve = BSpline<Vec3, f64>;

    fn build(spline: &Spline) -> Result<Self::Curve> {
        let points = spline.points.iter().map(|p| Vec3(*p)).collect();
        Ok(BSpline::new(DEGREE, points, spline.knots.clone()))
    }

    fn evaluate(curve: &Self::Curve, parameters: &[f64], out: &mut Vec<[f64; 3]>) -> Result<()> {
        out.extend(parameters.iter().map(|t| curve.point(*t).0));
        Ok(())
    }
}

impl Answers for Bspline {
    const NAME: &'static str = "bspline 1.1";
    const ORDERS: usize = 1;
    type Curve = BSpline<f64, f64>;

    fn curve(case: &Case) -> Result<Self::Curve> {
        Ok(BSpline::new(case.degree, case.points.clone(), case.knots.clone()))
    }

    fn answer(curve: &Self::Curve, t: f64, out: &mut [f64]) -> Result<()> {
        out[0] = curve.point(t);
        Ok(())
    }
}
