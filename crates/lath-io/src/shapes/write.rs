//! Writing lath JSON.

use std::io::Write;

use crate::error::{Code, Error, Result};
use crate::shapes::Shape;
use crate::shapes::kinds;
use crate::shapes::object::Object;

/// Writes shapes as lath JSON, one point a line; reading it back gives the same bits.
///
/// # Errors
/// F019 a curve of a kind that does not travel; I005 where writing fails.
pub fn write(out: &mut dyn Write, shapes: &[Shape]) -> Result<()> {
    let text = to_string(shapes)?;
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|e| Error::writing(&e))
}

/// The lath JSON of these shapes.
///
/// ```
/// use lath::error::Limits;
/// use lath_io::{shapes, source::Source};
///
/// let text = r#"{"lath": 1, "shapes": [{"kind": "polyline", "points": [[0, 0.5], [1e-7, 2]]}]}"#;
/// let shapes = shapes::read(&Source::from_bytes("line.json", text), &Limits::default())?;
/// let written = shapes::to_string(&shapes)?;
/// assert_eq!(written, r#"{"lath": 1, "shapes": [
///   {
///     "kind": "polyline",
///     "points": [
///       [0, 0.5],
///       [1e-7, 2]
///     ]
///   }
/// ]}
/// "#);
/// # Ok::<(), lath_io::Error>(())
/// ```
///
/// # Errors
/// F019 a curve of a kind that does not travel.
pub fn to_string(shapes: &[Shape]) -> Result<String> {
    let mut text = String::from("{\"lath\": 1, \"shapes\": [");
    for (index, shape) in shapes.iter().enumerate() {
        text.push_str(if index == 0 { "\n" } else { ",\n" });
        text.push_str("  ");
        object(shape).and_then(|object| object.print(1, &mut text)).map_err(|error| error.at_index(index))?;
    }
    text.push_str("\n]}\n");
    Ok(text)
}

fn object(shape: &Shape) -> Result<Object> {
    let Some((kind, body)) = kinds::write(&shape.curve) else {
        let error = Error::new(Code::F019, format!("a curve of kind \"{}\" has no form in lath JSON", shape.kind()));
        return Err(error.remedied("Convert it to a kind that travels."));
    };
    Ok(Object::of_kind(kind, shape.name(), body))
}
