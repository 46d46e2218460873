//! `quintic-hermite`: parameters, points, first and second derivatives.

use core::any::Any;

use lath::curve::{AnyCurve, Curve, CurveBuilder, CurveVisitor, QuinticHermite, pad};
use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::json::{Members, Rows};
use crate::shapes::kinds::Kind;
use crate::shapes::object::{Member, Object};

pub(crate) const KIND: Kind = Kind { name: "quintic-hermite", read, write: |curve| curve.visit(Write) };

struct Data {
    parameters: Vec<f64>,
    points: Rows,
    tangents: Rows,
    seconds: Rows,
}

impl CurveBuilder for &Data {
    fn build<const D: usize>(self) -> lath::error::Result<Box<dyn Curve<D>>> {
        let rows = |rows: &Rows| pad::<D>(&rows.values, rows.width);
        let parameters = self.parameters.clone();
        Ok(Box::new(QuinticHermite::new(parameters, rows(&self.points), rows(&self.tangents), rows(&self.seconds))?))
    }
}

fn read(members: &mut Members) -> Result<AnyCurve> {
    let parameters = members.numbers("parameters")?;
    let points = members.rows("points")?;
    let tangents = members.rows("tangents")?;
    let seconds = members.rows("seconds")?;
    for (name, rows) in [("tangents", &tangents), ("seconds", &seconds)] {
        if rows.width != points.width {
            let message = format!("points have {} coordinates, {name} {}", points.width, rows.width);
            return Err(Error::new(Code::Core(CoreCode::P005), message).at_pointer(members.pointer(name)));
        }
    }
    let data = Data { parameters, points, tangents, seconds };
    AnyCurve::build(data.points.width, &data).map_err(|core| {
        let culprit = match core.code() {
            CoreCode::P005 => "tangents",
            _ if core.is_parameter() => "parameters",
            _ => "points",
        };
        members.refused(culprit, core)
    })
}

struct Write;

impl CurveVisitor for Write {
    type Output = Option<Object>;

    fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Option<Object> {
        let curve = (curve as &dyn Any).downcast_ref::<QuinticHermite<D>>()?;
        let mut object = Object::default();
        object.push("parameters", Member::Numbers(curve.parameters().to_vec()));
        object.push("points", Member::points(curve.points(), dimension));
        object.push("tangents", Member::points(curve.tangents(), dimension));
        object.push("seconds", Member::points(curve.seconds(), dimension));
        Some(object)
    }
}
