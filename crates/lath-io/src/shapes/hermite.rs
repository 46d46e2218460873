//! `hermite`: parameters, points and tangents; closed with one parameter more.

use core::any::Any;

use lath::curve::{Curve, Hermite, pad};
use lath::error::Code as CoreCode;

use crate::error::{Error, Result};
use crate::json::{Members, Rows};
use crate::number::counted;
use crate::shapes::kinds::Travels;
use crate::shapes::object::{Member, Object};

pub(crate) struct Data {
    parameters: Vec<f64>,
    points: Rows,
    tangents: Rows,
    closed: bool,
}

impl Travels for Data {
    const NAME: &'static str = "hermite";

    fn read(members: &mut Members) -> Result<Data> {
        let closed = members.flag("closed")?;
        let parameters = members.numbers("parameters")?;
        let points = members.rows("points")?;
        let tangents = members.rows("tangents")?;
        same_width(members, &points, "tangents", &tangents)?;
        Ok(Data { parameters, points, tangents, closed })
    }

    fn dimension(&self) -> usize {
        self.points.width
    }

    fn build<const D: usize>(&self) -> lath::error::Result<Box<dyn Curve<D>>> {
        let rows = |rows: &Rows| pad::<D>(&rows.values, rows.width);
        let make = if self.closed { Hermite::closed } else { Hermite::new };
        Ok(Box::new(make(self.parameters.clone(), rows(&self.points), rows(&self.tangents))?))
    }

    fn refused(&self, members: &Members, core: lath::error::Error) -> Error {
        members.refused(culprit(&core, &[("tangents", &self.tangents)]), core)
    }

    fn write<const D: usize>(curve: &dyn Curve<D>, dimension: usize) -> Option<Object> {
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

/// Refuses derivatives with another number of coordinates than the points.
pub(crate) fn same_width(members: &Members, points: &Rows, name: &'static str, rows: &Rows) -> Result<()> {
    if rows.width == points.width {
        return Ok(());
    }
    let message = format!("points have {}, {name} {}", counted(points.width, "coordinate"), rows.width);
    Err(Error::from(lath::error::Error::new(CoreCode::P005, message)).at_pointer(members.pointer(name)))
}

/// The member a refusal speaks of: the core names an index, but parameters, points and derivatives can all be out of
/// scale, or too few.
pub(crate) fn culprit(core: &lath::error::Error, derivatives: &[(&'static str, &Rows)]) -> &'static str {
    let out_of_scale = |rows: &Rows| {
        let row = core.index().and_then(|i| rows.values.chunks(rows.width.max(1)).nth(i));
        row.is_some_and(|row| row.iter().any(|x| x.abs() > 1e300))
    };
    let of = |wanted: &dyn Fn(&str, &Rows) -> bool| {
        derivatives.iter().find(|(name, rows)| wanted(name, rows)).map(|(name, _)| *name)
    };
    let named = |name: &str, _: &Rows| core.message().contains(name);
    match core.code() {
        CoreCode::P005 => of(&named).or(of(&|_, _| true)).unwrap_or("points"),
        CoreCode::P003 => of(&|_, rows| out_of_scale(rows)).unwrap_or("points"),
        _ if core.is_parameter() => "parameters",
        _ => "points",
    }
}
