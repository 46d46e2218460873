//! `bspline`: degree, control points, and knots where they are not uniform; closed with one period of knots.

use core::any::Any;

use lath::curve::{AnyCurve, BSpline, Curve, CurveBuilder, CurveVisitor, pad};
use lath::error::Code as CoreCode;

use crate::error::{Error, Result};
use crate::json::{Members, Rows};
use crate::shapes::kinds::Kind;
use crate::shapes::object::{Member, Object};

pub(crate) const KIND: Kind = Kind { name: "bspline", read, write: |curve| curve.visit(Write) };

enum Over {
    Knots(Vec<f64>),
    Uniform,
    Period(Vec<f64>),
    UniformPeriod,
}

struct Build<'a> {
    degree: usize,
    over: Over,
    points: &'a Rows,
}

impl CurveBuilder for Build<'_> {
    fn build<const D: usize>(self) -> lath::error::Result<Box<dyn Curve<D>>> {
        let points = pad::<D>(&self.points.values, self.points.width);
        Ok(Box::new(match self.over {
            Over::Knots(knots) => BSpline::over(knots, self.degree, points)?,
            Over::Uniform => BSpline::uniform(self.degree, points)?,
            Over::Period(period) => BSpline::closed(&period, self.degree, points)?,
            Over::UniformPeriod => BSpline::closed_uniform(self.degree, points)?,
        }))
    }
}

fn read(members: &mut Members) -> Result<AnyCurve> {
    let degree = members.count("degree")?;
    let closed = members.flag("closed")?;
    let points = members.rows("points")?;
    let over = match (members.optional_numbers("knots")?, closed) {
        (None, false) => Over::Uniform,
        (None, true) => Over::UniformPeriod,
        (Some(knots), false) => Over::Knots(knots),
        (Some(period), true) => Over::Period(period),
    };
    let build = Build { degree, over, points: &points };
    AnyCurve::build(points.width, build)
        .map_err(|core| refused(members, if core.is_knots() { "knots" } else { "points" }, core))
}

fn refused(members: &Members, member: &'static str, core: lath::error::Error) -> Error {
    members.refused(if core.code() == CoreCode::K006 { "degree" } else { member }, core)
}

struct Write;

impl CurveVisitor for Write {
    type Output = Option<Object>;

    fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Option<Object> {
        let curve = (curve as &dyn Any).downcast_ref::<BSpline<D>>()?;
        let mut object = Object::default();
        object.push("degree", Member::Whole(curve.degree()));
        if curve.is_closed() {
            object.push("closed", Member::Flag(true));
        }
        let knots = curve.period().unwrap_or_else(|| curve.knots().values());
        object.push("knots", Member::Numbers(knots.to_vec()));
        object.push("points", Member::points(curve.control_points(), dimension));
        Some(object)
    }
}
