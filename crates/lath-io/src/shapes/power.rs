//! `power`: breaks, and for each piece the coefficients of ascending powers of t − break.

use core::any::Any;

use lath::curve::{Curve, Power, pad};
use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::json::{Json, Members, child, rows};
use crate::number::counted;
use crate::shapes::kinds::Travels;
use crate::shapes::object::{Member, Object};

pub(crate) struct Data {
    breaks: Vec<f64>,
    width: usize,
    /// Coefficients a piece.
    count: usize,
    values: Vec<f64>,
}

impl Travels for Data {
    const NAME: &'static str = "power";

    fn read(members: &mut Members) -> Result<Data> {
        let breaks = members.numbers("breaks")?;
        let pieces = members.require("coefficients", "[piece][power][coordinate]")?;
        let pointer = members.pointer("coefficients");
        let pieces = match pieces {
            Json::Array(pieces) => Vec::from(pieces),
            Json::Numbers(none) if none.is_empty() => {
                let error = Error::new(Code::Core(CoreCode::P001), "there are no pieces");
                return Err(error.at_pointer(pointer));
            }
            Json::Numbers(_) => {
                let error = Error::new(Code::F017, "piece 0 is a number, not an array of coefficients");
                return Err(error.at_pointer(child(&pointer, "0")));
            }
            other => {
                let message = format!("{} where [piece][power][coordinate] is needed", other.type_name());
                return Err(Error::new(Code::F017, message).at_pointer(pointer));
            }
        };
        let mut data = Data { breaks, width: 0, count: 0, values: Vec::new() };
        for (index, piece) in pieces.into_iter().enumerate() {
            let here = child(&pointer, &index.to_string());
            let refuse = |message: String| Error::new(Code::Core(CoreCode::P005), message).at_index(index);
            let piece = rows(piece, &here)?;
            let count = piece.values.len() / piece.width;
            if index == 0 {
                (data.width, data.count) = (piece.width, count);
            }
            if piece.width != data.width {
                let message =
                    format!("piece {index} has {}, the first has {}", counted(piece.width, "coordinate"), data.width);
                return Err(refuse(message).at_pointer(here));
            }
            if count != data.count {
                let message = format!("piece {index} has {count} coefficients, the first has {}", data.count);
                return Err(refuse(message).at_pointer(here));
            }
            data.values.extend(piece.values);
        }
        Ok(data)
    }

    fn dimension(&self) -> usize {
        self.width
    }

    fn build<const D: usize>(&self) -> lath::error::Result<Box<dyn Curve<D>>> {
        let coefficients = pad::<D>(&self.values, self.width);
        Ok(Box::new(Power::new(self.breaks.clone(), coefficients.chunks(self.count.max(1)))?))
    }

    fn refused(&self, members: &Members, core: lath::error::Error) -> Error {
        members.refused(if core.is_parameter() { "breaks" } else { "coefficients" }, core)
    }

    fn write<const D: usize>(curve: &dyn Curve<D>, dimension: usize) -> Option<Object> {
        let curve = (curve as &dyn Any).downcast_ref::<Power<D>>()?;
        let mut object = Object::default();
        object.push("breaks", Member::Numbers(curve.breaks()));
        let pieces = curve.coefficients().map(|piece| Member::points(piece, dimension)).collect();
        object.push("coefficients", Member::Blocks(pieces));
        Some(object)
    }
}
