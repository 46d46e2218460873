//! Files of curves: lath JSON, and those of geomdl and SciPy.

use crate::points::{checked, shown};
use crate::questions::ask_any;
use crate::small;
use crate::tape::Tape;
use lath::error::Limits;
use lath_io::format::{self, Content};
use lath_io::shapes::{self, Shape};
use lath_io::source::Source;

/// The target: 8 bytes of decisions for the questions, then the file.
pub fn run(bytes: &[u8]) {
    let Some((options, file)) = bytes.split_at_checked(8) else { return };
    let (limits, source) = (small(), Source::from_bytes("any", file));
    let json = format::by_name("json").ok();
    match format::read(&source, json, &limits) {
        Ok(Content::Shapes(shapes)) => {
            returns(&shapes);
            for curve in shapes.iter().filter_map(Shape::curve).take(4) {
                ask_any(curve, &mut Tape::new(options));
            }
        }
        Ok(Content::Points(_)) => {}
        Err(error) => shown(&error),
    }
    checked(&source, json, &limits);
}

/// What is written reads back, and is written the same again.
pub(crate) fn returns(shapes: &[Shape]) {
    let text = match shapes::to_string(shapes) {
        Ok(text) => text,
        Err(error) => panic!("{error}"),
    };
    let again = shapes::read(&Source::from_bytes("again", text.as_str()), &Limits::default());
    let again = again.and_then(|again| shapes::to_string(&again));
    assert!(again.as_ref().is_ok_and(|again| *again == text), "{again:?} from {text}");
    let Ok(scipy) = format::by_name("scipy") else { return };
    let mut bytes = Vec::new();
    if scipy.write_shapes(&mut bytes, shapes).is_ok() {
        let back = format::read_shapes(&Source::from_bytes("again", bytes), Some(scipy), &Limits::default());
        let mut twice = Vec::new();
        let written = back.and_then(|back| scipy.write_shapes(&mut twice, &back));
        assert!(written.is_ok(), "{written:?} from {text}");
    }
}
