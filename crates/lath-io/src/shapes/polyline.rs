//! `polyline`: points, at t = 0, 1, 2, …

use core::any::Any;

use lath::curve::{AnyCurve, Curve, CurveBuilder, CurveVisitor, Polyline, pad};

use crate::error::Result;
use crate::json::{Members, Rows};
use crate::shapes::bezier::refuse_closed;
use crate::shapes::kinds::Kind;
use crate::shapes::object::{Member, Object};

pub(crate) const KIND: Kind = Kind { name: "polyline", read, write: |curve| curve.visit(Write) };

struct Build<'a>(&'a Rows);

impl CurveBuilder for Build<'_> {
    fn build<const D: usize>(self) -> lath::error::Result<Box<dyn Curve<D>>> {
        Ok(Box::new(Polyline::new(pad::<D>(&self.0.values, self.0.width))?))
    }
}

fn read(members: &mut Members) -> Result<AnyCurve> {
    refuse_closed(members)?;
    let points = members.rows("points")?;
    AnyCurve::build(points.width, Build(&points)).map_err(|core| members.refused("points", core))
}

struct Write;

impl CurveVisitor for Write {
    type Output = Option<Object>;

    fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Option<Object> {
        let curve = (curve as &dyn Any).downcast_ref::<Polyline<D>>()?;
        let mut object = Object::default();
        object.push("points", Member::points(curve.points(), dimension));
        Some(object)
    }
}
