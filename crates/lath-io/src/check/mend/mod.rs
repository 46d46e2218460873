//! Mending what is safe.
//!
//! No point is moved. What is mended:
//!
//! - *tables*: rows with NaN or infinities (`null` in JSON) are dropped, and rows that repeat the one before;
//! - *knots* two too few, the convention of openNURBS: the first and the last are repeated;
//! - *knots* that decrease by a few units in the last place: they are made equal;
//! - *knots* repeated more than degree + 1 times: the superfluous ones are removed, if the number of knots then fits;
//! - the *closing point* of a closed shape, where the number of knots or parameters shows that it is one too many.
//!
//! Everything else stays as it is, and in the report. So does a file that would have more errors afterwards: where the first row
//! goes, others may look like a title.
//!
//! Mending a mended file changes nothing: where the first row goes, the rows behind it may be laid out anew, and then more of
//! them go, until nothing is left to mend. A file that is still not mended after [`ROUNDS`] rounds is left alone.

mod rows;
mod shape;

use lath::error::Limits;

use crate::check::{Report, check};
use crate::error::Result;
use crate::format::{self, Format};
use crate::json::{self, Json};
use crate::shapes::{self, geomdl, scipy};
use crate::source::Source;

/// How often a file is mended before it is given up.
const ROUNDS: usize = 16;

/// A mended file.
#[derive(Clone, Debug)]
pub struct Fixed {
    bytes: Vec<u8>,
    changes: Vec<String>,
    report: Report,
}

impl Fixed {
    /// The mended file, or the file as it was where nothing was changed.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// What was changed, in words; empty where nothing was. What begins with "then" was seen only after the changes before it, and
    /// counts lines and rows in the file as they left it.
    #[must_use]
    pub fn changes(&self) -> &[String] {
        &self.changes
    }

    /// What is left.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }
}

/// Mends what is safe, says what it changed, and looks again.
///
/// ```
/// use lath::error::Limits;
/// use lath_io::{check, source::Source};
///
/// let text = r#"{"lath": 1, "shapes": [{"kind": "bspline", "degree": 2, "knots": [0, 0, 1, 1], "points": [[0], [1], [0]]}]}"#;
/// let fixed = check::fix(&Source::from_bytes("arch.json", text), None, &Limits::default())?;
/// assert_eq!(fixed.changes(), ["/shapes/0/knots: repeated the first and the last knot once more, which were left out"]);
/// assert_eq!(fixed.report().errors(), 0);
/// # Ok::<(), lath_io::Error>(())
/// ```
///
/// # Errors
/// As [`check()`].
pub fn fix(source: &Source, from: Option<&'static Format>, limits: &Limits<'_>) -> Result<Fixed> {
    let first = check(source, from, limits)?;
    let mut fixed = Fixed { bytes: source.bytes().to_vec(), changes: Vec::new(), report: first.clone() };
    for round in 0..ROUNDS {
        let now = Source::from_bytes(source.name(), fixed.bytes.as_slice());
        let Some((bytes, changes)) = mend(&now, from, limits)? else { return Ok(fixed) };
        let next = Source::from_bytes(source.name(), bytes);
        let report = check(&next, from, limits)?;
        if report.errors() > fixed.report.errors() {
            return Ok(fixed);
        }
        let then = if round == 0 { "" } else { "then " };
        fixed.changes.extend(changes.into_iter().map(|change| format!("{then}{change}")));
        (fixed.bytes, fixed.report) = (next.into_bytes(), report);
    }
    Ok(Fixed { bytes: source.bytes().to_vec(), changes: Vec::new(), report: first })
}

/// Mends a file once: its bytes, and what was changed; none where nothing was.
fn mend(source: &Source, from: Option<&'static Format>, limits: &Limits<'_>) -> Result<Option<(Vec<u8>, Vec<String>)>> {
    let mut changes = Vec::new();
    let mended = match format::of_source(source, from).map(|format| format.name) {
        Err(_) => None,
        Ok("json" | "scipy") => mend_json(source, limits, &mut changes),
        Ok("npy") => rows::npy(source, limits, &mut changes)?,
        Ok(_) => rows::text(source, limits, &mut changes)?,
    };
    Ok(mended.filter(|_| !changes.is_empty()).map(|bytes| (bytes, changes)))
}

fn mend_json(source: &Source, limits: &Limits<'_>, changes: &mut Vec<String>) -> Option<Vec<u8>> {
    // What cannot be parsed cannot be mended; the report says why.
    let mut tree = json::parse(source, limits).ok()?;
    if geomdl::recognise(&tree) || scipy::recognise(&tree) {
        return None;
    }
    if !shapes::recognise(&tree) {
        rows::json(&mut tree, changes);
        return Some(json::print(&tree).into_bytes());
    }
    if let Some(Json::Array(list)) = tree.get_mut("shapes") {
        for (index, shape) in list.iter_mut().enumerate() {
            shape::mend(shape, &format!("/shapes/{index}"), changes);
        }
    }
    Some(json::print(&tree).into_bytes())
}
