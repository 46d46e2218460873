//! `path`: shapes one after another.

use core::any::Any;

use lath::curve::{AnyCurve, Curve, CurveBuilder, Path};
use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::json::{Json, Members, child};
use crate::number::counted;
use crate::shapes::kinds::{self, Travels};
use crate::shapes::object::{Member, Object};

pub(crate) struct Data {
    closed: bool,
    dimension: usize,
    pieces: Vec<kinds::Data>,
}

impl Travels for Data {
    const NAME: &'static str = "path";

    /// How deep paths may hold paths is limited by how deep JSON may be nested.
    fn read(members: &mut Members) -> Result<Data> {
        let closed = members.flag("closed")?;
        let pointer = members.pointer("pieces");
        let list = match members.require("pieces", "[…], a list of shapes")? {
            Json::Array(list) => Vec::from(list),
            Json::Numbers(numbers) => numbers.iter().copied().map(Json::Number).collect(),
            other => {
                let message = format!("\"pieces\" is {}, not an array", other.type_name());
                return Err(Error::new(Code::F017, message).at_pointer(pointer));
            }
        };
        let mut data = Data { closed, dimension: 1, pieces: Vec::new() };
        for (index, tree) in list.into_iter().enumerate() {
            let here = child(&pointer, &index.to_string());
            let mut members = Members::of(tree, here.as_str())?;
            let piece = kinds::read(&mut members)?;
            members.finish()?;
            if index == 0 {
                data.dimension = piece.dimension();
            }
            if piece.dimension() != data.dimension {
                let message = format!(
                    "piece {index} has {}, piece 0 has {}",
                    counted(piece.dimension(), "coordinate"),
                    data.dimension
                );
                return Err(Error::new(Code::Core(CoreCode::P005), message).at_pointer(here).at_index(index));
            }
            // Built here only for its faults: its members are still at hand to name their places.
            AnyCurve::build(piece.dimension(), &piece).map_err(|core| piece.refused(&members, core))?;
            data.pieces.push(piece);
        }
        Ok(data)
    }

    fn dimension(&self) -> usize {
        self.dimension
    }

    fn build<const D: usize>(&self) -> lath::error::Result<Box<dyn Curve<D>>> {
        let pieces: Vec<_> = self.pieces.iter().map(CurveBuilder::build::<D>).collect::<lath::error::Result<_>>()?;
        Ok(Box::new(Path::new(pieces, self.closed)?))
    }

    fn refused(&self, members: &Members, core: lath::error::Error) -> Error {
        members.refused(if core.code() == CoreCode::C002 { "closed" } else { "pieces" }, core)
    }

    fn write<const D: usize>(curve: &dyn Curve<D>, dimension: usize) -> Option<Object> {
        let curve = (curve as &dyn Any).downcast_ref::<Path<D>>()?;
        let mut object = Object::default();
        if curve.is_closed() {
            object.push("closed", Member::Flag(true));
        }
        let mut pieces = Vec::new();
        for piece in curve.pieces() {
            let (kind, body) = kinds::write_in(&**piece, dimension)?;
            pieces.push(Object::of_kind(kind, None, body));
        }
        object.push("pieces", Member::Objects(pieces));
        Some(object)
    }
}
