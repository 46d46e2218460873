//! `hermite`: parameters, points and tangents; closed with one parameter more.

use core::any::Any;

use lath::curve::{AnyCurve, Curve, CurveBuilder, CurveVisitor, Hermite, pad};
use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::json::{Members, Rows};
use crate::shapes::kinds::Kind;
use crate::shapes::object::{Member, Object};

pub(crate) const KIND: Kind = Kind { name: "hermite", read, write: |curve| curve.visit(Write) };

struct Data {
    parameters: Vec<f64>,
    points: Rows,
    tangents: Rows,
    closed: bool,
}

impl CurveBuilder for &Data {
    fn build<const D: usize>(self) -> lath::error::Result<Box<dyn Curve<D>>> {
        let rows = |rows: &Rows| pad::<D>(&rows.values, rows.width);
        let make = if self.closed { Hermite::closed } else { Hermite::new };
        Ok(Box::new(make(self.parameters.clone(), rows(&self.points), rows(&self.tangents))?))
    }
}

fn read(members: &mut Members) -> Result<AnyCurve> {
    let closed = members.flag("closed")?;
    let parameters = members.numbers("parameters")?;
    let points = members.rows("points")?;
    let tangents = members.rows("tangents")?;
    if points.width != tangents.width {
        let message = format!("points have {} coordinates, tangents {}", points.width, tangents.width);
        return Err(Error::new(Code::Core(CoreCode::P005), message).at_pointer(members.pointer("tangents")));
    }
    let data = Data { parameters, points, tangents, closed };
    AnyCurve::build(data.points.width, &data).map_err(|core| members.refused(culprit(&core, &data), core))
}

/// The member a refusal speaks of: the core names an index, but points, tangents and parameters can all be out of
/// scale.
fn culprit(core: &lath::error::Error, data: &Data) -> &'static str {
    let out_of_scale = |rows: &Rows| {
        let row = core.index().and_then(|i| rows.values.chunks(rows.width.max(1)).nth(i));
        row.is_some_and(|row| row.iter().any(|x| x.abs() > 1e300))
    };
    match core.code() {
        CoreCode::P005 => "tangents",
        CoreCode::P003 if out_of_scale(&data.tangents) => "tangents",
        _ if core.is_parameter() => "parameters",
        _ => "points",
    }
}

struct Write;

impl CurveVisitor for Write {
    type Output = Option<Object>;

    fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Option<Object> {
        let curve = (curve as &dyn Any).downcast_ref::<Hermite<D>>()?;
        let mut object = Object::default();
        if curve.is_closed() {
            object.push("closed", Member::Flag(true));
        }
        object.push("parameters", Member::Numbers(curve.parameters().to_vec()));
        object.push("points", Member::points(curve.points(), dimension));
        object.push("tangents", Member::points(curve.tangents(), dimension));
        Some(object)
    }
}
