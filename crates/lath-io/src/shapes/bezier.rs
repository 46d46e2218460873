//! `bezier`: control points, their weights where the curve is rational, and the domain where it is not [0, 1].

use core::any::Any;

use lath::curve::{Bezier, Curve, Interval, RationalBezier, pad};
use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::json::{Members, Rows};
use crate::number::counted;
use crate::shapes::kinds::Travels;
use crate::shapes::object::{Member, Object};

const UNIT: Interval = Interval { start: 0.0, end: 1.0 };

pub(crate) struct Data {
    points: Rows,
    weights: Option<Vec<f64>>,
    domain: Interval,
}

impl Travels for Data {
    const NAME: &'static str = "bezier";

    fn read(members: &mut Members) -> Result<Data> {
        refuse_closed(members)?;
        let points = members.rows("points")?;
        let domain = match members.optional_numbers("domain")?.as_deref() {
            None => UNIT,
            Some(&[start, end]) => Interval { start, end },
            Some(other) => {
                let message = format!("\"domain\" has {}, not 2", counted(other.len(), "number"));
                return Err(Error::new(Code::F017, message).at_pointer(members.pointer("domain")));
            }
        };
        Ok(Data { points, weights: members.optional_numbers("weights")?, domain })
    }

    fn dimension(&self) -> usize {
        self.points.width
    }

    fn build<const D: usize>(&self) -> lath::error::Result<Box<dyn Curve<D>>> {
        let curve = Bezier::on(pad::<D>(&self.points.values, self.points.width), self.domain)?;
        Ok(match &self.weights {
            None => Box::new(curve),
            Some(weights) => Box::new(curve.weighted(weights.iter().copied())?),
        })
    }

    fn refused(&self, members: &Members, core: lath::error::Error) -> Error {
        let member = match () {
            () if core.is_parameter() => "domain",
            () if core.is_weights() => "weights",
            () => "points",
        };
        members.refused(member, core)
    }

    fn write<const D: usize>(curve: &dyn Curve<D>, dimension: usize) -> Option<Object> {
        let curve: &dyn Any = curve;
        let rational = curve.downcast_ref::<RationalBezier<D>>();
        let curve = rational.map(RationalBezier::unweighted).or_else(|| curve.downcast_ref::<Bezier<D>>())?;
        let mut object = Object::default();
        let domain = curve.domain();
        if domain != UNIT {
            object.push("domain", Member::Numbers(vec![domain.start, domain.end]));
        }
        object.push("points", Member::points(curve.control_points(), dimension));
        if let Some(rational) = rational {
            object.push("weights", Member::Numbers(rational.weights().to_vec()));
        }
        Some(object)
    }
}

/// A kind that cannot be closed takes `"closed": false` and refuses `true`.
pub(crate) fn refuse_closed(members: &mut Members) -> Result<()> {
    if members.flag("closed")? {
        let error = Error::new(Code::Core(CoreCode::C002), "a curve of this kind cannot be closed");
        return Err(error
            .remedied("Repeat the first point at the end, or use a closed bspline.")
            .at_pointer(members.pointer("closed")));
    }
    Ok(())
}
