//! The curve itself: each kind by the function of the library that makes it.

use crate::condition::Conditions;
use crate::derivative::Given;
use crate::kind::Kind;
use lath::curve::{Curve, CurveBuilder, Hermite, pad};
use lath::interpolate::{
    Derivative, Parameters, akima, bspline_closed, bspline_with_derivatives, cardinal, catmull_rom, cubic,
    cubic_closed, kochanek_bartels, makima, parameters, pchip, steffen,
};

/// Makes the curve in whatever dimension it is asked for.
pub(crate) struct Through<'a> {
    pub(crate) rows: &'a [f64],
    pub(crate) dimension: usize,
    pub(crate) rule: Parameters<'a>,
    pub(crate) closed: bool,
    pub(crate) tangents: Option<&'a [f64]>,
    pub(crate) kind: Kind,
    /// Of a B-spline.
    pub(crate) degree: usize,
    pub(crate) conditions: &'a Conditions,
    /// Of a B-spline, beside those of the ends.
    pub(crate) derivatives: &'a [Given],
    /// Receives the parameters of the points.
    pub(crate) parameters: &'a mut Vec<f64>,
}

impl CurveBuilder for Through<'_> {
    fn build<const D: usize>(self) -> lath::error::Result<Box<dyn Curve<D>>> {
        let points = pad::<D>(self.rows, self.dimension);
        let (t, closed) = (parameters(&points, self.closed, self.rule)?, self.closed);
        self.parameters.clone_from(&t);
        if let Some(rows) = self.tangents {
            let (tangents, make) =
                (pad::<D>(rows, self.dimension), if closed { Hermite::closed } else { Hermite::new });
            return Ok(Box::new(make(t, points, tangents)?));
        }
        Ok(match self.kind {
            Kind::Cubic if closed => Box::new(cubic_closed(points, t)?),
            Kind::Cubic => Box::new(cubic(points, t, &self.conditions.ends())?),
            Kind::BSpline if closed => Box::new(bspline_closed(points, t, self.degree)?),
            Kind::BSpline => {
                let (start, end) = self.conditions.bspline_ends();
                let derivatives: Vec<Derivative<D>> = self.derivatives.iter().map(Given::derivative).collect();
                Box::new(bspline_with_derivatives(points, t, self.degree, &start, &end, &derivatives)?)
            }
            Kind::CatmullRom => Box::new(catmull_rom(points, t, closed)?),
            Kind::Cardinal(tension) => Box::new(cardinal(points, t, closed, tension)?),
            Kind::KochanekBartels(tcb) => Box::new(kochanek_bartels(points, t, closed, tcb)?),
            Kind::Pchip => Box::new(pchip(points, t, closed)?),
            Kind::Akima => Box::new(akima(points, t, closed)?),
            Kind::Makima => Box::new(makima(points, t, closed)?),
            Kind::Steffen => Box::new(steffen(points, t, closed)?),
        })
    }
}
