//! `polyline`: points, at t = 0, 1, 2, …

use core::any::Any;

use lath::curve::{Curve, Polyline, pad};

use crate::error::{Error, Result};
use crate::json::{Members, Rows};
use crate::shapes::bezier::refuse_closed;
use crate::shapes::kinds::Travels;
use crate::shapes::object::{Member, Object};

pub(crate) struct Data(Rows);

impl Travels for Data {
    const NAME: &'static str = "polyline";

    fn read(members: &mut Members) -> Result<Data> {
        refuse_closed(members)?;
        members.rows("points").map(Data)
    }

    fn dimension(&self) -> usize {
        self.0.width
    }

    fn build<const D: usize>(&self) -> lath::error::Result<Box<dyn Curve<D>>> {
        Ok(Box::new(Polyline::new(pad::<D>(&self.0.values, self.0.width))?))
    }

    fn refused(&self, members: &Members, core: lath::error::Error) -> Error {
        members.refused("points", core)
    }

    fn write<const D: usize>(curve: &dyn Curve<D>, dimension: usize) -> Option<Object> {
        let curve = (curve as &dyn Any).downcast_ref::<Polyline<D>>()?;
        let mut object = Object::default();
        object.push("points", Member::points(curve.points(), dimension));
        Some(object)
    }
}
