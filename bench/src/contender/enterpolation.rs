//! The crate `enterpolation`: de Boor's algorithm in a work space of constant size. Its knots leave out the first and
//! the last, which no value depends on.

use crate::Result;
use crate::accuracy::{Answers, Case};
use crate::contender::vec3::Vec3;
use crate::evaluation::{DEGREE, Evaluates, Spline};
use enterpolation::bspline::BSpline;
use enterpolation::{ConstSpace, DynSpace, Signal, Sorted};

pub(crate) struct Enterpolation;

impl Evaluates for Enterpolation {
    const NAME: &'static str = "enterpolation 0.3";
    type Curve = BSpline<Sorted<Vec<f64>>, Vec<Vec3>, ConstSpace<Vec3, { DEGREE + 1 }>>;

    fn build(spline: &Spline) -> Result<Self::Curve> {
        let points: Vec<Vec3> = spline.points.iter().map(|p| Vec3(*p)).collect();
        let knots = spline.knots[1..spline.knots.len() - 1].to_vec();
        let curve = BSpline::builder().elements(points).knots(knots).constant::<{ DEGREE + 1 }>().build();
        Ok(curve.map_err(|error| format!("{error:?}"))?)
    }

    fn evaluate(curve: &Self::Curve, parameters: &[f64], out: &mut Vec<[f64; 3]>) -> Result<()> {
        out.extend(parameters.iter().map(|t| curve.eval(*t).0));
        Ok(())
    }
}

impl Answers for Enterpolation {
    const NAME: &'static str = "enterpolation 0.3";
    const ORDERS: usize = 1;
    type Curve = BSpline<Sorted<Vec<f64>>, Vec<f64>, DynSpace<f64>>;

    fn curve(case: &Case) -> Result<Self::Curve> {
        let knots = case.knots[1..case.knots.len() - 1].to_vec();
        let curve = BSpline::builder().elements(case.points.clone()).knots(knots).dynamic().build();
        Ok(curve.map_err(|error| format!("{error:?}"))?)
    }

    fn answer(curve: &Self::Curve, t: f64, out: &mut [f64]) -> Result<()> {
        out[0] = curve.eval(t);
        Ok(())
    }
}
