//! lath itself. There is no call for many parameters yet: points are asked for one by one, each checked.

use crate::Result;
use crate::accuracy::{Answers, Case, ORDERS};
use crate::evaluation::{DEGREE, Evaluates, Spline};
use crate::interpolation::{Data, Interpolates};
use crate::subdivision::{CutsCorners, STEPS};
use lath::curve::{BSpline, Curve, Hermite};
use lath::error::Limits;
use lath::interpolate::{End, Ends, cubic};
use lath::knot::Knots;
use lath::subdivide::{self, Scheme, Subdivision, Target};

pub(crate) struct Lath;

impl Interpolates for Lath {
    const NAME: &'static str = "lath";
    type Curve<'a> = Hermite<3>;

    fn through(data: &Data) -> Result<Hermite<3>> {
        Ok(cubic(&data.points, data.parameters.clone(), &Ends::Open(End::Natural, End::Natural))?)
    }

    fn point(curve: &Hermite<3>, t: f64) -> Result<[f64; 3]> {
        Ok(curve.eval(t)?)
    }
}

impl Evaluates for Lath {
    const NAME: &'static str = "lath";
    type Curve = BSpline<3>;

    fn build(spline: &Spline) -> Result<BSpline<3>> {
        Ok(BSpline::new(Knots::new(spline.knots.clone(), DEGREE)?, &spline.points)?)
    }

    fn evaluate(curve: &BSpline<3>, parameters: &[f64], out: &mut Vec<[f64; 3]>) -> Result<()> {
        for t in parameters {
            out.push(curve.eval(*t)?);
        }
        Ok(())
    }
}

impl CutsCorners for Lath {
    const NAME: &'static str = "lath";
    type Ring = Vec<[f64; 2]>;
    type Cut = Vec<[f64; 2]>;

    fn ring(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        points.to_vec()
    }

    fn cut(ring: &Vec<[f64; 2]>) -> Result<Vec<[f64; 2]>> {
        let sub = Subdivision::new(Scheme::chaikin(), ring.iter().copied(), subdivide::Ends::Closed)?;
        Ok(sub.level(STEPS, Target::Level, &Limits::default())?)
    }

    fn points(cut: &Vec<[f64; 2]>) -> Vec<[f64; 2]> {
        cut.clone()
    }
}

impl Answers for Lath {
    const NAME: &'static str = "lath";
    const ORDERS: usize = ORDERS;
    type Curve = BSpline<1>;

    fn curve(case: &Case) -> Result<BSpline<1>> {
        Ok(BSpline::new(Knots::new(case.knots.clone(), case.degree)?, case.points.iter().map(|x| [*x]))?)
    }

    fn answer(curve: &BSpline<1>, t: f64, out: &mut [f64]) -> Result<()> {
        out.iter_mut().zip(curve.jet(t, ORDERS - 1)?).for_each(|(out, [x])| *out = x);
        [out[0]] = curve.eval(t)?;
        Ok(())
    }
}
