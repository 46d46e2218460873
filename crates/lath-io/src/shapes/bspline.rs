//! `bspline`: degree, control points, their weights where the curve is rational, and knots where they are not uniform; closed with
//! one period of knots.

use core::any::Any;

use lath::curve::{BSpline, Curve, Nurbs, UniformBSpline, pad};
use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::json::{Members, Rows};
use crate::number::counted;
use crate::shapes::kinds::Travels;
use crate::shapes::object::{Member, Object};

/// By how much the degree of a closed curve may exceed the number of its points. Its knots are extended by the degree
/// on both sides: otherwise a file of a few bytes could ask for thousands.
const CLOSED_EXCESS: usize = 64;

pub(crate) struct Data {
    degree: usize,
    closed: bool,
    knots: Option<Vec<f64>>,
    points: Rows,
    weights: Option<Vec<f64>>,
}

impl Data {
    /// The open curve of these data.
    pub(crate) fn open(degree: usize, knots: Vec<f64>, points: Rows, weights: Option<Vec<f64>>) -> Data {
        Data { degree, closed: false, knots: Some(knots), points, weights }
    }
}

impl Travels for Data {
    const NAME: &'static str = "bspline";

    fn read(members: &mut Members) -> Result<Data> {
        let degree = members.count("degree")?;
        let closed = members.flag("closed")?;
        let points = members.rows("points")?;
        let count = points.values.len() / points.width.max(1);
        if closed && degree > count.saturating_add(CLOSED_EXCESS) {
            let message = format!("degree {degree} for a closed curve of {}", counted(count, "point"));
            return Err(Error::new(Code::Core(CoreCode::K006), message)
                .remedied(format!("Files hold closed curves of degree points + {CLOSED_EXCESS} at most."))
                .at_pointer(members.pointer("degree")));
        }
        let knots = members.optional_numbers("knots")?;
        Ok(Data { degree, closed, knots, points, weights: members.optional_numbers("weights")? })
    }

    fn dimension(&self) -> usize {
        self.points.width
    }

    fn build<const D: usize>(&self) -> lath::error::Result<Box<dyn Curve<D>>> {
        let points = pad::<D>(&self.points.values, self.points.width);
        let curve = match (&self.knots, self.closed) {
            (Some(knots), false) => BSpline::over(knots.clone(), self.degree, points)?,
            (Some(period), true) => BSpline::closed(period, self.degree, points)?,
            (None, false) => BSpline::uniform(self.degree, points)?,
            (None, true) => BSpline::closed_uniform(self.degree, points)?,
        };
        Ok(match &self.weights {
            None => Box::new(curve),
            Some(weights) => Box::new(curve.weighted(weights.iter().copied())?),
        })
    }

    fn refused(&self, members: &Members, core: lath::error::Error) -> Error {
        let member = match core.code() {
            CoreCode::K006 => "degree",
            _ if core.is_knots() => "knots",
            _ if core.is_weights() => "weights",
            _ => "points",
        };
        members.refused(member, core)
    }

    fn write<const D: usize>(curve: &dyn Curve<D>, dimension: usize) -> Option<Object> {
        // Uniform curves travel without knots; they are read as curves over uniform knots.
        let any: &dyn Any = curve;
        let rational = any.downcast_ref::<Nurbs<D>>();
        let (knots, points) = match any.downcast_ref::<UniformBSpline<D>>() {
            Some(curve) => (None, curve.control_points()),
            None => {
                let curve = rational.map(Nurbs::unweighted).or_else(|| any.downcast_ref::<BSpline<D>>())?;
                (Some(curve.period().unwrap_or_else(|| curve.knots().values())), curve.control_points())
            }
        };
        let mut object = Object::default();
        object.push("degree", Member::Whole(curve.degree()));
        if curve.is_closed() {
            object.push("closed", Member::Flag(true));
        }
        if let Some(knots) = knots {
            object.push("knots", Member::Numbers(knots.to_vec()));
        }
        object.push("points", Member::points(points, dimension));
        if let Some(rational) = rational {
            object.push("weights", Member::Numbers(rational.weights().to_vec()));
        }
        Some(object)
    }
}
