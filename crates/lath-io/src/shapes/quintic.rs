//! `quintic-hermite`: parameters, points, first and second derivatives.

use core::any::Any;

use lath::curve::{Curve, QuinticHermite, pad};

use crate::error::{Error, Result};
use crate::json::{Members, Rows};
use crate::shapes::hermite::{culprit, same_width};
use crate::shapes::kinds::Travels;
use crate::shapes::object::{Member, Object};

pub(crate) struct Data {
    parameters: Vec<f64>,
    points: Rows,
    tangents: Rows,
    seconds: Rows,
}

impl Travels for Data {
    const NAME: &'static str = "quintic-hermite";

    fn read(members: &mut Members) -> Result<Data> {
        let parameters = members.numbers("parameters")?;
        let points = members.rows("points")?;
        let tangents = members.rows("tangents")?;
        let seconds = members.rows("seconds")?;
        same_width(members, &points, "tangents", &tangents)?;
        same_width(members, &points, "seconds", &seconds)?;
        Ok(Data { parameters, points, tangents, seconds })
    }

    fn dimension(&self) -> usize {
        self.points.width
    }

    fn build<const D: usize>(&self) -> lath::error::Result<Box<dyn Curve<D>>> {
        let rows = |rows: &Rows| pad::<D>(&rows.values, rows.width);
        let parameters = self.parameters.clone();
        Ok(Box::new(QuinticHermite::new(parameters, rows(&self.points), rows(&self.tangents), rows(&self.seconds))?))
    }

    fn refused(&self, members: &Members, core: lath::error::Error) -> Error {
        members.refused(culprit(&core, &[("tangents", &self.tangents), ("seconds", &self.seconds)]), core)
    }

    fn write<const D: usize>(curve: &dyn Curve<D>, dimension: usize) -> Option<Object> {
        let curve = (curve as &dyn Any).downcast_ref::<QuinticHermite<D>>()?;
        let mut object = Object::default();
        object.push("parameters", Member::Numbers(curve.parameters().to_vec()));
        object.push("points", Member::points(curve.points(), dimension));
        object.push("tangents", Member::points(curve.tangents(), dimension));
        object.push("seconds", Member::points(curve.seconds(), dimension));
        Some(object)
    }
}
